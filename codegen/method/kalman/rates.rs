//! The Kalman filter of outputs at several rates.

use super::super::constant::{Asked, Outputs, design};
use super::super::noise;
use super::{METHOD, RESIDUAL, said_of, unsettled};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::corrector::exact::{Exact, Law};
use crate::estimator::corrector::periodic::{Periodic, cycle, periodic};
use crate::numbers::count;
use crate::plant::Plant;
use crate::real::Precision;
use crate::sampled::model::Model;

/// The most calls of a cycle.
const MOST_CALLS: usize = 1_000;
/// Numbers of a table that is written out, at most.
const MOST_NUMBERS: usize = 65_536;

/// What the outputs' rates make together.
pub(super) struct Rates {
    every: Vec<usize>,
    calls: usize,
}

impl Rates {
    /// Of a plant with an output that is not due at every call; what stands against them is collected.
    pub(super) fn new(plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Self> {
        let slowest = plant.outputs.iter().filter(|output| output.every > 1).max_by_key(|output| output.every)?;
        let every: Vec<usize> = plant.outputs.iter().map(|output| output.every).collect();
        let most = MOST_CALLS.min(MOST_NUMBERS / (plant.states.len() * plant.outputs.len()));
        let Some(calls) = cycle(&every, most) else {
            let message = "the outputs come together too rarely for a table of gains";
            let error = Diagnostic::error(codes::TOO_LARGE, slowest.every_span.clone(), message);
            let error = error.label(format!("less than every {most} calls")).measured(count(most));
            found.push(error.help("rates that are multiples of each other"));
            return None;
        };
        Some(Self { every, calls })
    }

    /// The design.
    pub(super) fn design(&self, plant: &Plant, noise: &noise::Model) -> Result<Design, Vec<Diagnostic>> {
        let law = |model: &Model, p: Precision| Ok(Law::Periodic(self.filter(plant, noise, model, p)?.gains));
        let notes = |exact: &Exact| {
            let model = &exact.model;
            let found = self.filter(plant, noise, model, model.phi.precision())?;
            if found.residual > RESIDUAL {
                return Err(vec![unsettled(plant, found.residual)]);
            }
            let mut notes = noise.notes(plant);
            let largest = |i: usize| {
                let each = found.updated.iter().map(|p| p[(i, i)].checked_sqrt().map_or(0.0, |x| x.to_f64()));
                each.fold(0.0, f64::max)
            };
            notes.push(format!("largest standard deviations for this noise{}", said_of(plant, &largest)));
            Ok(notes)
        };
        let outputs = plant.outputs.iter().map(|output| match output.every {
            1 => format!("{} at every call", output.label.name),
            every => format!("{} at every {every} calls", output.label.name),
        });
        let outputs: Vec<String> = outputs.collect();
        let summary = format!(
            "Kalman filter of {}; {} gains, from the call on at which all are due; current estimator",
            outputs.join(", "),
            self.calls
        );
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

    fn filter(
        &self,
        plant: &Plant,
        noise: &noise::Model,
        model: &Model,
        p: Precision,
    ) -> Result<Periodic, Vec<Diagnostic>> {
        let found = periodic(&model.phi, &model.c, &noise.at(plant, p)?, &self.every, self.calls);
        found.map_err(|failure| noise.said(plant, failure))
    }
}
