//! The f64 format: taking numbers apart, rounding them to the nearest.

use crate::scaled::{Scaled, normalised, scaled};

// Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1.
pub(crate) const SIGN_F64: u64 = 0x8000_0000_0000_0000;
pub(crate) const MAGNITUDE_F64: u64 = 0x7FFF_FFFF_FFFF_FFFF;
pub(crate) const INFINITY_F64: u64 = 0x7FF0_0000_0000_0000;
pub(crate) const NAN_F64: u64 = 0x7FF8_0000_0000_0000;
pub(crate) const ONE_F64: u64 = 0x3FF0_0000_0000_0000;

/// The finite positive number with these bits, not 0; exact.
pub(crate) fn unpacked_f64(magnitude: u64) -> Scaled {
    let field: i32 = (magnitude >> 52) as i32;
    let digits: u64 = magnitude << 11;
    if field == 0 {
        return normalised(digits, -1022);
    }
    scaled(digits | (1_u64 << 63), field - 1023)
}

/// The sign bit of a negative number, else 0.
pub(crate) fn sign_f64(negative: bool) -> u64 {
    if negative {
        return SIGN_F64;
    }
    0
}

/// x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in.
pub(crate) fn rounded_f64(sign: u64, x: Scaled) -> f64 {
    let field: i32 = x.exponent + 1023;
    if field >= 2047 {
        return f64::from_bits(sign | INFINITY_F64);
    }
    let shift: i32 = if field > 0 { 11 } else { 12 - field };
    if shift > 63 {
        let least: bool = shift == 64 && x.significand > (1_u64 << 63);
        return f64::from_bits(if least { sign + 1 } else { sign });
    }
    let kept: u64 = x.significand >> shift;
    let rest: u64 = x.significand - (kept << shift);
    let half: u64 = 1_u64 << (shift - 1);
    let odd: u64 = kept & 1;
    let up: u64 = if rest + odd > half { 1 } else { 0 };
    let base: u64 = if field > 0 { ((field - 1) as u64) << 52 } else { 0 };
    f64::from_bits(sign | (base + (kept + up)))
}
