//! Claim: for every specification of the corpus, in its scalar (and in CI in the other too), the interpreter, Rust
//! unoptimised and at opt-level 3, and C by every compiler at -O0, -O2 and -O3 with the machine's
//! own instructions give the same bits and the same status, whatever is measured; and no estimate
//! is ever NaN or infinite.

use crate::support::{compile, corpus};

use std::collections::BTreeSet;

use compile::{Answer, Case, Sample, Workshop};
use corpus::{ODD, Random, Span, Subject, side_by_side, subjects};
use deadbeat_codegen::internals::estimator::corrector::Corrector;
use deadbeat_codegen::internals::estimator::window::Functional;
use deadbeat_codegen::promise::Convergence;

/// A smooth signal with some noise, in samples of the subject's window.
#[expect(clippy::cast_precision_loss, reason = "step counts are small")]
fn smooth(span: Span, step: usize, window: usize, place: usize, noise: f64, random: &mut Random) -> f64 {
    let turn = step as f64 / window as f64 + 0.37 * place as f64;
    let wave = 0.6 * (2.1 * turn).sin() + 0.3 * (0.7 * turn + 1.0).cos();
    span.centre + span.amplitude * (wave + noise * random.signed())
}

/// What happens to a measurement of this step. The window is filled cleanly first, spoilt in every
/// way, and filled again.
fn spoilt(value: f64, step: usize, window: usize, random: &mut Random) -> f64 {
    let since = step.saturating_sub(2 * window);
    match since {
        // One missing sample now and then: coasting, in which the model fills in.
        1..60 if random.one_in(8) => f64::NAN,
        // Bursts: of nothing, of odd numbers among good ones, of numbers out of range, of odd ones only.
        70..78 => f64::NAN,
        90..130 if random.one_in(3) => random.among(&ODD),
        130..170 if random.one_in(5) => value * 1e6,
        170..190 => random.among(&ODD),
        _ => value,
    }
}

/// window + 200 samples with faults, then two windows without.
fn case(subject: &Subject) -> Case {
    let mut random = Random::new(subject.name.bytes().map(u64::from).sum());
    let window = subject.window();
    // What converges by its innovations alone does so on signals that hardly change, and some time after others.
    let sensed = matches!(subject.generated.design.convergence, Convergence::Sensed { .. });
    let (pace, rest) = if sensed { (1_000_000, 5_000) } else { (window, 200) };
    let (measured, applied) = (subject.measured(), subject.applied());
    let mut samples = Vec::new();
    // After the last fault, as long as its status takes.
    let recovery =
        subject.generated.design.estimator.downcast_ref::<Corrector>().map_or(0, |corrector| corrector.recovery);
    for step in 0..4 * window + rest + recovery {
        let mut signal = |place: usize, span: &Span, spoil: fn(f64, usize, usize, &mut Random) -> f64| {
            let value = smooth(*span, step, pace, place, if sensed { 0.0 } else { 1e-3 }, &mut random);
            spoil(value, step, window, &mut random)
        };
        samples.push(Sample {
            measurements: measured.iter().enumerate().map(|(o, span)| signal(o, span, spoilt)).collect(),
            inputs: applied.iter().enumerate().map(|(i, span)| signal(i + 7, span, spoilt)).collect(),
        });
    }
    Case { program: subject.generated.program.clone(), samples }
}

/// Claim: interpreter, Rust and C agree bit for bit on the whole corpus.
#[test]
fn the_corpus_is_equal_everywhere() {
    let cases: Vec<Case> = subjects().iter().map(case).collect();
    let expected: Vec<Vec<Answer>> = side_by_side(&cases, Case::interpreted);
    for ((subject, case), answers) in subjects().iter().zip(&cases).zip(&expected) {
        let name = &case.program.name;
        let mut seen: BTreeSet<u8> = answers.iter().map(|answer| answer.status).collect();
        // Where samples are left out, those that are there determine the state in spite of all faults.
        let functional = subject.generated.design.estimator.downcast_ref::<Functional>();
        if functional.is_some_and(|functional| functional.irregular.is_some()) {
            seen.insert(2);
        }
        assert_eq!(seen, BTreeSet::from([0, 1, 2]), "{name}: the samples lead through every status");
        assert_eq!(answers.last().map(|it| it.status), Some(1), "{name}: converged again at the end");
        let finite = |answer: &Answer| answer.estimates.iter().all(|x| x.is_finite());
        assert!(answers.iter().all(finite), "{name}: every estimate is finite");
    }
    for (build, answers) in Workshop::new("equal_corpus").answers(&cases) {
        for ((case, expected), answers) in cases.iter().zip(&expected).zip(&answers) {
            let differs = expected.iter().zip(answers).position(|(a, b)| a != b);
            assert_eq!(answers.len(), expected.len());
            if let Some(step) = differs {
                let (expected, answer) = (&expected[step], &answers[step]);
                panic!("{build}, {}, call {step}:\n{expected:?} expected\n{answer:?}", case.program.name);
            }
        }
    }
}
