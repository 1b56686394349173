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
    /// All of them, in the order of lists.
    pub const ALL: [Self; 8] =
        [Self::Wrap, Self::Counter, Self::Gate, Self::Every, Self::Age, Self::Ahead, Self::InitAt, Self::Coasted];

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

/// What a method cannot take, why, and what can.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// What is asked for.
    pub feature: Feature,
    /// For which specifications.
    pub when: When,
    /// The reason: a clause behind "the method `x` cannot take `key`: ".
    pub why: &'static str,
    /// The nearest way out.
    pub instead: &'static str,
}

/// For which specifications a limit stands; the words are a clause behind the key.
#[derive(Clone, Copy, Debug)]
pub enum When {
    /// For all.
    Always,
    /// For some plants.
    Plant(&'static str, fn(&Plant) -> bool),
    /// For some of the method's keys; the method knows which by the words.
    Keys(&'static str),
}

impl When {
    /// The words; none where it is for all.
    pub const fn words(self) -> Option<&'static str> {
        match self {
            Self::Always => None,
            Self::Plant(words, _) | Self::Keys(words) => Some(words),
        }
    }
}

impl Limit {
    /// A limit for all specifications.
    pub const fn new(feature: Feature, why: &'static str, instead: &'static str) -> Self {
        Self { feature, when: When::Always, why, instead }
    }

    /// The same for some.
    #[must_use]
    pub const fn when(self, when: When) -> Self {
        Self { when, ..self }
    }
}

/// What a plant's specification asks for that its method cannot do; `keys` says whether a limit's words are true of the
/// method's keys.
pub fn refused(plant: &Plant, method: &str, limits: &[Limit], keys: impl Fn(&str) -> bool) -> Vec<Diagnostic> {
    let stands = |limit: &&Limit| match limit.when {
        When::Always => true,
        When::Plant(_, holds) => holds(plant),
        When::Keys(words) => keys(words),
    };
    let refusal = |(feature, span): (Feature, Range<usize>)| {
        let limit = limits.iter().filter(|limit| limit.feature == feature).find(stands)?;
        let message = format!("the method `{method}` cannot take `{}`: {}", feature.key(), limit.why);
        let error = Diagnostic::error(codes::METHOD_CANNOT, span, message);
        Some(error.context(plant.span.clone(), "the method").help(limit.instead))
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

/// A method that works with positions cannot take every counter: singles do not hold every count of 32 bits, only those
/// within a turn, which integers find.
pub const POSITIONS: Limit = Limit::new(
    Feature::Counter,
    "it works with positions, and single precision does not hold every count of 32 bits",
    "write `wrap`, a turn of at most 2^24 counts, or `scalar = \"f64\"`, or use `window`, which takes differences",
)
.when(When::Plant("of 32 bits in f32, unless `wrap` is a turn of at most 2^24 counts", has_coarse_counts));

fn has_coarse_counts(plant: &Plant) -> bool {
    let holds = |output: &Output| {
        let Some(counter) = output.counter else { return true };
        let turn = output.wrap.as_ref().and_then(|wrap| match &output.quantum {
            Some(quantum) => wrap.turn.over(quantum).ok()?.to_f64().ok(),
            None => wrap.turn.to_f64().ok(),
        });
        // Below, a single is every count of a turn; inputs are taken out of floats.
        let turns =
            turn.is_some_and(|turn| turn <= 16_777_216.0) && output.feedthrough.iter().all(|factor| factor.is_zero());
        plant.scalar == Scalar::F64 || counter.bits == 16 || turns
    };
    !plant.outputs.iter().all(holds)
}
