//! Samples that come with their age: for which plants and ages.

use std::ops::Range;

use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::irregular::degree;
use crate::numbers::seconds;
use crate::plant::{Aged, Output, Plant};
use crate::sampled::Signal;

/// Reports what stands against ages.
pub(super) fn check(plant: &Plant, signals: &[Signal], steps: usize) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (o, output) in plant.outputs.iter().enumerate() {
        let Some(aged) = &output.aged else { continue };
        let mistakes = [
            refuse_fast(plant, o, aged),
            refuse_name(plant, output, aged),
            refuse_oldest(plant, signals, steps, output, aged),
        ];
        found.extend(mistakes.into_iter().flatten());
    }
    found
}

fn refuse_fast(plant: &Plant, output: usize, aged: &Aged) -> Option<Diagnostic> {
    match degree(plant, output, &aged.most) {
        Ok(Some(_)) => None,
        Ok(None) => {
            let most = aged.most.to_f64().unwrap_or(f64::NAN);
            let message = format!("the plant is too fast for samples that are up to {} s old", show(most));
            let error = Diagnostic::error(codes::METHOD_CANNOT, aged.span.clone(), message);
            let error = error.label("24 powers of the age do not suffice").measured(most);
            Some(error.help("a smaller `age_max`, or a model without the fast states"))
        }
        Err(mut found) => found.pop(),
    }
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
