//! Claim: `pll`, `alpha-beta`, `low-pass` and `adaptive-window` are the formulas that firmware ships: each gives what a
//! direct implementation gives, lost samples included, and is as late as its header says.

#![allow(clippy::cast_precision_loss, reason = "counts of calls and samples are small")]

use crate::support::plant;

use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::promise::Convergence;
use plant::{Random, designed};

const H: f64 = 1e-3;

fn specification(method: &str, keys: &str) -> String {
    format!(
        "deadbeat = 1\nname = 'b'\n[outputs]\ny = {{ unit = 'rad', noise = 1e-3 }}\n[observer.{method}]\n{keys}\n\
         [target]\nsample_time = {H}\nscalar = 'f64'\n"
    )
}

/// The estimates and statuses of a signal.
fn through(text: &str, samples: &[f64]) -> Vec<(Vec<f64>, Status)> {
    let generated = designed(text);
    let mut interpreter = Interpreter::new(&generated.program);
    let step = |y: &f64| {
        let mut estimate = vec![0.0; generated.plant.states.len()];
        let status = interpreter.step(&[*y], &[], &mut estimate);
        (estimate, status)
    };
    samples.iter().map(step).collect()
}

/// A motion that turns round, with noise that takes its bound at random.
fn motion(calls: usize, seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed);
    let sample = |k: usize| {
        let t = k as f64 * H;
        (9.0 * t).sin() + 0.3 * (31.0 * t).cos() + random.within(-1e-3, 1e-3)
    };
    (0..calls).map(sample).collect()
}

/// The same with one sample in ten lost.
fn with_losses(mut samples: Vec<f64>, seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed);
    samples.iter_mut().skip(2).filter(|_| random.below(10) == 0).for_each(|y| *y = f64::NAN);
    samples
}

/// The tracking loop as drives write it, against the designed one: twenty roundings of numbers of size 1, which the loop
/// forgets within some 20 calls, and in the rate over h.
#[test]
fn the_tracking_loop_is_the_one_that_drives_ship() {
    let b = 150.0;
    let samples = motion(2_000, 1);
    let answers = through(&specification("pll", "bandwidth = 150"), &samples);
    let (kp, ki) = (2.0 * b, b * b);
    let (mut p, mut w) = (samples[0], 0.0);
    for (k, (y, (estimate, _))) in samples.iter().zip(&answers).enumerate() {
        if k > 0 {
            p += H * w;
            let e = y - p;
            p += H * kp * e;
            w += H * ki * e;
        }
        assert!((estimate[0] - p).abs() <= 400.0 * f64::EPSILON, "call {k}: {} and {p}", estimate[0]);
        assert!((estimate[1] - w).abs() <= 400.0 * f64::EPSILON / H, "call {k}: {} and {w}", estimate[1]);
    }
}

/// kp h = alpha and ki h^2 = beta give the same step, bit for bit.
#[test]
fn the_tracking_loop_is_an_alpha_beta_filter() {
    let samples = with_losses(motion(500, 2), 3);
    let bits = |method: &str, keys: &str| -> Vec<[u64; 2]> {
        let answers = through(&specification(method, keys), &samples);
        answers.iter().map(|(estimate, _)| [estimate[0].to_bits(), estimate[1].to_bits()]).collect()
    };
    assert_eq!(bits("pll", "bandwidth = 150"), bits("alpha-beta", "alpha = 0.3\nbeta = 0.0225"));
}

/// By its rule the filter is the line, or the parabola, by least squares through all samples so far in which each counts
/// r times as much with every one that follows. After 600 calls r^600 is left of the start, below 1e-23.
#[test]
fn the_rule_is_the_fading_memory() {
    let r: f64 = 0.915;
    let samples = motion(600, 4);
    for order in [2, 3] {
        let alpha = 1.0 - r.powi(order);
        let text = specification("alpha-beta", &format!("order = {order}\nalpha = {alpha:?}"));
        let answers = through(&text, &samples);
        let (estimate, _) = answers.last().unwrap();
        let fitted = faded(&samples, usize::try_from(order).unwrap(), r);
        for (i, (ours, theirs)) in estimate.iter().zip(&fitted).enumerate() {
            // alpha is given to 16 digits, and r is a root of what is left of 1; the sums have 600 terms.
            let scale = [1.0, 1.0 / H, 1.0 / (H * H)][i];
            assert!((ours - theirs).abs() <= 1e-11 * scale, "order {order}, state {i}: {ours} and {theirs}");
        }
        let Convergence::Geometric { radius, .. } = designed(&text).design.convergence else { panic!("another kind") };
        // A root of multiplicity m moves by the m-th root of a rounding.
        assert!((radius - r).abs() < 4.0 * f64::EPSILON.powf(1.0 / f64::from(order)), "{radius} is not {r}");
    }
}

/// Value, slope and curvature at the newest sample.
fn faded(samples: &[f64], order: usize, r: f64) -> Vec<f64> {
    let mut normal = nalgebra::DMatrix::<f64>::zeros(order, order);
    let mut right = nalgebra::DVector::<f64>::zeros(order);
    for (age, y) in samples.iter().rev().enumerate() {
        // In samples, so that the sums are of one size.
        let t = -(age as f64);
        let row = [1.0, t, 0.5 * t * t];
        let weight = r.powi(i32::try_from(age).unwrap());
        for i in 0..order {
            right[i] += weight * row[i] * y;
            for j in 0..order {
                normal[(i, j)] += weight * row[i] * row[j];
            }
        }
    }
    let solution = normal.lu().solve(&right).unwrap();
    (0..order).map(|i| solution[i] / H.powi(i32::try_from(i).unwrap())).collect()
}

/// At constant acceleration the rate is late by 2/b - h/2, by (alpha/beta - 1/2) h, by T + h/2, and with three states not
/// at all.
#[test]
fn lags_are_those_of_the_header() {
    let acceleration = 8.0;
    let samples: Vec<f64> = (0..3_000).map(|k| 0.5 * acceleration * (f64::from(k) * H).powi(2)).collect();
    let lag = |method: &str, keys: &str| {
        let answers = through(&specification(method, keys), &samples);
        let (estimate, status) = &answers[2_999];
        assert_eq!(*status, Status::Converged, "{method}");
        2.999 - estimate[1] / acceleration
    };
    // Positions up to 36 are rounded, and the rate is their difference over h.
    let near = |lag: f64, expected: f64| assert!((lag - expected).abs() < 1e-9, "{lag} s, not {expected}");
    near(lag("pll", "bandwidth = 150"), 2.0 / 150.0 - 0.5 * H);
    near(lag("alpha-beta", "alpha = 0.3\nbeta = 0.02"), (0.3 / 0.02 - 0.5) * H);
    near(lag("alpha-beta", "alpha = 0.3\norder = 3"), 0.0);
    near(lag("low-pass", "time_constant = 5e-3"), 5e-3 + 0.5 * H);
    let late = |method: &str, keys: &str| designed(&specification(method, keys)).design.notes.join("\n");
    assert!(late("pll", "bandwidth = 150").contains("the rate is 0.01283 s late"));
    assert!(late("alpha-beta", "alpha = 0.3\nbeta = 0.02").contains("the rate is 0.0145 s late"));
    assert!(late("low-pass", "time_constant = 5e-3").contains("the rate is 0.005 s late"));
}

/// Counts of 0.01, so that many samples are equal, and losses.
#[test]
fn the_held_difference_is_the_one_that_is_shipped() {
    let samples: Vec<f64> = motion(2_000, 5).iter().map(|y| (y / 0.01).round() * 0.01).collect();
    let samples = with_losses(samples, 6);
    let tau = 4e-3;
    let answers = through(&specification("low-pass", &format!("time_constant = {tau}")), &samples);
    let a = tau / (tau + H);
    let (mut last, mut since, mut quotient, mut v) = (samples[0], 0, 0.0, 0.0);
    for (k, (y, (estimate, status))) in samples.iter().zip(&answers).enumerate() {
        if k > 0 {
            since += 1;
            if y.is_finite() && *y != last {
                quotient = (y - last) / (H * f64::from(since));
                (last, since) = (*y, 0);
            }
            v = a * v + (1.0 - a) * quotient;
        }
        assert_eq!(estimate[0], last, "call {k}");
        // Quotients up to 60, each with a few roundings.
        assert!((estimate[1] - v).abs() <= 1e-12, "call {k}: {} and {v}", estimate[1]);
        let clean = samples[..=k].iter().rev().take_while(|y| y.is_finite()).count();
        let good = samples[..=k].iter().filter(|y| y.is_finite()).count();
        // a^62 is the first power below 1e-6.
        let expected = match (good > 62, clean >= 62 || clean == k + 1) {
            (false, _) => Status::Converging,
            (true, true) => Status::Converged,
            (true, false) => Status::Coasting,
        };
        assert_eq!(*status, expected, "call {k}");
    }
    let held = through(&specification("low-pass", "time_constant = 0"), &[0.0, 0.02, 0.02, 0.02, 0.03]);
    let rates: Vec<f64> = held.iter().map(|(estimate, _)| estimate[1]).collect();
    for (rate, expected) in rates.iter().zip([0.0, 20.0, 20.0, 20.0, 10.0 / 3.0]) {
        assert!((rate - expected).abs() < 1e-12, "{rates:?}");
    }
}

/// The longest line by brute force: value and slope, from the newest samples that are there and no older than `longest`.
fn longest_line(known: &[(f64, f64)], deviation: f64, longest: f64) -> Option<(f64, f64)> {
    let newest = known.last()?.0;
    let mut chosen = None;
    for count in 2..=known.len() {
        let window = &known[known.len() - count..];
        if newest - window[0].0 > longest + 0.5 {
            break;
        }
        let points = count as f64;
        let (mean_t, mean_y) = (window.iter().map(|p| p.0).sum::<f64>() / points, mean(window));
        let spread: f64 = window.iter().map(|(t, _)| (t - mean_t).powi(2)).sum();
        let slope = window.iter().map(|(t, y)| (t - mean_t) * (y - mean_y)).sum::<f64>() / spread;
        let line = |t: f64| mean_y + slope * (t - mean_t);
        if count > 2 && window.iter().any(|(t, y)| (y - line(*t)).abs() > deviation) {
            break;
        }
        chosen = Some((line(newest), slope / H));
    }
    chosen
}

fn mean(window: &[(f64, f64)]) -> f64 {
    window.iter().map(|p| p.1).sum::<f64>() / window.len() as f64
}

/// Against all lines, one by one; windows of 1, 2 and 20 samples, none and one in ten samples lost.
#[test]
fn the_adaptive_window_is_the_longest_line() {
    for (longest, losses) in [(20, false), (20, true), (2, true), (1, true)] {
        let samples = if losses { with_losses(motion(1_500, 7), 8) } else { motion(1_500, 7) };
        let keys = format!("deviation = 1.1e-3\nlongest = {}", f64::from(longest) * H);
        let answers = through(&specification("adaptive-window", &keys), &samples);
        let mut known: Vec<(f64, f64)> = Vec::new();
        let mut lengths = 0;
        for (k, (y, (estimate, status))) in samples.iter().zip(&answers).enumerate() {
            if y.is_finite() {
                known.push((k as f64, *y));
            }
            let line = longest_line(&known, 1.1e-3, f64::from(longest));
            lengths += usize::from(line.is_some());
            let expected = match (line.is_some(), y.is_finite()) {
                (false, _) => Status::Converging,
                (true, true) => Status::Converged,
                (true, false) => Status::Coasting,
            };
            if y.is_finite() || known.len() > 1 {
                assert_eq!(*status, expected, "{longest}, call {k}");
            }
            let Some((value, slope)) = line else { continue };
            // A lost sample: the line goes on, for a window and a call.
            let past = (k as f64 - known.last().unwrap().0).min(f64::from(longest) + 1.0);
            let value = value + slope * H * past;
            assert!((estimate[0] - value).abs() < 1e-12, "{longest}, call {k}: {} and {value}", estimate[0]);
            assert!((estimate[1] - slope).abs() < 1e-11 / H, "{longest}, call {k}: {} and {slope}", estimate[1]);
        }
        assert!(lengths > 1_300, "{longest}: {lengths}");
    }
}

/// Exact with the second sample of a straight motion, exactly 0 when samples are equal, and at once on the other way
/// after a turn; a gap longer than the window begins anew.
#[test]
fn an_adaptive_window_is_long_or_short_as_it_must() {
    let text = specification("adaptive-window", "deviation = 1e-6\nlongest = 0.02");
    let there: Vec<f64> = (0..60).map(|k| 0.25 + f64::from(k) * 0.125).collect();
    let back: Vec<f64> = (0..60).map(|k| there[59] - f64::from(k) * 0.125).collect();
    let rest = vec![back[59]; 40];
    let samples: Vec<f64> = [there, back, rest, vec![f64::NAN; 30], vec![3.0, 3.25]].concat();
    let answers = through(&text, &samples);
    let rate = |call: usize| answers[call].0[1];
    for call in 1..60 {
        assert!((rate(call) - 125.0).abs() < 1e-9, "call {call}: {}", rate(call));
    }
    for call in 61..120 {
        assert!((rate(call) + 125.0).abs() < 1e-9, "call {call}: {}", rate(call));
    }
    for call in 140..160 {
        assert_eq!(rate(call), 0.0, "call {call}");
    }
    let statuses: Vec<Status> = answers[158..].iter().map(|(_, status)| *status).collect();
    assert_eq!(statuses[..2], [Status::Converged; 2]);
    assert_eq!(statuses[2..32], [Status::Coasting; 30]);
    assert_eq!(statuses[32..], [Status::Converging, Status::Converged]);
    assert!((rate(191) - 250.0).abs() < 1e-9);
}
