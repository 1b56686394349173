//! Claim: on recordings of a drive and of a car the chains of integrators give the numbers that a prototype in double
//! precision gave; `deadbeat compare` gives the README's table; the time stamps of a satellite receiver matter where they
//! tell which samples are missing.

#[path = "support/plant.rs"]
mod plant;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::{env, fs};

use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::designed_in;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).expect(path).replace("\r\n", "\n")
}

/// A column of a recording.
fn column(recording: &str, name: &str) -> Vec<f64> {
    let text = read(&format!("specs/data/{recording}.csv"));
    let mut lines = text.lines();
    let place = lines.next().expect("a header").split(',').position(|it| it == name).expect(name);
    lines.map(|line| line.split(',').nth(place).expect("a cell").parse().expect("a number")).collect()
}

/// The root mean square of the error of `dq` over the rows on which it has converged, and how many these are; rows are
/// taken to be a sample time apart.
fn error(text: &str, scalar: Scalar, recording: &str) -> (f64, u32) {
    let generated = designed_in(text, scalar);
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    let (mut squares, mut rows) = (0.0, 0_u32);
    for (q, reference) in column(recording, "q").into_iter().zip(column(recording, "dq_ref")) {
        if interpreter.step(&[q], &[], &mut estimate) == Status::Converged {
            squares += (estimate[1] - reference) * (estimate[1] - reference);
            rows += 1;
        }
    }
    (f64::sqrt(squares / f64::from(rows)), rows)
}

/// A chain of integrators with a window of so many steps.
fn chain(order: usize, steps: u32, sample_time: f64) -> String {
    let names = ["q", "dq", "d2q", "0"];
    let next = |i: usize| if i + 1 < order { names[i + 1] } else { "0" };
    let states: String = (0..order).map(|i| format!("{} = {{ derivative = '{}' }}\n", names[i], next(i))).collect();
    format!(
        "deadbeat = 1\nname = \"chain\"\n[states]\n{states}[outputs]\ny = {{ value = 'q' }}\n\
         [observer.window]\nwindow = {}\n[target]\nsample_time = {sample_time}\n",
        f64::from(steps) * sample_time
    )
}

fn difference(sample_time: f64) -> String {
    format!(
        "deadbeat = 1\nname = \"difference\"\n[outputs]\nq = {{}}\n[observer.fixed-time-linear]\norder = 2\n\
         [target]\nsample_time = {sample_time}\n"
    )
}

fn near(what: &str, (value, rows): (f64, u32), expected: (f64, u32)) {
    println!("{what}: {value} over {rows} rows");
    assert_eq!(rows, expected.1, "{what}");
    // The prototype's four digits.
    assert!((value - expected.0).abs() <= 0.5e-4, "{what}: {value}, not {}", expected.0);
}

/// Claim: against the drive's own velocity, three integrators over 131 steps are right to 0.1442 rad/s where a backward
/// difference is right to 0.5945 rad/s; on the swing-up, two integrators over two steps to 0.4004 rad/s.
#[test]
fn a_drive_by_hand_and_by_itself() {
    let (hand, swing) = ("ak80_hand_guided_1khz", "ak80_swing_200hz");
    for scalar in [Scalar::F32, Scalar::F64] {
        near("131 steps", error(&chain(3, 131, 1e-3), scalar, hand), (0.1442, 30_000 - 131));
        near("difference", error(&difference(1e-3), scalar, hand), (0.5945, 29_999));
        near("two steps", error(&chain(2, 2, 5e-3), scalar, swing), (0.4004, 3_998));
    }
}

/// The README's command, in a format.
fn table(format: &str) -> String {
    let arguments = ["compare", "--table", "specs/compare/table.toml", "--format", format];
    let output = Command::new(env!("CARGO_BIN_EXE_deadbeat")).current_dir(root()).args(arguments).output();
    let output = output.expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// The report for machines.
fn report() -> &'static Value {
    static REPORT: OnceLock<Value> = OnceLock::new();
    REPORT.get_or_init(|| serde_json::from_str(&table("json")).expect("JSON"))
}
