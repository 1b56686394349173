//! Sine and cosine on [-pi/4, pi/4], as alternating series in the square.

use crate::fixed::mul_high;
use crate::scaled::{Scaled, settled, squared_fraction};

// (1 - sin(r) / r) / r^2 in powers of -r^2.
const SINE: [u64; 7] = [
    0x2AAA_AAAA_AAAA_AAA6,
    0x0222_2222_2222_2160,
    0x000D_00D0_0D00_C575,
    0x0000_2E3B_C74A_673D,
    0x0000_006B_9914_A637,
    0x0000_0000_B090_498C,
    0x0000_0000_00D5_52BC,
];

// (1 - cos(r)) / r^2 in powers of -r^2.
const COSINE: [u64; 8] = [
    0x8000_0000_0000_0000,
    0x0AAA_AAAA_AAAA_AAA8,
    0x005B_05B0_5B05_B02B,
    0x0001_A01A_01A0_1865,
    0x0000_049F_93ED_D666,
    0x0000_0008_F76C_6243,
    0x0000_0000_0C9C_9706,
    0x0000_0000_000D_551B,
];

/// sin(r) for 0 < r <= pi/4, relative error below 2^-60.
pub(crate) fn sine(r: Scaled) -> Scaled {
    let z: u64 = squared_fraction(r);
    let z_high: u64 = z >> 32;
    let tail: u64 = SINE[5] - ((SINE[6] * z_high) >> 32);
    let c4: u64 = SINE[4] - ((tail * z_high) >> 32);
    let c3: u64 = SINE[3] - mul_high(c4, z);
    let c2: u64 = SINE[2] - mul_high(c3, z);
    let c1: u64 = SINE[1] - mul_high(c2, z);
    let c0: u64 = SINE[0] - mul_high(c1, z);
    let lost: u64 = mul_high(r.significand, mul_high(c0, z));
    settled(r.significand - lost, r.exponent)
}

/// cos(r) for 0 < r <= pi/4, relative error below 2^-60.
pub(crate) fn cosine(r: Scaled) -> Scaled {
    let z: u64 = squared_fraction(r);
    let z_high: u64 = z >> 32;
    let tail: u64 = COSINE[6] - ((COSINE[7] * z_high) >> 32);
    let c5: u64 = COSINE[5] - ((tail * z_high) >> 32);
    let c4: u64 = COSINE[4] - mul_high(c5, z);
    let c3: u64 = COSINE[3] - mul_high(c4, z);
    let c2: u64 = COSINE[2] - mul_high(c3, z);
    let c1: u64 = COSINE[1] - mul_high(c2, z);
    let c0: u64 = COSINE[0] - mul_high(c1, z);
    settled((1_u64 << 63) - (mul_high(c0, z) >> 1), 0)
}
