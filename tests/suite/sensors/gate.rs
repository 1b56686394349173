//! Claim: on a recording with one outlier in a hundred, a gate keeps out the outliers and nothing else, so that the
//! velocity is as good as without them; a true jump is followed after as many samples as the limit says; what is
//! missing or comes before convergence is not counted as rejected.

use crate::support::{plant, truths};

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::{corpus, designed_in, edited};
use truths::truth;

/// q and `dq_ref` by row.
fn recording() -> Vec<(f64, f64)> {
    let path = format!("{}/specs/data/ak80_hand_guided_1khz.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,q,dq_ref,tau"));
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        (cells[1], cells[2])
    };
    lines.map(row).collect()
}

/// One call's estimate and status, and how many samples in a row were rejected.
struct Answer {
    x: Vec<f64>,
    status: Status,
    rejected: u32,
}

fn fed(generated: &Generated, samples: impl Iterator<Item = f64>) -> Vec<Answer> {
    let mut interpreter = Interpreter::new(&generated.program);
    let mut x = vec![0.0; generated.program.estimates.len()];
    let mut answers = Vec::new();
    for sample in samples {
        let status = interpreter.step(&[sample], &[], &mut x);
        let cells = interpreter.cells();
        let rejected = cells.iter().find(|(name, _)| name == "rejected_y").map_or(0.0, |(_, content)| content[0]);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index, widened")]
        answers.push(Answer { x: x.clone(), status, rejected: rejected as u32 });
    }
    answers
}

/// N of `hand_guided.toml`.
const STEPS: usize = 131;

fn rms(answers: &[Answer], rows: &[(f64, f64)]) -> f64 {
    let squares: Vec<f64> = answers
        .iter()
        .zip(rows)
        .skip(STEPS)
        .map(|(answer, (_, reference))| (answer.x[1] - reference).powi(2))
        .collect();
    #[expect(clippy::cast_precision_loss, reason = "30,000 rows")]
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    mean.sqrt()
}

/// Rows moved by half a radian, up and down by turns.
fn outlier(k: usize) -> bool {
    (7_919 * k) % 1_000 >= 990
}

/// 0.1442 rad/s without outliers, within 5 % of it with them; every outlier rejected, no other sample.
#[test]
fn outliers_are_kept_out() {
    let rows = recording();
    assert_eq!(rows.len(), 30_000);
    for scalar in [Scalar::F32, Scalar::F64] {
        let gated = designed_in(&corpus("hand_guided"), scalar);
        let plain = designed_in(&edited(&corpus("hand_guided"), ", gate = 0.1", ""), scalar);
        let clean = rms(&fed(&plain, rows.iter().map(|(q, _)| *q)), &rows);
        println!("{scalar}, clean: {clean}");
        assert!((clean / 0.1442 - 1.0).abs() < 0.01, "{scalar}: {clean}");
        let answers = fed(&gated, rows.iter().map(|(q, _)| *q));
        assert!(answers.iter().all(|answer| answer.rejected == 0), "{scalar}: a clean sample was rejected");
        let mut up = false;
        let moved = |(k, (q, _)): (usize, &(f64, f64))| {
            up ^= outlier(k);
            if !outlier(k) {
                *q
            } else if up {
                q + 0.5
            } else {
                q - 0.5
            }
        };
        let moved: Vec<f64> = rows.iter().enumerate().map(moved).collect();
        let answers = fed(&gated, moved.iter().copied());
        for (k, answer) in answers.iter().enumerate().skip(STEPS + 1) {
            assert_eq!(answer.rejected > 0, outlier(k), "{scalar}, row {k}");
        }
        let dirty = rms(&answers, &rows);
        let without = rms(&fed(&plain, moved.iter().copied()), &rows);
        println!("{scalar}, outliers: {dirty} behind the gate, {without} without one");
        assert!((dirty / clean - 1.0).abs() < 0.05, "{scalar}: {dirty}, clean {clean}");
        assert!(without > 3.0 * clean, "outliers that matter: {without}");
    }
}

/// A jump of a radian: rejected until the limit, then the window starts again with it, and converges on time.
#[test]
fn a_true_jump_is_followed() {
    let text = corpus("hand_guided");
    let limited = edited(&text, "gate = 0.1", "gate = 0.1, gate_limit = 7");
    for (text, limit) in [(text, STEPS), (limited, 7)] {
        let generated = designed_in(&text, Scalar::F64);
        let jump = 400;
        let answers = fed(&generated, (0..1_000).map(|k| if k < jump { 0.25 } else { 1.25 }));
        // The call that would be the last rejection is the first of the new window.
        let again = jump + limit - 1;
        for (k, answer) in answers.iter().enumerate() {
            let (status, q) = match k {
                _ if k < STEPS => (Status::Converging, 0.25),
                _ if k < jump => (Status::Converged, 0.25),
                _ if k < again => (Status::Coasting, 0.25),
                _ if k < again + STEPS => (Status::Converging, 1.25),
                _ => (Status::Converged, 1.25),
            };
            assert_eq!(answer.status, status, "limit {limit}, call {k}");
            // Weights of a window of 131 add up to 1 within their rounding.
            assert!((answer.x[0] - q).abs() < 1e-12, "limit {limit}, call {k}: {}", answer.x[0]);
            let rejected = if (jump..again).contains(&k) { k - jump + 1 } else { 0 };
            assert_eq!(answer.rejected as usize, rejected, "limit {limit}, call {k}");
        }
    }
}

/// Missing samples in between neither count nor end a row of rejections; `coasted` counts both.
#[test]
fn missing_samples_do_not_count() {
    let text = edited(&corpus("hand_guided"), "gate = 0.1", "gate = 0.1, gate_limit = 4");
    let generated = designed_in(&text, Scalar::F32);
    let sample = |k: usize| match k {
        300 | 302 | 304 => 2.0,
        301 | 303 => f64::NAN,
        _ => 1.0,
    };
    let answers = fed(&generated, (0..400).map(sample));
    let rejected: Vec<u32> = answers[299..307].iter().map(|answer| answer.rejected).collect();
    assert_eq!(rejected, [0, 1, 1, 2, 2, 3, 0, 0]);
    let coasted: Vec<f64> = answers[299..307].iter().map(|answer| answer.x[3]).collect();
    assert_eq!(coasted, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 0.0]);
    assert!(answers[300..].iter().all(|answer| answer.status != Status::Converging));
}

/// A step that finds unknown constants by a regression of its own has the same gate: an outlier of either output is as a
/// sample that is not there, and nothing else is rejected.
#[test]
fn unknowns_are_found_behind_a_gate() {
    let text = edited(&corpus("unknown_force"), "value = 'q', noise = 1e-4", "value = 'q', noise = 1e-4, gate = 0.05");
    let generated = designed_in(&text, Scalar::F64);
    let from = generated.design.valid_from_step;
    let run = truth("unknown_force").unwrap().run(generated.plant.sample_time_s(), 1, 3 * from, 5);
    let (mut moved, mut lost) = (run.clone(), run.clone());
    for call in [from + 20, from + 21, from + 90] {
        moved.measurements[call][0] += 0.3;
        lost.measurements[call][0] = f64::NAN;
    }
    let [clean, moved, lost] = [run, moved, lost].map(|run| run.through(&generated));
    assert!(clean.statuses[from..].iter().all(|status| *status == Status::Converged));
    for call in 0..3 * from {
        let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&moved.estimates[call]), bits(&lost.estimates[call]), "call {call}");
    }
    assert_eq!(moved.statuses, lost.statuses);
    assert_eq!(moved.statuses[from + 20], Status::Coasting);
}

/// Before convergence every sample is believed: the window fills with what comes.
#[test]
fn nothing_is_rejected_before_convergence() {
    let generated = designed_in(&corpus("hand_guided"), Scalar::F32);
    let answers = fed(&generated, (0..STEPS).map(|k| if k % 2 == 0 { 5.0 } else { -5.0 }));
    assert!(answers.iter().all(|answer| answer.rejected == 0));
}
