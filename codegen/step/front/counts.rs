//! A counter whose samples are kept as they come: how far it has come is an exact difference of integers, whatever it
//! has counted to, also across its overflow.

use super::{fold, has_inputs, in_scalar, turns};
use crate::plant::{Output, Plant};
use crate::program::builder::Builder;
use crate::program::{Scalar, Value};
use crate::sampled::settled::round;

/// A counter that wraps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counts {
    /// 16 or 32.
    pub(crate) bits: u8,
    signed: bool,
    /// One count, in the output's unit.
    quantum: f64,
    /// What is added to a sample, with a turn, in the output's unit.
    shift: Option<(f64, f64)>,
    /// Counts of a turn, where that is less than the counter's own range.
    turn: Option<f64>,
}

impl Counts {
    /// Of an output whose differences are those of its counts.
    ///
    /// Not of one that has inputs in it or arrives late, nor where a turn is more than half of the counter's range and
    /// not all of it: there, samples are floats.
    pub(crate) fn of(plant: &Plant, output: &Output) -> Option<Self> {
        let (counter, wrap) = (output.counter?, output.wrap.as_ref()?);
        let quantum = output.quantum.as_ref().map_or(1.0, |quantum| round(quantum, plant.scalar));
        let turn = match &output.quantum {
            Some(quantum) => wrap.turn.over(quantum).ok()?.to_f64().ok()?,
            None => wrap.turn.to_f64().ok()?,
        };
        let range = if counter.bits == 16 { 65_536.0 } else { 4_294_967_296.0 };
        if has_inputs(output) || output.delay.is_some() || (turn > range / 2.0 && turn < range) {
            return None;
        }
        let turn = (turn < range).then(|| in_scalar(turn, plant.scalar));
        let shift = output.shift().map(|shift| (round(&shift, plant.scalar), round(&wrap.turn, plant.scalar)));
        Some(Self { bits: counter.bits, signed: counter.signed, quantum, shift, turn })
    }

    /// How far the counter has come from `before` to `now`, in the output's unit, folded into half a turn.
    pub(crate) fn moved(&self, b: &mut Builder, now: Value, before: Value) -> Value {
        let counts = self.steps(b, now, before);
        self.in_unit(b, counts)
    }

    /// The same in counts.
    pub(crate) fn steps(&self, b: &mut Builder, now: Value, before: Value) -> Value {
        let counts = b.wrap_difference(now, before, self.bits);
        let counts = b.signed_to_float(counts);
        self.folded(b, counts)
    }

    /// Where a count is, in the output's unit, within half a turn of zero.
    pub(crate) fn place(&self, b: &mut Builder, count: Value) -> Value {
        let none = b.index(0);
        let counts = match self.turn {
            // A power of two divides what singles cannot hold of 32 bits.
            Some(turn) if self.bits == 32 && b.scalar() == Scalar::F32 && is_power_of_two(turn) => {
                let low = b.wrap_difference(count, none, 16);
                let high = b.wrap_difference(count, low, 32);
                let (low, high) = (b.signed_to_float(low), b.signed_to_float(high));
                let high = fold(b, high, turn);
                b.add(high, low)
            }
            Some(_) if !self.signed => b.to_float(count),
            _ => {
                let extended = b.wrap_difference(count, none, self.bits);
                b.signed_to_float(extended)
            }
        };
        let counts = self.folded(b, counts);
        let value = self.in_unit(b, counts);
        let Some((shift, turn)) = self.shift else { return value };
        let shift = b.float(shift);
        let value = b.add(value, shift);
        fold(b, value, turn)
    }

    /// The count that is nearest to so much further than another.
    pub(crate) fn further(&self, b: &mut Builder, count: Value, by: Value) -> Value {
        let counts = turns(b, by, self.quantum);
        let counts = b.from_float(counts);
        b.wrap_add(count, counts)
    }

    fn folded(&self, b: &mut Builder, counts: Value) -> Value {
        self.turn.map_or(counts, |turn| fold(b, counts, turn))
    }

    /// Counts in the output's unit.
    pub(crate) fn in_unit(&self, b: &mut Builder, counts: Value) -> Value {
        let quantum = b.float(self.quantum);
        b.mul(quantum, counts)
    }
}

/// Whether a number of counts is a power of two: its mantissa has no other digit.
fn is_power_of_two(counts: f64) -> bool {
    counts.to_bits() & ((1 << (f64::MANTISSA_DIGITS - 1)) - 1) == 0
}
