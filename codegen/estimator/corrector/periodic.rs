//! The Kalman filter of outputs at several rates: a gain for every call of a cycle.
//!
//! An output with `every = g` is measured at calls 0, g, 2 g, …; a cycle has as many calls as the least common multiple of
//! all g.
//! What the calls of a cycle do to the prediction's covariance is put together (`doubling`), so that a
//! cycle's fixed point is that of a steady filter. Phi need not be invertible.

use super::doubling::Map;
use super::riccati::{Failure, GUARD, Noise, Way, check, closed_loop, contracts, gain, told_apart};
use crate::real::{Matrix, Real, solve};

/// The filter after all transients.
#[derive(Clone, Debug)]
pub struct Periodic {
    /// K of the calls of a cycle, n x p; the columns of outputs that are not due are zero.
    pub gains: Vec<Matrix>,
    /// The covariance of the estimate of each, n x n.
    pub updated: Vec<Matrix>,
    /// Largest entry of what a cycle leaves of its own equation, relative to the largest entry of P.
    pub residual: f64,
}

/// Calls of a cycle: the least common multiple; `None` beyond any that is designed.
pub fn cycle(every: &[usize], most: usize) -> Option<usize> {
    every.iter().try_fold(1_usize, |all, one| {
        let together = all / common(all, *one) * one;
        (together <= most).then_some(together)
    })
}

fn common(a: usize, b: usize) -> usize {
    if b == 0 { a } else { common(b, a % b) }
}

/// The filter of a plant, Phi n x n and C p x n, whose outputs are due at every so many calls; `calls` is their cycle.
///
/// # Errors
/// [`Failure`].
pub fn periodic(phi: &Matrix, c: &Matrix, noise: &Noise, every: &[usize], calls: usize) -> Result<Periodic, Failure> {
    check(noise)?;
    let due = |call: usize| -> Vec<usize> { (0..every.len()).filter(|o| call.is_multiple_of(every[*o])).collect() };
    let due: Vec<Vec<usize>> = (0..calls).map(due).collect();
    told_apart(noise, |noise, way| solution(phi, c, noise, &due, way))
}

/// The stabilising solution, if there is one; `due` has the outputs of each call.
fn solution(
    phi: &Matrix,
    c: &Matrix,
    noise: &Noise,
    due: &[Vec<usize>],
    way: Way,
) -> Result<Option<Periodic>, Failure> {
    let p = phi.precision();
    let Some(start) = fixed_point(phi, c, noise, due, way) else { return Ok(None) };
    let (n, outputs) = (phi.rows(), c.rows());
    let mut found = Periodic { gains: Vec::new(), updated: Vec::new(), residual: 0.0 };
    let mut around = Matrix::identity(n, p);
    let mut predicted = start.clone();
    for due in due {
        let (part, part_noise) = only(c, noise, due);
        let small = if due.is_empty() { Matrix::zeros(n, 0, p) } else { gain(&part, &predicted, &part_noise)? };
        let whole = Matrix::from_fn(n, outputs, |i, o| match due.iter().position(|it| *it == o) {
            Some(place) => small[(i, place)].clone(),
            None => Real::zero(p),
        });
        around = &closed_loop(phi, c, &whole) * &around;
        let updated = &predicted - &(&whole * &(c * &predicted));
        let updated = (&updated + &updated.transpose()).shifted(-1);
        predicted = &(&(phi * &updated) * &phi.transpose()) + &noise.process;
        found.gains.push(whole);
        found.updated.push(updated);
    }
    if !contracts(&around) {
        return Ok(None);
    }
    let left = (&predicted - &start).max_abs().checked_div(&start.max_abs());
    found.residual = left.map_or(0.0, |left| left.to_f64());
    Ok(Some(found))
}

/// The prediction's covariance at the cycle's first call.
fn fixed_point(phi: &Matrix, c: &Matrix, noise: &Noise, due: &[Vec<usize>], way: Way) -> Option<Matrix> {
    let p = phi.precision();
    let working = p.plus(GUARD);
    let wide = |m: &Matrix| m.with_precision(working);
    let (phi, c, q) = (wide(phi), wide(c), wide(&noise.process));
    let noise = Noise { process: q.clone(), measurement: wide(&noise.measurement) };
    let mut cycle: Option<Map> = None;
    for due in due {
        let (part, part_noise) = only(&c, &noise, due);
        let n = phi.rows();
        let information = if due.is_empty() {
            Matrix::zeros(n, n, working)
        } else {
            &part.transpose() * &solve(&part_noise.measurement, &part).ok()?
        };
        let call = Map { a: phi.clone(), g: information, h: q.clone() };
        cycle = Some(match cycle {
            Some(before) => before.then(&call)?,
            None => call,
        });
    }
    way.fixed_point(&cycle?).map(|solution| solution.with_precision(p))
}

/// The rows of C, and the noise, of some outputs.
fn only(c: &Matrix, noise: &Noise, due: &[usize]) -> (Matrix, Noise) {
    let part = Matrix::from_fn(due.len(), c.cols(), |i, j| c[(due[i], j)].clone());
    let measurement = Matrix::from_fn(due.len(), due.len(), |i, j| noise.measurement[(due[i], due[j])].clone());
    (part, Noise { process: noise.process.clone(), measurement })
}

#[cfg(test)]
mod tests {
    use super::super::noise::{Definiteness, definiteness};
    use super::super::riccati::steady;
    use super::*;
    use crate::real::Precision;

    fn entries(seed: u64) -> impl FnMut(usize, usize) -> Real {
        let mut state = seed;
        move |_, _| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(99);
            Real::from_i64((state >> 33).cast_signed() - (1 << 30), Precision::bits(256)).shifted(-30)
        }
    }

    /// At one rate it is the steady filter; at several the recursion over a cycle comes back to where it began, and every
    /// covariance is one. Phi may be singular.
    #[test]
    fn a_cycle_is_a_fixed_point_of_the_recursion() {
        for (n, every, singular) in
            [(2, vec![1, 1], false), (3, vec![1, 4], false), (4, vec![2, 3], false), (3, vec![5], true)]
        {
            let mut next = entries(7 + u64::try_from(n).unwrap());
            let mut phi = Matrix::from_fn(n, n, &mut next).shifted(1);
            if singular {
                let zero = Matrix::zeros(n, 1, phi.precision());
                phi.set_block(0, 0, &zero);
            }
            let c = Matrix::from_fn(every.len(), n, &mut next);
            let factor = Matrix::from_fn(n, n, &mut next);
            let measurement = Matrix::identity(every.len(), Precision::bits(256)).shifted(-6);
            let noise = Noise { process: &factor * &factor.transpose(), measurement };
            let calls = cycle(&every, 100).unwrap();
            let found = periodic(&phi, &c, &noise, &every, calls).unwrap();
            assert_eq!(found.gains.len(), calls);
            assert!(found.residual < 1e-60, "{every:?}: {:e}", found.residual);
            assert!(found.updated.iter().all(|p| definiteness(p) == Definiteness::Definite), "{every:?}");
            if calls == 1 {
                let steady = steady(&phi, &c, &noise).unwrap();
                let off = (&steady.gain - &found.gains[0]).max_abs().log2_abs();
                assert!(off < steady.gain.max_abs().log2_abs() - 200.0);
            }
        }
    }
}
