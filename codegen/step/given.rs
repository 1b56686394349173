//! A start from a given state: what of it can be used, and what the model makes of it from call to call.
//!
//! The given state is of the call before the first step. What a number of any bits does: one that is not finite, or
//! beyond the bound that keeps every sum finite, counts as the state's own `initial`, and then nobody vouches.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value, place};
use crate::promise::vouched::Trust;
use crate::sampled::Source;
use crate::sampled::settled::round;

use super::front;
use super::injections::{Moment, Samples, initial_output};
use super::logic::all;
use super::sensors::Sensors;

/// How long a given state is what is known: a cell that is 0, or 1 while it is, or 2 where the caller vouched for it, and
/// more by the calls for which the printed bound still holds, where that ends.
#[derive(Clone, Copy)]
pub(crate) struct Running {
    cell: CellId,
    trust: Trust,
}

impl Running {
    /// Declares the cell; `until` says how long the given state is what is known.
    pub(crate) fn declare(b: &mut Builder, until: &str, trust: Trust) -> Self {
        let more = match trust {
            Trust::Always | Trust::Calls(0) => "",
            Trust::Calls(_) => ", and more by the calls in which the bound still holds",
        };
        let doc = format!("1 {until}, 2 if that was vouched for{more}");
        Self { cell: b.index_cell("given", &doc, 0), trust }
    }

    /// Whether the bound may end to hold before there is something better.
    pub(crate) fn ends(self) -> bool {
        self.trust.ends()
    }

    /// Whether the last call had nothing better.
    pub(crate) fn active(self, b: &mut Builder) -> Value {
        let (running, none) = (b.read(self.cell), b.index(0));
        b.index_less(none, running)
    }

    /// Whether the caller vouched for it.
    pub(crate) fn vouched(self, b: &mut Builder) -> Value {
        let (running, one) = (b.read(self.cell), b.index(1));
        b.index_less(one, running)
    }

    /// Whether it was vouched for, and the bound holds at this call.
    pub(crate) fn promised(self, b: &mut Builder) -> Value {
        match self.trust {
            Trust::Always => self.vouched(b),
            Trust::Calls(0) => b.boolean(false),
            Trust::Calls(_) => {
                let (running, two) = (b.read(self.cell), b.index(2));
                b.index_less(two, running)
            }
        }
    }

    /// Keeps it for the next call where it is still active.
    pub(crate) fn keep(self, b: &mut Builder, active: Value) {
        let none = b.index(0);
        let mut running = b.read(self.cell);
        if matches!(self.trust, Trust::Calls(1..)) {
            let (promised, fewer) = (self.promised(b), b.count_down(running));
            running = b.select(promised, fewer, running);
        }
        let kept = b.select(active, running, none);
        b.set(self.cell, kept);
    }

    /// In a start: trusted, where the caller vouches.
    pub(crate) fn begin(self, b: &mut Builder, vouched: Value) {
        let calls = match self.trust {
            Trust::Always => 0,
            Trust::Calls(calls) => calls,
        };
        let (one, trusted) = (b.index(1), b.index(2 + calls));
        let running = b.select(vouched, trusted, one);
        b.set(self.cell, running);
    }
}

/// The given state in a start, with `initial` for what cannot be used; and whether the caller vouches for all of it.
pub(crate) fn state(b: &mut Builder, plant: &Plant, bound: f64) -> (Vec<Value>, Value) {
    let (mut state, mut good) = (Vec::new(), vec![b.vouched()]);
    for (i, own) in plant.states.iter().enumerate() {
        let given = b.given(place(i));
        let usable = b.in_range(given, -bound, bound);
        let initial = b.float(round(&own.initial, plant.scalar));
        state.push(b.select(usable, given, initial));
        good.push(usable);
    }
    let vouched = all(b, &good);
    (turned_back(b, plant, state), vouched)
}

/// A state with the whole turns of outputs that wrap taken off, each along its direction.
pub(crate) fn turned_back(b: &mut Builder, plant: &Plant, mut state: Vec<Value>) -> Vec<Value> {
    for (o, output) in plant.outputs.iter().enumerate() {
        let Some(wrap) = &output.wrap else { continue };
        let shown = sum(b, plant, &state, o);
        let turns = front::turns(b, shown, round(&wrap.turn, plant.scalar));
        for (x, direction) in state.iter_mut().zip(&wrap.direction) {
            let size = direction.times(&wrap.turn).ok().filter(|size| !size.is_zero());
            if let Some(size) = size {
                let size = b.float(round(&size, plant.scalar));
                let whole = b.mul(turns, size);
                *x = b.sub(*x, whole);
            }
        }
    }
    state
}

/// What an output shows of a state, within its range; else what it shows of the initial one.
fn shown(b: &mut Builder, plant: &Plant, state: &[Value], output: usize, range: (f64, f64)) -> Value {
    let shown = sum(b, plant, state, output);
    let good = b.in_range(shown, range.0, range.1);
    let initial = b.float(initial_output(plant, output, plant.scalar));
    b.select(good, shown, initial)
}

/// C x of one output.
fn sum(b: &mut Builder, plant: &Plant, state: &[Value], output: usize) -> Value {
    let mut terms = Vec::new();
    for (c, x) in plant.c[output].iter().zip(state).filter(|(c, _)| !c.is_zero()) {
        let c = b.float(round(c, plant.scalar));
        terms.push(b.mul(c, *x));
    }
    b.sum(&terms)
}

/// A value within a bound of zero, else zero.
pub(crate) fn within(b: &mut Builder, value: Value, bound: f64) -> Value {
    let (sane, zero) = (b.in_range(value, -bound, bound), b.float(0.0));
    b.select(sane, value, zero)
}

/// Keeps what a given state shows, and what that makes of the nonlinear terms, as if a call had brought it; inputs are
/// zero. `slot` is that of the newest values, where they stand in windows; of an output that is `late` nothing is known.
pub(crate) fn show(
    b: &mut Builder,
    sensors: &Sensors,
    state: &[Value],
    slot: Option<Value>,
    late: impl Fn(usize) -> bool,
) {
    b.section("what it shows, and what that makes of the nonlinear terms");
    let mut outputs = Vec::new();
    for (o, (range, kept)) in sensors.guard.outputs.iter().zip(&sensors.outputs).enumerate() {
        let shown = shown(b, sensors.plant, state, o, *range);
        if !late(o) {
            kept.begin(b, slot, shown);
        }
        outputs.push(shown);
    }
    let zeros: Vec<Value> = sensors.plant.inputs.iter().map(|_| b.float(0.0)).collect();
    let injections = sensors.injections(&zeros);
    for (term, kept) in sensors.terms.iter().zip(&sensors.values) {
        let (Source::Injection(k), true) = (term.source, term.of_sample) else { continue };
        let value = injections.evaluate(b, k, &Moment::Given, Samples::These(&outputs));
        let value = within(b, value, sensors.guard.bound);
        kept.begin(b, slot, value);
    }
}
