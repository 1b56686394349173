//! What is promised of an estimate: certificates with their kernels, how an observer converges, how the arithmetic went.
//!
//! Knows the plant at its samples and finished Programs. Never knows how an estimate comes from samples, nor a step's text.

pub mod kernel;
pub mod one_count;
pub mod rounding;
pub mod vouched;

/// A matrix of the design under the field's letter, row-major.
#[derive(Clone, Debug)]
pub struct NamedMatrix {
    /// `Phi`, `Gamma`, …
    pub letter: &'static str,
    /// Nearest doubles.
    pub rows: Vec<Vec<f64>>,
}

/// The window functional for reports: `x_k = sum_j K[j] y_{k-j} + M[j] w_{k-j} + c`.
#[derive(Clone, Debug)]
pub struct Fir {
    /// The columns of M: inputs and nonlinear injections.
    pub known: Vec<String>,
    /// n x p for age 0 … N.
    pub k: Vec<Vec<Vec<f64>>>,
    /// n x known for age 0 … N.
    pub m: Vec<Vec<Vec<f64>>>,
    /// n: what the constant terms of the plant add.
    pub c: Vec<f64>,
}

/// What is promised of the estimate.
#[derive(Clone, Debug, Default)]
pub struct Certificate {
    /// Largest error per unit of bounded noise: per state, per output.
    pub noise_gain_l1: Vec<Vec<f64>>,
    /// Standard deviation per unit of white noise: per state, per output.
    pub noise_gain_l2: Vec<Vec<f64>>,
    /// Largest error per unit of a bounded disturbance: per state, per disturbance.
    pub disturbance_gain_l1: Vec<Vec<f64>>,
    /// Per state, for the declared noise and disturbances; `None` where a bound is missing.
    pub error_bound: Vec<Option<f64>>,
    /// Error left at the promised step per unit of error at the first sample: per state, per state. Empty where nothing
    /// is left.
    pub initial_gain: Vec<Vec<f64>>,
    /// Per state, the most that rounding in single precision adds, in the state's unit: for samples within their declared
    /// range, or up to 1 where none is declared, and inputs up to 1; in proportion for larger ones. Empty in double
    /// precision, and where there is no such bound.
    pub rounding: Vec<f64>,
    /// Per state: the bound that the status keeps whatever samples are lost, for the declared noise and disturbances;
    /// `None` where a bound is missing. Empty where nothing is left out.
    pub error_bound_with_losses: Vec<Option<f64>>,
    /// Per output, where samples are left out and there are several: the error bound while it alone is lost, per state;
    /// `None` where the others do not determine the state. Empty elsewhere.
    pub error_bound_without: Vec<Option<Vec<Option<f64>>>>,
}

/// How the estimate comes to its bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Convergence {
    /// Exact from the design's `valid_from_step` on, whatever the initial state.
    Finite,
    /// By a factor each period; the design's `valid_from_step` is when [`CONTRACTED`] of the initial error is left.
    Geometric {
        /// Spectral radius of the linear part's error map over one period.
        radius: f64,
        /// Samples of that period.
        period: usize,
    },
    /// When the status says so: after this many calls in a row whose innovations are explained, whenever that is.
    Sensed {
        /// The calls.
        calls: usize,
        /// The largest explained innovation, in units of the output.
        innovation: f64,
    },
    /// At the design's `valid_from_step`, to what the gains leave of it.
    Prescribed {
        /// Of the worst initial error, in the root mean square of what it does to the outputs until then.
        left: f64,
    },
}

/// What is left of an initial error when a geometric convergence counts as done.
pub const CONTRACTED: f64 = 1e-6;

/// A way to compute the step, with what it would cost and whether it may run.
#[derive(Clone, Debug)]
pub struct Realization {
    /// As the user names it.
    pub name: &'static str,
    /// Numbers of state.
    pub words: usize,
    /// Additions and multiplications of the estimate, per step.
    pub flops: usize,
    /// Constants in tables.
    pub constants: usize,
    /// Why it may run, or the number that forbids it.
    pub verdict: Result<String, String>,
}

/// Gains from the noise of the measurements at the calls of one phase; each per state and output.
#[derive(Clone, Debug)]
pub struct Phase {
    /// Largest error per unit of bounded noise.
    pub noise_gain_l1: Vec<Vec<f64>>,
    /// Standard deviation per unit of white noise.
    pub noise_gain_l2: Vec<Vec<f64>>,
}

/// What is promised of the estimate of one of several windows.
#[derive(Clone, Debug)]
pub struct OfWindow {
    /// N: the window has N+1 samples.
    pub steps: usize,
    /// Of its estimate.
    pub certificate: Certificate,
}
