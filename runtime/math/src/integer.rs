//! Indices and counts: numbers of 32 bits in a `usize`, with a sign as two's complement.
//!
//! C needs only two of these as functions, since its indices have 32 bits: `index_from_f32` and `index_from_f64`.

/// The nearest `f32` of an index or a count.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "rounding is what it is for")]
pub fn f32_from_index(x: usize) -> f32 {
    x as f32
}

/// The nearest `f64` of an index or a count; exact below 2^53.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "rounding is what it is for")]
pub fn f64_from_index(x: usize) -> f64 {
    x as f64
}

/// The nearest `f32` of a signed count.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "rounding is what it is for")]
pub fn f32_from_signed(x: usize) -> f32 {
    x as i32 as f32
}

/// A signed count, exactly.
#[must_use]
pub fn f64_from_signed(x: usize) -> f64 {
    f64::from(x as i32)
}

/// `x` towards zero as a signed count, -2147483648 to 2147483520, the largest that is an `f32`; 0 for NaN.
#[must_use]
pub fn index_from_f32(x: f32) -> usize {
    index_from_i32(x.clamp(-2_147_483_648.0, 2_147_483_520.0) as i32)
}

/// `x` towards zero as a signed count, -2147483648 to 2147483647; 0 for NaN.
#[must_use]
pub fn index_from_f64(x: f64) -> usize {
    index_from_i32(x as i32)
}

/// The count, its sign extended to 32 bits.
#[must_use]
pub fn index_from_i16(x: i16) -> usize {
    index_from_i32(i32::from(x))
}

/// The count.
#[must_use]
pub fn index_from_u16(x: u16) -> usize {
    usize::from(x)
}

/// The count.
#[must_use]
pub fn index_from_i32(x: i32) -> usize {
    x as u32 as usize
}

/// The count.
#[must_use]
pub fn index_from_u32(x: u32) -> usize {
    x as usize
}

/// The low 16 bits.
#[must_use]
pub fn u16_from_index(x: usize) -> u16 {
    x as u16
}

/// The low 32 bits.
#[must_use]
pub fn u32_from_index(x: usize) -> u32 {
    x as u32
}

/// `a + b` modulo 2^32.
#[must_use]
pub fn wrap_add(a: usize, b: usize) -> usize {
    a.wrapping_add(b) as u32 as usize
}

/// `a - b` modulo 2^16, its sign extended to 32 bits.
#[must_use]
pub fn difference_16(a: usize, b: usize) -> usize {
    index_from_i16(a.wrapping_sub(b) as i16)
}

/// `a - b` modulo 2^32.
#[must_use]
pub fn difference_32(a: usize, b: usize) -> usize {
    a.wrapping_sub(b) as u32 as usize
}
