//! Square root, always correctly rounded.

use crate::f32::format::{INFINITY_F32, MAGNITUDE_F32, NAN_F32, unpacked_f32};
use crate::root::reciprocal_root;
use crate::scaled::Scaled;

/// Square root, always correctly rounded: an approximation, corrected by its exact remainder.
#[must_use]
pub fn sqrt_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    if (bits & MAGNITUDE_F32) == 0 {
        return x;
    }
    if bits > INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if bits == INFINITY_F32 {
        return x;
    }
    let operand: Scaled = unpacked_f32(bits);
    let odd: i32 = operand.exponent & 1;
    let v: u64 = operand.significand >> (33 - odd);
    let mut digits: u64 = (v * reciprocal_root(v)) >> 38;
    let mut rest: u64 = (v << 16).wrapping_sub(digits.wrapping_mul(digits));
    if (rest >> 63) != 0 {
        digits -= 1;
        rest = rest.wrapping_add(2 * digits + 1);
    }
    if rest > 2 * digits {
        rest -= 2 * digits + 1;
        digits += 1;
    }
    let up: u64 = if rest > digits { 1 } else { 0 };
    let field: i32 = ((operand.exponent - odd) / 2) + 126;
    f32::from_bits(((field as u32) << 23) + ((digits + up) as u32))
}
