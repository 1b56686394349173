//! What a step returns.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Field, Kind, Status, Value};
use crate::sampled::settled::round;

use super::ahead::Ahead;
use super::injections::Injections;

/// How an answer is moved to a later time, with what is known of this call.
pub(crate) struct Moved<'a> {
    pub(crate) ahead: &'a Ahead,
    pub(crate) injections: Injections<'a>,
    /// Per output: what stands for its sample.
    pub(crate) outputs: &'a [Value],
}

/// Answers under the states' names, with something behind them.
pub(crate) fn estimates(b: &mut Builder, plant: &Plant, estimate: Vec<Value>, moved: Option<Moved>, behind: &str) {
    let answer = match moved {
        Some(Moved { ahead, injections, outputs }) => ahead.moved(b, plant, &estimate, &injections, outputs),
        None => estimate,
    };
    for (state, value) in plant.states.iter().zip(answer) {
        let name = format!("{}{behind}", state.label.name);
        b.estimate(field(&name, &state.label.unit, &state.label.doc), value);
    }
}

/// Answers the calls since the newest accepted sample.
pub(crate) fn coasted(b: &mut Builder, coasted: Value) {
    let (name, doc) = ("coasted".into(), "calls since the newest accepted sample".into());
    b.estimate(Field { name, unit: String::new(), doc, kind: Kind::Index }, coasted);
}

/// Converging until the estimate is known; then coasting, unless nothing has been replaced in it.
pub(crate) fn status(b: &mut Builder, known: Value, clean: Value) {
    let [converged, coasting, converging] =
        [Status::Converged, Status::Coasting, Status::Converging].map(|status| b.status(status));
    let working = b.select(clean, converged, coasting);
    let status = b.select(known, working, converging);
    b.report(status);
}

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
