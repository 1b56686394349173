//! Claim: correctors of every method bridge missing samples: what is not finite or out of range corrects nothing, the
//! status says so until as many good calls in a row have followed as the header says, and without noise no more is then
//! left of whatever happened meanwhile than of an initial error, and nothing in the end. No bits and no number of missing samples make a state non-finite.

#![allow(clippy::cast_possible_truncation, reason = "bits of a single stand in the lower half of a word")]

use crate::support::plant;

use deadbeat_codegen::Generated;
use deadbeat_codegen::internals::estimator::corrector::Corrector;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::promise::Convergence;
use plant::{Hold, Random, Run, Truth, designed_in, matrix};

const H: f64 = 0.01;

/// Every method that predicts and corrects, with its keys.
const METHODS: [(&str, &str); 13] = [
    ("prescribed-time", "time = 0.3"),
    ("prescribed-time", "time = 0.3\nstop_before = 0"),
    ("prescribed-time", "time = 0.3\nafter = 'restart'"),
    ("prescribed-time", "time = 0.3\nholloway-krstic = { m = 2, l = [3, 2] }\nstop_before = 5"),
    ("prescribed-time", "time = 0.3\nefimov-orlov = { L = [80, 1600] }\nstop_before = 3"),
    ("prescribed-time", "time = 0.3\nafter = 'handover'\nprocess_noise = [1e-8, 1e-4]\nmeasurement_noise = [1e-6]"),
    (
        "prescribed-time",
        "time = 0.3\nkalman = { process_noise = [1e-8, 1e-4], measurement_noise = [1e-6], initial_deviation = 10 }",
    ),
    ("luenberger", "poles = [[-30, 10], [-30, -10]]"),
    ("kalman", "process_noise = [1e-8, 1e-4]\nmeasurement_noise = [1e-6]"),
    ("high-gain", "gain = 40\npoles = [-1, -1]"),
    ("fixed-time-linear", ""),
    ("robust-exact", "lipschitz = 50"),
    ("kalman", ""),
];

fn oscillator(method: &str, keys: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'o'\n[states]\nx = {{ derivative = 'v' }}\nv = {{ derivative = 'u - 9*x - 0.4*v + w' }}\n\
         [inputs]\nu = {{}}\n[outputs]\nx = {{ value = 'x', noise = 1e-3, range = [-10, 10] }}\n[disturbances]\n\
         w = {{ bound = 1 }}\n[observer.{method}]\n{keys}\n[target]\nsample_time = {H}\n"
    )
}

fn truth() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], u[0] - 9.0 * x[0] - 0.4 * x[1]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-1.0, 1.0), (-3.0, 3.0)],
        input: vec![(-3.0, 3.0)],
        exact: true,
    }
}

/// What can stand where a sample is missing.
const BAD: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 10.5, -1e300];

fn each(body: impl Fn(&str, &Generated)) {
    for (method, keys) in METHODS {
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&oscillator(method, keys), scalar);
            body(&format!("{method} {keys:?} {scalar}"), &generated);
        }
    }
}

/// The run with bad samples at some calls, what they are by turns.
fn without(run: &Run, missing: impl Fn(usize) -> bool) -> Run {
    let mut run = run.clone();
    let mut bad = BAD.iter().cycle();
    for (_, sample) in run.measurements.iter_mut().enumerate().filter(|(call, _)| missing(*call)) {
        sample[0] = *bad.next().unwrap();
    }
    run
}

/// What the statuses must be from a call on: Converging until more than V good calls, then Coasting from a missing sample
/// until as many in a row as the header prints.
struct Counts {
    enough: usize,
    recovery: usize,
    good: usize,
    clean: usize,
}

impl Counts {
    fn call(&mut self, there: bool) -> Status {
        self.good += usize::from(there);
        self.clean = if there { self.clean + 1 } else { 0 };
        match (self.good > self.enough, self.clean >= self.recovery) {
            (false, _) => Status::Converging,
            (true, true) => Status::Converged,
            (true, false) => Status::Coasting,
        }
    }
}

/// Single missing samples, pairs, bursts and one in twenty by chance, before and after convergence: the status of every
/// call is what the counts of good calls say. A law that senses its convergence is held to them from then on.
#[test]
fn the_status_says_how_long_a_missing_sample_is_felt() {
    each(|what, generated| {
        let valid = generated.design.valid_from_step;
        let calls = 12 * valid + 800;
        let whole = truth().run(H, 1, calls, 3);
        let mut random = Random::new(11);
        let chance: Vec<bool> = (0..calls).map(|_| random.below(20) == 0).collect();
        let sensed = matches!(generated.design.convergence, Convergence::Sensed { .. });
        let from = if sensed { 400 } else { 0 };
        let last = from + 3 * valid;
        let patterns: [&dyn Fn(usize) -> bool; 5] = [
            &|call| call < 3,
            &|call| call == valid / 2 || call == last,
            &|call| call == last || call == last + 2,
            &|call| (last..last + 60).contains(&call),
            &|call| chance[call],
        ];
        for (number, missing) in patterns.iter().enumerate() {
            let missing = |call: usize| call >= from && missing(call);
            let answers = without(&whole, missing).through(generated);
            // What is missing before the first sample does not count.
            let recovery = recovery(generated);
            let mut counts = Counts { enough: valid, recovery, good: 0, clean: recovery };
            let mut began = false;
            for (call, status) in answers.statuses.iter().enumerate() {
                if sensed && call < from {
                    // Until then it may converge when it likes.
                    assert!(call < from - 1 || *status == Status::Converged, "{what}: not after {call} calls");
                    (counts.good, counts.clean) = (valid + 1, recovery);
                    continue;
                }
                // Nothing has begun before the first good sample.
                began |= !missing(call);
                let expected = if began || sensed { counts.call(!missing(call)) } else { Status::Converging };
                assert_eq!(*status, expected, "{what}, pattern {number}, call {call}");
            }
        }
    });
}

/// Good calls in a row from a missing sample to `Converged`.
fn recovery(generated: &Generated) -> usize {
    generated.design.estimator.downcast_ref::<Corrector>().expect("a corrector").recovery
}

/// The size of an error: the root mean square of what it does to the output over the calls until convergence.
fn size(generated: &Generated, error: [f64; 2]) -> f64 {
    let (phi, calls) = (matrix(generated, "Phi"), generated.design.valid_from_step.max(2));
    let (mut e, mut sum) = (error, 0.0);
    for _ in 0..calls {
        sum += e[0] * e[0];
        e = [phi[0][0] * e[0] + phi[0][1] * e[1], phi[1][0] * e[0] + phi[1][1] * e[1]];
    }
    #[expect(clippy::cast_precision_loss, reason = "counts of calls are small")]
    let calls = calls as f64;
    (sum / calls).sqrt()
}

/// The plant is moved while its sensor is out, at any place of a countdown: when the status says `Converged` again, no more
/// is left of that than the first convergence leaves of an initial error, or a millionth.
#[test]
fn converged_again_means_that_what_happened_is_gone() {
    for (method, keys) in METHODS {
        let generated = designed_in(&oscillator(method, keys), Scalar::F64);
        let left = match generated.design.convergence {
            Convergence::Prescribed { left } => left.max(1e-6),
            Convergence::Geometric { .. } | Convergence::Finite => 1e-6,
            Convergence::Sensed { .. } => continue,
        };
        let valid = generated.design.valid_from_step;
        for place in 0..valid.min(40) {
            let gap = 3 * valid + 20 + place;
            let calls = gap + 3 * recovery(&generated) + 20;
            let (before, after) = (truth().run(H, 1, calls, 17), truth().run(H, 1, calls, 18));
            let mut run = after.clone();
            for call in 0..gap {
                run.measurements[call].clone_from(&before.measurements[call]);
                run.inputs[call].clone_from(&before.inputs[call]);
            }
            run.measurements[gap - 1][0] = f64::NAN;
            let answers = run.through(&generated);
            let error = |call: usize, truth: &Run| [0, 1].map(|i| answers.estimates[call][i] - truth.states[call][i]);
            let moved = size(&generated, error(gap - 1, &after));
            let again = (gap..calls).find(|call| answers.statuses[*call] == Status::Converged).unwrap();
            let rest = size(&generated, error(again, &after));
            // One call of the plant more, and rounding.
            let most = 1.1 * left * moved + 1e-12;
            assert!(rest <= most, "{method} {keys:?}, {place}: {rest:e} above {most:e} at {}", again - gap);
        }
    }
}

/// Without noise, one sample in twenty lost and a burst: the error goes on dying out, to rounding.
#[test]
fn nothing_is_left_of_missing_samples() {
    each(|what, generated| {
        let calls = 4_000;
        let whole = truth().run(H, 1, calls, 5);
        let mut random = Random::new(13);
        let lost: Vec<bool> =
            (0..calls).map(|call| call < 3_900 && (random.below(20) == 0 || (2_000..2_150).contains(&call))).collect();
        let answers = without(&whole, |call| lost[call]).through(generated);
        let epsilon = match generated.program.scalar {
            Scalar::F32 => f64::from(f32::EPSILON),
            Scalar::F64 => f64::EPSILON,
        };
        let errors = answers.errors(&whole, 3_990..calls);
        for (i, error) in errors.iter().enumerate() {
            // Rounding of samples of 1 enters like noise of that size, through gains of at most 2/h in the velocity; that of
            // the states, over at most a hundred calls of memory.
            let rounding = 100.0 * epsilon * if i == 0 { 1.0 } else { 2.0 / H };
            assert!(*error <= rounding, "{what} state {i}: {error:e} of {rounding:e}");
        }
        assert!(answers.estimates.iter().flatten().all(|x| x.is_finite()), "{what}");
    });
}

/// Any bits as samples and as inputs: estimates and cells stay finite, and good samples bring the estimate back where
/// inputs have been sane.
#[test]
fn no_bits_make_the_state_other_than_finite() {
    each(|what, generated| {
        let mut random = Random::new(17);
        let mut interpreter = Interpreter::new(&generated.program);
        let any = |random: &mut Random| match generated.program.scalar {
            Scalar::F32 => f64::from(f32::from_bits(random.bits() as u32)),
            Scalar::F64 => f64::from_bits(random.bits()),
        };
        let mut estimate = [0.0; 2];
        for call in 0..30_000 {
            // Some good ones in between, so that it starts, and the largest that pass.
            let sample = match random.below(4) {
                0 => random.within(-10.0, 10.0),
                1 => 10.0,
                _ => any(&mut random),
            };
            let input = if call < 15_000 { any(&mut random) } else { random.within(-3.0, 3.0) };
            interpreter.step(&[sample], &[input], &mut estimate);
            assert!(estimate.iter().all(|x| x.is_finite()), "{what}, call {call}");
            let cells = interpreter.cells();
            assert!(cells.iter().flat_map(|(_, held)| held).all(|x| x.is_finite()), "{what}, call {call}");
        }
        let run = truth().run(H, 1, 12_000, 19);
        for (measured, applied) in run.measurements.iter().zip(&run.inputs) {
            interpreter.step(measured, applied, &mut estimate);
        }
        let state = run.states.last().unwrap();
        let error = estimate.iter().zip(state).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        // What single precision leaves in a velocity: see above.
        assert!(error < 3e-3, "{what}: {estimate:?} {state:?}");
    });
}

/// Coasting on a plant that grows ends where the floats do: the observer starts again, and converges again.
#[test]
fn a_coast_to_the_end_of_the_floats_starts_again() {
    for (method, keys) in METHODS.into_iter().filter(|(_, keys)| !keys.contains("l = [3, 2]")) {
        let text = oscillator(method, keys).replace("u - 9*x - 0.4*v", "u + 9*x - 0.4*v").replace("-30", "-40");
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&text, scalar);
            let mut interpreter = Interpreter::new(&generated.program);
            let mut estimate = [0.0; 2];
            let mut status = Status::Converging;
            for _ in 0..2_000 {
                status = interpreter.step(&[0.5], &[-4.5], &mut estimate);
            }
            assert_eq!(status, Status::Converged, "{method} {keys:?} {scalar}");
            let mut again = false;
            for _ in 0..60_000 {
                status = interpreter.step(&[f64::NAN], &[-3.0], &mut estimate);
                assert!(estimate.iter().all(|x| x.is_finite()), "{method} {keys:?} {scalar}");
                again |= status == Status::Converging;
            }
            assert!(again, "{method} {keys:?} {scalar}: {status:?} {estimate:?}");
            for _ in 0..4_000 {
                status = interpreter.step(&[0.5], &[-4.5], &mut estimate);
            }
            assert_eq!(status, Status::Converged, "{method} {keys:?} {scalar}: {estimate:?}");
            assert!((estimate[0] - 0.5).abs() < 1e-4 && estimate[1].abs() < 1e-2, "{method} {keys:?}: {estimate:?}");
        }
    }
}

/// One of two outputs missing: the other still corrects, and the status says that something is missing.
#[test]
fn an_output_that_is_there_still_corrects() {
    let text = "deadbeat = 1\nname = 'k'\n[plant]\ntime = 'discrete'\nA = [[1, 0.1], [0, 1]]\nC = [[1, 0], [0, 1]]\n\
                [observer.kalman]\nprocess_noise = [1e-3, 1e-3]\nmeasurement_noise = [1e-2, 1e-2]\n[target]\n\
                sample_time = 0.1\nscalar = 'f64'\n";
    let generated = designed_in(text, Scalar::F64);
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = [0.0; 2];
    interpreter.step(&[0.0, 0.0], &[], &mut estimate);
    for call in 1..4_000 {
        let position = 0.2 * f64::from(call);
        let status = interpreter.step(&[position, f64::NAN], &[], &mut estimate);
        assert!(status != Status::Converged);
    }
    // The gain is that for both outputs: by the one alone it takes longer.
    assert!((estimate[1] - 2.0).abs() < 1e-9, "{estimate:?}");
}

/// Methods that take a signal without a plant.
const SIGNALS: [(&str, &str); 5] = [
    ("differentiator", "order = 3\ntime = 0.3"),
    ("differentiator", "order = 3\ntime = 0.3\nafter = 'restart'"),
    ("differentiator", "order = 3\ntime = 0.3\nprediction = 'implicit-euler'"),
    ("differentiator", "order = 3\ntime = 0.3\nafter = 'handover'\nprocess_noise = [0, 0, 1e-6]"),
    ("fixed-time-linear", "order = 3"),
];

/// A parabola, which the chain of three integrators continues: the statuses follow the counts through single missing
/// samples and a burst, and after the last count nothing is left of them. Implicit Euler's chain lags on a parabola; its
/// first state alone, which is the sample, is compared.
#[test]
fn a_signal_without_a_plant_is_bridged() {
    let parabola = |call: usize| {
        #[expect(clippy::cast_precision_loss, reason = "counts of calls are small")]
        let t = call as f64 * H;
        [1.0 - 0.2 * t + 0.005 * t * t, -0.2 + 0.01 * t, 0.01]
    };
    for (method, keys) in SIGNALS {
        let text = format!(
            "deadbeat = 1\nname = 's'\n[outputs]\nx = {{ noise = 1e-3, range = [-10, 10] }}\n[observer.{method}]\n{keys}\n\
             [target]\nsample_time = {H}\n"
        );
        for scalar in [Scalar::F32, Scalar::F64] {
            let generated = designed_in(&text, scalar);
            let (valid, recovery) = (generated.design.valid_from_step, recovery(&generated));
            let (gap, calls) = (3 * valid + 20, 3 * valid + 80 + 2 * recovery);
            let missing = |call: usize| call == valid / 2 + 1 || call == gap || (gap + 5..gap + 15).contains(&call);
            let mut counts = Counts { enough: valid, recovery, good: 0, clean: recovery };
            let mut interpreter = Interpreter::new(&generated.program);
            let mut estimate = [0.0; 3];
            for call in 0..calls {
                let sample = if missing(call) { f64::NAN } else { parabola(call)[0] };
                let status = interpreter.step(&[sample], &[], &mut estimate);
                assert_eq!(status, counts.call(!missing(call)), "{method} {keys:?} {scalar}, call {call}");
                assert!(estimate.iter().all(|x| x.is_finite()));
            }
            let epsilon = if scalar == Scalar::F32 { f64::from(f32::EPSILON) } else { f64::EPSILON };
            let noise = &generated.design.certificate.noise_gain_l1;
            let compared = if keys.contains("implicit") { 1 } else { 3 };
            for i in 0..compared {
                // Samples of about 1 are rounded, and the state a few times a call; a millionth of the burst is left.
                let most = 8.0 * epsilon * noise[i][0] + 1e-5;
                let error = (estimate[i] - parabola(calls - 1)[i]).abs();
                assert!(error <= most, "{method} {keys:?} {scalar}: state {i} off by {error:e}, {most:e}");
            }
        }
    }
}
