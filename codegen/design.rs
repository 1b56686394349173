//! The design: constants in exact arithmetic, with what is promised of them.
//!
//! In: a plant and a method's keys. Out: constants that have settled (the same double at d and at
//! 2d digits), a certificate, the arithmetic's own record, and the shape that the step will take.
//! A Design knows no language.

use crate::ahead::Ahead;
use crate::baseline::{self, Baseline};
use crate::corrector::{self, Corrector};
use crate::diagnostic::Diagnostic;
use crate::expr::Symbol;
use crate::impulsive::{self, Form, Impulsive};
use crate::plant::Plant;
use crate::program::{Program, Scalar};
use crate::real::Real;
use crate::regression::{self, Regression};
use crate::window::model::Between;
use crate::window::{self, Functional, Part};

/// A constant after its one rounding, in both float types.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settled {
    /// The nearest double.
    pub double: f64,
    /// The nearest single.
    pub single: f32,
}

impl Settled {
    /// Rounds once to each type.
    pub fn round(value: &Real) -> Self {
        Self { double: value.to_f64(), single: value.to_f32() }
    }

    /// As the step carries it.
    pub fn value(self, scalar: Scalar) -> f64 {
        match scalar {
            Scalar::F32 => f64::from(self.single),
            Scalar::F64 => self.double,
        }
    }
}

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
}

/// How the arithmetic went.
#[derive(Clone, Copy, Debug, Default)]
pub struct Numerics {
    /// Decimal digits of the coarser run.
    pub digits: usize,
    /// Decimal digits to which both runs agree, over all constants.
    pub agreement: f64,
    /// Of the observability matrix with columns scaled to one.
    pub condition: f64,
    /// Largest entry of `acc_{N+1}` against its history; 0 in exact arithmetic.
    pub unbiasedness: f64,
}

/// How the estimate comes to its bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Convergence {
    /// Exact from [`Design::valid_from_step`] on, whatever the initial state.
    Finite,
    /// By a factor each period; [`Design::valid_from_step`] is when [`CONTRACTED`] of the initial error is left.
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
    /// At [`Design::valid_from_step`], to what the gains leave of it.
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

/// A design, complete.
#[derive(Clone, Debug)]
pub struct Design {
    /// The method's name.
    pub method: &'static str,
    /// How the step is realised.
    pub realization: &'static str,
    /// What the method does here, in one line.
    pub summary: String,
    /// Window length in samples, N.
    pub window_steps: usize,
    /// The first step (from 0) whose estimate is within its bound.
    pub valid_from_step: usize,
    /// How it comes to its bound.
    pub convergence: Convergence,
    /// All realisations that the method knows, the chosen one first; empty where there is but one.
    pub realizations: Vec<Realization>,
    /// What the method's own theorem says of this plant, a line each: conditions, bounds, rates.
    pub notes: Vec<String>,
    /// For reports.
    pub constants: Vec<NamedMatrix>,
    /// For reports.
    pub fir: Option<Fir>,
    /// What is promised.
    pub certificate: Certificate,
    /// How the arithmetic went.
    pub numerics: Numerics,
    /// What the user should look at.
    pub warnings: Vec<Diagnostic>,
    /// What the step computes.
    pub shape: Shape,
}

/// The shapes that methods lower to.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A functional over the last N samples.
    Window(Box<Functional>),
    /// A regression over the last N samples.
    Regression(Box<Regression>),
    /// Two copies, reset every N calls.
    Impulsive(Box<Impulsive>),
    /// Predict and correct.
    Corrector(Box<Corrector>),
    /// A signal and its rate without a model.
    Baseline(Box<Baseline>),
}

impl Shape {
    /// How nonlinear terms run between samples.
    pub fn between(&self) -> Between {
        match self {
            Self::Window(functional) if functional.signals.iter().any(|s| s.part == Part::Curves) => Between::Cubics,
            Self::Impulsive(design) => design.between,
            Self::Window(_) | Self::Regression(_) | Self::Corrector(_) | Self::Baseline(_) => Between::Lines,
        }
    }
}

impl Design {
    /// What a certificate leaves out: how what varies is taken to run between samples, and of which order that is;
    /// `None` where nothing is.
    pub fn between_samples(&self, plant: &Plant) -> Option<String> {
        let varies = |symbol: &Symbol| !matches!(symbol, Symbol::Input(_));
        let enters = |i: &&crate::plant::Injection| i.column.iter().any(|entry| !entry.is_zero());
        let terms = !plant.discrete && plant.injections.iter().filter(enters).any(|i| i.symbols().iter().any(varies));
        let outputs = matches!(&self.shape, Shape::Impulsive(design) if design.form == Form::Continuous);
        let what = match (outputs, terms) {
            (false, false) => return None,
            (false, true) => "nonlinear terms",
            (true, false) => "outputs",
            (true, true) => "outputs and nonlinear terms",
        };
        let how = match self.shape.between() {
            Between::Lines | Between::Steps => "straight lines between samples, second order",
            Between::Cubics => "cubics between samples, where no input jumps and no sample is missing fourth order",
        };
        Some(format!("{what} are {how} in the sample time"))
    }

    /// Why there is no error bound although the noise is declared; for the certificate.
    pub fn unbounded(&self) -> &'static str {
        match &self.shape {
            Shape::Window(functional)
                if functional
                    .irregular
                    .as_ref()
                    .is_some_and(|solve| functional.gaps.is_some() || solve.ages.iter().any(Option::is_some)) =>
            {
                "no error bound: it depends on when samples come; the gains are of regular gaps"
            }
            Shape::Window(functional) if functional.gaps.is_some() => {
                "no error bound: what enters between measurements is carried on"
            }
            Shape::Impulsive(design) if design.calls.every > 1 => {
                "no error bound: between measurements, an error goes through the nonlinear terms again and again"
            }
            Shape::Corrector(_) if self.certificate.noise_gain_l1.iter().flatten().any(|gain| gain.is_infinite()) => {
                "no error bound: what is left of the past dies out too slowly, or over too many calls, to be summed up"
            }
            _ => "no error bound: the slope of a nonlinear term is not bounded over the declared ranges",
        }
    }

    /// What is promised, of every window where there are several.
    pub fn certificates(&mut self) -> impl Iterator<Item = &mut Certificate> {
        let longer = match &mut self.shape {
            Shape::Window(functional) => functional.longer.as_mut_slice(),
            _ => &mut [],
        };
        std::iter::once(&mut self.certificate).chain(longer.iter_mut().map(|longer| &mut longer.certificate))
    }

    /// The step as a Program.
    pub fn lower(&self, plant: &Plant, ahead: Option<&Ahead>) -> Result<Program, Vec<Diagnostic>> {
        match &self.shape {
            Shape::Window(functional) => window::lower::lower(plant, functional, ahead),
            Shape::Regression(regression) => regression::lower::lower(plant, regression),
            Shape::Impulsive(design) => impulsive::lower::lower(plant, design, ahead),
            Shape::Corrector(design) => corrector::lower::lower(plant, design, ahead),
            Shape::Baseline(design) => baseline::lower::lower(plant, design, ahead),
        }
    }
}
