//! Claim (000 Theorem 1, sampled): whatever the linear plant, its initial state, its inputs and k, the estimate of
//! `[observer.single-delay]` equals the state from the promised step on, to rounding. Plants are refused only where
//! their outputs do not show the state, repeat each other or show all of it, or where `Phi_rr` is singular.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::depth::trials;
use crate::support::{linear, plant};

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use linear::{Linear, Shape};
use nalgebra::DMatrix;
use plant::{Random, rounding};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Plants that are tried; the outputs of some show all of the state, or repeat each other.
fn plants() -> (u32, u32) {
    trials((81, 60), (270, 200))
}

/// A plant without delays, sometimes with declared noise, and the observer's keys.
fn drawn(shape: Shape) -> (Linear, String) {
    let (mut linear, mut random) = Linear::new(shape);
    let (n, p) = (linear.a.nrows(), linear.delays.len());
    linear.delays = vec![0; p];
    linear.steps = n + shape.4;
    if random.below(3) == 0 {
        linear.noise = (0..p).map(|_| [0.01, 0.5, 3.0][random.below(3)]).collect();
    }
    let keys = match random.below(4) {
        0 => "k = 'auto'".to_owned(),
        _ => format!("k = {:.3}", k(&mut random, linear.steps as f64 * linear.h)),
    };
    (linear, format!("[observer.single-delay]\n{keys}"))
}

/// Weights that fall by up to e^8 over the window, or rise by up to e^3.
fn k(random: &mut Random, window_s: f64) -> f64 {
    random.within(-3.0, 8.0) / window_s
}

/// Why a plant may be refused: what the message begins with, and what must then be true of it.
fn refusal_is_right(message: &str, linear: &Linear) -> Option<&'static str> {
    let (n, p) = (linear.a.nrows(), linear.delays.len());
    let rank = |m: &DMatrix<f64>| m.clone().svd(false, false).rank(1e-9);
    let (repeat, all) = ("the output `", "every state is measured");
    let (forgets, unobservable) = ("the plant forgets part of its state", "the state");
    if message.starts_with(repeat) {
        (rank(&linear.c) < p).then_some(repeat)
    } else if message.starts_with(all) {
        (rank(&linear.c) == n).then_some(all)
    } else if message.starts_with(forgets) {
        // A continuous plant never does.
        linear.discrete.then_some(forgets)
    } else if message.starts_with(unobservable) {
        let phi = linear.sampled().0;
        let mut rows = linear.c.clone();
        let mut all = rows.clone();
        for _ in 1..n {
            rows = &rows * &phi;
            let larger = all.nrows() + p;
            all = all.resize_vertically(larger, 0.0);
            all.rows_mut(larger - p, p).copy_from(&rows);
        }
        (rank(&all) < n).then_some(unobservable)
    } else {
        None
    }
}

/// The design, or why the plant is refused.
fn design(linear: &Linear, text: &str) -> Result<Result<Generated, &'static str>, TestCaseError> {
    let report = match Generator::new(text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design() {
        Ok(generated) => return Ok(Ok(generated)),
        Err(report) => report,
    };
    let codes = [codes::UNOBSERVABLE, codes::METHOD_CANNOT];
    let [one] = report.diagnostics.as_slice() else { return Err(TestCaseError::fail(report.render(false))) };
    let why = codes.contains(&one.code).then(|| refusal_is_right(&one.message, linear)).flatten();
    why.map(Err).map_or_else(|| Err(TestCaseError::fail(format!("{}\n{text}", report.render(false)))), Ok)
}

#[test]
fn every_observable_linear_plant_is_estimated_exactly() {
    let (refused, digits, worst) = (RefCell::new(BTreeMap::new()), Cell::new([0; 4]), Cell::new(0.0_f64));
    let config = Config { cases: plants().0, failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (
        2_usize..=6,
        1_usize..=3,
        0_usize..=2,
        (proptest::bool::ANY, proptest::bool::ANY),
        0_usize..=12,
        0_u64..1 << 40,
    );
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape| {
        let (linear, observer) = drawn(shape);
        let text = linear.text(&observer);
        let generated = match design(&linear, &text)? {
            Ok(generated) => generated,
            Err(why) => {
                *refused.borrow_mut().entry(why).or_insert(0) += 1;
                return Ok(());
            }
        };
        let design = &generated.design;
        if (design.valid_from_step, design.window_steps) != (linear.steps, linear.steps) {
            return Err(TestCaseError::fail("the promised step is not the window's length"));
        }
        let (run, step) = linear.run(2 * linear.steps + 10, shape.5);
        let answers = run.through(&generated);
        let expected = |call| if call < linear.steps { Status::Converging } else { Status::Converged };
        if let Some(call) = (0..run.states.len()).find(|call| answers.statuses[*call] != expected(*call)) {
            return Err(TestCaseError::fail(format!("call {call}: {:?}\n{text}", answers.statuses[call])));
        }
        // The bound sums the weights themselves, so that what large ones cost is in it.
        let bounds = rounding(&generated, &run, &step, &[]);
        let errors = answers.errors(&run, linear.steps..run.states.len());
        for (i, ((error, bound), size)) in errors.iter().zip(&bounds).zip(run.sizes(linear.steps)).enumerate() {
            if error > bound {
                return Err(TestCaseError::fail(format!("state {i}: error {error:e}, bound {bound:e}\n{text}")));
            }
            let mut count = digits.get();
            let relative = bound / size.max(1e-3);
            count[[1e-12, 1e-9, 1e-6].iter().position(|limit| relative < *limit).unwrap_or(3)] += 1;
            digits.set(count);
            worst.set(worst.get().max(error / bound));
        }
        Ok(())
    });
    outcome.unwrap_or_else(|why| panic!("{why}"));
    let [a, b, c, d] = digits.get();
    println!(
        "refused: {:?}; states with a bound below 1e-12: {a}, 1e-9: {b}, 1e-6: {c}, above: {d}; largest error / bound {:.2e}",
        refused.borrow(),
        worst.get()
    );
    let (count, (plants, enough)) = (refused.borrow().values().sum::<u32>(), plants());
    assert!(plants - count >= enough, "{count} of {plants} refused: {:?}", refused.borrow());
    assert!(d * 20 <= a + b + c + d, "the bound says nothing for {d} states");
}
