//! The impulsive observer as a Program.
//!
//! One step: look at the samples, predict those that are missing or not measured now, carry both copies on, reset
//! them when a period is full, and say how good the estimate is. All of it is branch-free.
//!
//! **Start.** At the first good sample both copies start, z1 at the states' `initial`; N calls later, with a good
//! sample at each, the first reset gives the estimate. Before that a missing sample starts the observer again, so
//! that it has converged N calls after the first of N+1 good samples in a row. Where signals run on third-order
//! polynomials the copies start two calls later, when these have their samples.
//!
//! **Missing samples.** After that the model's prediction stands in, and the observer is `Coasting` until a reset
//! whose period had a good sample at each call. It starts again when a prediction leaves the output's range, when
//! one of several outputs has been missing for a whole period while another has not, and when a reset gives what
//! no good samples could.
//!
//! **Every g-th call.** Calls 0, g, 2g … are measured, whatever happens in between. Between them the prediction is
//! part of the observer; it is kept within the output's range, where the output itself is.

mod cells;
mod copies;
mod count;
mod given;
mod sample;

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Program, Value};
use crate::sampled::settled::{Settled, round};
use crate::step::ahead::Ahead;
use crate::step::injections;
use crate::step::injections::Injections;
use crate::step::report::{self, Moved, field, start};

use super::guard::Bounds;
use super::{Grid, Impulsive, Update};
use cells::Cells;

/// Lowers a design for its plant; constants that the target's floats cannot hold are reported.
pub fn lower(plant: &Plant, design: &Impulsive, ahead: Option<&Ahead>) -> Result<Program, Vec<Diagnostic>> {
    let bounds = Bounds::new(plant, design)?;
    injections::check(plant)?;
    let mut builder = Builder::new(&plant.name, plant.scalar, round(&plant.sample_time.0, plant.scalar));
    let cells = cells::declare(&mut builder, plant, design);
    for output in &plant.outputs {
        builder.measurement(field(&output.label.name, &output.label.unit, &output.label.doc));
    }
    for input in &plant.inputs {
        builder.input(field(&input.label.name, &input.label.unit, &input.label.doc));
    }
    let mut lowering = Lowering { plant, design, bounds, builder, cells, ahead };
    lowering.step();
    lowering.init_at();
    Ok(lowering.builder.finish())
}

struct Lowering<'a> {
    plant: &'a Plant,
    design: &'a Impulsive,
    bounds: Bounds,
    builder: Builder,
    cells: Cells,
    /// How the answer is moved.
    ahead: Option<&'a Ahead>,
}

/// What is known of a call once its samples have been looked at.
struct Sampled {
    /// Whether this call is one that is measured.
    due: Value,
    /// Whether every sample of this call, as far as it is measured, was good.
    samples_good: Value,
    /// Whether everything since the last call was good.
    interval_good: Value,
    /// Whether a missing sample had no prediction.
    lost: Value,
    /// Per output: what stands for it.
    outputs: Vec<Value>,
    /// Per known: its value of this call.
    knowns: Vec<Value>,
    /// Per input: what was used.
    inputs: Vec<Value>,
    /// Calls since the newest accepted sample, where the estimate says so.
    coasted: Option<Value>,
}

/// What a call makes of the copies, and whether that can be used.
struct Copies {
    /// z1 and z2 of this call, as if nothing started again.
    after: [Vec<Value>; 2],
    /// Whether this call ends a period.
    full: Value,
    /// The phase that follows from the last call's.
    phase: Value,
    /// Whether a reset gave what no good samples can.
    wild: Value,
    /// z1 of this call without any reset.
    carried: Vec<Value>,
}

impl Lowering<'_> {
    fn step(&mut self) {
        let sampled = self.sample();
        let copies = self.carry(&sampled);
        let counted = self.count(&sampled, &copies);
        let given = self.runs_given(&sampled, &copies, &counted);
        let first = self.store(&sampled, &copies, (counted.starting, given));
        let counted = self.with_given(counted, given);
        self.report(&sampled, &first, &counted);
    }

    fn constant(&mut self, value: Settled) -> Value {
        self.builder.float(value.value(self.plant.scalar))
    }

    /// Adds weights times values to the terms of a sum.
    fn push_products(&mut self, terms: &mut Vec<Value>, weights: &[Option<Settled>], values: &[Value]) {
        for (weight, value) in weights.iter().zip(values) {
            if let Some(weight) = weight {
                let weight = self.constant(*weight);
                terms.push(self.builder.mul(weight, *value));
            }
        }
    }

    /// A grid times values.
    fn products(&mut self, grid: &Grid, values: &[Value]) -> Vec<Value> {
        let row = |row: &Vec<Option<Settled>>| {
            let mut terms = Vec::new();
            self.push_products(&mut terms, row, values);
            self.builder.sum(&terms)
        };
        grid.iter().map(row).collect()
    }

    /// The terms of one row of an update from the values by age: outputs and knowns, from an age on.
    fn row_terms(
        &mut self,
        update: &Update,
        row: usize,
        copy: &[Value],
        (outputs, knowns): (&[Vec<Value>], &[Vec<Value>]),
    ) -> Vec<Value> {
        let mut terms = Vec::new();
        self.push_products(&mut terms, &update.copy[row], copy);
        for (grid, values) in update.outputs.iter().zip(outputs) {
            self.push_products(&mut terms, &grid[row], values);
        }
        for (columns, values) in update.knowns.iter().zip(knowns) {
            for (column, value) in columns.iter().zip(values) {
                self.push_products(&mut terms, &column[row..=row], &[*value]);
            }
        }
        if let Some(constant) = update.constant[row] {
            terms.push(self.constant(constant));
        }
        terms
    }

    /// Keeps what the next call needs; gives z1.
    fn store(
        &mut self,
        sampled: &Sampled,
        copies: &Copies,
        (starting, given): (Value, Option<given::Run>),
    ) -> Vec<Value> {
        self.builder.section("for the next call");
        let gained = self.products(&self.design.gain, &sampled.outputs);
        let mut first = Vec::new();
        for (i, rest) in self.design.rest.iter().enumerate() {
            let initial = round(&self.plant.states[*rest].initial, self.plant.scalar);
            let initial = self.builder.float(initial);
            let initial = given.map_or(initial, |run| self.builder.select(run.active, copies.carried[i], initial));
            let z1 = self.builder.select(starting, initial, copies.after[0][i]);
            let begin = self.builder.add(initial, gained[i]);
            let z2 = self.builder.select(starting, begin, copies.after[1][i]);
            self.builder.set(self.cells.first[i], z1);
            self.builder.set(self.cells.second[i], z2);
            first.push(z1);
        }
        let none = self.builder.index(0);
        let phase = self.builder.select(starting, none, copies.phase);
        self.builder.set(self.cells.phase, phase);
        for (o, cells) in self.cells.outputs.clone().iter().enumerate() {
            self.shift(cells, sampled.outputs[o]);
        }
        for (s, cells) in self.cells.knowns.clone().iter().enumerate() {
            self.shift(cells, sampled.knowns[s]);
        }
        let calls = self.builder.read(self.cells.calls);
        let calls = self.builder.count_up(calls, u32::MAX);
        self.builder.set(self.cells.calls, calls);
        if self.design.calls.every > 1 {
            let turn = self.builder.read(self.cells.turn);
            let turn = self.builder.advance(turn, cells::length(self.design.calls.every));
            self.builder.set(self.cells.turn, turn);
        }
        first
    }

    /// The estimate, or the start before convergence; and what it is worth.
    fn report(&mut self, sampled: &Sampled, first: &[Value], counted: &count::Counted) {
        self.builder.section("the estimate; until it has converged, the start");
        let values: Vec<Value> = sampled.outputs.iter().chain(first).copied().collect();
        let estimate = self.products(&self.design.back, &values);
        let mut answer = Vec::new();
        for (i, estimate) in estimate.iter().enumerate() {
            let start = start(&mut self.builder, self.plant, i, &sampled.outputs);
            answer.push(self.builder.select(counted.known, *estimate, start));
        }
        let moved = self.ahead.map(|ahead| {
            let injections = Injections::new(self.plant, self.cells.calls, sampled.inputs.clone());
            Moved { ahead, injections, outputs: &sampled.outputs }
        });
        report::estimates(&mut self.builder, self.plant, answer, moved, "");
        if let Some(coasted) = sampled.coasted {
            report::coasted(&mut self.builder, coasted);
        }
        report::status(&mut self.builder, counted.converged, counted.clean);
    }
}
