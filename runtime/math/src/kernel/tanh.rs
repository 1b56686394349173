//! Hyperbolic tangent of magnitudes below 32.

use crate::constants::LOG2_E;
use crate::fixed::mul_high;
use crate::kernel::exp2::exp2;
use crate::scaled::{Scaled, fraction, normalised, product, quotient, scaled, settled, squared_fraction};

// (1 - tanh(x) / x) / x^2 in powers of -x^2, for x < 1/8.
const TANH: [u64; 6] = [
    0x5555_5555_5555_48FD,
    0x2222_2222_21E6_138E,
    0x0DD0_DD0D_6F8E_83BF,
    0x0599_3CD9_8812_4FEC,
    0x0244_C113_66A2_9CD2,
    0x00E6_54D0_8BAB_B967,
];

/// tanh(x) for 0 < x < 1/8, relative error below 2^-60.
pub(crate) fn small_tanh(x: Scaled) -> Scaled {
    let z: u64 = squared_fraction(x);
    let c4: u64 = TANH[4] - mul_high(TANH[5], z);
    let c3: u64 = TANH[3] - mul_high(c4, z);
    let c2: u64 = TANH[2] - mul_high(c3, z);
    let c1: u64 = TANH[1] - mul_high(c2, z);
    let c0: u64 = TANH[0] - mul_high(c1, z);
    let lost: u64 = mul_high(x.significand, mul_high(c0, z));
    settled(x.significand - lost, x.exponent)
}

/// tanh(x) = (1 - q) / (1 + q) with q = exp(-2 x), for 0 < x < 32, relative error below 2^-58.
pub(crate) fn tanh(x: Scaled) -> Scaled {
    if x.exponent < -3 {
        return small_tanh(x);
    }
    let power: Scaled = product(x, scaled(LOG2_E, 1));
    let q: u64 = fraction(exp2(true, power.significand, 0, power.exponent));
    if q == 0 {
        return scaled(1_u64 << 63, 0);
    }
    let less: Scaled = normalised(0_u64.wrapping_sub(q), -1);
    quotient(less, scaled((1_u64 << 63) + (q >> 1), 0))
}
