//! `missing = "left-out"`: least squares over the samples that are there, solved in the step.

use std::ops::Range;
use std::sync::Arc;

use super::{Keys, METHOD, VERDICT_BITS, Weighting, constants, fir, resolution_warnings, several, time_warning};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::window::irregular::{self, Irregular, Pattern, certify};
use crate::estimator::window::realize::Wanted;
use crate::estimator::window::settle::settle;
use crate::estimator::window::solve::Choice;
use crate::numbers::{count, seconds, short, trimmed};
use crate::plant::Plant;
use crate::promise::Convergence;
use crate::real::Precision;
use crate::sampled::Signal;
use crate::sampled::model::{Between, Model, signals_between};
use crate::step::injections::needed;

/// What becomes of a missing sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Missing {
    /// The model's prediction stands in.
    Predicted,
    /// It is left out.
    LeftOut,
}

/// The key's words.
pub(super) const WORDS: [(&str, Missing); 2] = [("predicted", Missing::Predicted), ("left-out", Missing::LeftOut)];

/// The most operations of a step: 10 ms of a processor that does forty million a second.
const MOST_OPERATIONS: usize = 400_000;
/// The most of one that nobody asked for: half a millisecond of it.
const MOST_BY_DEFAULT: usize = 20_000;

impl Keys {
    /// Whether the step solves for the rows that are there: asked for, the only way, or the better one.
    pub(super) fn leaves_out(&self, plant: &Plant) -> bool {
        let irregular = plant.outputs.iter().any(|output| output.every > 1 || output.aged.is_some());
        irregular || self.missing.0 == Some(Missing::LeftOut) || !self.spared(plant).is_empty()
    }

    /// Outputs that the plant can lose, where leaving samples out is for the method to decide: the others show the state,
    /// and no nonlinear term needs it.
    pub(super) fn spared(&self, plant: &Plant) -> Vec<usize> {
        if !self.may_leave_out(plant) {
            return Vec::new();
        }
        let (steps, delays) =
            (several::steps(plant, &self.windows, &mut Vec::new()), super::delays(plant, &mut Vec::new()));
        let model = Model::new(plant, &[], Precision::bits(VERDICT_BITS));
        let (Some(steps), Some(delays), Ok(model)) = (steps, delays, model) else { return Vec::new() };
        let row = irregular::operations(plant.states.len(), delays.len(), signals_between(plant, Between::Lines).len());
        if (steps[0] + 1) * row > MOST_BY_DEFAULT {
            return Vec::new();
        }
        let pattern = Pattern::new(vec![1; delays.len()], delays);
        let spared = |o: &usize| !needed(plant, *o) && pattern.shown(&model, steps[0], Some(*o)) == plant.states.len();
        (0..plant.outputs.len()).filter(spared).collect()
    }

    /// Whether nothing is asked for that speaks for or against leaving samples out, and nothing is there that a solve
    /// cannot take.
    fn may_leave_out(&self, plant: &Plant) -> bool {
        let fits = |output: &crate::plant::Output| {
            let regular = output.every == 1 && output.aged.is_none();
            let narrow = output.counter.is_none_or(|counter| counter.bits == 16);
            regular && narrow && (output.gate.is_none() || output.delay.is_none())
        };
        let undecided = self.missing.0.is_none() && self.windows.len() == 1 && !self.fixed;
        let taken = plant.states.iter().any(|state| state.label.name == "coasted");
        undecided && !taken && plant.outputs.len() > 1 && plant.unknowns.is_empty() && plant.outputs.iter().all(fits)
    }

    /// The plant with an estimate that says how old the newest sample is.
    pub(super) fn counted(&self, mut plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        plant.coasted = true;
        match plant.states.iter().find(|state| state.label.name == "coasted") {
            None => Ok(plant),
            Some(state) => {
                let message = "`coasted` is a field of the estimate";
                let error = Diagnostic::error(codes::BAD_NAME, state.label.span.clone(), message);
                let error = error.context(self.missing.1.clone(), "calls since the newest accepted sample");
                Err(vec![error.help("another name for the state")])
            }
        }
    }

    /// The design, for samples that come as a pattern says when none is lost.
    pub(super) fn left_out(
        &self,
        plant: &Plant,
        signals: &[Signal],
        steps: usize,
        pattern: Pattern,
        condition: f64,
    ) -> Result<Design, Vec<Diagnostic>> {
        self.refuse_what_a_solve_cannot()?;
        refuse_work(plant, signals.len(), steps, &self.windows[0].span())?;
        let delays = pattern.delays().to_vec();
        let (mut functional, exact, mut numerics) = settle(plant, signals, &delays, steps, &Choice::LeastSquares)?;
        numerics.condition = condition;
        let mut irregular = irregular::design(plant, signals, steps, pattern)?;
        irregular.judge(plant, &functional, &exact, false);
        let certified = certify(plant, &functional, &irregular, &exact);
        let certified = certified.filter(|_| irregular.pivot >= 16.0 * irregular::limit(plant));
        let Some((mut certificate, phases)) = certified else {
            return Err(vec![hardly_determined(plant, &irregular, &self.windows[0].span())]);
        };
        let aged = irregular.ages.iter().any(Option::is_some);
        if aged {
            // Other times of samples may cost more.
            certificate.error_bound = vec![None; plant.states.len()];
            certificate.error_bound_without.iter_mut().flatten().for_each(|bounds| bounds.fill(None));
        }
        let phases = if phases.len() > 1 { phases } else { Vec::new() };
        let regular = phases.is_empty();
        let mut notes = notes(&irregular, phases.len(), steps);
        notes.extend(spared_note(plant, &self.spared(plant)));
        functional.irregular = Some(irregular);
        let h = plant.sample_time_s();
        let window = trimmed(seconds(steps, h));
        Ok(Design {
            method: METHOD.name,
            realization: "solve",
            summary: format!(
                "least squares over the samples that are there of the last {} ({window} s at {h} s)",
                steps + 1
            ),
            window_steps: steps,
            valid_from_step: steps,
            convergence: Convergence::Finite,
            realizations: Vec::new(),
            notes,
            constants: constants(&exact.model),
            fir: (regular && !aged).then(|| fir(plant, &functional)),
            certificate,
            numerics,
            warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
            longer: Vec::new(),
            phases,
            estimator: Arc::new(functional),
        })
    }

    /// Keys that say how a sum with constant weights is computed.
    fn refuse_what_a_solve_cannot(&self) -> Result<(), Vec<Diagnostic>> {
        let mut found = Vec::new();
        let mut refuse = |span: &Range<usize>, message: &str, help: &str| {
            let error = Diagnostic::error(codes::BAD_COMBINATION, span.clone(), message);
            found.push(error.context(self.missing.1.clone(), "the step solves for the rows that are there").help(help));
        };
        if self.missing.0 == Some(Missing::Predicted) {
            let message = "samples that come at a rate of their own cannot be predicted in between";
            refuse(&self.missing.1, message, "leave out `missing`, or `every` and `age`");
        }
        if self.weighting == Weighting::Minimax {
            let message = "minimax weights are of all samples of a window";
            refuse(&self.weights_span, message, "leave out `weights`, or write `missing = \"predicted\"`");
        }
        if self.wanted != Wanted::Auto {
            let message = "samples that are left out can be computed in one way only";
            refuse(&self.wanted_span, message, "leave out `realization`, or write `missing = \"predicted\"`");
        }
        if self.hold.0 == Between::Cubics {
            let message = "no cubic runs through samples that are left out";
            refuse(&self.hold.1, message, "leave out `hold`, or write `missing = \"predicted\"`");
        }
        if found.is_empty() { Ok(()) } else { Err(found) }
    }
}

/// Why samples are left out where nobody asked for it.
fn spared_note(plant: &Plant, spared: &[usize]) -> Option<String> {
    let names: Vec<&str> = spared.iter().map(|o| plant.outputs[*o].label.name.as_str()).collect();
    let names = names.join(" or ");
    let why = "samples are left out as the state is shown without";
    (!spared.is_empty()).then(|| format!("{why} {names}; `missing = \"predicted\"` costs less and needs every output"))
}

/// Refuses a step that does more than a small processor can.
fn refuse_work(plant: &Plant, signals: usize, steps: usize, window: &Range<usize>) -> Result<(), Vec<Diagnostic>> {
    let (n, rows) = (plant.states.len(), steps + 1);
    let row = irregular::operations(n, plant.outputs.len(), signals);
    let operations = rows * row;
    if operations <= MOST_OPERATIONS {
        return Ok(());
    }
    let message = "leaving samples out takes too many operations a call";
    let error = Diagnostic::error(codes::WINDOW_TOO_LONG, window.clone(), message)
        .label(format!("up to {operations} for {rows} samples; at most {MOST_OPERATIONS} are generated"))
        .measured(count(operations));
    let most = MOST_OPERATIONS / row;
    let help = format!("a window of at most {most} samples, a longer sample time, or `missing = \"predicted\"`");
    Err(vec![error.help(help)])
}

/// The rows are there, but rounding hides what they show.
fn hardly_determined(plant: &Plant, irregular: &Irregular, window: &Range<usize>) -> Diagnostic {
    let limit = 16.0 * irregular::limit(plant);
    Diagnostic::error(codes::WINDOW_TOO_SHORT, window.clone(), "the samples hardly determine the state")
        .label(format!(
            "smallest pivot {} of the normal equations; {} needs {}",
            short(irregular.pivot),
            plant.scalar,
            short(limit)
        ))
        .measured(irregular.pivot)
        .help("a longer window, measure more often, or `scalar = \"f64\"`")
}

/// What the header says of it.
fn notes(irregular: &Irregular, period: usize, steps: usize) -> Vec<String> {
    let mut notes = vec![
        "a missing sample is left out: with fewer samples the gains are larger, without noise the estimate is as exact"
            .to_owned(),
        "CONVERGED while the bound with samples lost holds; beyond it COASTING: the estimate of the samples that are there,"
            .to_owned(),
        "or, where they do not determine the state or hardly do, the model's prediction, the latter for three windows at most"
            .to_owned(),
    ];
    if irregular.ages.iter().any(Option::is_some) {
        notes.push("each sample counts at its own time; the gains are of samples of age 0".to_owned());
    }
    if period > 1 {
        notes.push(format!(
            "gains at the worst of {period} phases with the samples that are due, {} calls a window; `design` has each",
            steps + 1
        ));
    }
    notes
}
