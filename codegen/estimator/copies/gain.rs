//! The search for L: the smallest worst-case noise gain that does not cost digits.
//!
//! As L goes to 0 the gain of the estimate falls to a limit, while X grows without one: the copies then carry the
//! common error nearly alike, and the reset multiplies their rounding errors. So the search weighs one against the
//! other, and, where samples are missing by design, the spectral radius of the errors as well. It starts from the
//! gain that moves each mode by about one over the window, goes along a pattern in fixed order, and rounds to three
//! digits; the choice is the same on every machine.

use crate::decimal;
use crate::expr::Constant;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real};
use crate::sampled::coordinates::{Blocks, Coordinates};
use crate::sampled::model::Model;

use super::Calls;
use super::errors::{ErrorMap, spectral_radius};
use super::exact::{Exact, ExactUpdate, Failure, Pair, pair};
use super::size::Size;
use super::weights::Weights;
use crate::dense::Rows;

/// Bits of what decides.
const BITS: usize = 512;
/// The price of rounding: where that of a call is multiplied by the inverse of this, a gain counts for twice itself.
const AMPLIFICATION: f64 = 1e-3;
/// Most values of L that are tried from each beginning.
const MOST_TRIALS: usize = 300;
/// Multiplications in multiprecision that all of them may take, some seconds.
const MOST_WORK: usize = 20_000_000;
/// Halvings of the pattern's step.
const HALVINGS: usize = 6;
/// Powers of two by which the first L is tried larger and smaller.
const SCALES: i32 = 5;
/// Rows of the first L whose signs are tried both ways.
const MOST_SIGNS: usize = 3;
/// How many of the beginnings, with different signs, are gone on from.
const BEGINNINGS: usize = 3;

/// The plant that the search sees: linear, sampled.
struct Search<'a> {
    calls: &'a Calls,
    coordinates: Coordinates,
    phi: Matrix,
    blocks: Blocks,
    /// Per output, what its samples count by.
    trust: Vec<f64>,
    trials: usize,
    /// Most values of L that are tried in all.
    most: usize,
}

/// The L with the best balance, (n-p) x p; `None` where none tells the copies apart.
///
/// # Errors
/// What the plant's own constants have against them.
pub fn search(plant: &Plant, rest: &[usize], calls: &Calls) -> Result<Option<Vec<Vec<Constant>>>, Failure> {
    let model = Model::new(plant, &[], Precision::bits(BITS)).map_err(Failure::Plant)?;
    let coordinates = Coordinates::new(&model.c, rest.to_vec())?;
    let blocks = coordinates.blocks(&model.phi);
    let trust = model.trust.iter().map(Real::to_f64).collect();
    let most = most_trials(rest.len(), calls.period);
    let mut search = Search { calls, coordinates, phi: model.phi, blocks, trust, trials: 0, most };
    let Some(size) = Size::new(&search.blocks, &search.trust, calls.period) else { return Ok(None) };
    let mut best: Option<(f64, Rows)> = None;
    for (score, alike) in search.beginnings(&size) {
        let (score, alike) = search.pattern(score, alike, &size);
        if best.as_ref().is_none_or(|(least, _)| score < *least) {
            best = Some((score, alike));
        }
    }
    let rounded = best.map(|(_, alike)| rounded(&size.gain_of(&alike, &search.trust), &size.gain));
    Ok(rounded.filter(|(gain, _)| search.score(gain, &size).is_some()).map(|(_, constants)| constants))
}

/// Trials that the work allows; each takes powers and an inverse of matrices of this size.
fn most_trials(rest: usize, period: usize) -> usize {
    let products = 2 * period.max(2).ilog2() as usize + 6;
    MOST_WORK / (rest * rest * rest * products)
}

impl Search<'_> {
    /// The best multiples of the first L with some signs turned, the best ones of all first.
    fn beginnings(&mut self, size: &Size) -> Vec<(f64, Rows)> {
        let mut all: Vec<(f64, Rows)> = Vec::new();
        for signs in 0..1_usize << size.start.len().min(MOST_SIGNS) {
            if signs > 0 && 2 * self.trials > self.most {
                break;
            }
            let turned = |i: usize| if i < MOST_SIGNS && signs >> i & 1 == 1 { -1.0 } else { 1.0 };
            let mut best: Option<(f64, Rows)> = None;
            for exponent in -SCALES..=SCALES {
                let factor = deadbeat_math::pow_f64(2.0, f64::from(exponent));
                let row = |(i, row): (usize, &Vec<f64>)| row.iter().map(|x| factor * turned(i) * x).collect();
                let alike: Rows = size.start.iter().enumerate().map(row).collect();
                if let Some(score) = self.score(&size.gain_of(&alike, &self.trust), size)
                    && best.as_ref().is_none_or(|(least, _)| score < *least)
                {
                    best = Some((score, alike));
                }
            }
            all.extend(best);
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.truncate(BEGINNINGS);
        all
    }

    /// From there, coordinate by coordinate, with steps that are halved when none helps.
    fn pattern(&mut self, mut score: f64, mut alike: Rows, size: &Size) -> (f64, Rows) {
        let most = self.most.min(self.trials + MOST_TRIALS);
        let mut share = 1.0;
        let mut halvings = 0;
        while halvings < HALVINGS && self.trials < most {
            let before = score;
            for i in 0..alike.len() {
                for o in 0..alike[i].len() {
                    let step = share * f64::max(1.0, alike[i][o].abs());
                    for moved in [alike[i][o] + step, alike[i][o] - step] {
                        let mut trial = alike.clone();
                        trial[i][o] = moved;
                        let gain = size.gain_of(&trial, &self.trust);
                        if let Some(lower) = self.score(&gain, size).filter(|lower| *lower < score) {
                            (score, alike) = (lower, trial);
                            break;
                        }
                    }
                }
            }
            if score >= before {
                share *= 0.5;
                halvings += 1;
            }
        }
        (score, alike)
    }

    /// The logarithm of what is made small: the geometric mean of the states' noise gains, the price of X, and,
    /// where the errors contract from reset to reset, how long an error of noise stays.
    fn score(&mut self, l: &Rows, size: &Size) -> Option<f64> {
        self.trials += 1;
        let precision = self.phi.precision();
        let rows: Option<Vec<Vec<Real>>> =
            l.iter().map(|row| row.iter().map(|x| Real::from_f64(*x, precision)).collect()).collect();
        let rows = rows?;
        let gain = Matrix::from_fn(l.len(), self.trust.len(), |i, o| rows[i][o].clone());
        let pair = pair(&self.blocks, &gain, |m| Ok(m.powi(self.calls.period as u64))).ok()?;
        let period = self.calls.period;
        let amplification =
            size.amplification([&self.blocks.rr, &pair.h], &pair.x, l, period) / crate::numbers::count(period);
        let weights = Weights::new(&self.blocks, &gain, &pair);
        let states = weights.worst(period, &self.trust);
        let mean = states.iter().map(|gain| deadbeat_math::log_f64(f64::max(*gain, f64::MIN_POSITIVE))).sum::<f64>()
            / crate::numbers::count(states.len());
        let stays = if self.calls.every > 1 { 1.0 - self.radius(&gain, pair) } else { 1.0 };
        let price = deadbeat_math::log_f64(1.0 + AMPLIFICATION * amplification);
        let score = mean + price - deadbeat_math::log_f64(f64::max(stays, 0.0));
        (stays > 0.0 && score.is_finite()).then_some(score)
    }

    /// Of the errors over a period.
    fn radius(&self, gain: &Matrix, pair: Pair) -> f64 {
        let (p, rest, precision) = (self.trust.len(), gain.rows(), self.phi.precision());
        let update = |copy: &Matrix, output: &Matrix| ExactUpdate {
            copy: copy.clone(),
            outputs: vec![Matrix::zeros(output.rows(), p, precision), output.clone()],
            knowns: Vec::new(),
            constant: Matrix::zeros(rest, 1, precision),
        };
        let exact = Exact {
            first: update(&self.blocks.rr, &self.blocks.ry),
            second: update(&pair.h, &pair.g),
            predictor: update(&self.blocks.yr, &self.blocks.yy),
            coordinates: self.coordinates.clone(),
            phi: self.phi.clone(),
            gamma: Matrix::zeros(p + rest, 0, precision),
            gain: gain.clone(),
            pair,
            continuous: None,
        };
        spectral_radius(&ErrorMap::new(&exact).period(self.calls))
    }
}

/// To three digits of each entry, or of the sizes where an entry is far below its own.
fn rounded(gain: &Rows, scale: &Rows) -> (Rows, Vec<Vec<Constant>>) {
    let entry = |x: f64, scale: f64| if x.abs() < 1e-3 * scale { "0".to_owned() } else { format!("{x:.2e}") };
    let text = |i: usize, o: usize| entry(gain[i][o], scale[i][o]);
    let grid = |of: &dyn Fn(&str) -> Constant| -> Vec<Vec<Constant>> {
        (0..gain.len()).map(|i| (0..gain[i].len()).map(|o| of(&text(i, o))).collect()).collect()
    };
    let constants = grid(&|text| Constant::from(decimal::parse(text).unwrap_or_default()));
    let doubles = constants.iter().map(|row| row.iter().map(|c| c.to_f64().unwrap_or(0.0)).collect()).collect();
    (doubles, constants)
}

#[cfg(test)]
mod tests {
    use crate::method::designed;

    /// The arm's velocity over 50 samples: the smallest gain that any weights have is 40 (from the two ends of the
    /// window), and the search comes close to it with a reset that costs less than two digits.
    #[test]
    fn the_gain_is_near_the_smallest_there_is() {
        let (_, design) = designed(include_str!("../../../specs/pendulum_impulsive.toml")).unwrap();
        let gain = design.certificate.noise_gain_l1[1][0];
        assert!((40.0..43.0).contains(&gain), "{gain}");
        let x = &design.constants.iter().find(|matrix| matrix.letter == "X").unwrap().rows;
        assert!(x[0][0].abs() < 100.0, "{x:?}");
    }

    /// Units do not matter: a state in thousandths has an L of a thousand times the size.
    #[test]
    fn the_choice_does_not_depend_on_units() {
        let text = |unit: &str, back: &str| {
            format!(
                "deadbeat = 1\nname = 'm'\n[states]\nx = {{ derivative = '{back}*v' }}\nv = {{ derivative = '-3*v + {unit}*i' }}\n\
                 i = {{ derivative = '-20*i - {back}*v' }}\n[outputs]\nx = {{ value = 'x' }}\n[observer.impulsive]\nwindow = 0.5\n\
                 [target]\nsample_time = 0.025\nscalar = 'f64'\n"
            )
        };
        let gain = |text: &str| designed(text).unwrap().1.certificate.noise_gain_l1;
        let (metres, millimetres) = (gain(&text("1", "1")), gain(&text("1024", "0.0009765625")));
        for (state, factor) in [(1, 1024.0), (2, 1.0)] {
            let (a, b) = (metres[state][0] * factor, millimetres[state][0]);
            // L is rounded to three digits in either unit.
            assert!((a / b - 1.0).abs() < 0.01, "state {state}: {a}, {b}");
        }
    }
}
