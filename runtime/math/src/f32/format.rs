//! The f32 format: taking numbers apart, rounding them to the nearest.

use crate::scaled::{Scaled, normalised, scaled};

// Bits of the sign, of the largest magnitude, of infinity, of the only NaN returned, of 1.
pub(crate) const SIGN_F32: u32 = 0x8000_0000;
pub(crate) const MAGNITUDE_F32: u32 = 0x7FFF_FFFF;
pub(crate) const INFINITY_F32: u32 = 0x7F80_0000;
pub(crate) const NAN_F32: u32 = 0x7FC0_0000;
pub(crate) const ONE_F32: u32 = 0x3F80_0000;

/// The finite positive number with these bits, not 0; exact.
pub(crate) fn unpacked_f32(magnitude: u32) -> Scaled {
    let field: i32 = (magnitude >> 23) as i32;
    let digits: u64 = u64::from(magnitude) << 40;
    if field == 0 {
        return normalised(digits, -126);
    }
    scaled(digits | (1_u64 << 63), field - 127)
}

/// The sign bit of a negative number, else 0.
pub(crate) fn sign_f32(negative: bool) -> u32 {
    if negative {
        return SIGN_F32;
    }
    0
}

/// x rounded to the nearest, ties to even, with subnormals and overflow, and the sign put in.
pub(crate) fn rounded_f32(sign: u32, x: Scaled) -> f32 {
    let field: i32 = x.exponent + 127;
    if field >= 255 {
        return f32::from_bits(sign | INFINITY_F32);
    }
    let shift: i32 = if field > 0 { 40 } else { 41 - field };
    if shift > 63 {
        let least: bool = shift == 64 && x.significand > (1_u64 << 63);
        return f32::from_bits(if least { sign + 1 } else { sign });
    }
    let kept: u64 = x.significand >> shift;
    let rest: u64 = x.significand - (kept << shift);
    let half: u64 = 1_u64 << (shift - 1);
    let odd: u64 = kept & 1;
    let up: u64 = if rest + odd > half { 1 } else { 0 };
    let base: u32 = if field > 0 { ((field - 1) as u32) << 23 } else { 0 };
    f32::from_bits(sign | (base + ((kept + up) as u32)))
}
