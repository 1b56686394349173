//! How the errors of the observer move: one call, one reset, one period.
//!
//! The errors are `s = (x_r - z1, x_r + L y - z2, y - w, and y - w of earlier calls as far as an output's run needs
//! them)`; what the observer takes for the output is the sample where there is one and the prediction w elsewhere.
//! Right after a reset both copies have the same error and the sample is right, so that one period is a map of
//! fewer numbers. With a sample at every call that map is 0.

use crate::promise::CONTRACTED;
use crate::real::{Matrix, Precision, Real, singular_values};

use super::Calls;
use super::exact::{Exact, ExactUpdate};

/// The maps of the errors; D = 2 (n-p) + p times the outputs' ages.
#[derive(Clone, Debug)]
pub struct ErrorMap {
    /// n-p.
    rest: usize,
    /// p.
    outputs: usize,
    /// One call without a sample, D x D.
    pub free: Matrix,
    /// One call with a sample, D x D.
    pub measured: Matrix,
    /// A reset, behind a call, D x D.
    pub reset: Matrix,
    /// What the noise of a sample adds to its call, D x p.
    pub noise: Matrix,
    /// What a unit added to the plant's state just before a call adds to that call: without and with a sample, D x n.
    pub disturbed: [Matrix; 2],
    /// What an error of a known's value adds to calls with a sample: per known and age, D x 1.
    pub knowns: Vec<Vec<Matrix>>,
    /// The error of the plant's states, n x D.
    pub estimate: Matrix,
}

impl ErrorMap {
    /// The maps of a design.
    pub fn new(exact: &Exact) -> Self {
        let (p, rest) = (exact.coordinates.outputs(), exact.coordinates.rest.len());
        let ages = exact.first.outputs.len() - 1;
        let precision = exact.phi.precision();
        let (n, size) = (p + rest, 2 * rest + p * ages);
        let zeros = |rows: usize, cols: usize| Matrix::zeros(rows, cols, precision);
        // A column of e1, e2, the newest y - w: what adds to each, with what the newest output does to the copies.
        let stacked = |first: &Matrix, second: &Matrix, output: &Matrix| {
            let mut all = zeros(size, first.cols());
            all.set_block(0, 0, &(first + &(&exact.first.outputs[0] * output)));
            all.set_block(rest, 0, &(second + &(&exact.second.outputs[0] * output)));
            all.set_block(2 * rest, 0, output);
            all
        };
        let mut prediction = zeros(p, size);
        prediction.set_block(0, 0, &exact.predictor.copy);
        for (age, of_output) in exact.predictor.outputs.iter().enumerate().skip(1) {
            prediction.set_block(0, 2 * rest + p * (age - 1), of_output);
        }
        // What a prediction does to itself, by way of terms that are evaluated at it.
        prediction = &prediction + &(&exact.predictor.outputs[0] * &prediction);
        let row = |update: &ExactUpdate, place: usize| {
            let mut row = zeros(rest, size);
            row.set_block(0, place, &update.copy);
            for (age, of_output) in update.outputs.iter().enumerate().skip(1) {
                row.set_block(0, 2 * rest + p * (age - 1), of_output);
            }
            row
        };
        let call = |output: &Matrix| {
            let mut all = stacked(&row(&exact.first, 0), &row(&exact.second, rest), output);
            for k in 0..p * (ages - 1) {
                all[(2 * rest + p + k, 2 * rest + k)] = Real::one(precision);
            }
            all
        };
        let free = call(&prediction);
        let measured = call(&zeros(p, size));

        let (x, gain) = (&exact.pair.x, &exact.gain);
        let mut reset = Matrix::identity(size, precision);
        let kept = &Matrix::identity(rest, precision) + x;
        let of_output = x * gain;
        for place in [0, rest] {
            reset.set_block(place, 0, &kept);
            reset.set_block(place, rest, &-x);
        }
        reset.set_block(0, 2 * rest, &of_output);
        reset.set_block(rest, 2 * rest, &(&of_output + gain));

        let into = &exact.coordinates.into;
        let (above, below) = (into.block(0..p, 0..n), into.block(p..n, 0..n));
        let shifted = &below + &(gain * &above);
        let disturbed = [stacked(&below, &shifted, &above), stacked(&below, &shifted, &zeros(p, n))];
        let unseen = &-&Matrix::identity(p, precision);
        let noise = stacked(&zeros(rest, p), &zeros(rest, p), unseen);
        let pairs = exact.first.knowns.iter().zip(&exact.second.knowns);
        let knowns = pairs.map(|(first, second)| {
            first.iter().zip(second).map(|(first, second)| stacked(first, second, &zeros(p, 1))).collect()
        });
        let knowns = knowns.collect();
        let back = &exact.coordinates.back;
        let mut estimate = zeros(n, size);
        estimate.set_block(0, 0, &back.block(0..n, p..n));
        estimate.set_block(0, 2 * rest, &back.block(0..n, 0..p));
        Self { rest, outputs: p, free, measured, reset, noise, disturbed, knowns, estimate }
    }

    /// From right after one reset to right after the next.
    pub fn period(&self, calls: &Calls) -> Matrix {
        let (size, precision) = (self.free.rows(), self.free.precision());
        // The common error of the copies, and the outputs' errors of earlier calls.
        let older = 2 * self.rest + self.outputs;
        let few = self.rest + size - older;
        let mut spread = Matrix::zeros(size, few, precision);
        let mut picked = Matrix::zeros(few, size, precision);
        for i in 0..self.rest {
            for place in [i, self.rest + i] {
                spread[(place, i)] = Real::one(precision);
            }
            picked[(i, i)] = Real::one(precision);
        }
        for k in 0..size - older {
            spread[(older + k, self.rest + k)] = Real::one(precision);
            picked[(self.rest + k, older + k)] = Real::one(precision);
        }
        let block = &self.measured * &self.free.powi(calls.every as u64 - 1);
        let through = block.powi((calls.period / calls.every) as u64);
        &(&picked * &(&self.reset * &through)) * &spread
    }
}

/// Squarings after which the norm of a power tells the radius to ten digits, and that power.
const SQUARINGS: (usize, f64) = (40, 1_099_511_627_776.0);
/// A radius below this is that of a nilpotent map with rounding errors.
const NOTHING: f64 = 1e-12;

/// The largest magnitude of an eigenvalue, by the norm of a high power.
pub fn spectral_radius(map: &Matrix) -> f64 {
    let mut power = map.clone();
    for _ in 0..SQUARINGS.0 {
        power = &power * &power;
    }
    let bits = power.max_abs().log2_abs() / SQUARINGS.1;
    let radius = deadbeat_math::pow_f64(2.0, bits);
    if radius < NOTHING { 0.0 } else { radius }
}

/// Bits at which powers of the period's map are taken.
const POWER_BITS: usize = 256;
/// The most periods that a convergence may take.
pub const MOST_PERIODS: usize = 300;

/// Periods after which [`CONTRACTED`] of an initial error is left, in the 2-norm; `None` when they are too many.
pub fn periods(map: &Matrix) -> Option<usize> {
    let map = map.with_precision(Precision::bits(POWER_BITS));
    let mut power = map.clone();
    for periods in 1..=MOST_PERIODS {
        let largest = power.max_abs().to_f64();
        // The 2-norm is between the largest entry and the root of the number of entries times it.
        if largest < CONTRACTED && singular_values(&power).first().is_none_or(|norm| norm.to_f64() < CONTRACTED) {
            return Some(periods);
        }
        power = &power * &map;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimator::copies::exact::{Choice, exact};
    use crate::estimator::copies::known::knowns;
    use crate::estimator::copies::{Between, Form};
    use crate::method::designed;

    const MOTOR: &str = "deadbeat = 1\nname = 'm'\n[plant]\nA = [[0, 1, 0], [0, -1, 15], [0, -36.4, -200]]\nC = [[1, 0, 0]]\n\
                         [observer.impulsive]\nwindow = 0.1\nL = [[-1], [3]]\n[target]\nsample_time = 5e-3\n";

    fn map(form: Form, between: Between) -> ErrorMap {
        let (plant, design) = designed(MOTOR).unwrap();
        assert_eq!(design.window_steps, 20);
        let decimal = |x: i64| crate::expr::Constant::from(crate::real::Rational::from(x));
        let gain = vec![vec![decimal(-1)], vec![decimal(3)]];
        let choice = Choice { form, between, period: 20, rest: vec![1, 2], gain };
        let Ok(exact) = exact(&plant, &choice, &knowns(&plant, between), Precision::bits(512)) else {
            unreachable!("this motor has numbers")
        };
        ErrorMap::new(&exact)
    }

    /// With a sample at every call a reset leaves nothing; with fewer, something, and more the fewer there are.
    #[test]
    fn a_period_of_samples_leaves_nothing() {
        for (form, between) in
            [(Form::Exact, Between::Lines), (Form::Continuous, Between::Lines), (Form::Continuous, Between::Cubics)]
        {
            let map = map(form, between);
            let calls = |every| Calls { period: 20, every, warm_up: 0, converged: 0 };
            let left = map.period(&calls(1));
            // Of an error of the copies; older outputs have none with a sample at every call.
            let left = left.block(0..left.rows(), 0..2);
            assert!(left.max_abs().log2_abs() < -400.0, "{form:?}, {between:?}");
            let radii = [2, 4, 10].map(|every| spectral_radius(&map.period(&calls(every))));
            assert!(0.0 < radii[0] && radii[0] < radii[1] && radii[1] < radii[2], "{form:?}, {between:?}: {radii:?}");
        }
    }

    #[test]
    fn radii_are_those_of_known_matrices() {
        let p = Precision::bits(256);
        let matrix = |rows: [[i64; 2]; 2]| Matrix::from_fn(2, 2, |i, j| Real::from_i64(rows[i][j], p).shifted(-4));
        for (rows, radius) in
            [([[8, 3], [0, -12]], 0.75), ([[3, -4], [4, 3]], 0.3125), ([[8, 1], [0, 8]], 0.5), ([[0, 9], [0, 0]], 0.0)]
        {
            assert!((spectral_radius(&matrix(rows)) - radius).abs() < 1e-9, "{rows:?}");
        }
        // 0.5^20 = 9.5e-7.
        assert_eq!(periods(&matrix([[8, 0], [0, 2]])), Some(20));
        assert_eq!(periods(&matrix([[16, 0], [0, 2]])), None);
    }
}
