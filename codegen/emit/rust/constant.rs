//! Constants in Rust: the digits of [`literal::float`], in groups of three where they are many.
//!
//! clippy refuses literals that are nearly a constant of the standard library, whoever wrote them
//! ("3.14159"). Equal bits are spelled as that constant, others as bits.

use std::f64::consts;
use std::str::FromStr;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::ident;
use crate::program::{Scalar, literal};

/// A float without a suffix.
pub fn float(value: f64, scalar: Scalar) -> TokenStream {
    let magnitude = unsigned(value.abs(), scalar);
    if value.is_sign_negative() { quote!(-#magnitude) } else { magnitude }
}

/// An index without a suffix.
pub fn index(number: u32) -> TokenStream {
    let digits = number.to_string();
    let digits = if digits.len() > GROUPED { from_the_right(&digits) } else { digits };
    parsed(&digits)
}

/// A float that is not negative.
fn unsigned(value: f64, scalar: Scalar) -> TokenStream {
    let digits = literal::float(value, scalar);
    match known(&digits, scalar) {
        None => parsed(&grouped(&digits)),
        Some(Known::Equal(name)) => {
            let (module, name) = (ident(&scalar.to_string()), ident(name));
            quote!(::core::#module::consts::#name)
        }
        Some(Known::Near) => bits(value, scalar),
    }
}

/// How a literal relates to a constant of the standard library.
enum Known {
    Equal(&'static str),
    Near,
}

/// The constants that clippy knows, and the length of the shortest literal that it refuses.
const KNOWN: [(f64, &str, usize); 21] = [
    (consts::E, "E", 5),
    (consts::FRAC_1_PI, "FRAC_1_PI", 5),
    (consts::FRAC_1_SQRT_2, "FRAC_1_SQRT_2", 6),
    (consts::FRAC_2_PI, "FRAC_2_PI", 6),
    (consts::FRAC_2_SQRT_PI, "FRAC_2_SQRT_PI", 6),
    (consts::FRAC_PI_2, "FRAC_PI_2", 6),
    (consts::FRAC_PI_3, "FRAC_PI_3", 6),
    (consts::FRAC_PI_4, "FRAC_PI_4", 6),
    (consts::FRAC_PI_6, "FRAC_PI_6", 6),
    (consts::FRAC_PI_8, "FRAC_PI_8", 6),
    (consts::LN_2, "LN_2", 6),
    (consts::LN_10, "LN_10", 6),
    (consts::LOG2_10, "LOG2_10", 6),
    (consts::LOG2_E, "LOG2_E", 6),
    (consts::LOG10_2, "LOG10_2", 6),
    (consts::LOG10_E, "LOG10_E", 6),
    (consts::PI, "PI", 4),
    (consts::SQRT_2, "SQRT_2", 6),
    (consts::TAU, "TAU", 4),
    // Newer than the oldest compiler that we support: always spelled as bits.
    (1.618_033_988_749_895, "", 6),
    (0.577_215_664_901_532_9, "", 6),
];

/// Whether plain digits are a constant of the standard library, cut off or rounded somewhere.
fn known(digits: &str, scalar: Scalar) -> Option<Known> {
    let decimals = digits.split_once('.')?.1.len();
    let near = |constant: f64| format!("{constant:.decimals$}") == digits || constant.to_string().starts_with(digits);
    let (constant, name, _) =
        KNOWN.iter().find(|(constant, _, shortest)| digits.len() >= *shortest && near(*constant))?;
    let is_equal = !name.is_empty() && literal::float(rounded(*constant, scalar), scalar) == digits;
    Some(if is_equal { Known::Equal(name) } else { Known::Near })
}

/// A constant of the standard library in the scalar type.
fn rounded(constant: f64, scalar: Scalar) -> f64 {
    match scalar {
        #[expect(clippy::cast_possible_truncation, reason = "the rounding of the library's f32")]
        Scalar::F32 => f64::from(constant as f32),
        Scalar::F64 => constant,
    }
}

/// A float by its bits.
fn bits(value: f64, scalar: Scalar) -> TokenStream {
    let digits = match scalar {
        #[expect(clippy::cast_possible_truncation, reason = "the value is representable")]
        Scalar::F32 => format!("{:08x}", (value as f32).to_bits()),
        Scalar::F64 => format!("{:016x}", value.to_bits()),
    };
    let groups: Vec<&str> = (0..digits.len()).step_by(4).map(|at| &digits[at..at + 4]).collect();
    let bits = parsed(&format!("0x{}", groups.join("_")));
    let scalar = ident(&scalar.to_string());
    quote!(#scalar::from_bits(#bits))
}

/// The most digits that clippy reads without a separator.
const GROUPED: usize = 5;

/// A float literal with its digits in groups of three, if there are many.
fn grouped(digits: &str) -> String {
    let (mantissa, exponent) = digits.split_once('e').map_or((digits, None), |(m, e)| (m, Some(e)));
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(w, f)| (w, Some(f)));
    if whole.len() <= GROUPED && fraction.is_none_or(|fraction| fraction.len() <= GROUPED) {
        return digits.to_owned();
    }
    let mut text = from_the_right(whole);
    if let Some(fraction) = fraction {
        text.push('.');
        text.push_str(&from_the_left(fraction));
    }
    if let Some(exponent) = exponent {
        text.push('e');
        text.push_str(exponent);
    }
    text
}

/// `1234567` as `1_234_567`.
fn from_the_right(digits: &str) -> String {
    let first = digits.len() % 3;
    let (head, tail) = digits.split_at(first);
    [head, &from_the_left(tail)].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("_")
}

/// `1234567` as `123_456_7`.
fn from_the_left(digits: &str) -> String {
    let groups: Vec<&str> = (0..digits.len()).step_by(3).map(|at| &digits[at..digits.len().min(at + 3)]).collect();
    groups.join("_")
}

/// Digits as a token.
fn parsed(digits: &str) -> TokenStream {
    match Literal::from_str(digits) {
        Ok(literal) => quote!(#literal),
        Err(error) => unreachable!("`{digits}` is a number: {error}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Claim: the spelling is what clippy asks for.
    #[test]
    fn spells() {
        let spelled = |value, scalar| float(value, scalar).to_string().replace(' ', "");
        let cases = [
            (0.5, "0.5"),
            (-1.0, "-1.0"),
            (9.80665, "9.80665"),
            (1_234_567.25, "1_234_567.25"),
            (2.257_403_4, "2.257_403_4"),
            (-1.5e-9, "-1.5e-9"),
            (1.234_567_8e-12, "1.234_567_8e-12"),
            (157.0 / 50.0, "f64::from_bits(0x4009_1eb8_51eb_851f)"),
            (-std::f64::consts::PI, "-::core::f64::consts::PI"),
            (0.25, "0.25"),
        ];
        for (value, text) in cases {
            assert_eq!(spelled(value, Scalar::F64), text);
        }
        let single = f64::from(std::f32::consts::LN_2);
        assert_eq!(spelled(single, Scalar::F32), "::core::f32::consts::LN_2");
    }
}
