//! Noise as a covariance: what a spectral density is over a sample, and what is none.

use crate::real::{Matrix, NormTooLarge, Real, weighted_gramian};

/// The covariance, n x n, by which one sample interval of `x' = a x + w` spreads the state, for white noise `w` of
/// the spectral density `density` (n x n, units squared times s): the integral of `exp(a s) density exp(a' s)` over
/// the interval of `h` seconds. Method: Van Loan 1978, "Computing integrals involving the matrix exponential".
///
/// # Errors
/// [`NormTooLarge`] for a plant too fast for the sample time.
pub fn over_a_sample(a: &Matrix, density: &Matrix, h: &Real) -> Result<Matrix, NormTooLarge> {
    weighted_gramian(&-&a.transpose(), density, h)
}

/// What a symmetric matrix is as a covariance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Definiteness {
    /// Everything varies.
    Definite,
    /// Something does not vary, nothing has a negative variance.
    Semidefinite,
    /// Some combination has a negative variance.
    Indefinite,
}

/// What a symmetric matrix is as a covariance: elimination with the largest remaining variance as pivot, after each
/// variable was scaled to a variance of order one; below `2^-(p/2)` nothing remains.
pub fn definiteness(matrix: &Matrix) -> Definiteness {
    let n = matrix.rows();
    if (0..n).any(|i| matrix[(i, i)].is_negative()) {
        return Definiteness::Indefinite;
    }
    // Half the exponent of the variance; a variable without one is left, to be seen by what it shares with others.
    let half: Vec<i64> = (0..n).map(|i| matrix[(i, i)].top().unwrap_or(0).div_euclid(2)).collect();
    let mut rest = Matrix::from_fn(n, n, |i, j| matrix[(i, j)].shifted(-half[i] - half[j]));
    let nothing = Real::one(matrix.precision()).shifted(-i64::try_from(matrix.precision().as_bits() / 2).unwrap_or(0));
    let mut left: Vec<usize> = (0..n).collect();
    while let Some(place) = (0..left.len()).max_by(|a, b| {
        let (a, b) = (left[*a], left[*b]);
        rest[(a, a)].cmp(&rest[(b, b)])
    }) {
        let k = left[place];
        if rest[(k, k)] <= nothing {
            let remains = |i: usize, j: usize| rest[(i, j)].abs() > nothing;
            let some = left.iter().any(|i| left.iter().any(|j| remains(*i, *j)));
            return if some { Definiteness::Indefinite } else { Definiteness::Semidefinite };
        }
        left.swap_remove(place);
        for i in &left {
            let factor = -(&rest[(*i, k)] / &rest[(k, k)]);
            for j in &left {
                rest[(*i, *j)] = factor.mul_add(&rest[(k, *j)], &rest[(*i, *j)]);
            }
        }
    }
    Definiteness::Definite
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Precision;

    fn matrix<const N: usize>(rows: [[i64; N]; N], p: Precision) -> Matrix {
        Matrix::from_fn(N, N, |i, j| Real::from_i64(rows[i][j], p))
    }

    /// The double integrator's covariance is q [[h^3/3, h^2/2], [h^2/2, h]] (Bar-Shalom 2001, 6.2.2).
    #[test]
    fn white_acceleration_has_its_polynomial_covariance() {
        let p = Precision::bits(200);
        let found = over_a_sample(&matrix([[0, 1], [0, 0]], p), &matrix([[0, 0], [0, 5]], p), &Real::from_i64(6, p));
        let exact = matrix([[360, 90], [90, 30]], p);
        assert!((&found.unwrap() - &exact).max_abs().log2_abs() < -190.0);
    }

    /// A lag's variance is q (1 - exp(-2 a h)) / (2 a).
    #[test]
    fn a_lag_forgets_its_noise() {
        let p = Precision::bits(200);
        let found = over_a_sample(&matrix([[-3]], p), &matrix([[2]], p), &Real::from_i64(4, p)).unwrap();
        let exact = (Real::one(p) - Real::from_i64(-24, p).checked_exp().unwrap()) / Real::from_i64(3, p);
        assert!((&found[(0, 0)] - &exact).log2_abs() < -190.0);
    }

    #[test]
    fn covariances_are_told_from_what_is_none() {
        let p = Precision::bits(128);
        assert_eq!(definiteness(&matrix([[2, 1], [1, 2]], p)), Definiteness::Definite);
        assert_eq!(definiteness(&matrix([[4, 2], [2, 1]], p)), Definiteness::Semidefinite);
        assert_eq!(definiteness(&matrix([[0, 0], [0, 1]], p)), Definiteness::Semidefinite);
        assert_eq!(definiteness(&matrix([[1, 2], [2, 1]], p)), Definiteness::Indefinite);
        assert_eq!(definiteness(&matrix([[0, 1], [1, 0]], p)), Definiteness::Indefinite);
        assert_eq!(definiteness(&matrix([[1, 0], [0, -1]], p)), Definiteness::Indefinite);
        // The same whatever the units of its variables.
        let units = |m: &Matrix| Matrix::from_fn(2, 2, |i, j| m[(i, j)].shifted(if i + j == 0 { -300 } else { 0 }));
        assert_eq!(definiteness(&units(&matrix([[2, 0], [0, 2]], p))), Definiteness::Definite);
        assert_eq!(definiteness(&Matrix::zeros(2, 2, p)), Definiteness::Semidefinite);
    }
}
