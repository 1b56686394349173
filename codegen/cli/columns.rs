//! Which columns of a recording a step reads, and as what.

use std::io::Read;

use clap::Args;
use deadbeat_codegen::Plant;

use super::Failure;
use super::files::explained;
use super::interface::{Count, Interface, MeasuredKind};
use super::recording::{Recording, RecordingError};
use super::replay::Row;

/// What the columns of a recording mean, where their names do not say it.
#[derive(Args, Clone, Debug, Default)]
pub struct Signals {
    /// A measurement, an input or the time `t` that has another name in the recording, may be repeated
    #[arg(long, value_name = "NAME=COLUMN", value_parser = renaming)]
    pub map: Vec<(String, String)>,
    /// A state and the column to compare it with, may be repeated
    #[arg(long, value_name = "STATE=COLUMN", value_parser = renaming)]
    pub reference: Vec<(String, String)>,
    /// An output whose age is measured, and the column with its sensor's own time, s; may be repeated
    #[arg(long, value_name = "OUTPUT=COLUMN", value_parser = renaming)]
    pub age: Vec<(String, String)>,
}

fn renaming(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, column)) if !name.is_empty() && !column.is_empty() => Ok((name.to_owned(), column.to_owned())),
        _ => Err("write NAME=COLUMN".into()),
    }
}

impl Signals {
    /// The column that stands for a name.
    fn column(&self, name: &str) -> String {
        found(&self.map, name).unwrap_or_else(|| name.to_owned())
    }

    /// Refuses names that no specification knows.
    pub fn check(&self, all: &[(&Plant, &Interface)]) -> Result<(), Failure> {
        let of = if all.len() == 1 { "of the specification" } else { "of any specification" };
        let input = |plant: &Plant, name: &str| plant.inputs.iter().any(|input| input.label.name == name);
        let measured = |interface: &Interface, name: &str| interface.measurements.iter().any(|m| m.name == name);
        let known = |name: &str| name == "t" || all.iter().any(|(p, i)| input(p, name) || measured(i, name));
        if let Some((name, _)) = self.map.iter().find(|(name, _)| !known(name)) {
            return Err(Failure::Misused(format!("--map: `{name}` is neither an output nor an input {of}, nor `t`")));
        }
        let aged = |name: &str| all.iter().any(|(_, interface)| measured(interface, &age_of(name)));
        if let Some((name, _)) = self.age.iter().find(|(name, _)| !aged(name)) {
            return Err(Failure::Misused(format!("--age: `{name}` is not an output {of} whose age is measured")));
        }
        if let Some((name, _)) = self.age.iter().find(|(name, _)| found(&self.map, &age_of(name)).is_some()) {
            return Err(Failure::Misused(format!("--age {name}: --map names a column for `{}` already", age_of(name))));
        }
        Ok(())
    }
}

impl Signals {
    /// Refuses references to what one specification does not estimate.
    pub fn check_references(&self, interface: &Interface) -> Result<(), Failure> {
        let known = |name: &str| interface.quantities().any(|(_, answer)| answer.name == name);
        match self.reference.iter().find(|(name, _)| !known(name)) {
            Some((name, _)) => {
                Err(Failure::Misused(format!("--reference: `{name}` is not a state of the specification")))
            }
            None => Ok(()),
        }
    }
}

/// The field that says how old an output's sample is.
fn age_of(output: &str) -> String {
    format!("{output}_age")
}

fn found(list: &[(String, String)], name: &str) -> Option<String> {
    list.iter().find(|(from, _)| from == name).map(|(_, column)| column.clone())
}

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
    ) -> Result<Self, Failure> {
        // A time that was named with --map must be there; one that was not may be absent.
        let time = signals.column("t");
        let timed = time != "t" || there.contains(&time);
        let time = timed.then(|| selection.place(time));
        if let (None, Some((name, _))) = (time, signals.age.first()) {
            return Err(Failure::Misused(format!(
                "--age {name}: an age is the time `t` less the sensor's, and the recording has no column `t`"
            )));
        }
        let measurements: Vec<Cell> = interface
            .measurements
            .iter()
            .map(|field| {
                let mut place = || selection.place(signals.column(&field.name));
                match field.kind {
                    MeasuredKind::Sample { count: Some(count), .. } => {
                        Cell::Count(place(), count, signals.column(&field.name))
                    }
                    MeasuredKind::Sample { count: None, .. } => Cell::Number(place()),
                    MeasuredKind::Age { output } => match found(&signals.age, &plant.outputs[output].label.name) {
                        Some(column) => Cell::Since(selection.place(column)),
                        None => Cell::Number(place()),
                    },
                }
            })
            .collect();
        let inputs = plant.inputs.iter().map(|u| selection.place(signals.column(&u.label.name))).collect();
        let read = selection.clone();
        let references = interface.answers.iter().map(|answer| {
            let column = found(&signals.reference, &answer.name).filter(|_| !answer.integer);
            let named = || all && !answer.integer && there.contains(&answer.name) && !read.names.contains(&answer.name);
            column.or_else(|| named().then(|| answer.name.clone())).map(|column| selection.place(column))
        });
        let references = references.collect();
        Ok(Self { time, measurements, inputs, references, negative_ages: 0 })
    }

    /// Per field of the estimate: whether it is compared.
    pub fn compared(&self) -> Vec<bool> {
        self.references.iter().map(Option::is_some).collect()
    }

    /// The row of a step; a count that is none is an error with its place in the recording.
    pub fn row<R>(&mut self, cells: &[f64], recording: &Recording<R>) -> Result<Row, Failure> {
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
fn counted<R>(value: f64, count: Count, column: &str, recording: &Recording<R>) -> Result<f64, Failure> {
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
    Err(explained(&recording.complaint(column, message, help)))
}
