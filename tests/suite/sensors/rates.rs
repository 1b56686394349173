//! Claim: outputs that are measured at rates of their own give the state to rounding at every phase, from the promised
//! call on, with the rest late or not; a sample that is not due is not missed, one that comes early is used; and the
//! gains that are printed are those of the worst phase.

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
use plant::{Random, Run, UNIT, corpus, designed, functional};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Random plants.
fn plants() -> u32 {
    trials(30, 200)
}

/// Leaves the samples that are due; of the others one in ten, which come early.
fn thin(run: &mut Run, every: &[usize], random: &mut Random) {
    for (call, row) in run.measurements.iter_mut().enumerate() {
        for (y, every) in row.iter_mut().zip(every) {
            if call % every > 0 && random.below(10) > 0 {
                *y = f64::NAN;
            }
        }
    }
}

/// The most by which rounding can move the estimate: as often as `Irregular::amplification` says of the worst phase, with
/// the run's own simulation, whose error of some units per sample the observer sees as noise. Samples that come early
/// only help. Sixteen times is allowed for the pass itself; the largest error of these plants is far below it.
fn bound(generated: &Generated, run: &Run) -> f64 {
    let sizes = run.sizes(0).into_iter().fold(0.0, f64::max);
    let inputs = run.inputs.iter().flatten().fold(0.0_f64, |largest, u| largest.max(u.abs()));
    let irregular = functional(generated).irregular.as_ref().expect("a solve in the step");
    let moved = irregular.largest_gain().min(1e3) * inputs;
    16.0 * UNIT * irregular.amplification().max(1.0) * (sizes + inputs + moved)
}

#[test]
fn every_linear_plant_is_estimated_exactly_at_every_phase() {
    let (refused, tight, worst) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64));
    let config = Config { cases: plants(), failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (
        1_usize..=4,
        1_usize..=3,
        0_usize..=2,
        (proptest::bool::ANY, proptest::bool::ANY),
        0_usize..=12,
        0_u64..1 << 40,
    );
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape: Shape| {
        let (mut linear, mut random) = Linear::new(shape);
        linear.every = linear.delays.iter().map(|_| 1 + random.below(4)).collect();
        linear.every[0] = linear.every[0].max(2);
        linear.steps = 4 * (linear.a.nrows() + 1) + 3 + shape.4;
        let text = linear.text("[observer.window]");
        let generated = match Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design()
        {
            Ok(generated) => generated,
            Err(report) => {
                let expected = [codes::UNOBSERVABLE, codes::WINDOW_TOO_SHORT];
                let known = report.diagnostics.iter().all(|d| expected.contains(&d.code));
                refused.set(refused.get() + 1);
                return if known { Ok(()) } else { Err(TestCaseError::fail(report.render(false))) };
            }
        };
        let steps = linear.steps;
        let calls = 3 * steps + 20;
        let (mut run, _) = linear.run(calls, shape.5);
        thin(&mut run, &linear.every, &mut random);
        let answers = run.through(&generated);
        let expected = |call| if call < steps { Status::Converging } else { Status::Converged };
        if let Some(call) = (0..calls).find(|call| answers.statuses[*call] != expected(*call)) {
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
    assert!(5 * (plants() - refused) >= 3 * plants(), "{refused} of {} refused", plants());
    assert!(2 * tight >= plants() - refused, "the bound says nothing for most plants");
}

/// Noise at its bound, by signs that are worst for one phase, moves the estimate by the printed gain: the largest of all
/// phases and no less.
#[test]
fn the_printed_gains_are_attained_at_the_worst_phase() {
    let generated = designed(&corpus("two_rates"));
    let irregular = functional(&generated).irregular.as_ref().expect("a solve in the step");
    let (steps, states) = (generated.design.valid_from_step, generated.plant.states.len());
    assert_eq!(generated.design.phases.len(), 5);
    let delays = plant::delays(&generated);
    let every = [5, 1];
    for output in 0..2 {
        for state in 0..states {
            let mut largest = 0.0_f64;
            for phase in 0..5 {
                let last = steps + 5 + phase;
                let weights = irregular.weights(&|age, o| irregular.pattern.there(last % 5, age, o)).expect("enough");
                let mut run = Run::default();
                for call in 0..=last {
                    let row = (0..2).map(|o| {
                        let age = last + delays[o] - call;
                        let sign = if age <= steps && o == output { weights[age][(state, o)].signum() } else { 0.0 };
                        if call % every[o] == 0 { sign } else { f64::NAN }
                    });
                    run.measurements.push(row.collect());
                    run.inputs.push(vec![0.0]);
                    run.states.push(vec![0.0; states]);
                }
                let answers = run.through(&generated);
                let (gain, expected) =
                    (answers.estimates[last][state], generated.design.phases[last % 5].noise_gain_l1[state][output]);
                // Both are sums over the same rows in doubles, by different ways.
                assert!((gain / expected - 1.0).abs() < 1e-9, "phase {phase}: {gain} {expected}");
                largest = largest.max(gain);
            }
            let printed = generated.design.certificate.noise_gain_l1[state][output];
            assert!((largest / printed - 1.0).abs() < 1e-9, "{largest} {printed}");
        }
    }
}
