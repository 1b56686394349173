//! Whether the equations agree with the units that are written beside them.
//!
//! A number in a product, `t`, and a quantity without a unit, may carry any unit: what they stand in is not checked. `0.5*v`
//! may be a rate times a speed; `1/tau` has no number but the one above the line. Beside such numbers a factor may have been
//! left out because it is 1, as in `force - 0.8*v`: another kind of quantity is no mistake there, but another size is.

use std::collections::BTreeMap;
use std::ops::Range;

use dashu_ratio::RBig;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::parse::{self, Expr, Kind};
use crate::expr::unit::{Unit, Unreadable};
use crate::spec::{Named, Quantity, Spec, Text};

/// Pushes what does not agree; for a specification whose expressions can be read.
pub(super) fn check(spec: &Spec, found: &mut Vec<Diagnostic>) {
    let mut units = Units::read(spec, found);
    for parameter in &spec.parameters {
        if let Quantity::Expression(text) = &parameter.value {
            units.relate(&parameter.named, text, Relation::Value);
        }
    }
    let change = if spec.discrete { Relation::Next } else { Relation::Derivative };
    for state in &spec.states {
        if let Some(text) = &state.change {
            units.relate(&state.named, text, change);
        }
    }
    for output in &spec.outputs {
        if let Some(text) = &output.value {
            units.relate(&output.named, text, Relation::Value);
        }
    }
    units.found.extend(alone(spec, &units.found));
    found.append(&mut units.found);
}

/// The one state, input or output without a unit, where no equation said already what it should be.
fn alone(spec: &Spec, found: &[Diagnostic]) -> Option<Diagnostic> {
    let signals = spec.states.iter().map(|s| &s.named).chain(spec.inputs.iter().map(|u| &u.named));
    let signals: Vec<&Named> = signals.chain(spec.outputs.iter().map(|y| &y.named)).collect();
    let [named] = signals.iter().filter(|named| named.unit.is_empty()).collect::<Vec<_>>()[..] else { return None };
    let said = found.iter().any(|d| d.labels[0].span == named.name.span);
    if said || signals.len() < 2 {
        return None;
    }
    let message = format!("`{}` has no unit, and every other state, input and output has one", named.name.value);
    let help = "write its `unit`, `1` for a number: without it, what it stands in is not checked";
    Some(Diagnostic::warning(codes::UNITS, named.name.span.clone(), message).help(help))
}

/// How an expression belongs to what it is written for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Relation {
    /// It is the thing's value.
    Value,
    /// It is the thing's value at the next sample.
    Next,
    /// It is the thing's derivative by time.
    Derivative,
}

impl Relation {
    /// What the expression is called.
    fn of(self, name: &str) -> String {
        match self {
            Self::Value => format!("the value of `{name}`"),
            Self::Next => format!("the next `{name}`"),
            Self::Derivative => format!("the derivative of `{name}`"),
        }
    }
}

struct Units<'a> {
    known: BTreeMap<&'a str, Unit>,
    found: Vec<Diagnostic>,
}

/// An expression on its way: where it stands, and the unit where one is known.
struct Walk<'a, 'b> {
    units: &'b mut Units<'a>,
    text: &'b Text,
    /// Whether a number stands in it that may carry a unit.
    numbers: bool,
}

impl<'a> Units<'a> {
    /// The units of all names; a text that is no unit is a warning, once.
    fn read(spec: &'a Spec, found: &mut Vec<Diagnostic>) -> Self {
        let mut unread: Vec<&str> = Vec::new();
        let mut known = BTreeMap::new();
        for named in everything(spec).filter(|named| !named.unit.is_empty()) {
            match Unit::parse(&named.unit) {
                Ok(unit) => drop(known.insert(named.name.value.as_str(), unit)),
                Err(why) => found.extend(first_time(&named.unit, &mut unread).then(|| not_read(named, why))),
            }
        }
        for output in &spec.outputs {
            if let Err(why) = Unit::parse(&output.named.unit) {
                found.extend(first_time(&output.named.unit, &mut unread).then(|| not_read(&output.named, why)));
            }
        }
        Self { known, found: Vec::new() }
    }

    /// Compares an expression with what it is written for.
    fn relate(&mut self, named: &Named, text: &Text, relation: Relation) {
        let Ok(expr) = parse::parse(&text.value) else { return };
        let numbers = has_number(&expr);
        let Some(unit) = (Walk { units: self, text, numbers }).term(&expr) else { return };
        let per = if relation == Relation::Derivative { (-1, 1) } else { (0, 1) };
        let second = Unit::word("s");
        let Ok(own) = Unit::parse(&named.unit) else { return };
        if named.unit.is_empty() {
            if let Some(own) = unit.times(&second, (-per.0, 1)).filter(|own| !numbers && *own != Unit::default()) {
                self.found.push(missing(named, &own, &unit, relation));
            }
            return;
        }
        let Some(wanted) = own.times(&second, per) else { return };
        if wanted.si() != unit.si() {
            let error = differs(named, relation, (&wanted, &unit), (&expr, text, numbers));
            let named_here = match &expr.kind {
                Kind::Name(name) if name != "t" => Some(name),
                _ => None,
            };
            let help = || way_out(&expr, text, (&unit, &wanted), named_here.map(String::as_str));
            self.found.extend(error.map(|error| error.help(help())));
        }
    }
}

/// Whether a text has not been seen before.
fn first_time<'a>(text: &'a str, seen: &mut Vec<&'a str>) -> bool {
    let new = !seen.contains(&text);
    seen.push(text);
    new
}

/// Whatever expressions may name.
fn everything(spec: &Spec) -> impl Iterator<Item = &Named> {
    let signals = spec.states.iter().map(|s| &s.named).chain(spec.inputs.iter().map(|u| &u.named));
    let rest = spec.unknowns.iter().chain(spec.disturbances.iter().map(|d| &d.named));
    spec.parameters.iter().map(|p| &p.named).chain(signals).chain(rest)
}

impl Walk<'_, '_> {
    /// The unit of what is added or compared: a function's value alone stands for one with a factor 1, in any unit.
    fn term(&mut self, expr: &Expr) -> Option<Unit> {
        self.unit(expr).filter(|_| !is_bare(expr))
    }

    /// The unit of an expression; `None` where it may be any.
    fn unit(&mut self, expr: &Expr) -> Option<Unit> {
        match &expr.kind {
            Kind::Number(_) => None,
            Kind::Name(name) if name == "pi" => Some(Unit::default()),
            Kind::Name(name) => self.units.known.get(name.as_str()).cloned(),
            Kind::Negative(inner) => self.unit(inner),
            Kind::Sum(terms) => self.alike(terms.iter().map(|(_, term)| term), "what is added"),
            Kind::Product(factors) => self.product(factors),
            Kind::Power(base, exponent) => self.power(base, exponent),
            Kind::Call(name, arguments) => self.call(name, arguments),
        }
    }

    fn product(&mut self, factors: &[(bool, Expr)]) -> Option<Unit> {
        let units: Vec<Option<Unit>> = factors.iter().map(|(_, factor)| self.unit(factor)).collect();
        let mut product = Unit::default();
        for (place, ((divided, factor), unit)) in factors.iter().zip(units).enumerate() {
            let above_the_line = place == 0 && !divided && factors[1..].iter().all(|(divided, _)| *divided);
            if above_the_line && matches!(&factor.kind, Kind::Number(one) if *one == RBig::ONE) {
                continue;
            }
            product = product.times(&unit?, (if *divided { -1 } else { 1 }, 1))?;
        }
        Some(product)
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<Unit> {
        let unit = self.unit(base);
        if let Some(power) = constant(exponent) {
            return Unit::default().times(&unit?, power);
        }
        self.number(exponent, "an exponent");
        None
    }

    fn call(&mut self, name: &str, arguments: &[Expr]) -> Option<Unit> {
        match (name, arguments) {
            ("sqrt", [of]) => Unit::default().times(&self.unit(of)?, (1, 2)),
            ("cbrt", [of]) => Unit::default().times(&self.unit(of)?, (1, 3)),
            ("abs" | "floor", [of]) => self.unit(of),
            ("sign", [of]) => self.unit(of).map(|_| Unit::default()),
            ("min" | "max" | "hypot" | "clamp", several) => {
                self.alike(several.iter(), &format!("what `{name}` compares"))
            }
            ("atan2", several) => {
                let _ = self.alike(several.iter(), "what `atan2` compares");
                Some(Unit::default())
            }
            (_, several) => {
                for argument in several {
                    self.number(argument, &format!("the argument of `{name}`"));
                }
                Some(Unit::default())
            }
        }
    }

    /// Says where something that must be a number, or an angle in radians, is not.
    fn number(&mut self, expr: &Expr, what: &str) {
        let Some(unit) = self.unit(expr) else { return };
        let number = Unit::default();
        if unit.si() == number.si() {
            return;
        }
        let wanted = if unit.si().is_number() { Unit::word("rad") } else { number };
        let kind = if unit.si().is_number() { "rad" } else { "a number" };
        let message = format!("{what} must be {kind}, and `{}` is in {unit}", self.text_of(expr));
        let error = mistake((&unit, &wanted), has_number(expr), self.text.place(expr.span.clone()), message);
        let help = || way_out(expr, self.text, (&unit, &wanted), None);
        self.units.found.extend(error.map(|error| error.help(help())));
    }

    /// The one unit of several parts: that of the first which has one.
    fn alike<'e>(&mut self, parts: impl Iterator<Item = &'e Expr>, what: &str) -> Option<Unit> {
        let mut first: Option<(&Expr, Unit)> = None;
        for part in parts {
            match (self.term(part), &first) {
                (Some(unit), None) => first = Some((part, unit)),
                (Some(unit), Some((other, wanted))) if unit.si() != wanted.si() => {
                    let (this, that) = (self.text_of(part), self.text_of(other));
                    let message = format!("{what} must be in one unit: `{that}` is in {wanted}, `{this}` in {unit}");
                    let error = mistake((&unit, wanted), self.numbers, self.text.place(part.span.clone()), message);
                    let help = || way_out(part, self.text, (&unit, wanted), None);
                    self.units.found.extend(error.map(|error| error.help(help())));
                    return None;
                }
                _ => {}
            }
        }
        first.map(|(_, unit)| unit)
    }

    fn text_of(&self, expr: &Expr) -> String {
        written(expr, self.text)
    }
}

/// Whether a product has a number in it that may carry a unit.
fn has_number(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) | Kind::Name(_) => false,
        Kind::Sum(terms) => terms.iter().any(|(_, term)| matches!(term.kind, Kind::Number(_)) || has_number(term)),
        Kind::Product(factors) => {
            let above = |place: usize| place == 0 && factors[1..].iter().all(|(divided, _)| *divided);
            let carries = |(place, (_, factor)): (usize, &(bool, Expr))| {
                matches!(&factor.kind, Kind::Number(value) if !(above(place) && *value == RBig::ONE))
                    || has_number(factor)
            };
            factors.iter().enumerate().any(carries)
        }
        Kind::Negative(inner) | Kind::Power(inner, _) => has_number(inner),
        Kind::Call(_, arguments) => arguments.iter().any(has_number),
    }
}

/// Whether nothing but numbers and functions of something stands in a product.
fn is_bare(expr: &Expr) -> bool {
    match &expr.kind {
        Kind::Number(_) => true,
        Kind::Call(name, _) => {
            !matches!(name.as_str(), "sqrt" | "cbrt" | "abs" | "floor" | "min" | "max" | "hypot" | "clamp")
        }
        Kind::Negative(inner) | Kind::Power(inner, _) => is_bare(inner),
        Kind::Product(factors) => factors.iter().all(|(_, factor)| is_bare(factor)),
        Kind::Name(_) | Kind::Sum(_) => false,
    }
}

fn written(expr: &Expr, text: &Text) -> String {
    text.value.get(expr.span.clone()).unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A rational exponent.
fn constant(exponent: &Expr) -> Option<(i32, i32)> {
    match &exponent.kind {
        Kind::Number(value) => {
            let (over, under) = (value.numerator().clone(), value.denominator().clone());
            Some((over.try_into().ok()?, under.try_into().ok()?))
        }
        Kind::Negative(inner) => constant(inner).map(|(over, under)| (-over, under)),
        Kind::Product(factors) => match factors.as_slice() {
            [(false, over), (true, under)] => {
                let ((a, b), (c, d)) = (constant(over)?, constant(under)?);
                Some((a.checked_mul(d)?, b.checked_mul(c).filter(|under| *under > 0)?))
            }
            _ => None,
        },
        _ => None,
    }
}

/// An error; a warning where a word that is a unit of its own decides, since it may be another's name; none where a factor
/// 1 may have been left out.
fn mistake((unit, wanted): (&Unit, &Unit), numbers: bool, span: Range<usize>, message: String) -> Option<Diagnostic> {
    let (unit, wanted) = (unit.si(), wanted.si());
    let level = if unit.has_own() || wanted.has_own() { Diagnostic::warning } else { Diagnostic::error };
    (!numbers || unit.alike(&wanted)).then(|| level(codes::UNITS, span, message))
}

fn differs(
    named: &Named,
    relation: Relation,
    (wanted, unit): (&Unit, &Unit),
    (expr, text, numbers): (&Expr, &Text, bool),
) -> Option<Diagnostic> {
    let name = &named.name.value;
    let message = format!(
        "{} must be in {wanted}, since `{name}` is in {}, and `{}` is in {unit}",
        relation.of(name),
        named.unit,
        super::words::shortened(written(expr, text))
    );
    mistake((unit, wanted), numbers, text.place(expr.span.clone()), message)
}

/// What to write: a factor where the units are of one kind.
fn way_out(expr: &Expr, text: &Text, (unit, wanted): (&Unit, &Unit), named: Option<&str>) -> String {
    let instead = named.map_or_else(String::new, |name| format!(", or another unit for `{name}`"));
    let Some((size, pi)) = unit.si().in_terms_of(&wanted.si()) else {
        return format!("{unit} is not {wanted} in other words: look at the factors and their units{instead}");
    };
    let product = matches!(expr.kind, Kind::Sum(_) | Kind::Negative(_));
    let of = written(expr, text);
    let of = if product { format!("({of})") } else { of };
    format!("1 {unit} is {} {wanted}: write `{}`{instead}", factor("1", &size, pi), factor(&of, &size, pi))
}

/// `of` times a rational and a power of pi.
fn factor(of: &str, size: &RBig, pi: i32) -> String {
    let circle = match pi.abs() {
        0 => None,
        1 => Some("pi".to_owned()),
        power => Some(format!("pi^{power}")),
    };
    let (over, under) = (size.numerator().to_string(), size.denominator().to_string());
    let above =
        [of.to_owned(), over].into_iter().chain(circle.clone().filter(|_| pi > 0)).filter(|factor| factor != "1");
    let below = std::iter::once(under).chain(circle.filter(|_| pi < 0)).filter(|factor| factor != "1");
    let above = above.collect::<Vec<_>>().join("*");
    let above = if above.is_empty() { "1".to_owned() } else { above };
    std::iter::once(above).chain(below).collect::<Vec<_>>().join("/")
}

fn missing(named: &Named, own: &Unit, unit: &Unit, relation: Relation) -> Diagnostic {
    let name = &named.name.value;
    let message = format!("`{name}` has no unit, and {} is in {unit}", relation.of(name));
    let warning = Diagnostic::warning(codes::UNITS, named.name.span.clone(), message);
    warning.help(format!("write `unit = \"{own}\"`: without it, what `{name}` stands in is not checked"))
}

fn not_read(named: &Named, why: Unreadable) -> Diagnostic {
    let unit = &named.unit;
    let (message, help) = match why {
        Unreadable::TwoWays => (
            format!("the unit `{unit}` of `{}` can be read in two ways", named.name.value),
            "write `a/(b c)` or `a c/b`; until then it is not checked",
        ),
        Unreadable::NoUnit => (
            format!("the unit `{unit}` of `{}` cannot be read", named.name.value),
            "write words with powers, such as `rad/(V s^2)` or `kg m^2`; `1` for a number; until then it is not checked",
        ),
    };
    Diagnostic::warning(codes::UNITS, named.name.span.clone(), message).help(help)
}
