//! What rounding does to an estimate from a window, whatever computes it.

use super::realize::{Load, Way};
use super::{Functional, Weights};
use crate::numbers::count;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::program::builder::additions;
use crate::promise::rounding::{output, reading, signal, unit};

/// Per state, the most that rounding adds in single precision, for the samples, inputs and terms of `promise::rounding`:
/// of a realisation with this load and these noise gains. Empty in double precision, and where samples that are there are
/// solved for.
pub fn bound(plant: &Plant, functional: &Functional, way: &Way, gains: &[Vec<f64>]) -> Vec<f64> {
    if plant.scalar != Scalar::F32 || functional.gaps.is_some() || functional.irregular.is_some() {
        return Vec::new();
    }
    let wraps = plant.outputs.iter().any(|output| output.wrap.is_some());
    let own = match way.load() {
        None if !wraps => (0..plant.states.len()).map(|i| unit(plant.scalar) * in_turn(plant, functional, i)).collect(),
        None => lumped(plant, functional, &functional.load(plant)),
        Some(load) => lumped(plant, functional, load),
    };
    let read: Vec<f64> = plant.outputs.iter().map(|output| reading(output, unit(plant.scalar))).collect();
    let of_state =
        |(own, gains): (f64, &Vec<f64>)| own + gains.iter().zip(&read).map(|(gain, read)| gain * read).sum::<f64>();
    own.into_iter().zip(gains).map(of_state).collect()
}

/// A load is of samples of 1.
fn lumped(plant: &Plant, functional: &Functional, load: &Load) -> Vec<f64> {
    let signals = functional.signals.iter().map(|it| signal(plant, it));
    // Constants are no samples, and stand in it with their own size.
    let least = if functional.constant.iter().any(|entry| entry.double != 0.0) { 1.0 } else { 0.0 };
    // Of what wraps, differences to the newest sample are summed.
    let turns = if plant.outputs.iter().any(|output| output.wrap.is_some()) { 2.0 } else { 1.0 };
    let largest = turns * plant.outputs.iter().map(output).chain(signals).fold(least, f64::max);
    load.round_off.iter().map(|own| own * largest).collect()
}

/// What the sums lose, in units, where they run from the newest sample back: an addition loses half of the last bit of what
/// has been summed until then.
fn in_turn(plant: &Plant, functional: &Functional, state: usize) -> f64 {
    let outputs = functional.outputs.iter().zip(plant.outputs.iter().map(output));
    let signals = functional.knowns.iter().zip(functional.signals.iter().map(|it| signal(plant, it)));
    let (mut lost, mut summed) = (0.0, functional.constant[state].double.abs());
    let mut add = |(weights, size): (&Weights, f64)| {
        for age in weights.ages() {
            let term = weights.at(state, age).double.abs() * size;
            summed += term;
            lost += 2.0 * term + summed;
        }
    };
    outputs.chain(signals).for_each(&mut add);
    lost + count(additions(functional.outputs.len() + functional.knowns.len() + 1)) * summed
}
