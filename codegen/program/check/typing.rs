//! The type of an operation, and whether it is well formed by itself.
//!
//! In: an operation, what it may refer to, the types of its operands. Out: the type of its result.
//! The builder asks while it builds, [`check`](super::check) afterwards.

use super::super::{Cell, CellId, CellKind, Op, Program, Scalar, Table, TableId, Type, Value};
use super::Flaw;

/// What an operation may refer to.
pub(in super::super) struct Context<'a> {
    /// The Program's.
    pub scalar: Scalar,
    /// How many.
    pub measurements: usize,
    /// How many.
    pub inputs: usize,
    /// The Program's.
    pub cells: &'a [Cell],
    /// The Program's.
    pub tables: &'a [Table],
    /// The table of the loop around the operation.
    pub row: Option<TableId>,
}

impl<'a> Context<'a> {
    /// Of a statement in a loop over `row`, or at the top level.
    pub fn of(program: &'a Program, row: Option<TableId>) -> Self {
        Self {
            scalar: program.scalar,
            measurements: program.measurements.len(),
            inputs: program.inputs.len(),
            cells: &program.cells,
            tables: &program.tables,
            row,
        }
    }

    /// The type of the operation's result.
    pub fn type_of(&self, op: &Op, operand: impl Fn(Value) -> Result<Type, Flaw>) -> Result<Type, Flaw> {
        self.well_formed(op)?;
        if let Op::Select { condition, then, otherwise } = *op {
            expect(condition, operand(condition)?, Type::Bool)?;
            let result = operand(then)?;
            expect(otherwise, operand(otherwise)?, result)?;
            return Ok(result);
        }
        let (arguments, result) = self.signature(op)?;
        for value in op.operands() {
            expect(value, operand(value)?, arguments)?;
        }
        Ok(result)
    }

    /// The type of all operands and the type of the result; `Select` has no single operand type.
    fn signature(&self, op: &Op) -> Result<(Type, Type), Flaw> {
        Ok(match op {
            Op::Float(_)
            | Op::Neg(_)
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Div(..)
            | Op::Call(..)
            | Op::Measurement(_)
            | Op::Input(_)
            | Op::Gain { .. } => (Type::Float, Type::Float),
            Op::Less(..) | Op::LessEqual(..) | Op::InRange { .. } => (Type::Float, Type::Bool),
            Op::Bool(_) | Op::And(..) | Op::Or(..) | Op::Not(_) => (Type::Bool, Type::Bool),
            Op::Status(_) | Op::Select { .. } => (Type::Status, Type::Status),
            Op::Index(_)
            | Op::Advance { .. }
            | Op::Retreat { .. }
            | Op::CountUp { .. }
            | Op::CountDown(_)
            | Op::AtMost { .. } => (Type::Index, Type::Index),
            Op::IndexLess(..) | Op::IndexEqual(..) => (Type::Index, Type::Bool),
            Op::ToFloat(_) | Op::Ring { .. } | Op::Lookup { .. } => (Type::Index, Type::Float),
            Op::Cell(cell) => (Type::Index, self.scalar_cell(*cell)?),
        })
    }

    /// Everything about an operation but its operands.
    fn well_formed(&self, op: &Op) -> Result<(), Flaw> {
        match *op {
            Op::Float(x) => representable(x, self.scalar),
            Op::InRange { low, high, .. } => {
                representable(low, self.scalar)?;
                representable(high, self.scalar)?;
                if low <= high { Ok(()) } else { Err(Flaw::EmptyRange { low, high }) }
            }
            Op::Call(function, ref arguments) if arguments.len() != function.arity() => {
                Err(Flaw::Arity { function, given: arguments.len() })
            }
            Op::Advance { len: 0, .. } | Op::Retreat { len: 0, .. } => Err(Flaw::EmptyRing),
            Op::Measurement(at) if usize::from(at) >= self.measurements => Err(Flaw::NoSuchField(at)),
            Op::Input(at) if usize::from(at) >= self.inputs => Err(Flaw::NoSuchField(at)),
            Op::Ring { ring, .. } => self.ring(ring).map(|_| ()),
            Op::Lookup { table, column, .. } => self.column(table, column),
            Op::Gain { column } => self.column(self.row.ok_or(Flaw::GainOutsideLoop)?, column),
            _ => Ok(()),
        }
    }

    /// The type of a scalar cell.
    pub fn scalar_cell(&self, cell: CellId) -> Result<Type, Flaw> {
        match self.cells.get(usize::from(cell.0)).map(|cell| &cell.kind) {
            Some(CellKind::Float { .. }) => Ok(Type::Float),
            Some(CellKind::Index { .. }) => Ok(Type::Index),
            Some(CellKind::Ring { .. }) => Err(Flaw::WrongKind(cell)),
            None => Err(Flaw::NoSuchCell(cell)),
        }
    }

    /// The length of a ring.
    pub fn ring(&self, cell: CellId) -> Result<u32, Flaw> {
        match self.cells.get(usize::from(cell.0)).map(|cell| &cell.kind) {
            Some(CellKind::Ring { len, .. }) => Ok(*len),
            Some(_) => Err(Flaw::WrongKind(cell)),
            None => Err(Flaw::NoSuchCell(cell)),
        }
    }

    /// The table.
    pub fn table(&self, table: TableId) -> Result<&Table, Flaw> {
        self.tables.get(usize::from(table.0)).ok_or(Flaw::NoSuchTable(table))
    }

    /// Whether the table has the column.
    fn column(&self, table: TableId, column: u16) -> Result<(), Flaw> {
        if usize::from(column) < self.table(table)?.columns.len() {
            Ok(())
        } else {
            Err(Flaw::NoSuchColumn { table, column })
        }
    }
}

/// Whether a value has the type it is used with.
pub(in super::super) fn expect(value: Value, found: Type, expected: Type) -> Result<(), Flaw> {
    if found == expected { Ok(()) } else { Err(Flaw::WrongType { value, expected, found }) }
}

/// Whether a constant is finite and exact in the scalar type.
pub(in super::super) fn representable(x: f64, scalar: Scalar) -> Result<(), Flaw> {
    #[expect(clippy::cast_possible_truncation, reason = "the rounding is what is tested")]
    let single = f64::from(x as f32);
    let exact = match scalar {
        Scalar::F32 => single.to_bits() == x.to_bits(),
        Scalar::F64 => true,
    };
    if x.is_finite() && exact { Ok(()) } else { Err(Flaw::NotRepresentable(x)) }
}
