//! From the chain of integrators to any observable plant with one output: M and q.
//!
//! With `W = I - Phi^-1`, the columns of M solve `C Phi W^(n-j) m_n = 1` for j = 1 … n and `m_(j-1) = W m_j`;
//! `q = (Phi - I) m_1`. Then `K = M kappa + q` makes the estimation error exactly M times that of the chain in implicit
//! Euler's scaled coordinates, `eps = (I - kappa e_1') (I - N)^-1 eps` with the shift N: no canonical form runs, and the
//! plant's own prediction is exact (prescribed-time-observers, section 3, where it was found and checked; the tests
//! here check it again on random plants).

use crate::real::{Matrix, Real, Singular, inverse, solve};

/// M, n x n; q, n x 1.
#[derive(Clone, Debug)]
pub struct Chain {
    /// By columns from the chain's coordinates, all in the output's unit.
    pub m: Matrix,
    /// What the innovation adds whatever the gain.
    pub q: Matrix,
}

impl Chain {
    /// Of a sampled plant: phi n x n, c 1 x n.
    ///
    /// # Errors
    /// Phi singular, or (C, Phi) not observable to the working precision.
    pub fn new(phi: &Matrix, c: &Matrix) -> Result<Self, Singular> {
        let (n, p) = (phi.rows(), phi.precision());
        let identity = Matrix::identity(n, p);
        let w = &identity - &inverse(phi)?;
        // Rows C Phi W^(n-j), j = n … 1.
        let mut row = c * phi;
        let mut rows = row.clone();
        for _ in 1..n {
            row = &row * &w;
            rows = rows.vcat(&row);
        }
        let ones = Matrix::from_fn(n, 1, |_, _| Real::one(p));
        let mut columns = vec![solve(&rows, &ones)?];
        for _ in 1..n {
            columns.push(&w * &columns[columns.len() - 1]);
        }
        let m =
            columns.into_iter().rev().reduce(|left, right| left.hcat(&right)).unwrap_or_else(|| Matrix::zeros(0, 0, p));
        let q = &(phi - &identity) * &m.column(0);
        Ok(Self { m, q })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Precision;

    /// The error of the plant is M times the chain's, for plants up to order 8 and any kappa.
    #[test]
    fn the_error_is_m_times_the_chains() {
        let p = Precision::bits(512);
        for n in 2..=8_i64 {
            let size = usize::try_from(n).unwrap();
            // A full matrix without structure.
            let mut seed = 12_345_i64;
            let phi = Matrix::from_fn(size, size, |i, j| {
                seed = (seed * 1_103_515_245 + 12_345) % (1 << 31);
                let entry = (seed >> 16) % 21 - 10 + 9 * i64::from(i == j);
                &Real::from_i64(entry, p) / &Real::from_i64(8 + n, p)
            });
            let c = Matrix::from_fn(1, size, |_, j| Real::from_i64(1 + i64::try_from(j).unwrap() % 3, p));
            let Chain { m, q } = Chain::new(&phi, &c).unwrap();
            let kappa =
                Matrix::from_fn(size, 1, |j, _| &Real::one(p) / &Real::from_i64(2 + i64::try_from(j).unwrap(), p));
            let identity = Matrix::identity(size, p);
            let gain = &(&m * &kappa) + &q;
            let error = &(&identity - &(&gain * &c)) * &phi;
            let summing = Matrix::from_fn(size, size, |i, j| if j >= i { Real::one(p) } else { Real::zero(p) });
            let first = Matrix::from_fn(1, size, |_, j| if j == 0 { Real::one(p) } else { Real::zero(p) });
            let chain = &(&identity - &(&kappa * &first)) * &summing;
            let difference = &(&error * &m) - &(&m * &chain);
            assert!(difference.max_abs().log2_abs() < m.max_abs().log2_abs() - 400.0, "order {n}");
        }
    }
}
