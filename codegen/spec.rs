//! The specification file: keys, names, places.
//!
//! Knows keys, places and names. Never knows what any of it means.
//!
//! In: TOML text. Out: a [`Spec`], in which every key has been recognised and every name can be
//! carried by Rust and C, or all the mistakes at once. Expressions are still text.

mod chain;
mod identifiers;
mod read;
pub mod reader;
pub mod sensor;
mod syntax;

use std::cell::RefCell;
use std::ops::Range;

use dashu_ratio::RBig;
use serde::Deserialize;

use crate::diagnostic::{Report, Source, codes};
use crate::program::Scalar;
use reader::{Found, Table};
use sensor::Sensor;

/// A string with its place in the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// Without quotes.
    pub value: String,
    /// Of the value with its quotes, or of the key.
    pub span: Range<usize>,
    /// Where the characters start in the file, if they stand there unescaped.
    pub inner: Option<usize>,
}

impl Text {
    /// Maps bytes of the value to bytes of the file; the whole string when it is written with escapes.
    pub fn place(&self, within: Range<usize>) -> Range<usize> {
        self.inner.map_or_else(|| self.span.clone(), |start| start + within.start..start + within.end)
    }
}

/// A number, or a constant expression still to be read.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// Exactly.
    Number(RBig, Range<usize>),
    /// In a string.
    Expression(Text),
}

impl Quantity {
    /// Its place in the file.
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Number(_, span) => span.clone(),
            Self::Expression(text) => text.span.clone(),
        }
    }
}

/// A named number.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name, unit, documentation.
    pub named: Named,
    /// The number.
    pub value: Quantity,
}

/// A name with a unit and a line of documentation.
#[derive(Clone, Debug)]
pub struct Named {
    /// The name with its place.
    pub name: Text,
    /// SI unit, as written; may be empty.
    pub unit: String,
    /// One line; may be empty.
    pub doc: String,
}

/// A state.
#[derive(Clone, Debug)]
pub struct State {
    /// Name, unit, documentation.
    pub named: Named,
    /// `derivative` or `next`; absent in a plant by matrices.
    pub change: Option<Text>,
    /// The estimate before convergence, for states that are not measured.
    pub initial: Option<Quantity>,
}

/// What an input does between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Keeps its value.
    Zero,
    /// Is sampled together with the outputs, and runs straight from one sample to the next.
    First,
}

/// A known input.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name, unit, documentation.
    pub named: Named,
    /// Between samples.
    pub hold: Hold,
    /// Whether the file says it.
    pub said: bool,
}

/// A measured output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name, unit, documentation.
    pub named: Named,
    /// Affine in states and inputs; absent in a plant by matrices.
    pub value: Option<Text>,
    /// Bound on the noise, in the output's unit.
    pub noise: Option<Quantity>,
    /// How late it arrives, s.
    pub delay: Option<Quantity>,
    /// Samples outside are treated as missing.
    pub range: Option<(Vec<Quantity>, Range<usize>)>,
    /// What its sensor is like.
    pub sensor: Sensor,
}

/// A bounded unknown signal.
#[derive(Clone, Debug)]
pub struct Disturbance {
    /// Name, unit, documentation.
    pub named: Named,
    /// Bound on its magnitude.
    pub bound: Option<Quantity>,
}

/// Rows of numbers with their place.
pub type Rows = (Vec<Vec<Quantity>>, Range<usize>);

/// `[plant]`.
#[derive(Clone, Debug)]
pub struct Matrices {
    /// n x n.
    pub a: Option<Rows>,
    /// n x m.
    pub b: Option<Rows>,
    /// p x n.
    pub c: Option<Rows>,
    /// p x m.
    pub d: Option<Rows>,
    /// Whether they are already discrete.
    pub discrete: bool,
    /// Of the table.
    pub span: Range<usize>,
}

/// `[observer.<method>]`; what its other keys say is the method's business.
#[derive(Clone, Debug)]
pub struct Observer {
    /// The method's name with its place.
    pub method: Text,
    /// By how much later the estimate is for, s.
    pub ahead: Option<Quantity>,
}

/// `[target]`.
#[derive(Clone, Debug)]
pub struct Target {
    /// Seconds between two calls.
    pub sample_time: Quantity,
    /// The float type of the step.
    pub scalar: Scalar,
    /// By how much the true times of samples may differ from those of calls, s.
    pub jitter: Option<Quantity>,
    /// Whether the estimate says how many calls ago a sample was accepted.
    pub coasted: bool,
    /// Whether an observer can be started from an estimate.
    pub init_at: bool,
    /// Whether a state that is vouched for there is exact.
    pub exact_start: bool,
}

/// What the command line, the macro's arguments and `[target]` can all say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// The float type, instead of the file's.
    #[serde(default, deserialize_with = "scalar_word")]
    pub scalar: Option<Scalar>,
}

impl Settings {
    /// Reads settings such as `scalar = "f64"`.
    pub fn from_toml(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|error| error.message().to_owned())
    }
}

fn scalar_word<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Option<Scalar>, D::Error> {
    #[derive(Deserialize)]
    #[serde(rename_all = "lowercase")]
    enum Word {
        F32,
        F64,
    }
    Word::deserialize(from).map(|word| Some(if matches!(word, Word::F32) { Scalar::F32 } else { Scalar::F64 }))
}

/// A specification, as written.
#[derive(Clone, Debug)]
pub struct Spec {
    /// The text.
    pub source: Source,
    /// Prefixes everything that is generated.
    pub name: Text,
    /// One line for documentation.
    pub title: String,
    /// Where the model comes from.
    pub origin: String,
    /// In the order of the file.
    pub parameters: Vec<Parameter>,
    /// In the order of the file, which is the estimate's.
    pub states: Vec<State>,
    /// Whether the states have `next` instead of `derivative`.
    pub discrete: bool,
    /// In the order of the file.
    pub inputs: Vec<Input>,
    /// In the order of the file.
    pub outputs: Vec<Output>,
    /// Constants to estimate together with the state.
    pub unknowns: Vec<Named>,
    /// For the certificate only.
    pub disturbances: Vec<Disturbance>,
    /// A plant by matrices.
    pub matrices: Option<Matrices>,
    /// The method and its keys.
    pub observer: Observer,
    /// What it is for.
    pub target: Target,
}

/// Whether a method's keys stand for the plant, by a chain of integrators, and how to speak of that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chain {
    /// How many integrators; `None` where the file declares the plant.
    pub order: Option<usize>,
    /// The key that stands for the plant; `None` where the method itself does.
    pub key: Option<&'static str>,
    /// What to write in a file that declares a plant too.
    pub instead: &'static str,
}

/// Reads the keys of `[observer.<method>]`, given the method's name and the table that holds them; mistakes are reported
/// there and give `None`. The text says why a chain's method takes no second output.
pub type ReadKeys<'a> = &'a mut dyn FnMut(&Text, Table) -> Option<(Chain, String)>;

/// Why a file is no specification.
pub struct Unread {
    /// Every mistake.
    pub report: Report,
    /// What the plant can be read from, where no more than keys are wrong: for the mistakes in its equations.
    pub rest: Option<Box<Spec>>,
}

/// Mistakes that leave what else is written as it is.
const LOCAL: [&str; 3] = [codes::UNKNOWN_KEY, codes::MISSING_KEY, codes::BAD_CHOICE];

impl Spec {
    /// Reads a specification, with `keys` for the observer's own table.
    ///
    /// # Errors
    /// Every mistake of the file's keys, names and numbers.
    pub fn parse(source: Source, settings: Settings, keys: ReadKeys) -> Result<Self, Unread> {
        let found: Found = RefCell::new(Vec::new());
        let spec = read::read(&source, settings, keys, &found);
        let found = found.into_inner();
        match spec {
            Some((spec, true)) if found.is_empty() => Ok(spec),
            spec => {
                let local = found.iter().all(|mistake| LOCAL.contains(&mistake.code));
                let whole =
                    |spec: &Spec| spec.matrices.is_some() || !(spec.states.is_empty() || spec.outputs.is_empty());
                let rest = spec.filter(|(spec, _)| local && whole(spec)).map(|(spec, _)| Box::new(spec));
                Err(Unread { report: Report::new(source, found), rest })
            }
        }
    }
}

impl Observer {
    /// Where the method's keys could not be read.
    fn stand_in(method: Option<Text>) -> Self {
        Self { method: method.unwrap_or_default(), ahead: None }
    }
}

impl Target {
    /// Where it could not be read.
    fn stand_in() -> Self {
        let sample_time = Quantity::Number(RBig::ONE, 0..0);
        Self { sample_time, scalar: Scalar::F64, jitter: None, coasted: false, init_at: false, exact_start: false }
    }
}
