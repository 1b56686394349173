//! `window = [0.01, 0.03, 0.1]`: several windows over one buffer of samples, each with its estimate.

use super::{seconds, settle, trimmed, window_steps};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::Functional;
use crate::estimator::window::certificate::certify;
use crate::estimator::window::realize::Way;
use crate::estimator::window::rounding;
use crate::estimator::window::solve::Choice;
use crate::numbers::count;
use crate::plant::Plant;
use crate::promise::OfWindow;
use crate::sampled::Signal;
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The most windows over one buffer.
const MOST: usize = 8;

/// The key `window`: a number, or a list of them; mistakes of its form are reported.
pub(super) fn read(table: &mut Table) -> Option<Vec<Quantity>> {
    if !table.has_list("window") {
        return table.quantity("window").map(|window| vec![window]);
    }
    let (windows, span) = table.list("window")?;
    if windows.is_empty() || windows.len() > MOST {
        let message = format!("`window` in {} must be a number, or a list of 1 to {MOST} of them", table.what());
        let error = Diagnostic::error(codes::BAD_NUMBER, span, message).label(format!("this has {}", windows.len()));
        table.report(error.measured(count(windows.len())).help("write the lengths in seconds, shortest first"));
        return None;
    }
    Some(windows)
}

/// N of each window, shortest first; `None` after reporting what stands against one of them.
pub(super) fn steps(plant: &Plant, windows: &[Quantity], found: &mut Vec<Diagnostic>) -> Option<Vec<usize>> {
    let all: Vec<Option<usize>> = windows.iter().map(|window| window_steps(plant, window, found)).collect();
    let all: Vec<usize> = all.into_iter().collect::<Option<_>>()?;
    let before = found.len();
    for (pair, window) in all.windows(2).zip(&windows[1..]) {
        if pair[1] <= pair[0] {
            let message = "each window must be longer than the one before it";
            let length = |steps: usize| show(seconds(steps, plant.sample_time_s()));
            let label = format!("{} s, behind {} s", length(pair[1]), length(pair[0]));
            let error = Diagnostic::error(codes::BAD_NUMBER, window.span(), message).label(label);
            found.push(error.measured(count(pair[1])).help("sort them, shortest first, each once"));
        }
    }
    refuse_names(plant, all.len(), found);
    (found.len() == before).then_some(all)
}

/// Refuses states whose names are those of a longer window's estimates.
fn refuse_names(plant: &Plant, windows: usize, found: &mut Vec<Diagnostic>) {
    let taken = |name: &str| plant.states.iter().find(|state| state.label.name == name);
    let mut refuse = |state: &crate::plant::State, what: String| {
        let message = format!("`{}` names two fields of the estimate", state.label.name);
        let error = Diagnostic::error(codes::DUPLICATE_NAME, state.label.span.clone(), message);
        found.push(error.label(format!("so is {what} called")).help("rename the state"));
    };
    for (state, place) in plant.states.iter().flat_map(|state| (2..=windows).map(move |place| (state, place))) {
        if let Some(other) = taken(&format!("{}_{place}", state.label.name)) {
            refuse(other, format!("`{}` of window {place}", state.label.name));
        }
    }
    if windows > 1
        && let Some(state) = taken("windows")
    {
        refuse(state, "the number of windows that have converged".into());
    }
}

/// A longer window over the same samples.
pub(super) fn longer(
    plant: &Plant,
    signals: &[Signal],
    delays: &[usize],
    steps: usize,
    choice: &Choice,
) -> Result<(Functional, OfWindow), Vec<Diagnostic>> {
    let (functional, exact, _) = settle(plant, signals, delays, steps, choice)?;
    let mut certificate = certify(plant, &functional, &exact);
    certificate.rounding = rounding::bound(plant, &functional, &Way::Fir, &certificate.noise_gain_l1);
    Ok((functional, OfWindow { steps, certificate }))
}

/// From when on the longer windows' estimates are their own.
pub(super) fn note(all: &[usize]) -> Option<String> {
    let longer = all.iter().enumerate().skip(1);
    let calls: Vec<String> =
        longer.map(|(place, steps)| format!("those of window {} from call {}", place + 1, steps + 1)).collect();
    (!calls.is_empty()).then(|| format!("{}, until then as the next shorter one", calls.join(", ")))
}

/// `11, 31 and 101 samples (0.01 s, 0.03 s, 0.1 s)`.
pub(super) fn lengths(all: &[usize], h: f64) -> String {
    let samples: Vec<String> = all.iter().map(|steps| (steps + 1).to_string()).collect();
    let times: Vec<String> = all.iter().map(|steps| format!("{} s", trimmed(seconds(*steps, h)))).collect();
    let (last, before) = samples.split_last().unwrap_or_else(|| unreachable!("there is at least one window"));
    format!("{} and {last} samples ({})", before.join(", "), times.join(", "))
}
