//! Inverse sine, cosine and tangent.

use crate::constants::PI;
use crate::f64::format::{INFINITY_F64, MAGNITUDE_F64, NAN_F64, ONE_F64, SIGN_F64, rounded_f64, unpacked_f64};
use crate::kernel::arcsine::other_leg;
use crate::kernel::atan::angle;
use crate::scaled::{Scaled, scaled, sum};

/// Inverse sine, error below 0.51 ulp.
#[must_use]
pub fn asin_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    let sign: u64 = bits & SIGN_F64;
    if magnitude > ONE_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return x;
    }
    if magnitude == ONE_F64 {
        return rounded_f64(sign, scaled(PI, 0));
    }
    let opposite: Scaled = unpacked_f64(magnitude);
    rounded_f64(sign, angle(opposite, other_leg(opposite), false))
}

/// Inverse cosine, error below 0.51 ulp.
#[must_use]
pub fn acos_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    if magnitude > ONE_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return rounded_f64(0, scaled(PI, 0));
    }
    if bits == ONE_F64 {
        return f64::from_bits(0);
    }
    if magnitude == ONE_F64 {
        return rounded_f64(0, scaled(PI, 1));
    }
    let adjacent: Scaled = unpacked_f64(magnitude);
    rounded_f64(0, angle(other_leg(adjacent), adjacent, bits != magnitude))
}

/// Inverse tangent, error below 0.51 ulp.
#[must_use]
pub fn atan_f64(x: f64) -> f64 {
    let bits: u64 = x.to_bits();
    let magnitude: u64 = bits & MAGNITUDE_F64;
    let sign: u64 = bits & SIGN_F64;
    if magnitude > INFINITY_F64 {
        return f64::from_bits(NAN_F64);
    }
    if magnitude == 0 {
        return x;
    }
    if magnitude == INFINITY_F64 {
        return rounded_f64(sign, scaled(PI, 0));
    }
    rounded_f64(sign, angle(unpacked_f64(magnitude), scaled(1_u64 << 63, 0), false))
}

/// Angle of the point (x, y), from -pi to pi, error below 0.51 ulp.
#[must_use]
pub fn atan2_f64(y: f64, x: f64) -> f64 {
    let sign: u64 = y.to_bits() & SIGN_F64;
    let rise: u64 = y.to_bits() & MAGNITUDE_F64;
    let run: u64 = x.to_bits() & MAGNITUDE_F64;
    let behind: bool = x.to_bits() != run;
    if (rise > INFINITY_F64) || (run > INFINITY_F64) {
        return f64::from_bits(NAN_F64);
    }
    if (rise == INFINITY_F64) && (run == INFINITY_F64) {
        let quarter: Scaled = scaled(PI, -1);
        return rounded_f64(sign, if behind { sum(scaled(PI, 0), quarter) } else { quarter });
    }
    if (rise == 0) || (run == INFINITY_F64) {
        if behind {
            return rounded_f64(sign, scaled(PI, 1));
        }
        return f64::from_bits(sign);
    }
    if (run == 0) || (rise == INFINITY_F64) {
        return rounded_f64(sign, scaled(PI, 0));
    }
    rounded_f64(sign, angle(unpacked_f64(rise), unpacked_f64(run), behind))
}
