//! What a realisation needs of a window functional: its innovation form, read from the window's start.
//!
//! With `V_j` the weight of the innovation of age j in a window of a+1 samples, and i = a - j its place from
//! the window's start, `V_j = P_a F^j G = (P_a F^a) (F^-i G)`: the samples enter a statistic by rows that
//! depend on their place alone, and the read-out depends on the window's length alone. For least squares
//! `F^-1 = Phi^T`, so that no inverse of Phi is taken and the rows are the plant's own `C Phi^i`.

use std::ops::Range;

use crate::real::{Matrix, Singular, inverse};

use super::super::innovation::{Innovation, trust};
use crate::sampled::model::Model;

/// The part of the innovation form that no window length changes.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// `Phi - L C`, n x n.
    pub copy: Matrix,
    /// L, n x p.
    pub inject: Matrix,
    /// `F^-1`, f x f.
    pub back: Matrix,
    /// G, f x p.
    pub input: Matrix,
}

/// How a window of a+1 samples is read.
#[derive(Clone, Debug)]
pub struct ReadOut {
    /// D, n x p.
    pub direct: Matrix,
    /// `P F^a`, n x f.
    pub read: Matrix,
}

/// A functional that has an innovation form, at any precision and window length.
pub trait Form {
    /// Whether the filter's modes are the plant's own run backwards, so that one that decays there grows here.
    fn runs_backwards(&self) -> bool {
        false
    }

    /// What no window length changes.
    ///
    /// # Errors
    /// If a matrix cannot be inverted.
    fn dynamics(&self, model: &Model) -> Result<Dynamics, Singular>;

    /// The read-outs of windows by their age a.
    ///
    /// # Errors
    /// If a window does not show every state.
    fn read_outs(&self, model: &Model, ages: Range<usize>) -> Result<Vec<ReadOut>, Singular>;
}

/// Least squares over every sample of the window (002 (9), (19)).
#[derive(Clone, Copy, Debug)]
pub struct LeastSquares;

impl Form for LeastSquares {
    fn runs_backwards(&self) -> bool {
        true
    }

    fn dynamics(&self, model: &Model) -> Result<Dynamics, Singular> {
        let (n, p) = (model.phi.rows(), model.c.rows());
        Ok(Dynamics {
            copy: model.phi.clone(),
            inject: Matrix::zeros(n, p, model.phi.precision()),
            back: model.phi.transpose(),
            input: &model.c.transpose() * &trust(model),
        })
    }

    fn read_outs(&self, model: &Model, ages: Range<usize>) -> Result<Vec<ReadOut>, Singular> {
        let (n, p) = (model.phi.rows(), model.phi.precision());
        let trust = trust(model);
        let direct = Matrix::zeros(n, model.c.rows(), p);
        let (mut gramian, mut row) = (Matrix::zeros(n, n, p), model.c.clone());
        let mut through = Matrix::identity(n, p);
        let mut all = Vec::new();
        for age in 0..ages.end {
            gramian = &gramian + &(&row.transpose() * &(&trust * &row));
            if age >= ages.start {
                all.push(ReadOut { direct: direct.clone(), read: &through * &inverse(&gramian)? });
            }
            row = &row * &model.phi;
            through = &through * &model.phi;
        }
        Ok(all)
    }
}

/// A functional given by its six matrices for windows of `steps` + 1 samples, over a range of steps.
pub struct ByInnovation<F>(pub F);

impl<F: Fn(&Model, Range<usize>) -> Result<Vec<Innovation>, Singular>> Form for ByInnovation<F> {
    fn dynamics(&self, model: &Model) -> Result<Dynamics, Singular> {
        // Copy and filter are those of every window; this one shows every state of an observable plant.
        let steps = 2 * model.phi.rows();
        let form = (self.0)(model, steps..steps + 1)?.pop().ok_or(Singular { column: 0 })?;
        Ok(Dynamics { copy: form.copy, inject: form.inject, back: inverse(&form.filter)?, input: form.input })
    }

    fn read_outs(&self, model: &Model, ages: Range<usize>) -> Result<Vec<ReadOut>, Singular> {
        let forms = (self.0)(model, ages.clone())?;
        let read = |(age, form): (usize, Innovation)| ReadOut {
            read: &form.output * &form.filter.powi(age as u64),
            direct: form.direct,
        };
        Ok(ages.zip(forms).map(read).collect())
    }
}

/// `F^-i G` for i = 0 … len - 1, f x p each.
pub fn rows(dynamics: &Dynamics, len: usize) -> Vec<Matrix> {
    let mut rows = vec![dynamics.input.clone()];
    while rows.len() < len {
        let next = &dynamics.back * &rows[rows.len() - 1];
        rows.push(next);
    }
    rows
}
