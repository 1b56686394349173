//! Claim: the constants of the motor's window observer are the doubles nearest to the true ones, which
//! another program computed with 70 digits (tests/golden/motor_twin.json).

#[path = "support/plant.rs"]
mod plant;

use deadbeat_codegen::Generated;
use plant::{designed, functional, matrix};
use serde_json::Value;

/// The golden plant: both columns of B are inputs that keep their value.
const MOTOR: &str = "
deadbeat = 1
name = 'motor'
[plant]
A = [[0, 1, 0], [0, -1, 15], [0, -36.4, -200]]
B = [[0, 0], [-35, 0], [0, 40]]
C = [[1, 0, 0]]
[inputs]
sin_y = {}
u = {}
[observer.window]
window = 0.1
[target]
sample_time = 1e-3
scalar = 'f64'
";

fn golden() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/motor_twin.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Numbers of a list, whatever its depth, in order; 17 digits read back to the one double.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(entries) => entries.iter().flat_map(numbers).collect(),
        Value::Number(number) => vec![number.as_f64().unwrap()],
        other => panic!("{other} is no number"),
    }
}

fn flat(matrices: &[Vec<Vec<f64>>]) -> Vec<f64> {
    matrices.iter().flatten().flatten().copied().collect()
}

/// Every bit of two lists.
fn same_bits(what: &str, ours: &[f64], golden: &[f64]) {
    assert_eq!(ours.len(), golden.len(), "{what}");
    let different: Vec<(usize, f64, f64)> = (0..ours.len())
        .filter(|i| ours[*i].to_bits() != golden[*i].to_bits())
        .map(|i| (i, ours[i], golden[i]))
        .collect();
    assert!(different.is_empty(), "{what}: {} of {} differ: {different:?}", different.len(), ours.len());
}

fn motor() -> Generated {
    designed(MOTOR)
}

/// K by age 0 … N and M by age 1 … N, to the last bit; M has nothing at age 0.
#[test]
fn the_weights_are_the_nearest_doubles() {
    let (generated, golden) = (motor(), golden());
    let fir = generated.design.fir.as_ref().unwrap();
    assert_eq!(fir.known, ["sin_y", "u"]);
    same_bits("K", &flat(&fir.k), &numbers(&golden["fir"]["K"]));
    same_bits("M", &flat(&fir.m[1..]), &numbers(&golden["fir"]["M"]));
    assert!(flat(&fir.m[..1]).iter().all(|m| *m == 0.0), "an input that is held since the last call has no weight at age 0");
}

/// Phi to the last bit.
#[test]
fn the_transition_is_the_nearest_double() {
    let generated = motor();
    let ours: Vec<f64> = matrix(&generated, "Phi").iter().flatten().copied().collect();
    same_bits("Phi", &ours, &numbers(&golden()["Phi"]));
}

/// The gains to 1e-14: they are sums of 101 rounded terms of one sign, each rounding at most 1.1e-16 of the sum.
#[test]
fn the_gains_agree() {
    let (generated, golden) = (motor(), golden());
    let certificate = &generated.design.certificate;
    for (ours, key) in [(&certificate.noise_gain_l1, "l1_gain"), (&certificate.noise_gain_l2, "l2_gain")] {
        for (ours, golden) in ours.iter().zip(numbers(&golden["fir"][key])) {
            let relative = (ours[0] - golden).abs() / golden;
            println!("{key}: {} against {golden}, {relative:.1e}", ours[0]);
            assert!(relative <= 1e-14, "{key}: {} against {golden}", ours[0]);
        }
    }
}

/// What the step carries in double precision is what the report shows.
#[test]
fn the_report_shows_what_the_step_carries() {
    let generated = motor();
    let (fir, functional) = (generated.design.fir.as_ref().unwrap(), functional(&generated));
    let rows: Vec<&Vec<f64>> = generated.program.tables.iter().flat_map(|table| &table.rows).collect();
    for age in 8..90 {
        for i in 0..3 {
            assert_eq!(fir.k[age][i][0], functional.outputs[0].at(i, age).double);
            assert!(rows.iter().any(|row| row.contains(&fir.k[age][i][0])), "K, age {age}, state {i}");
        }
    }
}
