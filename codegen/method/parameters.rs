//! `[observer.parameters]`: the state and unknown constants together, from the last `window` seconds.
//!
//! **Idea.** `x' = A x + ... + sum_i eps_i gamma_i` with unknown constants eps_i. The samples of a window are
//! linear equations in the state at its start and in the eps_i; solved together by least squares they
//! give both, exactly, after N+1 samples.
//!
//! **Source.** 002 (mazenc-malisoff-2022-parameters-and-states), Theorems 1, 2 and 3, which find the eps_i
//! in a second stage from the state's first; `form = "joint"` is one stage (window-observers, section 2:
//! one Gramian of the plant and its exosystem contains everything, kappa is minus its off-diagonal
//! block), needs no Assumption 2, takes any number of outputs and unknowns and half the time.
//!
//! **Conditions.** (A, C) observable; the Schur complement of the joint Gramian not singular
//! (`parameters/identifiable.rs`).

use std::sync::Arc;

use super::window::{constants, delays, fir, refuse_long_delays, resolution_warnings, steps, time_warning, verdict};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::describe::short;
use crate::design::{Certificate, Convergence, Design, Shape};
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::List;
use crate::parameters::augment::{augmented, varying, without};
use crate::parameters::functions::{Functions, with_functions};
use crate::parameters::identifiable;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::regression::exact::Problem;
use crate::regression::excitation::excitation;
use crate::regression::{MOST, Regression};
use crate::spec::Quantity;
use crate::spec::reader::Table;
use crate::window::certificate::certify;
use crate::window::model::signals;
use crate::window::settle::settle;
use crate::window::solve::Choice;
use crate::window::{count, refuse_much_work, seconds, trimmed};

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "parameters",
    summary: "the state and unknown constants together, over the last N+1 samples",
    source: "Mazenc and Malisoff 2022 (parameters and states), Theorems 1, 2, 3, made exact for samples",
    keys: &[
        ("window", "s", "length of the window, a whole number of samples; the estimate has converged after it"),
        (
            "excitation",
            "number",
            "share of an unknown's effect that the state must not explain; 1e-3 in f32, 1e-6 in f64 (varying factors)",
        ),
        ("realization", "\"auto\" | \"fir\"", "how the step computes it"),
    ],
    realizations: &[
        ("fir", "one weighted sum over the stored samples; no state that can drift (constant factors)"),
        ("regression", "responses and equations over the stored samples in every call (varying factors)"),
    ],
    page: include_str!("parameters.md"),
    read,
};

/// The default of `excitation` in single precision: responses are right to about 1e-6, the unknowns then to 1e-3.
const SINGLE: f64 = 1e-3;
/// And in double precision: 1e-15 and 1e-9.
const DOUBLE: f64 = 1e-6;

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    window: Quantity,
    excitation: Option<Quantity>,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let window = table.quantity("window");
    if window.is_none() && !table.has("window") {
        table.missing(
            "window",
            "write `window = …`, the length in seconds; the deadline by which the estimate is exact",
        );
    }
    let excitation = table.quantity("excitation");
    table.choice("realization", &[("auto", ()), ("fir", ())], ());
    Some(Arc::new(Keys { window: window?, excitation }))
}

/// A window that fits the plant.
struct Frame {
    steps: usize,
    delays: Vec<usize>,
    condition: f64,
}

impl Keyed for Keys {
    fn observed(&self, plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        if plant.unknowns.is_empty() {
            let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), "there is no unknown to estimate");
            return Err(vec![error.help("declare it under [unknowns], or use the method `window`")]);
        }
        with_functions(augmented(plant))
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let frame = self.frame(plant)?;
        if varying(plant).is_empty() { functional(plant, &frame) } else { self.regression(plant, frame) }
    }
}

impl Keys {
    /// Refuses windows that are none, states that are not seen, unknowns that are not told apart.
    fn frame(&self, plant: &Plant) -> Result<Frame, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let steps = steps(&self.window, plant, &mut found);
        let delays = delays(plant, &mut found);
        let (Some(steps), Some(delays)) = (steps, delays) else { return Err(found) };
        let span = self.window.span();
        refuse_long_delays(plant, &delays, steps, &span, &mut found);
        refuse_much_work(plant, steps, &span, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let every: Vec<usize> = (0..plant.unknowns.len()).collect();
        verdict(&without(plant, &every), &delays, steps, &span)?;
        let base = without(plant, &varying(plant));
        identifiable::check(&base, &delays)?;
        let condition = verdict(&base, &delays, steps, &span)?;
        Ok(Frame { steps, delays, condition })
    }

    /// The smallest share of an unknown's energy that the state must leave unexplained.
    fn threshold(&self, plant: &Plant) -> Result<f64, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let Some(key) = &self.excitation else {
            return Ok(match plant.scalar {
                Scalar::F32 => SINGLE * SINGLE,
                Scalar::F64 => DOUBLE * DOUBLE,
            });
        };
        let value = plant.constant(key, &mut found).and_then(|value| value.to_f64().ok()).unwrap_or(f64::NAN);
        if found.is_empty() && !(value > 0.0 && value < 1.0) {
            let message = format!("`excitation` must be between 0 and 1, not {}", show(value));
            let error = Diagnostic::error(codes::BAD_NUMBER, key.span(), message).measured(value);
            found.push(error.help("write the smallest share of an unknown's effect that counts, such as 1e-3"));
        }
        if found.is_empty() { Ok(value * value) } else { Err(found) }
    }

    /// Unknowns whose gammas vary.
    fn regression(&self, plant: &Plant, frame: Frame) -> Result<Design, Vec<Diagnostic>> {
        refuse_many(plant)?;
        let (signals, steps) = (signals(plant), frame.steps);
        let functions = Functions::of(plant);
        let threshold = self.threshold(plant)?;
        let problem = Problem { plant, functions, signals: &signals, delays: &frame.delays, steps, threshold };
        let (regression, exact, mut numerics) = problem.settle()?;
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
            shape: Shape::Regression(Box::new(regression)),
        })
    }
}

/// Unknowns whose gammas are constant: a functional with constant weights.
fn functional(plant: &Plant, frame: &Frame) -> Result<Design, Vec<Diagnostic>> {
    let steps = frame.steps;
    let settled = settle(plant, &signals(plant), &frame.delays, steps, &Choice::LeastSquares)?;
    let (functional, exact, mut numerics) = settled;
    numerics.condition = frame.condition;
    let certificate = certify(plant, &functional, &exact);
    Ok(Design {
        method: METHOD.name,
        realization: "fir",
        summary: summary(plant, steps),
        window_steps: steps,
        valid_from_step: steps,
        convergence: Convergence::Finite,
        realizations: Vec::new(),
        notes: Vec::new(),
        constants: constants(&exact.model),
        fir: Some(fir(plant, &functional)),
        certificate,
        numerics,
        warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
        shape: Shape::Window(functional),
    })
}

fn refuse_many(plant: &Plant) -> Result<(), Vec<Diagnostic>> {
    let varying = varying(plant);
    let Some(first) = varying.get(MOST) else { return Ok(()) };
    let message = format!("{} unknowns have factors that vary; at most {MOST} are estimated", varying.len());
    let error = Diagnostic::error(codes::METHOD_CANNOT, plant.unknowns[*first].label.span.clone(), message);
    Err(vec![error.measured(count(varying.len())).help("fewer unknowns")])
}

/// What is promised while the gain depends on the signals.
fn notes(plant: &Plant, functions: &Functions, threshold: f64) -> Vec<String> {
    let names: Vec<&str> = functions.unknowns.iter().map(|i| plant.unknowns[*i].label.name.as_str()).collect();
    let mut notes = vec![
        format!(
            "{} with factors that vary: exact where the last window excites them, that is where more than",
            List(&names)
        ),
        format!(
            "{} of what each shows is not explained by the state and the others; elsewhere they keep",
            short(deadbeat_math::sqrt_f64(threshold))
        ),
        "their last values, and the status is `Converging`".into(),
    ];
    let lines = functions.lines.iter().flatten().any(|(k, _)| !plant.injections[*k].symbols().is_empty());
    if lines && !plant.discrete {
        notes.push(
            "factors that depend on outputs are straight lines between samples: second order in the sample time".into(),
        );
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
            "{} of what it shows is its own; smallest singular value of the scaled Schur complement {singular:.1e}",
            root(found.share.1)
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
            "{} of time alone: every one of {} windows until {until} s excites, by at least {}",
            List(&names),
            found.windows,
            root(found.share.0)
        ),
        Some(at) => format!(
            "{} of time alone: {} of {} windows until {until} s excite; the first that does not ends at {} s",
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

fn summary(plant: &Plant, steps: usize) -> String {
    let h = plant.sample_time_s();
    format!(
        "joint least squares for states and unknowns over the last {} samples ({} s at {h} s), stateless",
        steps + 1,
        trimmed(seconds(steps, h))
    )
}
