//! A start from a given state: what of it can be used, and what the model makes of it from call to call.
//!
//! The given state is of the call before the first step. What a number of any bits does: one that is not finite, or
//! beyond the bound that keeps every sum finite, counts as the state's own `initial`, and then nobody vouches.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Value, place};
use crate::sampled::settled::round;
use crate::step::front;
use crate::step::injections::initial_output;
use crate::step::logic::all;

/// The given state in a start, with `initial` for what cannot be used; and whether the caller vouches for all of it.
pub(crate) fn state(b: &mut Builder, plant: &Plant, bound: f64) -> (Vec<Value>, Value) {
    let (mut state, mut good) = (Vec::new(), vec![b.vouched()]);
    for (i, own) in plant.states.iter().enumerate() {
        let given = b.given(place(i));
        let usable = b.in_range(given, -bound, bound);
        let initial = b.float(round(&own.initial, plant.scalar));
        state.push(b.select(usable, given, initial));
        good.push(usable);
    }
    let vouched = all(b, &good);
    (turned_back(b, plant, state), vouched)
}

/// A state with the whole turns of outputs that wrap taken off, each along its direction.
pub(crate) fn turned_back(b: &mut Builder, plant: &Plant, mut state: Vec<Value>) -> Vec<Value> {
    for (o, output) in plant.outputs.iter().enumerate() {
        let Some(wrap) = &output.wrap else { continue };
        let shown = sum(b, plant, &state, o);
        let turns = front::turns(b, shown, round(&wrap.turn, plant.scalar));
        for (x, direction) in state.iter_mut().zip(&wrap.direction) {
            let size = direction.times(&wrap.turn).ok().filter(|size| !size.is_zero());
            if let Some(size) = size {
                let size = b.float(round(&size, plant.scalar));
                let whole = b.mul(turns, size);
                *x = b.sub(*x, whole);
            }
        }
    }
    state
}

/// What an output shows of a state, within its range; else what it shows of the initial one.
pub(crate) fn shown(b: &mut Builder, plant: &Plant, state: &[Value], output: usize, range: (f64, f64)) -> Value {
    let shown = sum(b, plant, state, output);
    let good = b.in_range(shown, range.0, range.1);
    let initial = b.float(initial_output(plant, output, plant.scalar));
    b.select(good, shown, initial)
}

/// C x of one output.
fn sum(b: &mut Builder, plant: &Plant, state: &[Value], output: usize) -> Value {
    let mut terms = Vec::new();
    for (c, x) in plant.c[output].iter().zip(state).filter(|(c, _)| !c.is_zero()) {
        let c = b.float(round(c, plant.scalar));
        terms.push(b.mul(c, *x));
    }
    b.sum(&terms)
}
