//! The elementary functions, each with the arguments it is not defined for as an error.
//!
//! The functions are correctly rounded ([`Real::checked_powf`] nearly so). Arguments of
//! magnitude 2^4096 and above are refused, as are exponentials whose result would leave the
//! range of about 2^±(2^32): every call ends quickly, whatever it is given.

use std::fmt;

use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, FBig, FpError, Repr};

use super::number::{Precision, Real, size};

/// Arguments `x` with `|x| < 2^LARGEST_TOP` are accepted.
const LARGEST_TOP: i64 = 4096;

/// Exponentials are accepted for `|x| < 2^LARGEST_EXPONENTIAL_TOP`.
const LARGEST_EXPONENTIAL_TOP: i64 = 32;

/// Why a function has no value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Undefined {
    /// The argument is outside the mathematical domain: `sqrt(-1)`, `1/0`, `asin(2)`.
    OutsideDomain,
    /// The argument or the result is too large to be worked with.
    OutOfRange,
}

impl fmt::Display for Undefined {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::OutsideDomain => "the argument is outside the domain of the function",
            Self::OutOfRange => "the argument or the result is too large",
        })
    }
}

impl std::error::Error for Undefined {}

type Rounding = Context<HalfEven>;
type Float = FBig<HalfEven, 2>;
type Outcome = Result<dashu_float::round::Rounded<Float>, FpError>;

/// The value in the representation of the function library.
fn lent(x: &Real) -> Result<Repr<2>, Undefined> {
    let exponent = isize::try_from(x.exponent).map_err(|_| Undefined::OutOfRange)?;
    Ok(Repr::new(x.mantissa.clone(), exponent))
}

/// A library result as a value.
fn returned(outcome: Outcome, p: Precision) -> Result<Real, Undefined> {
    let value = match outcome {
        Ok(rounded) => rounded.value().into_repr(),
        Err(FpError::OutOfDomain | FpError::Indeterminate) => return Err(Undefined::OutsideDomain),
        Err(_) => return Err(Undefined::OutOfRange),
    };
    if value.is_infinite() {
        return Err(Undefined::OutOfRange);
    }
    let (mantissa, exponent) = value.into_parts();
    Ok(Real::rounded(mantissa, i64::try_from(exponent).map_err(|_| Undefined::OutOfRange)?, p))
}

impl Real {
    /// The circle constant, correctly rounded.
    #[must_use]
    pub fn pi(p: Precision) -> Self {
        let (mantissa, exponent) = Rounding::new(p.as_bits()).pi::<2>(None).value().into_repr().into_parts();
        Self::rounded(mantissa, exponent as i64, p)
    }

    /// Applies a library function.
    fn through(&self, function: impl FnOnce(&Rounding, &Repr<2>) -> Outcome) -> Result<Self, Undefined> {
        self.bounded()?;
        let context = Rounding::new(self.precision.as_bits());
        returned(function(&context, &lent(self)?), self.precision)
    }

    /// Refuses gigantic arguments.
    fn bounded(&self) -> Result<(), Undefined> {
        match self.top() {
            Some(top) if top > LARGEST_TOP => Err(Undefined::OutOfRange),
            _ => Ok(()),
        }
    }

    /// Whether `|self| < 2^-bits`.
    fn is_below(&self, bits: i64) -> bool {
        self.top().is_none_or(|top| top <= -bits)
    }

    /// Whether `self^2` is below a quarter of the last place of one, so that odd functions with
    /// unit slope round to their argument and even ones to one.
    fn is_linear(&self) -> bool {
        self.is_below(size(self.precision.as_bits() / 2) + 2)
    }

    /// The exponential.
    ///
    /// # Errors
    /// [`Undefined::OutOfRange`] for `|self| >= 2^32`.
    pub fn checked_exp(&self) -> Result<Self, Undefined> {
        if self.is_below(size(self.precision.as_bits()) + 2) {
            return Ok(Self::one(self.precision));
        }
        if self.top().is_some_and(|top| top > LARGEST_EXPONENTIAL_TOP) {
            return Err(Undefined::OutOfRange);
        }
        self.through(|context, x| context.exp(x, None))
    }

    /// The natural logarithm.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] at zero and below, [`Undefined::OutOfRange`] outside
    /// 2^±4096.
    pub fn checked_ln(&self) -> Result<Self, Undefined> {
        if self.is_zero() || self.is_negative() {
            return Err(Undefined::OutsideDomain);
        }
        if self.is_below(LARGEST_TOP) {
            return Err(Undefined::OutOfRange);
        }
        self.through(|context, x| context.ln(x, None))
    }

    /// The sine of an angle in radians.
    ///
    /// # Errors
    /// [`Undefined::OutOfRange`] for `|self| >= 2^4096`.
    pub fn checked_sin(&self) -> Result<Self, Undefined> {
        if self.is_linear() {
            return Ok(self.clone());
        }
        self.through(|context, x| context.sin(x, None))
    }

    /// The cosine of an angle in radians.
    ///
    /// # Errors
    /// [`Undefined::OutOfRange`] for `|self| >= 2^4096`.
    pub fn checked_cos(&self) -> Result<Self, Undefined> {
        if self.is_linear() {
            return Ok(Self::one(self.precision));
        }
        self.through(|context, x| context.cos(x, None))
    }

    /// The tangent of an angle in radians (no number of finite mantissa is a pole).
    ///
    /// # Errors
    /// [`Undefined::OutOfRange`] for `|self| >= 2^4096`.
    pub fn checked_tan(&self) -> Result<Self, Undefined> {
        if self.is_linear() {
            return Ok(self.clone());
        }
        self.through(|context, x| context.tan(x, None))
    }

    /// The arc sine, in radians.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] for `|self| > 1`.
    pub fn checked_asin(&self) -> Result<Self, Undefined> {
        if self.abs() > Self::one(self.precision) {
            return Err(Undefined::OutsideDomain);
        }
        if self.is_linear() {
            return Ok(self.clone());
        }
        self.through(|context, x| context.asin(x, None))
    }

    /// The arc cosine, in radians.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] for `|self| > 1`.
    pub fn checked_acos(&self) -> Result<Self, Undefined> {
        let p = self.precision;
        if self.abs() > Self::one(p) {
            return Err(Undefined::OutsideDomain);
        }
        if self.is_below(size(p.as_bits()) + 64) {
            return Ok(Self::pi(p).shifted(-1));
        }
        self.through(|context, x| context.acos(x, None))
    }

    /// The arc tangent, in radians.
    ///
    /// # Errors
    /// [`Undefined::OutOfRange`] for `|self| >= 2^4096`.
    pub fn checked_atan(&self) -> Result<Self, Undefined> {
        if self.is_linear() {
            return Ok(self.clone());
        }
        self.through(|context, x| context.atan(x, None))
    }

    /// The angle of the point `(x, self)` in radians, in (-pi, pi]; zero has no sign here, so
    /// the negative axis is at pi.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] at the origin, [`Undefined::OutOfRange`] for coordinates
    /// outside 2^±4096 other than zero.
    pub fn checked_atan2(&self, x: &Self) -> Result<Self, Undefined> {
        let p = self.precision.max(x.precision);
        if self.is_zero() {
            return match x.is_negative() {
                true => Ok(Self::pi(p)),
                false if x.is_zero() => Err(Undefined::OutsideDomain),
                false => Ok(Self::zero(p)),
            };
        }
        for coordinate in [self, x] {
            coordinate.bounded()?;
            if !coordinate.is_zero() && coordinate.is_below(LARGEST_TOP) {
                return Err(Undefined::OutOfRange);
            }
        }
        let context = Rounding::new(p.as_bits());
        returned(context.atan2(&lent(self)?, &lent(x)?, None), p)
    }

    /// The hyperbolic tangent; defined everywhere.
    #[must_use]
    pub fn tanh(&self) -> Self {
        let p = self.precision;
        if self.is_linear() {
            return self.clone();
        }
        let one = if self.is_negative() { -Self::one(p) } else { Self::one(p) };
        // 1 - |tanh x| < 2 exp(-2 |x|), below half a unit in the last place from |x| = bits on.
        if self.abs() >= Self::from_i64(size(p.as_bits()), Precision::bits(64)) {
            return one;
        }
        self.through(|context, x| context.tanh(x, None)).unwrap_or(one)
    }

    /// The power `self^y`: by repeated squaring for integer `y`, otherwise `exp(y ln self)` with
    /// guard bits, within half a unit in the last place plus a part in 2^16 of one.
    ///
    /// # Errors
    /// [`Undefined::OutsideDomain`] for a negative base with a fractional exponent and for
    /// negative powers of zero, [`Undefined::OutOfRange`] if the result or an argument is.
    pub fn checked_powf(&self, y: &Self) -> Result<Self, Undefined> {
        let p = self.precision.max(y.precision);
        if let Some(n) = y.to_integer() {
            return self.with_precision(p).checked_powi(n);
        }
        if self.is_zero() && !y.is_negative() {
            return Ok(Self::zero(p));
        }
        let working = p.plus(80);
        let logarithm = self.with_precision(working).checked_ln()?;
        Ok((y * &logarithm).checked_exp()?.into_precision(p))
    }

    /// The value as an integer, if it is one of less than 63 bits.
    #[must_use]
    pub fn to_integer(&self) -> Option<i64> {
        match self.top() {
            None => Some(0),
            Some(1..63) => {
                let value = self.to_rational()?;
                value.is_int().then(|| i64::try_from(value.numerator()).ok())?
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn evil(p: Precision) -> Vec<Real> {
        let mut table = Vec::new();
        for top in [
            -(1 << 62),
            -(1 << 40),
            -70_000,
            -4097,
            -4096,
            -4095,
            -300,
            -60,
            -1,
            0,
            1,
            2,
            30,
            33,
            64,
            300,
            4000,
            4096,
            4097,
            70_000,
            1 << 40,
            1 << 62,
        ] {
            for mantissa in [1, 3, 0x1f_ffff_ffff_ffff] {
                let x = Real::from_i64(mantissa, p).shifted(top);
                table.push(-&x);
                table.push(x);
            }
        }
        // Next to the ends of the domains, and to a zero of the logarithm.
        let one = Real::one(p);
        for k in [-52, -51, -40] {
            table.extend([&one + one.shifted(k), &one - one.shifted(k), -(&one - one.shifted(k))]);
        }
        table.extend([Real::zero(p), Real::pi(p), Real::pi(p).shifted(-1)]);
        table
    }

    #[test]
    fn no_argument_makes_a_checked_function_panic_or_hang() {
        for p in [8, 53, 130].map(Precision::bits) {
            let table = evil(p);
            for x in &table {
                for function in [
                    Real::checked_sqrt,
                    Real::checked_exp,
                    Real::checked_ln,
                    Real::checked_sin,
                    Real::checked_cos,
                    Real::checked_tan,
                    Real::checked_asin,
                    Real::checked_acos,
                    Real::checked_atan,
                ] {
                    let _ = function(x);
                }
                assert!(x.tanh().abs() <= Real::one(p));
                for n in [i64::MIN, -2, 0, 1, 7, i64::MAX] {
                    let _ = x.checked_powi(n);
                }
                let _ = (x.to_f64(), x.to_f32(), x.log2_abs(), x.to_integer());
            }
            for x in table.iter().step_by(5) {
                for y in table.iter().step_by(7) {
                    let _ = (x.checked_div(y), x.checked_atan2(y), x.checked_powf(y));
                    let _ = (x + y, x - y, x * y, x.cmp(y), x.mul_add(y, x));
                }
            }
        }
    }

    #[test]
    fn domain_errors_are_reported_as_such() {
        let p = Precision::bits(100);
        let (zero, one, two) = (Real::zero(p), Real::one(p), Real::from_i64(2, p));
        let outside = Err(Undefined::OutsideDomain);
        assert_eq!(zero.checked_ln(), outside);
        assert_eq!((-&one).checked_ln(), outside);
        assert_eq!((-&one).checked_sqrt(), outside);
        assert_eq!(two.checked_asin(), outside);
        assert_eq!((-&two).checked_acos(), outside);
        assert_eq!(one.checked_div(&zero), outside);
        assert_eq!(zero.checked_atan2(&zero), outside);
        assert_eq!((-&two).checked_powf(&one.shifted(-1)), outside);
        assert_eq!(zero.checked_powf(&-&one.shifted(-1)), outside);
        assert_eq!(Real::from_f64(1e30, p).unwrap().checked_exp(), Err(Undefined::OutOfRange));
        assert_eq!(one.shifted(1400).checked_exp(), Err(Undefined::OutOfRange));
        assert_eq!(one.shifted(4096).checked_sin(), Err(Undefined::OutOfRange));
    }

    #[test]
    fn values_agree_with_twice_the_precision_and_with_the_identities() {
        let p = Precision::bits(113);
        let wide = p.plus(150);
        for k in 1..30 {
            let x = Real::from_i64(k * k - 7 * k, p) / Real::from_i64(31, p);
            for function in
                [Real::checked_exp, Real::checked_sin, Real::checked_cos, Real::checked_tan, Real::checked_atan]
            {
                let fine = function(&x.with_precision(wide)).unwrap();
                assert_eq!(function(&x).unwrap(), fine.into_precision(p));
            }
            let x = x.with_precision(wide);
            let (s, c) = (x.checked_sin().unwrap(), x.checked_cos().unwrap());
            let off = &s * &s + &c * &c - Real::one(p);
            assert!(off.log2_abs() < -260.0);
            let off = x.tanh() * (x.shifted(1).checked_exp().unwrap() + Real::one(p))
                - (x.shifted(1).checked_exp().unwrap() - Real::one(p));
            assert!(off.log2_abs() < -230.0);
            let back = s.checked_atan2(&c).unwrap().checked_sin().unwrap() - s;
            assert!(back.log2_abs() < -255.0);
        }
    }

    #[test]
    fn named_values() {
        let p = Precision::bits(120);
        let (one, pi) = (Real::one(p), Real::pi(p));
        assert_eq!(one.checked_asin().unwrap(), pi.shifted(-1));
        assert_eq!((-&one).checked_acos().unwrap(), pi);
        assert_eq!(one.checked_atan().unwrap(), pi.shifted(-2));
        assert_eq!(Real::zero(p).checked_atan2(&-&one).unwrap(), pi);
        assert_eq!(Real::from_i64(4, p).checked_powf(&one.shifted(-1)).unwrap(), Real::from_i64(2, p));
        assert_eq!(Real::from_i64(-2, p).checked_powf(&Real::from_i64(3, p)).unwrap(), Real::from_i64(-8, p));
        assert_eq!(one.checked_exp().unwrap().to_decimal(30), "2.71828182845904523536028747135e0");
        assert_eq!(pi.checked_ln().unwrap().to_decimal(30), "1.14472988584940017414342735135e0");
        assert_eq!(pi.shifted(400).tanh(), one);
    }
}
