//! Natural logarithm.

use crate::f64::format::{
    INFINITY_F64, MAGNITUDE_F64, NAN_F64, ONE_F64, SIGN_F64, rounded_f64, sign_f64, unpacked_f64,
};
use crate::kernel::log::logarithm;
use crate::scaled::Signed;

/// Natural logarithm, error below 0.51 ulp.
#[must_use]
pub fn log_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    if (bits & MAGNITUDE_F64) == 0 {
        return f64::from_bits(SIGN_F64 | INFINITY_F64);
    }
    if bits > INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if bits == INFINITY_F64 {
        return x;
    }
    if bits == ONE_F64 {
        return f64::from_bits(0);
    }
    let value: Signed = logarithm(unpacked_f64(bits));
    rounded_f64(sign_f64(value.negative), value.magnitude)
}
