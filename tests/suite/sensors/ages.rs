//! Claim: samples that come with their ages give the state of now to rounding, from the promised call on: of chains of
//! integrators up to order 4 and plants of up to 3 states, with inputs of either hold; a sample without a usable age is
//! missing; and in single precision the series in the age cost no more than rounding.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::depth::trials;
use crate::support::{linear, plant};

use std::cell::Cell;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use linear::{Linear, Shape};
use nalgebra::{DMatrix, DVector};
use plant::{Random, Run, UNIT, corpus, designed, designed_in, functional};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Random plants.
fn plants() -> u32 {
    trials(30, 200)
}

/// The state of so long before a call.
fn earlier(linear: &Linear, run: &Run, call: usize, age: f64) -> DVector<f64> {
    let now = DVector::from_vec(run.states[call].clone());
    // What acts before the first call nobody knows; its sample counts only where nothing does.
    if linear.holds.is_empty() || call == 0 {
        return linear.over(-age).0 * now;
    }
    // From the call before on: held inputs are those that this call brings, others run straight.
    let since = linear.h - age;
    let (phi, held, rise) = linear.over(since);
    let from = DVector::from_fn(linear.holds.len(), |i, _| match linear.holds[i] {
        plant::Hold::Zero => run.inputs[call][i],
        plant::Hold::First => run.inputs[call - 1][i],
    });
    let risen = DVector::from_fn(linear.holds.len(), |i, _| match linear.holds[i] {
        plant::Hold::Zero => 0.0,
        plant::Hold::First => (run.inputs[call][i] - run.inputs[call - 1][i]) * since / linear.h,
    });
    phi * DVector::from_vec(run.states[call - 1].clone()) + held * from + rise * risen
}

/// Gives every sample of an output with an age one, up to the oldest; one in twenty is older, or of no known age.
fn age(linear: &Linear, run: &mut Run, random: &mut Random) {
    for call in 0..run.states.len() {
        let mut ages = Vec::new();
        for (o, most) in linear.ages.iter().enumerate().filter(|(_, most)| **most > 0.0) {
            let age = random.within(0.0, *most);
            let state = earlier(linear, run, call, age);
            run.measurements[call][o] = (linear.c.row(o) * state)[0];
            ages.push(match random.below(60) {
                0 => 1.1 * most,
                1 => f64::NAN,
                2 => -age,
                _ => age,
            });
        }
        run.measurements[call].extend(ages);
    }
}

/// The most by which rounding can move the estimate: as often as `Irregular::amplification` says for samples at the
/// times of calls, with the run's own simulation, whose error of some units per sample the observer sees as noise. Other
/// times cost more, as pivots fall; 64 times is allowed, and the largest error of these plants is below a tenth of that.
fn bound(generated: &Generated, run: &Run) -> f64 {
    let sizes = run.sizes(0).into_iter().fold(0.0, f64::max);
    let inputs = run.inputs.iter().flatten().fold(0.0_f64, |largest, u| largest.max(u.abs()));
    let irregular = functional(generated).irregular.as_ref().expect("a solve in the step");
    let moved = irregular.largest_gain().min(1e3) * inputs;
    64.0 * UNIT * irregular.amplification().max(1.0) * (sizes + inputs + moved)
}

#[test]
fn every_linear_plant_is_estimated_exactly_from_samples_with_ages() {
    let (refused, tight, worst) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64));
    let (coasting, converged) = (Cell::new(0), Cell::new(0));
    let config = Config { cases: plants(), failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (
        1_usize..=4,
        1_usize..=2,
        0_usize..=2,
        (proptest::bool::ANY, proptest::bool::ANY),
        10_usize..=20,
        0_u64..1 << 40,
    );
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape: Shape| {
        let (mut linear, mut random) = Linear::new(shape);
        let n = linear.a.nrows();
        (linear.discrete, linear.delays) = (false, vec![0; linear.delays.len()]);
        if shape.3.0 || n > 3 {
            linear.a = DMatrix::from_fn(n, n, |i, j| if j == i + 1 { 1.0 } else { 0.0 });
            linear.c.column_mut(0).fill(1.0);
        }
        // Without inputs a sample may be older than a sample time.
        let chain = shape.3.0 || n > 3;
        let most = if linear.holds.is_empty() && chain { 2.5 * linear.h } else { linear.h };
        linear.ages =
            (0..linear.delays.len()).map(|o| if o == 0 || random.below(2) == 0 { most } else { 0.0 }).collect();
        let text = linear.text("[observer.window]");
        let generated = match Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design()
        {
            Ok(generated) => generated,
            Err(report) => {
                let known = report.diagnostics.iter().all(|d| d.code == codes::UNOBSERVABLE);
                refused.set(refused.get() + 1);
                return if known { Ok(()) } else { Err(TestCaseError::fail(report.render(false))) };
            }
        };
        let steps = linear.steps;
        let calls = 3 * steps + 10;
        let (mut run, _) = linear.run(calls, shape.5);
        age(&linear, &mut run, &mut random);
        let answers = run.through(&generated);
        let expected = |call| if call < steps { Status::Converging } else { Status::Converged };
        // Ages at which the gains are larger than the printed ones are rare, and say so; the estimate is exact with them too.
        let coasts = |call: &usize| *call >= steps && answers.statuses[*call] == Status::Coasting;
        coasting.set(coasting.get() + (0..calls).filter(coasts).count());
        converged.set(converged.get() + calls - steps);
        let other = |call: &usize| answers.statuses[*call] != expected(*call) && !coasts(call);
        if let Some(call) = (0..calls).find(other) {
            return Err(TestCaseError::fail(format!("call {call}: {:?}\n{text}", answers.statuses[call])));
        }
        let bound = bound(&generated, &run);
        let size = run.sizes(steps).into_iter().fold(0.0, f64::max);
        for (i, error) in answers.errors(&run, steps..calls).into_iter().enumerate() {
            worst.set(worst.get().max(error / bound));
            if error > bound {
                return Err(TestCaseError::fail(format!("state {i}: {error:e} above {bound:e} of {size:e}\n{text}")));
            }
        }
        tight.set(tight.get() + u32::from(bound < 1e-6 * size.max(1e-3)));
        Ok(())
    });
    outcome.unwrap_or_else(|why| panic!("{why}"));
    let (refused, tight) = (refused.get(), tight.get());
    println!(
        "{refused} of {} refused; the bound is below a millionth of the state for {tight}; largest error / bound {:.1e}",
        plants(),
        worst.get()
    );
    let (coasting, converged) = (coasting.get(), converged.get());
    println!("{coasting} of {converged} calls after the first window with larger gains than printed");
    assert!(1_000 * coasting <= converged, "{coasting} of {converged} calls");
    assert!(5 * (plants() - refused) >= 3 * plants(), "{refused} of {} refused", plants());
    assert!(2 * tight >= plants() - refused, "the bound says nothing for most plants");
}

/// Edges of an encoder: each is exact, at its own time. At constant acceleration, which the chain of three knows, speed
/// and acceleration come out to rounding although the edges come as they like, several turns a window.
#[test]
fn edges_give_speed_and_acceleration_without_quantisation() {
    let (tau, count) = (std::f64::consts::TAU, std::f64::consts::TAU / 64.0);
    for (scalar, allowed) in [(Scalar::F64, [1e-11, 1e-9, 1e-7]), (Scalar::F32, [1e-5, 1e-2, 1.0])] {
        let generated = designed_in(&corpus("edge_times"), scalar);
        let steps = generated.design.valid_from_step;
        let motion = |t: f64| [1.0 + 300.0 * t - 200.0 * t * t, 300.0 - 400.0 * t, -400.0];
        let mut run = Run::default();
        for call in 0..3 * steps {
            let t = call as f64 * 1e-3;
            // The newest edge: where the position last passed a multiple of a count.
            let edge = (motion(t)[0] / count).floor() * count;
            let root = (300.0_f64 * 300.0 - 800.0 * (edge - 1.0)).sqrt();
            let age = t - (300.0 - root) / 400.0;
            run.states.push(motion(t).to_vec());
            run.measurements.push(vec![edge - tau * (edge / tau).round(), age]);
            run.inputs.push(Vec::new());
        }
        let answers = run.through(&generated);
        for call in steps..3 * steps {
            assert_eq!(answers.statuses[call], Status::Converged, "call {call}");
            for (i, allowed) in allowed.iter().enumerate() {
                let error = answers.estimates[call][i] - run.states[call][i];
                let error = if i == 0 { error - tau * (error / tau).round() } else { error };
                assert!(error.abs() < *allowed, "{scalar}, call {call}, state {i}: {error:e}");
            }
        }
    }
}

/// Without ages the same motor is wrong by what it moves in them.
#[test]
fn a_sample_of_unknown_age_is_missing() {
    let generated = designed(&corpus("bus_sensor"));
    let steps = generated.design.valid_from_step;
    let mut run = Run::default();
    for call in 0..3 * steps {
        let old = call >= 2 * steps;
        run.measurements.push(vec![0.5, if old { 1.001e-3 } else { 0.3e-3 }]);
        run.inputs.push(vec![0.0]);
        run.states.push(vec![0.5, 0.0, 0.0]);
    }
    let answers = run.through(&generated);
    assert!(answers.statuses[steps..2 * steps].iter().all(|status| *status == Status::Converged));
    assert_eq!(answers.statuses[3 * steps - 1], Status::Coasting);
    let error = |calls| answers.errors(&run, calls).into_iter().fold(0.0, f64::max);
    assert!(error(steps..2 * steps) < bound(&generated, &run));
    // While the last rows leave the window, each of three pivots falls to a 64th before the model takes over.
    assert!(error(2 * steps..3 * steps) < 64.0 * bound(&generated, &run));
}
