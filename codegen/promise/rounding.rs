//! The model of rounding that every bound on it shares: half of a float's last bit at each operation, and how large the
//! numbers are on which it is.

use crate::expr::bounds::enclose;
use crate::plant::{Output, Plant};
use crate::program::Scalar;
use crate::sampled::settled::Settled;
use crate::sampled::{Signal, Source};

use super::kernel::range;

/// Half of the distance from 1 to the next float: what one operation loses of its result, at most.
pub fn unit(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32 => f64::from(f32::EPSILON) / 2.0,
        Scalar::F64 => f64::EPSILON / 2.0,
    }
}

/// Roundings of a constant with its product: none where it is a power of two, or there is none.
pub fn of_product(factor: Option<Settled>) -> f64 {
    let exact = factor.is_none_or(|factor| factor.double.to_bits().trailing_zeros() >= 52);
    if exact { 0.0 } else { 2.0 }
}

/// The magnitude of an output without what it has of inputs and constants: by its declared range; where none is
/// declared, of samples up to 1.
pub fn output(output: &Output) -> f64 {
    let largest = |(low, high): &(crate::expr::Constant, crate::expr::Constant)| {
        let size = |limit: &crate::expr::Constant| limit.to_f64().unwrap_or(f64::INFINITY).abs();
        size(low).max(size(high))
    };
    if let Some(wrap) = &output.wrap {
        return 0.5 * wrap.turn.to_f64().unwrap_or(f64::INFINITY).abs();
    }
    match (&output.range, &output.raw_range) {
        (Some(range), _) => largest(range),
        (None, Some(raw)) => largest(raw) + beside(output),
        (None, None) => 1.0 + beside(output),
    }
}

/// The magnitude of a sample as it comes.
pub fn sample(output: &Output) -> f64 {
    let declared = output.raw_range.as_ref().map(|(low, high)| {
        let size = |limit: &crate::expr::Constant| limit.to_f64().unwrap_or(f64::INFINITY).abs();
        size(low).max(size(high))
    });
    declared.unwrap_or_else(|| self::output(output) + beside(output))
}

/// What inputs up to 1 and constants add to a sample.
fn beside(output: &Output) -> f64 {
    let size = |number: &crate::expr::Constant| number.to_f64().unwrap_or(f64::INFINITY).abs();
    output.feedthrough.iter().map(size).sum::<f64>() + output.shift().map_or(0.0, |shift| size(&shift))
}

/// What reading a sample loses: its constant, each of its inputs, its turns.
pub fn reading(output: &Output, unit: f64) -> f64 {
    let size = |number: &crate::expr::Constant| number.to_f64().unwrap_or(f64::INFINITY).abs();
    let largest = sample(output);
    let counted = if output.counter.is_some() { 2.0 * largest } else { 0.0 };
    let shifted = output.shift().map_or(0.0, |shift| largest + size(&shift));
    let inputs = output.feedthrough.iter().filter(|factor| !factor.is_zero());
    let inputs = inputs.map(|factor| largest + 3.0 * size(factor)).sum::<f64>();
    let turned = output.wrap.as_ref().map_or(0.0, |wrap| 4.0 * size(&wrap.turn));
    unit * (counted + shifted + inputs + turned)
}

/// The magnitude of a known signal: 1 for an input, for a nonlinear term its bound over the declared ranges, or 1.
pub fn signal(plant: &Plant, signal: &Signal) -> f64 {
    let Source::Injection(k) = signal.source else { return 1.0 };
    let size = enclose(&plant.injections[k].node.poly, &|symbol| range(plant, symbol)).magnitude();
    if size.is_finite() { size } else { 1.0 }
}

/// What is taken to be up to 1, because nothing bounds it.
pub fn taken(plant: &Plant) -> Vec<&str> {
    let open = |output: &&Output| output.wrap.is_none() && output.range.is_none() && output.raw_range.is_none();
    let outputs = plant.outputs.iter().filter(open).map(|output| output.label.name.as_str());
    let mut all: Vec<&str> = outputs.chain(plant.inputs.iter().map(|input| input.label.name.as_str())).collect();
    let unbounded = |injection: &crate::plant::Injection| {
        !enclose(&injection.node.poly, &|symbol| range(plant, symbol)).magnitude().is_finite()
    };
    if plant.injections.iter().any(unbounded) {
        all.push("nonlinear terms");
    }
    all
}
