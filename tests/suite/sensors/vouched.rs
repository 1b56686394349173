//! Claim: after a start from a state that the caller vouches for, no estimate with the status `Converged` is further off
//! than the printed bound, whatever the declared noise and disturbances do: neither of a state that is exact, nor of one
//! that is off by as much as an answer of the observer may be. And an exact state of a plant that nothing disturbs is
//! converged from the first call on.

use crate::support::plant::{Random, designed};

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;

const H: f64 = 0.01;
const NOISE: f64 = 1e-5;

/// Estimators that keep a window or copies: their run from the given state is the model's.
const OF_THE_MODEL: [&str; 8] = [
    "[observer.window]\nwindow = 0.3",
    "[observer.window]\nwindow = 0.3\nrealization = 'ping-pong'",
    "[observer.window]\nwindow = 0.3\nmissing = 'left-out'",
    "[observer.window]\nwindow = [0.1, 0.3]",
    "[observer.window]\nwindow = 0.3\nweights = 'minimax'",
    "[observer.single-delay]\nwindow = 0.3",
    "[observer.impulsive]\nwindow = 0.3",
    "[observer.impulsive]\nwindow = 0.3\nform = 'continuous'",
];

/// Those that predict and correct.
const CORRECTORS: [&str; 6] = [
    "[observer.kalman]\nprocess_noise = [0, 1e-4]",
    "[observer.luenberger]\npoles = [-9, -12]",
    "[observer.high-gain]\ngain = 15\npoles = [-1, -1.2]",
    "[observer.prescribed-time]\ntime = 0.3",
    "[observer.prescribed-time]\ntime = 0.3\nafter = 'restart'",
    "[observer.fixed-time-linear]",
];

/// A mass that is pushed by `bound` at most; not at all where that is zero.
fn text(observer: &str, bound: f64, init_at: &str) -> String {
    let (push, disturbances) =
        if bound > 0.0 { ("w", format!("[disturbances]\nw = {{ bound = {bound} }}\n")) } else { ("0", String::new()) };
    format!(
        "deadbeat = 1\nname = 'm'\n[states]\nx = {{ derivative = 'v' }}\nv = {{ derivative = '{push}' }}\n\
         [outputs]\ny = {{ value = 'x', noise = {NOISE} }}\n{disturbances}{observer}\n[target]\nsample_time = {H}\n\
         scalar = 'f64'\ninit_at = {init_at}\n"
    )
}

/// What pushes, and the noise, both between -1 and 1, by call.
type Signals<'a> = &'a dyn Fn(usize) -> (f64, f64);

/// Estimates, statuses and states, from the call before the first on, when the plant is at `state`.
fn run(
    generated: &Generated,
    observer: &mut Interpreter,
    (mut state, bound): ([f64; 2], f64),
    signals: Signals,
    calls: usize,
) -> Vec<([f64; 2], Status, [f64; 2])> {
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    (0..calls)
        .map(|call| {
            let (push, noise) = signals(call);
            let a = push * bound;
            state = [state[0] + H * state[1] + 0.5 * H * H * a, state[1] + H * a];
            let status = observer.step(&[state[0] + noise * NOISE], &[], &mut estimate);
            ([estimate[0], estimate[1]], status, state)
        })
        .collect()
}

/// Pushes that keep their sign, change it at a call, go to and fro, and by chance; with noise likewise.
fn each_attack(mut body: impl FnMut(&str, Signals)) {
    for sign in [1.0, -1.0] {
        for noise in [0.0, 1.0, -1.0] {
            body("constant", &|_| (sign, noise));
            body("noise to and fro", &|call| (sign, if call % 2 == 0 { 1.0 } else { -1.0 }));
            for turn in [3, 8, 15, 22, 29, 31] {
                body("one change", &|call| {
                    (if call < turn { sign } else { -sign }, if call < turn { noise } else { -noise })
                });
            }
        }
    }
    for seed in 0..8 {
        let mut random = Random::new(seed);
        let all: Vec<(f64, f64)> =
            (0..200).map(|_| (random.within(-1.0, 1.0).signum(), random.within(-1.0, 1.0).signum())).collect();
        body("by chance", &|call| all[call]);
    }
}

/// Whether a call that says `Converged` is within the bound; how near it comes, at most 1.
fn share(generated: &Generated, (estimate, status, state): &([f64; 2], Status, [f64; 2]), what: &str) -> f64 {
    if *status != Status::Converged {
        return 0.0;
    }
    let mut nearest: f64 = 0.0;
    for i in 0..2 {
        let bound = generated.design.certificate.error_bound[i].expect("noise and disturbances are declared");
        let off = (estimate[i] - state[i]).abs();
        // Rounding of sums of numbers below 1 with gains below 1e4.
        assert!(off <= bound * (1.0 + 1e-9) + 1e-11, "{what}: state {i} is off by {off:e}, bound {bound:e}");
        nearest = nearest.max(off / bound);
    }
    nearest
}

#[test]
fn an_exact_start_keeps_its_bound_against_the_worst_disturbances() {
    for observer in OF_THE_MODEL.iter().chain(&CORRECTORS) {
        for bound in [0.0, 0.001, 1.0] {
            let generated = designed(&text(observer, bound, "'exact'"));
            let mut first = [false; 2];
            each_attack(|attack, signals| {
                let mut interpreter = Interpreter::new(&generated.program);
                let mut given = vec![0.0; generated.program.estimates.len()];
                (given[0], given[1]) = (0.2, -0.1);
                interpreter.start_at(&given, Status::Converged);
                let answers = run(&generated, &mut interpreter, ([0.2, -0.1], bound), signals, 120);
                for (call, answer) in answers.iter().enumerate() {
                    share(&generated, answer, &format!("{observer}, push {bound}, {attack}, call {call}"));
                    assert_ne!(answer.1, Status::Converging, "{observer}, push {bound}, {attack}, call {call}");
                    // Without a push the model is exact.
                    assert!(bound > 0.0 || answer.1 == Status::Converged, "{observer}, {attack}, call {call}");
                }
                first = [answers[0].1 == Status::Converged, answers[60].1 == Status::Converged];
            });
            // The bound of the window method is far above what a call of the push makes; afterwards samples have it.
            assert!(first[0], "{observer}, push {bound}");
            assert!(first[1], "{observer}, push {bound}");
        }
    }
}

/// What stands in the bound of a velocity moves the position further off with every call: nothing of it is promised until
/// samples have determined the estimate.
#[test]
fn a_start_that_is_off_by_its_bound_is_not_converged_while_the_model_carries_it() {
    for observer in OF_THE_MODEL {
        for bound in [0.0, 0.001, 1.0] {
            let generated = designed(&text(observer, bound, "true"));
            let printed: Vec<f64> =
                generated.design.certificate.error_bound.iter().map(|bound| bound.unwrap()).collect();
            for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
                each_attack(|attack, signals| {
                    let mut interpreter = Interpreter::new(&generated.program);
                    let mut given = vec![0.0; generated.program.estimates.len()];
                    (given[0], given[1]) = (0.2 + signs[0] * printed[0], -0.1 + signs[1] * printed[1]);
                    interpreter.start_at(&given, Status::Converged);
                    let answers = run(&generated, &mut interpreter, ([0.2, -0.1], bound), signals, 80);
                    for (call, answer) in answers.iter().enumerate() {
                        share(&generated, answer, &format!("{observer}, push {bound}, {attack}, call {call}"));
                        // The given state is used, and the samples have it in the end.
                        assert_ne!(answer.1, Status::Converging, "{observer}, push {bound}, {attack}, call {call}");
                        assert!(call < 61 || answer.1 == Status::Converged, "{observer}, {attack}, call {call}");
                    }
                });
            }
        }
    }
}

/// What an observer answered as converged starts another one of its kind: the bound goes on to hold.
#[test]
fn an_answer_can_be_handed_over() {
    for observer in OF_THE_MODEL.iter().chain(&CORRECTORS) {
        let generated = designed(&text(observer, 1.0, "true"));
        each_attack(|attack, signals| {
            let mut interpreter = Interpreter::new(&generated.program);
            let before = run(&generated, &mut interpreter, ([0.2, -0.1], 1.0), signals, 100);
            let (estimate, status, state) = before[99];
            let mut given = vec![0.0; generated.program.estimates.len()];
            given[..2].copy_from_slice(&estimate);
            for later in [0, 1] {
                let mut next = Interpreter::new(&generated.program);
                next.start_at(&given, status);
                let answers = run(&generated, &mut next, (state, 1.0), &|call| signals(call + later), 100);
                for (call, answer) in answers.iter().enumerate() {
                    share(&generated, answer, &format!("{observer}, {attack}, call {call} after the handing over"));
                }
            }
        });
    }
}

/// The measured state of an estimate that takes it from the newest sample comes from there in the run, too: noise is all
/// that it is off by.
#[test]
fn the_measured_state_is_the_newest_sample_where_it_always_is() {
    for observer in ["[observer.single-delay]\nwindow = 0.3", "[observer.impulsive]\nwindow = 0.3"] {
        let generated = designed(&text(observer, 1.0, "'exact'"));
        let mut interpreter = Interpreter::new(&generated.program);
        interpreter.start_at(&[0.2, -0.1], Status::Converged);
        let answers = run(&generated, &mut interpreter, ([0.2, -0.1], 1.0), &|_| (1.0, 1.0), 60);
        for (call, (estimate, _, state)) in answers.iter().enumerate() {
            assert!((estimate[0] - state[0]).abs() <= NOISE * (1.0 + 1e-9), "{observer}, call {call}");
        }
    }
}
