//! What the baselines share: rounding their constants, and a design without gains.

use std::sync::Arc;

use super::window::resolution_warnings;
use crate::diagnostic::Diagnostic;
use crate::estimator::Design;
use crate::estimator::baseline::Baseline;
use crate::plant::Plant;
use crate::promise::{Certificate, Convergence};
use crate::real::{Precision, Real};
use crate::sampled::settle::{Numerics, rising};
use crate::sampled::settled::Settled;

/// Constants after their one rounding.
pub(super) struct Settling {
    /// `None` marks an exact zero.
    pub(super) constants: Vec<Option<Settled>>,
    pub(super) numerics: Numerics,
}

/// Rounds constants of different units once.
///
/// # Errors
/// What `run` reports, or that they do not settle.
pub(super) fn settle(
    plant: &Plant,
    run: &dyn Fn(Precision) -> Result<Vec<Real>, Vec<Diagnostic>>,
) -> Result<Settling, Vec<Diagnostic>> {
    let (constants, _, numerics) =
        rising(plant, run, |pass, coarse: &Vec<Real>, fine: &Vec<Real>| pass.each(coarse, fine), |_| 0.0)?;
    Ok(Settling { constants, numerics: Numerics { condition: 1.0, ..numerics } })
}

/// The design of a formula: its name and one line, how and from which call on it has converged, what it says of itself.
pub(super) fn design(
    plant: &Plant,
    (method, summary): (&'static str, String),
    (convergence, valid): (Convergence, usize),
    notes: Vec<String>,
    shape: Baseline,
    numerics: Numerics,
) -> Design {
    Design {
        method,
        realization: shape.realization(),
        summary,
        window_steps: shape.steps(),
        valid_from_step: valid,
        convergence,
        realizations: Vec::new(),
        notes,
        constants: Vec::new(),
        fir: None,
        certificate: Certificate::default(),
        numerics,
        warnings: resolution_warnings(plant),
        longer: Vec::new(),
        phases: Vec::new(),
        estimator: Arc::new(shape),
    }
}
