//! A Program laid out for printing: what both languages must decide alike.
//!
//! In: a Program. Out: its functions, and for every value whether it is spelled as a constant, as
//! a local, or as a field of the struct that one function hands to the next.

use std::collections::{BTreeMap, BTreeSet};

use super::names::Names;
use super::split::{self, Item};
use crate::program::{CellKind, Op, Program, Scalar, Statement, TableId, Type, Value};

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
    /// Its operation, if it is spelled where it is used.
    constant: Option<&'a Op>,
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
}

/// What a function touches, itself or through what it calls.
#[derive(Clone, Copy, Default)]
pub struct Reach {
    pub state: Access,
    pub work: Access,
    pub measurements: bool,
    pub inputs: bool,
}

/// How something is used.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Access {
    #[default]
    None,
    Read,
    Write,
}

impl<'a> Plan<'a> {
    /// Lays out the Program.
    pub fn new(program: &'a Program) -> Self {
        let mut plan = Self {
            program,
            names: Names::new(program),
            functions: split::functions(program),
            crossing: vec![],
            flags: vec![],
            definitions: BTreeMap::new(),
        };
        plan.define(&program.body);
        plan.name_operands(&program.body);
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

    /// The step itself, and the functions that it is split into.
    pub fn step(&self) -> (&Function<'a>, &[Function<'a>]) {
        match self.functions.split_last() {
            Some(both) => both,
            None => unreachable!("split::functions ends with the step"),
        }
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
        match self.program.scalar {
            Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }

    /// Size of the state in bytes, on a host of 64 bits.
    pub fn state_bytes(&self) -> usize {
        let cell = |kind: &CellKind| match kind {
            CellKind::Float { .. } => self.float_bytes(),
            CellKind::Index { .. } => 8,
            CellKind::Ring { len, .. } => *len as usize * self.float_bytes(),
        };
        self.program.cells.iter().map(|one| cell(&one.kind)).sum()
    }

    /// Notes the types and the constants.
    fn define(&mut self, body: &'a [Statement]) {
        for statement in body {
            match statement {
                Statement::Let { value, op } => {
                    let is_constant = matches!(op, Op::Float(_) | Op::Bool(_) | Op::Status(_) | Op::Index(_));
                    let constant = is_constant.then_some(op);
                    let definition = Definition { r#type: self.result(op), constant };
                    self.definitions.insert(*value, definition);
                }
                Statement::Loop(inner) => {
                    for carried in &inner.carried {
                        let r#type = self.r#type(carried.start);
                        self.definitions.insert(carried.value, Definition { r#type, constant: None });
                    }
                    self.define(&inner.body);
                }
                Statement::Section(_) | Statement::SetCell { .. } | Statement::SetRing { .. } => {}
            }
        }
    }

    /// Gives a name to the constants that cannot stand where they are used: an operation on nothing
    /// but constants has no type in Rust, and clippy takes `-1.0 * x` for a mistake.
    fn name_operands(&mut self, body: &[Statement]) {
        for statement in body {
            match statement {
                // Equal branches: the condition is not spelled.
                Statement::Let { op: Op::Select { then, otherwise, .. }, .. } if then == otherwise => {}
                Statement::Let { op, .. } => {
                    let operands = op.operands();
                    let all = operands.iter().all(|value| self.constant(*value).is_some());
                    let is_minus_one = |value: &Value| matches!(self.constant(*value), Some(Op::Float(-1.0)));
                    let named = operands.into_iter().filter(|value| all || matches!(op, Op::Mul(..)) && is_minus_one(value));
                    for value in named.collect::<Vec<_>>() {
                        self.definitions.entry(value).and_modify(|it| it.constant = None);
                    }
                }
                Statement::Loop(inner) => self.name_operands(&inner.body),
                Statement::Section(_) | Statement::SetCell { .. } | Statement::SetRing { .. } => {}
            }
        }
    }

    /// The constant that is spelled in place of a value.
    fn constant(&self, value: Value) -> Option<&'a Op> {
        self.definitions[&value].constant
    }

    /// The type of an operation's result.
    fn result(&self, op: &Op) -> Type {
        match op {
            Op::Less(..)
            | Op::LessEqual(..)
            | Op::InRange { .. }
            | Op::Bool(_)
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
            | Op::AtMost { .. } => Type::Index,
            Op::Cell(cell) => match self.program.cells[usize::from(cell.0)].kind {
                CellKind::Index { .. } => Type::Index,
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
            | Op::Measurement(_)
            | Op::Input(_)
            | Op::Ring { .. }
            | Op::Lookup { .. }
            | Op::Gain { .. } => Type::Float,
        }
    }

    /// The values that one function defines and another uses.
    fn crossing_values(&self) -> Vec<Value> {
        let mut homes = BTreeMap::new();
        let mut uses = BTreeSet::new();
        for (at, function) in self.functions.iter().enumerate() {
            split::visit(&function.items, &mut |item| {
                homes.extend(item.defines().into_iter().map(|value| (value, at)));
                uses.extend(item.uses().into_iter().map(|value| (value, at)));
            });
        }
        let step = self.functions.len() - 1;
        uses.extend(self.program.estimates.iter().map(|(_, value)| (*value, step)));
        uses.insert((self.program.status, step));
        let crosses = |(value, at): &(Value, usize)| {
            homes[value] != *at && self.constant(*value).is_none()
        };
        let crossing: BTreeSet<Value> = uses.into_iter().filter(crosses).map(|(value, _)| value).collect();
        crossing.into_iter().collect()
    }

    /// What the items touch; the functions that they call are done.
    fn reach(&self, items: &[Item<'a>]) -> Reach {
        let mut reach = Reach::default();
        split::visit(items, &mut |item| {
            reach = reach.and(self.reach_of(item));
        });
        reach
    }

    /// What one item touches by itself.
    fn reach_of(&self, item: &Item<'a>) -> Reach {
        let mut reach = match item {
            Item::Call(callee) => self.functions[*callee].reach,
            Item::Plain(Statement::SetCell { .. } | Statement::SetRing { .. }) => {
                Reach { state: Access::Write, ..Reach::default() }
            }
            Item::Plain(Statement::Let { op, .. }) => Reach {
                state: match op {
                    Op::Cell(_) | Op::Ring { .. } => Access::Read,
                    _ => Access::None,
                },
                measurements: matches!(op, Op::Measurement(_)),
                inputs: matches!(op, Op::Input(_)),
                work: Access::None,
            },
            Item::Plain(_) | Item::Loop { .. } => Reach::default(),
        };
        let crosses = |value: &Value| self.crossing.binary_search(value).is_ok();
        if item.uses().iter().any(crosses) {
            reach.work = reach.work.max(Access::Read);
        }
        if item.defines().iter().any(crosses) {
            reach.work = Access::Write;
        }
        reach
    }
}

impl Reach {
    /// What two pieces of code touch together.
    fn and(self, other: Self) -> Self {
        Self {
            state: self.state.max(other.state),
            work: self.work.max(other.work),
            measurements: self.measurements || other.measurements,
            inputs: self.inputs || other.inputs,
        }
    }
}
