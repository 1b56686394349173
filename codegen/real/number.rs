//! The scalar: an integer mantissa, a binary exponent and a precision.

use std::cmp::Ordering;

use dashu_base::{BitTest, Sign, Signed};
use dashu_int::{IBig, UBig};

/// A working precision, in bits of mantissa.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Precision {
    bits: usize,
}

impl Precision {
    /// The smallest and the largest precision; requests outside are moved to the nearer end.
    const RANGE: (usize, usize) = (8, 1 << 24);

    /// A precision of `bits` mantissa bits (at least 8, at most 2^24).
    #[must_use]
    pub fn bits(bits: usize) -> Self {
        Self { bits: bits.clamp(Self::RANGE.0, Self::RANGE.1) }
    }

    /// The precision carrying `digits` decimal digits, rounded up to whole bits.
    #[must_use]
    pub fn digits(digits: usize) -> Self {
        // log2(10) < 3.321928095
        let bits = (digits.min(1 << 24) as u64 * 3_321_928_095).div_ceil(1_000_000_000);
        Self::bits(usize::try_from(bits).unwrap_or(usize::MAX))
    }

    /// Twice as many bits.
    #[must_use]
    pub fn doubled(self) -> Self {
        Self::bits(self.bits * 2)
    }

    /// `guard` bits more.
    #[must_use]
    pub fn plus(self, guard: usize) -> Self {
        Self::bits(self.bits.saturating_add(guard))
    }

    /// The mantissa bits.
    #[must_use]
    pub fn as_bits(self) -> usize {
        self.bits
    }

    /// The decimal digits carried in full, rounded down.
    #[must_use]
    pub fn as_digits(self) -> usize {
        // log10(2) > 0.301029995
        usize::try_from(self.bits as u64 * 301_029_995 / 1_000_000_000).unwrap_or(usize::MAX)
    }
}

/// A binary floating-point number `mantissa * 2^exponent` with a mantissa of at most
/// `precision` bits.
///
/// An operation rounds its exact result once, to nearest with ties to even, at the larger
/// precision of its operands. There are no infinities, no NaN and no signed zero. The exponent
/// range is ±2^60: smaller magnitudes become zero, larger ones stick at the end of the range,
/// which no converted constant can come near (conversion to `f64` overflows at 2^1024).
///
/// Equality and order are those of the values; the precision does not take part.
#[derive(Clone, Debug)]
pub struct Real {
    pub(super) mantissa: IBig,
    pub(super) exponent: i64,
    pub(super) precision: Precision,
}

/// The largest exponent magnitude.
const EXPONENT_LIMIT: i64 = 1 << 60;

impl Real {
    /// Zero at precision `p`.
    #[must_use]
    pub fn zero(p: Precision) -> Self {
        Self { mantissa: IBig::ZERO, exponent: 0, precision: p }
    }

    /// One at precision `p`.
    #[must_use]
    pub fn one(p: Precision) -> Self {
        Self { mantissa: IBig::ONE, exponent: 0, precision: p }
    }

    /// The integer `n`, rounded to `p` bits if it is longer.
    #[must_use]
    pub fn from_i64(n: i64, p: Precision) -> Self {
        Self::rounded(IBig::from(n), 0, p)
    }

    /// `mantissa * 2^exponent` rounded to `p` bits, to nearest with ties to even.
    #[must_use]
    pub fn rounded(mantissa: IBig, exponent: i64, p: Precision) -> Self {
        let length = mantissa.bit_len();
        let (mantissa, exponent) = if length > p.as_bits() {
            let drop = length - p.as_bits();
            let (sign, magnitude) = mantissa.into_parts();
            let magnitude = shift_right_to_even(magnitude, drop);
            (IBig::from_parts(sign, magnitude), exponent.saturating_add(size(drop)))
        } else {
            (mantissa, exponent)
        };
        if mantissa.is_zero() || exponent < -EXPONENT_LIMIT {
            return Self::zero(p);
        }
        Self { mantissa, exponent: exponent.min(EXPONENT_LIMIT), precision: p }
    }

    /// The precision this number carries into operations.
    #[must_use]
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// The same value rounded to precision `p` (unchanged if it fits).
    #[must_use]
    pub fn with_precision(&self, p: Precision) -> Self {
        self.clone().into_precision(p)
    }

    /// [`Real::with_precision`] without a copy.
    #[must_use]
    pub fn into_precision(self, p: Precision) -> Self {
        Self::rounded(self.mantissa, self.exponent, p)
    }

    /// Whether the value is exactly zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// Whether the value is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        !self.is_zero() && self.mantissa.is_negative()
    }

    /// The magnitude, exactly.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// The value times `2^k`, exactly.
    #[must_use]
    pub fn shifted(&self, k: i64) -> Self {
        Self::rounded(self.mantissa.clone(), self.exponent.saturating_add(k), self.precision)
    }

    /// The smallest `t` with `|self| < 2^t`; `None` for zero.
    #[must_use]
    pub fn top(&self) -> Option<i64> {
        (!self.is_zero()).then(|| self.exponent + size(self.mantissa.bit_len()))
    }

    /// The order of the magnitudes.
    #[must_use]
    pub fn cmp_abs(&self, other: &Self) -> Ordering {
        match (self.top(), other.top()) {
            (Some(a), Some(b)) if a == b => {
                // Equal tops: the exponents differ by less than the mantissa lengths.
                let low = self.exponent.min(other.exponent);
                aligned(self, low).cmp(&aligned(other, low))
            }
            (a, b) => a.cmp(&b),
        }
    }
}

/// The magnitude of `x` as a multiple of `2^low`, for `low` at or below its exponent.
fn aligned(x: &Real, low: i64) -> UBig {
    x.mantissa.clone().into_parts().1 << count(x.exponent - low)
}

/// `magnitude / 2^drop` rounded to nearest, ties to even.
pub(super) fn shift_right_to_even(mut magnitude: UBig, drop: usize) -> UBig {
    if drop == 0 {
        return magnitude;
    }
    let half = magnitude.bit(drop - 1);
    let above_half = half && magnitude.trailing_zeros().is_some_and(|zeros| zeros < drop - 1);
    magnitude >>= drop;
    if half && (above_half || magnitude.bit(0)) {
        magnitude += UBig::ONE;
    }
    magnitude
}

/// A bit count as an exponent difference.
pub(super) fn size(bits: usize) -> i64 {
    i64::try_from(bits).unwrap_or(i64::MAX)
}

/// A non-negative exponent difference as a bit count.
pub(super) fn count(bits: i64) -> usize {
    usize::try_from(bits).unwrap_or(0)
}

impl Ord for Real {
    fn cmp(&self, other: &Self) -> Ordering {
        let sign = |x: &Self| match (x.is_zero(), x.mantissa.sign()) {
            (true, _) => 0,
            (false, Sign::Positive) => 1,
            (false, Sign::Negative) => -1,
        };
        sign(self).cmp(&sign(other)).then_with(|| {
            let order = self.cmp_abs(other);
            if sign(self) < 0 { order.reverse() } else { order }
        })
    }
}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Real {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Real {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_to_nearest_and_ties_go_to_even() {
        let p = Precision::bits(8);
        let round = |n: i64| Real::from_i64(n, p);
        // 9 bits: the last one is a tie.
        assert_eq!(round(0b1_0000_0001), round(0b1_0000_0000));
        assert_eq!(round(0b1_0000_0011), round(0b1_0000_0100));
        assert_eq!(round(-0b1_0000_0011), round(-0b1_0000_0100));
        // Just above the tie, and a carry into the next binade.
        assert_eq!(round(0b100_0000_0101), round(0b100_0000_1000));
        assert_eq!(round(0b1_1111_1111), round(0b10_0000_0000));
    }

    #[test]
    fn order_is_that_of_the_values_whatever_the_representation() {
        let p = Precision::bits(64);
        let four = Real::rounded(IBig::from(1), 2, p);
        assert_eq!(four, Real::from_i64(4, Precision::bits(100)));
        assert!(Real::from_i64(-5, p) < Real::from_i64(-4, p));
        assert!(Real::from_i64(-5, p) < Real::zero(p));
        assert!(Real::zero(p) < Real::one(p).shifted(-100_000));
        assert!(Real::from_i64(3, p) < four);
    }

    #[test]
    fn precision_converts_between_digits_and_bits_without_losing_any() {
        for digits in 3..2000 {
            assert_eq!(Precision::digits(digits).as_digits(), digits);
        }
        assert_eq!(Precision::digits(50).as_bits(), 167);
        assert_eq!(Precision::bits(100).doubled().as_bits(), 200);
    }

    #[test]
    fn exponents_saturate_instead_of_overflowing() {
        let p = Precision::bits(53);
        let huge = Real::one(p).shifted(i64::MAX);
        assert_eq!(huge, Real::one(p).shifted(EXPONENT_LIMIT));
        assert!(Real::one(p).shifted(i64::MIN).is_zero());
        assert_eq!(&huge * &huge, huge);
    }
}
