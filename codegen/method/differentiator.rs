//! `[observer.differentiator]`: a signal and its derivatives, by gains that grow until the prescribed time.
//!
//! **Idea.** The signal is the first state of a chain of integrators; implicit Euler makes the prescribed-time observer
//! of it a recursion with n-1 additions and one division, finite at T itself. A constant map of its states gives the
//! derivatives without implicit Euler's lag.
//!
//! **Source.** 003 (efimov-orlov-2024-implicit-euler): (4), (10)-(13), (21), Theorem 1; 004's gains. Corrected and
//! brought to scaled states by prescribed-time-observers, sections 0, 1 and 3.
//!
//! **Conditions.** One output without delay; the derivative of order n bounded, for a bound on the errors.

mod notes;

use crate::spec::Chain;
use std::ops::Range;
use std::sync::Arc;

use super::countdown::{self, Countdown};
use super::order::{self, Order};
use super::prescribed_time::{exactly, filter, promised, summary, weak};
use super::window::{constants, refuse_unknowns, resolution_warnings, verdict};
use super::{Keyed, Method, Moment, between, noise};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::corrector::design::{Promise, Request, build};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::implicit_euler::{Gains, ImplicitEuler, output_map};
use crate::estimator::corrector::{self, After, interval};
use crate::plant::Plant;
use crate::promise::{Certificate, Convergence, NamedMatrix};
use crate::real::{Precision, Rational, Real};
use crate::sampled::model::Model;
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "differentiator",
    summary: "derivatives of a signal by a prescribed time; no plant, n numbers of state",
    source: "Efimov and Orlov 2024, (10)-(13), (21), Theorem 1, with a map of its outputs that takes the lag away",
    keys: &[
        ("order", "2 … 8", "n: the signal and its first n-1 derivatives are estimated"),
        countdown::TIME,
        countdown::POLES,
        countdown::HOLLOWAY_KRSTIC,
        countdown::EFIMOV_ORLOV,
        ("prediction", "\"exact\" | \"implicit-euler\"", "of the chain; the second is the paper's, and lags"),
        countdown::AFTER,
        countdown::STOP_BEFORE,
        countdown::MAX_GAIN,
        noise::KEYS[0],
        noise::KEYS[1],
        noise::KEYS[2],
        countdown::INITIAL,
    ],
    realizations: &[("recursive", "the scaled chain is carried on from call to call, and corrected")],
    limits: corrector::OF_A_CHAIN,
    page: include_str!("differentiator.md"),
    read,
};

/// The highest order.
const MOST: usize = 8;

/// Bits of what is reported of one step.
const REPORTED_BITS: usize = 512;

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    order: usize,
    chain: Order,
    initial: Option<(Vec<Quantity>, Range<usize>)>,
    countdown: countdown::Keys,
    /// Of the handover, and of the filter that the gains are compared with.
    noise: noise::Keys,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let order = order::read(table, 2..=MOST);
    if !table.has("order") {
        table.missing("order", "write `order = 3` for the signal and two derivatives");
    }
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let initial = table.list("initial");
    let countdown = countdown::read(table);
    let noise = noise::read(table);
    let chain = order?;
    Some(Arc::new(Keys { order: chain.order?, chain, initial, countdown: countdown?, noise }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain {
            order: Some(self.order),
            key: Some("order"),
            instead: "`[observer.prescribed-time]` has the same gains for a plant of your own, without `order`",
        }
    }

    fn observed(&self, mut plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        countdown::start(&mut plant, self.initial.as_ref())?;
        Ok(plant)
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let countdown = self.countdown(plant)?;
        let noise = self.noise(plant)?;
        let condition = verdict(plant, &[0], self.order, &self.countdown.time.span())?;
        let condition = between::verdict(plant)?.unwrap_or(condition);
        let calls = interval::calls(plant);
        let model = |p: Precision| self.model(plant, p);
        let counting = countdown.counting;
        let handover = noise.as_ref().filter(|_| counting.after == After::Handover);
        let law = |model: &Model, p: Precision| {
            let steady = handover.map(|noise| filter::handover(plant, noise, model, p)).transpose()?;
            let rows = countdown.rows(plant, p).ok_or_else(|| countdown::no_value(plant))?;
            Ok((Law::Countdown(rows), steady))
        };
        let promise = Promise::At(calls * promised(counting, self.order));
        let request =
            Request { plant, signals: Vec::new(), counting, scaled: calls == 1, promise, model: &model, law: &law };
        let mut built = build(&request)?;
        built.numerics.condition = condition;
        let last = built.schedule.lead.last();
        let last = last.map_or(0.0, |gain| gain.iter().fold(0.0, |most: f64, x| most.max(x.abs())));
        let mut warnings = countdown.warnings(plant, &self.countdown, last);
        warnings.extend(weak(plant, &self.countdown, built.remaining.share)?);
        warnings.extend(resolution_warnings(plant));
        let proved = notes::proved(plant, &countdown);
        let mut all = constants(&built.exact.model);
        if let Some(chain) = built.exact.chain.as_ref().filter(|_| calls > 1) {
            all.push(NamedMatrix { letter: "M", rows: chain.m.to_f64() });
            all.push(NamedMatrix { letter: "q", rows: chain.q.to_f64() });
        } else if !self.lags() {
            all.push(NamedMatrix {
                letter: "M",
                rows: output_map(self.order).iter().map(|row| doubles(row)).collect(),
            });
        }
        if let Some(Some(found)) = &proved {
            all.push(NamedMatrix { letter: "P", rows: found.p.clone() });
        }
        let mut all_notes = notes::exponents(plant, &countdown);
        all_notes.extend(proved.map(|found| notes::inequalities(plant, &countdown, found.as_ref())));
        all_notes.push(notes::lag(plant, self.order, self.lags()));
        if !self.lags() {
            all_notes.extend(filter::notes(
                plant,
                &built,
                None,
                noise.as_ref(),
                "the law `kalman` of `prescribed-time`",
            ));
        }
        Ok(Design {
            method: METHOD.name,
            realization: "recursive",
            summary: summary(plant, counting),
            window_steps: calls * counting.steps,
            valid_from_step: calls * built.corrector.valid,
            convergence: if exactly(counting) { Convergence::Finite } else { built.convergence },
            realizations: Vec::new(),
            notes: all_notes,
            constants: all,
            fir: None,
            certificate: self.certificate(built.certificate),
            numerics: built.numerics,
            warnings,
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(built.corrector),
        })
    }

    fn at(&self, plant: &Plant, step: usize) -> Result<Moment, String> {
        let no_value = || "a constant of the gain law has no usable value".to_owned();
        let countdown = self.countdown(plant).map_err(|_| no_value())?;
        let left = countdown.left_at(step)?;
        let precision = Precision::bits(REPORTED_BITS);
        let h = interval::time(plant, precision).ok().and_then(|h| h.to_rational());
        let rows = countdown.rows(plant, precision);
        let euler = h.zip(rows).and_then(|(h, rows)| ImplicitEuler::new(&gains(&rows, left)?, &h));
        let euler = euler.ok_or_else(no_value)?;
        let column = |entries: &[Rational]| entries.iter().map(|x| vec![x.to_f64().value()]).collect();
        let o = euler.o.map_or(f64::INFINITY, |o| o.to_f64().value());
        let matrices = vec![
            NamedMatrix { letter: "Z", rows: euler.z.iter().map(|row| doubles(row)).collect() },
            NamedMatrix { letter: "F", rows: column(&euler.f) },
            NamedMatrix { letter: "O", rows: vec![vec![o]] },
        ];
        Ok(Moment { step, left, in_use: left >= countdown.counting.stop, matrices })
    }
}

impl Keys {
    fn countdown(&self, plant: &Plant) -> Result<Countdown, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        between::refuse_rare(plant, &mut found);
        if self.countdown.after.0 == After::Handover && self.lags() {
            let message = "a Kalman gain is of the exact chain, and this prediction is not";
            let error = Diagnostic::error(codes::METHOD_CANNOT, self.countdown.after.1.clone(), message);
            found.push(error.help("leave `prediction` out, or keep the last gain by `after = \"hold\"`"));
        }
        let countdown = Countdown::new(plant, &self.countdown, &mut found);
        countdown.filter(|_| found.is_empty()).ok_or(found)
    }

    /// What the derivative of order n and the samples are taken to do: for a handover it must be said, else it may be.
    fn noise(&self, plant: &Plant) -> Result<Option<noise::Model>, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let noise = self.noise.check(plant, &mut found);
        let asked = self.noise.given() || self.countdown.after.0 == After::Handover;
        if asked && !found.is_empty() { Err(found) } else { Ok(noise) }
    }

    /// Whether derivatives are backward differences: with two states those are the exact chain's.
    fn lags(&self) -> bool {
        self.chain.euler && self.order > 2
    }

    /// The chain from one sample to the next.
    fn model(&self, plant: &Plant, precision: Precision) -> Result<Model, Vec<Diagnostic>> {
        Order { euler: self.lags(), ..self.chain }.model(plant, &[], precision)
    }

    /// Without the bounds that implicit Euler's lag breaks: it grows with derivatives of which no bound is declared.
    fn certificate(&self, mut certificate: Certificate) -> Certificate {
        if self.lags() {
            certificate.error_bound[1..].fill(None);
            certificate.disturbance_gain_l1[1..].iter_mut().flatten().for_each(|gain| *gain = f64::INFINITY);
        }
        certificate
    }
}

fn doubles(row: &[Rational]) -> Vec<f64> {
    row.iter().map(|x| x.to_f64().value()).collect()
}

/// The gains with `left` steps left, from `r^n c_i` by powers of r.
fn gains(rows: &[Vec<Real>], left: usize) -> Option<Gains> {
    let r = Rational::from(left);
    let powers: Vec<Rational> =
        (0..=rows.len()).scan(Rational::ONE, |power, _| Some(std::mem::replace(power, &*power * &r))).collect();
    let value = |row: &Vec<Real>| {
        let terms = row.iter().zip(&powers).map(|(a, power)| Some(a.to_rational()? * power));
        terms.collect::<Option<Vec<Rational>>>().map(|terms| terms.into_iter().fold(Rational::ZERO, |sum, x| sum + x))
    };
    let scaled: Option<Vec<Rational>> = rows.iter().map(value).collect();
    Some(Gains { power: powers.last()?.clone(), scaled: scaled? })
}
