//! The Kalman filter of a sampled plant `x+ = Phi x + w`, `y = C x + v`: steady, and from the first call on.
//!
//! With Q and R the covariances of `w` and `v`, the prediction's covariance P solves the filter Riccati equation
//! `P = Phi (P - P C' (C P C' + R)^-1 C P) Phi' + Q`, and `K = P C' (C P C' + R)^-1` corrects the prediction by the
//! sample of the same instant: `x = x- + K (y - C x-)`.
//!
//! Steady: by doubling (`doubling`), which follows the covariance from nothing on, and never leaves that
//! where a growing mode is not excited by Q; there, by the stable subspace of the symplectic pencil, from the matrix sign
//! function of its Cayley transform (Lancaster and Rodman 1995, chapters 12 and 22), which is dearer. Both take any Phi,
//! singular ones too. Nothing is believed: `(I - K C) Phi` must contract, and the equation's residual goes with the solution.

use crate::real::{Matrix, Precision, Real, balanced, inverse, least_squares, solve, unbalanced};

use super::doubling::{Map, within_reach};
use super::noise::{Definiteness, definiteness};

/// Covariances per sample.
#[derive(Clone, Debug)]
pub struct Noise {
    /// Q, n x n.
    pub process: Matrix,
    /// R, p x p.
    pub measurement: Matrix,
}

/// The filter after all transients.
#[derive(Clone, Debug)]
pub struct Steady {
    /// K, n x p.
    pub gain: Matrix,
    /// P, n x n: the covariance of the prediction's error.
    pub predicted: Matrix,
    /// Largest entry of the Riccati equation's residual, relative to the largest entry of P.
    pub residual: f64,
}

/// Why there is no steady filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// R is not positive definite.
    MeasurementNoise(Definiteness),
    /// Q is not positive semi-definite.
    ProcessNoise,
    /// (C, Phi) is not detectable: a mode that does not die out is not seen.
    Undetectable,
    /// A mode on the unit circle is not excited by Q: its variance shrinks to nothing, and K with it.
    Unexcited,
}

/// Guard bits of the sign iteration.
pub(super) const GUARD: usize = 64;
/// Steps of the sign iteration, which converges quadratically; a pencil with an eigenvalue on the unit circle to half
/// of all digits never settles.
const ITERATIONS: usize = 100;
/// Squarings of the closed loop's map until it must contract; what takes longer is not stable.
const SQUARINGS: usize = 100;
/// Bits at which stability is checked.
const STABILITY_BITS: usize = 256;

/// The steady filter of a plant: Phi n x n, C p x n.
///
/// # Errors
/// [`Failure`].
pub fn steady(phi: &Matrix, c: &Matrix, noise: &Noise) -> Result<Steady, Failure> {
    check(noise)?;
    told_apart(noise, |noise, way| solution(phi, c, noise, way))
}

/// The filter by either way, or why there is none.
pub(super) fn told_apart<T>(
    noise: &Noise,
    solution: impl Fn(&Noise, Way) -> Result<Option<T>, Failure>,
) -> Result<T, Failure> {
    if let Some(found) = solution(noise, Way::Doubling)? {
        return Ok(found);
    }
    // With every state excited, only what is not seen stands in the way.
    let process = Matrix::identity(noise.process.rows(), noise.process.precision());
    let excited = Noise { process, measurement: noise.measurement.clone() };
    if solution(&excited, Way::Doubling)?.is_none() {
        return Err(Failure::Undetectable);
    }
    solution(noise, Way::Subspace)?.ok_or(Failure::Unexcited)
}

/// How a covariance is found that calls leave as it is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Way {
    /// From nothing on.
    Doubling,
    /// By the stable subspace.
    Subspace,
}

impl Way {
    /// The covariance, at the precision of the map; `None` where there is none.
    pub(super) fn fixed_point(self, calls: &Map) -> Option<Matrix> {
        match self {
            Self::Doubling => calls.fixed_point(),
            Self::Subspace => subspace(&calls.a, &calls.g, &calls.h),
        }
    }
}

pub(super) fn check(noise: &Noise) -> Result<(), Failure> {
    match (definiteness(&noise.measurement), definiteness(&noise.process)) {
        (Definiteness::Definite, Definiteness::Indefinite) => Err(Failure::ProcessNoise),
        (Definiteness::Definite, _) => Ok(()),
        (other, _) => Err(Failure::MeasurementNoise(other)),
    }
}

/// The stabilising solution, if there is one.
fn solution(phi: &Matrix, c: &Matrix, noise: &Noise, way: Way) -> Result<Option<Steady>, Failure> {
    let Some(predicted) = predicted(phi, c, noise, way) else { return Ok(None) };
    let gain = gain(c, &predicted, noise)?;
    let closed = closed_loop(phi, c, &gain);
    if !contracts(&closed) {
        return Ok(None);
    }
    let updated = &predicted - &(&gain * &(c * &predicted));
    let next = &(&(phi * &updated) * &phi.transpose()) + &noise.process;
    let size = predicted.max_abs();
    let residual = (&next - &predicted).max_abs().checked_div(&size).map_or(0.0, |residual| residual.to_f64());
    Ok(Some(Steady { gain, predicted, residual }))
}

/// K of a prediction with this covariance.
pub(super) fn gain(c: &Matrix, predicted: &Matrix, noise: &Noise) -> Result<Matrix, Failure> {
    let seen = c * predicted;
    let innovation = &(&seen * &c.transpose()) + &noise.measurement;
    let gain = solve(&innovation, &seen).map_err(|_| Failure::MeasurementNoise(Definiteness::Semidefinite))?;
    Ok(gain.transpose())
}

/// `(I - K C) Phi`, n x n: what a call does to the estimate's error.
pub fn closed_loop(phi: &Matrix, c: &Matrix, gain: &Matrix) -> Matrix {
    phi - &(&(gain * c) * phi)
}

/// Whether the powers of a map die out.
pub fn contracts(map: &Matrix) -> bool {
    let mut power = map.with_precision(Precision::bits(STABILITY_BITS));
    for _ in 0..SQUARINGS {
        if power.norm_inf() < Real::one(power.precision()) {
            return true;
        }
        let Some(within) = within_reach(&power) else { return false };
        power = &within * &within;
    }
    false
}

/// P, with guard bits on the way.
fn predicted(phi: &Matrix, c: &Matrix, noise: &Noise, way: Way) -> Option<Matrix> {
    let p = phi.precision();
    let working = p.plus(GUARD);
    let wide = |m: &Matrix| m.with_precision(working);
    let (phi, c, q, r) = (wide(phi), wide(c), wide(&noise.process), wide(&noise.measurement));
    let information = &c.transpose() * &solve(&r, &c).ok()?;
    way.fixed_point(&Map { a: phi, g: information, h: q }).map(|solution| solution.with_precision(p))
}

/// P of `P = Phi (I + P G)^-1 P Phi' + Q` with G n x n the information of a call's samples, from the pencil
/// `[[Phi', 0], [-Q, I]] - z [[I, G], [0, Phi]]`: `[I; P]` spans what is inside the unit circle. `None` where an eigenvalue
/// lies on it or the subspace has no such basis.
fn subspace(phi: &Matrix, information: &Matrix, q: &Matrix) -> Option<Matrix> {
    let (n, working) = (phi.rows(), phi.precision());
    let identity = Matrix::identity(n, working);
    let mut left = Matrix::zeros(2 * n, 2 * n, working);
    left.set_block(0, 0, &phi.transpose());
    left.set_block(n, 0, &-q);
    left.set_block(n, n, &identity);
    let mut right = Matrix::zeros(2 * n, 2 * n, working);
    right.set_block(0, 0, &identity);
    right.set_block(0, n, information);
    right.set_block(n, n, phi);
    let cayley = solve(&(&left + &right), &(&left - &right)).ok()?;
    let (scaled, shifts) = balanced(&cayley);
    let outside = &unbalanced(&sign(&scaled)?, &shifts) + &Matrix::identity(2 * n, working);
    let solution = least_squares(&outside.block(0..2 * n, n..2 * n), &-&outside.block(0..2 * n, 0..n)).ok()?;
    Some((&solution + &solution.transpose()).shifted(-1))
}

/// The matrix sign function by Newton's iteration, scaled by powers of two; `None` where it does not settle.
fn sign(matrix: &Matrix) -> Option<Matrix> {
    let p = matrix.precision();
    let mut sign = matrix.clone();
    let mut last = false;
    for _ in 0..ITERATIONS {
        let inverse = inverse(&sign).ok()?;
        let scale = (inverse.max_abs().top()? - sign.max_abs().top()?) / 2;
        let next = (&sign.shifted(scale) + &inverse.shifted(-scale)).shifted(-1);
        if last {
            return Some(next);
        }
        // Quadratic: half of the digits agree, so that all do after the next.
        let change = (&next - &sign).max_abs().log2_abs() - next.max_abs().log2_abs();
        last = change < -bits(p) / 2.0;
        sign = next;
    }
    None
}

/// The gains, n x p, of the calls 1 … `calls`, from the covariance of the estimate at call 0.
///
/// # Errors
/// [`Failure::MeasurementNoise`], [`Failure::ProcessNoise`].
pub fn transient(
    phi: &Matrix,
    c: &Matrix,
    noise: &Noise,
    start: &Matrix,
    calls: usize,
) -> Result<Vec<Matrix>, Failure> {
    check(noise)?;
    let mut covariance = start.clone();
    let mut gains = Vec::with_capacity(calls);
    for _ in 0..calls {
        let predicted = &(&(phi * &covariance) * &phi.transpose()) + &noise.process;
        let gain = gain(c, &predicted, noise)?;
        let updated = &predicted - &(&gain * &(c * &predicted));
        covariance = (&updated + &updated.transpose()).shifted(-1);
        gains.push(gain);
    }
    Ok(gains)
}

/// The covariance, n x n, of an estimate whose measured states were taken from the first sample, by `readout` (n x p,
/// rows of zeros for what is not measured), and whose others are off by `deviation` (n; not read where measured).
pub fn first_covariance(readout: &Matrix, deviation: &[Real], noise: &Noise) -> Matrix {
    let measured = |i: usize| (0..readout.cols()).any(|o| !readout[(i, o)].is_zero());
    let mut covariance = &(readout * &noise.measurement) * &readout.transpose();
    for (i, deviation) in deviation.iter().enumerate().filter(|(i, _)| !measured(*i)) {
        covariance[(i, i)] = deviation * deviation;
    }
    covariance
}

pub(super) fn bits(p: Precision) -> f64 {
    crate::numbers::count(p.as_bits())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decimal::parse;
    use crate::real::singular_values;

    fn bits_256() -> Precision {
        Precision::bits(256)
    }

    fn real(text: &str) -> Real {
        Real::from_rational(&parse(text).unwrap(), bits_256())
    }

    fn matrix<const C: usize>(rows: &[[&str; C]]) -> Matrix {
        Matrix::from_fn(rows.len(), C, |i, j| real(rows[i][j]))
    }

    fn noise(process: Matrix, measurement: Matrix) -> Noise {
        Noise { process, measurement }
    }

    /// `P = (s + sqrt(s^2 + 4 q r)) / 2`, `s = q - (1 - a^2) r`; a growing mode without noise is mirrored.
    #[test]
    fn one_state_has_its_closed_form() {
        for (a, q, r) in
            [("0.9", "0.3", "2"), ("1", "1e-12", "1e6"), ("-1.3", "0.01", "0.5"), ("0", "1", "1"), ("2", "0", "3")]
        {
            let (phi, q, r) = (matrix(&[[a]]), real(q), real(r));
            let found =
                steady(&phi, &matrix(&[["1"]]), &noise(phi.map(|_| q.clone()), phi.map(|_| r.clone()))).unwrap();
            let a = &phi[(0, 0)];
            let s = &q - (Real::one(bits_256()) - a * a) * &r;
            let root = (&s * &s + (&q * &r).shifted(2)).checked_sqrt().unwrap();
            let exact = (&s + &root).shifted(-1);
            assert!((&found.predicted[(0, 0)] - &exact).log2_abs() < exact.log2_abs() - 200.0, "{a:?}");
            assert!(found.residual < 1e-60);
        }
    }

    /// Kalata 1984, "The tracking index": with `L = sigma_w h^2 / sigma_v`, `r = (4 + L - sqrt(8 L + L^2)) / 4`,
    /// alpha = 1 - r^2 and beta = 2 (2 - alpha) - 4 sqrt(1 - alpha); here h = 1.
    #[test]
    fn alpha_and_beta_are_those_of_the_tracking_index() {
        for index in ["0.001", "0.3", "7"] {
            let index = real(index);
            let square = &index * &index;
            let q = Matrix::from_fn(2, 2, |i, j| square.shifted(i64::from(i == 1) + i64::from(j == 1) - 2));
            let phi = matrix(&[["1", "1"], ["0", "1"]]);
            let found = steady(&phi, &matrix(&[["1", "0"]]), &noise(q, matrix(&[["1"]]))).unwrap();
            let four = Real::from_i64(4, bits_256());
            let root = (index.shifted(3) + &square).checked_sqrt().unwrap();
            let r = (&four + &index - root) / &four;
            let alpha = Real::one(bits_256()) - &r * &r;
            let beta = (Real::from_i64(2, bits_256()) - &alpha).shifted(1) - r.shifted(2);
            assert!((&found.gain[(0, 0)] - &alpha).log2_abs() < alpha.log2_abs() - 180.0);
            assert!((&found.gain[(1, 0)] - &beta).log2_abs() < beta.log2_abs() - 180.0);
        }
    }

    #[test]
    fn random_plants_have_a_stable_solution_of_the_equation() {
        let mut state = 5_u64;
        let mut next = |_: usize, _: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(99);
            Real::from_i64((state >> 33).cast_signed() - (1 << 30), bits_256()).shifted(-30)
        };
        for (n, p) in [(1, 1), (2, 1), (3, 2), (5, 1), (6, 3), (8, 1)] {
            // Eigenvalues of either side of the circle.
            let phi = Matrix::from_fn(n, n, &mut next).shifted(1);
            let c = Matrix::from_fn(p, n, &mut next);
            let factor = Matrix::from_fn(n, n, &mut next);
            let noise = noise(&factor * &factor.transpose(), Matrix::identity(p, bits_256()).shifted(-10));
            let found = steady(&phi, &c, &noise).unwrap();
            assert!(found.residual < 1e-60, "{n}: {:e}", found.residual);
            assert!(contracts(&closed_loop(&phi, &c, &found.gain)));
            assert_eq!(definiteness(&found.predicted), Definiteness::Definite);
            // The same gain to all digits at twice as many.
            let wide = |m: &Matrix| m.with_precision(bits_256().doubled());
            let twice = Noise { process: wide(&noise.process), measurement: wide(&noise.measurement) };
            let twice = steady(&wide(&phi), &wide(&c), &twice).unwrap();
            let difference = (&twice.gain - &found.gain).max_abs().log2_abs();
            assert!(difference < twice.gain.max_abs().log2_abs() - 200.0, "{n}");
        }
    }

    /// Doubling and the stable subspace know nothing of each other: to all digits they give the same covariance, also of a
    /// filter that forgets slowly.
    #[test]
    fn both_ways_give_the_same_covariance() {
        let slow = matrix(&[["1", "0.001"], ["0", "1"]]);
        let fast = matrix(&[["1.5", "0.25"], ["-0.5", "0.75"]]);
        let c = matrix(&[["1", "0"]]);
        for (phi, q) in [(slow, ["0", "1e-14"]), (fast, ["0.1", "1e-3"])] {
            let process = matrix(&[[q[0], "0"], ["0", q[1]]]);
            let noise = noise(process, matrix(&[["0.01"]]));
            let by = |way| predicted(&phi, &c, &noise, way).unwrap();
            let (doubled, subspace) = (by(Way::Doubling), by(Way::Subspace));
            let off = (&doubled - &subspace).max_abs().log2_abs() - subspace.max_abs().log2_abs();
            assert!(off < -200.0, "{off}");
        }
    }

    #[test]
    fn what_has_no_steady_filter_is_told_apart() {
        let one = matrix(&[["1"]]);
        let zero = Matrix::zeros(1, 1, bits_256());
        let steady_of = |phi: &Matrix, c: &Matrix, q: &Matrix, r: &Matrix| {
            steady(phi, c, &noise(q.clone(), r.clone())).map(|s| s.gain.to_f64())
        };
        // A constant without noise: K goes to 0 like 1/k.
        assert_eq!(steady_of(&one, &one, &zero, &one), Err(Failure::Unexcited));
        assert_eq!(steady_of(&one, &zero, &one, &one), Err(Failure::Undetectable));
        assert_eq!(steady_of(&one, &one, &one, &zero), Err(Failure::MeasurementNoise(Definiteness::Semidefinite)));
        assert_eq!(steady_of(&one, &one, &-&one, &one), Err(Failure::ProcessNoise));
        // A growing mode that is not seen, beside one that is.
        let phi = matrix(&[["0.5", "0"], ["0", "1.5"]]);
        let (seen, unseen) = (matrix(&[["0", "1"]]), matrix(&[["1", "0"]]));
        let identity = Matrix::identity(2, bits_256());
        assert_eq!(steady_of(&phi, &unseen, &identity, &one), Err(Failure::Undetectable));
        // A mode that dies out need not be seen.
        assert!(steady_of(&phi, &seen, &identity, &one).is_ok());
        // A rotation at a seventh of a turn per sample, and a ramp, without noise.
        let (c, s) = ("0.6234898018587335305250048840042398", "0.7818314824680298087084445266740577");
        let turn = real(c);
        let rotation = Matrix::from_fn(2, 2, |i, j| match (i, j) {
            (0, 1) => real(s),
            (1, 0) => -real(s),
            _ => turn.clone(),
        });
        // Of determinant one to 34 digits only: made exact.
        let norm = (&turn * &turn + real(s) * real(s)).checked_sqrt().unwrap();
        let rotation = rotation.map(|x| x / &norm);
        let none = Matrix::zeros(2, 2, bits_256());
        assert_eq!(steady_of(&rotation, &unseen, &none, &one), Err(Failure::Unexcited));
        let ramp = matrix(&[["1", "1"], ["0", "1"]]);
        assert_eq!(steady_of(&ramp, &unseen, &none, &one), Err(Failure::Unexcited));
    }

    /// The transient ends in the steady gain; its first gain on two states is the regression through two samples.
    #[test]
    fn the_transient_leads_from_regression_to_the_steady_gain() {
        let phi = matrix(&[["1", "1"], ["0", "1"]]);
        let c = matrix(&[["1", "0"]]);
        let noise = noise(matrix(&[["0.01", "0.02"], ["0.02", "0.04"]]), matrix(&[["0.5"]]));
        let start = first_covariance(&matrix(&[["1"], ["0"]]), &[Real::zero(bits_256()), real("1e30")], &noise);
        let gains = transient(&phi, &c, &noise, &start, 400).unwrap();
        assert!((gains[0].to_f64()[0][0] - 1.0).abs() < 1e-15 && (gains[0].to_f64()[1][0] - 1.0).abs() < 1e-15);
        let steady = steady(&phi, &c, &noise).unwrap();
        assert!((&gains[399] - &steady.gain).max_abs().log2_abs() < -100.0);
        assert!(singular_values(&closed_loop(&phi, &c, &steady.gain))[1].log2_abs() < 0.0);
    }
}
