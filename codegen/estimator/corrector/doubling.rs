//! Calls of a Kalman filter put together, and twice as many from as many: the structured doubling algorithm.
//!
//! One call takes the prediction's covariance by `P -> A (I + P G)^-1 P A' + H`, with A = Phi, G the information `C' R^-1 C`
//! of its samples and H = Q. Such maps compose to one of the same form (Chu, Fan, Lin and Wang 2004,
//! "Structure-preserving algorithms for periodic discrete-time algebraic Riccati equations"). Doubled over and over, H is
//! the covariance after so many calls from nothing on, and A what they leave: it vanishes as fast as the filter forgets,
//! squared with each doubling. A need not be invertible.

use super::riccati::bits;
use crate::real::{Matrix, Real, solve};

/// Doublings until the covariance stands still; what takes longer does not.
const DOUBLINGS: usize = 100;
/// Powers of two beyond which a number counts as nothing, or as without bound: its exponent doubles with each squaring.
const REACH: i64 = 1_000_000;

/// What calls do to a prediction's covariance.
#[derive(Clone, Debug)]
pub(super) struct Map {
    /// n x n.
    pub(super) a: Matrix,
    /// n x n, symmetric.
    pub(super) g: Matrix,
    /// n x n, symmetric.
    pub(super) h: Matrix,
}

impl Map {
    /// This one, and then another.
    pub(super) fn then(&self, next: &Self) -> Option<Self> {
        let n = self.a.rows();
        let seen = &Matrix::identity(n, self.a.precision()) + &(&self.h * &next.g);
        let both = solve(&seen, &self.a.hcat(&self.h)).ok()?;
        let (carried, held) = (both.block(0..n, 0..n), both.block(0..n, n..2 * n));
        // (I + G2 H1)^-1 G2 = G2 (I + H1 G2)^-1.
        let looked = &next.g * &carried;
        let symmetric = |m: Matrix| (&m + &m.transpose()).shifted(-1);
        Some(Self {
            a: &next.a * &carried,
            g: symmetric(&self.g + &(&self.a.transpose() * &looked)),
            h: symmetric(&next.h + &(&(&next.a * &held) * &next.a.transpose())),
        })
    }

    /// The covariance that it leaves as it is, from nothing on; `None` where it does not come to one. Where a motion grows
    /// that no noise excites it is not that of a filter that is stable.
    pub(super) fn fixed_point(&self) -> Option<Matrix> {
        let p = self.a.precision();
        let mut calls = self.clone();
        let mut last = false;
        for _ in 0..DOUBLINGS {
            let mut twice = calls.then(&calls)?;
            twice.a = within_reach(&twice.a)?;
            within_reach(&twice.h)?;
            if last || twice.h.is_zero() {
                return Some(twice.h);
            }
            // Quadratic: half of the digits agree, so that all do after the next.
            let change = (&twice.h - &calls.h).max_abs().log2_abs() - twice.h.max_abs().log2_abs();
            last = change < -bits(p) / 2.0;
            calls = twice;
        }
        None
    }
}

/// A matrix that is squared over and over, without what has vanished; `None` where something has grown beyond all bounds.
pub(super) fn within_reach(matrix: &Matrix) -> Option<Matrix> {
    let top = |x: &Real| x.top().unwrap_or(0);
    let found = matrix.map(|x| if top(x) < -REACH { Real::zero(x.precision()) } else { x.clone() });
    matrix.iter().all(|x| top(x) < REACH).then_some(found)
}
