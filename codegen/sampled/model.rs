//! The sampled plant: what one sample interval does to the state, at a given precision.
//!
//! Continuous plants are discretised exactly for inputs that keep their value, and for signals
//! that run straight from sample to sample; nothing here approximates but the straight line
//! itself. Discrete plants are taken as they are.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Constant;
use crate::plant::combine::{Change, change};
use crate::plant::{Hold, Plant};
use crate::real::{Matrix, NormTooLarge, Precision, Real, first_order_hold, third_order_hold, zero_order_hold};

use super::{Part, Signal, Source};

/// One sample interval of the plant.
#[derive(Clone, Debug)]
pub struct Model {
    /// Phi, n x n.
    pub phi: Matrix,
    /// C, p x n.
    pub c: Matrix,
    /// Per signal.
    pub effects: Vec<Effect>,
    /// n x 1: the effect of the constant terms.
    pub constant: Matrix,
    /// Per output, what its samples count by: one over its noise where every output declares one, else 1.
    pub trust: Vec<Real>,
}

/// What a signal does to the state over one interval; n x 1 each.
#[derive(Clone, Debug, Default)]
pub struct Effect {
    /// Times the value that the call at the interval's beginning brought.
    pub at_begin: Option<Matrix>,
    /// Times the value that the call at the interval's end brought.
    pub at_end: Option<Matrix>,
    /// Instead of both where a cubic runs through four samples: their factors, oldest first, for an interval that
    /// begins at the first, second or third of them.
    pub curve: Option<Box<[[Matrix; 4]; 3]>>,
}

/// How nonlinear terms run between samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Between {
    /// Straight lines: second order in the sample time.
    #[default]
    Lines,
    /// Cubics through four samples: fourth order.
    Cubics,
    /// The value of the sample before: first order, half a sample late; refused.
    Steps,
}

/// What is known at each sample besides the outputs, with nonlinear terms as asked for.
pub fn signals_between(plant: &Plant, between: Between) -> Vec<Signal> {
    let mut signals = signals(plant);
    if between == Between::Cubics {
        let curved = |signal: &&mut Signal| signal.part == Part::Runs && matches!(signal.source, Source::Injection(_));
        signals.iter_mut().filter(curved).for_each(|signal| signal.part = Part::Curves);
    }
    signals
}

/// What is known at each sample besides the outputs.
pub fn signals(plant: &Plant) -> Vec<Signal> {
    let mut signals = Vec::new();
    for (i, input) in plant.inputs.iter().enumerate() {
        if plant.b.iter().any(|row| !row[i].is_zero()) {
            let part = if input.hold == Hold::Zero { Part::Held } else { Part::Runs };
            signals.push(Signal { source: Source::Input(i), part, text: input.label.name.clone() });
        }
    }
    for (k, injection) in plant.injections.iter().enumerate() {
        let mut push = |part, text: String| signals.push(Signal { source: Source::Injection(k), part, text });
        match change(&injection.node.poly, |i| plant.inputs[i].hold) {
            Change::Held => push(Part::Held, injection.text.clone()),
            Change::Runs => push(Part::Runs, injection.text.clone()),
            Change::RunsAndJumps => {
                push(Part::Start, format!("{} at the start", injection.text));
                if !plant.discrete {
                    push(Part::End, format!("{} at the end", injection.text));
                }
            }
        }
    }
    signals
}

/// The plant's matrices at one precision.
#[derive(Clone, Debug)]
pub struct Matrices {
    /// A, n x n.
    pub a: Matrix,
    /// C, p x n.
    pub c: Matrix,
    /// Per signal, n x 1.
    pub columns: Vec<Matrix>,
    /// c, n x 1.
    pub offset: Matrix,
    /// Seconds between samples.
    pub h: Real,
}

impl Matrices {
    /// Evaluates the plant's constants.
    pub fn new(plant: &Plant, signals: &[Signal], precision: Precision) -> Result<Self, Vec<Diagnostic>> {
        let domain = std::cell::Cell::new(false);
        let value = |constant: &Constant| {
            constant.evaluate(precision).unwrap_or_else(|_| {
                domain.set(true);
                Real::zero(precision)
            })
        };
        let n = plant.states.len();
        let a = Matrix::from_fn(n, n, |i, j| value(&plant.a[i][j]));
        let c = Matrix::from_fn(plant.outputs.len(), n, |i, j| value(&plant.c[i][j]));
        let column = |signal: &Signal| {
            Matrix::from_fn(n, 1, |i, _| match signal.source {
                Source::Input(u) => value(&plant.b[i][u]),
                Source::Injection(k) => value(&plant.injections[k].column[i]),
            })
        };
        let columns = signals.iter().map(column).collect();
        let offset = Matrix::from_fn(n, 1, |i, _| value(&plant.offset[i]));
        let h = value(&plant.sample_time.0);
        if domain.get() {
            let error =
                Diagnostic::error(codes::DOMAIN, plant.span.clone(), "a constant of the plant has no usable value");
            let label = format!("not at {} bits", precision.as_bits());
            return Err(vec![
                error.label(label).help("it is the difference of nearly equal constants: write its value as a number"),
            ]);
        }
        Ok(Self { a, c, columns, offset, h })
    }

    /// Why the plant cannot be sampled.
    pub fn too_fast(&self, plant: &Plant, error: NormTooLarge) -> Vec<Diagnostic> {
        let span = plant.sample_time.1.clone();
        let fastest = self.h.log2_abs() + self.a.max_abs().log2_abs();
        if fastest < 8.0 {
            let message = "the plant's coefficients are too far apart to compute with";
            let far = Diagnostic::error(codes::OUT_OF_RANGE, span, message)
                .label("scaling the states to similar sizes takes factors beyond 1e1233")
                .help("choose units in which all states and coefficients have similar sizes");
            return vec![far];
        }
        let fast = Diagnostic::error(codes::OUT_OF_RANGE, span, "the plant is too fast for this sample time")
            .label(error.to_string())
            .help("shorten the sample time, or leave the fast states out of the model");
        vec![fast]
    }
}

impl Model {
    /// Samples the plant.
    pub fn new(plant: &Plant, signals: &[Signal], precision: Precision) -> Result<Self, Vec<Diagnostic>> {
        let matrices = Matrices::new(plant, signals, precision)?;
        let trust = trust(plant, precision);
        if plant.discrete {
            let Matrices { a, c, columns, offset, .. } = matrices;
            let effects = signals.iter().zip(columns).map(|(s, column)| discrete_effect(s.part, column)).collect();
            return Ok(Self { phi: a, c, effects, constant: offset, trust });
        }
        let Matrices { a, c, columns, offset, h } = &matrices;
        let too_fast = |error| matrices.too_fast(plant, error);
        let (phi, constant) = zero_order_hold(a, offset, h).map_err(too_fast)?;
        let effect = |(signal, column): (&Signal, &Matrix)| continuous_effect(signal.part, a, column, h);
        let effects: Result<Vec<Effect>, NormTooLarge> = signals.iter().zip(columns).map(effect).collect();
        Ok(Self { phi, c: c.clone(), effects: effects.map_err(too_fast)?, constant, trust })
    }
}

/// Samples of different sensors are comparable only in units of their noise. One sensor needs no unit.
pub fn trust(plant: &Plant, precision: Precision) -> Vec<Real> {
    let one = || Real::one(precision);
    let inverse =
        |output: &crate::plant::Output| one().checked_div(&output.noise.as_ref()?.evaluate(precision).ok()?).ok();
    let all: Option<Vec<Real>> = plant.outputs.iter().map(inverse).collect();
    all.filter(|all| all.len() > 1).unwrap_or_else(|| plant.outputs.iter().map(|_| one()).collect())
}

/// A discrete plant uses the value at the beginning of its step.
pub(crate) fn discrete_effect(part: Part, column: Matrix) -> Effect {
    match part {
        Part::Held | Part::Start => Effect { at_end: Some(column), ..Effect::default() },
        Part::Runs | Part::Curves => Effect { at_begin: Some(column), ..Effect::default() },
        Part::End => Effect::default(),
    }
}

/// What a signal does to `x' = a x + column w` over one interval.
pub fn continuous_effect(part: Part, a: &Matrix, column: &Matrix, h: &Real) -> Result<Effect, NormTooLarge> {
    if part == Part::Held {
        let (_, gamma) = zero_order_hold(a, column, h)?;
        return Ok(Effect { at_end: Some(gamma), ..Effect::default() });
    }
    let (_, first, last) = first_order_hold(a, column, h)?;
    let curve = |start| third_order_hold(a, column, h, start);
    Ok(match part {
        Part::Start => Effect { at_end: Some(first), ..Effect::default() },
        Part::End => Effect { at_end: Some(last), ..Effect::default() },
        Part::Curves => {
            let curve = Some(Box::new([curve(0)?, curve(1)?, curve(2)?]));
            Effect { at_begin: Some(first), at_end: Some(last), curve }
        }
        _ => Effect { at_begin: Some(first), at_end: Some(last), curve: None },
    })
}
