//! Decimal text to an exact rational: `0.1` is one tenth.
//!
//! Knows digits and exponents. Never knows what a number is for.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// Largest decimal exponent that is read; a double ends at 308.
const MAX_EXPONENT: i32 = 400;
/// Most digits that are read.
const MAX_DIGITS: usize = 400;

/// Reads an unsigned or signed decimal such as `-1_000.5e-3`.
pub fn parse(text: &str) -> Result<RBig, String> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent_of(exponent).ok_or_else(|| too_far(text))?),
        None => (digits.as_str(), 0),
    };
    let (negative, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa.strip_prefix('+').unwrap_or(mantissa)),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{fraction}");
    if all.is_empty() || !all.bytes().all(|b| b.is_ascii_digit()) {
        return Err(format!("`{}` is not a decimal number", shorten(text)));
    }
    if all.len() > MAX_DIGITS {
        return Err(format!("a number of {} digits; at most {MAX_DIGITS} are read", all.len()));
    }
    let scale = exponent - i32::try_from(fraction.len()).unwrap_or(i32::MAX);
    let magnitude =
        UBig::from_str_radix(&all, 10).map_err(|_| format!("`{}` is not a decimal number", shorten(text)))?;
    let signed = if negative { -IBig::from(magnitude) } else { IBig::from(magnitude) };
    let power = UBig::from(10_u8).pow(scale.unsigned_abs() as usize);
    Ok(if scale >= 0 { RBig::from(signed * IBig::from(power)) } else { RBig::from_parts(signed, power) })
}

/// A measured number for messages: up to nine digits, with an exponent where zeros would pile up.
pub fn show(value: f64) -> String {
    let short: f64 = format!("{value:.8e}").parse().unwrap_or(value);
    let size = short.abs();
    if size == 0.0 || !size.is_finite() || (1e-5..1e9).contains(&size) {
        short.to_string()
    } else {
        format!("{short:e}")
    }
}

fn exponent_of(text: &str) -> Option<i32> {
    text.parse::<i32>().ok().filter(|e| e.unsigned_abs() <= MAX_EXPONENT.unsigned_abs())
}

fn too_far(text: &str) -> String {
    format!("`{}` has an exponent beyond {MAX_EXPONENT}", shorten(text))
}

fn shorten(text: &str) -> String {
    if text.chars().count() <= 32 { text.to_owned() } else { text.chars().take(29).chain("...".chars()).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Decimals are what they say, not their nearest binary float.
    #[test]
    fn decimals_are_exact() {
        assert_eq!(parse("0.1").unwrap() * RBig::from(10), RBig::from(1));
        assert_eq!(parse("-1_000.5e-3").unwrap(), RBig::from_parts(IBig::from(-10_005), UBig::from(10_000_u32)));
        assert_eq!(parse("2e3").unwrap(), RBig::from(2_000));
    }

    /// What is no decimal, or has no sensible size, is refused with the reason.
    #[test]
    fn the_rest_is_refused() {
        for text in
            ["", "-", ".", "1e", "1e401", "1e99999999999", "1e-2147483648", "inf", "nan", "0x10", &"9".repeat(401)]
        {
            assert!(parse(text).is_err(), "{text:.40}");
        }
    }
}
