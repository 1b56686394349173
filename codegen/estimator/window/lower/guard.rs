//! The bound on what may enter a window: its weights' largest sums.

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::sampled::settled::Settled;
use crate::step::guard::{Guard, lost};

use super::super::{Functional, Prediction};

/// What else a step computes from samples: the largest sums, for samples of magnitude 1.
#[derive(Clone, Copy, Debug, Default)]
pub struct Growth {
    /// Of samples.
    pub linear: f64,
    /// Of products of two samples.
    pub square: f64,
}

/// Refuses weights that the target's floats cannot hold: beyond their range, or all of a column below it.
fn refuse_lost_weights(plant: &Plant, functional: &Functional) -> Result<(), Vec<Diagnostic>> {
    let weights = functional.windows().flat_map(|window| window.outputs.iter().chain(&window.knowns));
    let columns = weights.flat_map(|w| w.columns.iter().flatten());
    let smallest = match plant.scalar {
        Scalar::F32 => f64::from(f32::MIN_POSITIVE),
        Scalar::F64 => f64::MIN_POSITIVE,
    };
    let mut all: Vec<Settled> = functional.windows().flat_map(|window| window.constant.clone()).collect();
    let of_way = functional.way.columns();
    for column in columns.chain(&of_way) {
        all.extend(column);
        let largest = column.iter().map(|w| w.double.abs()).fold(0.0, f64::max);
        if largest < smallest && largest > 0.0 {
            return Err(vec![lost(plant, "small", largest)]);
        }
    }
    for prediction in &functional.prediction {
        let parts = [&prediction.states, &prediction.held, &prediction.end];
        all.extend(parts.into_iter().flatten().flatten());
        all.push(prediction.constant);
    }
    match all.iter().find(|weight| !weight.value(plant.scalar).is_finite()) {
        Some(weight) => Err(vec![lost(plant, "large", weight.double)]),
        None => Ok(()),
    }
}

/// The largest sum of magnitudes in a step, for samples of magnitude 1; at least 1.
fn largest_gain(plant: &Plant, functional: &Functional) -> f64 {
    let size = |value: &Option<Settled>| value.map_or(0.0, |v| v.double.abs());
    let one = |window: &Functional, i: usize| -> f64 {
        let weights = window.outputs.iter().chain(&window.knowns);
        let turns = plant.outputs.iter().flat_map(|output| &output.wrap).map(|wrap| wrap.direction[i].to_f64());
        let newest: f64 = turns.map(|s| s.unwrap_or(0.0).abs()).sum();
        // Differences of what wraps are summed up from sample to sample.
        let turned =
            if plant.outputs.iter().any(|o| o.wrap.is_some()) { crate::numbers::count(window.steps) } else { 1.0 };
        turned * weights.map(|w| w.l1(i)).sum::<f64>() + window.constant[i].double.abs() + newest
    };
    let state = |i: usize| functional.windows().map(|window| one(window, i)).fold(0.0, f64::max);
    let mut states: Vec<f64> = (0..plant.states.len()).map(state).collect();
    // Whatever else the way adds up on its way to a state, cells included.
    let of_way = functional.way.load().map_or(0.0, |load| load.gain);
    for gain in &mut states {
        *gain = gain.max(of_way);
    }
    if let Some(irregular) = &functional.irregular {
        // What wraps is summed up from slot to slot.
        let summed = if plant.outputs.iter().any(|o| o.wrap.is_some()) { irregular.rows.len() } else { 1 };
        let largest = irregular.largest_gain() * crate::numbers::count(summed);
        for gain in &mut states {
            *gain = gain.max(largest);
        }
    }
    let prediction = |p: &Prediction| -> f64 {
        let own: f64 = p.states.iter().zip(&states).map(|(weight, gain)| size(weight) * gain).sum();
        let signals: f64 = p.held.iter().chain(&p.end).map(|weight| 2.0 * size(weight)).sum();
        own + signals + p.constant.double.abs()
    };
    let start =
        |s: &crate::plant::State| -> f64 { s.measured.iter().map(|(_, w)| w.to_f64().unwrap_or(0.0).abs()).sum() };
    let predictions = functional.prediction.iter().map(prediction);
    states.iter().copied().chain(predictions).chain(plant.states.iter().map(start)).fold(1.0, f64::max)
}

/// Finds the bound; a weight or range that the target's floats cannot hold is an error.
pub(crate) fn bound(plant: &Plant, functional: &Functional, growth: Growth) -> Result<Guard, Vec<Diagnostic>> {
    refuse_lost_weights(plant, functional)?;
    Guard::with_gain(plant, largest_gain(plant, functional).max(growth.linear), growth.square)
}
