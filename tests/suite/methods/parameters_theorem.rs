//! Claim: whatever the linear plant and its unknown constants, states and unknowns are found from the promised step on,
//! to rounding: in the joint form and the paper's, with constant factors, factors of time, and, in discrete time,
//! factors of outputs and inputs; only plants that do not show them are refused.
//!
//! Numbers are dyadic, so that the simulation is of the same plant to the last bit.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::plant;

use std::cell::Cell;
use std::fmt::Write as _;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use nalgebra::{DMatrix, DVector};
use plant::{NOTHING_YET, Random, Run, UNIT, advance, exponential, rounding};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Plants of constant factors that are tried.
const CONSTANT: u32 = 200;
/// Plants of factors that vary.
const VARYING: u32 = 120;

/// n, q, further outputs, discrete, further samples, seed.
type Shape = (usize, usize, usize, bool, usize, u64);

/// A random linear plant with unknown constants.
struct Linear {
    discrete: bool,
    h: f64,
    /// Window, and the further keys of the method.
    window: usize,
    keys: String,
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    gamma: DMatrix<f64>,
    /// Per unknown.
    factors: Vec<Factor>,
    delays: Vec<usize>,
}

/// A factor as text and as a function of t, the first output and the first input.
#[derive(Clone)]
struct Factor {
    text: String,
    value: fn(f64, f64, f64, f64) -> f64,
    rate: f64,
}

impl Factor {
    fn constant() -> Self {
        Self { text: "1".into(), value: |_, _, _, _| 1.0, rate: 0.0 }
    }

    fn at(&self, t: f64, y: f64, u: f64) -> f64 {
        (self.value)(self.rate, t, y, u)
    }

    /// Of time, and of the held input, which is constant between samples.
    fn of_time(random: &mut Random) -> Self {
        let rate = (1.0 + random.below(24) as f64) / 8.0;
        match random.below(7) {
            0 => Self { text: format!("sin({rate}*t)"), value: |w, t, _, _| (w * t).sin(), rate },
            1 => Self { text: format!("cos({rate}*t + 0.5)"), value: |w, t, _, _| (w * t + 0.5).cos(), rate },
            2 => Self { text: "t".into(), value: |_, t, _, _| t, rate },
            3 => Self { text: "(t - 1)^2".into(), value: |_, t, _, _| (t - 1.0) * (t - 1.0), rate },
            4 => Self { text: "exp(-0.25*t)".into(), value: |_, t, _, _| (-0.25 * t).exp(), rate },
            5 => Self { text: format!("t*sin({rate}*t)"), value: |w, t, _, _| t * (w * t).sin(), rate },
            _ => Self { text: "u1".into(), value: |_, _, _, u| u, rate },
        }
    }

    /// Of everything known.
    fn of_all(random: &mut Random) -> Self {
        match random.below(4) {
            0 => Self { text: "tanh(y1)".into(), value: |_, _, y, _| y.tanh(), rate: 0.0 },
            1 => Self { text: "sin(2*y1)".into(), value: |_, _, y, _| (2.0 * y).sin(), rate: 0.0 },
            2 => Self { text: "cos(y1)*u1".into(), value: |_, _, y, u| y.cos() * u, rate: 0.0 },
            _ => Self::of_time(random),
        }
    }
}

impl Linear {
    fn new((n, q, more, discrete, spare, seed): Shape, varying: bool) -> Self {
        let mut random = Random::new(seed);
        // More unknowns than states cannot be told apart.
        let q = if varying { q } else { q.min(n).min(6 - n) };
        // Constant factors need as many outputs as unknowns: each adds an integrator that only another output shows.
        let p = if varying { 1 + more.min(1) } else { (q + more).min(3) };
        let h = [0.0625, 0.125, 0.25][random.below(3)];
        let delays: Vec<usize> =
            (0..p).map(|o| if o > 0 && random.below(3) == 0 { 1 + random.below(3) } else { 0 }).collect();
        let mut entry = |most: f64, zeros: usize| {
            let value = (random.within(-most, most) * 64.0).round() / 64.0;
            if random.below(10) < zeros { 0.0 } else { value }
        };
        let most = if discrete { 1.5 / (n as f64).sqrt() } else { 2.0 };
        let a = DMatrix::from_fn(n, n, |_, _| entry(most, 2));
        let b = DMatrix::from_fn(n, 1, |_, _| entry(2.0, 2));
        let mut gamma = DMatrix::from_fn(n, q, |_, _| entry(2.0, 2));
        let mut c = DMatrix::from_fn(p, n, |_, _| entry(2.0, 3));
        // Everything that is declared enters somewhere.
        gamma
            .column_iter_mut()
            .filter(|column| column.iter().all(|x| *x == 0.0))
            .for_each(|mut column| column[0] = 1.0);
        c.row_iter_mut().filter(|row| row.iter().all(|x| *x == 0.0)).for_each(|mut row| row[0] = 1.0);
        if varying {
            // The first output is a state, so that factors may depend on it.
            c.row_mut(0).fill(0.0);
            c[(0, 0)] = 1.0;
        }
        let factor = |random: &mut Random| match (varying, discrete) {
            (false, _) => Factor::constant(),
            (true, false) => Factor::of_time(random),
            (true, true) => Factor::of_all(random),
        };
        let factors = (0..q).map(|_| factor(&mut random)).collect();
        let window = n + q + delays.iter().max().unwrap() + 2 + spare;
        Self { discrete, h, window, keys: String::new(), a, b, c, gamma, factors, delays }
    }

    /// The same in the paper's form, where that takes it: one output, one unknown.
    fn in_the_papers_form(mut self, seed: u64) -> Self {
        let mut random = Random::new(seed ^ 0x5a5a);
        if self.c.nrows() == 1 && self.gamma.ncols() == 1 {
            let late = if self.discrete { 0 } else { random.below(2) * (1 + random.below(3)) };
            self.delays = vec![late];
            let integration = 2 + random.below(self.window);
            self.keys = format!("form = 'paper'\nintegration_window = {}\n", integration as f64 * self.h);
        }
        self
    }

    /// The specification.
    fn text(&self) -> String {
        let mut text = "deadbeat = 1\nname = 'random'\n[states]\n".to_owned();
        let key = if self.discrete { "next" } else { "derivative" };
        for i in 0..self.a.nrows() {
            let mut sum = String::from("0");
            for j in 0..self.a.ncols() {
                let _ = write!(sum, " + ({})*x{}", self.a[(i, j)], j + 1);
            }
            let _ = write!(sum, " + ({})*u1", self.b[(i, 0)]);
            for (k, factor) in self.factors.iter().enumerate() {
                let factor = factor.text.replace("y1", "x1");
                let _ = write!(sum, " + ({})*e{}*{factor}", self.gamma[(i, k)], k + 1);
            }
            let _ = writeln!(text, "x{} = {{ {key} = '{sum}' }}", i + 1);
        }
        text += "[inputs]\nu1 = {}\n[outputs]\n";
        for (o, delay) in self.delays.iter().enumerate() {
            let mut sum = String::from("0");
            for j in 0..self.c.ncols() {
                let _ = write!(sum, " + ({})*x{}", self.c[(o, j)], j + 1);
            }
            let late = if *delay > 0 { format!(", delay = {}", *delay as f64 * self.h) } else { String::new() };
            let _ = writeln!(text, "y{} = {{ value = '{sum}'{late} }}", o + 1);
        }
        text += "[unknowns]\n";
        for k in 1..=self.factors.len() {
            let _ = writeln!(text, "e{k} = {{}}");
        }
        let window = self.window as f64 * self.h;
        let _ = writeln!(text, "[observer.parameters]\nwindow = {window}\n{}", self.keys);
        let _ = writeln!(text, "[target]\nsample_time = {}\nscalar = 'f64'", self.h);
        text
    }

    /// Columns of states over one sample interval: each moves by A and by its own drive, a function of t.
    fn interval(&self, call: usize, columns: &DMatrix<f64>, drive: &dyn Fn(f64) -> DMatrix<f64>) -> DMatrix<f64> {
        let begin = call as f64 * self.h;
        if self.discrete {
            return &self.a * columns + drive(begin);
        }
        let (n, m) = columns.shape();
        let rhs = |t: f64, x: &[f64]| (&self.a * DMatrix::from_column_slice(n, m, x) + drive(t)).as_slice().to_vec();
        let middle = advance(&rhs, begin, self.h / 2.0, columns.as_slice());
        DMatrix::from_column_slice(n, m, &advance(&rhs, begin + self.h / 2.0, self.h / 2.0, &middle))
    }

    /// A run with the unknowns behind the states, and its inputs by interval.
    fn run(&self, calls: usize, seed: u64) -> (Run, Vec<f64>) {
        let (n, q) = (self.a.nrows(), self.factors.len());
        let mut random = Random::new(seed);
        let unknowns: Vec<f64> = (0..q).map(|_| random.within(0.5, 1.5)).collect();
        let inputs: Vec<f64> = (0..calls).map(|_| random.within(-1.0, 1.0)).collect();
        let mut x = DMatrix::from_fn(n, 1, |_, _| random.within(-1.0, 1.0));
        let mut run = Run::default();
        for call in 0..calls {
            if call > 0 {
                let (y, u) = ((&self.c * &x)[0], inputs[call - 1]);
                x = self.interval(call - 1, &x, &|t| {
                    let force = DMatrix::from_fn(q, 1, |k, _| unknowns[k] * self.factors[k].at(t, y, u));
                    &self.gamma * force + &self.b * u
                });
            }
            run.inputs.push(vec![if call == 0 { NOTHING_YET } else { inputs[call - 1] }]);
            run.states.push(x.iter().chain(&unknowns).copied().collect());
            let sample = |o: usize| match call.checked_sub(self.delays[o]) {
                Some(past) => (self.c.row(o) * DVector::from_column_slice(&run.states[past][..n]))[0],
                None => NOTHING_YET,
            };
            run.measurements.push((0..self.delays.len()).map(sample).collect());
        }
        (run, inputs)
    }

    /// The error of one simulated interval per state, in units of u, for a rounding bound on constant weights.
    fn step(&self, run: &Run) -> Vec<f64> {
        let n = self.a.nrows();
        let sizes = run.sizes(0);
        let phi = if self.discrete { self.a.clone() } else { exponential(&(&self.a * self.h)) };
        let roundings = (n + self.factors.len() + 3) as f64;
        // The sixteenth-order extrapolation multiplies the rounding errors of the increments by less than 32.
        let method = if self.discrete { 1.0 } else { 32.0 };
        let total =
            sizes.iter().sum::<f64>() * (2.0 + self.gamma.abs().max() + self.b.abs().max()) * phi.abs().max().max(1.0);
        (0..sizes.len()).map(|i| if i < n { roundings * method * total } else { 0.0 }).collect()
    }
}

/// The design, or that something is not shown, or that an assumption of the paper does not hold; everything else
/// is a failure.
fn design(text: &str) -> Result<Option<Generated>, TestCaseError> {
    let paper = text.contains("form = 'paper'");
    match Generator::new(text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design() {
        Ok(generated) => Ok(Some(generated)),
        Err(report) if report.diagnostics.iter().all(|d| d.code == codes::UNOBSERVABLE) => Ok(None),
        Err(report) if paper && report.diagnostics.iter().all(|d| d.message.contains("Assumption")) => Ok(None),
        Err(report) => Err(TestCaseError::fail(format!("{}\n{text}", report.render(false)))),
    }
}

fn shapes(most: usize) -> impl proptest::strategy::Strategy<Value = Shape> {
    (1_usize..=most, 1_usize..=3, 0_usize..=1, proptest::bool::ANY, 0_usize..=10, 0_u64..1 << 40)
}

fn tried(count: u32, most: usize, test: impl Fn(Shape) -> Result<(), TestCaseError>) {
    let config = Config { cases: count, failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes(most), test);
    outcome.unwrap_or_else(|why| panic!("{why}"));
}

/// Constant factors, joint or in the paper's two stages.
#[test]
fn constant_factors_are_found() {
    let (refused, paper, worst) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64));
    let (states, loose) = (Cell::new(0), Cell::new(0));
    tried(CONSTANT, 4, |shape| {
        let linear = Linear::new(shape, false).in_the_papers_form(shape.5);
        let text = linear.text();
        let Some(generated) = design(&text)? else {
            refused.set(refused.get() + 1);
            return Ok(());
        };
        paper.set(paper.get() + u32::from(!linear.keys.is_empty()));
        let from = generated.design.valid_from_step;
        if linear.keys.is_empty() && from != linear.window {
            return Err(TestCaseError::fail("the promised step is not the window's length"));
        }
        let run = linear.run(2 * from + 10, shape.5).0;
        let answers = run.through(&generated);
        for (call, status) in answers.statuses.iter().enumerate() {
            let expected = if call < from { Status::Converging } else { Status::Converged };
            if *status != expected {
                return Err(TestCaseError::fail(format!("call {call}: {status:?}\n{text}")));
            }
        }
        let bounds = rounding(&generated, &run, &linear.step(&run), &[]);
        let errors = answers.errors(&run, from..run.states.len());
        for ((error, bound), size) in errors.iter().zip(&bounds).zip(run.sizes(from)) {
            if error > bound {
                return Err(TestCaseError::fail(format!("error {error:e}, bound {bound:e}\n{text}")));
            }
            worst.set(worst.get().max(error / bound));
            states.set(states.get() + 1);
            loose.set(loose.get() + u32::from(bound / size.max(1e-3) > 1e-6));
        }
        Ok(())
    });
    let (refused, paper, states, loose) = (refused.get(), paper.get(), states.get(), loose.get());
    println!(
        "{refused} of {CONSTANT} refused, {paper} in two stages; {loose} of {states} bounds above 1e-6; largest error / bound {:.1e}",
        worst.get()
    );
    assert!(refused * 10 <= CONSTANT, "{refused} of {CONSTANT} refused");
    assert!(paper * 10 >= CONSTANT, "{paper} of {CONSTANT} in two stages");
    assert!(loose * 20 <= states, "the bound says nothing for {loose} of {states} states");
}

/// A window of the regression, solved without the crate: by singular values.
struct Window {
    /// Largest error of a state and unknown per unit of error in every row.
    gains: Vec<f64>,
    /// The smallest and the largest singular value of what the state cannot explain, unknowns scaled to show 1.
    own: (f64, f64),
    /// The largest that the rows are made of.
    size: f64,
}

/// The rows `[C Phi^j, C p_j]` of the window that ends at a call.
fn window(linear: &Linear, run: &Run, inputs: &[f64], last: usize) -> Window {
    let (n, q, steps) = (linear.a.nrows(), linear.factors.len(), linear.window);
    let unknowns = &run.states[0][n..];
    let first = last - steps;
    // Columns: the n responses to the state, q to the unknowns, one to the input.
    let mut columns = DMatrix::zeros(n, n + q + 1);
    columns.view_mut((0, 0), (n, n)).fill_with_identity();
    let (mut rows, mut size) = (Vec::new(), 0.0_f64);
    for j in 0..=steps {
        if j > 0 {
            let call = first + j - 1;
            let (y, u) = (run.states[call][0], inputs[call]);
            columns = linear.interval(call, &columns, &|t| {
                let mut drive = DMatrix::zeros(n, n + q + 1);
                for k in 0..q {
                    drive.set_column(n + k, &(linear.gamma.column(k) * linear.factors[k].at(t, y, u)));
                }
                drive.set_column(n + q, &(linear.b.column(0) * u));
                drive
            });
        }
        for o in (0..linear.delays.len()).filter(|o| j + linear.delays[*o] <= steps) {
            let row = linear.c.row(o) * &columns;
            let shown = (linear.c.row(o) * DVector::from_column_slice(&run.states[first + j][..n]))[0];
            let parts: f64 = (0..q).map(|k| (row[n + k] * unknowns[k]).abs()).sum::<f64>() + row[n + q].abs();
            size = size.max(shown.abs() + parts);
            rows.push(row.columns(0, n + q).into_owned());
        }
    }
    let omega = DMatrix::from_rows(&rows);
    let (states, gammas) = (omega.columns(0, n).into_owned(), omega.columns(n, q).into_owned());
    let explained = states.clone().svd(true, true).solve(&gammas, 1e-13).unwrap();
    let mut own = &gammas - &states * explained;
    for (k, mut column) in own.column_iter_mut().enumerate() {
        column /= gammas.column(k).norm().max(f64::MIN_POSITIVE);
    }
    let values = own.svd(false, false).singular_values;
    let inverse = omega.pseudo_inverse(0.0).unwrap();
    let mut out = DMatrix::zeros(n + q, n + q);
    out.view_mut((0, 0), (n, n + q)).copy_from(&columns.columns(0, n + q));
    (0..q).for_each(|k| out[(n + k, n + k)] = 1.0);
    let weights = out * inverse;
    let gains = weights.row_iter().map(|row| row.iter().map(|w| w.abs()).sum()).collect();
    Window { gains, own: (values.min(), values.max()), size }
}

/// Factors that vary: with time and held inputs in continuous time, with everything known in discrete time.
#[test]
fn varying_factors_are_found_where_they_are_excited() {
    let (refused, excited, weak, worst, loose) =
        (Cell::new(0), Cell::new(0), Cell::new(0), Cell::new(0.0_f64), Cell::new(0));
    tried(VARYING, 3, |shape| {
        let linear = Linear::new(shape, true);
        let text = linear.text();
        let Some(generated) = design(&text)? else {
            refused.set(refused.get() + 1);
            return Ok(());
        };
        let (n, from) = (linear.a.nrows(), generated.design.valid_from_step);
        let (run, inputs) = linear.run(2 * from + 10, shape.5);
        let answers = run.through(&generated);
        for call in (from..run.states.len()).step_by(5) {
            let window = window(&linear, &run, &inputs, call);
            let (smallest, largest) = window.own;
            // The step's threshold is 1e-6 on each pivot, which is above the smallest and, for three unknowns, may be
            // some times it.
            if smallest < 1e-5 {
                weak.set(weak.get() + 1);
                continue;
            }
            excited.set(excited.get() + 1);
            if answers.statuses[call] != Status::Converged {
                return Err(TestCaseError::fail(format!(
                    "call {call}: {:?}, {smallest:e}\n{text}",
                    answers.statuses[call]
                )));
            }
            // Rounding errors of the rows, in the simulation and in the step, each of which passes N intervals of at most
            // n + q + 3 roundings (32 times that by the extrapolation); the equations of the unknowns are formed from
            // what is left of them, whose condition enters squared.
            let method = if linear.discrete { 1.0 } else { 32.0 };
            let roundings = (linear.window as f64 + 8.0) * (n as f64 + 6.0) * method;
            let condition = (largest / smallest).powi(2) / smallest;
            for (i, gain) in window.gains.iter().enumerate() {
                let error = (answers.estimates[call][i] - run.states[call][i]).abs();
                let bound = UNIT * roundings * (gain * window.size * condition.max(1.0) + window.size);
                if error.is_nan() || error > bound {
                    return Err(TestCaseError::fail(format!(
                        "call {call}, {i}: error {error:e}, bound {bound:e}\n{text}"
                    )));
                }
                worst.set(worst.get().max(error / bound));
                loose.set(loose.get() + u32::from(error > 1e-6 * run.states[call][i].abs().max(1e-3)));
            }
        }
        Ok(())
    });
    let (refused, excited, weak, loose) = (refused.get(), excited.get(), weak.get(), loose.get());
    println!(
        "{refused} of {VARYING} refused; {excited} windows excited, {weak} hardly; {loose} errors above 1e-6; largest error / bound {:.1e}",
        worst.get()
    );
    assert!(refused * 10 <= VARYING, "{refused} of {VARYING} refused");
    assert!(weak <= excited, "{weak} windows hardly excited, {excited} are");
    assert!(loose * 20 <= excited, "{loose} errors are large");
}
