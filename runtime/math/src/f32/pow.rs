//! Power function.

use crate::constants::LOG2_E;
use crate::f32::format::{INFINITY_F32, MAGNITUDE_F32, NAN_F32, ONE_F32, SIGN_F32, rounded_f32, unpacked_f32};
use crate::kernel::exp2::exp2;
use crate::kernel::log::logarithm;
use crate::scaled::{Scaled, Signed, product, scaled, signed, tie_restored};

/// Whether a positive finite number is an integer: 0 for no, 1 for odd, 2 for even.
pub(crate) fn parity_f32(magnitude: u32) -> u32 {
    let exponent: i32 = ((magnitude >> 23) as i32) - 127;
    if exponent < 0 {
        return 0;
    }
    if exponent > 23 {
        return 2;
    }
    let shift: i32 = 23 - exponent;
    let leading: u32 = 1_u32 << 23;
    let digits: u32 = (magnitude & (leading - 1)) | leading;
    let whole: u32 = digits >> shift;
    if (whole << shift) != digits {
        return 0;
    }
    if (whole & 1) != 0 {
        return 1;
    }
    2
}

/// Infinity or zero, as a power grows or shrinks without bound.
pub(crate) fn limit_f32(sign: u32, grows: bool) -> f32 {
    f32::from_bits(if grows { sign | INFINITY_F32 } else { sign })
}

/// x^y as 2^(y log2(x)) for finite x > 0 but 1 and finite y but 0.
pub(crate) fn general_pow_f32(sign: u32, x: Scaled, y: Signed) -> f32 {
    let wide: Signed = logarithm(x);
    let shrinks: bool = wide.negative != y.negative;
    let power: Scaled = product(product(wide.magnitude, scaled(LOG2_E, 0)), y.magnitude);
    if power.exponent > 10 {
        return limit_f32(sign, !shrinks);
    }
    if power.exponent < -64 {
        return f32::from_bits(sign | ONE_F32);
    }
    let value: Scaled = exp2(shrinks, power.significand, 0, power.exponent);
    rounded_f32(sign, tie_restored(value, 1_u64 << 39, 1_u64 << 14))
}

/// x to the power y, error below 0.500001 ulp.
#[must_use]
pub fn pow_f32(x: f32, y: f32) -> f32 {
    let base_bits: u32 = x.to_bits();
    let power_bits: u32 = y.to_bits();
    let base: u32 = base_bits & MAGNITUDE_F32;
    let power: u32 = power_bits & MAGNITUDE_F32;
    let inverse: bool = power_bits != power;
    if (power == 0) || (base_bits == ONE_F32) {
        return f32::from_bits(ONE_F32);
    }
    if (base > INFINITY_F32) || (power > INFINITY_F32) {
        return f32::from_bits(NAN_F32);
    }
    let kind: u32 = parity_f32(power);
    let sign: u32 = if kind == 1 { base_bits & SIGN_F32 } else { 0 };
    if base == ONE_F32 {
        return f32::from_bits(if kind == 0 { NAN_F32 } else { sign | ONE_F32 });
    }
    if (base == 0) || (base == INFINITY_F32) || (power == INFINITY_F32) {
        return limit_f32(sign, (base < ONE_F32) == inverse);
    }
    if (kind == 0) && (base_bits != base) {
        return f32::from_bits(NAN_F32);
    }
    general_pow_f32(sign, unpacked_f32(base), signed(unpacked_f32(power), inverse))
}
