//! Hyperbolic tangent.

use crate::f32::format::{INFINITY_F32, MAGNITUDE_F32, NAN_F32, ONE_F32, SIGN_F32, rounded_f32, unpacked_f32};
use crate::kernel::tanh::tanh;

/// Hyperbolic tangent, the nearest `f32`.
#[must_use]
pub fn tanh_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    let sign: u32 = bits & SIGN_F32;
    if magnitude > INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return x;
    }
    if magnitude >= 0x4200_0000 {
        return f32::from_bits(sign | ONE_F32);
    }
    rounded_f32(sign, tanh(unpacked_f32(magnitude)))
}
