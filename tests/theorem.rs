//! Claim: whatever the linear plant, its initial state and its inputs, the estimate equals the state
//! from the promised step on, to rounding; only plants that do not show their state are refused.
//!
//! Plants have up to six states, three outputs, some of them late, and two inputs of either hold;
//! they are continuous or discrete, stable or not, written as matrices or as equations, weighted equally
//! or for the worst case. Entries are dyadic, so that the simulation is of the same plant to the last bit.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

#[path = "support/plant.rs"]
mod plant;

use std::cell::Cell;
use std::fmt::Write as _;

use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings, diagnostic::codes};
use nalgebra::{DMatrix, DVector};
use plant::{Answers, Hold, NOTHING_YET, Random, Run, UNIT, exponential, matrix, rounding};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Plants that are tried.
const PLANTS: u32 = 200;

/// A random linear plant.
struct Linear {
    discrete: bool,
    equations: bool,
    minimax: bool,
    h: f64,
    steps: usize,
    a: DMatrix<f64>,
    b: DMatrix<f64>,
    c: DMatrix<f64>,
    holds: Vec<Hold>,
    delays: Vec<usize>,
}

/// Sizes and kinds, which proptest shrinks; the numbers follow from a seed.
type Shape = (usize, usize, usize, (bool, bool), usize, u64);

impl Linear {
    fn new((n, p, m, (discrete, equations), spare, seed): Shape) -> Self {
        let mut random = Random::new(seed);
        let h = [0.0625, 0.125, 0.25][random.below(3)];
        let delays: Vec<usize> = (0..p).map(|_| if random.below(3) == 0 { 1 + random.below(3) } else { 0 }).collect();
        // Some entries are structural zeros, so that some plants do not show their state.
        let mut entry = |most: f64, zeros: usize| {
            let value = (random.within(-most, most) * 64.0).round() / 64.0;
            if random.below(10) < zeros { 0.0 } else { value }
        };
        // Discrete plants with radii around 1, continuous ones with |A| h around 1: stable and unstable.
        let most = if discrete { 2.0 / (n as f64).sqrt() } else { 2.0 };
        let a = DMatrix::from_fn(n, n, |_, _| entry(most, 3));
        let b = DMatrix::from_fn(n, m, |_, _| entry(2.0, 2));
        let mut c = DMatrix::from_fn(p, n, |_, _| entry(2.0, 4));
        for mut row in c.row_iter_mut() {
            if row.iter().all(|x| *x == 0.0) {
                row[0] = 1.0;
            }
        }
        let holds = (0..m).map(|_| if random.below(2) == 0 { Hold::Zero } else { Hold::First }).collect();
        let steps = n + delays.iter().max().unwrap() + spare;
        let minimax = random.below(4) == 0;
        Self { discrete, equations, minimax, h, steps, a, b, c, holds, delays }
    }

    /// The specification.
    fn text(&self) -> String {
        let mut text = "deadbeat = 1\nname = 'random'\n".to_owned();
        let row = |row: Vec<f64>| format!("[{}]", row.iter().map(f64::to_string).collect::<Vec<_>>().join(", "));
        let rows =
            |m: &DMatrix<f64>| m.row_iter().map(|r| row(r.iter().copied().collect())).collect::<Vec<_>>().join(", ");
        let sum = |r: Vec<f64>, letter: &str| {
            let terms = r.iter().enumerate().filter(|(_, x)| **x != 0.0);
            terms.map(|(i, x)| format!("({x})*{letter}{}", i + 1)).collect::<Vec<_>>().join(" + ")
        };
        if self.equations {
            text += "[states]\n";
            for i in 0..self.a.nrows() {
                let key = if self.discrete { "next" } else { "derivative" };
                let (states, inputs) =
                    (self.a.row(i).iter().copied().collect(), self.b.row(i).iter().copied().collect());
                let _ = writeln!(
                    text,
                    "x{} = {{ {key} = '0 + {} + {}' }}",
                    i + 1,
                    or_zero(sum(states, "x")),
                    or_zero(sum(inputs, "u"))
                );
            }
        } else {
            let time = if self.discrete { "discrete" } else { "continuous" };
            let _ = writeln!(text, "[plant]\ntime = '{time}'\nA = [{}]\nC = [{}]", rows(&self.a), rows(&self.c));
            if !self.holds.is_empty() {
                let _ = writeln!(text, "B = [{}]", rows(&self.b));
            }
        }
        if !self.holds.is_empty() {
            text += "[inputs]\n";
        }
        for (i, hold) in self.holds.iter().enumerate() {
            let _ =
                writeln!(text, "u{} = {{ hold = '{}' }}", i + 1, if *hold == Hold::Zero { "zero" } else { "first" });
        }
        text += "[outputs]\n";
        for (o, delay) in self.delays.iter().enumerate() {
            let value = if self.equations {
                format!("value = '{}'", sum(self.c.row(o).iter().copied().collect(), "x"))
            } else {
                String::new()
            };
            let late = if *delay > 0 { format!("delay = {}", *delay as f64 * self.h) } else { String::new() };
            let entries: Vec<String> = [value, late].into_iter().filter(|s| !s.is_empty()).collect();
            let _ = writeln!(text, "y{} = {{ {} }}", o + 1, entries.join(", "));
        }
        let weights = if self.minimax { "minimax" } else { "equal" };
        let _ = writeln!(
            text,
            "[observer.window]\nwindow = {}\nweights = '{weights}'\n[target]\nsample_time = {}\nscalar = 'f64'",
            self.steps as f64 * self.h,
            self.h
        );
        text
    }

    /// exp of [A B 0; 0 0 I; 0 0 0] h: Phi, the effect of a held input, and of one that rises by 1 over the interval.
    fn sampled(&self) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
        let (n, m) = (self.a.nrows(), self.b.ncols());
        if self.discrete {
            return (self.a.clone(), self.b.clone(), DMatrix::zeros(n, m));
        }
        let mut whole = DMatrix::zeros(n + 2 * m, n + 2 * m);
        whole.view_mut((0, 0), (n, n)).copy_from(&(&self.a * self.h));
        whole.view_mut((0, n), (n, m)).copy_from(&(&self.b * self.h));
        whole.view_mut((n, n + m), (m, m)).fill_with_identity();
        let whole = exponential(&whole);
        let part = |from: usize, width: usize| whole.view((0, from), (n, width)).into_owned();
        (part(0, n), part(n, m), part(n + m, m))
    }

    /// A run, and the error of one simulated step per state in units of u.
    fn run(&self, calls: usize, seed: u64) -> (Run, Vec<f64>) {
        let (n, m) = (self.a.nrows(), self.holds.len());
        let mut random = Random::new(seed);
        let (phi, held, rise) = self.sampled();
        let mut x = DVector::from_fn(n, |_, _| random.within(-1.0, 1.0));
        let knots: Vec<DVector<f64>> =
            (0..=calls).map(|_| DVector::from_fn(m, |_, _| random.within(-1.0, 1.0))).collect();
        let mut run = Run::default();
        let mut largest = DVector::zeros(n);
        for call in 0..calls {
            if call > 0 {
                let (from, to) = (&knots[call - 1], &knots[call]);
                // A discrete plant uses the value at the beginning of its step, whatever the hold.
                let rises =
                    DVector::from_fn(m, |i, _| if self.holds[i] == Hold::First { to[i] - from[i] } else { 0.0 });
                x = &phi * &x + &held * from + &rise * rises;
            }
            largest = DVector::from_fn(n, |i, _| f64::max(largest[i], x[i].abs()));
            let input = |i: usize| match self.holds[i] {
                Hold::Zero if call == 0 => NOTHING_YET,
                Hold::Zero => knots[call - 1][i],
                Hold::First => knots[call][i],
            };
            run.inputs.push((0..m).map(input).collect());
            run.states.push(x.iter().copied().collect());
            let sample = |o: usize| match call.checked_sub(self.delays[o]) {
                Some(past) => (self.c.row(o) * DVector::from_vec(run.states[past].clone()))[0],
                None => NOTHING_YET,
            };
            run.measurements.push((0..self.delays.len()).map(sample).collect());
        }
        // Each product and sum is rounded; the exponential is right to some units of its largest entries.
        let (norm, roundings) = (phi.abs().max().max(1.0), (n + 2 * m + 2) as f64);
        let exponential = if self.discrete { 0.0 } else { 32.0 * norm };
        let total = largest.sum() + 2.0 * held.abs().max().max(rise.abs().max()) * m as f64;
        let through = phi.abs() * &largest
            + held.abs() * DVector::from_element(m, 1.0)
            + rise.abs() * DVector::from_element(m, 2.0);
        let step = through.iter().map(|t| roundings * t + exponential * total).collect();
        (run, step)
    }
}

fn or_zero(text: String) -> String {
    if text.is_empty() { "0".into() } else { text }
}

/// The design, or that the plant does not show its state; everything else is a failure.
fn design(text: &str) -> Result<Option<Generated>, TestCaseError> {
    match Generator::new(text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design() {
        Ok(generated) => Ok(Some(generated)),
        Err(report) if report.diagnostics.iter().all(|d| d.code == codes::UNOBSERVABLE) => Ok(None),
        Err(report) => Err(TestCaseError::fail(format!("{}\n{text}", report.render(false)))),
    }
}

#[test]
fn every_observable_linear_plant_is_estimated_exactly() {
    let (refused, digits, worst) = (Cell::new(0), Cell::new([0; 4]), Cell::new(0.0_f64));
    let config = Config { cases: PLANTS, failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (
        1_usize..=6,
        1_usize..=3,
        0_usize..=2,
        (proptest::bool::ANY, proptest::bool::ANY),
        0_usize..=12,
        0_u64..1 << 40,
    );
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape| {
        let linear = Linear::new(shape);
        let text = linear.text();
        let Some(generated) = design(&text)? else {
            refused.set(refused.get() + 1);
            return Ok(());
        };
        if generated.design.valid_from_step != linear.steps {
            return Err(TestCaseError::fail("the promised step is not the window's length"));
        }
        let (run, step) = linear.run(2 * linear.steps + 10, shape.5);
        let answers = run.through(&generated);
        let bounds = rounding(&generated, &run, &step, &[]);
        check(&linear, &run, &answers, &bounds).map_err(|why| TestCaseError::fail(format!("{why}\n{text}")))?;
        let errors = answers.errors(&run, linear.steps..run.states.len());
        for ((error, bound), size) in errors.iter().zip(&bounds).zip(run.sizes(linear.steps)) {
            let mut count = digits.get();
            let relative = bound / size.max(1e-3);
            count[[1e-12, 1e-9, 1e-6].iter().position(|limit| relative < *limit).unwrap_or(3)] += 1;
            digits.set(count);
            worst.set(worst.get().max(error / bound));
        }
        Ok(())
    });
    outcome.unwrap_or_else(|why| panic!("{why}"));
    let ([a, b, c, d], refused) = (digits.get(), refused.get());
    println!(
        "{refused} of {PLANTS} refused; states with a bound below 1e-12: {a}, 1e-9: {b}, 1e-6: {c}, above: {d}; largest error / bound {:.2e}",
        worst.get()
    );
    assert!(refused * 10 <= PLANTS, "{refused} of {PLANTS} refused");
    assert!(d * 20 <= a + b + c + d, "the bound says nothing for {d} states");
}

/// Converging before the promised step, converged and within the bound from it on.
fn check(linear: &Linear, run: &Run, answers: &Answers, bounds: &[f64]) -> Result<(), String> {
    for (call, status) in answers.statuses.iter().enumerate() {
        let expected = if call < linear.steps { Status::Converging } else { Status::Converged };
        if *status != expected {
            return Err(format!("call {call}: {status:?}"));
        }
    }
    let errors = answers.errors(run, linear.steps..run.states.len());
    for (i, (error, bound)) in errors.iter().zip(bounds).enumerate() {
        if error > bound {
            return Err(format!("state {i}: error {error:e}, bound {bound:e}"));
        }
    }
    Ok(())
}

/// The tool's exact Phi is nalgebra's to some units in the last place: two exponentials that share nothing.
#[test]
fn the_transition_is_that_of_another_exponential() {
    for seed in 0..10 {
        let linear = Linear::new((1 + seed as usize % 5, 3, 1, (false, false), 2, seed));
        let Some(generated) = design(&linear.text()).unwrap() else { continue };
        let phi = linear.sampled().0;
        for (i, row) in matrix(&generated, "Phi").iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                assert!(
                    (entry - phi[(i, j)]).abs() <= 64.0 * UNIT * phi.abs().max(),
                    "seed {seed}: {entry} against {}",
                    phi[(i, j)]
                );
            }
        }
    }
}
