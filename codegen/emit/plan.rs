//! A Program laid out for printing: what both languages must decide alike.
//!
//! In: a Program. Out: its functions, and for every value whether it is spelled as a constant, as
//! a local, or as a field of the struct that one function hands to the next.

mod reach;
mod values;

use std::collections::BTreeMap;

use super::c::math;
use super::split::{self, Item};
use crate::names::Names;
use crate::program::{Carried, CellKind, Op, Program, Statement, TableId, Type, Value};

pub use reach::{Access, Reach};

/// A Program laid out for printing.
pub struct Plan<'a> {
    pub program: &'a Program,
    pub names: Names,
    /// Every function stands behind those that it calls; the step itself is the last.
    pub functions: Vec<Function<'a>>,
    /// The values that cross from one function to another, in order.
    pub crossing: Vec<Value>,
    /// The truth values among them. They travel in one array: clippy takes more than three fields
    /// of type `bool` for a mistake.
    pub flags: Vec<Value>,
    definitions: BTreeMap<Value, Definition<'a>>,
}

/// What is known of a value.
struct Definition<'a> {
    r#type: Type,
    origin: Origin<'a>,
    /// Whether it is a constant that is spelled where it is used.
    in_place: bool,
}

/// Where a value comes from.
#[derive(Clone, Copy)]
pub enum Origin<'a> {
    Op(&'a Op),
    Carried(&'a Carried),
}

/// How a value is spelled.
#[derive(Clone, Copy)]
pub enum Place<'a> {
    /// As the constant itself.
    Constant(&'a Op),
    /// As a local variable.
    Local,
    /// As a field of `work`.
    Work,
    /// As an element of `work.flags`.
    Flag(usize),
}

/// A function of the output.
pub struct Function<'a> {
    pub items: Vec<Item<'a>>,
    /// The table whose row it is called with.
    pub row: Option<TableId>,
    pub reach: Reach,
    /// Whether it is the start from an estimate, or a part of that.
    pub starts: bool,
}

impl<'a> Plan<'a> {
    /// Lays out the Program.
    pub fn new(program: &'a Program) -> Self {
        let mut plan = Self {
            program,
            names: Names::new(program, math::is_taken),
            functions: split::functions(program),
            crossing: vec![],
            flags: vec![],
            definitions: BTreeMap::new(),
        };
        for body in [program.init_at.as_deref().unwrap_or_default(), &program.body] {
            plan.define(body);
            plan.name_operands(body);
        }
        plan.crossing = plan.crossing_values();
        plan.flags = plan.crossing.iter().copied().filter(|v| plan.r#type(*v) == Type::Bool).collect();
        for at in 0..plan.functions.len() {
            plan.functions[at].reach = plan.reach(&plan.functions[at].items);
        }
        plan
    }

    /// The type of a value.
    pub fn r#type(&self, value: Value) -> Type {
        self.definitions[&value].r#type
    }

    /// Where a value comes from.
    pub fn origin(&self, value: Value) -> Origin<'a> {
        self.definitions[&value].origin
    }

    /// How a value is spelled.
    pub fn place(&self, value: Value) -> Place<'a> {
        if let Some(op) = self.constant(value) {
            Place::Constant(op)
        } else if self.crossing.binary_search(&value).is_err() {
            Place::Local
        } else {
            self.flags.binary_search(&value).map_or(Place::Work, Place::Flag)
        }
    }

    /// The step itself.
    pub fn step(&self) -> &Function<'a> {
        match self.functions.last() {
            Some(step) => step,
            None => unreachable!("split::functions ends with the step"),
        }
    }

    /// The start from an estimate itself.
    pub fn start(&self) -> Option<&Function<'a>> {
        self.functions.iter().rfind(|function| function.starts)
    }

    /// The functions that the start and the step are split into, with their places and of which they are a part.
    pub fn parts(&self) -> impl Iterator<Item = (usize, &'static str, &Function<'a>)> {
        let whole = 1 + usize::from(self.program.init_at.is_some());
        let parts = self.functions[..self.functions.len() - whole].iter().enumerate();
        parts.map(|(at, part)| (at, if part.starts { "a start" } else { "a step" }, part))
    }

    /// The table of the row that a function is called with, if it reads the row.
    pub fn row_of(&self, function: &Function) -> Option<TableId> {
        function.row.filter(|_| self.uses_row(&function.items))
    }

    /// Whether the body of a loop reads the row that it is at.
    pub fn uses_row(&self, items: &[Item]) -> bool {
        items.iter().any(|item| match item {
            Item::Plain(Statement::Let { op, .. }) => matches!(op, Op::Gain { .. }),
            Item::Call(callee) => self.row_of(&self.functions[*callee]).is_some(),
            Item::Plain(_) | Item::Loop { .. } => false,
        })
    }

    /// Size of one element of a struct of floats.
    pub fn float_bytes(&self) -> usize {
        self.program.scalar.bytes() as usize
    }

    /// Size of the state in bytes, on a host of 64 bits.
    pub fn state_bytes(&self) -> usize {
        let cell = |kind: &CellKind| match kind {
            CellKind::Float { .. } => self.float_bytes(),
            CellKind::Index { .. } => 8,
            CellKind::Ring { len, .. } => *len as usize * self.float_bytes(),
            CellKind::Counts { len, bits, .. } => *len as usize * usize::from(bits / 8),
        };
        self.program.cells.iter().map(|one| cell(&one.kind)).sum()
    }
}
