//! The elementary functions in C: one part per function, type or group of constants.
//!
//! Each function is the twin of one in `deadbeat-math`, with the same operations in the same order.
//! Every name of a part starts with `deadbeat_` or `DEADBEAT_`, so another prefix can be put in by
//! replacing text. What a part requires is read from its text. A function with everything that it
//! requires, in the order of [`PARTS`] behind `#include <stdint.h>`, compiles, and no function of it
//! is unused.

#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// A piece of C99.
#[derive(Debug)]
pub struct Part {
    /// Its name; a function or a type is called so, behind the prefix.
    pub name: &'static str,
    /// Its text, without any `#include`.
    pub text: &'static str,
}

/// Parts by name; the file of each stands in the folder beside this file.
macro_rules! parts {
    ($($name:ident)*) => {
        &[$(Part { name: stringify!($name), text: include_str!(concat!("math/", stringify!($name), ".c")) }),*]
    };
}

/// All parts, each behind those that it requires: the order in which they are written.
#[rustfmt::skip]
pub const PARTS: &[Part] = parts! {
    index_from_f32 index_from_f64 f32_cell_t f32_to_bits sign_bit_f32 magnitude_f32 infinity_f32 nan_f32 one_f32
    f32_from_bits scaled_t signed_t turned_t signed fraction mul_high squared_fraction scaled settled cosine sine
    sine_at turned leading_zeros normalised unpacked_f32 window_f32 product pi_constant turned_from_quarters
    reduce_f32 rounded_f32 sign_f32 sin_f32 cosine_at cos_f32 reciprocal quotient tan_f32 nearest_quarter small_arc
    tabulated_arc quarters aligned sum difference arc angle reciprocal_root root square_root other_leg asin_f32
    acos_f32 atan_f32 atan2_f32 log2_e_constant log2_e_low_constant exp2_fraction exp2 exp_f32 times_log_two
    twice_atanh logarithm log_f32 sqrt_f32 small_tanh tanh tanh_f32 parity_f32 limit_f32 tie_restored general_pow_f32
    pow_f32 f64_cell_t f64_to_bits sign_bit_f64 magnitude_f64 infinity_f64 nan_f64 one_f64 f64_from_bits unpacked_f64
    window_f64 pair_t pair mul_full reduce_f64 rounded_f64 sign_f64 sin_f64 cos_f64 tan_f64 asin_f64 acos_f64 atan_f64
    atan2_f64 pair_sum pair_times exp_f64 log_f64 sqrt_f64 tanh_f64 parity_f64 limit_f64 pair_difference pair_product
    log2_near_one log2_wide general_pow_f64 pow_f64
};

/// Where each name is defined.
static DEFINED: LazyLock<BTreeMap<&str, &Part>> =
    LazyLock::new(|| PARTS.iter().flat_map(|part| part.defined().map(move |name| (name, part))).collect());

impl Part {
    /// The names that it defines: of its own name a function or type, and its constants and tables.
    fn defined(&self) -> impl Iterator<Item = &'static str> {
        let own = names(self.text).find(|name| name.strip_prefix("deadbeat_") == Some(self.name));
        let is_constant = |line: &&str| line.starts_with("#define ") || line.starts_with("static const ");
        own.into_iter().chain(self.text.lines().filter(is_constant).filter_map(|line| names(line).next()))
    }

    /// The parts that define the names in its text, itself aside.
    fn requires(&self) -> impl Iterator<Item = &'static Part> {
        names(self.text).filter_map(|name| DEFINED.get(name).copied()).filter(|part| part.name != self.name)
    }
}

/// The parts of some functions and of everything that they require, in the order in which they are written.
pub fn closure(functions: BTreeSet<String>) -> impl Iterator<Item = &'static Part> {
    let mut wanted = functions;
    // A part stands behind those that it requires: one pass from the end finds them all.
    for part in PARTS.iter().rev() {
        if wanted.contains(part.name) {
            wanted.extend(part.requires().map(|it| it.name.to_owned()));
        }
    }
    PARTS.iter().filter(move |part| wanted.contains(part.name))
}

/// Whether a part has a constant or table of this name, without the prefix.
pub fn is_taken(name: &str) -> bool {
    DEFINED.contains_key(&*format!("DEADBEAT_{name}"))
}

/// The names with the prefix that stand in a text, as often as they do.
fn names(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    words.filter(|word| word.starts_with("deadbeat_") || word.starts_with("DEADBEAT_"))
}
