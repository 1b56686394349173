//! The impulsive observer: two copies of what is not measured, set to a common value every N samples.
//!
//! Knows the plant at its samples, its gain and its period. Never knows what a sensor is like, nor another estimator.
//!
//! In coordinates (y, `x_r`) with the outputs first (001 (3)-(4)), z1 estimates `x_r` and z2 estimates `x_r` + L y. Both
//! start with the same error; one carries it by P, the other by Q, so that after N samples their difference tells
//! it, and the reset takes it away (001 (9), with `t_(k+1)` where `t_k` is printed):
//!
//! `z1 = z1- + X (z1- - z2- + L y), z2 = z1 + L y, X = P (Q - P)^-1 = R1 - I = -R2`.
//!
//! 001 starts both copies at the same z; here z2 starts at z + L y, which is 001's z2 plus `Q L y_k` at the next
//! reset, and takes the place of its term `E^-1 L y(t_k) = X Q L y(t_k)`: the same estimate, one memory less, and
//! the difference of the copies is small once they have converged, so that its digits are not lost.
//!
//! [`exact`] has the numbers at one precision, [`settle`] rounds them once, [`gain`] searches for L. [`errors`] is how
//! the errors move, [`proof`] what follows from it when only every g-th sample is measured ([`slopes`], [`theorem`]).
//! [`certificate`] sums up, [`guard`] bounds what may enter, and [`lower`] writes the step.

pub mod certificate;
pub mod errors;
pub mod exact;
pub mod gain;
pub mod guard;
pub mod known;
pub mod lower;
pub mod proof;
pub mod settle;
pub mod size;
pub mod slopes;
pub mod theorem;
mod weights;

use crate::diagnostic::Diagnostic;
use crate::estimator::Estimator;
use crate::plant::Plant;
use crate::program::Program;
use crate::promise::Certificate;
use crate::sampled::model::Between;
use crate::sampled::settled::Settled;
use crate::step::ahead::Ahead;
use known::Known;

/// Which of the two discretisations the copies are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Of the sampled plant: exact for linear plants at any sample time (window-observers, section 2).
    Exact,
    /// 001's differential equations (5)-(9), with the outputs running between samples as [`Between`] says.
    Continuous,
}

/// How many calls make up what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Calls {
    /// N: from one reset to the next.
    pub period: usize,
    /// g: from one measurement to the next; divides N.
    pub every: usize,
    /// Before the copies start, so that the polynomials have their samples; a multiple of g.
    pub warm_up: usize,
    /// From the first sample to convergence: the warm-up and whole periods.
    pub converged: usize,
}

/// Settled entries, row-major; `None` marks a structural zero.
pub type Grid = Vec<Vec<Option<Settled>>>;

/// The update of one part of the state from call to call: a weighted sum of z1 or z2 and of what is known.
#[derive(Clone, Debug)]
pub struct Update {
    /// Of the copy that drives it.
    pub copy: Grid,
    /// Of the outputs, by age in calls from 0.
    pub outputs: Vec<Grid>,
    /// Of what else is known: per [`Known`] a column per age in calls from 0.
    pub knowns: Vec<Vec<Vec<Option<Settled>>>>,
    /// Of the constant terms.
    pub constant: Vec<Option<Settled>>,
}

/// The observer, settled.
#[derive(Clone, Debug)]
pub struct Impulsive {
    /// Counts.
    pub calls: Calls,
    /// Which discretisation.
    pub form: Form,
    /// How signals run between samples.
    pub between: Between,
    /// Places of the plant's states that make up `x_r`.
    pub rest: Vec<usize>,
    /// What is known besides the outputs.
    pub knowns: Vec<Known>,
    /// z1, from z1.
    pub first: Update,
    /// z2, from z2.
    pub second: Update,
    /// The outputs, from z1: 001's w.
    pub predictor: Update,
    /// L, (n-p) x p.
    pub gain: Grid,
    /// X, (n-p) x (n-p).
    pub reset: Grid,
    /// T^-1, n x n: the plant's states from (y, z1).
    pub back: Grid,
}

impl Estimator for Impulsive {
    fn lower(&self, plant: &Plant, ahead: Option<&Ahead>, promised: &Certificate) -> Result<Program, Vec<Diagnostic>> {
        lower::lower(plant, self, ahead, promised)
    }

    fn between(&self) -> Between {
        self.between
    }

    fn outputs_run(&self) -> bool {
        self.form == Form::Continuous
    }

    fn unbounded(&self, _promised: &Certificate) -> &'static str {
        if self.calls.every > 1 {
            "no error bound: between measurements, an error goes through the nonlinear terms again and again"
        } else {
            "no error bound: the slope of a nonlinear term is not bounded over the declared ranges"
        }
    }
}
