//! Exponential function.

use crate::constants::{LOG2_E, LOG2_E_LOW};
use crate::f64::format::{INFINITY_F64, MAGNITUDE_F64, NAN_F64, ONE_F64, rounded_f64, unpacked_f64};
use crate::fixed::{Pair, pair, pair_times};
use crate::kernel::exp2::exp2;
use crate::scaled::Scaled;

/// Exponential function, error below 0.51 ulp.
#[must_use]
pub fn exp_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    let negative: bool = bits != magnitude;
    if magnitude > INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude >= 0x4090_0000_0000_0000 {
        return f64::from_bits(if negative { 0 } else { INFINITY_F64 });
    }
    if magnitude < 0x3C00_0000_0000_0000 {
        return f64::from_bits(ONE_F64);
    }
    let operand: Scaled = unpacked_f64(magnitude);
    let power: Pair = pair_times(pair(LOG2_E, LOG2_E_LOW), operand.significand);
    let shift: i32 = if (power.high >> 63) == 0 { 1 } else { 0 };
    let high: u64 = (power.high << shift) | ((power.low >> 1) >> (63 - shift));
    let exponent: i32 = operand.exponent + 1 - shift;
    rounded_f64(0, exp2(negative, high, power.low << shift, exponent))
}
