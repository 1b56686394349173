//! Claim: the constants of the motor's window observer are the doubles nearest to the true ones, which
//! two other programs computed: with 70 digits, of which 17 are kept (`tests/golden/motor_twin.json`), and
//! with 400, of which 40 are kept (`tests/golden/motor_fir_40.json`, by the script beside it).
//!
//! Seventeen digits do not tell the nearest double where the true number lies within half a unit of the
//! last digit of the middle between two; forty do.

use crate::support::plant;

use deadbeat_codegen::Generated;
use plant::{designed, functional, matrix};

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

/// The numbers of a list of a golden file, whatever its depth, as they are written.
fn golden(file: &str, key: &str) -> Vec<String> {
    let path = format!("{}/tests/golden/{file}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let list = text.split_once(&format!("\"{key}\": [")).unwrap_or_else(|| panic!("no {key}")).1;
    let mut depth = 1;
    let end = list.find(|c| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        depth == 0
    });
    let numbers = list[..end.unwrap()].split(|c: char| "[], \n".contains(c)).filter(|word| !word.is_empty());
    numbers.map(str::to_owned).collect()
}

fn flat(matrices: &[Vec<Vec<f64>>]) -> Vec<f64> {
    matrices.iter().flatten().flatten().copied().collect()
}

/// Every number is the double nearest to the forty digits, and within one unit of the last place of
/// the seventeen, which may have been rounded across the middle between two doubles.
fn nearest(key: &str, ours: &[f64]) {
    let (forty, seventeen) = (golden("motor_fir_40", key), golden("motor_twin", key));
    assert_eq!((ours.len(), ours.len()), (forty.len(), seventeen.len()), "{key}");
    let mut apart = 0;
    for ((ours, forty), seventeen) in ours.iter().zip(&forty).zip(&seventeen) {
        assert_eq!(ours.to_bits(), forty.parse::<f64>().unwrap().to_bits(), "{key}: {ours} is not nearest to {forty}");
        let twin: f64 = seventeen.parse().unwrap();
        assert!(ours.to_bits().abs_diff(twin.to_bits()) <= 1, "{key}: {ours} against {seventeen}");
        apart += u32::from(ours.to_bits() != twin.to_bits());
    }
    println!(
        "{key}: {} numbers, all nearest; {apart} differ in the last bit from the golden file of 17 digits",
        ours.len()
    );
}

fn motor() -> Generated {
    designed(MOTOR)
}

/// K by age 0 … N and M by age 1 … N, to the last bit; M has nothing at age 0.
#[test]
fn the_weights_are_the_nearest_doubles() {
    let generated = motor();
    let fir = generated.design.fir.as_ref().unwrap();
    assert_eq!(fir.known, ["sin_y", "u"]);
    nearest("K", &flat(&fir.k));
    nearest("M", &flat(&fir.m[1..]));
    assert!(
        flat(&fir.m[..1]).iter().all(|m| *m == 0.0),
        "an input that is held since the last call has no weight at age 0"
    );
}

/// Phi to the last bit.
#[test]
fn the_transition_is_the_nearest_double() {
    let generated = motor();
    let ours: Vec<f64> = matrix(&generated, "Phi").iter().flatten().copied().collect();
    nearest("Phi", &ours);
}

/// The gains to 1e-14: they are sums of 101 rounded terms of one sign, each rounding at most 1.1e-16 of the sum.
#[test]
fn the_gains_agree() {
    let generated = motor();
    let certificate = &generated.design.certificate;
    for (ours, key) in [(&certificate.noise_gain_l1, "l1_gain"), (&certificate.noise_gain_l2, "l2_gain")] {
        for (ours, golden) in ours.iter().zip(golden("motor_twin", key)) {
            let golden: f64 = golden.parse().unwrap();
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
            assert_eq!(fir.k[age][i][0].to_bits(), functional.outputs[0].at(i, age).double.to_bits());
            assert!(rows.iter().any(|row| row.contains(&fir.k[age][i][0])), "K, age {age}, state {i}");
        }
    }
}
