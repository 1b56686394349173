//! Times as whole numbers of samples.

use crate::numbers::count;
use std::ops::Range;

use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Constant;
use crate::plant::Plant;
use crate::real::{Precision, Real};

/// The longest window that is designed, in samples.
const MOST: usize = 20_000;

/// A time as a whole number of samples; `None` after reporting that it is not one, or too many.
pub fn whole_samples(
    time: &Constant,
    span: &Range<usize>,
    what: &str,
    plant: &Plant,
    found: &mut Vec<Diagnostic>,
) -> Option<usize> {
    let ratio = time.to_f64().unwrap_or(f64::NAN) / plant.sample_time_s();
    let samples = exactly_whole(time, &plant.sample_time.0);
    let mistake = match samples {
        Some(samples) if samples <= MOST => return Some(samples),
        _ if ratio > count(MOST) => too_many(ratio, span, what),
        _ => not_whole(ratio, span, what, plant.sample_time_s()),
    };
    found.push(mistake);
    None
}

fn too_many(ratio: f64, span: &Range<usize>, what: &str) -> Diagnostic {
    Diagnostic::error(codes::WINDOW_TOO_LONG, span.clone(), format!("{what} has too many samples"))
        .label(format!("{} samples; at most {MOST} are designed", show(ratio)))
        .measured(ratio)
        .help("a shorter time, or a longer sample time")
}

fn not_whole(ratio: f64, span: &Range<usize>, what: &str, h: f64) -> Diagnostic {
    let (below, above, nearest) = (ratio.floor(), ratio.ceil(), ratio.round());
    let choice = |samples: f64| format!("{} s has {} samples", show(samples * h), show(samples));
    if nearest > 0.0 && show(ratio) == show(nearest) {
        // A time such as 0.30000000000000004, the sum of two others in binary.
        return Diagnostic::error(codes::NOT_WHOLE, span.clone(), format!("{what} is not a whole number of samples"))
            .label(format!("not quite {} samples of {} s", show(nearest), show(h)))
            .measured(ratio)
            .help(format!("write {}", show(nearest * h)));
    }
    let help = if below > 0.0 { format!("{}, {}", choice(below), choice(above)) } else { choice(above.max(1.0)) };
    Diagnostic::error(codes::NOT_WHOLE, span.clone(), format!("{what} is not a whole number of samples"))
        .label(format!("{} samples of {} s", show(ratio), show(h)))
        .measured(ratio)
        .help(help)
}

/// The most weights that are designed: 1.6 MB as doubles, more than any target of a step has.
const MOST_WEIGHTS: usize = 200_000;

/// The most steps of the design's longest loops, about half a minute.
const MOST_WORK: usize = 20_000_000;

/// Samples whose loops cost as much as the exponential does.
const EXPONENTIAL: usize = 40;

/// Reports a window that would take minutes to design, for a step that no target can hold.
pub fn refuse_much_work(plant: &Plant, steps: usize, span: &Range<usize>, found: &mut Vec<Diagnostic>) {
    let (n, p) = (plant.states.len(), plant.outputs.len());
    let signals = p + plant.inputs.len() + plant.injections.len();
    let by_weights = (MOST_WEIGHTS / (n * signals)).saturating_sub(1);
    let by_work = (MOST_WORK / (n * n * (n + p))).saturating_sub(EXPONENTIAL);
    let most = by_weights.min(by_work);
    if most == 0 {
        let message = format!("{n} states are too many for this method");
        let error = Diagnostic::error(codes::TOO_LARGE, plant.span.clone(), message).measured(count(n));
        found.push(error.label("not one sample fits into the work of a design").help("a model with fewer states"));
    } else if steps > most {
        let message = "the window is too long for a plant of this size";
        let label = format!("{steps} samples of {n} states; at most {most} are designed");
        let error =
            Diagnostic::error(codes::WINDOW_TOO_LONG, span.clone(), message).label(label).measured(count(steps));
        found.push(error.help("a shorter window, a longer sample time, or fewer states"));
    }
}

/// The ratio of two times, when it is a whole number: exactly if both are rational, else to 30 digits.
fn exactly_whole(time: &Constant, h: &Constant) -> Option<usize> {
    if let (Some(time), Some(h)) = (time.as_rational(), h.as_rational()) {
        let ratio = time / h;
        return if ratio.is_int() { ratio.numerator().clone().try_into().ok() } else { None };
    }
    let precision = Precision::bits(256);
    let ratio = time.evaluate(precision).ok()?.checked_div(&h.evaluate(precision).ok()?).ok()?;
    let nearest = Real::from_f64(ratio.to_f64().round(), precision)?;
    let distance = &ratio - &nearest;
    let near = distance.is_zero() || distance.log2_abs() < -100.0;
    nearest.to_integer().filter(|_| near).and_then(|whole| usize::try_from(whole).ok())
}
