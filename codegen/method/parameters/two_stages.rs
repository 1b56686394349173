//! `form = "paper"`: 002's two stages, for one output.
//!
//! Theorem 1 without delay, Theorem 2 with one, Theorem 3 in discrete time. With one unknown of constant
//! factor W and rho are constants, and the two stages a functional with constant weights
//! ([`crate::sampled::unknowns::stages`]). With factors of time, Assumption 2 asks `det M(t)` never to vanish;
//! it is looked at, and the joint form, which does not need it, is named.

use std::ops::Range;

use super::super::window::{VERDICT_BITS, delays, verdict, window_steps};
use super::determinant::{continuous, vanishing};
use super::{Frame, functional};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::window::realize::Wanted;
use crate::estimator::window::settle::settle;
use crate::estimator::window::solve::Choice;
use crate::expr::Symbol;
use crate::numbers::{count, seconds, trimmed};
use crate::plant::Plant;
use crate::promise::NamedMatrix;
use crate::real::{Precision, Real, inverse};
use crate::sampled::model::{Model, signals};
use crate::sampled::samples::{refuse_much_work, whole_samples};
use crate::sampled::unknowns::augment::{varying, without};
use crate::sampled::unknowns::identifiable;
use crate::sampled::unknowns::paper::Exosystem;
use crate::sampled::unknowns::stages::{Stages, Theorem};
use crate::spec::Quantity;

/// The keys of the second stage.
#[derive(Clone, Debug)]
pub(super) struct Paper {
    pub(super) integration: Option<Quantity>,
    pub(super) shifts: Option<(Vec<Quantity>, Range<usize>)>,
}

const JOINT: &str = "leave `form` out: the joint form takes this";

/// Designs the two stages.
pub(super) fn design(
    plant: &Plant,
    window: &Quantity,
    paper: &Paper,
    wanted: &(Wanted, Range<usize>),
) -> Result<Design, Vec<Diagnostic>> {
    refuse_sizes(plant)?;
    let (stages, shifts) = lengths(plant, window, paper)?;
    refuse_factors(plant, &stages, &shifts)?;
    let span = window.span();
    let total = stages.steps();
    let mut found = Vec::new();
    refuse_much_work(plant, total, &span, &mut found);
    if !found.is_empty() {
        return Err(found);
    }
    let delays = vec![stages.delay];
    let every: Vec<usize> = (0..plant.unknowns.len()).collect();
    let first = if stages.theorem == Theorem::Three { stages.window - 1 } else { stages.window + stages.delay };
    verdict(&without(plant, &every), &delays, first, &span)?;
    identifiable::check(plant, &delays)?;
    let condition = verdict(plant, &delays, total, &span)?;
    let model = Model::new(plant, &[], Precision::bits(VERDICT_BITS))?;
    refuse_stages(plant, &stages, &model, &span)?;
    let settled = settle(plant, &signals(plant), &delays, total, &Choice::Stages(stages))?;
    let letters = letters(plant, &stages, &model);
    let frame = Frame { steps: total, delays, condition };
    let form = Err("the paper's two stages follow no recursion");
    functional(plant, &frame, settled, (form, wanted), (summary(plant, &stages), letters))
}

fn cannot(plant: &Plant, message: &str, span: Option<Range<usize>>) -> Vec<Diagnostic> {
    let span = span.unwrap_or_else(|| plant.span.clone());
    vec![Diagnostic::error(codes::METHOD_CANNOT, span, message).help(JOINT)]
}

/// The paper's third theorem is for one unknown.
fn refuse_sizes(plant: &Plant) -> Result<(), Vec<Diagnostic>> {
    let second = plant.unknowns.get(1).filter(|_| plant.discrete);
    second.map_or(Ok(()), |second| {
        Err(cannot(plant, "Theorem 3, for discrete plants, takes one unknown", Some(second.label.span.clone())))
    })
}

/// tau, T, `tau_i` and h in samples.
fn lengths(plant: &Plant, window: &Quantity, paper: &Paper) -> Result<(Stages, Vec<usize>), Vec<Diagnostic>> {
    let mut found = Vec::new();
    let tau = window_steps(plant, window, &mut found);
    let delay = delays(plant, &mut found).map(|delays| delays[0]);
    let integration = match &paper.integration {
        None => tau,
        Some(key) => samples(plant, key, "the integration window", &mut found),
    };
    if let (Some(0), Some(key)) = (integration, &paper.integration) {
        let error = Diagnostic::error(codes::BAD_NUMBER, key.span(), "the integration window must be longer than 0 s");
        found.push(error.help("write T in seconds, or leave it out"));
    }
    let shifts = shifts(plant, paper, &mut found);
    let theorem = match delay {
        _ if plant.discrete => Theorem::Three,
        Some(1..) => Theorem::Two,
        _ => Theorem::One,
    };
    if let (Some((_, span)), Theorem::Two | Theorem::Three) = (&paper.shifts, theorem) {
        let message = "`shifts` belong to Theorem 1: continuous time without delay";
        found.push(Diagnostic::error(codes::BAD_COMBINATION, span.clone(), message).help("leave them out"));
    }
    match (tau, integration, delay, shifts) {
        (Some(window), Some(integration), Some(delay), Some(shifts)) if found.is_empty() => {
            Ok((Stages { theorem, window, integration, shift: shifts[0], delay }, shifts))
        }
        _ => Err(found),
    }
}

fn samples(plant: &Plant, key: &Quantity, what: &str, found: &mut Vec<Diagnostic>) -> Option<usize> {
    let value = plant.constant(key, found)?;
    whole_samples(&value, &key.span(), what, plant, found)
}

/// `0 <= tau_1 < tau_2 < ...`, one per unknown.
fn shifts(plant: &Plant, paper: &Paper, found: &mut Vec<Diagnostic>) -> Option<Vec<usize>> {
    let q = plant.unknowns.len();
    let Some((keys, span)) = &paper.shifts else {
        if q == 1 {
            return Some(vec![0]);
        }
        let message = format!("{q} unknowns need {q} shifts");
        found.push(Diagnostic::error(codes::MISSING_KEY, plant.span.clone(), message).help(JOINT));
        return None;
    };
    let shifts: Vec<Option<usize>> = keys.iter().map(|key| samples(plant, key, "a shift", found)).collect();
    let shifts: Vec<usize> = shifts.into_iter().collect::<Option<_>>()?;
    if shifts.len() == q && shifts.is_sorted_by(|a, b| a < b) {
        return Some(shifts);
    }
    let error = Diagnostic::error(codes::SHAPE, span.clone(), "`shifts` must be one rising time per unknown");
    found.push(error.label(format!("{} shifts, {q} unknowns", shifts.len())).help("write `shifts = [0, …]`"));
    None
}

/// Factors that vary are refused: those of outputs and inputs at once, those of time with what is known of det M.
fn refuse_factors(plant: &Plant, stages: &Stages, shifts: &[usize]) -> Result<(), Vec<Diagnostic>> {
    let varying = varying(plant);
    let timed =
        |i: &usize| plant.unknowns[*i].gamma.iter().flat_map(crate::expr::Poly::symbols).all(|s| s == Symbol::Time);
    if let Some(other) = varying.iter().find(|i| !timed(i)) {
        let label = &plant.unknowns[*other].label;
        let message =
            format!("the factor of `{}` depends on more than time; 002's gammas are functions of time", label.name);
        return Err(cannot(plant, &message, Some(label.span.clone())));
    }
    let Some(first) = varying.first() else { return Ok(()) };
    let label = &plant.unknowns[*first].label;
    if let Some(at) = vanishing(plant, stages, shifts) {
        let message = "det M(t) vanishes: Assumption 2 does not hold";
        let error = Diagnostic::error(codes::METHOD_CANNOT, label.span.clone(), message);
        return Err(vec![
            error.label(format!("it changes its sign at t = {} s", trimmed(at))).measured(at).help(JOINT),
        ]);
    }
    let message =
        format!("the two stages are designed for constant factors; that of `{}` varies with time", label.name);
    Err(cannot(plant, &message, Some(label.span.clone())))
}

/// Refuses stages that cannot be computed, or of which the second does not see the unknown.
fn refuse_stages(plant: &Plant, stages: &Stages, model: &Model, window: &Range<usize>) -> Result<(), Vec<Diagnostic>> {
    let n = model.phi.rows() - 1;
    if inverse(&model.phi.block(0..n, 0..n)).is_err() {
        return Err(cannot(plant, "002's Assumption 4: A must have an inverse, and this one has none", None));
    }
    let Ok(first) = stages.first(model) else {
        let error =
            Diagnostic::error(codes::WINDOW_TOO_SHORT, window.clone(), "the window is too short to show every state");
        return Err(vec![error.help(format!("at least {n} samples"))]);
    };
    let divisor = stages.divisor(model, &first);
    let scale = (&model.c.block(0..1, 0..n).max_abs() * &first.share.max_abs()).max(Real::zero(divisor.precision()));
    // Half of the digits are far from rounding.
    if divisor.is_zero() || divisor.log2_abs() < scale.log2_abs() - count(VERDICT_BITS / 2) {
        let what = if stages.theorem == Theorem::One { "W is 0: Assumption 2" } else { "rho is 0: Assumption 3" };
        return Err(cannot(plant, &format!("the second stage does not see the unknown: {what} does not hold"), None));
    }
    Ok(())
}

/// The constants under the paper's letters.
fn letters(plant: &Plant, stages: &Stages, model: &Model) -> Vec<NamedMatrix> {
    let named = |letter: &'static str, matrix: &crate::real::Matrix| NamedMatrix { letter, rows: matrix.to_f64() };
    let mut letters = vec![named("Phi", &model.phi), named("C", &model.c)];
    if stages.theorem == Theorem::Three {
        let Ok(first) = stages.first(model) else { return letters };
        letters.extend([named("F", &first.gramian), named("M", &first.kappa)]);
        letters.push(NamedMatrix { letter: "beta", rows: vec![vec![stages.divisor(model, &first).to_f64()]] });
        return letters;
    }
    let constants = Exosystem::of(&plant.unknowns[0]).and_then(|exosystem| continuous(plant, &exosystem, stages));
    let Some(constants) = constants else { return letters };
    letters.extend([named("E", &constants.e), named("Einv", &constants.e_inverse)]);
    letters.extend([named("kappa", &constants.kappa), named("W", &constants.w)]);
    if stages.theorem == Theorem::Two {
        letters.extend([named("E_h", &constants.e_h), named("theta", &constants.theta)]);
    }
    letters
}

fn summary(plant: &Plant, stages: &Stages) -> String {
    let h = plant.sample_time_s();
    let time = |samples: usize| trimmed(seconds(samples, h));
    let theorem = match stages.theorem {
        Theorem::One => "Theorem 1",
        Theorem::Two => "Theorem 2",
        Theorem::Three => "Theorem 3",
    };
    format!(
        "two stages ({theorem}): the state over {} s, the unknown over {} s, made exact for samples of {h} s; stateless",
        time(stages.window),
        time(stages.integration)
    )
}
