//! The shape "predict and correct": a state carried from call to call, corrected by each sample.
//!
//! Knows the plant at its samples and a law of gains. Never knows which method asks for the law, nor another estimator.
//!
//! `z- = Phi z + what is known, e = y - C z-, z = z- + K e`.
//!
//! Methods differ in K alone. A gain law is
//!
//! - a constant,
//! - a table with a row per call until the promised one,
//! - a table that goes round, for outputs at several rates, or
//! - a countdown: with r steps left to the prescribed time T = N h, the implicit Euler step of 003 (4) or 004 (7) in
//!   scaled coordinates has the injections `c_i = h^i g_i`, whose products `r^n c_i` are polynomials in r without
//!   negative coefficients ([`law`]). With `S_j = sum_(i>=j) c_i`, `kappa_j = S_j / (1 + S_1)` lies in (0, 1], takes
//!   one division, and is 1 at r = 0, where all that 003 (12), (13) are made of is infinite (prescribed-time-observers,
//!   section 0). [`chain`] takes it to any observable plant with one output: `K = M kappa + q` makes the error exactly M
//!   times the chain's, whatever the plant (section 3).
//! - sliding: kappa from the size of the innovation itself, by Levant's differentiator in implicit form.
//!
//! A new law is one function in [`law`] that gives its polynomials; a law of another kind is one variant of [`Gain`],
//! its gain by call in [`schedule`], and one function in `lower/gain.rs`.
//!
//! [`exact`] has the numbers at one precision, [`settle`] rounds them once, [`schedule`] has the gain of every call in
//! doubles for [`errors`] and [`certificate`], `rounds` and `past` follow gains that go round however slowly, [`guard`] bounds what may enter, [`lower`] writes the step.

pub mod certificate;
pub mod chain;
pub mod design;
pub mod deviation;
mod doubling;
pub mod errors;
pub mod exact;
mod far;
pub mod guard;
pub mod holloway_krstic;
pub mod implicit_euler;
pub mod interval;
pub mod law;
pub mod lower;
pub mod noise;
mod past;
pub mod periodic;
pub mod placement;
pub mod riccati;
pub mod rounding;
mod rounds;
pub mod schedule;
pub mod settle;
pub mod sliding;
pub mod theorem1;

use crate::diagnostic::Diagnostic;
use crate::estimator::Estimator;
use crate::plant::Plant;
use crate::plant::features::{Feature, Limit, POSITIONS, nonlinear_term};
use crate::program::Program;
use crate::promise::Certificate;
use crate::sampled::Signal;
use crate::sampled::settled::Settled;
use crate::step::ahead::Ahead;

/// Settled entries, row-major; `None` marks a structural zero.
pub type Grid = Vec<Vec<Option<Settled>>>;

/// What no method that predicts and corrects can take.
pub const LIMITS: &[Limit] = &[IN_BETWEEN, AGE, DELAY, LEFT_OUT, WINDOWS, POSITIONS];

/// The same with a law that gives as many numbers as there are states.
pub const OF_ONE_OUTPUT: &[Limit] = &[IN_BETWEEN, AGE, DELAY, ONE_OUTPUT, LEFT_OUT, WINDOWS, POSITIONS];

/// The same for chains of integrators, which have no nonlinear term.
pub const OF_A_CHAIN: &[Limit] = &[AGE, DELAY, ONE_OUTPUT, LEFT_OUT, WINDOWS, POSITIONS];

/// A nonlinear term must be known wherever it acts.
pub const IN_BETWEEN: Limit = Limit::new(
    Feature::Every,
    "the prediction of every call has the term in it, and no sample says what it is in between",
    "measure it at every call, or linearise the term",
)
.when("of an output in a nonlinear term", nonlinear_term);

/// A gain is of a sample taken at a call.
pub const AGE: Limit = Limit::new(
    Feature::Age,
    "its gain is of the age 0, and another age would need another gain",
    "use `window`, which takes samples of any age",
);

/// A correction is of now.
pub const DELAY: Limit = Limit::new(
    Feature::Delay,
    "it corrects the state now, and what a late sample shows is an earlier one, which is not kept",
    "use `window`, which takes late outputs",
);

/// A law of n numbers.
pub const ONE_OUTPUT: Limit = Limit::new(
    Feature::Outputs,
    "its law gives a number for each state, the gain of one output, and leaves open how several share in it",
    "keep the one that shows every state, or use `window` or `kalman`, which take any number",
);

/// Nothing that could be left out is kept.
pub const LEFT_OUT: Limit = Limit::new(
    Feature::LeftOut,
    "it keeps no samples, and a missing one is one correction less whatever is asked for",
    "leave it out, or use `window`",
);

/// A state that is carried on is of all samples.
pub const WINDOWS: Limit = Limit::new(
    Feature::Windows,
    "its estimate is carried on from the first sample, and no window ends it",
    "use `window`, or an observer for each speed",
);

/// The nearest way out for a method that needs a sample at every call.
pub const ONE_RATE: &str =
    "a `sample_time` from sample to sample, or `luenberger`, `kalman` or `window`, which take `every`";

/// What the gain does when the countdown has come to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum After {
    /// The last gain stays.
    Hold,
    /// The countdown starts again: 003 (21).
    Restart,
    /// A constant gain takes over.
    Handover,
}

/// The countdown: call k from the first sample on has r = N - k steps left, down to `stop`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counting {
    /// N: from the first sample to the prescribed time.
    pub steps: usize,
    /// The fewest steps left.
    pub stop: usize,
    /// What follows.
    pub after: After,
}

impl Counting {
    /// Of a constant gain.
    pub const NONE: Self = Self { steps: 0, stop: 0, after: After::Hold };

    /// Calls with a gain of their own, from the one after the first sample.
    pub fn lead(self) -> usize {
        self.steps - self.stop
    }
}

/// The coordinates that the step carries.
#[derive(Clone, Debug)]
pub enum Frame {
    /// The plant's states, predicted by the sampled plant.
    Plant {
        /// n x n.
        phi: Grid,
        /// Phi - I on its diagonal: what a state that is carried in two floats grows by.
        growth: Vec<Option<Settled>>,
        /// Of kappa into the states: M n x n and q n x 1; absent where the gain is of the states already.
        spread: Option<Spread>,
    },
    /// The scaled chain of integrators `xi_i = h^(i-1) x_i` in implicit Euler's coordinates: n-1 additions predict it.
    Chain {
        /// x from xi, n x n.
        readout: Grid,
        /// xi at the start but for the sample, n x 1.
        start: Vec<Option<Settled>>,
        /// xi from x, n x n, where the observer can start from a given state.
        entry: Option<Grid>,
    },
}

/// K = M kappa + q.
#[derive(Clone, Debug)]
pub struct Spread {
    /// n x n.
    pub m: Grid,
    /// n x 1.
    pub q: Vec<Option<Settled>>,
}

/// How the gain of a call is found.
#[derive(Clone, Debug)]
pub enum Gain {
    /// K, n x p, at every call.
    Constant(Grid),
    /// K of calls 1, 2, …, N - stop; n x p each.
    Table(Vec<Vec<Vec<Settled>>>),
    /// K of the calls of a cycle, over and over; n x p each.
    Periodic(Vec<Vec<Vec<Settled>>>),
    /// kappa from the steps left.
    Countdown(Polynomials),
    /// kappa from the size of the innovation.
    Sliding {
        /// The law's constants.
        law: sliding::Sliding,
        /// The largest innovation that noise and what the law allows for explain: after n within it the estimate counts as
        /// converged.
        calm: f64,
    },
}

/// `r'^n c_i` by powers of `r' = 2^-shift r`, for i = 1 … n; no entry is negative.
#[derive(Clone, Debug)]
pub struct Polynomials {
    /// The power of two that keeps all powers within the floats.
    pub shift: i64,
    /// Row i - 1: coefficients of `r'^0 … r'^n`.
    pub terms: Grid,
    /// The smallest `r'^n (1 + S_1)` of any call.
    pub smallest: f64,
    /// The largest.
    pub largest: f64,
}

/// The observer, settled.
#[derive(Clone, Debug)]
pub struct Corrector {
    /// What the state is.
    pub frame: Frame,
    /// What is known besides the outputs.
    pub signals: Vec<Signal>,
    /// Per signal: times its value at the interval's beginning, n x 1.
    pub at_begin: Vec<Vec<Option<Settled>>>,
    /// Per signal: times its value at the interval's end, n x 1.
    pub at_end: Vec<Vec<Option<Settled>>>,
    /// What the constant terms add, n x 1.
    pub constant: Vec<Option<Settled>>,
    /// C, p x n.
    pub output: Grid,
    /// K.
    pub gain: Gain,
    /// K after a handover, n x p, in the frame's coordinates.
    pub handover: Option<Grid>,
    /// Per coordinate, whether a second float carries what the first leaves out; see [`rounding`].
    pub twofold: Vec<bool>,
    /// The countdown.
    pub counting: Counting,
    /// Good calls after the first until the estimate counts as converged; of one output, its samples.
    pub valid: usize,
    /// Good calls in a row after a missing sample until it does again; at least 1.
    pub recovery: usize,
}

impl Estimator for Corrector {
    fn lower(&self, plant: &Plant, ahead: Option<&Ahead>, _promised: &Certificate) -> Result<Program, Vec<Diagnostic>> {
        lower::lower(plant, self, ahead)
    }

    fn recovery(&self) -> Option<usize> {
        Some(self.recovery)
    }

    fn unbounded(&self, promised: &Certificate) -> &'static str {
        if promised.noise_gain_l1.iter().flatten().any(|gain| gain.is_infinite()) {
            "no error bound: what is left of the past dies out too slowly, or over too many calls, to be summed up"
        } else {
            "no error bound: the slope of a nonlinear term is not bounded over the declared ranges"
        }
    }
}

impl Corrector {
    /// What a coordinate is predicted from: its row of Phi; of what it grows by, where two floats carry it.
    pub fn prediction(&self, phi: &Grid, growth: &[Option<Settled>], i: usize) -> Vec<Option<Settled>> {
        let mut row = phi[i].clone();
        if self.twofold[i] {
            row[i] = growth[i];
        }
        row
    }
}
