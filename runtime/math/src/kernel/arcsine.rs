//! The cosine that belongs to a sine.

use crate::fixed::mul_high;
use crate::root::square_root;
use crate::scaled::{Scaled, fraction, normalised, scaled};

/// sqrt(1 - x^2) for 0 < x < 1 of at most 53 significant bits, relative error below 2^-59.
pub(crate) fn other_leg(x: Scaled) -> Scaled {
    let part: u64 = fraction(x);
    if part == 0 {
        return scaled(1_u64 << 63, 0);
    }
    let less: Scaled = normalised(0_u64.wrapping_sub(part), -1);
    let more: u64 = (1_u64 << 63) + (part >> 1);
    let square: u64 = mul_high(less.significand, more);
    square_root(normalised(square, less.exponent + 1))
}
