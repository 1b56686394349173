//! Outputs that are measured at rates of their own: what is due must show the state at every phase.

use std::ops::Range;

use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::irregular::Pattern;
use crate::numbers::count;
use crate::plant::Plant;
use crate::real::Precision;
use crate::sampled::model::Model;

use super::VERDICT_BITS;

/// The most phases times samples of a window that are designed for.
const MOST_PHASES: usize = 50_000;

/// When the samples of each output come; or that they show too little.
pub(super) fn pattern(
    plant: &Plant,
    delays: Vec<usize>,
    steps: usize,
    window: &Range<usize>,
) -> Result<Pattern, Vec<Diagnostic>> {
    let every: Vec<usize> = plant.outputs.iter().map(|output| output.every).collect();
    let latest = delays.iter().max().copied().unwrap_or(0);
    let pattern = Pattern::new(every, delays);
    let Some(period) = pattern.period().filter(|period| period.saturating_mul(steps + 1) <= MOST_PHASES) else {
        return Err(vec![too_many_phases(plant, &pattern, steps)]);
    };
    if period > 1 {
        let model = Model::new(plant, &[], Precision::bits(VERDICT_BITS))?;
        let n = plant.states.len();
        let shown = pattern.shown(&model, steps, None);
        if shown < n {
            // Beyond this a phase has shown whatever it shows.
            let longest = (n + 1) * period + latest;
            return Err(vec![too_few(plant, &pattern, &model, (steps, shown, longest), window)]);
        }
    }
    Ok(pattern)
}

fn too_many_phases(plant: &Plant, pattern: &Pattern, steps: usize) -> Diagnostic {
    let slowest = plant.outputs.iter().max_by_key(|output| output.every);
    let span = slowest.map_or(plant.span.clone(), |output| output.every_span.clone());
    let error = Diagnostic::error(codes::TOO_LARGE, span, "the rates have too many phases");
    let most = MOST_PHASES / (steps + 1);
    let error = match pattern.period() {
        Some(period) => error
            .label(format!("they meet every {period} calls; with {} samples at most {most} are designed", steps + 1))
            .measured(count(period)),
        None => error.label("they never meet"),
    };
    error.help("rates that are multiples of each other, or a shorter window")
}

/// How many states the worst phase shows, and the shortest window that shows all.
fn too_few(
    plant: &Plant,
    pattern: &Pattern,
    model: &Model,
    (steps, shown, longest): (usize, usize, usize),
    window: &Range<usize>,
) -> Diagnostic {
    let n = plant.states.len();
    let message = "the samples that are due within the window do not show every state";
    let error = Diagnostic::error(codes::WINDOW_TOO_SHORT, window.clone(), message)
        .label(format!("{shown} of {n} states at the worst of {} calls", pattern.period().unwrap_or(1)))
        .measured(count(shown));
    let enough = |steps: usize| pattern.shown(model, steps, None) == n;
    if longest <= steps || !enough(longest) {
        return error.help("another rate: the samples come in step with a motion of the plant, whatever the window");
    }
    let (mut few, mut many) = (steps, longest);
    while few + 1 < many {
        let middle = usize::midpoint(few, many);
        if enough(middle) { many = middle } else { few = middle }
    }
    error.help(format!("a window of at least {} s", show(count(many) * plant.sample_time_s())))
}
