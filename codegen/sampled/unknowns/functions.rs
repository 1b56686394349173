//! The functions that gammas are made of, and the exosystem that some of them come from.
//!
//! `gamma_i = sum_k column_ik f_k(t, y, u)`. A function of time alone whose derivatives are sums of few such
//! functions is a state of `w' = S w` (constants, polynomials, sines, cosines, exponentials and their
//! products), so that its effect over a sample interval is exact; every other one is held, or a straight
//! line between samples, as the plant's own injections are.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::bounds::derivative;
use crate::expr::{Constant, Meaning, Monomial, Node, Poly, Symbol};
use crate::plant::words::text_of;
use crate::plant::{Injection, Plant, Unknown};
use crate::real::Rational;

use super::augment::{own_states, varying};

/// The most functions that one function's derivatives may lead to.
const MOST_MEMBERS: usize = 8;
/// The most functions that all gammas may need.
const MOST_FUNCTIONS: usize = 64;

/// A function times where it enters, n x 1 with n the plant's own states.
pub type Share = (usize, Vec<Constant>);

/// The gammas that vary, by the plant's injections.
#[derive(Clone, Debug)]
pub struct Functions {
    /// Per unknown that varies: its place among the plant's unknowns.
    pub unknowns: Vec<usize>,
    /// Per unknown that varies: the functions that are held or run straight between samples.
    pub lines: Vec<Vec<Share>>,
    /// Per unknown that varies: the functions of the exosystem, by place in `members`.
    pub flows: Vec<Vec<Share>>,
    /// w: the functions of the exosystem, as injections of the plant.
    pub members: Vec<usize>,
    /// S.
    pub change: Vec<Vec<Constant>>,
}

/// What a plant's gammas need, before its injections are numbered.
struct Needs {
    /// Per unknown that varies.
    lines: Vec<Vec<(Poly, Vec<Constant>)>>,
    flows: Vec<Vec<(Monomial, Vec<Constant>)>>,
    /// Per unknown that varies: the exosystem that it needs.
    systems: Vec<System>,
}

/// Functions of time, each with its derivative.
pub(super) type System = BTreeMap<Monomial, BTreeMap<Monomial, Constant>>;

/// An augmented plant with an injection, of no effect of its own, for every function of its gammas.
pub fn with_functions(mut plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
    let needs = Needs::of(&plant);
    // Each function with the place of the first unknown that needs it.
    let mut polys: BTreeMap<Poly, Range<usize>> = BTreeMap::new();
    for (i, place) in varying(&plant).into_iter().enumerate() {
        let members = needs.systems[i].keys().map(|m| Poly::monomial(m.clone(), Rational::ONE));
        for poly in needs.lines[i].iter().map(|(poly, _)| poly.clone()).chain(members) {
            polys.entry(poly).or_insert_with(|| plant.unknowns[place].label.span.clone());
        }
    }
    if polys.len() > MOST_FUNCTIONS {
        let message = format!("the factors of the unknowns are made of {} functions", polys.len());
        let error = Diagnostic::error(codes::TOO_LARGE, plant.span.clone(), message);
        return Err(vec![error.label(format!("at most {MOST_FUNCTIONS} are designed")).help("simpler factors")]);
    }
    let names: Vec<(String, Meaning)> = names(&plant);
    for (poly, span) in polys {
        if find(&plant, &poly).is_none() {
            let node = node_of(&poly, &span);
            let text = text_of(&node, &names);
            plant.injections.push(Injection { node, text, column: vec![Constant::default(); plant.states.len()] });
        }
    }
    Ok(plant)
}

impl Functions {
    /// The gammas of a plant that has their functions.
    pub fn of(plant: &Plant) -> Self {
        let needs = Needs::of(plant);
        let place = |poly: &Poly| {
            find(plant, poly).unwrap_or_else(|| unreachable!("every function of a gamma is an injection of the plant"))
        };
        let system: System = needs.systems.iter().flatten().map(|(m, change)| (m.clone(), change.clone())).collect();
        let members: Vec<&Monomial> = system.keys().collect();
        let lines = needs
            .lines
            .iter()
            .map(|shares| shares.iter().map(|(poly, column)| (place(poly), column.clone())).collect())
            .collect();
        let member =
            |m: &Monomial| members.iter().position(|other| *other == m).unwrap_or_else(|| unreachable!("closed"));
        let flows = needs
            .flows
            .iter()
            .map(|shares| shares.iter().map(|(m, column)| (member(m), column.clone())).collect())
            .collect();
        let change = members
            .iter()
            .map(|row| members.iter().map(|column| system[*row].get(*column).cloned().unwrap_or_default()).collect())
            .collect();
        let poly = |m: &&Monomial| Poly::monomial((*m).clone(), Rational::ONE);
        Self {
            unknowns: varying(plant),
            lines,
            flows,
            members: members.iter().map(|m| place(&poly(m))).collect(),
            change,
        }
    }

    /// Whether an unknown's gamma is a function of time alone.
    pub fn of_time(&self, plant: &Plant, unknown: usize) -> bool {
        let timed = |k: usize| plant.injections[k].symbols().iter().all(|s| *s == Symbol::Time);
        self.lines[unknown].iter().all(|(k, _)| timed(*k))
    }
}

fn find(plant: &Plant, poly: &Poly) -> Option<usize> {
    plant.injections.iter().position(|injection| injection.node.poly == *poly)
}

fn node_of(poly: &Poly, span: &Range<usize>) -> Node {
    let mut terms = poly.terms();
    match (terms.next(), terms.next()) {
        (Some((monomial, coefficient)), None) if *coefficient == Rational::ONE && !monomial.factors().is_empty() => {
            Node::from_monomial(monomial, span)
        }
        _ => Node::from_poly(poly, span),
    }
}

fn names(plant: &Plant) -> Vec<(String, Meaning)> {
    let states =
        plant.states.iter().enumerate().map(|(j, s)| (s.label.written.clone(), Meaning::Symbol(Symbol::State(j))));
    let inputs =
        plant.inputs.iter().enumerate().map(|(i, u)| (u.label.written.clone(), Meaning::Symbol(Symbol::Input(i))));
    states.chain(inputs).collect()
}

impl Needs {
    fn of(plant: &Plant) -> Self {
        let mut needs = Self { lines: Vec::new(), flows: Vec::new(), systems: Vec::new() };
        for place in varying(plant) {
            let (mut lines, mut flows, mut whole) = (Vec::new(), Vec::new(), System::new());
            for (monomial, column) in monomials(&plant.unknowns[place], own_states(plant)) {
                match closure(&monomial).filter(|_| !plant.discrete) {
                    Some(system) => {
                        whole.extend(system);
                        flows.push((monomial, column));
                    }
                    None => lines.push((monomial, column)),
                }
            }
            needs.lines.push(fewest(&lines));
            needs.flows.push(flows);
            needs.systems.push(whole);
        }
        needs
    }
}

/// gamma as monomials that vary times constant columns.
pub(super) fn monomials(unknown: &Unknown, n: usize) -> BTreeMap<Monomial, Vec<Constant>> {
    let mut columns: BTreeMap<Monomial, Vec<Poly>> = BTreeMap::new();
    for (i, entry) in unknown.gamma.iter().enumerate() {
        for (monomial, coefficient) in entry.terms() {
            let (fixed, varying) = monomial.split();
            let column = columns.entry(varying).or_insert_with(|| vec![Poly::default(); n]);
            let term = Poly::monomial(fixed, coefficient.clone());
            column[i] = std::mem::take(&mut column[i]).plus(&term).unwrap_or_default();
        }
    }
    let constants = |column: Vec<Poly>| column.into_iter().map(constant).collect();
    columns.into_iter().map(|(monomial, column)| (monomial, constants(column))).collect()
}

fn constant(poly: Poly) -> Constant {
    Constant::try_from(poly).unwrap_or_else(|_| unreachable!("what varies has been split off"))
}

/// One function per monomial, or one per row where that is fewer.
fn fewest(lines: &[(Monomial, Vec<Constant>)]) -> Vec<(Poly, Vec<Constant>)> {
    let n = lines.first().map_or(0, |(_, column)| column.len());
    let rows: Vec<usize> = (0..n).filter(|i| lines.iter().any(|(_, column)| !column[*i].is_zero())).collect();
    let one_each =
        || lines.iter().map(|(m, column)| (Poly::monomial(m.clone(), Rational::ONE), column.clone())).collect();
    if lines.len() <= rows.len() {
        return one_each();
    }
    let sum = |i: usize| -> Option<(Poly, Vec<Constant>)> {
        let mut sum = Poly::default();
        for (monomial, column) in lines {
            sum = sum.plus(&column[i].poly().times(&Poly::monomial(monomial.clone(), Rational::ONE)).ok()?).ok()?;
        }
        let unit = (0..n).map(|j| if j == i { Constant::one() } else { Constant::default() }).collect();
        Some((sum, unit))
    };
    rows.iter().map(|i| sum(*i)).collect::<Option<_>>().unwrap_or_else(one_each)
}

/// All functions that a function of time and its derivatives are made of, each with its derivative; `None`
/// when they are many, or it depends on more than time.
pub(super) fn closure(start: &Monomial) -> Option<System> {
    if start.symbols().iter().any(|symbol| *symbol != Symbol::Time) {
        return None;
    }
    let mut system = System::new();
    let mut open = vec![start.clone()];
    while let Some(next) = open.pop() {
        if system.contains_key(&next) {
            continue;
        }
        if system.len() == MOST_MEMBERS {
            return None;
        }
        let mut change: BTreeMap<Monomial, Poly> = BTreeMap::new();
        for (monomial, coefficient) in derivative(&Poly::monomial(next.clone(), Rational::ONE), Symbol::Time)?.terms() {
            let (fixed, varying) = monomial.split();
            let sum = change.entry(varying).or_default();
            *sum = std::mem::take(sum).plus(&Poly::monomial(fixed, coefficient.clone())).ok()?;
        }
        open.extend(change.keys().cloned());
        system.insert(next, change.into_iter().map(|(monomial, factor)| (monomial, constant(factor))).collect());
    }
    Some(system)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Atom, Function};

    fn call(function: Function, argument: Poly) -> Poly {
        Poly::call(function, vec![argument]).unwrap()
    }

    fn members(poly: &Poly) -> Option<usize> {
        closure(poly.terms().next().unwrap().0).map(|system| system.len())
    }

    #[test]
    fn sums_of_products_of_sines_powers_and_exponentials_close() {
        let t = Poly::from(Atom::Symbol(Symbol::Time));
        let (sine, cosine) = (call(Function::Sin, t.clone()), call(Function::Cos, t.clone()));
        assert_eq!(members(&sine), Some(2));
        assert_eq!(members(&sine.times(&cosine).unwrap()), Some(3));
        assert_eq!(members(&t.power(3).unwrap()), Some(4));
        assert_eq!(members(&call(Function::Exp, t.clone().negated()).times(&sine).unwrap()), Some(2));
        assert_eq!(members(&t.power(2).unwrap().times(&sine).unwrap()), Some(6));
    }

    #[test]
    fn what_does_not_close_or_is_not_of_time_alone_is_left() {
        let t = Poly::from(Atom::Symbol(Symbol::Time));
        let x = Poly::from(Atom::Symbol(Symbol::State(0)));
        assert_eq!(members(&call(Function::Exp, t.power(2).unwrap())), None);
        assert_eq!(members(&call(Function::Tanh, t.clone())), None);
        assert_eq!(members(&call(Function::Abs, t.clone())), None);
        assert_eq!(members(&t.reciprocal().unwrap()), None);
        assert_eq!(members(&call(Function::Sin, x)), None);
    }
}
