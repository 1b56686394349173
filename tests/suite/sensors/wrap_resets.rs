//! Claim: two copies that are reset, a regression, and windows with samples at irregular times estimate from folded angles what they estimate from unfolded ones,
//! also through gaps; single precision loses nothing after any number of turns; a counter gives the same bits wherever it
//! stands, whatever its turn; and a gate makes an outlier a missing sample, and follows a true jump.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "counts of calls and samples are small"
)]

use crate::support::plant;

use std::f64::consts::TAU;

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::{designed_in, edited};

const H: f64 = 5e-3;

/// What moves, and who observes it.
const PLANTS: [(&str, &str, &str); 9] = [
    ("0", "", "[observer.impulsive]\nwindow = 0.05"),
    ("-19.6*sin(q) - 0.5*dq", "", "[observer.impulsive]\nwindow = 0.04"),
    ("-19.6*sin(q) - 0.5*dq", "", "[observer.impulsive]\nwindow = 0.08\nmeasured_every = 2\nunproved = 'accept'"),
    ("load", "[unknowns]\nload = {}\n", "[observer.parameters]\nwindow = 0.2"),
    ("load - 19.6*sin(q)", "[unknowns]\nload = {}\n", "[observer.parameters]\nwindow = 0.2"),
    ("load", "[unknowns]\nload = {}\n", "[observer.parameters]\nwindow = 0.2\nform = 'paper'"),
    ("0", "", "[observer.single-delay]\nwindow = 0.05\nintermittent = { min = 0.005, max = 0.02 }"),
    (
        "-19.6*sin(q) - 0.5*dq",
        "",
        "[observer.single-delay]\nwindow = 0.05\nintermittent = { min = 0.005, max = 0.02 }\nunproved = 'accept'",
    ),
    ("0", "", "[observer.window]\nwindow = 0.05\nmissing = 'left-out'"),
];

fn specification((law, unknowns, observer): (&str, &str, &str)) -> String {
    format!(
        "deadbeat = 1\nname = 'p'\n[states]\nq = {{ derivative = 'dq' }}\ndq = {{ derivative = '{law}' }}\n[outputs]\n\
         y = {{ value = 'q', wrap = '2*pi' }}\n{unknowns}{observer}\n[target]\nsample_time = {H}\n"
    )
}

/// q of the swing-up, over several turns.
fn swing() -> Vec<f64> {
    let path = format!("{}/specs/data/ak80_swing_200hz.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let column = |line: &str| line.split(',').nth(1).unwrap().parse().unwrap();
    text.lines().skip(1).map(column).collect()
}

fn folded(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

fn through(generated: &Generated, samples: impl Iterator<Item = f64>) -> Vec<Answer> {
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    samples
        .map(|sample| {
            let status = interpreter.step(&[sample], &[], &mut estimate);
            (estimate.clone(), status)
        })
        .collect()
}

/// An estimate and its status.
type Answer = (Vec<f64>, Status);

/// Per state, how far two runs are apart where both have converged, and the largest estimate; angles but for turns.
fn apart(a: &[Answer], b: &[Answer]) -> Vec<(f64, f64)> {
    let both = || a.iter().zip(b).filter(|(a, b)| a.1 == Status::Converged && b.1 == Status::Converged);
    assert!(both().count() > a.len() / 4);
    let of = |i: usize| {
        let off = |(a, b): (&Answer, &Answer)| {
            if i == 0 { folded(a.0[0] - b.0[0]).abs() } else { (a.0[i] - b.0[i]).abs() }
        };
        (both().map(off).fold(0.0, f64::max), both().map(|(_, b)| b.0[i].abs()).fold(1.0, f64::max))
    };
    (0..b[0].0.len()).map(of).collect()
}

/// Folded or not, with the key or without it, with samples missing or not.
#[test]
fn folded_angles_give_the_estimates_of_unfolded_ones() {
    let angles = swing();
    assert!(angles.iter().fold(0.0_f64, |most, q| most.max(q.abs())) > 2.0 * TAU);
    for plant in PLANTS {
        let text = specification(plant);
        let [wrapping, plain] =
            [text.clone(), edited(&text, ", wrap = '2*pi'", "")].map(|text| designed_in(&text, Scalar::F64));
        for gaps in [false, true] {
            let lost = |k: usize| gaps && (7_919 * k) % 1_000 >= 985;
            let run = |generated: &Generated, seen: fn(f64) -> f64| {
                let samples = angles.iter().enumerate();
                through(generated, samples.map(|(k, q)| if lost(k) { f64::NAN } else { seen(*q) }))
            };
            let reference = run(&plain, |q| q);
            for seen in [folded, |q: f64| q] {
                let answers = run(&wrapping, seen);
                for (k, (answer, expected)) in answers.iter().zip(&reference).enumerate() {
                    assert_eq!(answer.1, expected.1, "{plant:?}, gaps {gaps}, call {k}");
                }
                for (i, (off, largest)) in apart(&answers, &reference).into_iter().enumerate() {
                    // Angles up to 16 rad are rounded to 2e-15; the rates are a thousand times, a force a million times
                    // that.
                    assert!(off <= 1e-8 * largest, "{plant:?}, gaps {gaps}, state {i}: {off:e} of {largest:e}");
                }
            }
        }
    }
}

/// Thirty thousand radians away, on the same single-precision samples: the estimates are as near to double precision as
/// those of the first turn.
#[test]
fn turns_cost_no_digits_in_single_precision() {
    for plant in PLANTS {
        let [single, double] = [Scalar::F32, Scalar::F64].map(|scalar| designed_in(&specification(plant), scalar));
        let off = |samples: &[f64]| {
            let [single, double] = [&single, &double].map(|it| through(it, samples.iter().copied()));
            apart(&single, &double)
        };
        // Those samples have the grid of singles there, 2e-3 rad: near zero they are exact as well.
        let far: Vec<f64> = swing().iter().map(|q| f64::from((q + 30_000.0) as f32)).collect();
        let near: Vec<f64> = far.iter().map(|q| folded(*q)).collect();
        for (i, ((far, largest), (near, _))) in off(&far).into_iter().zip(off(&near)).enumerate() {
            println!("{plant:?}, state {i}: {far:e} far, {near:e} near, of {largest:e}");
            assert!(far <= 4.0 * near + 1e-6 * largest, "{plant:?}, state {i}: {far:e} far, {near:e} near");
        }
    }
}

/// Wherever it stands, also across its overflow; and the angle is that of the counts.
#[test]
fn counters_of_any_turn() {
    for plant in PLANTS {
        for (turn, sample) in [(2_156, "i32"), (10_000, "u32"), (40_000, "i32"), (2_156, "u16")] {
            let sensor = format!("wrap = '2*pi', quantum = '2*pi/{turn}'");
            let text = specification(plant);
            let counted = edited(&text, "wrap = '2*pi'", &format!("{sensor}, sample = '{sample}'"));
            let generated = designed_in(&counted, Scalar::F32);
            let count = TAU / f64::from(turn);
            let counts: Vec<i64> = swing().iter().take(900).map(|q| (q / count).round() as i64).collect();
            let from = |start: i64| through(&generated, counts.iter().map(|n| shown(n + start, sample)));
            let turns = |start: i64| start - start.rem_euclid(i64::from(turn));
            let reference = from(turns(1 << 15));
            let range = if sample.ends_with("32") { 1_i64 << 32 } else { 1 << 16 };
            let overflow = if sample.starts_with('u') { range } else { range / 2 };
            for start in [turns(overflow - 1), turns(range / 4)] {
                assert!(from(start) == reference, "{counted}\nfrom {start}");
            }
            let plain = designed_in(&edited(&text, "wrap = '2*pi'", &sensor), Scalar::F64);
            let angles = through(&plain, counts.iter().map(|n| folded(*n as f64 * count)));
            let (off, _) = apart(&reference, &angles)[0];
            assert!(off <= count, "{counted}\n{off:e} of {count:e}");
        }
    }
}

/// What a counter of so many bits shows, as a number.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "that is what counters do")]
fn shown(count: i64, sample: &str) -> f64 {
    match sample {
        "u16" => f64::from(count as u16),
        "i32" => f64::from(count as i32),
        _ => f64::from(count as u32),
    }
}

/// The copies behind a gate: after convergence an outlier gives the bits of a missing sample.
#[test]
fn outliers_are_missing_samples() {
    let motion = |k: usize| 0.4 * (3.0 * H * k as f64).sin();
    let outlying = |k: usize| k > 300 && k.is_multiple_of(37);
    for plant in [PLANTS[0], PLANTS[1], PLANTS[6], PLANTS[7], PLANTS[8]] {
        for scalar in [Scalar::F32, Scalar::F64] {
            let gated = edited(&specification(plant), "wrap = '2*pi'", "gate = 0.2");
            let generated = designed_in(&gated, scalar);
            let with =
                |bad: f64| through(&generated, (0..800).map(|k| motion(k) + if outlying(k) { bad } else { 0.0 }));
            let [wrong, missing] = [1.5, f64::NAN].map(with);
            assert!(wrong == missing, "{plant:?} {scalar}");
            assert!(wrong.iter().skip(300).all(|(_, status)| *status != Status::Converging));
        }
    }
}

/// A jump of the plant is rejected so many times, then believed: N calls later the copies have converged upon it.
#[test]
fn a_true_jump_is_followed() {
    let limit = 6;
    for scalar in [Scalar::F32, Scalar::F64] {
        let gated = edited(&specification(PLANTS[0]), "wrap = '2*pi'", &format!("gate = 0.2, gate_limit = {limit}"));
        let generated = designed_in(&gated, scalar);
        let (jump, calls) = (100, generated.design.window_steps);
        let place = |k: usize| 0.5 * H * k as f64 + if k < jump { 0.0 } else { 1.0 };
        let answers = through(&generated, (0..200).map(place));
        for (k, (x, status)) in answers.iter().enumerate().skip(calls) {
            let rejects = (jump..jump + limit - 1).contains(&k);
            let starts = (jump + limit - 1..jump + limit - 1 + calls).contains(&k);
            let expected = [Status::Converged, Status::Coasting, Status::Converging];
            assert_eq!(*status, expected[usize::from(rejects) + 2 * usize::from(starts)], "{scalar}, call {k}");
            // Places of order 1 and gains of the reset; rounding of a single, times a hundred.
            let rounding = if scalar == Scalar::F32 { 1e-4 } else { 1e-11 };
            let off = (x[0] - place(k)).abs().max((x[1] - 0.5).abs());
            assert!(*status != Status::Converged || off <= rounding, "{scalar}, call {k}: {x:?}");
        }
    }
}
