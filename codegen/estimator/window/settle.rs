//! Rounds a functional once, when its constants have settled.

use super::solve::{Choice, Exact, ExactPrediction};
use super::{Functional, Prediction, Way, Weights};
use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::real::{Precision, Real};
use crate::sampled::Signal;
use crate::sampled::model::Model;
use crate::sampled::settle::{Numerics, Pass, rising};

/// Designs by least squares or minimax weights at rising precision until everything has settled.
pub fn settle(
    plant: &Plant,
    signals: &[Signal],
    delays: &[usize],
    steps: usize,
    choice: &Choice,
) -> Result<(Functional, Exact, Numerics), Vec<Diagnostic>> {
    let run = |p: Precision| -> Result<Exact, Vec<Diagnostic>> {
        let model = Model::new(plant, signals, p)?;
        Exact::new(model, signals, delays, steps, choice, p).map_err(|error| {
            let message = "the window does not determine the state";
            vec![Diagnostic::error(codes::UNOBSERVABLE, plant.span.clone(), message).label(error.to_string())]
        })
    };
    settle_runs(plant, signals, delays, steps, Bias::None, &run)
}

/// What the weights may leave of the state before the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bias {
    /// Nothing in exact arithmetic.
    None,
    /// The error of integrals that are taken from samples.
    OfSampling,
}

/// Settles a window functional; `run` is the design at one precision.
pub fn settle_runs(
    plant: &Plant,
    signals: &[Signal],
    delays: &[usize],
    steps: usize,
    bias: Bias,
    run: &dyn Fn(Precision) -> Result<Exact, Vec<Diagnostic>>,
) -> Result<(Functional, Exact, Numerics), Vec<Diagnostic>> {
    let round = |pass: &mut Pass, coarse: &Exact, fine: &Exact| functional(pass, coarse, fine, signals, delays, steps);
    let unbiasedness = |exact: &Exact| if bias == Bias::None { exact.unbiasedness } else { 0.0 };
    let (functional, exact, numerics) = rising(plant, run, round, unbiasedness)?;
    let unbiasedness = exact.unbiasedness;
    Ok((functional, exact, Numerics { unbiasedness, ..numerics }))
}

fn weights(pass: &mut Pass, first: usize, coarse: &[Vec<Real>], fine: &[Vec<Real>]) -> Weights {
    Weights { first, columns: coarse.iter().zip(fine).map(|(c, f)| pass.group(c, f)).collect() }
}

/// Rounds a prediction.
pub(crate) fn prediction(pass: &mut Pass, coarse: &ExactPrediction, fine: &ExactPrediction) -> Prediction {
    let states = pass.each(&coarse.states, &fine.states);
    let held = pass.each(&coarse.held, &fine.held);
    let end = pass.each(&coarse.end, &fine.end);
    let constant = pass.each(std::slice::from_ref(&coarse.constant), std::slice::from_ref(&fine.constant));
    Prediction { states, held, end, constant: constant[0].unwrap_or_default() }
}

fn functional(
    pass: &mut Pass,
    coarse: &Exact,
    fine: &Exact,
    signals: &[Signal],
    delays: &[usize],
    steps: usize,
) -> Functional {
    let outputs = coarse.outputs.iter().zip(&fine.outputs).map(|(c, f)| weights(pass, 0, c, f)).collect();
    let knowns = (0..signals.len()).map(|s| weights(pass, fine.first[s], &coarse.knowns[s], &fine.knowns[s])).collect();
    let constant = pass.each(&coarse.constant, &fine.constant).into_iter().map(Option::unwrap_or_default).collect();
    let prediction = coarse.prediction.iter().zip(&fine.prediction).map(|(c, f)| prediction(pass, c, f)).collect();
    Functional {
        steps,
        delays: delays.to_vec(),
        signals: signals.to_vec(),
        outputs,
        knowns,
        constant,
        prediction,
        gaps: None,
        irregular: None,
        way: Way::Fir,
        longer: Vec::new(),
    }
}
