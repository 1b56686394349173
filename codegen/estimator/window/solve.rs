//! The weights of the least-squares functional, at a given precision.
//!
//! `K = Phi^N (W O)^+ W` with W what the samples count by (one over the noise of their output, where several
//! outputs declare theirs; else 1) and `O = [C; C Phi; …; C Phi^N]`, referenced to the window's start and solved by an
//! orthogonal method: referenced to its end it would be ill conditioned for fast stable modes.
//! M follows without an inverse (window-observers, section 2):
//!
//! `acc_1 = I - K_0 C`, `acc_{i+1} = acc_i Phi - K_i C`, `M_i = acc_i Gamma`, and `acc_{N+1} = 0`
//! says that the estimate is unbiased; every design checks it.
//!
//! An output that arrives d samples late has rows `C Phi^{N-s}` only for states of age s >= d; its
//! weight at call age j is that of state age j + d. Nothing else changes.

use crate::real::{Matrix, Precision, RankDeficient, Real, pseudo_inverse};
use crate::sampled::observability::{observability, output_powers};

use super::minimax;
use crate::sampled::model::{Effect, Model};
use crate::sampled::unknowns::stages::Stages;
use crate::sampled::{Part, Signal};

/// Which of the unbiased weights are taken.
#[derive(Clone, Debug)]
pub enum Choice {
    /// Least squares: the smallest gain from white noise.
    LeastSquares,
    /// The smallest gain from bounded noise; per state the rows that carry its weights.
    Rows(Vec<Vec<usize>>),
    /// 002's two stages.
    Stages(Stages),
}

/// All numbers of a functional, before they are rounded.
#[derive(Clone, Debug)]
pub struct Exact {
    /// The sampled plant.
    pub model: Model,
    /// Per output and state: weights by call age from 0.
    pub outputs: Vec<Vec<Vec<Real>>>,
    /// Per signal and state: weights by call age from [`Exact::first`].
    pub knowns: Vec<Vec<Vec<Real>>>,
    /// Per signal: the first call age with a weight.
    pub first: Vec<usize>,
    /// n: what the constant terms add.
    pub constant: Vec<Real>,
    /// Per output.
    pub prediction: Vec<ExactPrediction>,
    /// `acc_1 … acc_N`, n x n each: what a disturbance of the state leaves in the estimate, by age.
    pub accumulated: Vec<Matrix>,
    /// Largest entry of `acc_{N+1}` against its history.
    pub unbiasedness: f64,
}

/// The one-step prediction of an output.
#[derive(Clone, Debug)]
pub struct ExactPrediction {
    /// Per state.
    pub states: Vec<Real>,
    /// Per signal: the whole effect of a value that stays; of a start, with its end's.
    pub held: Vec<Real>,
    /// Per signal: the end alone.
    pub end: Vec<Real>,
    /// Of the constant terms.
    pub constant: Real,
}

impl Exact {
    /// Solves for the weights.
    pub fn new(
        model: Model,
        signals: &[Signal],
        delays: &[usize],
        steps: usize,
        choice: &Choice,
        p: Precision,
    ) -> Result<Self, RankDeficient> {
        let n = model.phi.rows();
        let powers = output_powers(&model, steps);
        let (observability, rows) = observability(&powers, delays);
        let trust: Vec<Real> = rows.iter().map(|(_, output)| model.trust[*output].clone()).collect();
        let through = model.phi.powi(steps as u64);
        let weights = match choice {
            Choice::LeastSquares => least_squares(&observability, &trust, &through)?,
            Choice::Rows(chosen) => smallest_gain(chosen, &observability, &through)?,
            Choice::Stages(stages) => {
                let by_age = stages.weights(&model).map_err(|error| RankDeficient { column: error.column })?;
                Matrix::from_fn(n, rows.len(), |i, r| by_age[rows[r].0 - delays[rows[r].1]].get(i, 0).clone())
            }
        };
        let mut by_age = vec![Matrix::zeros(n, delays.len(), p); steps + 1];
        for (place, (age, output)) in rows.iter().enumerate() {
            for i in 0..n {
                by_age[*age][(i, *output)] = weights.get(i, place).clone();
            }
        }
        let (accumulated, unbiasedness) = accumulate(&model, &by_age, &powers, p);
        Ok(Self::assembled(model, signals, delays, &by_age, accumulated, unbiasedness))
    }

    /// From weights that are known, by age: `steps` + 1 of n x p.
    pub fn from_weights(model: Model, signals: &[Signal], by_age: &[Matrix]) -> Self {
        let steps = by_age.len() - 1;
        let (p, delays) = (model.phi.precision(), vec![0; model.c.rows()]);
        let (accumulated, unbiasedness) = accumulate(&model, by_age, &output_powers(&model, steps), p);
        Self::assembled(model, signals, &delays, by_age, accumulated, unbiasedness)
    }

    fn assembled(
        model: Model,
        signals: &[Signal],
        delays: &[usize],
        by_age: &[Matrix],
        accumulated: Vec<Matrix>,
        unbiasedness: f64,
    ) -> Self {
        let outputs = by_output(by_age, delays);
        let first = first_ages(&model.effects);
        let knowns = model.effects.iter().zip(signals).map(|(e, s)| known_weights(e, &accumulated, s.part)).collect();
        let constant = of_constant(&accumulated, &model.constant);
        let prediction = (0..delays.len()).map(|o| predict(&model, signals, o, delays[o])).collect();
        Self { model, outputs, knowns, first, constant, prediction, accumulated, unbiasedness }
    }
}

/// Weights by output, state and call age.
pub fn by_output(by_age: &[Matrix], delays: &[usize]) -> Vec<Vec<Vec<Real>>> {
    let of = |o: usize, i: usize| by_age[delays[o]..].iter().map(|weights| weights.get(i, o).clone()).collect();
    (0..delays.len()).map(|o| (0..by_age[0].rows()).map(|i| of(o, i)).collect()).collect()
}

/// Per signal, the first call age with a weight.
pub fn first_ages(effects: &[Effect]) -> Vec<usize> {
    effects.iter().map(|effect| usize::from(effect.at_end.is_none())).collect()
}

/// What a constant drift adds.
pub fn of_constant(accumulated: &[Matrix], constant: &Matrix) -> Vec<Real> {
    let zero = Matrix::zeros(constant.rows(), 1, constant.precision());
    let sum = accumulated.iter().fold(zero, |sum, acc| &sum + &(acc * constant));
    (0..constant.rows()).map(|i| sum.get(i, 0).clone()).collect()
}

/// Rows times what they count by.
pub fn trusted(rows: &Matrix, trust: &[Real]) -> Matrix {
    Matrix::from_fn(rows.rows(), rows.cols(), |i, j| rows.get(i, j) * &trust[i])
}

/// The weights by state and row.
fn least_squares(observability: &Matrix, trust: &[Real], through: &Matrix) -> Result<Matrix, RankDeficient> {
    let inverse = pseudo_inverse(&trusted(observability, trust))?;
    Ok(through * &trusted(&inverse.transpose(), trust).transpose())
}

/// Likewise, from the rows that carry them.
fn smallest_gain(rows: &[Vec<usize>], observability: &Matrix, through: &Matrix) -> Result<Matrix, RankDeficient> {
    let (n, p) = (through.rows(), through.precision());
    let mut weights = Matrix::zeros(n, observability.rows(), p);
    for (i, chosen) in rows.iter().enumerate() {
        let values = minimax::weights(observability, chosen, &through.block(i..i + 1, 0..n));
        for (row, value) in chosen.iter().zip(values.ok_or(RankDeficient { column: i })?) {
            weights[(i, *row)] = value;
        }
    }
    Ok(weights)
}

/// `acc_1 … acc_N`, and how far `acc_{N+1}` is from zero.
///
/// Column j of acc is measured in what the outputs see of state j, so that it has the unit of K's rows; the
/// distance of a row is against the largest entry of K and of acc's history in that row.
pub fn accumulate(model: &Model, by_age: &[Matrix], powers: &[Matrix], p: Precision) -> (Vec<Matrix>, f64) {
    let n = model.phi.rows();
    let mut acc = &Matrix::identity(n, p) - &(&by_age[0] * &model.c);
    let mut all = Vec::new();
    for weights in &by_age[1..] {
        all.push(acc.clone());
        acc = &(&acc * &model.phi) - &(weights * &model.c);
    }
    let largest = |entries: &mut dyn Iterator<Item = Real>| entries.max().unwrap_or_else(|| Real::zero(p));
    let seen: Vec<Real> = (0..n)
        .map(|j| largest(&mut powers.iter().flat_map(|m| (0..m.rows()).map(move |o| m.get(o, j).abs()))))
        .collect();
    let row = |m: &Matrix, i: usize| {
        let scaled = (0..n).filter(|j| !seen[*j].is_zero()).map(|j| &m.get(i, j).abs() / &seen[j]);
        scaled.max().unwrap_or_else(|| Real::zero(p))
    };
    let distance = |i: usize| {
        let history = largest(&mut all.iter().map(|m| row(m, i)));
        let weights = largest(&mut by_age.iter().flat_map(|m| (0..m.cols()).map(move |o| m.get(i, o).abs())));
        let bias = row(&acc, i);
        let scale = history.max(weights);
        if bias.is_zero() { 0.0 } else { bias.checked_div(&scale).map_or(f64::INFINITY, |ratio| ratio.to_f64()) }
    };
    let worst = (0..n).map(distance).fold(0.0, f64::max);
    (all, worst)
}

/// M of one signal, per state, by call age.
pub fn known_weights(effect: &Effect, accumulated: &[Matrix], part: Part) -> Vec<Vec<Real>> {
    let columns: Vec<Matrix> = match &effect.curve {
        Some(curve) => curve_weights(curve, accumulated),
        None => line_weights(effect, accumulated, part),
    };
    let n = accumulated.first().map_or(0, Matrix::rows);
    (0..n).map(|i| columns.iter().map(|column| column.get(i, 0).clone()).collect()).collect()
}

/// An interval's effect belongs to the values at its begin and its end.
fn line_weights(effect: &Effect, accumulated: &[Matrix], part: Part) -> Vec<Matrix> {
    let steps = accumulated.len();
    let ages = match (part, &effect.at_begin, &effect.at_end) {
        (Part::Runs | Part::Curves, Some(_), Some(_)) => 0..=steps,
        (Part::Runs | Part::Curves, _, None) => 1..=steps,
        _ => 0..=steps - 1,
    };
    ages.map(|age| {
        let end = effect.at_end.as_ref().filter(|_| age < steps).map(|gamma| &accumulated[age] * gamma);
        let begin = effect.at_begin.as_ref().filter(|_| age > 0).map(|gamma| &accumulated[age - 1] * gamma);
        match (begin, end) {
            (Some(begin), Some(end)) => &begin + &end,
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => unreachable!("every age in the range has an effect"),
        }
    })
    .collect()
}

/// An interval's effect belongs to four samples, in the middle of which it lies where the window allows.
fn curve_weights(curve: &[[Matrix; 4]; 3], accumulated: &[Matrix]) -> Vec<Matrix> {
    let steps = accumulated.len();
    let n = accumulated[0].rows();
    let mut columns = vec![Matrix::zeros(n, 1, accumulated[0].precision()); steps + 1];
    for (newer, acc) in accumulated.iter().enumerate() {
        // The interval from age `newer + 1` to age `newer`.
        let start = if newer == 0 { 2 } else { usize::from(newer + 1 < steps) };
        for (node, factor) in curve[start].iter().enumerate() {
            let age = newer + 1 + start - node;
            columns[age] = &columns[age] + &(acc * factor);
        }
    }
    columns
}

/// How an output's next sample is predicted from the estimate.
pub fn predict(model: &Model, signals: &[Signal], output: usize, delay: usize) -> ExactPrediction {
    let n = model.phi.rows();
    let c = model.c.block(output..output + 1, 0..n);
    let row = if delay == 0 { &c * &model.phi } else { c.clone() };
    let zero = Real::zero(model.phi.precision());
    let through = |gamma: &Option<Matrix>| match gamma {
        Some(gamma) if delay == 0 => (&c * gamma).get(0, 0).clone(),
        _ => zero.clone(),
    };
    let end: Vec<Real> = model.effects.iter().map(|e| through(&e.at_end)).collect();
    let whole = |s: usize| match signals.get(s + 1) {
        Some(next) if next.part == Part::End => &end[s] + &end[s + 1],
        _ => &through(&model.effects[s].at_begin) + &end[s],
    };
    let held = (0..signals.len()).map(whole).collect();
    let constant = through(&Some(model.constant.clone()));
    ExactPrediction { states: (0..n).map(|j| row.get(0, j).clone()).collect(), held, end, constant }
}
