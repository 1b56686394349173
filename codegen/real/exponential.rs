//! The matrix exponential and the discretisations that follow from it.
//!
//! Balancing, scaling, a Taylor series in Paterson–Stockmeyer form, squaring. The working
//! precision covers the worst growth of the rounding errors, so that the error of the result is
//! below `2^-(p-2)` of its norm. Sums and products of exact zeros stay exact, so elements of the
//! exponential that vanish by the structure of the matrix (triangular, nilpotent, decoupled)
//! come out as exact zeros.

use std::fmt;

use super::balance::{balanced, unbalanced};
use super::matrix::Matrix;
use super::number::{Precision, Real, count};

/// The largest binary exponent of a norm that is accepted, after balancing.
const LARGEST_NORM_TOP: i64 = 12;

/// Guard bits of the holds, for the rounding of `a h` and the difference of the constant part
/// and the ramp.
const GUARD: usize = 40;

/// The largest ratio of the scale factors of balancing that is accepted, as a binary exponent.
const LARGEST_SPREAD: i64 = 1 << 12;

/// The exponential of a matrix whose norm stays above 4096 under diagonal scaling is refused:
/// a step that long against the fastest motion of a system is a mistake in the units or in the
/// step, and would take that many bits of working precision.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NormTooLarge;

impl fmt::Display for NormTooLarge {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("the step is more than 4096 times the fastest time constant")
    }
}

impl std::error::Error for NormTooLarge {}

/// The exponential of the square matrix `a`, with an error below `2^-(p-2)` relative to the norm
/// of the result, at the precision `p` of `a`.
///
/// # Errors
/// [`NormTooLarge`] if no diagonal scaling brings the 1-norm of `a` below 4096, or only one
/// whose factors are further than 2^4096 apart.
///
/// # Panics
/// If the matrix is not square.
pub fn exponential(a: &Matrix) -> Result<Matrix, NormTooLarge> {
    assert_eq!(a.rows(), a.cols(), "the exponential needs a square matrix");
    let (n, p) = (a.rows(), a.precision());
    let (b, shifts) = balanced(a);
    let norm = b.norm_1();
    let Some(top) = norm.top() else {
        return Ok(Matrix::identity(n, p));
    };
    if top > LARGEST_NORM_TOP {
        return Err(NormTooLarge);
    }
    // Terms shrink by 2^-reduction each; a deeper reduction costs squarings, a shallower one
    // terms.
    let reduction = 2 + i64::from(p.as_bits().ilog2()) / 2;
    let squarings = (top + reduction).max(0);
    // The squarings can lose exp(2 norm) against the result, and undoing the balancing the ratio
    // of the largest to the smallest scale factor.
    let growth = if top > 0 { 3 << top } else { 3 };
    let (highest, lowest) = (shifts.iter().max(), shifts.iter().min());
    let spread = highest.unwrap_or(&0).saturating_sub(*lowest.unwrap_or(&0));
    if spread > LARGEST_SPREAD {
        return Err(NormTooLarge);
    }
    let guard = growth + spread + 2 * squarings + 2 * i64::from(n.max(1).ilog2()) + 24;
    let working = p.plus(count(guard));
    let mut result = taylor(&b.with_precision(working).shifted(-squarings), reduction.max(-top));
    for _ in 0..squarings {
        result = &result * &result;
    }
    Ok(unbalanced(&result, &shifts).with_precision(p))
}

/// The Taylor series of the exponential of `x`, with `|x| <= 2^-reduction`, to its precision.
fn taylor(x: &Matrix, reduction: i64) -> Matrix {
    let (n, p) = (x.rows(), x.precision());
    let degree = degree(reduction, p);
    // Paterson–Stockmeyer: a polynomial in x^width with polynomials in x as coefficients.
    let width = degree.isqrt().max(1);
    let mut powers = vec![Matrix::identity(n, p), x.clone()];
    for k in 2..=width {
        powers.push(&powers[k - 1] * x);
    }
    let mut inverse_factorials = vec![Real::one(p)];
    for k in 1..=degree {
        let divisor = Real::from_i64(i64::try_from(k).expect("a small number"), p);
        inverse_factorials.push(&inverse_factorials[k - 1] / divisor);
    }
    let mut sum = Matrix::zeros(n, n, p);
    for block in (0..=degree / width).rev() {
        let mut coefficient = Matrix::zeros(n, n, p);
        for (k, power) in powers.iter().take(width).enumerate() {
            if let Some(factor) = inverse_factorials.get(block * width + k) {
                coefficient = &coefficient + &power.scale(factor);
            }
        }
        sum = &(&sum * &powers[width]) + &coefficient;
    }
    sum
}

/// The first degree whose next term `2^(-reduction k) / k!` is below the precision.
fn degree(reduction: i64, p: Precision) -> usize {
    let mut bits = 0;
    let mut k = 1_usize;
    while count(bits) < p.as_bits() + 4 {
        k += 1;
        bits += reduction + i64::from(k.ilog2());
    }
    k
}

/// The discrete system `x(h) = phi x(0) + gamma w` of `x' = a x + b w` with `w` constant over
/// the step: `phi = exp(a h)` is `n x n`, `gamma`, the integral of `exp(a s) b` over the step,
/// `n x m` like `b`. Both come from one exponential; `a` may be singular.
///
/// # Errors
/// [`NormTooLarge`] as in [`exponential`].
///
/// # Panics
/// If the shapes of `a` and `b` do not fit.
#[allow(clippy::many_single_char_names, reason = "the letters of the textbooks")]
pub fn zero_order_hold(a: &Matrix, b: &Matrix, h: &Real) -> Result<(Matrix, Matrix), NormTooLarge> {
    let (n, m) = (a.rows(), b.cols());
    let p = a.precision().max(b.precision()).max(h.precision());
    let h = h.with_precision(p.plus(GUARD));
    let mut block = Matrix::zeros(n + m, n + m, h.precision());
    block.set_block(0, 0, &a.scale(&h));
    block.set_block(0, n, &b.scale(&h));
    let result = exponential(&block)?.with_precision(p);
    Ok((result.block(0..n, 0..n), result.block(0..n, n..n + m)))
}

/// The discrete system `x(h) = phi x(0) + gamma0 w(0) + gamma1 w(h)` of `x' = a x + b w` with
/// `w` linear over the step; shapes as in [`zero_order_hold`]. `gamma0 + gamma1` is the `gamma`
/// of the zero-order hold.
///
/// # Errors
/// [`NormTooLarge`] as in [`exponential`].
///
/// # Panics
/// If the shapes of `a` and `b` do not fit.
#[allow(clippy::many_single_char_names, reason = "the letters of the textbooks")]
pub fn first_order_hold(a: &Matrix, b: &Matrix, h: &Real) -> Result<(Matrix, Matrix, Matrix), NormTooLarge> {
    let (n, m) = (a.rows(), b.cols());
    let p = a.precision().max(b.precision()).max(h.precision());
    let h = h.with_precision(p.plus(GUARD));
    let mut block = Matrix::zeros(n + 2 * m, n + 2 * m, h.precision());
    block.set_block(0, 0, &a.scale(&h));
    block.set_block(0, n, &b.scale(&h));
    block.set_block(n, n + m, &Matrix::identity(m, h.precision()));
    let result = exponential(&block)?;
    let step = result.block(0..n, n..n + m);
    let ramp = result.block(0..n, n + m..n + 2 * m);
    let gamma0 = (&step - &ramp).with_precision(p);
    Ok((result.block(0..n, 0..n).with_precision(p), gamma0, ramp.with_precision(p)))
}

/// What the polynomial through four samples of `w`, one step apart, does over one step of `x' = a x + b w`: the
/// factors of the samples, oldest first, shapes as `gamma` in [`zero_order_hold`]. The step goes from the sample at
/// place `start` (0, 1 or 2) to the next: with 2 the newest sample is the step's end, so that the hold is causal.
/// Their sum is the `gamma` of the zero-order hold.
///
/// # Errors
/// [`NormTooLarge`] as in [`exponential`].
///
/// # Panics
/// If the shapes of `a` and `b` do not fit, or there is no sample behind `start`.
#[allow(clippy::many_single_char_names, reason = "the letters of the textbooks")]
pub fn third_order_hold(a: &Matrix, b: &Matrix, h: &Real, start: usize) -> Result<[Matrix; 4], NormTooLarge> {
    assert!(start < 3, "the step lies between two of the four samples");
    let (n, m) = (a.rows(), b.cols());
    let p = a.precision().max(b.precision()).max(h.precision());
    let h = h.with_precision(p.plus(GUARD));
    let mut block = Matrix::zeros(n + 4 * m, n + 4 * m, h.precision());
    block.set_block(0, 0, &a.scale(&h));
    block.set_block(0, n, &b.scale(&h));
    for k in 0..3 {
        block.set_block(n + k * m, n + (k + 1) * m, &Matrix::identity(m, h.precision()));
    }
    let result = exponential(&block)?;
    // Column k is the response to (t / h)^k / k!.
    let powers: Vec<Matrix> = (0..4).map(|k| result.block(0..n, n + k * m..n + (k + 1) * m)).collect();
    let whole = |x: i64| Real::from_i64(x, h.precision());
    Ok(std::array::from_fn(|node| {
        // Lagrange's polynomial of this node over theta = t / h, by coefficients.
        let places: Vec<i64> = (0..4).filter(|j| *j != node).map(|j| offset(j, start)).collect();
        let own = offset(node, start);
        let scale: i64 = places.iter().map(|place| own - place).product();
        let [r, s, t] = [places[0], places[1], places[2]];
        let coefficients = [-r * s * t, r * s + r * t + s * t, -(r + s + t), 1];
        let factorials = [1, 1, 2, 6];
        let terms = powers.iter().zip(coefficients).zip(factorials);
        terms
            .map(|((power, c), factorial)| power.scale(&(whole(c * factorial) / whole(scale))))
            .fold(Matrix::zeros(n, m, h.precision()), |sum, term| &sum + &term)
            .with_precision(p)
    }))
}

/// Where a sample lies, in steps behind the beginning of the step.
#[allow(clippy::cast_possible_wrap, reason = "numbers below four")]
const fn offset(node: usize, start: usize) -> i64 {
    node as i64 - start as i64
}

#[cfg(test)]
#[allow(clippy::cast_possible_wrap, reason = "small numbers")]
mod tests {
    use super::super::matrix::tests::{arbitrary, distance, fractions};
    use super::*;

    #[test]
    fn a_rotation_generator_gives_the_rotation() {
        let p = Precision::bits(256);
        for w in [1, 10, 700] {
            let rotation = exponential(&fractions(&[[0, w], [-w, 0]], 7, p)).unwrap();
            let angle = Real::from_i64(w, p.plus(60)) / Real::from_i64(7, p);
            let (s, c) = (angle.checked_sin().unwrap(), angle.checked_cos().unwrap());
            let exact = Matrix::from_fn(2, 2, |i, j| match (i, j) {
                (0, 1) => s.clone(),
                (1, 0) => -&s,
                _ => c.clone(),
            });
            assert!(distance(&rotation, &exact) < -254.0);
        }
    }

    #[test]
    fn a_decaying_diagonal_keeps_its_small_elements_and_its_zeros() {
        let p = Precision::bits(200);
        let result = exponential(&fractions(&[[-100, 0], [0, 3]], 1, p)).unwrap();
        assert!(result[(0, 1)].is_zero() && result[(1, 0)].is_zero());
        for (i, rate) in [-100, 3].into_iter().enumerate() {
            let exact = Real::from_i64(rate, p).checked_exp().unwrap();
            let off = &result[(i, i)] - &exact;
            assert!(off.log2_abs() < exact.log2_abs() - 198.0);
        }
    }

    #[test]
    fn chains_of_integrators_are_exact_and_triangular_structure_survives() {
        let p = Precision::bits(128);
        let chain = Matrix::from_fn(5, 5, |i, j| Real::from_i64(i64::from(j == i + 1), p));
        let result = exponential(&chain.shifted(-3)).unwrap();
        let mut factorial = Real::one(p);
        for k in 0..5_usize {
            if k > 0 {
                factorial = factorial * Real::from_i64(k as i64, p);
            }
            let exact = Real::one(p).shifted(-3 * k as i64) / &factorial;
            for i in 0..5 - k {
                assert_eq!(result[(i, i + k)], exact);
            }
        }
        let mut lower = arbitrary(6, 6, p);
        for i in 0..6 {
            for j in i + 1..6 {
                lower[(i, j)] = Real::zero(p);
            }
        }
        let result = exponential(&lower.shifted(3)).unwrap();
        assert!((0..6).all(|i| (i + 1..6).all(|j| result[(i, j)].is_zero())));
        // Nilpotent without being triangular: A^2 = 0, so the exponential is I + A.
        let a = fractions(&[[1, -1], [1, -1]], 1, p);
        assert_eq!(exponential(&a).unwrap(), &Matrix::identity(2, p) + &a);
    }

    #[test]
    fn half_steps_compose_and_twice_the_precision_agrees() {
        let p = Precision::bits(160);
        for size in [0, 3, 6] {
            let a = arbitrary(7, 7, p).shifted(size);
            let whole = exponential(&a).unwrap();
            let fine = exponential(&a.with_precision(p.doubled())).unwrap();
            assert!(distance(&whole, &fine) < -158.0);
            let half = exponential(&a.with_precision(p.doubled()).shifted(-1)).unwrap();
            assert!(distance(&(&half * &half), &fine) < -320.0 + 3.0 * a.norm_1().to_f64());
        }
    }

    #[test]
    fn badly_scaled_units_cost_nothing_and_impossible_steps_are_refused() {
        let p = Precision::bits(200);
        // omega = 1e6: the norm is 1e12, the balanced one 1e6; h omega = 1.
        let a = fractions(&[[0, 1], [-1_000_000_000_000, 0]], 1_000_000, p);
        let cosine = exponential(&a).unwrap()[(0, 0)].clone();
        let off = &cosine - Real::one(p).checked_cos().unwrap();
        assert!(off.log2_abs() < -196.0);
        assert_eq!(exponential(&a.shifted(40)), Err(NormTooLarge));
    }

    #[test]
    fn holds_match_the_closed_forms_and_each_other() {
        let p = Precision::bits(180);
        let h = Real::from_i64(1, p) / Real::from_i64(10, p);
        // x' = -5 x + 2 w.
        let (a, b) = (fractions(&[[-5]], 1, p), fractions(&[[2]], 1, p));
        let (phi, gamma) = zero_order_hold(&a, &b, &h).unwrap();
        let decay = (-&h * Real::from_i64(5, p.plus(40))).checked_exp().unwrap();
        assert!((&phi[(0, 0)] - &decay).log2_abs() < -178.0);
        let exact = (Real::one(p) - &decay) * Real::from_i64(2, p) / Real::from_i64(5, p);
        assert!((&gamma[(0, 0)] - &exact).log2_abs() < -178.0);
        // A ramp of two singular states: gamma0 = h^2/3 and h/2, gamma1 = h^2/6 and h/2.
        let (a, b) = (fractions(&[[0, 1], [0, 0]], 1, p), fractions(&[[0], [1]], 1, p));
        let (_, gamma0, gamma1) = first_order_hold(&a, &b, &h).unwrap();
        let close = |x: &Real, y: Real| assert!((x - &y).log2_abs() < y.log2_abs() - 176.0);
        close(&gamma0[(0, 0)], &h * &h / Real::from_i64(3, p));
        close(&gamma1[(0, 0)], &h * &h / Real::from_i64(6, p));
        close(&gamma0[(1, 0)], h.shifted(-1));
        close(&gamma1[(1, 0)], h.shifted(-1));
    }

    #[test]
    fn the_third_order_hold_is_exact_for_cubics_wherever_the_step_lies() {
        let p = Precision::bits(200);
        let (a, b, h) = (arbitrary(4, 4, p).shifted(1), arbitrary(4, 1, p), Real::from_i64(1, p).shifted(-3));
        let (_, whole) = zero_order_hold(&a, &b, &h).unwrap();
        // x' = a x + b (t / h)^3 as an autonomous system.
        let mut block = Matrix::zeros(8, 8, p);
        block.set_block(0, 0, &a);
        block.set_block(0, 4, &b);
        for k in 0..3 {
            block[(4 + k, 5 + k)] = Real::from_i64(3 - k as i64, p) / &h;
        }
        let exact = exponential(&block.scale(&h)).unwrap().block(0..4, 7..8);
        for start in 0..3 {
            let factors = third_order_hold(&a, &b, &h, start).unwrap();
            let sum = factors.iter().fold(Matrix::zeros(4, 1, p), |sum, factor| &sum + factor);
            assert!(distance(&sum, &whole) < -190.0);
            let cubic = factors.iter().enumerate().fold(Matrix::zeros(4, 1, p), |sum, (node, factor)| {
                &sum + &factor.scale(&Real::from_i64(offset(node, start).pow(3), p))
            });
            assert!(distance(&cubic, &exact) < -188.0);
        }
    }

    #[test]
    fn tiny_steps_and_tiny_inputs_keep_their_relative_accuracy() {
        let p = Precision::bits(150);
        let (a, b) = (arbitrary(3, 3, p), arbitrary(3, 2, p));
        let faint = Matrix::from_fn(3, 2, |i, j| b[(i, j)].shifted(-200 * j as i64));
        let h = Real::one(p).shifted(-120);
        let (_, coarse) = zero_order_hold(&a, &faint, &h).unwrap();
        let (_, fine) = zero_order_hold(&a, &faint, &h.with_precision(p.plus(800))).unwrap();
        for j in 0..2 {
            assert!(distance(&coarse.column(j), &fine.column(j)) < -148.0);
        }
        // The far end of a chain: h^5 / 5!.
        let chain = Matrix::from_fn(6, 6, |i, j| Real::from_i64(i64::from(j == i + 1), p));
        let end = exponential(&chain.scale(&h)).unwrap()[(0, 5)].clone();
        let exact = Real::one(p).shifted(-600) / Real::from_i64(120, p);
        assert!((end - &exact).log2_abs() < exact.log2_abs() - 148.0);
    }

    #[test]
    fn holds_satisfy_their_identities_for_general_systems() {
        let p = Precision::bits(200);
        let (a, b, h) = (arbitrary(5, 5, p).shifted(2), arbitrary(5, 2, p), Real::from_i64(1, p).shifted(-2));
        let (phi, gamma) = zero_order_hold(&a, &b, &h).unwrap();
        assert!(distance(&(&a * &gamma), &(&(&phi - &Matrix::identity(5, p)) * &b)) < -194.0);
        let (same, gamma0, gamma1) = first_order_hold(&a, &b, &h).unwrap();
        assert!(distance(&same, &phi) < -196.0);
        assert!(distance(&(&gamma0 + &gamma1), &gamma) < -196.0);
        // Integration by parts of the response to the ramp t / h.
        let left = (&a * &gamma1).scale(&h);
        let right = &gamma - &b.scale(&h);
        assert!(distance(&left, &right) < -194.0);
    }
}
