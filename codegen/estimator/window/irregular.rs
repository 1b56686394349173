//! Least squares over the samples that are there: measurements at irregular times, for linear plants.
//!
//! Nothing but the rows of the window's equations depends on which samples came (window-observers, section 2), so
//! the estimate is exact as soon as the rows that are there determine the state: in finite time and without a
//! condition on gaps such as that of 000 Theorem 2. The price is a small solve in the step. With `O = Q R`, the rows
//! of Q as the constants, the normal equations of all rows are the unit matrix, and those of some rows stay close to
//! it: single precision suffices. Those of a sensor with much noise, alone, are small throughout; what they determine is
//! judged by shares of their diagonal ([`Worth`]).

mod age;
mod certify;
mod equations;
mod pattern;
mod size;
mod worth;

use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
pub use crate::promise::rounding::unit;
use crate::real::{Matrix, Precision, Real, inverse};
use crate::sampled::settled::Settled;

use age::ExactAges;
pub use age::{Ages, degree};
pub use certify::certify;
pub use equations::{Eliminated, There};
pub use pattern::Pattern;
pub use worth::Worth;

use super::solve::trusted;
use crate::sampled::Signal;
use crate::sampled::model::Model;
use crate::sampled::observability::output_powers;
use crate::sampled::settle::{Pass, rising};

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
    /// Up to where an estimate counts.
    pub worth: Worth,
    /// Per output: what a sample with an age shows.
    pub ages: Vec<Option<Ages>>,
    /// By age from N to 0: `Phi^(N - age) R^-1`, n x n; where samples come with their ages.
    pub states: Vec<Vec<Vec<Settled>>>,
}

/// The same at one precision.
struct Exact {
    rows: Vec<Matrix>,
    states: Vec<Matrix>,
    ages: Vec<Option<ExactAges>>,
    through: Matrix,
    model: Model,
}

/// Multiplications and additions that a row of the window takes, for n states, p outputs and so many signals; what is
/// structurally zero is less.
pub fn operations(n: usize, p: usize, signals: usize) -> usize {
    let response = n * n + 2 * n * signals + n * p;
    let equations = n * (n + 1) / 2 + n;
    2 * response + p * (2 + n + 2 * equations)
}

/// The smallest pivot that is more than rounding.
pub fn limit(plant: &Plant) -> f64 {
    64.0 * crate::numbers::count(plant.states.len()) * unit(plant.scalar)
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
    let irregular = Irregular { trust, pattern, ..irregular };
    Ok(Irregular { pivot: smallest_pivot(&irregular), ..irregular })
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
    let mut effects = |which: fn(&crate::sampled::model::Effect) -> &Option<Matrix>| -> Sparse {
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
    let trust = Vec::new();
    let (pivot, worth) = (0.0, Worth::default());
    Irregular { rows, through, phi, c: seen, begin, end, constant, trust, pattern, pivot, worth, ages, states }
}

/// The smallest pivot of the normal equations with the samples of the pattern, at the worst call.
fn smallest_pivot(irregular: &Irregular) -> f64 {
    let of_phase = |phase: usize| {
        let at = |age: usize, o: usize| irregular.pattern.there(phase, age, o);
        irregular.eliminated(&There { at: &at, share: &|_| 0.0 }).map_or(0.0, |it| it.pivot)
    };
    irregular.pattern.phases().map(of_phase).fold(f64::INFINITY, f64::min)
}
