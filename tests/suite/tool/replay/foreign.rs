//! Claim: recordings replay as other people's programs write them: units of time, stamps of the calendar, coarse clocks,
//! separators, decimal commas, words for what is missing, rows of units, headers in comments, columns without names.

use std::fmt::Write as _;

use super::{Desk, chain};

/// A ramp of 3 rad/s at 100 Hz, 60 rows, from the text of a row's time and what stands behind its sample.
fn ramp(header: &str, row: impl Fn(u32, f64) -> String) -> String {
    (0..60).fold(format!("{header}\n"), |mut text, k| {
        let _ = writeln!(text, "{}", row(k, f64::from(k) * 0.03));
        text
    })
}

/// Claim: the speed is exact and no row is lost, whatever the file looks like.
#[test]
fn as_others_write_them() {
    let desk = Desk::new("foreign");
    desk.write("axis.toml", &chain("", "[observer.window]\nwindow = 0.05", ""));
    let clock = |k: u32| format!("{:.6}", 0.01 * f64::from(k));
    let comma = |value: f64| format!("{value:.4}").replace('.', ",");
    let iso = |k: u32| format!("2026-01-01T23:59:59.{:06}+01:00", k * 10_000);
    for (what, arguments, text) in [
        ("ms by argument", "--time-unit ms", ramp("t,y", |k, y| format!("{},{y}", 10 * k))),
        ("us by argument", "--time-unit us --map t=stamp", ramp("stamp,y", |k, y| format!("{},{y}", 10_000 * k))),
        ("ms by name", "", ramp("Time (ms),y", |k, y| format!("{},{y}", 10 * k))),
        ("us by name", "", ramp("TimeUS,y", |k, y| format!("{},{y}", 10_000 * k))),
        ("ns by name", "--map t=stamp_ns", ramp("stamp_ns,y", |k, y| format!("{},{y}", 10_000_000 * u64::from(k)))),
        ("ms in a row of units", "", ramp("t,y,note\n[ms],rad,-", |k, y| format!("{},{y},a", 10 * k))),
        ("time for t", "", ramp("time,y", |k, y| format!("{},{y}", clock(k)))),
        ("calendar", "", ramp("t,y", |k, y| format!("{},{y}", iso(k)))),
        ("space", "", ramp("timestamp,y", |k, y| format!("2026-01-01 12:00:00.{:03},{y}", 10 * k))),
        ("coarse clock", "", ramp("t,y", |k, y| format!("{},{y}", clock(k / 2 * 2)))),
        ("packets", "", ramp("t,y", |k, y| format!("{},{y}", clock(k / 6 * 6)))),
        ("semicolons", "", ramp("t;y", |k, y| format!("{};{}", clock(k).replace('.', ","), comma(y)))),
        ("tabs", "", ramp("t\ty", |k, y| format!("{}\t{y}", clock(k)))),
        ("units and commas", "", ramp("Time;y\nms;rad", |k, y| format!("{};{}", 10 * k, comma(y)))),
        ("comment", "", ramp("# rig 3\n# t,y", |k, y| format!("{},{y}", clock(k)))),
        ("byte order mark", "", ramp("\u{feff}# t,y", |k, y| format!("{},{y}", clock(k)))),
        ("equal names", "", ramp(",t,y,alt,alt,", |k, y| format!("{k},{},{y},1,2,", clock(k)))),
        ("trailing comma", "", ramp("t,y", |k, y| format!("{},{y},", clock(k)))),
    ] {
        desk.write("log.csv", &text);
        let line = format!("run axis.toml --log log.csv {arguments} --out est.csv");
        let report = desk.json(&line);
        assert_eq!(
            (report["rows"].as_u64(), report["converged_rows"].as_u64()),
            (Some(60), Some(55)),
            "{what}: {report}"
        );
        let estimate = std::fs::read_to_string(desk.0.join("est.csv")).expect("the estimate");
        for row in estimate.lines().skip(6) {
            let speed: f64 = row.split(',').nth(2).and_then(|cell| cell.parse().ok()).expect("a speed");
            assert!((speed - 3.0).abs() < 1e-9, "{what}: {row}");
        }
    }
}

/// Claim: each word for a missing sample leaves out one sample, and nothing else does.
#[test]
fn words_for_missing() {
    let desk = Desk::new("words");
    desk.write("axis.toml", &chain("", "[observer.window]\nwindow = 0.05\nmissing = \"left-out\"", ""));
    for word in ["NULL", "N/A", "-", "nan", "", "none"] {
        let cell = |k: u32, y: f64| if k == 30 { word.to_owned() } else { y.to_string() };
        desk.write("log.csv", &ramp("t,y", |k, y| format!("{:.2},{}", 0.01 * f64::from(k), cell(k, y))));
        desk.fine("run axis.toml --log log.csv --out est.csv");
        let estimate = std::fs::read_to_string(desk.0.join("est.csv")).expect("the estimate");
        let coasted: Vec<&str> = estimate.lines().skip(30).take(3).filter_map(|row| row.split(',').nth(3)).collect();
        assert_eq!(coasted, ["0", "1", "0"], "{word}");
    }
    desk.write(
        "log.csv",
        &ramp("t,y", |k, y| {
            format!("{:.2},{}", 0.01 * f64::from(k), if k == 30 { "off".into() } else { y.to_string() })
        }),
    );
    desk.complains("run axis.toml --log log.csv", 1, &["log.csv:32:", "column `y`", "`off` is not a number"]);
}

/// Claim: where the unit of the time must be another one, the message says which; two columns of a name that is read are
/// told apart by nobody.
#[test]
fn what_cannot_be_told_is_said() {
    let desk = Desk::new("unit_hints");
    desk.write("axis.toml", &chain("", "[observer.window]\nwindow = 0.05", ""));
    for (factor, unit) in [(10_u64, "ms"), (10_000, "us"), (10_000_000, "ns")] {
        desk.write("log.csv", &ramp("t,y", |k, y| format!("{},{y}", factor * u64::from(k))));
        desk.complains("run axis.toml --log log.csv", 1, &[&format!("--time-unit {unit}")]);
    }
    desk.complains("run axis.toml --log log.csv --time-unit fortnights", 3, &["s, ms, us, ns, min, h"]);
    desk.write("log.csv", &ramp("t,y,y", |k, y| format!("{:.2},{y},{y}", 0.01 * f64::from(k))));
    desk.complains("run axis.toml --log log.csv", 1, &["columns 2 and 3 are both named `y`"]);
}

/// Claim: a reference and a measurement may have a factor, also in `compare`; a column that is called so is itself.
#[test]
fn factors() {
    let desk = Desk::new("factors");
    desk.write("axis.toml", &chain("", "[observer.window]\nwindow = 0.05", ""));
    let degrees = |y: f64| y.to_degrees();
    desk.write(
        "log.csv",
        &ramp("t,deg,counts,v*2", |k, y| format!("{:.2},{},1500,6", 0.01 * f64::from(k), degrees(y))),
    );
    let line = "axis.toml --log log.csv --map y=deg*pi/180 --reference v=counts*0.002";
    let largest = desk.json(&format!("run {line}"))["errors"]["v"]["max"].as_f64().expect("an error");
    assert!(largest < 1e-9, "{largest}");
    let report = desk.json(&format!("compare {line}"));
    let largest = report["states"][0]["specifications"][0]["max"].as_f64().expect("an error");
    assert!(largest < 1e-9, "{largest}");
    let itself = desk.json("run axis.toml --log log.csv --map y=deg*pi/180 --reference v=v*2");
    assert!((itself["errors"]["v"]["max"].as_f64().expect("an error") - 3.0).abs() < 1e-9, "{itself}");
}
