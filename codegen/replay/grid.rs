//! Which call of a step a row of a recording belongs to, by the row's own time.
//!
//! Calls are a sample time apart, the first one at the first row. A row belongs to the call that is nearest to it, and
//! calls without a row have missing samples. Rows that share a stamp came in a burst, and are a sample time apart each.

use std::fmt;

/// Samples that one jump of the time may leave out.
const LARGEST_GAP: f64 = 1e6;
/// How far a row may be from its call, in samples, to stand for the next call where its own has a row already.
const AHEAD: f64 = 0.75;
/// How far a row may be from its call, in samples, before the calls follow the recording's clock; and how fast they do
/// then, a share a row of what is beyond: a drive's clock drifts by 0.1 %, while jitter moves no call.
const STILL: f64 = 0.4;
const FOLLOWING: f64 = 1.0 / 8.0;
/// Samples, and share of the calls, by which the two clocks may differ in the end.
const DRIFT: (f64, f64) = (2.0, 0.01);
/// A row further off its call than this is off the grid, in samples: half of all would be, at an unrelated rate.
const OFF: f64 = 0.25;
/// The largest share of rows off the grid, or with the call of another row, of a recording at the step's rate.
const MOST_OFF: f64 = 0.1;
/// Rows in a row that are thousands of samples apart before the unit of the time is doubted.
const FAR_ROWS: u64 = 8;

/// Why a row's time does not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TimeError {
    /// What is wrong with it.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl fmt::Display for TimeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for TimeError {}

/// The calls of one step, as far as rows have come.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// s between two calls.
    sample_time: f64,
    /// Of the first and the newest row, s.
    times: Option<(f64, f64)>,
    /// The call of the newest row.
    call: u64,
    /// How late the calls are against the first row's clock, in samples.
    drift: f64,
    /// Rows that share the newest stamp, and the most that have shared one.
    burst: (u64, u64),
    rows: u64,
    /// Of these, rows whose call had a row already.
    doubled: u64,
    /// Of these, rows that are off the grid.
    off: u64,
    /// The sum of squares of what rows are off, in samples.
    squares: f64,
    /// Calls up to the newest row if each row were to tell the distance to the one before only.
    by_neighbours: f64,
    /// Whether rows so far were thousands of samples apart each.
    far: bool,
}

/// Where a row belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    /// So many calls behind the newest row's, at least 1; 1 for the first row.
    Behind(u64),
    /// The call has a row already.
    Taken,
}

impl Grid {
    /// Of a step with this sample time, s.
    pub fn new(sample_time: f64) -> Self {
        Self {
            sample_time,
            times: None,
            call: 0,
            drift: 0.0,
            burst: (1, 1),
            rows: 0,
            doubled: 0,
            off: 0,
            squares: 0.0,
            by_neighbours: 0.0,
            far: true,
        }
    }

    /// Whether the recording has times.
    pub fn timed(&self) -> bool {
        self.times.is_some()
    }

    /// Rows that were left out, since their call had one.
    pub fn doubled(&self) -> u64 {
        self.doubled
    }

    /// By how much rows are off the times of their calls, RMS, s.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub fn off(&self) -> f64 {
        self.sample_time * (self.squares / self.rows.max(1) as f64).sqrt()
    }

    /// The time of the call that a row of this time belongs to, on the recording's clock, s.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub fn time_of_call(&self, now: f64) -> f64 {
        let Some((start, before)) = self.times else { return now };
        let x = (now - start) / self.sample_time - self.drift;
        let call = self.call_at(x, now == before).unwrap_or(self.call);
        let on_time = (x - call as f64).abs() * self.sample_time <= 4.0 * f64::EPSILON * now.abs().max(start.abs());
        if on_time { now } else { start + (call as f64 + self.drift) * self.sample_time }
    }

    /// Takes the next row.
    ///
    /// # Errors
    /// When its time does not rise, or jumps too far.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub fn take(&mut self, now: f64) -> Result<Place, TimeError> {
        self.rows += 1;
        let Some((start, before)) = self.times else {
            self.times = Some((now, now));
            let what = format!("the time of the first row is {now}");
            return if now.is_finite() { Ok(Place::Behind(1)) } else { Err(unfit(what)) };
        };
        if now.is_nan() || now < before {
            return Err(unfit(format!("the time does not rise: {now} s behind {before} s")));
        }
        let gap = (now - before) / self.sample_time;
        if gap > LARGEST_GAP {
            let message = format!("the time jumps by {gap:.0} samples, from {before} s to {now} s");
            return Err(TimeError { message, help: unit(gap) });
        }
        self.far &= gap > 100.0;
        if self.far && self.rows > FAR_ROWS && unit(gap).is_some() {
            let message = format!(
                "the first rows are {} s apart, the specification's sample time is {} s",
                now - before,
                self.sample_time
            );
            return Err(TimeError { message, help: unit(gap) });
        }
        self.times = Some((start, now));
        self.burst.0 = if now > before { 1 } else { self.burst.0 + 1 };
        self.burst.1 = self.burst.1.max(self.burst.0);
        self.by_neighbours += gap.round().max(1.0);
        let x = (now - start) / self.sample_time - self.drift;
        let Some(call) = self.call_at(x, now == before) else {
            self.doubled += 1;
            return Ok(Place::Taken);
        };
        let behind = call - self.call;
        self.call = call;
        self.follow(x - call as f64);
        Ok(Place::Behind(behind))
    }

    /// The call of a row at `x`, in samples since the first call; `None` where that has a row already.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a recording has fewer than 2^53 samples"
    )]
    fn call_at(&self, x: f64, same: bool) -> Option<u64> {
        let next = self.call + 1;
        let ahead = next as f64 - x;
        let nearest = x.round().max(0.0) as u64;
        let most = self.burst.1 as f64;
        // A clock that is coarser than the sample time: rows follow one another unless it shows that some are missing.
        if same || (most > 1.0 && ahead.abs() < most) {
            return Some(next);
        }
        if nearest >= next { Some(nearest) } else { (ahead <= AHEAD).then_some(next) }
    }

    /// Lets the calls follow the clock of a recording, given how much later than its call a row is.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 samples")]
    fn follow(&mut self, late: f64) {
        if self.burst.1 > 1 {
            return;
        }
        let most = DRIFT.0 + DRIFT.1 * self.call as f64;
        let beyond = late - late.clamp(-STILL, STILL);
        self.drift = (self.drift + FOLLOWING * beyond).clamp(-most, most);
        self.off += u64::from(late.abs() > OFF);
        self.squares += late * late;
    }

    /// What is wrong with the whole recording; `converged` says whether any estimate has.
    ///
    /// # Errors
    /// When its rows are at another rate.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub fn judge(&self, converged: bool) -> Result<(), TimeError> {
        let Some((start, end)) = self.times.filter(|_| self.rows > 2) else { return Ok(()) };
        let (rows, samples) = (self.rows as f64, (end - start) / self.sample_time);
        let near = |calls: f64| (samples - calls).abs() <= DRIFT.0 + DRIFT.1 * calls;
        let mean = (end - start) / (rows - 1.0);
        let h = self.sample_time;
        let said = format!(
            "rows are {mean:.6} s apart in the mean of the recording, the specification's sample time is {h} s"
        );
        let resample = "set the specification's `sample_time` to the recording's, or resample the recording";
        if near(rows - 1.0) {
            return Ok(());
        }
        // More rows than samples, whatever their stamps.
        let crowded = self.doubled as f64 > DRIFT.0 + MOST_OFF * rows
            || samples + self.burst.1 as f64 + DRIFT.0 < (1.0 - MOST_OFF) * (rows - 1.0);
        let scattered = self.off as f64 > DRIFT.0 + MOST_OFF * rows && !near(self.by_neighbours);
        if crowded || scattered {
            return Err(TimeError { message: said, help: unit(mean / h).or(Some(resample.into())) });
        }
        if converged || mean < 1.25 * h {
            return Ok(());
        }
        let only = format!(
            "{resample}; if it holds the rows that were measured only, `missing = \"left-out\"`, `every` or `intermittent` \
             says so to the methods that have it"
        );
        Err(TimeError { message: format!("no estimate has converged: {said}"), help: unit(mean / h).or(Some(only)) })
    }
}

/// What to do where rows are so many times the sample time apart that the unit of the time is another one.
fn unit(times: f64) -> Option<String> {
    let near = |factor: f64| (0.5..2.0).contains(&(times / factor));
    let units = [(1e3, "ms"), (1e6, "us"), (1e9, "ns")];
    let (_, name) = units.into_iter().find(|(factor, _)| near(*factor))?;
    Some(format!("if the time is in {name}, say `--time-unit {name}`"))
}

fn unfit(message: String) -> TimeError {
    TimeError { message, help: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The calls of rows at these times, in samples; `None` for rows whose call is taken.
    fn calls(times: &[f64]) -> Vec<Option<u64>> {
        let mut grid = Grid::new(1.0);
        let mut call = 0;
        let mut take = |(row, time): (usize, &f64)| match grid.take(*time).expect("it rises") {
            Place::Behind(behind) => {
                call += if row == 0 { 0 } else { behind };
                Some(call)
            }
            Place::Taken => None,
        };
        times.iter().enumerate().map(&mut take).collect()
    }

    #[test]
    fn a_row_belongs_to_the_nearest_call_by_its_own_time() {
        let some = |all: &[u64]| all.iter().map(|call| Some(*call)).collect::<Vec<_>>();
        assert_eq!(calls(&[5.0, 6.0, 8.0, 11.0, 12.0]), some(&[0, 1, 3, 6, 7]));
        // By its neighbours the third would be two calls behind the second, and the fifth three behind the fourth.
        assert_eq!(calls(&[0.0, 0.75, 2.3, 2.9, 5.4, 6.1]), some(&[0, 1, 2, 3, 5, 6]));
        assert_eq!(calls(&[0.0, 1.0, 1.45, 3.0]), some(&[0, 1, 2, 3]), "the row before its call");
        assert_eq!(calls(&[0.0, 1.0, 1.2, 2.0]), [Some(0), Some(1), None, Some(2)], "two rows of one call");
    }

    #[test]
    fn rows_that_share_a_stamp_follow_one_another() {
        let some: Vec<_> = (0..8).map(Some).collect();
        assert_eq!(calls(&[0.0, 0.0, 2.0, 2.0, 4.0, 4.0, 6.0, 6.0]), some);
        // A clock of whole ms at 2.5 kHz, the first row 0.3 ms behind its tick.
        let stamps: Vec<f64> = (0..200).map(|k| (0.3 + 0.4 * f64::from(k)).floor() / 0.4).collect();
        assert_eq!(calls(&stamps), (0..200).map(Some).collect::<Vec<_>>());
        assert_eq!(calls(&[0.0, 0.0, 2.0, 2.0, 8.0, 8.0])[4..], [Some(8), Some(9)], "a lost packet stays lost");
    }

    #[test]
    fn clocks_may_drift_and_a_pause_that_is_made_up_for_leaves_nothing_out() {
        for factor in [0.99, 0.999, 1.001, 1.01] {
            let times: Vec<f64> = (0..3000).map(|k| factor * f64::from(k)).collect();
            assert_eq!(calls(&times), (0..3000).map(Some).collect::<Vec<_>>(), "{factor}");
        }
        // 14 rows early, one late, so that the mean is the sample time.
        let mut times = vec![0.0];
        for k in 0..300 {
            times.push(times[k] + if k % 15 == 14 { 4.1 / 2.7 } else { 2.6 / 2.7 });
        }
        assert_eq!(calls(&times), (0..=300).map(Some).collect::<Vec<_>>());
    }
}
