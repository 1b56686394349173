//! Splits a right-hand side into `A x + B u + c + phi(y, u, t) + sum eps gamma + sum w d`.
//!
//! The canonical form decides what is linear; the user's own form is kept for what is not, so
//! that the step computes it as it was written.

use std::collections::BTreeMap;
use std::ops::Range;

use dashu_ratio::RBig;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Meaning, Monomial, Node, NodeKind, Poly, Symbol};

use super::measurable::Measurable;
use super::words::{describe, name_of, shortened};

/// How many of each there are.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Sizes {
    pub states: usize,
    pub inputs: usize,
    pub unknowns: usize,
    pub disturbances: usize,
}

/// One right-hand side, split. Coefficients are constant polynomials.
pub struct Side {
    /// Row of A.
    pub states: Vec<Poly>,
    /// Row of B.
    pub inputs: Vec<Poly>,
    /// Entry of c.
    pub offset: Poly,
    /// Entries of the gammas, which may vary.
    pub unknowns: Vec<Poly>,
    /// Entries of the disturbances' columns.
    pub disturbances: Vec<Poly>,
    /// Nonlinear functions by their monic canonical form, with coefficients.
    pub nonlinear: BTreeMap<Poly, (Node, Poly)>,
}

/// Splits the right-hand side of a state; what cannot be split is reported and gives `None`.
pub fn side(
    (state, right): (usize, &Node),
    measurable: &Measurable,
    sizes: Sizes,
    known: &[(String, Meaning)],
    found: &mut Vec<Diagnostic>,
) -> Option<Side> {
    let before = found.len();
    let mut side = Side {
        states: vec![Poly::default(); sizes.states],
        inputs: vec![Poly::default(); sizes.inputs],
        offset: Poly::default(),
        unknowns: vec![Poly::default(); sizes.unknowns],
        disturbances: vec![Poly::default(); sizes.disturbances],
        nonlinear: BTreeMap::new(),
    };
    let mut rest = Poly::default();
    for (monomial, coefficient) in right.poly.terms() {
        let (fixed, varying) = monomial.split();
        let term = Poly::monomial(fixed, coefficient.clone());
        let add = |place: &mut Poly| *place = std::mem::take(place).plus(&term).unwrap_or_default();
        match classify(&varying, measurable) {
            Class::Offset => add(&mut side.offset),
            Class::State(j) => add(&mut side.states[j]),
            Class::Input(i) => add(&mut side.inputs[i]),
            Class::Disturbance(k) => add(&mut side.disturbances[k]),
            Class::Unknown(k, factor) => {
                let gamma = term.times(&factor).unwrap_or_default();
                side.unknowns[k] = std::mem::take(&mut side.unknowns[k]).plus(&gamma).unwrap_or_default();
            }
            Class::Nonlinear => {
                let whole = Poly::monomial(monomial.clone(), coefficient.clone());
                rest = rest.plus(&whole).unwrap_or_default();
            }
            Class::Mistake(mistake) => found.push(mistake.explain(&varying, (state, right), measurable, known)),
        }
    }
    nonlinear(right, rest, measurable, &mut side.nonlinear);
    (found.len() == before).then_some(side)
}

/// What a monomial's varying part is.
enum Class {
    Offset,
    State(usize),
    Input(usize),
    Unknown(usize, Poly),
    Disturbance(usize),
    Nonlinear,
    Mistake(Mistake),
}

enum Mistake {
    State(usize),
    Unknown(usize),
    Disturbance(usize),
}

fn classify(varying: &Monomial, measurable: &Measurable) -> Class {
    match varying.as_symbol() {
        Some(Symbol::State(j)) => return Class::State(j),
        Some(Symbol::Input(i)) => return Class::Input(i),
        Some(Symbol::Unknown(k)) => return Class::Unknown(k, Poly::from(RBig::ONE)),
        Some(Symbol::Disturbance(k)) => return Class::Disturbance(k),
        Some(Symbol::Time) => return Class::Nonlinear,
        None => {}
    }
    let symbols = varying.symbols();
    if symbols.is_empty() {
        return Class::Offset;
    }
    for symbol in &symbols {
        match *symbol {
            Symbol::State(j) if !measurable.shows(j) => return Class::Mistake(Mistake::State(j)),
            Symbol::Disturbance(k) => return Class::Mistake(Mistake::Disturbance(k)),
            Symbol::Unknown(k) => return factor_of_unknown(varying, k),
            _ => {}
        }
    }
    Class::Nonlinear
}

/// `eps * gamma(t, y, u)`: the unknown once, outside every function.
fn factor_of_unknown(varying: &Monomial, k: usize) -> Class {
    match varying.without(Symbol::Unknown(k)) {
        Some(gamma) if !gamma.symbols().iter().any(|s| matches!(s, Symbol::Unknown(_))) => {
            Class::Unknown(k, Poly::monomial(gamma, RBig::ONE))
        }
        _ => Class::Mistake(Mistake::Unknown(k)),
    }
}

impl Mistake {
    fn explain(
        &self,
        varying: &Monomial,
        (state, right): (usize, &Node),
        measurable: &Measurable,
        known: &[(String, Meaning)],
    ) -> Diagnostic {
        let symbol = match *self {
            Self::State(j) => Symbol::State(j),
            Self::Unknown(k) => Symbol::Unknown(k),
            Self::Disturbance(k) => Symbol::Disturbance(k),
        };
        let span = culprit(right, varying, Some(symbol));
        let name = name_of(symbol, known);
        let what = shortened(describe(varying, known));
        match *self {
            Self::State(j) if measurable.late[j] => {
                let message = format!("nonlinear in `{name}`, which is measured late");
                Diagnostic::error(codes::DELAYED_INJECTION, span, message)
                    .label(format!("`{what}` needs `{name}` at once"))
                    .help(format!("measure `{name}` without delay, or approximate the term by a linear one"))
            }
            Self::State(j) if varying.without(symbol).is_some_and(|rest| !rest.symbols().contains(&symbol)) => {
                let message = format!("`{name}`, which is not measured, has a factor that varies");
                let error = Diagnostic::error(codes::NONLINEAR_STATE, span, message)
                    .label(format!("in `{what}`; only constants may multiply `{name}`"));
                let of = name_of(Symbol::State(state), known);
                error.help(if measurable.constant.get(j).is_some_and(|constant| *constant) {
                    format!(
                        "`{name}` does not change: leave it out of [states], declare it under [unknowns] as `{name} = {{}}`, \
                         and use `[observer.parameters]`, which finds constants with factors that vary"
                    )
                } else if measurable.shows(state) {
                    format!(
                        "measure `{name}` as an output of its own; or, since `{of}` is measured, make `{of}` an input and \
                         leave out its equation and its output; or, if the factor hardly changes, make it a parameter"
                    )
                } else {
                    format!(
                        "no observer method accepts this: measure `{name}` as an output of its own, or, if the factor hardly \
                         changes, make it a parameter"
                    )
                })
            }
            Self::State(_) => {
                let message = format!("nonlinear in `{name}`, which is not measured");
                Diagnostic::error(codes::NONLINEAR_STATE, span, message)
                    .label(format!("`{what}` is not linear in `{name}`"))
                    .help(format!("no observer method accepts this: measure `{name}` as an output of its own, or approximate the term by a linear one"))
            }
            Self::Unknown(_) => {
                let message = format!("the unknown `{name}` must enter affinely");
                Diagnostic::error(codes::NOT_AFFINE, span, message)
                    .label(format!("this contains `{what}`"))
                    .help(format!("write `{name}` times a function of t, inputs and measured states"))
            }
            Self::Disturbance(_) => {
                let message = format!("the disturbance `{name}` must enter linearly");
                Diagnostic::error(codes::NOT_AFFINE, span, message)
                    .label(format!("this contains `{what}`"))
                    .help(format!("write a constant times `{name}`"))
            }
        }
    }
}

/// The smallest part of the tree that holds the monomial; failing that, the name itself.
pub fn culprit(node: &Node, varying: &Monomial, symbol: Option<Symbol>) -> Range<usize> {
    let holds = |child: &Node| child.poly.terms().any(|(m, _)| m.split().1 == *varying);
    match children(node).into_iter().find(|child| holds(child)) {
        Some(child) => culprit(child, varying, symbol),
        None if holds(node) => node.span.clone(),
        None => symbol.and_then(|s| find_symbol(node, s)).unwrap_or_else(|| node.span.clone()),
    }
}

fn find_symbol(node: &Node, symbol: Symbol) -> Option<Range<usize>> {
    match &node.kind {
        NodeKind::Symbol(found) if *found == symbol => Some(node.span.clone()),
        _ => children(node).into_iter().find_map(|child| find_symbol(child, symbol)),
    }
}

fn children(node: &Node) -> Vec<&Node> {
    match &node.kind {
        NodeKind::Constant | NodeKind::Symbol(_) => Vec::new(),
        NodeKind::Sum(parts) | NodeKind::Product(parts) => parts.iter().map(|(_, part)| part).collect(),
        NodeKind::Power(base, _) => vec![base],
        NodeKind::Call(_, arguments) => arguments.iter().collect(),
    }
}

/// Collects the nonlinear terms: the user's own where they are purely nonlinear, else monomial by monomial.
fn nonlinear(right: &Node, mut rest: Poly, measurable: &Measurable, into: &mut BTreeMap<Poly, (Node, Poly)>) {
    for (coefficient, core) in flatten(right, Poly::from(RBig::ONE)) {
        let pure = core.poly.terms().all(|(m, _)| matches!(classify(&m.split().1, measurable), Class::Nonlinear));
        let Ok(whole) = coefficient.times(&core.poly) else { continue };
        if !pure || whole.is_zero() {
            continue;
        }
        let Ok(difference) = rest.clone().plus(&whole.negated()) else { continue };
        rest = difference;
        // What cancels is not computed: the step may not know it where the rest is needed.
        let whole = core.symbols() == core.poly.symbols();
        let core = if whole { core } else { Node::from_poly(&core.poly, &core.span) };
        insert(into, core, &coefficient);
    }
    for (monomial, coefficient) in rest.terms() {
        let (fixed, varying) = monomial.split();
        insert(into, Node::from_monomial(&varying, &right.span), &Poly::monomial(fixed, coefficient.clone()));
    }
    into.retain(|_, (_, coefficient)| !coefficient.is_zero());
}

/// Adds a term; equal functions share an entry whatever their scale.
fn insert(into: &mut BTreeMap<Poly, (Node, Poly)>, node: Node, coefficient: &Poly) {
    let (monic, leading) = node.poly.monic();
    let (first, sum) = into.entry(monic).or_insert_with(|| (node, Poly::default()));
    let ratio = &leading / &first.poly.monic().1;
    if let Ok(more) = coefficient.times(&ratio.into()) {
        *sum = std::mem::take(sum).plus(&more).unwrap_or_default();
    }
}

/// The terms of a sum with their constant coefficients; constants are taken out of products and carried into sums.
fn flatten(node: &Node, coefficient: Poly) -> Vec<(Poly, Node)> {
    match &node.kind {
        NodeKind::Constant => Vec::new(),
        NodeKind::Sum(terms) => terms
            .iter()
            .flat_map(|(minus, term)| {
                let signed = if *minus { coefficient.clone().negated() } else { coefficient.clone() };
                flatten(term, signed)
            })
            .collect(),
        NodeKind::Product(factors) => flatten_product(node, factors, coefficient),
        _ => vec![(coefficient, node.clone())],
    }
}

fn flatten_product(node: &Node, factors: &[(bool, Node)], coefficient: Poly) -> Vec<(Poly, Node)> {
    let (constants, varying): (Vec<_>, Vec<_>) =
        factors.iter().partition(|(_, f)| matches!(f.kind, NodeKind::Constant));
    let mut scale = Ok(coefficient.clone());
    for (divided, constant) in &constants {
        let factor = if *divided { constant.poly.reciprocal() } else { Ok(constant.poly.clone()) };
        scale = scale.and_then(|product| product.times(&factor?));
    }
    let Ok(scale) = scale else { return vec![(coefficient, node.clone())] };
    if let [(false, only)] = varying.as_slice() {
        return flatten(only, scale);
    }
    let mut poly = Ok(Poly::from(RBig::ONE));
    for (divided, factor) in &varying {
        let factor = if *divided { factor.poly.reciprocal() } else { Ok(factor.poly.clone()) };
        poly = poly.and_then(|product| product.times(&factor?));
    }
    match poly {
        Ok(poly) => {
            let kind = NodeKind::Product(varying.into_iter().cloned().collect());
            vec![(scale, Node { kind, poly, span: node.span.clone() })]
        }
        Err(_) => vec![(coefficient, node.clone())],
    }
}
