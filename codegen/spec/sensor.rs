//! What a specification says of the sensor behind an output, as written.

use std::ops::Range;

use super::Quantity;
use super::reader::Table;
use crate::diagnostic::{Diagnostic, codes};

/// An integer measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counter {
    /// 16 or 32.
    pub bits: u8,
    /// Whether it counts below zero.
    pub signed: bool,
}

impl Counter {
    /// How many numbers there are until it begins again.
    #[must_use]
    pub fn numbers(self) -> u64 {
        1 << self.bits
    }

    /// The least and the greatest number.
    #[must_use]
    pub fn range(self) -> (f64, f64) {
        let half = if self.bits == 16 { 32_768.0 } else { 2_147_483_648.0 };
        if self.signed { (-half, half - 1.0) } else { (0.0, 2.0 * half - 1.0) }
    }
}

/// A jump that means nothing.
#[derive(Clone, Debug)]
pub enum Turn {
    /// By this, in the output's unit.
    Of(Quantity),
    /// By all numbers of the integer type; the place of the word.
    OfTheCounter(Range<usize>),
}

impl Turn {
    /// Its place in the file.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Of(quantity) => quantity.span(),
            Self::OfTheCounter(span) => span.clone(),
        }
    }
}

/// How a sensor rounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest count.
    #[default]
    Nearest,
    /// Down, as counters do.
    Floor,
}

/// Keys of an output that are about its sensor.
#[derive(Clone, Debug, Default)]
pub struct Sensor {
    /// A sample may jump by a turn.
    pub wrap: Option<Turn>,
    /// Whether a turn may move what is not this output's own; the place of the key, where it is written.
    pub turn_moves: (bool, Option<Range<usize>>),
    /// How fast the output may move, in its unit per second.
    pub max_rate: Option<Quantity>,
    /// One count, in the output's unit.
    pub quantum: Option<Quantity>,
    /// How it rounds, where that is written; with its place.
    pub rounding: Option<(Rounding, Range<usize>)>,
    /// The integer that the caller hands over instead of a float; with its place.
    pub counter: Option<(Counter, Range<usize>)>,
    /// A sample further than this from its prediction is missing.
    pub gate: Option<Quantity>,
    /// Rejected samples in a row that start the observer again.
    pub gate_limit: Option<(u32, Range<usize>)>,
    /// Measured at every so many steps.
    pub every: Option<(u32, Range<usize>)>,
    /// Whether the caller says how old each sample is; with its place.
    pub age: Option<Range<usize>>,
    /// The oldest sample that is used, s.
    pub age_max: Option<Quantity>,
}

const COUNTERS: [(&str, Option<Counter>); 5] = [
    ("float", None),
    ("i16", Some(Counter { bits: 16, signed: true })),
    ("u16", Some(Counter { bits: 16, signed: false })),
    ("i32", Some(Counter { bits: 32, signed: true })),
    ("u32", Some(Counter { bits: 32, signed: false })),
];

impl Sensor {
    /// Reads the keys from an output's table; mistakes are reported there.
    pub(super) fn read(entry: &mut Table) -> Self {
        let rounding =
            entry.choice("rounding", &[("nearest", Rounding::Nearest), ("floor", Rounding::Floor)], Rounding::Nearest);
        let counter = entry.choice("sample", &COUNTERS, None);
        let aged = entry.choice("age", &[("none", false), ("measured", true)], false);
        let accepted = entry.choice("turn_moves", &[("refuse", false), ("accept", true)], false);
        let sensor = Self {
            wrap: turn(entry),
            turn_moves: (accepted, entry.has("turn_moves").then(|| entry.key_span("turn_moves"))),
            max_rate: entry.quantity("max_rate"),
            quantum: entry.quantity("quantum"),
            rounding: entry.has("rounding").then(|| (rounding, entry.key_span("rounding"))),
            counter: counter.map(|counter| (counter, entry.key_span("sample"))),
            gate: entry.quantity("gate"),
            gate_limit: count(entry, "gate_limit"),
            every: count(entry, "every"),
            age: aged.then(|| entry.key_span("age")),
            age_max: entry.quantity("age_max"),
        };
        sensor.refuse_without(entry);
        sensor
    }

    /// Keys that mean nothing without another.
    fn refuse_without(&self, entry: &Table) {
        let needs = |key: &str, other: &str, there: bool| {
            if entry.has(key) && !there {
                let message = format!("`{key}` means nothing without `{other}`");
                let error = Diagnostic::error(codes::BAD_COMBINATION, entry.key_span(key), message);
                entry.report(error.help(format!("leave it out, or write `{other} = …` too")));
            }
        };
        needs("rounding", "quantum", entry.has("quantum"));
        needs("turn_moves", "wrap", entry.has("wrap"));
        needs("gate_limit", "gate", entry.has("gate"));
        needs("age_max", "age", self.age.is_some());
    }
}

/// The key `wrap`: a size, or the word for all numbers of the integer type.
fn turn(entry: &mut Table) -> Option<Turn> {
    let whole = entry.has_word("wrap", "counter");
    let turn = entry.quantity("wrap")?;
    if !whole {
        return Some(Turn::Of(turn));
    }
    if !entry.has("sample") || entry.has_word("sample", "float") {
        let message = "`wrap = \"counter\"` is the turn of an integer, and the samples are floats";
        let error = Diagnostic::error(codes::BAD_COMBINATION, turn.span(), message);
        entry.report(error.help("write the turn in the output's unit, or `sample = \"u16\"` or another integer"));
        return None;
    }
    Some(Turn::OfTheCounter(turn.span()))
}

/// Steps or samples: a whole number from 1 to a million, if the key is there.
fn count(entry: &mut Table, key: &str) -> Option<(u32, Range<usize>)> {
    const MOST: u32 = 1_000_000;
    let (number, span) = entry.whole(key)?;
    let small = u32::try_from(number.numerator()).ok().filter(|n| (1..=MOST).contains(n));
    if small.is_none() {
        let message = format!("`{key}` must be a whole number from 1 to {MOST}, not {number}");
        entry.report(Diagnostic::error(codes::BAD_NUMBER, span.clone(), message).help("write how many samples"));
    }
    small.map(|n| (n, span))
}
