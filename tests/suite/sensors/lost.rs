//! Claim: where an output is lost for good and the others show the state, the estimate becomes that of the others alone,
//! whatever their noise is beside the lost one's: exactly what a design for them alone gives. The status says that the
//! bound of all outputs no longer holds, and the certificate what it has become. This is so by default.

#![allow(clippy::cast_precision_loss, reason = "counts of calls are small")]

use crate::support::depth::trials;
use crate::support::{linear, plant};

use deadbeat_codegen::Generated;
use deadbeat_codegen::internals::diagnostic::codes;
use deadbeat_codegen::internals::estimator::window::Functional;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generator, Settings};
use linear::Linear;
use plant::{Run, designed, designed_in, edited};

/// A height by an accurate sonar that reaches 4 m and a coarse barometer, beside an accelerometer.
fn height(missing: &str) -> String {
    format!(
        "deadbeat = 1
name = 'height'
[states]
z = {{ unit = 'm', derivative = 'v' }}
v = {{ unit = 'm/s', derivative = 'acc' }}
[inputs]
acc = {{ unit = 'm/s^2' }}
[outputs]
sonar = {{ unit = 'm', value = 'z', noise = 0.02, range = [0.1, 4] }}
baro = {{ unit = 'm', value = 'z', noise = 0.5 }}
[observer.window]
window = 2
{missing}
[target]
sample_time = 0.02
"
    )
}

/// A climb at 1 m/s while the accelerometer says 0.05 m/s^2: from 4 m on the sonar is out of its range.
fn climb() -> Run {
    let mut run = Run::default();
    for call in 0..=1000 {
        let z = 0.5 + 0.02 * f64::from(call);
        run.measurements.push(vec![z, z]);
        run.inputs.push(vec![0.05]);
        run.states.push(vec![z, 1.0]);
    }
    run
}

/// A line through the barometer's last 101 samples, less what the accelerometer says, ends at 20.5165 m and 1.05 m/s:
/// least squares by hand.
#[test]
fn a_barometer_goes_on_where_the_sonar_ends() {
    for missing in ["missing = 'left-out'", ""] {
        for (scalar, tolerance) in [(Scalar::F32, 2e-4), (Scalar::F64, 1e-9)] {
            let generated = designed_in(&height(missing), scalar);
            let answers = climb().through(&generated);
            let last = answers.estimates.last().expect("an answer");
            let errors = [last[0] - 20.5165, last[1] - 1.05];
            assert!(errors.iter().all(|error| error.abs() < tolerance), "{missing} {scalar}: {last:?}");
            for (call, status) in answers.statuses.iter().enumerate() {
                let expected = match call {
                    _ if call < 100 => Some(Status::Converging),
                    // Until the bound without samples lost is passed.
                    _ if call <= 175 => Some(Status::Converged),
                    _ if call < 276 => None,
                    _ => Some(Status::Coasting),
                };
                assert!(expected.is_none_or(|expected| expected == *status), "{scalar}, call {call}: {status:?}");
            }
        }
    }
}

/// Whatever the two noises are: with one output lost, the estimate is that of a plant that never had it.
#[test]
fn any_ratio_of_noises_is_carried() {
    for scalar in [Scalar::F32, Scalar::F64] {
        for noise in ["0.1", "1", "20", "500", "1e4"] {
            let text = edited(&height("missing = 'left-out'"), "noise = 0.5", &format!("noise = {noise}"));
            let alone = edited(&text, "sonar = { unit = 'm', value = 'z', noise = 0.02, range = [0.1, 4] }\n", "");
            let (both, alone) = (designed_in(&text, scalar), designed_in(&alone, scalar));
            let run = climb();
            let mut without = run.clone();
            without.measurements.iter_mut().for_each(|row| *row = vec![row[1]]);
            let (both, alone) = (run.through(&both), without.through(&alone));
            let tolerance = if scalar == Scalar::F32 { 1e-3 } else { 1e-9 };
            for call in 400..1000 {
                let (a, b) = (&both.estimates[call], &alone.estimates[call]);
                assert!((0..2).all(|i| (a[i] - b[i]).abs() < tolerance), "{noise} {scalar} {call}: {a:?} {b:?}");
            }
        }
    }
}

/// A position encoder beside an accurate velocity sensor that is lost: a line through the encoder's last 51 samples, of a
/// motion that the model does not know, ends at 2.9959 m and 1.95 m/s: least squares by hand.
#[test]
fn an_encoder_goes_on_where_the_velocity_sensor_ends() {
    let text = "deadbeat = 1
name = 'axis'
[states]
x = { derivative = 'v' }
v = { derivative = '0' }
[outputs]
x = { value = 'x', noise = 0.06 }
v = { value = 'v', noise = 0.03 }
[observer.window]
window = 0.5
[target]
sample_time = 0.01
";
    let generated = designed(text);
    let mut run = Run::default();
    for call in 0..=400 {
        let t = 0.01 * f64::from(call - 400);
        let lost = call > 100;
        let v = if lost { f64::NAN } else { 2.0 + 0.2 * t };
        run.measurements.push(vec![3.0 + 2.0 * t + 0.1 * t * t, v]);
        run.inputs.push(Vec::new());
    }
    let answers = run.through(&generated);
    let last = answers.estimates.last().expect("an answer");
    assert!((last[0] - 2.995_916_667).abs() < 1e-5 && (last[1] - 1.95).abs() < 1e-5, "{last:?}");
    // Without the encoder no sample says where it is.
    let without = &generated.design.certificate.error_bound_without;
    assert!(without[0].is_none() && without[1].is_some(), "{without:?}");
}

/// Of three outputs two are lost: what one alone shows is solved for, whatever that is beside all three.
#[test]
fn one_of_three_is_enough() {
    let text = edited(
        &height("missing = 'left-out'"),
        "baro =",
        "radar = { unit = 'm', value = 'z', noise = 0.03, range = [0.1, 4] }\nbaro =",
    );
    let generated = designed_in(&text, Scalar::F64);
    let mut run = climb();
    run.measurements.iter_mut().for_each(|row| row.insert(1, row[0]));
    let answers = run.through(&generated);
    let last = answers.estimates.last().expect("an answer");
    assert!((last[0] - 20.5165).abs() < 1e-9 && (last[1] - 1.05).abs() < 1e-9, "{last:?}");
}

/// A burst of samples in every window and a half: no prediction goes on for ever.
#[test]
fn what_hardly_determines_the_state_is_better_than_nothing_for_ever() {
    let text = edited(&height("missing = 'left-out'"), "noise = 0.5", "noise = 0.02");
    let generated = designed_in(&text, Scalar::F64);
    let mut run = climb();
    for (call, row) in run.measurements.iter_mut().enumerate() {
        if call > 200 {
            // At most eight adjacent samples of one sensor in a window.
            *row = vec![f64::NAN, if call % 150 < 8 { row[1] } else { f64::NAN }];
        }
    }
    let answers = run.through(&generated);
    // The model alone would be off by 0.05/2 t^2, 6 m by the end; a line through eight samples is not.
    let worst = (800..1000).map(|call| (answers.estimates[call][0] - run.states[call][0]).abs()).fold(0.0, f64::max);
    assert!(worst < 0.5, "{worst}");
    assert!(answers.statuses[400..].iter().all(|status| *status == Status::Coasting));
}

/// The bound without an output is that of a design without it.
#[test]
fn the_certificate_says_what_the_bound_becomes() {
    let generated = designed(&height("missing = 'left-out'"));
    for (place, line) in [
        "sonar = { unit = 'm', value = 'z', noise = 0.02, range = [0.1, 4] }\n",
        "baro = { unit = 'm', value = 'z', noise = 0.5 }\n",
    ]
    .into_iter()
    .enumerate()
    {
        let alone = designed(&edited(&height("missing = 'left-out'"), line, ""));
        let without = generated.design.certificate.error_bound_without[place].as_ref().expect("determined");
        for (without, alone) in without.iter().zip(&alone.design.certificate.error_bound) {
            let (without, alone) = (without.expect("a bound"), alone.expect("a bound"));
            assert!((without / alone - 1.0).abs() < 1e-9, "{without} {alone}");
        }
    }
    let output = Generator::new(&height(""), "height.toml").generate().unwrap_or_else(|report| panic!("{report:?}"));
    let header = &output.files().iter().find(|file| file.name == "height.h").expect("a header").text;
    for line in ["error bound without sonar", "error bound without baro", "error bound with samples lost"] {
        assert!(header.contains(line), "{line} is not in the header");
    }
}

/// Random plants with two outputs whose noises differ by up to a thousand times; the accurate one is lost.
#[test]
fn every_linear_plant_goes_on_with_what_is_left() {
    let mut tried = 0;
    for seed in 0..trials(60, 600) {
        let (mut both, mut random) = Linear::new((1 + seed % 3, 2, seed % 2, (seed % 5 < 2, true), 12, seed as u64));
        both.delays = vec![0; 2];
        both.noise = vec![1e-3, [1e-3, 1e-2, 1e-1, 1.0][random.below(4)]];
        let alone = Linear {
            c: both.c.rows(1, 1).into_owned(),
            delays: vec![0],
            noise: vec![both.noise[1]],
            b: both.b.clone(),
            a: both.a.clone(),
            holds: both.holds.clone(),
            every: Vec::new(),
            ages: Vec::new(),
            ..both
        };
        let design = |linear: &Linear| -> Option<Generated> {
            let text = linear.text("[observer.window]\nmissing = 'left-out'");
            match Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) }).design() {
                Ok(generated) => Some(generated),
                Err(report) => {
                    assert!(
                        report.diagnostics.iter().all(|d| d.code == codes::UNOBSERVABLE),
                        "{}",
                        report.render(false)
                    );
                    None
                }
            }
        };
        let (Some(two), Some(one)) = (design(&both), design(&alone)) else { continue };
        if two.design.certificate.error_bound_without[0].is_none() {
            // Shown in exact arithmetic only.
            continue;
        }
        let steps = both.steps;
        let (mut run, _) = both.run(6 * steps, seed as u64);
        run.measurements[2 * steps..].iter_mut().for_each(|row| row[0] = f64::NAN);
        // What no model says: least squares must be of the same samples to agree.
        run.measurements.iter_mut().for_each(|row| row[1] += random.within(-1.0, 1.0) * both.noise[1]);
        let mut rest = run.clone();
        rest.measurements.iter_mut().for_each(|row| *row = vec![row[1]]);
        let (answers, expected) = (run.through(&two), rest.through(&one));
        let conditioned = irregular(&one).amplification().max(1.0);
        let sizes = run.sizes(0).into_iter().fold(1.0, f64::max);
        for call in 4 * steps + 2..6 * steps {
            assert_ne!(answers.statuses[call], Status::Converging, "seed {seed}, call {call}");
            for (a, b) in answers.estimates[call].iter().zip(&expected.estimates[call]) {
                // Both round; the rows of two outputs see the one that is left less evenly than its own do.
                let most = 1e4 * plant::UNIT * conditioned * sizes * both.noise[1] / both.noise[0];
                assert!((a - b).abs() <= most, "seed {seed}, call {call}: {a} {b}, {most:e}");
            }
        }
        tried += 1;
    }
    println!("{tried} plants");
    assert!(tried >= trials(20, 200), "{tried}");
}

fn irregular(generated: &Generated) -> &deadbeat_codegen::internals::estimator::window::irregular::Irregular {
    let functional: &Functional = plant::functional(generated);
    functional.irregular.as_ref().expect("a solve in the step")
}
