//! Reduction of any finite angle by 2/pi to as many bits as it needs (Payne and Hanek).

use crate::f64::format::unpacked_f64;
use crate::fixed::{Pair, mul_full, mul_high};
use crate::kernel::reduce::{Turned, turned, turned_from_quarters};
use crate::scaled::signed;

// 2/pi after 64 zero bits.
const TWO_OVER_PI_F64: [u32; 40] = [
    0x0000_0000,
    0x0000_0000,
    0xA2F9_836E,
    0x4E44_1529,
    0xFC27_57D1,
    0xF534_DDC0,
    0xDB62_9599,
    0x3C43_9041,
    0xFE51_63AB,
    0xDEBB_C561,
    0xB724_6E3A,
    0x424D_D2E0,
    0x0649_2EEA,
    0x09D1_921C,
    0xFE1D_EB1C,
    0xB129_A73E,
    0xE882_35F5,
    0x2EBB_4484,
    0xE99C_7026,
    0xB45F_7E41,
    0x3991_D639,
    0x8353_39F4,
    0x9C84_5F8B,
    0xBDF9_283B,
    0x1FF8_97FF,
    0xDE05_980F,
    0xEF2F_118B,
    0x5A0A_6D1F,
    0x6D36_7ECF,
    0x27CB_09B7,
    0x4F46_3F66,
    0x9E5F_EA2D,
    0x7527_BAC7,
    0xEBE5_F17B,
    0x3D07_39F7,
    0x8A52_92EA,
    0x6BFB_5FB1,
    0x1F8D_5D08,
    0x5603_3046,
    0xFC7B_6BAB,
];

/// 32 bits of 2/pi from bit 32 slot + shift on.
pub(crate) fn window_f64(slot: u32, shift: u32) -> u64 {
    let first: u64 = u64::from(TWO_OVER_PI_F64[slot as usize]);
    let second: u64 = u64::from(TWO_OVER_PI_F64[(slot + 1) as usize]);
    (((first << 32) | second) >> (32 - shift)) & 0xFFFF_FFFF
}

/// The angle with these bits, positive and finite, its rest exact to 2^-60 of itself.
pub(crate) fn reduce_f64(magnitude: u64) -> Turned {
    if magnitude <= 0x3FE9_21FB_5444_2D18 {
        return turned(signed(unpacked_f64(magnitude), false), 0);
    }
    let digits: u64 = (magnitude & 0x000F_FFFF_FFFF_FFFF) | (1_u64 << 52);
    let start: u32 = ((magnitude >> 52) as u32) - 1013;
    let slot: u32 = start >> 5;
    let shift: u32 = start & 31;
    let upper: u64 = (window_f64(slot, shift) << 32) | window_f64(slot + 1, shift);
    let middle: u64 = (window_f64(slot + 2, shift) << 32) | window_f64(slot + 3, shift);
    let lower: u64 = (window_f64(slot + 4, shift) << 32) | window_f64(slot + 5, shift);
    let center: Pair = mul_full(middle, digits);
    let low: u64 = center.low.wrapping_add(mul_high(lower, digits));
    let carry: u64 = if low < center.low { 1 } else { 0 };
    let high: u64 = upper.wrapping_mul(digits).wrapping_add(center.high + carry);
    turned_from_quarters(high, low)
}
