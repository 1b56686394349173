//! Claim: the interpreter, Rust unoptimised and at opt-level 3, gcc and clang from -O0 to -O3 with
//! the machine's own instructions give the same bits for any Program and any input, and neither
//! they nor their C++ warn about the emitted code.

use crate::support::depth::trials;
use crate::support::{compile, random_program};

use compile::{Answer, Case, Sample, Workshop};
use deadbeat_codegen::program::builder::Builder;
use deadbeat_codegen::program::{Field, Function, Kind, Program, Scalar, Status, Value};
use random_program::{random_inputs, random_program};

/// How many random Programs.
fn programs() -> u64 {
    trials(30, 300)
}

/// How many calls of each.
const STEPS: usize = 40;

#[test]
fn random_programs_are_equal() {
    let cases: Vec<Case> = (0..programs()).map(|seed| case(seed, random_program(seed))).collect();
    compare(&Workshop::new("equal_random"), &cases);
}

/// Programs that are split into functions, with loops whose bodies are split too.
#[test]
fn long_programs_are_equal() {
    let cases: Vec<Case> = (0..4).map(|seed| case(seed, long_program(seed))).collect();
    compare(&Workshop::new("equal_long"), &cases);
}

/// The Program with random samples.
fn case(seed: u64, program: Program) -> Case {
    let samples = random_inputs(seed, &program, STEPS)
        .into_iter()
        .map(|(measurements, inputs)| Sample { measurements, inputs })
        .collect();
    Case { program, samples }
}

/// Every build answers as the interpreter does, and every dialect takes the C files.
fn compare(workshop: &Workshop, cases: &[Case]) {
    workshop.dialects(cases);
    let expected: Vec<Vec<Answer>> = cases.iter().map(Case::interpreted).collect();
    for (build, answers) in workshop.answers(cases) {
        assert_eq!(answers.len(), cases.len());
        for ((case, expected), answers) in cases.iter().zip(&expected).zip(&answers) {
            let differs = expected.iter().zip(answers).position(|(a, b)| a != b);
            if let Some(step) = differs {
                let (expected, answer) = (&expected[step], &answers[step]);
                panic!("{build}, {}, call {step}:\n{expected:?} expected\n{answer:?}", case.program.name);
            }
        }
    }
}

/// A Program of some 500 statements, with values of every type that are used far from where they
/// are defined, and a loop with a long body.
fn long_program(seed: u64) -> Program {
    let scalar = if seed.is_multiple_of(2) { Scalar::F32 } else { Scalar::F64 };
    let mut b = Builder::new(&format!("long_{seed}"), scalar, 0.25);
    let field = |name: String| Field { name, unit: "V".to_owned(), doc: String::new(), kind: Kind::Float };
    let measured = (0..3).map(|at| b.measurement(field(format!("y{at}")))).collect::<Vec<_>>();
    let known = b.input(field("u".to_owned()));
    let memory = b.float_cell("memory", "the last sum", 0.5);
    let newest = b.index_cell("newest", "slot of age 0", 0);
    let ring = b.ring("ring", "samples", 7, 0.0);
    let columns: Vec<String> = (0..5).map(|at| format!("gain {at}")).collect();
    let rows = (0..7_u8).map(|row| (0..5_u8).map(|column| f64::from(row * column) / 8.0 - 1.5).collect()).collect();
    let table = b.table("GAINS", "Long rows of gains.", columns, rows);

    b.section("samples");
    let mut floats: Vec<Value> = measured.iter().map(|at| b.read_measurement(*at)).collect();
    let first = floats[0];
    let good: Vec<Value> = floats.iter().map(|value| b.in_range(*value, -2.0, 1.5)).collect();
    let slot = b.read(newest);
    let slot = b.advance(slot, 7);
    b.set(newest, slot);
    b.set_ring(ring, slot, first);
    let before = b.read(memory);
    floats.push(before);
    for section in 0..3 {
        b.section(&format!("chain {section}"));
        chain(&mut b, &mut floats, &good, 60);
    }
    b.section("window");
    let ends = b.loop_over(table, &[floats[0], slot, good[0]], |b, carried| {
        let mut inner: Vec<Value> = (0..5).map(|column| b.gain(column)).collect();
        let sample = b.read_ring(ring, carried[1]);
        inner.extend([sample, carried[0], floats[3]]);
        chain(b, &mut inner, &good, 200);
        let sum = b.sum(&inner[190..]);
        let sum = b.call(Function::Tanh, &[sum]);
        let other = b.not(carried[2]);
        let back = b.retreat(carried[1], 7);
        vec![sum, back, other]
    });
    b.section("result");
    floats.push(ends[0]);
    let applied = b.read_input(known);
    floats.push(applied);
    chain(&mut b, &mut floats, &good, 60);
    let sum = b.sum(&floats);
    let sum = b.call(Function::Atan, &[sum]);
    b.set(memory, sum);
    b.estimate(field("x".to_owned()), sum);
    b.estimate(field("first".to_owned()), first);
    let (yes, no) = (b.status(Status::Converged), b.status(Status::Coasting));
    let both = b.and(ends[2], good[2]);
    let status = b.select(both, yes, no);
    b.report(status);
    b.finish()
}

/// Statements that use what was defined long before.
fn chain(b: &mut Builder, floats: &mut Vec<Value>, good: &[Value], count: usize) {
    for at in 0..count {
        let (near, far) = (floats[floats.len() - 1], floats[at % floats.len()]);
        let value = match at % 4 {
            0 => b.add(near, far),
            1 => b.mul(near, far),
            2 => b.select(good[at % good.len()], near, far),
            _ => b.sub(far, near),
        };
        floats.push(value);
    }
}
