//! How far an estimate is from a reference, and by how much it is late.

use super::super::interface::Answer;
use super::track::Track;

/// What an estimate is worth over some rows; absent where there is nothing to compare.
#[derive(Clone, Debug, Default)]
pub struct Score {
    /// Root of the mean square of the error.
    pub rms: Option<f64>,
    /// Below it are 99 % of the magnitudes.
    pub p99: Option<f64>,
    /// The largest magnitude.
    pub max: Option<f64>,
    /// s: how much later than the reference the estimate is.
    pub lag: Option<f64>,
    /// The share of the rows, coasting ones too, on which the error is beyond the bound that is promised.
    pub beyond: Option<f64>,
}

/// An estimate and what it is compared with.
pub(super) struct Pair<'a> {
    pub answer: &'a Answer,
    /// Per row, s.
    pub times: &'a [f64],
    /// Per row.
    pub estimate: &'a [f64],
    pub reference: &'a Track,
    /// The rows to compare.
    pub rows: &'a [usize],
    /// Of the error where one is promised, in the unit.
    pub bound: Option<f64>,
}

/// Samples by which the estimate is shifted at first, either way.
const FIRST_REACH: i32 = 16;
/// Share of the rows' time by which it may be shifted at most.
const FARTHEST: f64 = 0.25;
/// Samples by which it may be shifted at most.
const MOST_SAMPLES: i32 = 4096;

/// A part of a whole.
#[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
fn share(part: usize, whole: usize) -> f64 {
    part as f64 / whole as f64
}

impl Pair<'_> {
    /// All numbers; `step` is the sample time, s, by which the search for the lag goes.
    pub fn score(&self, step: f64) -> Score {
        let mut sizes: Vec<f64> = self.errors(0.0, 0.0).map(f64::abs).collect();
        sizes.sort_by(f64::total_cmp);
        let Some(max) = sizes.last().copied() else { return Score::default() };
        Score {
            rms: Some(mean_square(sizes.iter().copied()).sqrt()),
            p99: sizes.get((99 * sizes.len()).div_ceil(100) - 1).copied(),
            max: Some(max),
            lag: self.lag(step),
            beyond: self.bound.map(|bound| {
                let within = sizes.partition_point(|size| *size <= bound);
                share(sizes.len() - within, sizes.len())
            }),
        }
    }

    /// Errors against the reference of `shift` seconds earlier, over the rows for which it is known up to `reach`
    /// seconds earlier and later.
    fn errors(&self, shift: f64, reach: f64) -> impl Iterator<Item = f64> {
        let (first, last) = self.reference.span().unwrap_or((f64::INFINITY, f64::INFINITY));
        let within = move |row: &&usize| (first + reach..=last - reach).contains(&self.times[**row]);
        let mut from = 0;
        let error = move |row: &usize| {
            let reference = self.reference.at(self.times[*row] - shift, &self.answer.turns, &mut from);
            self.answer.error(self.estimate[*row], reference)
        };
        self.rows.iter().filter(within).map(error).filter(|error| error.is_finite())
    }

    /// The shift with the smallest mean square: whole samples, then a parabola through the three around it.
    ///
    /// The mean square is itself nearly a parabola there: the noise's share is the same for all shifts. `None` when the
    /// reference does not move, or the smallest is as far away as the search goes.
    fn lag(&self, step: f64) -> Option<f64> {
        let (first, last) = self.reference.span()?;
        let rows = self.times[*self.rows.last()?] - self.times[*self.rows.first()?];
        let most = MOST_SAMPLES.min(whole(FARTHEST * rows.min(last - first) / step));
        let mut reach = FIRST_REACH.min(most);
        loop {
            let square = |k: i32| mean_square(self.errors(f64::from(k) * step, f64::from(reach) * step));
            let squares: Vec<f64> = (-reach..=reach).map(square).collect();
            let best = (0..squares.len()).min_by(|a, b| squares[*a].total_cmp(&squares[*b]))?;
            let around = best.checked_sub(1).and_then(|first| squares.get(first..first + 3));
            if let Some(&[before, least, behind]) = around {
                let bend = before - 2.0 * least + behind;
                let samples = f64::from(i32::try_from(best).ok()? - reach) + (before - behind) / (2.0 * bend);
                return (bend > 0.0).then_some(samples * step);
            }
            if reach == most || squares.iter().all(|square| *square == squares[0]) {
                return None;
            }
            reach = most.min(4 * reach);
        }
    }
}

/// The whole part of a number that is not negative; 0 for NaN.
#[expect(clippy::cast_possible_truncation, reason = "a cast saturates, and the result is bounded by its user")]
fn whole(number: f64) -> i32 {
    number as i32
}

#[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
fn mean_square(errors: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = errors.fold((0.0, 0_u64), |(sum, count), error| (sum + error * error, count + 1));
    if count == 0 { f64::NAN } else { sum / count as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer() -> Answer {
        let (name, unit, doc) = (String::new(), String::new(), String::new());
        Answer { name, unit, doc, integer: false, state: None, window: None, turns: Vec::new() }
    }

    /// The score of `estimate` against `reference`, both functions of the time, over 1000 rows of 0.01 s.
    fn score(estimate: impl Fn(f64) -> f64, reference: impl Fn(f64) -> f64) -> Score {
        let times: Vec<f64> = (0..1000).map(|k| f64::from(k) * 0.01).collect();
        let estimate: Vec<f64> = times.iter().map(|t| estimate(*t)).collect();
        let values = times.iter().map(|t| reference(*t)).collect();
        let reference = Track { times: times.clone(), values };
        let rows: Vec<usize> = (0..1000).collect();
        let (answer, bound) = (answer(), None);
        Pair { answer: &answer, times: &times, estimate: &estimate, reference: &reference, rows: &rows, bound }
            .score(0.01)
    }

    #[test]
    fn magnitudes_are_ranked() {
        let score = score(|t| t, |_| 0.0);
        // 0, 0.01 … 9.99: 99 % of the thousand are at most the 990th.
        assert_eq!((score.p99, score.max), (Some(989.0 * 0.01), Some(999.0 * 0.01)));
        let exact: f64 = (0..1000).map(|k| f64::from(k * k) * 1e-4 / 1000.0).sum();
        assert!((score.rms.unwrap() - exact.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_delay_between_samples_is_found_on_either_side_and_far_away() {
        for delay in [0.0, 0.033, -0.0271, 0.5, 1.234] {
            let lag = score(|t| (1.1 * (t - delay)).sin(), |t| (1.1 * t).sin()).lag.unwrap();
            // The mean square of a sine's shift is a parabola but for its fourth order: (0.011)^2 of a sample.
            assert!((lag - delay).abs() < 1e-4, "{delay}: {lag}");
        }
    }

    #[test]
    fn what_does_not_move_has_no_lag() {
        assert_eq!(score(f64::sin, |_| 1.0).lag, None);
        assert_eq!(score(|_| 1.0, |_| 1.0).lag, None);
        assert!(score(|_| f64::NAN, |t| t).rms.is_none());
    }
}
