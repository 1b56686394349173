//! The numbers of a regression, at a given precision.

use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::solve::{ExactPrediction, predict};
use crate::expr::Constant;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, exponential, orthonormal};
use crate::sampled::model::{Effect, Model, continuous_effect, discrete_effect};
use crate::sampled::observability::{observability, output_powers};
use crate::sampled::settle::{Numerics, rising};
use crate::sampled::unknowns::augment::{own_states, without};
use crate::sampled::unknowns::functions::Functions;
use crate::sampled::{Part, Signal, Source};

use super::Regression;
use super::bound::reach;

/// Bits at which the scales are chosen.
const BITS: usize = 256;

/// All numbers of a regression, before they are rounded.
#[derive(Clone, Debug)]
pub struct Exact {
    /// The sampled plant without the unknowns whose gammas vary.
    pub model: Model,
    /// Per unknown and signal.
    pub gammas: Vec<Vec<Effect>>,
    /// What the samples of each output count by, the largest 1.
    pub(super) trust: Vec<Real>,
    /// Trust times C.
    pub(super) shown: Matrix,
    /// o by sample, p x n each.
    pub(super) rows: Vec<Matrix>,
    /// `Phi^N R^-1`.
    pub(super) through: Matrix,
    /// Per output, of what is not a regressor.
    pub(super) prediction: Vec<ExactPrediction>,
}

/// What a regression is of.
pub struct Problem<'a> {
    /// With its unknowns as states and their functions as injections.
    pub plant: &'a Plant,
    /// Of its gammas.
    pub functions: Functions,
    /// Of the plant.
    pub signals: &'a [Signal],
    /// Whole samples, per output.
    pub delays: &'a [usize],
    /// N.
    pub steps: usize,
    /// The smallest share of a regressor's energy that the state cannot explain.
    pub threshold: f64,
}

impl Problem<'_> {
    /// The plant without the unknowns whose gammas vary.
    fn base(&self) -> Plant {
        without(self.plant, &self.functions.unknowns)
    }

    /// Solves at rising precision until every constant has settled.
    pub fn settle(&self) -> Result<(Regression, Exact, Numerics), Vec<Diagnostic>> {
        let base = self.base();
        let first = self.exact(&base, &vec![0; self.functions.unknowns.len()], Precision::bits(BITS))?;
        let shifts: Vec<i64> = (0..first.gammas.len()).map(|i| first.shift(i, self.steps)).collect();
        let run = |p: Precision| self.exact(&base, &shifts, p);
        rising(self.plant, run, |pass, coarse, fine| self.round(pass, coarse, fine, &shifts), |_| 0.0)
    }

    fn exact(&self, base: &Plant, shifts: &[i64], p: Precision) -> Result<Exact, Vec<Diagnostic>> {
        let model = Model::new(base, self.signals, p)?;
        let gammas = self.gammas(base, shifts, p)?;
        let largest = model.trust.iter().max().cloned().unwrap_or_else(|| Real::one(p));
        let trust: Vec<Real> = model.trust.iter().map(|t| t / &largest).collect();
        let shown = Matrix::from_fn(model.c.rows(), model.c.cols(), |i, j| model.c.get(i, j) * &trust[i]);
        let powers = output_powers(&model, self.steps);
        let (matrix, of) = observability(&powers, self.delays);
        let weighted = Matrix::from_fn(matrix.rows(), matrix.cols(), |r, j| matrix.get(r, j) * &trust[of[r].1]);
        let (basis, inverse) = orthonormal(&weighted).map_err(|error| {
            let message = "the window does not determine the state";
            vec![Diagnostic::error(codes::UNOBSERVABLE, base.span.clone(), message).label(error.to_string())]
        })?;
        let mut rows = vec![Matrix::zeros(self.delays.len(), basis.cols(), p); self.steps + 1];
        for (place, (age, output)) in of.iter().enumerate() {
            for j in 0..basis.cols() {
                rows[self.steps - age][(*output, j)] = basis.get(place, j).clone();
            }
        }
        let through = &model.phi.powi(self.steps as u64) * &inverse;
        let prediction = (0..self.delays.len()).map(|o| predict(&model, self.signals, o, self.delays[o])).collect();
        Ok(Exact { model, gammas, trust, shown, rows, through, prediction })
    }

    /// What each gamma does over one interval, by signal.
    fn gammas(&self, base: &Plant, shifts: &[i64], p: Precision) -> Result<Vec<Vec<Effect>>, Vec<Diagnostic>> {
        let (n, own) = (base.states.len(), own_states(self.plant));
        let a = matrix(&base.a, base, p)?;
        let h = value(&base.sample_time.0, base, p)?;
        let too_fast = |_| {
            let message = "the factors of the unknowns change too fast for this sample time";
            vec![
                Diagnostic::error(codes::OUT_OF_RANGE, base.sample_time.1.clone(), message)
                    .help("a shorter sample time"),
            ]
        };
        let system = matrix(&self.functions.change, base, p)?;
        let mut all = Vec::new();
        for (i, shift) in shifts.iter().enumerate() {
            let mut effects = vec![Effect::default(); self.signals.len()];
            for (k, entries) in &self.functions.lines[i] {
                let column = column(entries, n, base, p)?.shifted(*shift);
                for (s, signal) in self.of_injection(*k) {
                    effects[s] = if base.discrete {
                        discrete_effect(signal.part, column.clone())
                    } else {
                        continuous_effect(signal.part, &a, &column, &h).map_err(too_fast)?
                    };
                }
            }
            let members = self.functions.members.len();
            if !self.functions.flows[i].is_empty() {
                let mut enters = Matrix::zeros(own, members, p);
                for (m, entries) in &self.functions.flows[i] {
                    enters.set_block(0, *m, &column(entries, own, base, p)?.shifted(*shift));
                }
                let mut block = Matrix::zeros(n + members, n + members, p);
                block.set_block(0, 0, &a.scale(&h));
                block.set_block(0, n, &enters.scale(&h));
                block.set_block(n, n, &system.scale(&h));
                let flow = exponential(&block).map_err(too_fast)?;
                for (m, k) in self.functions.members.iter().enumerate() {
                    let effect = flow.block(0..n, n + m..n + m + 1);
                    for (s, signal) in self.of_injection(*k) {
                        // A constant is held: the value that the interval's end brings is that of its start.
                        let place =
                            if signal.part == Part::Held { &mut effects[s].at_end } else { &mut effects[s].at_begin };
                        *place = Some(effect.clone());
                    }
                }
            }
            all.push(effects);
        }
        Ok(all)
    }

    fn of_injection(&self, k: usize) -> impl Iterator<Item = (usize, &Signal)> {
        self.signals.iter().enumerate().filter(move |(_, signal)| signal.source == Source::Injection(k))
    }
}

impl Exact {
    /// The power of two that brings an unknown's response, for values of 1, to order one.
    fn shift(&self, unknown: usize, steps: usize) -> i64 {
        let (phi, shown) = (self.model.phi.to_f64(), self.shown.to_f64());
        let columns: Vec<Vec<f64>> = self.gammas[unknown]
            .iter()
            .flat_map(|effect| [&effect.at_begin, &effect.at_end])
            .flatten()
            .map(|m| m.to_f64().into_iter().map(|row| row[0]).collect())
            .collect();
        let largest = reach(&phi, &columns, &shown, steps).1;
        let exponent = |value: &f64| -> Option<i64> {
            (value.is_finite() && *value > 0.0).then(|| Real::from_f64(*value, Precision::bits(BITS))?.top()).flatten()
        };
        -exponent(&largest).unwrap_or(0)
    }

    /// What a signal's value adds to an output's next sample, for a unit of an unknown.
    pub(super) fn ahead(
        &self,
        signals: &[Signal],
        (output, delay): (usize, usize),
        signal: usize,
        unknown: usize,
        end: bool,
    ) -> Real {
        let n = self.model.phi.rows();
        let c = self.model.c.block(output..output + 1, 0..n);
        let effects = &self.gammas[unknown];
        let through = |gamma: Option<&Matrix>| match gamma {
            Some(gamma) if delay == 0 => (&c * gamma).get(0, 0).clone(),
            _ => Real::zero(c.precision()),
        };
        let own = through(effects[signal].at_end.as_ref());
        if end {
            return own;
        }
        match signals.get(signal + 1) {
            Some(next) if next.part == Part::End => own + through(effects[signal + 1].at_end.as_ref()),
            _ => own + through(effects[signal].at_begin.as_ref()),
        }
    }
}

fn value(constant: &Constant, plant: &Plant, p: Precision) -> Result<Real, Vec<Diagnostic>> {
    constant.evaluate(p).map_err(|error| {
        let message = "a constant in the factor of an unknown has no usable value";
        vec![Diagnostic::error(codes::DOMAIN, plant.span.clone(), message).label(error.0)]
    })
}

fn matrix(rows: &[Vec<Constant>], plant: &Plant, p: Precision) -> Result<Matrix, Vec<Diagnostic>> {
    let values: Vec<Vec<Real>> = rows
        .iter()
        .map(|row| row.iter().map(|entry| value(entry, plant, p)).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()?;
    Ok(Matrix::from_fn(rows.len(), rows.first().map_or(0, Vec::len), |i, j| values[i][j].clone()))
}

/// A column with zeros below it.
fn column(entries: &[Constant], n: usize, plant: &Plant, p: Precision) -> Result<Matrix, Vec<Diagnostic>> {
    let values: Vec<Real> = entries.iter().map(|entry| value(entry, plant, p)).collect::<Result<_, _>>()?;
    Ok(Matrix::from_fn(n, 1, |i, _| values.get(i).cloned().unwrap_or_else(|| Real::zero(p))))
}
