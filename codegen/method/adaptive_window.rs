//! `[observer.adaptive-window]`: the slope of the longest line that fits the newest samples.
//!
//! **Idea.** A long window when the signal runs straight, a short one when it bends: of the lines by least squares through
//! the newest two, three, … samples the last before one leaves a sample further off than `deviation`. Its slope at the
//! end is the rate.
//!
//! **Source.** Janabi-Sharifi, Hayward and Chen 2000, "Discrete-time adaptive windowing for velocity estimation": the
//! first-order window with the best fit. See [`crate::estimator::baseline`].
//!
//! **Conditions.** One output without delay. No certificate: the window's length depends on the samples.

use crate::spec::Chain;
use std::sync::Arc;

use super::baseline::{self, Settling};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::baseline::{AdaptiveWindow, Baseline, Law};
use crate::expr::Constant;
use crate::numbers::{count, short};
use crate::plant::Plant;
use crate::promise::Convergence;
use crate::real::Precision;
use crate::sampled::samples::whole_samples;
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "adaptive-window",
    summary: "the slope of the longest line that stays close to every sample",
    source: "Janabi-Sharifi, Hayward and Chen 2000, first order, best fit",
    keys: &[
        ("deviation", "unit of the output", "how far a sample may be off the line; one count, or the noise"),
        ("longest", "s", "the longest window, a whole number of samples, at most 64"),
        ("missing", "\"left-out\"", "what becomes of a missing sample: the line goes through those that are there"),
    ],
    realizations: &[("search", "every window is fitted and looked at in every call")],
    limits: crate::estimator::baseline::ADAPTIVE_WINDOW,
    page: include_str!("adaptive-window.md"),
    read,
};

/// The longest window: sums of ages are then whole numbers below 2^24, exact in single precision.
const MOST: usize = 64;

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    deviation: Quantity,
    longest: Quantity,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("search", ())], ());
    table.choice("missing", &[("left-out", ())], ());
    let (deviation, longest) = (table.quantity("deviation"), table.quantity("longest"));
    if deviation.is_none() && !table.has("deviation") {
        table.missing("deviation", "write `deviation = …`, in the output's unit: one count, or the noise");
    }
    if longest.is_none() && !table.has("longest") && table.has("deviation") {
        table.missing("longest", "write `longest = …`, in s: how far back the line may go");
    }
    Some(Arc::new(Keys { deviation: deviation?, longest: longest? }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain { order: Some(2), key: None, instead: "`[observer.window]` takes a plant of your own" }
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = super::constant::refuse(plant, METHOD.name, super::constant::Outputs::One);
        let (deviation, longest) = (self.deviation(plant, &mut found), self.longest(plant, &mut found));
        let (Some(deviation), Some(longest), true) = (deviation, longest, found.is_empty()) else { return Err(found) };
        let run = |p: Precision| {
            let numbers = deviation.evaluate(p).ok().zip(plant.sample_time.0.evaluate(p).ok());
            numbers.map(|(deviation, h)| vec![deviation, h]).ok_or_else(|| vec![self.no_number()])
        };
        let Settling { constants, numerics } = baseline::settle(plant, &run)?;
        let [bound, period] = [0, 1].map(|i| constants.get(i).copied().flatten().unwrap_or_default());
        let law = AdaptiveWindow { longest, deviation: bound, period };
        let shape = Baseline { law: Law::AdaptiveWindow(law), valid: 1, recovery: 1 };
        let summary = format!(
            "line through the newest 2 to {} samples, as long as all are within {} of it",
            longest + 1,
            show(bound.double)
        );
        let pairs = longest * (longest + 3) / 2 - 2;
        let notes = vec![
            format!("{longest} fits and {pairs} deviations a call, whatever the samples"),
            "lost samples are left out, and the line goes through those that are there".to_owned(),
        ];
        let convergence = (Convergence::Finite, 1);
        Ok(baseline::design(plant, (METHOD.name, summary), convergence, notes, shape, numerics))
    }
}

impl Keys {
    /// The deviation, above 0.
    fn deviation(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Constant> {
        let deviation = plant.constant(&self.deviation, found)?;
        let value = plant.scalar_value(deviation.to_f64().unwrap_or(f64::NAN));
        if value > 0.0 && value.is_finite() {
            return Some(deviation);
        }
        let message = format!("`deviation` must be above 0, not {}", show(value));
        let error = Diagnostic::error(codes::BAD_NUMBER, self.deviation.span(), message).measured(value);
        found.push(error.help("write one count of the sensor, or the bound on its noise"));
        None
    }

    /// N.
    fn longest(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<usize> {
        let longest = plant.constant(&self.longest, found)?;
        let (value, span, h) = (longest.to_f64().unwrap_or(f64::NAN), self.longest.span(), plant.sample_time_s());
        if value <= 0.0 || !value.is_finite() {
            let message = format!("`longest` must be longer than 0 s, not {}", show(value));
            let error = Diagnostic::error(codes::BAD_NUMBER, span, message).measured(value);
            found.push(error.help("write how far back the line may go, in s"));
            return None;
        }
        let samples = whole_samples(&longest, &span, "the longest window", plant, found)?;
        if samples > MOST {
            let error = Diagnostic::error(codes::WINDOW_TOO_LONG, span, "the longest window has too many samples");
            let error = error.label(format!("{samples} samples; every call looks at half the square of that"));
            let help =
                format!("at most {} s, which are {MOST} samples, or `[observer.window]`", short(count(MOST) * h));
            found.push(error.measured(count(samples)).help(help));
            return None;
        }
        Some(samples)
    }

    fn no_number(&self) -> Diagnostic {
        Diagnostic::error(codes::DOMAIN, self.deviation.span(), "the deviation has no usable value")
    }
}
