//! To and from exact rationals, hardware formats and decimal text.

use dashu_base::{BitTest, Sign};
use dashu_int::{IBig, UBig};

use super::Rational;
use super::number::{Precision, Real, count, shift_right_to_even, size};

impl Real {
    /// The rational number, correctly rounded to `p`.
    #[must_use]
    pub fn from_rational(x: &Rational, p: Precision) -> Self {
        let numerator = Self::exact(x.numerator().clone(), p);
        let denominator = Self::exact(IBig::from(x.denominator().clone()), p);
        // The operands are exact, whatever precision they carry: one rounding, in the division.
        &numerator / &denominator
    }

    /// The integer, unrounded, with a nominal precision.
    fn exact(mantissa: IBig, precision: Precision) -> Self {
        Self { mantissa, exponent: 0, precision }
    }

    /// The double, rounded to `p` if it is longer; `None` for infinities and NaN.
    #[must_use]
    pub fn from_f64(x: f64, p: Precision) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let bits = x.to_bits();
        let field = i64::try_from(bits >> 52 & 0x7ff).unwrap_or(0);
        let fraction = bits & ((1 << 52) - 1);
        let (magnitude, exponent) = if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        let sign = if x.is_sign_negative() { Sign::Negative } else { Sign::Positive };
        Some(Self::rounded(IBig::from_parts(sign, UBig::from(magnitude)), exponent, p))
    }

    /// The nearest double, ties to even: one rounding, subnormals included; values of 2^1024 -
    /// 2^970 and above become infinite. Zero is `+0.0`; a negative value that rounds to zero is
    /// `-0.0`.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let bits = self.to_format(52, 11);
        f64::from_bits(bits)
    }

    /// The nearest single-precision number, rounded once (not by way of `f64`), with the same
    /// rules as [`Real::to_f64`].
    #[must_use]
    #[allow(clippy::missing_panics_doc, reason = "the expectation always holds")]
    pub fn to_f32(&self) -> f32 {
        let bits = self.to_format(23, 8);
        f32::from_bits(u32::try_from(bits).expect("a 32-bit format has 32 bits"))
    }

    /// The bit pattern of the nearest number of the IEEE format with these field widths.
    fn to_format(&self, fraction_bits: u32, exponent_bits: u32) -> u64 {
        let Some(top) = self.top() else {
            return 0;
        };
        let sign = u64::from(self.is_negative()) << (fraction_bits + exponent_bits);
        let bias = (1_i64 << (exponent_bits - 1)) - 1;
        let infinity = ((1_u64 << exponent_bits) - 1) << fraction_bits;
        if top > bias + 1 {
            return sign | infinity;
        }
        // The unit in the last place is 2^unit, no smaller than that of the subnormals.
        let subnormal = 1 - bias - i64::from(fraction_bits);
        let unit = subnormal.max(top - 1 - i64::from(fraction_bits));
        if top < subnormal {
            return sign;
        }
        let (_, magnitude) = self.mantissa.clone().into_parts();
        let units = if self.exponent >= unit {
            magnitude << count(self.exponent - unit)
        } else {
            shift_right_to_even(magnitude, count(unit - self.exponent))
        };
        let units = u64::try_from(units).expect("at most fraction_bits + 2 bits are left");
        // Adding the fraction to the exponent field carries into the next binade, into the first
        // normal number and into infinity exactly as it should.
        let binade = u64::try_from(unit - subnormal).expect("no smaller than the subnormals");
        sign | ((binade << fraction_bits) + units)
    }

    /// The exact value; `None` beyond 2^±65536, where writing it out is pointless.
    #[must_use]
    pub fn to_rational(&self) -> Option<Rational> {
        let Some(top) = self.top() else {
            return Some(Rational::ZERO);
        };
        if top.abs() > 1 << 16 {
            return None;
        }
        let power = UBig::ONE << count(self.exponent.abs());
        Some(if self.exponent < 0 {
            Rational::from_parts(self.mantissa.clone(), power)
        } else {
            Rational::from_parts(&self.mantissa * IBig::from(power), UBig::ONE)
        })
    }

    /// `log2 |self|` for reports, to about 12 digits; minus infinity for zero. Computed from
    /// exactly defined operations, so it is the same on every machine.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "both casts are of short integers")]
    #[allow(clippy::missing_panics_doc, reason = "the expectation always holds")]
    pub fn log2_abs(&self) -> f64 {
        let Some(top) = self.top() else {
            return f64::NEG_INFINITY;
        };
        let (_, magnitude) = self.mantissa.clone().into_parts();
        let length = magnitude.bit_len();
        let leading = if length > 53 { magnitude >> (length - 53) } else { magnitude << (53 - length) };
        let leading = u64::try_from(leading).expect("53 bits are left");
        // 1 <= x < 2; squaring doubles the logarithm and hands out its bits one by one.
        let mut x = leading as f64 / (1_u64 << 52) as f64;
        let (mut fraction, mut weight) = (0.0, 0.5);
        for _ in 0..44 {
            x *= x;
            if x >= 2.0 {
                x *= 0.5;
                fraction += weight;
            }
            weight *= 0.5;
        }
        (top - 1) as f64 + fraction
    }

    /// Scientific decimal notation with `digits` significant digits (at least one), the nearest
    /// such decimal; values beyond 2^±65536 are written as a power of two.
    #[must_use]
    pub fn to_decimal(&self, digits: usize) -> String {
        let Some(top) = self.top() else {
            return "0".to_string();
        };
        let sign = if self.is_negative() { "-" } else { "" };
        let Some(exact) = self.abs().to_rational() else {
            return format!("{sign}2^{top}");
        };
        let digits = digits.max(1);
        // The decimal exponent is this estimate or one more.
        let mut exponent = (top - 1) * 30_103 / 100_000 - 1;
        loop {
            let scale = size(digits) - 1 - exponent;
            let power = Rational::from(UBig::from(10_u8).pow(count(scale.abs())));
            let scaled = if scale < 0 { &exact / power } else { &exact * power };
            let text = scaled.round().to_string();
            if text.len() == digits {
                let (first, rest) = text.split_at(1);
                let point = if rest.is_empty() { "" } else { "." };
                return format!("{sign}{first}{point}{rest}e{exponent}");
            }
            exponent += 1;
        }
    }
}

impl std::fmt::Display for Real {
    /// Scientific notation, 17 digits or the formatter's precision.
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.to_decimal(formatter.precision().unwrap_or(17)))
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, clippy::cast_possible_truncation, reason = "exact expectations")]
mod tests {
    use super::*;

    fn power(k: i64) -> Real {
        Real::one(Precision::bits(3000)).shifted(k)
    }

    #[test]
    fn halves_go_to_even_and_anything_beyond_a_half_decides() {
        let speck = power(-2900);
        let tie = power(0) + power(-53);
        assert_eq!(tie.to_f64(), 1.0);
        assert_eq!((&tie + &speck).to_f64(), 1.0 + f64::EPSILON);
        assert_eq!((&tie + power(-52)).to_f64(), 1.0 + 2.0 * f64::EPSILON);
        assert_eq!((-(&tie + &speck)).to_f64(), -1.0 - f64::EPSILON);
        assert_eq!((power(0) - power(-54)).to_f64(), 1.0);
        assert_eq!((power(0) - power(-54) - &speck).to_f64(), 1.0 - f64::EPSILON / 2.0);
    }

    #[test]
    fn single_precision_is_not_rounded_by_way_of_double() {
        // 1 + 2^-24 + 2^-60: as a double it is the tie 1 + 2^-24, which would go to 1.
        let x = power(0) + power(-24) + power(-60);
        assert_eq!(x.to_f32(), 1.0 + f32::EPSILON);
        assert_eq!(x.to_f64() as f32, 1.0);
    }

    #[test]
    fn subnormals_and_the_ends_of_the_range_round_once() {
        let least = f64::from_bits(1);
        assert_eq!(power(-1074).to_f64(), least);
        assert_eq!(power(-1075).to_f64(), 0.0);
        assert_eq!((power(-1075) + power(-2000)).to_f64(), least);
        assert_eq!((power(-1074) + power(-1075)).to_f64(), 2.0 * least);
        assert_eq!(power(-1076).to_f64(), 0.0);
        assert!((-power(-1080)).to_f64().is_sign_negative());
        // The largest subnormal and a half goes to the first normal number.
        assert_eq!((power(-1022) - power(-1075)).to_f64(), f64::MIN_POSITIVE);
        // The last bit of a subnormal is decided by the bits below it, not by 53-bit rounding.
        let x = power(-1073) + power(-1075) + power(-1120);
        assert_eq!(x.to_f64(), 3.0 * least);
        // Overflow starts half a unit above the largest number.
        let edge = power(1024) - power(970);
        assert_eq!((&edge - power(-1000)).to_f64(), f64::MAX);
        assert_eq!(edge.to_f64(), f64::INFINITY);
        assert_eq!((-power(5000)).to_f64(), f64::NEG_INFINITY);
        assert_eq!(power(-150).to_f32(), 0.0);
        assert_eq!((power(-150) + power(-2000)).to_f32(), f32::from_bits(1));
        assert_eq!((power(128) - power(103)).to_f32(), f32::INFINITY);
        assert_eq!((power(128) - power(103) - power(0)).to_f32(), f32::MAX);
    }

    #[test]
    fn every_kind_of_double_survives_the_round_trip() {
        let mut bits = 1_u64;
        for _ in 0..20_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let x = f64::from_bits(bits);
            if x.is_finite() {
                assert_eq!(Real::from_f64(x, Precision::bits(53)).unwrap().to_f64().to_bits(), bits);
                let single = x as f32;
                let there = Real::from_f64(x, Precision::bits(53)).unwrap().to_f32();
                assert_eq!(there.to_bits(), single.to_bits());
            }
        }
        assert!(Real::from_f64(f64::NAN, Precision::bits(53)).is_none());
        assert_eq!(Real::from_f64(-0.0, Precision::bits(53)).unwrap().to_f64().to_bits(), 0);
    }

    #[test]
    fn logarithms_for_reports_are_close() {
        let three = Real::from_i64(3, Precision::bits(300));
        assert!((three.log2_abs() - 1.584_962_500_721_156).abs() < 1e-12);
        assert!((three.shifted(-5000).log2_abs() + 4_998.415_037_499_279).abs() < 1e-9);
        assert_eq!(Real::zero(Precision::bits(9)).log2_abs(), f64::NEG_INFINITY);
    }

    #[test]
    fn decimals_are_the_nearest_ones() {
        let p = Precision::bits(200);
        let decimal = |n: i64, d: u64, digits| {
            Real::from_rational(&Rational::from_parts(n.into(), d.into()), p).to_decimal(digits)
        };
        assert_eq!(decimal(1, 3, 5), "3.3333e-1");
        assert_eq!(decimal(-2, 3, 5), "-6.6667e-1");
        assert_eq!(decimal(99_999, 1, 3), "1.00e5");
        assert_eq!(decimal(1, 1024, 1), "1e-3");
        assert_eq!(Real::zero(p).to_string(), "0");
        assert_eq!(Real::one(p).shifted(100_000).to_decimal(3), "2^100001");
        assert_eq!(format!("{:.20}", Real::pi(p)), "3.1415926535897932385e0");
    }
}
