//! What a sample that is not due at every call asks of a method that predicts and corrects.

use std::ops::Range;

use super::window::VERDICT_BITS;
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::interval;
use crate::numbers::count;
use crate::plant::{Output, Plant};
use crate::real::{Precision, equilibrated_columns, rank, singular_values};
use crate::sampled::model::Model;

/// The most calls from one sample to the next of a gain that stays.
const MOST_CALLS: usize = 1_000;

/// As many samples as a number of calls has, which must end with one; mistakes are collected.
pub(super) fn samples(
    plant: &Plant,
    calls: usize,
    span: &Range<usize>,
    what: &str,
    found: &mut Vec<Diagnostic>,
) -> Option<usize> {
    let every = interval::calls(plant);
    if calls.is_multiple_of(every) {
        return Some(calls / every);
    }
    let (output, below) = (&plant.outputs[0], calls - calls % every);
    let message = format!("{what} is not that of a sample");
    let error = Diagnostic::error(codes::NOT_WHOLE, span.clone(), message).measured(count(calls));
    let error = error.label(format!("{calls} calls"));
    let error = error.context(output.every_span.clone(), format!("measured at every {every} calls"));
    let [below, above] = [below, below + every].map(|calls| show(count(calls) * plant.sample_time_s()));
    found.push(error.help(format!("{below} s or {above} s")));
    None
}

/// A certificate is of every call between two samples.
pub(super) fn refuse_rare(plant: &Plant, found: &mut Vec<Diagnostic>) {
    let calls = interval::calls(plant);
    let Some(output) = plant.outputs.first().filter(|_| calls > MOST_CALLS) else { return };
    let message = format!("a sample of `{}` is due too rarely to be certified", output.label.name);
    let error = Diagnostic::error(codes::TOO_LARGE, output.every_span.clone(), message);
    let error = error.label(format!("at most every {MOST_CALLS} calls")).measured(count(calls));
    found.push(error.help("a longer sample time"));
}

/// Whether the samples that are due show every state, as those of every call do; the condition number of n + 1 of them.
/// `None` where every call is a sample.
pub(super) fn verdict(plant: &Plant) -> Result<Option<f64>, Vec<Diagnostic>> {
    let (calls, n) = (interval::calls(plant), plant.states.len());
    let Some(output) = plant.outputs.first().filter(|_| calls > 1) else { return Ok(None) };
    let model = Model::new(plant, &[], Precision::bits(VERDICT_BITS))?;
    let step = interval::transition(plant, &model.phi);
    let mut row = model.c.clone();
    let mut rows = row.clone();
    for _ in 0..n {
        row = &row * &step;
        rows = rows.vcat(&row);
    }
    let scaled = equilibrated_columns(&rows).0;
    let seen = rank(&scaled, VERDICT_BITS / 2).rank;
    if seen < n {
        return Err(vec![in_step(plant, output, seen)]);
    }
    let values = singular_values(&scaled);
    Ok(Some((&values[0] / &values[n - 1]).to_f64()))
}

fn in_step(plant: &Plant, output: &Output, seen: usize) -> Diagnostic {
    let place: Range<usize> = output.every_span.clone();
    let message = format!("samples of `{}` {} s apart do not show every state", output.label.name, apart(plant));
    let error = Diagnostic::error(codes::UNOBSERVABLE, place, message).measured(count(seen));
    let error = error.label(format!("rank {seen} of {}", plant.states.len()));
    error.help("another rate: the samples come in step with a motion of the plant")
}

/// m h, s, as a person writes it.
pub(super) fn apart(plant: &Plant) -> String {
    show(interval::seconds(plant))
}

/// So many samples, in words.
pub(super) fn counted(plant: &Plant, samples: usize) -> String {
    match interval::calls(plant) {
        1 => format!("{samples} calls at {} s", plant.sample_time_s()),
        _ => format!("{samples} samples, {} s apart", apart(plant)),
    }
}

/// The summary of a method, with when it corrects.
pub(super) fn said(plant: &Plant, summary: String) -> String {
    match interval::calls(plant) {
        1 => summary,
        calls => format!("{summary}; corrected at every {calls} calls"),
    }
}

/// How late a rate is at constant acceleration, with the rule that says so for samples `h` apart; it stays until the next
/// sample, m h behind one.
pub(super) fn late(plant: &Plant, seconds: f64, rule: &str) -> String {
    let at = format!("at constant acceleration the rate is {} s late", crate::numbers::short(seconds));
    if interval::calls(plant) == 1 {
        return format!("{at}: {rule}");
    }
    let more = interval::seconds(plant) - plant.sample_time_s();
    let latest = crate::numbers::short(seconds + more);
    format!("{at} at a sample, {latest} s before the next: {rule} with h = {} s", apart(plant))
}
