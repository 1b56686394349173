//! Names looked up: a tree of nodes, each with its place and its canonical form.
//!
//! The tree keeps the user's own factored form, which is what the step should compute
//! (`(q - 1)^8` expanded would cancel in single precision); the canonical form is what the plant
//! is split by.

use std::collections::BTreeSet;
use std::ops::Range;

use dashu_ratio::RBig;

use super::parse::{Expr, Kind};
use super::poly::{Atom, MAX_POWER, Monomial, Poly, PolyError};
use super::{CLAMP, Constant, Function, Symbol, guess, nearest};
use crate::diagnostic::{Diagnostic, codes};

/// What names mean, and where the expression's text stands in the file.
pub struct Names<'a> {
    /// Name and meaning; a parameter means its value.
    pub known: &'a [(String, Meaning)],
    /// Maps a span of the text to a span of the file.
    pub place: &'a dyn Fn(Range<usize>) -> Range<usize>,
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub enum Meaning {
    /// A constant.
    Parameter(Constant),
    /// A parameter whose line comes later, so that it has no value yet.
    Later,
    /// Something that varies.
    Symbol(Symbol),
}

/// An expression with its names looked up.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// The canonical form.
    pub poly: Poly,
    /// Bytes of the file.
    pub span: Range<usize>,
}

/// The forms of a node. Constant subtrees are folded.
#[derive(Clone, Debug)]
pub enum NodeKind {
    /// Nothing varies in it; the value is the canonical form.
    Constant,
    /// What varies.
    Symbol(Symbol),
    /// Terms; `true` marks a subtracted one.
    Sum(Vec<(bool, Node)>),
    /// Factors; `true` marks a divisor.
    Product(Vec<(bool, Node)>),
    /// A whole power, at least 2.
    Power(Box<Node>, u32),
    /// A function.
    Call(Function, Vec<Node>),
}

/// Looks up the names of an expression and folds its constants; a mistake is pushed and gives `None`.
pub fn resolve(expr: &Expr, names: &Names, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let node = match &expr.kind {
        Kind::Number(value) => {
            Node { kind: NodeKind::Constant, poly: value.clone().into(), span: (names.place)(expr.span.clone()) }
        }
        Kind::Name(name) => resolve_name(name, expr, names, found)?,
        Kind::Sum(terms) => resolve_sum(terms, expr, names, found)?,
        Kind::Product(factors) => resolve_product(factors, expr, names, found)?,
        Kind::Negative(inner) => resolve_sum(std::slice::from_ref(&(true, (**inner).clone())), expr, names, found)?,
        Kind::Power(base, exponent) => resolve_power(base, exponent, expr, names, found)?,
        Kind::Call(name, arguments) => resolve_call(name, arguments, expr, names, found)?,
    };
    Some(fold(node))
}

fn fold(node: Node) -> Node {
    if node.poly.is_constant() { Node { kind: NodeKind::Constant, ..node } } else { node }
}

fn resolve_name(name: &str, expr: &Expr, names: &Names, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let span = (names.place)(expr.span.clone());
    let symbol =
        |symbol| Node { kind: NodeKind::Symbol(symbol), poly: Atom::Symbol(symbol).into(), span: span.clone() };
    let known = names.known.iter().find(|(known, _)| known == name);
    let mistake = match (known, name) {
        (Some((_, Meaning::Parameter(value))), _) => {
            return Some(Node { kind: NodeKind::Constant, poly: value.poly().clone(), span });
        }
        (Some((_, Meaning::Symbol(which))), _) => return Some(symbol(*which)),
        (None, "t") => return Some(symbol(Symbol::Time)),
        (None, "pi") => return Some(Node { kind: NodeKind::Constant, poly: Atom::Pi.into(), span }),
        (Some((_, Meaning::Later)), _) => {
            Diagnostic::error(codes::UNKNOWN_NAME, span, format!("`{name}` has no value yet"))
                .help(format!("a parameter may use those on the lines above it, so `{name}` must come before it"))
        }
        (None, _) => unknown_name(name, span, names),
    };
    // A missing declaration is one mistake, however often the name is used.
    if !found.iter().any(|other| other.code == mistake.code && other.message == mistake.message) {
        found.push(mistake);
    }
    None
}

fn unknown_name(name: &str, span: Range<usize>, names: &Names) -> Diagnostic {
    let diagnostic = Diagnostic::error(codes::UNKNOWN_NAME, span.clone(), format!("`{name}` is not declared"));
    if Function::names().any(|known| known == name) {
        return diagnostic.help(format!("`{name}` is a function: write `{name}(…)`"));
    }
    if name == "e" {
        return diagnostic.help("write `exp(1)`, and powers of it as `exp(…)`");
    }
    let choices = names.known.iter().map(|(known, _)| known.as_str()).chain(["t", "pi"]);
    match nearest(name, choices) {
        Some(close) => diagnostic.help(format!("did you mean `{close}`?")).patch(span, close),
        None => diagnostic.help("declare it under [parameters], [states], [inputs], [unknowns] or [disturbances]"),
    }
}

fn resolve_sum(terms: &[(bool, Expr)], expr: &Expr, names: &Names, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let nodes = resolve_parts(terms, names, found)?;
    let mut total = Ok(Poly::default());
    for (minus, node) in &nodes {
        let term = if *minus { node.poly.clone().negated() } else { node.poly.clone() };
        total = total.and_then(|sum| sum.plus(&term));
    }
    let span = (names.place)(expr.span.clone());
    let poly = refuse(total, &span, found)?;
    Some(Node { kind: NodeKind::Sum(nodes), poly, span })
}

fn resolve_product(factors: &[(bool, Expr)], expr: &Expr, names: &Names, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let nodes = resolve_parts(factors, names, found)?;
    if let Some((_, zero)) = nodes.iter().find(|(divided, node)| *divided && node.poly.is_zero()) {
        found.push(division_by_zero(&zero.span));
        return None;
    }
    let mut total = Ok(Poly::from(RBig::ONE));
    for (divided, node) in &nodes {
        let factor = if *divided { node.poly.reciprocal() } else { Ok(node.poly.clone()) };
        total = total.and_then(|product| product.times(&factor?));
    }
    let span = (names.place)(expr.span.clone());
    let poly = refuse(total, &span, found)?;
    Some(Node { kind: NodeKind::Product(nodes), poly, span })
}

/// Resolves all parts even when one is wrong, so that all mistakes are found.
fn resolve_parts(parts: &[(bool, Expr)], names: &Names, found: &mut Vec<Diagnostic>) -> Option<Vec<(bool, Node)>> {
    let nodes: Vec<Option<(bool, Node)>> =
        parts.iter().map(|(flag, part)| resolve(part, names, found).map(|node| (*flag, node))).collect();
    nodes.into_iter().collect()
}

fn resolve_power(
    base: &Expr,
    exponent: &Expr,
    expr: &Expr,
    names: &Names,
    found: &mut Vec<Diagnostic>,
) -> Option<Node> {
    let (base, exponent) = (resolve(base, names, found), resolve(exponent, names, found));
    let (base, exponent) = (base?, exponent?);
    let span = (names.place)(expr.span.clone());
    let Some(whole) = exponent.poly.as_rational().and_then(|value| small_whole(&value)) else {
        return call(Function::Pow, vec![base, exponent], span, found);
    };
    let poly = refuse(base.poly.power(whole), &span, found)?;
    Some(power(base, whole, poly, span))
}

/// `base ^ whole` as multiplications and at most one division.
fn power(base: Node, whole: i32, poly: Poly, span: Range<usize>) -> Node {
    let raised = match whole.unsigned_abs() {
        1 => base,
        n => Node { kind: NodeKind::Power(Box::new(base), n), poly: poly.clone(), span: span.clone() },
    };
    if whole < 0 { Node { kind: NodeKind::Product(vec![(true, raised)]), poly, span } } else { raised }
}

fn small_whole(value: &RBig) -> Option<i32> {
    let whole: i32 = value.clone().try_into().ok().and_then(|big: dashu_int::IBig| big.try_into().ok())?;
    (whole.abs() <= MAX_POWER).then_some(whole)
}

fn resolve_call(
    name: &str,
    arguments: &[Expr],
    expr: &Expr,
    names: &Names,
    found: &mut Vec<Diagnostic>,
) -> Option<Node> {
    let span = (names.place)(expr.span.clone());
    let nodes: Vec<Option<Node>> = arguments.iter().map(|argument| resolve(argument, names, found)).collect();
    let arity = if name == CLAMP { Some(3) } else { Function::by_name(name).map(|(_, arity)| arity) };
    let Some(arity) = arity else {
        found.push(unknown_function(name, span, names));
        return None;
    };
    if arity != nodes.len() {
        let plural = if arity == 1 { "" } else { "s" };
        let message = format!("`{name}` takes {arity} argument{plural}, {} given", nodes.len());
        let arguments = ["a", "a, b", "x, low, high"][arity - 1];
        let help = format!("write `{name}({arguments})`");
        found.push(Diagnostic::error(codes::EXPRESSION_SYNTAX, span, message).help(help));
        return None;
    }
    let nodes: Vec<Node> = nodes.into_iter().collect::<Option<_>>()?;
    match Function::by_name(name) {
        Some((function, _)) => call(function, nodes, span, found),
        None => clamp(nodes, &span, found),
    }
}

/// `min(max(x, low), high)`: no number stays none.
fn clamp(nodes: Vec<Node>, span: &Range<usize>, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let mut nodes = nodes.into_iter();
    let (x, low, high) = (nodes.next()?, nodes.next()?, nodes.next()?);
    let above = call(Function::Max, vec![x, low], span.clone(), found)?;
    call(Function::Min, vec![fold(above), high], span.clone(), found)
}

fn unknown_function(name: &str, span: Range<usize>, names: &Names) -> Diagnostic {
    let diagnostic = Diagnostic::error(codes::UNKNOWN_NAME, span, format!("there is no function `{name}`"));
    if names.known.iter().any(|(known, _)| known == name) {
        return diagnostic.help(format!("`{name}` is a quantity: write `{name}*(…)` for a product"));
    }
    diagnostic.help(guess::instead_of(name))
}

fn call(function: Function, arguments: Vec<Node>, span: Range<usize>, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let poly = Poly::call(function, arguments.iter().map(|a| a.poly.clone()).collect());
    let poly = refuse(poly, &span, found)?;
    Some(Node { kind: NodeKind::Call(function, arguments), poly, span })
}

fn refuse(result: Result<Poly, PolyError>, span: &Range<usize>, found: &mut Vec<Diagnostic>) -> Option<Poly> {
    let error = match result {
        Ok(poly) => return Some(poly),
        Err(PolyError::DivisionByZero) => division_by_zero(span),
        Err(PolyError::TooLarge(what)) => {
            Diagnostic::error(codes::TOO_LARGE, span.clone(), "the expression is too large to expand").label(what).help(
                "a simpler expression: sums are multiplied out, and parameters written out, to find what is linear",
            )
        }
    };
    found.push(error);
    None
}

fn division_by_zero(span: &Range<usize>) -> Diagnostic {
    Diagnostic::error(codes::DOMAIN, span.clone(), "a division by zero").label("this is 0")
}

impl Node {
    /// Everything that is written in it, also what cancels.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        match &self.kind {
            NodeKind::Constant => BTreeSet::new(),
            NodeKind::Symbol(symbol) => BTreeSet::from([*symbol]),
            NodeKind::Sum(parts) | NodeKind::Product(parts) => {
                parts.iter().flat_map(|(_, part)| part.symbols()).collect()
            }
            NodeKind::Power(base, _) => base.symbols(),
            NodeKind::Call(_, arguments) => arguments.iter().flat_map(Self::symbols).collect(),
        }
    }

    /// Visits the largest subtrees in which nothing varies.
    pub fn visit_constants(&self, visit: &mut dyn FnMut(&Self)) {
        let parts: Vec<&Self> = match &self.kind {
            NodeKind::Constant => return visit(self),
            NodeKind::Symbol(_) => Vec::new(),
            NodeKind::Sum(parts) | NodeKind::Product(parts) => parts.iter().map(|(_, part)| part).collect(),
            NodeKind::Power(base, _) => vec![base],
            NodeKind::Call(_, arguments) => arguments.iter().collect(),
        };
        for part in parts {
            part.visit_constants(visit);
        }
    }
}

impl Node {
    /// A node that computes one monomial, for terms that are known only in canonical form.
    pub fn from_monomial(monomial: &Monomial, span: &Range<usize>) -> Self {
        let factors = monomial.factors().iter().map(|(atom, exponent)| {
            let base = Self::from_atom(atom, span);
            let whole = Monomial::of(atom.clone(), exponent.unsigned_abs());
            let poly = Poly::monomial(whole, RBig::ONE);
            let raised = match exponent.unsigned_abs() {
                1 => base,
                n => Self { kind: NodeKind::Power(Box::new(base), n), poly, span: span.clone() },
            };
            (*exponent < 0, raised)
        });
        let factors: Vec<_> = factors.collect();
        let poly = Poly::monomial(monomial.clone(), RBig::ONE);
        Self { kind: NodeKind::Product(factors), poly, span: span.clone() }
    }

    fn from_atom(atom: &Atom, span: &Range<usize>) -> Self {
        let kind = match atom {
            Atom::Pi => NodeKind::Constant,
            Atom::Symbol(symbol) => NodeKind::Symbol(*symbol),
            Atom::Call(function, arguments) => {
                NodeKind::Call(*function, arguments.iter().map(|a| Self::from_poly(a, span)).collect())
            }
            Atom::Reciprocal(sum) => NodeKind::Product(vec![(true, Self::from_poly(sum, span))]),
        };
        fold(Self { kind, poly: atom.clone().into(), span: span.clone() })
    }

    /// A node that computes a canonical form term by term.
    pub fn from_poly(poly: &Poly, span: &Range<usize>) -> Self {
        let terms = poly.terms().map(|(monomial, coefficient)| {
            let constant = Self { kind: NodeKind::Constant, poly: coefficient.clone().into(), span: span.clone() };
            let factors = vec![(false, constant), (false, Self::from_monomial(monomial, span))];
            let poly = Poly::monomial(monomial.clone(), coefficient.clone());
            (false, fold(Self { kind: NodeKind::Product(factors), poly, span: span.clone() }))
        });
        let kind = NodeKind::Sum(terms.collect());
        fold(Self { kind, poly: poly.clone(), span: span.clone() })
    }
}
