//! What a step returns.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Field, Kind, Value};
use crate::sampled::settled::round;

pub(crate) fn field(name: &str, unit: &str, doc: &str) -> Field {
    Field { name: name.to_owned(), unit: unit.to_owned(), doc: doc.to_owned(), kind: Kind::Float }
}

/// What stands for a state before convergence: measured ones from the newest sample, the others their `initial`.
pub(crate) fn start(b: &mut Builder, plant: &Plant, state: usize, outputs: &[Value]) -> Value {
    let state = &plant.states[state];
    if state.measured.is_empty() {
        return b.float(round(&state.initial, plant.scalar));
    }
    let mut terms = Vec::new();
    for (output, weight) in &state.measured {
        let weight = b.float(round(weight, plant.scalar));
        terms.push(b.mul(weight, outputs[*output]));
    }
    b.sum(&terms)
}
