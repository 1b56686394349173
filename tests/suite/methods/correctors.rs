//! Claim: every corrector of the corpus does what its header says: at the printed step its error is what the printed
//! share leaves of the initial one, to rounding; from then on it is a converged observer, with bounded noise within its
//! printed bound; and the plant's nonlinear terms cost the second order of the sample time.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{plant, truths};

use deadbeat_codegen::Generated;
use deadbeat_codegen::internals::estimator::corrector::Corrector;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::promise::Convergence;
use plant::{Answers, Random, Run, Truth, UNIT, at_sample_time, corpus, designed};
use truths::{corrects, names, names_of, truth};

/// The correctors of the corpus, in double precision, with their truths.
fn correctors() -> Vec<(String, Generated, Truth)> {
    // What is certain of a law that is not linear, and when: `tests/suite/methods/robust_exact.rs`.
    let linear = |name: &String| corrects(name) && !names_of("robust-exact").contains(name);
    let all = names().into_iter().filter(linear).map(|name| {
        let (generated, truth) = (designed(&corpus(&name)), truth(&name));
        assert!(generated.design.estimator.downcast_ref::<Corrector>().is_some(), "{name}");
        let truth = truth.unwrap_or_else(|| panic!("{name} has no truth"));
        (name, generated, truth)
    });
    all.collect()
}

/// What rounding can do: each call rounds the innovation and the state a few times over; that enters like noise and
/// like a disturbance of so many units in the last place, and the largest gains carry it.
fn rounding(generated: &Generated, run: &Run) -> Vec<f64> {
    let certificate = &generated.design.certificate;
    let (sizes, calls) = (run.sizes(0), generated.design.valid_from_step as f64);
    let sample = run.measurements.iter().flatten().fold(0.0_f64, |most, y| most.max(y.abs()));
    let noise = certificate.noise_gain_l1.iter().map(|gains| gains.iter().sum::<f64>());
    noise.zip(sizes).map(|(gain, size)| 32.0 * UNIT * (gain * sample + calls * size)).collect()
}

fn statuses(name: &str, generated: &Generated, answers: &Answers) {
    for (call, status) in answers.statuses.iter().enumerate() {
        let expected = if call < generated.design.valid_from_step { Status::Converging } else { Status::Converged };
        assert_eq!(*status, expected, "{name}, call {call}");
    }
}

/// Linear plants: the error at the printed step is the printed matrix times the initial one.
#[test]
fn what_is_left_of_an_initial_error_is_what_is_printed() {
    for (name, generated, truth) in correctors() {
        let (design, n) = (&generated.design, generated.plant.states.len());
        if !truth.exact || design.certificate.initial_gain.is_empty() {
            continue;
        }
        for seed in 0..4 {
            let valid = design.valid_from_step;
            let run = truth.run(generated.plant.sample_time_s(), 1, 2 * valid + 1, seed);
            let answers = run.through(&generated);
            statuses(&name, &generated, &answers);
            let error = |call: usize, i: usize| answers.estimates[call][i] - run.states[call][i];
            let rounding = rounding(&generated, &run);
            for (i, row) in design.certificate.initial_gain.iter().enumerate() {
                let expected: f64 = (0..n).map(|j| row[j] * error(0, j)).sum();
                // The share is in doubles too, of a product of as many matrices.
                let of_share: f64 = (0..n).map(|j| row[j].abs() * error(0, j).abs()).sum::<f64>() * 1e-9;
                let (got, slack) = (error(valid, i), rounding[i] + of_share);
                assert!((got - expected).abs() <= slack, "{name} state {i}: {got:e}, {expected:e} expected, {slack:e}");
            }
        }
    }
}

/// Noise that takes its bound at every call, with the worst signs of chance: what it adds to the estimate stays within the
/// printed bound. Where the law is linear, that is the difference to a run without noise, so that no initial error counts.
#[test]
fn noise_stays_within_the_printed_bound() {
    for (name, generated, truth) in correctors() {
        let bounds = &generated.design.certificate.error_bound;
        if !truth.exact || bounds.iter().any(Option::is_none) || bounds.is_empty() {
            continue;
        }
        let valid = generated.design.valid_from_step;
        let mut random = Random::new(7);
        let sensed = matches!(generated.design.convergence, Convergence::Sensed { .. });
        let clean = truth.run(generated.plant.sample_time_s(), 1, 3 * valid + 60, 1);
        let mut run = truth.run(generated.plant.sample_time_s(), 1, 3 * valid + 60, 1);
        for sample in &mut run.measurements {
            for (y, output) in sample.iter_mut().zip(&generated.plant.outputs) {
                let level = output.noise.as_ref().unwrap().to_f64().unwrap();
                *y += if random.below(2) == 0 { level } else { -level };
            }
        }
        let answers = run.through(&generated);
        if !sensed {
            run.states = clean.through(&generated).estimates;
        }
        let converged = (valid..run.states.len()).filter(|call| answers.statuses[*call] == Status::Converged);
        let errors = answers.errors(&run, converged);
        let rounding = rounding(&generated, &run);
        for (i, bound) in bounds.iter().enumerate() {
            let most = bound.unwrap() + rounding[i];
            println!("{name} state {i}: {:.2e} of {most:.2e}", errors[i]);
            assert!(errors[i] <= most, "{name} state {i}: {:e} above {most:e}", errors[i]);
        }
    }
}

/// Nonlinear plants: with the same steps the error falls with the second order of the sample time.
#[test]
fn nonlinear_terms_cost_the_second_order() {
    for (name, coarse, truth) in correctors() {
        if truth.exact {
            continue;
        }
        let (text, h) = (corpus(&name), coarse.plant.sample_time_s());
        let mut errors = Vec::new();
        let mut sizes = Vec::new();
        for refine in [1, 2, 4] {
            // The steps before the end stay, so that the gains at the end grow with the rate, as the errors fall.
            let generated = designed(&at_sample_time(&text, h / f64::from(refine)));
            // Half as long again as it takes: what is left of the initial error is then below what is measured.
            let valid = generated.design.valid_from_step;
            let calls = 2 * valid + 40;
            let run = truth.run(h / f64::from(refine), refine as usize, calls, 1);
            let answers = run.through(&generated);
            statuses(&name, &generated, &answers);
            errors.push(answers.errors(&run, 3 * valid / 2..calls));
            sizes = run.sizes(0);
        }
        for i in 0..sizes.len() {
            let [first, second, third] = [errors[0][i], errors[1][i], errors[2][i]];
            let orders = [(first / second).log2(), (second / third).log2()];
            println!("{name} state {i}: {first:.1e}, {second:.1e}, {third:.1e} of {:.1e}, {orders:.2?}", sizes[i]);
            if first.max(second).max(third) <= 8.0 * UNIT * sizes[i] {
                continue;
            }
            assert!(orders.iter().all(|order| *order > 1.8), "{name} state {i}: {orders:?}");
            assert!(third < 1e-3 * sizes[i], "{name} state {i}: {third:e} of {:e}", sizes[i]);
        }
    }
}
