//! Sharing: an operation that was written before is that value, not a second statement.

use std::collections::HashMap;
use std::mem::{Discriminant, discriminant};

use super::super::{CellId, Op, Value};

/// What makes two operations the same: kind, operands, and constants bit for bit. Operands are
/// never swapped.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    kind: Discriminant<Op>,
    operands: Vec<Value>,
    constants: [u64; 2],
}

/// The operations written so far, by scope, and when each cell was last written.
#[derive(Default)]
pub(super) struct Shared {
    /// The top level and, in a loop, its body.
    scopes: Vec<HashMap<Key, Value>>,
    /// One for each cell; a write changes it, so that no read is shared across a write.
    versions: Vec<u64>,
    /// The versions before the loop.
    outside: Vec<u64>,
    /// The version that every cell got at the loop's start.
    entered: u64,
    /// The newest version.
    newest: u64,
}

impl Shared {
    /// An empty top level.
    pub fn new() -> Self {
        Self { scopes: vec![HashMap::new()], ..Self::default() }
    }

    /// The same, of a Program that has so many cells.
    pub fn with_cells(cells: usize) -> Self {
        Self { versions: vec![0; cells], ..Self::new() }
    }

    /// A cell was declared.
    pub fn declare(&mut self) {
        self.versions.push(self.newest);
    }

    /// A cell was written: no earlier read stands for a later one.
    pub fn write(&mut self, cell: CellId) {
        self.newest += 1;
        self.versions[usize::from(cell.0)] = self.newest;
    }

    /// A loop body starts. Any cell may be written in it, so no read before the loop stands for
    /// one in the body.
    pub fn enter(&mut self) {
        self.newest += 1;
        self.entered = self.newest;
        self.outside = self.versions.clone();
        self.versions.fill(self.entered);
        self.scopes.push(HashMap::new());
    }

    /// The loop body ends: its values are gone; cells that it did not write are as before.
    pub fn leave(&mut self) {
        self.scopes.pop();
        for (version, outside) in self.versions.iter_mut().zip(&self.outside) {
            if *version == self.entered {
                *version = *outside;
            }
        }
    }

    /// The value of the same operation, if one in scope has it.
    pub fn find(&self, op: &Op) -> Option<Value> {
        let key = self.key(op);
        self.scopes.iter().rev().find_map(|scope| scope.get(&key).copied())
    }

    /// From now on `value` stands for the operation.
    pub fn remember(&mut self, op: &Op, value: Value) {
        let key = self.key(op);
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(key, value);
        }
    }

    /// Two operations with equal keys have equal results.
    fn key(&self, op: &Op) -> Key {
        let at = |cell: CellId| [u64::from(cell.0), self.versions[usize::from(cell.0)]];
        let constants = match *op {
            Op::Float(x) => [x.to_bits(), 0],
            Op::InRange { low, high, .. } => [low.to_bits(), high.to_bits()],
            Op::Call(function, _) => [function as u64, 0],
            Op::Bool(truth) => [u64::from(truth), 0],
            Op::Status(status) => [status as u64, 0],
            Op::Index(number)
            | Op::Advance { len: number, .. }
            | Op::Retreat { len: number, .. }
            | Op::CountUp { max: number, .. }
            | Op::AtMost { max: number, .. }
            | Op::Remainder { modulus: number, .. } => [u64::from(number), 0],
            Op::Measurement(field) | Op::Count(field) | Op::Input(field) | Op::Given(field) => [u64::from(field), 0],
            Op::Difference { bits, .. } => [u64::from(bits), 0],
            Op::Cell(cell) | Op::Ring { ring: cell, .. } => at(cell),
            Op::Lookup { table, column, .. } => [u64::from(table.0), u64::from(column)],
            Op::Gain { column } => [u64::from(column), 0],
            Op::Neg(_)
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Div(..)
            | Op::Less(..)
            | Op::LessEqual(..)
            | Op::And(..)
            | Op::Or(..)
            | Op::Not(_)
            | Op::Select { .. }
            | Op::IndexLess(..)
            | Op::IndexEqual(..)
            | Op::CountDown(_)
            | Op::ToFloat(_)
            | Op::SignedToFloat(_)
            | Op::FromFloat(_)
            | Op::WrapAdd(..)
            | Op::Vouched => [0, 0],
        };
        Key { kind: discriminant(op), operands: op.operands(), constants }
    }
}
