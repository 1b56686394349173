//! What a specification may ask of any method, and who cannot do it.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::plant::{Output, Plant};
use crate::program::Scalar;

/// What a specification may ask of any method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// Samples that jump by whole turns.
    Wrap,
    /// Samples that are integers.
    Counter,
    /// Samples that are looked at before they are believed.
    Gate,
    /// Outputs that are measured at every so many steps.
    Every,
    /// Samples that come with their age.
    Age,
    /// The estimate for later.
    Ahead,
    /// A start from a known state.
    InitAt,
    /// Calls since the newest accepted sample.
    Coasted,
}

impl Feature {
    /// The key that asks for it.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Wrap => "wrap",
            Self::Counter => "sample",
            Self::Gate => "gate",
            Self::Every => "every",
            Self::Age => "age",
            Self::Ahead => "ahead",
            Self::InitAt => "init_at",
            Self::Coasted => "coasted",
        }
    }
}

/// Why a method cannot do something, and what can.
#[derive(Clone, Copy, Debug)]
pub struct Cannot {
    /// A clause behind "the method `x` cannot take `key`: ".
    pub why: &'static str,
    /// The nearest way out.
    pub instead: &'static str,
}

/// What a plant's specification asks for that its method cannot do.
pub fn refused(plant: &Plant, method: &str, cannot: impl Fn(Feature) -> Option<Cannot>) -> Vec<Diagnostic> {
    let refusal = |(feature, span): (Feature, Range<usize>)| {
        let cannot = cannot(feature)?;
        let message = format!("the method `{method}` cannot take `{}`: {}", feature.key(), cannot.why);
        let error = Diagnostic::error(codes::METHOD_CANNOT, span, message);
        Some(error.context(plant.span.clone(), "the method").help(cannot.instead))
    };
    asked(plant).into_iter().filter_map(refusal).chain(contradiction(plant)).chain(coasted_twice(plant)).collect()
}

/// An estimate for later is none to start from.
fn contradiction(plant: &Plant) -> Option<Diagnostic> {
    let (_, span) = plant.ahead.as_ref().filter(|_| plant.init_at)?;
    let message = "`init_at` starts from an estimate of now, and `ahead` gives estimates for later";
    let error = Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message);
    Some(error.help("leave one of them out"))
}

/// A state that is called as the field which counts the calls since a sample was accepted.
fn coasted_twice(plant: &Plant) -> Option<Diagnostic> {
    let state = plant.states.iter().find(|state| plant.coasted && state.label.name == "coasted")?;
    let message = "`coasted` names two fields of the estimate";
    let error = Diagnostic::error(codes::DUPLICATE_NAME, state.label.span.clone(), message);
    Some(error.label("so are the calls since the newest accepted sample called").help("rename the state"))
}

/// What is asked for, with the places.
fn asked(plant: &Plant) -> Vec<(Feature, Range<usize>)> {
    let mut asked = Vec::new();
    for output in &plant.outputs {
        let name = || output.label.span.clone();
        asked.extend(output.wrap.iter().map(|wrap| (Feature::Wrap, wrap.span.clone())));
        asked.extend(output.counter.iter().map(|_| (Feature::Counter, name())));
        asked.extend(output.gate.iter().map(|gate| (Feature::Gate, gate.span.clone())));
        asked.extend((output.every > 1).then(|| (Feature::Every, output.every_span.clone())));
        asked.extend(output.aged.iter().map(|aged| (Feature::Age, aged.span.clone())));
    }
    asked.extend(plant.ahead.iter().map(|(_, span)| (Feature::Ahead, span.clone())));
    asked.extend(plant.init_at.then(|| (Feature::InitAt, plant.span.clone())));
    asked.extend(plant.coasted.then(|| (Feature::Coasted, plant.span.clone())));
    asked
}

/// Why a method that works with positions cannot take a counter: singles do not hold every count of 32 bits, but where a
/// turn divides them.
pub fn cannot_count(plant: &Plant) -> Option<Cannot> {
    let holds = |output: &Output| {
        let Some(counter) = output.counter else { return true };
        let turn = output.wrap.as_ref().and_then(|wrap| match &output.quantum {
            Some(quantum) => wrap.turn.over(quantum).ok()?.to_f64().ok(),
            None => wrap.turn.to_f64().ok(),
        });
        // A power of two below 2^24 counts.
        let divides = turn.is_some_and(|turn| turn <= 16_777_216.0 && turn.to_bits().trailing_zeros() >= 52);
        plant.scalar == Scalar::F64 || counter.bits == 16 || divides
    };
    (!plant.outputs.iter().all(holds)).then_some(Cannot {
        why: "it works with positions, and single precision does not hold every count of 32 bits",
        instead: "write `wrap`, a power of two of counts, or `scalar = \"f64\"`, or use `window`, which takes differences",
    })
}
