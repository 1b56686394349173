//! Samples that come with their age: for which plants and ages.

use std::ops::Range;

use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::irregular::degree;
use crate::expr::{Constant, Symbol};
use crate::numbers::{count, seconds};
use crate::plant::{Aged, Output, Plant};
use crate::sampled::Signal;

/// The most states of a plant that is no chain of integrators.
const MOST_STATES: usize = 3;
/// The most states of a chain of integrators.
const LONGEST_CHAIN: usize = 4;

/// Reports what stands against ages.
pub(super) fn check(plant: &Plant, signals: &[Signal], steps: usize) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (o, output) in plant.outputs.iter().enumerate() {
        let Some(aged) = &output.aged else { continue };
        let mistakes = [
            refuse_plant(plant, o, aged),
            refuse_sensor(plant, o, output, aged),
            refuse_name(plant, output, aged),
            refuse_oldest(plant, signals, steps, output, aged),
        ];
        found.extend(mistakes.into_iter().flatten());
    }
    found
}

fn refuse(aged: &Aged, message: String) -> Diagnostic {
    Diagnostic::error(codes::METHOD_CANNOT, aged.span.clone(), message)
}

fn refuse_plant(plant: &Plant, output: usize, aged: &Aged) -> Option<Diagnostic> {
    if plant.discrete {
        let message = "a discrete plant has nothing between samples".to_owned();
        return Some(refuse(aged, message).help("write the plant in continuous time, or leave out `age`"));
    }
    let n = plant.states.len();
    let chain = n <= LONGEST_CHAIN && is_nilpotent(&plant.a);
    if n > MOST_STATES && !chain {
        let message = format!("samples with an age are for at most {MOST_STATES} states, {LONGEST_CHAIN} in a chain");
        let error = refuse(aged, message).label(format!("this plant has {n}")).measured(count(n));
        return Some(error.help("fewer states, or samples at the times of calls: `missing = \"left-out\"`"));
    }
    match degree(plant, output, &aged.most) {
        Ok(Some(_)) => None,
        Ok(None) => {
            let most = aged.most.to_f64().unwrap_or(f64::NAN);
            let message = format!("the plant is too fast for samples that are up to {} s old", show(most));
            let error = refuse(aged, message).label("24 powers of the age do not suffice").measured(most);
            Some(error.help("a smaller `age_max`, or a model without the fast states"))
        }
        Err(mut found) => found.pop(),
    }
}

/// Whether the powers of A end: chains of integrators.
fn is_nilpotent(a: &[Vec<Constant>]) -> bool {
    let n = a.len();
    let mut reaches: Vec<Vec<bool>> = a.iter().map(|row| row.iter().map(|x| !x.is_zero()).collect()).collect();
    for k in 0..n {
        for i in 0..n {
            for j in 0..n {
                reaches[i][j] |= reaches[i][k] && reaches[k][j];
            }
        }
    }
    (0..n).all(|i| !reaches[i][i])
}

fn refuse_sensor(plant: &Plant, o: usize, output: &Output, aged: &Aged) -> Option<Diagnostic> {
    let name = &output.label.name;
    if let Some((_, delay)) = &output.delay {
        let message = format!("`{name}` has a delay and an age");
        return Some(refuse(aged, message).context(delay.clone(), "the delay").help("add the delay to the age"));
    }
    if let Some(gate) = &output.gate {
        let message = format!("`{name}` has a gate and an age");
        let error = refuse(aged, message).context(gate.span.clone(), "predictions are of the time of a call");
        return Some(error.help("leave out one of them"));
    }
    if output.feedthrough.iter().any(|factor| !factor.is_zero()) {
        let message = format!("`{name}` has an input in it and an age");
        return Some(refuse(aged, message).help("take the input out of the sample before the call"));
    }
    let shows =
        |symbol: &Symbol| matches!(symbol, Symbol::State(j) if plant.states[*j].measured.iter().any(|(m, _)| *m == o));
    let injection = plant.injections.iter().find(|injection| injection.symbols().iter().any(shows))?;
    let message = format!("`{}` needs `{name}` at the time of each call", injection.text);
    let error = refuse(aged, message).context(injection.node.span.clone(), "this nonlinear term");
    Some(error.help("measure it at the calls, without `age`"))
}

fn refuse_name(plant: &Plant, output: &Output, aged: &Aged) -> Option<Diagnostic> {
    let field = format!("{}_age", output.label.name);
    let other = plant.outputs.iter().find(|other| other.label.name == field)?;
    let error = Diagnostic::error(codes::BAD_NAME, other.label.span.clone(), format!("`{field}` is an age"));
    Some(error.context(aged.span.clone(), "this adds a field to the measurements").help("another name for the output"))
}

/// Ages within the window; with something that acts on the plant, within one sample.
fn refuse_oldest(plant: &Plant, signals: &[Signal], steps: usize, output: &Output, aged: &Aged) -> Option<Diagnostic> {
    let h = plant.sample_time_s();
    let oldest = aged.most.to_f64().unwrap_or(f64::NAN);
    let (most, why): (f64, &str) = if signals.is_empty() {
        (seconds(steps, h), "the window")
    } else {
        (h, "a sample time, as something acts on the plant")
    };
    let span: Range<usize> = aged.span.clone();
    // Both are given in decimals; a double tells them apart.
    (oldest > most).then(|| {
        let message = format!("samples of `{}` may be older than {why}", output.label.name);
        let error = Diagnostic::error(codes::OUT_OF_RANGE, span, message);
        let error = error.label(format!("{} s; at most {} s", show(oldest), show(most))).measured(oldest);
        error.help(format!("`age_max = {}` or less", show(most)))
    })
}
