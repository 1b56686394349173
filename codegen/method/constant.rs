//! What all methods with a constant gain do: refuse what the shape cannot take, build, report.

use std::sync::Arc;

use super::between;
use super::window::{constants, refuse_unknowns, resolution_warnings, time_warning, verdict};
use crate::diagnostic::Diagnostic;
use crate::estimator::Design;
use crate::estimator::corrector::design::{Built, Promise, Request, build};
use crate::estimator::corrector::exact::{Exact, Law};
use crate::estimator::corrector::{Counting, Gain, interval};
use crate::plant::Plant;
use crate::promise::NamedMatrix;
use crate::real::Precision;
use crate::sampled::model::{Model, signals};
use crate::sampled::settled::Settled;

/// How many outputs a method takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outputs {
    One,
    Any,
}

/// Something, or what stands against it.
type Found<T> = Result<T, Vec<Diagnostic>>;

/// What a method says of itself and its gain.
pub(super) struct Asked<'a> {
    pub(super) method: &'static str,
    pub(super) outputs: Outputs,
    pub(super) summary: String,
    pub(super) warnings: Vec<Diagnostic>,
    /// The gain at one precision.
    pub(super) law: &'a dyn Fn(&Model, Precision) -> Found<Law>,
    /// What the method's theory says of the design.
    pub(super) notes: &'a dyn Fn(&Exact) -> Found<Vec<String>>,
}

/// What stands against a method of this shape before its keys are read.
pub(super) fn refuse(plant: &Plant, method: &str, outputs: Outputs) -> Vec<Diagnostic> {
    let mut found = refuse_unknowns(plant, method);
    if outputs == Outputs::One {
        between::refuse_rare(plant, &mut found);
    }
    found
}

/// The design.
pub(super) fn design(plant: &Plant, asked: Asked) -> Result<Design, Vec<Diagnostic>> {
    let condition = verdict(plant, &vec![0; plant.outputs.len()], plant.states.len(), &plant.span)?;
    let one = asked.outputs == Outputs::One;
    let condition = if one { between::verdict(plant)?.unwrap_or(condition) } else { condition };
    let signals = signals(plant);
    let model = |p: Precision| Model::new(plant, &signals, p);
    let law = |model: &Model, p: Precision| Ok(((asked.law)(model, p)?, None));
    let built = build(&Request {
        plant,
        signals: signals.clone(),
        counting: Counting::NONE,
        scaled: false,
        promise: Promise::Contracted,
        model: &model,
        law: &law,
    })?;
    let Built { corrector, exact, certificate, mut numerics, convergence, .. } = built;
    numerics.condition = condition;
    let notes = (asked.notes)(&exact)?;
    let mut matrices = constants(&exact.model);
    if let Gain::Constant(gain) = &corrector.gain {
        let entry = |entry: &Option<Settled>| entry.unwrap_or_default().double;
        matrices
            .push(NamedMatrix { letter: "K", rows: gain.iter().map(|row| row.iter().map(entry).collect()).collect() });
    }
    if let Gain::Periodic(gains) = &corrector.gain {
        let rows = gains.iter().flatten().map(|row| row.iter().map(|entry| entry.double).collect());
        matrices.push(NamedMatrix { letter: "K", rows: rows.collect() });
    }
    let valid = interval::calls(plant) * corrector.valid;
    let mut warnings = asked.warnings;
    warnings.extend(time_warning(plant));
    warnings.extend(resolution_warnings(plant));
    Ok(Design {
        method: asked.method,
        realization: "recursive",
        summary: if one { between::said(plant, asked.summary) } else { asked.summary },
        window_steps: valid,
        valid_from_step: valid,
        convergence,
        realizations: Vec::new(),
        notes,
        constants: matrices,
        fir: None,
        certificate,
        numerics,
        warnings,
        longer: Vec::new(),
        phases: Vec::new(),
        estimator: Arc::new(corrector),
    })
}
