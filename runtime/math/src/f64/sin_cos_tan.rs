//! Sine, cosine and tangent.

use crate::f64::format::{INFINITY_F64, MAGNITUDE_F64, NAN_F64, ONE_F64, SIGN_F64, rounded_f64, sign_f64};
use crate::f64::reduce::reduce_f64;
use crate::kernel::reduce::{Turned, cosine_at, sine_at};
use crate::kernel::sin_cos::{cosine, sine};
use crate::scaled::{Scaled, Signed, quotient};

/// Sine of an angle in radians, error below 0.51 ulp.
#[must_use]
pub fn sin_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    if magnitude >= INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return x;
    }
    let value: Signed = sine_at(reduce_f64(magnitude));
    rounded_f64((bits & SIGN_F64) ^ sign_f64(value.negative), value.magnitude)
}

/// Cosine of an angle in radians, error below 0.51 ulp.
#[must_use]
pub fn cos_f64(x: f64) -> f64 {
    let magnitude: u64 = x.to_bits() & MAGNITUDE_F64;
    if magnitude >= INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return f64::from_bits(ONE_F64);
    }
    let value: Signed = cosine_at(reduce_f64(magnitude));
    rounded_f64(sign_f64(value.negative), value.magnitude)
}

/// Tangent of an angle in radians, error below 0.51 ulp.
#[must_use]
pub fn tan_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    if magnitude >= INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return x;
    }
    let angle: Turned = reduce_f64(magnitude);
    let odd: bool = (angle.quadrant & 1) != 0;
    let sign: u64 = (bits & SIGN_F64) ^ sign_f64(angle.rest.negative != odd);
    let rise: Scaled = sine(angle.rest.magnitude);
    let run: Scaled = cosine(angle.rest.magnitude);
    rounded_f64(sign, quotient(if odd { run } else { rise }, if odd { rise } else { run }))
}
