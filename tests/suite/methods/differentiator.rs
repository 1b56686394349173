//! Claim: the method `differentiator` is 003's observer: the golden trajectories of both predictions, Z, F and O at
//! every step, the gains from noise that an independent sum gave; its derivatives have the promised orders in the sample
//! time; polynomials are exact from the promised step on; and no countdown is too long for a single.
//!
//! The golden numbers come from 60-digit arithmetic (`tests/golden/traj_003_*.json`, `zf_003.json`).

#![allow(clippy::cast_precision_loss, reason = "counts of calls and powers are small")]

use crate::support::depth::trials;
use crate::support::golden;

use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::promise::Convergence;
use deadbeat_codegen::{Generated, Generator, Settings};
use golden::{golden, nearest, text};

/// A specification of a signal `y` with these keys.
fn spec(order: usize, keys: &str, h: &str, scalar: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'probe'\n[outputs]\ny = {{ unit = 'm' }}\n[observer.differentiator]\norder = {order}\n\
         {keys}\n[target]\nsample_time = {h}\nscalar = '{scalar}'\n"
    )
}

fn designed(text: &str) -> Generated {
    Generator::new(text, "test.toml").design().unwrap_or_else(|report| panic!("{}", report.render(false)))
}

/// The estimates of every call.
fn fed(generated: &Generated, samples: &[f64]) -> (Vec<Vec<f64>>, Vec<Status>) {
    let mut interpreter = Interpreter::new(&generated.program);
    let order = generated.plant.states.len();
    let each = samples.iter().map(|y| {
        let mut estimate = vec![0.0; order];
        let status = interpreter.step(&[*y], &[], &mut estimate);
        (estimate, status)
    });
    each.unzip()
}

fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// The numbers of a list of a golden file, in its order.
fn numbers(file: &str, key: &str) -> Vec<f64> {
    golden(file, &[key]).iter().filter_map(|word| word.parse().ok()).collect()
}

const PAPER: &str = "time = 2.5\nefimov-orlov = { L = [46, 791, 6026, 17160] }\nafter = 'restart'\nstop_before = 1";

/// (21) and the same with the exact prediction, noise and all, to 1e-13 of the largest sample in scaled units.
#[test]
fn the_trajectories_are_the_golden_ones() {
    for (file, h) in [("traj_003_h0p1", "0.1"), ("traj_003_h0p01", "0.01")] {
        let mut samples = numbers(file, "y");
        let most = samples.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
        // The golden runs start from 0; call 0 takes the state from its sample.
        samples[0] = 0.0;
        let step: f64 = h.parse().unwrap();
        for (column, prediction) in [("uptS_restart_21", "implicit-euler"), ("uptS_restart_exact_prediction", "exact")]
        {
            let generated = designed(&spec(4, &format!("{PAPER}\nprediction = '{prediction}'"), h, "f64"));
            let (estimates, _) = fed(&generated, &samples);
            let rows = numbers(file, column);
            assert!(rows.len() >= 200 && rows.len().is_multiple_of(5), "{file} {column}: {}", rows.len());
            let mut worst = 0.0_f64;
            for row in rows.chunks(5) {
                let call = (0..samples.len()).find(|k| *k as f64 == row[0]).unwrap();
                for (i, expected) in row[1..].iter().enumerate() {
                    worst = worst.max((estimates[call][i] - expected).abs() * power(step, i) / most);
                }
            }
            println!("{file} {column}: {worst:.1e}");
            assert!(worst <= 1e-13, "{file} {column}: {worst:e}");
        }
    }
}

/// Z, F, O at a step, the prescribed time included, are the golden ones to the last bit.
#[test]
fn what_is_printed_at_a_step_is_golden() {
    let all = text("zf_003");
    let mut seen = 0;
    for case in all.split("\"n\":").skip(1) {
        let case = format!("\"n\":{case}");
        let words = |key: &str| -> Vec<String> {
            let behind = case.split_once(&format!("\"{key}\":")).unwrap().1;
            let mut depth = 0;
            let end = behind.find(|c| {
                depth += i32::from(c == '[') - i32::from(c == ']');
                depth == 0 && matches!(c, ']' | ',')
            });
            let words = behind[..end.unwrap_or(behind.len())].split(|c: char| "[]{}, \n\"".contains(c));
            words.filter(|word| !word.is_empty()).map(str::to_owned).collect()
        };
        let (n, time, h, l) = (words("n"), words("T"), words("h"), words("L").join(", "));
        let keys = format!("time = {}\nefimov-orlov = {{ L = [{l}] }}\nstop_before = 1", time[0]);
        let generator = Generator::new(&spec(n[0].parse().unwrap(), &keys, &h[0], "f64"), "test.toml");
        let number = |word: &str| word.parse::<f64>().unwrap();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of steps")]
        let step = (number(&words("t")[0]) / number(&h[0])).round() as usize;
        let moment = generator.at(step).unwrap_or_else(|report| panic!("{}", report.render(false))).unwrap();
        let matrix = |letter: &str| moment.matrices.iter().find(|m| m.letter == letter).unwrap().rows.concat();
        nearest("Z", &matrix("Z"), &words("Z"));
        nearest("F", &matrix("F"), &words("F"));
        match words("O")[0].as_str() {
            "inf" => assert_eq!((matrix("O"), moment.left), (vec![f64::INFINITY], 0)),
            _ => nearest("O", &matrix("O"), &words("O")),
        }
        seen += 1;
    }
    assert_eq!(seen, 39);
}

/// The worst-case gains from noise over a period of (21) that section 6 of prescribed-time-observers has, to its digits.
#[test]
fn noise_gains_of_the_restart_are_those_of_an_independent_sum() {
    for (h, expected) in [("0.1", [1.64, 39.6, 613.0, 6269.0]), ("0.01", [707.0, 3.6e4, 6.8e5, 6.27e6])] {
        let generated = designed(&spec(4, &format!("{PAPER}\nprediction = 'implicit-euler'"), h, "f64"));
        let gains = generated.design.certificate.noise_gain_l1.iter().map(|gains| gains[0]);
        for (i, (gain, expected)) in gains.zip(expected).enumerate() {
            // The printed numbers have two or three digits.
            let digit = if expected == 3.6e4 || expected == 6.8e5 { 0.5 / 36.0 } else { 0.5 / 160.0 };
            assert!((gain / expected - 1.0).abs() <= digit, "h = {h}, derivative {i}: {gain} against {expected}");
        }
    }
}

/// The paper's signal, 0.1 t^5 - 100 t + sin 7t + 1000, and its derivative of an order, at t.
fn signal(t: f64, derivative: usize) -> f64 {
    let powers = (0..derivative).fold(0.1, |factor, i| factor * (5.0 - i as f64));
    let polynomial = if derivative > 5 { 0.0 } else { powers * power(t, 5 - derivative) };
    let line = match derivative {
        0 => 1000.0 - 100.0 * t,
        1 => -100.0,
        _ => 0.0,
    };
    let wave = match derivative % 4 {
        0 => (7.0 * t).sin(),
        1 => (7.0 * t).cos(),
        2 => -(7.0 * t).sin(),
        _ => -(7.0 * t).cos(),
    };
    polynomial + line + power(7.0, derivative) * wave
}

/// Mean errors of the derivatives on [2, 4] s, after the deadbeat gain has taken over at 1 s.
fn errors(order: usize, prediction: &str, h: &str) -> Vec<f64> {
    let keys = format!("time = 1\nstop_before = 0\nprediction = '{prediction}'");
    let generated = designed(&spec(order, &keys, h, "f64"));
    assert_eq!(generated.design.convergence, Convergence::Finite);
    let step: f64 = h.parse().unwrap();
    let times: Vec<f64> = (0..=1000).map(|k| f64::from(k) * step).take_while(|t| *t <= 4.0).collect();
    let samples: Vec<f64> = times.iter().map(|t| signal(*t, 0)).collect();
    let (estimates, _) = fed(&generated, &samples);
    let late: Vec<usize> = (0..times.len()).filter(|k| times[*k] >= 2.0).collect();
    let mean = |i: usize| {
        late.iter().map(|k| (estimates[*k][i] - signal(times[*k], i)).abs()).sum::<f64>() / late.len() as f64
    };
    (0..order).map(mean).collect()
}

/// Derivative i has order n-i by the exact prediction, and 1 by implicit Euler.
#[test]
fn derivatives_have_their_orders() {
    for order in 2..=5 {
        for prediction in ["exact", "implicit-euler"] {
            let [coarse, fine] = ["0.01", "0.005"].map(|h| errors(order, prediction, h));
            let orders: Vec<f64> = coarse.iter().zip(&fine).skip(1).map(|(c, f)| (c / f).log2()).collect();
            println!("n = {order}, {prediction}: {coarse:.3?}, orders {orders:.2?}");
            for (i, found) in (1..order).zip(&orders) {
                let expected = if prediction == "exact" { (order - i) as f64 } else { 1.0 };
                // The next term is (7 h)^2 of the error, for a wave of 7 rad/s: 0.5 % at most, and sums over 2 s hide less.
                assert!((found - expected).abs() <= 0.03, "n = {order}, {prediction}, derivative {i}: {found}");
            }
        }
    }
}

/// The bias table of section 3 at h = 0.01, n = 4: implicit Euler 6.83, 4.63, 22.0, exact 3.7e-4, 0.135, 22.0.
#[test]
fn the_lag_is_that_of_the_table() {
    // The table's means are of [3T, 4T] = [7.5, 10] s; the wave and the powers of t differ on [2, 4] s, so take those.
    let mean = |prediction: &str| {
        let keys = format!("time = 2.5\nstop_before = 0\nprediction = '{prediction}'");
        let generated = designed(&spec(4, &keys, "0.01", "f64"));
        let times: Vec<f64> = (0..1000).map(|k| f64::from(k) / 100.0).collect();
        let samples: Vec<f64> = times.iter().map(|t| signal(*t, 0)).collect();
        let (estimates, _) = fed(&generated, &samples);
        let late = 750..1000;
        let error = |i: usize| {
            late.clone().map(|k| (estimates[k][i] - signal(times[k], i)).abs()).sum::<f64>() / late.len() as f64
        };
        [error(1), error(2), error(3)]
    };
    for (prediction, table) in [("implicit-euler", [6.83, 4.63, 22.0]), ("exact", [3.7e-4, 0.135, 22.0])] {
        let found = mean(prediction);
        for (found, table) in found.iter().zip(table) {
            // Two to three printed digits.
            assert!((found / table - 1.0).abs() <= 0.02, "{prediction}: {found} against {table}");
        }
    }
}

/// Any order, law and start: exact for polynomials of degree n-1 from the promised step, n-1 after T, on.
#[test]
fn polynomials_are_exact_from_the_promised_step_on() {
    let laws = ["poles = { p = 9 }", "holloway-krstic = { m = 2 }", "poles = { p = 14 }\ninitial = [INITIAL]"];
    for order in 2..=8_usize {
        for (seed, law) in laws.iter().enumerate() {
            let initial: Vec<String> = (1..order).map(|i| format!("{}", 3.0 / (i + seed) as f64)).collect();
            let law = law.replace("INITIAL", &initial.join(", "));
            let generated = designed(&spec(order, &format!("time = 0.5\n{law}\nstop_before = 0"), "0.01", "f64"));
            let valid = generated.design.valid_from_step;
            assert_eq!(valid, 50 + order - 1);
            // sum of a_j (t - 0.4)^j, a_j of changing sign.
            let at = |t: f64, derivative: usize| -> f64 {
                let term = |j: usize| {
                    let falling = (0..derivative).fold(1.0, |product, i| product * (j - i) as f64);
                    let sign = if (j + seed) % 3 == 1 { -1.0 } else { 1.0 };
                    sign * (1.0 + 0.3 * j as f64) * falling * power(t - 0.4, j - derivative)
                };
                (derivative..order).map(term).sum()
            };
            let times: Vec<f64> = (0..2 * valid).map(|k| k as f64 / 100.0).collect();
            let samples: Vec<f64> = times.iter().map(|t| at(*t, 0)).collect();
            let most = samples.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
            let (estimates, statuses) = fed(&generated, &samples);
            for (k, status) in statuses.iter().enumerate() {
                let expected = if k < valid { Status::Converging } else { Status::Converged };
                assert_eq!(*status, expected, "order {order}, call {k}");
            }
            for (i, gains) in generated.design.certificate.noise_gain_l1.iter().enumerate() {
                let error = (valid..2 * valid).map(|k| (estimates[k][i] - at(times[k], i)).abs()).fold(0.0, f64::max);
                // Samples are rounded, by a few units of the sums that they are; the recursion rounds each of its n states
                // once per call, and is deadbeat: n calls are left of that.
                let rounding = 0.5 * f64::EPSILON * gains[0] * most * (8 + 2 * order * order) as f64;
                assert!(error <= rounding, "order {order}, {law}, derivative {i}: {error:e} above {rounding:e}");
            }
        }
    }
}

/// With two states backward differences are the exact chain's: both predictions are one observer.
#[test]
fn both_predictions_are_one_for_two_states() {
    let text = |prediction| spec(2, &format!("time = 1\nprediction = '{prediction}'"), "0.01", "f32");
    let [exact, euler] = ["exact", "implicit-euler"].map(|prediction| designed(&text(prediction)));
    assert_eq!(exact.program, euler.program);
    assert_eq!(exact.design.certificate.error_bound, euler.design.certificate.error_bound);
}

/// 20,000 steps to T, the most there can be, in single precision at order 8, down to T itself: every estimate is finite, and the gains are not
/// lost on the way: the signal is followed to rounding at T. The bound of a countdown that restarts looks at each of its
/// calls, which is a minute's work at order 8.
#[test]
fn the_longest_countdowns_stay_within_singles() {
    for (order, stop, after) in [(8, 0, "hold"), (trials(3, 8), 2000, "restart"), (3, 0, "hold")] {
        let keys = format!("time = 200\nstop_before = {stop}\nafter = '{after}'");
        let text = spec(order, &keys, "0.01", "f32");
        let generator = Generator::new(&text, "test.toml").with(Settings { scalar: Some(Scalar::F32) });
        let generated = generator.design().unwrap_or_else(|report| panic!("{}", report.render(false)));
        #[expect(clippy::cast_possible_truncation, reason = "rounding to the nearest single")]
        let sample = |k: u32| f64::from((f64::from(k) * 1e-3).sin() as f32);
        let samples: Vec<f64> = (0..41_000).map(sample).collect();
        let (estimates, statuses) = fed(&generated, &samples);
        assert!(estimates.iter().flatten().all(|x| x.is_finite()), "order {order}");
        assert_eq!(statuses.last(), Some(&Status::Converged));
        if stop == 0 {
            for k in 20_000..samples.len() {
                // kappa_1 = 1 at r = 0: y is the sample, but for the rounding of a sum of up to 2^(n-1) of its size.
                let slack = f64::from(f32::EPSILON) * power(2.0, order);
                assert!((estimates[k][0] - samples[k]).abs() <= slack, "order {order}, call {k}");
            }
        }
    }
}

/// The notes say what 003 Theorem 1 says of these gains.
#[test]
fn the_theorem_is_reported() {
    let notes = |keys: &str| designed(&spec(4, keys, "0.1", "f64")).design.notes.join("\n");
    let paper = notes(PAPER);
    assert!(paper.contains("29.92 is above 3") && paper.contains("gamma_1"), "{paper}");
    let long = notes("time = 100\nstop_before = 10");
    assert!(long.contains("have no solution") && long.contains("T/2 = 50"), "{long}");
    let other = notes("time = 2.5\nholloway-krstic = { m = 1 }\nstop_before = 1");
    assert!(other.contains("(T-t)^(5-i)") && !other.contains("gamma_1"), "{other}");
}

/// The same gains by the other way: the chain as a plant of `prescribed-time`, in its own coordinates with M and q, while
/// the countdown holds, restarts and hands over. Both agree to rounding, on a signal that no polynomial is.
#[test]
fn the_chain_as_a_plant_is_the_same_observer() {
    let observer = |method: &str, order: &str, after: &str| {
        format!("[observer.{method}]\n{order}time = 0.5\nholloway-krstic = {{ m = 2 }}\nafter = '{after}'\n")
    };
    let rest = "[disturbances]\nw = { bound = 3.0 }\n[target]\nsample_time = 0.01\nscalar = 'f64'\n";
    for after in ["hold", "restart", "handover"] {
        let chain = format!(
            "deadbeat = 1\nname = 'probe'\n[outputs]\ny = {{ noise = 1e-3 }}\n{}{rest}",
            observer("differentiator", "order = 3\n", after)
        );
        let plant = format!(
            "deadbeat = 1\nname = 'probe'\n[states]\ny = {{ derivative = 'dy' }}\ndy = {{ derivative = 'd2y' }}\n\
             d2y = {{ derivative = 'w' }}\n[outputs]\ny = {{ value = 'y', noise = 1e-3 }}\n{}{rest}",
            observer("prescribed-time", "", after)
        );
        let samples: Vec<f64> = (0..200).map(|k| (f64::from(k) * 0.07).sin()).collect();
        let [ours, theirs] = [chain, plant].map(|text| {
            let generated = designed(&text);
            (fed(&generated, &samples), generated.design.certificate)
        });
        assert_eq!(ours.0.1, theirs.0.1, "{after}: the status");
        assert_eq!(ours.1.error_bound, theirs.1.error_bound, "{after}: the certificate");
        for (i, gains) in ours.1.noise_gain_l1.iter().enumerate() {
            let apart = ours.0.0.iter().zip(&theirs.0.0).map(|(a, b)| (a[i] - b[i]).abs()).fold(0.0, f64::max);
            // Every call rounds the innovation and three states a few times, which enters as noise does.
            let rounding = 0.5 * f64::EPSILON * 16.0 * gains[0];
            println!("{after}, derivative {i}: {apart:.1e} of {rounding:.1e}");
            assert!(apart <= rounding, "{after}, derivative {i}: {apart:e} above {rounding:e}");
        }
    }
}
