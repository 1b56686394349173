//! Coordinates in which a statistic's rows are orthogonal, so that nothing in it cancels.
//!
//! A read-out C of a statistic `s = sum R_i v_i` amplifies the rounding of s by `|C| |R_i|` where only `C R_i`
//! is wanted. With rows that are orthogonal over the statistic's samples, a row of C is as long as the
//! weights `C R_i` together are, whatever the modes of F do; the factor left is at most the root of the
//! number of weights. The scales are powers of two, so that the change itself rounds nothing but once.

use crate::real::{Matrix, Real};

/// The change of coordinates `T = scale * lower^-1`, for rows `T R_i` and read-outs `C T^-1`.
///
/// Components that the others give at every place are left out: a filter may have more of them than its inputs tell
/// apart.
#[derive(Clone, Debug)]
pub struct Basis {
    /// Unit lower triangular, f x f.
    lower: Matrix,
    /// The components that stay, with exponents of two.
    kept: Vec<(usize, i64)>,
}

/// The components that stay and the exponents of their scales, decided once, so that every precision decides alike.
pub fn kept(rows: &[Matrix]) -> Vec<(usize, i64)> {
    #[expect(clippy::cast_possible_truncation, reason = "exponents are far below 2^63")]
    let half = |pivot: &Real| -(pivot.log2_abs() / 2.0).floor() as i64;
    let pivots = factor(rows).1.into_iter().enumerate();
    pivots.filter_map(|(k, pivot)| Some((k, half(&pivot?)))).collect()
}

impl Basis {
    /// For the rows of a statistic, f x p each; `None` if other components stay at this precision.
    pub fn new(rows: &[Matrix], kept: &[(usize, i64)]) -> Option<Self> {
        let (lower, pivots) = factor(rows);
        let stay = |k: usize| kept.iter().any(|(component, _)| *component == k);
        let same = pivots.iter().enumerate().all(|(k, pivot)| pivot.is_some() == stay(k));
        same.then(|| Self { lower, kept: kept.to_vec() })
    }

    /// `T R`.
    pub fn row(&self, row: &Matrix) -> Matrix {
        let mut solved = row.clone();
        for i in 0..solved.rows() {
            for j in 0..solved.cols() {
                let mut value = solved.get(i, j).clone();
                for (k, _) in self.kept.iter().filter(|(k, _)| *k < i) {
                    value = &value - &(self.lower.get(i, *k) * solved.get(*k, j));
                }
                solved[(i, j)] = value;
            }
        }
        Matrix::from_fn(self.kept.len(), solved.cols(), |i, j| solved.get(self.kept[i].0, j).shifted(self.kept[i].1))
    }

    /// `C T^-1`.
    pub fn read(&self, read: &Matrix) -> Matrix {
        let read = read * &self.lower;
        Matrix::from_fn(read.rows(), self.kept.len(), |i, j| read.get(i, self.kept[j].0).shifted(-self.kept[j].1))
    }
}

/// `sum R_i R_i^T = L diag(d) L^T` with a unit lower triangular L; no d for a component that depends on those before.
fn factor(rows: &[Matrix]) -> (Matrix, Vec<Option<Real>>) {
    let (f, p) = rows.first().map_or((0, crate::real::Precision::bits(0)), |row| (row.rows(), row.precision()));
    let mut rest = Matrix::zeros(f, f, p);
    for row in rows {
        rest = &rest + &(row * &row.transpose());
    }
    // Half of the bits are far from any rounding of the sums.
    let nothing = crate::numbers::count(p.as_bits()) / 2.0;
    let whole: Vec<f64> = (0..f).map(|k| rest.get(k, k).log2_abs()).collect();
    let mut lower = Matrix::identity(f, p);
    let mut pivots = Vec::new();
    for k in 0..f {
        let pivot = rest.get(k, k).clone();
        let dependent = pivot.is_zero() || pivot.is_negative() || pivot.log2_abs() < whole[k] - nothing;
        if dependent {
            pivots.push(None);
            continue;
        }
        for i in k + 1..f {
            lower[(i, k)] = rest.get(i, k).checked_div(&pivot).unwrap_or_else(|_| Real::zero(p));
        }
        for i in k + 1..f {
            for j in k + 1..f {
                rest[(i, j)] = rest.get(i, j) - &(&(lower.get(i, k) * lower.get(j, k)) * &pivot);
            }
        }
        pivots.push(Some(pivot));
    }
    (lower, pivots)
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
            let basis = Basis::new(&rows, &kept(&rows)).unwrap();
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
    fn a_component_that_depends_on_others_is_left_out_and_weights_stay() {
        let p = Precision::bits(256);
        let rows: Vec<Matrix> =
            (1..5).map(|i| Matrix::from_fn(3, 1, |k, _| Real::from_i64([i, 3 * i, i * i][k], p))).collect();
        let read = Matrix::from_fn(1, 3, |_, j| Real::from_i64([2, 5, -1][j], p));
        let stay = kept(&rows);
        assert_eq!(stay.iter().map(|(k, _)| *k).collect::<Vec<_>>(), [0, 2]);
        let basis = Basis::new(&rows, &stay).unwrap();
        for row in &rows {
            let difference = &(&read * row) - &(&basis.read(&read) * &basis.row(row));
            assert!(difference.is_zero() || difference.max_abs().log2_abs() < -200.0);
        }
        assert!(Basis::new(&rows, &[(0, 0), (1, 0), (2, 0)]).is_none());
    }
}
