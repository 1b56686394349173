//! Claim: with `missing = "left-out"` the estimate is that of the samples that are there: exact to rounding for linear
//! plants with outputs late or not, from the promised call on, whatever is lost; converged as long as they determine the
//! state, and the model's prediction where they do not. Of a nonlinear plant only a sample that a nonlinear term needs
//! makes the observer coast.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::depth::trials;
use crate::support::{linear, plant, truths};

use std::cell::Cell;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::internals::estimator::window::irregular::{Irregular, There};
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use linear::{Linear, Shape};
use plant::{Random, Run, UNIT, corpus, delays, designed, functional};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use truths::truth;

/// Random plants.
fn plants() -> u32 {
    trials(30, 200)
}

fn solve(generated: &Generated) -> &Irregular {
    functional(generated).irregular.as_ref().expect("a solve in the step")
}

/// One sample in twenty is lost, and now and then all of an output for half a window.
fn lose(run: &mut Run, steps: usize, random: &mut Random) {
    let outputs = run.measurements[0].len();
    for o in 0..outputs {
        let mut silent = 0;
        for row in &mut run.measurements {
            if random.below(6 * steps) == 0 {
                silent = steps / 2;
            }
            if silent > 0 || random.below(20) == 0 {
                row[o] = f64::NAN;
            }
            silent = silent.saturating_sub(1);
        }
    }
}

/// What the samples that are there say of the state at a call, by the rules that the step has; `None` when it is too near
/// to say.
#[derive(Clone, Copy, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "four answers, each asked for on its own")]
struct Worth {
    sound: bool,
    good: bool,
    close: bool,
    some: bool,
}

fn worth(generated: &Generated, run: &Run, call: usize) -> Option<Worth> {
    let irregular = solve(generated);
    let (delays, limits) = (delays(generated), &irregular.worth);
    let at = |age: usize, o: usize| {
        let of = (call + delays[o]).checked_sub(age);
        age >= delays[o] && of.is_some_and(|of| !run.measurements[of][o].is_nan())
    };
    let some = (0..irregular.rows.len()).any(|age| (0..delays.len()).any(|o| at(age, o)));
    let nothing = Worth { sound: false, good: false, close: false, some };
    let Some(equations) = irregular.eliminated(&There { at: &at, share: &|_| 0.0 }) else { return Some(nothing) };
    let shares = irregular.asked();
    let shares = shares.iter().zip(&limits.scale).filter_map(|(t, scale)| Some(equations.variance(t) / (*scale)?));
    let worst = shares.fold(0.0, f64::max);
    let bound = worst * (limits.per_sample * equations.count() + limits.fixed);
    // A small pivot is a difference of sums: its rounding is of their size.
    let near = |value: f64, limit: f64, digits: f64| limit > 0.0 && (value / limit - 1.0).abs() < digits;
    let limited = [(worst, limits.most), (worst, limits.usual), (bound, 1.0)];
    if near(equations.tolerance, limits.tolerance, 1e-1)
        || limited.iter().any(|(value, limit)| near(*value, *limit, 1e-3))
    {
        return None;
    }
    let sound = equations.tolerance > limits.tolerance && worst <= limits.most;
    let good = sound && worst <= limits.usual;
    Some(Worth { sound, good, close: good && bound <= 1.0, some })
}

/// The most by which rounding can move the estimate.
///
/// The sums over the rows and the run's own simulation, whose error of some units per sample the observer sees as noise,
/// reach a state as often as `Irregular::amplification` says with all samples there. With fewer, variances rise 64 times,
/// and the estimate is that much less certain; a prediction that stands in carries its own error on, as the plant does.
fn bound(generated: &Generated, run: &Run) -> f64 {
    let sizes = run.sizes(0).into_iter().fold(0.0, f64::max);
    let inputs = run.inputs.iter().flatten().fold(0.0_f64, |largest, u| largest.max(u.abs()));
    let irregular = solve(generated);
    let moved = irregular.largest_gain().min(1e3) * inputs;
    64.0 * UNIT * irregular.amplification().max(1.0) * (sizes + inputs + moved)
}

#[test]
fn every_linear_plant_is_estimated_exactly_from_the_samples_that_are_there() {
    let (refused, tight, worst, coasted) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64), Cell::new(0));
    let config = Config { cases: plants(), failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (
        1_usize..=4,
        1_usize..=3,
        0_usize..=2,
        (proptest::bool::ANY, proptest::bool::ANY),
        6_usize..=18,
        0_u64..1 << 40,
    );
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape: Shape| {
        let (linear, mut random) = Linear::new(shape);
        let text = linear.text("[observer.window]\nmissing = 'left-out'");
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
        if generated.design.valid_from_step != steps {
            return Err(TestCaseError::fail("the promised step is not the window's length"));
        }
        let calls = 6 * steps + 10;
        let (mut run, _) = linear.run(calls, shape.5);
        lose(&mut run, steps, &mut random);
        let answers = run.through(&generated);
        // Whether there is an estimate, whether it is as exact as all samples give it, and how many calls none was good.
        let patience = 3 * (steps + 1);
        let (mut known, mut fine, mut poor, mut exact) = (false, false, patience, Vec::new());
        for call in 0..calls {
            let Some(worth) = worth(&generated, &run, call) else { return Ok(()) };
            let predicted = known;
            poor = if worth.good { 0 } else { (poor + usize::from(worth.some)).min(patience) };
            let solved = worth.sound && (worth.good || !predicted || poor == patience);
            known = call >= steps && (solved || predicted);
            fine = if solved { worth.good } else { fine };
            let expected = match (known, worth.close) {
                (true, true) => Status::Converged,
                (true, false) => Status::Coasting,
                (false, _) => Status::Converging,
            };
            if expected != answers.statuses[call] {
                let status = answers.statuses[call];
                return Err(TestCaseError::fail(format!("call {call}: {status:?}, not {expected:?}\n{text}")));
            }
            coasted.set(coasted.get() + u32::from(known && !worth.close));
            if known && fine {
                exact.push(call);
            }
        }
        let bound = bound(&generated, &run);
        let size = run.sizes(steps).into_iter().fold(0.0, f64::max);
        for (i, error) in answers.errors(&run, exact.into_iter()).into_iter().enumerate() {
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
        "{refused} of {} refused; the bound is below a millionth of the state for {tight}; largest error / bound {:.1e}; \
         {} calls coasted",
        plants(),
        worst.get(),
        coasted.get()
    );
    assert!(5 * (plants() - refused) >= 3 * plants(), "{refused} of {} refused", plants());
    assert!(2 * tight >= plants() - refused, "the bound says nothing for most plants");
    assert!(coasted.get() > 0, "nothing was lost for long");
}

/// The camera enters nothing nonlinear: its losses leave the status alone. The wheel does: for as long as the window
/// holds what stood in for one of its samples, the observer coasts, and the estimate stays near the state.
#[test]
fn a_sample_that_no_nonlinear_term_needs_is_not_missed() {
    let generated = designed(&corpus("lossy_position"));
    let steps = generated.design.valid_from_step;
    let run = truth("lossy_position").unwrap().run(generated.plant.sample_time_s(), 1, 4 * steps, 11);
    let clean = run.through(&generated);
    let of = |answers: &plant::Answers| answers.errors(&run, steps..4 * steps);
    let mut without_camera = run.clone();
    for call in [steps + 3, steps + 4, steps + 9, 2 * steps] {
        without_camera.measurements[call][0] = f64::NAN;
    }
    let answers = without_camera.through(&generated);
    assert!(answers.statuses[steps..].iter().all(|status| *status == Status::Converged));
    // The straight lines between samples are of second order: what is lost changes the weights, not the order.
    let (lossy, full) = (of(&answers), of(&clean));
    assert!(lossy.iter().zip(&full).all(|(lossy, full)| *lossy <= 2.0 * full), "{lossy:?} {full:?}");
    let mut without_wheel = run.clone();
    without_wheel.measurements[2 * steps][1] = f64::NAN;
    let answers = without_wheel.through(&generated);
    for (call, status) in answers.statuses.iter().enumerate().skip(steps) {
        let coasts = (2 * steps..=3 * steps).contains(&call);
        assert_eq!(*status, if coasts { Status::Coasting } else { Status::Converged }, "call {call}");
    }
    let lossy = of(&answers);
    assert!(lossy.iter().zip(&full).all(|(lossy, full)| *lossy <= 2.0 * full), "{lossy:?} {full:?}");
}

/// Samples missing while the window fills do not make it start again, as they do where predictions stand in.
#[test]
fn the_promised_call_is_kept_when_samples_are_missing_before_it() {
    let generated = designed(&corpus("lossy_encoder"));
    let steps = generated.design.valid_from_step;
    let mut run = Run::default();
    for call in 0..2 * steps {
        let t = call as f64 * 1e-3;
        run.states.push(vec![1.0 + 2.0 * t - 3.0 * t * t, 2.0 - 6.0 * t, -6.0]);
        run.measurements.push(vec![if call % 7 == 3 || call < 5 { f64::NAN } else { run.states[call][0] }]);
        run.inputs.push(Vec::new());
    }
    let answers = run.through(&generated);
    for (call, status) in answers.statuses.iter().enumerate() {
        assert_eq!(*status, if call < steps { Status::Converging } else { Status::Converged }, "call {call}");
    }
    let errors = answers.errors(&run, steps..2 * steps);
    let bound = bound(&generated, &run);
    assert!(errors.iter().all(|error| *error < bound), "{errors:?} above {bound:e}");
}

/// An arm that turns many times within the window: folded samples give the estimate of unfolded ones, but for whole
/// turns; a sample beyond the gate is left out, and a jump is followed after as many as the limit says.
#[test]
fn folded_samples_give_what_unfolded_ones_give() {
    let folded = corpus("lossy_encoder").replace("value = 'q'", "value = 'q', wrap = '2*pi'");
    let (folded, plain) = (designed(&folded), designed(&corpus("lossy_encoder")));
    let (tau, steps) = (std::f64::consts::TAU, plain.design.valid_from_step);
    let mut random = Random::new(5);
    let (mut wide, mut run) = (Run::default(), Run::default());
    for call in 0..4 * steps {
        let t = call as f64 * 1e-3;
        // Up to 700 rad/s: ten turns in the window, a tenth of a turn a sample.
        let y = 3000.0 + 40.0 * (15.0 * t).sin() + if random.below(10) == 0 { f64::NAN } else { 0.0 };
        wide.measurements.push(vec![y]);
        run.measurements.push(vec![y - tau * (y / tau).round()]);
        wide.inputs.push(Vec::new());
        run.inputs.push(Vec::new());
    }
    let (one, other) = (run.through(&folded), wide.through(&plain));
    assert_eq!(one.statuses, other.statuses);
    for call in steps..4 * steps {
        let (a, b) = (&one.estimates[call], &other.estimates[call]);
        let turns = (b[0] - a[0]) / tau;
        // Folding 3000 rad leaves 1e-12 of the samples; weights raise that as they raise noise.
        assert!((turns - turns.round()).abs() < 1e-11, "call {call}: {turns}");
        for (i, scale) in [(1, 1e-9), (2, 1e-8)] {
            assert!((a[i] - b[i]).abs() < scale, "call {call}: {a:?} {b:?}");
        }
    }
}

/// Equal samples give exactly 0 for every derivative, wherever they stand, folded or with samples missing.
#[test]
fn at_standstill_every_derivative_is_zero() {
    let text = corpus("lossy_encoder").replace("value = 'q'", "value = 'q', wrap = '2*pi'");
    for scalar in [Scalar::F32, Scalar::F64] {
        let generated = plant::designed_in(&text, scalar);
        let steps = generated.design.valid_from_step;
        let mut run = Run::default();
        for call in 0..3 * steps {
            run.measurements.push(vec![if call % 5 == 2 { f64::NAN } else { f64::from(2.7_f32) }]);
            run.inputs.push(Vec::new());
        }
        for estimate in &run.through(&generated).estimates[steps..] {
            assert_eq!(estimate[..3], [f64::from(2.7_f32), 0.0, 0.0]);
        }
    }
}

#[test]
fn a_sample_beyond_the_gate_is_left_out_until_there_are_too_many() {
    let generated = designed(&corpus("lossy_arm"));
    let steps = generated.design.valid_from_step;
    let run = truth("lossy_arm").unwrap().run(generated.plant.sample_time_s(), 1, 7 * steps, 3);
    let mut lost = run.clone();
    let mut far = run.clone();
    for call in (steps + 5..3 * steps).step_by(7) {
        lost.measurements[call][0] = f64::NAN;
        far.measurements[call][0] += if call % 2 == 0 { 0.5 } else { -0.5 };
    }
    let (lost, answers) = (lost.through(&generated), far.through(&generated));
    assert_eq!(lost.statuses, answers.statuses);
    assert_eq!(lost.estimates, answers.estimates);
    // From call 4N on the arm is a third of a turn further, for good: the Nth such sample is believed and begins a window.
    for row in &mut far.measurements[4 * steps..] {
        row[0] += 2.0;
    }
    let answers = far.through(&generated);
    let status = |call: usize| answers.statuses[call];
    assert_eq!(status(4 * steps - 1), Status::Converged);
    assert_eq!(status(5 * steps - 2), Status::Coasting);
    assert_eq!(status(5 * steps - 1), Status::Converging);
    assert_eq!(status(6 * steps - 2), Status::Converging);
    assert!(answers.statuses[6 * steps - 1..].iter().all(|status| *status == Status::Converged));
}

/// The last field of the estimate: calls since a sample was accepted, of whichever output.
#[test]
fn the_estimate_says_how_old_the_newest_sample_is() {
    let generated = designed(&corpus("lossy_position"));
    let mut interpreter = Interpreter::new(&generated.program);
    let there = [true, false, false, true, true, false];
    let mut since = 0.0;
    for (call, there) in there.iter().cycle().take(100).enumerate() {
        let y = if *there { 0.1 } else { f64::NAN };
        let mut estimate = vec![0.0; generated.program.estimates.len()];
        // One output is as good as the other.
        let samples = if call % 2 == 0 { [y, f64::NAN] } else { [f64::NAN, y] };
        let _ = interpreter.step(&samples, &[0.0], &mut estimate);
        since = if *there { 0.0 } else { since + 1.0 };
        assert_eq!(*estimate.last().expect("a field"), since, "call {call}");
    }
}
