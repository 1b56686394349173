//! Claim: a missing or bad sample never enters the estimate. Before convergence it starts the window
//! again; after it, the model's prediction stands in for it, exactly for linear plants and to second
//! order for others, and the status is Coasting for just as long as the window holds a prediction.
//! Bad inputs cost what their replacement differs by, and nothing makes the observer fail for good.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{plant, truths};

use deadbeat_codegen::Generated;
use deadbeat_codegen::internals::estimator::window::Functional;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::promise::Convergence;
use plant::{
    Answers, Hold, Random, Run, Truth, UNIT, at_sample_time, corpus, delays, designed, designed_in, edited, functional,
    integration_rounding, matrix, rounding,
};
use truths::{corrects, inverted_cart, is_baseline, late_position, names, names_of, truth};

use Status::{Coasting, Converged, Converging};

/// A run in which some samples of some outputs are missing.
fn without(run: &Run, missing: impl Fn(usize, usize) -> bool) -> Run {
    let mut run = run.clone();
    for (call, sample) in run.measurements.iter_mut().enumerate() {
        sample.iter_mut().enumerate().filter(|(o, _)| missing(call, *o)).for_each(|(_, y)| *y = f64::NAN);
    }
    run
}

/// The status of every call is what `expected` says.
fn assert_statuses(what: &str, answers: &Answers, expected: impl Fn(usize) -> Status) {
    for (call, status) in answers.statuses.iter().enumerate() {
        assert_eq!(*status, expected(call), "{what}, call {call}");
    }
}

/// Whether samples may be missing by declaration: `tests/suite/sensors/irregular.rs` has those.
fn takes_gaps(generated: &Generated) -> bool {
    generated.design.estimator.downcast_ref::<Functional>().is_some_and(|functional| functional.irregular.is_some())
}

/// Every plant and output: a sample that is missing before convergence starts the window again, and N+1
/// good samples later the estimate has converged.
#[test]
fn a_missing_sample_starts_the_window_again() {
    for name in names() {
        let truth = truth(&name).unwrap();
        let generated = designed(&corpus(&name));
        // Where not every call is measured, a sample between measurements is not missed. Correctors have no window:
        // `tests/suite/sensors/corrector_missing.rs`.
        if generated.design.convergence != Convergence::Finite
            || takes_gaps(&generated)
            || corrects(&name)
            || is_baseline(&name)
        {
            continue;
        }
        let steps = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 2 * steps + 4, 3);
        for output in 0..truth.delays.len() {
            for at in [0, 1, steps / 2, steps - 1, steps] {
                let answers = without(&run, |call, o| call == at && o == output).through(&generated);
                let what = format!("{name}, output {output} missing at call {at}");
                assert_statuses(&what, &answers, |call| if call <= at + steps { Converging } else { Converged });
            }
        }
    }
}

/// Every plant and output: the window holds a prediction for N+1 calls, for N+1-d when it arrives d late.
#[test]
fn coasting_lasts_while_the_window_holds_a_prediction() {
    for name in names_of("window") {
        let truth = truth(&name).unwrap();
        let generated = designed(&corpus(&name));
        // Copies that take turns hold a sample for longer, by when it came: tests/suite/methods/realizations.rs. Nothing stands in for
        // samples that are left out: tests/suite/sensors/left_out.rs.
        if generated.design.realization == "ping-pong" || takes_gaps(&generated) {
            continue;
        }
        let steps = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 3 * steps + 20, 4);
        for output in 0..truth.delays.len() {
            let delay = delays(&generated)[output];
            let (first, last) = (steps + 10, steps + 12);
            let answers = without(&run, |call, o| (call == first || call == last) && o == output).through(&generated);
            assert_statuses(&format!("{name}, output {output}"), &answers, |call| match call {
                call if call < steps => Converging,
                call if (first..=last + steps - delay).contains(&call) => Coasting,
                _ => Converged,
            });
        }
    }
}

/// A linear plant, and a specification that says the same.
struct Linear {
    name: &'static str,
    truth: Truth,
    text: String,
}

fn linear_plants() -> Vec<Linear> {
    let cart = edited(&corpus("inverted_cart"), " + 0.3*sin(2*pi*1.5*t)", "");
    let late = edited(&corpus("late_position"), " - 0.4*tanh(20*wheel)", "");
    let exact = |name: &'static str| Linear { name, truth: truth(name).unwrap(), text: corpus(name) };
    vec![
        exact("mass_chain"),
        exact("thermal_stack"),
        Linear { name: "inverted_cart", truth: inverted_cart(0.0), text: cart },
        Linear { name: "late_position", truth: late_position(0.0), text: late },
    ]
}

/// The largest entry that the powers of Phi reach over some calls: how much a rounding error grows.
fn growth(generated: &Generated, calls: usize) -> f64 {
    let phi = matrix(generated, "Phi");
    let n = phi.len();
    let phi = nalgebra::DMatrix::from_fn(n, n, |i, j| phi[i][j]);
    let mut power = nalgebra::DMatrix::identity(n, n);
    let mut largest = 1.0_f64;
    for _ in 0..calls {
        power = &power * &phi;
        largest = largest.max(power.abs().max());
    }
    largest
}

/// What rounding may do to a run with predictions: to a full window's share each prediction adds its
/// own, at most as often as there are predictions, and the plant carries all of it on.
fn prediction_rounding(generated: &Generated, truth: &Truth, run: &Run, predictions: usize) -> Vec<f64> {
    let step: Vec<f64> = if truth.discrete {
        run.sizes(0).iter().map(|x| 4.0 * x).collect()
    } else {
        integration_rounding(generated, run)
    };
    let factor = (1 + predictions) as f64 * growth(generated, predictions);
    rounding(generated, run, &step, &[]).iter().map(|bound| factor * bound).collect()
}

/// Linear plants, stable and unstable: single misses, bursts, one sensor alone, and three windows of
/// nothing leave the estimate at the true state; only the calls without prediction are Converging.
#[test]
fn predictions_are_exact_for_linear_plants() {
    type Pattern = (&'static str, fn(usize, usize, usize) -> bool);
    let patterns: [Pattern; 6] = [
        ("one call", |k, _, n| k == n + 8),
        ("the first call after convergence", |k, _, n| k == n + 1),
        ("a burst", |k, _, n| (n + 9..n + 16).contains(&k)),
        ("every fifth call", |k, _, n| k > n + 8 && k % 5 == 0),
        ("the first output for half a window", |k, o, n| o == 0 && (n + 8..n + 8 + n / 2).contains(&k)),
        ("three windows of nothing", |k, _, n| (n + 8..4 * n + 8).contains(&k)),
    ];
    for Linear { name, truth, text } in linear_plants() {
        let generated = designed(&text);
        let n = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 6 * n, 5);
        for (what, missing) in &patterns {
            let answers = without(&run, |call, o| missing(call, o, n)).through(&generated);
            let predictions = (0..6 * n).filter(|k| (0..truth.delays.len()).any(|o| missing(*k, o, n))).count();
            let bounds = prediction_rounding(&generated, &truth, &run, predictions);
            let errors = answers.errors(&run, (n..6 * n).filter(|k| answers.statuses[*k] != Converging));
            let worst = errors.iter().zip(&bounds).map(|(e, b)| e / b).fold(0.0, f64::max);
            let relative = errors.iter().zip(run.sizes(n)).map(|(e, x)| e / x).fold(0.0, f64::max);
            println!("{name}, {what}: {relative:.1e} of the states, {worst:.1e} of the bound");
            assert!(worst <= 1.0, "{name}, {what}: {errors:?}, bounds {bounds:?}");
            assert_ne!(*answers.statuses.last().unwrap(), Converging, "{name}, {what}");
        }
    }
}

/// A late sample is predicted from the estimate of the time that it shows. While that estimate had not
/// converged there is no prediction: the window starts again, and never uses what is not there.
#[test]
fn a_late_sample_has_a_prediction_once_the_estimate_it_needs_had_converged() {
    let text = edited(&corpus("late_position"), " - 0.4*tanh(20*wheel)", "");
    let (generated, truth) = (designed(&text), late_position(0.0));
    let (n, delay) = (generated.design.valid_from_step, functional(&generated).delays[0]);
    assert_eq!(delay, 4);
    let run = truth.run(generated.plant.sample_time_s(), 1, 3 * n, 6);
    for at in n + 1..n + 8 {
        let answers = without(&run, |call, o| call == at && o == 0).through(&generated);
        let predicted = at >= n + delay;
        assert_statuses(&format!("late sample missing at call {at}"), &answers, |call| match call {
            call if call < n => Converging,
            call if call < at => Converged,
            call if predicted && call <= at + n - delay => Coasting,
            call if !predicted && call <= at + n => Converging,
            _ => Converged,
        });
        let bounds = prediction_rounding(&generated, &truth, &run, 1);
        let errors = answers.errors(&run, (n..3 * n).filter(|k| answers.statuses[*k] != Converging));
        assert!(errors.iter().zip(&bounds).all(|(e, b)| e <= b), "missing at call {at}: {errors:?}, bounds {bounds:?}");
    }
}

/// Nonlinear plants: the error through a tenth of a window of nothing is of second order in the sample time.
#[test]
fn predictions_are_of_second_order_for_nonlinear_plants() {
    for name in ["dc_motor", "pendulum", "magnetic_levitation", "two_mass_drive"] {
        let (text, truth) = (corpus(name), truth(name).unwrap());
        let coarse = designed(&text);
        let (h, n) = (coarse.plant.sample_time_s(), coarse.design.valid_from_step);
        let mut errors = Vec::new();
        for refine in [1, 2, 4] {
            let generated = designed(&at_sample_time(&text, h / refine as f64));
            let run = truth.run(h / refine as f64, refine, 3 * n * refine, 7);
            let lost = (n + n / 4) * refine..(n + n / 4 + n / 10) * refine;
            let answers = without(&run, |call, _| lost.contains(&call)).through(&generated);
            assert_eq!(answers.statuses[lost.start], Coasting);
            errors.push(answers.errors(&run, (n..3 * n).map(|k| k * refine)));
        }
        for (i, state) in coarse.plant.states.iter().enumerate() {
            let orders = [(errors[0][i] / errors[1][i]).log2(), (errors[1][i] / errors[2][i]).log2()];
            println!(
                "{name} {}: {:.1e}, {:.1e}, {:.1e}, orders {:.2}, {:.2}",
                state.label.name, errors[0][i], errors[1][i], errors[2][i], orders[0], orders[1]
            );
            // As without misses: the next term is of order h^3 to h^4.
            assert!(orders.iter().all(|order| (1.8..2.3).contains(order)), "{name} {}: {orders:?}", state.label.name);
        }
    }
}

/// NaN, both infinities and both sides of the range are the same as nothing at all, bit for bit.
#[test]
fn bad_samples_are_missing_samples() {
    for (name, below, above) in
        [("thermal_stack", -50.5, 200.5), ("magnetic_levitation", 0.9e-3, 0.031), ("pendulum", -1e308, 1e308)]
    {
        let generated = designed(&corpus(name));
        let n = generated.design.valid_from_step;
        let run = truth(name).unwrap().run(generated.plant.sample_time_s(), 1, 3 * n, 8);
        for at in [n / 2, n + 5] {
            let missing = without(&run, |call, _| call == at).through(&generated);
            for bad in [f64::INFINITY, f64::NEG_INFINITY, below, above, -f64::NAN] {
                let mut other = run.clone();
                other.measurements[at][0] = bad;
                let other = other.through(&generated);
                assert_eq!(missing.statuses, other.statuses, "{name}, {bad} at call {at}");
                let bits =
                    |answers: &Answers| answers.estimates.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
                assert_eq!(bits(&missing), bits(&other), "{name}, {bad} at call {at}");
            }
        }
    }
}

/// A bad input is taken as the last good one. The status is Coasting while the window holds it, N calls
/// for an input that is held and N+1 for one that runs, and the error is its weight times the difference.
#[test]
fn a_bad_input_costs_what_its_replacement_differs_by() {
    let first = edited(&corpus("two_mass_drive"), " - eccentricity*sin(load_angle)", "");
    let mut drive = truth("two_mass_drive").unwrap();
    drive.change = Box::new(|_, x, u| {
        let shaft = 400.0 * (x[0] - x[1]) + 0.2 * (x[2] - x[3]);
        vec![x[2], x[3], (u[0] - shaft) / 0.01, shaft / 0.05]
    });
    let mut plants = linear_plants();
    plants.push(Linear { name: "two_mass_drive", truth: drive, text: first });
    for Linear { name, truth, text } in plants {
        let generated = designed(&text);
        let n = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 3 * n, 9);
        let (at, fir) = (n + n / 2, functional(&generated));
        for input in 0..truth.holds.len() {
            for bad in [f64::NAN, f64::INFINITY] {
                let mut spoilt = run.clone();
                spoilt.inputs[at][input] = bad;
                let answers = spoilt.through(&generated);
                let stays = if truth.holds[input] == Hold::Zero { n } else { n + 1 };
                assert_statuses(name, &answers, |call| match call {
                    call if call < n => Converging,
                    call if (at..at + stays).contains(&call) => Coasting,
                    _ => Converged,
                });
                let difference = run.inputs[at - 1][input] - run.inputs[at][input];
                let bounds = prediction_rounding(&generated, &truth, &run, 0);
                for call in n..3 * n {
                    let weight = |i: usize| call.checked_sub(at).map_or(0.0, |age| fir.knowns[input].at(i, age).double);
                    for (i, bound) in bounds.iter().enumerate() {
                        let error = answers.estimates[call][i] - run.states[call][i];
                        let explained = weight(i) * difference;
                        assert!(
                            (error - explained).abs() <= *bound,
                            "{name}, call {call}, state {i}: {error:e}, explained {explained:e}"
                        );
                    }
                }
            }
        }
    }
}

/// The first call's held inputs are ignored even when they are no numbers.
#[test]
fn the_first_call_has_no_interval_before_it() {
    for Linear { name, truth, text } in linear_plants() {
        let generated = designed(&text);
        let n = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 2 * n, 10);
        let mut spoilt = run.clone();
        spoilt.inputs[0].fill(f64::NAN);
        let answers = spoilt.through(&generated);
        assert_statuses(name, &answers, |call| if call < n { Converging } else { Converged });
        let (errors, bounds) = (answers.errors(&run, n..2 * n), prediction_rounding(&generated, &truth, &run, 0));
        assert!(errors.iter().zip(&bounds).all(|(e, b)| e <= b), "{name}: {errors:?}");
    }
}

/// A prediction that leaves the declared range is no prediction: the window starts again, and N+1 good
/// samples later the estimate is right.
#[test]
fn a_prediction_that_leaves_the_range_starts_the_window_again() {
    let text = edited(&corpus("inverted_cart"), " + 0.3*sin(2*pi*1.5*t)", "");
    let text = edited(&text, "value = 'angle',", "value = 'angle', range = [-0.5, 0.5],");
    let (generated, truth) = (designed(&text), inverted_cart(0.0));
    let n = generated.design.valid_from_step;
    let run = truth.run(generated.plant.sample_time_s(), 1, 2 * n, 11);
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = [0.0; 4];
    let mut status = Converging;
    for (y, u) in run.measurements.iter().zip(&run.inputs) {
        status = interpreter.step(y, u, &mut estimate);
    }
    assert_eq!(status, Converged);
    let mut coasted = 0;
    while status != Converging {
        status = interpreter.step(&[f64::NAN; 2], &[1.0], &mut estimate);
        assert!(estimate[1].abs() <= 0.5, "the estimate followed a prediction out of the range");
        coasted += 1;
        assert!(coasted < 2_000, "an unstable angle with a constant force leaves every range");
    }
    for (call, (y, u)) in run.measurements.iter().zip(&run.inputs).enumerate() {
        status = interpreter.step(y, u, &mut estimate);
        assert_eq!(status, if call < n { Converging } else { Converged }, "{call} calls after the sensor's return");
        if status == Converged {
            let errors: Vec<f64> = estimate.iter().zip(&run.states[call]).map(|(a, b)| (a - b).abs()).collect();
            let bounds = prediction_rounding(&generated, &truth, &run, 0);
            assert!(errors.iter().zip(&bounds).all(|(e, b)| e <= b), "{errors:?}, bounds {bounds:?}");
        }
    }
}

/// An unstable plant whose sensors are gone for ever: nothing becomes infinite or no number, whatever
/// arrives instead, and the estimate is right again N+1 samples after they return.
#[test]
fn an_unstable_plant_survives_the_loss_of_its_sensors() {
    let text = edited(&corpus("inverted_cart"), " + 0.3*sin(2*pi*1.5*t)", "");
    for scalar in [Scalar::F32, Scalar::F64] {
        let (generated, truth) = (designed_in(&text, scalar), inverted_cart(0.0));
        let n = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 2 * n, 12);
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = [0.0; 4];
        let mut random = Random::new(13);
        for (y, u) in run.measurements.iter().zip(&run.inputs) {
            interpreter.step(y, u, &mut estimate);
        }
        let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        let mut statuses = Vec::new();
        for call in 0..100_000 {
            let y = [bad[random.below(3)], bad[random.below(3)]];
            let u = if call % 7 == 0 { bad[random.below(3)] } else { random.within(-1.0, 1.0) };
            statuses.push(interpreter.step(&y, &[u], &mut estimate));
            assert!(estimate.iter().all(|x| x.is_finite()), "{scalar}, call {call}: {estimate:?}");
        }
        assert!(interpreter.cells().iter().flat_map(|(_, cell)| cell).all(|x| x.is_finite()));
        assert_eq!(statuses.last(), Some(&Converging), "{scalar}: the prediction has left every bound");
        assert_eq!(statuses.first(), Some(&Coasting));
        println!("{scalar}: coasted for {} calls", statuses.iter().position(|s| *s == Converging).unwrap());
        // In single precision a sum over the window is rounded (N + 6) times with 2^29 u.
        let unit = if scalar == Scalar::F32 { 2.0_f64.powi(29) } else { 1.0 };
        let bounds: Vec<f64> = prediction_rounding(&generated, &truth, &run, 0).iter().map(|b| unit * b).collect();
        for (call, (y, u)) in run.measurements.iter().zip(&run.inputs).enumerate() {
            let status = interpreter.step(y, u, &mut estimate);
            assert_eq!(
                status,
                if call < n { Converging } else { Converged },
                "{scalar}, {call} calls after the return"
            );
            let errors: Vec<f64> = estimate.iter().zip(&run.states[call]).map(|(a, b)| (a - b).abs()).collect();
            assert!(
                status == Converging || errors.iter().zip(&bounds).all(|(e, b)| e <= b),
                "{scalar}: {errors:?}, bounds {bounds:?}"
            );
        }
    }
}

/// The tests above would pass for a bound of any size: it is small against the states.
#[test]
fn the_rounding_bounds_are_small() {
    for Linear { name, truth, text } in linear_plants() {
        let generated = designed(&text);
        let n = generated.design.valid_from_step;
        let run = truth.run(generated.plant.sample_time_s(), 1, 6 * n, 5);
        let bounds = prediction_rounding(&generated, &truth, &run, 0);
        for (bound, size) in bounds.iter().zip(run.sizes(n)) {
            assert!(*bound < 1e6 * UNIT * size.max(1e-3), "{name}: {bound:e} of {size:e}");
        }
    }
}

/// One of two sensors is gone for ever. Its predictions would feed on themselves (here with a factor of 1.029
/// a call, on a stable plant), so after a window of them the observer starts again instead of going on; and
/// it is right again N+1 samples after the sensor returns.
#[test]
fn one_sensor_of_two_is_not_predicted_for_ever() {
    let text = "deadbeat = 1\nname = 'pair'\n[plant]\nA = [[1, 2], [-2, -3]]\nC = [[-1, 1], [0, -1]]\n\
                [observer.window]\nwindow = 0.5\nmissing = 'predicted'\n[target]\nsample_time = 0.1\nscalar = 'f64'\n";
    let generated = designed(text);
    let window = generated.design.valid_from_step + 1;
    let (gone, back, calls) = (21, 1_500, 1_600);
    let mut random = Random::new(7);
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = [0.0; 2];
    for call in 0..calls {
        // The plant is at rest; both sensors have noise of 1e-3.
        let mut samples = [random.within(-1e-3, 1e-3), random.within(-1e-3, 1e-3)];
        if (gone..back).contains(&call) {
            samples[0] = f64::NAN;
        }
        let status = interpreter.step(&samples, &[], &mut estimate);
        let expected = match call {
            _ if call + 1 < window => Converging,
            _ if call < gone => Converged,
            _ if call < gone + window => Coasting,
            _ if call < back + window - 1 => Converging,
            _ => Converged,
        };
        assert_eq!(status, expected, "call {call}");
        // Six predictions let an error of the window's noise gain grow by 1.029^6 at most.
        assert!(estimate.iter().all(|x| x.abs() < 0.1), "call {call}: {estimate:?}");
    }
}
