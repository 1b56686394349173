//! Standard deviations of a schedule of gains for white noise: the covariance from call to call, in doubles, for notes.

use super::schedule::Schedule;
use crate::dense::{Rows as Dense, identity, product, sum, transposed};

/// Standard deviations of the estimate, per state.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviations {
    /// At the promised call.
    pub promised: Vec<f64>,
    /// In the long run: the root mean square over a cycle of gains; infinite where it does not stand still.
    pub later: Vec<f64>,
}

/// A sampled plant with its noise, in doubles.
#[derive(Clone, Debug)]
pub struct Noisy {
    /// Phi, n x n.
    pub phi: Dense,
    /// C, p x n.
    pub c: Dense,
    /// Q, n x n, per sample.
    pub process: Dense,
    /// R, p x p, per sample.
    pub measurement: Dense,
}

/// Cycles until the covariance must stand still.
const MOST_CYCLES: usize = 100_000;
/// By how much it may still move.
const STILL: f64 = 1e-9;

impl Noisy {
    /// `P+ = (I - K C) (Phi P Phi' + Q) (I - K C)' + K R K'`: of any gain, without a difference of covariances.
    fn call(&self, covariance: &Dense, gain: &Dense) -> Dense {
        let predicted = sum(&product(&product(&self.phi, covariance), &transposed(&self.phi)), &self.process);
        let shown = product(gain, &self.c);
        let mut kept = identity(self.phi.len());
        kept.iter_mut().flatten().zip(shown.iter().flatten()).for_each(|(kept, shown)| *kept -= shown);
        let carried = product(&product(&kept, &predicted), &transposed(&kept));
        sum(&carried, &product(&product(gain, &self.measurement), &transposed(gain)))
    }

    /// The deviations of a schedule whose lead ends with the promised call, from the covariance at call 0.
    pub fn deviations(&self, start: Dense, schedule: &Schedule) -> Deviations {
        let n = self.phi.len();
        let mut covariance = schedule.lead.iter().fold(start, |covariance, gain| self.call(&covariance, gain));
        let root = |square: f64| deadbeat_math::sqrt_f64(square.max(0.0));
        let promised = (0..n).map(|i| root(covariance[i][i])).collect();
        let mut later = vec![f64::INFINITY; n];
        for _ in 0..MOST_CYCLES {
            let mut squares = vec![0.0; n];
            for gain in &schedule.cycle {
                covariance = self.call(&covariance, gain);
                squares.iter_mut().enumerate().for_each(|(i, square)| *square += covariance[i][i]);
            }
            let length = crate::numbers::count(schedule.cycle.len());
            let now: Vec<f64> = squares.iter().map(|square| root(square / length)).collect();
            let still = now.iter().zip(&later).all(|(now, before)| (now - before).abs() <= STILL * now);
            later = now;
            if still {
                return Deviations { promised, later };
            }
        }
        Deviations { promised, later: vec![f64::INFINITY; n] }
    }
}
