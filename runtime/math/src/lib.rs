//! Elementary functions in integer arithmetic, with the same bits everywhere.
//!
//! Every function has a twin in C99, which the generator writes into its C
//! files: the same operations in the same order. All of them are operations on 32- and
//! 64-bit integers; floating-point numbers are only taken apart and put
//! together by their bits. So neither contraction, excess precision, rounding
//! modes, flushing of subnormals nor the absence of a floating-point unit can
//! change a result, and `f32` never touches `f64`.
//!
//! # How
//!
//! A number becomes a 64-bit significand and an exponent. The argument is
//! reduced, a minimax polynomial in fixed point gives the result to about 60
//! bits (`coefficients.py` makes every constant), and one rounding at the end
//! makes it an `f32` or `f64`. Products are built from 32-by-32-bit products, of
//! which one is a single instruction on a Cortex-M3 and up; there is one 32-bit
//! division where a quotient is needed and no 64-bit division. There are no
//! loops; the time depends little on the argument.
//!
//! # Accuracy
//!
//! For `f32` every result that was tried is the nearest `f32`. Tried were, for
//! `sin`, `cos`, `tan`, `log` and `sqrt`, every argument; for `asin`, all of
//! [-1, 1]; for `tanh`, up to magnitude 100; for `acos`, from 1e-9 to 1; for
//! `exp`, from 1e-9 to 105; for `atan`, from 1e-5 to 1e9; and 2 million
//! pseudo-random pairs for each of `atan2` and `pow`. For `f64` the table has the largest
//! error among 400 thousand pseudo-random arguments per function, in units of
//! the last place; 0.5 would be the nearest throughout.
//!
//! | function | `f64`, ulp | range of arguments |
//! |----------|-----------:|--------------------|
//! | `sin`    |     0.5023 | all finite         |
//! | `cos`    |     0.5022 | all finite         |
//! | `tan`    |     0.5060 | all finite         |
//! | `asin`   |     0.5034 | -1 to 1            |
//! | `acos`   |     0.5040 | -1 to 1            |
//! | `atan`   |     0.5012 | all                |
//! | `atan2`  |     0.5039 | all                |
//! | `exp`    |     0.5021 | all                |
//! | `log`    |     0.5056 | positive           |
//! | `sqrt`   |     0.5000 | not negative       |
//! | `tanh`   |     0.5033 | all                |
//! | `pow`    |     0.5101 | all                |
//!
//! `sqrt` is the nearest by construction: its remainder is computed exactly.
//! The range of `sin`, `cos` and `tan` has no bound because the argument is
//! multiplied by as many bits of 2/pi as it needs; their time does not grow.
//! Where the exact power lies halfway between two numbers, `pow` rounds it to
//! even as it should. Subnormal arguments and results are as good as any.
//!
//! # Special values
//!
//! Infinities, zeros and their signs follow Annex F of C99, among them
//! `pow(x, 0) = 1` and `pow(1, y) = 1` even for a NaN, `pow(-1, ±inf) = 1`, and
//! the sixteen cases of `atan2` at zeros and infinities. A result that is not a
//! number always has the bits `0x7FC00000` or `0x7FF8000000000000`. No flags are
//! raised.
#![no_std]
#![forbid(unsafe_code)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "bits move between integers of known range"
)]
#![allow(
    clippy::bool_to_int_with_if,
    clippy::manual_abs_diff,
    clippy::similar_names,
    reason = "the text stays comparable line by line with its C twin"
)]

mod constants;
pub mod cost;
mod f32;
mod f64;
mod fixed;
mod integer;
mod kernel;
mod root;
mod scaled;

pub use crate::cost::COSTS;
pub use crate::f32::arc::{acos_f32, asin_f32, atan_f32, atan2_f32};
pub use crate::f32::exp::exp_f32;
pub use crate::f32::log::log_f32;
pub use crate::f32::pow::pow_f32;
pub use crate::f32::sin_cos_tan::{cos_f32, sin_f32, tan_f32};
pub use crate::f32::sqrt::sqrt_f32;
pub use crate::f32::tanh::tanh_f32;
pub use crate::f64::arc::{acos_f64, asin_f64, atan_f64, atan2_f64};
pub use crate::f64::exp::exp_f64;
pub use crate::f64::log::log_f64;
pub use crate::f64::pow::pow_f64;
pub use crate::f64::sin_cos_tan::{cos_f64, sin_f64, tan_f64};
pub use crate::f64::sqrt::sqrt_f64;
pub use crate::f64::tanh::tanh_f64;
pub use crate::integer::{
    difference_16, difference_32, f32_from_index, f32_from_signed, f64_from_index, f64_from_signed, index_from_f32,
    index_from_f64, index_from_i16, index_from_i32, index_from_u16, index_from_u32, u16_from_index, u32_from_index,
    wrap_add,
};
