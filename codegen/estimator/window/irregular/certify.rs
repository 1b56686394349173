//! What an estimate from the samples that are there promises, with the samples of a pattern: the worst of its phases.

use crate::plant::Plant;
use crate::promise::{Certificate, Phase};
use crate::real::{Matrix, Real};

use super::super::Functional;
use super::super::certificate::{disturbance_gains, error_bound};
use super::super::solve::{Exact, known_weights};
use super::Irregular;
use crate::sampled::model::Model;

/// Gains at the worst phase of the pattern, and those of all phases; `None` where its samples are too few.
///
/// The error bound holds while no sample of the pattern is lost; beside it stand those with losses.
pub fn certify(
    plant: &Plant,
    functional: &Functional,
    irregular: &Irregular,
    exact: &Exact,
) -> Option<(Certificate, Vec<Phase>)> {
    let (mut certificate, phases) = worst(plant, functional, irregular, exact, None)?;
    certificate.error_bound_with_losses = irregular.bound_with_losses(plant, functional, exact);
    if plant.outputs.len() > 1 {
        let without = |o: usize| {
            let rest =
                worst(plant, functional, irregular, exact, Some(o)).filter(|_| irregular.determined_without(o))?;
            Some(rest.0.error_bound)
        };
        certificate.error_bound_without = (0..plant.outputs.len()).map(without).collect();
    }
    Some((certificate, phases))
}

/// Gains at the worst phase, with all samples of one output lost, or of none.
fn worst(
    plant: &Plant,
    functional: &Functional,
    irregular: &Irregular,
    exact: &Exact,
    lost: Option<usize>,
) -> Option<(Certificate, Vec<Phase>)> {
    let n = plant.states.len();
    let zeros = |columns: usize| vec![vec![0.0; columns]; n];
    let mut worst = Certificate {
        noise_gain_l1: zeros(plant.outputs.len()),
        noise_gain_l2: zeros(plant.outputs.len()),
        disturbance_gain_l1: zeros(plant.disturbances.len()),
        error_bound: vec![Some(0.0); n],
        ..Certificate::default()
    };
    let mut phases = Vec::new();
    for phase in irregular.pattern.phases() {
        let weights = irregular.weights(&|age, o| lost != Some(o) && irregular.pattern.there(phase, age, o))?;
        let gains = noise_gains(&weights);
        raise(&mut worst.noise_gain_l1, &gains.noise_gain_l1);
        raise(&mut worst.noise_gain_l2, &gains.noise_gain_l2);
        let accumulated = accumulated(&exact.model, &weights)?;
        let disturbance = disturbance_gains(plant, &accumulated);
        raise(&mut worst.disturbance_gain_l1, &disturbance);
        let knowns = known_gains(functional, exact, &accumulated);
        for i in 0..n {
            let knowns: Vec<f64> = knowns.iter().map(|gains| gains[i]).collect();
            let bound = error_bound(plant, functional, &gains.noise_gain_l1[i], &disturbance[i], &knowns);
            worst.error_bound[i] = worst.error_bound[i].zip(bound).map(|(a, b)| a.max(b));
        }
        phases.push(gains);
    }
    Some((worst, phases))
}

/// Entry by entry the larger of both.
fn raise(worst: &mut [Vec<f64>], gains: &[Vec<f64>]) {
    for (worst, gains) in worst.iter_mut().zip(gains) {
        worst.iter_mut().zip(gains).for_each(|(worst, gain)| *worst = worst.max(*gain));
    }
}

fn noise_gains(weights: &[nalgebra::DMatrix<f64>]) -> Phase {
    let (n, p) = weights[0].shape();
    let sums = |sum: &dyn Fn(&mut dyn Iterator<Item = f64>) -> f64| -> Vec<Vec<f64>> {
        (0..n).map(|i| (0..p).map(|o| sum(&mut weights.iter().map(|weights| weights[(i, o)]))).collect()).collect()
    };
    Phase {
        noise_gain_l1: sums(&|weights| weights.map(f64::abs).sum()),
        noise_gain_l2: sums(&|weights| deadbeat_math::sqrt_f64(weights.map(|weight| weight * weight).sum())),
    }
}

/// Per signal and state: the sum of the magnitudes of its weights.
fn known_gains(functional: &Functional, exact: &Exact, accumulated: &[Matrix]) -> Vec<Vec<f64>> {
    let of = |(effect, signal): (&crate::sampled::model::Effect, &crate::sampled::Signal)| -> Vec<f64> {
        let by_state = known_weights(effect, accumulated, signal.part);
        by_state.iter().map(|weights| weights.iter().map(|weight| weight.to_f64().abs()).sum()).collect()
    };
    exact.model.effects.iter().zip(&functional.signals).map(of).collect()
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
