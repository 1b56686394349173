//! The innovation form of a window functional: a copy of the plant and a filter of what it did not foresee.
//!
//! With a copy `xc+ = (Phi - L C) xc + L y + (what is known)`, started anywhere, and its innovation
//! `v = y - C xc`, every functional whose weights follow a linear recursion is
//!
//! `x_k = xc_k + D v_k + P sum_{j=0}^{N} F^j G v_{k-j}`.
//!
//! The stateless sum over the window ([`Innovation::weights`]), the recursive filter with one delayed
//! innovation, blocks, and copies that are restarted are all realisations of these six matrices.
//! Least squares (002 (9), (19)): the copy is the plant itself, `F = Phi^-T`. Single delay (000 (7), (13)):
//! the copy is driven by y, and F has 000's `psi_1` and `psi_2` as modes. The filter is written such that no
//! inverse of `Phi_rr - a I` is needed: its first half is `psi_1` - `psi_2`.

use std::ops::Range;

use crate::real::{Matrix, Real, Singular, inverse};

use crate::sampled::coordinates::Coordinates;
use crate::sampled::model::Model;
use crate::sampled::observability::output_powers;

/// The six matrices, in the plant's own states.
#[derive(Clone, Debug)]
pub struct Innovation {
    /// `Phi - L C`, n x n.
    pub copy: Matrix,
    /// L, n x p.
    pub inject: Matrix,
    /// D, n x p.
    pub direct: Matrix,
    /// F.
    pub filter: Matrix,
    /// G, its inputs are innovations.
    pub input: Matrix,
    /// P, its outputs are states.
    pub output: Matrix,
}

/// The constants of the single-delay observer in the coordinates of its output (000 (4)-(6), sampled).
#[derive(Clone, Debug)]
pub struct SingleDelay {
    /// S, (n-p) x (n-p).
    pub s: Matrix,
    /// N, (n-p) x p.
    pub n: Matrix,
    /// R = S^-1 N.
    pub r: Matrix,
    /// `Phi_rr`.
    pub rr: Matrix,
}

/// Outputs by what their samples count by.
pub(super) fn trust(model: &Model) -> Matrix {
    let p = model.trust.len();
    let zero = Real::zero(model.phi.precision());
    Matrix::from_fn(p, p, |i, j| if i == j { &model.trust[i] * &model.trust[i] } else { zero.clone() })
}

impl Innovation {
    /// Least squares over `steps` + 1 samples of outputs without delay.
    ///
    /// # Errors
    /// If Phi cannot be inverted, or the window does not show every state.
    pub fn least_squares(model: &Model, steps: usize) -> Result<Self, Singular> {
        let (n, p) = (model.phi.rows(), model.phi.precision());
        let trust = trust(model);
        let mut gramian = Matrix::zeros(n, n, p);
        for row in output_powers(model, steps) {
            gramian = &gramian + &(&row.transpose() * &(&trust * &row));
        }
        let through = model.phi.powi(steps as u64);
        let output = &(&through * &inverse(&gramian)?) * &through.transpose();
        Ok(Self {
            copy: model.phi.clone(),
            inject: Matrix::zeros(n, model.c.rows(), p),
            direct: Matrix::zeros(n, model.c.rows(), p),
            filter: inverse(&model.phi)?.transpose(),
            input: &model.c.transpose() * &trust,
            output,
        })
    }

    /// The single-delay observer over `steps` samples, with the factor `a = exp(-k h)`.
    ///
    /// # Errors
    /// If `Phi_rr` cannot be inverted, or the window does not show every state.
    pub fn single_delay(
        model: &Model,
        coordinates: &Coordinates,
        a: &Real,
        steps: usize,
    ) -> Result<(Self, SingleDelay), Singular> {
        let mut all = Self::single_delays(model, coordinates, a, steps..steps + 1)?;
        all.pop().ok_or(Singular { column: 0 })
    }

    /// The same over each of these numbers of samples.
    ///
    /// # Errors
    /// If `Phi_rr` cannot be inverted, or a window does not show every state.
    pub fn single_delays(
        model: &Model,
        coordinates: &Coordinates,
        a: &Real,
        steps: Range<usize>,
    ) -> Result<Vec<(Self, SingleDelay)>, Singular> {
        let precision = model.phi.precision();
        let (p, rest) = (coordinates.outputs(), coordinates.rest.len());
        let (n, blocks, trust) = (p + rest, coordinates.blocks(&model.phi), trust(model));
        let zeros = |i: usize, j: usize| Matrix::zeros(i, j, precision);
        let eye = |size: usize| Matrix::identity(size, precision);
        let back = &coordinates.back;
        let backwards = inverse(&blocks.rr)?;

        let mut copy = zeros(n, n);
        copy.set_block(0, 0, &eye(p).scale(a));
        copy.set_block(0, p, &blocks.yr);
        copy.set_block(p, p, &blocks.rr);
        let copy = &(back * &copy) * &coordinates.into;
        let inject = back * &(&blocks.yy - &eye(p).scale(a)).vcat(&blocks.ry);
        let mut filter = zeros(2 * rest, 2 * rest);
        filter.set_block(0, 0, &eye(rest).scale(a));
        filter.set_block(0, rest, &eye(rest).scale(a));
        filter.set_block(rest, rest, &backwards.transpose().scale(&(a * a)));
        let input = zeros(rest, p).vcat(&(&(&blocks.yr * &backwards).transpose() * &trust));
        let over = |s: &Matrix, sum: &Matrix| -> Result<(Self, SingleDelay), Singular> {
            let s_inverse = inverse(s)?;
            let r = &s_inverse * sum;
            let mut output = zeros(n, 2 * rest);
            output.set_block(p, 0, &s_inverse.scale(&-Real::one(precision)));
            let form = Self {
                copy: copy.clone(),
                inject: inject.clone(),
                direct: back * &eye(p).vcat(&r),
                filter: filter.clone(),
                input: input.clone(),
                output: back * &output,
            };
            Ok((form, SingleDelay { s: s.clone(), n: sum.clone(), r, rr: blocks.rr.clone() }))
        };

        // lambda_j = lambda_(j-1) + a^(j-1) Phi_yr Phi_rr^-j.
        let (mut lambda, mut term) = (zeros(p, rest), &blocks.yr * &backwards);
        let (mut s, mut sum) = (zeros(rest, rest), zeros(rest, p));
        let mut all = Vec::with_capacity(steps.len());
        for samples in 1..steps.end {
            lambda = &lambda + &term;
            term = (&term * &backwards).scale(a);
            let trusted = &lambda.transpose() * &trust;
            s = &s + &(&trusted * &lambda);
            sum = &sum + &trusted;
            if steps.contains(&samples) {
                all.push(over(&s, &sum)?);
            }
        }
        Ok(all)
    }

    /// K by age: the same functional as a sum over the samples, n x p each.
    pub fn weights(&self, model: &Model, steps: usize) -> Vec<Matrix> {
        let mut tail = self.input.clone();
        let mut of_innovation = &self.direct + &(&self.output * &tail);
        let mut left = &Matrix::identity(self.copy.rows(), self.copy.precision()) - &(&of_innovation * &model.c);
        let mut weights = vec![of_innovation];
        for _ in 0..steps {
            tail = &self.filter * &tail;
            of_innovation = &self.output * &tail;
            weights.push(&of_innovation + &(&left * &self.inject));
            left = &(&left * &self.copy) - &(&of_innovation * &model.c);
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::designed;
    use crate::real::Precision;
    use crate::sampled::model::signals;

    const MOTOR: &str = include_str!("../../../specs/dc_motor.toml");

    /// What the weights leave of the state before the window, against their size.
    fn bias(weights: &[Matrix], model: &Model) -> f64 {
        let mut left = &Matrix::identity(model.phi.rows(), model.phi.precision()) - &(&weights[0] * &model.c);
        for weight in &weights[1..] {
            left = &(&left * &model.phi) - &(weight * &model.c);
        }
        let largest = weights.iter().map(Matrix::max_abs).max().unwrap();
        (&left.max_abs() / &largest).to_f64()
    }

    #[test]
    fn both_forms_are_unbiased_and_least_squares_agrees_with_the_orthogonal_method() {
        let (plant, design) = designed(MOTOR).unwrap();
        let p = Precision::bits(1_024);
        let model = Model::new(&plant, &signals(&plant), p).unwrap();
        let steps = design.window_steps;
        let squares = Innovation::least_squares(&model, steps).unwrap().weights(&model, steps);
        assert!(bias(&squares, &model) < 1e-100);
        let fir = design.fir.unwrap();
        for (weight, printed) in squares.iter().zip(&fir.k) {
            assert_eq!(&weight.to_f64(), printed);
        }
        let rest = Coordinates::pick(&model.c.to_f64(), 3).unwrap();
        let coordinates = Coordinates::new(&model.c, rest).unwrap();
        for k in [-30, 0, 75, 100] {
            let a = (Real::from_i64(-k, p) / Real::from_i64(1_000, p)).checked_exp().unwrap();
            let (form, _) = Innovation::single_delay(&model, &coordinates, &a, steps).unwrap();
            assert!(bias(&form.weights(&model, steps), &model) < 1e-100);
        }
    }
}
