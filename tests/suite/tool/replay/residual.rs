//! Claim: what the samples are against what the estimates foretold of them tells a wrong model and a wrong noise, by how
//! much, for every method; against a reference, the share of rows beyond the bound is told.

use std::fmt::Write as _;

use serde_json::Value;

use super::{Desk, chain};
use crate::support::plant::Random;

/// An axis at 3 rad/s with white noise of this size, 2000 rows at 100 Hz.
fn noisy(size: f64) -> String {
    let mut random = Random::new(7);
    (0..2000).fold("t,y,v\n".into(), |mut text, k| {
        let t = f64::from(k) * 0.01;
        let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
        let _ = writeln!(text, "{t:.2},{},3", 3.0 * t + sign * size);
        text
    })
}

fn residual(report: &Value) -> &Value {
    &report["residuals"][0]
}

const OBSERVERS: [&str; 6] = [
    "[observer.window]\nwindow = 0.1",
    "[observer.window]\nwindow = 0.02",
    "[observer.single-delay]\nwindow = 0.1",
    "[observer.kalman]\nprocess_noise = [0, 1e-4]\nmeasurement_noise = [1e-4]",
    "[observer.luenberger]\npoles = [-5, -6]",
    "[observer.prescribed-time]\ntime = 0.5",
];

/// Claim: with noise of its bound's size at every sample the residual is once what it can be; with 2.3 times that, the
/// verdict says 2.3 times, whatever the method: its own gain from noise is allowed for.
#[test]
fn noise_that_is_larger_than_declared() {
    let desk = Desk::new("residual_noise");
    for observer in OBSERVERS {
        desk.write("axis.toml", &chain(", noise = 0.01", observer, ""));
        for (size, words) in
            [(0.01 / 3.0_f64.sqrt(), "explain the samples"), (0.023, "the model or the noise is wrong by 2.")]
        {
            desk.write("log.csv", &noisy(size));
            let report = desk.json("run axis.toml --log log.csv");
            let residual = residual(&report);
            let times = residual["times"].as_f64().expect("a number");
            // 2000 samples: a deviation of a few percent.
            assert!((times / (size / 0.01) - 1.0).abs() < 0.1, "{observer}: {report}");
            assert!(
                residual["verdict"].as_str().is_some_and(|verdict| verdict.contains(words)),
                "{observer}: {report}"
            );
        }
    }
    let text = desk.fine("run axis.toml --log log.csv");
    assert!(text.contains("residual of y: ") && text.contains("lag-1 correlation"), "{text}");
    let both = desk.fine("compare axis.toml --log log.csv --reference v=v");
    assert!(both.contains("axis: residual of y: ") && both.contains("wrong by 2."), "{both}");
}

/// Claim: a battery whose open-circuit voltage is another curve than the model's is told from the right one.
#[test]
fn a_wrong_open_circuit_curve() {
    let desk = Desk::new("residual_curve");
    desk.write(
        "cell.toml",
        "deadbeat = 1\nname = \"cell\"\n[states]\nsoc = { derivative = '-i/9000', initial = 0.9 }\n[inputs]\ni = { unit = \"A\" }\n\
         [outputs]\nv = { unit = \"V\", value = '3.2 + 0.9*soc - 0.02*i', noise = 0.005 }\n\
         [observer.kalman]\nprocess_noise = [3e-9]\nmeasurement_noise = [25e-6]\n\
         [target]\nsample_time = 1\nscalar = \"f64\"\n",
    );
    for (bend, words) in [(0.0, "explain the samples"), (0.15, "the model is wrong")] {
        let mut random = Random::new(11);
        let text = (0..4000).fold("t,v,i,soc\n".to_owned(), |mut text, k| {
            let soc = 0.95 - 2.0 / 9000.0 * f64::from(k);
            let voltage = 3.2 + 0.9 * soc + bend * (std::f64::consts::TAU * soc).sin() - 0.04;
            let _ = writeln!(text, "{k},{},2,{soc}", voltage + random.within(-0.005, 0.005));
            text
        });
        desk.write("log.csv", &text);
        let report = desk.json("run cell.toml --log log.csv");
        let verdict = residual(&report)["verdict"].as_str().expect("a verdict").to_owned();
        assert!(verdict.contains(words), "{report}");
    }
}

/// Claim: the share of rows beyond the bound is counted where the status is converged: none of a right model, all of a
/// reference that is off by more.
#[test]
fn rows_beyond_the_bound() {
    let desk = Desk::new("residual_beyond");
    desk.write("axis.toml", &chain(", noise = 0.01", "[observer.window]\nwindow = 0.1", ""));
    desk.write("log.csv", &noisy(0.01).replace(",3\n", ",3,13\n").replacen("t,y,v", "t,y,v,wrong", 1));
    let beyond = |arguments: &str| {
        let report = desk.json(&format!("run axis.toml --log log.csv {arguments}"));
        report["errors"]["v"]["beyond_bound"].as_f64().expect("a share")
    };
    assert_eq!((beyond(""), beyond("--reference v=wrong")), (0.0, 1.0));
    let text = desk.fine("run axis.toml --log log.csv --reference v=wrong");
    assert!(text.contains("v: 100 % of 1990 rows beyond the bound"), "{text}");
}
