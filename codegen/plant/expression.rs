//! Texts of a specification as expressions and constants.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Constant, Meaning, Names, Node, parse, resolve};
use crate::spec::{Quantity, Text};

use super::words;

/// Reads an expression; its mistakes are collected.
pub(super) fn read_expression(text: &Text, known: &[(String, Meaning)], found: &mut Vec<Diagnostic>) -> Option<Node> {
    let place = |within: Range<usize>| text.place(within);
    match parse::parse(&text.value) {
        Ok(expr) => {
            let node = resolve(&expr, &Names { known, place: &place }, found)?;
            let mut exist = true;
            node.visit_constants(&mut |part| {
                let constant = Constant::try_from(part.poly.clone());
                exist &= constant.is_ok_and(|constant| exists(&constant, &part.span, found));
            });
            exist.then_some(node)
        }
        Err(error) => {
            let mut diagnostic = Diagnostic::error(codes::EXPRESSION_SYNTAX, place(error.span), error.message);
            diagnostic.help = error.help;
            found.push(diagnostic);
            None
        }
    }
}

/// A quantity as a constant whose value exists.
pub(super) fn read_constant(
    quantity: &Quantity,
    known: &[(String, Meaning)],
    found: &mut Vec<Diagnostic>,
) -> Option<Constant> {
    let (constant, span) = match quantity {
        Quantity::Number(value, span) => (Constant::from(value.clone()), span.clone()),
        Quantity::Expression(text) => {
            let node = read_expression(text, known, found)?;
            let varies = node.poly.symbols().first().map(|symbol| words::name_of(*symbol, known));
            let Ok(constant) = Constant::try_from(node.poly) else {
                let error = Diagnostic::error(codes::NOT_CONSTANT, node.span, "a constant is needed here");
                let error = error.label(varies.map_or_else(String::new, |name| format!("`{name}` varies")));
                found.push(error.help("write parameters, numbers, pi and functions of them"));
                return None;
            };
            (constant, node.span)
        }
    };
    exists(&constant, &span, found).then_some(constant)
}

/// Whether a constant can be computed, and is not beyond the range of a double.
pub(super) fn exists(constant: &Constant, span: &Range<usize>, found: &mut Vec<Diagnostic>) -> bool {
    let why = match constant.to_f64() {
        Err(error) => error.0,
        Ok(value) if value.is_infinite() => "beyond 1.8e308, where a double ends".to_owned(),
        Ok(_) => return true,
    };
    // A part that was reported already spoils what it is part of.
    if !found
        .iter()
        .any(|d| d.code == codes::DOMAIN && span.start <= d.labels[0].span.start && d.labels[0].span.end <= span.end)
    {
        found.push(Diagnostic::error(codes::DOMAIN, span.clone(), "this constant has no usable value").label(why));
    }
    false
}
