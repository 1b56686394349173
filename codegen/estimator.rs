//! The design: constants in exact arithmetic, with what is promised of them, and the estimator that they make.
//!
//! Knows the plant, its samples, what is promised and how a step is written. Never knows the methods that ask for it;
//! an estimator never knows another one.

pub mod baseline;
pub mod copies;
pub mod corrector;
pub mod window;

use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Symbol;
use crate::numbers::short;
use crate::plant::{Injection, Plant};
use crate::program::Program;
use crate::promise::{Certificate, Convergence, Fir, NamedMatrix, OfWindow, Phase, Realization};
use crate::sampled::model::Between;
use crate::sampled::settle::Numerics;
use crate::step::ahead::Ahead;

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
    /// Likewise of each longer window where there are several, shortest first.
    pub longer: Vec<OfWindow>,
    /// Gains at each phase, where outputs are measured at rates of their own.
    pub phases: Vec<Phase>,
    /// How the arithmetic went.
    pub numerics: Numerics,
    /// What the user should look at.
    pub warnings: Vec<Diagnostic>,
    /// How the estimate comes from samples.
    pub estimator: Arc<dyn Estimator>,
}

/// How an estimate comes from samples. It knows nothing of sensors: what is read, guarded and reported is the step's.
pub trait Estimator: Any + Debug + Send + Sync {
    /// The step as a Program; `ahead` moves its answer, and what is `promised` says how long a given state is trusted.
    ///
    /// # Errors
    /// Constants that the target's floats cannot hold.
    fn lower(&self, plant: &Plant, ahead: Option<&Ahead>, promised: &Certificate) -> Result<Program, Vec<Diagnostic>>;

    /// How nonlinear terms are taken to run between samples.
    fn between(&self) -> Between {
        Between::Lines
    }

    /// Whether outputs are taken to run so too.
    fn outputs_run(&self) -> bool {
        false
    }

    /// Good calls in a row after a missing sample until the estimate is not coasting, where that is no window's length.
    fn recovery(&self) -> Option<usize> {
        None
    }

    /// What a finite convergence depends on, behind "from call N, ".
    fn proviso(&self) -> &'static str {
        "whatever the initial state"
    }

    /// Why there are no gains from noise, where there are none.
    fn no_gains(&self) -> Option<&'static str> {
        None
    }

    /// Why there is no error bound although the noise is declared.
    fn unbounded(&self, _promised: &Certificate) -> &'static str {
        "no error bound: the slope of a nonlinear term is not bounded over the declared ranges"
    }
}

impl dyn Estimator {
    /// The estimator itself, where it is of this kind.
    pub fn downcast_ref<T: Estimator>(&self) -> Option<&T> {
        (self as &dyn Any).downcast_ref()
    }
}

impl Design {
    /// What a certificate leaves out: how what varies is taken to run between samples, and of which order that is;
    /// `None` where nothing is.
    pub fn between_samples(&self, plant: &Plant) -> Option<String> {
        let varies = |symbol: &Symbol| !matches!(symbol, Symbol::Input(_));
        let enters = |i: &&Injection| i.column.iter().any(|entry| !entry.is_zero());
        let terms = !plant.discrete && plant.injections.iter().filter(enters).any(|i| i.symbols().iter().any(varies));
        let what = match (self.estimator.outputs_run(), terms) {
            (false, false) => return None,
            (false, true) => "nonlinear terms",
            (true, false) => "outputs",
            (true, true) => "outputs and nonlinear terms",
        };
        let how = match self.estimator.between() {
            Between::Lines | Between::Steps => "straight lines between samples, second order",
            Between::Cubics => "cubics between samples, where no input jumps and no sample is missing fourth order",
        };
        Some(format!("{what} are {how} in the sample time"))
    }

    /// States that rounding moves further than noise and disturbances do.
    pub fn rounded(&self, plant: &Plant) -> Vec<Diagnostic> {
        let both = self.certificate.error_bound.iter().zip(&self.certificate.rounding).zip(&plant.states);
        let more = both.filter_map(|((bound, rounding), state)| Some((bound.as_ref()?, rounding, state)));
        let more = more.filter(|(bound, rounding, _)| **bound > 0.0 && rounding > bound);
        let each = more.map(|(bound, rounding, state)| {
            let message = format!("rounding in f32 may move `{}` further than its noise does", state.label.name);
            let label = format!("by up to {}, noise by up to {}", short(*rounding), short(*bound));
            let warning = Diagnostic::warning(codes::ROUNDING, state.label.span.clone(), message).label(label);
            let other = if self.realizations.len() > 1 && self.realization != "fir" {
                ", or `realization = \"fir\"`"
            } else {
                ""
            };
            let help = format!("write `scalar = \"f64\"`, or the `range` that samples really have{other}");
            warning.measured(*rounding).help(help)
        });
        each.collect()
    }

    /// The promises as those of the answer moved by `ahead`.
    pub fn moved(&mut self, plant: &Plant, ahead: &Ahead) {
        let longer = self.longer.iter_mut().map(|window| &mut window.certificate);
        std::iter::once(&mut self.certificate).chain(longer).for_each(|certificate| ahead.certify(plant, certificate));
        for phase in &mut self.phases {
            ahead.carry(&mut phase.noise_gain_l1);
            ahead.carry(&mut phase.noise_gain_l2);
        }
        self.notes.push(ahead.note());
    }
}
