//! Claim: the certificate is true and attained. The noise that has the signs of the weights gives exactly
//! the worst-case gain, white noise the other; no bounded disturbance passes its gain and one comes
//! within 1 % of it; the error bound holds for a nonlinear plant up to the hold's error.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{plant, truths};

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use nalgebra::{DMatrix, DVector, RowDVector};
use plant::{Hold, Random, Truth, accumulated, corpus, designed, edited, functional};
use truths::truth;

/// Linear plants: one output and several, one late, both ways of weighting; without the nonlinear terms,
/// which add to the noise what K does not see.
fn linear_specs() -> Vec<(&'static str, String)> {
    let cart = edited(&corpus("inverted_cart"), " + 0.3*sin(2*pi*1.5*t)", "");
    let minimax = edited(&cart, "window = 0.1", "window = 0.1\nweights = \"minimax\"");
    vec![
        ("thermal_stack", corpus("thermal_stack")),
        ("mass_chain", corpus("mass_chain")),
        ("late_position", edited(&corpus("late_position"), " - 0.4*tanh(20*wheel)", "")),
        ("inverted_cart", cart),
        ("inverted_cart, minimax", minimax),
        ("dc_motor", edited(&corpus("dc_motor"), " - a1*sin(q)", "")),
    ]
}

/// The estimate from a window of measurements, oldest first, around a plant at rest.
fn estimate(generated: &Generated, window: &[Vec<f64>]) -> Vec<f64> {
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.plant.states.len()];
    let inputs = vec![0.0; generated.plant.inputs.len()];
    let mut status = Status::Converging;
    for measurements in window {
        status = interpreter.step(measurements, &inputs, &mut estimate);
    }
    assert_eq!(status, Status::Converged);
    estimate
}

/// `noise_gain_l1`: the sign sequence of one output's weights gives exactly that error, random noise never more.
#[test]
fn the_worst_case_noise_gain_is_attained() {
    for (name, text) in linear_specs() {
        let generated = designed(&text);
        let (steps, fir) = (generated.design.valid_from_step, functional(&generated));
        let outputs = generated.plant.outputs.len();
        let gains = &generated.design.certificate.noise_gain_l1;
        let mut random = Random::new(1);
        let mut fullest = 0.0_f64;
        for (state, gains) in gains.iter().enumerate() {
            for (output, gain) in gains.iter().enumerate() {
                let worst = (0..=steps).rev().map(|age| {
                    let sign = |o: usize| if fir.outputs[o].at(state, age).double < 0.0 { -1.0 } else { 1.0 };
                    (0..outputs).map(|o| if o == output { sign(o) } else { 0.0 }).collect()
                });
                let error = estimate(&generated, &worst.collect::<Vec<Vec<f64>>>())[state];
                // Sums of N+1 terms of one sign, in two orders: (N+1) u apart, below 2e-14 for these windows.
                assert!(
                    (error - gain).abs() <= 1e-12 * gain,
                    "{name}, state {state}, output {output}: {error}, gain {gain}"
                );
            }
        }
        for _ in 0..50 {
            let signs = random.below(2) == 0;
            let noise: Vec<Vec<f64>> = (0..=steps)
                .map(|_| {
                    (0..outputs).map(|_| random.within(-1.0, 1.0)).map(|v| if signs { v.signum() } else { v }).collect()
                })
                .collect();
            for (error, gains) in estimate(&generated, &noise).iter().zip(gains) {
                let all: f64 = gains.iter().sum();
                assert!(error.abs() <= all * (1.0 + 1e-12), "{name}: {error}, gain {all}");
                fullest = fullest.max(error.abs() / all);
            }
        }
        println!("{name}: random noise reaches {fullest:.2} of the worst case");
    }
}

/// `noise_gain_l2`: the deviation of the estimate from white noise, over windows that share no sample.
#[test]
fn the_white_noise_gain_is_the_measured_deviation() {
    /// The deviation of a deviation from so many independent windows is 1 / sqrt(2 WINDOWS), 1.6 %.
    const WINDOWS: u32 = 2_000;
    for (name, text) in linear_specs() {
        let generated = designed(&text);
        let (n, steps) = (generated.plant.states.len(), generated.design.valid_from_step);
        let inputs = vec![0.0; generated.plant.inputs.len()];
        for output in 0..generated.plant.outputs.len() {
            let mut interpreter = Interpreter::new(&generated.program);
            let (mut random, mut squares) = (Random::new(2), vec![0.0; n]);
            let mut estimate = vec![0.0; n];
            for call in 0..WINDOWS as usize * (steps + 1) {
                let mut sample = vec![0.0; generated.plant.outputs.len()];
                sample[output] = random.normal();
                interpreter.step(&sample, &inputs, &mut estimate);
                if call % (steps + 1) == steps {
                    squares.iter_mut().zip(&estimate).for_each(|(sum, x)| *sum += x * x);
                }
            }
            for (state, sum) in squares.iter().enumerate() {
                let measured = (sum / f64::from(WINDOWS)).sqrt();
                let gain = generated.design.certificate.noise_gain_l2[state][output];
                // Four and a half deviations: one in 150,000 comparisons, of which there are 60.
                let allowed = 4.5 / f64::from(2 * WINDOWS).sqrt();
                assert!(
                    (measured - gain).abs() <= allowed * gain,
                    "{name}, state {state}, output {output}: {measured}, gain {gain}"
                );
            }
        }
    }
}

/// Pieces of a sample interval in which a disturbance is constant.
const PIECES: usize = 32;

/// x' = A x + d w and y = C x from rest, with w constant in each piece; one column of pieces per sample.
struct Disturbed {
    transition: DMatrix<f64>,
    effect: DVector<f64>,
    c: RowDVector<f64>,
}

impl Disturbed {
    /// The motor without its injection, w on the acceleration.
    fn motor() -> Self {
        let a = DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 0.0, -1.0, 15.0, 0.0, -36.4, -200.0]);
        let piece = a * (1e-3 / PIECES as f64);
        let d = DVector::from_vec(vec![0.0, 1.0, 0.0]);
        // Norm 7e-3: the twelfth term is below 1e-30.
        let (mut power, mut transition) = (DMatrix::identity(3, 3), DMatrix::identity(3, 3));
        let mut integral = DMatrix::identity(3, 3);
        for k in 1..12 {
            power = &power * &piece / f64::from(k);
            transition += &power;
            integral += &power / f64::from(k + 1);
        }
        Self { transition, effect: integral * d * (1e-3 / PIECES as f64), c: RowDVector::from_vec(vec![1.0, 0.0, 0.0]) }
    }

    /// The error of the estimate for a disturbance over the window, oldest piece first.
    fn error(&self, generated: &Generated, disturbance: &[f64]) -> DVector<f64> {
        let mut x = DVector::zeros(3);
        let mut window = vec![vec![(&self.c * &x)[0]]];
        for sample in disturbance.chunks(PIECES) {
            for w in sample {
                x = &self.transition * &x + &self.effect * *w;
            }
            window.push(vec![(&self.c * &x)[0]]);
        }
        DVector::from_vec(estimate(generated, &window)) - x
    }

    /// What one unit in each piece does to the error of each state, oldest first: acc e^{A s} d, integrated.
    fn kernel(&self, generated: &Generated) -> Vec<DVector<f64>> {
        let pieces: Vec<DVector<f64>> = (0..PIECES)
            .scan(self.effect.clone(), |at, _| Some(std::mem::replace(at, &self.transition * &*at)))
            .collect();
        let acc = accumulated(generated);
        let through = |acc: &Vec<Vec<f64>>, piece: &DVector<f64>| DMatrix::from_fn(3, 3, |i, j| acc[i][j]) * piece;
        acc.iter().rev().flat_map(|acc| pieces.iter().rev().map(move |piece| through(acc, piece))).collect()
    }
}

/// `disturbance_gain_l1`: an upper bound for everything, and within 1 % of what bang-bang attains.
#[test]
fn the_disturbance_gain_is_a_tight_bound() {
    let generated = designed(&edited(&corpus("dc_motor"), " - a1*sin(q)", ""));
    let (motor, steps) = (Disturbed::motor(), generated.design.valid_from_step);
    let gains = &generated.design.certificate.disturbance_gain_l1;
    let same = designed(&corpus("dc_motor")).design.certificate.disturbance_gain_l1;
    assert_eq!(*gains, same, "a nonlinearity in what is measured is known, and changes nothing");
    let kernel = motor.kernel(&generated);
    assert_eq!(kernel.len(), steps * PIECES);
    for state in 0..3 {
        let worst: Vec<f64> = kernel.iter().map(|k| -k[state].signum()).collect();
        let attained = motor.error(&generated, &worst)[state];
        let gain = gains[state][0];
        println!(
            "{}: bang-bang attains {attained:.6e}, gain {gain:.6e}, {:.3} % above",
            generated.plant.states[state].label.name,
            (gain / attained - 1.0) * 100.0
        );
        assert!(attained <= gain, "state {state}: {attained} above {gain}");
        assert!(gain <= 1.01 * attained, "state {state}: {gain} far above {attained}");
    }
    let mut random = Random::new(3);
    for run in 0..200 {
        let mut held = 1.0;
        let disturbance: Vec<f64> = (0..steps * PIECES)
            .map(|_| {
                // Fast and slow, full and partial.
                if random.below(1 + run) == 0 {
                    held = if run % 2 == 0 { random.within(-1.0, 1.0) } else { random.within(-1.0, 1.0).signum() };
                }
                held
            })
            .collect();
        let error = motor.error(&generated, &disturbance);
        assert!((0..3).all(|i| error[i].abs() <= gains[i][0]), "run {run}: {error}");
    }
}

/// `error_bound`: the pendulum with its declared noise at the worst signs, for each of the states.
#[test]
fn the_error_bound_holds_for_a_nonlinear_plant() {
    const LEVEL: f64 = 2e-4;
    let generated = designed(&corpus("pendulum"));
    let (truth, steps, fir) = (truth("pendulum").unwrap(), generated.design.valid_from_step, functional(&generated));
    let bounds: Vec<f64> =
        generated.design.certificate.error_bound.iter().map(|b| b.expect("noise is declared")).collect();
    for (state, bound) in bounds.iter().enumerate() {
        let (mut largest, mut hold) = (0.0_f64, 0.0_f64);
        for seed in 0..20 {
            let run = truth.run(1e-3, 1, 400, seed);
            let clean = run.through(&generated).errors(&run, steps..400)[state];
            for at in [steps, 120, 250, 399] {
                for sign in [-1.0, 1.0] {
                    let mut noisy = run.clone();
                    for call in at - steps..=at {
                        let weight = fir.outputs[0].at(state, at - call).double;
                        noisy.measurements[call][0] += sign * LEVEL * weight.signum();
                    }
                    let error = (noisy.through(&generated).estimates[at][state] - run.states[at][state]).abs();
                    // The straight lines' own error is no part of the certificate; it is measured here without noise.
                    assert!(
                        error <= *bound + clean,
                        "state {state}, seed {seed}: {error:e} above {:e} + {clean:e}",
                        *bound
                    );
                    (largest, hold) = (largest.max(error), hold.max(clean));
                }
            }
        }
        println!("{}: {largest:.4e} of {:.4e}, hold {hold:.1e}", generated.plant.states[state].label.name, *bound);
        assert!(largest > 0.9 * *bound, "state {state}: the bound {:e} is far from {largest:e}", *bound);
    }
}

/// `error_bound` with a disturbance: the motor with both at their worst, each part attained separately.
#[test]
fn the_error_bound_is_the_sum_of_its_parts() {
    let generated = designed(&edited(&corpus("dc_motor"), " - a1*sin(q)", ""));
    let certificate = &generated.design.certificate;
    for (i, bound) in certificate.error_bound.iter().enumerate() {
        let sum = 1e-4 * certificate.noise_gain_l1[i][0] + 0.1 * certificate.disturbance_gain_l1[i][0];
        assert!((bound.unwrap() / sum - 1.0).abs() < 1e-15 * 4.0, "{bound:?}, {sum}");
    }
}

/// A discrete plant's disturbance changes once a step: the gain is the sum of |acc d| and is attained.
#[test]
fn the_disturbance_gain_of_a_discrete_plant_is_attained() {
    let text = edited(&corpus("thermal_stack"), "0.9*power'", "0.9*power + 0.5*draught'");
    let text = edited(&text, "[outputs]", "[disturbances]\ndraught = { bound = 1 }\n[outputs]");
    let generated = designed(&text);
    let gains = &generated.design.certificate.disturbance_gain_l1;
    let acc = accumulated(&generated);
    for state in 0..3 {
        let known = truth("thermal_stack").unwrap();
        let signs: Vec<f64> = acc.iter().rev().map(|acc| -acc[state][0].signum()).collect();
        let plant = Truth {
            discrete: true,
            change: Box::new(move |t, x, u| {
                let mut next = (known.change)(t, x, u);
                next[0] += 0.5 * signs[(t / 0.5).round() as usize];
                next
            }),
            outputs: Box::new(|x, _| vec![x[2]]),
            delays: vec![0.0],
            holds: vec![Hold::Zero; 2],
            start: vec![(0.0, 0.0); 3],
            input: vec![(0.0, 0.0); 2],
            exact: true,
        };
        let run = plant.run(0.5, 1, acc.len() + 1, 0);
        let error = run.through(&generated).estimates[acc.len()][state] - run.states[acc.len()][state];
        // Sums of 20 terms in two orders.
        assert!((error / gains[state][0] - 1.0).abs() < 1e-12, "state {state}: {error}, gain {}", gains[state][0]);
    }
}
