//! The part of the runtime's C source that a Program needs.

use std::collections::BTreeSet;

use super::super::plan::Plan;
use super::super::split;
use super::super::split::Item;
use super::math;
use crate::program::{Op, Statement};

/// The parts that the Program's functions need, in the order in which they may be written, with the
/// Program's prefix.
pub fn sources(plan: &Plan) -> Vec<String> {
    math::closure(called(plan)).map(|part| plan.names.adopt(part.text.trim_end())).collect()
}

/// The names of the functions that the Program calls.
fn called(plan: &Plan) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for function in &plan.functions {
        split::visit(&function.items, &mut |item| {
            let name = match item {
                Item::Plain(Statement::Let { op: Op::Call(function, _), .. }) => function.name(),
                Item::Plain(Statement::Let { op: Op::FromFloat(_), .. }) => "index_from",
                _ => return,
            };
            names.insert(format!("{name}_{}", plan.program.scalar));
        });
    }
    names
}

#[cfg(test)]
mod tests {
    use super::math::PARTS;

    /// Claim: no name of the runtime's C source becomes a name of the interface.
    #[test]
    fn runtime_leaves_our_names_alone() {
        let own = ["status", "measurements", "inputs", "estimate", "state", "work", "init", "init_at", "step"];
        for part in PARTS {
            let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
            for word in part.text.split(|c| !is_word(c)) {
                let name = word.strip_prefix("deadbeat_").unwrap_or("");
                assert!(!own.contains(&name) && !name.starts_with("part_"), "{word}");
            }
        }
    }
}
