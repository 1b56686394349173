//! Correctly rounded `+ - * /`, square root, integer powers and sums of products.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use dashu_base::{BitTest, DivRem, Sign, SquareRootRem};
use dashu_int::{IBig, UBig};

use super::accumulate;
use super::elementary::Undefined;
use super::number::{Precision, Real, count, size};

/// The largest binary exponent [`Real::checked_powi`] produces.
const LARGEST_EXPONENT: u128 = 1 << 40;

/// Guard bits of [`Real::sum_of_products`].
const GUARD: usize = 32;

impl Real {
    /// `self / divisor`, correctly rounded.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] for a zero divisor.
    pub fn checked_div(&self, divisor: &Self) -> Result<Self, Undefined> {
        let p = self.precision.max(divisor.precision);
        if divisor.is_zero() {
            return Err(Undefined::OutsideDomain);
        }
        if self.is_zero() {
            return Ok(Self::zero(p));
        }
        let (sign_a, a) = self.mantissa.clone().into_parts();
        let (sign_b, b) = divisor.mantissa.clone().into_parts();
        // Two bits more than asked, then one sticky bit for the remainder.
        let shift = (p.as_bits() + 2 + b.bit_len()).saturating_sub(a.bit_len());
        let (quotient, remainder) = (a << shift).div_rem(&b);
        let quotient = (quotient << 1) | UBig::from(u8::from(!remainder.is_zero()));
        let exponent = self.exponent - divisor.exponent - size(shift) - 1;
        Ok(Self::rounded(IBig::from_parts(sign_a * sign_b, quotient), exponent, p))
    }

    /// The square root, correctly rounded.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] below zero.
    pub fn checked_sqrt(&self) -> Result<Self, Undefined> {
        if self.is_negative() {
            return Err(Undefined::OutsideDomain);
        }
        if self.is_zero() {
            return Ok(self.clone());
        }
        let (_, magnitude) = self.mantissa.clone().into_parts();
        let mut shift = (2 * self.precision.as_bits() + 4).saturating_sub(magnitude.bit_len());
        if (self.exponent - size(shift)) % 2 != 0 {
            shift += 1;
        }
        let (root, remainder) = (magnitude << shift).sqrt_rem();
        let root = (root << 1) | UBig::from(u8::from(!remainder.is_zero()));
        let exponent = (self.exponent - size(shift)) / 2 - 1;
        Ok(Self::rounded(IBig::from_parts(Sign::Positive, root), exponent, self.precision))
    }

    /// The integer power `self^n` (`0^0` is one), by repeated squaring with guard bits: exact if
    /// the result fits the precision, otherwise within half a unit in the last place plus a
    /// part in 2^16 of one.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] for a negative power of zero, [`Undefined::OutOfRange`] if
    /// the result's binary exponent could exceed 2^40 in magnitude.
    pub fn checked_powi(&self, n: i64) -> Result<Self, Undefined> {
        let p = self.precision;
        let Some(top) = self.top() else {
            return match n {
                0 => Ok(Self::one(p)),
                1.. => Ok(Self::zero(p)),
                _ => Err(Undefined::OutsideDomain),
            };
        };
        let steps = n.unsigned_abs();
        if self.abs() == Self::one(p) {
            return Ok(if n % 2 == 0 { self.abs() } else { self.clone() });
        }
        // |self| lies between 2^(top-1) and 2^top.
        let growth = top.unsigned_abs().max((top - 1).unsigned_abs());
        if u128::from(growth) * u128::from(steps) > LARGEST_EXPONENT {
            return Err(Undefined::OutOfRange);
        }
        let working = p.plus(2 * count(64 - i64::from(steps.leading_zeros())) + 20);
        let base = self.with_precision(working);
        let mut power = Self::one(working);
        for bit in (0..u64::BITS - steps.leading_zeros()).rev() {
            power = &power * &power;
            if steps >> bit & 1 == 1 {
                power = &power * &base;
            }
        }
        let power = if n < 0 { Self::one(working).checked_div(&power)? } else { power };
        Ok(power.into_precision(p))
    }

    /// `self * a + b` rounded once.
    #[must_use]
    pub fn mul_add(&self, a: &Self, b: &Self) -> Self {
        let p = self.precision.max(a.precision).max(b.precision);
        if self.is_zero() || a.is_zero() {
            return b.with_precision(p);
        }
        add(&self.mantissa * &a.mantissa, self.exponent + a.exponent, b.clone(), p)
    }

    /// The sum of the products of the pairs, rounded to `p` once; where its terms are so long or of so different sizes
    /// that they cannot be summed exactly, accumulated with 32 guard bits: the error is below half a unit in the last
    /// place plus `terms * 2^-(p+32)` of the sum of the magnitudes. Pairs with an exact zero are skipped.
    #[must_use]
    pub fn sum_of_products<'a>(pairs: impl IntoIterator<Item = (&'a Self, &'a Self)>, p: Precision) -> Self {
        let pairs: Vec<(&Self, &Self)> = pairs.into_iter().filter(|(a, b)| !a.is_zero() && !b.is_zero()).collect();
        match accumulate::sum(&pairs) {
            Some((mantissa, exponent)) => Self::rounded(mantissa, exponent, p),
            None => guarded_sum(&pairs, p),
        }
    }
}

/// The sum of products, rounded on the way with [`GUARD`] bits more, then to `p`.
fn guarded_sum(pairs: &[(&Real, &Real)], p: Precision) -> Real {
    let working = p.plus(GUARD);
    let mut sum = Real::zero(working);
    for (a, b) in pairs {
        sum = add(&a.mantissa * &b.mantissa, a.exponent + b.exponent, sum, working);
    }
    sum.into_precision(p)
}

/// `mantissa * 2^exponent + other`, rounded to `p` once.
fn add(mantissa: IBig, exponent: i64, other: Real, p: Precision) -> Real {
    if other.is_zero() {
        return Real::rounded(mantissa, exponent, p);
    }
    let (mut a, mut ea, mut b, mut eb) = (mantissa, exponent, other.mantissa, other.exponent);
    let (top_a, top_b) = (ea + size(a.bit_len()), eb + size(b.bit_len()));
    if top_b > top_a {
        (a, ea, b, eb) = (b, eb, a, ea);
    }
    // Every point at which the rounding could change is a multiple of 2^cut, and so is `a`; a `b`
    // below 2^cut therefore counts by its sign only.
    let cut = ea.min(top_a.max(top_b) - size(p.as_bits()) - 2);
    if top_a.min(top_b) <= cut {
        b = IBig::from_parts(b.sign(), UBig::ONE);
        eb = cut - 1;
    }
    if ea >= eb {
        a <<= count(ea - eb);
    } else {
        b <<= count(eb - ea);
    }
    Real::rounded(a + b, ea.min(eb), p)
}

impl Neg for Real {
    type Output = Real;
    fn neg(self) -> Real {
        Real { mantissa: -self.mantissa, ..self }
    }
}

impl Neg for &Real {
    type Output = Real;
    fn neg(self) -> Real {
        -self.clone()
    }
}

impl Add for &Real {
    type Output = Real;
    fn add(self, other: &Real) -> Real {
        let p = self.precision.max(other.precision);
        if self.is_zero() {
            return other.with_precision(p);
        }
        if other.is_zero() {
            return self.with_precision(p);
        }
        add(self.mantissa.clone(), self.exponent, other.clone(), p)
    }
}

impl Sub for &Real {
    type Output = Real;
    fn sub(self, other: &Real) -> Real {
        self + &-other
    }
}

impl Mul for &Real {
    type Output = Real;
    fn mul(self, other: &Real) -> Real {
        let p = self.precision.max(other.precision);
        if self.is_zero() || other.is_zero() {
            return Real::zero(p);
        }
        Real::rounded(&self.mantissa * &other.mantissa, self.exponent + other.exponent, p)
    }
}

/// Division for divisors known not to be zero; see [`Real::checked_div`].
///
/// # Panics
/// If the divisor is zero.
impl Div for &Real {
    type Output = Real;
    fn div(self, other: &Real) -> Real {
        self.checked_div(other).expect("the divisor is known not to be zero")
    }
}

/// The remaining combinations of owned and borrowed operands.
macro_rules! owned_operands {
    ($($operator:ident :: $method:ident),*) => {$(
        impl $operator for Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                $operator::$method(&self, &other)
            }
        }
        impl $operator<&Real> for Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                $operator::$method(&self, other)
            }
        }
        impl $operator<Real> for &Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                $operator::$method(self, &other)
            }
        }
    )*};
}
owned_operands!(Add::add, Sub::sub, Mul::mul, Div::div);

impl AddAssign<&Real> for Real {
    fn add_assign(&mut self, other: &Real) {
        *self = &*self + other;
    }
}

impl SubAssign<&Real> for Real {
    fn sub_assign(&mut self, other: &Real) {
        *self = &*self - other;
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "exact expectations")]
mod tests {
    use super::*;
    use crate::real::Rational;

    /// A reproducible stream of numbers with widely different exponents and mantissa lengths.
    fn stream(count: usize, p: Precision) -> Vec<Real> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 16
        };
        (0..count)
            .map(|_| {
                let mantissa = i64::try_from(next() >> (next() % 40)).unwrap_or(0) - (1 << 20);
                Real::rounded(IBig::from(mantissa), i64::try_from(next() % 90).unwrap_or(0) - 45, p)
            })
            .collect()
    }

    #[test]
    fn every_operation_is_the_rounded_exact_result() {
        let p = Precision::bits(24);
        let numbers = stream(60, p);
        for a in &numbers {
            for b in &numbers {
                let (x, y) = (a.to_rational().unwrap(), b.to_rational().unwrap());
                assert_eq!(a + b, Real::from_rational(&(&x + &y), p));
                assert_eq!(a - b, Real::from_rational(&(&x - &y), p));
                assert_eq!(a * b, Real::from_rational(&(&x * &y), p));
                assert_eq!(a.mul_add(b, a), Real::from_rational(&(&x * &y + &x), p));
                if !b.is_zero() {
                    assert_eq!(a / b, Real::from_rational(&(&x / &y), p));
                }
            }
        }
    }

    #[test]
    fn tiny_addends_act_by_their_sign_alone_and_cost_nothing() {
        let p = Precision::bits(8);
        let tie = Real::rounded(IBig::from(257), 0, Precision::bits(9));
        let speck = Real::one(p).shifted(-(1 << 50));
        // 257 is half way between 256 and 258 at 8 bits; mul_add rounds the exact sum once.
        let one = Real::one(p);
        assert_eq!(add(tie.mantissa.clone(), 0, speck.clone(), p), Real::from_i64(258, p));
        assert_eq!(add(tie.mantissa, 0, -&speck, p), Real::from_i64(256, p));
        assert_eq!(one.mul_add(&one, &speck), one);
        assert_eq!(&one - &speck, one);
        assert_eq!(&one - &one, Real::zero(p));
    }

    #[test]
    fn square_roots_are_correctly_rounded() {
        let p = Precision::bits(40);
        for x in stream(200, p).iter().map(Real::abs) {
            let root = x.checked_sqrt().unwrap();
            let exact = x.to_rational().unwrap();
            if root.is_zero() {
                continue;
            }
            // The half units around the root enclose the true one.
            let half = Real::one(p).shifted(root.top().unwrap() - 41).to_rational().unwrap();
            let root = root.to_rational().unwrap();
            let (low, high) = (&root - &half, &root + &half);
            assert!(&low * &low <= exact && exact <= &high * &high);
        }
        assert!(Real::from_i64(-1, p).checked_sqrt().is_err());
    }

    #[test]
    fn powers_are_exact_when_they_fit() {
        let p = Precision::bits(200);
        let three = Real::from_i64(3, p);
        assert_eq!(three.checked_powi(100).unwrap().to_rational().unwrap(), Rational::from(3).pow(100));
        assert_eq!(Real::from_i64(-2, p).checked_powi(-3).unwrap().to_f64(), -0.125);
        assert_eq!(Real::zero(p).checked_powi(0).unwrap(), Real::one(p));
        assert!(Real::zero(p).checked_powi(-1).is_err());
        assert!(three.checked_powi(i64::MIN).is_err());
        assert_eq!(Real::from_i64(-1, p).checked_powi(i64::MIN).unwrap(), Real::one(p));
    }

    #[test]
    fn sums_of_products_round_once() {
        let p = Precision::bits(53);
        let (big, one) = (Real::one(p).shifted(60), Real::one(p));
        let minus = -&big;
        let sum = Real::sum_of_products([(&big, &one), (&one, &one), (&minus, &one)], p);
        assert_eq!(sum, one);
    }

    /// Claim: sums of products of any lengths, signs and sizes are the rounded exact ones; those that are summed exactly
    /// and those that are rounded on the way, to what 32 guard bits leave.
    #[test]
    fn sums_of_products_are_the_rounded_exact_sums() {
        let mut exact = 0;
        for bits in [8, 63, 64, 65, 128, 300, 512, 1_300] {
            let p = Precision::bits(bits);
            // Quotients fill all bits.
            let numbers: Vec<Real> = stream(240, p)
                .chunks(2)
                .map(|it| if it[1].is_zero() { it[0].clone() } else { &it[0] / &it[1] })
                .collect();
            for (at, terms) in numbers.chunks(6).enumerate() {
                let shift = [0, 1, 70, 700, 40_000][at % 5];
                let far: Vec<Real> =
                    terms.iter().enumerate().map(|(k, x)| x.shifted(if k % 3 == 1 { shift } else { 0 })).collect();
                let pairs: Vec<_> = far.iter().zip(numbers.iter().rev()).collect();
                let rational = |x: &Real| x.to_rational().unwrap();
                let sum = pairs.iter().map(|(a, b)| rational(a) * rational(b)).fold(Rational::ZERO, |sum, x| sum + x);
                let rounded = Real::from_rational(&sum, p);
                let nonzero: Vec<_> = pairs.iter().copied().filter(|(a, b)| !a.is_zero() && !b.is_zero()).collect();
                if accumulate::sum(&nonzero).is_some() {
                    exact += 1;
                    assert_eq!(Real::sum_of_products(pairs, p), rounded, "{bits} bits, {shift}");
                }
                assert_eq!(guarded_sum(&nonzero, p), rounded, "{bits} bits, {shift}, with guard bits");
            }
        }
        assert!((100..160).contains(&exact), "{exact} of 160 sums are exact");
    }

    /// Claim: carries run through words of ones, and what cancels leaves nothing.
    #[test]
    fn sums_of_products_carry_and_cancel() {
        let p = Precision::bits(512);
        let ones = &Real::one(p).shifted(512) - &Real::one(p);
        let (one, minus) = (Real::one(p), -&ones);
        let sum = Real::sum_of_products([(&ones, &ones), (&one, &ones), (&one, &ones), (&one, &one)], p);
        assert_eq!(sum, Real::one(p).shifted(1024));
        assert!(Real::sum_of_products([(&ones, &ones), (&minus, &ones)], p).is_zero());
        assert!(Real::sum_of_products([], p).is_zero());
    }
}
