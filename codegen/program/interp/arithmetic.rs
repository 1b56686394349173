//! The meaning of each operation, once: for the interpreter and for the folding of constants.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::super::Function;

/// A float type that a Program computes in.
pub(in super::super) trait Number:
    Copy
    + Default
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// Rounded to nearest even.
    fn from_f64(x: f64) -> Self;
    /// Exact.
    fn to_f64(self) -> f64;
    /// Rounded to nearest even.
    fn from_index(x: u32) -> Self;
    /// [`Op::SignedToFloat`](super::super::Op::SignedToFloat).
    fn from_signed(x: u32) -> Self;
    /// [`Op::FromFloat`](super::super::Op::FromFloat).
    fn to_signed(self) -> u32;
    /// The runtime's elementary function; one of a single argument ignores `b`.
    fn call(function: Function, a: Self, b: Self) -> Self;
}

/// Both implementations differ in the names of types and functions only.
macro_rules! number {
    ($type:ident, $largest:literal, $sin:ident, $cos:ident, $tan:ident, $asin:ident, $acos:ident,
     $atan:ident, $atan2:ident, $exp:ident, $log:ident, $sqrt:ident, $tanh:ident, $pow:ident) => {
        impl Number for $type {
            #[allow(clippy::cast_possible_truncation, reason = "the rounding is meant; f64 to f64 has none")]
            fn from_f64(x: f64) -> Self {
                x as Self
            }

            #[allow(clippy::cast_lossless, reason = "f64 to f64 is no conversion")]
            fn to_f64(self) -> f64 {
                self as f64
            }

            #[allow(clippy::cast_precision_loss, clippy::cast_lossless, reason = "f32 rounds, f64 is exact")]
            fn from_index(x: u32) -> Self {
                x as Self
            }

            #[allow(clippy::cast_precision_loss, clippy::cast_lossless, reason = "f32 rounds, f64 is exact")]
            fn from_signed(x: u32) -> Self {
                x.cast_signed() as Self
            }

            #[expect(clippy::cast_possible_truncation, reason = "it is cut off; NaN becomes 0")]
            fn to_signed(self) -> u32 {
                (self.clamp(-2_147_483_648.0, $largest) as i32).cast_unsigned()
            }

            fn call(function: Function, a: Self, b: Self) -> Self {
                match function {
                    Function::Sin => deadbeat_math::$sin(a),
                    Function::Cos => deadbeat_math::$cos(a),
                    Function::Tan => deadbeat_math::$tan(a),
                    Function::Asin => deadbeat_math::$asin(a),
                    Function::Acos => deadbeat_math::$acos(a),
                    Function::Atan => deadbeat_math::$atan(a),
                    Function::Atan2 => deadbeat_math::$atan2(a, b),
                    Function::Exp => deadbeat_math::$exp(a),
                    Function::Log => deadbeat_math::$log(a),
                    Function::Sqrt => deadbeat_math::$sqrt(a),
                    Function::Tanh => deadbeat_math::$tanh(a),
                    Function::Pow => deadbeat_math::$pow(a, b),
                }
            }
        }
    };
}

number!(
    f32,
    2_147_483_520.0,
    sin_f32,
    cos_f32,
    tan_f32,
    asin_f32,
    acos_f32,
    atan_f32,
    atan2_f32,
    exp_f32,
    log_f32,
    sqrt_f32,
    tanh_f32,
    pow_f32
);
number!(
    f64,
    2_147_483_647.0,
    sin_f64,
    cos_f64,
    tan_f64,
    asin_f64,
    acos_f64,
    atan_f64,
    atan2_f64,
    exp_f64,
    log_f64,
    sqrt_f64,
    tanh_f64,
    pow_f64
);

/// [`Op::Advance`](super::super::Op::Advance).
pub(in super::super) const fn advance(slot: u32, len: u32) -> u32 {
    if slot < len - 1 { slot + 1 } else { 0 }
}

/// [`Op::Retreat`](super::super::Op::Retreat).
pub(in super::super) const fn retreat(slot: u32, len: u32) -> u32 {
    if slot >= 1 && slot < len { slot - 1 } else { len - 1 }
}

/// [`Op::CountUp`](super::super::Op::CountUp).
pub(in super::super) const fn count_up(count: u32, max: u32) -> u32 {
    if count < max { count + 1 } else { max }
}

/// [`Op::CountDown`](super::super::Op::CountDown).
pub(in super::super) const fn count_down(count: u32) -> u32 {
    count.saturating_sub(1)
}

/// [`Op::AtMost`](super::super::Op::AtMost).
pub(in super::super) const fn at_most(value: u32, max: u32) -> u32 {
    if value < max { value } else { max }
}

/// [`Op::Remainder`](super::super::Op::Remainder).
pub(in super::super) const fn remainder(value: u32, modulus: u32) -> u32 {
    value % modulus
}

/// [`Op::Difference`](super::super::Op::Difference).
pub(in super::super) const fn difference(a: u32, b: u32, bits: u32) -> u32 {
    let above = 32 - bits;
    (a.wrapping_sub(b) << above).cast_signed().wrapping_shr(above).cast_unsigned()
}

/// What a counter of that kind shows for a number: cut off towards zero, at most its largest and at least its smallest
/// number; 0 for NaN. Extended to 32 bits.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "conversions that saturate")]
pub(super) const fn counted(x: f64, bits: u8, signed: bool) -> u32 {
    match (bits, signed) {
        (16, true) => (x as i16 as i32).cast_unsigned(),
        (16, false) => x as u16 as u32,
        (_, true) => (x as i32).cast_unsigned(),
        (_, false) => x as u32,
    }
}
