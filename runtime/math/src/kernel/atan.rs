//! Angles: atan(y/x) about the nearest of 0, 1/4, 1/2, 3/4, 1.

use crate::constants::PI;
use crate::fixed::mul_high;
use crate::scaled::{Scaled, difference, normalised, quotient, scaled, settled, squared_fraction, sum};

// (1 - atan(u) / u) / u^2 in powers of -u^2, for u <= 1/8.
const ATAN: [u64; 7] = [
    0x5555_5555_5555_52E7,
    0x3333_3333_3323_AB7E,
    0x2492_4924_70B3_872C,
    0x1C71_C6F9_FE73_C009,
    0x1745_BE89_28FE_DC86,
    0x13AB_824D_5565_141E,
    0x102A_38CE_A40E_F432,
];

// atan(k/4) for k = 1 to 4, as significands.
const ARC_TABLE: [u64; 4] =
    [0xFADB_AFC9_6406_EB15, 0xED63_382B_0DDA_7B45, 0xA4BC_7D19_34F7_0924, 0xC90F_DAA2_2168_C235];

/// atan(u) for 0 < u <= 1/8, relative error below 2^-60.
pub(crate) fn small_arc(u: Scaled) -> Scaled {
    let z: u64 = squared_fraction(u);
    let c5: u64 = ATAN[5] - mul_high(ATAN[6], z);
    let c4: u64 = ATAN[4] - mul_high(c5, z);
    let c3: u64 = ATAN[3] - mul_high(c4, z);
    let c2: u64 = ATAN[2] - mul_high(c3, z);
    let c1: u64 = ATAN[1] - mul_high(c2, z);
    let c0: u64 = ATAN[0] - mul_high(c1, z);
    let lost: u64 = mul_high(u.significand, mul_high(c0, z));
    settled(u.significand - lost, u.exponent)
}

/// x k/4 for k <= 4, rounded down.
pub(crate) fn quarters(x: u64, k: u64) -> u64 {
    (x >> 2) * k + (((x & 3) * k) >> 2)
}

/// atan(k/4) for k = 1 to 4.
pub(crate) fn tabulated_arc(k: u64) -> Scaled {
    let exponent: i32 = if k == 1 {
        -3
    } else if k == 2 {
        -2
    } else {
        -1
    };
    scaled(ARC_TABLE[(k - 1) as usize], exponent)
}

/// The k of the k/4 next to y/x for 0 < y <= x.
pub(crate) fn nearest_quarter(y: Scaled, x: Scaled) -> u64 {
    let gap: i32 = x.exponent - y.exponent;
    if gap > 3 {
        return 0;
    }
    let a: u64 = y.significand >> (1 + gap);
    let eighth: u64 = x.significand >> 4;
    let lower: u64 = if a > eighth { 1 } else { 0 };
    let middle: u64 = if a > 3 * eighth { 2 } else { lower };
    let upper: u64 = if a > 5 * eighth { 3 } else { middle };
    if a > 7 * eighth {
        return 4;
    }
    upper
}

/// atan(y/x) for 0 < y <= x, relative error below 2^-58.
pub(crate) fn arc(y: Scaled, x: Scaled) -> Scaled {
    let k: u64 = nearest_quarter(y, x);
    if k == 0 {
        return small_arc(quotient(y, x));
    }
    let start: Scaled = tabulated_arc(k);
    let rise: u64 = y.significand >> (1 + x.exponent - y.exponent);
    let run: u64 = x.significand >> 1;
    let target: u64 = quarters(run, k);
    let along: Scaled = normalised(run + quarters(rise, k), 0);
    if rise == target {
        return start;
    }
    let ahead: bool = rise > target;
    let across: u64 = if ahead { rise - target } else { target - rise };
    let rest: Scaled = small_arc(quotient(normalised(across, 0), along));
    if ahead {
        return sum(start, rest);
    }
    difference(start, rest)
}

/// The angle of (x, y) for y > 0 and x > 0, or for -x when behind, relative error below 2^-58.
pub(crate) fn angle(y: Scaled, x: Scaled, behind: bool) -> Scaled {
    let level: bool = y.exponent == x.exponent;
    let steep: bool = if level { y.significand > x.significand } else { y.exponent > x.exponent };
    let inner: Scaled = arc(if steep { x } else { y }, if steep { y } else { x });
    if steep && behind {
        return sum(scaled(PI, 0), inner);
    }
    if steep {
        return difference(scaled(PI, 0), inner);
    }
    if behind {
        return difference(scaled(PI, 1), inner);
    }
    inner
}
