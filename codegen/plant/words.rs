//! Expressions in the user's names, for messages and comments.

use dashu_ratio::RBig;

use crate::decimal;
use crate::expr::{Atom, Function, Meaning, Monomial, Node, NodeKind, Poly, Symbol};

/// What the user calls a symbol.
pub fn name_of(symbol: Symbol, known: &[(String, Meaning)]) -> String {
    let matches = |meaning: &Meaning| matches!(meaning, Meaning::Symbol(found) if *found == symbol);
    known.iter().find(|(_, meaning)| matches(meaning)).map_or_else(|| "t".into(), |(name, _)| name.clone())
}

/// An expression's text for a label: its beginning, when it is long.
pub fn shortened(text: String) -> String {
    const LONGEST: usize = 60;
    if text.chars().count() <= LONGEST { text } else { text.chars().take(LONGEST).chain(" …".chars()).collect() }
}

/// A monomial in the user's names.
pub fn describe(monomial: &Monomial, known: &[(String, Meaning)]) -> String {
    let factor = |(atom, exponent): &(Atom, i32)| {
        let base = match atom {
            Atom::Pi => "pi".into(),
            Atom::Symbol(symbol) => name_of(*symbol, known),
            Atom::Reciprocal(sum) => format!("1/({})", describe_poly(sum, known)),
            Atom::Call(Function::Pow, arguments) => {
                format!("({})^({})", describe_poly(&arguments[0], known), describe_poly(&arguments[1], known))
            }
            Atom::Call(function, arguments) => {
                let list: Vec<String> = arguments.iter().map(|a| describe_poly(a, known)).collect();
                format!("{}({})", function.name(), list.join(", "))
            }
        };
        if *exponent == 1 { base } else { format!("{base}^{exponent}") }
    };
    monomial.factors().iter().map(factor).collect::<Vec<_>>().join("*")
}

fn describe_poly(poly: &Poly, known: &[(String, Meaning)]) -> String {
    let term = |(monomial, coefficient): (&Monomial, &RBig)| {
        let what = describe(monomial, known);
        let number = decimal::show(coefficient.to_f64().value());
        match (what.is_empty(), *coefficient == RBig::ONE) {
            (true, _) => number,
            (false, true) => what,
            (false, false) => format!("{number}*{what}"),
        }
    };
    let text = poly.terms().map(term).collect::<Vec<_>>().join(" + ").replace("+ -", "- ");
    if text.is_empty() { "0".into() } else { text }
}

/// A node in the user's names, for comments.
pub fn text_of(node: &Node, known: &[(String, Meaning)]) -> String {
    let flat = |sign: &str, parts: &[(bool, Node)], first: [&str; 2]| {
        let mut text = String::new();
        for (place, (other, part)) in parts.iter().enumerate() {
            let link = match (place, other) {
                (0, other) => first[usize::from(*other)].to_owned(),
                (_, false) => sign[..3].to_owned(),
                (_, true) => sign[3..].to_owned(),
            };
            let inner = text_of(part, known);
            let sum = parts.len() > 1
                && match &part.kind {
                    NodeKind::Sum(terms) => terms.len() > 1,
                    NodeKind::Constant => part.poly.terms().count() > 1,
                    _ => false,
                };
            let divisor = *other && sign.contains('/') && matches!(part.kind, NodeKind::Product(_));
            let wrap = sum || divisor;
            let (open, close) = if wrap { ("(", ")") } else { ("", "") };
            for piece in [&link, open, &inner, close] {
                text.push_str(piece);
            }
        }
        text
    };
    match &node.kind {
        NodeKind::Constant => describe_poly(&node.poly, known),
        NodeKind::Symbol(symbol) => name_of(*symbol, known),
        NodeKind::Sum(parts) => flat(" +  - ", parts, ["", "-"]),
        NodeKind::Product(parts) => flat(" *  / ", parts, ["", "1 / "]).replace(" * ", "*").replace(" / ", "/"),
        NodeKind::Power(base, n) if matches!(base.kind, NodeKind::Symbol(_) | NodeKind::Call(..)) => {
            format!("{}^{n}", text_of(base, known))
        }
        NodeKind::Power(base, n) => format!("({})^{n}", text_of(base, known)),
        NodeKind::Call(Function::Pow, arguments) => {
            format!("({})^({})", text_of(&arguments[0], known), text_of(&arguments[1], known))
        }
        NodeKind::Call(function, arguments) => {
            let list: Vec<String> = arguments.iter().map(|a| text_of(a, known)).collect();
            format!("{}({})", function.name(), list.join(", "))
        }
    }
}
