//! Sine, cosine and tangent.

use crate::f32::format::{INFINITY_F32, MAGNITUDE_F32, NAN_F32, ONE_F32, SIGN_F32, rounded_f32, sign_f32};
use crate::f32::reduce::reduce_f32;
use crate::kernel::reduce::{Turned, cosine_at, sine_at};
use crate::kernel::sin_cos::{cosine, sine};
use crate::scaled::{Scaled, Signed, quotient};

/// Sine of an angle in radians, the nearest `f32`.
#[must_use]
pub fn sin_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    if magnitude >= INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return x;
    }
    let value: Signed = sine_at(reduce_f32(magnitude));
    rounded_f32((bits & SIGN_F32) ^ sign_f32(value.negative), value.magnitude)
}

/// Cosine of an angle in radians, the nearest `f32`.
#[must_use]
pub fn cos_f32(x: f32) -> f32 {
    let magnitude: u32 = x.to_bits() & MAGNITUDE_F32;
    if magnitude >= INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return f32::from_bits(ONE_F32);
    }
    let value: Signed = cosine_at(reduce_f32(magnitude));
    rounded_f32(sign_f32(value.negative), value.magnitude)
}

/// Tangent of an angle in radians, the nearest `f32`.
#[must_use]
pub fn tan_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    if magnitude >= INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return x;
    }
    let angle: Turned = reduce_f32(magnitude);
    let odd: bool = (angle.quadrant & 1) != 0;
    let sign: u32 = (bits & SIGN_F32) ^ sign_f32(angle.rest.negative != odd);
    let rise: Scaled = sine(angle.rest.magnitude);
    let run: Scaled = cosine(angle.rest.magnitude);
    rounded_f32(sign, quotient(if odd { run } else { rise }, if odd { rise } else { run }))
}
