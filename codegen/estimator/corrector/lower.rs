//! A corrector as a Program.
//!
//! One step: look at the samples, predict the state, evaluate what depends on the samples of now, correct by the
//! innovation, and say how good the estimate is. All of it is branch-free.
//!
//! **Start.** The first call with a good sample of every output takes the state from it: what it shows, and `initial`
//! for the rest. The k-th good call after it has r = N - k steps left.
//!
//! **Missing samples.** Without a good sample nothing is corrected, and the countdown waits: the deadline moves by the
//! calls without one. The estimate is `Coasting` until so many good calls in a row that what is left of any error is
//! what the first convergence left. A prediction outside the output's range starts the observer again, and so does a
//! state beyond the floats' guard.
//!
//! **Two floats.** See `carried`.
//!
//! **Turns.** See `turn`.
//!
//! **Sliding.** Under the sliding law an innovation that is not explained
//! makes both counts begin again, and one wider than the output's range starts the observer again.

mod carried;
mod gain;
mod given;
mod predict;
mod turn;

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Program, Value};
use crate::sampled::Source;
use crate::sampled::settled::round;
use crate::sampled::weights::{constant, products};
use crate::step::ahead::Ahead;
use crate::step::guard::Guard;
use crate::step::kept::Kept;
use crate::step::known::Term;
use crate::step::reading::Reading;
use crate::step::report::{self, Moved, start};
use crate::step::sensors::{self, Sensors};
use crate::step::{front, gate, injections, inputs, rates};

use super::{Corrector, Frame, Gain, guard};
use carried::Carried;

/// Lowers a design for its plant; constants that the target's floats cannot hold are reported.
///
/// # Errors
/// What the guard or the injections' constants report.
pub fn lower(plant: &Plant, design: &Corrector, ahead: Option<&Ahead>) -> Result<Program, Vec<Diagnostic>> {
    let guard = guard::bound(plant, design)?;
    injections::check(plant)?;
    let mut builder = Builder::new(&plant.name, plant.scalar, round(&plant.sample_time.0, plant.scalar));
    let (cells, sensors) = Cells::declare(&mut builder, plant, design, guard);
    sensors::declare(&mut builder, plant);
    let mut lowering = Lowering { plant, design, builder, cells, sensors, due: Vec::new(), ahead };
    lowering.step();
    lowering.init_at();
    Ok(lowering.builder.finish())
}

/// The state of a corrector.
struct Cells {
    /// n.
    state: Vec<CellId>,
    /// What these leave out, where a second float carries it.
    low: Vec<Option<CellId>>,
    /// Calls of the countdown that are left.
    left: CellId,
    /// Good calls, at most one more than convergence takes.
    good: CellId,
    /// Good calls in a row, likewise.
    clean: CellId,
    /// 1 from a start by an estimate until the first good call, where there is such a start.
    given: Option<CellId>,
    /// Calls since every output was due.
    phase: CellId,
    /// Per output that is not due at every call: the calls until it is.
    due: Vec<Option<CellId>>,
}

impl Cells {
    fn declare<'a>(b: &mut Builder, plant: &'a Plant, design: &Corrector, guard: Guard) -> (Self, Sensors<'a>) {
        let scaled = matches!(design.frame, Frame::Chain { .. });
        let initial = |i: usize| round(&plant.states[i].initial, plant.scalar);
        let state = (0..plant.states.len()).map(|i| {
            let label = &plant.states[i].label;
            if scaled {
                let doc = format!("{} in the units of {}", ordinal(i), plant.outputs[0].label.name);
                return b.float_cell(&format!("xi{}", i + 1), &doc, 0.0);
            }
            b.float_cell(&label.name, &format!("{} as last estimated", label.name), initial(i))
        });
        let state: Vec<CellId> = state.collect();
        let low = carried::cells(b, plant, design);
        let lead = calls(design.counting.lead());
        let left = b.index_cell("left", "calls of the countdown that are left", lead);
        let good = b.index_cell("good", &format!("good calls, at most {}", design.valid + 1), 0);
        let clean = b.index_cell("clean", &format!("good calls in a row, at most {}", design.recovery), 0);
        let counters = sensors::counters(b, plant);
        let outputs = plant.outputs.iter().enumerate().map(|(o, output)| {
            let name = &output.label.name;
            let initial = injections::initial_output(plant, o, plant.scalar);
            Kept::Newest(b.float_cell(
                &format!("last_{name}"),
                &format!("the last {name}, measured or predicted"),
                initial,
            ))
        });
        let outputs = outputs.collect();
        let values = design.signals.iter().enumerate().map(|(s, signal)| {
            let name = match signal.source {
                Source::Input(_) => format!("last_{}", signal.text),
                Source::Injection(_) => format!("last_known{s}"),
            };
            Kept::Newest(b.float_cell(&name, &format!("{} of the last call", signal.text), 0.0))
        });
        let values = values.collect();
        let inputs = inputs::cells(b, plant);
        let calls = b.index_cell("calls", "calls since init", 0);
        let rejected = gate::cells(b, plant);
        let coasted = plant.coasted.then(|| b.index_cell("coasted", "calls since the newest accepted sample", 0));
        let phase = b.index_cell("phase", "calls since every output was due", 0);
        let due = rates::cells(b, plant);
        let given = plant.init_at.then(|| b.index_cell("given", "1 from a given state until the first good call", 0));
        let sensors = Sensors {
            plant,
            guard,
            terms: design.signals.iter().map(Term::from).collect(),
            newest: None,
            counters,
            outputs,
            values,
            inputs,
            calls,
            missed: Vec::new(),
            rejected,
            // As many as convergence takes, and one alone never.
            patience: self::calls(design.valid),
            coasted,
        };
        (Self { state, low, left, good, clean, given, phase, due }, sensors)
    }
}

/// A scaled derivative in words.
fn ordinal(i: usize) -> String {
    match i {
        0 => "the signal".to_owned(),
        _ => format!("the sample time to the power {i} times derivative {i}, in implicit Euler's coordinates,"),
    }
}

/// A number of calls as a Program has it.
fn calls(count: usize) -> u32 {
    u32::try_from(count).unwrap_or_else(|_| unreachable!("the prescribed time is bounded"))
}

struct Lowering<'a> {
    plant: &'a Plant,
    design: &'a Corrector,
    builder: Builder,
    cells: Cells,
    sensors: Sensors<'a>,
    /// Per output that is not due at every call, whether it is due now.
    due: Vec<Option<Value>>,
    /// How the answer is moved.
    ahead: Option<&'a Ahead>,
}

/// What is known of a call before it is corrected.
struct Predicted<'a> {
    reading: Reading<'a>,
    /// Whether there is a sample of every output that is due.
    measured: Value,
    /// Whether there is one of every output.
    complete: Value,
    /// Whether everything was good.
    fine: Value,
    /// z-, n; of what two floats carry, what it grows by since the last call.
    moved: Vec<Value>,
    /// z-, n.
    state: Vec<Value>,
}

impl Lowering<'_> {
    fn step(&mut self) {
        let predicted = self.predict();
        self.builder.section("correction by the innovation");
        let (innovation, lost) = self.innovation(&predicted);
        let (corrections, left) = self.correct(&innovation, self.counts(&predicted));
        let corrected = self.corrected(&predicted.moved, &corrections);
        let corrected = self.turned_back(corrected);
        self.builder.section("the first sample starts the observer; so does a state beyond all bounds");
        let again = self.starts_again(&innovation, &corrected, lost);
        let state = self.store(&predicted, &corrected, (again, left));
        let calm = self.calm(&innovation);
        let counts = self.count(&predicted, again, calm);
        self.report(&state, &predicted, counts);
    }

    /// y - C z-, within half a turn, and 0 where there is no sample; per output. And whether the state is not to be carried
    /// on: a missing sample is not to be predicted, the state turns too fast to be seen, or the samples have jumped.
    fn innovation(&mut self, predicted: &Predicted) -> (Vec<Value>, Value) {
        let shown = self.shown(&predicted.state);
        let lost = self.lost(predicted, &shown);
        let spun = self.spun(&shown);
        let lost = self.builder.or(lost, spun);
        let lost = predicted.reading.again.map_or(lost, |again| self.builder.or(lost, again));
        let none = self.builder.float(0.0);
        let each = shown.iter().enumerate().map(|(o, shown)| {
            let difference = self.builder.sub(predicted.reading.outputs[o], *shown);
            let difference = front::folded(&mut self.builder, &self.plant.outputs[o], difference, self.plant.scalar);
            self.builder.select(predicted.reading.good[o], difference, none)
        });
        (each.collect(), lost)
    }

    /// Whether a call counts: with one output, each that has its sample; with several, each that has those that are due.
    fn counts(&self, predicted: &Predicted) -> Value {
        if self.plant.outputs.len() == 1 { predicted.complete } else { predicted.measured }
    }

    /// C z, per output.
    fn shown(&mut self, state: &[Value]) -> Vec<Value> {
        let design = self.design;
        match design.frame {
            Frame::Plant { .. } => products(&mut self.builder, &design.output, state),
            Frame::Chain { .. } => vec![state[0]],
        }
    }

    /// Whether a sample is missing whose prediction no sample could be.
    fn lost(&mut self, predicted: &Predicted, shown: &[Value]) -> Value {
        let mut lost = self.builder.boolean(false);
        let ranges = self.plant.outputs.iter().map(|output| output.range.is_some()).collect::<Vec<_>>();
        for o in (0..ranges.len()).filter(|o| ranges[*o]) {
            let (low, high) = self.sensors.guard.outputs[o];
            let sane = self.builder.in_range(shown[o], low, high);
            let covered = self.builder.or(predicted.reading.good[o], sane);
            let astray = self.builder.not(covered);
            lost = self.builder.or(lost, astray);
        }
        lost
    }

    /// Whether the observer has no state yet, or one that nothing reasonable leads to.
    fn starts_again(&mut self, innovation: &[Value], corrected: &[Carried], lost: Value) -> Value {
        let bound = self.sensors.guard.bound;
        let none = self.builder.index(0);
        let good = self.builder.read(self.cells.good);
        let waiting = self.builder.index_equal(good, none);
        let waiting = self.without_a_state(waiting);
        let mut again = self.builder.or(waiting, lost);
        if let Some(width) = self.farthest() {
            let near = self.builder.in_range(innovation[0], -width, width);
            let far = self.builder.not(near);
            again = self.builder.or(again, far);
        }
        for carried in corrected {
            let sane = self.builder.in_range(carried.high, -bound, bound);
            let wild = self.builder.not(sane);
            again = self.builder.or(again, wild);
        }
        again
    }

    /// How wide the output's range is, where the law takes longer the larger the error: a prediction further off than that is
    /// worse than none.
    fn farthest(&self) -> Option<f64> {
        let sliding = matches!(self.design.gain, Gain::Sliding { .. }) && self.plant.outputs[0].range.is_some();
        let (low, high) = self.sensors.guard.outputs[0];
        sliding.then(|| self.plant.scalar_value(high - low))
    }

    /// The state after this call: corrected, or the start.
    fn store(
        &mut self,
        predicted: &Predicted,
        corrected: &[Carried],
        (again, left): (Value, Option<Value>),
    ) -> Vec<Value> {
        let (starts, rests) = (self.starts(&predicted.reading.outputs), self.rests());
        let mut state = Vec::new();
        for (i, carried) in corrected.iter().enumerate() {
            let start = self.builder.select(predicted.complete, starts[i], rests[i]);
            let value = self.builder.select(again, start, carried.high);
            self.builder.set(self.cells.state[i], value);
            self.store_low(i, carried.low, again);
            state.push(value);
        }
        if let Some(left) = left {
            let lead = self.builder.index(calls(self.design.counting.lead()));
            let left = self.builder.select(again, lead, left);
            self.builder.set(self.cells.left, left);
        }
        state
    }

    /// Whether noise and what the law allows for explain the innovation; always, for a gain that does not ask.
    fn calm(&mut self, innovation: &[Value]) -> Value {
        let Gain::Sliding { calm, .. } = self.design.gain else { return self.builder.boolean(true) };
        let calm = self.plant.scalar_value(calm);
        self.builder.in_range(innovation[0], -calm, calm)
    }

    /// Counts the good calls since the start, and those in a row.
    fn count(&mut self, predicted: &Predicted, again: Value, calm: Value) -> [Value; 2] {
        let (none, one) = (self.builder.index(0), self.builder.index(1));
        let most = calls(self.design.valid + 1);
        let first = self.builder.select(predicted.complete, one, none);
        let good = self.builder.read(self.cells.good);
        let more = self.builder.count_up(good, most);
        let more = self.builder.select(calm, more, one);
        let good = self.builder.select(self.counts(predicted), more, good);
        let good = self.builder.select(again, first, good);
        self.builder.set(self.cells.good, good);
        // Since the start nothing has been missing: the first convergence alone counts.
        let recovered = calls(self.design.recovery);
        let clean = self.builder.read(self.cells.clean);
        let more = self.builder.count_up(clean, recovered);
        let more = self.builder.select(calm, more, one);
        let clean = self.builder.select(predicted.fine, more, none);
        let all = self.builder.index(recovered);
        let clean = self.builder.select(again, all, clean);
        self.builder.set(self.cells.clean, clean);
        self.sensors.count_call(&mut self.builder);
        self.has_begun(predicted, again);
        [good, clean]
    }

    /// The state from a first sample, per state.
    fn starts(&mut self, outputs: &[Value]) -> Vec<Value> {
        if let Frame::Chain { start, .. } = &self.design.frame {
            let mut starts = self.rests();
            starts[0] = if start[0].is_none() { outputs[0] } else { self.builder.add(starts[0], outputs[0]) };
            return starts;
        }
        (0..self.plant.states.len()).map(|i| start(&mut self.builder, self.plant, i, outputs)).collect()
    }

    /// The state without a sample, per state.
    fn rests(&mut self) -> Vec<Value> {
        let design = self.design;
        if let Frame::Chain { start, .. } = &design.frame {
            return start.iter().map(|entry| constant(&mut self.builder, entry.unwrap_or_default())).collect();
        }
        let initial = self.plant.states.iter().map(|state| round(&state.initial, self.plant.scalar));
        initial.collect::<Vec<_>>().into_iter().map(|value| self.builder.float(value)).collect()
    }

    /// The estimate, and what it is worth.
    fn report(&mut self, state: &[Value], predicted: &Predicted, [good, clean]: [Value; 2]) {
        self.builder.section("the estimate");
        let design = self.design;
        let estimate = match &design.frame {
            Frame::Plant { .. } => state.to_vec(),
            Frame::Chain { readout, .. } => products(&mut self.builder, readout, state),
        };
        let moved = self.ahead.map(|ahead| {
            let injections = self.sensors.injections(&predicted.reading.known.injections.inputs);
            Moved { ahead, injections, outputs: &predicted.reading.outputs }
        });
        report::estimates(&mut self.builder, self.plant, estimate, moved, "");
        if let Some(coasted) = predicted.reading.coasted {
            report::coasted(&mut self.builder, coasted);
        }
        let [enough, recovered] = [design.valid, design.recovery - 1].map(|count| self.builder.index(calls(count)));
        let (known, undisturbed) = (self.builder.index_less(enough, good), self.builder.index_less(recovered, clean));
        report::status(&mut self.builder, known, undisturbed);
    }
}
