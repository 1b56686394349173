//! Claim: 002's constants and trajectories are those of an independent computation in 70 digits; unknowns that
//! no window tells apart are refused with the number; the status follows the excitation; and samples that are
//! missing are what the found unknowns foresee.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls are small"
)]

use crate::support::{plant, truths};

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::internals::real::{Precision, Real};
use deadbeat_codegen::internals::sampled::unknowns::paper::{Exosystem, Times, constants};
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator};
use plant::{Hold, NOTHING_YET, Random, Run, Truth, corpus, designed, designed_in, edited, matrix};
use serde_json::Value;
use truths::truth;

const GOLDEN: &str = include_str!("../../golden/double_integrator_002.json");
const TRAJECTORY: &str = include_str!("../../golden/traj_double_integrator_002.json");

/// 002's example with one force.
fn force(observer: &str, gamma: &str, output: &str, sample_time: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'force'\n[states]\nx1 = {{ derivative = 'x2' }}\nx2 = {{ derivative = '{gamma}' }}\n\
         [outputs]\ny = {{ value = 'x1'{output} }}\n[unknowns]\ne = {{}}\n[observer.parameters]\n{observer}\n\
         [target]\nsample_time = {sample_time}\nscalar = 'f64'\n"
    )
}

/// The numbers of a list of a case of the golden file, whatever its depth, each read as the nearest double.
fn golden(case: &str, key: &str) -> Vec<f64> {
    let case = GOLDEN.split_once(&format!("\"{case}\": {{")).unwrap_or_else(|| panic!("no {case}")).1;
    let list = case.split_once(&format!("\"{key}\": [")).unwrap_or_else(|| panic!("no {key}")).1;
    let mut depth = 1;
    let end = list.find(|c| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        depth == 0
    });
    let words = list[..end.unwrap()].split(|c: char| "[], \n".contains(c)).filter(|word| !word.is_empty());
    words.map(|word| word.parse().unwrap()).collect()
}

/// E, E^-1, kappa, W, `E_h`, theta of the constant force: the nearest doubles.
#[test]
fn the_constants_of_a_constant_force_are_the_nearest_doubles() {
    for (case, integration) in [("T1", "1"), ("T_half", "0.5")] {
        for (delay, letters) in [("", vec!["E", "Einv", "kappa", "W"]), (", delay = 0.3", vec!["E", "E_h", "theta"])] {
            let observer = format!("window = 1\nform = 'paper'\nintegration_window = {integration}");
            let generated = designed(&force(&observer, "e", delay, "0.1"));
            for letter in letters {
                let ours = matrix(&generated, letter).concat();
                // Of kappa, W and theta the golden file has those of the force sin t behind.
                assert_eq!(ours, golden(case, letter)[..ours.len()], "{case} {letter}");
            }
        }
    }
}

/// The same of the force `sin t`, from the blocks of one Gramian times w(2) = (sin 2, cos 2).
#[test]
fn the_constants_of_a_sine_come_from_its_exosystem() {
    let plant = designed(&force("window = 1", "e*sin(t)", "", "0.1")).plant;
    let exosystem = Exosystem::of(&plant.unknowns[0]).unwrap();
    let members = exosystem.at(2.0);
    let p = Precision::bits(256);
    let real = |x: f64| Real::from_f64(x, p).unwrap();
    for (case, integration) in [("T1", 1.0), ("T_half", 0.5)] {
        let (window, integration) = (real(1.0), real(integration));
        let delay = Real::from_i64(3, p) / Real::from_i64(10, p);
        let times = Times { window: &window, integration: &integration, delay: &delay };
        let found = constants(&plant, &exosystem, times, p).unwrap();
        for (matrix, letter) in [(&found.kappa, "kappa"), (&found.w, "W"), (&found.theta, "theta")] {
            let rows = matrix.to_f64();
            let theirs = golden(case, letter);
            for (row, theirs) in rows.iter().zip(&theirs[theirs.len() - rows.len()..]) {
                let ours: f64 = row.iter().zip(&members).map(|(a, w)| a * w).sum();
                // Two products of doubles, each rounded twice, of magnitudes below 1.
                assert!((ours - theirs).abs() <= 4.0 * f64::EPSILON, "{case} {letter}: {ours} against {theirs}");
            }
        }
        assert_eq!(found.e_h.to_f64().concat(), golden(case, "E_h"));
    }
}

/// The golden trajectory: exact from the time of each theorem, and from the window's end in the joint form.
#[test]
fn the_golden_trajectory_is_estimated() {
    let golden: Value = serde_json::from_str(TRAJECTORY).unwrap();
    let rows = golden["rows"].as_array().unwrap();
    let eps = golden["eps"].as_f64().unwrap();
    let paper = "window = 1\nform = 'paper'";
    let cases = [
        (paper, "", "y_nodelay", 20),
        ("window = 1", "", "y_nodelay", 10),
        (paper, ", delay = 0.3", "y_delay0p3", 26),
        ("window = 1.3", ", delay = 0.3", "y_delay0p3", 13),
    ];
    for (observer, output, key, from) in cases {
        let generated = designed(&force(observer, "e", output, "0.1"));
        assert_eq!(generated.design.valid_from_step, from, "{observer}{output}");
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = [0.0; 3];
        for (call, row) in rows.iter().enumerate() {
            let sample = row[key].as_f64().unwrap_or(NOTHING_YET);
            let status = interpreter.step(&[sample], &[], &mut estimate);
            assert_eq!(status, if call < from { Status::Converging } else { Status::Converged });
            if call >= from {
                let x = row["x"].as_array().unwrap();
                let truth = [x[0].as_f64().unwrap(), x[1].as_f64().unwrap(), eps];
                for (ours, theirs) in estimate.iter().zip(truth) {
                    // Gains below 12 times rounding errors of samples below 10, a few hundred in the sums.
                    assert!(
                        (ours - theirs).abs() <= 1e-13 * theirs.abs().max(1.0),
                        "{observer}{output}, call {call}: {ours}, {theirs}"
                    );
                }
            }
        }
        assert!(rows.len() > from + 5, "the trajectory goes on");
    }
}

/// The one error of a specification.
fn refused(text: &str) -> (&'static str, String) {
    let report = Generator::new(text, "test.toml").design().map(|_| ()).unwrap_err();
    assert_eq!(report.diagnostics.len(), 1, "{}", report.render(false));
    assert!(report.diagnostics[0].help.is_some());
    (report.diagnostics[0].code, report.render(false))
}

/// Unknowns that do the same to the output, or what a state does, are named with their Schur complement.
#[test]
fn unknowns_that_cannot_be_told_apart_are_refused() {
    let two = |first: &str, second: &str| {
        let text = force("window = 1", "0", "", "0.1");
        let text = edited(&text, "e = {}", "e = {}\nf = {}");
        edited(
            &edited(&text, "'x2'", &format!("'x2 + {first}'")),
            "derivative = '0'",
            &format!("derivative = '{second}'"),
        )
    };
    let (code, text) = refused(&two("e", "f"));
    assert_eq!(code, codes::UNOBSERVABLE);
    assert!(text.contains("the outputs do not tell the unknown `e` apart from the state `x2`"), "{text}");
    assert!(text.contains("smallest singular value of the Schur complement"), "{text}");
    let (code, text) = refused(&two("0", "e + f"));
    assert_eq!(code, codes::UNOBSERVABLE);
    assert!(text.contains("do not tell the unknowns `e` and `f` apart"), "{text}");
    let (code, text) = refused(&two("0", "e*cos(t) + 3*f*cos(t)"));
    assert_eq!(code, codes::UNOBSERVABLE);
    assert!(text.contains("no window tells the unknown `f` apart"), "{text}");
    // A factor that is there but shows nothing.
    let (code, text) = refused(&edited(
        &force("window = 1", "e*sin(t)", "", "0.1"),
        "name = 'force'\n[states]",
        "name = 'force'\n[states]\nz = { derivative = '-z' }",
    ));
    assert_eq!(code, codes::UNOBSERVABLE);
    assert!(text.contains("the state `z` cannot be estimated"), "{text}");
}

/// Assumption 2 fails for {1, sin t} (two zeros of det M per period); the joint form takes the same plant.
#[test]
fn a_vanishing_determinant_is_refused_and_the_joint_form_is_not() {
    let text = |observer: &str| edited(&force(observer, "e + f*sin(t)", "", "0.1"), "e = {}", "e = {}\nf = {}");
    let (code, rendered) = refused(&text("window = 1\nform = 'paper'\nshifts = [0, 0.8]"));
    assert_eq!(code, codes::METHOD_CANNOT);
    assert!(rendered.contains("det M(t) vanishes") && rendered.contains("it changes its sign at t ="), "{rendered}");
    let generated = designed(&text("window = 2.8"));
    assert!(
        generated.design.notes.iter().any(|note| note.contains("every one of 1000 windows")),
        "{:?}",
        generated.design.notes
    );
}

/// What the paper's form does not take says so and names the joint form.
#[test]
fn the_papers_form_names_the_joint_one() {
    let paper = "window = 1\nform = 'paper'";
    let never_zero = force(paper, "e*(2 + sin(t))", "", "0.1");
    assert!(refused(&never_zero).1.contains("designed for constant factors"));
    assert!(refused(&force(paper, "e*x1", "", "0.1")).1.contains("depends on more than time"));
    let late = edited(&force(paper, "e", ", delay = 0.3", "0.1"), "form = 'paper'", "form = 'paper'\nshifts = [0.1]");
    assert!(refused(&late).1.contains("`shifts` belong to Theorem 1"));
    let joint = force("window = 1\nshifts = [0]", "e", "", "0.1");
    assert!(refused(&joint).1.contains("`shifts` belongs to `form = \"paper\"`"));
    let share = force("window = 1\nexcitation = 2", "e*sin(t)", "", "0.1");
    let large = edited(&force("window = 1", "1e300*e*sin(t)", "", "0.1"), "'f64'", "'f32'");
    assert!(refused(&large).1.contains("does not fit into f32"));
    assert!(refused(&share).1.contains("`excitation` must be between 0 and 1"));
}

/// x' = v, v' = -2x - v + e u, with an input that stops and starts again.
fn driven() -> (Generated, Truth) {
    let text = edited(&force("window = 1", "-2*x1 - x2 + e*u", "", "0.1"), "[outputs]", "[inputs]\nu = {}\n[outputs]");
    let truth = Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], -2.0 * x[0] - x[1] + x[2] * u[0], 0.0]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-1.0, 1.0), (-1.0, 1.0), (1.0, 2.0)],
        input: vec![(-1.0, 1.0)],
        exact: true,
    };
    (designed(&text), truth)
}

/// A run of `driven` whose input is zero for some calls.
fn stopped(truth: &Truth, calls: usize, quiet: &std::ops::Range<usize>) -> Run {
    let mut run = truth.run(0.1, 1, calls, 3);
    let mut x = run.states[0].clone();
    for call in 0..calls {
        if call > 0 {
            if quiet.contains(&call) {
                run.inputs[call] = vec![0.0];
            }
            let u = run.inputs[call].clone();
            let rhs = |_: f64, x: &[f64]| (truth.change)(0.0, x, &u);
            x = plant::advance(&rhs, 0.0, 0.1, &x);
        }
        run.states[call].clone_from(&x);
        run.measurements[call] = vec![x[0]];
    }
    run
}

/// No input, no excitation: the unknown keeps its value to the last bit, the state goes on exactly, and the
/// status says Converging until a sample with an input is in the window again.
#[test]
fn the_status_follows_the_excitation() {
    let (generated, truth) = driven();
    let (steps, quiet) = (generated.design.valid_from_step, 30..60);
    let run = stopped(&truth, 90, &quiet);
    let answers = run.through(&generated);
    for (call, status) in answers.statuses.iter().enumerate() {
        // The interval that ends at call 29 is the last with an input; the window of call 29 + N starts there.
        let excited = call < quiet.start + steps - 1 || call >= quiet.end;
        let expected = if call >= steps && excited { Status::Converged } else { Status::Converging };
        assert_eq!(*status, expected, "call {call}");
    }
    let held = answers.estimates[quiet.start + steps - 2][2];
    for call in quiet.start + steps - 1..quiet.end {
        assert_eq!(answers.estimates[call][2].to_bits(), held.to_bits());
    }
    // Weights below 100, rounding errors of some tens of u; the first and last intervals hardly excite.
    for (i, error) in answers.errors(&run, steps..run.states.len()).iter().enumerate() {
        assert!(*error < 1e-9, "state {i}: {error:e}");
    }
}

/// A plant at rest tells nothing of a factor of its position, whatever noise is measured; a plant that swings does.
#[test]
fn noise_alone_is_no_excitation() {
    let text = "deadbeat = 1\nname = 'spring'\n[states]\nx = { derivative = 'v' }\nv = { derivative = '-4*x - a*x' }\n\
                [unknowns]\na = {}\n[outputs]\nx = { value = 'x', noise = 1e-3, range = [-10, 10] }\n\
                [observer.parameters]\nwindow = 0.5\n[target]\nsample_time = 0.01\nscalar = 'f64'\n";
    let generated = designed(text);
    let steps = generated.design.valid_from_step;
    let mut random = Random::new(7);
    for (amplitude, excited) in [(0.0, false), (1.0, true)] {
        let mut run = Run::default();
        for call in 0..400 {
            // x'' = -9 x: a is 5.
            let x = amplitude * f64::cos(0.03 * f64::from(call));
            run.measurements.push(vec![x + random.within(-1e-3, 1e-3)]);
            run.inputs.push(vec![]);
        }
        let answers = run.through(&generated);
        let converged = answers.statuses.iter().filter(|status| **status == Status::Converged).count();
        println!("amplitude {amplitude}: {converged} of 400 converged");
        assert_eq!(converged, if excited { 400 - steps } else { 0 }, "amplitude {amplitude}");
    }
}

/// In single precision the same samples give the same unknowns to what its rounding errors allow.
#[test]
fn single_precision_keeps_its_digits() {
    let text = edited(&corpus("unknown_force_network"), "window = 1\n", "window = 1\nexcitation = 1e-3\n");
    let (single, double) = (designed_in(&text, Scalar::F32), designed(&text));
    let run = truth("unknown_force_network").unwrap().run(0.01, 1, 400, 2);
    let (coarse, fine) = (run.through(&single), run.through(&double));
    let mut largest = [0.0_f64; 6];
    for call in double.design.valid_from_step..400 {
        assert_eq!(coarse.statuses[call], Status::Converged, "call {call}");
        for (largest, (a, b)) in largest.iter_mut().zip(coarse.estimates[call].iter().zip(&fine.estimates[call])) {
            *largest = largest.max((a - b).abs());
        }
    }
    println!("{largest:?}");
    // Samples of about 1 m are rounded by 6e-8, the responses of a hundred samples by some times that; the gains to the
    // weights are below a few thousand, to position and speed below 5 and 300.
    for (largest, bound) in largest.iter().zip([3e-6, 2e-4, 3e-3, 3e-3, 3e-3, 3e-3]) {
        assert!(*largest < bound, "{largest:e}");
    }
}

/// Without excitation from the start there is no estimate but the start, and a missing sample has no prediction.
#[test]
fn before_the_first_excitation_there_is_nothing_to_predict_with() {
    let (generated, truth) = driven();
    let steps = generated.design.valid_from_step;
    let mut run = stopped(&truth, 60, &(0..25));
    run.measurements[20] = vec![f64::NAN];
    let answers = run.through(&generated);
    for call in 0..60 {
        // The window starts again behind call 20, and has its first input at call 25.
        let expected = if call < 21 + steps { Status::Converging } else { Status::Converged };
        assert_eq!(answers.statuses[call], expected, "call {call}");
        if call < 21 + steps {
            assert_eq!(answers.estimates[call][2], 0.0);
        }
    }
}

/// Factors of time: a prediction is exact, so the estimate is while it coasts; a late output likewise.
#[test]
fn missing_samples_are_predicted_with_the_unknowns() {
    for delay in [0.0, 0.3] {
        let output = if delay > 0.0 { ", delay = 0.3" } else { "" };
        let generated = designed(&force("window = 2", "-x1 + e*sin(2*t)", output, "0.1"));
        let truth = Truth {
            discrete: false,
            change: Box::new(|t, x, _| vec![x[1], -x[0] + x[2] * (2.0 * t).sin(), 0.0]),
            outputs: Box::new(|x, _| vec![x[0]]),
            delays: vec![delay],
            holds: vec![],
            start: vec![(-1.0, 1.0), (-1.0, 1.0), (1.0, 2.0)],
            input: vec![],
            exact: true,
        };
        let (steps, late) = (generated.design.valid_from_step, (delay * 10.0_f64).round() as usize);
        let mut run = truth.run(0.1, 1, 5 * steps, 1);
        let missing = 2 * steps..2 * steps + 8;
        missing.clone().for_each(|call| run.measurements[call] = vec![f64::NAN]);
        let answers = run.through(&generated);
        for (call, status) in answers.statuses.iter().enumerate() {
            let expected = match call {
                call if call < steps => Status::Converging,
                call if (missing.start..missing.end + steps - late).contains(&call) => Status::Coasting,
                _ => Status::Converged,
            };
            assert_eq!(*status, expected, "delay {delay}, call {call}");
        }
        // Gains from noise are printed: below 40 here; eight predictions in a row, each with rounding errors of tens of u.
        for (i, error) in answers.errors(&run, steps..run.states.len()).iter().enumerate() {
            assert!(*error < 1e-11, "delay {delay}, state {i}: {error:e}");
        }
    }
}
