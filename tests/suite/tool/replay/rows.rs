//! Claim: a row belongs to the call that is nearest to its own time; what the time leaves out is missing, so that
//! files of measured rows replay through the methods that take them; what no specification explains is refused, with the
//! mean of the whole recording.

use std::fmt::Write as _;

use serde_json::Value;

use super::{Desk, WINDOW, chain};

/// A ramp of 3 rad/s at these times, s.
fn ramp(times: impl IntoIterator<Item = f64>) -> String {
    times.into_iter().fold("t,y,v\n".into(), |mut text, t| {
        let _ = writeln!(text, "{t:.6},{},3", 3.0 * t);
        text
    })
}

fn largest(report: &Value, state: &str) -> f64 {
    report["errors"][state]["max"].as_f64().unwrap_or_else(|| panic!("an error of {state}: {report}"))
}

/// Claim: 14 rows early and one late, with the sample time as their mean, are the samples one by one; the speed is right
/// to what half a sample of lateness does to a window of 41.
#[test]
fn a_pause_that_is_made_up_for() {
    let desk = Desk::new("hiccup");
    let spec = chain("", "[observer.window]\nwindow = '40*2.7e-3'", "").replace("time = 0.01", "time = 2.7e-3");
    desk.write("axis.toml", &spec);
    let mut times = vec![0.0];
    for k in 0..300 {
        times.push(times[k] + if k % 15 == 14 { 4.1e-3 } else { 2.6e-3 });
    }
    desk.write("log.csv", &ramp(times));
    let report = desk.json("run axis.toml --log log.csv");
    assert_eq!((report["rows"].as_u64(), report["converged_rows"].as_u64()), (Some(301), Some(261)));
    // A slope over T is off by at most 3/T times what the samples are: 3 rad/s times half of 2.7 ms.
    assert!(largest(&report, "v") < 3.0 / 0.108 * 3.0 * 1.35e-3, "{report}");
    let text = desk.fine("run axis.toml --log log.csv");
    assert!(!text.contains("leaves out") && text.contains("(RMS) off the times of their calls"), "{text}");
}

/// Claim: rows at irregular times, and rows of every second call only, are exact where the method takes them.
#[test]
fn rows_that_were_measured_only() {
    let desk = Desk::new("measured_only");
    let gaps = [1, 2, 3, 2, 1, 3, 1, 1, 2];
    let irregular: Vec<f64> = (0..200)
        .scan(0, |call, k: usize| {
            let now = *call;
            *call += gaps[k % gaps.len()];
            Some(f64::from(now) * 0.01)
        })
        .collect();
    let second: Vec<f64> = (0..200).map(|k| f64::from(k) * 0.02).collect();
    let intermittent = "[observer.single-delay]\nintermittent = { min = 0.01, max = 0.03 }\nwindow = 0.08";
    let left_out = "[observer.window]\nwindow = 0.08\nmissing = \"left-out\"";
    for (times, output, observer) in [
        (&irregular, "", intermittent),
        (&irregular, "", left_out),
        (&second, "", intermittent),
        (&second, "", left_out),
        (&second, ", every = 2", "[observer.window]\nwindow = 0.08"),
        (&second, "", "[observer.impulsive]\nwindow = 0.08\nmeasured_every = 2"),
        (&second, ", every = 2", "[observer.luenberger]\npoles = [-40, -50]"),
    ] {
        desk.write("axis.toml", &chain(output, observer, ""));
        desk.write("log.csv", &ramp(times.iter().copied()));
        let report = desk.json("run axis.toml --log log.csv");
        let rows = report["converged_rows"].as_u64().expect("rows");
        // Where the initial error dies out, up to 1e-6 of it in every state is left.
        let exact = observer.contains("window]") || observer.contains("single-delay");
        let settled = if exact { 1e-9 } else { 1e-4 };
        assert!(rows > 100 && largest(&report, "v") < settled, "{observer}: {report}");
    }
    // A plain window never has its samples.
    desk.write("axis.toml", &chain("", WINDOW, ""));
    desk.write("log.csv", &ramp(second));
    let words =
        ["no estimate has converged", "rows are 0.020000 s apart", "sample time is 0.01 s", "left-out", "every"];
    desk.complains("run axis.toml --log log.csv", 1, &words);
}

/// Claim: what is printed as a mean is that of the whole recording, whose first part may be at the right rate.
#[test]
fn the_mean_is_the_recordings() {
    let desk = Desk::new("mean");
    desk.write("axis.toml", &chain("", WINDOW, ""));
    let mut times = vec![0.0];
    for k in 0..900 {
        times.push(times[k] + if k < 300 { 0.01 } else { 0.0137 });
    }
    desk.write("log.csv", &ramp(times));
    // (300*10 + 600*13.7)/900 ms
    desk.complains("run axis.toml --log log.csv", 1, &["rows are 0.012467 s apart in the mean of the recording"]);
}

/// Claim: a row that is some time off its call has a sample of another age there, so that the speed is exact.
#[test]
fn ages_are_those_of_the_calls() {
    let desk = Desk::new("call_ages");
    desk.write("axis.toml", &chain(", age = \"measured\", age_max = 0.02", WINDOW, ""));
    let mut text = "t,y,stamp,y_age,v\n".to_owned();
    for k in 0..300 {
        let t = f64::from(k) * 0.01 + 0.003 * f64::from((k * 7 + 2) % 5 - 2) / 2.0;
        let age = 0.005 + 1e-4 * f64::from(k % 30);
        let _ = writeln!(text, "{t:.6},{},{},{age},3", 3.0 * (t - age), t - age);
    }
    desk.write("log.csv", &text);
    for line in ["--age y=stamp", ""] {
        let report = desk.json(&format!("run axis.toml --log log.csv {line}"));
        assert!(report["converged_rows"].as_u64() > Some(250), "{report}");
        // Times of up to 3 s with six decimals, over a window of 0.05 s.
        assert!(largest(&report, "v") < 3.0 * 1e-6 / 0.05, "{line}: {report}");
    }
}
