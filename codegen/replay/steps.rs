//! Feeds a recording to the interpreter, one sample a step, and compares what comes out.
//!
//! A row's held input is applied from that row's time until the next row's; the step at a row
//! therefore gets the held inputs of the row before and the first-order inputs of this one. Where
//! the recording's time jumps over samples, the step is told that they are missing.

use std::fmt;

use crate::generated::Generated;
use crate::plant::moved::notes;
use crate::plant::{Hold, Plant};
use crate::program::Status;
use crate::program::interp::Interpreter;

use super::interface::{Count, Interface, MeasuredKind, fold};
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
    /// Of the first row, s.
    start: Option<f64>,
    calls: u64,
    odd_rows: u32,
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
}

/// Why a row's time does not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TimeError {
    /// What is wrong with it.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl fmt::Display for TimeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for TimeError {}

/// Rows in a row whose spacing does not fit before the recording is refused.
const ODD_ROWS: u32 = 8;
/// Rows before the recording's rate is compared with the sample time: until then, jitter hides it.
const RATE_ROWS: u64 = 100;
/// Samples by which the recording's time and the steps may differ, whatever the length.
const RATE_SAMPLES: f64 = 2.0;
/// Share of the steps by which they may differ besides: a drive's clock drifts by up to 0.1 %.
const RATE_SHARE: f64 = 0.01;
/// Samples that one jump of the time may leave out.
const LARGEST_GAP: f64 = 1e6;

/// What to do about a recording at another rate.
const RATE_HELP: &str = "set the specification's `sample_time` to the recording's, or resample the recording";

impl<'a> Steps<'a> {
    /// Starts with nothing seen.
    pub fn new(generated: &'a Generated) -> Self {
        let interface = Interface::of(generated);
        Self {
            generated,
            interpreter: Interpreter::new(&generated.program),
            held: vec![0.0; generated.plant.inputs.len()],
            previous: None,
            start: None,
            calls: 0,
            odd_rows: 0,
            rows: 0,
            converged_rows: 0,
            coasting_rows: 0,
            converged_from: None,
            left_out: 0,
            errors: vec![Errors::default(); interface.answers.len()],
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
        self.start.is_some()
    }

    /// What the recording has that a report should not keep silent about, a line each; `negative_ages` are samples of
    /// a later time than their row's.
    pub fn remarks(&self, negative_ages: u64) -> Vec<String> {
        let mut remarks = Vec::new();
        if !self.timed() {
            let h = self.plant().sample_time_s();
            remarks.push(format!("the recording has no column `t`: its rows are taken to be {h} s apart"));
        }
        if self.left_out > 0 {
            let counts = self.interface.measurements.iter().any(|field| field.kind.is_count());
            let what = if counts { "put on a straight line" } else { "treated as missing" };
            remarks.push(format!("{} samples that the recording's time leaves out were {what}", self.left_out));
        }
        remarks.extend(notes(self.plant()));
        if negative_ages > 0 {
            remarks.push(format!(
                "{negative_ages} samples are of a later time than their row and were treated as missing"
            ));
        }
        remarks
    }

    /// Takes one row.
    ///
    /// # Errors
    /// When its time does not rise, or is not that of the specification's sample time.
    pub fn feed(&mut self, row: &Row) -> Result<Sample, TimeError> {
        let gap = self.gap(row)?;
        self.check_rate(row, gap)?;
        let previous = self.previous.take();
        let mut estimate = vec![0.0; self.interface.answers.len()];
        if let Some(previous) = &previous {
            for missing in 1..gap {
                let inputs = self.inputs(previous, row, missing, gap);
                let nothing = self.between(previous, row, missing, gap);
                self.interpreter.step(&nothing, &inputs, &mut estimate);
                self.calls += 1;
                self.left_out += 1;
            }
        }
        let inputs = self.inputs(previous.as_ref().unwrap_or(row), row, gap, gap);
        let status = self.interpreter.step(&row.measurements, &inputs, &mut estimate);
        self.compare(row, &estimate, status);
        let t = row.t.unwrap_or_else(|| self.now());
        self.calls += 1;
        self.rows += 1;
        self.start = self.start.or(row.t);
        self.previous = Some(row.clone());
        Ok(Sample { t, estimate, status })
    }

    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    fn now(&self) -> f64 {
        self.calls as f64 * self.plant().sample_time_s()
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
                self.errors[place].add(self.interface.answers[place].error(estimate[place], *reference));
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

    /// Samples since the previous row, at least 1.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "rounded, positive and bounded just before"
    )]
    fn gap(&mut self, row: &Row) -> Result<u64, TimeError> {
        let Some((before, now)) = self.previous.as_ref().and_then(|p| p.t).zip(row.t) else { return Ok(1) };
        let h = self.plant().sample_time_s();
        let samples = (now - before) / h;
        if samples.is_nan() || samples <= 0.0 {
            return Err(unfit(format!("the time does not rise: {now} s behind {before} s")));
        }
        if samples > LARGEST_GAP {
            return Err(unfit(format!("the time jumps by {samples:.0} samples, from {before} s to {now} s")));
        }
        let fits = (0.75..1.5).contains(&samples);
        self.odd_rows = if fits { 0 } else { self.odd_rows + 1 };
        if self.odd_rows == ODD_ROWS {
            let spacing = now - before;
            return Err(another_rate(format!(
                "rows are {spacing:.6} s apart, the specification's sample time is {h} s"
            )));
        }
        Ok((samples.round() as u64).max(1))
    }

    /// Refuses a row `gap` samples behind the previous one when the time since the first row is not
    /// that of the steps: every row may be near the sample time, and the recording still be at
    /// another rate.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 samples")]
    fn check_rate(&self, row: &Row, gap: u64) -> Result<(), TimeError> {
        let Some((start, now)) = self.start.zip(row.t).filter(|_| self.rows >= RATE_ROWS) else { return Ok(()) };
        let h = self.plant().sample_time_s();
        // The first row is at step 0, the previous one at `self.calls - 1`.
        let steps = (self.calls - 1 + gap) as f64;
        if ((now - start) / h - steps).abs() <= RATE_SAMPLES + RATE_SHARE * steps {
            return Ok(());
        }
        let spacing = (now - start) / steps;
        Err(another_rate(format!(
            "samples are {spacing:.6} s apart in the mean of {steps} since the first row, \
             the specification's sample time is {h} s"
        )))
    }
}

fn unfit(message: String) -> TimeError {
    TimeError { message, help: None }
}

fn another_rate(message: String) -> TimeError {
    TimeError { message, help: Some(RATE_HELP.into()) }
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
