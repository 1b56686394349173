//! Claim: the constants of the single-delay observer are the doubles nearest to those that other programs computed
//! with 70 digits (`tests/golden/motor_000.json` for the paper's integrals, `motor_twin.json` for the sampled twin),
//! and what the design says of itself holds of any plant: no bias, fixed points, no dependence on k.

#[path = "support/golden.rs"]
mod golden;
#[path = "support/plant.rs"]
mod plant;

use deadbeat_codegen::Generated;
use deadbeat_codegen::real::{Matrix, Precision, Real, inverse};
use deadbeat_codegen::window::coordinates::Coordinates;
use deadbeat_codegen::window::innovation::{Innovation, SingleDelay};
use deadbeat_codegen::window::model::Model;
use golden::{golden, nearest};
use plant::{designed, matrix};

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
