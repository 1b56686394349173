//! Least squares over the samples that are there: measurements at irregular times, for linear plants.
//!
//! Nothing but the rows of the window's equations depends on which samples came (window-observers, section 2), so
//! the estimate is exact as soon as the rows that are there determine the state: in finite time and without a
//! condition on gaps such as that of 000 Theorem 2. The price is a small solve in the step. With `O = Q R`, the rows
//! of Q as the constants, the normal equations of all rows are the unit matrix, and those of some rows stay close to
//! it: single precision suffices.

use crate::design::{Certificate, Settled};
use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::program::Scalar;
use crate::real::{Matrix, Precision, Real, inverse};

use super::Signal;
use super::certificate::disturbance_gains;
use super::model::Model;
use super::settle::{Pass, rising};
use super::solve::{output_powers, trusted};

/// Rows of numbers; `None` marks a structural zero.
pub type Sparse = Vec<Vec<Option<Settled>>>;

/// The constants of the solve.
#[derive(Clone, Debug)]
pub struct Irregular {
    /// By age from N to 0 and output: a row of Q, n numbers.
    pub rows: Vec<Vec<Vec<Settled>>>,
    /// Per output: what its samples count by.
    pub trust: Vec<Settled>,
    /// `Phi^N R^-1`, n x n.
    pub through: Sparse,
    /// Phi, n x n.
    pub phi: Sparse,
    /// C, p x n.
    pub c: Sparse,
    /// Per signal and state: times the value that the call at an interval's begin brought.
    pub begin: Sparse,
    /// Per signal and state: times the value that the call at the interval's end brought.
    pub end: Sparse,
    /// Per state: what the constant terms add in an interval.
    pub constant: Vec<Option<Settled>>,
    /// The smallest pivot with a sample every `most` calls.
    pub pivot: f64,
    /// The smallest pivot that is trusted.
    pub threshold: f64,
}

impl Irregular {
    /// The largest magnitude in a step for samples of magnitude 1, from above.
    ///
    /// Rows of Q are at most 1, and so are the diagonals of G and of what elimination leaves of it; with a pivot d that
    /// is trusted, d at least the threshold, a factor of elimination is at most 1/sqrt(d), twice that with rounding.
    pub fn largest_gain(&self) -> f64 {
        let size = |weight: &Option<Settled>| weight.map_or(0.0, |weight| weight.double.abs());
        let sum = |row: &Vec<Option<Settled>>| row.iter().map(size).sum::<f64>();
        let n = self.phi.len();
        let mut response = vec![0.0; n];
        let mut largest = vec![0.0_f64; n];
        let moved = |i: usize| -> f64 {
            let of = |effects: &Sparse| effects.iter().map(|effect| size(&effect[i])).sum::<f64>();
            of(&self.begin) + of(&self.end) + size(&self.constant[i])
        };
        for _ in 0..self.rows.len() {
            let kept =
                |i: usize| -> f64 { self.phi[i].iter().zip(&response).map(|(weight, r)| size(weight) * r).sum() };
            response = (0..n).map(|i| kept(i) + moved(i)).collect();
            largest.iter_mut().zip(&response).for_each(|(largest, r)| *largest = largest.max(*r));
        }
        let response = largest.iter().copied().fold(0.0, f64::max);
        let trust = self.trust.iter().map(|trust| trust.double).fold(0.0, f64::max);
        let seen = self.c.iter().map(sum).fold(0.0, f64::max);
        let right = super::count(self.rows.len() * self.c.len()) * trust * (1.0 + seen * response);
        let factor = 2.0 / deadbeat_math::sqrt_f64(self.threshold);
        let eliminated = (1..n).fold(right / self.threshold, |gain, _| gain * (1.0 + factor) * (1.0 + factor));
        let through = self.through.iter().map(sum).fold(0.0, f64::max);
        let phi = self.phi.iter().map(sum).fold(1.0, f64::max);
        (through * eliminated + response) * phi + (0..n).map(moved).fold(0.0, f64::max)
    }

    /// K for a pattern of samples, by age from 0, n x p each, in doubles; `None` where it does not determine the state.
    pub fn weights(&self, there: &dyn Fn(usize) -> bool) -> Option<Vec<nalgebra::DMatrix<f64>>> {
        let (n, p, steps) = (self.phi.len(), self.c.len(), self.rows.len() - 1);
        let dense = |sparse: &Sparse| {
            nalgebra::DMatrix::from_fn(sparse.len(), n, |i, j| sparse[i][j].map_or(0.0, |weight| weight.double))
        };
        let row = |age: usize, o: usize| nalgebra::DVector::from_fn(n, |j, _| self.rows[steps - age][o][j].double);
        let mut normal = nalgebra::DMatrix::zeros(n, n);
        for age in (0..=steps).filter(|age| there(*age)) {
            for o in 0..p {
                normal += row(age, o) * row(age, o).transpose();
            }
        }
        let through = dense(&self.through) * normal.cholesky()?.inverse();
        let weights = |age: usize| {
            let columns: Vec<_> = (0..p)
                .map(|o| {
                    let column = &through * row(age, o) * self.trust[o].double;
                    if there(age) { column } else { column * 0.0 }
                })
                .collect();
            nalgebra::DMatrix::from_columns(&columns)
        };
        Some((0..=steps).map(weights).collect())
    }
}

impl Irregular {
    /// How often rounding errors of the sums reach a state, with a sample every `most` calls at the worst call.
    ///
    /// A sum over the rows is off by some units of its terms; the solve and the way to the newest sample multiply that
    /// by `|Phi^N R^-1| |G^-1|`. A direction that has died out by then may be poorly determined.
    pub fn amplification(&self, most: usize) -> f64 {
        let (n, steps) = (self.phi.len(), self.rows.len() - 1);
        let mut worst = 0.0_f64;
        for phase in 0..most {
            let mut normal = nalgebra::DMatrix::zeros(n, n);
            let mut terms = nalgebra::DVector::zeros(n);
            for age in (0..=steps).filter(|age| age % most == phase) {
                for (row, trust) in self.rows[steps - age].iter().zip(&self.trust) {
                    let row = nalgebra::DVector::from_fn(n, |j, _| row[j].double);
                    normal += &row * row.transpose();
                    terms += row.abs() * trust.double;
                }
            }
            let Some(inverse) = normal.cholesky().map(|factor| factor.inverse()) else { return f64::INFINITY };
            let through = nalgebra::DMatrix::from_fn(n, n, |i, j| self.through[i][j].map_or(0.0, |w| w.double.abs()));
            worst = worst.max((through * inverse.abs() * terms).max());
        }
        worst
    }
}

/// The same at one precision.
struct Exact {
    rows: Vec<Matrix>,
    through: Matrix,
    model: Model,
}

/// Half the distance from 1 to the next float.
pub fn unit(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32 => f64::from(f32::EPSILON) / 2.0,
        Scalar::F64 => f64::EPSILON / 2.0,
    }
}

/// Designs the solve for gaps of up to `most` samples.
pub fn design(plant: &Plant, signals: &[Signal], steps: usize, most: usize) -> Result<Irregular, Vec<Diagnostic>> {
    let refuse = || {
        let message = "the window does not determine the state";
        vec![Diagnostic::error(codes::UNOBSERVABLE, plant.span.clone(), message)]
    };
    let run = |p: Precision| {
        let model = Model::new(plant, signals, p)?;
        let factor = triangle(&model, steps).ok_or_else(refuse)?;
        let back = inverse(&factor).map_err(|_| refuse())?;
        let rows = output_powers(&model, steps).iter().map(|row| &trusted(row, &model.trust) * &back).collect();
        Ok(Exact { rows, through: &model.phi.powi(steps as u64) * &back, model })
    };
    let round = |pass: &mut Pass, coarse: &Exact, fine: &Exact| rounded(pass, coarse, fine, plant.outputs.len());
    let (irregular, exact, _) = rising(plant, run, round, |_| 0.0)?;
    let trust = exact.model.trust.iter().map(Settled::round).collect();
    let pivot = smallest_pivot(&irregular.rows, most);
    // Below the limit a pivot is rounding; irregular patterns are a little worse than the worst regular one.
    let limit = 64.0 * super::count(plant.states.len()) * unit(plant.scalar);
    let threshold = limit.max(pivot / 64.0);
    Ok(Irregular { trust, pivot, threshold, ..irregular })
}

/// R of `W O = Q R`, upper triangular, by Cholesky's factorisation of the Gramian.
fn triangle(model: &Model, steps: usize) -> Option<Matrix> {
    let (n, p) = (model.phi.rows(), model.phi.precision());
    let mut gramian = Matrix::zeros(n, n, p);
    for row in output_powers(model, steps) {
        let trusted = trusted(&row, &model.trust);
        gramian = &gramian + &(&trusted.transpose() * &trusted);
    }
    let mut factor = Matrix::zeros(n, n, p);
    for i in 0..n {
        for j in i..n {
            let done = Real::sum_of_products((0..i).map(|k| (factor.get(k, i), factor.get(k, j))), p);
            let left = gramian.get(i, j) - &done;
            factor[(i, j)] =
                if i == j { left.checked_sqrt().ok()? } else { left.checked_div(factor.get(i, i)).ok()? };
        }
        if factor.get(i, i).is_zero() {
            return None;
        }
    }
    Some(factor)
}

fn rounded(pass: &mut Pass, coarse: &Exact, fine: &Exact, outputs: usize) -> Irregular {
    let row = |m: &Matrix, i: usize| -> Vec<Real> { (0..m.cols()).map(|j| m.get(i, j).clone()).collect() };
    let rows = coarse.rows.iter().zip(&fine.rows).map(|(c, f)| {
        let one = |pass: &mut Pass, o: usize| {
            pass.each(&row(c, o), &row(f, o)).into_iter().map(Option::unwrap_or_default).collect()
        };
        (0..outputs).map(|o| one(pass, o)).collect()
    });
    let rows = rows.collect();
    let mut sparse =
        |c: &Matrix, f: &Matrix| -> Sparse { (0..c.rows()).map(|i| pass.each(&row(c, i), &row(f, i))).collect() };
    let through = sparse(&coarse.through, &fine.through);
    let (c, f) = (&coarse.model, &fine.model);
    let phi = sparse(&c.phi, &f.phi);
    let seen = sparse(&c.c, &f.c);
    let mut effects = |which: fn(&super::model::Effect) -> &Option<Matrix>| -> Sparse {
        let none = || vec![None; c.phi.rows()];
        c.effects
            .iter()
            .zip(&f.effects)
            .map(|(c, f)| match (which(c), which(f)) {
                (Some(c), Some(f)) => sparse(&c.transpose(), &f.transpose()).remove(0),
                _ => none(),
            })
            .collect()
    };
    let (begin, end) = (effects(|e| &e.at_begin), effects(|e| &e.at_end));
    let constant = sparse(&c.constant.transpose(), &f.constant.transpose()).remove(0);
    Irregular { rows, through, phi, c: seen, begin, end, constant, trust: Vec::new(), pivot: 0.0, threshold: 0.0 }
}

/// The smallest pivot of the normal equations with a sample every `most` calls, at the worst call.
fn smallest_pivot(rows: &[Vec<Vec<Settled>>], most: usize) -> f64 {
    let n = rows[0][0].len();
    let mut smallest = f64::INFINITY;
    for phase in 0..most {
        let mut normal = vec![vec![0.0; n]; n];
        for outputs in rows.iter().skip(phase).step_by(most) {
            for row in outputs {
                for i in 0..n {
                    for j in 0..n {
                        normal[i][j] += row[i].double * row[j].double;
                    }
                }
            }
        }
        for k in 0..n {
            let pivot = normal[k][k];
            smallest = f64::min(smallest, pivot);
            if pivot <= 0.0 {
                return 0.0;
            }
            let row = normal[k].clone();
            for below in &mut normal[k + 1..] {
                let factor = below[k] / pivot;
                below.iter_mut().zip(&row).for_each(|(x, above)| *x -= factor * above);
            }
        }
    }
    smallest
}

/// Gains with a measurement every `most` samples, at the worst call; `None` where that is too few.
pub fn certify(plant: &Plant, irregular: &Irregular, exact: &super::solve::Exact, most: usize) -> Option<Certificate> {
    let n = plant.states.len();
    let zeros = |columns: usize| vec![vec![0.0; columns]; n];
    let mut worst = Certificate {
        noise_gain_l1: zeros(plant.outputs.len()),
        noise_gain_l2: zeros(plant.outputs.len()),
        disturbance_gain_l1: zeros(plant.disturbances.len()),
        error_bound: Vec::new(),
        initial_gain: Vec::new(),
    };
    for phase in 0..most {
        let weights = irregular.weights(&|age| age % most == phase)?;
        for i in 0..n {
            for o in 0..plant.outputs.len() {
                let of = weights.iter().map(|weights| weights[(i, o)]);
                let squares = of.clone().map(|weight| weight * weight).sum();
                let (l1, l2) = (&mut worst.noise_gain_l1[i][o], &mut worst.noise_gain_l2[i][o]);
                *l1 = l1.max(of.map(f64::abs).sum());
                *l2 = l2.max(deadbeat_math::sqrt_f64(squares));
            }
        }
        let gains = disturbance_gains(plant, &accumulated(&exact.model, &weights)?);
        for (worst, gains) in worst.disturbance_gain_l1.iter_mut().zip(gains) {
            worst.iter_mut().zip(gains).for_each(|(worst, gain)| *worst = worst.max(gain));
        }
    }
    // Patterns within the declared gaps may cost more than regular ones, so that this bounds nothing.
    worst.error_bound = vec![None; n];
    Some(worst)
}

/// What a disturbance of the state leaves in the estimate, by age.
fn accumulated(model: &Model, weights: &[nalgebra::DMatrix<f64>]) -> Option<Vec<Matrix>> {
    let p = model.phi.precision();
    let mut left = Matrix::identity(model.phi.rows(), p);
    let mut all = Vec::new();
    for weights in &weights[..weights.len() - 1] {
        let entries: Option<Vec<Real>> = weights.iter().map(|weight| Real::from_f64(*weight, p)).collect();
        let entries = entries?;
        let rows = weights.nrows();
        let weights = Matrix::from_fn(rows, weights.ncols(), |i, o| entries[o * rows + i].clone());
        left = &left - &(&weights * &model.c);
        all.push(left.clone());
        left = &left * &model.phi;
    }
    Some(all)
}
