//! Claim: `deadbeat compare` scores several specifications over the rows on which all of them have converged, with errors,
//! lags, deadlines and costs that can be told beforehand, as text, JSON, Markdown and a figure; what does not fit is said
//! with its place, and nothing half-made stays on the disk.

use crate::support::corpus;

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use corpus::empty_folder;
use serde_json::Value;

/// A folder with a command line in it.
struct Desk(PathBuf);

/// How a command ended.
struct Ended {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Ended {
    fn is(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "\n{}\n{}", self.out, self.err);
        self
    }

    fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}\n{}", self.out))
    }

    /// Standard error has all of these, and standard output nothing.
    fn complains(self, words: &[&str]) {
        for word in words {
            assert!(self.err.contains(word), "`{word}` is not in\n{}", self.err);
        }
        assert!(self.out.is_empty(), "{}", self.out);
    }
}

impl Desk {
    /// With a window of three samples, one of 21, backward differences, and a recording of a ramp.
    fn new(test: &str) -> Self {
        let desk = Self(empty_folder(&format!("compare_{test}")));
        for (name, steps) in [("narrow", 2), ("wide", 20)] {
            let window = f64::from(steps) * 0.01;
            desk.write(&format!("{name}.toml"), &chain(name, &format!("[observer.window]\nwindow = {window}")));
        }
        desk.write("difference.toml", &chain("difference", "[observer.fixed-time-linear]"));
        desk.write("ramp.csv", &rows(300, |t| 2.0 * t, |_| 2.0));
        desk
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.0.join(name), text).expect("a file of the test");
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder");
        let mut names: Vec<String> =
            entries.map(|it| it.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn fed(&self, line: &str, input: &str) -> Ended {
        let mut command = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
        command.current_dir(&self.0).args(line.split_whitespace());
        let mut child =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it runs");
        // A command that refuses does not read to the end.
        let _ = child.stdin.take().expect("its input").write_all(input.as_bytes());
        let output = child.wait_with_output().expect("it ends");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        Ended { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
    }

    fn run(&self, line: &str) -> Ended {
        self.fed(line, "")
    }
}

/// Two integrators in double precision, at 100 Hz.
fn chain(name: &str, observer: &str) -> String {
    format!(
        "deadbeat = 1\nname = \"{name}\"\n[states]\nx = {{ unit = \"m\", derivative = 'v' }}\n\
         v = {{ unit = \"m/s\", derivative = '0' }}\n[outputs]\ny = {{ unit = \"m\", value = 'x' }}\n{observer}\n\
         [target]\nsample_time = 0.01\nscalar = \"f64\"\n"
    )
}

/// A recording `t,y,v_ref` at 100 Hz.
fn rows(count: i32, y: impl Fn(f64) -> f64, v: impl Fn(f64) -> f64) -> String {
    let mut text = "t,y,v_ref\n".to_owned();
    for k in 0..count {
        let t = f64::from(k) * 0.01;
        let _ = writeln!(text, "{t:.2},{},{}", y(t), v(t));
    }
    text
}

/// The row of a specification in the report for machines.
fn row<'a>(report: &'a Value, specification: &str) -> &'a Value {
    let all = report["states"][0]["specifications"].as_array().expect("rows");
    all.iter().find(|row| row["specification"] == specification).unwrap_or_else(|| panic!("{specification}: {report}"))
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| panic!("{key}: {row}"))
}

const ALL: &str = "compare narrow.toml wide.toml difference.toml --log ramp.csv --reference v=v_ref";

/// Claim: errors are counted over the rows that all have converged on; a ramp with one wrong reference gives its error
/// to every row's maximum, and costs and deadlines are those of `design`.
#[test]
fn everyone_is_scored_over_the_same_rows() {
    let desk = Desk::new("rows");
    // One reference is off by 3 in row 100 (from 0), one by 7 in row 10, where only the narrow ones have converged.
    let off =
        |t: f64| 2.0 + if (t - 1.0).abs() < 1e-6 { 3.0 } else { 0.0 } + if (t - 0.1).abs() < 1e-6 { 7.0 } else { 0.0 };
    desk.write("ramp.csv", &rows(300, |t| 2.0 * t, off));
    let report = desk.run(&format!("{ALL} --format json")).is(0).json();
    let state = &report["states"][0];
    assert_eq!((report["rows"].as_u64(), state["compared_rows"].as_u64()), (Some(300), Some(280)));
    assert_eq!((state["first_compared_row"].as_u64(), state["last_compared_row"].as_u64()), (Some(21), Some(300)));
    assert_eq!((state["state"].as_str(), state["unit"].as_str()), (Some("v"), Some("m/s")));
    for (name, row_number, after) in [("narrow", 3, 0.02), ("wide", 21, 0.2), ("difference", 2, 0.01)] {
        let row = row(&report, name);
        assert_eq!(row["converged_row"].as_u64(), Some(row_number), "{name}");
        // The recording's times have two digits; their difference is rounded once.
        assert!((number(row, "converged_after") - after).abs() < 1e-15, "{name}");
        // Differences of numbers up to 6 over 0.01 s, in double precision.
        let rounding = 6.0 / 0.01 * 16.0 * f64::EPSILON;
        assert!((number(row, "max") - 3.0).abs() < rounding, "{name}: {row}");
        assert!((number(row, "rms") - 3.0 / 280.0_f64.sqrt()).abs() < rounding, "{name}: {row}");
        assert!(number(row, "p99") < rounding, "one row of 280 is beyond 99 %: {row}");
        let design = desk.run(&format!("design {name}.toml --format json")).is(0).json();
        assert_eq!(row["ram_bytes"], design["cost"]["ram_bytes"]);
        assert_eq!(row["operations"], design["cost"]["flops_worst"]);
    }
}

/// Claim: the lag of an estimate by a window of N steps of a slow sine's speed is half the window, and of backward
/// differences half a sample: both fit a straight line to the position.
#[test]
fn lags_are_those_of_straight_lines() {
    let desk = Desk::new("lag");
    desk.write("ramp.csv", &rows(3000, f64::sin, f64::cos));
    let report = desk.run(&format!("{ALL} --format json")).is(0).json();
    for (name, lag) in [("narrow", 0.01), ("wide", 0.1), ("difference", 0.005)] {
        // A line's slope over a length of T is the derivative's mean with a parabola's weight: later terms are (T/2)^3.
        let found = number(row(&report, name), "lag");
        assert!((found - lag).abs() < 0.1 * lag.powi(3) + 1e-6, "{name}: {found}");
    }
}

/// Claim: text, Markdown and JSON say the same; the specifications keep their order; a name that two have gives way to
/// their files.
#[test]
fn reports_agree() {
    let desk = Desk::new("reports");
    let noisy = |t: f64| 2.0 * t + 1e-3 * (1e4 * t * t).sin();
    desk.write("ramp.csv", &rows(300, noisy, |_| 2.0));
    let report = desk.run(&format!("{ALL} --format json")).is(0).json();
    let text = desk.run(ALL).is(0).out;
    let page = desk.run(&format!("{ALL} --format markdown")).is(0).out;
    let mut last = 0;
    for name in ["narrow", "wide", "difference"] {
        let line = text.lines().position(|line| line.starts_with(&format!("{name} "))).expect("a row");
        assert!(line > last, "{text}");
        last = line;
        let words: Vec<&str> = text.lines().nth(line).expect("it").split_whitespace().collect();
        let rms: f64 = words[2].parse().expect("a number");
        let exact = number(row(&report, name), "rms");
        // Four digits.
        assert!((rms - exact).abs() <= 5.1e-4 * exact, "{rms} {exact}");
        let cells = format!("| `{name}` | `{}` | {} |", words[1], words[2..].join(" | "));
        assert!(page.contains(&cells), "{cells}\n{page}");
    }
    assert!(text.contains("`v` [m/s] against `v_ref`: errors over the 280 of 300 rows"), "{text}");
    desk.write("again.toml", &chain("narrow", "[observer.window]\nwindow = 0.05"));
    let twice = desk.run("compare narrow.toml again.toml --log ramp.csv --reference v=v_ref").is(0).out;
    assert!(twice.contains("\nnarrow.toml ") && twice.contains("\nagain.toml "), "{twice}");
}

/// Claim: references from a recording of their own run straight between its rows; outside of it nothing is compared.
#[test]
fn references_may_be_in_another_recording() {
    let desk = Desk::new("elsewhere");
    // The speed is a quarter of t^2, known once a second at odd times; between them straight lines.
    let speed = |t: f64| 0.25 * t * t;
    desk.write("ramp.csv", &rows(1000, |t| t * t * t / 12.0, |_| 0.0));
    let known: Vec<String> = (1..=8).map(|k| format!("{k}.005,{}\n", speed(f64::from(k) + 0.005))).collect();
    desk.write("ref.csv", &format!("t,v\n{}", known.concat()));
    let line = "compare narrow.toml wide.toml --log ramp.csv --reference v=v --reference-log ref.csv --format json";
    let report = desk.run(line).is(0).json();
    // From 1.01 s to 8 s.
    assert_eq!(report["states"][0]["compared_rows"].as_u64(), Some(700));
    let largest = number(row(&report, "narrow"), "max");
    // A chord over a second of 0.25 t^2 is 1/16 too high in its middle; the window of three is 0.01 s late on a slope of
    // 0.25 t, at most 4, which is 0.02 of it.
    assert!((0.0625..0.0625 + 0.04).contains(&largest), "{largest}");
    desk.write("ref.csv", "t,v\n1,0\n1,0\n");
    desk.run(line).is(1).complains(&["ref.csv:3:", "the time does not rise"]);
    desk.write("ref.csv", "t,w\n1,0\n");
    desk.run(line).is(1).complains(&["ref.csv:", "there is no column `v`"]);
}

/// Claim: what does not fit is named, with its place.
#[test]
fn what_does_not_fit_is_named() {
    let desk = Desk::new("wrong");
    desk.write("slow.toml", &chain("slow", "[observer.window]\nwindow = 0.1").replace("time = 0.01", "time = 0.02"));
    let line = "compare narrow.toml slow.toml --log ramp.csv --reference v=v_ref";
    desk.run(line).is(1).complains(&["ramp.csv:", "slow.toml does not fit", "sample time is 0.02 s"]);
    desk.write("untimed.csv", &rows(30, |t| t, |_| 1.0).replacen("t,", "seconds,", 1));
    let untimed = line.replace("ramp", "untimed");
    desk.run(&untimed).is(3).complains(&["no column `t`", "0.01 s apart for narrow.toml", "0.02 s for slow.toml"]);
    desk.write("bad.csv", "t,y,v_ref\n0,1,x\n");
    desk.run(&ALL.replace("ramp", "bad")).is(1).complains(&["bad.csv:2:", "column `v_ref`", "`x` is not a number"]);
    desk.run(&ALL.replace("v=v_ref", "w=v_ref")).is(3).complains(&["`w` is not a state of narrow.toml", "`x`, `v`"]);
    desk.run(&ALL.replace("v=v_ref", "v=speed")).is(1).complains(&["no column `speed`"]);
    desk.run("compare narrow.toml --log ramp.csv").is(3).complains(&["--reference STATE=COLUMN"]);
    desk.run("compare narrow.toml --reference v=v_ref").is(3).complains(&["--log"]);
    desk.run("compare --log ramp.csv --reference v=v_ref").is(3).complains(&["<SPECS>"]);
    desk.run(&format!("{ALL} --map z=y")).is(3).complains(&["--map: `z`", "of any specification"]);
    desk.run(&format!("{ALL} --age y=t")).is(3).complains(&["--age: `y` is not an output", "whose age is measured"]);
    desk.run(&format!("{ALL} --plot ramp.csv")).is(3).complains(&["--plot would overwrite ramp.csv", "--log"]);
    desk.run("compare - --log - --reference v=v_ref").is(3).complains(&["one file only"]);
    desk.write("none.csv", "t,y,v_ref\n");
    desk.run(&ALL.replace("ramp", "none")).is(1).complains(&["the recording has no rows"]);
    let names = desk.names();
    assert!(!names.iter().any(|name| name.ends_with("svg") || name.ends_with("part")), "{names:?}");
}

/// Claim: when one never converges nothing is compared, and the report says which.
#[test]
fn nothing_to_compare_is_said() {
    let desk = Desk::new("never");
    desk.write("ramp.csv", &rows(15, |t| 2.0 * t, |_| 2.0));
    let text = desk.run(ALL).is(0).out;
    assert!(text.contains("nothing to compare") && text.contains("`wide` never does"), "{text}");
    let report = desk.run(&format!("{ALL} --format json")).is(0).json();
    assert!(row(&report, "narrow")["rms"].is_null() && row(&report, "narrow")["converged_row"] == 3, "{report}");
    desk.write("ramp.csv", &rows(300, |t| 2.0 * t, |_| f64::NAN));
    assert!(desk.run(ALL).is(0).out.contains("the reference is known on none of them"));
}

/// Claim: the figure has every estimate in a colour of its own with a legend; standard output can stand for it, and
/// standard input for the recording.
#[test]
fn figures() {
    let desk = Desk::new("figure");
    desk.run(&format!("{ALL} --plot out.svg")).is(0);
    let svg = fs::read_to_string(desk.0.join("out.svg")).expect("a figure");
    for name in ["reference", "narrow", "wide", "difference"] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name}");
    }
    for colour in ["#0072b2", "#d55e00", "#009e73"] {
        // The legend, two panels of two columns.
        assert_eq!(svg.matches(&format!("<path stroke=\"{colour}\"")).count(), 5, "{colour}");
    }
    let input = fs::read_to_string(desk.0.join("ramp.csv")).expect("the recording");
    let piped = desk.fed(&format!("{} --plot -", ALL.replace("ramp.csv", "-")), &input).is(0);
    assert_eq!(piped.out, svg.replace("ramp.csv", "standard input"));
    assert!(piped.err.contains("errors over the 280 of 300 rows"), "{}", piped.err);
}

/// Claim: a table of groups gives a report for each, with paths from where it stands; a mistake in it is named by line.
#[test]
fn tables() {
    let desk = Desk::new("table");
    fs::create_dir(desk.0.join("sub")).expect("a folder");
    let group = "[[recording]]\ntitle = \"One\"\nlog = \"../ramp.csv\"\nreferences = { v = \"v_ref\" }\n\
                 specs = [\"../narrow.toml\", \"../wide.toml\"]\n";
    let other = group.replace("One", "Two").replace("\"../narrow.toml\", ", "");
    desk.write("sub/table.toml", &format!("{group}{other}"));
    let report = desk.run("compare --table sub/table.toml --format json").is(0).json();
    let titles: Vec<&str> =
        report["recordings"].as_array().expect("two").iter().filter_map(|r| r["title"].as_str()).collect();
    assert_eq!(titles, ["One", "Two"]);
    let alone = desk.run("compare narrow.toml wide.toml --log ramp.csv --reference v=v_ref --format json").is(0).json();
    let key = |report: &Value, key: &str| row(report, "wide")[key].clone();
    for what in ["rms", "p99", "max", "lag", "converged_after"] {
        assert_eq!(key(&report["recordings"][0], what), key(&alone, what), "{what}");
    }
    let page = desk.run("compare --table sub/table.toml --format markdown").is(0).out;
    assert!(page.starts_with("**One**\n") && page.contains("\n**Two**\n"), "{page}");
    desk.run("compare narrow.toml --table sub/table.toml").is(3).complains(&["--table"]);
    desk.write("sub/table.toml", &group.replace("log", "lgo"));
    desk.run("compare --table sub/table.toml").is(1).complains(&["sub/table.toml", "line 3", "lgo"]);
    desk.write("sub/table.toml", &group.replace("\"../narrow.toml\", \"../wide.toml\"", ""));
    desk.run("compare --table sub/table.toml").is(3).complains(&["no specification"]);
}
