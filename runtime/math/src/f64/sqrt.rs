//! Square root, always correctly rounded.

use crate::f64::format::{INFINITY_F64, MAGNITUDE_F64, NAN_F64, unpacked_f64};
use crate::root::root;
use crate::scaled::Scaled;

/// Square root, always correctly rounded: an approximation, corrected by its exact remainder.
#[must_use]
pub fn sqrt_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    if (bits & MAGNITUDE_F64) == 0 {
        return x;
    }
    if bits > INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if bits == INFINITY_F64 {
        return x;
    }
    let operand: Scaled = unpacked_f64(bits);
    let odd: i32 = operand.exponent & 1;
    let v: u64 = operand.significand >> (1 - odd);
    let mut digits: u64 = root(v) >> 11;
    let mut rest: u64 = (v << 42).wrapping_sub(digits.wrapping_mul(digits));
    if (rest >> 63) != 0 {
        digits -= 1;
        rest = rest.wrapping_add(2 * digits + 1);
    }
    if rest > 2 * digits {
        rest -= 2 * digits + 1;
        digits += 1;
    }
    let up: u64 = if rest > digits { 1 } else { 0 };
    let field: i32 = ((operand.exponent - odd) / 2) + 1022;
    f64::from_bits(((field as u64) << 52) + digits + up)
}
