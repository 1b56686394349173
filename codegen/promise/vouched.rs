//! For how many calls the printed bound holds of a state that the caller vouches for, before samples have determined one.
//!
//! The model carries the given state, and takes over what the newest samples show where the estimate does. Its error is
//! a sum over what the given state was off by, what noise entered by and what disturbances did since: all of it is known
//! ahead of time, from above, for every call.

use nalgebra::{DMatrix, DVector};

use super::Certificate;
use super::kernel::Kernel;
use crate::expr::Symbol;
use crate::plant::{Injection, Plant, Vouched};

/// How long a state that was vouched for is within the bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trust {
    /// As long as the model runs.
    Always,
    /// For so many calls.
    Calls(u32),
}

impl Trust {
    /// Whether it ends while the model runs.
    pub fn ends(self) -> bool {
        self != Self::Always
    }
}

/// How the error of a state moves that starts with a given one. What is carried are m numbers.
#[derive(Clone, Debug)]
pub struct Run {
    /// From call to call, m x m.
    pub map: DMatrix<f64>,
    /// From an error of the given state, m x n.
    pub start: DMatrix<f64>,
    /// What enters at a call, a column for each cause, times its bound; m rows.
    pub enters: DMatrix<f64>,
    /// From what disturbs the plant's states until a call, m x n.
    pub disturbed: DMatrix<f64>,
    /// The error of the answer, n x m.
    pub shown: DMatrix<f64>,
}

impl Run {
    /// For how many of the first `most` calls the bound holds. Given states are exact where the specification says so;
    /// else they are off by the bound at most, as an answer with the status `Converged` is.
    pub fn trust(&self, plant: &Plant, promised: &Certificate, most: usize) -> Trust {
        let bound = |i: usize| promised.error_bound.get(i).copied().flatten();
        let bounds: Vec<Option<f64>> = (0..plant.states.len()).map(bound).collect();
        let disturbed = !plant.disturbances.is_empty();
        if bounds.iter().all(|bound| bound.is_none_or(|bound| bound <= 0.0)) && !disturbed {
            // Nothing that is declared makes an error.
            return Trust::Always;
        }
        // Terms of the call before are then of outputs that are off by as much as the given state shows.
        let through = plant.vouched == Vouched::Bounded && plant.injections.iter().any(depends_on_states);
        let bounded = bounds.iter().any(Option::is_some) && !through;
        let Some(kernel) = Kernel::new(plant).filter(|_| bounded) else { return Trust::Calls(0) };
        let off = DVector::from_iterator(bounds.len(), bounds.iter().map(|bound| bound.unwrap_or(0.0)));
        let off = if plant.vouched == Vouched::Exact { off * 0.0 } else { off };
        let levels: Vec<f64> = plant.disturbances.iter().map(|d| d.bound.to_f64().unwrap_or(f64::INFINITY)).collect();
        let (mut rows, mut entered) = (self.shown.clone(), DVector::<f64>::zeros(bounds.len()));
        let mut gains = DMatrix::zeros(bounds.len(), levels.len());
        for call in 0..most {
            entered += (&rows * &self.enters).abs().column_sum();
            kernel.add(&(&rows * &self.disturbed), &mut gains);
            rows *= &self.map;
            let error = (&rows * &self.start).abs() * &off + &entered + &gains * DVector::from_column_slice(&levels);
            let within = |(error, bound): (&f64, &Option<f64>)| bound.is_none_or(|bound| *error <= bound * SLACK);
            if !error.iter().zip(&bounds).all(within) {
                return Trust::Calls(u32::try_from(call).unwrap_or(u32::MAX));
            }
        }
        Trust::Calls(u32::try_from(most).unwrap_or(u32::MAX))
    }
}

fn depends_on_states(injection: &Injection) -> bool {
    injection.symbols().iter().any(|symbol| matches!(symbol, Symbol::State(_)))
}

/// For the rounding of sums.
const SLACK: f64 = 1.0 + 1e-9;
