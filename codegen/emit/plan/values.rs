//! Types of values, and which constants are spelled where they are used.

use super::{Definition, Origin, Plan};
use crate::program::{CellKind, Op, Statement, Type, Value};

impl<'a> Plan<'a> {
    /// Notes the types and the constants.
    pub(super) fn define(&mut self, body: &'a [Statement]) {
        for statement in body {
            match statement {
                Statement::Let { value, op } => {
                    let in_place = matches!(op, Op::Float(_) | Op::Bool(_) | Op::Status(_) | Op::Index(_));
                    let definition = Definition { r#type: self.result(op), origin: Origin::Op(op), in_place };
                    self.definitions.insert(*value, definition);
                }
                Statement::Loop(inner) => {
                    for carried in &inner.carried {
                        let r#type = self.r#type(carried.start);
                        let origin = Origin::Carried(carried);
                        self.definitions.insert(carried.value, Definition { r#type, origin, in_place: false });
                    }
                    self.define(&inner.body);
                }
                Statement::Section(_) | Statement::SetCell { .. } | Statement::SetRing { .. } => {}
            }
        }
    }

    /// Gives a name to the constants that cannot stand where they are used: an operation on nothing
    /// but constants has no type in Rust, and clippy takes `-1.0 * x` for a mistake.
    pub(super) fn name_operands(&mut self, body: &[Statement]) {
        for statement in body {
            match statement {
                // Equal branches: the condition is not spelled.
                Statement::Let { op: Op::Select { then, otherwise, .. }, .. } if then == otherwise => {}
                Statement::Let { op, .. } => {
                    let operands = op.operands();
                    let all = operands.iter().all(|value| self.constant(*value).is_some());
                    let is_minus_one = |value: &Value| matches!(self.constant(*value), Some(Op::Float(-1.0)));
                    let named =
                        operands.into_iter().filter(|value| all || matches!(op, Op::Mul(..)) && is_minus_one(value));
                    for value in named.collect::<Vec<_>>() {
                        self.definitions.entry(value).and_modify(|it| it.in_place = false);
                    }
                }
                Statement::Loop(inner) => self.name_operands(&inner.body),
                Statement::Section(_) | Statement::SetCell { .. } | Statement::SetRing { .. } => {}
            }
        }
    }

    /// The constant that is spelled in place of a value.
    pub(super) fn constant(&self, value: Value) -> Option<&'a Op> {
        match self.definitions[&value] {
            Definition { origin: Origin::Op(op), in_place: true, .. } => Some(op),
            _ => None,
        }
    }

    /// The type of an operation's result.
    fn result(&self, op: &Op) -> Type {
        match op {
            Op::Less(..)
            | Op::LessEqual(..)
            | Op::InRange { .. }
            | Op::Bool(_)
            | Op::Vouched
            | Op::And(..)
            | Op::Or(..)
            | Op::Not(_)
            | Op::IndexLess(..)
            | Op::IndexEqual(..) => Type::Bool,
            Op::Status(_) => Type::Status,
            Op::Select { then, .. } => self.r#type(*then),
            Op::Index(_)
            | Op::Advance { .. }
            | Op::Retreat { .. }
            | Op::CountUp { .. }
            | Op::CountDown(_)
            | Op::AtMost { .. }
            | Op::FromFloat(_)
            | Op::WrapAdd(..)
            | Op::Difference { .. }
            | Op::Remainder { .. }
            | Op::Count(_) => Type::Index,
            Op::Cell(cell) | Op::Ring { ring: cell, .. } => match self.program.cells[usize::from(cell.0)].kind {
                CellKind::Index { .. } | CellKind::Counts { .. } => Type::Index,
                CellKind::Float { .. } | CellKind::Ring { .. } => Type::Float,
            },
            Op::Float(_)
            | Op::Neg(_)
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Div(..)
            | Op::Call(..)
            | Op::ToFloat(_)
            | Op::SignedToFloat(_)
            | Op::Measurement(_)
            | Op::Input(_)
            | Op::Given(_)
            | Op::Lookup { .. }
            | Op::Gain { .. } => Type::Float,
        }
    }
}
