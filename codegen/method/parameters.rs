//! `[observer.parameters]`: the state and unknown constants together, from the last `window` seconds.
//!
//! **Idea.** `x' = A x + ... + sum_i eps_i gamma_i` with unknown constants eps_i. The samples of a window are
//! linear equations in the state at its start and in the eps_i; solved together by least squares they
//! give both, exactly, after N+1 samples.
//!
//! **Source.** 002 (mazenc-malisoff-2022-parameters-and-states), Theorems 1, 2 and 3, which find the eps_i
//! in a second stage from the state's first; `form = "joint"` is one stage (window-observers, section 2:
//! one Gramian of the plant and its exosystem contains everything, kappa is minus its off-diagonal
//! block), needs no Assumption 2, takes any number of outputs and unknowns and half the time.
//!
//! **Conditions.** (A, C) observable; the Schur complement of the joint Gramian not singular
//! (`parameters/identifiable.rs`).

use std::sync::Arc;

use super::window::{constants, delays, fir, refuse_long_delays, resolution_warnings, steps, time_warning, verdict};
use super::{Keyed, Method};
use crate::design::{Convergence, Design, Shape};
use crate::diagnostic::{Diagnostic, codes};
use crate::parameters::augment::{augmented, varying, without};
use crate::parameters::identifiable;
use crate::plant::Plant;
use crate::spec::Quantity;
use crate::spec::reader::Table;
use crate::window::certificate::certify;
use crate::window::model::signals;
use crate::window::settle::settle;
use crate::window::solve::Choice;
use crate::window::{refuse_much_work, seconds, trimmed};

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "parameters",
    summary: "the state and unknown constants together, over the last N+1 samples",
    source: "Mazenc and Malisoff 2022 (parameters and states), Theorems 1, 2, 3, made exact for samples",
    keys: &[
        ("window", "s", "length of the window, a whole number of samples"),
        ("realization", "\"auto\" | \"fir\"", "how the step computes it"),
    ],
    realizations: &[("fir", "one weighted sum over the stored samples; no state that can drift")],
    page: include_str!("parameters.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    window: Quantity,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let window = table.quantity("window");
    if window.is_none() && !table.has("window") {
        table.missing(
            "window",
            "write `window = …`, the length in seconds; the deadline by which the estimate is exact",
        );
    }
    table.choice("realization", &[("auto", ()), ("fir", ())], ());
    Some(Arc::new(Keys { window: window? }))
}

impl Keyed for Keys {
    fn observed(&self, plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        if plant.unknowns.is_empty() {
            let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), "there is no unknown to estimate");
            return Err(vec![error.help("declare it under [unknowns], or use the method `window`")]);
        }
        Ok(augmented(plant))
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let steps = steps(&self.window, plant, &mut found);
        let delays = delays(plant, &mut found);
        let (Some(steps), Some(delays)) = (steps, delays) else { return Err(found) };
        let span = self.window.span();
        refuse_long_delays(plant, &delays, steps, &span, &mut found);
        refuse_much_work(plant, steps, &span, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let every: Vec<usize> = (0..plant.unknowns.len()).collect();
        verdict(&without(plant, &every), &delays, steps, &span)?;
        let base = without(plant, &varying(plant));
        identifiable::check(&base, &delays)?;
        let condition = verdict(&base, &delays, steps, &span)?;
        let (functional, exact, mut numerics) = settle(plant, &signals(plant), &delays, steps, &Choice::LeastSquares)?;
        numerics.condition = condition;
        let certificate = certify(plant, &functional, &exact);
        Ok(Design {
            method: METHOD.name,
            realization: "fir",
            summary: summary(plant, steps),
            window_steps: steps,
            valid_from_step: steps,
            convergence: Convergence::Finite,
            realizations: Vec::new(),
            notes: Vec::new(),
            constants: constants(&exact.model),
            fir: Some(fir(plant, &functional)),
            certificate,
            numerics,
            warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
            shape: Shape::Window(functional),
        })
    }
}

fn summary(plant: &Plant, steps: usize) -> String {
    let h = plant.sample_time_s();
    format!(
        "joint least squares for states and unknowns over the last {} samples ({} s at {h} s), stateless",
        steps + 1,
        trimmed(seconds(steps, h))
    )
}
