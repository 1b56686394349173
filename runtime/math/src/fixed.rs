//! Products of 64-bit integers from 32-bit halves, as a 32-bit core multiplies.

/// A 128-bit unsigned integer.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) high: u64,
    pub(crate) low: u64,
}

/// Makes a 128-bit integer of its halves.
pub(crate) fn pair(high: u64, low: u64) -> Pair {
    Pair { high, low }
}

/// The upper half of the product, at most 2 too small.
pub(crate) fn mul_high(a: u64, b: u64) -> u64 {
    let a_high: u64 = a >> 32;
    let a_low: u64 = a & 0xFFFF_FFFF;
    let b_high: u64 = b >> 32;
    let b_low: u64 = b & 0xFFFF_FFFF;
    let cross: u64 = ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
    a_high * b_high + cross
}

/// The exact 128-bit product.
pub(crate) fn mul_full(a: u64, b: u64) -> Pair {
    let a_high: u64 = a >> 32;
    let a_low: u64 = a & 0xFFFF_FFFF;
    let b_high: u64 = b >> 32;
    let b_low: u64 = b & 0xFFFF_FFFF;
    let lowest: u64 = a_low * b_low;
    let first: u64 = a_high * b_low + (lowest >> 32);
    let second: u64 = a_low * b_high + (first & 0xFFFF_FFFF);
    let high: u64 = a_high * b_high + (first >> 32) + (second >> 32);
    pair(high, (second << 32) | (lowest & 0xFFFF_FFFF))
}

/// The sum of two 128-bit integers; the caller knows that it fits.
pub(crate) fn pair_sum(a: Pair, b: Pair) -> Pair {
    let low: u64 = a.low.wrapping_add(b.low);
    let carry: u64 = if low < a.low { 1 } else { 0 };
    pair(a.high + b.high + carry, low)
}

/// The difference of two 128-bit integers, a >= b.
pub(crate) fn pair_difference(a: Pair, b: Pair) -> Pair {
    let low: u64 = a.low.wrapping_sub(b.low);
    let borrow: u64 = if a.low < b.low { 1 } else { 0 };
    pair(a.high - b.high - borrow, low)
}

/// The upper half of the product of 128 by 64 bits as 128 of 192 bits, at most 3 too small.
pub(crate) fn pair_times(a: Pair, b: u64) -> Pair {
    let below: u64 = mul_high(a.low, b);
    pair_sum(mul_full(a.high, b), pair(0, below))
}

/// The upper 128 of the 256 bits of the product, at most 5 too small.
pub(crate) fn pair_product(a: Pair, b: Pair) -> Pair {
    let cross: u64 = mul_high(a.low, b.high);
    pair_sum(pair_times(b, a.high), pair(0, cross))
}

/// The number of zero bits above the highest one bit; x is not 0.
pub(crate) fn leading_zeros(x: u64) -> i32 {
    x.leading_zeros().cast_signed()
}
