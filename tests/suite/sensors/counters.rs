//! Claim: an integer says how samples are stored, not that they turn. Without `wrap` raw counts give what the same samples
//! give as floats, also where the plant would allow a turn; with `wrap = "counter"` an overflow changes nothing. And a turn
//! that moves something else than an angle is refused, or said wherever it matters and hidden nowhere.

#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "counts, and what they stand for")]

use std::f64::consts::TAU;

use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::replay::{Recording, Replay, Signals};
use deadbeat_codegen::{Generated, Generator};

use crate::support::plant::{designed, designed_in, edited};

/// An AD converter at 500 Hz: an offset, and a tone of 200 Hz near half of the sample rate, so that its samples jump across
/// the converter's whole range. A free offset is what made a turn of the type harmless to the plant.
fn converter(sensor: &str, observer: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'converter'\n[parameters]\nw = '2*pi*200'\n[states]\na = {{ unit = 'V', derivative = '-w*b' }}\n\
         b = {{ unit = 'V', derivative = 'w*a' }}\ndc = {{ unit = 'V', derivative = '0' }}\n[outputs]\n\
         v = {{ unit = 'V', value = 'a + dc', quantum = '5/65536'{sensor} }}\n[observer.{observer}\n\
         [target]\nsample_time = 2e-3\n"
    )
}

const OBSERVERS: [&str; 4] = [
    "window]\nwindow = 0.02",
    "single-delay]\nwindow = 0.02",
    "impulsive]\nwindow = 0.02",
    "kalman]\nprocess_noise = [1e-4, 1e-4, 1e-6]\nmeasurement_noise = [1e-6]",
];

/// The tone of 2 V around 2.5 V, rounded to counts.
fn counts() -> impl Iterator<Item = f64> {
    (0..400).map(|k| ((2.5 + 2.0 * (TAU * 200.0 * 2e-3 * f64::from(k)).cos()) * 65_536.0 / 5.0).round())
}

/// The last estimate and its status.
fn last(generated: &Generated, samples: impl Iterator<Item = f64>) -> (Vec<f64>, Status) {
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    let status = samples.map(|sample| interpreter.step(&[sample], &[], &mut estimate)).last().unwrap();
    (estimate, status)
}

/// Every way to write the converter without `wrap` gives the offset of 2.5 V, to a count, and the same as floats do.
#[test]
fn a_converter_is_no_counter() {
    for observer in OBSERVERS {
        let floats = last(&designed(&converter("", observer)), counts().map(|n| n * 5.0 / 65_536.0));
        for sensor in [
            ", sample = 'u16'",
            ", sample = 'u16', range = [0, 5]",
            ", sample = 'u16', max_rate = 1e5",
            ", sample = 'u32'",
        ] {
            let generated = designed(&converter(sensor, observer));
            assert!(generated.plant.outputs[0].wrap.is_none(), "{sensor}");
            let (estimate, status) = last(&generated, counts());
            assert_eq!(status, Status::Converged, "{observer}");
            for (ours, as_floats) in estimate.iter().zip(&floats.0) {
                assert!((ours - as_floats).abs() < 1e-9, "{observer}{sensor}: {ours} for {as_floats}");
            }
            let offset = estimate[2];
            assert!((offset - 2.5).abs() < 5.0 / 65_536.0 * 10.0, "{observer}{sensor}: {offset} V for 2.5 V");
        }
    }
}

/// A counter that overflows, in all integer types and both precisions: the rate is that of the motion.
#[test]
fn a_counter_turns_where_it_says_so() {
    let text = |sample: &str| {
        format!(
            "deadbeat = 1\nname = 'belt'\n[states]\nx = {{ derivative = 'v' }}\nv = {{ derivative = '0' }}\n[outputs]\n\
             y = {{ value = 'x', sample = '{sample}', quantum = 1e-3, wrap = 'counter' }}\n[observer.window]\nwindow = 0.1\n\
             [target]\nsample_time = 0.01\n"
        )
    };
    for (sample, first, most) in [
        ("i16", 32_700, 1_i64 << 15),
        ("u16", 65_500, 1 << 16),
        ("i32", 2_147_483_600, 1 << 31),
        ("u32", 4_294_967_200, 1 << 32),
    ] {
        let range = if sample.ends_with("16") { 1_i64 << 16 } else { 1 << 32 };
        let folded = |n: i64| if n >= most { n - range } else { n };
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&text(sample), scalar);
            // 7 counts a sample are 0.7 a second; the overflow lies in the middle of the samples.
            let (estimate, status) = last(&generated, (0..30).map(|k| folded(first + 7 * k) as f64));
            assert_eq!(status, Status::Converged);
            assert!((estimate[1] - 0.7).abs() < 1e-5, "{sample}, {scalar}: {}", estimate[1]);
        }
    }
}

/// A contradiction is refused in its place: a range that a counter leaves, a rate that its turn cannot follow.
#[test]
fn a_counter_that_turns_shows_all_its_numbers() {
    let message = |sensor: &str| {
        let report = Generator::new(&converter(sensor, OBSERVERS[0]), "converter.toml").check();
        assert!(report.has_errors(), "{sensor} is accepted");
        report.render(false)
    };
    for (sensor, words) in [
        (", sample = 'u16', wrap = 'counter', range = [0, 4.9]", "its range leaves some out"),
        (", sample = 'u16', wrap = 5, range = [0.1, 5]", "its range leaves some out"),
        (", sample = 'u16', wrap = 'counter', max_rate = 1e5", "may move by half a turn or more"),
        (", sample = 'u16', wrap = 5, max_rate = 1e5", "may move by half a turn or more"),
        (", wrap = 'counter'", "is the turn of an integer"),
    ] {
        let text = message(sensor);
        assert!(text.contains(words), "{sensor}: {text}");
    }
    // All of the range is no contradiction.
    designed(&converter(", sample = 'u16', wrap = 'counter', range = [0, 5]", OBSERVERS[0]));
}

/// A servo on a spring, with a load that is a state: a turn of the angle is a turn of the spring, 3*2 pi = 18.85 rad/s^2.
const SPRUNG: &str = "deadbeat = 1\nname = 'servo'\n[states]\nq = { unit = 'rad', derivative = 'w' }\n\
     w = { unit = 'rad/s', derivative = '12*u - 4*w - m - 3*q' }\nm = { unit = 'rad/s^2', derivative = '0' }\n\
     [inputs]\nu = { unit = 'V' }\n[outputs]\ny = { unit = 'rad', value = 'q', wrap = '2*pi', noise = 1e-3 }\n\
     [observer.window]\nwindow = 0.05\n[target]\nsample_time = 1e-3\nscalar = 'f64'\n";

/// What a turn moves is refused with its size; accepted, it stands in the header; an angle that turns along needs no key.
#[test]
fn a_turn_that_moves_a_load_is_refused() {
    let report = |text: &str| Generator::new(text, "servo.toml").check();
    let refused = report(SPRUNG).render(false);
    assert!(refused.contains("a turn of `y` moves `m` by -18.85 rad/s^2"), "{refused}");
    assert!(refused.contains("turn_moves = \"accept\""), "{refused}");
    // A load behind a gear of 10: a turn of the motor is a tenth of one.
    let geared = "deadbeat = 1\nname = 'geared'\n[states]\nq = { unit = 'rad', derivative = 'w' }\n\
         w = { unit = 'rad/s', derivative = '-50*(q - 10*p)' }\np = { unit = 'rad', derivative = 'r' }\n\
         r = { unit = 'rad/s', derivative = '80*(q - 10*p)' }\n[outputs]\ny = { unit = 'rad', value = 'q', wrap = '2*pi' }\n\
         [observer.window]\nwindow = 0.5\n[target]\nsample_time = 0.01\nscalar = 'f64'\n";
    let text = report(geared).render(false);
    assert!(text.contains("a turn of `y` moves `p` by 0.6283 rad"), "{text}");
    let direct = designed(&edited(geared, "10*p", "p"));
    let said = "a turn of y moves p by 6.283 rad: it is known up to whole multiples of that";
    assert!(direct.design.notes.iter().any(|note| note == said), "{:?}", direct.design.notes);
    let accepted = designed(&edited(SPRUNG, "noise = 1e-3", "noise = 1e-3, turn_moves = 'accept'"));
    assert!(accepted.to_text().contains("a turn of y moves m by -18.85 rad/s^2"), "{}", accepted.to_text());
}

/// A replay compares the load as it is, not modulo its move, and says what a turn moves: at rest at one and a half turns the
/// load is off by one.
#[test]
fn a_replay_hides_no_move() {
    let accepted = designed(&edited(SPRUNG, "noise = 1e-3", "noise = 1e-3, turn_moves = 'accept'"));
    // At rest at q = 8 rad with a load that holds it there: w' = -m - 3 q = 0.
    let row = |k: i32| format!("{:.3},{},0,{},-24\n", f64::from(k) * 1e-3, 8.0 - TAU, 8.0);
    let rows = (0..200).map(row).collect::<Vec<_>>().concat();
    let recording = Recording::open(std::io::Cursor::new(format!("t,y,u,q,m\n{rows}")), "rest.csv").unwrap();
    let mut replay = Replay::new(&accepted, recording, &Signals::default()).unwrap();
    assert!(replay.by_ref().all(|step| step.is_ok()));
    let verdict = replay.verdict();
    let largest = |name: &str| verdict.errors(name).and_then(|errors| errors.max).unwrap();
    assert!(largest("q") < 1e-6, "the angle is compared within a turn: {}", largest("q"));
    assert!((largest("m") - 3.0 * TAU).abs() < 1e-3, "the load is off by {}", largest("m"));
    assert!(verdict.remarks.iter().any(|remark| remark.contains("moves m by -18.85 rad/s^2")), "{:?}", verdict.remarks);
}
