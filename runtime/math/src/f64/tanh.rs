//! Hyperbolic tangent.

use crate::f64::format::{INFINITY_F64, MAGNITUDE_F64, NAN_F64, ONE_F64, SIGN_F64, rounded_f64, unpacked_f64};
use crate::kernel::tanh::tanh;

/// Hyperbolic tangent, error below 0.51 ulp.
#[must_use]
pub fn tanh_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    let sign: u64 = bits & SIGN_F64;
    if magnitude > INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return x;
    }
    if magnitude >= 0x4040_0000_0000_0000 {
        return f64::from_bits(sign | ONE_F64);
    }
    rounded_f64(sign, tanh(unpacked_f64(magnitude)))
}
