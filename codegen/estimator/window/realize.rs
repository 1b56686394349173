//! How a step computes a window functional: by one sum over the window, or with state of its own.
//!
//! Every realisation computes the same weights; they differ in memory, operations, round-off, and in which
//! plants they may run for (window-observers, section 3). [`realize`] designs what is asked for, or what
//! [`decide`] finds best, and lists all of them with this plant's numbers.

pub mod ages;
pub mod basis;
pub mod copy;
pub mod form;
pub mod ping_pong;
pub mod recursive;
pub mod tables;
pub mod two_level;

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::promise::rounding::unit;
use crate::promise::{Certificate, Realization};
use crate::real::{Precision, Real, Singular};
use crate::sampled::settled::Settled;

use super::certificate::{certify, certify_ages};
use super::solve::Exact;
use super::{Functional, decide, rounding};
use crate::numbers::count;
use crate::sampled::settle::{round_groups, settle_groups};
use ages::AtAge;
pub use form::{ByInnovation, Form, LeastSquares};
use ping_pong::PingPong;
use recursive::Recursive;
use two_level::TwoLevel;

/// Bits at which it is judged whether a realisation may run.
const VERDICT_BITS: usize = 256;

/// How a step computes a functional.
#[derive(Clone, Debug, Default)]
pub enum Way {
    /// One sum over the stored samples.
    #[default]
    Fir,
    /// Statistics of blocks.
    TwoLevel(Box<TwoLevel>),
    /// Two copies that are restarted by turns.
    PingPong(Box<PingPong>),
    /// A filter with one delayed innovation.
    Recursive(Box<Recursive>),
}

/// What the user asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// What [`decide`] finds best.
    #[default]
    Auto,
    /// One sum over the stored samples.
    Fir,
    /// A filter with one delayed innovation.
    Recursive,
    /// Statistics of blocks.
    TwoLevel,
    /// Two copies that are restarted by turns.
    PingPong,
}

/// The words of the key `realization`.
pub const WORDS: [(&str, Wanted); 5] = [
    ("auto", Wanted::Auto),
    ("fir", Wanted::Fir),
    ("recursive", Wanted::Recursive),
    ("two-level", Wanted::TwoLevel),
    ("ping-pong", Wanted::PingPong),
];

/// The same for a method's list of keys.
pub const REALIZATION_CHOICES: &str = "\"auto\" | \"fir\" | \"two-level\" | \"ping-pong\" | \"recursive\"";

/// Lines for a method's registry entry.
pub const REALIZATIONS: [(&str, &str); 4] = [
    ("fir", "one weighted sum over the stored samples; no state that can drift"),
    ("two-level", "statistics of blocks of samples; for long windows, any plant, the same work every call"),
    ("ping-pong", "two copies of the plant, restarted by turns; no stored samples, a window of N+1 to 2N samples"),
    ("recursive", "a filter with one delayed innovation; only where it is stable with a margin"),
];

impl Wanted {
    /// As the user writes it.
    pub fn word(self) -> &'static str {
        WORDS.iter().find(|(_, wanted)| *wanted == self).map_or("auto", |(word, _)| word)
    }
}

/// How far a realisation is designed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// For numbers that are compared.
    Look,
    /// For constants that a step carries.
    Settle,
}

impl Depth {
    fn round(self, plant: &Plant, settled: Precision, run: &Run) -> Result<Vec<Option<Vec<Settled>>>, Refusal> {
        match self {
            Self::Look => round_groups(settled, run),
            Self::Settle => settle_groups(plant, settled, run),
        }
        .map_err(Refusal::Broken)
    }
}

/// Constants at a precision, in groups of one unit.
type Run<'a> = dyn Fn(Precision) -> Result<Vec<Vec<Real>>, Vec<Diagnostic>> + 'a;

/// What is to be realised.
pub struct Request<'a> {
    /// The functional; its way is what [`realize`] decides.
    pub functional: Functional,
    /// Its numbers before they were rounded.
    pub exact: &'a Exact,
    /// Its innovation form, or why it has none.
    pub form: Result<&'a dyn Form, &'static str>,
    /// What the user asks for.
    pub wanted: Wanted,
    /// Where.
    pub span: Range<usize>,
}

/// A functional with its realisation.
#[derive(Clone, Debug)]
pub struct Realized {
    /// With its way.
    pub functional: Functional,
    /// Of the chosen realisation.
    pub certificate: Certificate,
    /// The name of the chosen realisation.
    pub name: &'static str,
    /// All realisations, the chosen one first.
    pub realizations: Vec<Realization>,
    /// What its user should know, a line each.
    pub notes: Vec<String>,
}

/// What a realisation takes, and what it does to numbers.
#[derive(Clone, Debug, Default)]
pub struct Load {
    /// Numbers of state.
    pub words: usize,
    /// Additions and multiplications of the estimate, per call.
    pub flops: usize,
    /// Constants in tables.
    pub constants: usize,
    /// The largest sum of magnitudes in a step, for samples of magnitude 1.
    pub gain: f64,
    /// The most that rounding moves each state, for samples of magnitude 1.
    pub round_off: Vec<f64>,
}

impl Load {
    /// Round-off against the sum of the weights: the worst state.
    pub fn relative(&self, functional: &Functional) -> f64 {
        let ratio = |(i, error): (usize, &f64)| {
            let weights = functional.weights(i);
            if weights > 0.0 { error / weights } else { 0.0 }
        };
        self.round_off.iter().enumerate().map(ratio).fold(0.0, f64::max)
    }
}

/// Why a realisation cannot be.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// It does not fit this plant: why, and the number.
    Unfit(String, Option<f64>),
    /// The design itself fails.
    Broken(Vec<Diagnostic>),
}

impl Refusal {
    fn because(why: String) -> Self {
        Self::Unfit(why, None)
    }

    fn measured(why: String, number: f64) -> Self {
        Self::Unfit(why, Some(number))
    }

    /// In one line.
    pub fn why(&self) -> String {
        match self {
            Self::Unfit(why, _) => why.clone(),
            Self::Broken(found) => found.first().map_or_else(String::new, |d| d.message.clone()),
        }
    }
}

impl From<Singular> for Refusal {
    fn from(error: Singular) -> Self {
        Self::because(format!("a matrix of its innovation form has no inverse ({error})"))
    }
}

fn singular(plant: &Plant, error: Singular) -> Diagnostic {
    Diagnostic::error(codes::PRECISION, plant.span.clone(), "the innovation form cannot be computed")
        .label(error.to_string())
        .help("`realization = \"fir\"`")
}

impl Functional {
    /// Sum of the magnitudes of all weights of a state.
    pub fn weights(&self, state: usize) -> f64 {
        self.outputs.iter().chain(&self.knowns).map(|w| w.l1(state)).sum()
    }

    /// (State, signal) pairs with weights.
    pub fn pairs(&self) -> usize {
        self.outputs.iter().chain(&self.knowns).map(|w| w.columns.iter().flatten().count()).sum()
    }

    /// What the sums over the windows take; the round-off is that of the shortest.
    pub fn load(&self, plant: &Plant) -> Load {
        let n = plant.states.len();
        let signals = self.outputs.len() + self.knowns.len();
        // Each term is rounded with its weight, with its product, and once in each later addition.
        let chain = unit(plant.scalar) * count(self.steps + 2 + signals);
        let weights: Vec<f64> = (0..n).map(|i| self.weights(i) + self.constant[i].double.abs()).collect();
        let constants = self.windows().map(|window| window.pairs() * (window.steps + 1)).sum();
        Load {
            words: signals * (self.longest() + 1),
            flops: 2 * constants,
            constants,
            gain: weights.iter().copied().fold(1.0, f64::max),
            round_off: weights.iter().map(|w| w * chain).collect(),
        }
    }
}

impl Way {
    /// As the user names it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Fir => "fir",
            Self::TwoLevel(_) => "two-level",
            Self::PingPong(_) => "ping-pong",
            Self::Recursive(_) => "recursive",
        }
    }

    /// What its user should know.
    pub fn note(&self) -> Option<String> {
        match self {
            Self::Fir => None,
            Self::TwoLevel(two) => Some(format!(
                "computed in blocks of {} samples: {} whole ones and two in part",
                two.cut.block, two.cut.whole
            )),
            Self::PingPong(pair) => {
                let (least, most) = (pair.steps + 1, 2 * pair.steps);
                Some(format!(
                    "two copies take turns: the window has {least} to {most} samples, the gains are of the worst"
                ))
            }
            Self::Recursive(filter) if filter.turns => Some("two copies with their filters take turns".into()),
            Self::Recursive(filter) => {
                let calls = (1.0 / -deadbeat_math::log_f64(filter.radius)).ceil();
                Some(format!("an outlier's rounding stays in the filter and falls to 1/e in {calls} samples"))
            }
        }
    }

    /// Whether the samples of the window are stored.
    pub fn stores_window(&self) -> bool {
        match self {
            Self::Fir | Self::TwoLevel(_) => true,
            Self::PingPong(_) | Self::Recursive(_) => false,
        }
    }

    /// What it takes, where it is not the plain sum.
    pub fn load(&self) -> Option<&Load> {
        match self {
            Self::Fir => None,
            Self::TwoLevel(two) => Some(&two.load),
            Self::PingPong(pair) => Some(&pair.load),
            Self::Recursive(recursive) => Some(&recursive.load),
        }
    }

    /// Its own constants, in columns of one unit.
    pub fn columns(&self) -> Vec<Vec<Settled>> {
        match self {
            Self::Fir => Vec::new(),
            Self::TwoLevel(two) => two.columns(),
            Self::PingPong(pair) => pair.columns(),
            Self::Recursive(recursive) => recursive.columns(),
        }
    }
}

/// Realises a functional as asked for, or as is best.
///
/// # Errors
/// That what is asked for may not run, with the number that forbids it and what may.
pub fn realize(plant: &Plant, request: Request) -> Result<Realized, Vec<Diagnostic>> {
    let decision = decide::decide(plant, &request)?;
    let mut functional = request.functional;
    let mut certificate = match &decision.way {
        Way::PingPong(pair) => {
            let ages = pair.steps..2 * pair.steps;
            let at = |age| AtAge::new(pair, &functional, &request.exact.model.c, age);
            certify_ages(plant, &functional, ages.map(at))
        }
        _ => certify(plant, &functional, request.exact),
    };
    certificate.rounding = rounding::bound(plant, &functional, &decision.way, &certificate.noise_gain_l1);
    functional.way = decision.way;
    let (name, notes) = (functional.way.name(), functional.way.note().into_iter().collect());
    Ok(Realized { functional, certificate, name, realizations: decision.list, notes })
}
