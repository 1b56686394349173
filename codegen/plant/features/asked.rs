//! What a specification asks for, with the places; and what no method can be asked for.

use std::ops::Range;

use super::Feature;
use crate::diagnostic::{Diagnostic, codes};
use crate::numbers::count;
use crate::plant::Plant;

/// What is asked for, where, of which output, with which number.
pub(super) struct Asked {
    pub(super) feature: Feature,
    pub(super) span: Range<usize>,
    pub(super) output: Option<usize>,
    pub(super) measured: Option<f64>,
}

/// What single outputs ask for.
pub(super) fn of_outputs(plant: &Plant) -> Vec<Asked> {
    let mut all = Vec::new();
    for (place, output) in plant.outputs.iter().enumerate() {
        let name = output.label.span.clone();
        let mut ask = |feature, span: Option<Range<usize>>, measured| {
            all.extend(span.map(|span| Asked { feature, span, output: Some(place), measured }));
        };
        ask(Feature::Wrap, output.wrap.as_ref().map(|wrap| wrap.span.clone()), None);
        ask(Feature::Counter, output.counter.map(|_| name), None);
        ask(Feature::Gate, output.gate.as_ref().map(|gate| gate.span.clone()), None);
        ask(Feature::Every, (output.every > 1).then(|| output.every_span.clone()), Some(count(output.every)));
        ask(Feature::Age, output.aged.as_ref().map(|aged| aged.span.clone()), None);
        let late = output.delay.as_ref().and_then(|(delay, _)| delay.to_f64().ok());
        ask(Feature::Delay, output.delay.as_ref().map(|(_, span)| span.clone()), late);
    }
    all
}

/// What the whole specification asks for.
pub(super) fn of_all(plant: &Plant) -> Vec<Asked> {
    let ask = |feature, span| Asked { feature, span, output: None, measured: None };
    let outputs = count(plant.outputs.len());
    let second = plant.outputs.get(1).map(|second| second.label.span.clone());
    let second = second.map(|span| Asked { measured: Some(outputs), ..ask(Feature::Outputs, span) });
    let mut all: Vec<Asked> = second.into_iter().collect();
    all.extend(plant.ahead.iter().map(|(_, span)| ask(Feature::Ahead, span.clone())));
    all.extend(plant.init_at.then(|| ask(Feature::InitAt, plant.span.clone())));
    all.extend(plant.coasted.then(|| ask(Feature::Coasted, plant.span.clone())));
    all
}

/// An estimate for later is none to start from.
pub(super) fn contradiction(plant: &Plant) -> Option<Diagnostic> {
    let (_, span) = plant.ahead.as_ref().filter(|_| plant.init_at)?;
    let message = "`init_at` starts from an estimate of now, and `ahead` gives estimates for later";
    let error = Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message);
    Some(error.help("leave one of them out"))
}

/// A state that is called as the field which counts the calls since a sample was accepted.
pub(super) fn coasted_twice(plant: &Plant) -> Option<Diagnostic> {
    let state = plant.states.iter().find(|state| plant.coasted && state.label.name == "coasted")?;
    let message = "`coasted` names two fields of the estimate";
    let error = Diagnostic::error(codes::DUPLICATE_NAME, state.label.span.clone(), message);
    Some(error.label("so are the calls since the newest accepted sample called").help("rename the state"))
}
