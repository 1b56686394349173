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
use crate::real::{Matrix, Precision, Real, inverse};
use crate::window::coordinates::{Blocks, Coordinates};
use crate::window::model::Model;

use super::Calls;
use super::errors::{ErrorMap, spectral_radius};
use super::exact::{Exact, ExactUpdate, Failure, Pair, pair};

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
    let rounded = best.map(|(_, alike)| rounded(&size.gain(&alike, &search.trust), &size.gain));
    Ok(rounded.filter(|(gain, _)| search.score(gain, &size).is_some()).map(|(_, constants)| constants))
}

/// Trials that the work allows; each takes powers and an inverse of matrices of this size.
fn most_trials(rest: usize, period: usize) -> usize {
    let products = 2 * period.max(2).ilog2() as usize + 6;
    MOST_WORK / (rest * rest * rest * products)
}

type Rows = Vec<Vec<f64>>;

/// What is large and what is small for a plant, whatever its units.
pub struct Size {
    /// Of `x_r`: what one unit of the outputs' trust, once in the window, leaves unknown of it.
    rest: Vec<f64>,
    /// Of the entries of L.
    gain: Rows,
    /// S with `S S' = W^-1`, W the Gramian of `x_r` over the window: what is alike in its columns' coordinates.
    root: Rows,
    /// A first L, `-W^-1 Phi_yr'`, in these coordinates.
    start: Rows,
}

impl Size {
    /// Of a sampled plant.
    pub fn new(blocks: &Blocks, trust: &[f64], period: usize) -> Option<Self> {
        let (p, rest, precision) = (blocks.yr.rows(), blocks.rr.rows(), blocks.rr.precision());
        let mut weights = Matrix::zeros(p, p, precision);
        for (o, trust) in trust.iter().enumerate() {
            weights[(o, o)] = Real::from_f64(*trust, precision)?;
        }
        let mut gramian = Matrix::zeros(rest, rest, precision);
        let mut seen = &weights * &blocks.yr;
        for _ in 0..period {
            gramian = &gramian + &(&seen.transpose() * &seen);
            seen = &seen * &blocks.rr;
        }
        let spread = inverse(&gramian).ok()?;
        let root = square_root(&spread)?;
        let samples = Real::from_f64(crate::window::count(period), precision)?.checked_sqrt().ok()?;
        let start = (&root.transpose() * &(&weights * &blocks.yr).transpose()).scale(&-&samples).to_f64();
        let root = root.map(|x| x / &samples).to_f64();
        let samples = samples.to_f64();
        let size = |i: usize| deadbeat_math::sqrt_f64(spread.get(i, i).to_f64().max(0.0));
        let sizes: Vec<f64> = (0..rest).map(size).collect();
        let gain: Rows = sizes.iter().map(|size| trust.iter().map(|trust| size * trust / samples).collect()).collect();
        let fine = start.iter().chain(&root).flatten().all(|x| x.is_finite());
        let fine = fine && gain.iter().flatten().all(|x| x.is_normal());
        fine.then_some(Self { rest: sizes, gain, root, start })
    }

    /// L from these coordinates.
    fn gain(&self, alike: &Rows, trust: &[f64]) -> Rows {
        let mut gain = product(&self.root, alike);
        for row in &mut gain {
            row.iter_mut().zip(trust).for_each(|(x, trust)| *x *= trust);
        }
        gain
    }

    /// By how much a period and its reset multiply the rounding error of one call: the sum over the calls of what
    /// both copies, as large as they become from a wrong start, add to the estimate.
    pub fn amplification(&self, [first, second]: [&Matrix; 2], x: &Matrix, gain: &Rows, period: usize) -> f64 {
        let (first, second) = (first.to_f64(), second.to_f64());
        let [mut kept, mut taken] = both(&x.to_f64());
        // z2 is of the size of x_r + L y.
        let shift = |j: usize| self.rest[j] * gain[j].iter().zip(&self.gain[j]).map(|(l, s)| l.abs() / s).sum::<f64>();
        let shifted: Vec<f64> = (0..gain.len()).map(|j| self.rest[j] + shift(j)).collect();
        let (of_first, of_second) = (grown(&first, &self.rest, period), grown(&second, &self.rest, period));
        let mut sums = vec![0.0; gain.len()];
        for call in (0..period).rev() {
            for (i, sum) in sums.iter_mut().enumerate() {
                let share = |j: usize| {
                    let own = kept[i][j].abs() * (self.rest[j] + of_first[call][j]);
                    own + taken[i][j].abs() * (shifted[j] + of_second[call][j])
                };
                *sum += (0..gain.len()).map(share).sum::<f64>() / self.rest[i];
            }
            kept = product(&kept, &first);
            taken = product(&taken, &second);
        }
        sums.into_iter().fold(0.0, |largest: f64, sum| if sum.is_finite() { largest.max(sum) } else { f64::INFINITY })
    }
}

/// What an error of these sizes becomes in a copy, by call.
fn grown(copy: &Rows, sizes: &[f64], period: usize) -> Vec<Vec<f64>> {
    let mut power = identity(copy.len());
    let mut all = Vec::new();
    for _ in 0..period {
        power = product(copy, &power);
        all.push(power.iter().map(|row| row.iter().zip(sizes).map(|(x, size)| x.abs() * size).sum()).collect());
    }
    all
}

/// The lower triangular root of a symmetric positive matrix, after Cholesky.
fn square_root(matrix: &Matrix) -> Option<Matrix> {
    let n = matrix.rows();
    let mut root = Matrix::zeros(n, n, matrix.precision());
    for i in 0..n {
        for j in 0..=i {
            let known = Real::sum_of_products((0..j).map(|k| (&root[(i, k)], &root[(j, k)])), matrix.precision());
            let left = matrix.get(i, j) - &known;
            root[(i, j)] = if i == j { left.checked_sqrt().ok()? } else { left.checked_div(&root[(j, j)]).ok()? };
        }
    }
    Some(root)
}

/// What a reset takes of z1 and z2: I + X and -X.
pub(super) fn both(x: &Rows) -> [Rows; 2] {
    let mut first = x.clone();
    first.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
    [first, x.iter().map(|row| row.iter().map(|x| -x).collect()).collect()]
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
                if let Some(score) = self.score(&size.gain(&alike, &self.trust), size)
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
                        let gain = size.gain(&trial, &self.trust);
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
            size.amplification([&self.blocks.rr, &pair.h], &pair.x, l, period) / crate::window::count(period);
        let weights = Weights::new(&self.blocks, &gain, &pair);
        let states = weights.worst(period, &self.trust);
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
        let [mut first, mut second] = both(&self.x);
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

    /// Per state of `x_r`: the gain from noise, in units of the outputs' trust, right after a reset or right before
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

#[cfg(test)]
mod tests {
    use crate::method::designed;

    /// The arm's velocity over 50 samples: the smallest gain that any weights have is 40 (from the two ends of the
    /// window), and the search comes close to it with a reset that costs less than two digits.
    #[test]
    fn the_gain_is_near_the_smallest_there_is() {
        let (_, design) = designed(include_str!("../../specs/pendulum_impulsive.toml")).unwrap();
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
