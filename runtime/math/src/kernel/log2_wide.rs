//! Binary logarithm to 70 bits, for the power function.
//!
//! m c = 1 + r with a tabulated c of 9 bits leaves an exact r; the series of
//! log(1 + r), split into odd and even powers, needs more than 64 bits only in
//! its first two terms.

use crate::constants::{LOG2_E, LOG2_E_LOW};
use crate::fixed::{Pair, mul_high, pair, pair_difference, pair_product, pair_sum, pair_times};
use crate::scaled::Scaled;

// Nearly 256 / m for m in [1 + k/32, 1 + (k+1)/32), exact at both ends.
const RECIPROCAL: [u32; 32] = [
    0x0100, 0x00F5, 0x00ED, 0x00E7, 0x00E0, 0x00DA, 0x00D5, 0x00CF, 0x00CA, 0x00C5, 0x00C1, 0x00BC, 0x00B8, 0x00B4,
    0x00B0, 0x00AC, 0x00A9, 0x00A5, 0x00A2, 0x009F, 0x009C, 0x0099, 0x0096, 0x0094, 0x0091, 0x008E, 0x008C, 0x008A,
    0x0087, 0x0085, 0x0083, 0x0080,
];

// log2(256 / RECIPROCAL) with 126 fraction bits, upper and lower half.
const LOG2_HIGH: [u64; 32] = [
    0x0000_0000_0000_0000,
    0x040E_1FBE_F2A1_A768,
    0x071E_D4A2_DC3C_713E,
    0x097C_F196_ADFE_E84D,
    0x0C54_4C05_5FDE_9933,
    0x0ED6_1169_F220_E97F,
    0x10FA_8480_44B3_5108,
    0x139D_E8E1_559F_6F7F,
    0x15DF_DCF1_EEAE_0E44,
    0x1830_4D90_C11F_D32A,
    0x1A15_2F14_2981_B3D7,
    0x1C81_9DC2_D45F_E438,
    0x1E7D_F5FE_538A_B34E,
    0x2085_7A97_34F9_3131,
    0x2298_AC1F_CD15_F101,
    0x24B8_1408_C77D_5F5B,
    0x2657_FDC6_E1DC_D0CB,
    0x288E_2D45_8104_C41B,
    0x2A3F_E5C6_0429_7860,
    0x2BF9_B9C4_E4FB_B68A,
    0x2DBB_F854_F1F8_C67D,
    0x2F86_F524_4FCF_F690,
    0x315B_08D9_E6D3_481B,
    0x3298_50E9_2589_B608,
    0x347C_5E95_887E_C06B,
    0x366A_8B0E_C3A8_F2F0,
    0x37B9_D3B9_92C3_0E34,
    0x390D_EF6F_D495_1167,
    0x3B15_7408_B603_8F49,
    0x3C76_40A8_DEAA_9421,
    0x3DDC_65C5_5D99_7DA2,
    0x4000_0000_0000_0000,
];
const LOG2_LOW: [u64; 32] = [
    0x0000_0000_0000_0000,
    0x216F_872E_A85D_508F,
    0x86C9_CEE7_766E_CE70,
    0x0E8C_E104_240E_74CA,
    0x354D_BF16_FB06_95EE,
    0x22BA_704D_CAA7_6F41,
    0x6F03_DB42_AAB7_4164,
    0x2B4B_D1C4_37FE_666D,
    0x2D6D_90E9_BB2D_C3AE,
    0x3AB0_A4B5_5A72_5949,
    0xB0E6_5D2C_D9DC_E8B3,
    0x95D8_AC46_64F2_3FC7,
    0xFB51_5AC9_3B44_3D55,
    0xE6CE_7FFB_AF0A_4DCA,
    0xC141_E66F_AAAA_CA50,
    0xEB91_0702_75D8_7152,
    0x4492_F1BC_6B3E_5770,
    0x9013_2AED_DB58_038F,
    0x5FF4_EDF5_F974_522E,
    0x4D0C_BBDA_DCCA_DA10,
    0xBA46_B45B_B3FC_4044,
    0xFCE5_9662_ABA4_5266,
    0x85A5_4D7E_E2FD_5DF2,
    0x0F70_9A1F_F3E4_E5A5,
    0x1FF1_8294_40C2_4AEB,
    0x5706_9FC5_2C5A_2CD9,
    0xEC21_C817_AD56_BAA1,
    0x134E_9646_B9A1_51E1,
    0xFECB_BB79_2D67_6256,
    0x60E0_F2C3_388E_FAF5,
    0x4FD7_5F60_AD97_15A1,
    0x0000_0000_0000_0000,
];

// (atanh(r) / r - 1) / r^2 in powers of r^2 = z.
const LOG_ODD: [u64; 5] =
    [0x5555_5555_5555_5575, 0x3333_3333_332C_4BC5, 0x2492_4925_115F_8948, 0x1C71_C31F_99AE_7B0B, 0x1754_5ACC_E6BC_6FFA];

// -(log(1 - z) / z + 1) / (2 z) in powers of r^2 = z.
const LOG_EVEN: [u64; 5] =
    [0x4000_0000_0000_0032, 0x2AAA_AAAA_AAA1_9655, 0x2000_0000_92AB_BD95, 0x1999_9568_0207_42C3, 0x1563_96E4_4728_F68A];

/// |log2(1 + r)| with 126 fraction bits; r has 59 fraction bits beyond 1/32.
pub(crate) fn log2_near_one(r: u64, negative: bool) -> Pair {
    let z: u64 = mul_high(r, r);
    let narrow: u64 = z >> 10;
    let o3: u64 = LOG_ODD[3] + mul_high(LOG_ODD[4], narrow);
    let o2: u64 = LOG_ODD[2] + mul_high(o3, narrow);
    let o1: u64 = LOG_ODD[1] + mul_high(o2, narrow);
    let o0: u64 = LOG_ODD[0] + mul_high(o1, narrow);
    let e3: u64 = LOG_EVEN[3] + mul_high(LOG_EVEN[4], narrow);
    let e2: u64 = LOG_EVEN[2] + mul_high(e3, narrow);
    let e1: u64 = LOG_EVEN[1] + mul_high(e2, narrow);
    let e0: u64 = LOG_EVEN[0] + mul_high(e1, narrow);
    let odd: u64 = mul_high(z, o0);
    let even: u64 = mul_high(mul_high(r, z), e0);
    let plus: Pair = pair((1_u64 << 63) + (odd >> 11), odd << 53);
    let linear: Pair = pair(r >> 7, r << 57);
    let minus: Pair = pair_sum(linear, pair(even >> 16, even << 48));
    let factor: Pair = if negative { pair_sum(plus, minus) } else { pair_difference(plus, minus) };
    let value: Pair = pair_times(pair_product(factor, pair(LOG2_E, LOG2_E_LOW)), r);
    pair(value.high >> 5, (value.high << 59) | (value.low >> 5))
}

/// |log2(x)| for x of 53 significant bits and not 1, relative error below 2^-70.
///
/// 126 fraction bits for 1/2 <= x < 2, else 116; negative for x < 1.
pub(crate) fn log2_wide(x: Scaled) -> Pair {
    let slot: u64 = (x.significand >> 58) & 31;
    let scale: u64 = u64::from(RECIPROCAL[slot as usize]);
    let around: u64 = (x.significand >> 11) * scale;
    let negative: bool = around < (1_u64 << 60);
    let r: u64 = if negative { (1_u64 << 60) - around } else { around - (1_u64 << 60) };
    let fine: Pair = log2_near_one(r << 9, negative);
    let table: Pair = pair(LOG2_HIGH[slot as usize], LOG2_LOW[slot as usize]);
    let value: Pair = if negative { pair_difference(table, fine) } else { pair_sum(table, fine) };
    if x.exponent == 0 {
        return value;
    }
    if x.exponent == -1 {
        return pair_difference(pair(1_u64 << 62, 0), value);
    }
    let part: Pair = pair(value.high >> 10, (value.high << 54) | (value.low >> 10));
    if x.exponent > 0 {
        let whole: u64 = x.exponent as u64;
        return pair_sum(pair(whole << 52, 0), part);
    }
    let whole: u64 = (-x.exponent) as u64;
    pair_difference(pair(whole << 52, 0), part)
}
