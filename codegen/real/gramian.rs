//! The observability Gramian over a finite horizon.

use super::exponential::{NormTooLarge, exponential};
use super::matrix::Matrix;
use super::number::{Precision, Real, count};

/// The integral over `r` from `-tau` to `0` of `exp(a' r) c' c exp(a r)`: how well the outputs
/// `y = c x` of the last `tau` determine the state now. `a` is `n x n`, `c` is `q x n`, the
/// result `n x n`, symmetric to the last bit.
///
/// Van Loan's block exponential: with `m = [[a', c'c], [0, -a]]`, `exp(m tau) = [[., g], [0, f]]`
/// and the Gramian is `f' g`. Forgetting one of the factors can cancel all the growth of the
/// other; three bits per unit of `norm(a) tau` on top of the precision cover that, for an error
/// of about `2^-p` relative to the norm of the result.
///
/// # Errors
/// [`NormTooLarge`] as in [`exponential`].
///
/// # Panics
/// If the shapes do not fit.
pub fn gramian(a: &Matrix, c: &Matrix, tau: &Real) -> Result<Matrix, NormTooLarge> {
    let n = a.rows();
    assert_eq!((a.cols(), c.cols()), (n, n), "a square matrix and as many output columns");
    // The result is linear in tau c'c: it enters the exponential at order one.
    let magnitude = c.max_abs().top().unwrap_or(0);
    integral(a, c.precision(), tau, 2 * magnitude, |working| {
        let c = c.with_precision(working).shifted(-magnitude);
        &c.transpose() * &c
    })
}

/// [`gramian`] with the symmetric `weight`, `n x n`, in place of `c'c`.
///
/// # Errors
/// [`NormTooLarge`] as in [`exponential`].
///
/// # Panics
/// If the shapes do not fit.
pub fn weighted_gramian(a: &Matrix, weight: &Matrix, tau: &Real) -> Result<Matrix, NormTooLarge> {
    let n = a.rows();
    assert_eq!((a.cols(), weight.rows(), weight.cols()), (n, n, n), "two square matrices of one size");
    let magnitude = weight.max_abs().top().unwrap_or(0);
    integral(a, weight.precision(), tau, magnitude, |working| weight.with_precision(working).shifted(-magnitude))
}

/// The integral of `exp(a' r) weight exp(a r)` from `-tau` to 0 times `2^magnitude`; `weight` at the precision it is
/// asked for.
fn integral(
    a: &Matrix,
    precision: Precision,
    tau: &Real,
    magnitude: i64,
    weight: impl Fn(Precision) -> Matrix,
) -> Result<Matrix, NormTooLarge> {
    let n = a.rows();
    let p = a.precision().max(precision).max(tau.precision());
    let (balanced, _) = super::balance::balanced(&a.scale(tau));
    let growth = match balanced.norm_1().top() {
        Some(top) if top > 12 => return Err(NormTooLarge),
        Some(top) if top > 0 => 3 << top,
        _ => 3,
    };
    let working = p.plus(count(growth) + 40);
    let a = a.with_precision(working);
    let mut block = Matrix::zeros(2 * n, 2 * n, working);
    block.set_block(0, 0, &a.transpose().scale(tau));
    block.set_block(0, n, &weight(working));
    block.set_block(n, n, &-&a.scale(tau));
    let result = exponential(&block)?;
    let backward = result.block(n..2 * n, n..2 * n);
    let gramian = &backward.transpose() * &result.block(0..n, n..2 * n);
    let symmetric = (&gramian + &gramian.transpose()).scale(tau).shifted(magnitude - 1);
    Ok(symmetric.with_precision(p))
}

#[cfg(test)]
mod tests {
    use super::super::matrix::tests::{arbitrary, distance, fractions};
    use super::*;

    /// `A'G + GA = C'C - exp(-A' tau) C'C exp(-A tau)`, evaluated at high precision.
    fn identity_error(a: &Matrix, c: &Matrix, tau: &Real) -> f64 {
        let gramian = gramian(a, c, tau).unwrap();
        assert_eq!(gramian, gramian.transpose());
        let wide = a.precision().plus(400);
        let (a, c) = (a.with_precision(wide), c.with_precision(wide));
        let backward = &c * &exponential(&-&a.scale(tau)).unwrap();
        let left = &(&a.transpose() * &gramian) + &(&gramian * &a);
        let right = &(&c.transpose() * &c) - &(&backward.transpose() * &backward);
        distance(&left, &right)
    }

    #[test]
    fn the_lyapunov_identity_holds_for_short_and_long_horizons() {
        let p = Precision::bits(150);
        let (a, c) = (arbitrary(4, 4, p), arbitrary(1, 4, p));
        for k in [-6, 0, 4] {
            assert!(identity_error(&a, &c, &Real::one(p).shifted(k)) < -140.0);
        }
        // Stable and unstable motions at once.
        let a = fractions(&[[-4, 1, 0], [0, -1, 2], [0, 0, 3]], 1, p);
        let c = fractions(&[[1, 1, 1], [0, 2, 0]], 1, p);
        assert!(identity_error(&a, &c, &Real::from_i64(5, p)) < -140.0);
    }

    #[test]
    fn short_horizons_and_faint_outputs_keep_their_relative_accuracy() {
        let p = Precision::bits(150);
        let (a, c) = (arbitrary(3, 3, p), arbitrary(1, 3, p).shifted(-900));
        let tau = Real::one(p).shifted(-100);
        let coarse = gramian(&a, &c, &tau).unwrap();
        let fine = gramian(&a, &c, &tau.with_precision(p.plus(500))).unwrap();
        assert!(distance(&coarse, &fine) < -148.0);
    }

    #[test]
    fn a_double_integrator_has_its_polynomial_gramian() {
        let p = Precision::bits(120);
        let (a, c) = (fractions(&[[0, 1], [0, 0]], 1, p), fractions(&[[1, 0]], 1, p));
        let found = gramian(&a, &c, &Real::from_i64(6, p)).unwrap();
        // [[tau, -tau^2/2], [., tau^3/3]]
        let exact = fractions(&[[6, -18], [-18, 72]], 1, p);
        assert!(distance(&found, &exact) < -118.0);
    }

    #[test]
    fn a_decaying_state_grows_exponentially_into_the_past() {
        let p = Precision::bits(120);
        for rate in [1, 60] {
            let found = gramian(&fractions(&[[-rate]], 1, p), &Matrix::identity(1, p), &Real::one(p));
            let rate = Real::from_i64(2 * rate, p.plus(60));
            let exact = (rate.checked_exp().unwrap() - Real::one(p)) / &rate;
            assert!((found.unwrap()[(0, 0)].clone() - &exact).log2_abs() < exact.log2_abs() - 118.0);
        }
    }
}
