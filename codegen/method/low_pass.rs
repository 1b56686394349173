//! `[observer.low-pass]`: the held difference quotient through a filter of first order.
//!
//! **Idea.** With each change of the signal a new quotient, the change over the time since the change before; held until
//! the next, and filtered at every call: `v = a v + (1 - a) q`, `a = T / (T + h)`.
//!
//! **Source.** What open motor controllers ship (`SimpleFOC`'s `Sensor` and `LowPassFilter`), in own words: nothing of it
//! is theirs but the formula. See [`crate::estimator::baseline`].
//!
//! **Conditions.** One output without delay. No certificate: the formula is not linear in the samples.

use crate::spec::Chain;
use std::sync::Arc;

use super::baseline::{self, Settling};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::baseline::{Baseline, Law, LowPass};
use crate::expr::Constant;
use crate::numbers::short;
use crate::plant::Plant;
use crate::promise::{CONTRACTED, Convergence};
use crate::real::{Precision, Real};
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "low-pass",
    summary: "the held difference of a signal through a low pass, as motor controllers have it",
    source: "shipped by SimpleFOC; v = a v + (1 - a) q, a = T/(T + h)",
    keys: &[("time_constant", "s", "T of the filter; 0 leaves the held difference as it is")],
    realizations: &[("recursive", "the filter is carried on from call to call")],
    limits: crate::estimator::baseline::LOW_PASS,
    page: include_str!("low-pass.md"),
    read,
};

/// The most calls until a filter has forgotten where it began.
const MOST_CALLS: f64 = 1e6;

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    time_constant: Quantity,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let time_constant = table.quantity("time_constant");
    if time_constant.is_none() && !table.has("time_constant") {
        table.missing("time_constant", "write `time_constant = …`, in s; 5e-3 is what is shipped");
    }
    Some(Arc::new(Keys { time_constant: time_constant? }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain { order: Some(2), key: None, instead: "`[observer.window]` takes a plant of your own" }
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = super::constant::refuse(plant, METHOD.name, super::constant::Outputs::One);
        let time = self.checked(plant, &mut found);
        let Some(time) = time.filter(|_| found.is_empty()) else { return Err(found) };
        let run = |p: Precision| {
            let numbers = time.evaluate(p).ok().zip(plant.sample_time.0.evaluate(p).ok());
            numbers.map(|(time, h)| constants(&time, h)).ok_or_else(|| vec![self.no_number()])
        };
        let Settling { constants, numerics } = baseline::settle(plant, &run)?;
        let [kept, entering, period] = [0, 1, 2].map(|i| constants.get(i).copied().flatten());
        let law = LowPass { kept, entering: entering.unwrap_or_default(), period: period.unwrap_or_default() };
        let radius = kept.map_or(0.0, |kept| kept.double);
        let calls = forgotten(radius);
        let shape = Baseline { law: Law::LowPass(law), valid: calls, recovery: calls };
        let time = show(time.to_f64().unwrap_or(f64::NAN));
        let summary = if radius > 0.0 {
            format!("held difference, low pass of {time} s: a = {}", short(radius))
        } else {
            "held difference, not filtered".to_owned()
        };
        let notes =
            vec![format!("at constant acceleration the rate is {time} s late, and half the time between changes more")];
        let convergence = if radius > 0.0 { Convergence::Geometric { radius, period: 1 } } else { Convergence::Finite };
        Ok(baseline::design(plant, (METHOD.name, summary), (convergence, calls), notes, shape, numerics))
    }
}

impl Keys {
    /// T, not negative, and short enough.
    fn checked(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Constant> {
        let time = plant.constant(&self.time_constant, found)?;
        let (value, h) = (time.to_f64().unwrap_or(f64::NAN), plant.sample_time_s());
        if value < 0.0 || !value.is_finite() {
            let message = format!("`time_constant` must not be negative, but is {}", show(value));
            let error = Diagnostic::error(codes::BAD_NUMBER, self.time_constant.span(), message).measured(value);
            found.push(error.help("write it in s; 0 leaves the held difference as it is"));
            return None;
        }
        // ln 1e-6 is -13.8.
        let calls = 14.0 * value / h;
        if calls > MOST_CALLS {
            let message = "the filter is too slow for this sample time";
            let error = Diagnostic::error(codes::OUT_OF_RANGE, self.time_constant.span(), message);
            let error = error.label(format!("{} calls until it has forgotten where it began", short(calls)));
            let help = format!("at most {} s, or a longer sample time", short(MOST_CALLS * h / 14.0));
            found.push(error.measured(calls).help(help));
            return None;
        }
        Some(time)
    }

    fn no_number(&self) -> Diagnostic {
        Diagnostic::error(codes::DOMAIN, self.time_constant.span(), "the time constant has no usable value")
    }
}

/// a, 1 - a and h.
fn constants(time: &Real, h: Real) -> Vec<Real> {
    let whole = time + &h;
    vec![time / &whole, &h / &whole, h]
}

/// Calls after which a millionth is left of where the filter began.
fn forgotten(radius: f64) -> usize {
    let mut left = 1.0;
    let mut calls = 0;
    while left > CONTRACTED {
        left *= radius;
        calls += 1;
    }
    calls
}
