//! Claim: the constants of the single-delay observer are the doubles nearest to those that other programs computed
//! with 70 digits (`tests/golden/motor_000.json` for the paper's integrals, `motor_twin.json` for the sampled twin),
//! and what the design says of itself holds of any plant: no bias, fixed points, no dependence on k.

use crate::support::{golden, plant};

use deadbeat_codegen::Generated;
use deadbeat_codegen::internals::estimator::window::innovation::{Innovation, SingleDelay};
use deadbeat_codegen::internals::real::{Matrix, Precision, Real, inverse};
use deadbeat_codegen::internals::sampled::coordinates::Coordinates;
use deadbeat_codegen::internals::sampled::model::Model;
use golden::{golden, nearest};
use plant::{NOTHING_YET, Random, Run, at_sample_time, corpus, designed, matrix, rounding};

/// 000 (65) with its numbers, the sine as an input.
fn motor(keys: &str) -> Generated {
    designed(&format!(
        "deadbeat = 1
name = 'motor'
[plant]
A = [[0, 1, 0], [0, -1, 15], [0, -36.4, -200]]
B = [[0, 0], [-35, 0], [0, 40]]
C = [[1, 0, 0]]
[inputs]
sin_y = {{}}
u = {{}}
[observer.single-delay]
window = 0.1
{keys}
[target]
sample_time = 1e-3
scalar = 'f64'
"
    ))
}

fn flat(rows: &[Vec<f64>]) -> Vec<f64> {
    rows.iter().flatten().copied().collect()
}

/// S, N, R, H, their relatives and the two exponentials of 000 (4)-(7) and (13), for the paper's three k.
#[test]
fn the_papers_constants_are_the_nearest_doubles() {
    for k in [75, 100, 150] {
        let generated = motor(&format!("k = {k}\nform = 'continuous'"));
        let section = format!("k{k}");
        let letters = [
            ("S", "S"),
            ("N", "N"),
            ("R", "R"),
            ("H", "H"),
            ("Sinv", "Sinv"),
            ("exp(-k tau)", "exp_minus_k_tau"),
            ("exp(-(A1' + 2kI) tau)", "exp_minus_A1T_plus_2kI_tau"),
        ];
        for (letter, key) in letters {
            nearest(
                &format!("{letter} at k = {k}"),
                &flat(matrix(&generated, letter)),
                &golden("motor_000", &[&section, key]),
            );
        }
        for letter in ["A1", "A2"] {
            nearest(letter, &flat(matrix(&generated, letter)), &golden("motor_000", &["inputs", letter]));
        }
    }
}

/// The six matrices of the twin and its constants with far more digits than a double has.
fn twin(generated: &Generated, k: i64) -> (Innovation, SingleDelay, Real) {
    let p = Precision::bits(1_024);
    let model = Model::new(&generated.plant, &[], p).unwrap();
    let rest = Coordinates::pick(&model.c.to_f64(), 3).unwrap();
    let coordinates = Coordinates::new(&model.c, rest).unwrap();
    let a = (Real::from_i64(-k, p) / Real::from_i64(1_000, p)).checked_exp().unwrap();
    let (form, constants) = Innovation::single_delay(&model, &coordinates, &a, 100).unwrap();
    (form, constants, a)
}

fn rounded(m: &Matrix) -> Vec<f64> {
    flat(&m.to_f64())
}

/// S, N, R and a as the design shows them, and H, T2, T2^N, a^N and the weights of the innovations of the form behind
/// it, which has no H of its own: its filter needs no inverse of `Phi_rr - a I`.
#[test]
fn the_twins_constants_are_the_nearest_doubles() {
    for k in [20, 100] {
        let generated = motor(&format!("k = {k}"));
        let section = format!("twin000_k{k}");
        let check = |what: &str, ours: &[f64], key: &str| {
            nearest(&format!("{what} at k = {k}"), ours, &golden("motor_twin", &[&section, key]));
        };
        for (letter, key) in [("a", "a"), ("S", "S_d"), ("N", "N_d"), ("R", "R_d")] {
            check(letter, &flat(matrix(&generated, letter)), key);
        }
        let (form, constants, a) = twin(&generated, k);
        check("R", &rounded(&form.direct.block(1..3, 0..1)), "R_d");
        assert_eq!(rounded(&constants.r), flat(matrix(&generated, "R")), "the report's R is the form's");
        let psi2 = form.filter.block(2..4, 2..4);
        check("T2", &rounded(&psi2), "T2");
        let through = form.filter.powi(100);
        check("T2^N", &rounded(&through.block(2..4, 2..4)), "T2_pow_N");
        check("a^N", &[through.get(0, 0).to_f64()], "a_pow_N");
        // psi_2 is fed with H v, the filter with the lower half of G: (I - T2 / a) H of it.
        let one = Matrix::identity(2, a.precision());
        let back = inverse(&(&one - &psi2.scale(&(Real::one(a.precision()) / &a)))).unwrap();
        check("H", &rounded(&(&back * &form.input.block(2..4, 0..1))), "H_d");
        let (mut tail, mut weights) = (form.input.clone(), Vec::new());
        assert!((&form.output * &tail).is_zero(), "the newest innovation has R and nothing else");
        for _ in 0..100 {
            tail = &form.filter * &tail;
            weights.extend(rounded(&-&(&form.output * &tail).block(1..3, 0..1)));
        }
        check("the innovations' weights", &weights, "fir_v");
    }
}

/// 000 (65) with its sine, at 2 ms so that a window has 51 samples.
fn nonlinear(keys: &str) -> Generated {
    let text = corpus("dc_motor").replace("sample_time = 1e-3", "sample_time = 2e-3");
    designed(&text.replace("[observer.window]", &format!("[observer.single-delay]\n{keys}")))
}

/// `acc_(N+1) = 0` to all digits of 512 bits: the state before the window leaves nothing in the estimate.
#[test]
fn the_twin_is_unbiased_to_all_digits() {
    for k in ["-30", "0", "75", "100", "'auto'"] {
        let unbiasedness = motor(&format!("k = {k}")).design.numerics.unbiasedness;
        println!("k = {k}: {unbiasedness:.1e}");
        assert!(unbiasedness < 1e-60, "k = {k}: {unbiasedness:e}");
    }
}

/// At rest away from zero the estimate is the state, to the rounding of one sum, whatever the state before: the
/// inputs and the sine that hold the motor there weigh as much as its output does.
#[test]
fn an_equilibrium_is_a_fixed_point() {
    for k in ["-20", "0", "100", "'auto'"] {
        let generated = nonlinear(&format!("k = {k}"));
        let steps = generated.design.valid_from_step;
        for q in [-2.0_f64, 0.4, 1.5] {
            let current = 35.0 * q.sin() / 15.0;
            let calls = 2 * steps;
            let run = Run {
                states: vec![vec![q, 0.0, current]; calls],
                measurements: vec![vec![q]; calls],
                inputs: vec![vec![5.0 * current]; calls],
            };
            // The voltage and the sine are rounded, too.
            let bounds = rounding(&generated, &run, &[0.0; 3], &[q.sin().abs()]);
            let errors = run.through(&generated).errors(&run, steps..calls);
            println!("k = {k}, q = {q}: {errors:?} within {bounds:?}");
            assert!(errors.iter().zip(&bounds).all(|(error, bound)| error <= bound), "{errors:?}, {bounds:?}");
            assert!(bounds.iter().all(|bound| *bound < 1e-10));
        }
    }
}

/// Without noise k does not matter: the estimates differ by rounding.
#[test]
fn the_estimate_does_not_depend_on_k() {
    let (mut first, mut random) = (None, Random::new(7));
    let voltages: Vec<f64> = (0..400).map(|_| random.within(-10.0, 10.0)).collect();
    for k in ["-30", "0", "20", "75", "100", "150", "'auto'"] {
        let generated = motor(&format!("k = {k}"));
        let (run, step) = driven(&generated, &voltages);
        let answers = run.through(&generated);
        let bounds = rounding(&generated, &run, &step, &[]);
        let steps = generated.design.valid_from_step;
        assert!(bounds.iter().all(|bound| *bound < 1e-10), "the bound says nothing: {bounds:?}");
        let (others, other_bounds) = first.get_or_insert_with(|| (answers.estimates.clone(), bounds.clone()));
        for (call, (ours, others)) in answers.estimates.iter().zip(others.iter()).enumerate().skip(steps) {
            for i in 0..3 {
                let apart = (ours[i] - others[i]).abs();
                assert!(apart <= bounds[i] + other_bounds[i], "k = {k}, call {call}, state {i}: {apart:e}");
            }
        }
    }
}

/// The motor without its sine, by the design's own Phi and the golden Gamma; and the error of one step per state, in
/// units of u: each entry, product and sum is rounded.
fn driven(generated: &Generated, voltages: &[f64]) -> (Run, Vec<f64>) {
    let phi = matrix(generated, "Phi");
    let gamma = golden("motor_twin", &["Gam"]);
    let gamma: Vec<f64> = gamma.iter().skip(1).step_by(2).map(|x| x.parse().unwrap()).collect();
    let through =
        |row: &[f64], x: &[f64], size: fn(f64) -> f64| -> f64 { row.iter().zip(x).map(|(p, x)| size(*p) * x).sum() };
    let (mut run, mut x) = (Run::default(), vec![1.0, -2.0, 0.5]);
    for call in 0..voltages.len() {
        let held = if call == 0 { NOTHING_YET } else { voltages[call - 1] };
        if call > 0 {
            x = phi.iter().zip(&gamma).map(|(row, g)| through(row, &x, |p| p) + g * held).collect();
        }
        run.states.push(x.clone());
        run.measurements.push(vec![x[0]]);
        run.inputs.push(vec![0.0, held]);
    }
    let size = run.sizes(0);
    let step = phi.iter().zip(&gamma).map(|(row, g)| 5.0 * (through(row, &size, f64::abs) + 10.0 * g.abs()));
    let step = step.collect();
    (run, step)
}

/// A measured state is its sample, to the bit, before and after convergence, in both forms and with both holds.
#[test]
fn measured_states_are_passed_through() {
    for form in ["exact", "continuous"] {
        for hold in ["first", "third"] {
            let generated = nonlinear(&format!("k = 50\nform = '{form}'\nhold = '{hold}'"));
            let mut random = Random::new(3);
            let calls = 3 * generated.design.valid_from_step;
            let run = Run {
                states: vec![vec![0.0; 3]; calls],
                measurements: (0..calls).map(|_| vec![random.within(-3.0, 3.0)]).collect(),
                inputs: (0..calls).map(|_| vec![random.within(-9.0, 9.0)]).collect(),
            };
            for (estimate, y) in run.through(&generated).estimates.iter().zip(&run.measurements) {
                assert_eq!(estimate[0].to_bits(), y[0].to_bits());
            }
        }
    }
}

/// The sum of the logarithms of the gains from bounded noise of the states that are not measured, for the k of a design.
fn objective(generated: &Generated, rest: &[usize], k: f64) -> f64 {
    let p = Precision::bits(512);
    let model = Model::new(&generated.plant, &[], p).unwrap();
    let coordinates = Coordinates::new(&model.c, rest.to_vec()).unwrap();
    let kh = k * generated.plant.sample_time_s();
    let a = (-Real::from_f64(kh, p).unwrap()).checked_exp().unwrap();
    let steps = generated.design.window_steps;
    let weights = Innovation::single_delay(&model, &coordinates, &a, steps).unwrap().0.weights(&model, steps);
    let noise: Vec<f64> =
        generated.plant.outputs.iter().map(|o| o.noise.as_ref().map_or(1.0, |noise| noise.to_f64().unwrap())).collect();
    let of = |weights: &Matrix, i: usize| -> f64 {
        noise.iter().enumerate().map(|(o, noise)| weights.get(i, o).to_f64().abs() * noise).sum()
    };
    rest.iter().map(|i| weights.iter().map(|w| of(w, *i)).sum::<f64>().ln()).sum()
}

/// "auto" finds the smallest noise gains: no k of a fine grid is better by more than 1 %, also where a window of 401
/// samples is thinned for the search.
#[test]
fn auto_is_the_best_k() {
    for (name, window, h, rest) in [
        ("dc_motor", 0.1, 2e-3, vec![1, 2]),
        ("pendulum", 0.05, 1e-3, vec![1]),
        ("two_mass_drive", 0.02, 5e-4, vec![2, 3]),
        ("inverted_cart", 0.2, 0.01, vec![2, 3]),
        ("dc_motor", 0.1, 2.5e-4, vec![1, 2]),
    ] {
        let text = corpus(name);
        let (before, after) = text.split_once("[observer.window]").unwrap();
        let after = after.split_once("[target]").unwrap().1;
        let text = format!("{before}[observer.single-delay]\nwindow = {window}\n\n[target]{after}");
        let generated = designed(&at_sample_time(&text, h));
        let summary = &generated.design.summary;
        let k: f64 = summary.split_once("k = ").unwrap().1.split(' ').next().unwrap().parse().unwrap();
        let ours = objective(&generated, &rest, k);
        let grid = (-48..=144).map(|i| f64::from(i) / 4.0 / window).map(|k| (k, objective(&generated, &rest, k)));
        let (best, least) = grid.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        let more = (ours - least).exp() - 1.0;
        println!("{name}: k = {k} 1/s, {:.2} % more than at {best:.1}", more * 100.0);
        assert!(more < 0.01, "{name}: {k} against {best}");
    }
}

/// The paper's own motor with a window of a second: its Gramian has a condition of 1e80, more than 256 bits hold. R of 000
/// (6) for samples, computed with 400 digits.
#[test]
fn a_long_window_has_as_many_digits_as_it_needs() {
    let text = "deadbeat = 1\nname = \"motor\"\n[plant]\nA = [[0, 1, 0], [0, -1, 15], [0, -36.4, -200]]\n\
                B = [[0], [0], [40]]\nC = [[1, 0, 0]]\n[observer.single-delay]\nwindow = 1.0\nk = 100\n\
                [target]\nsample_time = 1e-3\n";
    let generated = plant::designed(text);
    let r = generated.design.constants.iter().find(|matrix| matrix.letter == "R").unwrap();
    for (found, exact) in r.rows.iter().zip([92.052_691, -17.076_561]) {
        assert!((found[0] - exact).abs() < 1e-6, "{found:?}, exactly {exact}");
    }
}
