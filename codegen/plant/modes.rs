//! The plant's modes, for reports: the eigenvalues of A.
//!
//! Double precision suffices here; no constant depends on it.

use nalgebra::{DMatrix, Schur};

use super::Plant;
use crate::diagnostic::{Diagnostic, codes};
use crate::numbers::short;

/// Sweeps of the QR algorithm before it is given up.
const SWEEPS: usize = 10_000;

/// Where rounding of a double begins: a state that decays by more within a sample is at rest at each.
const GONE: f64 = 36.0;

/// A warning where a mode dies out within a sample: then it is none that samples show, or the sample time is in another
/// unit than the model.
pub(super) fn gone_within_a_sample(plant: &Plant) -> Option<Diagnostic> {
    let h = plant.sample_time_s();
    let fastest = modes(plant).filter(|_| !plant.discrete)?.into_iter().map(|(re, _)| re).reduce(f64::min)?;
    let decay = -fastest * h;
    if decay.is_nan() || decay < GONE {
        return None;
    }
    let message = format!("a mode of the plant decays by e^-{} within a sample", short(decay));
    let label = format!("its time constant is {} s, a sample {} s", short(-1.0 / fastest), short(h));
    let warning = Diagnostic::warning(codes::WEAK_SAMPLES, plant.sample_time.1.clone(), message).label(label);
    Some(warning.measured(decay).help(
        "check the units of the sample time and of the model, both in seconds; or leave the state out, at its equilibrium",
    ))
}

/// Eigenvalues of A as (real, imaginary), by real part and then imaginary part, largest first; 1/s for a
/// continuous plant. `None` when the QR algorithm does not settle.
pub fn modes(plant: &Plant) -> Option<Vec<(f64, f64)>> {
    let n = plant.states.len();
    if n == 0 {
        return None;
    }
    let mut entries = Vec::new();
    for constant in plant.a.iter().flatten() {
        entries.push(constant.to_f64().ok().filter(|x| x.is_finite())?);
    }
    let a = DMatrix::from_row_slice(n, n, &entries);
    let schur = Schur::try_new(a, f64::EPSILON, SWEEPS)?;
    let mut modes: Vec<(f64, f64)> = schur.complex_eigenvalues().iter().map(|z| (z.re, z.im)).collect();
    modes.sort_by(|x, y| y.0.total_cmp(&x.0).then(y.1.total_cmp(&x.1)));
    modes.iter().all(|(re, im)| re.is_finite() && im.is_finite()).then_some(modes)
}
