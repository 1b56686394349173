//! Claim: on a recording of a physical pendulum the observer's velocity differs from the laboratory's by
//! 0.0369 rad/s RMS and 0.3237 rad/s at most, in single and in double precision, and `deadbeat run`
//! reports that.

#[path = "support/plant.rs"]
mod plant;

use std::process::Command;

use deadbeat_codegen::program::cost::cost;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::{corpus, designed_in};

/// Digits to which a prototype in double precision gave the two numbers.
const DIGITS: f64 = 1e-4;

fn path(name: &str) -> String {
    format!("{}/specs/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// theta and omega by row.
fn recording() -> Vec<(f64, f64)> {
    let text = std::fs::read_to_string(path("data/pendulum_free_swing_1khz.csv")).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,theta,omega"));
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        (cells[1], cells[2])
    };
    lines.map(row).collect()
}

fn near(what: &str, value: f64, expected: f64) {
    println!("{what}: {value}");
    assert!((value - expected).abs() <= DIGITS, "{what}: {value}, not {expected}");
}

/// Through the interpreter, both float types.
#[test]
fn the_interpreter_gives_the_velocity() {
    let rows = recording();
    assert_eq!(rows.len(), 55_001);
    for scalar in [Scalar::F32, Scalar::F64] {
        let generated = designed_in(&corpus("pendulum"), scalar);
        let mut interpreter = Interpreter::new(&generated.program);
        let (mut squares, mut largest, mut compared) = (0.0, 0.0_f64, 0_u32);
        for (theta, omega) in &rows {
            let mut estimate = [0.0; 2];
            if interpreter.step(&[*theta], &[], &mut estimate) == Status::Converged {
                let error = estimate[1] - omega;
                squares += error * error;
                largest = largest.max(error.abs());
                compared += 1;
            }
        }
        assert_eq!(compared, 54_951);
        near(&format!("{scalar} RMS"), f64::sqrt(squares / f64::from(compared)), 0.0369);
        near(&format!("{scalar} maximum"), largest, 0.3237);
    }
}

/// The README's table: error, deadline, memory and operations of three methods, to the digits that it gives.
#[test]
fn the_table_is_measured() {
    let readme = std::fs::read_to_string(format!("{}/README.md", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let rows = recording();
    for name in ["pendulum", "pendulum_single_delay", "pendulum_impulsive"] {
        let generated = designed_in(&corpus(name), Scalar::F32);
        let mut interpreter = Interpreter::new(&generated.program);
        let (mut squares, mut largest, mut compared) = (0.0, 0.0_f64, 0_u32);
        for (theta, omega) in &rows {
            let mut estimate = [0.0; 2];
            if interpreter.step(&[*theta], &[], &mut estimate) == Status::Converged {
                let error = estimate[1] - omega;
                squares += error * error;
                largest = largest.max(error.abs());
                compared += 1;
            }
        }
        assert_eq!(compared, 54_951, "{name}");
        let cost = cost(&generated.program, deadbeat_math::COSTS);
        let counted = cost.to_string();
        let number = |what: &str| -> u32 {
            let before = counted.split(what).next().unwrap().trim_end();
            before.rsplit([' ', '(']).next().unwrap().parse().unwrap()
        };
        let operations = number("multiplications") + number("additions");
        let deadline = 0.001 * f64::from(u32::try_from(generated.design.valid_from_step).unwrap());
        let row = format!(
            "| `{name}.toml` | {:.4} rad/s | {largest:.4} rad/s | {deadline} s | {} bytes | {operations} and a sine |",
            f64::sqrt(squares / f64::from(compared)),
            cost.ram_bytes
        );
        assert!(readme.contains(&row), "not in the README: {row}");
    }
}

/// Through the command line.
#[test]
fn the_command_line_gives_the_velocity() {
    let (spec, log) = (path("pendulum.toml"), path("data/pendulum_free_swing_1khz.csv"));
    for scalar in ["f32", "f64"] {
        let arguments = ["run", &spec, "--log", &log, "--format", "json", "--scalar", scalar];
        let output = Command::new(env!("CARGO_BIN_EXE_deadbeat")).args(arguments).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["rows"], 55_001);
        assert_eq!(report["converged_rows"], 54_951);
        near(&format!("{scalar} RMS"), report["errors"]["omega"]["rms"].as_f64().unwrap(), 0.0369);
        near(&format!("{scalar} maximum"), report["errors"]["omega"]["max"].as_f64().unwrap(), 0.3237);
    }
}
