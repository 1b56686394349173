//! What a turn of an output moves besides the output itself.
//!
//! The direction of a turn may have more in it than the output: an angle on the same shaft, but also a load that makes up
//! for a spring. Such a load is known up to whole multiples of its move only, which nobody expects who writes `wrap`.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Constant;
use crate::numbers::short;

use super::Plant;
use super::sensor::Wrap;

/// A state that a turn moves.
#[derive(Clone, Debug)]
pub struct Moved {
    /// Its place.
    pub state: usize,
    /// By how much, in its unit.
    pub by: Constant,
    /// Whether it is an angle that turns too: by whole turns, in the output's unit.
    pub turns: bool,
}

/// What a turn moves besides what the output shows.
pub fn besides(plant: &Plant, output: usize, wrap: &Wrap) -> Vec<Moved> {
    let shown: Vec<usize> = moves(wrap).filter(|j| !plant.c[output][*j].is_zero()).collect();
    let own = |j: usize| shown.as_slice() == [j];
    moves(wrap).filter(|j| !own(*j)).filter_map(|j| moved(plant, output, wrap, j)).collect()
}

fn moves(wrap: &Wrap) -> impl Iterator<Item = usize> {
    (0..wrap.direction.len()).filter(|j| !wrap.direction[*j].is_zero())
}

fn moved(plant: &Plant, output: usize, wrap: &Wrap, state: usize) -> Option<Moved> {
    let share = &wrap.direction[state];
    let unit = &plant.states[state].label.unit;
    let whole = share.as_rational().is_some_and(|share| share.is_int());
    let turns = whole && !unit.is_empty() && *unit == plant.outputs[output].label.unit;
    Some(Moved { state, by: share.times(&wrap.turn).ok()?, turns })
}

/// Refuses a turn that moves something else than angles.
pub(super) fn refusal(plant: &Plant, output: usize, wrap: &Wrap, moved: &Moved) -> Diagnostic {
    let (state, by) = (&plant.states[moved.state].label, moved.by.to_f64().unwrap_or(f64::NAN));
    let message =
        format!("a turn of `{}` moves `{}` by {}", plant.outputs[output].label.name, state.name, shown(moved, plant));
    let error = Diagnostic::error(codes::METHOD_CANNOT, wrap.span.clone(), message).measured(by);
    let error = error.label(format!("so `{}` would be known up to whole multiples of that", state.name));
    error.context(state.span.clone(), "this is moved").help(
        "leave `wrap` out and hand over an angle that counts turns; or, if so much is enough to know, write \
         `turn_moves = \"accept\"`",
    )
}

fn shown(moved: &Moved, plant: &Plant) -> String {
    let unit = &plant.states[moved.state].label.unit;
    let by = short(moved.by.to_f64().unwrap_or(f64::NAN));
    if unit.is_empty() { by } else { format!("{by} {unit}") }
}

/// What is to be said of the turns of a plant's outputs, a line for each state that they move.
pub fn notes(plant: &Plant) -> Vec<String> {
    let mut notes = Vec::new();
    for (o, output) in plant.outputs.iter().enumerate() {
        for moved in output.wrap.iter().flat_map(|wrap| besides(plant, o, wrap)) {
            let state = &plant.states[moved.state].label.name;
            let by = shown(&moved, plant);
            notes.push(format!(
                "a turn of {} moves {state} by {by}: it is known up to whole multiples of that",
                output.label.name
            ));
        }
    }
    notes
}
