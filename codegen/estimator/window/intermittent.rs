//! Measurements at irregular times (000 Theorem 2): what its condition says, and what the linear part does.
//!
//! Between measurements omega, the model's prediction, stands in for the output. Two questions decide whether the
//! error dies out. The paper's condition `T mu < 1` (000 (40)-(41)) is sufficient; its `q1` lacks the term of the
//! newest innovation, so that `q1 + |R|` stands here, and in `varsigma_3` `e^{ks}` where (38) prints `e^{-ks}`. It is
//! very conservative. The linear part's error is itself a linear recursion: with a measurement every g samples
//! its map over g samples is a matrix, and its spectral radius predicts what happens.

use std::ops::RangeInclusive;

use nalgebra::{DMatrix, Schur};

use crate::real::{Matrix, Real, exponential, singular_values};

use super::Functional;
use super::continuous::Constants;

/// Intervals of the quadrature over the window.
const PANELS: usize = 400;
/// The largest error map whose eigenvalues are computed.
const LARGEST: usize = 600;
/// Up to so many times its rows cubed, for every gap; beyond, for the longest gap only.
const MOST_EXACT: usize = 30_000_000;
/// Half of the periods that are iterated at least.
const WARM: usize = 64;
/// The most work of half the iterations of all gaps together, in products; beyond, some gaps are left out.
const MOST_ITERATED: usize = 200_000_000;
/// Sweeps of the QR algorithm before it is given up.
const SWEEPS: usize = 100_000;

/// What 000 Theorem 2 says, corrected.
#[derive(Clone, Copy, Debug)]
pub struct Condition {
    /// mu, 1/s.
    pub mu: f64,
    /// `T mu`, which must be below 1.
    pub product: f64,
    /// The guaranteed rate, 1/s, where it is.
    pub rate: Option<f64>,
}

/// The largest singular value.
fn norm(m: &Matrix) -> f64 {
    singular_values(m).first().map_or(0.0, Real::to_f64)
}

impl Condition {
    /// For Lipschitz constants K1, K2 (000 (3)), a window of `tau` and gaps up to `gap` seconds; k must be positive.
    pub fn new(constants: &Constants, k: f64, tau: f64, gap: f64, (k1, k2): (f64, f64)) -> Option<Self> {
        let exp = deadbeat_math::exp_f64;
        let (a1, a2) = (norm(&constants.a1), norm(&constants.a2));
        // Where outputs count by their noise, every integral of (38) has their weight in it.
        let s_inverse = norm(&constants.s_inverse) * norm(&constants.weight);
        let h = norm(constants.h.as_ref()?);
        let lambda = lambda_norms(constants, k, tau)?;
        let d = tau / crate::numbers::count(PANELS);
        // Simpson over s = -j d.
        let integral = |weight: &dyn Fn(f64) -> f64| -> f64 {
            let term = |(j, lambda): (usize, &f64)| {
                let simpson = if j == 0 || j == PANELS {
                    1.0
                } else if j % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                simpson * lambda * weight(-d * crate::numbers::count(j))
            };
            lambda.iter().enumerate().map(term).sum::<f64>() * d / 3.0
        };
        let growth = exp(a1 * tau);
        let s1 = s_inverse * a2 * growth / (k * k) * integral(&|s| exp(k * s) - s * k - 1.0);
        let s2 = s_inverse / k * integral(&|s| 1.0 - exp(k * s));
        let s3 = s_inverse * tau * growth * h * integral(&|s| growth + exp(k * s));
        let rest = constants.a1.rows();
        let twice =
            Matrix::identity(rest, constants.a1.precision()).scale(&Real::from_f64(k, constants.a1.precision())?);
        let psi2 = norm(&(&constants.a1.transpose() + &twice.shifted(1)));
        let s4 = s_inverse * h * ((1.0 - exp(-k * tau)) / k + tau * exp(psi2 * tau));
        let q1 = (s1 + s3) * k1 + s2 * k2 + s4;
        let mu = a2 * (q1 + norm(&constants.r)) + k + k2;
        let product = gap * mu;
        let rate = (product < 1.0).then(|| -deadbeat_math::log_f64(product) / (tau + gap));
        mu.is_finite().then_some(Self { mu, product, rate })
    }
}

/// `|lambda(-j d)|` for j = 0 … [`PANELS`].
fn lambda_norms(constants: &Constants, k: f64, tau: f64) -> Option<Vec<f64>> {
    let (a1, a2) = (&constants.a1, &constants.a2);
    let (rest, p, precision) = (a1.rows(), a2.rows(), a1.precision());
    let k = Real::from_f64(k, precision)?;
    let d = Real::from_f64(tau, precision)? / Real::from_i64(i64::try_from(PANELS).ok()?, precision);
    let mut block = Matrix::zeros(rest + p, rest + p, precision);
    block.set_block(0, 0, &(a1 + &Matrix::identity(rest, precision).scale(&k)));
    block.set_block(rest, 0, a2);
    let back = exponential(&-&block.scale(&d)).ok()?;
    let mut power = Matrix::identity(rest + p, precision);
    let mut norms = Vec::new();
    for _ in 0..=PANELS {
        norms.push(norm(&power.block(rest..rest + p, 0..rest)));
        power = &power * &back;
    }
    Some(norms)
}

/// How the linear part's error goes on when only every g-th sample is measured.
#[derive(Clone, Copy, Debug)]
pub struct Lifted {
    /// Spectral radius of the error's map over g samples.
    pub radius: f64,
    /// Periods of g samples until [`crate::promise::CONTRACTED`] of an error is left; `None` when it never is.
    pub periods: Option<usize>,
}

impl Lifted {
    /// Of all gaps the one after which an error takes most calls to die out, or the shortest with which it does not.
    ///
    /// The longest need not be the worst: where plant and weights swing, a shorter one may meet them. Of windows with
    /// more than 600 rows the contraction is that of two errors; gaps whose work is too much are thinned, but the
    /// longest is always looked at.
    pub fn slowest(
        functional: &Functional,
        output_next: &[Vec<f64>],
        gaps: RangeInclusive<usize>,
    ) -> Option<(usize, Self)> {
        let errors = Errors::new(functional, output_next);
        let (size, longest) = (errors.size(), *gaps.end());
        let all = size.saturating_pow(3).saturating_mul(gaps.clone().count()) <= MOST_EXACT;
        let calls = gaps.clone().map(|gap| gap * errors.warm(gap)).sum::<usize>();
        let work = calls.saturating_mul(size * errors.outputs);
        let mut looked_at: Vec<usize> = gaps.rev().step_by(work.div_ceil(MOST_ITERATED).max(1)).collect();
        looked_at.reverse();
        let mut slowest: Option<(usize, Self)> = None;
        for gap in looked_at {
            let exact = size <= LARGEST && (all || gap == longest);
            let lifted = match gap {
                // An error leaves with its sample; all eigenvalues are zero, which no algorithm finds.
                1 => Self { radius: 0.0, periods: Some(errors.rows.len()) },
                _ if exact => Self::exact(&errors, gap)?,
                _ => Self::by_iteration(&errors, gap),
            };
            let Some(periods) = lifted.periods.filter(|_| lifted.radius < 1.0) else { return Some((gap, lifted)) };
            let calls = |(gap, lifted): (usize, Self)| lifted.periods.map_or(0, |periods| periods * gap);
            if slowest.is_none_or(|slowest| calls(slowest) <= periods * gap) {
                slowest = Some((gap, lifted));
            }
        }
        slowest
    }

    fn exact(errors: &Errors, gap: usize) -> Option<Self> {
        let size = errors.size();
        let mut map = DMatrix::zeros(size, size);
        for j in 0..size {
            let mut window = vec![0.0; size];
            window[j] = 1.0;
            errors.period(&mut window, gap);
            map.set_column(j, &nalgebra::DVector::from_vec(window));
        }
        let schur = Schur::try_new(map.clone(), f64::EPSILON, SWEEPS)?;
        let eigenvalues = schur.complex_eigenvalues();
        let radius = eigenvalues.iter().map(|z| deadbeat_math::sqrt_f64(z.re * z.re + z.im * z.im)).fold(0.0, f64::max);
        Some(Self { radius, periods: contraction(&map, radius) })
    }

    /// From what becomes of two errors: one that all samples share, and one that swings.
    fn by_iteration(errors: &Errors, gap: usize) -> Self {
        let swinging = (0..errors.size()).map(|j| if j % 3 == 0 { 1.0 } else { -0.5 }).collect();
        let (one, two) = (Self::of(errors, gap, vec![1.0; errors.size()]), Self::of(errors, gap, swinging));
        let periods = one.periods.zip(two.periods).map(|(one, two)| one.max(two));
        Self { radius: one.radius.max(two.radius), periods }
    }

    /// From what becomes of an error whose largest entry is 1.
    fn of(errors: &Errors, gap: usize, mut window: Vec<f64>) -> Self {
        let half = errors.warm(gap);
        let contracted = deadbeat_math::log_f64(crate::promise::CONTRACTED);
        // Of what is left: the logarithm now, and after the first half.
        let (mut left, mut warm) = (0.0, 0.0);
        let mut periods = None;
        for step in 1..=2 * half {
            errors.period(&mut window, gap);
            let size = window.iter().fold(0.0_f64, |largest, e| largest.max(e.abs()));
            if size == 0.0 {
                return Self { radius: 0.0, periods: periods.or(Some(step)) };
            }
            for error in &mut window {
                *error /= size;
            }
            left += deadbeat_math::log_f64(size);
            if step == half {
                warm = left;
            }
            if left < contracted {
                periods = periods.or(Some(step));
            }
        }
        let rate = (left - warm) / crate::numbers::count(half);
        if rate < 0.0 && periods.is_none() {
            let needed = crate::numbers::count(2 * half) + (contracted - left) / rate;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive and clamped")]
            let needed = needed.ceil().clamp(1.0, 1e9) as usize;
            periods = Some(needed);
        }
        Self { radius: deadbeat_math::exp_f64(rate), periods }
    }
}

/// How the window's errors, newest first and output by output, give the next.
struct Errors {
    outputs: usize,
    /// By age: `C Phi K_j`, row by row.
    rows: Vec<Vec<f64>>,
}

impl Errors {
    fn new(functional: &Functional, output_next: &[Vec<f64>]) -> Self {
        let outputs = functional.outputs.len();
        let entry = |age: usize, o: usize, from: usize| -> f64 {
            output_next[o].iter().enumerate().map(|(i, c)| c * functional.outputs[from].at(i, age).double).sum()
        };
        let row = |age: usize| (0..outputs * outputs).map(|at| entry(age, at / outputs, at % outputs)).collect();
        Self { outputs, rows: (0..=functional.steps).map(row).collect() }
    }

    /// Of a window's errors.
    fn size(&self) -> usize {
        self.rows.len() * self.outputs
    }

    /// Periods after which a window's first errors have left it twice over.
    fn warm(&self, gap: usize) -> usize {
        WARM.max(2 * self.rows.len().div_ceil(gap))
    }

    /// The error of the prediction that takes a sample's place.
    fn predicted(&self, window: &[f64]) -> Vec<f64> {
        let of = |o: usize| -> f64 {
            let at = o * self.outputs..(o + 1) * self.outputs;
            let age = |(row, errors): (&Vec<f64>, &[f64])| -> f64 {
                row[at.clone()].iter().zip(errors).map(|(weight, error)| weight * error).sum()
            };
            self.rows.iter().zip(window.chunks(self.outputs)).map(age).sum()
        };
        (0..self.outputs).map(of).collect()
    }

    fn push(&self, window: &mut Vec<f64>, newest: Vec<f64>) {
        window.truncate((self.rows.len() - 1) * self.outputs);
        window.splice(0..0, newest);
    }

    /// From one measurement to the call before the next.
    fn period(&self, window: &mut Vec<f64>, gap: usize) {
        self.push(window, vec![0.0; self.outputs]);
        for _ in 1..gap {
            let newest = self.predicted(window);
            self.push(window, newest);
        }
    }
}

/// Gains from the noise of the measurements, each per state and output: worst case, and root sum of squares.
///
/// With a measurement every `gap` samples and predictions in between, which carry its noise on; at the worst call.
pub fn noise_gains(
    functional: &Functional,
    output_next: &[Vec<f64>],
    gap: usize,
    periods: usize,
) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let errors = Errors::new(functional, output_next);
    let n = functional.constant.len();
    let mut gains = (vec![vec![0.0; errors.outputs]; n], vec![vec![0.0; errors.outputs]; n]);
    for o in 0..errors.outputs {
        // Per call since the newest measurement: sums over the measurements before.
        let mut sums = vec![vec![(0.0, 0.0); n]; gap];
        let mut window = vec![0.0; errors.rows.len() * errors.outputs];
        for call in 0..(periods * gap).max(errors.rows.len()) {
            let mut newest = vec![0.0; errors.outputs];
            if call == 0 {
                newest[o] = 1.0;
            } else if call % gap > 0 {
                newest = errors.predicted(&window);
            }
            errors.push(&mut window, newest);
            for (i, sum) in sums[call % gap].iter_mut().enumerate() {
                let weight = |(age, errors): (usize, &[f64])| -> f64 {
                    errors.iter().enumerate().map(|(from, e)| e * functional.outputs[from].at(i, age).double).sum()
                };
                let response: f64 = window.chunks(errors.outputs).enumerate().map(weight).sum();
                sum.0 += response.abs();
                sum.1 += response * response;
            }
        }
        for sums in sums {
            for (i, (magnitudes, squares)) in sums.into_iter().enumerate() {
                gains.0[i][o] = f64::max(gains.0[i][o], magnitudes);
                gains.1[i][o] = f64::max(gains.1[i][o], deadbeat_math::sqrt_f64(squares));
            }
        }
    }
    gains
}

/// The first power of a map whose norm is small enough, by doubling and then bisection.
fn contraction(map: &DMatrix<f64>, radius: f64) -> Option<usize> {
    let small = |m: &DMatrix<f64>| m.norm() < crate::promise::CONTRACTED;
    if radius >= 1.0 {
        return None;
    }
    let mut powers = vec![map.clone()];
    while !small(&powers[powers.len() - 1]) {
        let last = &powers[powers.len() - 1];
        if powers.len() > 24 || last.iter().any(|x| !x.is_finite()) {
            return None;
        }
        powers.push(last * last);
    }
    // The largest power that is not small, one bit after the other.
    let mut done: Option<DMatrix<f64>> = None;
    let mut count = 0;
    for (bit, power) in powers.iter().enumerate().rev() {
        let next = done.as_ref().map_or_else(|| power.clone(), |done| done * power);
        if !small(&next) {
            done = Some(next);
            count += 1_usize << bit;
        }
    }
    Some(count + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::designed;

    const MOTOR: &str = include_str!("../../../specs/motor_intermittent.toml");

    /// Windows that are too long for eigenvalues: the iteration finds what they say of one that is not.
    #[test]
    fn the_iteration_agrees_with_the_eigenvalues() {
        for k in [20, 100] {
            let (_, design) = designed(&MOTOR.replace("k = 20", &format!("k = {k}"))).unwrap();
            let functional = design.estimator.downcast_ref::<Functional>().unwrap();
            let phi = &design.constants.iter().find(|c| c.letter == "Phi").unwrap().rows;
            let errors = Errors::new(functional, &phi[..1]);
            for gap in [2, 5, 10, 16, 18, 19] {
                let (exact, iterated) = (Lifted::exact(&errors, gap).unwrap(), Lifted::by_iteration(&errors, gap));
                // Two errors are not all of them, and 128 periods not enough for every pair of near eigenvalues.
                let near = |one: f64, other: f64| (one / other - 1.0).abs() < 0.1;
                let periods = |lifted: Lifted| crate::numbers::count(lifted.periods.unwrap());
                assert!(near(iterated.radius, exact.radius), "{k}, {gap}: {iterated:?}, {exact:?}");
                assert!(near(periods(iterated), periods(exact)), "{k}, {gap}: {iterated:?}, {exact:?}");
            }
        }
    }
}
