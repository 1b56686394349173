//! Square roots: one reciprocal root of 32 bits, refined or checked by the caller.

use crate::fixed::mul_high;
use crate::scaled::{Scaled, settled};

// The first guess of 1/sqrt(v), never too large (30 fraction bits).
const RECIPROCAL_ROOT: [u64; 3] = [0xA6D2_AA9B, 0xCD34_B71A, 0x6658_9918];

/// 1/sqrt(v) for 1/4 <= v < 1 (32 fraction bits in, 30 out), too small by less than 2^-27.
///
/// A quadratic, then y (1 + e/2 + 3 e^2/8) with e = 1 - v y^2 twice, each less
/// a margin of four units that keeps e positive whatever is rounded off.
pub(crate) fn reciprocal_root(v: u64) -> u64 {
    let slope: u64 = RECIPROCAL_ROOT[1] - ((RECIPROCAL_ROOT[2] * v) >> 32);
    let first: u64 = RECIPROCAL_ROOT[0] - ((slope * v) >> 32);
    let first_gap: u64 = (1_u64 << 30) - ((((first * first) >> 30) * v) >> 32);
    let first_step: u64 = (first_gap >> 1) + ((3 * first_gap * first_gap) >> 33);
    let second: u64 = first + ((first * first_step) >> 30) - 4;
    let second_gap: u64 = (1_u64 << 30) - ((((second * second) >> 30) * v) >> 32);
    let second_step: u64 = (second_gap >> 1) + ((3 * second_gap * second_gap) >> 33);
    second + ((second * second_step) >> 30) - 4
}

/// sqrt(v) for 1/4 <= v < 1, both with 64 fraction bits, off by less than 2^-60.
pub(crate) fn root(v: u64) -> u64 {
    let inverse: u64 = reciprocal_root(v >> 32);
    let covered: u64 = mul_high(v, (inverse * inverse) << 2);
    let gap: u64 = (1_u64 << 62) - covered;
    let coarse: u64 = gap >> 5;
    let series: u64 = (gap << 1) + ((3 * coarse * coarse) >> 53);
    let start: u64 = (((v >> 32) * inverse) << 2) + (((v & 0xFFFF_FFFF) * inverse) >> 30);
    start + mul_high(start, series)
}

/// sqrt(a), relative error below 2^-59.
pub(crate) fn square_root(a: Scaled) -> Scaled {
    if (a.exponent & 1) == 0 {
        return settled(root(a.significand >> 1), a.exponent / 2);
    }
    settled(root(a.significand), (a.exponent - 1) / 2)
}
