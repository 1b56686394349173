//! Claim: with a gate, a method that predicts and corrects treats outliers as missing samples, rejects no other sample, and
//! follows a true jump after `gate_limit` rejections.

#![allow(clippy::cast_precision_loss, reason = "counts of calls and samples are small")]

use crate::support::plant;

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use plant::{designed, edited};

const METHODS: [(&str, &str); 5] = [
    ("pll", "bandwidth = 90"),
    ("alpha-beta", "alpha = 0.15"),
    ("differentiator", "order = 2\ntime = 0.1\nstop_before = 20"),
    ("differentiator", "order = 3\ntime = 0.2\nstop_before = 60"),
    ("robust-exact", "order = 2\nlipschitz = 30"),
];

fn specification((method, keys): (&str, &str), gate: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'g'\n[outputs]\nq = {{ unit = 'rad', noise = 1.5e-3{gate} }}\n[observer.{method}]\n{keys}\n\
         [target]\nsample_time = 1e-3\nscalar = 'f64'\n"
    )
}

/// q and the drive's own velocity, of an arm that is moved by hand.
fn by_hand() -> Vec<(f64, f64)> {
    let path = format!("{}/specs/data/ak80_hand_guided_1khz.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        (cells[1], cells[2])
    };
    text.lines().skip(1).map(row).collect()
}

/// One row in a hundred.
fn is_spoilt(row: usize) -> bool {
    (7919 * row) % 1000 >= 990
}

/// Per call: velocity, calls since the newest accepted sample (0 without a gate), status.
fn through(generated: &Generated, samples: &[f64]) -> Vec<(f64, f64, Status)> {
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    let step = |y: &f64| {
        let status = interpreter.step(&[*y], &[], &mut estimate);
        (estimate[1], *estimate.get(generated.plant.states.len()).unwrap_or(&0.0), status)
    };
    samples.iter().map(step).collect()
}

fn rms(answers: &[(f64, f64, Status)], rows: &[(f64, f64)], from: usize) -> f64 {
    let squares = answers.iter().zip(rows).skip(from).map(|(a, (_, dq))| (a.0 - dq).powi(2));
    (squares.sum::<f64>() / (rows.len() - from) as f64).sqrt()
}

/// Rows moved by 0.5 rad to either side: within 5 % of the error without them, and only they are rejected.
#[test]
fn outliers_are_missing_samples() {
    let rows = by_hand();
    let clean: Vec<f64> = rows.iter().map(|(q, _)| *q).collect();
    let mut sign = -1.0;
    let mut outlier = |(row, q): (usize, &f64)| {
        sign = if is_spoilt(row) { -sign } else { sign };
        if is_spoilt(row) { q + 0.5 * sign } else { *q }
    };
    let spoilt: Vec<f64> = clean.iter().enumerate().map(&mut outlier).collect();
    for method in METHODS {
        let (bare, gated) = (designed(&specification(method, "")), designed(&specification(method, ", gate = 0.1")));
        // An outlier before convergence is taken: the first comes with row 90.
        let from = gated.design.valid_from_step.max(1_000);
        let (without, with) = (through(&bare, &clean), through(&gated, &spoilt));
        let (error, gated_error) = (rms(&without, &rows, from), rms(&with, &rows, from));
        let unguarded = rms(&through(&bare, &spoilt), &rows, from);
        println!("{method:?}: {error:.4} rad/s clean, {gated_error:.4} with a gate, {unguarded:.4} without");
        assert!((gated_error / error - 1.0).abs() < 0.05, "{method:?}: {gated_error} and {error}");
        // The sliding law weighs outliers down by itself.
        assert!(unguarded > 1.1 * error, "{method:?}: the outliers say nothing");
        for (row, (_, coasted, _)) in with.iter().enumerate().skip(from) {
            assert_eq!(*coasted > 0.0, is_spoilt(row), "{method:?}, row {row}");
        }
    }
}

/// A jump of 1 rad: rejected so often, then the observer starts again with it, by default after as many calls as it takes
/// to converge, and after no fewer than 10: outliers come in bursts.
#[test]
fn a_true_jump_is_followed() {
    for method in METHODS {
        for (gate, limit) in [(", gate = 0.1, gate_limit = 20", Some(20)), (", gate = 0.1", None)] {
            let generated = designed(&specification(method, gate));
            let valid = generated.design.valid_from_step;
            let limit = limit.unwrap_or(valid.max(10));
            let jump = 4 * valid + 1_000;
            let samples: Vec<f64> =
                (0..jump + limit + 2 * valid + 400).map(|k| f64::from(u8::from(k >= jump))).collect();
            let answers = through(&generated, &samples);
            for (k, (_, coasted, status)) in answers.iter().enumerate().skip(jump).take(limit - 1) {
                assert_eq!(
                    (*coasted, *status),
                    ((k - jump + 1) as f64, Status::Coasting),
                    "{method:?}{gate}, call {k}"
                );
            }
            let (velocity, coasted, status) = answers[jump + limit - 1];
            assert_eq!((velocity, coasted), (0.0, 0.0), "{method:?}{gate}: it starts again");
            assert!(status == Status::Converging || valid == 0, "{method:?}{gate}");
            let (velocity, _, status) = *answers.last().unwrap();
            assert_eq!(status, Status::Converged, "{method:?}{gate}");
            assert!(velocity.abs() < 1e-9, "{method:?}{gate}: {velocity}");
        }
    }
}

/// Of two outputs each has its own gate: the other goes on correcting, and a nonlinear term does not see what is rejected.
#[test]
fn each_output_has_its_own_gate() {
    let text = "deadbeat = 1\nname = 'g'\n[states]\na = { derivative = 'b' }\nb = { derivative = '-9*sin(a) - b' }\n\
                c = { derivative = '2*a - 3*c' }\n[outputs]\na = { value = 'a', gate = 0.05 }\nc = { value = 'c' }\n\
                [observer.kalman]\nprocess_noise = [1e-6, 1e-4, 1e-6]\nmeasurement_noise = [1e-6, 1e-6]\n[target]\n\
                sample_time = 0.01\nscalar = 'f64'\n";
    let (gated, bare) = (designed(text), designed(&edited(text, ", gate = 0.05", "")));
    let from = 3 * gated.design.valid_from_step;
    let run = |generated: &Generated, wrong: f64| {
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = vec![0.0; generated.program.estimates.len()];
        let mut all = Vec::new();
        for k in 0..from + 400 {
            let a = if k > from && k % 7 == 0 { wrong } else { 0.0 };
            let status = interpreter.step(&[a, 0.0], &[], &mut estimate);
            all.push((estimate[..3].to_vec(), status));
        }
        all
    };
    // As if those samples were not there, bit for bit, until one of them could have been good.
    let (rejected, missing) = (run(&gated, 0.7), run(&bare, f64::NAN));
    assert_eq!(rejected, missing);
    assert!(rejected.iter().skip(from).any(|(_, status)| *status == Status::Coasting));
}
