//! Natural logarithm by log(m) = 2 atanh((m - 1) / (m + 1)).

use crate::fixed::mul_high;
use crate::scaled::{
    Scaled, Signed, difference, normalised, product, quotient, scaled, settled, signed, squared_fraction, sum,
};

// (atanh(s) / s - 1) / s^2 in powers of s^2, for s <= 3 - 2 sqrt(2).
const ATANH: [u64; 8] = [
    0x5555_5555_5555_5349,
    0x3333_3333_333B_FC1D,
    0x2492_4924_856A_542F,
    0x1C71_C725_8E95_08F9,
    0x1745_CDE3_BF82_DE5E,
    0x13B2_0AA7_A183_4D9A,
    0x10F5_CE17_AF18_0A75,
    0x10F6_2331_2CBC_BEA0,
];

// sqrt(2) with 63 fraction bits.
const ROOT_TWO: u64 = 0xB504_F333_F9DE_6484;

// log(2) with 64 fraction bits.
const LN_2: u64 = 0xB172_17F7_D1CF_79AC;

/// 2 atanh(s) for 0 < s <= 3 - 2 sqrt(2), relative error below 2^-60.
pub(crate) fn twice_atanh(s: Scaled) -> Scaled {
    let z: u64 = squared_fraction(s);
    let c6: u64 = ATANH[6] + mul_high(ATANH[7], z);
    let c5: u64 = ATANH[5] + mul_high(c6, z);
    let c4: u64 = ATANH[4] + mul_high(c5, z);
    let c3: u64 = ATANH[3] + mul_high(c4, z);
    let c2: u64 = ATANH[2] + mul_high(c3, z);
    let c1: u64 = ATANH[1] + mul_high(c2, z);
    let c0: u64 = ATANH[0] + mul_high(c1, z);
    let gained: u64 = mul_high(s.significand, mul_high(c0, z));
    let half: u64 = (s.significand >> 1) + (gained >> 1);
    settled(half, s.exponent + 2)
}

/// |k| log(2) for k but 0, relative error below 2^-60.
pub(crate) fn times_log_two(k: i32) -> Scaled {
    let steps: i32 = if k < 0 { -k } else { k };
    product(normalised(steps as u64, 63), scaled(LN_2, -1))
}

/// log(x) for x > 0 of at most 62 significant bits and not 1, relative error below 2^-58.
pub(crate) fn logarithm(x: Scaled) -> Signed {
    let below_one: bool = x.significand > ROOT_TWO;
    let power: i32 = if below_one { x.exponent + 1 } else { x.exponent };
    let half: u64 = x.significand >> 1;
    let over: u64 = (x.significand - (1_u64 << 63)) << 1;
    let distance: u64 = if below_one { 0_u64.wrapping_sub(x.significand) } else { over };
    let total: u64 = if below_one { (1_u64 << 63) + half } else { (1_u64 << 63) + (over >> 2) };
    let denominator: Scaled = scaled(total, if below_one { 0 } else { 1 });
    if distance == 0 {
        return signed(times_log_two(power), power < 0);
    }
    let fine: Scaled = twice_atanh(quotient(normalised(distance, -1), denominator));
    if power == 0 {
        return signed(fine, below_one);
    }
    if below_one == (power < 0) {
        return signed(sum(times_log_two(power), fine), power < 0);
    }
    signed(difference(times_log_two(power), fine), power < 0)
}
