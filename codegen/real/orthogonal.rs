//! Householder QR: least squares and the pseudo-inverse of tall matrices.
//!
//! Columns are first scaled by powers of two, so states in unsuitable units do no harm; normal
//! equations are never formed, so the condition number enters once.

use std::fmt;

use super::balance::{equilibrated_columns, pivot_threshold};
use super::matrix::Matrix;
use super::number::{Precision, Real};

pub use super::singular::{Rank, condition, rank, singular_values};

/// Guard bits of the factorisation.
const GUARD: usize = 32;

/// The columns depend on each other, or cannot be told from doing so: with columns scaled to order
/// one, a diagonal element of `R` is below `64 n 2^-p` for `n` rows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RankDeficient {
    /// The column, counted from zero, that depends on the ones before it.
    pub column: usize,
}

impl fmt::Display for RankDeficient {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "column {} depends on the columns before it", self.column)
    }
}

impl std::error::Error for RankDeficient {}

/// A QR factorisation by Householder reflections, stored by columns.
pub(super) struct Factors {
    /// The reflection vectors: `reflections[k]` acts on the rows from `k` on. Empty if the
    /// column was already zero there.
    reflections: Vec<Vec<Real>>,
    /// `2 / v'v` of each reflection.
    weights: Vec<Real>,
    /// The columns of `R`: `upper[j]` holds rows `0..=j`.
    pub(super) upper: Vec<Vec<Real>>,
    precision: Precision,
}

/// The sum of the products of two columns.
fn dot(a: &[Real], b: &[Real], p: Precision) -> Real {
    Real::sum_of_products(a.iter().zip(b), p)
}

/// The columns of a matrix.
pub(super) fn columns(a: &Matrix) -> Vec<Vec<Real>> {
    (0..a.cols()).map(|j| (0..a.rows()).map(|i| a[(i, j)].clone()).collect()).collect()
}

impl Factors {
    /// Factors a matrix with at least as many rows as columns, at its precision.
    pub(super) fn of(a: &Matrix) -> Self {
        let precision = a.precision();
        let mut factors = Self { reflections: Vec::new(), weights: Vec::new(), upper: Vec::new(), precision };
        for (k, mut column) in columns(a).into_iter().enumerate() {
            factors.reflect(&mut column);
            let mut vector = column.split_off(k);
            let square = dot(&vector, &vector, precision);
            let norm = square.checked_sqrt().expect("a sum of squares is not negative");
            if norm.is_zero() {
                vector.clear();
                column.push(norm);
                factors.weights.push(Real::zero(precision));
            } else {
                // The sign that adds magnitudes; then v'v = 2 norm (norm + |x0|).
                let negative = vector[0].is_negative();
                let reach = &norm + vector[0].abs();
                factors.weights.push(Real::one(precision) / (&norm * &reach));
                vector[0] = if negative { -reach } else { reach };
                column.push(if negative { norm } else { -norm });
            }
            factors.upper.push(column);
            factors.reflections.push(vector);
        }
        factors
    }

    /// Applies reflection `k` to a full-length column.
    fn reflect_once(&self, k: usize, column: &mut [Real]) {
        let vector = &self.reflections[k];
        if vector.is_empty() {
            return;
        }
        let factor = -(dot(vector, &column[k..], self.precision) * &self.weights[k]);
        for (x, v) in column[k..].iter_mut().zip(vector) {
            *x = factor.mul_add(v, x);
        }
    }

    /// Applies all reflections so far: `Q' column`.
    fn reflect(&self, column: &mut [Real]) {
        (0..self.reflections.len()).for_each(|k| self.reflect_once(k, column));
    }

    /// Applies them in the opposite order: `Q column`.
    fn reflect_back(&self, column: &mut [Real]) {
        (0..self.reflections.len()).rev().for_each(|k| self.reflect_once(k, column));
    }

    /// Refuses diagonal elements of `R` below `2^-threshold`.
    fn full_rank(&self, threshold: i64) -> Result<(), RankDeficient> {
        let small = |j: usize| self.upper[j][j].top().is_none_or(|top| top < -threshold);
        (0..self.upper.len()).find(|&j| small(j)).map_or(Ok(()), |column| Err(RankDeficient { column }))
    }

    /// Solves `R x = y` in place, for the leading elements of `y`.
    fn back_substitute(&self, y: &mut Vec<Real>) {
        y.truncate(self.upper.len());
        for j in (0..self.upper.len()).rev() {
            y[j] = &y[j] / &self.upper[j][j];
            let factor = -&y[j];
            for (known, r) in y.iter_mut().zip(&self.upper[j]).take(j) {
                *known = factor.mul_add(r, known);
            }
        }
    }
}

/// Scales, factors at `working` precision and checks the rank to precision `p`.
fn factored(a: &Matrix, p: Precision, working: Precision) -> Result<(Factors, Vec<i64>), RankDeficient> {
    assert!(a.rows() >= a.cols(), "at least as many rows as columns");
    let (scaled, shifts) = equilibrated_columns(&a.with_precision(working));
    let factors = Factors::of(&scaled);
    factors.full_rank(pivot_threshold(p, a.rows()))?;
    Ok((factors, shifts))
}

/// The `x` that minimises the Euclidean norm of `a x - b`, column by column: `a` is `n x k` with
/// `n >= k` and full column rank, `b` is `n x m`, `x` is `k x m`. The error is about the
/// condition number of the equilibrated `a` (its square for large residuals) times `2^-(p+32)`,
/// plus the final rounding.
///
/// # Errors
/// [`RankDeficient`] if a column depends on those before it to precision `p`.
///
/// # Panics
/// If there are more columns than rows, or `b` has another number of rows.
pub fn least_squares(a: &Matrix, b: &Matrix) -> Result<Matrix, RankDeficient> {
    assert_eq!(a.rows(), b.rows(), "as many right-hand rows as equations");
    let p = a.precision().max(b.precision());
    let working = p.plus(GUARD);
    let (factors, shifts) = factored(a, p, working)?;
    let mut solutions = columns(&b.with_precision(working));
    for column in &mut solutions {
        factors.reflect(column);
        factors.back_substitute(column);
    }
    let x = Matrix::from_fn(a.cols(), b.cols(), |i, j| solutions[j][i].shifted(shifts[i]));
    Ok(x.with_precision(p))
}

/// `(Q, R^-1)` with `a = Q R`: Q is `n x k` with orthonormal columns, R `k x k` upper triangular, for a
/// matrix of full column rank, `n >= k`. Accuracy as that of [`pseudo_inverse`].
///
/// # Errors
/// [`RankDeficient`] if a column depends on those before it to the precision of `a`.
///
/// # Panics
/// If there are more columns than rows.
pub fn orthonormal(a: &Matrix) -> Result<(Matrix, Matrix), RankDeficient> {
    let p = a.precision();
    let working = p.plus(GUARD);
    let (n, k) = (a.rows(), a.cols());
    let (factors, shifts) = factored(a, p, working)?;
    let unit = |j: usize, len: usize| -> Vec<Real> {
        (0..len).map(|i| if i == j { Real::one(working) } else { Real::zero(working) }).collect()
    };
    let (mut basis, mut inverse) = (Vec::with_capacity(k), Vec::with_capacity(k));
    for j in 0..k {
        let mut column = unit(j, n);
        factors.reflect_back(&mut column);
        basis.push(column);
        let mut column = unit(j, k);
        factors.back_substitute(&mut column);
        inverse.push(column);
    }
    let basis = Matrix::from_fn(n, k, |i, j| basis[j][i].clone());
    let inverse = Matrix::from_fn(k, k, |i, j| inverse[j][i].shifted(shifts[i]));
    Ok((basis.with_precision(p), inverse.with_precision(p)))
}

/// The pseudo-inverse of an `n x k` matrix of full column rank, `n >= k`: the `k x n` matrix
/// `R^-1 Q'`. The error is about the condition number of the equilibrated matrix times
/// `2^-(p+32)`, plus the final rounding.
///
/// # Errors
/// [`RankDeficient`] if a column depends on those before it to the precision of `a`.
///
/// # Panics
/// If there are more columns than rows.
pub fn pseudo_inverse(a: &Matrix) -> Result<Matrix, RankDeficient> {
    let p = a.precision();
    let working = p.plus(GUARD);
    let (n, k) = (a.rows(), a.cols());
    let (factors, shifts) = factored(a, p, working)?;
    // Row i of R^-1 Q' is Q times the padded column i of R^-T: k columns to reflect, not n.
    let mut inverse = Vec::with_capacity(k);
    for j in 0..k {
        let mut unit = vec![Real::zero(working); k];
        unit[j] = Real::one(working);
        factors.back_substitute(&mut unit);
        inverse.push(unit);
    }
    let mut rows = Vec::with_capacity(k);
    for i in 0..k {
        let mut row: Vec<Real> = inverse.iter().map(|column| column[i].clone()).collect();
        row.resize(n, Real::zero(working));
        factors.reflect_back(&mut row);
        rows.push(row);
    }
    let pseudo_inverse = Matrix::from_fn(k, n, |i, j| rows[i][j].shifted(shifts[i]));
    Ok(pseudo_inverse.with_precision(p))
}

#[cfg(test)]
mod tests {
    use super::super::matrix::tests::{arbitrary, distance, fractions};
    use super::*;

    #[test]
    fn an_orthonormal_basis_times_its_factor_is_the_matrix() {
        let p = Precision::bits(150);
        let a = arbitrary(9, 4, p);
        let awkward = Matrix::from_fn(9, 4, |i, j| a[(i, j)].shifted([-40, -10, 20, 50][j]));
        let (basis, inverse) = orthonormal(&awkward).unwrap();
        assert!(distance(&(&basis.transpose() * &basis), &Matrix::identity(4, p)) < -140.0);
        assert!(distance(&(&awkward * &inverse), &basis) < -140.0);
        assert_eq!(orthonormal(&a.hcat(&a)).unwrap_err().column, 4);
    }

    #[test]
    fn the_pseudo_inverse_satisfies_moore_and_penrose() {
        let p = Precision::bits(160);
        let a = arbitrary(11, 4, p);
        let inverse = pseudo_inverse(&a).unwrap();
        assert!(distance(&(&inverse * &a), &Matrix::identity(4, p)) < -150.0);
        let projection = &a * &inverse;
        assert!(distance(&projection.transpose(), &projection) < -150.0);
        assert!(distance(&(&projection * &a), &a) < -150.0);
        assert!(distance(&(&inverse * &projection), &inverse) < -150.0);
    }

    #[test]
    fn badly_scaled_columns_lose_nothing() {
        let p = Precision::bits(100);
        let a = arbitrary(9, 3, p);
        let shifts = [-300, 0, 500];
        let awkward = Matrix::from_fn(9, 3, |i, j| a[(i, j)].shifted(shifts[j]));
        let (plain, awkward) = (pseudo_inverse(&a).unwrap(), pseudo_inverse(&awkward).unwrap());
        let undone = Matrix::from_fn(3, 9, |i, j| awkward[(i, j)].shifted(shifts[i]));
        assert_eq!(undone, plain);
    }

    #[test]
    fn least_squares_reproduces_the_solution_and_leaves_an_orthogonal_residual() {
        let p = Precision::bits(160);
        let (a, x, b) = (arbitrary(10, 3, p), arbitrary(3, 2, p), arbitrary(10, 1, p));
        assert!(distance(&least_squares(&a, &(&a * &x)).unwrap(), &x) < -150.0);
        let residual = &(&a * &least_squares(&a, &b).unwrap()) - &b;
        assert!((&a.transpose() * &residual).max_abs().log2_abs() < -150.0);
        let same = &pseudo_inverse(&a).unwrap() * &b;
        assert!(distance(&least_squares(&a, &b).unwrap(), &same) < -150.0);
    }

    #[test]
    fn dependent_columns_are_named() {
        let p = Precision::bits(90);
        let a = fractions(&[[1, 2, 3], [4, 5, 9], [7, 8, 15], [1, 0, 1]], 7, p);
        assert_eq!(pseudo_inverse(&a), Err(RankDeficient { column: 2 }));
        assert_eq!(pseudo_inverse(&Matrix::zeros(3, 1, p)), Err(RankDeficient { column: 0 }));
        let structured = fractions(&[[1, 0], [0, 3], [0, 0]], 1, p);
        let inverse = pseudo_inverse(&structured).unwrap();
        assert!(inverse[(0, 1)].is_zero() && inverse[(1, 0)].is_zero() && inverse[(0, 2)].is_zero());
    }
}
