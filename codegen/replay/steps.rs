//! Feeds a recording to the interpreter, one sample a step, and compares what comes out.
//!
//! A row's held input is applied from that row's time until the next row's; the step at a row
//! therefore gets the held inputs of the row before and the first-order inputs of this one. Where
//! the recording's time jumps over samples, the step is told that they are missing.

use crate::generated::Generated;
use crate::numbers::short;
use crate::plant::moved::notes;
use crate::plant::{Hold, Plant};
use crate::program::Status;
use crate::program::interp::Interpreter;

use super::grid::{Grid, Place, TimeError};
use super::interface::{Count, Interface, MeasuredKind, fold};
use super::residual::{Innovations, Residual};
use super::verdict::Errors;

/// One row of a recording.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// s; absent when the recording has no time.
    pub t: Option<f64>,
    /// Per field of the measurements; NaN when missing.
    pub measurements: Vec<f64>,
    /// Per input; NaN when missing.
    pub inputs: Vec<f64>,
    /// Per field of the estimate; NaN when it is not compared, or not known.
    pub references: Vec<f64>,
}

/// What a step at a row gave.
#[derive(Clone, Debug)]
pub struct Sample {
    /// s since the first row, or the recording's own time.
    pub t: f64,
    /// Per field.
    pub estimate: Vec<f64>,
    /// Of the estimate.
    pub status: Status,
}

/// A step that is fed with rows.
pub struct Steps<'a> {
    generated: &'a Generated,
    interface: Interface,
    interpreter: Interpreter,
    held: Vec<f64>,
    previous: Option<Row>,
    /// What the newest call gave.
    newest: Option<(Vec<f64>, Status)>,
    grid: Grid,
    innovations: Option<Innovations>,
    calls: u64,
    /// Rows fed.
    pub rows: u64,
    /// Rows with a converged or coasting estimate.
    pub converged_rows: u64,
    /// Those of them that coast.
    pub coasting_rows: u64,
    /// The first such call, from 1.
    pub converged_from: Option<u64>,
    /// Samples that the recording's time left out.
    pub left_out: u64,
    /// Per field of the estimate.
    pub errors: Vec<Errors>,
    /// Likewise: what is promised of it.
    bounds: Vec<Option<f64>>,
}

impl<'a> Steps<'a> {
    /// Starts with nothing seen.
    pub fn new(generated: &'a Generated) -> Self {
        let interface = Interface::of(generated);
        Self {
            generated,
            interpreter: Interpreter::new(&generated.program),
            held: vec![0.0; generated.plant.inputs.len()],
            previous: None,
            newest: None,
            grid: Grid::new(generated.plant.sample_time_s()),
            innovations: Innovations::of(generated, &interface),
            calls: 0,
            rows: 0,
            converged_rows: 0,
            coasting_rows: 0,
            converged_from: None,
            left_out: 0,
            errors: vec![Errors::default(); interface.answers.len()],
            bounds: interface.answers.iter().map(|answer| answer.bound(&generated.design)).collect(),
            interface,
        }
    }

    /// The design.
    pub fn generated(&self) -> &'a Generated {
        self.generated
    }

    /// The fields of the step.
    pub fn interface(&self) -> &Interface {
        &self.interface
    }

    fn plant(&self) -> &'a Plant {
        &self.generated.plant
    }

    /// Whether the recording has times.
    pub fn timed(&self) -> bool {
        self.grid.timed()
    }

    /// What the recording has that a report should not keep silent about, a line each; `negative_ages` are samples of
    /// a later time than their row's.
    pub fn remarks(&self, negative_ages: u64) -> Vec<String> {
        let mut remarks = Vec::new();
        let h = self.plant().sample_time_s();
        if !self.timed() {
            remarks.push(format!("the recording has no column `t`: its rows are taken to be {h} s apart"));
        }
        if self.left_out > 0 {
            let counts = self.interface.measurements.iter().any(|field| field.kind.is_count());
            let what = if counts { "put on a straight line" } else { "treated as missing" };
            remarks.push(format!("{} samples that the recording's time leaves out were {what}", self.left_out));
        }
        if self.grid.doubled() > 0 {
            let doubled = self.grid.doubled();
            remarks.push(format!("{doubled} rows were left out, since another row belongs to the same call"));
        }
        if self.grid.off() > 0.1 * h {
            let off = short(self.grid.off());
            remarks.push(format!("rows are {off} s (RMS) off the times of their calls, which are {h} s apart"));
        }
        remarks.extend(notes(self.plant()));
        if negative_ages > 0 {
            remarks.push(format!(
                "{negative_ages} samples are of a later time than their row and were treated as missing"
            ));
        }
        remarks
    }

    /// The time of the call that a row of this time belongs to, s.
    pub fn time_of_call(&self, now: f64) -> f64 {
        self.grid.time_of_call(now)
    }

    /// Takes one row. A row whose call has had one already is left out: the estimate is that of the call.
    ///
    /// # Errors
    /// When its time does not rise, or jumps too far.
    pub fn feed(&mut self, row: &Row) -> Result<Sample, TimeError> {
        let place = row.t.map_or(Ok(Place::Behind(1)), |now| self.grid.take(now))?;
        self.rows += 1;
        let newest = match (place, self.newest.take()) {
            (Place::Taken, Some(newest)) => newest,
            (Place::Behind(gap), _) => self.called(row, gap),
            (Place::Taken, None) => unreachable!("the first row has a call of its own"),
        };
        let t = row.t.unwrap_or_else(|| self.now());
        self.previous = Some(row.clone());
        let (estimate, status) = self.newest.insert(newest).clone();
        Ok(Sample { t, estimate, status })
    }

    /// What is to be said at the end of the recording.
    ///
    /// # Errors
    /// When its rows are at another rate than the step.
    pub fn judge(&self) -> Result<(), TimeError> {
        self.grid.judge(self.converged_rows > 0)
    }

    /// Calls the step for a row that is `gap` calls behind the previous one.
    fn called(&mut self, row: &Row, gap: u64) -> (Vec<f64>, Status) {
        let previous = self.previous.take();
        let mut estimate = vec![0.0; self.interface.answers.len()];
        if let Some(previous) = &previous {
            for missing in 1..gap {
                let inputs = self.inputs(previous, row, missing, gap);
                let nothing = self.between(previous, row, missing, gap);
                let status = self.interpreter.step(&nothing, &inputs, &mut estimate);
                self.foretell(&nothing, &inputs, &estimate, status);
                self.calls += 1;
                self.left_out += 1;
            }
        }
        let inputs = self.inputs(previous.as_ref().unwrap_or(row), row, gap, gap);
        let status = self.interpreter.step(&row.measurements, &inputs, &mut estimate);
        self.foretell(&row.measurements, &inputs, &estimate, status);
        self.compare(row, &estimate, status);
        self.calls += 1;
        (estimate, status)
    }

    /// Compares the samples of a call with what was foretold of them, and foretells the next.
    fn foretell(&mut self, measurements: &[f64], inputs: &[f64], estimate: &[f64], status: Status) {
        let Some(innovations) = &mut self.innovations else { return };
        let fields = self.interface.measurements.iter().zip(measurements);
        let samples = fields.filter(|(field, _)| matches!(field.kind, MeasuredKind::Sample { .. })).map(|(_, it)| *it);
        innovations.call(&samples.collect::<Vec<_>>(), inputs, estimate, status != Status::Converging);
    }

    /// What the samples were against what the estimates before them foretold, per output; empty where an estimate
    /// foretells nothing.
    pub fn residuals(&self) -> Vec<Residual> {
        self.innovations.as_ref().map_or_else(Vec::new, |innovations| innovations.judged(self.generated))
    }

    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    fn now(&self) -> f64 {
        self.calls.saturating_sub(1) as f64 * self.plant().sample_time_s()
    }

    fn compare(&mut self, row: &Row, estimate: &[f64], status: Status) {
        if status == Status::Converging {
            return;
        }
        self.converged_rows += 1;
        self.coasting_rows += u64::from(status == Status::Coasting);
        self.converged_from = self.converged_from.or(Some(self.calls + 1));
        for (place, reference) in row.references.iter().enumerate() {
            if reference.is_finite() && self.interface.has_converged(place, estimate, status) {
                let error = self.interface.answers[place].error(estimate[place], *reference);
                let bound = self.bounds[place].filter(|_| status == Status::Converged);
                self.errors[place].add(error, bound);
            }
        }
    }

    /// Measurements for the step that is `step` of `gap` samples behind the previous row.
    #[expect(clippy::cast_precision_loss, reason = "a gap is below 10^6")]
    fn between(&self, previous: &Row, row: &Row, step: u64, gap: u64) -> Vec<f64> {
        let share = step as f64 / gap as f64;
        let ends = previous.measurements.iter().zip(&row.measurements);
        let value = |(field, (from, to)): (&_, (&f64, &f64))| match field {
            MeasuredKind::Sample { count: Some(count), output } => {
                let turns = self.plant().outputs[*output].wrap.is_some();
                on_line(*count, turns, (*from, *to), share)
            }
            MeasuredKind::Sample { count: None, .. } | MeasuredKind::Age { .. } => f64::NAN,
        };
        self.interface.measurements.iter().map(|field| &field.kind).zip(ends).map(value).collect()
    }

    /// Inputs for the step that is `step` of `gap` samples behind the previous row.
    #[expect(clippy::cast_precision_loss, reason = "a gap is below 10^6")]
    fn inputs(&mut self, previous: &Row, row: &Row, step: u64, gap: u64) -> Vec<f64> {
        let share = step as f64 / gap as f64;
        for (i, input) in self.plant().inputs.iter().enumerate() {
            self.held[i] = match input.hold {
                Hold::Zero => previous.inputs[i],
                Hold::First if step == gap => row.inputs[i],
                Hold::First => previous.inputs[i] + share * (row.inputs[i] - previous.inputs[i]),
            };
        }
        self.held.clone()
    }
}

/// The count at a share of the way from one count to another; the shorter way round, where the counter turns.
fn on_line(count: Count, turns: bool, (from, to): (f64, f64), share: f64) -> f64 {
    if !turns {
        return (from + share * (to - from)).round();
    }
    let (least, most) = count.range();
    let turn = count.turn();
    let between = (from + share * fold(to - from, &[turn])).round();
    match between {
        below if below < least => below + turn,
        above if above > most => above - turn,
        within => within,
    }
}
