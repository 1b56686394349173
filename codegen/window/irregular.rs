//! Least squares over the samples that are there: measurements at irregular times, for linear plants.
//!
//! Nothing but the rows of the window's equations depends on which samples came (window-observers, section 2), so
//! the estimate is exact as soon as the rows that are there determine the state: in finite time and without a
//! condition on gaps such as that of 000 Theorem 2. The price is a small solve in the step. With `O = Q R`, the rows
//! of Q as the constants, the normal equations of all rows are the unit matrix, and those of some rows stay close to
//! it: single precision suffices.

mod age;
mod certify;
mod pattern;

use crate::design::Settled;
use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::program::Scalar;
use crate::real::{Matrix, Precision, Real, inverse};

use age::ExactAges;
pub use age::{Ages, degree};
pub use certify::{Phase, certify};
pub use pattern::Pattern;

use super::Signal;
use super::model::Model;
use super::settle::{Pass, rising};
use super::solve::{output_powers, trusted};

/// Rows of numbers; `None` marks a structural zero.
pub type Sparse = Vec<Vec<Option<Settled>>>;

/// The constants of the solve.
#[derive(Clone, Debug)]
pub struct Irregular {
    /// By age from N to 0 and output: a row of Q, n numbers; zeros where a late output cannot show that age yet.
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
    /// The samples that come when none is lost.
    pub pattern: Pattern,
    /// The smallest pivot with these, at the worst phase.
    pub pivot: f64,
    /// The smallest pivot that is trusted.
    pub threshold: f64,
    /// Gains by phase, where there are several.
    pub phases: Vec<Phase>,
    /// Per output: what a sample with an age shows.
    pub ages: Vec<Option<Ages>>,
    /// By age from N to 0: `Phi^(N - age) R^-1`, n x n; where samples come with their ages.
    pub states: Vec<Vec<Vec<Settled>>>,
}

impl Irregular {
    /// Multiplications and additions of a step's pass over the window.
    pub fn operations(&self) -> usize {
        let of = |rows: &Sparse| rows.iter().flatten().flatten().count();
        let (n, p) = (self.phi.len(), self.c.len());
        let response = of(&self.phi) + of(&self.begin) + of(&self.end) + of(&self.c);
        let equations = n * (n + 1) / 2 + n;
        let aged = self.ages.iter().flatten().map(|ages| ages.operations() + 2 * n * (n + 1)).sum::<usize>();
        self.rows.len() * (2 * response + p * (2 + n + 2 * equations) + aged)
    }

    /// The largest entry of a row, for rows of samples with an age at any of them: those of Q are at most 1.
    fn largest_entry(&self) -> f64 {
        let of = |(ages, trust): (&Ages, &Settled)| {
            let row = ages.largest_row();
            let entry = |state: &Vec<Vec<Settled>>, j: usize| -> f64 {
                row.iter().zip(state).map(|(c, direction)| c * direction[j].double.abs()).sum::<f64>() * trust.double
            };
            let largest = |state: &Vec<Vec<Settled>>| (0..row.len()).map(|j| entry(state, j)).fold(0.0, f64::max);
            self.states.iter().map(largest).fold(0.0, f64::max)
        };
        let aged = self.ages.iter().zip(&self.trust).filter_map(|(ages, trust)| Some((ages.as_ref()?, trust)));
        aged.map(of).fold(1.0, f64::max)
    }

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
        let entry = self.largest_entry();
        let aged = self.ages.iter().flatten();
        let shown = aged.fold(1.0 + seen * response, |most, ages| {
            let seen = ages.largest_row().iter().sum::<f64>();
            most.max(1.0 + ages.largest_share() + seen * response)
        });
        let right = super::count(self.rows.len() * self.c.len()) * trust * shown * entry;
        // With entries beyond 1 the diagonals of G are at most their squares' sum.
        let diagonal = if entry > 1.0 {
            entry * deadbeat_math::sqrt_f64(super::count(self.rows.len() * self.c.len()))
        } else {
            1.0
        };
        let factor = 2.0 * diagonal / deadbeat_math::sqrt_f64(self.threshold);
        let eliminated = (1..n).fold(right / self.threshold, |gain, _| gain * (1.0 + factor) * (1.0 + factor));
        let through = self.through.iter().map(sum).fold(0.0, f64::max);
        let phi = self.phi.iter().map(sum).fold(1.0, f64::max);
        (through * eliminated + response) * phi + (0..n).map(moved).fold(0.0, f64::max)
    }

    /// K for some samples, by age of the state that they show from 0, n x p each, in doubles; `None` where they do not
    /// determine the state.
    pub fn weights(&self, there: &dyn Fn(usize, usize) -> bool) -> Option<Vec<nalgebra::DMatrix<f64>>> {
        let (n, p, steps) = (self.phi.len(), self.c.len(), self.rows.len() - 1);
        let dense = |sparse: &Sparse| {
            nalgebra::DMatrix::from_fn(sparse.len(), n, |i, j| sparse[i][j].map_or(0.0, |weight| weight.double))
        };
        let row = |age: usize, o: usize| nalgebra::DVector::from_fn(n, |j, _| self.rows[steps - age][o][j].double);
        let mut normal = nalgebra::DMatrix::zeros(n, n);
        for age in 0..=steps {
            for o in (0..p).filter(|o| there(age, *o)) {
                normal += row(age, o) * row(age, o).transpose();
            }
        }
        let through = dense(&self.through) * normal.cholesky()?.inverse();
        let weights = |age: usize| {
            let columns: Vec<_> = (0..p)
                .map(|o| {
                    let column = &through * row(age, o) * self.trust[o].double;
                    if there(age, o) { column } else { column * 0.0 }
                })
                .collect();
            nalgebra::DMatrix::from_columns(&columns)
        };
        Some((0..=steps).map(weights).collect())
    }

    /// How often rounding errors of the sums reach a state, with the samples of the pattern at the worst call.
    ///
    /// A sum over the rows is off by some units of its terms; the solve and the way to the newest sample multiply that
    /// by `|Phi^N R^-1| |G^-1|`. A direction that has died out by then may be poorly determined.
    pub fn amplification(&self) -> f64 {
        let (n, steps) = (self.phi.len(), self.rows.len() - 1);
        let mut worst = 0.0_f64;
        for phase in self.pattern.phases() {
            let mut normal = nalgebra::DMatrix::zeros(n, n);
            let mut terms = nalgebra::DVector::zeros(n);
            for age in 0..=steps {
                for (o, (row, trust)) in self.rows[steps - age].iter().zip(&self.trust).enumerate() {
                    if self.pattern.there(phase, age, o) {
                        let row = nalgebra::DVector::from_fn(n, |j, _| row[j].double);
                        normal += &row * row.transpose();
                        terms += row.abs() * trust.double;
                    }
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
    states: Vec<Matrix>,
    ages: Vec<Option<ExactAges>>,
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

/// The smallest pivot that is more than rounding.
pub fn limit(plant: &Plant) -> f64 {
    64.0 * super::count(plant.states.len()) * unit(plant.scalar)
}

/// Designs the solve for samples that come, when none is lost, as a pattern says.
pub fn design(plant: &Plant, signals: &[Signal], steps: usize, pattern: Pattern) -> Result<Irregular, Vec<Diagnostic>> {
    let refuse = || {
        let message = "the window does not determine the state";
        vec![Diagnostic::error(codes::UNOBSERVABLE, plant.span.clone(), message)]
    };
    let mut degrees = Vec::new();
    for (o, output) in plant.outputs.iter().enumerate() {
        degrees.push(output.aged.as_ref().map(|aged| degree(plant, o, &aged.most)).transpose()?.flatten());
    }
    let run = |p: Precision| {
        let model = Model::new(plant, signals, p)?;
        let mut ages = Vec::new();
        for (o, (output, degree)) in plant.outputs.iter().zip(&degrees).enumerate() {
            let aged = output.aged.as_ref().zip(*degree);
            let exact = aged.map(|(aged, degree)| ExactAges::new(plant, signals, o, &aged.most, degree, p));
            ages.push(exact.transpose()?);
        }
        let all = rows(&model, steps, &pattern);
        let factor = triangle(&all).ok_or_else(refuse)?;
        let back = inverse(&factor).map_err(|_| refuse())?;
        let rows = all.iter().map(|row| row * &back).collect();
        let states = if ages.iter().any(Option::is_some) { states(&model, &back, steps) } else { Vec::new() };
        Ok(Exact { rows, states, ages, through: &model.phi.powi(steps as u64) * &back, model })
    };
    let round = |pass: &mut Pass, coarse: &Exact, fine: &Exact| rounded(pass, coarse, fine, plant.outputs.len());
    let (irregular, exact, _) = rising(plant, run, round, |_| 0.0)?;
    let trust = exact.model.trust.iter().map(Settled::round).collect();
    let pivot = smallest_pivot(&irregular.rows, &pattern);
    // Below the limit a pivot is rounding; irregular patterns are a little worse than the worst regular one.
    let threshold = limit(plant).max(pivot / 64.0);
    Ok(Irregular { trust, pattern, pivot, threshold, ..irregular })
}

/// `Phi^j R^-1` for j = 0 … N.
fn states(model: &Model, back: &Matrix, steps: usize) -> Vec<Matrix> {
    let mut all = vec![back.clone()];
    for j in 0..steps {
        all.push(&model.phi * &all[j]);
    }
    all
}

/// `W C Phi^j` for j = 0 … N, p x n each; zeros where no sample shows the state of that age.
fn rows(model: &Model, steps: usize, pattern: &Pattern) -> Vec<Matrix> {
    let zero = Real::zero(model.phi.precision());
    let of = |(j, row): (usize, &Matrix)| {
        let row = trusted(row, &model.trust);
        let shows = |o: usize| pattern.shows(steps - j, o);
        Matrix::from_fn(row.rows(), row.cols(), |o, i| if shows(o) { row.get(o, i).clone() } else { zero.clone() })
    };
    output_powers(model, steps).iter().enumerate().map(of).collect()
}

/// R of `W O = Q R`, upper triangular, by Cholesky's factorisation of the Gramian.
fn triangle(rows: &[Matrix]) -> Option<Matrix> {
    let (n, p) = (rows[0].cols(), rows[0].precision());
    let mut gramian = Matrix::zeros(n, n, p);
    for row in rows {
        gramian = &gramian + &(&row.transpose() * row);
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
    let states = coarse.states.iter().zip(&fine.states).map(|(c, f)| {
        let one = |pass: &mut Pass, i: usize| {
            pass.each(&row(c, i), &row(f, i)).into_iter().map(Option::unwrap_or_default).collect()
        };
        (0..c.rows()).map(|i| one(pass, i)).collect()
    });
    let states = states.collect();
    let ages = coarse.ages.iter().zip(&fine.ages);
    let ages = ages.map(|(c, f)| Some(Ages::rounded(pass, c.as_ref()?, f.as_ref()?))).collect();
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
    let pattern = Pattern::together(outputs, 1);
    let (trust, phases) = (Vec::new(), Vec::new());
    let (pivot, threshold) = (0.0, 0.0);
    Irregular {
        rows,
        through,
        phi,
        c: seen,
        begin,
        end,
        constant,
        trust,
        pattern,
        pivot,
        threshold,
        phases,
        ages,
        states,
    }
}

/// The smallest pivot of the normal equations with the samples of a pattern, at the worst call.
fn smallest_pivot(rows: &[Vec<Vec<Settled>>], pattern: &Pattern) -> f64 {
    let (n, steps) = (rows[0][0].len(), rows.len() - 1);
    let mut smallest = f64::INFINITY;
    for phase in pattern.phases() {
        let mut normal = vec![vec![0.0; n]; n];
        for (place, outputs) in rows.iter().enumerate() {
            for (_, row) in outputs.iter().enumerate().filter(|(o, _)| pattern.there(phase, steps - place, *o)) {
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
