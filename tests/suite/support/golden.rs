//! Numbers of the files of `tests/golden/` as they are written there, and what so many digits decide.

#![allow(dead_code, reason = "each test uses a part of it")]

use deadbeat_codegen::internals::real::{Precision, Real};

/// The text of a golden file.
pub fn text(file: &str) -> String {
    let path = format!("{}/tests/golden/{file}.json", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The number, or the numbers of a list of any depth, behind some keys, each within the one before.
pub fn golden(file: &str, keys: &[&str]) -> Vec<String> {
    let text = text(file);
    let inside = keys.iter().fold(text.as_str(), |text, key| {
        text.split_once(&format!("\"{key}\":")).unwrap_or_else(|| panic!("no {key} in {file}")).1.trim_start()
    });
    let mut depth = 0;
    let end = inside.find(|c| {
        depth += i32::from(c == '[') - i32::from(c == ']');
        depth == 0 && (c == ']' || c == ',' || c == '\n')
    });
    let numbers = inside[..end.unwrap()].split(|c: char| "[], \n".contains(c)).filter(|word| !word.is_empty());
    numbers.map(str::to_owned).collect()
}

/// Whether a number that is written so, to 17 digits, can have this nearest double.
///
/// The true number is within half a unit of the 17th digit of the written one, and within half a unit in the last
/// place of its nearest double; nothing is rounded in the comparison.
pub fn can_be_nearest(ours: f64, written: &str) -> bool {
    let exact = |x: f64| Real::from_f64(x, Precision::bits(64)).unwrap().to_rational().unwrap();
    let golden = deadbeat_codegen::internals::decimal::parse(written).unwrap();
    let power = format!("{:e}", written.parse::<f64>().unwrap());
    let power: i32 = power.split_once('e').unwrap().1.parse().unwrap();
    let digit = deadbeat_codegen::internals::decimal::parse(&format!("0.5e{}", power - 16)).unwrap();
    let (below, above) = (exact(ours.next_down()), exact(ours.next_up()));
    // Twice the number, between the middles to both neighbours.
    let (twice, ours) = (&golden + &golden, exact(ours));
    let digit = &digit + &digit;
    &twice + &digit >= &below + &ours && &twice - &digit <= &above + &ours
}

/// Every number is the nearest double to one that is written so.
pub fn nearest(what: &str, ours: &[f64], written: &[String]) {
    assert_eq!(ours.len(), written.len(), "{what}");
    for (ours, written) in ours.iter().zip(written) {
        assert!(can_be_nearest(*ours, written), "{what}: {ours} is not nearest to {written}");
    }
}
