//! The canonical form of an expression: a polynomial with rational coefficients over atoms.
//!
//! Two expressions that are equal by the laws of arithmetic have the same form, so that a linear
//! right-hand side is recognised however it is written, and what cancels is gone. Sizes are
//! bounded; what would not fit is refused.

use std::collections::{BTreeMap, BTreeSet};

use dashu_base::{BitTest as _, Signed as _};
use dashu_ratio::RBig;

use super::{Function, Symbol, further};
use crate::decimal;
use crate::real::{Precision, Real, Undefined};

/// Most monomials of one expression.
const MAX_TERMS: usize = 400;
/// Most bits of a coefficient's numerator or denominator.
const MAX_BITS: usize = 8_192;
/// Most atoms of one expression, those inside functions too.
const MAX_ATOMS: usize = 8_000;
/// Deepest nesting of functions and reciprocals, through parameters too.
const MAX_NESTING: usize = 64;
/// Largest whole power that is expanded.
pub const MAX_POWER: i32 = 64;

/// What a monomial multiplies.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Atom {
    /// The circle's constant.
    Pi,
    /// A function of constants or of what varies.
    Call(Function, Vec<Poly>),
    /// One over a sum.
    Reciprocal(Poly),
    /// What varies.
    Symbol(Symbol),
}

/// A product of powers of atoms, in the atoms' order; empty for 1.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(Vec<(Atom, i32)>);

/// A sum of monomials with rational coefficients, none of them zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Poly(BTreeMap<Monomial, RBig>);

/// Why an expression has no canonical form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PolyError {
    /// More terms or digits than are worked with; says how many.
    TooLarge(String),
    /// A division by exactly zero.
    DivisionByZero,
}

impl Monomial {
    /// A power of one atom.
    pub fn of(atom: Atom, exponent: u32) -> Self {
        Self(vec![(atom, i32::try_from(exponent).unwrap_or(i32::MAX))])
    }

    /// The atoms with their exponents.
    pub fn factors(&self) -> &[(Atom, i32)] {
        &self.0
    }

    fn times(&self, other: &Self) -> Result<Self, PolyError> {
        let mut powers: BTreeMap<Atom, i32> = self.0.iter().cloned().collect();
        for (atom, exponent) in &other.0 {
            let sum = powers.entry(atom.clone()).or_insert(0);
            *sum = sum.checked_add(*exponent).ok_or_else(too_many_powers)?;
        }
        powers.retain(|_, exponent| *exponent != 0);
        Ok(Self(powers.into_iter().collect()))
    }

    fn power(&self, exponent: i32) -> Result<Self, PolyError> {
        let raised = |e: i32| e.checked_mul(exponent).ok_or_else(too_many_powers);
        self.0.iter().map(|(atom, e)| Ok((atom.clone(), raised(*e)?))).collect::<Result<_, _>>().map(Self)
    }

    /// Whether nothing in it varies.
    pub fn is_constant(&self) -> bool {
        self.0.iter().all(|(atom, _)| match atom {
            Atom::Pi => true,
            Atom::Symbol(_) => false,
            Atom::Call(_, arguments) => arguments.iter().all(Poly::is_constant),
            Atom::Reciprocal(sum) => sum.is_constant(),
        })
    }

    /// Splits into the constant part and the part that varies.
    pub fn split(&self) -> (Self, Self) {
        let constant = |entry: &&(Atom, i32)| Self(vec![(*entry).clone()]).is_constant();
        let (fixed, varying): (Vec<_>, Vec<_>) = self.0.iter().partition(constant);
        (Self(fixed.into_iter().cloned().collect()), Self(varying.into_iter().cloned().collect()))
    }

    /// The other factors, when a symbol is one to the power 1.
    pub fn without(&self, symbol: Symbol) -> Option<Self> {
        let this = |entry: &&(Atom, i32)| **entry == (Atom::Symbol(symbol), 1);
        self.0.iter().find(this)?;
        Some(Self(self.0.iter().filter(|entry| !this(entry)).cloned().collect()))
    }

    /// The symbol, when the monomial is exactly that.
    pub fn as_symbol(&self) -> Option<Symbol> {
        match self.0.as_slice() {
            [(Atom::Symbol(symbol), 1)] => Some(*symbol),
            _ => None,
        }
    }

    fn collect_symbols(&self, into: &mut BTreeSet<Symbol>) {
        for (atom, _) in &self.0 {
            match atom {
                Atom::Pi => {}
                Atom::Symbol(symbol) => drop(into.insert(*symbol)),
                Atom::Call(_, arguments) => arguments.iter().for_each(|a| a.collect_symbols(into)),
                Atom::Reciprocal(sum) => sum.collect_symbols(into),
            }
        }
    }

    /// Everything that varies in it.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = BTreeSet::new();
        self.collect_symbols(&mut symbols);
        symbols
    }
}

fn too_many_powers() -> PolyError {
    PolyError::TooLarge("a power beyond 2^31".into())
}

impl From<RBig> for Poly {
    fn from(value: RBig) -> Self {
        let mut terms = BTreeMap::new();
        if !value.is_zero() {
            terms.insert(Monomial::default(), value);
        }
        Self(terms)
    }
}

impl From<Atom> for Poly {
    fn from(atom: Atom) -> Self {
        Self(BTreeMap::from([(Monomial(vec![(atom, 1)]), RBig::ONE)]))
    }
}

impl Poly {
    /// The monomials with their coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &RBig)> {
        self.0.iter()
    }

    /// Whether it is nothing at all.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether nothing in it varies.
    pub fn is_constant(&self) -> bool {
        self.0.keys().all(Monomial::is_constant)
    }

    /// The value, when it is a rational number.
    pub fn as_rational(&self) -> Option<RBig> {
        match self.0.iter().next() {
            None => Some(RBig::ZERO),
            Some((monomial, value)) if self.0.len() == 1 && monomial.0.is_empty() => Some(value.clone()),
            Some(_) => None,
        }
    }

    fn as_monomial(&self) -> Option<(&Monomial, &RBig)> {
        if self.0.len() == 1 { self.0.iter().next() } else { None }
    }

    /// Everything that varies in it.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = BTreeSet::new();
        self.collect_symbols(&mut symbols);
        symbols
    }

    fn collect_symbols(&self, into: &mut BTreeSet<Symbol>) {
        self.0.keys().for_each(|monomial| monomial.collect_symbols(into));
    }

    /// One monomial times a coefficient.
    pub fn monomial(monomial: Monomial, coefficient: RBig) -> Self {
        if coefficient.is_zero() { Self::default() } else { Self(BTreeMap::from([(monomial, coefficient)])) }
    }

    /// `self + other`.
    pub fn plus(mut self, other: &Self) -> Result<Self, PolyError> {
        for (monomial, value) in &other.0 {
            let sum = self.0.entry(monomial.clone()).or_insert(RBig::ZERO);
            *sum += value;
            if sum.is_zero() {
                self.0.remove(monomial);
            }
        }
        self.bounded()
    }

    /// `-self`.
    #[must_use]
    pub fn negated(mut self) -> Self {
        for value in self.0.values_mut() {
            *value = -std::mem::replace(value, RBig::ZERO);
        }
        self
    }

    /// `self * other`.
    pub fn times(&self, other: &Self) -> Result<Self, PolyError> {
        if self.0.len().saturating_mul(other.0.len()) > MAX_TERMS * 8 {
            return Err(PolyError::TooLarge(format!("{} times {} terms", self.0.len(), other.0.len())));
        }
        let mut product: BTreeMap<Monomial, RBig> = BTreeMap::new();
        for (a, x) in &self.0 {
            for (b, y) in &other.0 {
                *product.entry(a.times(b)?).or_insert(RBig::ZERO) += x * y;
            }
        }
        product.retain(|_, value| !value.is_zero());
        Self(product).bounded()
    }

    /// `1 / self`.
    pub fn reciprocal(&self) -> Result<Self, PolyError> {
        if self.is_zero() {
            return Err(PolyError::DivisionByZero);
        }
        match self.as_monomial() {
            Some((monomial, value)) => Ok(Self::monomial(monomial.power(-1)?, RBig::ONE / value)),
            None => Self::from(Atom::Reciprocal(self.clone())).bounded(),
        }
    }

    /// A function of expressions.
    pub fn call(function: Function, arguments: Vec<Self>) -> Result<Self, PolyError> {
        match fold_call(function, &arguments) {
            Some(value) => Ok(value.into()),
            None => Self::from(Atom::Call(function, arguments)).bounded(),
        }
    }

    /// `self ^ exponent` for a whole exponent between -64 and 64.
    pub fn power(&self, exponent: i32) -> Result<Self, PolyError> {
        let base = if exponent < 0 { self.reciprocal()? } else { self.clone() };
        if exponent.unsigned_abs() > MAX_POWER.unsigned_abs() {
            return Err(PolyError::TooLarge(format!("the power {exponent}; at most {MAX_POWER} is expanded")));
        }
        let mut product = Self::from(RBig::ONE);
        for _ in 0..exponent.unsigned_abs() {
            product = product.times(&base)?;
        }
        Ok(product)
    }

    fn bounded(self) -> Result<Self, PolyError> {
        if self.0.len() > MAX_TERMS {
            return Err(PolyError::TooLarge(format!("{} terms; at most {MAX_TERMS} are kept", self.0.len())));
        }
        self.count(&mut 0, 0)?;
        let bits = |value: &RBig| value.numerator().bit_len().max(value.denominator().bit_len());
        match self.0.values().map(bits).max() {
            Some(most) if most > MAX_BITS => Err(PolyError::TooLarge(format!("a constant of {most} bits"))),
            _ => Ok(self),
        }
    }

    /// Counts the atoms, and gives up at the first too many or too deep.
    fn count(&self, atoms: &mut usize, depth: usize) -> Result<(), PolyError> {
        if depth > MAX_NESTING {
            return Err(PolyError::TooLarge(format!("functions nest deeper than {MAX_NESTING}")));
        }
        for (atom, _) in self.0.keys().flat_map(Monomial::factors) {
            *atoms += 1;
            if *atoms > MAX_ATOMS {
                return Err(PolyError::TooLarge(format!("more than {MAX_ATOMS} names and functions, written out")));
            }
            match atom {
                Atom::Pi | Atom::Symbol(_) => {}
                Atom::Reciprocal(sum) => sum.count(atoms, depth + 1)?,
                Atom::Call(_, arguments) => arguments.iter().try_for_each(|a| a.count(atoms, depth + 1))?,
            }
        }
        Ok(())
    }

    /// Divides by its leading coefficient; gives the monic polynomial and that coefficient.
    pub fn monic(&self) -> (Self, RBig) {
        let Some((_, leading)) = self.0.iter().next_back() else { return (Self::default(), RBig::ONE) };
        let leading = leading.clone();
        (Self(self.0.iter().map(|(m, v)| (m.clone(), v / &leading)).collect()), leading)
    }
}

/// A polynomial in which nothing varies: a number known as exactly as asked.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Constant(Poly);

/// A constant outside the domain of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DomainError(pub String);

impl TryFrom<Poly> for Constant {
    type Error = Poly;

    fn try_from(poly: Poly) -> Result<Self, Poly> {
        if poly.is_constant() { Ok(Self(poly)) } else { Err(poly) }
    }
}

impl From<RBig> for Constant {
    fn from(value: RBig) -> Self {
        Self(value.into())
    }
}

impl Constant {
    /// One.
    pub fn one() -> Self {
        Self::from(RBig::ONE)
    }

    /// Whether it is structurally nothing.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// The value, when it is rational.
    pub fn as_rational(&self) -> Option<RBig> {
        self.0.as_rational()
    }

    /// The polynomial.
    pub fn poly(&self) -> &Poly {
        &self.0
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Result<Self, PolyError> {
        self.0.clone().plus(&other.0).map(Self)
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Result<Self, PolyError> {
        self.0.clone().plus(&other.0.clone().negated()).map(Self)
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Result<Self, PolyError> {
        self.0.times(&other.0).map(Self)
    }

    /// The quotient.
    pub fn over(&self, other: &Self) -> Result<Self, PolyError> {
        self.0.times(&other.0.reciprocal()?).map(Self)
    }

    /// The value at a precision, to a few units of its last bit.
    pub fn evaluate(&self, precision: Precision) -> Result<Real, DomainError> {
        evaluate(&self.0, precision)
    }

    /// The nearest double.
    pub fn to_f64(&self) -> Result<f64, DomainError> {
        Ok(self.evaluate(Precision::bits(160))?.to_f64())
    }
}

/// Bits of a result that rounding may have spoiled: what is smaller than its parts by all other
/// bits is zero, at every precision alike.
const SPOILED_BITS: i64 = 24;

/// Zero, when `value` is nothing but the rounding of parts as large as `2^top`.
pub(super) fn without_rounding(value: Real, top: Option<i64>) -> Real {
    let bits = i64::try_from(value.precision().as_bits()).unwrap_or(i64::MAX);
    match (value.top(), top) {
        (Some(own), Some(top)) if own < top - bits + SPOILED_BITS => Real::zero(value.precision()),
        _ => value,
    }
}

fn evaluate(poly: &Poly, precision: Precision) -> Result<Real, DomainError> {
    let mut sum = Real::zero(precision);
    let mut largest = None;
    for (monomial, coefficient) in poly.terms() {
        let mut term = Real::from_rational(coefficient, precision);
        for (atom, exponent) in monomial.factors() {
            let value = evaluate_atom(atom, precision)?;
            let power = value
                .checked_powi(i64::from(*exponent))
                .map_err(|_| DomainError("a division by zero, or a power too large".into()))?;
            term = &term * &power;
        }
        largest = largest.max(term.top());
        sum = &sum + &term;
    }
    Ok(without_rounding(sum, largest))
}

fn evaluate_atom(atom: &Atom, precision: Precision) -> Result<Real, DomainError> {
    match atom {
        Atom::Pi => Ok(Real::pi(precision)),
        Atom::Symbol(_) => unreachable!("a constant has no symbol"),
        Atom::Reciprocal(sum) => Real::one(precision)
            .checked_div(&evaluate(sum, precision)?)
            .map_err(|_| DomainError("a division by zero".into())),
        Atom::Call(function, arguments) => {
            let values = arguments.iter().map(|a| evaluate(a, precision)).collect::<Result<Vec<_>, _>>()?;
            call(*function, &values).map_err(|why| {
                let shown: Vec<String> = values.iter().map(|v| decimal::show(v.to_f64())).collect();
                let text = match (function, shown.as_slice()) {
                    (Function::Pow, [base, exponent]) => format!("({base})^({exponent})"),
                    _ => format!("{}({})", function.name(), shown.join(", ")),
                };
                DomainError(match why {
                    Undefined::OutsideDomain => format!("{text} is not a real number"),
                    Undefined::OutOfRange => format!("{text} is too large or too small to compute with"),
                })
            })
        }
    }
}

/// A function at constants. At a zero or a pole the rounding of the argument is all that is left
/// (`sin(pi)`, `acos(sqrt(2)^2/2)`); it is taken off, so that the outcome is that of every precision.
fn call(function: Function, values: &[Real]) -> Result<Real, Undefined> {
    let x = &values[0];
    let one = Some(1);
    // Below 1 a sine is as precise as its argument.
    let around = x.top().filter(|top| *top > 0);
    Ok(match function {
        Function::Sin => without_rounding(x.checked_sin()?, around),
        Function::Cos => without_rounding(x.checked_cos()?, around),
        Function::Tan => {
            let (sine, cosine) = (call(Function::Sin, values)?, call(Function::Cos, values)?);
            if cosine.is_zero() {
                return Err(Undefined::OutsideDomain);
            }
            if sine.is_zero() { sine } else { x.checked_tan()? }
        }
        Function::Asin => at_most_one(x).checked_asin()?,
        Function::Acos => at_most_one(x).checked_acos()?,
        Function::Atan => x.checked_atan()?,
        Function::Atan2 => x.checked_atan2(&values[1])?,
        Function::Exp => x.checked_exp()?,
        Function::Log => without_rounding(x.checked_ln()?, one),
        Function::Sqrt => x.checked_sqrt()?,
        Function::Tanh => x.tanh(),
        Function::Pow => x.checked_powf(&values[1])?,
        Function::Abs => x.abs(),
        Function::Sign => Real::from_i64(
            if x.is_zero() {
                0
            } else if x.is_negative() {
                -1
            } else {
                1
            },
            x.precision(),
        ),
        Function::Min => {
            if values[1] < *x {
                values[1].clone()
            } else {
                x.clone()
            }
        }
        Function::Max => {
            if *x < values[1] {
                values[1].clone()
            } else {
                x.clone()
            }
        }
        _ => further::exact(function, values)?.unwrap_or_else(|| unreachable!("every function is here or there")),
    })
}

/// One or minus one, when the value differs from it by rounding only.
fn at_most_one(x: &Real) -> Real {
    let one = Real::one(x.precision());
    let one = if x.is_negative() { -one } else { one };
    if without_rounding(x - &one, Some(1)).is_zero() { one } else { x.clone() }
}

/// A function at rational arguments whose value is rational; `None` when it is not, or not known to be.
fn fold_call(function: Function, arguments: &[Poly]) -> Option<RBig> {
    let values: Vec<RBig> = arguments.iter().map(Poly::as_rational).collect::<Option<_>>()?;
    let x = &values[0];
    match function {
        Function::Abs => Some(if x.is_negative() { -x.clone() } else { x.clone() }),
        Function::Sign if x.is_zero() => Some(RBig::ZERO),
        Function::Sign => Some(if x.is_negative() { -RBig::ONE } else { RBig::ONE }),
        Function::Min => Some(x.clone().min(values[1].clone())),
        Function::Max => Some(x.clone().max(values[1].clone())),
        Function::Sin | Function::Tan | Function::Asin | Function::Atan | Function::Sqrt | Function::Tanh
            if x.is_zero() =>
        {
            Some(RBig::ZERO)
        }
        Function::Cos | Function::Exp if x.is_zero() => Some(RBig::ONE),
        Function::Log if *x == RBig::ONE => Some(RBig::ZERO),
        _ => further::rational(function, &values),
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse::parse;
    use super::super::{Names, resolve};
    use super::*;

    fn value(text: &str, bits: usize) -> Result<f64, DomainError> {
        let names = Names { known: &[], place: &|within| within };
        let node = resolve(&parse(text).unwrap(), &names, &mut Vec::new()).unwrap();
        Constant::try_from(node.poly).unwrap().evaluate(Precision::bits(bits)).map(|value| value.to_f64())
    }

    /// What is zero, or at the edge of a domain, is that at every precision, and not its rounding.
    #[test]
    fn rounding_decides_nothing() {
        for bits in [160, 256, 512, 1024] {
            for text in
                ["sin(pi)", "cos(pi/2)", "sqrt(sin(pi))", "sqrt(2)^2 - 2", "log(sqrt(2)^2/2)", "acos(sqrt(2)^2/2)"]
            {
                assert_eq!(value(text, bits), Ok(0.0), "{text} at {bits} bits");
            }
            for text in ["1/sin(pi)", "tan(pi/2)", "log(sin(pi))", "acos(1.1)", "sqrt(cos(pi))"] {
                assert!(value(text, bits).is_err(), "{text} at {bits} bits");
            }
            assert_eq!(value("sin(1e-100)", bits), Ok(1e-100));
            assert_eq!(value("1e-60 + 0*pi", bits), Ok(1e-60));
        }
    }
}
