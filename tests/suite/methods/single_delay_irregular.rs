//! Claim (000 Theorem 2, corrected): with measurements at irregular times and predictions in between, the error dies
//! out as fast as the printed spectral radius says, wherever that is below 1, and only there; the status says since
//! when. The paper's own condition is computed with its constants, and where it holds its rate is kept.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{linear, plant, truths};

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::promise::{CONTRACTED, Convergence};
use deadbeat_codegen::{Generated, Generator};
use linear::Linear;
use plant::{Random, Run, at_sample_time, designed, functional};
use truths::truth;

use Status::{Coasting, Converged, Converging};

/// Samples of the window of 0.1 s at 1 ms, less one.
const STEPS: usize = 100;

/// 000 (65) with or without its sine, with measurements `max` samples of 1 ms apart at most.
fn motor(sine: bool, k: u32, max: usize) -> String {
    let torque = if sine { " - 35*sin(q)" } else { "" };
    format!(
        "deadbeat = 1
name = 'motor'
[states]
q = {{ derivative = 'dq' }}
dq = {{ derivative = '15*i{torque} - dq' }}
i = {{ derivative = '40*u - 36.4*dq - 200*i' }}
[inputs]
u = {{}}
[outputs]
y = {{ value = 'q' }}
[observer.single-delay]
window = 0.1
k = {k}
intermittent = {{ min = 1e-3, max = '{max}/1000' }}
unproved = 'accept'
[target]
sample_time = 1e-3
scalar = 'f64'
"
    )
}

fn radius(generated: &Generated) -> f64 {
    match generated.design.convergence {
        Convergence::Geometric { radius, .. } => radius,
        Convergence::Finite | Convergence::Prescribed { .. } | Convergence::Sensed { .. } => {
            panic!("a convergence by a call")
        }
    }
}

/// A run of which only some calls bring a measurement.
fn measured_at(run: &Run, measured: impl Fn(usize) -> bool) -> Run {
    let mut run = run.clone();
    for (call, sample) in run.measurements.iter_mut().enumerate() {
        if !measured(call) {
            sample.fill(f64::NAN);
        }
    }
    run
}

/// A plant at rest whose first window of measurements is wrong by up to one: the estimate is the error, and nothing
/// rounds it off.
fn at_rest(generated: &Generated, calls: usize, seed: u64) -> Run {
    let (n, m) = (generated.plant.states.len(), generated.plant.inputs.len());
    let mut random = Random::new(seed);
    let mut run = Run {
        states: vec![vec![0.0; n]; calls],
        measurements: vec![vec![0.0]; calls],
        inputs: vec![vec![0.0; m]; calls],
    };
    run.measurements[..=STEPS].iter_mut().for_each(|y| y[0] = random.within(-1.0, 1.0));
    run
}

/// What the errors of the first window, which keeps its newest measurement in between, can do to the speed.
fn error_at_the_start(generated: &Generated, run: &Run) -> f64 {
    let mut newest = 0.0;
    let mut squares = 0.0;
    for y in &run.measurements[..=STEPS] {
        newest = if y[0].is_nan() { newest } else { y[0] };
        squares += newest * newest;
    }
    (functional(generated).outputs[0].sum_of_squares(1) * squares).sqrt()
}

/// The statuses are Converging before the promised step and Converged from it on.
fn assert_statuses(generated: &Generated, statuses: &[Status]) {
    for (call, status) in statuses.iter().enumerate() {
        let expected = if call < generated.design.valid_from_step { Converging } else { Converged };
        assert_eq!(*status, expected, "call {call} of {}", generated.design.valid_from_step);
    }
}

/// The linear motor: at the promised step a millionth of the error is left, and it goes on as the radius says.
#[test]
fn the_error_contracts_by_the_printed_radius() {
    for gap in [2, 10, 16, 18, 19] {
        let generated = designed(&motor(false, 100, gap));
        let (valid, radius) = (generated.design.valid_from_step, radius(&generated));
        // Down to 1e-200, where numbers have all their digits.
        let periods = (460.0 / -radius.ln()) as usize;
        // The first period begins with the call after the window is full, as the design counts them.
        let first = (STEPS + 1) % gap;
        let calls = valid + (20 + periods) * gap + STEPS;
        let run = measured_at(&at_rest(&generated, calls, 1), |call| call == 0 || call % gap == first);
        let answers = run.through(&generated);
        assert_statuses(&generated, &answers.statuses);
        let start = error_at_the_start(&generated, &run);
        let left = answers.estimates[valid][1].abs();
        assert!(left <= CONTRACTED * start, "gap {gap}: {left:e} of {start:e} is left");
        let error = |call: usize| answers.errors(&run, call..call + STEPS)[1];
        let (from, to) = (valid + 20 * gap, valid + (20 + periods) * gap);
        let measured = (error(to) / error(from)).powf(1.0 / periods as f64);
        println!("gap {gap}: radius {radius:.6}, measured {measured:.6}; left {left:.1e} of {start:.1e}");
        // Other eigenvalues, and the phase of a pair, may still move the largest error of a window by a factor of 4.
        let tolerance = 4.0_f64.ln() / periods as f64;
        assert!((measured / radius).ln().abs() < tolerance, "gap {gap}: {measured} against {radius}");
    }
}

/// With more than 18 ms between measurements the paper's motor is at the border; refusals say by how much.
#[test]
fn measurements_too_far_apart_are_refused_with_the_radius() {
    for gap in [20, 21, 25, 50, 99] {
        let report = Generator::new(&motor(true, 100, gap), "motor.toml").design().unwrap_err();
        let [one] = report.diagnostics.as_slice() else { panic!("{}", report.render(false)) };
        assert_eq!(one.code, codes::METHOD_CANNOT);
        assert!(one.measured.unwrap() > 1.0, "{}", report.render(false));
    }
}

/// A plant that swings: a measurement every fourth sample converges, every third does not, and what allows both is
/// refused.
#[test]
fn a_shorter_gap_that_is_worse_is_found() {
    let (mut linear, _) = Linear::new((4, 2, 0, (true, true), 8, 65));
    (linear.delays, linear.steps) = (vec![0; 2], 14);
    let design = |min: usize, max: usize| {
        let gaps = format!("{{ min = {}, max = {} }}", min as f64 * linear.h, max as f64 * linear.h);
        let keys = format!("k = -0.321\nintermittent = {gaps}\nunproved = 'accept'");
        Generator::new(&linear.text(&format!("[observer.single-delay]\n{keys}")), "swings.toml").design()
    };
    for (min, max) in [(3, 3), (1, 4), (3, 4), (2, 8)] {
        let report = design(min, max).unwrap_err();
        let radius = report.diagnostics[0].measured.unwrap();
        assert!((radius - 1.389).abs() < 1e-3, "{min} to {max}: {}", report.render(false));
    }
    let four = design(4, 4).unwrap();
    assert!((radius(&four) - 0.679).abs() < 1e-3, "{:?}", four.design.convergence);
}

/// Windows that are too long for eigenvalues: 801 samples, whose error contracts as the iteration says.
#[test]
fn long_windows_contract_as_the_iteration_says() {
    let generated = designed(&at_sample_time(&motor(false, 100, 18).replace("min = 1e-3", "min = 0.018"), 1.25e-4));
    let (steps, gap) = (generated.design.window_steps, 144);
    assert_eq!(steps, 800);
    let valid = generated.design.valid_from_step;
    let calls = valid + 41 * gap;
    let mut run = at_rest(&generated, calls, 1);
    run.measurements[..=steps].iter_mut().for_each(|y| y[0] = 1.0);
    let run = measured_at(&run, |call| call == 0 || call % gap == (steps + 1) % gap);
    let answers = run.through(&generated);
    assert_statuses(&generated, &answers.statuses);
    let error = |call: usize| answers.estimates[call][1].abs();
    let measured = (error(valid + 40 * gap) / error(valid)).powf(1.0 / 40.0);
    println!("radius {}, measured {measured}; {:e} left of {:e}", radius(&generated), error(valid), error(steps + gap));
    assert!((measured / radius(&generated) - 1.0).abs() < 1e-6);
    assert!(error(valid) <= CONTRACTED * error(steps + gap));
}

/// Errors of the speed over ten spans of equal length.
fn ten_spans(generated: &Generated, run: &Run, from: usize) -> Vec<f64> {
    let answers = run.through(generated);
    let length = (run.states.len() - from) / 10;
    (0..10).map(|i| answers.errors(run, from + i * length..from + (i + 1) * length)[1]).collect()
}

/// The motor with its sine converges where its linear part does, to a few times the error that straight lines between
/// samples leave where every sample is measured.
#[test]
fn the_motor_converges_with_its_sine() {
    for gap in [2, 16, 18, 19] {
        let generated = designed(&motor(true, 100, gap));
        let valid = generated.design.valid_from_step;
        let whole = truth("dc_motor").unwrap().run(1e-3, 50, 2 * valid + 400, 5);
        let run = measured_at(&whole, |call| call % gap == 0);
        let answers = run.through(&generated);
        assert_statuses(&generated, &answers.statuses);
        let start = answers.errors(&run, STEPS + 1..STEPS + 1 + gap)[1];
        let left = answers.errors(&run, valid..run.states.len())[1];
        let floor = whole.through(&generated).errors(&whole, valid..run.states.len())[1];
        println!("gap {gap}: {start:.1e}, {left:.1e} from call {valid} on; {floor:.1e} with every sample");
        assert!(start > 1e4 * left && left < 10.0 * floor, "gap {gap}: {start:e}, {left:e}, {floor:e}");
    }
}

/// Where the border lies with the sine: at 0.5 ms, 19.0 ms between measurements converge and 19.5 ms do not; at 0.2 ms
/// (too long for a test) 19.0 ms do and 19.2 ms do not. In continuous time `2 / (A2 R)` is 19.2 ms.
#[test]
fn the_border_is_where_the_linear_part_has_it() {
    let h = 5e-4;
    let generated = designed(&at_sample_time(&motor(true, 100, 18), h));
    for (gap, converges) in [(37, true), (38, true), (39, false), (40, false)] {
        // The window must first be filled as the design expects it.
        let run = truth("dc_motor").unwrap().run(h, 200, 16_000, 5);
        let run = measured_at(&run, |call| call % if call < 300 { 36 } else { gap } == 0);
        let errors = ten_spans(&generated, &run, 300);
        println!("{:.1} ms: {errors:?}", gap as f64 * h * 1e3);
        assert_eq!(errors[9] < 0.3 * errors[1], converges, "gap {gap}: {errors:?}");
        assert_eq!(errors[9] > 3.0 * errors[1], !converges, "gap {gap}: {errors:?}");
    }
}

/// Gaps drawn at random up to 12 ms: the promise holds as it does for regular ones.
#[test]
fn random_gaps_converge() {
    let generated = designed(&motor(false, 100, 12));
    let valid = generated.design.valid_from_step;
    for seed in 0..20 {
        let mut random = Random::new(seed);
        let calls = 2 * valid;
        let mut measured = vec![false; calls];
        let mut call = 0;
        while call < calls {
            measured[call] = true;
            call += 1 + random.below(12);
        }
        let run = measured_at(&at_rest(&generated, calls, seed), |call| measured[call]);
        let (answers, start) = (run.through(&generated), error_at_the_start(&generated, &run));
        assert_statuses(&generated, &answers.statuses);
        let left = answers.estimates[valid..].iter().map(|x| x[1].abs()).fold(0.0, f64::max);
        println!("seed {seed}: {left:.1e} of {start:.1e}");
        assert!(left <= CONTRACTED * start, "seed {seed}: {left:e} of {start:e}");
    }
}

/// A gap that is longer than declared is coasted over, until its error has died out as one at the start has; before the window is full it starts the window again.
#[test]
fn a_longer_gap_is_coasted_over() {
    let most = 12;
    let generated = designed(&motor(true, 100, most));
    let valid = generated.design.valid_from_step;
    let (last, next) = (valid + most - valid % most + 5 * most, valid + most - valid % most + 8 * most);
    let run = truth("dc_motor").unwrap().run(1e-3, 50, next + valid + 2 * STEPS, 5);
    let run = measured_at(&run, |call| call % most == 0 && !(last + 1..next).contains(&call));
    let answers = run.through(&generated);
    for (call, status) in answers.statuses.iter().enumerate() {
        let expected = match call {
            call if call < valid => Converging,
            call if (last + most..next + valid).contains(&call) => Coasting,
            _ => Converged,
        };
        assert_eq!(*status, expected, "call {call}, measured at {last} and {next}");
    }
}
