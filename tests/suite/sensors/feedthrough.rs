//! Claim: an output that is affine in states and inputs is as good as one that shows states alone: the estimate from
//! `C x + D u + c` is exact to rounding from the promised call on, for random linear plants.

#![allow(clippy::cast_precision_loss, reason = "counts of calls and samples are small")]

use crate::support::{linear, plant};

use std::fmt::Write as _;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::Scalar;
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
