//! The type of an operation, and whether it is well formed by itself.
//!
//! In: an operation, what it may refer to, the types of its operands. Out: the type of its result.
//! The builder asks while it builds, [`check`](super::check) afterwards.

use super::super::{Cell, CellId, CellKind, Field, Kind, Op, Program, Scalar, Table, TableId, Type, Value};
use super::Flaw;

/// What an operation may refer to.
pub(in super::super) struct Context<'a> {
    /// The Program's.
    pub scalar: Scalar,
    /// The Program's.
    pub measurements: &'a [Field],
    /// How many.
    pub inputs: usize,
    /// What the estimate has.
    pub estimates: &'a [(Field, Value)],
    /// Whether it is in [`Program::init_at`].
    pub starting: bool,
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
            measurements: &program.measurements,
            inputs: program.inputs.len(),
            estimates: &program.estimates,
            starting: false,
            cells: &program.cells,
            tables: &program.tables,
            row,
        }
    }

    /// Of a statement in [`Program::init_at`].
    pub fn starting(program: &'a Program) -> Self {
        Self { starting: true, ..Self::of(program, None) }
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
            | Op::Given(_)
            | Op::Gain { .. } => (Type::Float, Type::Float),
            Op::Less(..) | Op::LessEqual(..) | Op::InRange { .. } => (Type::Float, Type::Bool),
            Op::Bool(_) | Op::Vouched | Op::And(..) | Op::Or(..) | Op::Not(_) => (Type::Bool, Type::Bool),
            Op::Status(_) | Op::Select { .. } => (Type::Status, Type::Status),
            Op::Index(_)
            | Op::Advance { .. }
            | Op::Retreat { .. }
            | Op::CountUp { .. }
            | Op::CountDown(_)
            | Op::AtMost { .. }
            | Op::WrapAdd(..)
            | Op::Difference { .. }
            | Op::Remainder { .. }
            | Op::Count(_) => (Type::Index, Type::Index),
            Op::IndexLess(..) | Op::IndexEqual(..) => (Type::Index, Type::Bool),
            Op::ToFloat(_) | Op::SignedToFloat(_) | Op::Lookup { .. } => (Type::Index, Type::Float),
            Op::FromFloat(_) => (Type::Float, Type::Index),
            Op::Ring { ring, .. } => (Type::Index, self.element(*ring)?),
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
            Op::Remainder { modulus: 0, .. } => Err(Flaw::NoModulus),
            Op::Given(_) | Op::Vouched if !self.starting => Err(Flaw::NotAStart),
            Op::Measurement(_) | Op::Count(_) | Op::Input(_) if self.starting => Err(Flaw::NoSample),
            Op::Given(at) => match self.estimates.get(usize::from(at)) {
                Some((field, _)) if field.kind == Kind::Float => Ok(()),
                Some(_) => Err(Flaw::WrongField(at)),
                None => Err(Flaw::NoSuchField(at)),
            },
            Op::Measurement(at) => self.field(at, |kind| kind == Kind::Float),
            Op::Count(at) => self.field(at, |kind| matches!(kind, Kind::Count { .. })),
            Op::Difference { bits, .. } => width(bits),
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
            Some(CellKind::Ring { .. } | CellKind::Counts { .. }) => Err(Flaw::WrongKind(cell)),
            None => Err(Flaw::NoSuchCell(cell)),
        }
    }

    /// The type of a ring's elements.
    pub fn element(&self, cell: CellId) -> Result<Type, Flaw> {
        match self.cells.get(usize::from(cell.0)).map(|cell| &cell.kind) {
            Some(CellKind::Ring { .. }) => Ok(Type::Float),
            Some(CellKind::Counts { .. }) => Ok(Type::Index),
            Some(_) => Err(Flaw::WrongKind(cell)),
            None => Err(Flaw::NoSuchCell(cell)),
        }
    }

    /// The length of a ring.
    pub fn ring(&self, cell: CellId) -> Result<u32, Flaw> {
        match self.cells.get(usize::from(cell.0)).map(|cell| &cell.kind) {
            Some(CellKind::Ring { len, .. } | CellKind::Counts { len, .. }) => Ok(*len),
            Some(_) => Err(Flaw::WrongKind(cell)),
            None => Err(Flaw::NoSuchCell(cell)),
        }
    }

    /// Whether there is a measurement of that kind.
    fn field(&self, at: u16, is_right: impl FnOnce(Kind) -> bool) -> Result<(), Flaw> {
        match self.measurements.get(usize::from(at)) {
            Some(field) if is_right(field.kind) => Ok(()),
            Some(_) => Err(Flaw::WrongField(at)),
            None => Err(Flaw::NoSuchField(at)),
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

/// Whether there are integers of so many bits.
pub(in super::super) fn width(bits: u8) -> Result<(), Flaw> {
    if matches!(bits, 16 | 32) { Ok(()) } else { Err(Flaw::Width(bits)) }
}

/// Whether there are integers of so many bits, and the number is one.
pub(in super::super) fn fits(number: u32, bits: u8) -> Result<(), Flaw> {
    width(bits)?;
    if bits == 32 || number >> bits == 0 { Ok(()) } else { Err(Flaw::TooLarge { number, bits }) }
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
