//! Reduction of any finite angle by 2/pi to as many bits as it needs (Payne and Hanek).

use crate::f32::format::unpacked_f32;
use crate::kernel::reduce::{Turned, turned, turned_from_quarters};
use crate::scaled::signed;

// 2/pi after 32 zero bits.
const TWO_OVER_PI_F32: [u32; 9] = [
    0x0000_0000,
    0xA2F9_836E,
    0x4E44_1529,
    0xFC27_57D1,
    0xF534_DDC0,
    0xDB62_9599,
    0x3C43_9041,
    0xFE51_63AB,
    0xDEBB_C561,
];

/// 32 bits of 2/pi from bit 32 slot + shift on.
pub(crate) fn window_f32(slot: u32, shift: u32) -> u64 {
    let first: u64 = u64::from(TWO_OVER_PI_F32[slot as usize]);
    let second: u64 = u64::from(TWO_OVER_PI_F32[(slot + 1) as usize]);
    (((first << 32) | second) >> (32 - shift)) & 0xFFFF_FFFF
}

/// The angle with these bits, positive and finite, its rest exact to 2^-38 of itself.
pub(crate) fn reduce_f32(magnitude: u32) -> Turned {
    if magnitude <= 0x3F49_0FDA {
        return turned(signed(unpacked_f32(magnitude), false), 0);
    }
    let digits: u64 = u64::from((magnitude & 0x007F_FFFF) | 0x0080_0000);
    let start: u32 = (magnitude >> 23) - 120;
    let slot: u32 = start >> 5;
    let shift: u32 = start & 31;
    let upper: u64 = (window_f32(slot, shift) * digits) << 32;
    let middle: u64 = window_f32(slot + 1, shift) * digits;
    let lower: u64 = window_f32(slot + 2, shift) * digits;
    turned_from_quarters(upper.wrapping_add(middle).wrapping_add(lower >> 32), lower << 32)
}
