//! A counter whose samples are kept as they come: how far it has come is an exact difference of integers, whatever it
//! has counted to, also across its overflow.
//!
//! Where a turn divides the counter's range, what it shows says where it is. Elsewhere it overflows in the middle of a
//! turn, and singles do not hold every count of 32 bits: there its place is followed from sample to sample, in integers.
//! The first good sample is that many counts from 0.

use super::{fold, has_inputs, in_scalar, turns};
use crate::plant::{Output, Plant};
use crate::program::builder::Builder;
use crate::program::{CellId, Scalar, Value, place};
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
    /// Where its place is followed.
    followed: Option<Followed>,
}

/// The last good sample of a counter.
#[derive(Clone, Copy, Debug)]
struct Followed {
    /// What it showed.
    count: CellId,
    /// Where that is within a turn: 0 to one less than the turn.
    within: CellId,
    /// Counts of a turn.
    turn: u32,
}

/// Half of all numbers of 32 bits: with it, signed ones are unsigned.
const HALF: u32 = 1 << 31;
/// Counts of a turn below which three turns are a number of 32 bits.
const FOLLOWED: f64 = 1_073_741_824.0;

impl Counts {
    /// Declares what is kept of an output whose differences are those of its counts.
    pub(crate) fn declare(b: &mut Builder, plant: &Plant, output: &Output) -> Option<Self> {
        let counts = Self::of(plant, output)?;
        let followed = counts.uneven_turn().map(|turn| {
            let name = &output.label.name;
            // Half a range from it, so that the first difference is the count itself.
            let middle = if counts.signed { 0 } else { 1 << (counts.bits - 1) };
            let doc = format!("what {name} counted to at its last good sample");
            let count = b.index_cell(&format!("count_{name}"), &doc, middle);
            let doc = format!("where that is within a turn of {name}, in counts");
            Followed { count, within: b.index_cell(&format!("within_{name}"), &doc, middle % turn), turn }
        });
        Some(Self { followed, ..counts })
    }

    /// Of an output whose differences are those of its counts.
    ///
    /// Not of one that has inputs in it or arrives late, nor where a turn is more than half of the counter's range and
    /// not all of it: there, samples are floats.
    fn of(plant: &Plant, output: &Output) -> Option<Self> {
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
        Some(Self { bits: counter.bits, signed: counter.signed, quantum, shift, turn, followed: None })
    }

    /// How far the counter has come from `before` to `now`, in the output's unit, folded into half a turn.
    pub(crate) fn moved(&self, b: &mut Builder, now: Value, before: Value) -> Value {
        let counts = self.steps(b, now, before);
        self.in_unit(b, counts)
    }

    /// The same as a signed number of counts, not folded.
    fn difference(&self, b: &mut Builder, now: Value, before: Value) -> Value {
        b.wrap_difference(now, before, self.bits)
    }

    /// The same in counts.
    pub(crate) fn steps(&self, b: &mut Builder, now: Value, before: Value) -> Value {
        let counts = self.difference(b, now, before);
        let counts = b.signed_to_float(counts);
        self.folded(b, counts)
    }

    /// Where a count is, in the output's unit, within half a turn of zero.
    pub(crate) fn place(&self, b: &mut Builder, count: Value) -> Value {
        if let Some(followed) = self.followed {
            let within = self.within(b, followed, count);
            let counts = b.to_float(within);
            return self.in_turn(b, counts);
        }
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
        self.in_turn(b, counts)
    }

    /// Keeps a sample of an output that is good, where its place is followed.
    pub(crate) fn keep(&self, b: &mut Builder, output: usize, good: Value) {
        let Some(followed) = self.followed else { return };
        let now = b.read_count(place(output));
        let within = self.within(b, followed, now);
        for (cell, value) in [(followed.count, now), (followed.within, within)] {
            let before = b.read(cell);
            let after = b.select(good, value, before);
            b.set(cell, after);
        }
    }

    /// Where a count is within its turn, from the last good sample on.
    fn within(&self, b: &mut Builder, followed: Followed, count: Value) -> Value {
        let turn = followed.turn;
        let (last, within) = (b.read(followed.count), b.read(followed.within));
        let moved = self.difference(b, count, last);
        // `moved + 2^31` is not negative; what that is too much of a turn is made up for.
        let (half, rest) = (b.index(HALF), b.index(turn - HALF % turn));
        let moved = b.wrap_add(moved, half);
        let moved = b.remainder(moved, turn);
        let sum = b.wrap_add(within, moved);
        let sum = b.wrap_add(sum, rest);
        b.remainder(sum, turn)
    }

    /// Counts of a turn that does not divide the counter's range.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number, below 2^30")]
    fn uneven_turn(&self) -> Option<u32> {
        let turn = self.turn.filter(|turn| (1.0..FOLLOWED).contains(turn))? as u32;
        (!(1_u64 << self.bits).is_multiple_of(turn.into())).then_some(turn)
    }

    /// Counts of a turn in the output's unit, within half a turn of zero.
    fn in_turn(&self, b: &mut Builder, counts: Value) -> Value {
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
