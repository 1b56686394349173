//! The functions that are made of others: their exact values, values in doubles, enclosures and slopes.

use dashu_base::{Abs as _, Signed as _};
use dashu_ratio::RBig;
use deadbeat_math as math;

use super::Function;
use super::bounds::Interval;
use super::poly::{Poly, without_rounding};
use crate::real::{Real, Undefined};

/// The largest exponent of 2 or 10 that is looked at for a rational value.
const LARGEST: i64 = 64;

/// The value at constants; `None` for the other functions.
///
/// # Errors
/// Outside the domain, or what is too large to be worked with.
pub(super) fn exact(function: Function, values: &[Real]) -> Result<Option<Real>, Undefined> {
    let x = &values[0];
    let p = x.precision();
    let whole = |n: i64| Real::from_i64(n, p);
    let logarithm = |base: i64| without_rounding(x.checked_ln()?, Some(1)).checked_div(&whole(base).checked_ln()?);
    let cosh = || -> Result<Real, Undefined> {
        let grown = x.abs().checked_exp()?;
        Ok((&grown + &whole(1).checked_div(&grown)?).shifted(-1))
    };
    Ok(Some(match function {
        Function::Log10 => logarithm(10)?,
        Function::Log2 => logarithm(2)?,
        Function::Exp2 => whole(2).checked_powf(x)?,
        Function::Cosh => cosh()?,
        Function::Sinh => &x.tanh() * &cosh()?,
        Function::Cbrt if x.is_zero() => x.clone(),
        Function::Cbrt => {
            let root = x.abs().checked_powf(&whole(1).checked_div(&whole(3))?)?;
            if x.is_negative() { -root } else { root }
        }
        Function::Hypot => (&(x * x) + &(&values[1] * &values[1])).checked_sqrt()?,
        Function::Floor => floor(x)?,
        _ => return Ok(None),
    }))
}

/// The largest whole number that is not above; what differs from one by rounding only is that.
fn floor(x: &Real) -> Result<Real, Undefined> {
    if x.top().is_some_and(|top| top > 52) {
        return Err(Undefined::OutOfRange);
    }
    let nearest = Real::from_f64(x.to_f64().round(), x.precision()).ok_or(Undefined::OutOfRange)?;
    let rest = without_rounding(x - &nearest, x.top().max(Some(1)));
    Ok(if rest.is_negative() { &nearest - &Real::one(x.precision()) } else { nearest })
}

/// The value at rationals where it is rational, and known to be.
pub(super) fn rational(function: Function, values: &[RBig]) -> Option<RBig> {
    let x = &values[0];
    match function {
        Function::Floor => Some(RBig::from(x.floor())),
        Function::Sinh | Function::Cbrt if x.is_zero() => Some(RBig::ZERO),
        Function::Cosh if x.is_zero() => Some(RBig::ONE),
        Function::Log10 => exponent(x, 10),
        Function::Log2 => exponent(x, 2),
        Function::Exp2 => (-LARGEST..=LARGEST).find(|n| RBig::from(*n) == *x).map(|n| power(2, n)),
        Function::Hypot if x.is_zero() => Some(values[1].clone().abs()),
        Function::Hypot if values[1].is_zero() => Some(x.clone().abs()),
        _ => None,
    }
}

/// n where x is the n-th power of a base.
fn exponent(x: &RBig, base: u8) -> Option<RBig> {
    if !x.is_positive() {
        return None;
    }
    (-LARGEST..=LARGEST).find(|n| power(base, *n) == *x).map(RBig::from)
}

fn power(base: u8, n: i64) -> RBig {
    RBig::from(base).pow(isize::try_from(n).unwrap_or(0))
}

/// The value in doubles, for checks and reports.
pub(super) fn double(function: Function, values: &[f64]) -> Option<f64> {
    let x = values[0];
    let grown = math::exp_f64(x.abs());
    Some(match function {
        Function::Log10 => math::log_f64(x) * std::f64::consts::LOG10_E,
        Function::Log2 => math::log_f64(x) * std::f64::consts::LOG2_E,
        Function::Exp2 => math::pow_f64(2.0, x),
        Function::Cosh => 0.5 * grown + 0.5 / grown,
        Function::Sinh if x.abs() < 1.0 => math::tanh_f64(x) * (0.5 * grown + 0.5 / grown),
        Function::Sinh => x.signum() * (0.5 * grown - 0.5 / grown),
        Function::Cbrt => x.signum() * math::pow_f64(x.abs(), 1.0 / 3.0),
        Function::Floor => x.floor(),
        Function::Hypot => {
            let (large, small) = (x.abs().max(values[1].abs()), x.abs().min(values[1].abs()));
            if large == 0.0 { 0.0 } else { large * math::sqrt_f64(1.0 + (small / large) * (small / large)) }
        }
        _ => return None,
    })
}

/// Between which numbers it stays.
pub(super) fn enclose(function: Function, ranges: &[Interval]) -> Option<Interval> {
    let x = ranges[0];
    let at = |values: &[f64]| double(function, values).unwrap_or(f64::NAN);
    let rising = |whole: Interval| x.rising(|x| at(&[x]), whole);
    Some(match function {
        Function::Exp2 => rising(Interval::new(0.0, f64::INFINITY)),
        Function::Log10 | Function::Log2 | Function::Sinh | Function::Cbrt | Function::Floor => rising(Interval::ALL),
        Function::Cosh => Interval::new(at(&[x.least()]), at(&[x.magnitude()])),
        Function::Hypot => {
            let y = ranges[1];
            let most = if x.magnitude().is_finite() && y.magnitude().is_finite() {
                at(&[x.magnitude(), y.magnitude()])
            } else {
                f64::INFINITY
            };
            Interval::new(at(&[x.least(), y.least()]), most)
        }
        _ => return None,
    })
}

/// The derivative of a function of one argument, at that argument; `None` where none is known in closed form.
pub(super) fn slope(function: Function, x: &Poly) -> Option<Poly> {
    let call = |f: Function| Poly::call(f, vec![x.clone()]).ok();
    let number = |n: u8| Poly::from(RBig::from(n));
    let logarithm = |n: u8| Poly::call(Function::Log, vec![number(n)]).ok();
    match function {
        Function::Log10 => x.times(&logarithm(10)?).ok()?.reciprocal().ok(),
        Function::Log2 => x.times(&logarithm(2)?).ok()?.reciprocal().ok(),
        Function::Exp2 => call(Function::Exp2)?.times(&logarithm(2)?).ok(),
        Function::Sinh => call(Function::Cosh),
        Function::Cosh => call(Function::Sinh),
        Function::Cbrt => call(Function::Cbrt)?.power(2).ok()?.times(&number(3)).ok()?.reciprocal().ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bounds::{derivative, enclose};
    use super::super::poly::Atom;
    use super::super::value::value;
    use super::super::{Constant, Symbol};
    use super::*;
    use crate::real::Precision;

    const ALL: [Function; 7] = [
        Function::Log10,
        Function::Log2,
        Function::Exp2,
        Function::Sinh,
        Function::Cosh,
        Function::Cbrt,
        Function::Hypot,
    ];

    fn t() -> Poly {
        Poly::from(Atom::Symbol(Symbol::Time))
    }

    /// f(t), and f(t, 2) of two arguments.
    fn of_time(function: Function) -> Poly {
        let arguments = if function == Function::Hypot { vec![t(), Poly::from(RBig::from(2))] } else { vec![t()] };
        Poly::call(function, arguments).unwrap()
    }

    /// A slope is the quotient of differences, and an enclosure holds what is between its ends.
    #[test]
    fn slopes_and_enclosures_are_those_of_the_values() {
        for function in ALL {
            let (f, slope) = (of_time(function), derivative(&of_time(function), Symbol::Time).unwrap());
            for at in [0.3, 0.9, 2.5] {
                let near = |x: f64| value(&f, &|_| x);
                let quotient = (near(at + 1e-5) - near(at - 1e-5)) / 2e-5;
                let exact = value(&slope, &|_| at);
                // The third derivatives are below 1e3 here: (1e-5)^2 times that, and rounding by 1e-16/1e-5.
                assert!((quotient - exact).abs() < 1e-6, "{function:?} at {at}: {quotient} {exact}");
                let range = enclose(&f, &|_| Interval::new(at - 0.2, at + 0.2));
                for k in -10..=10 {
                    let inside = near(at + 0.02 * f64::from(k));
                    let off = 1e-14 * inside.abs();
                    assert!(range.low - off <= inside && inside <= range.high + off, "{function:?}: {range:?}");
                }
                assert!(range.high - range.low < 2.0 * 0.4 * (exact.abs() + 12.0), "{function:?}: {range:?} is wide");
            }
        }
        let both = enclose(&of_time(Function::Cosh), &|_| Interval::new(-2.0, 1.0));
        assert_eq!((both.low, both.high), (1.0, double(Function::Cosh, &[2.0]).unwrap()));
        assert_eq!(enclose(&of_time(Function::Floor), &|_| Interval::new(-0.5, 2.5)), Interval::new(-1.0, 2.0));
        assert!(derivative(&of_time(Function::Floor), Symbol::Time).is_none());
    }

    /// Values at constants, from tables (Abramowitz and Stegun 4.2, 4.5; cubes); rounding decides no floor.
    #[test]
    fn constants_have_their_values() {
        let of = |function, values: &[f64]| {
            let p = Precision::bits(200);
            let values: Vec<Real> = values.iter().map(|x| Real::from_f64(*x, p).unwrap()).collect();
            exact(function, &values).unwrap().unwrap().to_f64()
        };
        for (function, values, expected) in [
            (Function::Log10, vec![1000.0], 3.0),
            (Function::Log2, vec![0.125], -3.0),
            (Function::Exp2, vec![0.5], std::f64::consts::SQRT_2),
            (Function::Sinh, vec![1.0], 1.175_201_193_643_801_4),
            (Function::Sinh, vec![-1e-30], -1e-30),
            (Function::Cosh, vec![-1.0], 1.543_080_634_815_243_7),
            (Function::Cbrt, vec![-27.0], -3.0),
            (Function::Hypot, vec![-3.0, 4.0], 5.0),
            (Function::Floor, vec![-0.5], -1.0),
        ] {
            assert_eq!(of(function, &values), expected, "{function:?} of {values:?}");
        }
        let thousand = Poly::call(Function::Log10, vec![Poly::from(RBig::from(1000))]).unwrap();
        assert_eq!(thousand.as_rational(), Some(RBig::from(3)));
        let root = Poly::call(Function::Cbrt, vec![Poly::from(RBig::from(27))]).unwrap();
        let floor = Constant::try_from(Poly::call(Function::Floor, vec![root]).unwrap()).unwrap();
        for bits in [160, 256, 512] {
            assert_eq!(floor.evaluate(Precision::bits(bits)).unwrap().to_f64(), 3.0, "at {bits} bits");
        }
    }
}
