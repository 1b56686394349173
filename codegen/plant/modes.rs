//! The plant's modes, for reports: the eigenvalues of A.
//!
//! Double precision suffices here; no constant depends on it.

use nalgebra::{DMatrix, Schur};

use super::Plant;

/// Sweeps of the QR algorithm before it is given up.
const SWEEPS: usize = 10_000;

/// Eigenvalues of A as (real, imaginary), by real part and then imaginary part, largest first; 1/s for a
/// continuous plant. `None` when the QR algorithm does not settle.
pub fn modes(plant: &Plant) -> Option<Vec<(f64, f64)>> {
    let n = plant.states.len();
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
