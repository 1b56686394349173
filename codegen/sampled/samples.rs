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
        _ if ratio > count(MOST) => too_many(ratio, span, what, plant.sample_time_s()),
        _ => not_whole(ratio, span, what, plant.sample_time_s()),
    };
    found.push(mistake);
    None
}

fn too_many(ratio: f64, span: &Range<usize>, what: &str, h: f64) -> Diagnostic {
    let meant = meant(ratio * h, h).map_or_else(String::new, |meant| format!("{meant}; else "));
    Diagnostic::error(codes::WINDOW_TOO_LONG, span.clone(), format!("{what} has too many samples"))
        .label(format!("{} samples; at most {MOST} are designed", show(ratio)))
        .measured(ratio)
        .help(format!("{meant}a shorter time, or a longer sample time"))
}

/// What a whole number of seconds stands for where samples or milliseconds were meant.
fn meant(seconds: f64, h: f64) -> Option<String> {
    let is_count = (2.0..1e6).contains(&seconds) && show(seconds) == show(seconds.round());
    let (samples, milliseconds) = (show(seconds * h), show(seconds / 1000.0));
    let count = show(seconds);
    is_count.then(|| {
        if samples == milliseconds {
            format!("it is in seconds: {count} samples, or ms, are {samples} s")
        } else {
            format!("it is in seconds: {count} samples are {samples} s, {count} ms are {milliseconds} s")
        }
    })
}

/// So many samples.
fn counted(samples: f64) -> String {
    format!("{} sample{}", show(samples), if samples == 1.0 { "" } else { "s" })
}

fn not_whole(ratio: f64, span: &Range<usize>, what: &str, h: f64) -> Diagnostic {
    let (below, above, nearest) = (ratio.floor(), ratio.ceil(), ratio.round());
    let choice = |samples: f64| format!("{} s has {}", show(samples * h), counted(samples));
    let error = Diagnostic::error(codes::NOT_WHOLE, span.clone(), format!("{what} is not a whole number of samples"));
    if nearest > 0.0 && show(ratio) == show(nearest) {
        // A time such as 0.30000000000000004, the sum of two others in binary.
        return error
            .label(format!("not quite {} of {} s", counted(nearest), show(h)))
            .measured(ratio)
            .help(format!("write {}", show(nearest * h)));
    }
    let help = if below > 0.0 { format!("{}, {}", choice(below), choice(above)) } else { choice(above.max(1.0)) };
    // A sample time of whole seconds, in which the time does not fit: milliseconds?
    let small = ratio < 1.0 && h >= 1.0 && show(h) == show(h.round());
    let meant = format!("`sample_time` is in seconds: {} ms are {} s; else ", show(h), show(h / 1000.0));
    error.label(format!("{} samples of {} s", show(ratio), show(h))).measured(ratio).help(if small {
        meant + &help
    } else {
        help
    })
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
        let h = plant.sample_time_s();
        let meant = meant(count(steps) * h, h).map_or_else(String::new, |meant| format!("{meant}; else "));
        found.push(error.help(format!("{meant}a shorter window, a longer sample time, or fewer states")));
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
