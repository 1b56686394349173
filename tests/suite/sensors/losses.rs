//! Claim: with samples lost the status says converged only while the bound holds that the header prints for that,
//! whatever the losses, the noise and the disturbances; and with all samples that are due it always says so.
//!
//! The worst noise for the samples of a call has the signs of their weights, the worst disturbance those of its own
//! effect; both are fed to the step, so that what it is attacked with is what it answers.

#![allow(clippy::cast_precision_loss, reason = "counts of calls are small")]

use crate::support::depth::trials;
use crate::support::{linear, plant};

use deadbeat_codegen::internals::estimator::window::irregular::{Irregular, unit};
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator};
use linear::Linear;
use nalgebra::{DMatrix, DVector, RowDVector};
use plant::{Random, Run, corpus, delays, designed_in, edited, functional, matrix};

fn solve(generated: &Generated) -> &Irregular {
    functional(generated).irregular.as_ref().expect("a solve in the step")
}

fn dense(generated: &Generated, letter: &str) -> DMatrix<f64> {
    let rows = matrix(generated, letter);
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

/// A plant at rest, with the samples of a pattern there.
fn at_rest(generated: &Generated, calls: usize, there: &dyn Fn(usize, usize) -> bool) -> Run {
    let (n, p, m) = (generated.plant.states.len(), generated.plant.outputs.len(), generated.plant.inputs.len());
    let mut run = Run::default();
    for call in 0..calls {
        run.states.push(vec![0.0; n]);
        run.measurements.push((0..p).map(|o| if there(call, o) { 0.0 } else { f64::NAN }).collect());
        run.inputs.push(vec![0.0; m]);
    }
    run
}

/// What disturbances of the plant do to its state in a sample interval, held over it; n x d, times their bounds.
fn kicks(generated: &Generated) -> DMatrix<f64> {
    let plant = &generated.plant;
    let (n, d, h) = (plant.states.len(), plant.disturbances.len(), plant.sample_time_s());
    let number = |c: &deadbeat_codegen::internals::expr::Constant| c.to_f64().unwrap();
    let mut whole = DMatrix::zeros(n + d, n + d);
    for i in 0..n {
        (0..n).for_each(|j| whole[(i, j)] = number(&plant.a[i][j]) * h);
        for (k, disturbance) in plant.disturbances.iter().enumerate() {
            whole[(i, n + k)] = number(&disturbance.column[i]) * number(&disturbance.bound) * h;
        }
    }
    plant::exponential(&whole).view((0, n), (n, d)).into_owned()
}

/// The worst noise and disturbance for a state at a call, with what they do: samples and states of every call.
struct Worst {
    run: Run,
    error: f64,
}

fn worst(generated: &Generated, run: &Run, call: usize, state: usize) -> Option<Worst> {
    let irregular = solve(generated);
    let (steps, delays) = (irregular.rows.len() - 1, delays(generated));
    let at = |age: usize, o: usize| age >= delays[o] && !run.measurements[call + delays[o] - age][o].is_nan();
    let weights = irregular.weights(&at)?;
    let (phi, c, kicks) = (dense(generated, "Phi"), dense(generated, "C"), kicks(generated));
    let noise = |o: usize| generated.plant.outputs[o].noise.as_ref().unwrap().to_f64().unwrap();
    let mut attacked = run.clone();
    let mut error = 0.0;
    for (age, weights) in weights.iter().enumerate() {
        for o in (0..delays.len()).filter(|o| at(age, *o)) {
            let weight = weights[(state, o)];
            error += weight.abs() * noise(o);
            attacked.measurements[call + delays[o] - age][o] = weight.signum() * noise(o);
        }
    }
    // What is left of the state's own change in an interval, by its age.
    let mut left = DMatrix::identity(phi.nrows(), phi.nrows());
    let mut signs = vec![DVector::zeros(kicks.ncols()); call + 1];
    for age in 0..steps {
        left -= &weights[age] * &c;
        let effect = -(&left * &kicks).row(state);
        error += effect.abs().sum();
        signs[call - age] = effect.transpose().map(f64::signum);
        left = &left * &phi;
    }
    let mut x = DVector::zeros(phi.nrows());
    for (of, signs) in signs.iter().enumerate().skip(1) {
        x = &phi * &x + &kicks * signs;
        attacked.states[of] = x.iter().copied().collect();
        let shown = &c * &x;
        for (o, delay) in delays.iter().enumerate() {
            if let Some(row) = attacked.measurements.get_mut(of + delay) {
                row[o] += shown[o];
            }
        }
    }
    Some(Worst { run: attacked, error })
}

/// Roundings of an elimination with its sums, of a unit of the floats each.
const ROUNDINGS: f64 = 64.0;

/// The condition of the normal equations with the samples of a call, their columns scaled to one. The step asks for shares
/// of diagonals, which can be large while this is larger still: 5 samples of 29 calls of a plant that dies out.
fn condition(generated: &Generated, run: &Run, call: usize) -> f64 {
    let (irregular, delays) = (solve(generated), delays(generated));
    let steps = irregular.rows.len() - 1;
    let all = (0..=steps).flat_map(|age| (0..delays.len()).map(move |o| (age, o)));
    let there = all.filter(|(age, o)| age >= &delays[*o] && !run.measurements[call + delays[*o] - age][*o].is_nan());
    let rows: Vec<_> = there
        .map(|(age, o)| {
            RowDVector::from_iterator(irregular.phi.len(), irregular.rows[steps - age][o].iter().map(|x| x.double))
        })
        .collect();
    let mut rows = DMatrix::from_rows(&rows);
    rows.column_iter_mut().for_each(|mut column| column /= column.norm().max(f64::MIN_POSITIVE));
    let values = rows.singular_values();
    (values.max() / values.min()).powi(2)
}

/// The largest share of the bound that noise reaches while the status says converged, in two ways: at every call by the
/// weights, at the worst by the step.
fn attack(generated: &Generated, run: &Run, what: &str) -> f64 {
    let steps = generated.design.valid_from_step;
    let statuses = run.through(generated).statuses;
    let bounds = &generated.design.certificate.error_bound_with_losses;
    let mut largest = 0.0_f64;
    for (state, bound) in bounds.iter().enumerate() {
        let bound = bound.unwrap_or_else(|| panic!("{what}: no bound"));
        let mut most: Option<(f64, usize)> = None;
        for call in (steps..run.measurements.len()).filter(|call| statuses[*call] == Status::Converged) {
            let worst = worst(generated, run, call, state).unwrap_or_else(|| panic!("{what}, call {call}: converged"));
            if most.is_none_or(|(error, _)| worst.error > error) {
                most = Some((worst.error, call));
            }
        }
        let Some((error, call)) = most.filter(|(error, _)| *error > 0.0) else { continue };
        assert!(error <= bound * (1.0 + 1e-9), "{what}, state {state}, call {call}: {error:e} above {bound:e}");
        let attacked = worst(generated, run, call, state).expect("as before").run;
        let answers = attacked.through(generated);
        assert_eq!(answers.statuses[call], Status::Converged, "{what}, call {call}: the status is of what is there");
        let reached = (answers.estimates[call][state] - attacked.states[call][state]).abs();
        let digits = if generated.plant.scalar == Scalar::F32 { 2e-2 } else { 1e-6 };
        // What rounding does to the equations is in proportion to all of the answer, in units of the bounds.
        let off = |(estimate, truth): (&f64, &f64)| (estimate - truth).abs();
        let errors = answers.estimates[call].iter().zip(&attacked.states[call]).map(off);
        let size = errors.zip(bounds).map(|(error, bound)| error / bound.unwrap()).fold(0.0, f64::max);
        let rounding = ROUNDINGS * unit(generated.plant.scalar) * condition(generated, run, call) * size * bound;
        assert!(
            (reached - error).abs() < digits * error + rounding,
            "{what}, state {state}, call {call}: {reached:e}, not {error:e}, rounding {rounding:e}"
        );
        assert!(reached <= bound * (1.0 + digits), "{what}, state {state}, call {call}: {reached:e} above {bound:e}");
        largest = largest.max(error / bound);
    }
    largest
}

/// A chain with a slow mode, of whose samples half are missing: its noise reached 13.5 times the bound while the status
/// said converged.
const CHAIN: &str = "deadbeat = 1
name = 'chain'
[states]
x1 = { derivative = 'x2' }
x2 = { derivative = '1.9*x3 + 0.2*u1' }
x3 = { derivative = '-0.77*x3 + 3.1*u1 + w' }
[inputs]
u1 = {}
[outputs]
y1 = { value = 'x1', noise = 1e-3 }
[disturbances]
w = { bound = 0.01 }
[observer.window]
window = 0.26
missing = 'left-out'
[target]
sample_time = 0.013
";

#[test]
fn no_noise_and_no_disturbance_passes_the_bound_while_samples_are_lost() {
    let quiet = edited(&edited(CHAIN, " + w'", "'"), "[disturbances]\nw = { bound = 0.01 }\n", "");
    for (name, text) in [("noise", quiet.as_str()), ("disturbed", CHAIN)] {
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(text, scalar);
            let (steps, calls) = (generated.design.valid_from_step, 400);
            let mut largest = 0.0_f64;
            for seed in 0..trials(8, 60) {
                let mut random = Random::new(seed);
                let percent = [3, 20, 50, 70][usize::try_from(seed).unwrap() % 4];
                let lost: Vec<bool> = (0..calls).map(|_| random.below(100) < percent).collect();
                let run = at_rest(&generated, calls, &|call, _| !lost[call]);
                largest = largest.max(attack(&generated, &run, &format!("{name} {scalar}, seed {seed}")));
            }
            println!("{name} {scalar}: {largest:.3} of the bound with samples lost");
            assert!(largest > 0.3, "{name} {scalar}: the bound is far from {largest}");
            let full = at_rest(&generated, calls, &|_, _| true).through(&generated);
            assert!(full.statuses[steps..].iter().all(|status| *status == Status::Converged));
        }
    }
}

/// Rates of their own with losses, and measurements at irregular times: the gains printed are of regular samples.
#[test]
fn rates_and_irregular_times_keep_their_bounds() {
    for (name, due) in [("two_rates", [5, 1]), ("drive_irregular", [10, 10])] {
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&corpus(name), scalar);
            let (steps, p) = (generated.design.valid_from_step, generated.plant.outputs.len());
            let calls = 6 * steps;
            for seed in 0..trials(2, 20) {
                let mut random = Random::new(seed);
                let lost: Vec<Vec<bool>> =
                    (0..calls).map(|_| (0..p).map(|_| random.below(100) < 40).collect()).collect();
                let run = at_rest(&generated, calls, &|call, o| call % due[o] == 0 && !lost[call][o]);
                let largest = attack(&generated, &run, &format!("{name} {scalar}, seed {seed}"));
                println!("{name} {scalar}, seed {seed}: {largest:.3} of the bound");
            }
            let full = at_rest(&generated, calls, &|call, o| call % due[o] == 0).through(&generated);
            assert!(full.statuses[steps..].iter().all(|status| *status == Status::Converged), "{name} {scalar}");
        }
    }
}

/// Random plants, outputs late or not, with noises of their own, at rates or not, with losses.
#[test]
fn every_linear_plant_keeps_its_bound() {
    let (mut tried, mut largest, mut converged) = (0, 0.0_f64, 0);
    for seed in 0..trials(40, 400) {
        let shape = (1 + seed % 4, 1 + seed % 3, 0, (seed % 5 < 2, seed % 2 == 0), 8 + seed % 11, 1000 + seed as u64);
        let (mut linear, mut random) = Linear::new(shape);
        linear.noise = linear.delays.iter().map(|_| [1e-3, 1e-2, 0.25][random.below(3)]).collect();
        if seed % 4 == 3 {
            linear.every = linear.delays.iter().map(|_| 1 + random.below(3)).collect();
            linear.steps = 3 * (linear.a.nrows() + 1) + 3 + shape.4;
        }
        let text = linear.text("[observer.window]\nmissing = 'left-out'");
        // Some plants do not show their state.
        let Ok(generated) = Generator::new(&text, "random.toml").design() else { continue };
        if solve(&generated).amplification() > 1e6 {
            continue;
        }
        let (steps, p) = (linear.steps, linear.delays.len());
        let calls = 4 * steps;
        let due = |call: usize, o: usize| call.is_multiple_of(linear.every.get(o).copied().unwrap_or(1));
        let full = at_rest(&generated, calls, &due).through(&generated);
        assert!(full.statuses[steps..].iter().all(|status| *status == Status::Converged), "seed {seed}\n{text}");
        let percent = [5, 25, 50][random.below(3)];
        let lost: Vec<Vec<bool>> = (0..calls).map(|_| (0..p).map(|_| random.below(100) < percent).collect()).collect();
        let run = at_rest(&generated, calls, &|call, o| due(call, o) && !lost[call][o]);
        converged += run.through(&generated).statuses.iter().filter(|status| **status == Status::Converged).count();
        largest = largest.max(attack(&generated, &run, &format!("seed {seed}")));
        tried += 1;
    }
    println!("{tried} plants, {converged} calls converged with losses, {largest:.3} of the bound");
    assert!(tried >= trials(20, 200) && converged > 0, "{tried} {converged}");
}
