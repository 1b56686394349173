//! How the error of the model's run from a given state moves, and for how long that is within the bound.

use nalgebra::DMatrix;

use super::super::super::{Functional, Weights};
use super::super::longest_calls;
use crate::plant::Plant;
use crate::promise::Certificate;
use crate::promise::kernel::slope;
use crate::promise::vouched::{Run, Trust};
use crate::sampled::Source;
use crate::sampled::carry::Carry;
use crate::sampled::settled::Settled;

/// Per state: whether the estimate has it of the newest samples alone.
pub(crate) fn taken(plant: &Plant, functional: &Functional) -> Vec<bool> {
    if functional.irregular.is_some() {
        return vec![false; plant.states.len()];
    }
    let older = |weights: &Weights, i: usize, newest: usize| {
        let column = weights.columns[i].iter().flatten();
        column.enumerate().any(|(k, weight)| weights.first + k >= newest && *weight != Settled::default())
    };
    let newest = |i: usize| {
        let mut all =
            functional.outputs.iter().map(|w| older(w, i, 1)).chain(functional.knowns.iter().map(|w| older(w, i, 0)));
        !all.any(|older| older)
    };
    (0..plant.states.len()).map(|i| !plant.states[i].measured.is_empty() && newest(i)).collect()
}

/// For how many calls the run is trusted.
pub(crate) fn trust(
    plant: &Plant,
    functional: &Functional,
    (carry, taken): (&Carry, &[bool]),
    promised: &Certificate,
) -> Trust {
    let n = plant.states.len();
    let own = |i: usize| f64::from(u8::from(!taken[i]));
    let entry = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double);
    let carried = DMatrix::from_fn(n, n, |i, j| own(i) * entry(&carry.phi[i][j]));
    let level = |o: usize| plant.outputs[o].noise.as_ref().and_then(|noise| noise.to_f64().ok()).unwrap_or(0.0);
    let mut columns = Vec::new();
    for o in 0..plant.outputs.len() {
        let weight = |i: usize| plant.states[i].measured.iter().find(|(output, _)| *output == o);
        let shown = |i: usize| weight(i).map_or(0.0, |(_, weight)| weight.to_f64().unwrap_or(0.0));
        columns.push(DMatrix::from_fn(n, 1, |i, _| (1.0 - own(i)) * shown(i) * level(o)));
        for (s, signal) in functional.signals.iter().enumerate() {
            let Source::Injection(k) = signal.source else { continue };
            let off = slope(plant, k, o).unwrap_or(0.0) * level(o);
            for effect in [&carry.begin[s], &carry.end[s]] {
                columns.push(DMatrix::from_fn(n, 1, |i, _| own(i) * entry(&effect[i]) * off));
            }
        }
    }
    let enters = DMatrix::from_fn(n, columns.len(), |i, column| columns[column][(i, 0)]);
    let disturbed = DMatrix::from_diagonal(&nalgebra::DVector::from_fn(n, |i, _| own(i)));
    let identity = DMatrix::identity(n, n);
    let run = Run { map: carried, start: identity.clone(), enters, disturbed, shown: identity };
    run.trust(plant, promised, longest_calls(functional))
}
