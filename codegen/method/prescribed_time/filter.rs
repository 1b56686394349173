//! The Kalman filter within `prescribed-time`: as the law `kalman`, a table of gains from the first sample on; as what
//! a countdown hands over to; and as what every other law is compared with.

use std::ops::Range;

use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::design::Built;
use crate::estimator::corrector::deviation::{Deviations, Noisy};
use crate::estimator::corrector::exact::Exact;
use crate::estimator::corrector::riccati::{Noise, closed_loop, contracts, first_covariance, steady, transient};
use crate::estimator::corrector::schedule::Schedule;
use crate::estimator::corrector::{After, Counting, interval};
use crate::expr::Constant;
use crate::method::noise;
use crate::numbers::{count, short};
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real};
use crate::sampled::model::Model;
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The law's row of the keys' table.
pub(super) const KALMAN: (&str, &str, &str) = (
    "kalman",
    "{ initial_deviation, … }",
    "a Kalman filter from the first sample on, a table of gains; with `process_noise`, `measurement_noise`, `density` of its own",
);

/// Numbers of a table that is written out, at most.
const MOST_NUMBERS: usize = 65_536;
/// Multiplications in multiprecision that a comparison may take.
const MOST_WORK: usize = 2_000_000;
/// Bits for the comparison.
const BITS: usize = 192;
/// An initial error that is as good as unknown, in standard deviations of the steady filter.
const UNKNOWN: i64 = 1_000_000;
/// A table is better where it leaves less than this of a deviation.
const BETTER: f64 = 0.9;

/// The keys.
#[derive(Clone, Debug)]
pub(super) struct Keys {
    /// Of the law, with its place.
    law: Option<(Written, Range<usize>)>,
    /// Of the handover and the comparison.
    steady: noise::Keys,
}

/// The law as written.
#[derive(Clone, Debug)]
struct Written {
    noise: noise::Keys,
    deviation: Vec<Quantity>,
    /// Whether it is one number for all states.
    single: bool,
    place: Range<usize>,
}

/// Reads the keys; `None` where the law's table has a mistake.
pub(super) fn read(table: &mut Table) -> Option<Keys> {
    let steady = noise::read(table);
    let Some(mut keys) = table.table("kalman", "`kalman`") else {
        return (!table.has("kalman")).then_some(Keys { law: None, steady });
    };
    let noise = noise::read(&mut keys);
    let place = keys.key_span("initial_deviation");
    let help =
        "write `initial_deviation = …`, how far `initial` may be off: a number, or one per state; large is forgotten";
    if !keys.has("initial_deviation") {
        keys.missing("initial_deviation", help);
    }
    let single = !keys.has_list("initial_deviation");
    let deviation = if single {
        keys.quantity("initial_deviation").map(|one| vec![one])
    } else {
        keys.list("initial_deviation").map(|(list, _)| list)
    };
    keys.finish();
    let written = Written { noise, deviation: deviation?, single, place };
    Some(Keys { law: Some((written, table.key_span("kalman"))), steady })
}

impl Keys {
    /// Of the law `kalman`, if it is the one.
    pub(super) fn law_span(&self) -> Option<Range<usize>> {
        self.law.as_ref().map(|(_, span)| span.clone())
    }

    /// The law with its numbers; mistakes are collected.
    pub(super) fn law(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Law> {
        let (written, _) = self.law.as_ref()?;
        let noise = written.noise.check(plant, found);
        let (given, states) = (written.deviation.len(), plant.states.len());
        if !written.single && given != states {
            let message = "`initial_deviation` must be a number, or one per state";
            let error = Diagnostic::error(codes::SHAPE, written.place.clone(), message).measured(count(given));
            found.push(
                error.label(format!("{given} for {states} states")).help("those of measured states are not read"),
            );
            return None;
        }
        let values: Option<Vec<Constant>> = written.deviation.iter().map(|q| plant.constant(q, found)).collect();
        let mut values = values?;
        for (value, quantity) in values.iter().zip(&written.deviation) {
            let number = value.to_f64().unwrap_or(f64::NAN);
            if number <= 0.0 {
                let message = "`initial_deviation` must be above 0";
                let error = Diagnostic::error(codes::BAD_NUMBER, quantity.span(), message).measured(number);
                found
                    .push(error.help("how far `initial` may be off: a filter that is certain of it never corrects it"));
                return None;
            }
        }
        if written.single {
            values = vec![values[0].clone(); states];
        }
        Some(Law { noise: noise?, deviations: values })
    }

    /// The noise of the handover and the comparison: must be there for a handover, may be for the comparison.
    pub(super) fn steady(
        &self,
        plant: &Plant,
        after: After,
        law: Option<&Law>,
        found: &mut Vec<Diagnostic>,
    ) -> Option<noise::Model> {
        if let (Some(_), Some(span), false) = (law, self.steady.place(), after == After::Handover) {
            let message = "beside the braces of `kalman` the noise is of a handover, and there is none";
            let error = Diagnostic::error(codes::BAD_COMBINATION, span, message);
            found.push(error.help("write it within the braces, or `after = \"handover\"`"));
        }
        match law {
            Some(law) if !self.steady.given() => Some(law.noise.clone()),
            _ if self.steady.given() || after == After::Handover => self.steady.check(plant, found),
            _ => self.steady.check(plant, &mut Vec::new()),
        }
    }
}

/// The law `kalman`.
#[derive(Clone, Debug)]
pub(crate) struct Law {
    noise: noise::Model,
    /// Per state.
    deviations: Vec<Constant>,
}

impl Law {
    /// K of samples 1, 2, …, at one precision.
    pub(super) fn gains(
        &self,
        plant: &Plant,
        model: &Model,
        p: Precision,
        samples: usize,
    ) -> Result<Vec<Matrix>, Vec<Diagnostic>> {
        let noise = self.noise.at(plant, p)?;
        let start = self.start(plant, &noise, p);
        let noise = interval::noise(plant, &model.phi, noise);
        let phi = interval::transition(plant, &model.phi);
        transient(&phi, &model.c, &noise, &start, samples).map_err(|failure| self.noise.said(plant, failure))
    }

    fn start(&self, plant: &Plant, noise: &Noise, p: Precision) -> Matrix {
        let deviations: Vec<Real> =
            self.deviations.iter().map(|d| d.evaluate(p).unwrap_or_else(|_| Real::zero(p))).collect();
        first_covariance(&readout(plant, p), &deviations, noise)
    }
}

/// The weights of the first sample in the measured states, n x p.
fn readout(plant: &Plant, p: Precision) -> Matrix {
    let weight = |i: usize, o: usize| plant.states[i].measured.iter().find(|(output, _)| *output == o);
    Matrix::from_fn(plant.states.len(), plant.outputs.len(), |i, o| {
        weight(i, o).and_then(|(_, weight)| weight.evaluate(p).ok()).unwrap_or_else(|| Real::zero(p))
    })
}

/// The steady gain of a handover.
pub(crate) fn handover(
    plant: &Plant,
    noise: &noise::Model,
    model: &Model,
    p: Precision,
) -> Result<Matrix, Vec<Diagnostic>> {
    let white = interval::noise(plant, &model.phi, noise.at(plant, p)?);
    let phi = interval::transition(plant, &model.phi);
    let found = steady(&phi, &model.c, &white).map_err(|failure| noise.said(plant, failure))?;
    Ok(found.gain)
}

/// What stands against a table: a restart, its length.
pub(super) fn check(plant: &Plant, keys: &Keys, counting: Counting, after: &Range<usize>, found: &mut Vec<Diagnostic>) {
    if counting.after == After::Restart {
        let message = "a Kalman filter does not start again";
        let error = Diagnostic::error(codes::METHOD_CANNOT, after.clone(), message);
        let label =
            "at the end of its table it knows the state as well as its noise allows; a restart would forget that";
        found.push(error.label(label).help("`after = \"handover\"`, to the steady filter, or `\"hold\"`"));
    }
    let numbers = counting.lead() * plant.states.len() * plant.outputs.len();
    if numbers > MOST_NUMBERS {
        let span = keys.law_span().unwrap_or_else(|| plant.span.clone());
        let error = Diagnostic::error(codes::WINDOW_TOO_LONG, span, "the table of gains is too long");
        let label = format!("{numbers} numbers; at most {MOST_NUMBERS}");
        let help = "a shorter `time` with `after = \"handover\"`, or a larger `stop_before`";
        found.push(error.label(label).measured(count(numbers)).help(help));
    }
}

/// Refuses to hold a gain with which the error grows.
pub(super) fn refuse_growth(plant: &Plant, exact: &Exact, counting: Counting) -> Result<(), Vec<Diagnostic>> {
    let crate::estimator::corrector::exact::Law::Table(gains) = &exact.law else { return Ok(()) };
    let last = gains.last().filter(|_| counting.after == After::Hold);
    if last.is_none_or(|gain| {
        contracts(&closed_loop(&interval::transition(plant, &exact.model.phi), &exact.model.c, gain))
    }) {
        return Ok(());
    }
    let message = "with the table's last gain, held, the error does not die out";
    let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message);
    Err(vec![error.help("`after = \"handover\"`, or a longer `time`")])
}

/// What white noise leaves of the estimate, and what a table would, which is called so; two lines at most.
pub(crate) fn notes(
    plant: &Plant,
    built: &Built,
    law: Option<&Law>,
    noise: Option<&noise::Model>,
    alternative: &str,
) -> Vec<String> {
    let Some(noise) = law.map(|law| &law.noise).or(noise) else { return Vec::new() };
    let p = Precision::bits(BITS);
    let lead = built.schedule.lead.len();
    if lead * plant.states.len().pow(3) > MOST_WORK {
        return Vec::new();
    }
    let Ok(white) = noise.at(plant, p) else { return Vec::new() };
    let (phi, c) = (built.exact.model.phi.with_precision(p), built.exact.model.c.with_precision(p));
    let noisy = Noisy {
        phi: phi.to_f64(),
        c: c.to_f64(),
        process: white.process.to_f64(),
        measurement: white.measurement.to_f64(),
    };
    let zeros = vec![Real::zero(p); plant.states.len()];
    let start =
        law.map_or_else(|| first_covariance(&readout(plant, p), &zeros, &white), |law| law.start(plant, &white, p));
    let ours = noisy.deviations(start.to_f64(), &built.schedule);
    let mut notes = noise.notes(plant);
    let linear = if plant.injections.is_empty() { "" } else { ", without what it does through nonlinear terms" };
    notes.push(format!(
        "standard deviations for white noise{linear}, at call {} and later: {}",
        lead + 1,
        pairs(plant, &ours)
    ));
    if law.is_some() {
        return notes;
    }
    let calls = interval::calls(plant);
    let (phi, white) = (interval::transition(plant, &phi), interval::noise(plant, &phi, white));
    let Ok(filter) = steady(&phi, &c, &white) else { return notes };
    let unknown = |i: usize| {
        let deviation = filter.predicted[(i, i)].checked_sqrt().unwrap_or_else(|_| Real::zero(p));
        &deviation * &Real::from_i64(UNKNOWN, p)
    };
    let unknown: Vec<Real> = (0..plant.states.len()).map(unknown).collect();
    let start = first_covariance(&readout(plant, p), &unknown, &white);
    let Ok(gains) = transient(&phi, &c, &white, &start, lead / calls) else { return notes };
    let table = Schedule { lead: gains.iter().map(Matrix::to_f64).collect(), cycle: vec![filter.gain.to_f64()] };
    let table = table.between(calls, lead);
    let theirs = noisy.deviations(start.to_f64(), &table);
    if is_better(&theirs, &ours) {
        notes.push(format!(
            "{alternative}, handed over, leaves less of this noise: {} (from initial errors up to {UNKNOWN} times these)",
            pairs(plant, &theirs)
        ));
    }
    notes
}

fn is_better(theirs: &Deviations, ours: &Deviations) -> bool {
    let less = |a: &[f64], b: &[f64]| a.iter().zip(b).any(|(a, b)| *a < BETTER * b);
    less(&theirs.promised, &ours.promised) || less(&theirs.later, &ours.later)
}

/// Per state: at the promised call, and later.
fn pairs(plant: &Plant, deviations: &Deviations) -> String {
    let digits = |x: f64| if x.is_finite() { show(short(x).parse().unwrap_or(x)) } else { "no bound".into() };
    let both = deviations.promised.iter().zip(&deviations.later);
    let each = plant.states.iter().zip(both).map(|(state, (promised, later))| {
        let unit = if state.label.unit.is_empty() { String::new() } else { format!(" {}", state.label.unit) };
        format!("{} {}, {}{unit}", state.label.name, digits(*promised), digits(*later))
    });
    each.collect::<Vec<_>>().join("; ")
}
