//! Claim: on recordings of a drive and of a car the chains of integrators give the numbers that a prototype in double
//! precision gave; `deadbeat compare` gives the manual's table; the time stamps of a satellite receiver matter where they
//! tell which samples are missing.

use crate::support::plant;

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
    let states: Vec<String> = (0..order).map(|i| format!("{} = {{ derivative = '{}' }}", names[i], next(i))).collect();
    let states = states.join("\n");
    format!(
        "deadbeat = 1\nname = \"chain\"\n[states]\n{states}\n[outputs]\ny = {{ value = 'q' }}\n\
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

/// The manual's command, in a format.
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

/// The row of a specification in one of the table's groups.
fn row(group: usize, specification: &str) -> &'static Value {
    let rows = report()["recordings"][group]["states"][0]["specifications"].as_array().expect("rows");
    rows.iter().find(|row| row["specification"] == specification).expect(specification)
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| panic!("{key}: {row}"))
}

/// Claim: the manual's tables are what its command prints.
#[test]
fn the_manual_has_the_table() {
    let (manual, page) = (read("manual/compared.md"), table("markdown"));
    let quoted: Vec<&str> = page.lines().filter(|line| !line.is_empty()).collect();
    let missing: Vec<&str> = quoted.iter().copied().filter(|line| !manual.contains(line)).collect();
    assert!(missing.is_empty(), "not in manual/compared.md:\n{}", missing.join("\n"));
    // Nor has it rows of another version.
    let begin = manual.find(quoted[0]).expect("the first title");
    let end = begin + manual[begin..].find("\n## ").unwrap_or(manual.len() - begin);
    let rows = manual[begin..end].lines().filter(|line| line.starts_with('|'));
    assert_eq!(rows.count(), page.lines().filter(|line| line.starts_with('|')).count());
}

/// Claim: every specification of the table is accepted and takes part.
#[test]
fn every_specification_of_the_table_is_used() {
    let table = read("specs/compare/table.toml");
    let mut count = 0;
    for folder in ["hand", "swing", "gnss"] {
        for entry in fs::read_dir(root().join("specs/compare").join(folder)).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            let text = fs::read_to_string(&path).expect("a specification");
            let report = deadbeat_codegen::Generator::new(&text, &name).check();
            assert!(!report.has_errors(), "{}", report.render(false));
            assert!(text.contains(&format!("name = \"{}\"", name.trim_end_matches(".toml"))), "{name}");
            assert!(table.contains(&format!("\"{folder}/{name}\"")), "{folder}/{name} is in no group");
            count += 1;
        }
    }
    assert!(count > 20);
}

/// Claim: on noise, what is tuned ties: window, Kalman filter and differentiator are within a tenth of each other on
/// every recording, and all but the window of one step beat backward differences where there is noise to be averaged.
#[test]
fn tuned_estimators_tie() {
    for (group, names) in [
        (0, ["window_131_steps", "kalman_tuned", "differentiator_50_ms"]),
        (1, ["window_1_step", "kalman_tuned", "differentiator_20_ms"]),
        (2, ["window_9_steps", "kalman_tuned", "differentiator_4_s"]),
    ] {
        let errors = names.map(|name| number(row(group, name), "rms"));
        let (least, most) = errors.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(*x), b.max(*x)));
        assert!(most <= 1.1 * least, "{group}: {errors:?}");
        let factor = if group == 1 { 1.03 } else { 0.7 };
        assert!(most < factor * number(row(group, "difference"), "rms"), "{group}: {errors:?}");
    }
}

/// Claim: the receiver's own stamps and those of reception tell the same 19 missing epochs and give the same speed to a
/// few percent; with no stamps the gaps go unseen, and the speed is wrong by more than a metre a second.
#[test]
fn stamps_tell_which_samples_are_missing() {
    for name in ["window_9_steps", "kalman_tuned"] {
        let (sensor, received) = (number(row(2, name), "rms"), number(row(3, name), "rms"));
        assert!((received / sensor - 1.0).abs() < 0.05, "{name}: {sensor} {received}");
    }
    for group in [2, 3] {
        let remarks = report()["recordings"][group]["remarks"].to_string();
        assert!(remarks.contains("19 samples that the recording's time leaves out"), "{remarks}");
    }
    // Without its times; each row's reference is at the sensor's.
    let generated = designed_in(&read("specs/compare/gnss/window_9_steps.toml"), Scalar::F32);
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; 3];
    let (mut squares, mut rows) = (0.0, 0_u32);
    for (north, time) in column("rav4_gnss", "north").into_iter().zip(column("rav4_gnss", "t_sensor")) {
        if interpreter.step(&[north], &[], &mut estimate) == Status::Converged {
            squares += (estimate[1] - north_at(time)) * (estimate[1] - north_at(time));
            rows += 1;
        }
    }
    let error = f64::sqrt(squares / f64::from(rows));
    println!("no stamps: {error} m/s");
    // As the manual says, to two digits.
    assert!((error - 2.3).abs() < 0.05, "{error}");
}

/// The car's true speed to the north, m/s: straight lines between the rows of the reference.
fn north_at(time: f64) -> f64 {
    static REFERENCE: OnceLock<(Vec<f64>, Vec<f64>)> = OnceLock::new();
    let column = |name| column("rav4_pose_reference", name);
    let (times, speeds) = REFERENCE.get_or_init(|| (column("t"), column("v_north_ref")));
    let next = times.partition_point(|t| *t <= time);
    let share = (time - times[next - 1]) / (times[next] - times[next - 1]);
    speeds[next - 1] + share * (speeds[next] - speeds[next - 1])
}

/// Claim: a quotient over the receiver's own stamps is right to 0.13 m/s, over those of reception to 1.7 m/s, as the
/// manual says.
#[test]
fn a_quotient_over_stamps_of_reception_is_useless() {
    let north = column("rav4_gnss", "north");
    for (stamps, expected) in [("t_sensor", 0.13), ("t", 1.7)] {
        let times = column("rav4_gnss", stamps);
        let errors = (1..north.len()).map(|k| {
            let quotient = (north[k] - north[k - 1]) / (times[k] - times[k - 1]);
            (quotient - north_at(times[k])) * (quotient - north_at(times[k]))
        });
        let count = u32::try_from(north.len() - 1).expect("few rows");
        let error = f64::sqrt(errors.sum::<f64>() / f64::from(count));
        // Two digits.
        assert!((error / expected - 1.0).abs() < 0.03, "{stamps}: {error}");
    }
}
