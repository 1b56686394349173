//! Claim: with `ahead`, the answer is the state so much later with the inputs of now, exactly to rounding, from the
//! promised call on, for random linear plants and every shape of step; the printed bound holds.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{linear, plant};

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::{Generator, Settings};
use linear::Linear;
use nalgebra::{DMatrix, DVector};
use plant::{Random, UNIT, corpus, designed, edited, rounding};

/// Plants that are tried.
const PLANTS: u64 = 200;

/// e^{A a} and its integral times B, over whole samples of a discrete plant.
fn moved(linear: &Linear, ahead: f64) -> (DMatrix<f64>, DMatrix<f64>) {
    if !linear.discrete {
        let (phi, held, _) = Linear { h: ahead, ..copy(linear) }.sampled();
        return (phi, held);
    }
    let steps = (ahead / linear.h).round() as usize;
    let (mut phi, mut held) = (DMatrix::identity(linear.a.nrows(), linear.a.nrows()), &linear.b * 0.0);
    for _ in 0..steps {
        held = &linear.a * held + &linear.b;
        phi = &linear.a * phi;
    }
    (phi, held)
}

fn copy(linear: &Linear) -> Linear {
    Linear {
        a: linear.a.clone(),
        b: linear.b.clone(),
        c: linear.c.clone(),
        holds: linear.holds.clone(),
        delays: linear.delays.clone(),
        noise: linear.noise.clone(),
        every: linear.every.clone(),
        ages: linear.ages.clone(),
        ..*linear
    }
}

#[test]
fn the_answer_is_the_state_later() {
    let (mut tried, mut refused) = (0, 0);
    for seed in 0..PLANTS {
        let mut kinds = Random::new(seed);
        let shape =
            (1 + kinds.below(5), 1 + kinds.below(2), kinds.below(3), (kinds.below(3) == 0, kinds.below(2) == 0));
        let (linear, _) = Linear::new((shape.0, shape.1, shape.2, shape.3, kinds.below(8), seed));
        let steps = 1 + kinds.below(3);
        let ahead = if linear.discrete { steps as f64 } else { 0.375 * steps as f64 } * linear.h;
        let text = linear.text(&format!("[observer.window]\nahead = {ahead}"));
        let generated = match Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design()
        {
            Ok(generated) => generated,
            Err(report) if report.diagnostics.iter().all(|d| d.code == codes::UNOBSERVABLE) => {
                refused += 1;
                continue;
            }
            Err(report) => panic!("{}\n{text}", report.render(false)),
        };
        let (run, step) = linear.run(2 * linear.steps + 10, seed);
        let answers = run.through(&generated);
        let (phi, held) = moved(&linear, ahead);
        let (bounds, sizes) = (rounding(&generated, &run, &step, &[]), run.sizes(0));
        for call in linear.steps..run.states.len() {
            let truth = &phi * DVector::from_vec(run.states[call].clone())
                + &held * DVector::from_vec(run.inputs[call].clone());
            for i in 0..linear.a.nrows() {
                // The estimate's rounding, carried on; each product and sum of both sides, and the two exponentials, by
                // some units in the last place of their largest entries.
                let carried: f64 = (0..sizes.len()).map(|j| phi[(i, j)].abs() * bounds[j]).sum();
                let terms: f64 = (0..sizes.len()).map(|j| phi[(i, j)].abs() * sizes[j]).sum::<f64>()
                    + held.row(i).iter().map(|x| x.abs()).sum::<f64>();
                let norm = phi.abs().max().max(held.iter().fold(1.0, |most: f64, x| most.max(x.abs())));
                let total = sizes.iter().sum::<f64>() + linear.b.ncols() as f64;
                let bound = carried + UNIT * (16.0 * terms + 64.0 * norm * total);
                let error = (answers.estimates[call][i] - truth[i]).abs();
                assert!(error <= bound, "seed {seed}, call {call}, state {i}: {error:e} above {bound:e}\n{text}");
            }
        }
        tried += 1;
    }
    println!("{tried} plants, {refused} refused");
    assert!(refused * 10 <= tried, "{refused} refused");
}

/// Every shape of step: the answer is what the same observer's answer makes of it, with nonlinear terms as they are now.
#[test]
fn every_method_moves_its_answer_alone() {
    for name in ["long_window", "oscillator", "oscillator_kalman", "luenberger", "pendulum_impulsive", "kalman"] {
        let text = corpus(name);
        let (now, later) = (designed(&text), designed(&edited(&text, "[target]", "ahead = 0.004\n[target]")));
        assert_eq!(now.program.cells, later.program.cells, "{name} carries the same state");
        let mut random = Random::new(7);
        let calls = now.design.valid_from_step + 20;
        let (n, m) = (now.plant.states.len(), now.plant.inputs.len());
        let a = DMatrix::from_fn(n, n, |i, j| now.plant.a[i][j].to_f64().unwrap());
        // Over 4 ms: x + a (A x + f) + a^2/2 A (A x + f) + …, f the rest of the right-hand side.
        let series = |x: &DVector<f64>, f: &DVector<f64>| {
            let mut term = (&a * x + f) * 0.004;
            let mut sum = x + &term;
            for k in 2..=20 {
                term = &a * term * (0.004 / f64::from(k));
                sum += &term;
            }
            sum
        };
        let (mut before, mut after) =
            ([&now, &later].map(|g| deadbeat_codegen::program::interp::Interpreter::new(&g.program))).into();
        for call in 0..calls {
            let y: Vec<f64> = now.plant.outputs.iter().map(|_| 0.3 + 0.01 * random.within(-1.0, 1.0)).collect();
            let u: Vec<f64> = (0..m).map(|_| random.within(-1.0, 1.0)).collect();
            let [mut x, mut z] = [vec![0.0; n], vec![0.0; n]];
            step(&mut before, &y, &u, &mut x);
            step(&mut after, &y, &u, &mut z);
            let f = DVector::from_fn(n, |i, _| {
                let linear: f64 = (0..m).map(|k| now.plant.b[i][k].to_f64().unwrap() * u[k]).sum();
                let pendulum = now.plant.injections.iter().map(|injection| {
                    assert!(injection.text.contains("sin"), "{name} has only sines of its first state");
                    injection.column[i].to_f64().unwrap() * y[0].sin()
                });
                linear + pendulum.sum::<f64>() + now.plant.offset[i].to_f64().unwrap()
            });
            let expected = series(&DVector::from_vec(x.clone()), &f);
            for i in 0..n {
                // A few products and sums of either side.
                let size = x.iter().chain(&z).fold(1.0, |most: f64, x| most.max(x.abs())) * (1.0 + a.abs().max());
                let error = (z[i] - expected[i]).abs();
                assert!(error <= 1e3 * UNIT * size, "{name}, call {call}, state {i}: {error:e} of {size}");
            }
        }
    }
}

fn step(interpreter: &mut deadbeat_codegen::program::interp::Interpreter, y: &[f64], u: &[f64], x: &mut [f64]) {
    interpreter.step(y, u, x);
}

/// The worst case that bounded noise makes of the moved answers, by one unit at each sample in turn, is within what the
/// certificate prints for each window, and no less than the hundredth part of it.
#[test]
fn the_printed_gains_are_of_the_moved_answers() {
    let text = edited(&corpus("three_windows"), "[target]", "ahead = 0.004\n[target]");
    let generated = designed(&text);
    let n = generated.plant.states.len();
    let design = &generated.design;
    let certificates =
        std::iter::once(&design.certificate).chain(design.longer.iter().map(|longer| &longer.certificate));
    let gains: Vec<Vec<f64>> = certificates.map(|c| c.noise_gain_l1.iter().map(|gain| gain[0]).collect()).collect();
    assert_eq!(gains.len(), 3);
    // The longest window, full.
    let calls = 1 + (gains.len() * 100).max(300);
    let mut worst = vec![vec![0.0_f64; n]; gains.len()];
    let mut answer = vec![0.0; generated.program.estimates.len()];
    for unit in 0..calls {
        let mut interpreter = deadbeat_codegen::program::interp::Interpreter::new(&generated.program);
        for call in 0..calls {
            interpreter.step(&[f64::from(u8::from(call == unit))], &[], &mut answer);
        }
        for (window, sums) in worst.iter_mut().enumerate() {
            sums.iter_mut().zip(&answer[window * n..]).for_each(|(sum, x)| *sum += x.abs());
        }
    }
    for (printed, worst) in gains.iter().flatten().zip(worst.iter().flatten()) {
        // A sum of some hundred magnitudes, rounded.
        assert!(*worst <= printed * (1.0 + 1e-12), "{worst} above {printed}");
        assert!(*worst >= printed / 100.0, "{worst} is not near {printed}");
    }
}
