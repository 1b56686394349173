//! `[observer.prescribed-time]`: time-varying gains that make the estimate exact at a prescribed time.
//!
//! **Idea.** Gains that grow like 1/(T-t) make an error vanish at T whatever it was (004 Theorem 1; 003 Theorem 1).
//! In implicit Euler's form the gain of a sample lies between 0 and 1, at T itself is 1, and needs one division; M and
//! q take it to any observable plant with one output, predicted exactly.
//!
//! **Source.** 004 (holloway-krstic-2019-prescribed-time): (7), (12)-(23), Theorem 1; 003
//! (efimov-orlov-2024-implicit-euler): (4), (10)-(13), (21), Theorem 1; corrected and brought together by
//! prescribed-time-observers, sections 0, 2 and 3.
//!
//! **Conditions.** (C, A) observable with one output at the sample time, no delay, nonlinearities in measured states,
//! inputs and time only.

pub(super) mod filter;

use std::ops::Range;
use std::sync::Arc;

use super::countdown::{self, Countdown};
use super::window::{constants, refuse_unknowns, resolution_warnings, time_warning, verdict};
use super::{Keyed, Method, Moment, between, noise};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::corrector::chain::Chain;
use crate::estimator::corrector::design::{Built, Promise, Request, build};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::{self, After, Counting, interval, law};
use crate::numbers::{seconds, short, trimmed};
use crate::plant::Plant;
use crate::plant::features::{Feature, Limit, POSITIONS, holds};
use crate::promise::{Convergence, NamedMatrix};
use crate::real::{Matrix, Precision, Real};
use crate::sampled::model::{Model, signals};
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// Bits of what is reported of one step.
const REPORTED_BITS: usize = 512;

const LIMITS: &[Limit] = &[
    Limit::new(
        Feature::Every,
        "its countdown waits for a lost sample, and is then out of step with the calls at which the others are due",
        corrector::ONE_RATE,
    )
    .when("of several outputs", |case| holds(case.plant.outputs.len() > 1)),
    corrector::IN_BETWEEN,
    corrector::AGE,
    corrector::DELAY,
    corrector::ONE_OUTPUT
        .when("but with the law `kalman`", |case| holds(case.keys::<Keys>().filter.law_span().is_none())),
    corrector::LEFT_OUT,
    corrector::WINDOWS,
    POSITIONS,
];

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "prescribed-time",
    summary: "gains that grow until the prescribed time, by which the error is gone; n numbers of state",
    source: "Holloway and Krstic 2019, Theorem 1; Efimov and Orlov 2024, (10)-(13), (21); corrected, for any plant",
    keys: &[
        countdown::TIME,
        countdown::POLES,
        countdown::HOLLOWAY_KRSTIC,
        countdown::EFIMOV_ORLOV,
        filter::KALMAN,
        countdown::AFTER,
        countdown::STOP_BEFORE,
        countdown::MAX_GAIN,
        countdown::INITIAL,
        noise::KEYS[0],
        noise::KEYS[1],
        noise::KEYS[2],
    ],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: LIMITS,
    page: include_str!("prescribed-time.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    countdown: countdown::Keys,
    filter: filter::Keys,
    initial: Option<(Vec<Quantity>, Range<usize>)>,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let initial = table.list("initial");
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let countdown = countdown::read(table);
    let filter = filter::read(table);
    let (countdown, filter) = (countdown?, filter?);
    if let (Some(_), Some(span)) = (&countdown.law, filter.law_span()) {
        let error = Diagnostic::error(codes::BAD_COMBINATION, span, "an observer has one gain law");
        table.report(error.help("leave `kalman` or the other law out"));
        return None;
    }
    Some(Arc::new(Keys { countdown, filter, initial }))
}

/// Where the gains come from.
enum Gains {
    /// A law of the steps left.
    Countdown(Countdown),
    /// A Kalman filter.
    Table(filter::Law, Counting),
}

impl Gains {
    fn counting(&self) -> Counting {
        match self {
            Self::Countdown(countdown) => countdown.counting,
            Self::Table(_, counting) => *counting,
        }
    }

    fn filter(&self) -> Option<&filter::Law> {
        match self {
            Self::Countdown(_) => None,
            Self::Table(law, _) => Some(law),
        }
    }

    /// At one precision.
    fn law(&self, plant: &Plant, model: &Model, p: Precision) -> Result<Law, Vec<Diagnostic>> {
        match self {
            Self::Countdown(countdown) => {
                countdown.rows(plant, p).map(Law::Countdown).ok_or_else(|| countdown::no_value(plant))
            }
            Self::Table(law, counting) => law.gains(plant, model, p, counting.lead()).map(Law::Table),
        }
    }

    /// The promised call.
    fn promised(&self, order: usize) -> usize {
        match self {
            Self::Countdown(countdown) => promised(countdown.counting, order),
            Self::Table(_, counting) => counting.lead(),
        }
    }
}

impl Keyed for Keys {
    fn observed(&self, mut plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        countdown::start(&mut plant, self.initial.as_ref())?;
        Ok(plant)
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        between::refuse_rare(plant, &mut found);
        let gains = self.gains(plant, &mut found);
        let after = self.countdown.after.0;
        let noise = self.filter.steady(plant, after, gains.as_ref().and_then(Gains::filter), &mut found);
        let Some(gains) = gains.filter(|_| found.is_empty()) else { return Err(found) };
        let (counting, order) = (gains.counting(), plant.states.len());
        let condition = verdict(plant, &vec![0; plant.outputs.len()], order, &self.countdown.time.span())?;
        let condition = between::verdict(plant)?.unwrap_or(condition);
        let (signals, calls) = (signals(plant), interval::calls(plant));
        let model = |p: Precision| Model::new(plant, &signals, p);
        let handover = noise.as_ref().filter(|_| after == After::Handover);
        let law = |model: &Model, p: Precision| {
            let steady = handover.map(|noise| filter::handover(plant, noise, model, p)).transpose()?;
            Ok((gains.law(plant, model, p)?, steady))
        };
        let promise = Promise::At(calls * gains.promised(order));
        let request =
            Request { plant, signals: signals.clone(), counting, scaled: false, promise, model: &model, law: &law };
        let built = build(&request)?;
        filter::refuse_growth(plant, &built.exact, counting)?;
        let mut notes = gains.notes(plant);
        notes.extend(filter::notes(plant, &built, gains.filter(), noise.as_ref(), "the law `kalman`"));
        let Built { corrector, exact, schedule, certificate, mut numerics, convergence, remaining } = built;
        numerics.condition = condition;
        let mut warnings = Vec::new();
        if let Gains::Countdown(countdown) = &gains {
            let last = schedule.lead.last().into_iter().flatten().fold(0.0, |a: f64, x| a.max(x.abs()));
            warnings.extend(countdown.warnings(plant, &self.countdown, last));
        }
        warnings.extend(weak(plant, &self.countdown, remaining.share)?);
        warnings.extend(time_warning(plant));
        warnings.extend(resolution_warnings(plant));
        let mut all = constants(&exact.model);
        if let Some(chain) = &exact.chain {
            let named = |letter, matrix: &Matrix| NamedMatrix { letter, rows: without_rounding(matrix) };
            all.extend([named("M", &chain.m), named("q", &chain.q)]);
        }
        let valid = calls * corrector.valid;
        Ok(Design {
            method: METHOD.name,
            realization: "recursive",
            summary: gains.summary(plant),
            window_steps: calls * counting.steps,
            valid_from_step: valid,
            convergence: if gains.filter().is_none() && exactly(counting) { Convergence::Finite } else { convergence },
            realizations: Vec::new(),
            notes,
            constants: all,
            fir: None,
            certificate,
            numerics,
            warnings,
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(corrector),
        })
    }

    fn at(&self, plant: &Plant, step: usize) -> Result<Moment, String> {
        let no_value = || "a constant of the gain law has no usable value".to_owned();
        if self.filter.law_span().is_some() {
            return Err("the law `kalman` is a table from the first sample on, not one of the steps left".to_owned());
        }
        let countdown = Countdown::new(plant, &self.countdown, &mut Vec::new()).ok_or_else(no_value)?;
        let left = countdown.left_at(step)?;
        let precision = Precision::bits(REPORTED_BITS);
        let model = Model::new(plant, &[], precision).map_err(|_| no_value())?;
        let phi = interval::transition(plant, &model.phi);
        let chain = Chain::new(&phi, &model.c).map_err(|error| error.to_string())?;
        let rows = countdown.rows(plant, precision).ok_or_else(no_value)?;
        let gain = &(&chain.m * &law::exact_kappa(&rows, left)) + &chain.q;
        let transition = &(&Matrix::identity(countdown.order, precision) - &(&gain * &model.c)) * &phi;
        let matrices = vec![
            NamedMatrix { letter: "K", rows: without_rounding(&gain) },
            NamedMatrix { letter: "transition", rows: without_rounding(&transition) },
        ];
        Ok(Moment { step, left, in_use: left >= countdown.counting.stop, matrices })
    }
}

impl Keys {
    /// The gains with their numbers; mistakes are collected.
    fn gains(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Gains> {
        if self.filter.law_span().is_none() {
            return Countdown::new(plant, &self.countdown, found).map(Gains::Countdown);
        }
        let law = self.filter.law(plant, found);
        let counting = countdown::of_table(plant, &self.countdown, found)?;
        filter::check(plant, &self.filter, counting, &self.countdown.after.1, found);
        Some(Gains::Table(law?, counting))
    }
}

impl Gains {
    fn summary(&self, plant: &Plant) -> String {
        let Self::Table(_, counting) = self else { return summary(plant, self.counting()) };
        let time = trimmed(seconds(counting.lead(), interval::seconds(plant)));
        let then = if counting.after == After::Hold { "the last gain stays" } else { "the steady gain" };
        format!(
            "a Kalman filter from the first sample on, {time} s ({}) by a table, then {then}",
            between::counted(plant, counting.lead())
        )
    }

    fn notes(&self, plant: &Plant) -> Vec<String> {
        match self {
            Self::Countdown(countdown) => notes(plant, countdown),
            Self::Table(..) => Vec::new(),
        }
    }
}

/// The sample of the promised call: the countdown's end; where it holds the deadbeat gain, n samples of it.
pub fn promised(counting: Counting, order: usize) -> usize {
    if exactly(counting) { counting.steps + order - 1 } else { counting.lead() }
}

/// Whether the deadbeat gain is held.
pub fn exactly(counting: Counting) -> bool {
    counting.stop == 0 && counting.after == After::Hold
}

/// What happens when, in one line.
pub fn summary(plant: &Plant, counting: Counting) -> String {
    let Counting { steps, stop, after } = counting;
    let then = match after {
        After::Hold => "then the last gain stays".to_owned(),
        After::Restart => format!("then again from {steps}"),
        After::Handover => "then a steady Kalman gain".to_owned(),
    };
    let time = trimmed(seconds(steps, interval::seconds(plant)));
    let counted = between::counted(plant, steps);
    format!("gains for T = {time} s ({counted}), counted down to {stop} before it; {then}")
}

/// What the method's own theory says.
pub fn notes(plant: &Plant, countdown: &Countdown) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(margin) = countdown.margin(plant) {
        let least = countdown.order - 1;
        notes.push(format!("scaled errors fall like (T-t)^{} (above {least} is needed)", short(margin)));
    }
    notes
}

/// Says that much of the initial error is still there when the countdown ends, or refuses where all of it is.
///
/// # Errors
/// Gains with which the error has grown.
pub fn weak(plant: &Plant, keys: &countdown::Keys, left: f64) -> Result<Option<Diagnostic>, Vec<Diagnostic>> {
    if left <= 1e-2 {
        return Ok(None);
    }
    let span = keys.stop_before.as_ref().map_or_else(|| plant.span.clone(), |(_, span)| span.clone());
    let help = "a smaller `stop_before`, a longer `time`, or larger gains: a larger p, m or L";
    let said = |diagnostic: Diagnostic| {
        diagnostic.label(format!("{} of the worst one", short(left))).measured(left).help(help)
    };
    if left < 1.0 {
        let message = "much of the initial error is left when the countdown ends";
        return Ok(Some(said(Diagnostic::warning(codes::WEAK, span, message))));
    }
    Err(vec![said(Diagnostic::error(codes::WEAK, span, "more than the initial error is left when the countdown ends"))])
}

/// In doubles; what half of the digits do not show is an exact zero that was rounded.
fn without_rounding(matrix: &Matrix) -> Vec<Vec<f64>> {
    let half = i64::try_from(REPORTED_BITS / 2).unwrap_or(i64::MAX);
    let least = matrix.max_abs().shifted(-half);
    matrix.map(|x| if x.cmp_abs(&least).is_lt() { Real::zero(x.precision()) } else { x.clone() }).to_f64()
}
