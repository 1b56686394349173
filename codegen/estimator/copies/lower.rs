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
//! **Turns.** See `turn`.
//!
//! **Every g-th call.** Calls 0, g, 2g … are measured, whatever happens in between. Between them the prediction is
//! part of the observer; it is kept within the output's range, where the output itself is.

mod cells;
mod copies;
mod count;
mod given;
mod sample;
mod turn;

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Program, Value};
use crate::promise::Certificate;
use crate::sampled::settled::round;
use crate::sampled::weights::{self, products, push_products};
use crate::step::ahead::Ahead;
use crate::step::injections;
use crate::step::reading::Reading;
use crate::step::report::{self, Moved, start};
use crate::step::sensors::{self, Sensors};

use super::guard::Bounds;
use super::{Impulsive, Update};
use cells::Cells;
use turn::Turned;

/// Lowers a design for its plant; constants that the target's floats cannot hold are reported.
pub fn lower(
    plant: &Plant,
    design: &Impulsive,
    ahead: Option<&Ahead>,
    promised: &Certificate,
) -> Result<Program, Vec<Diagnostic>> {
    let (bounds, guard) = Bounds::new(plant, design)?;
    injections::check(plant)?;
    let mut builder = Builder::new(&plant.name, plant.scalar, round(&plant.sample_time.0, plant.scalar));
    let trust = plant.init_at.then(|| given::trust(plant, design, promised));
    let (cells, sensors) = cells::declare(&mut builder, plant, design, (guard, trust));
    sensors::declare(&mut builder, plant);
    let mut lowering = Lowering { plant, design, bounds, builder, cells, sensors, ahead };
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
    sensors: Sensors<'a>,
    /// How the answer is moved.
    ahead: Option<&'a Ahead>,
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
        let reading = self.read();
        let copies = self.carry(&reading);
        let counted = self.count(&reading, &copies);
        let given = self.runs_given(&reading, &copies, &counted);
        let (outputs, first) = self.store(&reading, &copies, (counted.starting, given));
        let counted = self.with_given(counted, given);
        self.report(&reading, (&outputs, &first), &counted);
    }

    /// The terms of one row of an update from the values by age: outputs and knowns, from an age on.
    fn row_terms(
        &mut self,
        update: &Update,
        row: usize,
        copy: &[Value],
        (outputs, knowns): (&[Vec<Value>], &[Vec<Value>]),
    ) -> Vec<Value> {
        let (mut terms, b) = (Vec::new(), &mut self.builder);
        push_products(b, &mut terms, &update.copy[row], copy);
        for (grid, values) in update.outputs.iter().zip(outputs) {
            push_products(b, &mut terms, &grid[row], values);
        }
        for (columns, values) in update.knowns.iter().zip(knowns) {
            for (column, value) in columns.iter().zip(values) {
                push_products(b, &mut terms, &column[row..=row], &[*value]);
            }
        }
        if let Some(constant) = update.constant[row] {
            terms.push(weights::constant(b, constant));
        }
        terms
    }

    /// Keeps what the next call needs; gives what stands for the outputs, and z1.
    fn store(
        &mut self,
        reading: &Reading,
        copies: &Copies,
        (starting, given): (Value, Option<given::Run>),
    ) -> (Vec<Value>, Vec<Value>) {
        self.builder.section("for the next call");
        let turned = self.after(reading, copies, (starting, given));
        for i in 0..self.design.rest.len() {
            self.builder.set(self.cells.first[i], turned.first[i]);
            self.builder.set(self.cells.second[i], turned.second[i]);
        }
        let none = self.builder.index(0);
        let phase = self.builder.select(starting, none, copies.phase);
        self.builder.set(self.cells.phase, phase);
        for (o, values) in turned.outputs.iter().enumerate() {
            self.keep(o, values);
        }
        let (b, sensors) = (&mut self.builder, &self.sensors);
        for (kept, value) in sensors.values.iter().zip(&reading.signals) {
            kept.write(b, None, *value);
        }
        sensors.count_call(b);
        if self.design.calls.every > 1 {
            let turn = self.builder.read(self.cells.turn);
            let turn = self.builder.advance(turn, cells::length(self.design.calls.every));
            self.builder.set(self.cells.turn, turn);
        }
        (turned.outputs.iter().map(|ages| ages[0]).collect(), turned.first)
    }

    /// Both copies and the outputs as they are kept: carried on, reset, or starting.
    fn after(&mut self, reading: &Reading, copies: &Copies, (starting, given): (Value, Option<given::Run>)) -> Turned {
        let gained = products(&mut self.builder, &self.design.gain, &reading.outputs);
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for (i, rest) in self.design.rest.iter().enumerate() {
            let initial = round(&self.plant.states[*rest].initial, self.plant.scalar);
            let initial = self.builder.float(initial);
            let initial = given.map_or(initial, |run| self.builder.select(run.active, copies.carried[i], initial));
            first.push(self.builder.select(starting, initial, copies.after[0][i]));
            let begin = self.builder.add(initial, gained[i]);
            second.push(self.builder.select(starting, begin, copies.after[1][i]));
        }
        let outputs = reading.outputs.iter().enumerate().map(|(o, now)| self.ages(o, *now)).collect();
        self.turned_back(Turned { outputs, first, second })
    }

    /// The estimate, or the start before convergence; and what it is worth.
    fn report(&mut self, reading: &Reading, (outputs, first): (&[Value], &[Value]), counted: &count::Counted) {
        self.builder.section("the estimate; until it has converged, the start");
        let values: Vec<Value> = outputs.iter().chain(first).copied().collect();
        let estimate = products(&mut self.builder, &self.design.back, &values);
        let mut answer = Vec::new();
        for (i, estimate) in estimate.iter().enumerate() {
            let start = start(&mut self.builder, self.plant, i, outputs);
            answer.push(self.builder.select(counted.known, *estimate, start));
        }
        let moved = self.ahead.map(|ahead| {
            let injections = self.sensors.injections(&reading.known.injections.inputs);
            Moved { ahead, injections, outputs }
        });
        report::estimates(&mut self.builder, self.plant, answer, moved, "");
        if let Some(coasted) = reading.coasted {
            report::coasted(&mut self.builder, coasted);
        }
        report::status(&mut self.builder, counted.converged, counted.clean);
    }
}
