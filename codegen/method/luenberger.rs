//! `[observer.luenberger]`: a constant gain by the poles of the error.
//!
//! **Idea.** The model runs beside the plant and is corrected by what the sample differs from its prediction; the gain
//! makes every estimation error die out like `exp(s t)` for the poles s that the user names.
//!
//! **Source.** Luenberger 1964, "Observing the state of a linear system"; the gain by Ackermann's formula, of the
//! current form (Franklin, Powell and Workman 1998, 8.2): `(I - K C) Phi` has the eigenvalues `exp(s_i h)`.
//!
//! **Conditions.** (C, A) observable with one output at the sample time, no mode that is gone within a sample, no
//! delay, nonlinearities in measured states, inputs and time only.

use std::sync::Arc;

use super::constant::{Asked, Outputs, design, refuse};
use super::poles::{self, Exact, Poles};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::interval;
use crate::estimator::corrector::placement::{Failure, Pole, gain, polynomial};
use crate::estimator::{Design, corrector};
use crate::numbers::{count, short};
use crate::plant::Plant;
use crate::real::{Precision, Undefined};
use crate::sampled::model::Model;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "luenberger",
    summary: "a constant gain, by the poles of the error",
    source: "Luenberger 1964; Ackermann's formula for the current form (Franklin, Powell and Workman, 8.2)",
    keys: &[("poles", "rad/s", "as many as states, below 0: numbers, or pairs [re, im] with their conjugates")],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: corrector::OF_ONE_OUTPUT,
    page: include_str!("luenberger.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    poles: Poles,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let poles = poles::read(table);
    if poles.is_none() && !table.has("poles") {
        table.missing("poles", "write `poles = […]`, a number in rad/s per state: minus one over its time constant");
    }
    Some(Arc::new(Keys { poles: poles? }))
}

impl Keyed for Keys {
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse(plant, METHOD.name, Outputs::One);
        let poles = self.poles.check(plant, &mut found);
        let Some(poles) = poles.filter(|_| found.is_empty()) else { return Err(found) };
        refuse_aliases(plant, &poles)?;
        let law = |model: &Model, p: Precision| placed(plant, &poles, model, p);
        let slowest = poles.iter().map(Exact::decay).fold(f64::INFINITY, f64::min);
        let summary = format!(
            "errors die out with {} poles, the slowest at {} 1/s; current estimator",
            poles.len(),
            short(-slowest)
        );
        let warnings = fast(plant, &poles);
        design(
            plant,
            Asked {
                method: METHOD.name,
                outputs: Outputs::One,
                summary,
                warnings,
                law: &law,
                notes: &|_| Ok(Vec::new()),
            },
        )
    }
}

/// K at one precision.
fn placed(plant: &Plant, poles: &[Exact], model: &Model, p: Precision) -> Result<Law, Vec<Diagnostic>> {
    let h = interval::time(plant, p).map_err(|_| no_number(plant, poles))?;
    let sampled: Result<Vec<Pole>, Undefined> = poles.iter().map(|pole| pole.at(p).sampled(&h)).collect();
    let wanted = polynomial(&sampled.map_err(|_| no_number(plant, poles))?);
    gain(&interval::transition(plant, &model.phi), &model.c, &wanted)
        .map(Law::Constant)
        .map_err(|failure| said(plant, failure))
}

fn no_number(plant: &Plant, poles: &[Exact]) -> Vec<Diagnostic> {
    let span = poles.first().map_or_else(|| plant.span.clone(), Exact::span);
    let message = "the poles are too far from 0 for numbers to hold what is left after a sample";
    vec![Diagnostic::error(codes::OUT_OF_RANGE, span, message).help("slower poles, or a shorter sample time")]
}

fn said(plant: &Plant, failure: Failure) -> Vec<Diagnostic> {
    vec![match failure {
        Failure::Outputs(outputs) => {
            let message = "poles determine the gain for one output only";
            Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message)
                .measured(count(outputs))
                .help("use `kalman` or `window`, which take any number of outputs")
        }
        Failure::Unobservable(rank) => {
            let message = "the output does not show every state";
            Diagnostic::error(codes::UNOBSERVABLE, plant.span.clone(), message)
                .label(format!("rank {rank} of {}", plant.states.len()))
                .measured(count(rank))
                .help("measure more of the plant")
        }
        Failure::Singular => {
            let message = "a motion of the plant is gone within a sample: no gain moves its pole";
            Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message)
                .label("Phi is singular")
                .measured(0.0)
                .help("leave that state out of the model, or use `kalman` or `window`")
        }
    }]
}

/// Refuses poles that turn by half a turn and more per sample: the sampled error would turn more slowly.
fn refuse_aliases(plant: &Plant, poles: &[Exact]) -> Result<(), Vec<Diagnostic>> {
    let h = interval::seconds(plant);
    let nyquist = std::f64::consts::PI / h;
    let beyond = poles.iter().find(|pole| pole.turns() >= nyquist);
    beyond.map_or(Ok(()), |pole| {
        let message = "a pole beyond half the sampling frequency";
        let error = Diagnostic::error(codes::OUT_OF_RANGE, pole.span(), message)
            .label(format!("samples {} s apart show at most {} rad/s", show(h), short(nyquist)))
            .measured(pole.turns());
        Err(vec![error.help("a smaller imaginary part, or a shorter sample time")])
    })
}

/// Warns of poles whose error is gone within a sample: the estimate then follows the noise of the newest samples.
fn fast(plant: &Plant, poles: &[Exact]) -> Vec<Diagnostic> {
    let h = interval::seconds(plant);
    let fastest = poles.iter().max_by(|a, b| a.size().total_cmp(&b.size())).filter(|pole| pole.size() * h > 1.0);
    let warning = |pole: &Exact| {
        let message = "a pole faster than the sample time";
        Diagnostic::warning(codes::NOISE, pole.span(), message)
            .label(format!("{} of its time constants per sample", short(pole.size() * h)))
            .measured(pole.size() * h)
            .help(format!(
                "poles within {} rad/s, or a shorter sample time: faster ones mostly amplify noise",
                short(1.0 / h)
            ))
    };
    fastest.map(warning).into_iter().collect()
}
