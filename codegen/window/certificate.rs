//! What a window functional promises: sums over its weights (window-observers, section 5).
//!
//! The gain from bounded noise is the sum of the weights' magnitudes and is attained; that from
//! white noise is their root sum of squares. A disturbance is bounded but otherwise free: its gain is
//! the integral of the magnitude of its kernel, from above. Noise also enters through the nonlinear
//! injections, by their slopes over the declared ranges. What none of this covers is the straight
//! line between samples: its error is of second order in the sample time.

use crate::design::Certificate;
use crate::expr::Symbol;
use crate::expr::bounds::{Interval, derivative, enclose};
use crate::plant::{Disturbance, Plant};
use crate::real::{Matrix, Precision, Real, exponential, zero_order_hold};

use super::realize::ages::AtAge;
use super::solve::Exact;
use super::{Functional, Source};

/// Sub-intervals of a sample interval in which a disturbance's kernel is integrated.
const PARTS: i64 = 8;

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
    Certificate { noise_gain_l1, noise_gain_l2, disturbance_gain_l1, error_bound, initial_gain: Vec::new() }
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
        initial_gain: Vec::new(),
    };
    for age in ages {
        let mut disturbed = vec![vec![if kernel.is_some() { 0.0 } else { f64::INFINITY }; d]; n];
        if let Some(kernel) = &kernel {
            age.accumulated.iter().for_each(|acc| kernel.add(acc, &mut disturbed));
        }
        for (i, disturbed) in disturbed.iter().enumerate() {
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

/// The steepest slope of an injection in one output, over the ranges of all outputs.
pub fn slope(plant: &Plant, injection: usize, output: usize) -> Option<f64> {
    let poly = &plant.injections[injection].node.poly;
    let mut steepest = 0.0;
    for (j, state) in plant.states.iter().enumerate() {
        let Some((_, weight)) = state.measured.iter().find(|(o, _)| *o == output) else { continue };
        let slope = enclose(&derivative(poly, Symbol::State(j))?, &|symbol| range(plant, symbol));
        steepest += slope.magnitude() * weight.to_f64().ok()?.abs();
    }
    f64::is_finite(steepest).then_some(steepest)
}

/// The range of what varies, as far as the specification declares it.
pub fn range(plant: &Plant, symbol: Symbol) -> Interval {
    let Symbol::State(j) = symbol else { return Interval::ALL };
    let weights = &plant.states[j].measured;
    let mut sum = Interval::point(0.0);
    for (o, weight) in weights {
        let Some((low, high)) = &plant.outputs[*o].range else { return Interval::ALL };
        let (Ok(low), Ok(high), Ok(weight)) = (low.to_f64(), high.to_f64(), weight.to_f64()) else {
            return Interval::ALL;
        };
        sum = sum.plus(Interval::new(low, high).times(Interval::point(weight)));
    }
    if weights.is_empty() { Interval::ALL } else { sum }
}

/// Sum over the window of the integral of `|acc_i e^{A s} d|`, from above.
pub fn disturbance_gains(plant: &Plant, accumulated: &[Matrix]) -> Vec<Vec<f64>> {
    let n = plant.states.len();
    let Some(kernel) = Kernel::new(plant) else {
        return vec![vec![f64::INFINITY; plant.disturbances.len()]; n];
    };
    let mut gains = vec![vec![0.0; plant.disturbances.len()]; n];
    let matrices: Vec<Vec<Vec<f64>>> = accumulated.iter().map(Matrix::to_f64).collect();
    // What is zero in exact arithmetic is left at about 1e-150 of the rest by 512 bits.
    let floor = matrices.iter().flatten().flatten().fold(0.0_f64, |largest, x| largest.max(x.abs())) * 1e-100;
    for mut acc in matrices {
        acc.iter_mut().flatten().filter(|x| x.abs() < floor).for_each(|x| *x = 0.0);
        kernel.add(&acc, &mut gains);
    }
    gains
}

/// What a disturbance does over one sample interval, cut into parts.
pub(crate) struct Kernel {
    /// Per part: the integral over it, n x d.
    parts: Vec<Vec<Vec<f64>>>,
    /// Per boundary between parts: the kernel there, n x d.
    edges: Vec<Vec<Vec<f64>>>,
    /// A bound on the kernel's slope, entry by entry.
    slope: Vec<Vec<f64>>,
    /// Length of a part, s; 0 for a discrete plant.
    length: f64,
}

impl Kernel {
    /// Of all disturbances; `None` where the plant is too fast for its sample time.
    pub(crate) fn new(plant: &Plant) -> Option<Self> {
        let n = plant.states.len();
        let p = Precision::bits(256);
        let column =
            |d: &Disturbance| Matrix::from_fn(n, 1, |i, _| d.column[i].evaluate(p).unwrap_or_else(|_| Real::zero(p)));
        let columns = plant.disturbances.iter().map(column);
        let all = columns.reduce(|a, b| a.hcat(&b)).unwrap_or_else(|| Matrix::zeros(n, 0, p));
        if plant.discrete || all.cols() == 0 {
            return Some(Self { parts: vec![all.to_f64()], edges: Vec::new(), slope: Vec::new(), length: 0.0 });
        }
        let a = Matrix::from_fn(n, n, |i, j| plant.a[i][j].evaluate(p).unwrap_or_else(|_| Real::zero(p)));
        let h = plant.sample_time.0.evaluate(p).ok()?;
        let length = &h / &Real::from_i64(PARTS, p);
        let (phi, gamma) = zero_order_hold(&a, &all, &length).ok()?;
        let (mut part, mut edge) = (gamma, all.clone());
        let (mut parts, mut edges) = (Vec::new(), vec![edge.to_f64()]);
        for _ in 0..PARTS {
            parts.push(part.to_f64());
            part = &phi * &part;
            edge = &phi * &edge;
            edges.push(edge.to_f64());
        }
        // |e^{A s} A d| <= e^{|A| h} |A| |d|, entry by entry.
        let magnitude = |m: &Matrix| m.map(Real::abs);
        let growth = exponential(&magnitude(&a).scale(&h)).ok()?;
        let slope = (&(&growth * &magnitude(&a)) * &magnitude(&all)).to_f64();
        Some(Self { parts, edges, slope, length: length.to_f64() })
    }

    /// Adds one interval's share for the accumulated matrix of its age.
    pub(crate) fn add(&self, acc: &[Vec<f64>], gains: &mut [Vec<f64>]) {
        let dot = |row: &[f64], m: &[Vec<f64>], d: usize| -> f64 { row.iter().zip(m).map(|(a, r)| a * r[d]).sum() };
        let bound =
            |row: &[f64], m: &[Vec<f64>], d: usize| -> f64 { row.iter().zip(m).map(|(a, r)| a.abs() * r[d]).sum() };
        for (row, gains) in acc.iter().zip(gains) {
            for (d, gain) in gains.iter_mut().enumerate() {
                for (place, part) in self.parts.iter().enumerate() {
                    *gain += dot(row, part, d).abs();
                    if self.length > 0.0 {
                        let steepest = bound(row, &self.slope, d);
                        let near = dot(row, &self.edges[place], d).abs().min(dot(row, &self.edges[place + 1], d).abs());
                        // Where the kernel may change its sign, the two halves cancel in the integral.
                        if near < steepest * self.length {
                            *gain += 0.5 * steepest * self.length * self.length;
                        }
                    }
                }
            }
        }
    }
}
