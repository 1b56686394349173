//! The shape "baseline": a signal and its rate as firmware has them today, without a model and without gains.
//!
//! Knows the outputs that are read and how a step is written. Never knows a model of the plant, nor another estimator.
//!
//! - `low-pass`: the held difference quotient through a filter of first order;
//! - `adaptive-window`: the slope of the longest straight line that fits the newest samples.
//!
//! Neither is linear in the samples: when a quotient is new, and how long the window is, depends on them. So nothing is
//! certified. What is said is when the formula has what it needs; [`lower`] writes the step.

pub mod lower;

use crate::diagnostic::Diagnostic;
use crate::estimator::Estimator;
use crate::numbers::count;
use crate::plant::Plant;
use crate::plant::features::{Feature, Limit, POSITIONS};
use crate::program::Program;
use crate::promise::Certificate;
use crate::sampled::settled::Settled;
use crate::step::ahead::Ahead;

/// The estimator, settled.
#[derive(Clone, Debug)]
pub struct Baseline {
    /// What it computes.
    pub law: Law,
    /// Good calls after the first until the estimate is the formula's.
    pub valid: usize,
    /// Good calls in a row after a missing sample until it is again; at least 1.
    pub recovery: usize,
}

/// What a baseline computes.
#[derive(Clone, Debug)]
pub enum Law {
    /// Held difference and low pass.
    LowPass(LowPass),
    /// The longest line that fits.
    AdaptiveWindow(AdaptiveWindow),
}

/// `v = a v + (1 - a) q`, `a = T / (T + h)`, q the change of the signal over the time since the change before.
#[derive(Clone, Debug)]
pub struct LowPass {
    /// a; `None` without a filter.
    pub kept: Option<Settled>,
    /// 1 - a.
    pub entering: Settled,
    /// h, s.
    pub period: Settled,
}

/// The line by least squares through the newest n + 1 samples, for the largest n before one of n = 2, 3, … leaves a
/// sample further off than `deviation`.
#[derive(Clone, Debug)]
pub struct AdaptiveWindow {
    /// N: the most calls that the window goes back, and the most samples before the newest.
    pub longest: usize,
    /// In the unit of the signal.
    pub deviation: Settled,
    /// h, s.
    pub period: Settled,
}

/// What a filter of the difference quotient cannot take.
pub const LOW_PASS: &[Limit] = &[
    GATE,
    EVERY,
    AGE,
    DELAY,
    ONE_OUTPUT,
    Limit::new(
        Feature::LeftOut,
        "it keeps one sample, and a missing one only makes the next difference longer",
        "leave it out: a missing sample changes nothing",
    ),
    Limit::new(Feature::Windows, "it has no window", "use `window`, or a specification for each `time_constant`"),
    INIT_AT,
    POSITIONS,
];

/// What the longest line that fits cannot take.
pub const ADAPTIVE_WINDOW: &[Limit] = &[
    GATE,
    EVERY,
    AGE,
    DELAY,
    ONE_OUTPUT,
    Limit::new(Feature::Windows, "the samples choose its length, up to `longest`", "use `window`"),
    INIT_AT,
    POSITIONS,
];

const GATE: Limit =
    Limit::new(Feature::Gate, "it predicts no sample to compare with", "use `pll`, `alpha-beta` or `window`");
const EVERY: Limit = Limit::new(
    Feature::Every,
    "without a model nothing says what the signal does at the calls in between",
    "write the time between its samples as `sample_time`",
);
const AGE: Limit = Limit::new(
    Feature::Age,
    "its differences are over whole sample times",
    "use `window`, which takes samples of any age",
);
const DELAY: Limit = Limit::new(
    Feature::Delay,
    "without a model nothing carries a late sample on to now",
    "leave it out, and the estimate is as late, or use `window`",
);
const ONE_OUTPUT: Limit = Limit::new(
    Feature::Outputs,
    "it is the rate of one signal, and without a model another says nothing of it",
    "put each signal into a file of its own",
);
const INIT_AT: Limit = Limit::new(Feature::InitAt, "it has no state to start from", "use `pll` or `alpha-beta`");

impl Baseline {
    /// Calls that the estimate goes back, as far as it does.
    pub fn steps(&self) -> usize {
        match &self.law {
            Law::LowPass(_) => self.valid,
            Law::AdaptiveWindow(law) => law.longest,
        }
    }

    /// How the user names its realisation.
    pub fn realization(&self) -> &'static str {
        match self.law {
            Law::LowPass(_) => "recursive",
            Law::AdaptiveWindow(_) => "search",
        }
    }

    /// The largest sum of a step, for samples of magnitude 1.
    fn growth(&self) -> f64 {
        match &self.law {
            Law::LowPass(law) => 4.0 * (1.0 + 1.0 / law.period.double),
            Law::AdaptiveWindow(law) => law.growth(),
        }
    }
}

impl AdaptiveWindow {
    /// Ages are whole numbers, so that the determinant of a fit is 1 at least; each is at most N (N + 1), whatever was
    /// lost in between, and each sample at most 2 N off the newest.
    fn growth(&self) -> f64 {
        let n = count(self.longest);
        let (age, sample) = (n * (n + 1.0), 2.0 * n);
        let slope = 2.0 * (n + 1.0) * n * age * sample;
        let level = sample + slope * age;
        4.0 * (level + slope * (n + 1.0) + slope / self.period.double)
    }
}

impl Estimator for Baseline {
    fn lower(&self, plant: &Plant, ahead: Option<&Ahead>, _promised: &Certificate) -> Result<Program, Vec<Diagnostic>> {
        lower::lower(plant, self, ahead)
    }

    fn recovery(&self) -> Option<usize> {
        Some(self.recovery)
    }

    fn no_gains(&self) -> Option<&'static str> {
        Some(match self.law {
            Law::LowPass(_) => "no gains from noise: what it does depends on when samples change",
            Law::AdaptiveWindow(_) => "no gains from noise: the window's length depends on it",
        })
    }
}
