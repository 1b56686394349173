//! The front end: from what the caller measured to the output `C x`.
//!
//! A sample as it comes may count, round down, wrap, and have inputs and a constant in it. What every method works with
//! is `C x` plus noise, in the output's unit; a wrapped one within half a turn of zero.

pub(crate) mod counts;
mod reduce;

use crate::plant::{Output, Plant};
use crate::program::builder::Builder;
use crate::program::{Field, Kind, Scalar, Value, place};
use crate::sampled::settled::round;
use counts::Counts;

/// What the caller hands over of an output.
pub(crate) fn measurement(output: &Output) -> Field {
    let kind = output.counter.map_or(Kind::Float, |counter| Kind::Count { bits: counter.bits, signed: counter.signed });
    let (name, unit, doc) = (output.label.name.clone(), output.label.unit.clone(), output.label.doc.clone());
    Field { name, unit, doc, kind }
}

/// A measured output, and whether it may be used: finite, within its range. `range` is what `C x` may be.
///
/// Inputs are still in it: [`without_inputs`] follows when they are known.
pub(crate) fn read(
    b: &mut Builder,
    plant: &Plant,
    output: usize,
    counter: Option<Counts>,
    range: (f64, f64),
) -> (Value, Value) {
    let (sensor, scalar) = (&plant.outputs[output], plant.scalar);
    let sample = sample(b, sensor, output, scalar);
    let bare = sensor.raw_range.is_none() && sensor.wrap.is_none() && !has_inputs(sensor);
    if bare {
        let value = shifted(b, sensor, sample, scalar);
        return (value, b.in_range(value, range.0, range.1));
    }
    let rounded = |limit| round(limit, scalar);
    let declared = sensor.raw_range.as_ref().map(|(low, high)| (rounded(low), rounded(high)));
    let (low, high) = match &sensor.wrap {
        Some(wrap) => {
            let most = farthest(rounded(&wrap.turn), scalar);
            declared.map_or((-most, most), |(low, high)| (low.max(-most), high.min(most)))
        }
        None => declared.unwrap_or(range),
    };
    let good = if sensor.counter.is_some() && sensor.raw_range.is_none() {
        // A count is always a number.
        b.boolean(true)
    } else {
        b.in_range(sample, low, high)
    };
    if let Some(counts) = counter {
        let count = b.read_count(place(output));
        return (counts.place(b, count), good);
    }
    if has_inputs(sensor) {
        return (shifted(b, sensor, sample, scalar), good);
    }
    let value = reduced(b, sensor, sample, scalar);
    (shifted_within(b, sensor, value, scalar), good)
}

/// A sample as a float, in the output's unit.
fn sample(b: &mut Builder, sensor: &Output, output: usize, scalar: Scalar) -> Value {
    let Some(counter) = sensor.counter else { return b.read_measurement(place(output)) };
    let count = b.read_count(place(output));
    let count = if counter.signed { b.signed_to_float(count) } else { b.to_float(count) };
    let Some(quantum) = &sensor.quantum else { return count };
    let quantum = b.float(round(quantum, scalar));
    b.mul(quantum, count)
}

/// The same without the inputs that the sample has in it; `inputs` are those until now.
pub(crate) fn without_inputs(
    b: &mut Builder,
    plant: &Plant,
    output: usize,
    (value, good): (Value, Value),
    inputs: &[Value],
    range: (f64, f64),
) -> (Value, Value) {
    let sensor = &plant.outputs[output];
    if !has_inputs(sensor) {
        return (value, good);
    }
    let mut value = value;
    for (factor, input) in sensor.feedthrough.iter().zip(inputs).filter(|(factor, _)| !factor.is_zero()) {
        let factor = b.float(round(factor, plant.scalar));
        let share = b.mul(factor, *input);
        value = b.sub(value, share);
    }
    let value = reduced(b, sensor, value, plant.scalar);
    let sane = b.in_range(value, range.0, range.1);
    (value, b.and(good, sane))
}

/// A sample within half a turn of zero, where the output wraps.
fn reduced(b: &mut Builder, output: &Output, value: Value, scalar: Scalar) -> Value {
    match &output.wrap {
        Some(wrap) => reduce::reduce(b, value, &wrap.turn, scalar),
        None => value,
    }
}

/// A difference folded into half a turn, where the output wraps.
pub(crate) fn folded(b: &mut Builder, output: &Output, value: Value, scalar: Scalar) -> Value {
    match &output.wrap {
        Some(wrap) => fold(b, value, round(&wrap.turn, scalar)),
        None => value,
    }
}

/// A value of at most [`farthest`] folded into half a turn: itself, bit for bit, where it is there already.
///
/// The nearest whole number of turns comes from adding and subtracting a number in whose neighbourhood floats are whole.
pub(crate) fn fold(b: &mut Builder, value: Value, turn: f64) -> Value {
    let turns = turns(b, value, turn);
    let size = b.float(turn);
    let whole = b.mul(turns, size);
    b.sub(value, whole)
}

/// The nearest whole number of turns.
pub(crate) fn turns(b: &mut Builder, value: Value, turn: f64) -> Value {
    let scalar = b.scalar();
    let share = b.float(in_scalar(1.0 / turn, scalar));
    let turns = b.mul(value, share);
    let whole = b.float(match scalar {
        Scalar::F32 => 12_582_912.0,
        Scalar::F64 => 6_755_399_441_055_744.0,
    });
    let near = b.add(turns, whole);
    b.sub(near, whole)
}

/// How far from zero a value may be that is folded: 2^20 turns in single precision, 2^49 in double, so that the sum above
/// keeps every whole number; and no further than can be computed with.
pub(crate) fn farthest(turn: f64, scalar: Scalar) -> f64 {
    in_scalar(
        match scalar {
            Scalar::F32 => (turn * 1_048_576.0).min(1e37),
            Scalar::F64 => (turn * 562_949_953_421_312.0).min(1e307),
        },
        scalar,
    )
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to the nearest single is what is asked")]
fn in_scalar(value: f64, scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32 => f64::from(value as f32),
        Scalar::F64 => value,
    }
}

/// Whether a sample has inputs in it.
fn has_inputs(output: &Output) -> bool {
    output.feedthrough.iter().any(|factor| !factor.is_zero())
}

/// The same of what is within half a turn, so that the sum is too.
fn shifted_within(b: &mut Builder, output: &Output, value: Value, scalar: Scalar) -> Value {
    if output.shift().is_none() {
        return value;
    }
    let value = shifted(b, output, value, scalar);
    folded(b, output, value, scalar)
}

/// Without the constant, and with half a count where the sensor rounds down.
fn shifted(b: &mut Builder, output: &Output, sample: Value, scalar: Scalar) -> Value {
    let Some(shift) = output.shift() else { return sample };
    let shift = b.float(round(&shift, scalar));
    b.add(sample, shift)
}
