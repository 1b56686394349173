//! Claim: whatever the linear plant, its initial state and its inputs, the estimate equals the state
//! from the promised step on, to rounding; only plants that do not show their state are refused.
//!
//! The plants are those of `support/linear.rs`, weighted equally or for the worst case.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{linear, plant};

use std::cell::Cell;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use linear::Linear;
use plant::{Answers, Run, UNIT, matrix, rounding};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Plants that are tried.
const PLANTS: u32 = 200;

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
        let (linear, mut random) = Linear::new(shape);
        let weights = if random.below(4) == 0 { "minimax" } else { "equal" };
        let text = linear.text(&format!("[observer.window]\nweights = '{weights}'"));
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
        let (linear, _) = Linear::new((1 + seed as usize % 5, 3, 1, (false, false), 2, seed));
        let Some(generated) = design(&linear.text("[observer.window]")).unwrap() else { continue };
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
