//! The sampled plant: what one sample interval does to the state, at a given precision.
//!
//! Continuous plants are discretised exactly for inputs that keep their value, and for signals
//! that run straight from sample to sample; nothing here approximates but the straight line
//! itself. Discrete plants are taken as they are.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Constant;
use crate::plant::combine::{Change, change};
use crate::plant::{Hold, Plant};
use crate::real::{Matrix, Precision, Real, first_order_hold, zero_order_hold};

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

impl Model {
    /// Samples the plant.
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
        let offset = Matrix::from_fn(n, 1, |i, _| value(&plant.offset[i]));
        let refused = || {
            let error =
                Diagnostic::error(codes::DOMAIN, plant.span.clone(), "a constant of the plant has no usable value");
            let label = format!("not at {} bits", precision.as_bits());
            vec![error.label(label).help("it is the difference of nearly equal constants: write its value as a number")]
        };
        if plant.discrete {
            let effects = signals.iter().map(|signal| discrete_effect(signal.part, column(signal))).collect();
            if domain.get() {
                return Err(refused());
            }
            return Ok(Self { phi: a, c, effects, constant: offset, trust: trust(plant, precision) });
        }
        let h = value(&plant.sample_time.0);
        let too_large = |error: &dyn std::fmt::Display| {
            let span = plant.sample_time.1.clone();
            let fastest = h.log2_abs() + a.max_abs().log2_abs();
            if fastest < 8.0 {
                let far = Diagnostic::error(
                    codes::OUT_OF_RANGE,
                    span,
                    "the plant's coefficients are too far apart to compute with",
                )
                .label("scaling the states to similar sizes takes factors beyond 1e1233")
                .help("choose units in which all states and coefficients have similar sizes");
                return vec![far];
            }
            let fast = Diagnostic::error(codes::OUT_OF_RANGE, span, "the plant is too fast for this sample time")
                .label(error.to_string())
                .help("shorten the sample time, or leave the fast states out of the model");
            vec![fast]
        };
        let (phi, constant) = zero_order_hold(&a, &offset, &h).map_err(|e| too_large(&e))?;
        let mut effects = Vec::new();
        for signal in signals {
            let effect = continuous_effect(signal.part, &a, &column(signal), &h).map_err(|e| too_large(&e))?;
            effects.push(effect);
        }
        if domain.get() {
            return Err(refused());
        }
        Ok(Self { phi, c, effects, constant, trust: trust(plant, precision) })
    }
}

/// Samples of different sensors are comparable only in units of their noise. One sensor needs no unit.
fn trust(plant: &Plant, precision: Precision) -> Vec<Real> {
    let one = || Real::one(precision);
    let inverse =
        |output: &crate::plant::Output| one().checked_div(&output.noise.as_ref()?.evaluate(precision).ok()?).ok();
    let all: Option<Vec<Real>> = plant.outputs.iter().map(inverse).collect();
    all.filter(|all| all.len() > 1).unwrap_or_else(|| plant.outputs.iter().map(|_| one()).collect())
}

/// A discrete plant uses the value at the beginning of its step.
pub(crate) fn discrete_effect(part: Part, column: Matrix) -> Effect {
    match part {
        Part::Held | Part::Start => Effect { at_begin: None, at_end: Some(column) },
        Part::Runs => Effect { at_begin: Some(column), at_end: None },
        Part::End => Effect::default(),
    }
}

/// Held, or a straight line over the interval.
pub(crate) fn continuous_effect(
    part: Part,
    a: &Matrix,
    column: &Matrix,
    h: &Real,
) -> Result<Effect, crate::real::NormTooLarge> {
    if part == Part::Held {
        let (_, gamma) = zero_order_hold(a, column, h)?;
        return Ok(Effect { at_begin: None, at_end: Some(gamma) });
    }
    let (_, first, last) = first_order_hold(a, column, h)?;
    Ok(match part {
        Part::Start => Effect { at_begin: None, at_end: Some(first) },
        Part::End => Effect { at_begin: None, at_end: Some(last) },
        _ => Effect { at_begin: Some(first), at_end: Some(last) },
    })
}
