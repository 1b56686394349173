//! Singular values by one-sided Jacobi rotations, and what follows from them.

use super::matrix::Matrix;
use super::number::{Precision, Real, size};
use super::orthogonal::{Factors, columns};

/// Guard bits of the rotations.
const GUARD: usize = 48;

/// More sweeps than the quadratically convergent method ever takes.
const SWEEPS: usize = 100;

/// The singular values, descending, as many as the smaller dimension. The error of each is below
/// about `2^-p` of the largest one. Method: Householder QR, then one-sided Jacobi on `R'`,
/// both with guard bits.
#[must_use]
#[allow(clippy::missing_panics_doc, reason = "the expectation always holds")]
pub fn singular_values(a: &Matrix) -> Vec<Real> {
    let p = a.precision();
    let tall = if a.rows() >= a.cols() { a.clone() } else { a.transpose() };
    let n = tall.cols();
    let working = p.plus(GUARD);
    // A common power of two, so that the squares stay in range whatever the scale.
    let scale = tall.max_abs().top().unwrap_or(0);
    let factors = Factors::of(&tall.with_precision(working).shifted(-scale));
    // The columns of R', which Jacobi diagonalises faster than those of R.
    let lower = Matrix::from_fn(n, n, |i, j| factors.upper[i].get(j).cloned().unwrap_or_else(|| Real::zero(working)));
    let mut values: Vec<Real> = jacobi(columns(&lower), working)
        .into_iter()
        .map(|square| square.checked_sqrt().expect("a sum of squares").shifted(scale))
        .map(|value| value.into_precision(p))
        .collect();
    values.sort_by(|a, b| b.cmp(a));
    values
}

/// Rotates the columns until they are orthogonal; their squared norms.
fn jacobi(mut columns: Vec<Vec<Real>>, p: Precision) -> Vec<Real> {
    let dot = |a: &[Real], b: &[Real]| Real::sum_of_products(a.iter().zip(b), p);
    let n = columns.len();
    let mut squares: Vec<Real> = columns.iter().map(|x| dot(x, x)).collect();
    // Squared columns below this are rounding of the larger ones, as are relative angles.
    let rounding = 2 * (size(p.as_bits()) - 8 - i64::from(n.max(1).ilog2()));
    for _ in 0..SWEEPS {
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|&a, &b| squares[b].cmp(&squares[a]).then(a.cmp(&b)));
        columns = order.iter().map(|&j| std::mem::take(&mut columns[j])).collect();
        squares = columns.iter().map(|x| dot(x, x)).collect();
        let negligible = squares.iter().max().map_or(Real::zero(p), |x| x.shifted(-rounding));
        let mut settled = true;
        for i in 0..n {
            for j in i + 1..n {
                if squares[i] <= negligible || squares[j] <= negligible {
                    continue;
                }
                let cross = dot(&columns[i], &columns[j]);
                if &cross * &cross <= (&squares[i] * &squares[j]).shifted(-rounding) {
                    continue;
                }
                settled = false;
                let (cosine, sine) = rotation(&squares[i], &squares[j], &cross, p);
                let (left, right) = columns.split_at_mut(j);
                for (x, y) in left[i].iter_mut().zip(&mut right[0]) {
                    let turned = Real::sum_of_products([(&cosine, &*x), (&-&sine, &*y)], p);
                    *y = Real::sum_of_products([(&sine, &*x), (&cosine, &*y)], p);
                    *x = turned;
                }
                squares[i] = dot(&columns[i], &columns[i]);
                squares[j] = dot(&columns[j], &columns[j]);
            }
        }
        if settled {
            break;
        }
    }
    squares
}

/// The cosine and sine of the smaller rotation that makes two columns orthogonal, from their
/// squared norms and their non-zero product.
fn rotation(a: &Real, b: &Real, cross: &Real, p: Precision) -> (Real, Real) {
    let one = Real::one(p);
    let hypotenuse = |x: &Real| (x * x + &one).checked_sqrt().expect("at least one");
    let zeta = (b - a) / cross.shifted(1);
    let reach = zeta.abs() + hypotenuse(&zeta);
    let tangent = if zeta.is_negative() { -(&one / reach) } else { &one / reach };
    let cosine = &one / hypotenuse(&tangent);
    let sine = &cosine * &tangent;
    (cosine, sine)
}

/// A numerical rank and the evidence for it.
#[derive(Clone, PartialEq, Debug)]
pub struct Rank {
    /// The number of singular values above the tolerance.
    pub rank: usize,
    /// All of them, descending, for the report.
    pub singular_values: Vec<f64>,
    /// The last kept over the first dropped singular value: large if the decision is clear.
    /// Infinite if none was dropped, none kept, or the first dropped is exactly zero.
    pub gap: f64,
}

/// The number of singular values above `2^-tolerance` of the largest one. The tolerance should
/// stay below the precision of `a`, at which dropped values are rounding. The columns are taken
/// as they are; for a rank that does not depend on units, pass
/// [`equilibrated_columns`](super::balance::equilibrated_columns).
#[must_use]
pub fn rank(a: &Matrix, tolerance: usize) -> Rank {
    let values = singular_values(a);
    let threshold = values.first().map(|largest| largest.shifted(-size(tolerance)));
    let rank = threshold
        .map_or(0, |threshold| values.iter().take_while(|value| !value.is_zero() && **value > threshold).count());
    let gap = match (rank.checked_sub(1), values.get(rank)) {
        (Some(kept), Some(dropped)) => values[kept].checked_div(dropped).map_or(f64::INFINITY, |gap| gap.to_f64()),
        _ => f64::INFINITY,
    };
    Rank { rank, singular_values: values.iter().map(Real::to_f64).collect(), gap }
}

/// The ratio of the largest to the smallest singular value; `None` if the smallest is zero or
/// there is none.
#[must_use]
pub fn condition(a: &Matrix) -> Option<Real> {
    let values = singular_values(a);
    values.first()?.checked_div(values.last()?).ok()
}

#[cfg(test)]
#[allow(clippy::cast_possible_wrap, reason = "small numbers")]
mod tests {
    use super::super::matrix::tests::{arbitrary, fractions};
    use super::super::solve::determinant;
    use super::*;

    fn hilbert(rows: usize, cols: usize, p: Precision) -> Matrix {
        Matrix::from_fn(rows, cols, |i, j| Real::one(p) / Real::from_i64((i + j + 1) as i64, p))
    }

    #[test]
    fn hilbert_matrices_agree_with_more_precision() {
        let p = Precision::bits(160);
        // The same rounded matrix, at two working precisions.
        let a = hilbert(9, 6, p);
        let (coarse, fine) = (singular_values(&a), singular_values(&a.with_precision(p.doubled())));
        let largest = fine[0].log2_abs();
        for (x, y) in coarse.iter().zip(&fine) {
            assert!((x - y).log2_abs() < largest - 159.0);
        }
        assert_eq!(coarse, singular_values(&a.transpose()));
        // The condition number of the 6 x 6 Hilbert matrix is 1.4951e7.
        let condition = condition(&hilbert(6, 6, p)).unwrap().to_f64();
        assert!((condition - 1.495_105_864e7).abs() < 1.0);
    }

    #[test]
    fn the_singular_values_multiply_to_the_determinant_and_add_to_the_norm() {
        let p = Precision::bits(160);
        let a = arbitrary(7, 7, p);
        let values = singular_values(&a);
        let product = values.iter().fold(Real::one(p), |product, x| product * x);
        assert!((product - determinant(&a).abs()).log2_abs() < -145.0);
        let squares = Real::sum_of_products(values.iter().zip(&values), p);
        let frobenius = Real::sum_of_products(a.iter().zip(a.iter()), p);
        assert!((squares - frobenius).log2_abs() < -145.0);
        assert!(values.is_sorted_by(|a, b| a >= b));
    }

    #[test]
    fn ranks_come_with_a_measured_gap() {
        let p = Precision::bits(128);
        let a = fractions(&[[1, 2, 3], [4, 5, 9], [7, 8, 15], [1, 0, 1]], 7, p);
        let found = rank(&a, 64);
        assert_eq!((found.rank, found.singular_values.len()), (2, 3));
        assert!(found.gap > 1e36);
        let full = rank(&Matrix::identity(4, p), 64);
        assert_eq!((full.rank, full.gap), (4, f64::INFINITY));
        assert_eq!(rank(&Matrix::zeros(3, 2, p), 64).rank, 0);
        assert_eq!(rank(&Matrix::zeros(3, 0, p), 64).rank, 0);
        let three = fractions(&[[3, 0], [0, 0]], 1, p);
        assert_eq!(rank(&three, 64), Rank { rank: 1, singular_values: vec![3.0, 0.0], gap: f64::INFINITY });
        assert_eq!(condition(&three), None);
    }
}
