//! Writing a Program: one call for each operation; folding, sharing and pruning as it goes.
//!
//! In: the calls of a lowering. Out: a [`Program`] in which no operation is written twice, no
//! constant is computed at run time, and nothing is left that the estimates do not need.
//! All of it leaves every bit of every result as it is: see `fold`, `share`, `prune`.
//!
//! A misuse (a wrong type, a value of another loop, a constant that was not rounded to the scalar
//! type) is a mistake of the calling code, unreachable by users, and panics.

mod composed;
mod declare;
mod fold;
mod looping;
mod operations;
mod prune;
mod share;

#[cfg(test)]
mod tests;

pub use composed::additions;

use self::fold::{Folded, fold};
use self::share::Shared;
use std::mem;

use super::check::Flaw;
use super::check::typing::{Context, expect};
use super::{CellId, Field, Kind, Op, Program, Scalar, Statement, TableId, Type, Value};

/// A Program being written.
pub struct Builder {
    /// The result so far; inside a loop, `body` is the loop's.
    program: Program,
    /// By value.
    definitions: Vec<Definition>,
    /// For reuse.
    shared: Shared,
    /// The loop being written: its table.
    row: Option<TableId>,
    /// The scope being written: `TOP`, or the number of the loop.
    scope: u32,
    /// How many loops there have been.
    loops: u32,
    /// Whether [`Builder::report`] was called.
    reported: bool,
}

/// The scope of a value that is visible everywhere in the step.
const TOP: u32 = 0;

/// The scope of the start.
const START: u32 = u32::MAX;

/// What is known of a value.
struct Definition {
    r#type: Type,
    scope: u32,
    /// `None` for what a loop carries.
    op: Option<Op>,
}

impl Builder {
    /// An empty Program; `sample_time` is in seconds, rounded to `scalar`.
    #[must_use]
    pub fn new(name: &str, scalar: Scalar, sample_time: f64) -> Self {
        let program = Program {
            name: name.to_owned(),
            scalar,
            sample_time,
            measurements: vec![],
            inputs: vec![],
            cells: vec![],
            tables: vec![],
            body: vec![],
            init_at: None,
            estimates: vec![],
            status: Value(0),
        };
        Self { program, definitions: vec![], shared: Shared::new(), row: None, scope: TOP, loops: 0, reported: false }
    }

    /// The float type of the Program.
    #[must_use]
    pub fn scalar(&self) -> Scalar {
        self.program.scalar
    }

    /// A heading for the statements that follow; left out if there are none.
    pub fn section(&mut self, text: &str) {
        assert!(self.row.is_none(), "section `{text}` inside a loop");
        self.program.body.push(Statement::Section(text.to_owned()));
    }

    /// Writes a scalar cell.
    pub fn set(&mut self, cell: CellId, value: Value) {
        let written = self.context().scalar_cell(cell).and_then(|r#type| self.has(value, r#type));
        self.require("set", written);
        self.shared.write(cell);
        self.program.body.push(Statement::SetCell { cell, value });
    }

    /// Writes one element of a ring.
    pub fn set_ring(&mut self, ring: CellId, slot: Value, value: Value) {
        let written = (self.context().element(ring))
            .and_then(|element| self.has(value, element))
            .and_then(|()| self.has(slot, Type::Index));
        self.require("set_ring", written);
        self.shared.write(ring);
        self.program.body.push(Statement::SetRing { ring, slot, value });
    }

    /// The next estimate that a call returns: a float, or an index, which makes the field one.
    pub fn estimate(&mut self, field: Field, value: Value) {
        let kind = match self.visible(value) {
            Ok(Type::Index) => Kind::Index,
            _ => Kind::Float,
        };
        self.require(&field.name, self.has(value, if kind == Kind::Index { Type::Index } else { Type::Float }));
        self.program.estimates.push((Field { kind, ..field }, value));
    }

    /// What a call reports.
    pub fn report(&mut self, status: Value) {
        self.require("report", self.has(status, Type::Status));
        self.program.status = status;
        self.reported = true;
    }

    /// Writes what a start from an estimate does, once the step is written: the estimate's fields are known then.
    pub fn init_at(&mut self, write: impl FnOnce(&mut Self)) {
        assert!(self.scope == TOP && self.program.init_at.is_none(), "one start, outside of loops");
        let step = mem::take(&mut self.program.body);
        let shared = mem::replace(&mut self.shared, Shared::with_cells(self.program.cells.len()));
        self.scope = START;
        write(self);
        self.scope = TOP;
        self.shared = shared;
        self.program.init_at = Some(mem::replace(&mut self.program.body, step));
    }

    /// The Program, without what the estimates and the status do not need; its values are
    /// `t0`, `t1`, … in the order of their definitions.
    #[must_use]
    pub fn finish(self) -> Program {
        assert!(self.reported, "program `{}` reports no status", self.program.name);
        prune::prune(self.program)
    }

    /// The operation's value: a known one if it folds or was written before, else a new one.
    fn push(&mut self, op: Op) -> Value {
        let typed = self.context().type_of(&op, |value| self.visible(value));
        self.require(&format!("{op:?}"), typed.map(|_| ()));
        let known = |value: Value| self.definitions[value.0 as usize].op.as_ref();
        let op = match fold(&op, self.scalar(), known) {
            Some(Folded::Same(value)) => return value,
            Some(Folded::Constant(constant)) => constant,
            None => op,
        };
        if let Some(value) = self.shared.find(&op) {
            return value;
        }
        let value = self.define(op.clone());
        self.shared.remember(&op, value);
        value
    }

    /// A new value and its statement.
    fn define(&mut self, op: Op) -> Value {
        let typed = self.context().type_of(&op, |value| self.visible(value));
        let r#type = typed.unwrap_or_else(|flaw| unreachable!("checked in push: {flaw}"));
        let value = self.name(r#type, Some(op.clone()));
        self.program.body.push(Statement::Let { value, op });
        value
    }

    /// A new value.
    fn name(&mut self, r#type: Type, op: Option<Op>) -> Value {
        let number = u32::try_from(self.definitions.len()).expect("fewer than 2^32 values");
        self.definitions.push(Definition { r#type, scope: self.scope, op });
        Value(number)
    }

    /// The type of a value.
    fn type_of(&self, value: Value) -> Type {
        self.definitions[value.0 as usize].r#type
    }

    /// The type of a value that may be used here.
    fn visible(&self, value: Value) -> Result<Type, Flaw> {
        match self.definitions.get(value.0 as usize) {
            Some(known) if known.scope == self.scope => Ok(known.r#type),
            Some(known) if known.scope == TOP && self.scope != START => Ok(known.r#type),
            _ => Err(Flaw::Undefined(value)),
        }
    }

    /// Whether a value may be used here with that type.
    fn has(&self, value: Value, r#type: Type) -> Result<(), Flaw> {
        self.visible(value).and_then(|found| expect(value, found, r#type))
    }

    /// What an operation written here may refer to.
    fn context(&self) -> Context<'_> {
        if self.scope == START { Context::starting(&self.program) } else { Context::of(&self.program, self.row) }
    }

    /// Panics on a misuse.
    fn require(&self, what: &str, verdict: Result<(), Flaw>) {
        if let Err(flaw) = verdict {
            panic!("program `{}`: {what}: {flaw}", self.program.name);
        }
    }
}
