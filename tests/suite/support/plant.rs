//! Plants simulated without the crate: right-hand sides as closures, an extrapolation method of
//! order 16 between the samples, inputs that follow their holds, samples that arrive late; and the
//! most that rounding can do to an estimate.

#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, OnceLock};

use deadbeat_codegen::internals::estimator::window::Functional;
use deadbeat_codegen::internals::estimator::window::regression::Regression;
use deadbeat_codegen::internals::sampled::Source;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use nalgebra::DMatrix;

/// Half the distance from 1 to the next double: the relative error of one rounding.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// Marsaglia's xorshift with multiplication: reproducible numbers.
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x2545_f491_4f6c_dd1d)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 * 2.0_f64.powi(-53)
    }

    /// Uniform in 0 … count - 1.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() >> 33) as usize % count
    }

    /// Normal with mean 0 and deviation 1, after Box and Muller.
    pub fn normal(&mut self) -> f64 {
        let (radius, angle) = (self.within(1e-300, 1.0), self.within(0.0, std::f64::consts::TAU));
        (-2.0 * radius.ln()).sqrt() * angle.cos()
    }
}

/// A specification's text in double precision, designed.
pub fn designed(text: &str) -> Generated {
    designed_in(text, Scalar::F64)
}

/// Designs by specification and scalar.
type Designs = Mutex<HashMap<(String, Scalar), Arc<OnceLock<Generated>>>>;

/// A specification's text, designed: once, whoever asks for the same.
pub fn designed_in(text: &str, scalar: Scalar) -> Generated {
    static DESIGNS: LazyLock<Designs> = LazyLock::new(Designs::default);
    let asked = (text.to_owned(), scalar);
    let once = Arc::clone(DESIGNS.lock().unwrap().entry(asked).or_default());
    let design = || {
        let generator = Generator::new(text, "test.toml").with(Settings { scalar: Some(scalar) });
        generator.design().unwrap_or_else(|report| panic!("{}", report.render(false)))
    };
    once.get_or_init(design).clone()
}

/// The text of a corpus specification.
pub fn corpus(name: &str) -> String {
    let path = format!("{}/specs/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A specification at another sample time.
pub fn at_sample_time(text: &str, sample_time: f64) -> String {
    let replace = |line: &str| {
        if line.starts_with("sample_time") { format!("sample_time = {sample_time}") } else { line.to_owned() }
    };
    text.lines().map(replace).collect::<Vec<_>>().join("\n")
}

/// Replaces a part of a specification that must be there.
pub fn edited(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "`{from}` is not in the specification");
    text.replace(from, to)
}

/// The exponential: halved until its norm is below 1/2, twenty terms of the series, squared again.
pub fn exponential(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let norm = matrix.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let halvings = (0..60).find(|s| norm * 0.5_f64.powi(*s) < 0.5).unwrap();
    let small = matrix * 0.5_f64.powi(halvings);
    let identity = DMatrix::identity(matrix.nrows(), matrix.nrows());
    let sum = (1..=20).rev().fold(identity.clone(), |sum, k| &identity + &small * sum / f64::from(k));
    (0..halvings).fold(sum, |power, _| &power * &power)
}

/// x(t + h) of x' = rhs(t, x): the modified midpoint rule, extrapolated to order 16.
///
/// It extrapolates the increment, so that the rounding error is that of one addition to x.
pub fn advance(rhs: &dyn Fn(f64, &[f64]) -> Vec<f64>, t: f64, h: f64, x: &[f64]) -> Vec<f64> {
    const INTERVALS: [usize; 8] = [2, 4, 6, 8, 10, 12, 14, 16];
    let mut table: Vec<Vec<f64>> = Vec::new();
    for (k, count) in INTERVALS.iter().enumerate() {
        let mut entry = midpoint(rhs, t, h, x, *count);
        for j in 1..=k {
            let ratio = *count as f64 / INTERVALS[k - j] as f64;
            let finer = entry.clone();
            for ((value, finer), coarser) in entry.iter_mut().zip(&finer).zip(&table[j - 1]) {
                *value = finer + (finer - coarser) / (ratio * ratio - 1.0);
            }
            table[j - 1] = finer;
        }
        table.push(entry);
    }
    x.iter().zip(&table[INTERVALS.len() - 1]).map(|(x, increment)| x + increment).collect()
}

/// The increment by the modified midpoint rule over an even number of intervals.
fn midpoint(rhs: &dyn Fn(f64, &[f64]) -> Vec<f64>, t: f64, h: f64, x: &[f64], count: usize) -> Vec<f64> {
    let s = h / count as f64;
    let at = |m: usize, z: &[f64]| {
        let here: Vec<f64> = x.iter().zip(z).map(|(x, z)| x + z).collect();
        rhs(t + m as f64 * s, &here)
    };
    let mut before = vec![0.0; x.len()];
    let mut now: Vec<f64> = rhs(t, x).iter().map(|f| s * f).collect();
    for m in 1..count {
        let next = before.iter().zip(at(m, &now)).map(|(z, f)| z + 2.0 * s * f).collect();
        before = std::mem::replace(&mut now, next);
    }
    now
}

/// What an input does between samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Keeps its value.
    Zero,
    /// Runs straight from sample to sample.
    First,
}

/// x' or x+ as a function of t, x, u.
pub type Change = Box<dyn Fn(f64, &[f64], &[f64]) -> Vec<f64>>;

/// y as a function of x, and of the inputs until then.
pub type Show = Box<dyn Fn(&[f64], &[f64]) -> Vec<f64>>;

/// A plant as a person would write it down.
pub struct Truth {
    /// Discrete: `change` gives the next state.
    pub discrete: bool,
    /// The right-hand side.
    pub change: Change,
    /// y of x.
    pub outputs: Show,
    /// s, per output.
    pub delays: Vec<f64>,
    /// Per input.
    pub holds: Vec<Hold>,
    /// Where initial states are drawn from.
    pub start: Vec<(f64, f64)>,
    /// Where inputs are drawn from.
    pub input: Vec<(f64, f64)>,
    /// Whether the estimate is exact to rounding, not of second order in the sample time.
    pub exact: bool,
}

/// What calls of a step are given, and the true states at the calls.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Per call.
    pub states: Vec<Vec<f64>>,
    /// Per call, as they arrive.
    pub measurements: Vec<Vec<f64>>,
    /// Per call, applied since the call before.
    pub inputs: Vec<Vec<f64>>,
}

/// What a run's calls gave.
pub struct Answers {
    /// Per call.
    pub estimates: Vec<Vec<f64>>,
    /// Per call.
    pub statuses: Vec<Status>,
}

/// What a late output shows, and what a held input says, before there is anything to show or say;
/// no estimate may depend on either.
pub const NOTHING_YET: f64 = 0.015_625;

impl Truth {
    /// Simulates `calls` calls at sample time `h`; the inputs change every `refine` calls.
    ///
    /// Runs of one seed at h, h / 2, h / 4 with `refine` 1, 2, 4 are of the same motion.
    pub fn run(&self, h: f64, refine: usize, calls: usize, seed: u64) -> Run {
        let mut random = Random::new(seed);
        let mut x: Vec<f64> = self.start.iter().map(|(low, high)| random.within(*low, *high)).collect();
        let knots: Vec<Vec<f64>> = (0..=calls / refine + 1)
            .map(|_| self.input.iter().map(|(low, high)| random.within(*low, *high)).collect())
            .collect();
        let delays: Vec<usize> = self.delays.iter().map(|d| (d / h).round() as usize).collect();
        let straight = |i: usize, call: usize| {
            let share = (call % refine) as f64 / refine as f64;
            let (from, to) = (knots[call / refine][i], knots[call / refine + 1][i]);
            from + share * (to - from)
        };
        let mut run = Run::default();
        for call in 0..calls {
            if call > 0 {
                x = self.interval(call - 1, h, &x, &|i, share| match self.holds[i] {
                    Hold::Zero => knots[(call - 1) / refine][i],
                    Hold::First => straight(i, call - 1) + share * (straight(i, call) - straight(i, call - 1)),
                });
            }
            let applied = self.holds.iter().enumerate().map(|(i, hold)| match hold {
                Hold::Zero if call == 0 => NOTHING_YET,
                Hold::Zero => knots[(call - 1) / refine][i],
                Hold::First => straight(i, call),
            });
            run.inputs.push(applied.collect());
            run.states.push(x.clone());
            let past = run.states.iter().zip(&run.inputs).rev().take(1 + delays.iter().max().unwrap_or(&0));
            let outputs: Vec<Vec<f64>> = past.map(|(x, u)| (self.outputs)(x, u)).collect();
            let sample = |o: usize| outputs.get(delays[o]).map_or(NOTHING_YET, |y| y[o]);
            run.measurements.push((0..delays.len()).map(sample).collect());
        }
        run
    }

    /// One sample interval; `input` by index and share of the interval.
    fn interval(&self, call: usize, h: f64, x: &[f64], input: &dyn Fn(usize, f64) -> f64) -> Vec<f64> {
        let inputs = |share: f64| -> Vec<f64> { (0..self.holds.len()).map(|i| input(i, share)).collect() };
        let begin = call as f64 * h;
        if self.discrete {
            return (self.change)(begin, x, &inputs(0.0));
        }
        let rhs = |s: f64, x: &[f64]| (self.change)(begin + s, x, &inputs(s / h));
        let middle = advance(&rhs, 0.0, h / 2.0, x);
        advance(&rhs, h / 2.0, h / 2.0, &middle)
    }
}

impl Run {
    /// Feeds it to the interpreter.
    pub fn through(&self, generated: &Generated) -> Answers {
        let mut interpreter = Interpreter::new(&generated.program);
        let mut answers = Answers { estimates: Vec::new(), statuses: Vec::new() };
        for (measurements, inputs) in self.measurements.iter().zip(&self.inputs) {
            let mut estimate = vec![0.0; generated.program.estimates.len()];
            // Samples that come with their ages are of now, where nothing else is said.
            let mut measurements = measurements.clone();
            measurements.resize(generated.program.measurements.len(), 0.0);
            answers.statuses.push(interpreter.step(&measurements, inputs, &mut estimate));
            estimate.truncate(generated.plant.states.len());
            answers.estimates.push(estimate);
        }
        answers
    }

    /// The largest magnitude of each state from a call on.
    pub fn sizes(&self, from: usize) -> Vec<f64> {
        largest(self.states[from..].iter())
    }
}

impl Answers {
    /// Per state: the largest error over some calls.
    pub fn errors(&self, run: &Run, calls: impl Iterator<Item = usize>) -> Vec<f64> {
        let differences: Vec<Vec<f64>> =
            calls.map(|k| self.estimates[k].iter().zip(&run.states[k]).map(|(a, b)| a - b).collect()).collect();
        largest(differences.iter())
    }
}

/// Per column: the largest magnitude; NaN is infinite.
fn largest<'a>(rows: impl Iterator<Item = &'a Vec<f64>>) -> Vec<f64> {
    let mut sizes = Vec::new();
    for row in rows {
        sizes.resize(row.len(), 0.0_f64);
        for (size, value) in sizes.iter_mut().zip(row) {
            *size = if value.is_nan() { f64::INFINITY } else { size.max(value.abs()) };
        }
    }
    sizes
}

/// The functional of a window design.
pub fn functional(generated: &Generated) -> &Functional {
    let functional = generated.design.estimator.downcast_ref::<Functional>();
    functional.unwrap_or_else(|| panic!("{} has no constant weights", generated.plant.name))
}

/// Whole samples of delay, per output.
pub fn delays(generated: &Generated) -> Vec<usize> {
    let estimator = &generated.design.estimator;
    let window = estimator.downcast_ref::<Functional>().map(|functional| functional.delays.clone());
    let regression = || estimator.downcast_ref::<Regression>().map(|regression| regression.carrier.delays.clone());
    window.or_else(regression).unwrap_or_else(|| vec![0; generated.plant.outputs.len()])
}

/// A matrix of the design by its letter.
pub fn matrix<'a>(generated: &'a Generated, letter: &str) -> &'a [Vec<f64>] {
    let found = generated.design.constants.iter().find(|m| m.letter == letter);
    &found.unwrap_or_else(|| panic!("the design has no matrix {letter}")).rows
}

/// `acc_1 … acc_N` with `acc_1 = I - K_0 C`, `acc_{i+1} = acc_i Phi - K_i C`: what one unit that
/// disturbs the state at the end of the interval of an age does to the estimate.
pub fn accumulated(generated: &Generated) -> Vec<Vec<Vec<f64>>> {
    let functional = functional(generated);
    let (phi, c) = (matrix(generated, "Phi"), matrix(generated, "C"));
    let n = phi.len();
    let mut acc: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    let mut all = Vec::new();
    for age in 0..functional.steps {
        for (o, weights) in functional.outputs.iter().enumerate() {
            let Some(call_age) = age.checked_sub(functional.delays[o]) else { continue };
            for (i, row) in acc.iter_mut().enumerate() {
                row.iter_mut().zip(&c[o]).for_each(|(x, c)| *x -= weights.at(i, call_age).double * c);
            }
        }
        all.push(acc.clone());
        acc =
            acc.iter().map(|row| (0..n).map(|j| row.iter().zip(phi).map(|(a, p)| a * p[j]).sum()).collect()).collect();
    }
    all
}

/// Per state: the most by which rounding can move the estimate from the simulated state.
///
/// In the step: each of the N+1 products per signal is rounded with its weight and passes at most
/// that many additions, so the sum is off by (N + 6) u times the sum of magnitudes, and the sums of
/// the signals by a few u more. In the simulation: what is rounded off a state is a disturbance
/// that the observer rightly does not know; it enters through acc. `step` is the error of one
/// simulated step, per state, in units of u.
pub fn rounding(generated: &Generated, run: &Run, step: &[f64], injections: &[f64]) -> Vec<f64> {
    let functional = functional(generated);
    let (outputs, inputs) = (largest(run.measurements.iter()), largest(run.inputs.iter()));
    let signal = |source: Source| match source {
        Source::Input(u) => inputs[u],
        Source::Injection(k) => injections[k],
    };
    let sizes = run.sizes(0);
    let mut through = vec![0.0; sizes.len()];
    for acc in accumulated(generated) {
        for (sum, row) in through.iter_mut().zip(&acc) {
            *sum += row.iter().zip(step).map(|(a, s)| a.abs() * s).sum::<f64>();
        }
    }
    (0..sizes.len())
        .map(|i| {
            let measured: f64 = functional.outputs.iter().zip(&outputs).map(|(w, y)| w.l1(i) * y).sum();
            let known: f64 =
                functional.knowns.iter().zip(&functional.signals).map(|(w, s)| w.l1(i) * signal(s.source)).sum();
            UNIT * ((functional.steps + 6) as f64 * (measured + known + sizes[i]) + through[i])
        })
        .collect()
}

/// The error of one simulated interval of a continuous plant, per state, in units of u: the states
/// are rounded a few times, and the sixteenth-order extrapolation multiplies the rounding errors of
/// the increments by less than 32.
pub fn integration_rounding(generated: &Generated, run: &Run) -> Vec<f64> {
    let (phi, sizes) = (matrix(generated, "Phi"), run.sizes(0));
    let jumps: Vec<Vec<f64>> =
        run.states.windows(2).map(|pair| pair[1].iter().zip(&pair[0]).map(|(b, a)| b - a).collect()).collect();
    let jumps = largest(jumps.iter());
    let through = |row: &Vec<f64>| row.iter().zip(&sizes).map(|(p, x)| p.abs() * x).sum::<f64>();
    phi.iter()
        .zip(&sizes)
        .zip(&jumps)
        .map(|((row, size), jump)| 4.0 * size + 32.0 * (through(row) - row_own(row, &sizes, *size) + jump))
        .collect()
}

/// At most the state's own share of a row of Phi.
fn row_own(row: &[f64], sizes: &[f64], size: f64) -> f64 {
    row.iter().zip(sizes).map(|(p, x)| p.abs() * x).fold(0.0, f64::max).min(size)
}
