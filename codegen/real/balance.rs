//! Exact scalings by powers of two that keep badly scaled units from doing harm.

use super::matrix::Matrix;
use super::number::{Precision, Real, size};

/// The `t` such that pivots below `2^-t` of an elimination on an equilibrated matrix with this
/// many rows are not distinguishable from the rounding of its elements to precision `p`.
pub(super) fn pivot_threshold(p: Precision, rows: usize) -> i64 {
    size(p.as_bits()) - 6 - i64::from(rows.max(1).ilog2())
}

/// The binary exponent of the sum of magnitudes; `None` if they are all zero.
fn sum_top<'a>(elements: impl Iterator<Item = &'a Real>) -> Option<i64> {
    elements.map(Real::abs).reduce(|a, b| a + b).and_then(|sum| sum.top())
}

/// The columns scaled by powers of two so that the largest magnitude of each lies in [1/2, 1),
/// with the exponents: column `j` of the result is column `j` of `a` times `2^shift[j]`. Zero
/// columns stay.
#[must_use]
pub fn equilibrated_columns(a: &Matrix) -> (Matrix, Vec<i64>) {
    let shifts: Vec<i64> =
        (0..a.cols()).map(|j| -(0..a.rows()).filter_map(|i| a[(i, j)].top()).max().unwrap_or(0)).collect();
    let scaled = Matrix::from_fn(a.rows(), a.cols(), |i, j| a[(i, j)].shifted(shifts[j]));
    (scaled.with_precision(a.precision()), shifts)
}

/// A diagonal similarity `b = D^-1 a D` with `D = diag(2^shift)` that brings the norms of the
/// rows and columns together (Parlett and Reinsch, by exponents only). Zeros stay zeros and
/// nothing is rounded. Variables that only drive others, or are only driven, are scaled so that
/// their coupling is of order one.
#[must_use]
pub fn balanced(a: &Matrix) -> (Matrix, Vec<i64>) {
    let n = a.rows();
    let mut b = a.clone();
    let mut shifts = vec![0_i64; n];
    for _ in 0..4 * n + 8 {
        let mut settled = true;
        for i in 0..n {
            let others = || (0..n).filter(move |&j| j != i);
            let column = sum_top(others().map(|j| &b[(j, i)]));
            let row = sum_top(others().map(|j| &b[(i, j)]));
            let shift = match (row, column) {
                (Some(row), Some(column)) => (row - column) / 2,
                (None, Some(column)) => -column,
                (Some(row), None) => row,
                (None, None) => 0,
            };
            if shift == 0 {
                continue;
            }
            settled = false;
            shifts[i] = shifts[i].saturating_add(shift);
            for j in others() {
                b[(j, i)] = b[(j, i)].shifted(shift);
                b[(i, j)] = b[(i, j)].shifted(-shift);
            }
        }
        if settled {
            break;
        }
    }
    (b, shifts)
}

/// Undoes [`balanced`] on a function of the balanced matrix: `D f D^-1`.
#[must_use]
pub fn unbalanced(f: &Matrix, shifts: &[i64]) -> Matrix {
    Matrix::from_fn(f.rows(), f.cols(), |i, j| f[(i, j)].shifted(shifts[i].saturating_sub(shifts[j])))
}

#[cfg(test)]
mod tests {
    use super::super::matrix::tests::fractions;
    use super::*;

    #[test]
    fn balancing_is_exact_and_lowers_the_norm_of_badly_scaled_matrices() {
        let p = Precision::bits(64);
        // An oscillator in metres, driven through a large gain.
        let a = fractions(&[[0, 1, 0], [-1_000_000_000, -3, 8_000_000], [0, 0, 0]], 1, p);
        let (b, shifts) = balanced(&a);
        assert_eq!(unbalanced(&b, &shifts), a);
        assert!(b.norm_1().to_f64() < 1e5);
        assert!(b[(0, 0)].is_zero() && b[(2, 0)].is_zero());
    }

    #[test]
    fn columns_are_brought_to_order_one_exactly() {
        let p = Precision::bits(64);
        let a = fractions(&[[0, 1, 5], [0, -1_000_000_000, 0]], 7, p);
        let (scaled, shifts) = equilibrated_columns(&a);
        assert_eq!(shifts[0], 0);
        for (j, shift) in shifts.into_iter().enumerate().skip(1) {
            assert_eq!(scaled.column(j).max_abs().top(), Some(0));
            assert_eq!(scaled.column(j).shifted(-shift), a.column(j));
        }
    }
}
