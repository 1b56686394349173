//! What gains that go round leave of an error after any number of calls, however many: by powers of a turn's map, each
//! the square of the one before, in multiprecision and rounded once.
//!
//! The first call from which on no more than a share is left is found by halving: a stretch of calls is passed over where
//! the error at its beginning, times the most that it can grow within, is below the share already.

use nalgebra::DMatrix;

use super::far::Far;
use crate::real::Matrix;

/// Squarings: 2^50 turns are more than anybody waits for.
const MOST_LEVELS: usize = 50;
/// Stretches that are looked at; beyond, one counts as above the share as a whole.
const MOST_STRETCHES: usize = 200_000;

/// Powers of a turn of the gains.
pub(super) struct Rounds {
    /// Each call of a turn, n x n.
    calls: Vec<DMatrix<f64>>,
    /// 2^i turns, and the newest of them in full.
    powers: Vec<DMatrix<f64>>,
    newest: Matrix,
    /// The largest norm of what any number of calls below 2^i turns leaves.
    growth: Vec<f64>,
}

impl Rounds {
    /// Of gains, n x p for states, in the coordinates given.
    pub(super) fn new(far: &Far, cycle: &[DMatrix<f64>]) -> Self {
        let steps: Vec<Matrix> = cycle.iter().map(|gain| far.call(gain)).collect();
        let calls: Vec<DMatrix<f64>> = steps.iter().map(Matrix::doubles).collect();
        let turn = steps.into_iter().reduce(|turn, step| &step * &turn);
        let newest = turn.unwrap_or_else(|| Matrix::identity(far.phi.rows(), far.phi.precision()));
        let mut within = DMatrix::identity(far.phi.rows(), far.phi.rows());
        let mut most: f64 = 1.0;
        for call in calls.iter().take(calls.len().saturating_sub(1)) {
            within = call * within;
            most = most.max(norm(&within));
        }
        Self { calls, powers: vec![newest.doubles()], newest, growth: vec![most] }
    }

    /// 2^`level` turns.
    pub(super) fn power(&mut self, level: usize) -> &DMatrix<f64> {
        while self.powers.len() <= level {
            let last = self.powers.len() - 1;
            let growth = self.growth[last] * norm(&self.powers[last]).max(1.0);
            self.newest = &self.newest * &self.newest;
            self.powers.push(self.newest.doubles());
            self.growth.push(growth);
        }
        &self.powers[level]
    }

    /// The fewest squarings after which at most this share of any error is left, for good; `None` where there are none.
    pub(super) fn levels(&mut self, share: f64) -> Option<usize> {
        (0..=MOST_LEVELS).find(|level| {
            let left = norm(self.power(*level));
            left <= 0.5 && left * self.growth[*level] <= share
        })
    }

    /// The fewest calls from which on at most `share` is left of what `start`, n x any, has at call 0, in the root of
    /// the sum of squares; `None` where that takes longer than anybody waits.
    pub(super) fn until(&mut self, start: &DMatrix<f64>, share: f64) -> Option<usize> {
        let level = self.levels(share / start.norm().max(f64::MIN_POSITIVE))?;
        let mut stretches = 0;
        let last = self.last_above(start, level, share, &mut stretches);
        Some(last.map_or(0, |call| call + 1))
    }

    /// The fewest calls after those before a place of the turn from which on at most `share` is left of any error.
    pub(super) fn until_from(&mut self, place: usize, share: f64) -> Option<usize> {
        let mut left = DMatrix::identity(self.newest.rows(), self.newest.rows());
        let mut last = None;
        for (call, step) in self.calls[place..].iter().enumerate() {
            last = if left.norm() > share { Some(call) } else { last };
            left = step * left;
        }
        let later = self.until(&left, share)?;
        Some(if later > 0 { self.calls.len() - place + later } else { last.map_or(0, |call| call + 1) })
    }

    /// The last call of 2^`level` turns at which more than `share` is left.
    fn last_above(&self, start: &DMatrix<f64>, level: usize, share: f64, stretches: &mut usize) -> Option<usize> {
        if start.norm() * self.growth[level] <= share {
            return None;
        }
        *stretches += 1;
        let turn = self.calls.len();
        if level == 0 {
            let mut left = start.clone();
            let mut last = None;
            for (call, step) in self.calls.iter().enumerate() {
                last = if left.norm() > share { Some(call) } else { last };
                left = step * left;
            }
            return last;
        }
        let half = turn << (level - 1);
        if *stretches > MOST_STRETCHES {
            return Some(2 * half - 1);
        }
        let later = &self.powers[level - 1] * start;
        let last = self.last_above(&later, level - 1, share, stretches).map(|call| call + half);
        last.or_else(|| self.last_above(start, level - 1, share, stretches))
    }

    /// What so many calls from the beginning of a turn on leave, n x n.
    pub(super) fn after(&mut self, calls: usize) -> DMatrix<f64> {
        let (turns, rest) = (calls / self.calls.len(), calls % self.calls.len());
        let bits = usize::BITS - turns.leading_zeros();
        let mut left = DMatrix::identity(self.newest.rows(), self.newest.rows());
        for level in (0..bits as usize).filter(|level| turns >> level & 1 == 1) {
            left = self.power(level) * left;
        }
        self.calls[..rest].iter().fold(left, |left, step| step * left)
    }

    /// The spectral radius of a turn.
    pub(super) fn radius(&self) -> f64 {
        self.powers[0].complex_eigenvalues().iter().map(|z| (z.re * z.re + z.im * z.im).sqrt()).fold(0.0, f64::max)
    }
}

/// The largest factor by which a map makes an error longer, and no less.
pub(super) fn norm(map: &DMatrix<f64>) -> f64 {
    // Squares of what is far below one would vanish.
    let size = map.amax();
    if size == 0.0 || !size.is_finite() {
        return size;
    }
    let scaled = map / size;
    size * deadbeat_math::sqrt_f64((scaled.transpose() * &scaled).symmetric_eigenvalues().max().max(0.0)) * SLACK
}

/// For the rounding of eigenvalues.
const SLACK: f64 = 1.0 + 1e-12;
