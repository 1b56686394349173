//! `[observer.kalman]`: the steady Kalman filter.
//!
//! **Idea.** Of all constant gains, the one whose estimate has the smallest variance for the given white noise. It
//! takes any number of outputs and weighs them by their noise.
//!
//! **Source.** Kalman 1960; the covariance from the filter Riccati equation (Anderson and Moore 1979, 4.1), in the
//! current form `x = x- + K (y - C x-)`; noise densities over a sample by Van Loan 1978.
//!
//! **Conditions.** (C, A) observable at the sample time, noise on every output, process noise on every motion that
//! neither grows nor dies out, no delay, nonlinearities in measured states, inputs and time only.

mod rates;

use std::sync::Arc;

use super::constant::{Asked, Outputs, design, refuse};
use super::{Keyed, Method, noise};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::exact::{Exact, Law};
use crate::estimator::corrector::riccati::{Steady, steady};
use crate::estimator::{Design, corrector};
use crate::numbers::short;
use crate::plant::Plant;
use crate::real::{Matrix, Precision};
use crate::sampled::model::Model;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "kalman",
    summary: "the constant gain of the smallest variance for given noise; any number of outputs",
    source: "Kalman 1960; Anderson and Moore 1979, 4.1; noise over a sample by Van Loan 1978",
    keys: &noise::KEYS,
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: corrector::LIMITS,
    page: include_str!("kalman.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    noise: noise::Keys,
}

#[expect(clippy::unnecessary_wraps, reason = "the registry's signature")]
fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    Some(Arc::new(Keys { noise: noise::read(table) }))
}

/// Largest share of the covariance that may be left of its equation.
const RESIDUAL: f64 = 1e-30;

impl Keyed for Keys {
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse(plant, METHOD.name, Outputs::Any);
        let rates = rates::Rates::new(plant, &mut found);
        let noise = self.noise.check(plant, &mut found);
        let Some(noise) = noise.filter(|_| found.is_empty()) else { return Err(found) };
        if let Some(rates) = rates {
            return rates.design(plant, &noise);
        }
        let law = |model: &Model, p: Precision| Ok(Law::Constant(filter(plant, &noise, model, p)?.gain));
        let notes = |exact: &Exact| {
            let model = &exact.model;
            let steady = filter(plant, &noise, model, model.phi.precision())?;
            if steady.residual > RESIDUAL {
                return Err(vec![unsettled(plant, steady.residual)]);
            }
            let mut notes = noise.notes(plant);
            notes.push(deviations(plant, model, &steady));
            Ok(notes)
        };
        let outputs = plant.outputs.len();
        let what = if outputs == 1 { "one output".to_owned() } else { format!("{outputs} outputs") };
        let summary = format!("steady Kalman filter of {what}; current estimator");
        design(
            plant,
            Asked {
                method: METHOD.name,
                outputs: Outputs::Any,
                summary,
                warnings: Vec::new(),
                law: &law,
                notes: &notes,
            },
        )
    }
}

fn filter(plant: &Plant, noise: &noise::Model, model: &Model, p: Precision) -> Result<Steady, Vec<Diagnostic>> {
    steady(&model.phi, &model.c, &noise.at(plant, p)?).map_err(|failure| noise.said(plant, failure))
}

fn unsettled(plant: &Plant, residual: f64) -> Diagnostic {
    Diagnostic::error(codes::CHECK_FAILED, plant.span.clone(), "the Riccati equation is not solved to enough digits")
        .label(format!("{residual:.1e} of the covariance is left of it"))
        .measured(residual)
        .help("noise of more similar sizes, or a model without motions that hardly die out")
}

/// Standard deviations of the estimate, after the correction.
fn deviations(plant: &Plant, model: &Model, steady: &Steady) -> String {
    let updated: Matrix = &steady.predicted - &(&steady.gain * &(&model.c * &steady.predicted));
    let said = said_of(plant, &|i| updated[(i, i)].checked_sqrt().map_or(0.0, |x| x.to_f64()));
    format!("standard deviations for this noise{said}")
}

/// A number per state, with what it leaves out.
fn said_of(plant: &Plant, deviation: &dyn Fn(usize) -> f64) -> String {
    let each = plant.states.iter().enumerate().map(|(i, state)| {
        let deviation = deviation(i);
        let unit = if state.label.unit.is_empty() { String::new() } else { format!(" {}", state.label.unit) };
        format!("{} {}{unit}", state.label.name, show(deviation_digits(deviation)))
    });
    let without = if plant.injections.is_empty() { "" } else { ", without what it does through nonlinear terms" };
    format!("{without}: {}", each.collect::<Vec<_>>().join(", "))
}

/// Three digits.
fn deviation_digits(deviation: f64) -> f64 {
    short(deviation).parse().unwrap_or(deviation)
}
