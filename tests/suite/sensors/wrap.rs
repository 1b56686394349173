//! Claim: an angle that wraps gives the estimate of the angle that does not. A recording folded into one turn, with
//! thirty crossings and with gaps, gives the rates of the recording itself, to rounding; after thousands of turns in
//! single precision, too; a plant that feels the angle goes round as if nothing happened; standing still is a rate of
//! exactly zero; and a counter gives the same bits wherever it stands, across the overflow of 16 and of 32 bits.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls, and counters that overflow on purpose"
)]

use crate::support::plant;

use std::f64::consts::{PI, TAU};

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::{Hold, Truth, corpus, designed, designed_in, edited};

/// q and `dq_ref` by row.
fn swing() -> Vec<(f64, f64)> {
    let path = format!("{}/specs/data/ak80_swing_200hz.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,q,dq_ref,tau"));
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        (cells[1], cells[2])
    };
    lines.map(row).collect()
}

/// Within half a turn of zero.
fn folded(q: f64) -> f64 {
    q - TAU * (q / TAU).round()
}

/// Five turns within a window of 131 samples: what is folded are steps from sample to sample, not the way across the
/// window.
#[test]
fn several_turns_within_a_window() {
    let text = edited(&corpus("hand_guided"), "value = 'q'", "value = 'q', wrap = '2*pi'");
    let generated = designed(&text);
    let steps = generated.design.window_steps;
    let rate = 10.0 * PI / (steps as f64 * 1e-3);
    let motion = |k: usize| rate * k as f64 * 1e-3 + (k as f64 * 1e-3).powi(2);
    let answers = fed(&generated, (0..3 * steps).map(|k| folded(motion(k))));
    for (k, (estimate, status)) in answers.iter().enumerate().skip(generated.design.valid_from_step) {
        assert_eq!(*status, Status::Converged, "call {k}");
        let expected = [folded(motion(k)), rate + 2.0 * k as f64 * 1e-3, 2.0];
        for (i, (ours, truth)) in estimate.iter().zip(expected).enumerate() {
            let error = if i == 0 { folded(ours - truth) } else { ours - truth };
            // Samples of half a turn, rounded; their sums over the window grow to five turns, rounded at each of the
            // steps; times the gain from noise.
            let bound =
                4.0 * steps as f64 * f64::EPSILON * 10.0 * PI * generated.design.certificate.noise_gain_l1[i][0];
            assert!(error.abs() <= bound, "call {k}, state {i}: {error:e} above {bound:e}");
        }
    }
}

/// Every field of an estimate, and its status.
type Answer = (Vec<f64>, Status);

/// The answers of a step without inputs.
fn fed(generated: &Generated, samples: impl Iterator<Item = f64>) -> Vec<Answer> {
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    samples
        .map(|sample| {
            let status = interpreter.step(&[sample], &[], &mut estimate);
            (estimate.clone(), status)
        })
        .collect()
}

/// The plain chain and the one that wraps, over the whole recording: two steps and twenty, two states and three.
fn specifications() -> Vec<(String, String, usize)> {
    let two = corpus("swing_up");
    let longer = edited(&two, "window = 0.01", "window = 0.1");
    let dq = "dq = { unit = \"rad/s\", derivative = '0' }";
    let three = edited(&longer, dq, "dq = { unit = \"rad/s\", derivative = 'd2q' }\nd2q = { derivative = '0' }");
    let specification = |text: String, n: usize| {
        let plain = edited(&text, ", wrap = '2*pi'", "");
        (text, plain, n)
    };
    vec![specification(two, 2), specification(longer, 2), specification(three, 3)]
}

/// Folded or not, with the key or without it: the same rates, the same angle but for turns; also through gaps.
#[test]
fn a_folded_recording_is_the_recording() {
    let rows = swing();
    let crossings = rows.windows(2).filter(|pair| (folded(pair[0].0) - folded(pair[1].0)).abs() > PI).count();
    assert_eq!(crossings, 30);
    let lost = |k: usize| (7_919 * k) % 1_000 >= 950;
    for (text, plain, n) in specifications() {
        let [wrapping, plain] = [&text, &plain].map(|text| designed(text));
        for gaps in [false, true] {
            let sample = |k: usize, q: f64| if gaps && lost(k) { f64::NAN } else { q };
            let with = |generated: &Generated, folds: bool| {
                let rows = rows.iter().enumerate();
                fed(generated, rows.map(|(k, (q, _))| sample(k, if folds { folded(*q) } else { *q })))
            };
            let reference = with(&plain, false);
            let scale: Vec<f64> =
                (0..n).map(|i| reference.iter().map(|(x, _)| x[i].abs()).fold(0.0, f64::max)).collect();
            for (which, answers) in [("folded", with(&wrapping, true)), ("unfolded", with(&wrapping, false))] {
                for (k, ((x, status), (expected, as_expected))) in answers.iter().zip(&reference).enumerate() {
                    assert_eq!(status, as_expected, "{which}, call {k}");
                    for i in 0..n {
                        let off = if i == 0 { folded(x[i] - expected[i]) } else { x[i] - expected[i] };
                        // Of the largest estimate: samples up to 16 rad are rounded to 2e-15, and the weights, which
                        // divide by the sample time, make the ten times larger rates of them.
                        assert!(off.abs() <= 1e-12 * scale[i], "{which}, gaps {gaps}, call {k}, state {i}: {off:e}");
                    }
                }
            }
        }
    }
}

/// Two integrators and two steps, against the drive's own velocity; a prototype in double precision gave 0.4004.
#[test]
fn the_recording_s_velocity() {
    let rows = swing();
    for scalar in [Scalar::F32, Scalar::F64] {
        let generated = designed_in(&corpus("swing_up"), scalar);
        let answers = fed(&generated, rows.iter().map(|(q, _)| folded(*q)));
        let compared = answers.iter().zip(&rows).filter(|((_, status), _)| *status == Status::Converged);
        let errors: Vec<f64> = compared.map(|((x, _), (_, reference))| x[1] - reference).collect();
        assert_eq!(errors.len(), rows.len() - 2);
        let rms = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
        println!("{scalar}: {rms}");
        assert!((rms - 0.4004).abs() < 1e-4, "{scalar}: {rms}");
    }
}

/// Thirty thousand radians away, on the same single-precision samples: single precision is as good as double.
#[test]
fn after_thousands_of_turns() {
    let rows = swing();
    for (text, _, n) in specifications() {
        let far = |k: usize| f64::from((rows[k].0 + 30_000.0) as f32);
        let [single, double] =
            [Scalar::F32, Scalar::F64].map(|scalar| fed(&designed_in(&text, scalar), (0..rows.len()).map(far)));
        for i in 0..n {
            let scale = double.iter().map(|(x, _)| x[i].abs()).fold(0.0, f64::max);
            let off = |((a, _), (b, _)): (&Answer, &Answer)| {
                if i == 0 { folded(a[i] - b[i]).abs() } else { (a[i] - b[i]).abs() }
            };
            let worst = single.iter().zip(&double).map(off).fold(0.0, f64::max);
            println!("state {i} of {n}: {:e} of {scale}", worst / scale);
            assert!(worst <= 1e-5 * scale, "state {i} of {n}: {worst:e} of {scale}");
        }
    }
}

/// After any motion, as soon as the window holds equal samples only; wherever they are.
#[test]
fn standing_still_is_exactly_zero() {
    for (text, _, n) in specifications() {
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&text, scalar);
            let steps = generated.design.window_steps;
            for place in [0.1, PI, -3.0, 1_234.567, -30_000.0] {
                let moving = (0..3 * steps).map(|k| place + (k as f64 * 0.7).sin());
                let standing = std::iter::repeat_n(place, 2 * steps + 2);
                let answers = fed(&generated, moving.chain(standing));
                for (x, _) in &answers[4 * steps..] {
                    assert!(x[1..n].iter().all(|rate| *rate == 0.0), "{scalar} at {place}: {x:?}");
                }
            }
        }
    }
}

/// A pendulum driven round and round.
fn pendulum() -> Truth {
    let (m, l, b, g): (f64, f64, f64, f64) = (0.6, 0.45, 0.15, 9.81);
    Truth {
        discrete: false,
        change: Box::new(move |_, x, u| vec![x[1], (u[0] + x[2] - b * x[1]) / (m * l * l) - g / l * x[0].sin(), 0.0]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-3.0, 3.0), (20.0, 25.0), (0.3, 0.5)],
        input: vec![(3.0, 5.0)],
        exact: false,
    }
}

/// Nonlinear in the angle: going round, with the key and one turn, without it and all turns.
#[test]
fn a_pendulum_that_goes_round() {
    let text = edited(&corpus("pendulum_turning"), ", gate = 0.2, gate_limit = 20", "");
    let wrapping = designed(&text);
    let plain = designed(&edited(&text, ", wrap = '2*pi'", ""));
    let run = pendulum().run(2e-3, 1, 1_500, 7);
    let turns = run.states.last().unwrap()[0] / TAU;
    assert!(turns > 10.0, "{turns}");
    let mut one_turn = run.clone();
    one_turn.measurements.iter_mut().for_each(|y| y[0] = folded(y[0]));
    let (reference, answers) = (run.through(&plain), one_turn.through(&wrapping));
    assert_eq!(answers.statuses, reference.statuses);
    for i in 0..3 {
        let scale = reference.estimates.iter().map(|x| x[i].abs()).fold(0.0, f64::max);
        for (k, (x, expected)) in answers.estimates.iter().zip(&reference.estimates).enumerate() {
            let off = if i == 0 { folded(x[0] - expected[0]) } else { x[i] - expected[i] };
            // Rounding of an angle of a hundred radians, by the gains: 1e-14 by 1e4 for the load.
            assert!(off.abs() <= 1e-9 * scale.max(1.0), "call {k}, state {i}: {off:e} of {scale}");
        }
    }
    // And it is right: straight lines between samples leave 1e-3 of a fast turn.
    let last = run.states.len() - 1;
    let error = (answers.estimates[last][1] - run.states[last][1]).abs();
    assert!(error < 2e-2 * run.states[last][1].abs(), "{error}");
}

/// The corpus's counter, without its gate.
fn counter() -> String {
    edited(&corpus("counter"), ", gate = 1e-3", "")
}

/// Counts of a motion that turns back, in steps of up to 300.
fn counts(k: usize) -> i64 {
    (4_000.0 * (k as f64 * 0.07).sin() + 0.5 * (k * k) as f64).floor() as i64
}

/// What a counter of so many bits shows, as a number.
fn shown(count: i64, sample: &str) -> f64 {
    match sample {
        "i16" => f64::from(count as i16),
        "u16" => f64::from(count as u16),
        "i32" => f64::from(count as i32),
        _ => f64::from(count as u32),
    }
}

/// Wherever the counter stands, the rates have the same bits; and they are those of the counts without overflow.
#[test]
fn counters_overflow_unnoticed() {
    let text = counter();
    for sample in ["i16", "u16", "i32", "u32"] {
        let counted = edited(&text, "sample = \"i32\"", &format!("sample = \"{sample}\""));
        let plain = edited(&text, "sample = \"i32\", wrap = \"counter\", ", "");
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&counted, scalar);
            let from = |start: i64| fed(&generated, (0..400).map(|k| shown(start + counts(k), sample)));
            let reference = from(0);
            for start in [32_000, 65_000, 1_000_000, (1 << 31) - 2_000, (1 << 32) - 2_000] {
                for ((x, status), (expected, as_expected)) in from(start).iter().zip(&reference) {
                    assert_eq!(status, as_expected);
                    let bits = |x: &[f64]| x[1..].iter().map(|x| x.to_bits()).collect::<Vec<_>>();
                    assert_eq!(bits(x), bits(expected), "{sample} {scalar} from {start}");
                }
            }
            let plain = fed(&designed(&plain), (0..400).map(|k| counts(k) as f64 * 1e-6));
            for i in 1..3 {
                let scale = plain.iter().map(|(x, _)| x[i].abs()).fold(0.0, f64::max);
                // Weights and sums are rounded: by 1e-7 or 2e-16 of what is added up, some tens of times the result.
                let share = if scalar == Scalar::F32 { 1e-5 } else { 1e-12 };
                for ((x, _), (expected, _)) in reference.iter().zip(&plain) {
                    assert!((x[i] - expected[i]).abs() <= share * scale, "{sample} {scalar}: {x:?} {expected:?}");
                }
            }
        }
    }
}

/// A sensor that rounds down is half a count behind: the place is moved by that, the rates are not.
#[test]
fn a_counter_that_rounds_down() {
    let text = edited(&counter(), "quantum = 1e-6", "quantum = 1e-6, rounding = \"floor\"");
    for scalar in [Scalar::F32, Scalar::F64] {
        let [down, nearest] = [text.clone(), counter()]
            .map(|text| fed(&designed_in(&text, scalar), (0..60).map(|k| shown(counts(k), "i32"))));
        for ((x, _), (nearest, _)) in down.iter().zip(&nearest) {
            assert_eq!(x[1..], nearest[1..]);
            // Places up to 6e-3 m in singles, summed of twenty terms: a hundredth of what is looked for.
            assert!((x[0] - nearest[0] - 0.5e-6).abs() < 5e-9, "{x:?} {nearest:?}");
        }
    }
}

/// Thirty-two bits at their far end, in single precision, with turns that divide their range and that do not: the angle
/// is that of the count.
#[test]
fn a_large_count_has_its_angle() {
    [4_096.0, 2_156.0, 40_000.0].into_iter().for_each(large_count);
}

fn large_count(turn: f64) {
    let count = TAU / turn;
    let text =
        edited(&counter(), "wrap = \"counter\", quantum = 1e-6", &format!("quantum = '2*pi/{turn}', wrap = '2*pi'"));
    let generated = designed_in(&text, Scalar::F32);
    let start = (1 << 30) + 1_234;
    let answers = fed(&generated, (0..200).map(|k| shown(start + counts(k) / 8, "i32")));
    for (k, (x, _)) in answers.iter().enumerate().skip(generated.design.window_steps) {
        let angle = (start + counts(k) / 8) as f64 * count;
        // The fit is off by what three integrators leave of the motion, a few counts; single precision of the count
        // itself would be off by 64 of them.
        assert!(folded(x[0] - angle).abs() < 10.0 * count, "call {k}: {} {angle}", x[0]);
    }
}
