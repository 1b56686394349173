//! A start from a given state: the model runs from it, with inputs and nonlinear terms, until samples have determined
//! the estimate; the window fills meanwhile, and no way of summing it knows of the start. What an estimate has of the
//! newest sample alone, the run has too.

mod error;

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value};
use crate::promise::vouched::Trust;
use crate::sampled::carry::Carry;
use crate::step::given::{self, Running};
use crate::step::report::start;

pub(crate) use error::{taken, trust};

use super::{Lowering, Sampled, kept_len};

/// What is kept of a given state.
pub(crate) struct Given {
    /// Per state of the model's run.
    pub(crate) state: Vec<CellId>,
    /// 0, or while the model runs 1; 2 where the caller vouched.
    pub(crate) running: Running,
    /// One call of the model.
    carry: Carry,
    /// Per state: whether it is what the newest samples show.
    taken: Vec<bool>,
    /// The run of this call.
    run: Option<Run>,
}

/// The model's run at one call.
#[derive(Clone)]
struct Run {
    state: Vec<Value>,
    /// Whether it is what is known of the state.
    active: Value,
    /// Whether the caller vouched for it.
    vouched: Value,
    /// Whether the bound holds of it.
    promised: Value,
}

impl Given {
    /// Declares the cells.
    pub(crate) fn declare(b: &mut Builder, plant: &Plant, (carry, taken): (Carry, Vec<bool>), trust: Trust) -> Self {
        let state = plant.states.iter().map(|state| {
            let (name, unit) = (&state.label.name, crate::step::cells::bracketed(&state.label.unit));
            b.float_cell(&format!("given_{name}"), &format!("{name} as the model has it from a given state{unit}"), 0.0)
        });
        let state = state.collect();
        let running = Running::declare(b, "while the model runs from a given state", trust);
        Self { state, running, carry, taken, run: None }
    }
}

impl Lowering<'_> {
    /// Carries the given state to this call; before anything is stored.
    pub(crate) fn run_given(&mut self, sampled: &Sampled) {
        let Some(mut given) = self.given.take() else { return };
        self.builder.section("from the given state, until there is an estimate");
        let slot = self.builder.retreat(sampled.newest, kept_len(self.functional));
        let (sensors, b) = (self.sensors(slot), &mut self.builder);
        let signals = &sampled.reading.signals;
        let now = signals.iter().enumerate();
        let begin: Vec<Value> = now.map(|(s, now)| sensors.begun(b, s, *now)).collect();
        let before: Vec<Value> = given.state.iter().map(|cell| b.read(*cell)).collect();
        let next = given.carry.next(b, &before, (&begin, signals));
        let mut state = given::turned_back(b, self.plant, next);
        let of_samples = state.iter_mut().enumerate().filter(|(i, _)| given.taken[*i]);
        for (i, value) in of_samples {
            let mut there = b.boolean(true);
            for (output, _) in &self.plant.states[i].measured {
                there = b.and(there, sampled.reading.good[*output]);
            }
            let shown = start(b, self.plant, i, &sampled.reading.outputs);
            *value = b.select(there, shown, *value);
        }
        let mut active = given.running.active(b);
        for value in &state {
            let sane = b.in_range(*value, -self.sensors.guard.bound, self.sensors.guard.bound);
            active = b.and(active, sane);
        }
        let (vouched, promised) = (given.running.vouched(b), given.running.promised(b));
        given.run = Some(Run { state, active, vouched, promised });
        self.given = Some(given);
    }

    /// Whether the model runs from a given state, by the call before; false where none is given.
    pub(crate) fn runs_given(&mut self) -> Option<Value> {
        self.given.as_ref()?.run.as_ref().map(|run| run.active)
    }

    /// Ends the run where samples determine the estimate, and keeps it for the next call elsewhere.
    pub(crate) fn end_given(&mut self, over: Value) {
        let Some(Given { state, running, run: Some(run), .. }) = &mut self.given else { return };
        let b = &mut self.builder;
        let goes_on = b.not(over);
        run.active = b.and(run.active, goes_on);
        run.vouched = b.and(run.active, run.vouched);
        run.promised = b.and(run.active, run.promised);
        let zero = b.float(0.0);
        running.keep(b, run.active);
        for (cell, value) in state.iter().zip(&run.state) {
            let kept = b.select(run.active, *value, zero);
            b.set(*cell, kept);
        }
    }

    /// The model's run in the place of an estimate, while it is what is known.
    pub(super) fn or_given(&mut self, state: usize, estimate: Value) -> Value {
        let Some(Given { run: Some(run), .. }) = &self.given else { return estimate };
        self.builder.select(run.active, run.state[state], estimate)
    }

    /// Whether the estimate has converged, by samples or by the caller's word.
    pub(super) fn or_vouched(&mut self, determined: Value) -> Value {
        let Some(Given { run: Some(run), .. }) = &self.given else { return determined };
        self.builder.or(determined, run.vouched)
    }

    /// Whether the bound holds of the estimate, where it comes from samples if it is `renewed`; none where that is so
    /// whenever there is one.
    pub(super) fn or_promised(&mut self, renewed: Option<Value>, determined: Value) -> Option<Value> {
        let Some(Given { running, run: Some(run), .. }) = &self.given else { return renewed };
        let renewed = renewed.or_else(|| running.ends().then_some(determined))?;
        // Samples may determine a state before the window is full, and the run be what is answered.
        let answered = self.builder.not(run.active);
        let renewed = self.builder.and(answered, renewed);
        Some(self.builder.or(renewed, run.promised))
    }

    /// Writes the start from a given state, where there is one; `more` adds what a method keeps besides.
    pub(crate) fn init_at(&mut self, more: impl FnOnce(&mut Builder, &[Value])) {
        let Self { plant, functional, builder, sensors, given: Some(given), .. } = self else { return };
        let (plant, bound) = (*plant, sensors.guard.bound);
        builder.init_at(|b| {
            b.section("the given state");
            let (state, vouched) = given::state(b, plant, bound);
            for (cell, value) in given.state.iter().zip(&state) {
                b.set(*cell, *value);
            }
            given.running.begin(b, vouched);
            let slot = b.index(kept_len(functional) - 1);
            // What arrives late was sampled before.
            given::show(b, sensors, &state, Some(slot), |o| functional.delays[o] > 0);
            more(b, &state);
        });
    }
}
