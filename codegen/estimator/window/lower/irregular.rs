//! The estimate from the samples that are there: one pass over the window, then a small solve.
//!
//! The pass goes from the oldest row to the newest. It carries what is known to have moved the state since the
//! window's start, so that what a sample shows beyond that is the start's doing; rows without a sample count nothing.
//! Where too few samples determine the state, the model's prediction from the last estimate stands in.

mod pass;

use crate::program::{CellId, Value};
use crate::step::front;

use super::super::irregular::Irregular;
use super::normal::solve;
use super::{Lowering, Sampled};
use crate::sampled::settled::round;
use crate::sampled::weights::{constant, row};
pub(super) use pass::acted;
use pass::{Pass, column, predicted, shift};

/// What the solve keeps from call to call.
pub(super) struct Memory {
    /// Per output: 1 for a sample, 0 for none; by slot.
    pub(super) present: Vec<CellId>,
    /// Per state: the model's prediction, as far as it is known.
    pub(super) next: Vec<CellId>,
    /// Whether that prediction comes from an estimate.
    pub(super) known: CellId,
    /// Per late output: the slot of the time that its newest sample shows.
    pub(super) late: Vec<Option<CellId>>,
    /// Calls since a sample was accepted.
    pub(super) coasted: CellId,
    /// Per output whose samples come with their ages: those, over the oldest; by slot.
    pub(super) ages: Vec<Option<CellId>>,
}

/// An estimate that not every call can renew.
pub(super) struct Irregularly {
    /// Per state.
    pub(super) estimate: Vec<Value>,
    /// Whether the samples determine it.
    pub(super) enough: Value,
    /// Whether it is one.
    pub(super) usable: Value,
}

impl Lowering<'_> {
    /// The state as the model predicts it, with the signals of this call.
    pub(super) fn predicted_state(&mut self, signals: &[Value]) -> Vec<Value> {
        let Some(irregular) = &self.functional.irregular else { return Vec::new() };
        let next = self.memory().next.clone();
        let b = &mut self.builder;
        next.iter().enumerate().map(|(i, next)| predicted(b, irregular, *next, i, signals)).collect()
    }

    /// What an output shows of a state.
    pub(super) fn shown(&mut self, output: usize, state: &[Value]) -> Value {
        let Some(irregular) = &self.functional.irregular else { unreachable!("asked for by the solve") };
        row(&mut self.builder, &irregular.c[output], state)
    }

    /// The estimate, and whether it comes from samples, or at least from the model.
    pub(super) fn irregular(&mut self, irregular: &Irregular, sampled: &Sampled, full: Value) -> Irregularly {
        let (outputs, signals) = (self.sensors.outputs.clone(), self.sensors.values.clone());
        let memory = self.cells.memory.take().unwrap_or_else(|| unreachable!("declared with the solve"));
        let (scalar, len) = (self.plant.scalar, self.window());
        let plant = self.plant;
        let (present, ages) = (memory.present.as_slice(), memory.ages.as_slice());
        let pass = Pass { irregular, plant, scalar, len, outputs: &outputs, signals: &signals, present, ages };
        let passed = self.pass(&pass, sampled.newest);
        let threshold = self.plant.scalar_value(irregular.threshold);
        let b = &mut self.builder;
        b.section("the window's start from the samples that are there");
        let (start, enough) = solve(b, &passed.normal, &passed.right, threshold);
        let mut solved = Vec::new();
        for (i, response) in passed.response.iter().enumerate() {
            let free = row(b, &irregular.through[i], &start);
            solved.push(b.add(free, *response));
        }
        for ((o, wrap), moved) in pass.turning().zip(&passed.moved) {
            // Where the window's oldest slot was, seen from the newest sample.
            let newest = outputs[o].read(b, sampled.newest);
            let from = b.sub(newest, *moved);
            shift(b, scalar, wrap, &mut solved, from);
        }
        let answer = self.fall_back(&pass, &memory, sampled, (solved, enough), full);
        self.cells.memory = Some(memory);
        answer
    }

    /// The model's prediction where too few samples came; and what the next call needs for that.
    fn fall_back(
        &mut self,
        pass: &Pass,
        memory: &Memory,
        sampled: &Sampled,
        (solved, enough): (Vec<Value>, Value),
        full: Value,
    ) -> Irregularly {
        let (irregular, bound, b) = (pass.irregular, self.sensors.guard.bound, &mut self.builder);
        b.section("without enough samples, the model's prediction");
        let (none, one, zero) = (b.index(0), b.index(1), b.float(0.0));
        let known = b.read(memory.known);
        let mut usable = b.index_equal(known, one);
        let mut estimate = Vec::new();
        let mut turned: Option<Vec<Value>> = None;
        for (o, wrap) in pass.turning() {
            let n = solved.len();
            let mut state = turned.take().unwrap_or_else(|| {
                (0..n).map(|i| predicted(b, irregular, memory.next[i], i, &sampled.reading.signals)).collect()
            });
            let turn = round(&wrap.turn, pass.scalar);
            let shown = row(b, &irregular.c[o], &state);
            let turns = front::turns(b, shown, turn);
            let back = b.float(-turn);
            let back = b.mul(turns, back);
            shift(b, pass.scalar, wrap, &mut state, back);
            turned = Some(state);
        }
        for (i, solved) in solved.into_iter().enumerate() {
            let predicted = match &turned {
                Some(state) => state[i],
                None => predicted(b, irregular, memory.next[i], i, &sampled.reading.signals),
            };
            let sane = b.in_range(predicted, -bound, bound);
            usable = b.and(usable, sane);
            estimate.push(b.select(enough, solved, predicted));
        }
        let some = b.or(enough, usable);
        let usable = b.and(full, some);
        let keep = b.select(usable, one, none);
        b.set(memory.known, keep);
        for (i, cell) in memory.next.iter().enumerate() {
            let kept = row(b, &irregular.phi[i], &estimate);
            let begun = column(b, &irregular.begin, i, &sampled.reading.signals);
            let constant = irregular.constant[i].map(|entry| constant(b, entry));
            let terms: Vec<Value> = [Some(kept), begun, constant].into_iter().flatten().collect();
            let sum = b.sum(&terms);
            let sane = b.in_range(sum, -bound, bound);
            let next = b.select(sane, sum, zero);
            b.set(*cell, next);
        }
        Irregularly { estimate, enough, usable }
    }
}
