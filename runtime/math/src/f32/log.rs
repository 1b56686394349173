//! Natural logarithm.

use crate::f32::format::{
    INFINITY_F32, MAGNITUDE_F32, NAN_F32, ONE_F32, SIGN_F32, rounded_f32, sign_f32, unpacked_f32,
};
use crate::kernel::log::logarithm;
use crate::scaled::Signed;

/// Natural logarithm, the nearest `f32`.
#[must_use]
pub fn log_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    if (bits & MAGNITUDE_F32) == 0 {
        return f32::from_bits(SIGN_F32 | INFINITY_F32);
    }
    if bits > INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if bits == INFINITY_F32 {
        return x;
    }
    if bits == ONE_F32 {
        return f32::from_bits(0);
    }
    let value: Signed = logarithm(unpacked_f32(bits));
    rounded_f32(sign_f32(value.negative), value.magnitude)
}
