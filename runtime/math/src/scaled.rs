//! Positive numbers with a 64-bit significand: the working format of every function.

use crate::fixed::{leading_zeros, mul_high};

/// The number significand / 2^63 * 2^exponent, with the top bit of the significand set.
#[derive(Clone, Copy)]
pub(crate) struct Scaled {
    pub(crate) significand: u64,
    pub(crate) exponent: i32,
}

/// A number with a sign.
#[derive(Clone, Copy)]
pub(crate) struct Signed {
    pub(crate) magnitude: Scaled,
    pub(crate) negative: bool,
}

/// Makes a number of a significand that has its top bit set.
pub(crate) fn scaled(significand: u64, exponent: i32) -> Scaled {
    Scaled { significand, exponent }
}

/// Attaches a sign.
pub(crate) fn signed(magnitude: Scaled, negative: bool) -> Signed {
    Signed { magnitude, negative }
}

/// Makes a number of any significand but 0.
pub(crate) fn normalised(significand: u64, exponent: i32) -> Scaled {
    let shift: i32 = leading_zeros(significand);
    scaled(significand << shift, exponent - shift)
}

/// Makes a number of a significand of at least 2^62.
pub(crate) fn settled(significand: u64, exponent: i32) -> Scaled {
    if (significand >> 63) == 0 {
        return scaled(significand << 1, exponent - 1);
    }
    scaled(significand, exponent)
}

/// a b, relative error below 2^-60.
pub(crate) fn product(a: Scaled, b: Scaled) -> Scaled {
    settled(mul_high(a.significand, b.significand), a.exponent + b.exponent + 1)
}

/// 2^126 / d for d >= 2^63, off by less than 2^-61 of itself.
///
/// A 16-bit quotient, one Newton step to 28 bits, one step of third order.
pub(crate) fn reciprocal(d: u64) -> u64 {
    let d_high: u64 = d >> 32;
    let d_low: u64 = d & 0xFFFF_FFFF;
    let top: u32 = (d >> 48) as u32;
    let guess: u64 = u64::from(0xFFFF_FFFF_u32 / (top + 1));
    let gap: u64 = ((1_u64 << 48) - (d_high + 1) * guess) >> 2;
    let second: u64 = (guess << 15) + ((guess * gap) >> 31);
    let covered: u64 = d_high * second + ((d_low * second) >> 32);
    let rest: u64 = (1_u64 << 63) - covered;
    let brief: u64 = rest >> 3;
    let series: u64 = (rest << 29) + ((brief * brief) >> 28);
    (second << 31) + (mul_high(series, second << 32) >> 29)
}

/// a / b, relative error below 2^-59.
pub(crate) fn quotient(a: Scaled, b: Scaled) -> Scaled {
    let high: u64 = mul_high(a.significand, reciprocal(b.significand));
    normalised(high, a.exponent - b.exponent + 1)
}

/// The significand of b moved to the exponent of a >= b.
pub(crate) fn aligned(a: Scaled, b: Scaled) -> u64 {
    let shift: i32 = a.exponent - b.exponent;
    if shift > 63 {
        return 0;
    }
    b.significand >> shift
}

/// a + b for a >= b, relative error below 2^-61.
pub(crate) fn sum(a: Scaled, b: Scaled) -> Scaled {
    let half: u64 = (a.significand >> 1) + (aligned(a, b) >> 1);
    settled(half, a.exponent + 1)
}

/// a - b for a > b, absolute error below 2^-63 of a.
pub(crate) fn difference(a: Scaled, b: Scaled) -> Scaled {
    normalised(a.significand - aligned(a, b), a.exponent)
}

/// A number below 1 as fixed point with 64 fraction bits.
pub(crate) fn fraction(a: Scaled) -> u64 {
    let shift: i32 = -1 - a.exponent;
    if shift > 63 {
        return 0;
    }
    a.significand >> shift
}

/// The square of a number below 1 as fixed point with 64 fraction bits.
pub(crate) fn squared_fraction(a: Scaled) -> u64 {
    let x: u64 = fraction(a);
    mul_high(x, x)
}

/// x, or within reach of a rounding tie the tie: powers hit ties exactly, their approximation not.
pub(crate) fn tie_restored(x: Scaled, half: u64, reach: u64) -> Scaled {
    let rest: u64 = x.significand & (2 * half - 1);
    let gap: u64 = if rest > half { rest - half } else { half - rest };
    if gap > reach {
        return x;
    }
    scaled(x.significand - rest + half, x.exponent)
}
