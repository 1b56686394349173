//! Powers of two: sixteenths from a table, the rest from a polynomial.

use crate::fixed::mul_high;
use crate::scaled::{Scaled, scaled};

// (2^g - 1) / g for 0 <= g < 1/16.
const EXP2: [u64; 7] = [
    0xB172_17F7_D1CF_7AA4,
    0x3D7F_7BFF_0589_9176,
    0x0E35_846B_8325_C9E5,
    0x0276_556D_C0C0_5222,
    0x0057_6207_1187_A944,
    0x000A_17B9_8000_087C,
    0x0001_0573_837C_79AD,
];

// 2^(k/16) with 63 fraction bits.
const EXP2_TABLE: [u64; 16] = [
    0x8000_0000_0000_0000,
    0x85AA_C367_CC48_7B15,
    0x8B95_C1E3_EA8B_D6E7,
    0x91C3_D373_AB11_C336,
    0x9837_F051_8DB8_A96F,
    0x9EF5_3260_91A1_11AE,
    0xA5FE_D6A9_B151_38EA,
    0xAD58_3EEA_42A1_4AC6,
    0xB504_F333_F9DE_6484,
    0xBD08_A39F_580C_36BF,
    0xC567_2A11_5506_DADD,
    0xCE24_8C15_1F84_80E4,
    0xD744_FCCA_D69D_6AF4,
    0xE0CC_DEEC_2A94_E111,
    0xEAC0_C6E7_DD24_392F,
    0xF525_7D15_2486_CC2C,
];

/// 2^f for f < 1 with 64 fraction bits, as a significand, relative error below 2^-60.
pub(crate) fn exp2_fraction(f: u64) -> u64 {
    let slot: u64 = f >> 60;
    let g: u64 = f & 0x0FFF_FFFF_FFFF_FFFF;
    let c5: u64 = EXP2[5] + mul_high(EXP2[6], g);
    let c4: u64 = EXP2[4] + mul_high(c5, g);
    let c3: u64 = EXP2[3] + mul_high(c4, g);
    let c2: u64 = EXP2[2] + mul_high(c3, g);
    let c1: u64 = EXP2[1] + mul_high(c2, g);
    let c0: u64 = EXP2[0] + mul_high(c1, g);
    let base: u64 = EXP2_TABLE[slot as usize];
    base + mul_high(base, mul_high(c0, g))
}

/// 2^p or 2^-p for p = (high, low) / 2^127 * 2^exponent, -64 <= exponent <= 10, high's top bit set.
pub(crate) fn exp2(negative: bool, high: u64, low: u64, exponent: i32) -> Scaled {
    let mut whole: i32 = 0;
    let mut part: u64 = high;
    if exponent >= 0 {
        whole = (high >> (63 - exponent)) as i32;
        part = (high << (exponent + 1)) | (low >> (63 - exponent));
    } else {
        part >>= -1 - exponent;
    }
    if negative {
        whole = if part == 0 { -whole } else { -1 - whole };
        part = 0_u64.wrapping_sub(part);
    }
    scaled(exp2_fraction(part), whole)
}
