//! Which columns of a recording a step reads, and as what.

use std::io::Read;

use crate::plant::{Input, Plant};

use super::interface::{Count, Interface, MeasuredKind};
use super::mistake::SignalError;
use super::recording::{Recording, RecordingError};
use super::signals::{Signals, found};
use super::steps::Row;

/// Columns to be read, each once.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    names: Vec<String>,
}

impl Selection {
    /// The place among the selected cells.
    pub fn place(&mut self, name: String) -> usize {
        self.names.iter().position(|other| *other == name).unwrap_or_else(|| {
            self.names.push(name);
            self.names.len() - 1
        })
    }

    /// Makes a recording deliver them; the cells of a row have this many places.
    pub fn apply<R: Read>(&self, recording: &mut Recording<R>) -> Result<usize, RecordingError> {
        let names: Vec<&str> = self.names.iter().map(String::as_str).collect();
        recording.select(&names).map(|places| places.len())
    }
}

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
}

impl Columns {
    /// Finds the columns of one specification; those that are named like a state are compared with it
    /// where `all` says so, unless they are what the step reads.
    pub fn find(
        plant: &Plant,
        interface: &Interface,
        signals: &Signals,
        there: &[String],
        selection: &mut Selection,
        all: bool,
    ) -> Result<Self, SignalError> {
        // A time that was named with --map must be there; one that was not may be absent.
        let time = signals.column("t");
        let timed = time != "t" || there.contains(&time);
        let time = timed.then(|| selection.place(time));
        if let (None, Some((name, _))) = (time, signals.age.first()) {
            return Err(SignalError::Timeless { name: name.clone() });
        }
        let measurements: Vec<Cell> = interface
            .measurements
            .iter()
            .map(|field| {
                let written = match field.kind {
                    MeasuredKind::Sample { output, .. } => &plant.outputs[output].label.written,
                    MeasuredKind::Age { .. } => &field.name,
                };
                let column = signals.column_of(&field.name, written, there);
                let mut place = || selection.place(column.clone());
                match field.kind {
                    MeasuredKind::Sample { count: Some(count), .. } => Cell::Count(place(), count, column),
                    MeasuredKind::Sample { count: None, .. } => Cell::Number(place()),
                    MeasuredKind::Age { output } => match found(&signals.age, &plant.outputs[output].label.name) {
                        Some(column) => Cell::Since(selection.place(column)),
                        None => Cell::Number(place()),
                    },
                }
            })
            .collect();
        let input = |u: &Input| signals.column_of(&u.label.name, &u.label.written, there);
        let inputs = plant.inputs.iter().map(|u| selection.place(input(u))).collect();
        let read = selection.clone();
        let references = interface.answers.iter().map(|answer| {
            let column = found(&signals.reference, &answer.name).filter(|_| !answer.integer);
            // Named like the field, or like the state as it is written.
            let state = answer.state.filter(|_| answer.window.is_none_or(|window| window == 1));
            let written = state.map_or(&answer.name, |state| &plant.states[state].label.written);
            let mut names = [&answer.name, written].into_iter().filter(|_| all && !answer.integer);
            let named = || names.find(|name| there.contains(*name) && !read.names.contains(*name)).cloned();
            column.or_else(named).map(|column| selection.place(column))
        });
        let references = references.collect();
        Ok(Self { time, measurements, inputs, references, negative_ages: 0 })
    }

    /// Per field of the estimate: whether it is compared.
    pub fn compared(&self) -> Vec<bool> {
        self.references.iter().map(Option::is_some).collect()
    }

    /// The row of a step; a count that is none is an error with its place in the recording.
    pub fn row<R>(&mut self, cells: &[f64], recording: &Recording<R>) -> Result<Row, RecordingError> {
        let t = self.time.map(|place| cells[place]);
        let mut measurements = Vec::with_capacity(self.measurements.len());
        for cell in &self.measurements {
            measurements.push(match cell {
                Cell::Number(place) => cells[*place],
                Cell::Count(place, count, column) => counted(cells[*place], *count, column, recording)?,
                Cell::Since(place) => {
                    let age = since(t.unwrap_or(f64::NAN), cells[*place]);
                    self.negative_ages += u64::from(age.is_none());
                    age.unwrap_or(f64::NAN)
                }
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
