//! Which columns of a recording a step reads, and as what.

use crate::plant::{Input, Plant};

use super::clock::{TimeUnit, is_time};
use super::interface::{Count, Interface, Measured, MeasuredKind};
use super::mistake::SignalError;
use super::recording::{Header, Recording, RecordingError};
use super::selection::{Selection, Source};
use super::signals::{Signals, found};
use super::steps::Row;

/// Where one step finds its signals among the selected cells.
#[derive(Clone, Debug)]
pub struct Columns {
    time: Option<usize>,
    measurements: Vec<Cell>,
    inputs: Vec<usize>,
    /// Per field of the estimate.
    references: Vec<Option<usize>>,
    /// Ages below zero so far: the sensor's time was ahead of the recording's.
    pub negative_ages: u64,
    /// What is said of the time where its column was found by itself.
    pub remark: Option<String>,
}

/// Where a field of the measurements comes from.
#[derive(Clone, Debug)]
enum Cell {
    /// The cell as it is.
    Number(usize),
    /// The cell, which holds an integer; with its column.
    Count(usize, Count, String),
    /// The time since the cell's, s.
    Since(usize),
    /// The cell, which holds how old a sample was at the row's time, s.
    Age(usize),
}

impl Columns {
    /// Finds the columns of one specification; those that are named like a state are compared with it
    /// where `all` says so, unless they are what the step reads.
    pub fn find(
        plant: &Plant,
        interface: &Interface,
        signals: &Signals,
        header: &Header,
        selection: &mut Selection,
        all: bool,
    ) -> Result<Self, SignalError> {
        let there = &header.columns;
        let own = |field: &str, written: &str| Source::named(&signals.column_of(field, written, there), there);
        let sample = |field: &Measured| match field.kind {
            MeasuredKind::Sample { output, .. } => own(&field.name, &plant.outputs[output].label.written),
            MeasuredKind::Age { .. } => own(&field.name, &field.name),
        };
        let input = |u: &Input| own(&u.label.name, &u.label.written);
        let read = interface.measurements.iter().map(sample).chain(plant.inputs.iter().map(input));
        let read: Vec<String> = read.map(|source| source.column).collect();
        let (time, remark) = time(signals, header, &read).unzip();
        if let (None, Some((name, _))) = (&time, signals.age.first()) {
            return Err(SignalError::Timeless { name: name.clone() });
        }
        let clock = time.as_ref().map_or(TimeUnit::Seconds, |time: &Clock| time.unit);
        let time = time.map(|time| selection.place(Source::time(&time.column, time.unit)));
        let measurements: Vec<Cell> = interface
            .measurements
            .iter()
            .map(|field| {
                let mut place = || selection.place(sample(field));
                match field.kind {
                    MeasuredKind::Sample { count: Some(count), .. } => {
                        Cell::Count(place(), count, sample(field).column)
                    }
                    MeasuredKind::Sample { count: None, .. } => Cell::Number(place()),
                    MeasuredKind::Age { output } => match found(&signals.age, &plant.outputs[output].label.name) {
                        Some(column) => {
                            let unit = TimeUnit::of_column(&column).unwrap_or(clock);
                            Cell::Since(selection.place(Source::time(&column, unit)))
                        }
                        None => Cell::Age(place()),
                    },
                }
            })
            .collect();
        let inputs = plant.inputs.iter().map(|u| selection.place(input(u))).collect();
        let read = selection.clone();
        let references = interface.answers.iter().map(|answer| {
            let column = found(&signals.reference, &answer.name).filter(|_| !answer.integer);
            // Named like the field, or like the state as it is written.
            let state = answer.state.filter(|_| answer.window.is_none_or(|window| window == 1));
            let written = state.map_or(&answer.name, |state| &plant.states[state].label.written);
            let mut names = [&answer.name, written].into_iter().filter(|_| all && !answer.integer);
            let itself = || names.find(|name| there.contains(*name) && !read.has(name)).cloned();
            column.or_else(itself).map(|column| selection.place(Source::named(&column, there)))
        });
        let references = references.collect();
        Ok(Self { time, measurements, inputs, references, negative_ages: 0, remark: remark.flatten() })
    }

    /// Per field of the estimate: whether it is compared.
    pub fn compared(&self) -> Vec<bool> {
        self.references.iter().map(Option::is_some).collect()
    }

    /// The row of a step, which is called for a row of a time at another one, s, that ages are told from; a count that is
    /// none is an error with its place in the recording.
    pub fn row<R>(
        &mut self,
        cells: &[f64],
        recording: &Recording<R>,
        call: impl Fn(f64) -> f64,
    ) -> Result<Row, RecordingError> {
        let t = self.time.map(|place| cells[place]);
        // The call is some time after the row, or up to half a sample before it; a sample is no younger than new.
        let later = t.map_or(0.0, |t| call(t) - t);
        let older = |age: f64| if age >= 0.0 { (age + later).max(0.0) } else { age };
        let mut measurements = Vec::with_capacity(self.measurements.len());
        for cell in &self.measurements {
            measurements.push(match cell {
                Cell::Number(place) => cells[*place],
                Cell::Count(place, count, column) => counted(cells[*place], *count, column, recording)?,
                Cell::Since(place) => {
                    let age = since(t.unwrap_or(f64::NAN), cells[*place]);
                    self.negative_ages += u64::from(age.is_none());
                    age.map_or(f64::NAN, older)
                }
                Cell::Age(place) => older(cells[*place]),
            });
        }
        Ok(Row {
            t,
            measurements,
            inputs: self.inputs.iter().map(|place| cells[*place]).collect(),
            references: self.references.iter().map(|place| place.map_or(f64::NAN, |place| cells[place])).collect(),
        })
    }
}

/// The column of the time, and its unit.
struct Clock {
    column: String,
    unit: TimeUnit,
}

/// Finds the time: the column that was named, `t`, or one that is named like a time and not `read`; and what is said of
/// it. A time that was named must be there; one that was not may be absent.
fn time(signals: &Signals, header: &Header, read: &[String]) -> Option<(Clock, Option<String>)> {
    let there = &header.columns;
    let named = found(&signals.map, "t");
    let given = named.clone().or_else(|| there.iter().find(|column| *column == "t").cloned());
    let alike = || there.iter().find(|column| is_time(column) && !read.contains(column)).cloned();
    let column = given.clone().or_else(alike)?;
    let below = there.iter().position(|other| *other == column).and_then(|place| header.units.get(place));
    let labelled = TimeUnit::of_column(&column).or_else(|| TimeUnit::of_cell(below?));
    let unit = signals.time_unit.or(labelled).unwrap_or_default();
    let itself = given.is_none() || signals.time_unit.is_none() && unit != TimeUnit::Seconds;
    let remark = itself.then(|| format!("the time is the column `{column}`, in {unit}"));
    Some((Clock { column, unit }, remark))
}

/// The time since a stamp, s; `None` where that is below zero by more than the rounding of two decimals.
fn since(now: f64, stamp: f64) -> Option<f64> {
    let age = now - stamp;
    let rounding = f64::EPSILON * now.abs().max(stamp.abs());
    if age < -rounding { None } else { Some(if age < 0.0 { 0.0 } else { age }) }
}

/// A cell that has to hold a count.
fn counted<R>(value: f64, count: Count, column: &str, recording: &Recording<R>) -> Result<f64, RecordingError> {
    let (least, most) = count.range();
    if value.fract() == 0.0 && (least..=most).contains(&value) {
        return Ok(value);
    }
    let sign = if count.signed { "a signed" } else { "an unsigned" };
    let (message, help) = if value.is_nan() {
        ("there is no count".to_owned(), "a counter has no missing sample: leave the whole row out")
    } else {
        (format!("{value} is not {sign} integer of {} bits", count.bits), "the recording has to hold the raw counts")
    };
    Err(recording.complaint(column, message, help))
}

/// The column of the time in a recording of references, and its unit; `t` where there is none.
pub(super) fn time_of_references(header: &Header, unit: Option<TimeUnit>) -> Source {
    let signals = Signals { time_unit: unit, ..Signals::default() };
    let clock = time(&signals, header, &[]).map(|(clock, _)| clock);
    clock.map_or_else(|| Source::time("t", TimeUnit::Seconds), |clock| Source::time(&clock.column, clock.unit))
}
