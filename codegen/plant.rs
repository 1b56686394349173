//! The plant: `x' = A x + B u + c + phi(y, u, t) + sum eps gamma`, `y = C x`, exactly.
//!
//! Knows the specification, exact coefficients, sensors, what may be asked of them. Never knows how a state is
//! estimated, nor a float.
//!
//! In: a [`Spec`]. Out: a [`Plant`] that no longer shows whether it was written as equations or as
//! matrices. Every coefficient is an exact [`Constant`]; a zero is a structural zero.

pub mod combine;
mod elimination;
mod expression;
pub mod features;
pub mod measurable;
pub mod modes;
pub mod moved;
mod outputs;
mod reading;
pub mod sensor;
pub mod split;
mod turn;
mod units;
pub mod words;

use std::collections::BTreeSet;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, Level, Report, Source};
use crate::expr::{Constant, Meaning, Node, Poly, Symbol};
use crate::program::Scalar;
pub use crate::spec::Hold;
use crate::spec::{Quantity, Spec};
use expression::read_constant;
use reading::Reading;
pub use sensor::{Aged, Counter, Gate, Wrap};

/// Name, unit, documentation and place of something declared.
#[derive(Clone, Debug)]
pub struct Label {
    /// An identifier of both languages, in which generated code and what it is called by speak.
    pub name: String,
    /// As the user wrote it, in which expressions speak.
    pub written: String,
    /// SI unit as written; may be empty.
    pub unit: String,
    /// One line; may be empty.
    pub doc: String,
    /// Of the name in the file.
    pub span: Range<usize>,
}

/// A named constant.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// What it is called.
    pub label: Label,
    /// Exactly.
    pub value: Constant,
}

/// A state.
#[derive(Clone, Debug)]
pub struct State {
    /// What it is called.
    pub label: Label,
    /// The estimate before convergence, for states that are not measured.
    pub initial: Constant,
    /// Weights of the undelayed outputs that give it at once; empty when it is not measured.
    pub measured: Vec<(usize, Constant)>,
    /// The right-hand side as the user wrote it; empty for a plant by matrices.
    pub equation: String,
}

/// How well a state is known that the caller vouches for in a start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vouched {
    /// It is off by the printed bound at most.
    Bounded,
    /// It is exact.
    Exact,
}

/// A known input.
#[derive(Clone, Debug)]
pub struct Input {
    /// What it is called.
    pub label: Label,
    /// Between samples.
    pub hold: Hold,
}

/// A measured output.
#[derive(Clone, Debug)]
pub struct Output {
    /// What it is called.
    pub label: Label,
    /// Bound on what a sample may be off by: the declared noise, half a count, and what it moves in the jitter.
    pub noise: Option<Constant>,
    /// These three, in this order, where there is more than the first.
    pub noise_parts: Vec<(&'static str, Constant)>,
    /// How late it arrives, s; with its place.
    pub delay: Option<(Constant, Range<usize>)>,
    /// Of `C x`: samples outside are treated as missing.
    pub range: Option<(Constant, Constant)>,
    /// Of the sample as it comes, where that is not `C x`.
    pub raw_range: Option<(Constant, Constant)>,
    /// Of the range in the file, or of the name.
    pub range_span: Range<usize>,
    /// The right-hand side as the user wrote it; empty for a plant by matrices.
    pub equation: String,
    /// Per input: what the sample has of it besides `C x`; empty where it has nothing.
    pub feedthrough: Vec<Constant>,
    /// What else the sample has besides `C x`.
    pub offset: Constant,
    /// The sample may jump by a turn.
    pub wrap: Option<Wrap>,
    /// The largest rate, in the unit per second.
    pub max_rate: Option<Constant>,
    /// One count, in the unit.
    pub quantum: Option<Constant>,
    /// Whether the sensor rounds down.
    pub floor: bool,
    /// The integer that the caller hands over.
    pub counter: Option<Counter>,
    /// A sample further from its prediction is missing.
    pub gate: Option<Gate>,
    /// Measured at every so many steps.
    pub every: usize,
    /// Of the key `every` in the file.
    pub every_span: Range<usize>,
    /// The caller says how old each sample is.
    pub aged: Option<Aged>,
}

impl Output {
    /// What a sample as it comes is within, where that is declared.
    pub fn sample_range(&self) -> Option<(Constant, Constant)> {
        let shown = |limit: &Constant| limit.plus(&self.offset).ok();
        self.raw_range.clone().or_else(|| {
            let (low, high) = self.range.as_ref()?;
            Some((shown(low)?, shown(high)?))
        })
    }

    /// What is added to a sample: half a count where the sensor rounds down, and the constant that the sample has in it,
    /// taken away.
    pub fn shift(&self) -> Option<Constant> {
        let half = self.quantum.as_ref().filter(|_| self.floor).map(sensor::half).transpose().ok().flatten();
        let half = half.unwrap_or_default();
        half.minus(&self.offset).ok().filter(|shift| !shift.is_zero())
    }
}

/// An unknown constant.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// What it is called.
    pub label: Label,
    /// gamma, n x 1: functions of t, inputs and measured states.
    pub gamma: Vec<Poly>,
}

/// A bounded unknown signal.
#[derive(Clone, Debug)]
pub struct Disturbance {
    /// What it is called.
    pub label: Label,
    /// On its magnitude.
    pub bound: Constant,
    /// n x 1.
    pub column: Vec<Constant>,
}

/// One nonlinear function of what is known, and where it enters.
#[derive(Clone, Debug)]
pub struct Injection {
    /// What the step computes.
    pub node: Node,
    /// For comments and names, such as `sin(theta)`.
    pub text: String,
    /// n x 1.
    pub column: Vec<Constant>,
}

impl Injection {
    /// What it depends on.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        self.node.poly.symbols()
    }
}

/// A plant with its outputs, and the target's sample time and scalar.
#[derive(Clone, Debug)]
pub struct Plant {
    /// The specification's text.
    pub source: Source,
    /// Prefixes everything that is generated.
    pub name: String,
    /// One line for documentation; may be empty.
    pub title: String,
    /// Where the model comes from; may be empty.
    pub origin: String,
    /// Discrete time: the equations give the next state.
    pub discrete: bool,
    /// n.
    pub states: Vec<State>,
    /// m.
    pub inputs: Vec<Input>,
    /// p.
    pub outputs: Vec<Output>,
    /// q.
    pub unknowns: Vec<Unknown>,
    /// Bounded unknown signals.
    pub disturbances: Vec<Disturbance>,
    /// A, n x n.
    pub a: Vec<Vec<Constant>>,
    /// B, n x m.
    pub b: Vec<Vec<Constant>>,
    /// C, p x n.
    pub c: Vec<Vec<Constant>>,
    /// c, n x 1.
    pub offset: Vec<Constant>,
    /// phi = sum of column times function.
    pub injections: Vec<Injection>,
    /// What expressions, and the method's own keys, may name.
    pub parameters: Vec<Parameter>,
    /// Seconds between two calls, with its place.
    pub sample_time: (Constant, Range<usize>),
    /// The float type of the step.
    pub scalar: Scalar,
    /// By how much later the estimate is for, s; with its place.
    pub ahead: Option<(Constant, Range<usize>)>,
    /// By how much the true times of samples may differ from those of calls, s; part of the outputs' noise.
    pub jitter: Option<Constant>,
    /// Whether the estimate says how many calls ago a sample was accepted.
    pub coasted: bool,
    /// Whether an observer can be started from an estimate.
    pub init_at: bool,
    /// How well a state is known that is vouched for there.
    pub vouched: Vouched,
    /// Of the observer's name in the file, for mistakes of the whole.
    pub span: Range<usize>,
}

impl Plant {
    /// Seconds between two calls, as the nearest double.
    pub fn sample_time_s(&self) -> f64 {
        self.sample_time.0.to_f64().unwrap_or(f64::NAN)
    }

    /// A double rounded to the step's float type.
    pub fn scalar_value(&self, value: f64) -> f64 {
        match self.scalar {
            #[expect(clippy::cast_possible_truncation, reason = "rounding to the nearest single is what is asked")]
            Scalar::F32 => f64::from(value as f32),
            Scalar::F64 => value,
        }
    }

    /// The value of one of a method's keys; mistakes are collected.
    pub fn constant(&self, quantity: &Quantity, found: &mut Vec<Diagnostic>) -> Option<Constant> {
        let parameters = self.parameters.iter().map(|p| (p.label.written.clone(), Meaning::Parameter(p.value.clone())));
        // States and inputs are known too, so that they are refused for what they are.
        let symbol = |label: &Label, symbol| (label.written.clone(), Meaning::Symbol(symbol));
        let states = self.states.iter().enumerate().map(|(j, state)| symbol(&state.label, Symbol::State(j)));
        let inputs = self.inputs.iter().enumerate().map(|(i, input)| symbol(&input.label, Symbol::Input(i)));
        let known: Vec<(String, Meaning)> = parameters.chain(states).chain(inputs).collect();
        read_constant(quantity, &known, found)
    }

    /// Splits a specification; the warnings come with the plant.
    pub fn new(spec: &Spec) -> Result<(Self, Vec<Diagnostic>), Report> {
        let (plant, mut found) = Reading::new(spec).finish();
        if found.iter().all(|d| d.level != Level::Error) {
            units::check(spec, &mut found);
        }
        match plant {
            Some(plant) if !found.iter().any(|d| d.level == Level::Error) => Ok((plant, found)),
            _ => Err(Report::new(spec.source.clone(), found)),
        }
    }
}
