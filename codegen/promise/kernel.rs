//! What a disturbance does to an estimate over one sample interval, and how steep a nonlinear term is.

use nalgebra::DMatrix;

use crate::expr::Symbol;
use crate::expr::bounds::{Interval, derivative, enclose};
use crate::plant::{Disturbance, Plant};
use crate::real::{Matrix, Precision, Real, exponential, zero_order_hold};

/// What a disturbance does over one sample interval, cut into parts.
pub(crate) struct Kernel {
    /// Per part: the integral over it, n x d.
    parts: Vec<DMatrix<f64>>,
    /// Per boundary between parts: the kernel there, n x d.
    edges: Vec<DMatrix<f64>>,
    /// A bound on the kernel's slope, entry by entry.
    slope: DMatrix<f64>,
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
            let slope = DMatrix::zeros(n, all.cols());
            return Some(Self { parts: vec![all.doubles()], edges: Vec::new(), slope, length: 0.0 });
        }
        let a = Matrix::from_fn(n, n, |i, j| plant.a[i][j].evaluate(p).unwrap_or_else(|_| Real::zero(p)));
        let h = plant.sample_time.0.evaluate(p).ok()?;
        let length = &h / &Real::from_i64(PARTS, p);
        let (phi, gamma) = zero_order_hold(&a, &all, &length).ok()?;
        let (mut part, mut edge) = (gamma, all.clone());
        let (mut parts, mut edges) = (Vec::new(), vec![edge.doubles()]);
        for _ in 0..PARTS {
            parts.push(part.doubles());
            part = &phi * &part;
            edge = &phi * &edge;
            edges.push(edge.doubles());
        }
        // |e^{A s} A d| <= e^{|A| h} |A| |d|, entry by entry.
        let magnitude = |m: &Matrix| m.map(Real::abs);
        let growth = exponential(&magnitude(&a).scale(&h)).ok()?;
        let slope = (&(&growth * &magnitude(&a)) * &magnitude(&all)).doubles();
        Some(Self { parts, edges, slope, length: length.to_f64() })
    }

    /// Per part of an interval: the integral of the kernel over it, n x d.
    pub(crate) fn parts(&self) -> &[DMatrix<f64>] {
        &self.parts
    }

    /// A bound on the kernel's slope, entry by entry; n x d.
    pub(crate) fn slope(&self) -> &DMatrix<f64> {
        &self.slope
    }

    /// Length of a part, s; 0 for a discrete plant.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Adds one interval's share for the accumulated matrix of its age.
    pub(crate) fn add(&self, acc: &DMatrix<f64>, gains: &mut DMatrix<f64>) {
        for i in 0..acc.nrows() {
            for d in 0..gains.ncols() {
                let dot = |m: &DMatrix<f64>| -> f64 { acc.row(i).iter().zip(&m.column(d)).map(|(a, r)| a * r).sum() };
                let gain = &mut gains[(i, d)];
                for (place, part) in self.parts.iter().enumerate() {
                    *gain += dot(part).abs();
                    if self.length > 0.0 {
                        let steepest: f64 =
                            acc.row(i).iter().zip(&self.slope.column(d)).map(|(a, r)| a.abs() * r).sum();
                        let near = dot(&self.edges[place]).abs().min(dot(&self.edges[place + 1]).abs());
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
