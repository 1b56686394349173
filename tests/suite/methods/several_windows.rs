//! Claim: several windows over one buffer give the estimates of separate designs, bit for bit, for the memory of the
//! longest alone; a window that is not full shows the next shorter one's estimate; a missing sample is predicted by
//! the longest window that is full, and stands in the status of the shortest.

use crate::support::plant;

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::cost::cost;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use plant::{Random, corpus, designed_in, edited};

use Status::{Coasting, Converged, Converging};

/// N of each window of `three_windows.toml`.
const STEPS: [usize; 3] = [10, 30, 100];
/// The same in seconds, as written there.
const SECONDS: [&str; 3] = ["0.01", "0.03", "0.1"];
/// States.
const N: usize = 3;

fn with_window(text: &str, window: &str, scalar: Scalar) -> Generated {
    designed_in(&edited(text, "[0.01, 0.03, 0.1]", window), scalar)
}

/// Every field of the estimate and the status, per call; a sample that is NaN is missing.
fn answers(generated: &Generated, samples: &[f64]) -> Vec<(Vec<f64>, Status)> {
    let mut interpreter = Interpreter::new(&generated.program);
    let call = |sample: &f64| {
        let mut estimate = vec![0.0; generated.program.estimates.len()];
        let status = interpreter.step(&[*sample], &[], &mut estimate);
        (estimate, status)
    };
    samples.iter().map(call).collect()
}

/// Of no plant at all: what is equal here is equal everywhere.
fn noise(len: usize) -> Vec<f64> {
    let mut random = Random::new(5);
    (0..len).map(|_| random.within(-2.0, 2.0)).collect()
}

/// Both scalars: the same bits as three designs of their own.
#[test]
fn each_window_is_a_design_of_its_own() {
    for scalar in [Scalar::F32, Scalar::F64] {
        let text = corpus("three_windows");
        let together = answers(&designed_in(&text, scalar), &noise(300));
        let apart = SECONDS.map(|window| answers(&with_window(&text, window, scalar), &noise(300)));
        for (call, (estimate, status)) in together.iter().enumerate() {
            let full = STEPS.iter().filter(|steps| call >= **steps).count();
            assert_eq!(*status, if full > 0 { Converged } else { Converging }, "call {call}");
            assert_eq!(estimate[STEPS.len() * N], [0.0, 1.0, 2.0, 3.0][full], "call {call}");
            for window in 0..STEPS.len() {
                // A window that is not full shows the next shorter one; before all of them, the start.
                let of = window.min(full.saturating_sub(1));
                for i in 0..N {
                    let (shown, own) = (estimate[window * N + i], apart[of][call].0[i]);
                    assert_eq!(shown.to_bits(), own.to_bits(), "{scalar}, call {call}, window {window}, state {i}");
                }
            }
        }
    }
}

/// One buffer; and a list of one is the plain number.
#[test]
fn the_memory_is_that_of_the_longest() {
    let text = corpus("three_windows");
    let memory = |generated: &Generated| cost(&generated.program, deadbeat_math::COSTS).ram_bytes;
    for scalar in [Scalar::F32, Scalar::F64] {
        assert_eq!(memory(&designed_in(&text, scalar)), memory(&with_window(&text, "0.1", scalar)));
        let [listed, plain] = ["[0.03]", "0.03"].map(|window| with_window(&text, window, scalar).program);
        assert_eq!(listed, plain);
    }
}

/// The stand-in is what the estimate of the longest full window foretells, to rounding: written in by hand, it gives
/// the same estimates.
#[test]
fn the_longest_window_predicts() {
    let generated = designed_in(&corpus("three_windows"), Scalar::F64);
    for (gap, longest) in [(20, 0), (60, 1), (150, 2)] {
        let mut samples = noise(400);
        let before = answers(&generated, &samples[..gap]).pop().unwrap().0;
        let x = &before[longest * N..(longest + 1) * N];
        let h = 1e-3;
        let foretold = x[0] + h * x[1] + h * h / 2.0 * x[2];
        samples[gap] = foretold;
        let by_hand = answers(&generated, &samples);
        samples[gap] = f64::NAN;
        let missing = answers(&generated, &samples);
        for (call, ((a, status), (b, _))) in missing.iter().zip(&by_hand).enumerate() {
            let clean = STEPS.iter().filter(|steps| call >= **steps && !(gap..=gap + **steps).contains(&call)).count();
            assert_eq!(a[STEPS.len() * N], [0.0, 1.0, 2.0, 3.0][clean], "gap at {gap}, call {call}");
            for i in 0..STEPS.len() * N {
                // The weights of the shortest window add up to 2e5 times the samples, which are 2 at most; rounding
                // moves the stand-in by a few parts in 1e16 of what it is summed of.
                let most = [1.0, 1e3, 2e5][i % N] * 2.0 * 1e-14;
                assert!((a[i] - b[i]).abs() <= most, "call {call}, field {i}: {} {}", a[i], b[i]);
            }
            let wanted = if call < STEPS[0] {
                Converging
            } else if (gap..=gap + STEPS[0]).contains(&call) {
                Coasting
            } else {
                Converged
            };
            assert_eq!(*status, wanted, "gap at {gap}, call {call}");
        }
    }
}
