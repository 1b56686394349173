//! `[observer.fixed-time-linear]`: the gains of the prescribed time itself, at every call.
//!
//! **Idea.** At T the gains of 003 and 004 no longer depend on the law: the estimate is that of the last n samples
//! alone, whatever was before. Held from the first sample on they are the fastest observer there is: exact after n
//! samples, and the one that noise reaches with nothing in its way. It is here to compare with.
//!
//! **Source.** 003 (efimov-orlov-2024-implicit-euler), Z(T) and F(T) below (13), `Z(T)^n = 0`; any plant by M and q
//! (prescribed-time-observers, sections 1 and 3).
//!
//! **Conditions.** A chain of integrators, or (C, A) observable with one output at the sample time, no mode that is gone
//! within a sample, no delay, nonlinearities in measured states, inputs and time only.

use crate::spec::Chain;
use std::sync::Arc;

use super::order::{self, Order};
use super::window::{constants, refuse_unknowns, resolution_warnings, time_warning, verdict};
use super::{Keyed, Method, between};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::design::{Promise, Request, build};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::{Counting, interval};
use crate::estimator::{Design, corrector};
use crate::numbers::{count, short};
use crate::plant::Plant;
use crate::promise::{Certificate, Convergence, NamedMatrix};
use crate::real::{Matrix, Precision, Real, rows};
use crate::sampled::model::signals;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "fixed-time-linear",
    summary: "the prescribed-time gains at their end: exact after n samples, at the price of the most noise",
    source: "Efimov and Orlov 2024, Z(T); for a chain of integrators backward differences",
    keys: &[order::ORDER, order::PREDICTION],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: corrector::OF_ONE_OUTPUT,
    page: include_str!("fixed-time-linear.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    order: Order,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    Some(Arc::new(Keys { order: order::read(table, 2..=8)? }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain { order: self.order.order, key: Some("order"), instead: "leave out `order`" }
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        between::refuse_rare(plant, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let n = plant.states.len();
        let condition = verdict(plant, &[0], n, &plant.span)?;
        let condition = between::verdict(plant)?.unwrap_or(condition);
        let calls = interval::calls(plant);
        let signals = signals(plant);
        let valid = calls * exact_after(plant);
        let request = Request {
            plant,
            signals: signals.clone(),
            counting: Counting::NONE,
            // Implicit Euler's coordinates are of samples, and the step predicts from call to call.
            scaled: self.order.order.is_some() && calls == 1,
            promise: Promise::At(valid),
            model: &|p: Precision| self.order.model(plant, &signals, p),
            law: &|_, p: Precision| Ok((Law::Kappa(Matrix::from_fn(n, 1, |_, _| Real::one(p))), None)),
        };
        let built = build(&request)?;
        let mut numerics = built.numerics;
        numerics.condition = condition;
        let mut all = constants(&built.exact.model);
        let gain = built.schedule.cycle.last().map(rows).unwrap_or_default();
        all.push(NamedMatrix { letter: "K", rows: gain });
        let mut warnings: Vec<Diagnostic> = noise(plant, &built.certificate, self.order.order).into_iter().collect();
        warnings.extend(time_warning(plant));
        warnings.extend(resolution_warnings(plant));
        Ok(Design {
            method: METHOD.name,
            realization: "recursive",
            summary: between::said(
                plant,
                format!("the estimate that the last {n} samples determine, carried on by a constant gain"),
            ),
            window_steps: calls * (n - 1),
            valid_from_step: valid,
            convergence: Convergence::Finite,
            realizations: Vec::new(),
            notes: self.order.late(if calls == 1 { "samples" } else { "calls" }).into_iter().collect(),
            constants: all,
            fir: None,
            certificate: self.order.certain(built.certificate),
            numerics,
            warnings,
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(built.corrector),
        })
    }
}

/// Samples after the first until the error is gone: `Z^n = 0`, and `Z^(n-1)` takes only what the first sample shows, which
/// is right where a state is what it shows.
fn exact_after(plant: &Plant) -> usize {
    let shown = plant.states.iter().any(|state| !state.measured.is_empty());
    plant.states.len() - usize::from(shown)
}

/// What the declared noise does to the state that it reaches most, in multiples of it.
fn noise(plant: &Plant, certificate: &Certificate, order: Option<usize>) -> Option<Diagnostic> {
    let output = &plant.outputs[0];
    let level = output.noise.as_ref()?.to_f64().ok().filter(|level| *level > 0.0)?;
    let gains = plant.states.iter().zip(&certificate.noise_gain_l1);
    let (state, gain) = gains.map(|(state, gain)| (state, gain[0])).max_by(|a, b| a.1.total_cmp(&b.1))?;
    let message = "the noise of n samples is all that stands between the sensor and the estimate";
    let (unit, name) = (&state.label.unit, &state.label.name);
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let label = format!("{} of it is up to {}{unit} in `{name}`", short(level), short(gain * level));
    let warning = Diagnostic::warning(codes::NOISE, output.label.span.clone(), message).measured(gain * level);
    let longer = count(10 * plant.states.len()) * interval::seconds(plant);
    let longer = short(longer);
    let help = match order {
        Some(order) => {
            format!("`[observer.differentiator]` with `order = {order}` and `time = {longer}` or more has less of it")
        }
        None => {
            format!(
                "`[observer.window]` with `window = {longer}` or more has less of it, or `prescribed-time`, which ends before"
            )
        }
    };
    Some(warning.label(label).help(help))
}

#[cfg(test)]
mod tests {
    use super::super::designed;
    use crate::promise::Convergence;

    /// A chain is exact with its n-th sample, call n - 1; so is a plant that shows a state. One that shows a sum of
    /// states needs one more.
    #[test]
    fn it_is_exact_with_the_last_sample_that_it_needs() {
        let chain = |keys: &str| {
            format!(
                "deadbeat = 1\nname = 'f'\n[outputs]\ny = {{}}\n[observer.fixed-time-linear]\norder = 4\n{keys}\n\
                 [target]\nsample_time = 0.1\nscalar = 'f64'\n"
            )
        };
        let plant = |value: &str| {
            format!(
                "deadbeat = 1\nname = 'f'\n[states]\na = {{ derivative = 'b' }}\nb = {{ derivative = 'c - a' }}\n\
                 c = {{ derivative = '-2*c' }}\n[outputs]\ny = {{ value = '{value}' }}\n[observer.fixed-time-linear]\n\
                 [target]\nsample_time = 0.1\nscalar = 'f64'\n"
            )
        };
        for (text, calls) in
            [(chain(""), 3), (chain("prediction = 'implicit-euler'"), 3), (plant("2*a"), 2), (plant("a + c"), 3)]
        {
            let (_, design) = designed(&text).unwrap();
            assert_eq!((design.convergence, design.valid_from_step), (Convergence::Finite, calls));
        }
    }
}
