//! Claim: a method that predicts and corrects, and a baseline, estimates from folded angles what it estimates from
//! unfolded ones; its state stays within half a turn whatever happens, so that single precision loses nothing after any
//! number of turns; and it never settles on a motion a turn per sample away.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "counts of calls and samples are small"
)]

use crate::support::plant;

use std::f64::consts::{PI, TAU};

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::{designed_in, edited};

const H: f64 = 5e-3;

/// Methods without a plant, with their keys.
const SIGNALS: [(&str, &str); 10] = [
    ("differentiator", "order = 3\ntime = 0.2"),
    ("differentiator", "order = 3\ntime = 0.2\nafter = 'restart'"),
    ("differentiator", "order = 2\ntime = 0.1\nstop_before = 0"),
    ("fixed-time-linear", "order = 3"),
    ("robust-exact", "order = 2\nlipschitz = 60"),
    ("pll", "bandwidth = 60"),
    ("alpha-beta", "alpha = 0.6"),
    ("alpha-beta", "alpha = 0.6\norder = 3"),
    ("low-pass", "time_constant = 0.01"),
    ("adaptive-window", "deviation = 5e-3\nlongest = 0.08"),
];

/// Methods with a plant.
const PLANTS: [(&str, &str); 8] = [
    ("luenberger", "poles = [-50, -60]"),
    ("kalman", "process_noise = [1e-6, 1e-1]\nmeasurement_noise = [1e-6]"),
    ("high-gain", "gain = 60\npoles = [-1, -1]"),
    ("fixed-time-linear", ""),
    ("robust-exact", "lipschitz = 60"),
    ("prescribed-time", "time = 0.2"),
    ("prescribed-time", "time = 0.2\nafter = 'handover'\nprocess_noise = [1e-6, 1e-1]\nmeasurement_noise = [1e-6]"),
    (
        "prescribed-time",
        "time = 0.2\nkalman = { process_noise = [1e-6, 1e-1], measurement_noise = [1e-6], initial_deviation = 10 }",
    ),
];

fn signal((method, keys): (&str, &str)) -> String {
    format!(
        "deadbeat = 1\nname = 's'\n[outputs]\nq = {{ unit = 'rad', wrap = '2*pi' }}\n[observer.{method}]\n{keys}\n\
         [target]\nsample_time = {H}\n"
    )
}

fn pendulum((method, keys): (&str, &str)) -> String {
    format!(
        "deadbeat = 1\nname = 'p'\n[states]\nq = {{ derivative = 'dq' }}\ndq = {{ derivative = '-19.6*sin(q) - 0.5*dq' }}\n\
         [outputs]\nq = {{ value = 'q', wrap = '2*pi' }}\n[observer.{method}]\n{keys}\n[target]\nsample_time = {H}\n"
    )
}

/// All of them, by what they are.
fn each(scalar: Scalar, body: impl Fn(&str, &str, &Generated)) {
    let signals = SIGNALS.map(|it| (format!("{} {:?}", it.0, it.1), signal(it)));
    let plants = PLANTS.map(|it| (format!("{} {:?} of a pendulum", it.0, it.1), pendulum(it)));
    for (what, text) in signals.into_iter().chain(plants) {
        body(&what, &text, &designed_in(&text, scalar));
    }
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

fn through(generated: &Generated, samples: impl Iterator<Item = f64>) -> Vec<(Vec<f64>, Status)> {
    let mut interpreter = Interpreter::new(&generated.program);
    let step = |y: f64| {
        let mut estimate = vec![0.0; generated.plant.states.len()];
        let inputs = vec![0.0; generated.plant.inputs.len()];
        let status = interpreter.step(&[y], &inputs, &mut estimate);
        (estimate, status)
    };
    samples.map(step).collect()
}

/// Largest differences of two runs from a call on, of angles within a turn; and the largest estimates.
fn apart(a: &[(Vec<f64>, Status)], b: &[(Vec<f64>, Status)], from: usize) -> Vec<(f64, f64)> {
    let n = a[0].0.len();
    let mut most = vec![(0.0_f64, 0.0_f64); n];
    for ((a, _), (b, _)) in a.iter().zip(b).skip(from) {
        for (i, most) in most.iter_mut().enumerate() {
            let difference = if i == 0 { folded(a[0] - b[0]) } else { a[i] - b[i] };
            *most = (most.0.max(difference.abs()), most.1.max(b[i].abs()));
        }
    }
    most
}

/// The recording crosses half a turn 30 times. The folded run differs by the rounding of angles up to 16 rad, which at
/// worst enters the i-th derivative (2/h)^i times.
#[test]
fn folded_angles_give_the_estimates_of_unfolded_ones() {
    let swing = swing();
    let crossings = swing.windows(2).filter(|pair| (folded(pair[1]) - folded(pair[0])).abs() > PI).count();
    assert_eq!(crossings, 30);
    each(Scalar::F64, |what, text, wrapped| {
        let unfolded = designed_in(&edited(text, ", wrap = '2*pi'", ""), Scalar::F64);
        let plain = through(&unfolded, swing.iter().copied());
        let answers = through(wrapped, swing.iter().map(|q| folded(*q)));
        assert!(answers.iter().zip(&plain).all(|(a, b)| a.1 == b.1), "{what}: another status");
        for (i, (difference, size)) in apart(&answers, &plain, 0).into_iter().enumerate() {
            let rounding = 16.0 * 4.0 * f64::EPSILON * (2.0 / H).powi(i32::try_from(i).unwrap());
            println!("{what}, state {i}: {difference:.1e} of {size:.1e}, rounding {rounding:.1e}");
            assert!(difference <= 1e-12 * size + rounding, "{what}, state {i}: {difference:e} of {size:e}");
        }
        assert!(answers.iter().all(|(estimate, _)| estimate[0].abs() <= PI + 1e-12), "{what}: beyond half a turn");
    });
}

/// Single precision after 4775 turns against double precision: what is left is the rounding of folded samples.
#[test]
fn turns_cost_no_digits_in_single_precision() {
    let swing = swing();
    each(Scalar::F32, |what, text, single| {
        if single.plant.states.len() > 2 {
            // An acceleration is samples over h^2: their rounding alone is more than 1e-5 of it.
            return;
        }
        let double = designed_in(text, Scalar::F64);
        let far = |q: &f64| folded(q + 30_000.0);
        let (single, double) = (through(single, swing.iter().map(far)), through(&double, swing.iter().map(far)));
        for (i, (difference, size)) in apart(&single, &double, 0).into_iter().enumerate() {
            println!("{what}, state {i}: {:.1e} of scale", difference / size);
            // A threshold may be passed a call earlier or later in single precision: what is chosen then, not how it is
            // computed, differs by as much as a sample may be off the line.
            // The sliding law makes sqrt(L v) in the rate of noise v, and the rounding of a sample is noise.
            let own = match what {
                _ if what.starts_with("adaptive-window") => 5e-3 / H,
                _ if what.starts_with("robust-exact") => (60.0 * PI * f64::from(f32::EPSILON)).sqrt(),
                _ => 0.0,
            };
            assert!(difference < 1e-5 * size + own, "{what}, state {i}: {difference:e} of {size:e}");
        }
    });
}

/// At 40 rad/s without samples for 20,000 calls, 640 turns, the estimate stays within half a turn; and when samples are
/// back it converges to where the shaft is, whatever whole turns lie between.
#[test]
fn the_state_stays_within_half_a_turn_while_it_coasts() {
    each(Scalar::F32, |what, text, generated| {
        let generated = if text.contains("[states]") {
            &designed_in(&edited(text, "-19.6*sin(q) - 0.5*dq", "0"), Scalar::F32)
        } else {
            generated
        };
        let rate = 40.0;
        let sample = |k: usize| {
            let there = !(2_000..22_000).contains(&k);
            if there { folded(rate * H * k as f64) } else { f64::NAN }
        };
        let answers = through(generated, (0..26_000).map(sample));
        for (k, (estimate, _)) in answers.iter().enumerate() {
            assert!(estimate[0].abs() <= PI + 1e-3, "{what}, call {k}: {}", estimate[0]);
        }
        let (estimate, status) = answers.last().unwrap();
        assert_eq!(*status, Status::Converged, "{what}");
        assert!((estimate[1] - rate).abs() < 0.01 * rate, "{what}: {}", estimate[1]);
        assert!(folded(estimate[0] - rate * H * 25_999.0).abs() < 1e-2, "{what}: {}", estimate[0]);
    });
}

/// Two integrators with an input, pushed beyond half a turn per sample: the state is given up, and found again.
#[test]
fn a_motion_that_samples_cannot_tell_starts_the_observer_again() {
    for (method, keys) in PLANTS.into_iter().filter(|(method, _)| *method != "robust-exact") {
        let text = edited(&pendulum((method, keys)), "-19.6*sin(q) - 0.5*dq", "u");
        let text = edited(&text, "[outputs]", "[inputs]\nu = {}\n[outputs]");
        for push in [TAU / (H * H), 1e9, 1e30] {
            let generated = designed_in(&text, Scalar::F32);
            let mut interpreter = Interpreter::new(&generated.program);
            let mut estimate = [0.0; 2];
            let mut status = Status::Converging;
            let mut after = None;
            for k in 0..3_000 {
                let input = if k == 1_000 { push } else { 0.0 };
                status = interpreter.step(&[0.5], &[input], &mut estimate);
                after = if k == 1_000 { Some(status) } else { after };
            }
            // Half a turn within a sample may still be told from none at all.
            let told = push < 1e9;
            assert!(told || after == Some(Status::Converging), "{method} {keys:?}: pushed by {push:e}");
            assert_eq!(status, Status::Converged, "{method} {keys:?}: pushed by {push:e}");
            assert!(estimate[1].abs() < 1e-3, "{method} {keys:?}: pushed by {push:e}, still at {}", estimate[1]);
        }
    }
}

/// At standstill an adaptive window shows exactly 0. What predicts and corrects comes to within the rounding of a sample
/// over the sample time, and may stay there; a held difference keeps its last quotient.
#[test]
fn equal_samples_give_zero() {
    each(Scalar::F32, |what, text, generated| {
        if text.contains("[states]") || what.starts_with("low-pass") {
            return;
        }
        let sample = |k: usize| if k < 700 { folded(3.0 * H * k as f64) } else { 1.234_567 };
        let answers = through(generated, (0..6_000).map(sample));
        let exactly = what.starts_with("adaptive-window");
        let rounding = if exactly { 0.0 } else { 2.0 * f64::from(f32::EPSILON) / H };
        for (k, (estimate, _)) in answers.iter().enumerate().skip(3_000) {
            assert!(estimate[1].abs() <= rounding, "{what}, call {k}: {}", estimate[1]);
        }
    });
}

/// Counts of 4096 a turn from a counter of 16 bits, and a counter of 32 bits that overflows without a turn of its own: the
/// angles that the counts stand for, also while the counter jumps.
#[test]
fn counters_are_angles() {
    let count = TAU / 4096.0;
    let counts: Vec<f64> = swing().iter().map(|q| (q / count).round()).collect();
    for (method, keys) in SIGNALS {
        let with = |sensor: &str| {
            let text = signal((method, keys));
            designed_in(&edited(&text, "wrap = '2*pi'", &format!("quantum = '2*pi/4096'{sensor}")), Scalar::F64)
        };
        let (folding, plain) = (with(", wrap = '2*pi'"), with(""));
        let short = through(&with(", wrap = '2*pi', sample = 'u16'"), counts.iter().map(|n| n.rem_euclid(65_536.0)));
        let angles = through(&folding, counts.iter().map(|n| folded(n * count)));
        // From just below the largest count of 32 bits; the recording goes to 10,000 counts below where it began.
        let at =
            |n: &f64| (n + 2_147_483_648.0 - 100.0 + 2_147_483_648.0).rem_euclid(4_294_967_296.0) - 2_147_483_648.0;
        let long = through(&with(", sample = 'i32', wrap = 'counter'"), counts.iter().map(at));
        let unfolded = through(&plain, counts.iter().map(|n| n * count));
        for (what, (a, b), size) in [("u16", (&short, &angles), 100.0), ("i32", (&long, &unfolded), 3.3e6)] {
            for (i, (difference, largest)) in apart(a, b, 0).into_iter().enumerate().skip(1) {
                // Positions of that size are rounded before they are differences.
                let rounding = size * 4.0 * f64::EPSILON * (2.0 / H).powi(i32::try_from(i).unwrap());
                let own = if method == "robust-exact" { (60.0 * size * f64::EPSILON).sqrt() } else { 0.0 };
                assert!(
                    difference <= 1e-12 * largest + rounding + own,
                    "{method} {keys:?}, {what}, state {i}: {difference:e} of {largest:e}"
                );
            }
        }
    }
}

/// Turns that no counter's range is a multiple of, in single precision: wherever the counter stands, also across its
/// overflow, the estimates have the same bits; and their angle is that of the counts to within a count, of which single
/// precision of the counts themselves would lose a hundred.
#[test]
fn counters_of_any_turn() {
    let signals = SIGNALS.map(signal);
    let plants = [PLANTS[0], PLANTS[1], PLANTS[5]].map(pendulum);
    for text in signals.iter().chain(&plants) {
        for (turn, sample) in [(2_156, "i32"), (10_000, "u32"), (40_000, "i32"), (2_156, "u16"), (10_000, "i16")] {
            let sensor = format!("wrap = '2*pi', quantum = '2*pi/{turn}'");
            let counted = edited(text, "wrap = '2*pi'", &format!("{sensor}, sample = '{sample}'"));
            let generated = designed_in(&counted, Scalar::F32);
            let count = TAU / f64::from(turn);
            let counts: Vec<i64> = swing().iter().take(900).map(|q| (q / count).round() as i64).collect();
            let from = |start: i64| through(&generated, counts.iter().map(|n| shown(n + start, sample)));
            // Never below zero at the first sample, and a whole number of turns each.
            let turns = |start: i64| start - start.rem_euclid(i64::from(turn));
            let near = turns(1 << 15);
            let reference = from(near);
            let range = if sample.ends_with("32") { 1_i64 << 32 } else { 1 << 16 };
            let overflow = if sample.starts_with('u') { range } else { range / 2 };
            for start in [turns(overflow - 1), turns(range / 4)] {
                let same = from(start);
                assert!(same == reference, "{counted}\nfrom {start}");
            }
            let plain = designed_in(&edited(text, "wrap = '2*pi'", &sensor), Scalar::F64);
            let angles = through(&plain, counts.iter().map(|n| folded(*n as f64 * count)));
            for (k, ((x, status), (expected, _))) in reference.iter().zip(&angles).enumerate() {
                let off = folded(x[0] - expected[0]).abs();
                assert!(*status != Status::Converged || off <= count, "{counted}\ncall {k}: {off:e} of {count:e}");
            }
        }
    }
}

/// What a counter of so many bits shows, as a number.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "that is what counters do")]
fn shown(count: i64, sample: &str) -> f64 {
    match sample {
        "i16" => f64::from(count as i16),
        "u16" => f64::from(count as u16),
        "i32" => f64::from(count as i32),
        _ => f64::from(count as u32),
    }
}
