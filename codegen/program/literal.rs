//! The one printer of float constants: the shortest decimal that reads back to the same bits.
//!
//! In: a constant and the type it is read as. Out: text that is a float literal in Rust, in C and
//! in JSON alike (it always has a point or an exponent); a language's suffix goes behind it.

use std::fmt::{Display, LowerExp};

use super::Scalar;

/// Decimal exponents that are printed as plain decimals: `1e-4 <= |x| < 1e7`.
const PLAIN: std::ops::RangeInclusive<i32> = -4..=6;

/// The shortest text that reads back to `value`, which is finite and representable in `scalar`.
///
/// `1.0`, `0.0735`, `-0.0`, `7.610685e-9`, `1e-300`.
#[must_use]
pub fn float(value: f64, scalar: Scalar) -> String {
    match scalar {
        #[expect(clippy::cast_possible_truncation, reason = "the value is representable")]
        Scalar::F32 => shortest(value as f32),
        Scalar::F64 => shortest(value),
    }
}

/// Rust's own shortest digits, plain or with an exponent.
fn shortest(value: impl Display + LowerExp) -> String {
    let scientific = format!("{value:e}");
    let exponent = scientific.split_once('e').and_then(|(_, digits)| digits.parse().ok());
    if !exponent.is_some_and(|exponent| PLAIN.contains(&exponent)) {
        return scientific;
    }
    let plain = value.to_string();
    if plain.contains('.') { plain } else { plain + ".0" }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Claim: the form of a literal follows from its decimal exponent.
    #[test]
    fn forms() {
        let cases = [
            (0.0, "0.0"),
            (-0.0, "-0.0"),
            (1.0, "1.0"),
            (0.0735, "0.0735"),
            (0.0001, "0.0001"),
            (0.000_099, "9.9e-5"),
            (9_999_999.0, "9999999.0"),
            (1e7, "1e7"),
            (-1.5e-300, "-1.5e-300"),
            (f64::MAX, "1.7976931348623157e308"),
            (5e-324, "5e-324"),
        ];
        for (value, text) in cases {
            assert_eq!(float(value, Scalar::F64), text);
        }
        assert_eq!(float(f64::from(0.1_f32), Scalar::F32), "0.1");
        assert_eq!(float(f64::from(1e-4_f32), Scalar::F32), "0.0001");
        assert_eq!(float(f64::from(f32::MAX), Scalar::F32), "3.4028235e38");
    }

    /// Claim: a literal reads back bit for bit and is a float in Rust, C and JSON, whatever the bits.
    #[test]
    fn reads_back() {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        for _ in 0..100_000 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let double = f64::from_bits(state);
            if double.is_finite() {
                let text = float(double, Scalar::F64);
                assert_eq!(text.parse().map(f64::to_bits), Ok(state), "{text}");
                assert!(text.contains(['.', 'e']), "{text}");
            }
            let bits = (state >> 32) as u32;
            let single = f32::from_bits(bits);
            if single.is_finite() {
                let text = float(f64::from(single), Scalar::F32);
                assert_eq!(text.parse().map(f32::to_bits), Ok(bits), "{text}");
                assert!(text.contains(['.', 'e']), "{text}");
            }
        }
    }
}
