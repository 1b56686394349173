//! From a law to a settled corrector with its certificate: what every method of this shape does.

use super::errors::{Errors, Remaining, until};
use super::exact::{Exact, Law};
use super::rounding::Rounding;
use super::schedule::Schedule;
use super::settle::settle;
use super::{Corrector, Counting, interval};
use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::promise::{CONTRACTED, Certificate, Convergence};
use crate::real::{Matrix, Precision};
use crate::sampled::Signal;
use crate::sampled::model::Model;
use crate::sampled::settle::Numerics;

/// When the estimate counts as converged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Promise {
    /// At this call from the first sample on; with one output, a call of a sample.
    At(usize),
    /// When [`CONTRACTED`] of the initial error is left.
    Contracted,
}

/// A law, and the gain after a handover; or why there is none.
pub type Lawful = Result<(Law, Option<Matrix>), Vec<Diagnostic>>;

/// What a method asks for.
pub struct Request<'a> {
    /// The plant.
    pub plant: &'a Plant,
    /// What is known besides the outputs.
    pub signals: Vec<Signal>,
    /// The countdown.
    pub counting: Counting,
    /// Whether the step carries the chain's scaled coordinates.
    pub scaled: bool,
    /// When it has converged.
    pub promise: Promise,
    /// The sampled plant at one precision, where it is not the exact one.
    pub model: &'a dyn Fn(Precision) -> Result<Model, Vec<Diagnostic>>,
    /// The law, and the gain after a handover, at one precision.
    pub law: &'a dyn Fn(&Model, Precision) -> Lawful,
}

/// What comes of it.
pub struct Built {
    /// Settled.
    pub corrector: Corrector,
    /// At the last precision.
    pub exact: Exact,
    /// K of every call.
    pub schedule: Schedule,
    /// From the promised call on.
    pub certificate: Certificate,
    /// How the arithmetic went.
    pub numerics: Numerics,
    /// How it comes to its bound.
    pub convergence: Convergence,
    /// What is left of an initial error at the promised call.
    pub remaining: Remaining,
}

/// The longest a convergence may take, in calls: what a step counts.
const MOST_CALLS: usize = 1 << 31;

/// Designs, rounds and certifies.
///
/// # Errors
/// What the model and the law report, and constants that do not settle; a gain whose error does not die out.
pub fn build(request: &Request) -> Result<Built, Vec<Diagnostic>> {
    let (plant, counting) = (request.plant, request.counting);
    let run = |p: Precision| {
        let model = (request.model)(p)?;
        let law = (request.law)(&model, p)?;
        Exact::new(plant, model, law, request.scaled, p)
    };
    let (mut corrector, exact, numerics) = settle(plant, &request.signals, counting, &run)?;
    let valid = match request.promise {
        Promise::At(call) => call,
        Promise::Contracted => contracted(plant, &exact, counting)?,
    };
    corrector.valid = valid / interval::calls(plant);
    let schedule = Schedule::new(plant, &exact, counting, valid);
    let errors = Errors::new(plant, &request.signals, &exact, &schedule, valid).ok_or_else(|| unobservable(plant))?;
    let remaining = errors.remaining(valid);
    let worst = errors.worst(valid);
    let mut certificate = errors.certify(&worst, &remaining);
    if let Some(rounding) = Rounding::new(plant, &corrector, &errors, &worst, &certificate.error_bound) {
        (certificate.rounding, corrector.twofold) = (rounding.bound, rounding.twofold);
    }
    corrector.recovery = errors.recovery(valid, remaining.share);
    let convergence = match request.promise {
        Promise::At(_) => Convergence::Prescribed { left: remaining.share },
        Promise::Contracted => Convergence::Geometric { radius: errors.radius(), period: schedule.cycle.len() },
    };
    Ok(Built { corrector, exact, schedule, certificate, numerics, convergence, remaining })
}

/// Rounds of the search for the call, each over the calls that the one before found.
const ROUNDS: usize = 8;

/// The first call from which on little enough of the initial error is left: in the size that is taken over as many calls,
/// so that it is found by rounds.
fn contracted(plant: &Plant, exact: &Exact, counting: Counting) -> Result<usize, Vec<Diagnostic>> {
    let schedule = Schedule::new(plant, exact, counting, 0);
    let mut valid = 0;
    for round in 0..=ROUNDS {
        let found = until(plant, exact, &schedule, valid, CONTRACTED).ok_or_else(|| unobservable(plant))?;
        let found = found.map_err(|radius| vec![stays(plant, &schedule, radius)])?;
        if found > MOST_CALLS {
            return Err(vec![outlasts(plant, found)]);
        }
        // What is enough in the size over `valid` calls is promised only where these are as many.
        if found == valid || round == ROUNDS {
            valid = found.max(valid);
            break;
        }
        valid = found;
    }
    Ok(valid.next_multiple_of(interval::calls(plant)))
}

fn stays(plant: &Plant, schedule: &Schedule, radius: f64) -> Diagnostic {
    let label = format!("{} {} of it in the long run", leaves(schedule), crate::numbers::factor(radius));
    grows(plant, "the estimation error does not die out", radius).label(label)
}

fn outlasts(plant: &Plant, calls: usize) -> Diagnostic {
    let message = "the estimation error dies out later than a step can count";
    let lasts = crate::numbers::seconds(calls, plant.sample_time_s());
    let label = format!("after {calls} calls, {} s; at most {MOST_CALLS}", crate::numbers::short(lasts));
    grows(plant, message, crate::numbers::count(calls)).label(label)
}

/// What makes the map whose radius is shown.
fn leaves(schedule: &Schedule) -> String {
    match schedule.cycle.len() {
        1 => "a call leaves".to_owned(),
        calls => format!("{calls} calls leave"),
    }
}

fn grows(plant: &Plant, message: &str, radius: f64) -> Diagnostic {
    let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message).measured(radius);
    error.help("a larger gain, faster poles, or process noise on the slow states")
}

fn unobservable(plant: &Plant) -> Vec<Diagnostic> {
    let message = "the outputs do not show every state";
    vec![Diagnostic::error(codes::UNOBSERVABLE, plant.span.clone(), message).help("measure more of the plant")]
}

/// Why a plant has no M and q.
pub fn no_chain(plant: &Plant, why: &str) -> Vec<Diagnostic> {
    let message = "the sampled plant cannot be run backwards, or its output does not show every state";
    let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message).label(why.to_owned());
    vec![error.help("leave states that vanish within a sample out of the model, or use the method `window`")]
}
