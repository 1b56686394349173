//! What a window functional promises: sums over its weights (window-observers, section 5).
//!
//! The gain from bounded noise is the sum of the weights' magnitudes and is attained; that from
//! white noise is their root sum of squares. A disturbance is bounded but otherwise free: its gain is
//! the integral of the magnitude of its kernel, from above. Noise also enters through the nonlinear
//! injections, by their slopes over the declared ranges. What none of this covers is the straight
//! line between samples: its error is of second order in the sample time.

use nalgebra::DMatrix;

use crate::plant::Plant;
use crate::promise::Certificate;
use crate::promise::kernel::{Kernel, slope};
use crate::real::{Matrix, rows};

use super::Functional;
use super::realize::ages::AtAge;
use super::solve::Exact;
use crate::sampled::Source;

/// Sums up a functional.
pub fn certify(plant: &Plant, functional: &Functional, exact: &Exact) -> Certificate {
    let n = plant.states.len();
    let gain = |sum: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..n).map(|i| (0..plant.outputs.len()).map(|o| sum(i, o)).collect()).collect()
    };
    let noise_gain_l1 = gain(&|i, o| functional.outputs[o].l1(i));
    let noise_gain_l2 = gain(&|i, o| deadbeat_math::sqrt_f64(functional.outputs[o].sum_of_squares(i)));
    let disturbance_gain_l1 = disturbance_gains(plant, &exact.accumulated);
    let knowns = |i: usize| -> Vec<f64> { functional.knowns.iter().map(|w| w.l1(i)).collect() };
    let error_bound =
        (0..n).map(|i| error_bound(plant, functional, &noise_gain_l1[i], &disturbance_gain_l1[i], &knowns(i)));
    let error_bound = error_bound.collect();
    Certificate { noise_gain_l1, noise_gain_l2, disturbance_gain_l1, error_bound, ..Certificate::default() }
}

/// Sums up a functional whose window grows from N+1 to 2N samples: the worst of all its ages.
pub fn certify_ages(plant: &Plant, functional: &Functional, ages: impl Iterator<Item = AtAge>) -> Certificate {
    let (n, p, d) = (plant.states.len(), plant.outputs.len(), plant.disturbances.len());
    let kernel = Kernel::new(plant).filter(|_| d > 0);
    let mut worst = Certificate {
        noise_gain_l1: vec![vec![0.0; p]; n],
        noise_gain_l2: vec![vec![0.0; p]; n],
        disturbance_gain_l1: vec![vec![0.0; d]; n],
        error_bound: vec![Some(0.0); n],
        ..Certificate::default()
    };
    for age in ages {
        let mut disturbed = DMatrix::from_element(n, d, if kernel.is_some() { 0.0 } else { f64::INFINITY });
        if let Some(kernel) = &kernel {
            let of = |acc: &Vec<Vec<f64>>| DMatrix::from_fn(n, n, |i, j| acc[i][j]);
            age.accumulated.iter().for_each(|acc| kernel.add(&of(acc), &mut disturbed));
        }
        for (i, disturbed) in rows(&disturbed).iter().enumerate() {
            let noise: Vec<f64> = age.outputs[i].iter().map(|(sum, _)| *sum).collect();
            for (o, (sum, squares)) in age.outputs[i].iter().enumerate() {
                worst.noise_gain_l1[i][o] = worst.noise_gain_l1[i][o].max(*sum);
                worst.noise_gain_l2[i][o] = worst.noise_gain_l2[i][o].max(deadbeat_math::sqrt_f64(*squares));
            }
            for (worst, gain) in worst.disturbance_gain_l1[i].iter_mut().zip(disturbed) {
                *worst = worst.max(*gain);
            }
            let bound = error_bound(plant, functional, &noise, disturbed, &age.knowns[i]);
            worst.error_bound[i] = worst.error_bound[i].zip(bound).map(|(a, b)| a.max(b));
        }
    }
    worst
}

/// The largest error of a state for the declared noise and disturbances; `None` where something is unbounded.
pub fn error_bound(
    plant: &Plant,
    functional: &Functional,
    noise: &[f64],
    disturbance: &[f64],
    knowns: &[f64],
) -> Option<f64> {
    let mut bound = 0.0;
    for (o, output) in plant.outputs.iter().enumerate() {
        let level = output.noise.as_ref()?.to_f64().ok()?;
        bound += noise[o] * level;
        for (s, signal) in functional.signals.iter().enumerate() {
            if let Source::Injection(k) = signal.source {
                let slope = slope(plant, k, o)?;
                bound += knowns[s] * slope * level;
            }
        }
    }
    for (d, gain) in plant.disturbances.iter().zip(disturbance) {
        bound += gain * d.bound.to_f64().ok()?;
    }
    bound.is_finite().then_some(bound)
}

/// Sum over the window of the integral of `|acc_i e^{A s} d|`, from above.
pub fn disturbance_gains(plant: &Plant, accumulated: &[Matrix]) -> Vec<Vec<f64>> {
    let n = plant.states.len();
    let Some(kernel) = Kernel::new(plant) else {
        return vec![vec![f64::INFINITY; plant.disturbances.len()]; n];
    };
    let mut gains = DMatrix::zeros(n, plant.disturbances.len());
    let matrices: Vec<DMatrix<f64>> = accumulated.iter().map(Matrix::doubles).collect();
    // What is zero in exact arithmetic is left at about 1e-150 of the rest by 512 bits.
    let floor = matrices.iter().flatten().fold(0.0_f64, |largest, x| largest.max(x.abs())) * 1e-100;
    for mut acc in matrices {
        acc.iter_mut().filter(|x| x.abs() < floor).for_each(|x| *x = 0.0);
        kernel.add(&acc, &mut gains);
    }
    rows(&gains)
}
