//! Claim: an output that is affine in states and inputs is as good as one that shows states alone: the estimate from
//! `C x + D u + c` is exact to rounding from the promised call on, for random linear plants.

#![allow(clippy::cast_precision_loss, reason = "counts of calls and samples are small")]

use crate::support::{linear, plant};

use std::fmt::Write as _;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::replay::{Recording, Replay, Signals};
use deadbeat_codegen::{Generator, Settings};
use linear::Linear;
use plant::{Random, UNIT, functional, rounding};

/// Plants that are tried.
const PLANTS: u64 = 200;

/// A plant's specification with D and c; by matrices there is no c.
fn text(linear: &Linear, direct: &[Vec<f64>], constants: &mut [f64]) -> String {
    let mut text = linear.text("[observer.window]");
    if !linear.equations {
        constants.fill(0.0);
        let rows: Vec<String> = direct.iter().map(|row| format!("{row:?}")).collect();
        return text.replacen("[inputs]", &format!("D = [{}]\n[inputs]", rows.join(", ")), 1);
    }
    for (o, (row, constant)) in direct.iter().zip(constants).enumerate() {
        let mut more = format!("{constant} + ");
        for (i, factor) in row.iter().enumerate() {
            let _ = write!(more, "({factor})*u{} + ", i + 1);
        }
        let begin = format!("y{} = {{ value = '", o + 1);
        assert!(text.contains(&begin));
        text = text.replacen(&begin, &format!("{begin}{more}"), 1);
    }
    text
}

#[test]
fn inputs_and_constants_are_taken_out_of_the_sample() {
    let (mut tried, mut refused) = (0, 0);
    for seed in 0..PLANTS {
        let mut kinds = Random::new(1_000 + seed);
        let shape =
            (1 + kinds.below(5), 1 + kinds.below(3), 1 + kinds.below(2), (kinds.below(3) == 0, kinds.below(2) == 0));
        let (mut linear, _) = Linear::new((shape.0, shape.1, shape.2, shape.3, kinds.below(8), seed));
        linear.delays.fill(0);
        let mut entry = || (kinds.within(-2.0, 2.0) * 64.0).round() / 64.0;
        let direct: Vec<Vec<f64>> = (0..shape.1).map(|_| (0..shape.2).map(|_| entry()).collect()).collect();
        let mut constants: Vec<f64> = (0..shape.1).map(|_| entry()).collect();
        let text = text(&linear, &direct, &mut constants);
        let generated = match Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design()
        {
            Ok(generated) => generated,
            Err(report) if report.diagnostics.iter().all(|d| d.code == codes::UNOBSERVABLE) => {
                refused += 1;
                continue;
            }
            Err(report) => panic!("{}\n{text}", report.render(false)),
        };
        let (mut run, step) = linear.run(2 * linear.steps + 10, seed);
        for (y, u) in run.measurements.iter_mut().zip(&run.inputs) {
            for (o, y) in y.iter_mut().enumerate() {
                *y += constants[o] + direct[o].iter().zip(u).map(|(d, u)| d * u).sum::<f64>();
            }
        }
        assert_eq!(generated.design.valid_from_step, linear.steps, "the promised call");
        let errors = run.through(&generated).errors(&run, linear.steps..run.states.len());
        let mut bounds = rounding(&generated, &run, &step, &[]);
        for (i, bound) in bounds.iter_mut().enumerate() {
            for (o, weights) in functional(&generated).outputs.iter().enumerate() {
                // Putting in and taking out: each term is rounded on either side, in sums of at most 6 + 8 + 2.
                let terms = 16.0 + constants[o].abs() + direct[o].iter().map(|d| d.abs()).sum::<f64>();
                *bound += UNIT * 8.0 * weights.l1(i) * terms;
            }
        }
        for (i, (error, bound)) in errors.iter().zip(&bounds).enumerate() {
            assert!(error <= bound, "seed {seed}, state {i}: {error:e} above {bound:e}\n{text}");
        }
        tried += 1;
    }
    println!("{tried} plants, {refused} refused");
    assert!(refused * 10 <= tried, "{refused} refused");
}

/// A cell of 1 As whose voltage has its current in it, sampled together.
fn cell(hold: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'cell'\n[states]\nx = {{ unit = 'V', derivative = '-1*i' }}\n[inputs]\n\
         i = {{ unit = 'A'{hold} }}\n[outputs]\nv = {{ unit = 'V', value = 'x - 0.1*i', noise = 1e-3 }}\n[observer.window]\n\
         window = 0.2\n[target]\nsample_time = 0.01\nscalar = 'f64'\n"
    )
}

/// A held input in an output that nobody said to be one is warned of; a sampled one is that of the recording's own row.
#[test]
fn an_input_that_is_sampled_with_the_output_is_that_of_its_row() {
    let warned = |hold: &str| {
        let report = Generator::new(&cell(hold), "cell.toml").check();
        assert!(!report.has_errors(), "{}", report.render(false));
        report.diagnostics.iter().any(|mistake| mistake.code == codes::HELD_IN_OUTPUT)
    };
    assert!(warned(""));
    assert!(!warned(", hold = 'zero'") && !warned(", hold = 'first'") && !warned(", hold = 'sampled'"));
    // i = sin 2t, so that x = 1 - (1 - cos 2t)/2.
    let row = |k: u32| {
        let t = f64::from(k) * 0.01;
        let (i, x) = ((2.0 * t).sin(), 1.0 - (1.0 - (2.0 * t).cos()) / 2.0);
        format!("{t},{},{i},{x}\n", x - 0.1 * i)
    };
    let rows: String = (0..400).map(row).collect();
    let largest = |hold: &str| {
        let generated = plant::designed(&cell(hold));
        let recording = Recording::open(std::io::Cursor::new(format!("t,v,i,x\n{rows}")), "cell.csv").unwrap();
        let mut replay = Replay::new(&generated, recording, &Signals::default()).unwrap();
        assert!(replay.by_ref().all(|step| step.is_ok()));
        replay.verdict().errors("x").and_then(|errors| errors.max).unwrap()
    };
    // A straight line is off by h^2/8 times the second derivative, 4 A/s^2, for a window of 0.2 s. The row before is off by
    // 0.1 ohm times the 0.02 A of a sample, less the charge of half a sample a call, for half of the window: 1e-3 V.
    let (sampled, held) = (largest(", hold = 'sampled'"), largest(", hold = 'zero'"));
    assert!(sampled < 5e-5 * 0.2 * 2.0, "{sampled}");
    assert!(held > 8e-4, "{held}");
}
