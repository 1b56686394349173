//! Claim: a replay hands over what a step's fields are: counts as integers, ages from a sensor's own clock, samples of
//! several rates; what turns with a wrapped output is compared modulo the turn, and integers are written as integers.

mod foreign;
mod residual;
mod rows;

use crate::support::corpus;

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use corpus::empty_folder;
use serde_json::Value;

struct Desk(PathBuf);

impl Desk {
    fn new(test: &str) -> Self {
        Self(empty_folder(&format!("replay_{test}")))
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("a file of the test");
    }

    /// Exit code, standard output, standard error.
    fn run(&self, line: &str) -> (Option<i32>, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
        let output = command.current_dir(&self.0).args(line.split_whitespace()).output().expect("it runs");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        (output.status.code(), text(output.stdout), text(output.stderr))
    }

    fn fine(&self, line: &str) -> String {
        let (code, out, err) = self.run(line);
        assert_eq!(code, Some(0), "{line}\n{err}");
        out
    }

    fn json(&self, line: &str) -> Value {
        serde_json::from_str(&self.fine(&format!("{line} --format json"))).expect("JSON")
    }

    fn complains(&self, line: &str, code: i32, words: &[&str]) {
        let (found, out, err) = self.run(line);
        assert_eq!(found, Some(code), "{line}\n{out}\n{err}");
        for word in words {
            assert!(err.contains(word), "`{word}` is not in\n{err}");
        }
    }
}

/// Two integrators at 100 Hz in double precision; the output's keys, the observer's lines and the target's.
fn chain(output: &str, observer: &str, target: &str) -> String {
    format!(
        "deadbeat = 1\nname = \"axis\"\n[states]\nx = {{ unit = \"rad\", derivative = 'v' }}\n\
         v = {{ unit = \"rad/s\", derivative = '0' }}\n[outputs]\ny = {{ unit = \"rad\", value = 'x'{output} }}\n\
         {observer}\n[target]\nsample_time = 0.01\nscalar = \"f64\"\n{target}"
    )
}

const WINDOW: &str = "[observer.window]\nwindow = 0.05";

/// A recording of 300 rows at 100 Hz, from the number of the row and its time.
fn recording(header: &str, row: impl Fn(i32, f64) -> Option<String>) -> String {
    let mut text = format!("{header}\n");
    for k in 0..300 {
        let t = f64::from(k) * 0.01;
        if let Some(cells) = row(k, t) {
            let _ = writeln!(text, "{t:.2},{cells}");
        }
    }
    text
}

/// A signed counter of 16 bits with 1000 counts a radian, of an axis at 20 rad/s: it overflows every 3.3 s.
fn count(k: i32) -> i64 {
    (i64::from(k) * 200 + 32_768).rem_euclid(65_536) - 32_768
}

/// Claim: counts are handed over raw and may overflow; the position is compared modulo the counter's range.
#[test]
fn counters() {
    let desk = Desk::new("counters");
    desk.write("axis.toml", &chain(", quantum = 0.001, sample = \"i16\", wrap = \"counter\"", WINDOW, ""));
    let truth = |k: i32, t: f64| format!("{},{},20", count(k), 20.0 * t);
    desk.write("log.csv", &recording("t,y,position,v", |k, t| Some(truth(k, t))));
    let line = "run axis.toml --log log.csv --reference x=position";
    let report = desk.json(line);
    assert_eq!((report["rows"].as_u64(), report["converged_rows"].as_u64()), (Some(300), Some(295)));
    for state in ["x", "v"] {
        let largest = report["errors"][state]["max"].as_f64().expect("an error");
        // Differences of up to 1000 counts times 0.001 over 0.05 s, in double precision.
        assert!(largest < 1e-10, "{state}: {largest}");
    }
    // Counts that the time leaves out lie on a straight line, over the overflow too (row 164).
    desk.write("gap.csv", &recording("t,y,position,v", |k, t| (!(160..170).contains(&k)).then(|| truth(k, t))));
    let gap = desk.json(&line.replace("log.csv", "gap.csv"));
    assert!(gap["errors"]["v"]["max"].as_f64().is_some_and(|largest| largest < 1e-10), "{gap}");
    let text = desk.fine(&line.replace("log.csv", "gap.csv"));
    assert!(text.contains("10 samples that the recording's time leaves out were put on a straight line"), "{text}");

    for (cell, words) in [
        ("1.5", ["log.csv:102:", "column `y`", "1.5 is not a signed integer of 16 bits"]),
        ("40000", ["log.csv:102:", "column `y`", "40000 is not a signed integer of 16 bits"]),
        ("", ["log.csv:102:", "column `y`", "there is no count"]),
    ] {
        let wrong = |k: i32, t: f64| Some(if k == 100 { format!("{cell},0,0") } else { truth(k, t) });
        desk.write("log.csv", &recording("t,y,position,v", wrong));
        desk.complains(line, 1, &words);
    }
}

/// Claim: a reference of a wrapped angle may count turns or not; the error is the same, by `run` and by `compare`.
#[test]
fn turns_are_no_error() {
    let desk = Desk::new("turns");
    desk.write("axis.toml", &chain(", wrap = '2*pi'", WINDOW, ""));
    let turn = std::f64::consts::TAU;
    let row = |_: i32, t: f64| {
        let angle = 20.0 * t;
        let folded = angle - turn * (angle / turn).round();
        Some(format!("{folded},{folded},{}", angle + 0.25))
    };
    desk.write("log.csv", &recording("t,y,folded,unfolded", row));
    let largest = |column: &str| {
        let report = desk.json(&format!("run axis.toml --log log.csv --reference x={column}"));
        report["errors"]["x"]["max"].as_f64().expect("an error")
    };
    // Rounding of angles up to 60 rad.
    assert!(largest("folded") < 1e-12, "{}", largest("folded"));
    assert!((largest("unfolded") - 0.25).abs() < 1e-12, "{}", largest("unfolded"));
    let report = desk.json("compare axis.toml --log log.csv --reference x=unfolded --reference x=folded");
    let rms = |place: usize| report["states"][place]["specifications"][0]["rms"].as_f64().expect("an error");
    assert!((rms(0) - 0.25).abs() < 1e-12 && rms(1) < 1e-12, "{} {}", rms(0), rms(1));
    let figure = desk.fine("run axis.toml --log log.csv --reference x=unfolded --plot -");
    assert!(figure.contains("error of x"));
}

/// Claim: `coasted` is written as an integer and cannot be compared; it counts the calls since the newest sample.
#[test]
fn integers_are_written_as_integers() {
    let desk = Desk::new("integers");
    desk.write("axis.toml", &chain("", &format!("{WINDOW}\nmissing = \"left-out\""), ""));
    let lost = |k: i32| (100..104).contains(&k);
    desk.write("log.csv", &recording("t,y,coasted", |k, t| Some(if lost(k) { ",7".into() } else { format!("{t},7") })));
    let report = desk.json("run axis.toml --log log.csv --out est.csv --reference x=y");
    assert!(report["errors"]["coasted"].is_null(), "{report}");
    let text = fs::read_to_string(desk.0.join("est.csv")).expect("the estimate");
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], ["t", "x", "v", "coasted", "status"]);
    let coasted: Vec<&str> = rows[100..107].iter().map(|row| row[3]).collect();
    assert_eq!(coasted, ["0", "1", "2", "3", "4", "0", "0"]);
    desk.complains("run axis.toml --log log.csv --reference coasted=coasted", 3, &["`coasted` is not a state"]);
}

/// Claim: each of several windows has its own columns, which may be compared.
#[test]
fn windows_have_columns_of_their_own() {
    let desk = Desk::new("windows");
    desk.write("axis.toml", &chain("", "[observer.window]\nwindow = [0.02, 0.1]", ""));
    desk.write("log.csv", &recording("t,y,speed", |_, t| Some(format!("{},{}", t * t, 2.0 * t))));
    let report = desk.json("compare axis.toml --log log.csv --reference v=speed --reference v_2=speed");
    let error = |place: usize| report["states"][place]["specifications"][0]["rms"].as_f64().expect("an error");
    // A straight line through a parabola is late by half its length: 2 rad/s^2 times 0.01 s and 0.05 s.
    assert!((error(0) - 0.02).abs() < 1e-9 && (error(1) - 0.1).abs() < 1e-9, "{} {}", error(0), error(1));
}

/// Claim: rows on which an output of a slower rate is not due may be empty or hold a number.
#[test]
fn rates_of_their_own() {
    let desk = Desk::new("rates");
    let text =
        chain(", every = 5", WINDOW, "").replace("[observer", "w = { unit = \"rad/s\", value = 'v' }\n[observer");
    desk.write("axis.toml", &text);
    let row = |k: i32, t: f64| Some(if k % 5 == 0 { format!("{},3,3", 3.0 * t) } else { ",3,3".into() });
    desk.write("log.csv", &recording("t,y,w,v", row));
    let report = desk.json("run axis.toml --log log.csv");
    assert!(report["converged_rows"].as_u64() > Some(280), "{report}");
    assert!(report["errors"]["v"]["max"].as_f64().is_some_and(|largest| largest < 1e-10), "{report}");
}

/// Claim: ages come from a column of their own or are the time less a sensor's own, with the same result; a sensor's time
/// ahead of the recording's is no age, and is counted.
#[test]
fn ages() {
    let desk = Desk::new("ages");
    desk.write("axis.toml", &chain(", age = \"measured\", age_max = 0.01", WINDOW, ""));
    let late = |k: i32| f64::from(k % 7) * 1e-3;
    let row = |k: i32, t: f64| {
        let stamp = if k == 150 { t + 0.5 } else { t - late(k) };
        let age = if k == 150 { f64::NAN } else { late(k) };
        Some(format!("{},{stamp},{age},{age},3", 3.0 * (t - late(k))))
    };
    desk.write("log.csv", &recording("t,y,stamp,y_age,old,v", row));
    let line = "run axis.toml --log log.csv";
    let report = desk.json(&format!("{line} --age y=stamp"));
    let largest = report["errors"]["v"]["max"].as_f64().expect("an error");
    // Times are differences of numbers up to 3 s, over a window of 0.05 s.
    assert!(largest < 3.0 * 3.0 / 0.05 * 64.0 * f64::EPSILON, "{largest}");
    assert_eq!(report["negative_ages"].as_u64(), Some(1));
    let text = desk.fine(&format!("{line} --age y=stamp"));
    assert!(text.contains("1 samples are of a later time than their row"), "{text}");
    for other in ["", "--map y_age=old"] {
        let same = desk.json(&format!("{line} {other}"));
        let found = same["errors"]["v"]["max"].as_f64().expect("an error");
        assert!(found < 1e-9 && same["negative_ages"].is_null(), "{other}: {same}");
        assert_eq!(same["converged_rows"], report["converged_rows"]);
    }
    desk.complains(&format!("{line} --age y=stamp --map y_age=old"), 3, &["--age y", "--map names a column"]);
    desk.complains(&format!("{line} --age x=stamp"), 3, &["`x` is not an output", "whose age is measured"]);
    desk.write("untimed.csv", "y,stamp\n1,1\n");
    desk.complains("run axis.toml --log untimed.csv --age y=stamp", 3, &["no column `t`"]);
}
