//! Claim: an output that is due at every m-th call, of methods with one constant gain and of those that count down: on
//! random plants no more is left of an initial error than is printed, from sample to sample the poles are those that
//! were asked for, the worst noise reaches the printed bound and never passes it, what is not due is not looked at, and a
//! lost sample moves a countdown by one sample.

#![allow(clippy::cast_precision_loss, reason = "counts of calls and samples are small")]

use crate::support::depth::trials;
use crate::support::plant;

use std::fmt::Write as _;

use deadbeat_codegen::internals::estimator::corrector::Corrector;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Generated, Generator};
use nalgebra::{DMatrix, DVector};
use plant::{Random, corpus, designed, exponential, matrix};

const H: f64 = 0.125;

/// What observes it: the table's name with its keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Gains {
    Luenberger,
    HighGain,
    FixedTime,
    Prescribed,
    Deadbeat,
    Table,
    Handover,
    Kalman,
}

const ALL: [Gains; 8] = [
    Gains::Luenberger,
    Gains::HighGain,
    Gains::FixedTime,
    Gains::Prescribed,
    Gains::Deadbeat,
    Gains::Table,
    Gains::Handover,
    Gains::Kalman,
];

/// A random plant with one output that is due at every so many calls.
struct Rare {
    a: DMatrix<f64>,
    c: DMatrix<f64>,
    every: usize,
    gains: Gains,
}

/// Samples of a countdown.
const SAMPLES: usize = 12;

impl Rare {
    fn new(random: &mut Random, gains: Gains) -> Self {
        let n = 2 + random.below(2);
        let mut entry = |most: f64| (random.within(-most, most) * 64.0).round() / 64.0;
        let a = DMatrix::from_fn(n, n, |_, _| entry(1.0));
        let c = DMatrix::from_fn(1, n, |_, _| entry(2.0));
        Self { a, c, every: 2 + random.below(4), gains }
    }

    fn poles(&self) -> Vec<f64> {
        (0..self.a.nrows()).map(|i| -1.0 - 0.25 * i as f64).collect()
    }

    fn text(&self) -> String {
        let n = self.a.nrows();
        let row = |row: Vec<f64>| row.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
        let rows = |m: &DMatrix<f64>| -> String {
            (0..m.nrows())
                .map(|r| format!("[{}]", row(m.row(r).iter().copied().collect())))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let time = SAMPLES as f64 * self.every as f64 * H;
        let process = row(vec![1e-3; n]);
        let noise = format!("process_noise = [{process}], measurement_noise = [1e-2]");
        let observer = match self.gains {
            Gains::Luenberger => format!("luenberger]\npoles = [{}]", row(self.poles())),
            Gains::HighGain => format!("high-gain]\ngain = 1.5\npoles = [{}]", row(self.poles())),
            Gains::FixedTime => "fixed-time-linear]".to_owned(),
            Gains::Prescribed => format!("prescribed-time]\ntime = {time}\nstop_before = 3"),
            Gains::Deadbeat => format!("prescribed-time]\ntime = {time}\nstop_before = 0"),
            Gains::Table => {
                format!("prescribed-time]\ntime = {time}\nkalman = {{ initial_deviation = 10, {noise} }}")
            }
            Gains::Handover => format!(
                "prescribed-time]\ntime = {time}\nstop_before = 3\nafter = 'handover'\nprocess_noise = [{process}]\n\
                 measurement_noise = [1e-2]"
            ),
            Gains::Kalman => format!("kalman]\nprocess_noise = [{process}]\nmeasurement_noise = [1e-2]"),
        };
        let mut text =
            format!("deadbeat = 1\nname = 'r'\n[plant]\nA = [{}]\nC = [{}]\n[outputs]\n", rows(&self.a), rows(&self.c));
        let _ = write!(
            text,
            "y = {{ every = {}, noise = 1 }}\n[observer.{observer}\n[target]\nsample_time = {H}\nscalar = 'f64'\n",
            self.every
        );
        text
    }

    fn counts_down(&self) -> bool {
        matches!(self.gains, Gains::Prescribed | Gains::Deadbeat | Gains::Table | Gains::Handover)
    }

    fn phi(&self, calls: usize) -> DMatrix<f64> {
        exponential(&(&self.a * (calls as f64 * H)))
    }
}

/// Random plants that can be observed, of each kind of gains in turn.
fn plants(kinds: &[Gains], each: usize) -> Vec<(Rare, Generated)> {
    let mut random = Random::new(41);
    let mut found = Vec::new();
    for gains in kinds {
        let drawn = std::iter::repeat_with(|| Rare::new(&mut random, *gains)).take(3 * each);
        let designed = drawn.filter_map(|rare| {
            let generated = Generator::new(&rare.text(), "r.toml").design().ok()?;
            Some((rare, generated))
        });
        let before = found.len();
        found.extend(designed.take(each));
        assert_eq!(found.len(), before + each, "most random plants are observed by {gains:?}");
    }
    found
}

fn sizes() -> usize {
    trials(2, 30)
}

/// What stands where no sample is due.
fn garbage(call: usize) -> f64 {
    [f64::NAN, 1e6, f64::INFINITY][call % 3]
}

fn recovery(generated: &Generated) -> usize {
    generated.design.estimator.downcast_ref::<Corrector>().expect("a corrector").recovery
}

/// From one sample to the next, `(I - K C) Phi^m` has the poles at m h that were asked for.
#[test]
fn poles_are_those_asked_for_from_sample_to_sample() {
    for (rare, generated) in plants(&[Gains::Luenberger], 2 * sizes()) {
        let n = rare.a.nrows();
        let gain = DMatrix::from_fn(n, 1, |i, _| matrix(&generated, "K")[i][0]);
        let around = (DMatrix::identity(n, n) - gain * &rare.c) * rare.phi(rare.every);
        let polynomial = |values: &[f64]| values.iter().fold(1.0, |product: f64, value| product * (0.5 - value));
        let asked: Vec<f64> = rare.poles().iter().map(|s| (s * rare.every as f64 * H).exp()).collect();
        // The characteristic polynomial at 1/2, at 0 and its trace: well conditioned, unlike single eigenvalues.
        let at_half = (DMatrix::identity(n, n) * 0.5 - &around).determinant();
        let size = around.norm().powi(i32::try_from(n).unwrap()).max(1.0);
        for (ours, theirs) in [
            (at_half, polynomial(&asked)),
            (around.determinant(), asked.iter().product()),
            (around.trace(), asked.iter().sum()),
        ] {
            assert!((ours - theirs).abs() < 1e-11 * size, "m = {}: {ours} and {theirs}", rare.every);
        }
    }
}

/// Without noise: the error at the printed call is the printed matrix times the initial one, nothing for deadbeat gains.
#[test]
fn what_is_left_of_an_initial_error_is_what_is_printed() {
    let mut random = Random::new(7);
    for (rare, generated) in plants(&ALL, sizes()) {
        let (n, valid) = (rare.a.nrows(), generated.design.valid_from_step);
        assert_eq!(valid % rare.every, 0, "{:?}: promised with a sample", rare.gains);
        let phi = rare.phi(1);
        let mut x = DVector::from_fn(n, |_, _| random.within(-1.0, 1.0));
        let mut interpreter = Interpreter::new(&generated.program);
        let (mut first, mut size) = (DVector::zeros(n), 0.0_f64);
        let gain = |o: &Vec<Vec<f64>>| o.iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
        for call in 0..=valid {
            let y = if call % rare.every == 0 { (&rare.c * &x)[0] } else { garbage(call) };
            let mut estimate = vec![0.0; n];
            let status = interpreter.step(&[y], &[], &mut estimate);
            let expected = if call < valid { Status::Converging } else { Status::Converged };
            assert_eq!(status, expected, "{:?}, every {}, call {call} of {valid}", rare.gains, rare.every);
            let error = DVector::from_vec(estimate) - &x;
            size = size.max(x.amax()).max(error.amax());
            if call == 0 {
                first = error;
            } else if call == valid {
                let certificate = &generated.design.certificate;
                let deadbeat = matches!(rare.gains, Gains::FixedTime | Gains::Deadbeat);
                for (i, row) in certificate.initial_gain.iter().enumerate() {
                    let left: f64 = row.iter().zip(first.iter()).map(|(gain, error)| gain * error).sum();
                    let left = if deadbeat { 0.0 } else { left };
                    // Each call rounds numbers of this size a few times; what is rounded passes like noise.
                    let rounding = 1e-14 * valid as f64 * size * gain(&certificate.noise_gain_l1);
                    assert!((error[i] - left).abs() < rounding, "{:?}: {} and {left}", rare.gains, error[i]);
                }
            }
            x = &phi * x;
        }
    }
}

/// The estimate of each call, for samples of a plant at rest that is disturbed as given; started at rest.
fn answers(rare: &Rare, generated: &Generated, samples: &[f64]) -> Vec<Vec<f64>> {
    let mut interpreter = Interpreter::new(&generated.program);
    let calls = 0..samples.len() * rare.every;
    let each = calls.map(|call| {
        let y = if call % rare.every == 0 { samples[call / rare.every] } else { garbage(call) };
        let mut estimate = vec![0.0; rare.a.nrows()];
        interpreter.step(&[y], &[], &mut estimate);
        estimate
    });
    each.collect()
}

/// Per state, the largest error that noise of size 1 with the worst signs makes at any of the promised calls.
fn attacked(rare: &Rare, generated: &Generated) -> Vec<f64> {
    let (n, m, valid) = (rare.a.nrows(), rare.every, generated.design.valid_from_step);
    let count = valid / m + recovery(generated) / m + 8;
    let pulse = |at: usize| (0..count).map(|k| f64::from(u8::from(k == at))).collect::<Vec<f64>>();
    let kernel: Vec<Vec<Vec<f64>>> = (0..count).map(|at| answers(rare, generated, &pulse(at))).collect();
    // The worst call of each state by the step's own responses, and then the step itself with the signs for it.
    let at = |call: usize, i: usize| kernel.iter().map(move |responses| responses[call][i]);
    let sum = |call: usize, i: usize| at(call, i).map(f64::abs).sum::<f64>();
    let reached = (0..n).map(|i| {
        let worst = (valid..count * m).max_by(|a, b| sum(*a, i).total_cmp(&sum(*b, i))).expect("promised calls");
        let signs: Vec<f64> = at(worst, i).map(f64::signum).collect();
        answers(rare, generated, &signs)[worst][i]
    });
    reached.collect()
}

/// No noise makes more than what is printed, at any phase; and noise with the worst signs makes as much.
#[test]
fn the_worst_noise_reaches_the_bound_and_never_passes_it() {
    for (rare, generated) in plants(&ALL, sizes()) {
        let reached = attacked(&rare, &generated);
        for (i, reached) in reached.iter().enumerate() {
            let bound = generated.design.certificate.noise_gain_l1[i][0];
            assert!(*reached <= bound * (1.0 + 1e-9), "{:?}, m = {}: {reached} above {bound}", rare.gains, rare.every);
            // One gain for all samples is summed up exactly; what was before the end of a countdown stays in the bound by its
            // magnitudes, once a thousandth of it is left.
            let least = if rare.counts_down() { 0.9 } else { 0.999 };
            assert!(*reached >= least * bound, "{:?}, m = {}: {reached} of {bound}", rare.gains, rare.every);
        }
    }
}

/// A sample that is lost in the countdown moves the promise by m calls, and no further; what is left then is what is printed
/// without it, carried by the plant for m calls more.
#[test]
fn a_lost_sample_moves_a_countdown_by_one_sample() {
    for (rare, generated) in plants(&[Gains::Prescribed, Gains::Deadbeat, Gains::Table], sizes()) {
        let (n, m, valid) = (rare.a.nrows(), rare.every, generated.design.valid_from_step);
        for lost in [1, 4, SAMPLES - 4] {
            let phi = rare.phi(1);
            let mut x = DVector::from_fn(n, |i, _| 1.0 - 0.5 * i as f64);
            let mut interpreter = Interpreter::new(&generated.program);
            let mut size = 0.0_f64;
            let mut promised = None;
            for call in 0..=valid + m + recovery(&generated) {
                let missing = call == lost * m;
                let y = if call % m == 0 && !missing { (&rare.c * &x)[0] } else { garbage(call) };
                // A number that is due is a sample: what is lost is NaN.
                let y = if missing { f64::NAN } else { y };
                let mut estimate = vec![0.0; n];
                let status = interpreter.step(&[y], &[], &mut estimate);
                size = size.max(x.amax());
                if call < valid + m {
                    assert_eq!(status, Status::Converging, "{:?}, lost {lost}, call {call}", rare.gains);
                } else {
                    assert_ne!(status, Status::Converging, "{:?}, lost {lost}, call {call}", rare.gains);
                }
                if status == Status::Converged && promised.is_none() {
                    promised = Some(call);
                    let error = (DVector::from_vec(estimate) - &x).amax();
                    if rare.gains == Gains::Deadbeat {
                        let gain = generated.design.certificate.noise_gain_l1.iter().flatten();
                        let gain = gain.fold(1.0, |most: f64, x| most.max(*x));
                        assert!(error < 1e-13 * (call as f64) * size * gain, "{error} at call {call}");
                    }
                }
                x = &phi * x;
            }
            assert!(promised.is_some(), "{:?}, lost {lost}: it converges", rare.gains);
        }
    }
}

/// Chains without a plant: a polynomial of their degree is followed exactly, by `differentiator` from its promised call on.
#[test]
fn a_polynomial_is_followed_between_samples() {
    let observers = [
        ("differentiator]\norder = 3\ntime = 1.5\nstop_before = 0", true),
        ("fixed-time-linear]\norder = 3", true),
        ("alpha-beta]\norder = 3\nalpha = 0.5", false),
    ];
    for (observer, exactly) in observers {
        let text = format!(
            "deadbeat = 1\nname = 'r'\n[outputs]\ny = {{ every = 3, noise = 1 }}\n[observer.{observer}\n[target]\n\
             sample_time = {H}\nscalar = 'f64'\n"
        );
        let generated = designed(&text);
        let valid = generated.design.valid_from_step;
        let mut interpreter = Interpreter::new(&generated.program);
        for call in 0..valid + 30 {
            let t = call as f64 * H;
            let truth = [2.0 - 3.0 * t + 0.5 * t * t, -3.0 + t, 1.0];
            let mut estimate = [0.0; 3];
            let y = if call % 3 == 0 { truth[0] } else { garbage(call) };
            let status = interpreter.step(&[y], &[], &mut estimate);
            assert_eq!(status == Status::Converged, call >= valid, "{observer}, call {call} of {valid}");
            for (estimate, truth) in estimate.iter().zip(truth).filter(|_| call >= valid) {
                // A millionth of an initial error of 3, where it dies out; peaks of a few of them.
                let most = if exactly { 1e-9 } else { 1e-4 };
                assert!((estimate - truth).abs() < most, "{observer}, call {call}: {estimate} and {truth}");
            }
        }
    }
}

/// The gain is that of the samples alone, and the bound is no smaller for being that of the calls between them too.
#[test]
fn the_gain_is_that_of_a_sample_time_from_sample_to_sample() {
    let text = corpus("camera_luenberger");
    let rare = designed(&text);
    let slow = plant::edited(&plant::edited(&text, ", every = 8", ""), "sample_time = 5e-3", "sample_time = 0.04");
    let slow = designed(&slow);
    for (ours, theirs) in matrix(&rare, "K").iter().flatten().zip(matrix(&slow, "K").iter().flatten()) {
        assert!((ours - theirs).abs() <= 1e-14 * theirs.abs(), "{ours} and {theirs}");
    }
    assert!(rare.design.certificate.noise_gain_l1[0][0] >= slow.design.certificate.noise_gain_l1[0][0]);
}
