//! Claim: the robust exact differentiator is exact in finite time where the highest derivative is bounded, without
//! chattering, on chains and on plants; whenever its status says so the printed bound holds; backward differences are the
//! reference's.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "counts of calls and orders are small"
)]

use crate::support::plant;

use deadbeat_codegen::Generated;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::promise::Convergence;
use plant::{Random, designed, designed_in};
use serde_json::Value;

/// A chain of integrators.
fn chain(method: &str, order: usize, keys: &str, noise: f64, h: f64) -> String {
    format!(
        "deadbeat = 1\nname = 'c'\n[outputs]\ny = {{ noise = {noise:e} }}\n[observer.{method}]\norder = {order}\n{keys}\n\
         [target]\nsample_time = {h}\nscalar = 'f64'\n"
    )
}

fn robust(order: usize, lipschitz: f64, noise: f64, h: f64) -> String {
    chain("robust-exact", order, &format!("lipschitz = {lipschitz:e}"), noise, h)
}

/// The estimates of every call, and the statuses.
fn run(generated: &Generated, samples: impl Iterator<Item = f64>) -> Vec<(Vec<f64>, Status)> {
    let mut interpreter = Interpreter::new(&generated.program);
    let call = |y: f64| {
        let mut estimate = vec![0.0; generated.plant.states.len()];
        let status = interpreter.step(&[y], &[], &mut estimate);
        (estimate, status)
    };
    samples.map(call).collect()
}

fn bounds(generated: &Generated) -> Vec<f64> {
    let bounds = &generated.design.certificate.error_bound;
    bounds.iter().map(|bound| bound.expect("noise is declared")).collect()
}

/// The first calls of a sine and its derivatives up to order - 1; the derivative of that order is at most 1.
fn sine(order: usize, h: f64, calls: usize) -> Vec<Vec<f64>> {
    let derivative = |i: usize, t: f64| (t + i as f64 * std::f64::consts::FRAC_PI_2).sin();
    (0..calls).map(|k| (0..order).map(|i| derivative(i, 0.7 + k as f64 * h)).collect()).collect()
}

/// From an error in every derivative the estimate converges, stays converged, and is then as near as is printed; that
/// bound is of order h^(n-i) in the derivative of order i, and nothing is left of the initial error.
#[test]
fn it_is_exact_in_finite_time_where_the_highest_derivative_is_bounded() {
    for order in 2..=6 {
        let mut printed = Vec::new();
        for h in [0.02, 0.01] {
            let generated = designed(&robust(order, 1.0, 0.0, h));
            let Convergence::Sensed { calls, innovation } = generated.design.convergence else { panic!("another") };
            assert_eq!(calls, order);
            // c_n = 1.1 h^n L, above the h^n L of the highest derivative.
            let reach = 1.1 * h.powi(order as i32);
            assert!((innovation / reach - 1.0).abs() < 1e-12, "{order}: {innovation:e} {reach:e}");
            let truth = sine(order, h, 4_000);
            let answers = run(&generated, truth.iter().map(|x| x[0]));
            let first = answers.iter().position(|(_, status)| *status == Status::Converged).expect("converges");
            println!("order {order}, h = {h}: converged after {:.2} s", first as f64 * h);
            assert!(first > order && (first as f64) * h < 20.0, "order {order}: {first}");
            let bounds = bounds(&generated);
            for ((estimate, status), x) in answers.iter().zip(&truth).skip(first) {
                // Rounding of samples of 1 makes innovations of 1e-16, far below h^n.
                assert_eq!(*status, Status::Converged, "order {order}");
                for i in 0..order {
                    let rounding = f64::EPSILON * (2.0 / h).powi(i as i32);
                    assert!(
                        (estimate[i] - x[i]).abs() <= bounds[i] + rounding,
                        "order {order}, {i}: {estimate:?} {x:?}"
                    );
                }
            }
            printed.push(bounds);
        }
        for (i, (coarse, fine)) in printed[0].iter().zip(&printed[1]).enumerate() {
            // The sample itself is the estimate of y.
            let power = (coarse / fine).log2();
            let expected = (order - i) as f64;
            // Backward differences' part and the shortfall's are each exactly of that order.
            assert!((power - expected).abs() < 1e-6 || *coarse == 0.0, "order {order}, {i}: {power}");
        }
    }
}

/// At rest nothing chatters: from the start the derivatives are exactly 0, and after a transient they are 0 but for the
/// rounding of the samples, where the explicit step's last derivative would jump by 2 h lambda L = 1.1 at every call.
#[test]
fn at_rest_there_is_no_chattering() {
    use deadbeat_codegen::program::Scalar;
    for (scalar, epsilon) in [(Scalar::F32, f64::from(f32::EPSILON)), (Scalar::F64, f64::EPSILON)] {
        for order in 2..=6 {
            let h = 0.01;
            let generated = designed_in(&robust(order, 50.0, 1e-3, h), scalar);
            let still = run(&generated, std::iter::repeat_n(0.75, 500));
            for (estimate, _) in &still {
                assert_eq!(estimate[0], 0.75);
                assert!(estimate[1..].iter().all(|d| *d == 0.0), "{scalar} {order}: {estimate:?}");
            }
            // A ramp that stops.
            let stops = (0..8_000).map(|k| 0.75_f64.min(0.1 + 0.01 * f64::from(k)));
            let moved = run(&generated, stops);
            let rest = &moved[6_000..];
            for (estimate, status) in rest {
                assert_eq!(*status, Status::Converged, "{scalar} {order}");
                for (i, d) in estimate.iter().enumerate().skip(1) {
                    // Differences of samples that are rounded to half a unit of 0.75, and of states likewise.
                    let left = 2.0 * epsilon * 0.75 * (2.0 / h).powi(i as i32);
                    assert!(d.abs() <= left, "{scalar} {order}: {d:e} of {left:e}");
                }
            }
        }
    }
}

/// With noise at its bound, of three kinds, each call that says it has converged is within the printed bound, and that
/// is most of them.
#[test]
fn whenever_it_says_so_the_bound_holds() {
    for order in 2..=6 {
        for noise in [1e-9, 1e-5, 1e-2] {
            let h = 0.02;
            let generated = designed(&robust(order, 1.0, noise, h));
            let (truth, bounds) = (sine(order, h, 6_000), bounds(&generated));
            for kind in 0..3 {
                let mut random = Random::new(7 + kind);
                let v = |k: usize, random: &mut Random| match kind {
                    0 => random.within(-noise, noise),
                    1 => noise * if random.below(2) == 0 { 1.0 } else { -1.0 },
                    _ => noise * if (k / 41).is_multiple_of(2) { 1.0 } else { -1.0 },
                };
                let samples: Vec<f64> = truth.iter().enumerate().map(|(k, x)| x[0] + v(k, &mut random)).collect();
                let answers = run(&generated, samples.into_iter());
                let mut converged = 0;
                for ((estimate, status), x) in answers.iter().zip(&truth).skip(1) {
                    if *status != Status::Converged {
                        continue;
                    }
                    converged += 1;
                    for i in 0..order {
                        let rounding = f64::EPSILON * (2.0 / h).powi(i as i32);
                        let error = (estimate[i] - x[i]).abs();
                        assert!(
                            error <= bounds[i] + rounding,
                            "{order} {noise} {kind}, {i}: {error:e} {:e}",
                            bounds[i]
                        );
                    }
                }
                println!("order {order}, noise {noise:e}, kind {kind}: {converged} of 6000 converged");
                assert!(converged > 3_000, "{order} {noise} {kind}: {converged}");
            }
        }
    }
}

/// On a plant with an input and a force that nobody knows: exact prediction of the rest, and the bound holds.
#[test]
fn it_holds_on_a_plant_with_an_unknown_force() {
    let text = "deadbeat = 1\nname = 'p'\n[states]\nx = { derivative = 'v' }\nv = { derivative = 'u - 4*x - 0.5*v + w' }\n\
                [inputs]\nu = {}\n[outputs]\nx = { value = 'x', noise = 1e-6 }\n[disturbances]\nw = { bound = 2 }\n\
                [observer.robust-exact]\nlipschitz = 3\n[target]\nsample_time = 0.01\nscalar = 'f64'\n";
    let generated = designed(text);
    assert!(generated.report.diagnostics.is_empty(), "{}", generated.report.render(false));
    let bounds = bounds(&generated);
    let mut random = Random::new(3);
    let mut interpreter = Interpreter::new(&generated.program);
    let (mut x, mut u, mut converged) = (vec![0.3, -1.0], 0.0, 0);
    for call in 0..20_000_u32 {
        let t = f64::from(call) * 0.01;
        let mut estimate = [0.0; 2];
        let status = interpreter.step(&[x[0] + random.within(-1e-6, 1e-6)], &[u], &mut estimate);
        if status == Status::Converged {
            converged += 1;
            for i in 0..2 {
                assert!((estimate[i] - x[i]).abs() <= bounds[i], "call {call}, {i}: {estimate:?} {x:?} {bounds:?}");
            }
        }
        u = random.within(-20.0, 20.0);
        let rhs = |s: f64, x: &[f64]| vec![x[1], u - 4.0 * x[0] - 0.5 * x[1] + 2.0 * (3.0 * (t + s)).sin()];
        x = plant::advance(&rhs, 0.0, 0.01, &x);
    }
    assert!(converged > 19_900, "{converged}");
    // Twice the worst of two samples' noise, and of the force over a sample.
    assert!(bounds[1] < 4.0 * (2e-6 / 0.01 + 0.02), "{bounds:?}");
}

/// More than `lipschitz` allows for is a warning with the number that would do.
#[test]
fn a_lipschitz_bound_below_the_disturbances_is_a_warning() {
    let text = "deadbeat = 1\nname = 'p'\n[states]\nx = { derivative = 'v' }\nv = { derivative = 'w' }\n[outputs]\n\
                x = { value = 'x' }\n[disturbances]\nw = { bound = 2 }\n[observer.robust-exact]\nlipschitz = 0.5\n\
                [target]\nsample_time = 0.01\nscalar = 'f64'\n";
    let generated = designed(text);
    let found: Vec<_> = generated.report.diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(found, [deadbeat_codegen::diagnostic::codes::WEAK]);
}

/// 003's fixed-time column: backward differences of the reference's samples, from a state of 0.
#[test]
fn backward_differences_are_the_reference() {
    for file in ["traj_003_h0p1", "traj_003_h0p01"] {
        let path = format!("{}/tests/golden/{file}.json", env!("CARGO_MANIFEST_DIR"));
        let golden: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        let h = golden["h"].as_f64().unwrap();
        let y: Vec<f64> = golden["y"].as_array().unwrap().iter().map(|y| y.as_f64().unwrap()).collect();
        let scale = y.iter().fold(0.0_f64, |a, y| a.max(y.abs()));
        let exact = designed(&chain("fixed-time-linear", 4, "", 0.0, h));
        let euler = designed(&chain("fixed-time-linear", 4, "prediction = 'implicit-euler'", 0.0, h));
        assert_eq!((euler.design.convergence, euler.design.valid_from_step), (Convergence::Finite, 3));
        // The reference starts at 0 whatever the first sample is.
        let samples = || std::iter::once(0.0).chain(y[1..].iter().copied());
        let (exact, euler) = (run(&exact, samples()), run(&euler, samples()));
        // M at h: 003's output map, which makes of the one the other.
        let m = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.5, 1.0 / 3.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]];
        for row in golden["fixed_time"].as_array().unwrap() {
            let k = row["k"].as_u64().unwrap() as usize;
            let expected: Vec<f64> = row["xhat"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
            for i in 0..4 {
                let unit = h.powi(i as i32) / scale;
                // 1e-13 of the scale in scaled units: a few roundings of the samples' size.
                assert!((euler[k].0[i] - expected[i]).abs() * unit < 1e-13, "{file} {k} {i}: {:?}", euler[k].0);
                let mapped: f64 = (0..4).map(|j| m[i][j] * expected[j] * h.powi(j as i32)).sum();
                assert!((exact[k].0[i] * h.powi(i as i32) - mapped).abs() / scale < 1e-13, "{file} {k} {i}");
            }
        }
    }
}
