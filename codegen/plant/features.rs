//! What a specification may ask of any method, and who cannot do it.

mod asked;

use std::any::Any;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Constant, Symbol};
use crate::plant::{Output, Plant};
use crate::program::Scalar;
use asked::{Asked, coasted_twice, contradiction, of_all, of_outputs};

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
    /// Outputs that arrive late.
    Delay,
    /// More than one output.
    Outputs,
    /// Samples that are missing.
    Missing,
    /// Estimates from the samples that are there, without a prediction for those that are not.
    LeftOut,
    /// Estimates from several windows at once.
    Windows,
    /// The estimate for later.
    Ahead,
    /// A start from a known state.
    InitAt,
    /// Calls since the newest accepted sample.
    Coasted,
}

impl Feature {
    /// All of them, in the order of lists.
    pub const ALL: [Self; 13] = [
        Self::Wrap,
        Self::Counter,
        Self::Gate,
        Self::Every,
        Self::Age,
        Self::Delay,
        Self::Outputs,
        Self::Missing,
        Self::LeftOut,
        Self::Windows,
        Self::Ahead,
        Self::InitAt,
        Self::Coasted,
    ];

    /// The head of its column: the key that asks for it, or a word where no key does.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Wrap => "wrap",
            Self::Counter => "sample",
            Self::Gate => "gate",
            Self::Every => "every",
            Self::Age => "age",
            Self::Delay => "delay",
            Self::Outputs => "outputs",
            Self::Missing => "NaN",
            Self::LeftOut => "left-out",
            Self::Windows => "windows",
            Self::Ahead => "ahead",
            Self::InitAt => "init_at",
            Self::Coasted => "coasted",
        }
    }

    /// What asks for it, behind "cannot take".
    pub const fn words(self) -> &'static str {
        match self {
            Self::Wrap => "`wrap`",
            Self::Counter => "`sample`",
            Self::Gate => "`gate`",
            Self::Every => "`every`",
            Self::Age => "`age`",
            Self::Delay => "`delay`",
            Self::Outputs => "several outputs",
            Self::Missing => "a missing sample",
            Self::LeftOut => "`missing = \"left-out\"`",
            Self::Windows => "several windows",
            Self::Ahead => "`ahead`",
            Self::InitAt => "`init_at`",
            Self::Coasted => "`coasted`",
        }
    }
}

/// What a method cannot take, why, and what can.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// What is asked for.
    pub feature: Feature,
    /// For which specifications.
    pub(crate) when: When,
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
    /// Where this finds something against it.
    Where(&'static str, fn(&Case) -> Against),
}

/// What a method finds against a feature in one specification: nothing, or it with the place and the name of the
/// culprit beside the key, where there is one.
pub type Against = Option<Option<(Range<usize>, &'static str)>>;

/// Against a feature where this is true, with no other culprit.
pub fn holds(is: bool) -> Against {
    is.then_some(None)
}

/// A feature that one specification asks for.
pub struct Case<'a> {
    /// The plant.
    pub plant: &'a Plant,
    /// The place of the output that asks, where one does.
    asking: Option<usize>,
    /// The method's keys.
    keys: &'a dyn Any,
}

impl Case<'_> {
    /// The output that asks, with its place; the first where the feature is not of one output.
    pub fn output(&self) -> (usize, &Output) {
        let place = self.asking.unwrap_or(0);
        (place, &self.plant.outputs[place])
    }

    /// The keys of the method whose limit it is.
    pub fn keys<K: 'static>(&self) -> &K {
        self.keys.downcast_ref().unwrap_or_else(|| unreachable!("a method's limits look at its own keys"))
    }
}

impl Limit {
    /// A limit for all specifications.
    pub const fn new(feature: Feature, why: &'static str, instead: &'static str) -> Self {
        Self { feature, when: When::Always, why, instead }
    }

    /// The same for some.
    #[must_use]
    pub const fn when(self, words: &'static str, against: fn(&Case) -> Against) -> Self {
        Self { when: When::Where(words, against), ..self }
    }

    /// For which specifications it stands, as a clause behind the key; none where it is for all.
    pub const fn words(&self) -> Option<&'static str> {
        match self.when {
            When::Always => None,
            When::Where(words, _) => Some(words),
        }
    }

    /// The sentence of a refusal.
    pub fn sentence(&self, method: &str) -> String {
        format!("the method `{method}` cannot take {}: {}", self.feature.words(), self.why)
    }

    /// Whether it stands in a case, and the culprit.
    fn against(&self, case: &Case) -> Against {
        match self.when {
            When::Always => holds(true),
            When::Where(_, against) => against(case),
        }
    }

    /// The refusal at a place. What two keys of one table ask of each other does not go together; the rest a method
    /// cannot do.
    pub fn refusal(&self, method: &str, span: Range<usize>) -> Diagnostic {
        let of_its_keys = matches!(self.feature, Feature::LeftOut | Feature::Windows);
        let both = of_its_keys && self.words().is_some();
        let code = if both { codes::BAD_COMBINATION } else { codes::METHOD_CANNOT };
        Diagnostic::error(code, span, self.sentence(method)).help(self.instead)
    }
}

/// What a plant's specification asks for that its method cannot do; `asked` is what the method's own keys ask for.
pub fn refused(
    plant: &Plant,
    method: &str,
    limits: &[Limit],
    (keys, asked): (&dyn Any, Vec<(Feature, Range<usize>)>),
) -> Vec<Diagnostic> {
    let refusal = |asked: Asked| {
        let case = Case { plant, asking: asked.output, keys };
        let mut limits = limits.iter().filter(|limit| limit.feature == asked.feature);
        let (limit, culprit) = limits.find_map(|limit| Some((limit, limit.against(&case)?)))?;
        let error = limit.refusal(method, asked.span).context(plant.span.clone(), "the method");
        let error = Diagnostic { measured: asked.measured, ..error };
        Some(culprit.into_iter().fold(error, |error, (span, label)| error.context(span, label)))
    };
    let asked = asked.into_iter().map(|(feature, span)| Asked { feature, span, output: None, measured: None });
    let all = of_outputs(plant).into_iter().chain(of_all(plant)).chain(asked);
    all.filter_map(refusal).chain(contradiction(plant)).chain(coasted_twice(plant)).collect()
}

/// A method that works with positions cannot take every counter: singles do not hold every count of 32 bits, only those
/// within a turn, which integers find.
pub const POSITIONS: Limit = Limit::new(
    Feature::Counter,
    "it works with positions, and single precision does not hold every count of 32 bits",
    "write `wrap`, a turn of at most 2^24 counts, a `range` within 2^24 counts of 0, or `scalar = \"f64\"`, or use `window` \
     with `wrap = \"counter\"`, which takes differences",
)
.when("of 32 bits in f32, unless `wrap` is a turn of at most 2^24 counts or `range` within these", |case| {
    holds(is_coarse(case))
});

/// A method that takes differences takes those of integers where a counter turns; where it does not, samples are floats.
pub const UNTURNED: Limit = Limit::new(
    Feature::Counter,
    "single precision does not hold every count of 32 bits, only differences of a counter that turns",
    "write `wrap = \"counter\"` if it counts on past its largest number; else a `range` within 2^24 counts of 0, or \
     `scalar = \"f64\"`",
)
.when("of 32 bits in f32 without `wrap`, unless `range` is within 2^24 counts of 0", |case| {
    holds(case.output().1.wrap.is_none() && is_coarse(case))
});

/// Whether single precision holds some of an output's counts only.
pub fn is_coarse(case: &Case) -> bool {
    let output = case.output().1;
    let one = Constant::one();
    let counts = |value: &Constant| value.over(output.quantum.as_ref().unwrap_or(&one)).ok()?.to_f64().ok();
    let turn = output.wrap.as_ref().and_then(|wrap| counts(&wrap.turn));
    // Below, a single is every count of a turn; what is late or has inputs in it works with floats.
    let bare = output.delay.is_none() && output.feedthrough.iter().all(Constant::is_zero);
    let turns = bare && turn.is_some_and(|turn| turn <= EXACT);
    let near = output.sample_range().is_some_and(|(low, high)| {
        output.wrap.is_none() && [low, high].iter().all(|limit| counts(limit).is_some_and(|c| c.abs() <= EXACT))
    });
    case.plant.scalar == Scalar::F32 && output.counter.is_some_and(|counter| counter.bits != 16) && !turns && !near
}

/// 2^24: singles hold every whole number up to it.
const EXACT: f64 = 16_777_216.0;

/// A nonlinear term of an output, with its place.
pub fn nonlinear_term(case: &Case) -> Against {
    let (place, plant) = (case.output().0, case.plant);
    let shows = |symbol: &Symbol| match symbol {
        Symbol::State(j) => plant.states[*j].measured.iter().any(|(shown, _)| *shown == place),
        _ => false,
    };
    let term = plant.injections.iter().find(|term| term.symbols().iter().any(shows))?;
    Some(Some((term.node.span.clone(), "this nonlinear term")))
}
