//! Claim: the constant gains of `luenberger`, `kalman` and `high-gain` are what other programs and the papers' own
//! recursions give; on every random plant the error follows (I - K C) Phi, decays by the printed radius, and at the
//! printed call no more is left of it than is promised.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::depth::trials;
use crate::support::{golden, linear, plant};

use std::fmt::Write as _;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::internals::decimal::parse;
use deadbeat_codegen::internals::estimator::corrector::noise::over_a_sample;
use deadbeat_codegen::internals::estimator::corrector::riccati::{Noise, first_covariance, steady, transient};
use deadbeat_codegen::internals::real::{Matrix, Precision, Real, zero_order_hold};
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::promise::{CONTRACTED, Convergence};
use deadbeat_codegen::{Generated, Generator};
use golden::{golden, nearest};
use linear::Linear;
use nalgebra::{DMatrix, DVector};
use plant::{Random, corpus, designed, edited, matrix};

/// A specification with its observer's table replaced.
fn with_observer(text: &str, observer: &str) -> String {
    let (before, rest) = text.split_once("[observer.").unwrap();
    let after = rest.split_once("[target]").unwrap().1;
    format!("{before}{observer}\n[target]{after}")
}

/// The gain, row by row.
fn gain(generated: &Generated) -> Vec<f64> {
    matrix(generated, "K").concat()
}

/// The load's angle alone, and the drive without its motor's sensor.
fn load_alone() -> String {
    let text = corpus("two_mass_kalman");
    let line = text.lines().find(|line| line.starts_with("motor_angle = { unit = \"rad\", value")).unwrap();
    edited(&text, &format!("{line}\n"), "")
}

/// Two outputs with noise densities, one with covariances per sample: the nearest doubles to what the covariance
/// recursion ends in (tests/golden/kalman.py).
#[test]
fn steady_kalman_gains_are_those_of_another_program() {
    let two_mass = designed(&corpus("two_mass_kalman"));
    nearest("two masses", &gain(&two_mass), &golden("kalman", &["two_mass", "steady"]));
    let noise = "process_noise = [1e-12, 1e-12, 1e-4, 1e-5]\nmeasurement_noise = [[1e-8]]";
    let one = designed(&with_observer(&load_alone(), &format!("[observer.kalman]\n{noise}\n")));
    nearest("the load alone", &gain(&one), &golden("kalman", &["load_alone", "steady"]));
}

/// A complex pair and two real poles on four states; two real ones on two.
#[test]
fn gains_by_poles_are_those_of_another_program() {
    let poles =
        "[observer.luenberger]\npoles = [[-200, 150], [-200, -150], -300, '-1/0.00833333333333333333333333333']\n";
    let drive = designed(&with_observer(&load_alone(), poles));
    nearest("the load's poles", &gain(&drive), &golden("kalman", &["load_poles", "gain"]));
    let pendulum = designed(&with_observer(&corpus("pendulum"), "[observer.luenberger]\npoles = [-40, -60]\n"));
    nearest("the pendulum's poles", &gain(&pendulum), &golden("kalman", &["pendulum_poles", "gain"]));
}

fn real(text: &str, p: Precision) -> Real {
    Real::from_rational(&parse(text).unwrap(), p)
}

/// The numbers of a golden matrix with this many columns, relative to the largest: agreement in digits.
fn agrees(what: &str, ours: &Matrix, written: &[String]) {
    let p = ours.precision();
    assert_eq!(ours.rows() * ours.cols(), written.len(), "{what}");
    for (ours, written) in ours.iter().zip(written) {
        let theirs = real(written, p);
        // 30 digits are written; the quadrature and the recursion of the script hold 45 and more.
        let off = (ours - &theirs).log2_abs() - theirs.log2_abs();
        assert!(off < -28.0 * std::f64::consts::LOG2_10, "{what}: {} is not {written}", ours.to_decimal(32));
    }
}

/// Noise over a sample and the first eight gains after a start from a sample, to 28 digits.
#[test]
fn first_kalman_gains_are_those_of_another_program() {
    let p = Precision::bits(400);
    let number = |text: &str| real(text, p);
    let zero = || Real::zero(p);
    let (stiffness, damping) = (number("400"), number("0.2"));
    let (motor, load) = (number("0.01"), number("0.05"));
    let shaft = |inertia: &Real, sign: i64| {
        let sign = Real::from_i64(sign, p);
        [&stiffness, &damping].map(|x| &(x / inertia) * &sign)
    };
    let ([k1, d1], [k2, d2]) = (shaft(&motor, 1), shaft(&load, 1));
    let rows = [
        [zero(), zero(), number("1"), zero()],
        [zero(), zero(), zero(), number("1")],
        [-&k1, k1, -&d1, d1],
        [k2.clone(), -k2, d2.clone(), -d2],
    ];
    let a = Matrix::from_fn(4, 4, |i, j| rows[i][j].clone());
    let h = number("5e-4");
    let diagonal = |entries: &[&str]| {
        Matrix::from_fn(entries.len(), entries.len(), |i, j| if i == j { number(entries[i]) } else { zero() })
    };
    let process = over_a_sample(&a, &diagonal(&["0", "0", "4", "0.5"]), &h).unwrap();
    agrees("noise over a sample", &process, &golden("kalman", &["two_mass", "q"]));
    let measurement = diagonal(&["1e-12", "2e-11"]).map(|density| density / &h);
    let noise = Noise { process, measurement };
    let phi = zero_order_hold(&a, &Matrix::zeros(4, 0, p), &h).unwrap().0;
    let c = Matrix::identity(4, p).block(0..2, 0..4);
    let deviation = ["0", "0", "100", "100"].map(number);
    let start = first_covariance(&c.transpose(), &deviation, &noise);
    let gains = transient(&phi, &c, &noise, &start, 8).unwrap();
    let all = gains.iter().skip(1).fold(gains[0].clone(), |all, gain| all.vcat(gain));
    agrees("first gains", &all, &golden("kalman", &["two_mass", "first"]));
    agrees("steady gain", &steady(&phi, &c, &noise).unwrap().gain, &golden("kalman", &["two_mass", "steady"]));
}

/// 003's example with rho = 2 at every step, on the chain in implicit Euler's discretisation: there, M and q change
/// nothing, and the step is the paper's own.
#[test]
fn high_gain_follows_the_reference() {
    for (file, h) in [("traj_003_h0p1", 0.1_f64), ("traj_003_h0p01", 0.01)] {
        let document: serde_json::Value = serde_json::from_str(&golden::text(file)).unwrap();
        let mut text = "deadbeat = 1\nname = 'chain'\n[states]\n".to_owned();
        for i in 1..=4 {
            // (I - h N)^-1: powers of h above the diagonal.
            let terms: Vec<String> = (i..=4).map(|j| format!("{h}^{}*x{j}", j - i)).collect();
            let terms = terms.join(" + ").replace(&format!("{h}^0*"), "").replace(&format!("{h}^1*"), &format!("{h}*"));
            let _ = writeln!(text, "x{i} = {{ next = '{terms}' }}");
        }
        let _ = write!(
            text,
            "[outputs]\nx1 = {{ value = 'x1' }}\n[observer.high-gain]\ngain = 2\nL = [46, 791, 6026, 17160]\n[target]\n\
             sample_time = {h}\nscalar = 'f64'\n"
        );
        let generated = designed(&text);
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = [0.0; 4];
        // The reference starts from 0, whatever its sample 0 is.
        interpreter.step(&[0.0], &[], &mut estimate);
        let samples: Vec<f64> = document["y"].as_array().unwrap().iter().map(|y| y.as_f64().unwrap()).collect();
        let rows = document["high_gain_rho2"].as_array().unwrap();
        let largest = samples.iter().fold(0.0_f64, |a, y| a.max(y.abs()));
        let (mut call, mut worst) = (0, 0.0_f64);
        for row in rows {
            let wanted = row["k"].as_u64().unwrap() as usize;
            while call < wanted {
                call += 1;
                interpreter.step(&[samples[call]], &[], &mut estimate);
            }
            for (i, ours) in estimate.iter().enumerate() {
                let theirs = row["xhat"][i].as_f64().unwrap();
                worst = worst.max((ours - theirs).abs() * h.powi(i as i32) / largest);
            }
        }
        println!("{file}: {worst:e} of the largest sample, {} rows", rows.len());
        // In scaled units each call rounds by a few units of the largest sample; the poles, 10 to 13 per second
        // times 2, forget them within a few calls at h = 0.1 and some ten at h = 0.01.
        assert!(worst < 1e-13 && rows.len() >= 40, "{file}: {worst:e}");
    }
}

/// Plants that are tried, and how many of them must be designed.
fn plants() -> (u64, u64) {
    trials((40, 26), (280, 200))
}

/// A random linear plant without delays; its specification with this observer.
fn random_plant(seed: u64, most_outputs: usize) -> (Linear, Random, impl Fn(&str) -> String) {
    let mut random = Random::new(seed);
    let sizes = (1 + random.below(8), 1 + random.below(most_outputs), random.below(3));
    let kinds = (random.below(2) == 0, random.below(2) == 0);
    let (mut linear, random) = Linear::new((sizes.0, sizes.1, sizes.2, kinds, 0, seed));
    linear.delays = vec![0; sizes.1];
    linear.noise = vec![0.01; sizes.1];
    let window = format!("window = {}\n", linear.steps as f64 * linear.h);
    let text = linear.text("OBSERVER").replace(&window, "");
    (linear, random, move |observer: &str| text.replace("OBSERVER", observer))
}

/// The design, or that this plant is not one for this method.
fn attempt(text: &str) -> Option<Generated> {
    match Generator::new(text, "random.toml").design() {
        Ok(generated) => Some(generated),
        Err(report) => {
            let known = [codes::UNOBSERVABLE, codes::METHOD_CANNOT];
            assert!(report.diagnostics.iter().any(|d| known.contains(&d.code)), "{}\n{text}", report.render(false));
            None
        }
    }
}

fn dense(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
}

/// What a run's errors must be: by the map from call to call, to rounding; and what is promised of them.
fn keeps_its_promise(what: &str, linear: &Linear, generated: &Generated, seed: u64) -> bool {
    let (phi, c, k) = (matrix(generated, "Phi"), matrix(generated, "C"), matrix(generated, "K"));
    let (phi, c, k) = (dense(phi), dense(c), dense(k));
    let n = phi.nrows();
    let map = (DMatrix::identity(n, n) - &k * &c) * &phi;
    let Convergence::Geometric { radius, period: 1 } = generated.design.convergence else {
        panic!("{what}: {:?}", generated.design.convergence)
    };
    let found = map.complex_eigenvalues().iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max);
    // A multiple eigenvalue of order n moves by the n-th root of the rounding of the map's entries, in doubles here
    // and there.
    let rounding = (n as f64 * f64::EPSILON * (1.0 + map.abs().max())).powf(1.0 / n as f64);
    assert!((found - radius).abs() <= 8.0 * rounding && radius < 1.0, "{what}: {found} is not {radius}");
    let valid = generated.design.valid_from_step;
    let calls = (valid + 3).min(400);
    let (run, _) = linear.run(calls, seed);
    let answers = run.through(generated);
    let error = |call: usize| DVector::from_fn(n, |i, _| answers.estimates[call][i] - run.states[call][i]);
    // What the map makes of the first error; the rest is rounding, of the size of states and estimates (which peak
    // with the gain) at each call, and kept by the powers of the map.
    let (mut expected, mut power, mut kept) = (error(0), DMatrix::identity(n, n), 1.0_f64);
    let mut size = 1.0_f64;
    for call in 0..calls {
        let numbers = run.states[call].iter().chain(&run.measurements[call]).chain(&answers.estimates[call]);
        size = numbers.fold(size, |a, x| a.max(x.abs()));
        if call > 0 {
            expected = &map * expected;
            power = &map * power;
            kept += power.abs().max();
        }
        let unit = size * (1.0 + k.abs().max()) * (1.0 + phi.abs().max()) * kept * (n * n) as f64;
        let off = (error(call) - &expected).abs().max();
        assert!(off <= 64.0 * f64::EPSILON * unit, "{what}, call {call}: {off:e} of {unit:e}");
        let status = if call < valid { Status::Converging } else { Status::Converged };
        assert_eq!(answers.statuses[call], status, "{what}, call {call}");
    }
    promise(what, generated, &map, (&phi, &c))
}

/// At the promised call a millionth is left of the worst error that the first sample does not show, in the root mean
/// square of what an error does to the outputs until then: here by the Gramian over all calls.
///
/// Whether that could be compared.
fn promise(what: &str, generated: &Generated, map: &DMatrix<f64>, (phi, c): (&DMatrix<f64>, &DMatrix<f64>)) -> bool {
    let (n, valid) = (phi.nrows(), generated.design.valid_from_step);
    let hidden: Vec<usize> = (0..n).filter(|i| generated.plant.states[*i].measured.is_empty()).collect();
    // Numbers of the condition of the Gramian are lost; where that is most of them, doubles cannot tell.
    if hidden.is_empty() || generated.design.numerics.condition > 1e4 || valid > 256 {
        return false;
    }
    let mut gramian = DMatrix::zeros(n, n);
    let mut row = c.clone();
    for _ in 0..valid.max(n) {
        gramian += row.transpose() * &row;
        row *= phi;
    }
    let size = |e: &DVector<f64>| (e.transpose() * &gramian * e)[0].max(0.0).sqrt();
    let transition = (0..valid).fold(DMatrix::identity(n, n), |power, _| map * power);
    for i in hidden {
        let mut start = DVector::zeros(n);
        start[i] = 1.0;
        let left = size(&(&transition * &start)) / size(&start);
        assert!(left <= 1.01 * CONTRACTED, "{what}: {left:e} left of state {i} at call {valid}");
    }
    true
}

#[test]
fn random_plants_follow_their_poles() {
    let (mut designs, mut compared) = (0_u64, 0_u64);
    let (plants, enough) = plants();
    for seed in 0..plants {
        let (linear, mut random, text) = random_plant(seed, 1);
        let mut poles = Vec::new();
        let n = linear.a.nrows();
        while poles.len() < n {
            let re = -(random.within(0.3, 1.5) * 64.0).round() / 64.0 / linear.h;
            if n - poles.len() >= 2 && random.below(2) == 0 {
                let im = (random.within(0.1, 1.5) * 64.0).round() / 64.0 / linear.h;
                poles.extend([format!("[{re}, {im}]"), format!("[{re}, {}]", -im)]);
            } else {
                poles.push(re.to_string());
            }
        }
        let observer = format!("[observer.luenberger]\npoles = [{}]", poles.join(", "));
        let Some(generated) = attempt(&text(&observer)) else { continue };
        designs += 1;
        compared += u64::from(keeps_its_promise(&format!("poles {seed}"), &linear, &generated, seed));
    }
    println!("{designs} designs, {compared} promises compared");
    assert!(4 * compared >= designs, "{compared} of {designs} promises compared");
    assert!(designs >= enough, "{designs} of {plants}");
}

#[test]
fn random_plants_have_a_kalman_filter() {
    let (mut designs, mut compared) = (0_u64, 0_u64);
    let (plants, enough) = plants();
    for seed in 0..plants {
        let (linear, mut random, text) = random_plant(seed, 3);
        let noise: Vec<String> = (0..linear.a.nrows()).map(|_| random.within(1e-4, 1e-1).to_string()).collect();
        let density = if linear.discrete || random.below(2) == 0 { "" } else { "density = true\n" };
        let observer = format!("[observer.kalman]\n{density}process_noise = [{}]", noise.join(", "));
        let Some(generated) = attempt(&text(&observer)) else { continue };
        designs += 1;
        compared += u64::from(keeps_its_promise(&format!("kalman {seed}"), &linear, &generated, seed));
    }
    println!("{designs} designs, {compared} promises compared");
    assert!(4 * compared >= designs, "{compared} of {designs} promises compared");
    assert!(designs >= enough, "{designs} of {plants}");
}

#[test]
fn random_plants_follow_a_high_gain() {
    let (mut designs, mut compared) = (0_u64, 0_u64);
    let (plants, enough) = plants();
    for seed in 0..plants {
        let (linear, mut random, text) = random_plant(seed, 1);
        let gain = random.within(0.3, 3.0) / linear.h;
        let poles = vec!["-1"; linear.a.nrows()].join(", ");
        let Some(generated) = attempt(&text(&format!("[observer.high-gain]\ngain = {gain}\npoles = [{poles}]"))) else {
            continue;
        };
        designs += 1;
        compared += u64::from(keeps_its_promise(&format!("high gain {seed}"), &linear, &generated, seed));
    }
    println!("{designs} designs, {compared} promises compared");
    assert!(4 * compared >= designs, "{compared} of {designs} promises compared");
    assert!(designs >= enough, "{designs} of {plants}");
}
