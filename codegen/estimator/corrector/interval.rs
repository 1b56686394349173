//! One output that is due at every m-th call only: what the observer of the time between two samples needs.
//!
//! What is not due corrects nothing, so that with a constant gain K an error is at the next sample `(I - K C) Phi^m` of
//! what it was at the last one, and `Phi^j` of it j calls behind one. This is the error map of the plant sampled every
//! m h: a gain that is designed with `Phi^m` for Phi and `m h` for h has from sample to sample the eigenvalues that were
//! asked for, whatever m, if (C, `Phi^m`) is observable. Where every call is a sample, m = 1 and nothing changes.

use super::riccati::Noise;
use crate::expr::poly::DomainError;
use crate::numbers::count;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real};

/// m, calls from one sample to the next of a plant with one output; 1 for several, whose rates are their own.
pub fn calls(plant: &Plant) -> usize {
    if let [output] = plant.outputs.as_slice() { output.every } else { 1 }
}

/// `Phi^m`, n x n.
pub fn transition(plant: &Plant, phi: &Matrix) -> Matrix {
    match calls(plant) {
        1 => phi.clone(),
        calls => phi.powi(u64::try_from(calls).unwrap_or(u64::MAX)),
    }
}

/// What acts from one sample to the next: `Q_m`, the sum of `Phi^j Q Phi'^j` for j below m, and R.
pub fn noise(plant: &Plant, phi: &Matrix, noise: Noise) -> Noise {
    let mut process = noise.process.clone();
    for _ in 1..calls(plant) {
        process = &(&(phi * &process) * &phi.transpose()) + &noise.process;
    }
    Noise { process, ..noise }
}

/// `m h`, s, at one precision.
///
/// # Errors
/// [`DomainError`], where the sample time has no value.
pub fn time(plant: &Plant, p: Precision) -> Result<Real, DomainError> {
    let h = plant.sample_time.0.evaluate(p)?;
    Ok(match calls(plant) {
        1 => h,
        calls => &h * &Real::from_i64(i64::try_from(calls).unwrap_or(i64::MAX), p),
    })
}

/// The same in doubles, for decisions and reports.
pub fn seconds(plant: &Plant) -> f64 {
    count(calls(plant)) * plant.sample_time_s()
}
