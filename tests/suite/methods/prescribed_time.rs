//! Claim: the prescribed-time observers are what the papers say, where they are right: 004's constants exactly, its
//! trajectories as in an independent program, its error curve in the limit of fast sampling; on any observable plant
//! with one output the error is M times the chain's, and at the promised step what the certificate says.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::depth::trials;
use crate::support::{linear, plant};

use std::cell::Cell;

use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::internals::estimator::corrector::holloway_krstic::{
    hbar, hbar_by_recursion, pbar, pbar_by_recursion, qbar,
};
use deadbeat_codegen::internals::real::{Precision, Rational, Real};
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use linear::{Linear, exponential};
use nalgebra::{DMatrix, DVector};
use plant::{Random, UNIT, designed, matrix};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use serde_json::Value;

fn golden(file: &str) -> Value {
    let path = format!("{}/tests/golden/{file}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// "12/5" as a rational.
fn ratio(text: &str) -> Rational {
    let (over, under) = text.split_once('/').unwrap_or((text, "1"));
    let whole = |part: &str| deadbeat_codegen::internals::decimal::parse(part).unwrap();
    whole(over) / whole(under)
}

/// A number that is written exactly in the file.
fn exact(value: &Value) -> Rational {
    Real::from_f64(value.as_f64().unwrap(), Precision::bits(64)).unwrap().to_rational().unwrap()
}

/// pbar, qbar and hbar of the reference file, as the same rationals and their nearest doubles.
#[test]
fn the_constants_of_004_are_exact() {
    let file = golden("gains_004");
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 126);
    for case in cases {
        let (n, m) = (case["n"].as_u64().unwrap() as usize, case["m"].as_u64().unwrap() as usize);
        let time = exact(&case["T"]);
        let l: Vec<Rational> = case["l"].as_array().unwrap().iter().map(exact).collect();
        let (p, q, h) = (pbar(n, m, &time), qbar(n, m, &time), hbar(m, &l, &time));
        assert_eq!(p, pbar_by_recursion(n, m, &time));
        assert_eq!(h, hbar_by_recursion(m, &l, &time));
        let check = |ours: &[Vec<Rational>], written: &Value, exactly: Option<&Value>| {
            for (i, row) in ours.iter().enumerate() {
                for (j, entry) in row.iter().enumerate() {
                    let double = Real::from_rational(entry, Precision::bits(256)).to_f64();
                    assert_eq!(double.to_bits(), (written[i][j].as_f64().unwrap() + 0.0).to_bits(), "{n} {m} {i} {j}");
                    if let Some(exactly) = exactly {
                        assert_eq!(*entry, ratio(exactly[i][j].as_str().unwrap()), "{n} {m} {i} {j}");
                    }
                }
            }
        };
        check(&p, &case["pbar"], Some(&case["pbar_exact"]));
        check(&q, &case["qbar"], None);
        check(&h, &case["hbar"], Some(&case["hbar_exact"]));
    }
}

/// The double integrator of 004, by implicit Euler with the input of the call: as in the file, to 1e-13 of the scale.
#[test]
fn the_double_integrator_runs_as_in_the_file() {
    let file = golden("traj_004_double_integrator");
    for case in file["cases"].as_array().unwrap() {
        let l = numbers(&case["l"]);
        // Implicit Euler of the chain is this discrete plant; its M is diag(1, 1/h), its q is 0.
        let generated = designed(&format!(
            "deadbeat = 1\nname = 'chain'\n[states]\nx1 = {{ next = 'x1 + 0.05*x2 + 0.0025*u' }}\nx2 = {{ next = 'x2 + 0.05*u' }}\n\
             [inputs]\nu = {{}}\n[outputs]\ny = {{ value = 'x1' }}\n[observer.prescribed-time]\ntime = 5\n\
             holloway-krstic = {{ m = {}, l = [{}, {}] }}\nstop_before = 0\n[target]\nsample_time = 0.05\nscalar = 'f64'\n",
            case["m"], l[0], l[1]
        ));
        let (y, u) = (numbers(&case["y"]), numbers(&case["u"]));
        let scale = y.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimates = Vec::new();
        for k in 0..y.len() {
            let mut estimate = [0.0; 2];
            // The file starts from 0, not from the first sample.
            interpreter.step(&[if k == 0 { 0.0 } else { y[k] }], &[u[k]], &mut estimate);
            estimates.push(estimate);
        }
        for row in case["implicit_euler_u_at_k_plus_1"].as_array().unwrap() {
            let (k, expected) = (row["k"].as_u64().unwrap() as usize, numbers(&row["xhat"]));
            for (i, unit) in [1.0, 0.05].into_iter().enumerate() {
                let error = unit * (estimates[k][i] - expected[i]).abs() / scale;
                assert!(error <= 1e-13, "m {}, call {k}, state {i}: {error:e}", case["m"]);
            }
        }
    }
}

/// Holloway and Krstic's exact error, `nu^(m+1) Q(nu) exp(Lambda t) P(1) e0` (34), (32), at a time.
fn error_of_004(m: usize, l: &[f64], time: f64, e0: &[f64], t: f64) -> Vec<f64> {
    let n = l.len();
    let whole = Real::from_f64(time, Precision::bits(64)).unwrap().to_rational().unwrap();
    let double = |x: &Rational| Real::from_rational(x, Precision::bits(128)).to_f64();
    let (p, q) = (pbar(n, m, &whole), qbar(n, m, &whole));
    let nu = (time - t) / time;
    let power = |k: usize| nu.powi(k as i32);
    let start = DMatrix::from_fn(n, n, |i, j| double(&p[i][j])) * DVector::from_column_slice(e0);
    let companion = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(j == i + 1)) - if j == 0 { l[i] } else { 0.0 });
    let z = exponential(&(companion * t)) * start;
    let back = DMatrix::from_fn(n, n, |i, j| if j > i { 0.0 } else { double(&q[i][j]) * power(n - 1 + j - i) });
    (back * z * power(m + 1)).iter().copied().collect()
}

/// That formula gives the file's curve; and the sampled observer runs along it the closer the faster it samples, with
/// the first order of implicit Euler, for three initial conditions and three m.
#[test]
fn the_error_follows_the_papers_curve() {
    let file = golden("traj_004_double_integrator");
    for case in file["cases"].as_array().unwrap() {
        let (m, l) = (case["m"].as_u64().unwrap() as usize, numbers(&case["l"]));
        let e0 = numbers(&case["x0"]);
        for row in case["continuous_error"].as_array().unwrap() {
            let t = row["t"].as_f64().unwrap();
            for (ours, expected) in error_of_004(m, &l, 5.0, &e0, t).iter().zip(numbers(&row["e"])) {
                assert!((ours - expected).abs() <= 1e-12 * e0.iter().map(|x| x.abs()).sum::<f64>(), "t {t}");
            }
        }
    }
    for m in 1..=3 {
        for speed in [1.0, 5.0, 10.0] {
            let mut errors = Vec::new();
            for steps in [200_usize, 400, 800] {
                let h = 5.0 / steps as f64;
                let generated = designed(&format!(
                    "deadbeat = 1\nname = 'chain'\n[states]\nx1 = {{ derivative = 'x2' }}\nx2 = {{ derivative = 'u' }}\n[inputs]\nu = {{}}\n\
                     [outputs]\ny = {{ value = 'x1' }}\n[observer.prescribed-time]\ntime = 5\nholloway-krstic = {{ m = {m}, l = [1, 1] }}\n\
                     stop_before = 1\n[target]\nsample_time = '5/{steps}'\nscalar = 'f64'\n"
                ));
                let mut interpreter = Interpreter::new(&generated.program);
                let (mut x, mut worst) = ([0.0, speed], 0.0_f64);
                for k in 0..=steps / 2 {
                    let t = k as f64 * h;
                    let mut estimate = [0.0; 2];
                    let u = (10.0 * (t - h)).sin() + (t - h).cos();
                    if k > 0 {
                        x = [x[0] + h * x[1] + 0.5 * h * h * u, x[1] + h * u];
                    }
                    interpreter.step(&[x[0]], &[u], &mut estimate);
                    let exact = error_of_004(m, &[1.0, 1.0], 5.0, &[0.0, speed], t);
                    worst = worst.max((x[1] - estimate[1] - exact[1]).abs());
                }
                errors.push(worst / speed);
            }
            let orders = [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()];
            assert!(orders.iter().all(|order| (0.9..1.15).contains(order)), "m {m}: {errors:?}, {orders:?}");
        }
    }
}

/// Plants that are tried, and that must be designed: some do not show their state, and some so little of it by the random
/// time that the error would have grown.
fn plants() -> (u32, u32) {
    trials((75, 60), (250, 200))
}

/// A random law for a plant of that order, and where the countdown ends.
fn law(random: &mut Random, n: usize, steps: usize, h: f64) -> (String, usize) {
    let stop = [1, 1 + steps / 20, 1 + steps / 10][random.below(3)].min(steps - 1);
    let choose = |n: usize, k: usize| (1..=k).fold(1.0, |product, i| product * (n + 1 - i) as f64 / i as f64);
    let law = match random.below(4) {
        0 => format!("poles = {{ p = {} }}", 4 * n + random.below(8)),
        1 => {
            let (time, p) = (steps as f64 * h, (4 * n + random.below(8)) as f64);
            let gains: Vec<String> =
                (1..=n).map(|i| format!("{:e}", choose(n, i) * (p / time).powi(i as i32))).collect();
            format!("efimov-orlov = {{ L = [{}] }}", gains.join(", "))
        }
        2 => {
            // (s + a)^n: stable.
            let a = random.within(0.1, 2.0);
            let l: Vec<String> = (1..=n).map(|i| format!("{:e}", choose(n, i) * a.powi(i as i32))).collect();
            format!("holloway-krstic = {{ m = {}, l = [{}] }}", 2 * n + random.below(6), l.join(", "))
        }
        _ => format!("holloway-krstic = {{ m = {} }}", 2 * n + random.below(6)),
    };
    (law, stop)
}

/// kappa with r steps left, from the formulas of the notes; the law as `law` writes it.
fn kappa(text: &str, n: usize, h: f64, r: f64, steps: f64) -> DVector<f64> {
    if text == "deadbeat" {
        return DVector::from_element(n, 1.0);
    }
    let choose = |n: usize, k: usize| (1..=k).fold(1.0, |product, i| product * (n + 1 - i) as f64 / i as f64);
    let inside = |key: &str| -> f64 {
        text.split_once(&format!("{key} = ")).unwrap().1.split([',', '}']).next().unwrap().trim().parse().unwrap()
    };
    // g_i h^i, i = 1 … n, with mu = N/r.
    let c: Vec<f64> = if let Some((_, list)) = text.split_once("L = [") {
        let gains = list.trim_end_matches("] }").split(", ").map(|x| x.parse::<f64>().unwrap());
        gains.enumerate().map(|(i, gain)| gain * (h * steps / r).powi(i as i32 + 1)).collect()
    } else if text.starts_with("poles") {
        (1..=n).map(|i| choose(n, i) * (inside("p") / r).powi(i as i32)).collect()
    } else {
        let m = inside("m") as usize;
        let mut l = vec![1.0];
        match text.split_once("l = [") {
            Some((_, list)) => l.extend(list.trim_end_matches("] }").split(", ").map(|x| x.parse::<f64>().unwrap())),
            None => l.extend(vec![0.0; n]),
        }
        let g = |i: usize| -> f64 {
            let term = |k: usize| {
                let falling: f64 = (0..k).map(|j| (n + m - j) as f64).product();
                l[i - k] * choose(n - i + k, k) * falling / (steps * h).powi(k as i32) * (steps / r).powi(k as i32)
            };
            (0..=i).map(term).sum()
        };
        (1..=n).map(|i| g(i) * h.powi(i as i32)).collect()
    };
    let sums: Vec<f64> = (0..n).map(|j| c[j..].iter().sum()).collect();
    DVector::from_fn(n, |j, _| sums[j] / (1.0 + sums[0]))
}

/// Up to order 8, continuous and discrete, stable and not, with inputs: the error is M times that of the chain, and at
/// the promised step at most what the certificate leaves of the initial one. With `fixed-time-linear` nothing is left.
#[test]
fn every_observable_plant_is_estimated_by_the_promised_step() {
    let (refused, compared) = (Cell::new(0), Cell::new(0));
    let config = Config { cases: plants().0, failure_persistence: None, ..Config::default() };
    let shapes = (1_usize..=8, 0_usize..=2, (proptest::bool::ANY, proptest::bool::ANY), 0_usize..=40, 0_u64..1 << 40);
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let outcome = TestRunner::new_with_rng(config, random).run(&shapes, |(n, m, kinds, spare, seed)| {
        let (mut linear, mut random) = Linear::new((n, 1, m, kinds, spare, seed));
        linear.delays = vec![0];
        linear.steps = n + 2 + spare;
        let (law, stop) = law(&mut random, n, linear.steps, linear.h);
        let time = linear.steps as f64 * linear.h;
        let observer = format!("[observer.prescribed-time]\ntime = {time}\n{law}\nstop_before = {stop}");
        let text = linear.specification(&observer);
        let generator = Generator::new(&text, "random.toml").with(Settings { scalar: Some(Scalar::F64) });
        let generated = match generator.design() {
            Ok(generated) => generated,
            // Not observable, or a discrete plant that cannot be run backwards.
            Err(report)
                if report
                    .diagnostics
                    .iter()
                    .all(|d| [codes::UNOBSERVABLE, codes::METHOD_CANNOT, codes::WEAK].contains(&d.code)) =>
            {
                refused.set(refused.get() + 1);
                return Ok(());
            }
            Err(report) => return Err(TestCaseError::fail(format!("{}\n{text}", report.render(false)))),
        };
        let fail = |why: String| TestCaseError::fail(format!("{why}\n{text}"));
        let valid = linear.steps - stop;
        if generated.design.valid_from_step != valid {
            return Err(fail(format!("promised for call {}", generated.design.valid_from_step)));
        }
        let well = promise(&linear, [&generated; 2], (&law, valid), seed).map_err(fail)?;
        compared.set(compared.get() + usize::from(well));
        // The same plant with the gains of the countdown's end at every call: exact with n samples, or one more.
        let fixed = Generator::new(&linear.specification("[observer.fixed-time-linear]"), "random.toml");
        let fixed =
            fixed.with(Settings { scalar: Some(Scalar::F64) }).design().map_err(|why| fail(why.render(false)))?;
        let calls = fixed.design.valid_from_step;
        let shown = generated.plant.states.iter().any(|state| !state.measured.is_empty());
        if calls != n - usize::from(shown) {
            return Err(fail(format!("fixed-time-linear promised for call {calls}")));
        }
        if calls > 0 {
            promise(&linear, [&fixed, &generated], ("deadbeat", calls), seed).map_err(fail)?;
        }
        Ok(())
    });
    outcome.unwrap_or_else(|why| panic!("{why}"));
    let (plants, enough) = plants();
    let designed = plants - refused.get();
    println!("{designed} designed, {} compared with rounding below 1e-6 of the initial error", compared.get());
    assert!(designed >= enough, "{designed} of {plants} designed");
    assert!(2 * compared.get() >= designed as usize, "the rounding bound says nothing for most plants");
}

/// Runs a design and compares, with the M and q of another; whether rounding left something to compare.
fn promise(
    linear: &Linear,
    [generated, frame]: [&Generated; 2],
    (law, valid): (&str, usize),
    seed: u64,
) -> Result<bool, String> {
    let n = linear.a.nrows();
    let (run, _) = linear.run(valid + 1, seed);
    let answers = run.through(generated);
    let to = |rows: &[Vec<f64>]| DMatrix::from_fn(n, rows[0].len(), |i, j| rows[i][j]);
    let (phi, m, q) = (to(matrix(frame, "Phi")), to(matrix(frame, "M")), to(matrix(frame, "q")));
    let c = linear.c.clone();
    let error = |k: usize| DVector::from_fn(n, |i, _| answers.estimates[k][i] - run.states[k][i]);
    let summing = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(j >= i)));
    let gains: Vec<DVector<f64>> =
        (1..=valid).map(|k| kappa(law, n, linear.h, (linear.steps - k) as f64, linear.steps as f64)).collect();
    // The chain's error, and what rounding adds to the plant's, from the last call backwards.
    let start = m.clone().lu().solve(&error(0)).ok_or("M is singular")?;
    let mut chain = start.clone();
    for kappa in &gains {
        chain = &summing * chain;
        let first = chain[0];
        chain -= kappa * first;
    }
    let mut through = DMatrix::<f64>::identity(n, n);
    let mut rounding = DVector::<f64>::zeros(n);
    for k in (1..=valid).rev() {
        let gain = &m * &gains[k - 1] + &q;
        let size =
            |call: usize| DVector::from_fn(n, |i, _| answers.estimates[call][i].abs().max(run.states[call][i].abs()));
        let inputs: f64 = run.inputs.iter().flatten().fold(0.0, |most, u| most.max(u.abs()));
        let carried =
            phi.abs() * size(k - 1) + linear.sampled().1.abs() * DVector::from_element(linear.holds.len(), inputs);
        let innovation = (c.abs() * (&carried + size(k)))[0];
        let spread = (m.abs() * &gains[k - 1] + q.abs()) * innovation;
        // Each product and sum, of the step and of the simulation, is rounded, and so is Phi in both.
        let local = (&carried + size(k) + spread) * (4.0 * n as f64 + 40.0) * UNIT;
        rounding += through.abs() * local;
        through = through * (DMatrix::identity(n, n) - &gain * &c) * &phi;
    }
    let expected = &m * &chain;
    let got = error(valid);
    let scale = m.abs() * start.abs();
    for i in 0..n {
        // The chain's error is itself computed in doubles.
        let slack = rounding[i] + 1e-11 * scale[i];
        if (got[i] - expected[i]).abs() > slack {
            return Err(format!("state {i}: {:e}, M times the chain's {:e}, slack {slack:e}", got[i], expected[i]));
        }
        let row = &generated.design.certificate.initial_gain[i];
        let left: f64 = row.iter().zip(error(0).iter()).map(|(g, e)| (g * e).abs()).sum();
        if got[i].abs() > left * (1.0 + 1e-6) + slack {
            return Err(format!("state {i}: {:e} of at most {left:e} and {slack:e}", got[i]));
        }
    }
    let initial = error(0).abs().max();
    if *answers.statuses.last().unwrap() != Status::Converged || answers.statuses[valid - 1] != Status::Converging {
        return Err(format!("{:?}", answers.statuses));
    }
    Ok(rounding.max() < 1e-6 * initial.max(1e-9))
}

/// An oscillator with an input that is held: at r = 0 the gain is the deadbeat one, and n calls of it leave nothing.
#[test]
fn an_oscillator_is_exact_one_call_after_the_prescribed_time() {
    for steps in [25_usize, 100, 800] {
        let generated = designed(&format!(
            "deadbeat = 1\nname = 'o'\n[states]\ny = {{ derivative = 'v' }}\nv = {{ derivative = 'u - 0.4*v - 25*y' }}\n[inputs]\nu = {{}}\n\
             [outputs]\ny = {{ value = 'y' }}\n[observer.prescribed-time]\ntime = 2\nstop_before = 0\n[target]\nsample_time = '2/{steps}'\n\
             scalar = 'f64'\n"
        ));
        assert_eq!(generated.design.valid_from_step, steps + 1);
        let phi = matrix(&generated, "Phi");
        let mut linear = Linear::new((2, 1, 1, (false, false), 0, 1)).0;
        linear.h = 2.0 / steps as f64;
        linear.a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -25.0, -0.4]);
        linear.b = DMatrix::from_row_slice(2, 1, &[0.0, 1.0]);
        linear.c = DMatrix::from_row_slice(1, 2, &[1.0, 0.0]);
        linear.holds = vec![plant::Hold::Zero];
        linear.delays = vec![0];
        let (run, _) = linear.run(steps + 20, 5);
        let answers = run.through(&generated);
        let errors = answers.errors(&run, steps + 1..steps + 20);
        // Rounding of a difference of two samples over h.
        let bound = 64.0 * UNIT * (1.0 / linear.h + 10.0) * phi[0][0].abs().max(1.0);
        assert!(errors[0] <= bound && errors[1] <= bound, "{steps}: {errors:?} above {bound:e}");
    }
}

/// The exact gains of 003's example against backward differences: restarts as the notes print them (section 6), holds
/// by summing the responses of the recursion from every call on, in another program; printed is at most a thousandth more.
#[test]
fn the_certificate_is_that_of_the_notes() {
    let printed = |gains: [&str; 4]| {
        gains.map(|text| {
            let value: f64 = text.parse().unwrap();
            let digits = text.split('e').next().unwrap().trim_matches('0').replace('.', "").len() as i32;
            (value, 0.5 * 10.0_f64.powi(value.log10().floor() as i32 - digits + 1) / value + 1e-3)
        })
    };
    let summed = |gains: [f64; 4]| gains.map(|value| (value, 1e-3));
    let cases = [
        ("0.1", 1, "restart", printed(["1.64", "39.6", "613", "6269"])),
        ("0.01", 1, "restart", printed(["707", "3.6e4", "6.8e5", "6.27e6"])),
        ("0.01", 50, "restart", printed(["8.4", "376", "6.6e3", "5.5e4"])),
        ("0.01", 100, "restart", printed(["2.7", "86", "1.3e3", "8.6e3"])),
        ("0.01", 10, "hold", summed([1.023_127_98, 197.400_415, 22_713.238_8, 1_266_608.82])),
        ("0.01", 50, "hold", summed([1.236_137_99, 104.029_798, 4_019.437_37, 56_030.911_4])),
    ];
    for (h, stop, after, expected) in cases {
        let generated = designed(&format!(
            "deadbeat = 1\nname = 'chain'\n[parameters]\nh = {h}\n[states]\nx1 = {{ next = 'x1 + h*(x2 + h*(x3 + h*x4))' }}\n\
             x2 = {{ next = 'x2 + h*(x3 + h*x4)' }}\nx3 = {{ next = 'x3 + h*x4' }}\nx4 = {{ next = 'x4' }}\n[outputs]\ny = {{ value = 'x1' }}\n\
             [observer.prescribed-time]\ntime = 2.5\nefimov-orlov = {{ L = [46, 791, 6026, 17160] }}\nafter = '{after}'\nstop_before = {stop}\n\
             [target]\nsample_time = {h}\nscalar = 'f64'\n"
        ));
        for (gains, (expected, share)) in generated.design.certificate.noise_gain_l1.iter().zip(expected) {
            let off = gains[0] / expected - 1.0;
            assert!(off.abs() <= share, "h {h}, {after} at {stop}: {} for {expected}", gains[0]);
        }
    }
}
