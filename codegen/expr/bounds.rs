//! Enclosures: between which numbers an expression stays, and its derivative.
//!
//! For certificates and for guards that can be left out; an enclosure may be wider than the truth,
//! never narrower but for rounding in the last digits. Elementary functions are the runtime's own,
//! so that the numbers are the same on every machine.

use dashu_ratio::RBig;
use deadbeat_math as math;

use super::poly::{Atom, Poly};
use super::{Function, Symbol, further};

/// All numbers between two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lowest.
    pub low: f64,
    /// Highest.
    pub high: f64,
}

impl Interval {
    /// No bound known.
    pub const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// From `low` to `high`; everything when one of them is not a number.
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high { Self { low, high } } else { Self::ALL }
    }

    /// One number.
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// The largest magnitude.
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// The smallest magnitude.
    pub(super) fn least(self) -> f64 {
        if self.contains_zero() { 0.0 } else { self.low.abs().min(self.high.abs()) }
    }

    /// Of the sum.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self::new(self.low + other.low, self.high + other.high)
    }

    /// Of the product; zero times no bound is no bound.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let corners = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if corners.iter().any(|c| c.is_nan()) {
            return Self::ALL;
        }
        let low = corners.iter().copied().fold(f64::INFINITY, f64::min);
        let high = corners.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self::new(low, high)
    }

    fn contains_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    fn reciprocal(self) -> Self {
        if self.contains_zero() { Self::ALL } else { Self::new(1.0 / self.high, 1.0 / self.low) }
    }

    /// Of a whole power; by squaring, since exponents reach 2^31.
    #[must_use]
    pub fn power(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::point(1.0),
            1 => self,
            _ => {
                let half = self.power(exponent / 2);
                let least = if half.contains_zero() { 0.0 } else { half.low.abs().min(half.high.abs()) };
                let square = Self::new(least * least, half.magnitude() * half.magnitude());
                if exponent.is_multiple_of(2) { square } else { square.times(self) }
            }
        }
    }

    /// Of a rising function; bounds at which it has no value are dropped.
    pub(super) fn rising(self, f: impl Fn(f64) -> f64, whole: Self) -> Self {
        let at = |x: f64, otherwise: f64| if x.is_finite() && !f(x).is_nan() { f(x) } else { otherwise };
        Self::new(at(self.low, whole.low), at(self.high, whole.high))
    }

    fn union(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }
}

/// Between which numbers an expression stays, given the ranges of what varies.
pub fn enclose(poly: &Poly, range: &dyn Fn(Symbol) -> Interval) -> Interval {
    let mut sum = Interval::point(0.0);
    for (monomial, coefficient) in poly.terms() {
        let mut product = Interval::point(coefficient.to_f64().value());
        for (atom, exponent) in monomial.factors() {
            let base = enclose_atom(atom, range);
            let power = base.power(exponent.unsigned_abs());
            product = product.times(if *exponent < 0 { power.reciprocal() } else { power });
        }
        sum = sum.plus(product);
    }
    sum
}

fn enclose_atom(atom: &Atom, range: &dyn Fn(Symbol) -> Interval) -> Interval {
    match atom {
        Atom::Pi => Interval::point(std::f64::consts::PI),
        Atom::Symbol(symbol) => range(*symbol),
        Atom::Reciprocal(sum) => enclose(sum, range).reciprocal(),
        Atom::Call(function, arguments) => {
            let ranges: Vec<Interval> = arguments.iter().map(|a| enclose(a, range)).collect();
            enclose_call(*function, &ranges)
        }
    }
}

fn enclose_call(function: Function, ranges: &[Interval]) -> Interval {
    let x = ranges[0];
    let (half_pi, pi) = (std::f64::consts::FRAC_PI_2, std::f64::consts::PI);
    match function {
        Function::Sin | Function::Cos | Function::Sign => Interval::new(-1.0, 1.0),
        Function::Tanh => x.rising(math::tanh_f64, Interval::new(-1.0, 1.0)),
        Function::Atan => x.rising(math::atan_f64, Interval::new(-half_pi, half_pi)),
        Function::Asin => x.rising(math::asin_f64, Interval::new(-half_pi, half_pi)),
        Function::Acos => Interval::new(0.0, pi),
        Function::Atan2 => Interval::new(-pi, pi),
        Function::Exp => x.rising(math::exp_f64, Interval::new(0.0, f64::INFINITY)),
        Function::Log => x.rising(math::log_f64, Interval::ALL),
        Function::Sqrt => x.rising(math::sqrt_f64, Interval::new(0.0, f64::INFINITY)),
        Function::Abs => Interval::new(x.least(), x.magnitude()),
        Function::Min | Function::Max => x.union(ranges[1]),
        Function::Tan | Function::Pow => Interval::ALL,
        _ => further::enclose(function, ranges).unwrap_or(Interval::ALL),
    }
}

/// The derivative with respect to a symbol; `None` where none is known in closed form.
pub fn derivative(poly: &Poly, symbol: Symbol) -> Option<Poly> {
    let mut sum = Poly::default();
    for (monomial, coefficient) in poly.terms() {
        for (atom, exponent) in monomial.factors() {
            let inner = derivative_of_atom(atom, symbol)?;
            if inner.is_zero() {
                continue;
            }
            let outer =
                Poly::from(coefficient.clone()).times(&Poly::monomial(monomial.clone(), RBig::from(*exponent))).ok()?;
            let lowered = outer.times(&Poly::from(atom.clone()).power(-1).ok()?).ok()?;
            sum = sum.plus(&lowered.times(&inner).ok()?).ok()?;
        }
    }
    Some(sum)
}

fn derivative_of_atom(atom: &Atom, symbol: Symbol) -> Option<Poly> {
    match atom {
        Atom::Pi => Some(Poly::default()),
        Atom::Symbol(found) => Some(Poly::from(RBig::from(i32::from(*found == symbol)))),
        Atom::Reciprocal(sum) => {
            let square = Poly::from(atom.clone()).power(2).ok()?.negated();
            derivative(sum, symbol)?.times(&square).ok()
        }
        Atom::Call(function, arguments) => {
            let inner = arguments.iter().map(|a| derivative(a, symbol)).collect::<Option<Vec<_>>>()?;
            if inner.iter().all(Poly::is_zero) {
                return Some(Poly::default());
            }
            match (function, arguments.as_slice()) {
                (Function::Hypot, [a, b]) => {
                    let product = a.times(&inner[0]).ok()?.plus(&b.times(&inner[1]).ok()?).ok()?;
                    product.times(&Poly::from(atom.clone()).reciprocal().ok()?).ok()
                }
                (_, [argument]) => slope_of_call(*function, argument)?.times(&inner[0]).ok(),
                _ => None,
            }
        }
    }
}

/// The derivative of a function of one argument, at that argument.
fn slope_of_call(function: Function, x: &Poly) -> Option<Poly> {
    let call = |f: Function| Poly::from(Atom::Call(f, vec![x.clone()]));
    let one = || Poly::from(RBig::ONE);
    match function {
        Function::Sin => Some(call(Function::Cos)),
        Function::Cos => Some(call(Function::Sin).negated()),
        Function::Exp => Some(call(Function::Exp)),
        Function::Log => x.reciprocal().ok(),
        Function::Sqrt => call(Function::Sqrt).times(&Poly::from(RBig::from(2))).ok()?.reciprocal().ok(),
        Function::Tanh => one().plus(&call(Function::Tanh).power(2).ok()?.negated()).ok(),
        Function::Atan => one().plus(&x.power(2).ok()?).ok()?.reciprocal().ok(),
        Function::Tan => one().plus(&call(Function::Tan).power(2).ok()?).ok(),
        Function::Abs => Some(call(Function::Sign)),
        _ => further::slope(function, x),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn q() -> Poly {
        Poly::from(Atom::Symbol(Symbol::State(0)))
    }

    /// Powers are as narrow as their sign allows, and gigantic ones take no time.
    #[test]
    fn powers_are_enclosed() {
        let range = Interval::new(-2.0, 1.0);
        assert_eq!(range.power(2), Interval::new(0.0, 4.0));
        assert_eq!(range.power(3), Interval::new(-8.0, 4.0));
        assert_eq!(Interval::new(-2.0, -1.0).power(5), Interval::new(-32.0, -1.0));
        assert_eq!(range.power(1 << 30).high, f64::INFINITY);
    }

    /// The slope of a sine is at most one wherever the angle goes.
    #[test]
    fn a_sine_has_slope_one() {
        let sine = Poly::from(Atom::Call(Function::Sin, vec![q()]));
        let slope = enclose(&derivative(&sine, Symbol::State(0)).unwrap(), &|_| Interval::ALL);
        assert_eq!(slope.magnitude(), 1.0);
    }

    /// A cube's slope depends on the range, and is unbounded without one.
    #[test]
    fn a_cube_needs_a_range() {
        let slope = derivative(&q().power(3).unwrap(), Symbol::State(0)).unwrap();
        assert_eq!(enclose(&slope, &|_| Interval::new(-2.0, 1.0)).magnitude(), 12.0);
        assert_eq!(enclose(&slope, &|_| Interval::ALL).magnitude(), f64::INFINITY);
    }
}
