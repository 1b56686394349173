//! Claim: 003's implicit Euler matrices Z, F, O in closed form, and the output map M, are what another program
//! computed from the definitions with 60 digits (`tests/golden/zf_003.json`, `output_map_M.json`): each number the
//! nearest double, limits at T and rationals exactly.

use crate::support::golden;

use deadbeat_codegen::internals::decimal;
use deadbeat_codegen::internals::estimator::corrector::implicit_euler::{Gains, ImplicitEuler, output_map};
use deadbeat_codegen::internals::real::Rational;
use golden::{nearest, text};

/// The numbers behind a key of one case, as they are written; quotes are left out.
fn numbers(case: &str, key: &str) -> Vec<String> {
    let behind = case.split_once(&format!("\"{key}\":")).unwrap_or_else(|| panic!("no {key}")).1;
    let mut depth = 0;
    let end = behind.find(|c| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        depth == 0 && matches!(c, ']' | ',')
    });
    let words = behind[..end.unwrap_or(behind.len())].split(|c: char| "[]{}, \n\"".contains(c));
    words.filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

fn cases(file: &str) -> Vec<String> {
    let text = text(file);
    let cases: Vec<String> = text.split("\"n\":").skip(1).map(|case| format!("\"n\":{case}")).collect();
    assert!(!cases.is_empty(), "{file}");
    cases
}

fn rational(written: &str) -> Rational {
    decimal::parse(written).unwrap_or_else(|why| panic!("{written}: {why}"))
}

fn doubles(exact: &[Rational]) -> Vec<f64> {
    exact.iter().map(|number| number.to_f64().value()).collect()
}

#[test]
fn z_f_and_o_of_003_are_the_nearest_doubles() {
    for case in cases("zf_003") {
        let one = |key| rational(&numbers(&case, key)[0]);
        let (time, h, t) = (one("T"), one("h"), one("t"));
        let l: Vec<Rational> = numbers(&case, "L").iter().map(|written| rational(written)).collect();
        let left = (&time - &t) / &h;
        let euler = ImplicitEuler::new(&Gains::efimov_orlov(&l, &time, &left), &h).unwrap();
        nearest("Z", &doubles(&euler.z.concat()), &numbers(&case, "Z"));
        nearest("F", &doubles(&euler.f), &numbers(&case, "F"));
        match euler.o {
            Some(o) => nearest("O", &doubles(&[o]), &numbers(&case, "O")),
            None => assert_eq!(numbers(&case, "O"), ["inf"]),
        }
    }
}

#[test]
fn the_output_map_is_the_golden_one_exactly() {
    for case in cases("output_map_M") {
        let n: usize = numbers(&case, "n")[0].parse().unwrap();
        let written: Vec<Rational> = numbers(&case, "M_exact").iter().map(|number| number.parse().unwrap()).collect();
        assert_eq!(output_map(n).concat(), written, "n = {n}");
    }
}
