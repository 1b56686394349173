//! Standard deviations of a schedule of gains for white noise: the covariance from call to call, in doubles, for notes.

use nalgebra::DMatrix;

use super::schedule::Schedule;

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
    pub phi: DMatrix<f64>,
    /// C, p x n.
    pub c: DMatrix<f64>,
    /// Q, n x n, per sample.
    pub process: DMatrix<f64>,
    /// R, p x p, per sample.
    pub measurement: DMatrix<f64>,
}

/// Cycles until the covariance must stand still.
const MOST_CYCLES: usize = 100_000;
/// By how much it may still move.
const STILL: f64 = 1e-9;

impl Noisy {
    /// `P+ = (I - K C) (Phi P Phi' + Q) (I - K C)' + K R K'`: of any gain, without a difference of covariances.
    fn call(&self, covariance: &DMatrix<f64>, gain: &DMatrix<f64>) -> DMatrix<f64> {
        let predicted = &self.phi * covariance * self.phi.transpose() + &self.process;
        let kept = DMatrix::identity(self.phi.nrows(), self.phi.nrows()) - gain * &self.c;
        &kept * predicted * kept.transpose() + gain * &self.measurement * gain.transpose()
    }

    /// The deviations of a schedule whose lead ends with the promised call, from the covariance at call 0.
    pub fn deviations(&self, start: DMatrix<f64>, schedule: &Schedule) -> Deviations {
        let n = self.phi.nrows();
        let mut covariance = schedule.lead.iter().fold(start, |covariance, gain| self.call(&covariance, gain));
        let root = |square: f64| deadbeat_math::sqrt_f64(square.max(0.0));
        let promised = (0..n).map(|i| root(covariance[(i, i)])).collect();
        let mut later = vec![f64::INFINITY; n];
        for _ in 0..MOST_CYCLES {
            let mut squares = vec![0.0; n];
            for gain in &schedule.cycle {
                covariance = self.call(&covariance, gain);
                squares.iter_mut().enumerate().for_each(|(i, square)| *square += covariance[(i, i)]);
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
