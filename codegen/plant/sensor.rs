//! What a specification says of the sensor behind an output, exactly: counts, turns, gates, rates, ages.

use std::ops::Range;

use crate::decimal;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Constant;
use crate::expr::poly::PolyError;
use crate::real::Rational;
pub use crate::spec::sensor::Counter;
use crate::spec::sensor::{Rounding, Turn};
use crate::spec::{self, Quantity};

use super::reading::Reading;

/// A sample that may jump by whole turns.
#[derive(Clone, Debug)]
pub struct Wrap {
    /// One turn, in the output's unit.
    pub turn: Constant,
    /// s, n: `A s = 0`, `C s = 1` for this output and 0 for those that do not wrap; proven. Of what it moves besides the
    /// output itself, `moved` tells.
    pub direction: Vec<Constant>,
    /// Of the key in the file.
    pub span: Range<usize>,
}

/// How far a sample may be from its prediction.
#[derive(Clone, Debug)]
pub struct Gate {
    /// In the output's unit.
    pub size: Constant,
    /// Rejected samples in a row that start the observer again; the method's own number by default.
    pub limit: Option<u32>,
    /// Of the key in the file.
    pub span: Range<usize>,
}

/// A sample that comes with its age.
#[derive(Clone, Debug)]
pub struct Aged {
    /// The oldest that is used, s.
    pub most: Constant,
    /// Of the key in the file.
    pub span: Range<usize>,
}

/// What an output's sensor is like; the turn is not proven yet.
#[derive(Clone, Debug, Default)]
pub(super) struct Sensor {
    pub(super) turn: Option<(Constant, Range<usize>)>,
    pub(super) turn_moves: bool,
    pub(super) max_rate: Option<Constant>,
    pub(super) quantum: Option<Constant>,
    pub(super) floor: bool,
    pub(super) counter: Option<(Counter, Range<usize>)>,
    pub(super) gate: Option<Gate>,
    pub(super) every: usize,
    pub(super) every_span: Range<usize>,
    pub(super) aged: Option<Aged>,
}

impl Sensor {
    /// Of an output about whose sensor nothing is said.
    pub(super) fn plain() -> Self {
        Self { every: 1, ..Self::default() }
    }

    /// What the measurement may be off by: the declared noise, half a count, and what the output moves in the jitter; as far
    /// as there is each.
    pub(super) fn noise(
        &self,
        declared: Option<Constant>,
        jitter: Option<&Constant>,
    ) -> Result<Vec<(&'static str, Constant)>, PolyError> {
        let count = self.quantum.as_ref().map(half).transpose()?;
        let moved = if self.aged.is_some() { None } else { self.max_rate.as_ref().zip(jitter) };
        let moved = moved.map(|(rate, jitter)| rate.times(jitter)).transpose()?;
        let parts = [("declared", declared), ("half a count", count), ("jitter", moved)];
        Ok(parts.into_iter().filter_map(|(what, part)| Some((what, part?))).collect())
    }
}

/// Half of a constant.
pub(crate) fn half(constant: &Constant) -> Result<Constant, PolyError> {
    constant.times(&Constant::from(Rational::from_parts(1.into(), 2_u8.into())))
}

/// All numbers of a counter, in counts.
fn whole(counter: Counter) -> Constant {
    Constant::from(Rational::from(counter.numbers()))
}

impl Reading<'_> {
    /// The keys of one output; `sample_time` and `jitter` as far as they could be read.
    pub(super) fn sensor(
        &mut self,
        output: &spec::Output,
        sample_time: Option<&Constant>,
        jitter: Option<&Constant>,
    ) -> Option<Sensor> {
        let written = &output.sensor;
        let quantum = self.above_zero(written.quantum.as_ref(), "one count", "write its size in the output's unit");
        let turn = self.turn(written);
        let max_rate =
            self.above_zero(written.max_rate.as_ref(), "the largest rate", "write it in the output's unit per second");
        let size = self.above_zero(written.gate.as_ref(), "a gate", "write how far a good sample may be off at most");
        let oldest = self.above_zero(written.age_max.as_ref(), "the oldest age", "write it in seconds");
        let (quantum, turn, max_rate, size, oldest) = (quantum?, turn?, max_rate?, size?, oldest?);
        let span = |quantity: &Option<Quantity>| quantity.as_ref().map_or(0..0, Quantity::span);
        let sensor = Sensor {
            turn: turn.zip(written.wrap.as_ref().map(Turn::span)),
            turn_moves: written.turn_moves.0,
            max_rate,
            quantum,
            floor: written.rounding.as_ref().is_some_and(|(rounding, _)| *rounding == Rounding::Floor),
            counter: written.counter.clone(),
            gate: size.map(|size| Gate {
                size,
                limit: written.gate_limit.as_ref().map(|(limit, _)| *limit),
                span: span(&written.gate),
            }),
            every: written.every.as_ref().map_or(1, |(every, _)| usize::try_from(*every).unwrap_or(1)),
            every_span: written.every.as_ref().map_or(0..0, |(_, span)| span.clone()),
            aged: match (&written.age, sample_time) {
                (Some(span), Some(h)) => Some(Aged { most: oldest.unwrap_or_else(|| h.clone()), span: span.clone() }),
                _ => None,
            },
        };
        self.check_turn(&sensor, output, sample_time);
        self.check_jitter(&sensor, output, jitter);
        Some(sensor)
    }

    /// One turn in the output's unit, if there is one; `None` outside when it is wrong.
    fn turn(&mut self, written: &spec::sensor::Sensor) -> Option<Option<Constant>> {
        match (&written.wrap, &written.counter) {
            (Some(Turn::Of(size)), _) => {
                self.above_zero(Some(size), "a turn", "write its size in the output's unit: `'2*pi'`")
            }
            (Some(Turn::OfTheCounter(_)), Some((counter, _))) => {
                let quantum =
                    written.quantum.as_ref().map_or(Some(Constant::one()), |quantum| self.constant(quantum))?;
                Some(quantum.times(&whole(*counter)).ok())
            }
            _ => Some(None),
        }
    }

    /// A counter that turns shows every number of its type.
    fn check_whole(&mut self, counts: &Constant, counter: Counter, sensor: &Sensor, output: &spec::Output) {
        let Some((limits, range)) = &output.range else { return };
        let Some((_, span)) = sensor.turn.as_ref().filter(|_| *counts == whole(counter)) else { return };
        let [low, high] = limits.as_slice() else { return };
        let (Some(low), Some(high)) = (self.constant(low), self.constant(high)) else { return };
        let one = Constant::one();
        let quantum = sensor.quantum.as_ref().unwrap_or(&one);
        let in_counts = |limit: &Constant| limit.over(quantum).ok().and_then(|c| c.to_f64().ok()).unwrap_or(f64::NAN);
        let (low, high, (least, most)) = (in_counts(&low), in_counts(&high), counter.range());
        if low <= least && high >= most {
            return;
        }
        let name = &output.named.name.value;
        let message = format!("`{name}` turns through every number of its type, and its range leaves some out");
        let label = format!("from {} to {} counts of {least} to {most}", decimal::show(low), decimal::show(high));
        let error = Diagnostic::error(codes::BAD_COMBINATION, range.clone(), message).label(label);
        let error = error.context(span.clone(), "a turn of all its numbers");
        self.found.push(error.help("leave out `wrap` if the samples stay within `range`, or `range` if they count on"));
    }

    /// Half a turn must be more than the output moves in a sample, and a turn a whole number of counts.
    fn check_turn(&mut self, sensor: &Sensor, output: &spec::Output, sample_time: Option<&Constant>) {
        let Some((turn, span)) = &sensor.turn else { return };
        let number = |constant: &Constant| constant.to_f64().unwrap_or(f64::NAN);
        let half = number(turn) / 2.0;
        if let Some((rate, h)) = sensor.max_rate.as_ref().zip(sample_time)
            && number(rate) * number(h) >= half
        {
            let moved = number(rate) * number(h);
            let name = &output.named.name.value;
            let message = format!("`{name}` may move by half a turn or more from sample to sample");
            let label = format!("up to {} a sample, half a turn is {}", decimal::show(moved), decimal::show(half));
            let error = Diagnostic::error(codes::OUT_OF_RANGE, span.clone(), message).label(label).measured(moved);
            let longest = decimal::show(half / number(rate));
            self.found.push(error.help(format!("a sample time below {longest} s: the way round could not be told")));
        }
        let Some((counter, counted)) = &sensor.counter else { return };
        let one = Constant::one();
        let counts = turn.over(sensor.quantum.as_ref().unwrap_or(&one)).ok();
        if !counts.as_ref().and_then(Constant::as_rational).is_some_and(|counts| counts.is_int()) {
            let message = "a turn must be a whole number of counts";
            let error = Diagnostic::error(codes::BAD_COMBINATION, span.clone(), message);
            let label =
                counts.as_ref().map_or_else(String::new, |c| format!("this is {} counts", decimal::show(number(c))));
            let error = error.label(label).context(counted.clone(), "counts are integers");
            self.found
                .push(error.help("write `wrap` in the output's unit and `quantum` as a share of it: `'2*pi/4096'`"));
        }
        if let Some(counts) = counts {
            self.check_whole(&counts, *counter, sensor, output);
        }
    }

    /// What a wrong time does to a sample depends on how fast the output moves.
    fn check_jitter(&mut self, sensor: &Sensor, output: &spec::Output, jitter: Option<&Constant>) {
        let (Some(jitter), None, None) = (jitter, &sensor.max_rate, &sensor.aged) else { return };
        let name = &output.named.name;
        let shown = decimal::show(jitter.to_f64().unwrap_or(f64::NAN));
        let message = format!("what a jitter of {shown} s does to `{}` depends on how fast it moves", name.value);
        let error = Diagnostic::error(codes::MISSING_KEY, name.span.clone(), message);
        self.found.push(error.help("write its `max_rate`, in its unit per second, or `age = \"measured\"`"));
    }

    /// A quantity above zero, if it is there; `None` outside when it is wrong.
    fn above_zero(&mut self, quantity: Option<&Quantity>, what: &str, help: &str) -> Option<Option<Constant>> {
        let Some(quantity) = quantity else { return Some(None) };
        let value = self.constant(quantity)?;
        self.not_below_zero(&value, quantity, what, false, help).then_some(Some(value))
    }
}
