//! Exponential function.

use crate::constants::LOG2_E;
use crate::f32::format::{INFINITY_F32, MAGNITUDE_F32, NAN_F32, ONE_F32, rounded_f32, unpacked_f32};
use crate::kernel::exp2::exp2;
use crate::scaled::{Scaled, product, scaled};

/// Exponential function, the nearest `f32`.
#[must_use]
pub fn exp_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    let negative: bool = bits != magnitude;
    if magnitude > INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude >= 0x4300_0000 {
        return f32::from_bits(if negative { 0 } else { INFINITY_F32 });
    }
    if magnitude < 0x3080_0000 {
        return f32::from_bits(ONE_F32);
    }
    let power: Scaled = product(unpacked_f32(magnitude), scaled(LOG2_E, 0));
    rounded_f32(0, exp2(negative, power.significand, 0, power.exponent))
}
