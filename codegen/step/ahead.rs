//! The estimate for later: what the model makes of it within `ahead`, with inputs and nonlinear terms as they are now.
//!
//! `x(t + a) = e^{A a} x + integral of e^{A s} ds (B u + c + phi(y, u, t))`: exact for linear plants whose inputs keep
//! their value. Nothing of the observer changes; the answer alone is moved.

use nalgebra::DMatrix;

use crate::diagnostic::{Diagnostic, codes};
use crate::numbers::{count, short};
use crate::plant::Plant;
use crate::program::builder::{Builder, additions};
use crate::program::{Scalar, Value};
use crate::promise::Certificate;
use crate::promise::kernel::{Kernel, slope};
use crate::promise::rounding::{signal, unit};
use crate::real::{Matrix, Precision, Real, rows, zero_order_hold};
use crate::sampled::model::Matrices;
use crate::sampled::samples::whole_samples;
use crate::sampled::settle::{Pass, rising};
use crate::sampled::settled::Settled;
use crate::sampled::{Part, Signal, Source};
use crate::step::injections::{Injections, Moment, Samples};

/// Settled entries; `None` marks a structural zero.
type Column = Vec<Option<Settled>>;

/// How the answer is moved.
#[derive(Clone, Debug)]
pub struct Ahead {
    /// By how much, s.
    pub seconds: f64,
    /// n x n, row-major.
    phi: Vec<Column>,
    /// What is held, with what it adds, n.
    held: Vec<(Source, Column)>,
    /// What the constant terms add, n.
    constant: Column,
}

/// The same at one precision.
struct Exact {
    phi: Matrix,
    held: Vec<Matrix>,
    constant: Matrix,
}

impl Ahead {
    /// What the specification asks for, if it does.
    ///
    /// # Errors
    /// A discrete plant and no whole number of samples; constants that do not settle.
    pub fn new(plant: &Plant) -> Result<Option<Self>, Vec<Diagnostic>> {
        let Some((time, span)) = &plant.ahead else { return Ok(None) };
        let seconds = time.to_f64().unwrap_or(f64::NAN);
        let sources = sources(plant);
        let signals: Vec<Signal> = sources.iter().map(|source| held(*source)).collect();
        let steps = if plant.discrete { Some(whole_steps(plant)?) } else { None };
        let too_long = || {
            let message = "the plant changes too much within `ahead`";
            vec![Diagnostic::error(codes::TOO_LARGE, span.clone(), message).help("write fewer seconds")]
        };
        let run = |p: Precision| {
            let matrices = Matrices::new(plant, &signals, p)?;
            let all = matrices.columns.iter().fold(matrices.offset.clone(), |all, column| all.hcat(column));
            let (phi, gamma) = match steps {
                Some(steps) => powers(&matrices.a, &all, steps),
                None => {
                    let time = time.evaluate(p).map_err(|_| too_long())?;
                    zero_order_hold(&matrices.a, &all, &time).map_err(|_| too_long())?
                }
            };
            let n = phi.rows();
            let column = |k: usize| gamma.block(0..n, k..k + 1);
            Ok(Exact { phi, held: (1..=sources.len()).map(column).collect(), constant: column(0) })
        };
        let round = |pass: &mut Pass, coarse: &Exact, fine: &Exact| Self {
            seconds,
            phi: (0..coarse.phi.rows()).map(|i| pass.each(&row(&coarse.phi, i), &row(&fine.phi, i))).collect(),
            held: (sources.iter().zip(&coarse.held).zip(&fine.held))
                .map(|((source, c), f)| (*source, pass.each(&entries(c), &entries(f))))
                .collect(),
            constant: pass.each(&entries(&coarse.constant), &entries(&fine.constant)),
        };
        let (ahead, _, _) = rising(plant, run, round, |_| 0.0)?;
        let largest = ahead.phi.iter().flatten().flatten().map(|entry| entry.single).fold(0.0, f32::max);
        if largest.is_infinite() { Err(too_long()) } else { Ok(Some(ahead)) }
    }

    /// The answer, moved; `outputs` are the samples that the nonlinear terms are of.
    pub(crate) fn moved(
        &self,
        b: &mut Builder,
        plant: &Plant,
        estimate: &[Value],
        injections: &Injections,
        outputs: &[Value],
    ) -> Vec<Value> {
        let scalar = plant.scalar;
        let known: Vec<Value> = (self.held.iter())
            .map(|(source, _)| match source {
                Source::Input(u) => injections.inputs[*u],
                Source::Injection(k) => injections.evaluate(b, *k, &Moment::Now, Samples::These(outputs)),
            })
            .collect();
        let most = match scalar {
            Scalar::F32 => f64::from(f32::MAX),
            Scalar::F64 => f64::MAX,
        };
        let mut moved = Vec::new();
        for (i, now) in estimate.iter().enumerate() {
            let factors = self.phi[i].iter().chain(self.held.iter().map(|(_, column)| &column[i]));
            let mut terms = Vec::new();
            for (factor, value) in factors.zip(estimate.iter().chain(&known)) {
                if let Some(factor) = factor {
                    let factor = b.float(factor.value(scalar));
                    terms.push(b.mul(factor, *value));
                }
            }
            terms.extend(self.constant[i].map(|constant| b.float(constant.value(scalar))));
            let sum = b.sum(&terms);
            // A nonlinear term without a value now leaves the answer where it is.
            let sane = b.in_range(sum, -most, most);
            moved.push(b.select(sane, sum, *now));
        }
        moved
    }

    /// For the header.
    pub fn note(&self) -> String {
        format!("the estimate is for {} s later, with inputs and nonlinear terms as they are now", short(self.seconds))
    }

    /// A certificate as that of the moved answer: from above, by the magnitudes of `e^{A a}`.
    pub fn certify(&self, plant: &Plant, certificate: &mut Certificate) {
        let moved = |bounds: &mut Vec<Option<f64>>| match self.bound(plant, bounds) {
            Some(moved) => *bounds = moved.into_iter().map(Some).collect(),
            None => bounds.fill(None),
        };
        moved(&mut certificate.error_bound);
        moved(&mut certificate.error_bound_with_losses);
        certificate.error_bound_without.iter_mut().flatten().for_each(moved);
        self.carry(&mut certificate.noise_gain_l1);
        self.carry(&mut certificate.noise_gain_l2);
        self.carry(&mut certificate.disturbance_gain_l1);
        self.carry(&mut certificate.initial_gain);
        self.round(plant, &mut certificate.rounding);
        add(&mut certificate.disturbance_gain_l1, &Self::disturbed(plant));
    }

    /// What rounding adds to the moved answer: a state is rounded by at least half of its last bit, and the move has so
    /// many more roundings of its terms.
    fn round(&self, plant: &Plant, rounding: &mut Vec<f64>) {
        if rounding.is_empty() {
            return;
        }
        let roundings = count(3 + additions(self.phi.len() + self.held.len() + 1));
        let size = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double.abs());
        let known = |i: usize| {
            let held = self.held.iter().map(|(source, column)| size(&column[i]) * signal(plant, &held(*source)));
            held.sum::<f64>() + size(&self.constant[i])
        };
        let magnitudes = self.magnitudes();
        let moved = magnitudes.iter().enumerate().map(|(i, row)| {
            let states: f64 = row.iter().zip(&*rounding).map(|(factor, own)| factor * own).sum();
            roundings * (states + unit(plant.scalar) * known(i))
        });
        *rounding = moved.collect();
    }

    /// Magnitudes of `e^{A a}`, n x n.
    fn magnitudes(&self) -> Vec<Vec<f64>> {
        let size = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double.abs());
        self.phi.iter().map(|row| row.iter().map(size).collect()).collect()
    }

    /// Gains, a row per state, as those of the moved states; none where there are none.
    pub fn carry(&self, gains: &mut Vec<Vec<f64>>) {
        let Some(columns) = gains.first().map(Vec::len) else { return };
        let sum = |row: &Vec<f64>, c: usize| -> f64 {
            row.iter().zip(gains.iter()).filter(|(m, _)| **m > 0.0).map(|(m, gains)| m * gains[c]).sum()
        };
        *gains = self.magnitudes().iter().map(|row| (0..columns).map(|c| sum(row, c)).collect()).collect();
    }

    /// What disturbances do meanwhile, n x d.
    fn disturbed(plant: &Plant) -> Vec<Vec<f64>> {
        let (n, d) = (plant.states.len(), plant.disturbances.len());
        let Some((time, span)) = &plant.ahead else { return vec![vec![0.0; d]; n] };
        if plant.discrete {
            // Each of the steps brings the column in, and the later ones carry it.
            let steps = whole_steps(plant).unwrap_or(0);
            let a: Vec<Vec<f64>> =
                plant.a.iter().map(|row| row.iter().map(|x| x.to_f64().unwrap_or(f64::INFINITY)).collect()).collect();
            let mut sums = vec![vec![0.0; d]; n];
            for (k, disturbance) in plant.disturbances.iter().enumerate() {
                let mut carried: Vec<f64> =
                    disturbance.column.iter().map(|c| c.to_f64().unwrap_or(f64::INFINITY)).collect();
                for _ in 0..steps {
                    (0..n).for_each(|i| sums[i][k] += carried[i].abs());
                    carried = a.iter().map(|row| row.iter().zip(&carried).map(|(a, x)| a * x).sum()).collect();
                }
            }
            return sums;
        }
        let longer = Plant { sample_time: (time.clone(), span.clone()), ..plant.clone() };
        let Some(kernel) = Kernel::new(&longer) else { return vec![vec![f64::INFINITY; d]; n] };
        let mut gains = DMatrix::zeros(n, d);
        kernel.add(&DMatrix::identity(n, n), &mut gains);
        rows(&gains)
    }

    /// The largest error, where there is one for the estimate of now.
    fn bound(&self, plant: &Plant, now: &[Option<f64>]) -> Option<Vec<f64>> {
        let now: Vec<f64> = now.iter().copied().collect::<Option<_>>()?;
        let disturbed = Self::disturbed(plant);
        let mut bounds = Vec::new();
        for (i, row) in self.magnitudes().iter().enumerate() {
            let mut bound: f64 = row.iter().zip(&now).map(|(m, bound)| m * bound).sum();
            for (disturbance, gain) in plant.disturbances.iter().zip(&disturbed[i]) {
                bound += gain * disturbance.bound.to_f64().ok()?;
            }
            for (source, column) in &self.held {
                let (Source::Injection(k), Some(factor)) = (source, &column[i]) else { continue };
                for (o, output) in plant.outputs.iter().enumerate() {
                    bound += factor.double.abs() * slope(plant, *k, o)? * output.noise.as_ref()?.to_f64().ok()?;
                }
            }
            bounds.push(bound);
        }
        (bounds.len() == now.len() && bounds.iter().all(|bound| bound.is_finite())).then_some(bounds)
    }
}

/// What keeps its value meanwhile: inputs that enter linearly, and nonlinear terms.
fn sources(plant: &Plant) -> Vec<Source> {
    let enters = |u: &usize| plant.b.iter().any(|row| !row[*u].is_zero());
    let inputs = (0..plant.inputs.len()).filter(enters).map(Source::Input);
    inputs.chain((0..plant.injections.len()).map(Source::Injection)).collect()
}

fn held(source: Source) -> Signal {
    Signal { source, part: Part::Held, text: String::new() }
}

fn row(m: &Matrix, i: usize) -> Vec<Real> {
    (0..m.cols()).map(|j| m.get(i, j).clone()).collect()
}

fn entries(column: &Matrix) -> Vec<Real> {
    (0..column.rows()).map(|i| column.get(i, 0).clone()).collect()
}

fn add(sums: &mut [Vec<f64>], more: &[Vec<f64>]) {
    for (sums, more) in sums.iter_mut().zip(more) {
        sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }
}

/// `A^m` and the sum of `A^i B` for i below m.
fn powers(a: &Matrix, b: &Matrix, steps: usize) -> (Matrix, Matrix) {
    let mut phi = Matrix::identity(a.rows(), a.precision());
    let mut gamma = Matrix::zeros(b.rows(), b.cols(), b.precision());
    for _ in 0..steps {
        gamma = &(a * &gamma) + b;
        phi = a * &phi;
    }
    (phi, gamma)
}

/// The samples of a discrete plant within `ahead`.
fn whole_steps(plant: &Plant) -> Result<usize, Vec<Diagnostic>> {
    let Some((time, span)) = &plant.ahead else { return Ok(0) };
    let mut found = Vec::new();
    whole_samples(time, span, "`ahead`", plant, &mut found).ok_or(found)
}
