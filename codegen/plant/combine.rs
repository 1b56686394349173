//! As few injections as possible, each with its behaviour between samples.

use std::collections::BTreeMap;

use dashu_ratio::RBig;

use crate::expr::{Node, NodeKind, Poly, Symbol};
use crate::spec::{Hold, Spec};

/// How a function behaves between samples, which decides its hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Change {
    /// With zero-order-hold inputs only: constant between samples.
    Held,
    /// With outputs, time and first-order-hold inputs: runs on between samples.
    Runs,
    /// With both: runs on, and jumps at the samples.
    RunsAndJumps,
}

/// The behaviour of a function between samples, given the holds of the inputs.
pub fn change(poly: &Poly, hold: impl Fn(usize) -> Hold) -> Change {
    let (mut held, mut runs) = (false, false);
    for symbol in poly.symbols() {
        match symbol {
            Symbol::Input(i) if hold(i) == Hold::Zero => held = true,
            _ => runs = true,
        }
    }
    match (held, runs) {
        (_, false) => Change::Held,
        (false, true) => Change::Runs,
        (true, true) => Change::RunsAndJumps,
    }
}

/// As few functions as possible: one per distinct function, or one per state where that is fewer.
pub fn combine(terms: BTreeMap<Poly, (Node, Vec<Poly>)>, spec: &Spec) -> Vec<(Node, Vec<Poly>)> {
    let mut groups: BTreeMap<Change, Vec<(Node, Vec<Poly>)>> = BTreeMap::new();
    for (poly, entry) in terms {
        groups.entry(change(&poly, |i| spec.inputs[i].hold)).or_default().push(entry);
    }
    groups.into_values().flat_map(combine_group).collect()
}

fn combine_group(functions: Vec<(Node, Vec<Poly>)>) -> Vec<(Node, Vec<Poly>)> {
    let n = functions.first().map_or(0, |(_, column)| column.len());
    let rows: Vec<usize> = (0..n).filter(|i| functions.iter().any(|(_, column)| !column[*i].is_zero())).collect();
    if functions.len() <= rows.len() {
        return functions;
    }
    let sums: Option<Vec<_>> = rows
        .iter()
        .map(|row| {
            let mut column = vec![Poly::default(); n];
            column[*row] = Poly::from(RBig::ONE);
            Some((sum_of(&functions, *row)?, column))
        })
        .collect();
    // A sum that is too large to know canonically stays apart.
    sums.unwrap_or(functions)
}

/// The sum of coefficient times function in one row, as a node.
fn sum_of(functions: &[(Node, Vec<Poly>)], row: usize) -> Option<Node> {
    let mut poly = Poly::default();
    let mut terms = Vec::new();
    for (node, column) in functions.iter().filter(|(_, column)| !column[row].is_zero()) {
        let coefficient = Node { kind: NodeKind::Constant, poly: column[row].clone(), span: node.span.clone() };
        let whole = column[row].times(&node.poly).ok()?;
        poly = poly.plus(&whole).ok()?;
        let kind = NodeKind::Product(vec![(false, coefficient), (false, node.clone())]);
        terms.push((false, Node { kind, poly: whole, span: node.span.clone() }));
    }
    let span = terms.first().map_or(0..0, |(_, term)| term.span.clone());
    Some(Node { kind: NodeKind::Sum(terms), poly, span })
}
