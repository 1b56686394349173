//! A window functional as a Program.
//!
//! One step: look at the samples, predict those that are missing, evaluate the injections, store
//! everything in rings by slot, sum over the window, and keep what the next prediction needs. All
//! of it is branch-free, so that the worst case is every case.
//!
//! No input makes the state non-finite: a sample enters a ring only if it is within [`Guard`]'s
//! bound, chosen such that no sum over the window and no prediction can overflow.

mod guard;
mod injections;
mod sums;

use crate::design::Settled;
use crate::diagnostic::Diagnostic;
use crate::plant::{Hold, Plant};
use crate::program::builder::Builder;
use crate::program::{CellId, Field, Program, Status, Value};

use super::{Functional, Part, Source};
use guard::Guard;
use injections::{Injections, Moment};

/// Lowers a functional for its plant; constants that the target's floats cannot hold are reported.
pub fn lower(plant: &Plant, functional: &Functional) -> Result<Program, Vec<Diagnostic>> {
    let guard = Guard::new(plant, functional)?;
    injections::check(plant)?;
    let mut lowering = Lowering::new(plant, functional, guard);
    lowering.step();
    Ok(lowering.builder.finish())
}

/// The cells of a window method.
struct Cells {
    /// Per output: samples by slot.
    outputs: Vec<CellId>,
    /// Per signal: values by slot.
    signals: Vec<CellId>,
    /// Per input: the last good value, where no ring holds it.
    inputs: Vec<CellId>,
    /// Slot of age 0.
    newest: CellId,
    /// Good samples in a row, at most N+1.
    count: CellId,
    /// Calls until no replaced sample is in the window.
    coasting: CellId,
    /// Per output: the next measurement, as far as it is known; by slot for a late one.
    ahead: Vec<CellId>,
    /// Per late output: slot in the ring above.
    late: Vec<Option<CellId>>,
    /// Calls since init.
    calls: CellId,
}

/// What the first half of a step finds out.
struct Sampled {
    /// Slot of age 0.
    newest: Value,
    /// Whether everything sampled now was good.
    samples_good: Value,
    /// Whether everything since the last call was good.
    interval_good: Value,
    /// Whether what was sampled now and is of now was good.
    newest_good: Value,
    /// Late outputs, and whether they were good.
    late: Vec<(usize, Value)>,
    /// Whether a missing sample had no prediction.
    lost: Value,
    /// Per output: what enters the window.
    outputs: Vec<Value>,
    /// Per signal: what enters the window.
    signals: Vec<Value>,
}

struct Lowering<'a> {
    plant: &'a Plant,
    functional: &'a Functional,
    guard: Guard,
    builder: Builder,
    cells: Cells,
}

impl<'a> Lowering<'a> {
    fn new(plant: &'a Plant, functional: &'a Functional, guard: Guard) -> Self {
        let mut builder = Builder::new(&plant.name, plant.scalar, functional_sample_time(plant));
        let cells = declare(&mut builder, plant, functional);
        for output in &plant.outputs {
            builder.measurement(field(&output.label.name, &output.label.unit, &output.label.doc));
        }
        for input in &plant.inputs {
            builder.input(field(&input.label.name, &input.label.unit, &input.label.doc));
        }
        Self { plant, functional, guard, builder, cells }
    }

    fn constant(&mut self, value: Settled) -> Value {
        self.builder.float(value.value(self.plant.scalar))
    }

    fn step(&mut self) {
        let sampled = self.sample();
        let count = self.count(&sampled);
        self.store(&sampled);
        let estimate = sums::estimate(&mut self.builder, self.plant, self.functional, &self.cells.outputs, &self.cells.signals, sampled.newest);
        self.look_ahead(&estimate, &sampled);
        self.report(&estimate, &sampled, count);
    }

    /// Reads, guards, predicts and evaluates.
    fn sample(&mut self) -> Sampled {
        let window = self.window();
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let newest_before = self.builder.read(self.cells.newest);
        let newest_before = self.builder.at_most(newest_before, window - 1);
        let count_before = self.builder.read(self.cells.count);
        let full = self.builder.index(window);
        let converged = self.builder.index_equal(count_before, full);
        let (measured, output_good): (Vec<Value>, Vec<Value>) = (0..self.plant.outputs.len()).map(|o| self.read_output(o)).unzip();
        let inputs = self.read_inputs(newest_before);
        let mut interval_good = Vec::new();
        let (late, now): (Vec<_>, Vec<_>) =
            output_good.iter().copied().enumerate().partition(|(o, _)| self.functional.delays[*o] > 0);
        let mut newest_good: Vec<Value> = now.into_iter().map(|(_, good)| good).collect();
        for (input, (_, good)) in self.plant.inputs.iter().zip(&inputs) {
            if input.hold == Hold::Zero { interval_good.push(*good) } else { newest_good.push(*good) }
        }
        let inputs: Vec<Value> = inputs.into_iter().map(|(value, _)| value).collect();

        self.builder.section("prediction, for a sample that is missing");
        let newest = self.builder.advance(newest_before, window);
        let mut injections = Injections::new(self.plant, self.cells.calls, inputs.clone());
        let mut signals: Vec<Option<Value>> = vec![None; self.functional.signals.len()];
        for s in 0..signals.len() {
            let part = self.functional.signals[s].part;
            if matches!(part, Part::Held | Part::Start) || matches!(self.functional.signals[s].source, Source::Input(_)) {
                let moment = if part == Part::Start { Moment::Before(newest_before) } else { Moment::Now };
                let (value, good) = self.signal(s, &mut injections, &moment, newest_before, &[]);
                interval_good.extend(good);
                signals[s] = Some(value);
            }
        }
        let predicted: Vec<Value> = (0..measured.len()).map(|o| self.predict(o, &signals)).collect();
        let candidates: Vec<Value> = (0..measured.len())
            .map(|o| {
                let last = self.builder.read_ring(self.cells.outputs[o], newest_before);
                let instead = self.builder.select(converged, predicted[o], last);
                self.builder.select(output_good[o], measured[o], instead)
            })
            .collect();
        for s in 0..signals.len() {
            if signals[s].is_none() {
                let (value, good) = self.signal(s, &mut injections, &Moment::Now, newest_before, &candidates);
                if self.functional.signals[s].part == Part::Runs {
                    newest_good.extend(good);
                } else {
                    interval_good.extend(good);
                }
                signals[s] = Some(value);
            }
        }
        let signals: Vec<Value> = signals.into_iter().flatten().collect();
        let mut lost = Vec::new();
        let outputs = (0..measured.len())
            .map(|o| {
                let refined = self.refine(o, predicted[o], &signals, newest_before);
                let (low, high) = self.guard.outputs[o];
                let sane = self.builder.in_range(refined, low, high);
                let usable = self.builder.and(converged, sane);
                let last = self.builder.read_ring(self.cells.outputs[o], newest_before);
                let instead = self.builder.select(usable, refined, last);
                let covered = self.builder.or(output_good[o], sane);
                lost.push(self.builder.not(covered));
                self.builder.select(output_good[o], measured[o], instead)
            })
            .collect();
        let newest_good = self.all(&newest_good);
        let samples_good = late.iter().fold(newest_good, |all, (_, good)| self.builder.and(all, *good));
        let interval_good = self.all(&interval_good);
        let lost = self.any(&lost);
        Sampled { newest, samples_good, interval_good, newest_good, late, lost, outputs, signals }
    }

    /// N+1.
    fn window(&self) -> u32 {
        u32::try_from(self.functional.steps + 1).unwrap_or_else(|_| unreachable!("the window's length is bounded"))
    }

    fn all(&mut self, values: &[Value]) -> Value {
        let first = self.builder.boolean(true);
        values.iter().fold(first, |sum, value| self.builder.and(sum, *value))
    }

    fn any(&mut self, values: &[Value]) -> Value {
        let first = self.builder.boolean(false);
        values.iter().fold(first, |sum, value| self.builder.or(sum, *value))
    }

    fn read_output(&mut self, output: usize) -> (Value, Value) {
        let value = self.builder.read_measurement(place(output));
        let (low, high) = self.guard.outputs[output];
        (value, self.builder.in_range(value, low, high))
    }

    /// Each input, with the last good value in place of a bad one.
    fn read_inputs(&mut self, newest_before: Value) -> Vec<(Value, Value)> {
        (0..self.plant.inputs.len())
            .map(|u| {
                let value = self.builder.read_input(place(u));
                let good = self.builder.in_range(value, -self.guard.bound, self.guard.bound);
                let ring = self.functional.signals.iter().position(|s| s.source == Source::Input(u));
                let last = match ring {
                    Some(s) => self.builder.read_ring(self.cells.signals[s], newest_before),
                    None => self.builder.read(self.cells.inputs[u]),
                };
                let used = self.builder.select(good, value, last);
                if ring.is_none() {
                    self.builder.set(self.cells.inputs[u], used);
                }
                (used, good)
            })
            .collect()
    }

    /// The value of a signal, with the last good one in place of a bad one, and whether it was good.
    fn signal(
        &mut self,
        s: usize,
        injections: &mut Injections,
        moment: &Moment,
        newest_before: Value,
        outputs: &[Value],
    ) -> (Value, Option<Value>) {
        let k = match self.functional.signals[s].source {
            Source::Input(u) => return (injections.inputs[u], None),
            Source::Injection(k) => k,
        };
        let value = injections.evaluate(&mut self.builder, k, moment, outputs, &self.cells.outputs);
        if !self.guard.injections[k] {
            return (value, None);
        }
        let good = self.builder.in_range(value, -self.guard.bound, self.guard.bound);
        let last = self.builder.read_ring(self.cells.signals[s], newest_before);
        (self.builder.select(good, value, last), Some(good))
    }

    /// What an output should measure now, with the signals that are known before the sample is.
    fn predict(&mut self, output: usize, signals: &[Option<Value>]) -> Value {
        if let Some(slot) = self.cells.late[output] {
            let slot = self.builder.read(slot);
            let slot = self.builder.at_most(slot, late_len(self.functional, output) - 1);
            return self.builder.read_ring(self.cells.ahead[output], slot);
        }
        let mut sum = self.builder.read(self.cells.ahead[output]);
        for (s, value) in signals.iter().enumerate() {
            let prediction = &self.functional.prediction[output];
            let weight = match self.functional.signals[s].part {
                // For a start also its end's share, as long as the end is not known.
                Part::Held | Part::Start => prediction.held[s],
                Part::Runs | Part::End => None,
            };
            if let (Some(value), Some(weight)) = (value, weight) {
                sum = self.add_product(sum, weight, *value);
            }
        }
        sum
    }

    fn add_product(&mut self, sum: Value, weight: Settled, value: Value) -> Value {
        let weight = self.constant(weight);
        let product = self.builder.mul(weight, value);
        self.builder.add(sum, product)
    }

    /// The prediction once the signals that run between samples are known at both ends.
    fn refine(&mut self, output: usize, predicted: Value, signals: &[Value], newest_before: Value) -> Value {
        let mut sum = predicted;
        for (s, signal) in self.functional.signals.iter().enumerate() {
            let begin = match signal.part {
                Part::Runs => self.builder.read_ring(self.cells.signals[s], newest_before),
                Part::End => signals[s - 1],
                Part::Held | Part::Start => continue,
            };
            if let Some(weight) = self.functional.prediction[output].end[s] {
                let rise = self.builder.sub(signals[s], begin);
                sum = self.add_product(sum, weight, rise);
            }
        }
        sum
    }

    /// Good samples in a row, or how the window starts again.
    fn count(&mut self, sampled: &Sampled) -> Value {
        let window = self.window();
        self.builder.section("how much of the window is good");
        let before = self.builder.read(self.cells.count);
        let full = self.builder.index(window);
        let converged = self.builder.index_equal(before, full);
        let (none, one) = (self.builder.index(0), self.builder.index(1));
        let more = self.builder.count_up(before, window);
        let kept = self.builder.select(sampled.lost, none, full);
        let grown = self.builder.select(sampled.interval_good, more, one);
        let growing = self.builder.select(sampled.samples_good, grown, none);
        let count = self.builder.select(converged, kept, growing);
        self.builder.set(self.cells.count, count);
        self.coast(sampled);
        count
    }

    /// Calls until no replaced sample is in the window.
    fn coast(&mut self, sampled: &Sampled) {
        let window = self.window();
        let before = self.builder.read(self.cells.coasting);
        let mut coasting = self.builder.count_down(before);
        let interval = self.builder.index(window - 1);
        coasting = self.builder.select(sampled.interval_good, coasting, interval);
        for (o, good) in &sampled.late {
            // A late sample leaves the window earlier.
            let stays = window - late_len(self.functional, *o);
            let stays = self.builder.index(stays);
            let longer = self.builder.index_less(coasting, stays);
            let raised = self.builder.select(longer, stays, coasting);
            coasting = self.builder.select(*good, coasting, raised);
        }
        let stays = self.builder.index(window);
        coasting = self.builder.select(sampled.newest_good, coasting, stays);
        self.builder.set(self.cells.coasting, coasting);
    }

    fn store(&mut self, sampled: &Sampled) {
        self.builder.section("into the window");
        self.builder.set(self.cells.newest, sampled.newest);
        for (ring, value) in self.cells.outputs.iter().zip(&sampled.outputs) {
            self.builder.set_ring(*ring, sampled.newest, *value);
        }
        for (ring, value) in self.cells.signals.iter().zip(&sampled.signals) {
            self.builder.set_ring(*ring, sampled.newest, *value);
        }
        let calls = self.builder.read(self.cells.calls);
        let calls = self.builder.count_up(calls, u32::MAX);
        self.builder.set(self.cells.calls, calls);
    }

    /// Keeps what the next prediction needs.
    fn look_ahead(&mut self, estimate: &[Value], sampled: &Sampled) {
        self.builder.section("the next measurement, as far as it is known");
        for o in 0..self.plant.outputs.len() {
            let prediction = self.functional.prediction[o].clone();
            let mut terms = Vec::new();
            for (weight, state) in prediction.states.iter().zip(estimate) {
                if let Some(weight) = weight {
                    let weight = self.constant(*weight);
                    terms.push(self.builder.mul(weight, *state));
                }
            }
            for (s, signal) in self.functional.signals.iter().enumerate() {
                if let (Part::Runs, Some(weight)) = (signal.part, prediction.held[s]) {
                    let weight = self.constant(weight);
                    terms.push(self.builder.mul(weight, sampled.signals[s]));
                }
            }
            if prediction.constant != Settled::default() {
                terms.push(self.constant(prediction.constant));
            }
            let sum = self.builder.sum(&terms);
            if let Some(slot) = self.cells.late[o] {
                let len = late_len(self.functional, o);
                let before = self.builder.read(slot);
                let before = self.builder.at_most(before, len - 1);
                self.builder.set_ring(self.cells.ahead[o], before, sum);
                let after = self.builder.advance(before, len);
                self.builder.set(slot, after);
            } else {
                self.builder.set(self.cells.ahead[o], sum);
            }
        }
    }

    /// The estimate, or the start while the window is not full.
    fn report(&mut self, estimate: &[Value], sampled: &Sampled, count: Value) {
        self.builder.section("the estimate; until the window is full, the start");
        let full = self.builder.index(self.window());
        let converged = self.builder.index_equal(count, full);
        for (i, state) in self.plant.states.iter().enumerate() {
            let start = self.start(i, sampled);
            let value = self.builder.select(converged, estimate[i], start);
            self.builder.estimate(field(&state.label.name, &state.label.unit, &state.label.doc), value);
        }
        let coasting = self.builder.read(self.cells.coasting);
        let none = self.builder.index(0);
        let clean = self.builder.index_equal(coasting, none);
        let statuses = [Status::Converged, Status::Coasting, Status::Converging].map(|s| self.builder.status(s));
        let working = self.builder.select(clean, statuses[0], statuses[1]);
        let status = self.builder.select(converged, working, statuses[2]);
        self.builder.report(status);
    }

    /// Measured states from the newest sample, the others their `initial`.
    fn start(&mut self, state: usize, sampled: &Sampled) -> Value {
        let state = &self.plant.states[state];
        if state.measured.is_empty() {
            let initial = injections::round(&state.initial, self.plant.scalar);
            return self.builder.float(initial);
        }
        let mut terms = Vec::new();
        for (output, weight) in &state.measured {
            let weight = injections::round(weight, self.plant.scalar);
            let weight = self.builder.float(weight);
            terms.push(self.builder.mul(weight, sampled.outputs[*output]));
        }
        self.builder.sum(&terms)
    }
}

/// Samples that a late output's predictions wait for.
fn late_len(functional: &Functional, output: usize) -> u32 {
    u32::try_from(functional.delays[output]).unwrap_or_else(|_| unreachable!("delays are bounded"))
}

fn declare(builder: &mut Builder, plant: &Plant, functional: &Functional) -> Cells {
    let window = u32::try_from(functional.steps + 1).unwrap_or_else(|_| unreachable!("the window's length is bounded"));
    let scalar = plant.scalar;
    let outputs = plant.outputs.iter().enumerate().map(|(o, output)| {
        let doc = format!("samples of {} by slot{}", output.label.name, bracketed(&output.label.unit));
        builder.ring(&output.label.name, &doc, window, injections::initial_output(plant, o, scalar))
    });
    let outputs = outputs.collect();
    let signals = functional.signals.iter().map(|signal| {
        builder.ring(&identifier(&signal.text), &format!("{} by slot", signal.text), window, 0.0)
    });
    let signals = signals.collect();
    let inputs = plant.inputs.iter().map(|input| {
        builder.float_cell(&format!("last_{}", input.label.name), "the last good value", 0.0)
    });
    let inputs = inputs.collect();
    let newest = builder.index_cell("newest", "slot of age 0", window - 1);
    let count = builder.index_cell("count", &format!("good samples in a row, at most {window}"), 0);
    let coasting = builder.index_cell("coasting", "calls until no replaced sample is in the window", 0);
    let mut ahead = Vec::new();
    let mut late = Vec::new();
    for (o, output) in plant.outputs.iter().enumerate() {
        let name = &output.label.name;
        if functional.delays[o] == 0 {
            ahead.push(builder.float_cell(&format!("ahead_{name}"), &format!("the next {name}, as far as it is known"), 0.0));
            late.push(None);
        } else {
            let len = late_len(functional, o);
            ahead.push(builder.ring(&format!("ahead_{name}"), &format!("{name} as it will arrive, by slot"), len, 0.0));
            late.push(Some(builder.index_cell(&format!("ahead_{name}_slot"), "slot of the oldest of these", 0)));
        }
    }
    let calls = builder.index_cell("calls", "calls since init", 0);
    Cells { outputs, signals, inputs, newest, count, coasting, ahead, late, calls }
}

fn bracketed(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(", {unit}") }
}

/// An expression's text as a name.
fn identifier(text: &str) -> String {
    const LONGEST: usize = 32;
    let mut name = String::new();
    for c in text.chars() {
        if c.is_ascii_alphanumeric() {
            name.push(c.to_ascii_lowercase());
        } else if !name.ends_with('_') {
            name.push('_');
        }
    }
    let name = name.trim_matches('_');
    let starts_well = name.starts_with(|c: char| c.is_ascii_lowercase());
    if starts_well && name.len() <= LONGEST && crate::emit::names::reserved(name).is_none() {
        name.to_owned()
    } else {
        "injection".to_owned()
    }
}

fn field(name: &str, unit: &str, doc: &str) -> Field {
    Field { name: name.to_owned(), unit: unit.to_owned(), doc: doc.to_owned() }
}

fn place(index: usize) -> u16 {
    u16::try_from(index).unwrap_or_else(|_| unreachable!("a specification is shorter than 65536 entries"))
}

fn functional_sample_time(plant: &Plant) -> f64 {
    injections::round(&plant.sample_time.0, plant.scalar)
}
