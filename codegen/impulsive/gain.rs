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
use crate::real::balance::balanced;
use crate::real::{Matrix, Precision, Real, inverse};
use crate::window::coordinates::{Blocks, Coordinates};
use crate::window::model::Model;

use super::Calls;
use super::errors::{ErrorMap, spectral_radius};
use super::exact::{Exact, ExactUpdate, Failure, Pair, pair};

/// Bits of what decides.
const BITS: usize = 512;
/// The price of X: with this inverse as its norm, a gain counts for twice itself.
const AMPLIFICATION: f64 = 1e-3;
/// Most values of L that are tried.
const MOST_TRIALS: usize = 600;
/// Halvings of the pattern's step.
const HALVINGS: usize = 6;
/// Powers of two by which the first L is tried larger and smaller.
const SCALES: i32 = 5;

/// The plant that the search sees: linear, sampled.
struct Search<'a> {
    calls: &'a Calls,
    coordinates: Coordinates,
    phi: Matrix,
    blocks: Blocks,
    /// Per output, what its samples count by.
    trust: Vec<f64>,
    trials: usize,
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
    let mut search = Search { calls, coordinates, phi: model.phi, blocks, trust, trials: 0 };
    let Some((start, scale)) = search.start() else { return Ok(None) };
    let best = search.along(&start).map(|(score, gain)| search.pattern(score, gain, &scale));
    let rounded = best.map(|gain| rounded(&gain, &scale));
    Ok(rounded.filter(|(gain, _)| search.score(gain).is_some()).map(|(_, constants)| constants))
}

type Rows = Vec<Vec<f64>>;

impl Search<'_> {
    /// The first L, `-W^-1 Phi_yr'` with the Gramian W of x_r over the window, and the size of its entries.
    fn start(&self) -> Option<(Rows, Rows)> {
        let (p, rest) = (self.coordinates.outputs(), self.coordinates.rest.len());
        let precision = self.phi.precision();
        let mut weights = Matrix::zeros(p, p, precision);
        for (o, trust) in self.trust.iter().enumerate() {
            weights[(o, o)] = Real::from_f64(trust * trust, precision)?;
        }
        let mut gramian = Matrix::zeros(rest, rest, precision);
        let mut seen = self.blocks.yr.clone();
        for _ in 0..self.calls.period {
            gramian = &gramian + &(&seen.transpose() * &(&weights * &seen));
            seen = &seen * &self.blocks.rr;
        }
        let spread = inverse(&gramian).ok()?;
        let start = (&(&-&spread * &self.blocks.yr.transpose()) * &weights).to_f64();
        let samples = crate::window::count(self.calls.period);
        let scale = |i: usize, o: usize| {
            deadbeat_math::sqrt_f64(spread.get(i, i).to_f64().max(0.0) / samples) * self.trust[o]
        };
        let scale: Rows = (0..rest).map(|i| (0..p).map(|o| scale(i, o)).collect()).collect();
        let finite = |rows: &Rows| rows.iter().flatten().all(|x| x.is_finite());
        (finite(&start) && finite(&scale)).then_some((start, scale))
    }

    /// The best multiple of an L.
    fn along(&mut self, start: &Rows) -> Option<(f64, Rows)> {
        let mut best: Option<(f64, Rows)> = None;
        for exponent in -SCALES..=SCALES {
            for sign in [1.0, -1.0] {
                let factor = sign * deadbeat_math::pow_f64(2.0, f64::from(exponent));
                let gain: Rows = start.iter().map(|row| row.iter().map(|x| factor * x).collect()).collect();
                if let Some(score) = self.score(&gain)
                    && best.as_ref().is_none_or(|(least, _)| score < *least)
                {
                    best = Some((score, gain));
                }
            }
        }
        best
    }

    /// From there, entry by entry, with steps that are halved when none helps.
    fn pattern(&mut self, mut score: f64, mut gain: Rows, scale: &Rows) -> Rows {
        let mut share = 1.0;
        let mut halvings = 0;
        while halvings < HALVINGS && self.trials < MOST_TRIALS {
            let before = score;
            for i in 0..gain.len() {
                for o in 0..gain[i].len() {
                    let step = share * f64::max(scale[i][o], gain[i][o].abs());
                    for moved in [gain[i][o] + step, gain[i][o] - step] {
                        let mut trial = gain.clone();
                        trial[i][o] = moved;
                        if let Some(lower) = self.score(&trial).filter(|lower| *lower < score) {
                            (score, gain) = (lower, trial);
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
        gain
    }

    /// The logarithm of what is made small: the geometric mean of the states' noise gains, the price of X, and,
    /// where the errors contract from reset to reset, how long an error of noise stays.
    fn score(&mut self, gain: &Rows) -> Option<f64> {
        self.trials += 1;
        let precision = self.phi.precision();
        let rows: Option<Vec<Vec<Real>>> =
            gain.iter().map(|row| row.iter().map(|x| Real::from_f64(*x, precision)).collect()).collect();
        let rows = rows?;
        let gain = Matrix::from_fn(gain.len(), self.trust.len(), |i, o| rows[i][o].clone());
        let pair = pair(&self.blocks, &gain, |m| Ok(m.powi(self.calls.period as u64))).ok()?;
        let amplification = balanced(&pair.x).0.norm_inf().to_f64();
        let weights = Weights::new(&self.blocks, &gain, &pair);
        let states = weights.worst(self.calls.period, &self.trust);
        let mean = states.iter().map(|gain| deadbeat_math::log_f64(f64::max(*gain, f64::MIN_POSITIVE))).sum::<f64>()
            / crate::window::count(states.len());
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

/// What a sample's noise does to the copies and the reset, in doubles: they decide, and are in no constant.
struct Weights {
    rr: Rows,
    ry: Rows,
    h: Rows,
    g: Rows,
    x: Rows,
    gain: Rows,
}

impl Weights {
    fn new(blocks: &Blocks, gain: &Matrix, pair: &Pair) -> Self {
        let double = Matrix::to_f64;
        Self {
            rr: double(&blocks.rr),
            ry: double(&blocks.ry),
            h: double(&pair.h),
            g: double(&pair.g),
            x: double(&pair.x),
            gain: double(gain),
        }
    }

    /// The weights of the period's samples in z1 right after a reset, oldest first: N+1 matrices, (n-p) x p.
    fn at_reset(&self, period: usize) -> Vec<Rows> {
        let of_gain = product(&self.x, &self.gain);
        let mut first = self.x.clone();
        first.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
        let mut second: Rows = self.x.iter().map(|row| row.iter().map(|x| -x).collect()).collect();
        let mut weights = vec![of_gain];
        for _ in 0..period {
            weights.push(sum(&product(&first, &self.ry), &product(&second, &self.g)));
            first = product(&first, &self.rr);
            second = product(&second, &self.h);
        }
        let oldest = weights.len() - 1;
        weights[oldest] = sum(&weights[oldest], &product(&second, &self.gain));
        weights.reverse();
        weights
    }

    /// Per state of x_r: the gain from noise, in units of the outputs' trust, right after a reset or right before
    /// the next, whichever is larger.
    fn worst(&self, period: usize, trust: &[f64]) -> Vec<f64> {
        let gains = |weights: &[Rows]| -> Vec<f64> {
            let of = |i: usize| weights.iter().flat_map(|w| w[i].iter().zip(trust)).map(|(w, t)| w.abs() / t).sum();
            (0..self.rr.len()).map(of).collect()
        };
        let mut weights = self.at_reset(period);
        let now = gains(&weights);
        let mut since = self.ry.clone();
        let (mut tail, mut power) = (Vec::new(), identity(self.rr.len()));
        for _ in 1..period {
            tail.push(since.clone());
            since = product(&self.rr, &since);
            power = product(&self.rr, &power);
        }
        for weight in &mut weights {
            *weight = product(&power, weight);
        }
        // The sample of the reset drives the copy too.
        if let Some(last) = tail.pop() {
            let newest = weights.len() - 1;
            weights[newest] = sum(&weights[newest], &last);
        }
        weights.extend(tail);
        let later = gains(&weights);
        now.into_iter().zip(later).map(|(now, later)| now.max(later)).collect()
    }
}

fn identity(n: usize) -> Rows {
    (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

pub(super) fn product(a: &Rows, b: &Rows) -> Rows {
    let cols = b.first().map_or(0, Vec::len);
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(x, row)| x * row[j]).sum();
    a.iter().map(|row| (0..cols).map(|j| entry(row, j)).collect()).collect()
}

pub(super) fn sum(a: &Rows, b: &Rows) -> Rows {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a + b).collect()).collect()
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
