//! Quarter turns: what remains of an angle after the nearest multiple of pi/2.

use crate::constants::PI;
use crate::fixed::leading_zeros;
use crate::kernel::sin_cos::{cosine, sine};
use crate::scaled::{Signed, product, scaled, signed};

/// The angle quadrant * pi/2 + rest.
#[derive(Clone, Copy)]
pub(crate) struct Turned {
    pub(crate) rest: Signed,
    pub(crate) quadrant: u32,
}

/// Makes an angle of its parts.
pub(crate) fn turned(rest: Signed, quadrant: u32) -> Turned {
    Turned { rest, quadrant }
}

/// The angle of (high, low) / 2^126 quarter turns, its rest exact to 2^-60 of itself.
pub(crate) fn turned_from_quarters(high: u64, low: u64) -> Turned {
    let eighths: u64 = high >> 61;
    let negative: bool = (eighths & 1) != 0;
    let mut upper: u64 = (high << 2) | (low >> 62);
    let mut lower: u64 = low << 2;
    if negative {
        upper = if lower == 0 { 0_u64.wrapping_sub(upper) } else { u64::MAX - upper };
        lower = 0_u64.wrapping_sub(lower);
    }
    let shift: i32 = leading_zeros(upper | 1);
    let significand: u64 = (upper << shift) | ((lower >> 1) >> (63 - shift));
    let rest: Signed = signed(product(scaled(significand, -1 - shift), scaled(PI, 0)), negative);
    turned(rest, (((eighths + 1) >> 1) & 3) as u32)
}

/// The sine of an angle.
pub(crate) fn sine_at(angle: Turned) -> Signed {
    let back: bool = (angle.quadrant & 2) != 0;
    if (angle.quadrant & 1) != 0 {
        return signed(cosine(angle.rest.magnitude), back);
    }
    signed(sine(angle.rest.magnitude), back != angle.rest.negative)
}

/// The cosine of an angle: the sine a quarter turn later.
pub(crate) fn cosine_at(angle: Turned) -> Signed {
    sine_at(turned(angle.rest, angle.quadrant + 1))
}
