//! The window functional: an estimate that is a fixed weighted sum of the last N+1 samples.
//!
//! Knows the plant at its samples and how many of them are kept. Never knows which method asks for it, nor another
//! estimator.
//!
//! `x_k = sum_{j=0}^{N} K_j y_{k-j} + M_j w_{k-j} + c`, where w are the inputs and the nonlinear
//! injections evaluated at the samples (window-observers, section 2, "stateless full-order FIR").
//! Every window method that is realised without a state of its own ends here: [`solve`] finds the
//! weights, [`certificate`] sums them, [`lower`] turns them into a Program.

pub mod certificate;
pub mod continuous;
pub mod decide;
pub mod innovation;
pub mod intermittent;
pub mod irregular;
pub mod lower;
pub mod minimax;
pub mod realize;
pub mod regression;
pub mod rounding;
pub mod settle;
pub mod solve;
pub mod tune;

use crate::diagnostic::Diagnostic;
use crate::estimator::Estimator;
use crate::plant::Plant;
use crate::program::Program;
use crate::promise::Certificate;
use crate::sampled::Part;
use crate::sampled::model::Between;
use crate::step::ahead::Ahead;
use std::ops::Range;

use crate::sampled::Signal;
use crate::sampled::settled::Settled;
pub use realize::Way;

/// A functional whose weights have settled.
#[derive(Clone, Debug)]
pub struct Functional {
    /// N: the window has N+1 samples.
    pub steps: usize,
    /// Whole samples of delay, per output.
    pub delays: Vec<usize>,
    /// What else is known at each sample.
    pub signals: Vec<Signal>,
    /// K, per output.
    pub outputs: Vec<Weights>,
    /// M, per signal.
    pub knowns: Vec<Weights>,
    /// c, n: what the constant terms of the plant add.
    pub constant: Vec<Settled>,
    /// How the next measurement is predicted, per output.
    pub prediction: Vec<Prediction>,
    /// Where measurements may come at irregular times.
    pub gaps: Option<Gaps>,
    /// Where the estimate is of the samples that are there, and not of all.
    pub irregular: Option<irregular::Irregular>,
    /// How a step computes it.
    pub way: Way,
    /// Further windows over the same stored samples, shortest first, each longer than this one.
    pub longer: Vec<Self>,
}

impl Functional {
    /// N of the longest window: what the rings hold.
    pub fn longest(&self) -> usize {
        self.longer.last().map_or(self.steps, |longer| longer.steps)
    }

    /// Every window, shortest first.
    pub fn windows(&self) -> impl Iterator<Item = &Self> {
        std::iter::once(self).chain(&self.longer)
    }
}

/// Measurements at irregular times: a prediction stands in between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gaps {
    /// Samples from one measurement to the next, at most.
    pub most: usize,
    /// Calls until the error has died out.
    pub settled: usize,
}

/// The weights of one signal by age; `None` marks a structural zero.
#[derive(Clone, Debug)]
pub struct Weights {
    /// The age in calls of the first weight.
    pub first: usize,
    /// One column per state: the weights by age, or nothing.
    pub columns: Vec<Option<Vec<Settled>>>,
}

impl Weights {
    /// The ages in calls that have a weight.
    pub fn ages(&self) -> Range<usize> {
        let len = self.columns.iter().flatten().map(Vec::len).max().unwrap_or(0);
        self.first..self.first + len
    }

    /// The weight of a state at an age; zero where there is none.
    pub fn at(&self, state: usize, age: usize) -> Settled {
        let place = age.checked_sub(self.first);
        let column = self.columns[state].as_ref();
        place.and_then(|place| column?.get(place).copied()).unwrap_or_default()
    }

    /// Sum of magnitudes over the ages.
    pub fn l1(&self, state: usize) -> f64 {
        self.columns[state].iter().flatten().map(|w| w.double.abs()).sum()
    }

    /// Sum of squares over the ages.
    pub fn sum_of_squares(&self, state: usize) -> f64 {
        self.columns[state].iter().flatten().map(|w| w.double * w.double).sum()
    }
}

/// One output of the one-step prediction; `None` marks a structural zero.
///
/// Without delay: `y_{k+1} = (C Phi) x_k + sum over the signals`. With a delay of d samples:
/// `y_{k+d} = C x_k`.
#[derive(Clone, Debug)]
pub struct Prediction {
    /// C Phi, or C for a delayed output; per state.
    pub states: Vec<Option<Settled>>,
    /// Per signal: the whole effect of a value that is held over the step.
    pub held: Vec<Option<Settled>>,
    /// Per signal: the part of the value at the end of the step.
    pub end: Vec<Option<Settled>>,
    /// What the constant terms add.
    pub constant: Settled,
}

impl Estimator for Functional {
    fn lower(&self, plant: &Plant, ahead: Option<&Ahead>, promised: &Certificate) -> Result<Program, Vec<Diagnostic>> {
        lower::lower(plant, self, ahead, promised)
    }

    fn between(&self) -> Between {
        let curves = self.signals.iter().any(|signal| signal.part == Part::Curves);
        if curves { Between::Cubics } else { Between::Lines }
    }

    fn unbounded(&self, promised: &Certificate) -> &'static str {
        let moves =
            self.irregular.as_ref().is_some_and(|it| self.gaps.is_some() || it.ages.iter().any(Option::is_some));
        if moves && promised.error_bound_with_losses.iter().any(Option::is_some) {
            "the gains are of regular gaps; whenever samples come, the bound is that with samples lost"
        } else if moves {
            "no error bound: it depends on when samples come; the gains are of regular gaps"
        } else if self.gaps.is_some() {
            "no error bound: what enters between measurements is carried on"
        } else {
            "no error bound: the slope of a nonlinear term is not bounded over the declared ranges"
        }
    }
}
