//! Claim: for linear plants whose measurements come at irregular times, the estimate equals the state from the
//! promised step on, to rounding, whatever the times, as long as gaps stay within what was declared; when nothing
//! comes any more the model goes on and the status says so.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{linear, plant};

use std::cell::Cell;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::internals::estimator::window::irregular::Irregular;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::promise::Convergence;
use deadbeat_codegen::{Generated, Generator, Settings};
use linear::{Linear, Shape};
use plant::{Random, Run, UNIT, corpus, designed, functional};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Plants that are tried.
const PLANTS: u32 = 260;

fn solve(generated: &Generated) -> &Irregular {
    functional(generated).irregular.as_ref().expect("a solve in the step")
}

/// Samples left out such that no two that are there are more than `most` calls apart.
fn thin(run: &mut Run, most: usize, random: &mut Random) {
    let mut next = random.below(most);
    for (call, row) in run.measurements.iter_mut().enumerate() {
        if call == next {
            next += 1 + random.below(most);
        } else {
            row.fill(f64::NAN);
        }
    }
}

/// The most by which rounding can move the estimate.
///
/// The sums over the rows, in the step, and the run's own simulation, whose error of some units per sample the observer
/// sees as noise, reach a state as often as `Irregular::amplification` says for regular gaps. Irregular ones whose
/// pivots are above the threshold, a 64th of the regular ones', cost more: sixteen times is allowed, and the largest
/// error of these plants is 0.4 of that. What moves the state by itself counts with it.
fn bound(generated: &Generated, run: &Run) -> f64 {
    let sizes = run.sizes(0).into_iter().fold(0.0, f64::max);
    let inputs = run.inputs.iter().flatten().fold(0.0_f64, |largest, u| largest.max(u.abs()));
    let irregular = solve(generated);
    let moved = irregular.largest_gain().min(1e3) * inputs;
    16.0 * UNIT * irregular.amplification().max(1.0) * (sizes + inputs + moved)
}

#[test]
fn every_linear_plant_is_estimated_exactly_from_the_samples_that_are_there() {
    let (refused, tight, worst, count) = (Cell::new(0), Cell::new(0), Cell::new(0.0_f64), Cell::new((0, 0)));
    let config = Config { cases: PLANTS, failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (
        2_usize..=5,
        1_usize..=3,
        0_usize..=2,
        (proptest::bool::ANY, proptest::bool::ANY),
        0_usize..=12,
        0_u64..1 << 40,
    );
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape: Shape| {
        let (mut linear, mut random) = Linear::new(shape);
        let most = 2 + random.below(3);
        linear.delays = vec![0; linear.delays.len()];
        linear.steps = most * (linear.a.nrows() + 2) + shape.4;
        let gaps = format!("intermittent = {{ min = {}, max = {} }}", linear.h, most as f64 * linear.h);
        let text = linear.text(&format!("[observer.single-delay]\n{gaps}"));
        let generated = match Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design()
        {
            Ok(generated) => generated,
            Err(report) => {
                let expected = [codes::UNOBSERVABLE, codes::METHOD_CANNOT, codes::WINDOW_TOO_SHORT];
                let known = report.diagnostics.iter().all(|d| expected.contains(&d.code));
                refused.set(refused.get() + 1);
                return if known { Ok(()) } else { Err(TestCaseError::fail(report.render(false))) };
            }
        };
        let design = &generated.design;
        if (design.valid_from_step, design.convergence) != (linear.steps, Convergence::Finite) {
            return Err(TestCaseError::fail("the promised step is not the window's length"));
        }
        let calls = 3 * linear.steps + 10;
        let (mut run, _) = linear.run(calls, shape.5);
        thin(&mut run, most, &mut random);
        let answers = run.through(&generated);
        // Some times within the gaps cost more than the bound that the status keeps.
        let early = |call: usize| (answers.statuses[call] == Status::Converging) == (call < linear.steps);
        if let Some(call) = (0..calls).find(|call| !early(*call)) {
            return Err(TestCaseError::fail(format!("call {call}: {:?}\n{text}", answers.statuses[call])));
        }
        for status in &answers.statuses[linear.steps..] {
            count.set((count.get().0 + u32::from(*status == Status::Coasting), count.get().1 + 1));
        }
        let bound = bound(&generated, &run);
        let size = run.sizes(linear.steps).into_iter().fold(0.0, f64::max);
        for (i, error) in answers.errors(&run, linear.steps..calls).into_iter().enumerate() {
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
    let (coasted, all) = count.get();
    println!("{coasted} of {all} calls beyond the bound");
    assert!(20 * coasted < all, "{coasted} of {all} calls are beyond the bound");
    println!(
        "{refused} of {PLANTS} refused; the bound is below a millionth of the state for {tight}; largest error / bound {:.1e}",
        worst.get()
    );
    assert!(PLANTS - refused >= 200, "{refused} of {PLANTS} refused");
    assert!(2 * tight >= PLANTS - refused, "the bound says nothing for most plants");
}

/// The printed smallest deadline is kept at the sparsest regular pattern, and gaps beyond it make it coast: exactly,
/// where nothing disturbs the plant.
#[test]
fn without_samples_the_model_goes_on() {
    let generated = designed(&corpus("drive_irregular"));
    let from = generated.design.valid_from_step;
    let irregular = solve(&generated);
    let mut run = Run::default();
    // At rest at 0.5 rad with no voltage: the state stays.
    for call in 0..8 * from {
        let silent = (4 * from..6 * from).contains(&call);
        let there = call % 10 == 3 && !silent;
        run.measurements.push(vec![if there { 0.5 } else { f64::NAN }]);
        run.inputs.push(vec![0.0]);
        run.states.push(vec![0.5, 0.0, 0.0]);
    }
    let answers = run.through(&generated);
    let whole = (from..4 * from).chain(7 * from + 10..8 * from);
    let error = answers.errors(&run, whole).into_iter().fold(0.0, f64::max);
    println!("error {error:e}");
    assert!(error <= 64.0 * UNIT * irregular.amplification(), "{error:e}");
    // While the window runs dry and fills again, what is left of it is solved up to a condition of 1e12: rounding is then
    // a ten-thousandth of the bound that the status keeps at most.
    let bounds = &generated.design.certificate.error_bound_with_losses;
    for (error, bound) in answers.errors(&run, 4 * from..7 * from + 10).into_iter().zip(bounds) {
        let bound = bound.expect("noise and disturbance are declared");
        assert!(error <= 1e-4 * bound, "{error:e} of {bound:e}");
    }
    for (call, status) in answers.statuses.iter().enumerate() {
        let expected = match call {
            _ if call < from => Some(Status::Converging),
            // Within the declared gap, and until the one beyond it has left the window.
            _ if (4 * from..4 * from + 10).contains(&call) || (6 * from..7 * from + 10).contains(&call) => None,
            _ if (4 * from + 10..6 * from).contains(&call) => Some(Status::Coasting),
            _ => Some(Status::Converged),
        };
        assert!(expected.is_none_or(|expected| *status == expected), "call {call}: {status:?}");
    }
}
