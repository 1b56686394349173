//! Methods that count down to a prescribed time: the gain laws of 003 and 004 with their numbers, and what follows.
//!
//! [`keys`] reads the table, [`numbers`](mod@numbers) evaluates a law; here are the steps, where they end, and what the user should
//! know of that.

pub mod keys;
pub mod numbers;

use std::ops::Range;

use super::between;
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::{After, Counting, interval, law, theorem1};
use crate::expr::{Constant, List};
use crate::numbers::count;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::real::{Precision, Rational, Real};
use crate::sampled::samples::whole_samples;
use crate::spec::Quantity;
pub use keys::{
    AFTER, EFIMOV_ORLOV, HOLLOWAY_KRSTIC, INITIAL, Keys, LawKeys, MAX_GAIN, POLES, STOP_BEFORE, TIME, read,
};
use numbers::numbers;
pub use numbers::{Numbers, listed};

/// Sets the states that the first sample does not show to what the key `initial` says.
///
/// # Errors
/// A wrong number of them, or one that is no constant.
pub fn start(plant: &mut Plant, initial: Option<&(Vec<Quantity>, Range<usize>)>) -> Result<(), Vec<Diagnostic>> {
    let Some((list, span)) = initial else { return Ok(()) };
    let mut found = Vec::new();
    let values: Vec<Option<Constant>> = list.iter().map(|q| plant.constant(q, &mut found)).collect();
    let hidden: Vec<&str> =
        plant.states.iter().filter(|s| s.measured.is_empty()).map(|s| s.label.name.as_str()).collect();
    if values.len() != hidden.len() {
        let wanted = hidden.len();
        let numbers = if wanted == 1 { "number" } else { "numbers" };
        let message = format!("`initial` needs {wanted} {numbers}, one per state that the first sample does not show");
        let error = Diagnostic::error(codes::SHAPE, span.clone(), message).measured(count(values.len()));
        found.push(error.label(format!("these are {}", values.len())).help(format!("they are of {}", List(&hidden))));
    }
    if !found.is_empty() {
        return Err(found);
    }
    let states = plant.states.iter_mut().filter(|state| state.measured.is_empty());
    states.zip(values.into_iter().flatten()).for_each(|(state, value)| state.initial = value);
    Ok(())
}

/// The most states of a countdown: the gains' powers and their exact exponents grow with them.
const MOST_STATES: usize = 12;

/// A countdown with its numbers.
#[derive(Clone, Debug)]
pub struct Countdown {
    /// N, where it stops, what follows.
    pub counting: Counting,
    /// T.
    pub time: Constant,
    /// The law.
    pub numbers: Numbers,
    /// n.
    pub order: usize,
}

impl Countdown {
    /// The numbers of the keys for a plant; mistakes are collected.
    pub fn new(plant: &Plant, keys: &Keys, found: &mut Vec<Diagnostic>) -> Option<Self> {
        let order = plant.states.len();
        let numbers = numbers(plant, keys, order, found);
        if order > MOST_STATES {
            let message = format!("{order} states are too many for gains by a countdown");
            let error = Diagnostic::error(codes::TOO_LARGE, plant.span.clone(), message).measured(count(order));
            found.push(
                error.label(format!("at most {MOST_STATES}")).help("use the law `kalman`, or the method `window`"),
            );
            return None;
        }
        let (time, steps) = duration(plant, keys, found)?;
        let numbers = numbers?;
        let mut countdown = Self { counting: Counting { steps, stop: 0, after: keys.after.0 }, time, numbers, order };
        countdown.counting.stop = countdown.stop(plant, keys, found)?;
        countdown.check_exponents(plant, keys, found);
        Some(countdown)
    }

    /// `r^n c_i` by powers of r, at one precision; `None` where a constant has no value.
    pub fn rows(&self, plant: &Plant, precision: Precision) -> Option<law::Rows> {
        let value = |constant: &Constant| constant.evaluate(precision).ok();
        Some(match &self.numbers {
            Numbers::EfimovOrlov(gains) => {
                let gains: Option<Vec<Real>> = gains.iter().map(value).collect();
                law::efimov_orlov(&gains?, &value(&self.time)?)
            }
            Numbers::HollowayKrstic(m, l) => {
                let l: Option<Vec<Real>> = l.iter().map(value).collect();
                law::holloway_krstic(*m, &l?, &interval::time(plant, precision).ok()?)
            }
            Numbers::Poles(p) => law::poles(self.order, &value(p)?),
        })
    }

    /// In doubles, for decisions and reports.
    pub fn doubles(&self, plant: &Plant) -> Option<Vec<Vec<f64>>> {
        let rows = self.rows(plant, Precision::bits(256))?;
        Some(rows.iter().map(|row| row.iter().map(Real::to_f64).collect()).collect())
    }

    /// The fewest steps left.
    fn stop(&self, plant: &Plant, keys: &Keys, found: &mut Vec<Diagnostic>) -> Option<usize> {
        let steps = self.counting.steps;
        if let Some(gain) = &keys.max_gain {
            return self.stop_at(plant, gain, found);
        }
        let Some((stop, span)) = &keys.stop_before else {
            let share = if self.counting.after == After::Restart { 5 } else { 10 };
            return Some(steps.div_ceil(share));
        };
        if *stop >= steps {
            let message = "the countdown ends before it begins";
            let error = Diagnostic::error(codes::BAD_NUMBER, span.clone(), message).measured(count(*stop));
            let label = format!("{stop} steps left of {steps}");
            found.push(error.label(label).help(format!("at most {}", steps - 1)));
            return None;
        }
        if *stop == 0 && self.counting.after == After::Restart {
            let message = "a restart cannot come from the prescribed time itself";
            let error = Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message);
            let label = "backward differences, whose noise the low gains after them keep";
            found.push(error.label(label).help("`stop_before = 1` is 003 (21); N/5 and more carries less noise over"));
            return None;
        }
        Some(*stop)
    }

    /// Where the largest gain reaches 004's limit: the fewest steps left at which no `g_i = c_i/h^i` is above it.
    fn stop_at(&self, plant: &Plant, limit: &Quantity, found: &mut Vec<Diagnostic>) -> Option<usize> {
        let most = plant.constant(limit, found)?.to_f64().unwrap_or(f64::NAN);
        let rows = self.doubles(plant)?;
        let h = interval::seconds(plant);
        let gain = |left: usize| {
            let r = count(left);
            let value = |(i, row): (usize, &Vec<f64>)| {
                let terms = row.iter().enumerate().map(|(j, a)| a * power(r, j) / power(r, self.order));
                terms.sum::<f64>() / power(h, i + 1)
            };
            rows.iter().enumerate().map(value).fold(0.0, f64::max)
        };
        let steps = self.counting.steps;
        let stop = (1..steps).rev().take_while(|left| gain(*left) <= most).last();
        if stop.is_none() {
            let first = gain(steps - 1);
            let message = "the first gain is above `max_gain` already";
            let error = Diagnostic::error(codes::BAD_NUMBER, limit.span(), message).measured(first);
            found.push(error.label(format!("{first:.3e} is needed")).help("a larger `max_gain`, or a longer `time`"));
        }
        stop
    }

    /// Refuses gains with which the error does not vanish at T: 003's exponents, exactly.
    fn check_exponents(&self, plant: &Plant, keys: &Keys, found: &mut Vec<Diagnostic>) {
        let Some(scaled) = self.scaled(plant) else { return };
        if theorem1::vanishes(&scaled) {
            return;
        }
        let (margin, needed) = (theorem1::margin(&scaled), count(self.order - 1));
        let span = match &keys.law {
            Some(LawKeys::EfimovOrlov(_, span) | LawKeys::HollowayKrstic(_, _, span)) => span.clone(),
            Some(LawKeys::Poles(p)) => p.span(),
            None => plant.span.clone(),
        };
        let message = "with these gains the error does not vanish at the prescribed time";
        let error = Diagnostic::error(codes::METHOD_CANNOT, span, message).measured(margin);
        let label = format!(
            "it falls like (T-t)^{}; for the last state more than (T-t)^{needed} is needed",
            crate::numbers::short(margin)
        );
        found.push(error.label(label).help("larger gains, a longer `time`, or `poles = { p = 10 }`"));
    }

    /// The exponent of the slowest decay of the scaled error: `-max Re eig(A - Lambda C - diag(0, …, n-1))`, with
    /// `Lambda_i = L_i T^i`; it must be above n - 1 (prescribed-time-observers, section 1: exact, where 003's
    /// T > 2n - 2 is only sufficient).
    pub fn margin(&self, plant: &Plant) -> Option<f64> {
        Some(theorem1::margin(&self.scaled(plant)?))
    }

    /// `Lambda_i = L_i T^i`, the law's share that grows fastest towards T: n of them.
    pub fn scaled(&self, plant: &Plant) -> Option<Vec<Rational>> {
        let rows = self.rows(plant, Precision::bits(256))?;
        rows.iter().enumerate().map(|(i, row)| row[self.order - 1 - i].to_rational()).collect()
    }

    /// Steps left at a step from the first sample on; the last is T.
    pub fn left_at(&self, step: usize) -> Result<usize, String> {
        let steps = self.counting.steps;
        steps
            .checked_sub(step)
            .ok_or_else(|| format!("the prescribed time is step {steps}; there is no step {step} before it"))
    }

    /// What the user should know of where the countdown ends.
    pub fn warnings(&self, plant: &Plant, keys: &Keys, largest_gain: f64) -> Vec<Diagnostic> {
        let Counting { steps, stop, after } = self.counting;
        let span = keys.stop_before.as_ref().map_or_else(|| plant.span.clone(), |(_, span)| span.clone());
        let mut warnings = Vec::new();
        if stop == 0 && plant.scalar == Scalar::F32 {
            let floor = f64::from(f32::EPSILON) * largest_gain;
            let message = "at r = 0 the rounding of the samples is all that single precision shows";
            let warning = Diagnostic::warning(codes::NOISE, span.clone(), message).measured(floor);
            let label = format!("a sample of 1 {} is worth {floor:.1e} in a state", plant.outputs[0].label.unit);
            let help = format!("`stop_before = {}`, or `scalar = \"f64\"`", steps.div_ceil(10));
            warnings.push(warning.label(label).help(help));
        }
        if after == After::Restart && 5 * stop < steps {
            let message = "a restart this close to the prescribed time carries its noise into the next round";
            let warning = Diagnostic::warning(codes::NOISE, span, message).measured(count(stop));
            let label = format!("{stop} of {steps} steps left");
            let help = format!("`stop_before = {}` or more; compare the noise gains", steps.div_ceil(5));
            warnings.push(warning.label(label).help(help));
        }
        warnings
    }
}

/// T and the samples until then; mistakes are collected.
fn duration(plant: &Plant, keys: &Keys, found: &mut Vec<Diagnostic>) -> Option<(Constant, usize)> {
    let order = plant.states.len();
    let span = keys.time.span();
    let time = plant.constant(&keys.time, found)?;
    let seconds = time.to_f64().unwrap_or(f64::NAN);
    if seconds <= 0.0 || !seconds.is_finite() {
        let message = format!("the prescribed time must be above 0 s, not {}", show(seconds));
        let error = Diagnostic::error(codes::BAD_NUMBER, span, message).measured(seconds);
        found.push(error.help("write the seconds from the first sample to the prescribed time"));
        return None;
    }
    let calls = whole_samples(&time, &span, "the prescribed time", plant, found)?;
    let steps = between::samples(plant, calls, &span, "the prescribed time", found)?;
    if steps < order {
        let message = "the prescribed time is too short to show every state";
        let error = Diagnostic::error(codes::WINDOW_TOO_SHORT, span, message).measured(count(steps));
        let samples = if steps == 1 { "sample" } else { "samples" };
        let label = format!("{steps} {samples} after the first, for {order} states");
        let least = show(count(order) * interval::seconds(plant));
        found.push(error.label(label).help(format!("a time of at least {least} s")));
        return None;
    }
    Some((time, steps))
}

/// The countdown of a table with a gain of its own for every call: to the prescribed time itself, where `stop_before`
/// does not say otherwise; mistakes are collected.
pub fn of_table(plant: &Plant, keys: &Keys, found: &mut Vec<Diagnostic>) -> Option<Counting> {
    if let Some(gain) = &keys.max_gain {
        let message = "`max_gain` limits gains that grow; those of a table are what they are";
        let error = Diagnostic::error(codes::BAD_COMBINATION, gain.span(), message);
        found.push(error.help("leave it out"));
    }
    let (_, steps) = duration(plant, keys, found)?;
    let stop = match &keys.stop_before {
        Some((stop, span)) if *stop >= steps => {
            let message = "the countdown ends before it begins";
            let error = Diagnostic::error(codes::BAD_NUMBER, span.clone(), message).measured(count(*stop));
            let label = format!("{stop} steps left of {steps}");
            found.push(error.label(label).help(format!("at most {}", steps - 1)));
            return None;
        }
        Some((stop, _)) => *stop,
        None => 0,
    };
    Some(Counting { steps, stop, after: keys.after.0 })
}

/// An integer power.
fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// A constant of the law without a value.
pub fn no_value(plant: &Plant) -> Vec<Diagnostic> {
    vec![Diagnostic::error(codes::DOMAIN, plant.span.clone(), "a constant of the gain law has no usable value")]
}
