//! What a disturbance does to an estimate over one sample interval, and how steep a nonlinear term is.

use crate::expr::Symbol;
use crate::expr::bounds::{Interval, derivative, enclose};
use crate::plant::{Disturbance, Plant};
use crate::real::{Matrix, Precision, Real, exponential, zero_order_hold};

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

/// Sub-intervals of a sample interval in which a disturbance's kernel is integrated.
const PARTS: i64 = 8;
