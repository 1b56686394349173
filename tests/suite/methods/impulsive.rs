//! Claim: the impulsive observer is 001's, corrected: its constants are the reference's to the last bit, and with
//! them the paper's equations give the reference's trajectories. The printed step converges by the printed call for
//! every observable linear plant, and from reset to reset by the printed factor where some calls are not measured.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::depth::trials;
use crate::support::{impulsive, plant};

use std::cell::Cell;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::promise::Convergence;
use deadbeat_codegen::{Generated, Generator};
use impulsive::{Linear, period_map, radius, rounding};
use plant::{advance, designed, matrix};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use serde_json::Value;

/// 001's example (64) with nu = 1 and L = -1.
fn pendulum(keys: &str, sample_time: f64) -> Generated {
    designed(&format!(
        "deadbeat = 1\nname = 'p'\n[states]\nx1 = {{ derivative = 'x2' }}\nx2 = {{ derivative = '-sin(x1)' }}\n[outputs]\n\
         x1 = {{ value = 'x1' }}\n[observer.impulsive]\nwindow = 1\nL = [[-1]]\n{keys}\n[target]\n\
         sample_time = {sample_time}\nscalar = 'f64'\n"
    ))
}

fn text_of(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/golden/{name}.json", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The first number behind a key, rounded by the standard library; that of JSON may be one unit off.
fn number(text: &str, key: &str) -> f64 {
    let behind = text.split_once(&format!("\"{key}\":")).unwrap_or_else(|| panic!("no {key}")).1;
    let behind = behind.trim_start_matches(|c: char| c.is_whitespace() || c == '[');
    behind.split(|c: char| !(c.is_ascii_digit() || "+-.e".contains(c))).next().unwrap().parse().unwrap()
}

fn scalar(generated: &Generated, letter: &str) -> f64 {
    let rows = matrix(generated, letter);
    assert_eq!((rows.len(), rows[0].len()), (1, 1), "{letter}");
    rows[0][0]
}

/// Functions of e, which is all that the example needs, to 40 digits: 17 do not always tell the nearest double.
const FORTY: [(&str, &str); 7] = [
    ("E", "-1.718281828459045235360287471352662497757"),
    ("Einv", "-0.5819767068693264243850020051090115585468"),
    ("R1", "-0.5819767068693264243850020051090115585468"),
    ("R2", "1.581976706869326424385002005109011558547"),
    ("Q", "0.3678794411714423215955237701614608674458"),
    ("beta", "4.745930120607979273155006015327034675641"),
    ("gamma", "10.49186024121595854631001203065406935128"),
];

/// Every constant of the example is the nearest double to the true one, and the reference's 17 digits are those of
/// that double or, where they were cut close to the middle between two, of its neighbour.
#[test]
fn the_constants_are_the_reference() {
    let golden = text_of("pendulum_001");
    let continuous = pendulum("form = 'continuous'\nmeasured_every = 5", 0.01);
    let constants = golden.split_once("\"constants\"").unwrap().1;
    for (ours, theirs) in [
        ("H", "H"),
        ("G", "G"),
        ("E", "E"),
        ("Einv", "Einv"),
        ("R1", "R1"),
        ("R2", "R2"),
        ("P", "exp_F22_nu"),
        ("Q", "exp_H_nu"),
        ("X", "inverse_free_X"),
    ] {
        let expected = number(constants, theirs);
        assert!(scalar(&continuous, ours).to_bits().abs_diff(expected.to_bits()) <= 1, "{ours}: {expected}");
    }
    for (letter, digits) in FORTY {
        let expected: f64 = digits.parse().unwrap();
        assert_eq!(scalar(&continuous, letter).to_bits(), expected.to_bits(), "{letter}: {expected}");
    }
    for (ours, theirs) in [("beta", "beta"), ("gamma", "gamma_corrected")] {
        let expected = number(&golden, theirs);
        assert!(scalar(&continuous, ours).to_bits().abs_diff(expected.to_bits()) <= 1, "{ours}: {expected}");
    }
    for letter in ["F11", "F12", "F21", "F22"] {
        assert_eq!(scalar(&continuous, letter).to_bits(), number(&golden, letter).to_bits());
    }
}

/// R1 + R2 = I and R1 P + R2 Q = 0, for both forms: the reset keeps what is right and takes away what is common.
#[test]
fn the_reset_keeps_what_is_right_and_takes_away_what_is_common() {
    for keys in ["", "form = 'continuous'", "form = 'continuous'\nhold = 'third'"] {
        let design = pendulum(keys, 0.01);
        let [r1, r2, p, q] = ["R1", "R2", "P", "Q"].map(|letter| scalar(&design, letter));
        // Each is rounded once.
        assert!((r1 + r2 - 1.0).abs() <= f64::EPSILON * r2.abs(), "{keys}: {r1} + {r2}");
        assert!((r1 * p + r2 * q).abs() <= 2.0 * f64::EPSILON * (r1 * p).abs(), "{keys}");
    }
}

/// The paper's equations (9) and (23), corrected, with the design's constants: state r, `x_r`, z1, z2, w.
struct Paper {
    h: f64,
    g: f64,
    r1: f64,
    r2: f64,
    e_inverse: f64,
    l: f64,
}

impl Paper {
    fn new() -> Self {
        let design = pendulum("form = 'continuous'", 0.05);
        let [h, g, r1, r2, e_inverse, l] = ["H", "G", "R1", "R2", "Einv", "L"].map(|letter| scalar(&design, letter));
        Self { h, g, r1, r2, e_inverse, l }
    }

    /// The reset with `- R2 L y_(k+1)`; (68) prints the other sign.
    fn reset(&self, [z1, z2]: [f64; 2], now: f64, before: f64) -> f64 {
        self.r1 * z1 + self.r2 * z2 - self.r2 * self.l * now - self.e_inverse * self.l * before
    }

    /// The right-hand side; `fed` tells whether w stands for the output.
    fn change(&self, x: &[f64], fed: bool) -> Vec<f64> {
        let output = if fed { x[4] } else { x[0] };
        vec![x[1], -x[0].sin(), -output.sin(), self.h * x[3] + self.g * output - output.sin(), x[2]]
    }
}

/// Integrated with an extrapolation method of order 16, the corrected equations give the reference's trajectories.
#[test]
fn the_trajectories_are_the_reference() {
    let golden: Value = serde_json::from_str(&text_of("traj_pendulum_001")).unwrap();
    let paper = Paper::new();
    let start = [1.0, 0.5];
    for (name, fed, per_second) in
        [("thm1_continuous", false, 20), ("thm2_mu_0p05", true, 20), ("thm2_mu_0p01", true, 100)]
    {
        let records = golden[name].as_array().unwrap();
        let step = 1.0 / f64::from(per_second);
        let mut x = vec![start[0], start[1], 0.0, 0.0, start[0]];
        let mut at_reset = x[0];
        let mut compared = 0;
        let mut worst = 0.0_f64;
        for tick in 1..=8 * per_second {
            let rhs = |_: f64, x: &[f64]| paper.change(x, fed);
            x = advance(&rhs, 0.0, step, &x);
            let minus = [x[2], x[3]];
            if tick % per_second == 0 {
                let z = paper.reset(minus, x[0], at_reset);
                (x[2], x[3], at_reset) = (z, z, x[0]);
            }
            x[4] = x[0];
            let Some(record) =
                records.iter().find(|r| (r["t"].as_f64().unwrap() - f64::from(tick) * step).abs() < step / 4.0)
            else {
                continue;
            };
            compared += 1;
            let pairs = [
                ("r", x[0]),
                ("x_r", x[1]),
                ("z1", x[2]),
                ("z2", x[3]),
                ("z1_minus", minus[0]),
                ("z2_minus", minus[1]),
            ];
            for (key, ours) in pairs {
                let theirs = record[key].as_f64().unwrap();
                worst = worst.max((ours - theirs).abs());
                // Of the scale 1; both sides carry some hundred rounding errors of 1e-16.
                assert!((ours - theirs).abs() <= 1e-13, "{name}, {key} at {}: {ours}, {theirs}", record["t"]);
            }
        }
        println!("{name}: {compared} records, within {worst:.1e}");
        assert_eq!(compared, records.len() - 1);
    }
}

/// An output that stays is a fixed point of every reset: `x_r = 0` goes in and comes out. With the printed sign of
/// (68) it would not.
#[test]
fn a_constant_output_is_a_fixed_point_of_the_reset() {
    let paper = Paper::new();
    let (y, nu) = (0.7_f64, 1.0_f64);
    // z1' = 0 and z2' = H z2 + G y, from 0, without the nonlinear term.
    let z2 = ((paper.h * nu).exp() - 1.0) / paper.h * paper.g * y;
    assert!(paper.reset([0.0, z2], y, y).abs() < 4.0 * f64::EPSILON);
    let printed = paper.r2 * z2 + paper.r2 * paper.l * y - paper.e_inverse * paper.l * y;
    assert!(printed.abs() > 1.0, "{printed}");

    // The step: an oscillator at rest away from 0, several outputs' worth of resets later.
    for keys in ["", "form = 'continuous'", "form = 'continuous'\nhold = 'third'", "measured_every = 2"] {
        let text = format!(
            "deadbeat = 1\nname = 'rest'\n[states]\nx = {{ derivative = 'v' }}\nv = {{ derivative = '-2*(x - 3) - v', initial = 1 }}\n\
             [outputs]\nx = {{ value = 'x' }}\n[observer.impulsive]\nwindow = 0.4\n{keys}\n[target]\nsample_time = 0.02\nscalar = 'f64'\n"
        );
        let generated = designed(&text);
        let calls = 4 * generated.design.valid_from_step;
        let run = plant::Run {
            states: vec![vec![3.0, 0.0]; calls],
            measurements: vec![vec![3.0]; calls],
            inputs: vec![Vec::new(); calls],
        };
        let answers = run.through(&generated);
        let errors = answers.errors(&run, generated.design.valid_from_step..calls);
        // Rounding errors of 3, through a reset whose X is below 100; or what a contraction to 1e-6 has left of 1.
        let left = if keys.contains("measured") { 1e-6 } else { 1e-12 };
        assert!(errors[1] < left, "{keys}: {errors:?}");
    }
}

/// Linear plants that are tried.
fn plants() -> u32 {
    trials(60, 200)
}

#[test]
fn every_observable_linear_plant_is_estimated_exactly() {
    let (refused, digits, worst) = (Cell::new(0), Cell::new([0; 4]), Cell::new(0.0_f64));
    let config = Config { cases: plants(), failure_persistence: None, ..Config::default() };
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let shapes = (2_usize..=6, 1_usize..=3, 0_usize..=2, proptest::bool::ANY, 0_usize..=12, 0_u64..1 << 40);
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |shape| {
        let linear = Linear::new(shape);
        let text = linear.text("");
        let generated = match Generator::new(&text, "random.toml").design() {
            Ok(generated) => generated,
            // States that no output shows, outputs that repeat each other, an L that tells nothing apart.
            Err(report)
                if report.diagnostics.iter().all(|d| [codes::UNOBSERVABLE, codes::METHOD_CANNOT].contains(&d.code)) =>
            {
                refused.set(refused.get() + 1);
                return Ok(());
            }
            Err(report) => return Err(TestCaseError::fail(format!("{}\n{text}", report.render(false)))),
        };
        let fail = |why: String| Err(TestCaseError::fail(format!("{why}\n{text}")));
        let steps = generated.design.valid_from_step;
        if (steps, generated.design.convergence) != (linear.steps, Convergence::Finite) {
            return fail(format!("promised {steps}"));
        }
        let (run, step) = linear.run(3 * steps + 5, shape.5);
        let answers = run.through(&generated);
        for (call, status) in answers.statuses.iter().enumerate() {
            if *status != if call < steps { Status::Converging } else { Status::Converged } {
                return fail(format!("call {call}: {status:?}"));
            }
        }
        let bounds = rounding(&generated, &run, &step);
        let errors = answers.errors(&run, steps..run.states.len());
        for ((error, bound), size) in errors.iter().zip(&bounds).zip(run.sizes(0)) {
            if error > bound {
                return fail(format!("errors {errors:?}, bounds {bounds:?}"));
            }
            let mut count = digits.get();
            let relative = error / size.max(1e-3);
            count[[1e-13, 1e-11, 1e-9].iter().position(|limit| relative < *limit).unwrap_or(3)] += 1;
            digits.set(count);
            worst.set(worst.get().max(if *bound > 0.0 { error / bound } else { 0.0 }));
        }
        Ok(())
    });
    outcome.unwrap_or_else(|why| panic!("{why}"));
    let ([a, b, c, d], refused, plants) = (digits.get(), refused.get(), plants());
    println!(
        "{refused} of {plants} refused; errors below 1e-13: {a}, 1e-11: {b}, 1e-9: {c}, above: {d}; largest error / bound {:.2e}",
        worst.get()
    );
    assert!(refused * 6 <= plants, "{refused} of {plants} refused");
    // The bound adds up the worst of everything; what happens is far smaller, but for plants whose gain from noise
    // is above 1e5.
    assert!(d * 20 <= a + b + c + d, "{d} states are lost in rounding");
}

/// Where calls are not measured, the error of z1 goes from reset to reset by a matrix whose spectral radius is the
/// printed one, in both forms.
#[test]
fn the_measured_contraction_has_the_printed_radius() {
    let mut seen = [0, 0];
    for seed in 0..40 {
        let mut linear = Linear::new((2 + seed as usize % 3, 1, 0, seed % 4 == 3, 6 + seed as usize % 5, seed));
        let every = 2 + seed as usize % 2;
        linear.steps = linear.steps.next_multiple_of(every);
        for (place, form) in ["exact", "continuous"].into_iter().enumerate() {
            let keys = format!("measured_every = {every}\nform = '{form}'");
            let Some((generated, map)) = period_map(&linear, &keys) else { continue };
            let Convergence::Geometric { radius: printed, period } = generated.design.convergence else { continue };
            assert_eq!(period, linear.steps);
            let found = radius(&map);
            println!("{form} seed {seed}: printed {printed:.9}, found {found:.9}");
            // The runs are exact to rounding, which a defective map may bring out with its root.
            assert!(
                (printed - found).abs() <= 1e-7 * map.abs().max().max(1.0),
                "{form}, seed {seed}: {printed} {found}"
            );
            seen[place] += 1;
        }
    }
    assert!(seen.iter().all(|seen| *seen >= 12), "{seen:?} plants");
}
