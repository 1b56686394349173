//! Claim: functions that a step makes of others, log10 to hypot, have the same bits in the interpreter, Rust and C, in both
//! float types, and give the estimate that the same terms computed elsewhere give.

use crate::support::{compile, corpus, plant};

use compile::{Case, Sample, Workshop};
use corpus::Random;
use deadbeat_codegen::program::Scalar;
use plant::designed_in;

/// Every function once, of a measured state and of an input.
fn text(name: &str) -> String {
    format!(
        "deadbeat = 1\nname = '{name}'\n[states]\nx = {{ derivative = 'z' }}\nz = {{ derivative = '-z + log10(3 + x) + \
         log2(3 + u) + exp2(x) + sinh(u) + cosh(x) + cbrt(u) + floor(3*x) + hypot(x, u) + clamp(4*u, x, 1)' }}\n\
         [inputs]\nu = {{}}\n[outputs]\nx = {{ value = 'x', range = [-2, 2] }}\n[observer.window]\nwindow = 0.05\n\
         [target]\nsample_time = 0.01\n"
    )
}

#[test]
fn composed_functions_are_equal_everywhere() {
    let mut cases = Vec::new();
    for (name, scalar) in [("in_single", Scalar::F32), ("in_double", Scalar::F64)] {
        let mut random = Random::new(11);
        let mut number = || if random.one_in(40) { 0.0 } else { 2.0 * random.signed() };
        let samples = (0..400).map(|_| Sample { measurements: vec![number()], inputs: vec![number()] }).collect();
        cases.push(Case { program: designed_in(&text(name), scalar).program, samples });
    }
    let expected: Vec<_> = cases.iter().map(Case::interpreted).collect();
    for answers in &expected {
        assert!(answers.iter().all(|answer| answer.estimates.iter().all(|x| x.is_finite())));
        assert!(answers.iter().skip(6).any(|answer| answer.estimates[1] != 0.0));
    }
    for (build, answers) in Workshop::new("equal_functions").answers(&cases) {
        for ((case, expected), answers) in cases.iter().zip(&expected).zip(&answers) {
            assert_eq!(expected.len(), answers.len());
            let differs = expected.iter().zip(answers).position(|(a, b)| a != b);
            assert_eq!(differs, None, "{build}, {}", case.program.name);
        }
    }
}

/// A discrete plant that is its function: the estimate of the next state is the function's value.
#[test]
fn an_estimate_has_the_functions_values() {
    for (function, at, value) in [
        ("log10(u)", 1000.0, 3.0),
        ("log2(u)", 0.125, -3.0),
        ("exp2(u)", -1.5, std::f64::consts::FRAC_1_SQRT_2 / 2.0),
        ("sinh(u)", 1.0, 1.175_201_193_643_801_4),
        ("cosh(u)", -2.0, 3.762_195_691_083_631_4),
        ("cbrt(u)", -27.0, -3.0),
        ("floor(u)", -1.5, -2.0),
        ("hypot(u, 2.4)", 1.0, 2.6),
        ("clamp(u, -1, 2)", 7.0, 2.0),
    ] {
        let text = format!(
            "deadbeat = 1\nname = 'f'\n[states]\na = {{ next = '{function}' }}\nb = {{ next = 'b + a' }}\n[inputs]\nu = {{}}\n\
             [outputs]\nb = {{ value = 'b' }}\n[observer.window]\nwindow = 0.03\n[target]\nsample_time = 0.01\n"
        );
        let program = designed_in(&text, Scalar::F64).program;
        let samples =
            (0..10_i32).map(|k| Sample { measurements: vec![f64::from(k) * value], inputs: vec![at] }).collect();
        let answers = Case { program, samples }.interpreted();
        let found = answers.last().unwrap().estimates[0];
        // A few roundings of a number of that size.
        assert!(
            (found - value).abs() <= 8.0 * f64::EPSILON * value.abs().max(1.0) * 10.0,
            "{function}: {found} {value}"
        );
    }
}
