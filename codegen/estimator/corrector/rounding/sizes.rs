//! How large the numbers of a corrector's step are, for samples within their range.
//!
//! An estimate is at most its gains times the samples, and where samples show it, their range and its error; an
//! innovation what noise and errors make of it.

use nalgebra::{DMatrix, DVector};

use super::super::errors::{Errors, Sums};
use super::super::{Corrector, Frame};
use crate::expr::Symbol;
use crate::numbers::count;
use crate::plant::Plant;
use crate::program::builder::additions;
use crate::promise::kernel::{Kernel, range};
use crate::promise::rounding::{of_product, output, signal, unit};
use crate::sampled::settled::Settled;

/// How large the numbers of a step are, for the samples, inputs and terms of `promise::rounding`.
pub(super) struct Sizes {
    /// Of what a step carries, n.
    pub(super) carried: DVector<f64>,
    /// The same, predicted.
    pub(super) predicted: DVector<f64>,
    /// Of the states, n.
    pub(super) states: DVector<f64>,
    /// Per signal.
    pub(super) signals: Vec<f64>,
    /// Per output, y - C z-.
    pub(super) innovations: DVector<f64>,
}

impl Sizes {
    pub(super) fn new(plant: &Plant, design: &Corrector, errors: &Errors, worst: &Sums, noise: &[Option<f64>]) -> Self {
        let n = plant.states.len();
        let outputs = DVector::from_iterator(plant.outputs.len(), plant.outputs.iter().map(output));
        let signals: Vec<f64> = design.signals.iter().map(|it| signal(plant, it)).collect();
        let constant = DVector::from_iterator(n, design.constant.iter().map(|entry| size(*entry)));
        let known = &worst.signals * DVector::from_column_slice(&signals);
        let mut states = &worst.noise * &outputs + known + &worst.carried * constant;
        for (j, size) in states.iter_mut().enumerate() {
            // A state that samples show is within their range, but for its error.
            let shown = range(plant, Symbol::State(j)).magnitude() + noise[j].unwrap_or(f64::INFINITY);
            *size = size.min(shown);
        }
        let carried = errors.into_carried.abs() * &states;
        let mut sizes =
            Self { predicted: carried.clone(), carried, states, signals, innovations: DVector::zeros(outputs.len()) };
        sizes.predicted = DVector::from_iterator(n, (0..n).map(|i| sizes.terms(design, i, false).sum()));
        sizes.innovations = outputs + shown(design) * &sizes.predicted;
        if let Some(explained) = explained(plant, errors, noise) {
            let own = &sizes.innovations * (8.0 * unit(plant.scalar));
            sizes.innovations = sizes.innovations.inf(&(explained + own));
        }
        sizes
    }

    /// The terms that a coordinate is predicted from; of what it grows by, where two floats carry it.
    pub(super) fn terms(&self, design: &Corrector, i: usize, twofold: bool) -> Terms {
        let Frame::Plant { phi, growth, .. } = &design.frame else {
            let above = (i + 1..self.carried.len()).map(|j| self.carried[j]).sum();
            let own = if twofold { 0.0 } else { self.carried[i] };
            return Terms(vec![(own, 0.0), (above, 0.0)]);
        };
        let mut row = phi[i].clone();
        if twofold {
            row[i] = growth[i];
        }
        let there = row.iter().zip(&self.carried).filter(|(factor, _)| factor.is_some());
        let mut terms: Vec<(f64, f64)> = there.map(|(factor, x)| (size(*factor) * x, of_product(*factor))).collect();
        for (s, signal) in self.signals.iter().enumerate() {
            let factors = [design.at_begin[s][i], design.at_end[s][i]];
            terms.extend(
                factors.iter().flatten().map(|factor| (size(Some(*factor)) * signal, of_product(Some(*factor)))),
            );
        }
        terms.extend(design.constant[i].map(|entry| (size(Some(entry)), 1.0)));
        Terms(terms)
    }
}

/// How large innovations are by noise, disturbances and the errors that these make; `None` where something else does.
fn explained(plant: &Plant, errors: &Errors, noise: &[Option<f64>]) -> Option<DVector<f64>> {
    if !plant.injections.is_empty() {
        return None;
    }
    let mut disturbed = DMatrix::zeros(plant.outputs.len(), plant.disturbances.len());
    Kernel::new(plant)?.add(&errors.shown(), &mut disturbed);
    let forces = plant.disturbances.iter().map(|disturbance| disturbance.bound.to_f64().ok());
    let forces: Vec<f64> = forces.collect::<Option<_>>()?;
    let bounds: Vec<f64> = noise.iter().copied().collect::<Option<_>>()?;
    let levels = plant.outputs.iter().map(|output| output.noise.as_ref()?.to_f64().ok());
    let levels: Vec<f64> = levels.collect::<Option<_>>()?;
    Some(
        DVector::from_vec(levels)
            + errors.foretold() * DVector::from_vec(bounds)
            + disturbed * DVector::from_vec(forces),
    )
}

/// Magnitudes of terms, each with the roundings of its product.
pub(super) struct Terms(pub(super) Vec<(f64, f64)>);

impl Terms {
    pub(super) fn sum(&self) -> f64 {
        self.0.iter().map(|(term, _)| term).sum()
    }

    /// What their products and their sum lose, in units.
    pub(super) fn loses(&self) -> f64 {
        let products: f64 = self.0.iter().map(|(term, roundings)| term * roundings).sum();
        products + count(additions(self.0.len())) * self.sum()
    }
}

/// |C| of what a step carries, p x n.
pub(super) fn shown(design: &Corrector) -> DMatrix<f64> {
    match design.frame {
        Frame::Plant { .. } => {
            let (p, n) = (design.output.len(), design.twofold.len());
            DMatrix::from_fn(p, n, |o, j| size(design.output[o][j]))
        }
        Frame::Chain { .. } => DMatrix::from_fn(1, design.twofold.len(), |_, j| if j == 0 { 1.0 } else { 0.0 }),
    }
}

pub(super) fn size(entry: Option<Settled>) -> f64 {
    entry.map_or(0.0, |entry| entry.double.abs())
}
