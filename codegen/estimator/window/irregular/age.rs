//! Samples that come with their age: what one shows of the state now.
//!
//! A sample of age a shows `C x(t - a) = C e^{-A a} x(t) - C (integral of e^{-A (a - s)} B u(t - s) over s from 0 to a)`. Both
//! are power series in a, with exact coefficients; of a chain of integrators they end by themselves, of other plants
//! where the rest is below half a unit of the last place, whatever the age. Ages count in units of the oldest, so that
//! no power of one is large or small.

use crate::diagnostic::Diagnostic;
use crate::expr::Constant;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::real::{Matrix, Precision, Real};
use crate::sampled::settled::Settled;

use super::{Sparse, unit};
use crate::sampled::model::Matrices;
use crate::sampled::settle::Pass;
use crate::sampled::{Part, Signal};

/// Series in the age over the oldest; coefficients of rising powers.
#[derive(Clone, Debug)]
pub struct Ages {
    /// The oldest sample that is used, s.
    pub most: Settled,
    /// One over it.
    pub scale: Settled,
    /// Per state: `C e^{-A a}`.
    pub row: Sparse,
    /// Per signal: what is missing in a sample, times the signal's value at this call.
    pub now: Sparse,
    /// Per signal: times its value at the call before.
    pub before: Sparse,
    /// What the constant terms add to that.
    pub constant: Vec<Option<Settled>>,
}

/// The same at one precision.
pub struct ExactAges {
    row: Matrix,
    now: Matrix,
    before: Matrix,
    constant: Matrix,
    most: Real,
}

/// The highest power that is computed.
const HIGHEST: usize = 24;
/// Powers of the rest that are added up; later ones are smaller than rounding by far.
const REST: usize = 96;

/// `C (-A m)^k / k!` for k = 0 …, n each; m is the oldest age.
fn terms(matrices: &Matrices, output: usize, most: &Real, count: usize) -> Vec<Matrix> {
    let n = matrices.a.rows();
    let scaled = -&matrices.a.scale(most);
    let mut all = vec![matrices.c.block(output..output + 1, 0..n)];
    for k in 1..count {
        all.push((&all[k - 1] * &scaled).scale(&over(k, most)));
    }
    all
}

/// 1/k.
fn over(k: usize, like: &Real) -> Real {
    let whole = Real::from_i64(i64::try_from(k).unwrap_or(i64::MAX), like.precision());
    &Real::one(like.precision()) / &whole
}

/// The power at which the series of an output may end; `None` where that is too late.
pub fn degree(plant: &Plant, output: usize, most: &Constant) -> Result<Option<usize>, Vec<Diagnostic>> {
    let p = Precision::bits(256);
    let matrices = Matrices::new(plant, &[], p)?;
    let most = most.evaluate(p).unwrap_or_else(|_| Real::zero(p));
    let sizes: Vec<Vec<f64>> = terms(&matrices, output, &most, HIGHEST + REST)
        .iter()
        .map(|term| (0..term.cols()).map(|i| term.get(0, i).to_f64().abs()).collect())
        .collect();
    let n = plant.states.len();
    let largest: Vec<f64> = (0..n).map(|i| sizes.iter().fold(0.0, |most: f64, size| most.max(size[i]))).collect();
    let rest = |degree: usize, i: usize| sizes[degree + 1..].iter().map(|size| size[i]).sum::<f64>();
    let half = unit(plant.scalar) / 2.0;
    Ok((0..=HIGHEST).find(|degree| (0..n).all(|i| rest(*degree, i) <= half * largest[i])))
}

impl ExactAges {
    /// The series up to a power.
    pub fn new(
        plant: &Plant,
        signals: &[Signal],
        output: usize,
        most: &Constant,
        degree: usize,
        p: Precision,
    ) -> Result<Self, Vec<Diagnostic>> {
        let matrices = Matrices::new(plant, signals, p)?;
        let most = most.evaluate(p).unwrap_or_else(|_| Real::zero(p));
        let terms = terms(&matrices, output, &most, degree + 1);
        let (n, zero) = (plant.states.len(), Real::zero(p));
        let row = Matrix::from_fn(n, degree + 1, |i, k| terms[k].get(0, i).clone());
        // m^(k+1) / (k+1)! of the integral of a held input, m^(k+2) / ((k+2)! h) of one that has risen since the call before.
        let of = |column: &Matrix, k: usize| (&terms[k] * column).get(0, 0).clone();
        let held = |column: &Matrix, power: usize| match power.checked_sub(1) {
            Some(k) if k <= degree => &(&of(column, k) * &most) * &over(k + 1, &most),
            _ => zero.clone(),
        };
        let risen = |column: &Matrix, power: usize| match power.checked_sub(2) {
            Some(k) if k <= degree => {
                let integral = &(&of(column, k) * &most) * &over(k + 1, &most);
                &(&(&integral * &most) * &over(k + 2, &most)) / &matrices.h
            }
            _ => zero.clone(),
        };
        let now = |s: usize, power: usize| {
            let column = &matrices.columns[s];
            match signals[s].part {
                Part::Held => held(column, power),
                Part::Start => risen(column, power),
                Part::Runs | Part::Curves | Part::End => &held(column, power) - &risen(column, power),
            }
        };
        let before = |s: usize, power: usize| match signals[s].part {
            Part::Runs | Part::Curves => risen(&matrices.columns[s], power),
            Part::Held | Part::Start | Part::End => zero.clone(),
        };
        Ok(Self {
            row,
            now: Matrix::from_fn(signals.len(), degree + 3, now),
            before: Matrix::from_fn(signals.len(), degree + 3, before),
            constant: Matrix::from_fn(1, degree + 3, |_, power| held(&matrices.offset, power)),
            most,
        })
    }
}

impl Ages {
    /// Rounds the series once.
    pub(crate) fn rounded(pass: &mut Pass, coarse: &ExactAges, fine: &ExactAges) -> Self {
        let mut sparse = |c: &Matrix, f: &Matrix| -> Sparse {
            let row = |m: &Matrix, i: usize| -> Vec<Real> { (0..m.cols()).map(|j| m.get(i, j).clone()).collect() };
            (0..c.rows()).map(|i| pass.each(&row(c, i), &row(f, i))).collect()
        };
        let (row, now) = (sparse(&coarse.row, &fine.row), sparse(&coarse.now, &fine.now));
        let before = sparse(&coarse.before, &fine.before);
        let constant = sparse(&coarse.constant, &fine.constant).remove(0);
        let one = Real::one(fine.most.precision());
        let scale = Settled::round(&one.checked_div(&fine.most).unwrap_or(one));
        Self { most: Settled::round(&fine.most), scale, row, now, before, constant }
    }

    /// The oldest age that is used, as the step compares with.
    pub fn oldest(&self, scalar: Scalar) -> f64 {
        self.most.value(scalar)
    }

    /// Sum of the magnitudes of a series.
    fn size(series: &[Option<Settled>]) -> f64 {
        series.iter().flatten().map(|weight| weight.double.abs()).sum()
    }

    /// The largest entry of `C e^{-A a}` by state, from above.
    pub fn largest_row(&self) -> Vec<f64> {
        self.row.iter().map(|series| Self::size(series)).collect()
    }

    /// The most that signals of magnitude 1 add to a sample.
    pub fn largest_share(&self) -> f64 {
        let signals = self.now.iter().chain(&self.before);
        signals.map(|series| Self::size(series)).sum::<f64>() + Self::size(&self.constant)
    }
}
