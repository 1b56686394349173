//! Power function.

use crate::f64::format::{INFINITY_F64, MAGNITUDE_F64, NAN_F64, ONE_F64, SIGN_F64, rounded_f64, unpacked_f64};
use crate::fixed::{Pair, leading_zeros, pair_times};
use crate::kernel::exp2::exp2;
use crate::kernel::log2_wide::log2_wide;
use crate::scaled::{Scaled, Signed, signed, tie_restored};

/// Whether a positive finite number is an integer: 0 for no, 1 for odd, 2 for even.
pub(crate) fn parity_f64(magnitude: u64) -> u32 {
    let exponent: i32 = ((magnitude >> 52) as i32) - 1023;
    if exponent < 0 {
        return 0;
    }
    if exponent > 52 {
        return 2;
    }
    let shift: i32 = 52 - exponent;
    let leading: u64 = 1_u64 << 52;
    let digits: u64 = (magnitude & (leading - 1)) | leading;
    let whole: u64 = digits >> shift;
    if (whole << shift) != digits {
        return 0;
    }
    if (whole & 1) != 0 {
        return 1;
    }
    2
}

/// Infinity or zero, as a power grows or shrinks without bound.
pub(crate) fn limit_f64(sign: u64, grows: bool) -> f64 {
    f64::from_bits(if grows { sign | INFINITY_F64 } else { sign })
}

/// x^y as 2^(y log2(x)) for finite x > 0 but 1 and finite y but 0.
pub(crate) fn general_pow_f64(sign: u64, x: Scaled, y: Signed) -> f64 {
    let shrinks: bool = (x.exponent < 0) != y.negative;
    let close: bool = (x.exponent == 0) || (x.exponent == -1);
    let wide: Pair = pair_times(log2_wide(x), y.magnitude.significand);
    let shift: i32 = leading_zeros(wide.high);
    let exponent: i32 = y.magnitude.exponent - shift + (if close { 2 } else { 12 });
    if exponent > 10 {
        return limit_f64(sign, !shrinks);
    }
    if exponent < -64 {
        return f64::from_bits(sign | ONE_F64);
    }
    let high: u64 = (wide.high << shift) | ((wide.low >> 1) >> (63 - shift));
    let power: Scaled = exp2(shrinks, high, wide.low << shift, exponent);
    rounded_f64(sign, tie_restored(power, 1_u64 << 10, 1_u64 << 4))
}

/// x to the power y, error below 0.52 ulp.
#[must_use]
pub fn pow_f64(x: f64, y: f64) -> f64 {
    let base_bits: u64 = x.to_bits();
    let power_bits: u64 = y.to_bits();
    let base: u64 = base_bits & MAGNITUDE_F64;
    let power: u64 = power_bits & MAGNITUDE_F64;
    let inverse: bool = power_bits != power;
    if (power == 0) || (base_bits == ONE_F64) {
        return f64::from_bits(ONE_F64);
    }
    if (base > INFINITY_F64) || (power > INFINITY_F64) {
        return f64::from_bits(NAN_F64);
    }
    let kind: u32 = parity_f64(power);
    let sign: u64 = if kind == 1 { base_bits & SIGN_F64 } else { 0 };
    if base == ONE_F64 {
        return f64::from_bits(if kind == 0 { NAN_F64 } else { sign | ONE_F64 });
    }
    if (base == 0) || (base == INFINITY_F64) || (power == INFINITY_F64) {
        return limit_f64(sign, (base < ONE_F64) == inverse);
    }
    if (kind == 0) && (base_bits != base) {
        return f64::from_bits(NAN_F64);
    }
    general_pow_f64(sign, unpacked_f64(base), signed(unpacked_f64(power), inverse))
}
