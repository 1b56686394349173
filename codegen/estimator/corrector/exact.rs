//! The observer at one precision.

use nalgebra::DMatrix;

use super::chain::Chain;
use super::law::Rows;
use super::sliding::ExactSliding;
use super::{Counting, interval};
use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, inverse};
use crate::sampled::model::Model;

/// What a method's keys say of the gain, at one precision.
#[derive(Clone, Debug)]
pub enum Law {
    /// K, n x p, in the plant's states.
    Constant(Matrix),
    /// kappa, n x 1, the same at every call.
    Kappa(Matrix),
    /// K of calls 1, 2, …, n x p each, in the plant's states.
    Table(Vec<Matrix>),
    /// K of the calls of a cycle, n x p each, in the plant's states.
    Periodic(Vec<Matrix>),
    /// `r^n c_i` by powers of r.
    Countdown(Rows),
    /// The robust exact differentiator's.
    Sliding(ExactSliding),
}

/// What a step computes, at one precision.
#[derive(Clone, Debug)]
pub struct Exact {
    /// The sampled plant.
    pub model: Model,
    /// M and q, where the law is of the chain.
    pub chain: Option<Chain>,
    /// The gain.
    pub law: Law,
    /// K after a handover, n x p.
    pub handover: Option<Matrix>,
    /// `xi = M^-1 x` of the states' `initial` without the measured ones, where the step carries xi; n x 1.
    pub start: Option<Matrix>,
    /// `M^-1`, where such a step can start from a given state.
    pub entry: Option<Matrix>,
}

impl Law {
    /// Whether it is a law of the chain's coordinates.
    pub fn needs_chain(&self) -> bool {
        matches!(self, Self::Kappa(_) | Self::Countdown(_) | Self::Sliding(_))
    }

    /// K of a call with `left` steps left, of call `lead - left`, or of that place of a cycle; in doubles.
    pub fn gain(&self, exact: &Exact, counting: Counting, left: usize) -> DMatrix<f64> {
        let spread = |kappa: &[f64]| {
            let chain = exact.chain.as_ref().unwrap_or_else(|| unreachable!("a law of the chain has one"));
            chain.m.doubles() * DMatrix::from_column_slice(kappa.len(), 1, kappa) + chain.q.doubles()
        };
        match self {
            Self::Constant(gain) => gain.doubles(),
            // Up to an innovation of c_n, which is what the certificate is of; `sliding::Backward` has the rest.
            Self::Sliding(law) => spread(&vec![1.0; law.ratios.len() + 1]),
            Self::Kappa(kappa) => spread(&kappa.iter().map(Real::to_f64).collect::<Vec<_>>()),
            Self::Periodic(rows) => rows[left % rows.len()].doubles(),
            Self::Table(rows) => rows[(counting.steps - left).max(1) - 1].doubles(),
            Self::Countdown(rows) => {
                let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.iter().map(Real::to_f64).collect()).collect();
                spread(&super::law::kappa(&rows, crate::numbers::count(left)))
            }
        }
    }
}

impl Exact {
    /// The observer for a law; `scaled` says that the step carries the chain's coordinates.
    ///
    /// # Errors
    /// What sampling reports, or that the outputs do not show every state.
    pub fn new(
        plant: &Plant,
        model: Model,
        (law, handover): (Law, Option<Matrix>),
        scaled: bool,
        precision: Precision,
    ) -> Result<Self, Vec<Diagnostic>> {
        let chain = if law.needs_chain() || scaled {
            Some(
                Chain::new(&interval::transition(plant, &model.phi), &model.c)
                    .map_err(|error| super::design::no_chain(plant, &error.to_string()))?,
            )
        } else {
            None
        };
        let (start, entry) = match &chain {
            Some(chain) if scaled => {
                let back = inverse(&chain.m).map_err(|error| super::design::no_chain(plant, &error.to_string()))?;
                (Some(start(plant, &back, precision)), plant.init_at.then_some(back))
            }
            _ => (None, None),
        };
        Ok(Self { model, chain, law, handover, start, entry })
    }

    /// Plant states from the coordinates that the step carries, and those from these; in doubles, n x n.
    pub fn frame(&self) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
        match (&self.chain, &self.start) {
            (Some(chain), Some(_)) => Some((chain.m.doubles(), inverse(&chain.m).ok()?.doubles())),
            _ => {
                let n = self.model.phi.rows();
                Some((DMatrix::identity(n, n), DMatrix::identity(n, n)))
            }
        }
    }

    /// The sums of magnitudes that a gain is made of, in the coordinates that the step carries: `|M| kappa + |q|` where
    /// the step computes it as `M kappa + q`.
    pub fn made_of(&self, carried: &DMatrix<f64>, gain: &DMatrix<f64>) -> DMatrix<f64> {
        match (&self.chain, &self.start, &self.law) {
            (Some(chain), None, Law::Countdown(_) | Law::Sliding(_)) => {
                let (m, q) = (chain.m.doubles(), chain.q.doubles());
                let kappa =
                    m.clone().lu().solve(&(gain - &q)).unwrap_or_else(|| DMatrix::from_element(q.len(), 1, 1.0));
                m.abs() * kappa.abs() + q.abs()
            }
            _ => (carried * gain).abs(),
        }
    }

    /// Into the coordinates that the step carries: the identity, or `M^-1`.
    pub fn into_frame(&self, gain: &Matrix) -> Option<Matrix> {
        match (&self.chain, &self.start) {
            (Some(chain), Some(_)) => Some(&inverse(&chain.m).ok()? * gain),
            _ => Some(gain.clone()),
        }
    }
}

fn start(plant: &Plant, back: &Matrix, precision: Precision) -> Matrix {
    let n = plant.states.len();
    let initial = Matrix::from_fn(n, 1, |i, _| {
        let state = &plant.states[i];
        let value = if state.measured.is_empty() { state.initial.evaluate(precision).ok() } else { None };
        value.unwrap_or_else(|| Real::zero(precision))
    });
    back * &initial
}
