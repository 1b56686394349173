//! The shape "regression over the last N samples": unknown constants whose gammas vary, found in the step.
//!
//! With x(w0) the state at the window's start and all responses from zero there, 002 (16) reads for samples
//!
//! `y_j = C Phi^j x(w0) + C r_j + sum_i eps_i C p_ij`,
//!
//! r the response to everything known, `p_i` that to `gamma_i`. The columns `C Phi^j` are orthonormalised
//! offline (`o_j = C Phi^j R^-1`), so that E of 002 (2) is the identity; what is left of the `p_i` outside them,
//! `e_i = C p_i - o c_i`, has 002's Schur complement as its Gramian, `S = sum e e'`, and
//! `S eps = sum e (y - C r)`. S is summed, not subtracted, so that single precision keeps its digits.
//!
//! [`exact`] has the numbers, [`bound`] what may enter, [`mod@excitation`] what is known offline of S,
//! [`lower`] the Program. A sample that is missing is predicted, as in every window method; a row could as
//! well be left out of the sums, by a factor per row.

pub mod bound;
pub mod exact;
pub mod excitation;
pub mod lower;
mod rounding;

use crate::diagnostic::Diagnostic;
use crate::estimator::Estimator;
use crate::estimator::window::Functional;
use crate::plant::Plant;
use crate::program::Program;
use crate::promise::Certificate;
use crate::sampled::settled::Settled;
use crate::step::ahead::Ahead;

/// The most unknowns whose gammas vary: the equations are written out.
pub const MOST: usize = 6;

/// A constant, or a structural zero.
pub type Entry = Option<Settled>;

/// A regression whose constants have settled.
#[derive(Clone, Debug)]
pub struct Regression {
    /// The window, its signals and the predictions of what is not a regressor; it has no weights.
    pub carrier: Functional,
    /// Place among the plant's states, per state of the regression (n): its own, then the unknowns that are columns of A.
    pub states: Vec<usize>,
    /// How many of these are the plant's own: the others stay at the window's start, and no response reaches them.
    pub own: usize,
    /// Place among the plant's states, per unknown (q).
    pub unknowns: Vec<usize>,
    /// Per unknown: its value over that in the step, a power of two; responses are of order one there.
    pub scales: Vec<f64>,
    /// Phi, n x n.
    pub phi: Vec<Vec<Entry>>,
    /// What drives r.
    pub known: Drive,
    /// What drives each p.
    pub gammas: Vec<Drive>,
    /// What the samples of each output count by, at most 1.
    pub trust: Vec<Settled>,
    /// Trust times C, p x n.
    pub shown: Vec<Vec<Entry>>,
    /// o by sample from the window's start: p x n each, 0 where a late output has not arrived.
    pub rows: Vec<Vec<Vec<Settled>>>,
    /// `Phi^N R^-1`, n x n.
    pub through: Vec<Vec<Entry>>,
    /// Per output, signal, unknown: what the signal's value adds to the next measurement.
    pub held: Vec<Vec<Vec<Entry>>>,
    /// Likewise, of the value at the step's end.
    pub end: Vec<Vec<Vec<Entry>>>,
    /// The smallest share of a regressor's energy that the state cannot explain.
    pub threshold: f64,
    /// Per unknown: 25 times the energy that noise of the declared size gives its regressor.
    pub floors: Vec<f64>,
}

/// What drives a response over one sample interval.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Per signal, n: times the value that the interval's first call brought.
    pub begin: Vec<Vec<Entry>>,
    /// Per signal, n: times the value that its last call brought.
    pub end: Vec<Vec<Entry>>,
    /// n.
    pub constant: Vec<Entry>,
}

impl Estimator for Regression {
    fn lower(&self, plant: &Plant, _ahead: Option<&Ahead>, promised: &Certificate) -> Result<Program, Vec<Diagnostic>> {
        lower::lower(plant, self, promised)
    }

    fn proviso(&self) -> &'static str {
        "as far as the signals excite the unknowns"
    }

    fn no_gains(&self) -> Option<&'static str> {
        Some("no gains from noise: they depend on how far the signals excite the unknowns")
    }
}
