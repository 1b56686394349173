//! Inverse sine, cosine and tangent.

use crate::constants::PI;
use crate::f32::format::{INFINITY_F32, MAGNITUDE_F32, NAN_F32, ONE_F32, SIGN_F32, rounded_f32, unpacked_f32};
use crate::kernel::arcsine::other_leg;
use crate::kernel::atan::angle;
use crate::scaled::{Scaled, scaled, sum};

/// Inverse sine, the nearest `f32`.
#[must_use]
pub fn asin_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    let sign: u32 = bits & SIGN_F32;
    if magnitude > ONE_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return x;
    }
    if magnitude == ONE_F32 {
        return rounded_f32(sign, scaled(PI, 0));
    }
    let opposite: Scaled = unpacked_f32(magnitude);
    rounded_f32(sign, angle(opposite, other_leg(opposite), false))
}

/// Inverse cosine, the nearest `f32`.
#[must_use]
pub fn acos_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    if magnitude > ONE_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return rounded_f32(0, scaled(PI, 0));
    }
    if bits == ONE_F32 {
        return f32::from_bits(0);
    }
    if magnitude == ONE_F32 {
        return rounded_f32(0, scaled(PI, 1));
    }
    let adjacent: Scaled = unpacked_f32(magnitude);
    rounded_f32(0, angle(other_leg(adjacent), adjacent, bits != magnitude))
}

/// Inverse tangent, the nearest `f32`.
#[must_use]
pub fn atan_f32(x: f32) -> f32 {
    let bits: u32 = x.to_bits();
    let magnitude: u32 = bits & MAGNITUDE_F32;
    let sign: u32 = bits & SIGN_F32;
    if magnitude > INFINITY_F32 {
        return f32::from_bits(NAN_F32);
    }
    if magnitude == 0 {
        return x;
    }
    if magnitude == INFINITY_F32 {
        return rounded_f32(sign, scaled(PI, 0));
    }
    rounded_f32(sign, angle(unpacked_f32(magnitude), scaled(1_u64 << 63, 0), false))
}

/// Angle of the point (x, y), from -pi to pi, error below 0.500001 ulp.
#[must_use]
pub fn atan2_f32(y: f32, x: f32) -> f32 {
    let sign: u32 = y.to_bits() & SIGN_F32;
    let rise: u32 = y.to_bits() & MAGNITUDE_F32;
    let run: u32 = x.to_bits() & MAGNITUDE_F32;
    let behind: bool = x.to_bits() != run;
    if (rise > INFINITY_F32) || (run > INFINITY_F32) {
        return f32::from_bits(NAN_F32);
    }
    if (rise == INFINITY_F32) && (run == INFINITY_F32) {
        let quarter: Scaled = scaled(PI, -1);
        return rounded_f32(sign, if behind { sum(scaled(PI, 0), quarter) } else { quarter });
    }
    if (rise == 0) || (run == INFINITY_F32) {
        if behind {
            return rounded_f32(sign, scaled(PI, 1));
        }
        return f32::from_bits(sign);
    }
    if (run == 0) || (rise == INFINITY_F32) {
        return rounded_f32(sign, scaled(PI, 0));
    }
    rounded_f32(sign, angle(unpacked_f32(rise), unpacked_f32(run), behind))
}
