//! LU factorisation with partial pivoting: linear systems, inverse, determinant.

use std::fmt;

use super::balance::{equilibrated_columns, pivot_threshold};
use super::matrix::Matrix;
use super::number::Real;

/// Guard bits of the factorisation.
const GUARD: usize = 32;

/// The matrix has no inverse, or none that could be told from rounding: with rows and columns
/// scaled to order one, elimination met a pivot below `64 n 2^-p`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Singular {
    /// The column, counted from zero, that depends on the ones before it.
    pub column: usize,
}

impl fmt::Display for Singular {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "column {} depends on the columns before it", self.column)
    }
}

impl std::error::Error for Singular {}

/// The rows eliminated, with what is needed to use them.
struct Factors {
    /// `[U | L^-1 P b]` by rows, for the scaled matrix.
    rows: Vec<Vec<Real>>,
    odd_permutation: bool,
}

/// Gaussian elimination of `[a | b]`, where pivots below `2^-threshold` count as zero.
fn eliminate(a: &Matrix, b: &Matrix, threshold: i64) -> Result<Factors, Singular> {
    let n = a.rows();
    let joined = a.hcat(b);
    let width = joined.cols();
    let mut rows: Vec<Vec<Real>> = (0..n).map(|i| (0..width).map(|j| joined[(i, j)].clone()).collect()).collect();
    let mut odd_permutation = false;
    for k in 0..n {
        let mut pivot = k;
        for i in k + 1..n {
            if rows[i][k].cmp_abs(&rows[pivot][k]).is_gt() {
                pivot = i;
            }
        }
        if rows[pivot][k].top().is_none_or(|top| top < -threshold) {
            return Err(Singular { column: k });
        }
        odd_permutation ^= pivot != k;
        rows.swap(k, pivot);
        let (upper, lower) = rows.split_at_mut(k + 1);
        let pivot_row = &upper[k];
        for row in lower {
            if row[k].is_zero() {
                continue;
            }
            let factor = -(&row[k] / &pivot_row[k]);
            row[k] = Real::zero(factor.precision());
            for j in k + 1..width {
                row[j] = factor.mul_add(&pivot_row[j], &row[j]);
            }
        }
    }
    Ok(Factors { rows, odd_permutation })
}

/// The rows and columns brought to order one by powers of two, with the exponents applied.
fn equilibrated(a: &Matrix) -> (Matrix, Vec<i64>, Vec<i64>) {
    let (by_rows, row_shifts) = equilibrated_columns(&a.transpose());
    let (scaled, column_shifts) = equilibrated_columns(&by_rows.transpose());
    (scaled, row_shifts, column_shifts)
}

/// The solution `x` of `a x = b`: `a` is `n x n`, `b` and `x` are `n x m`. Gaussian elimination
/// with partial pivoting after exact equilibration and with guard bits; the error is about the
/// condition number times `2^-(p+32)`, relative to the largest element, plus the final rounding.
///
/// # Errors
/// [`Singular`] if a pivot vanishes to precision `p`.
///
/// # Panics
/// If `a` is not square or `b` has another number of rows.
#[allow(clippy::many_single_char_names, reason = "the letters of the textbooks")]
pub fn solve(a: &Matrix, b: &Matrix) -> Result<Matrix, Singular> {
    assert_eq!(a.rows(), a.cols(), "solve needs a square matrix");
    assert_eq!(a.rows(), b.rows(), "as many right-hand rows as equations");
    let p = a.precision().max(b.precision());
    let (n, m) = (a.rows(), b.cols());
    let working = p.plus(GUARD);
    let (scaled, row_shifts, column_shifts) = equilibrated(&a.with_precision(working));
    let right = Matrix::from_fn(n, m, |i, j| b[(i, j)].shifted(row_shifts[i]));
    let factors = eliminate(&scaled, &right.with_precision(working), pivot_threshold(p, n))?;
    let mut x = Matrix::zeros(n, m, working);
    for i in (0..n).rev() {
        let row = &factors.rows[i];
        for j in 0..m {
            let known = Real::sum_of_products((i + 1..n).map(|k| (&row[k], &x[(k, j)])), working);
            x[(i, j)] = (&row[n + j] - known) / &row[i];
        }
    }
    let unscaled = Matrix::from_fn(n, m, |i, j| x[(i, j)].shifted(column_shifts[i]));
    Ok(unscaled.with_precision(p))
}

/// The inverse of a square matrix, with the accuracy of [`solve`].
///
/// # Errors
/// [`Singular`] if a pivot vanishes to the precision of `a`.
///
/// # Panics
/// If the matrix is not square.
pub fn inverse(a: &Matrix) -> Result<Matrix, Singular> {
    solve(a, &Matrix::identity(a.rows(), a.precision()))
}

/// The determinant of a square matrix, by elimination with guard bits. Zero if elimination
/// meets a pivot that is zero to the precision of `a`.
///
/// # Panics
/// If the matrix is not square.
#[must_use]
pub fn determinant(a: &Matrix) -> Real {
    assert_eq!(a.rows(), a.cols(), "the determinant needs a square matrix");
    let p = a.precision();
    let working = p.plus(GUARD);
    let (scaled, row_shifts, column_shifts) = equilibrated(&a.with_precision(working));
    let threshold = pivot_threshold(p, a.rows());
    let Ok(factors) = eliminate(&scaled, &Matrix::zeros(a.rows(), 0, working), threshold) else {
        return Real::zero(p);
    };
    let diagonal = factors.rows.iter().enumerate().map(|(i, row)| &row[i]);
    let product = diagonal.fold(Real::one(working), |product, pivot| &product * pivot);
    let product = if factors.odd_permutation { -product } else { product };
    let shift: i64 = row_shifts.iter().chain(&column_shifts).sum();
    product.shifted(-shift).into_precision(p)
}

#[cfg(test)]
#[allow(clippy::cast_possible_wrap, reason = "small numbers")]
mod tests {
    use super::super::matrix::tests::{arbitrary, distance, fractions};
    use super::super::number::Precision;
    use super::*;

    #[test]
    fn solutions_satisfy_their_equations_even_in_awkward_units() {
        let p = Precision::bits(150);
        let a = arbitrary(8, 8, p);
        let awkward = Matrix::from_fn(8, 8, |i, j| a[(i, j)].shifted(40 * i as i64 - 70 * j as i64));
        let x = arbitrary(8, 2, p);
        assert!(distance(&solve(&a, &(&a * &x)).unwrap(), &x) < -140.0);
        let found = inverse(&awkward).unwrap();
        let undone = Matrix::from_fn(8, 8, |i, j| found[(i, j)].shifted(40 * j as i64 - 70 * i as i64));
        assert!(distance(&undone, &inverse(&a).unwrap()) < -140.0);
        assert!(distance(&(&undone * &a), &Matrix::identity(8, p)) < -140.0);
    }

    #[test]
    fn singular_matrices_are_recognised_exactly_and_up_to_rounding() {
        let p = Precision::bits(100);
        let a = fractions(&[[1, 2, 3], [4, 5, 6], [7, 8, 9]], 1, p);
        assert_eq!(inverse(&a), Err(Singular { column: 2 }));
        let thirds = fractions(&[[1, 2, 3], [4, 5, 6], [7, 8, 9]], 3, p);
        assert_eq!(inverse(&thirds), Err(Singular { column: 2 }));
        assert_eq!(inverse(&Matrix::zeros(2, 2, p)), Err(Singular { column: 0 }));
        assert!(determinant(&a).is_zero());
        assert_eq!(inverse(&Matrix::zeros(0, 0, p)), Ok(Matrix::zeros(0, 0, p)));
    }

    #[test]
    fn determinants_of_integers_are_right() {
        let p = Precision::bits(100);
        let a = fractions(&[[0, 2, 1], [3, 0, -1], [2, 5, 4]], 1, p);
        assert_eq!(determinant(&a).to_f64().round().to_bits(), (-13.0_f64).to_bits());
        assert!((determinant(&a) + Real::from_i64(13, p)).log2_abs() < -95.0);
    }
}
