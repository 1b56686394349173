//! Coordinates in which a statistic's rows are orthogonal, so that nothing in it cancels.
//!
//! A read-out C of a statistic `s = sum R_i v_i` amplifies the rounding of s by `|C| |R_i|` where only `C R_i`
//! is wanted. With rows that are orthogonal over the statistic's samples, a row of C is as long as the
//! weights `C R_i` together are, whatever the modes of F do; the factor left is at most the root of the
//! number of weights. The scales are powers of two, so that the change itself rounds nothing but once.

use crate::real::{Matrix, Real};

/// The change of coordinates `T = scale * lower^-1`, for rows `T R_i` and read-outs `C T^-1`.
#[derive(Clone, Debug)]
pub struct Basis {
    /// Unit lower triangular, f x f.
    lower: Matrix,
    /// Exponents of two by component.
    scale: Vec<i64>,
}

/// Exponents of the scales; decided once, so that every precision scales alike.
pub fn scales(rows: &[Matrix]) -> Option<Vec<i64>> {
    let (_, pivots) = factor(rows)?;
    #[expect(clippy::cast_possible_truncation, reason = "exponents are far below 2^63")]
    let half = |pivot: &Real| -(pivot.log2_abs() / 2.0).floor() as i64;
    Some(pivots.iter().map(half).collect())
}

impl Basis {
    /// For the rows of a statistic, f x p each; `None` if they do not span all components.
    pub fn new(rows: &[Matrix], scale: &[i64]) -> Option<Self> {
        let (lower, _) = factor(rows)?;
        Some(Self { lower, scale: scale.to_vec() })
    }

    /// `T R`.
    pub fn row(&self, row: &Matrix) -> Matrix {
        let mut solved = row.clone();
        for i in 0..solved.rows() {
            for j in 0..solved.cols() {
                let mut value = solved.get(i, j).clone();
                for k in 0..i {
                    value = &value - &(self.lower.get(i, k) * solved.get(k, j));
                }
                solved[(i, j)] = value;
            }
        }
        Matrix::from_fn(solved.rows(), solved.cols(), |i, j| solved.get(i, j).shifted(self.scale[i]))
    }

    /// `C T^-1`.
    pub fn read(&self, read: &Matrix) -> Matrix {
        let read = read * &self.lower;
        Matrix::from_fn(read.rows(), read.cols(), |i, j| read.get(i, j).shifted(-self.scale[j]))
    }
}

/// `sum R_i R_i^T = L diag(d) L^T` with a unit lower triangular L; `None` where it has no full rank.
fn factor(rows: &[Matrix]) -> Option<(Matrix, Vec<Real>)> {
    let (f, p) = (rows.first()?.rows(), rows.first()?.precision());
    let mut rest = Matrix::zeros(f, f, p);
    for row in rows {
        rest = &rest + &(row * &row.transpose());
    }
    let whole: Vec<f64> = (0..f).map(|k| rest.get(k, k).log2_abs()).collect();
    let mut lower = Matrix::identity(f, p);
    let mut pivots = Vec::new();
    for k in 0..f {
        let pivot = rest.get(k, k).clone();
        // Half of the bits are far from any rounding of the sums.
        #[expect(clippy::cast_precision_loss, reason = "bits are few")]
        let nothing = whole[k] - p.as_bits() as f64 / 2.0;
        if pivot.is_zero() || pivot.is_negative() || pivot.log2_abs() < nothing {
            return None;
        }
        for i in k + 1..f {
            lower[(i, k)] = rest.get(i, k).checked_div(&pivot).ok()?;
        }
        for i in k + 1..f {
            for j in k + 1..f {
                rest[(i, j)] = rest.get(i, j) - &(&(lower.get(i, k) * lower.get(j, k)) * &pivot);
            }
        }
        pivots.push(pivot);
    }
    Some((lower, pivots))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Precision;

    /// Rows of a double integrator at a short sample time, and of a fast mode beside a slow one.
    #[test]
    fn rows_become_orthogonal_and_weights_stay() {
        let p = Precision::bits(512);
        let tiny = Real::from_i64(1, p).checked_div(&Real::from_i64(1_000, p)).unwrap();
        let fast = Real::from_i64(1, p).checked_div(&Real::from_i64(3, p)).unwrap();
        let integrator: Vec<Matrix> = (0..20)
            .map(|i| Matrix::from_fn(2, 1, |k, _| if k == 0 { Real::one(p) } else { &tiny * &Real::from_i64(i, p) }))
            .collect();
        let apart: Vec<Matrix> = (0..20)
            .map(|i| Matrix::from_fn(2, 1, |k, _| if k == 0 { Real::one(p) } else { fast.checked_powi(i).unwrap() }))
            .collect();
        let read = Matrix::from_fn(1, 2, |_, j| Real::from_i64(if j == 0 { 7 } else { -2 }, p));
        for rows in [integrator, apart] {
            let basis = Basis::new(&rows, &scales(&rows).unwrap()).unwrap();
            let turned: Vec<Matrix> = rows.iter().map(|row| basis.row(row)).collect();
            let mut gramian = Matrix::zeros(2, 2, p);
            for row in &turned {
                gramian = &gramian + &(row * &row.transpose());
            }
            let gramian = gramian.to_f64();
            assert!(gramian[0][1].abs() < 1e-100 && (0.9..4.1).contains(&gramian[0][0]), "{gramian:?}");
            assert!((0.9..4.1).contains(&gramian[1][1]), "{gramian:?}");
            for (row, turned) in rows.iter().zip(&turned) {
                let difference = &(&read * row) - &(&basis.read(&read) * turned);
                assert!(difference.is_zero() || difference.max_abs().log2_abs() < -400.0);
            }
        }
    }

    #[test]
    fn rows_that_do_not_span_all_components_have_no_basis() {
        let p = Precision::bits(256);
        let rows: Vec<Matrix> = (1..5).map(|i| Matrix::from_fn(2, 1, |_, _| Real::from_i64(i, p))).collect();
        assert!(scales(&rows).is_none());
    }
}
