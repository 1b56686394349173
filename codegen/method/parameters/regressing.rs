//! Unknowns whose factors vary: the regression in the step, and what is promised of it.

use std::sync::Arc;

use super::super::window::{constants, resolution_warnings, time_warning};
use super::{Frame, METHOD, summary};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::window::regression::bound::noise_floors;
use crate::estimator::window::regression::exact::Problem;
use crate::estimator::window::regression::excitation::excitation;
use crate::estimator::window::regression::{MOST, Regression};
use crate::expr::List;
use crate::numbers::{count, short, trimmed};
use crate::plant::Plant;
use crate::program::Scalar;
use crate::promise::{Certificate, Convergence};
use crate::sampled::model::signals;
use crate::sampled::unknowns::augment::{own_states, varying};
use crate::sampled::unknowns::functions::Functions;
use crate::spec::Quantity;

/// The default of `excitation` in single precision: responses are right to about 1e-6, the unknowns then to 1e-3.
const SINGLE: f64 = 1e-3;
/// And in double precision: 1e-15 and 1e-9.
const DOUBLE: f64 = 1e-6;

/// Designs the regression.
pub(super) fn design(plant: &Plant, frame: &Frame, excitation: Option<&Quantity>) -> Result<Design, Vec<Diagnostic>> {
    refuse_many(plant)?;
    let (signals, steps, functions) = (signals(plant), frame.steps, Functions::of(plant));
    let threshold = threshold(plant, excitation)?;
    let problem = Problem { plant, functions, signals: &signals, delays: &frame.delays, steps, threshold };
    let (mut regression, exact, mut numerics) = problem.settle()?;
    regression.floors = noise_floors(plant, &regression);
    numerics.condition = frame.condition;
    let mut notes = notes(plant, &problem.functions, threshold);
    notes.extend(excited(plant, &problem.functions, &regression)?);
    Ok(Design {
        method: METHOD.name,
        realization: "regression",
        summary: summary(plant, steps),
        window_steps: steps,
        valid_from_step: steps,
        convergence: Convergence::Finite,
        realizations: Vec::new(),
        notes,
        constants: constants(&exact.model),
        fir: None,
        certificate: Certificate::default(),
        numerics,
        warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
        longer: Vec::new(),
        phases: Vec::new(),
        estimator: Arc::new(regression),
    })
}

/// The smallest share of an unknown's energy that the state must leave unexplained.
fn threshold(plant: &Plant, key: Option<&Quantity>) -> Result<f64, Vec<Diagnostic>> {
    let Some(key) = key else {
        return Ok(match plant.scalar {
            Scalar::F32 => SINGLE * SINGLE,
            Scalar::F64 => DOUBLE * DOUBLE,
        });
    };
    let mut found = Vec::new();
    let value = plant.constant(key, &mut found).and_then(|value| value.to_f64().ok()).unwrap_or(f64::NAN);
    if found.is_empty() && !(value > 0.0 && value < 1.0) {
        let message = format!("`excitation` must be between 0 and 1, not {}", show(value));
        let error = Diagnostic::error(codes::BAD_NUMBER, key.span(), message).measured(value);
        found.push(error.help("write the smallest share of an unknown's effect that counts, such as 1e-3"));
    }
    if found.is_empty() { Ok(value * value) } else { Err(found) }
}

/// The loops of the step are written out by state and unknown; beyond this they fill a target's flash.
const MOST_PRODUCTS: usize = 10_000;

fn refuse_many(plant: &Plant) -> Result<(), Vec<Diagnostic>> {
    let (own, q) = (own_states(plant), varying(plant).len());
    let products = (q + 1) * own * own;
    if products > MOST_PRODUCTS {
        let message = format!("{own} states are too many for {q} unknowns with factors that vary");
        let error = Diagnostic::error(codes::TOO_LARGE, plant.span.clone(), message).measured(count(products));
        let label = format!("{products} products for each sample of the window; at most {MOST_PRODUCTS}");
        return Err(vec![error.label(label).help("fewer unknowns, a model with fewer states, or constant factors")]);
    }
    let varying = varying(plant);
    let Some(first) = varying.get(MOST) else { return Ok(()) };
    let message = format!("{} unknowns have factors that vary; at most {MOST} are estimated", varying.len());
    let error = Diagnostic::error(codes::METHOD_CANNOT, plant.unknowns[*first].label.span.clone(), message);
    Err(vec![error.measured(count(varying.len())).help("fewer unknowns")])
}

/// What is promised while the gain depends on the signals.
fn notes(plant: &Plant, functions: &Functions, threshold: f64) -> Vec<String> {
    let names: Vec<&str> = functions.unknowns.iter().map(|i| plant.unknowns[*i].label.name.as_str()).collect();
    let share = show(deadbeat_math::sqrt_f64(threshold));
    let mut notes = vec![
        format!("{}: exact while the last window excites them, that is, while more than {share} of what", List(&names)),
        "each shows is its own; else they keep their last values, and the status is `Converging`".into(),
    ];
    let lines = functions.lines.iter().flatten().any(|(k, _)| !plant.injections[*k].symbols().is_empty());
    if lines && !plant.discrete {
        notes.push("factors of outputs are straight lines between samples: second order in the sample time".into());
    }
    notes
}

/// What is known offline where factors depend on time alone; refused where no window excites.
fn excited(plant: &Plant, functions: &Functions, regression: &Regression) -> Result<Vec<String>, Vec<Diagnostic>> {
    let Some(found) = excitation(plant, functions, regression) else { return Ok(Vec::new()) };
    let name = |i: usize| &plant.unknowns[functions.unknowns[i]].label;
    let root = |share: f64| short(deadbeat_math::sqrt_f64(share));
    let until = trimmed(found.until);
    if found.exciting == 0 {
        let (weakest, singular) = found.weakest;
        let message =
            format!("no window tells the unknown `{}` apart from the state and the other unknowns", name(weakest).name);
        let label = format!(
            "{} of what it shows is its own; smallest singular value of the scaled Schur complement {}",
            root(found.share.1),
            if singular > 0.0 { format!("{singular:.1e}") } else { "0".into() }
        );
        let error = Diagnostic::error(codes::UNOBSERVABLE, name(weakest).span.clone(), message);
        let help = format!(
            "a longer window, another output, or a smaller `excitation` ({} windows until {until} s were tried)",
            found.windows
        );
        return Err(vec![error.label(label).measured(singular).help(help)]);
    }
    let names: Vec<&str> = found.unknowns.iter().map(|i| name(*i).name.as_str()).collect();
    let mut notes = vec![match found.first_failure {
        None => format!(
            "factors of time alone ({}): every one of {} windows until {until} s excites, by at least {}",
            List(&names),
            found.windows,
            root(found.share.0)
        ),
        Some(at) => format!(
            "factors of time alone ({}): {} of {} windows until {until} s excite; the first that does not ends at {} s",
            List(&names),
            found.exciting,
            found.windows,
            trimmed(at)
        ),
    }];
    for (o, output) in plant.outputs.iter().enumerate() {
        let Some(gains) = &found.gains else { continue };
        let list: Vec<String> = plant
            .states
            .iter()
            .zip(gains)
            .map(|(state, gain)| format!("{} {}", state.label.name, short(gain[o])))
            .collect();
        notes.push(format!("largest gain from noise of {} over these: {}", output.label.name, list.join(", ")));
    }
    Ok(notes)
}
