//! The Program: what one step does, as typed scalar operations in order.
//!
//! Knows typed scalar operations and their order. Never knows a matrix, a plant, a method or a language.
//!
//! In: constants that a design has rounded once. Out: the only thing that the emitters, the
//! interpreter and the cost count read. Every order of additions is written here, so that every back end keeps it.
//!
//! Invariants, all verified by [`check`](check::check):
//! - every value is defined once, before its uses, and used with its own type;
//! - every float constant is finite and representable in the Program's scalar type;
//! - every ring slot and table row is below its bound for any content of the cells;
//! - loops run over the rows of one constant table, so every bound is a constant.

pub mod builder;
pub mod check;
pub mod cost;
pub mod interp;
pub mod listing;
pub mod literal;

use std::fmt;

/// The float type of a step function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// IEEE 754 single precision.
    F32,
    /// IEEE 754 double precision.
    F64,
}

impl Scalar {
    /// Size in bytes.
    #[must_use]
    pub const fn bytes(self) -> u32 {
        match self {
            Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        })
    }
}

/// The type of a [`Value`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// A number of the Program's [`Scalar`] type.
    Float,
    /// An unsigned integer below 2^32: `usize` in Rust, `uint32_t` in C.
    Index,
    /// A truth value.
    Bool,
    /// What the step reports; see [`Status`].
    Status,
}

/// What a step says of its estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Status {
    /// Not yet converged: the estimate is the start, or what was last known.
    Converging = 0,
    /// Converged: the estimate is what the file's header promises.
    Converged = 1,
    /// A missing sample in the window was replaced by the model's prediction.
    Coasting = 2,
}

/// A value, defined once; written `t0`, `t1`, … in every language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub u32);

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "t{}", self.0)
    }
}

/// A place in [`Program::cells`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CellId(pub u16);

/// A place in [`Program::tables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TableId(pub u16);

/// An elementary function of the runtime (crate `deadbeat-math` and its C twin).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the names are the C99 names")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Exp,
    Log,
    Sqrt,
    Tanh,
    Pow,
}

impl Function {
    /// All of them, in the order of their declaration.
    pub const ALL: [Self; 12] = [
        Self::Sin,
        Self::Cos,
        Self::Tan,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Atan2,
        Self::Exp,
        Self::Log,
        Self::Sqrt,
        Self::Tanh,
        Self::Pow,
    ];

    /// The name in specifications and, with `_f32` or `_f64` behind it, in the runtime.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "asin",
            Self::Acos => "acos",
            Self::Atan => "atan",
            Self::Atan2 => "atan2",
            Self::Exp => "exp",
            Self::Log => "log",
            Self::Sqrt => "sqrt",
            Self::Tanh => "tanh",
            Self::Pow => "pow",
        }
    }

    /// How many arguments it takes.
    #[must_use]
    pub const fn arity(self) -> usize {
        match self {
            Self::Atan2 | Self::Pow => 2,
            _ => 1,
        }
    }
}

/// One operation. Float operations are IEEE 754, round to nearest even, one rounding each.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// Float: a constant, finite, representable in the Program's scalar type.
    Float(f64),
    /// Float: `-a`.
    Neg(Value),
    /// Float: `a + b`.
    Add(Value, Value),
    /// Float: `a - b`.
    Sub(Value, Value),
    /// Float: `a * b`.
    Mul(Value, Value),
    /// Float: `a / b`.
    Div(Value, Value),
    /// Float: an elementary function of the runtime.
    Call(Function, Vec<Value>),
    /// Bool: float `a < b`; false when one is NaN.
    Less(Value, Value),
    /// Bool: float `a <= b`; false when one is NaN.
    LessEqual(Value, Value),
    /// Bool: `low <= value && value <= high`; false for NaN. The bounds are constants.
    InRange {
        /// Float.
        value: Value,
        /// Finite, representable, not above `high`.
        low: f64,
        /// Finite, representable.
        high: f64,
    },
    /// Bool constant.
    Bool(bool),
    /// Bool: `a && b`.
    And(Value, Value),
    /// Bool: `a || b`.
    Or(Value, Value),
    /// Bool: `!a`.
    Not(Value),
    /// Status constant.
    Status(Status),
    /// Any type: `if condition { then } else { otherwise }`.
    Select {
        /// Bool.
        condition: Value,
        /// The value when true.
        then: Value,
        /// The value when false; of the same type.
        otherwise: Value,
    },
    /// Index constant.
    Index(u32),
    /// Bool: index `a < b`.
    IndexLess(Value, Value),
    /// Bool: index `a == b`.
    IndexEqual(Value, Value),
    /// Index: the next slot of a ring, `if slot < len - 1 { slot + 1 } else { 0 }`; below `len` for any slot.
    Advance {
        /// Index.
        slot: Value,
        /// At least 1.
        len: u32,
    },
    /// Index: the slot before, `if slot >= 1 && slot < len { slot - 1 } else { len - 1 }`; below `len` for any slot.
    Retreat {
        /// Index.
        slot: Value,
        /// At least 1.
        len: u32,
    },
    /// Index: `if count < max { count + 1 } else { max }`.
    CountUp {
        /// Index.
        count: Value,
        /// The end of the count.
        max: u32,
    },
    /// Index: `if count > 0 { count - 1 } else { 0 }`.
    CountDown(Value),
    /// Index: `if value < max { value } else { max }`.
    AtMost {
        /// Index.
        value: Value,
        /// The bound.
        max: u32,
    },
    /// Float: the index as a float, rounded to nearest even.
    ToFloat(Value),
    /// Float: the index as a signed number of 32 bits, two's complement, rounded to nearest even.
    SignedToFloat(Value),
    /// Index: the float towards zero as a signed number of 32 bits, two's complement. What is below the smallest or
    /// above the largest of these numbers that the scalar type has counts as that; NaN as 0.
    FromFloat(Value),
    /// Index: `a + b` modulo 2^32.
    WrapAdd(Value, Value),
    /// Index: `a - b` modulo 2^`bits`, its sign extended to 32 bits: how far a counter has come from `b` to `a`, right
    /// as long as that is less than half of its range.
    Difference {
        /// Index.
        a: Value,
        /// Index.
        b: Value,
        /// 16 or 32.
        bits: u8,
    },
    /// Index: what is left of an index when it is divided by a number.
    Remainder {
        /// Index.
        value: Value,
        /// At least 1.
        modulus: u32,
    },
    /// Float: a field of the measurements, of kind [`Kind::Float`].
    Measurement(u16),
    /// Index: a field of the measurements, of kind [`Kind::Count`], extended to 32 bits: by its sign if it has one.
    Count(u16),
    /// Float: a field of the inputs.
    Input(u16),
    /// Float: a field of the estimate that [`Program::init_at`] is given, of kind [`Kind::Float`]; only there.
    Given(u16),
    /// Bool: whether that estimate has converged: the caller vouches for it.
    Vouched,
    /// Float or Index: a scalar cell as it is now.
    Cell(CellId),
    /// Float or Index: an element of a ring as it is now; `slot` is proven below the ring's length.
    Ring {
        /// A cell of kind [`CellKind::Ring`] or [`CellKind::Counts`].
        ring: CellId,
        /// Index.
        slot: Value,
    },
    /// Float: an element of a table; `row` is proven below the number of rows.
    Lookup {
        /// The table.
        table: TableId,
        /// Index.
        row: Value,
        /// Below the number of columns.
        column: u16,
    },
    /// Float: an element of the row that the innermost loop is at.
    Gain {
        /// Below the number of columns of that loop's table.
        column: u16,
    },
}

/// One statement of a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A heading for the statements that follow; printed as a comment. Only at the top level.
    Section(String),
    /// Defines a value.
    Let {
        /// New.
        value: Value,
        /// What it is.
        op: Op,
    },
    /// Writes a scalar cell.
    SetCell {
        /// A cell of kind `Float` or `Index`.
        cell: CellId,
        /// Of the cell's type.
        value: Value,
    },
    /// Writes one element of a ring.
    SetRing {
        /// A cell of kind `Ring` or `Counts`.
        ring: CellId,
        /// Index, proven below the ring's length.
        slot: Value,
        /// Float, or Index for `Counts`.
        value: Value,
    },
    /// Runs its body once for each row of a table, in order.
    Loop(Loop),
}

/// A counted loop over the rows of one table.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// The table; [`Op::Gain`] in the body reads its current row.
    pub table: TableId,
    /// What one iteration hands to the next.
    pub carried: Vec<Carried>,
    /// `Let`, `SetCell` and `SetRing` only: loops do not nest.
    pub body: Vec<Statement>,
}

/// A value that changes from one iteration to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carried {
    /// In the body: its value in this iteration; behind the loop: its last value.
    pub value: Value,
    /// Its value in the first iteration; defined before the loop.
    pub start: Value,
    /// Its value in the next iteration; defined in the body, and not the `value` of another `Carried`.
    pub next: Value,
}

/// A field of the interface: a measurement, an input or an estimate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// An identifier of both languages.
    pub name: String,
    /// SI unit as in the specification, without brackets; may be empty.
    pub unit: String,
    /// One line; may be empty.
    pub doc: String,
    /// What it holds.
    pub kind: Kind,
}

/// What a field of the interface holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// A number of the Program's [`Scalar`] type.
    #[default]
    Float,
    /// The integer that a counter shows, two's complement if it has a sign; measurements only. It is never missing.
    Count {
        /// 16 or 32.
        bits: u8,
        /// Whether the counter goes below zero.
        signed: bool,
    },
    /// An unsigned integer of 32 bits; estimates only.
    Index,
}

/// A part of the observer's state.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// An identifier of both languages, unique among the cells.
    pub name: String,
    /// One line: what it holds, with its unit.
    pub doc: String,
    /// What it holds.
    pub kind: CellKind,
}

/// What a cell holds, and its value after `init`.
#[derive(Clone, Debug, PartialEq)]
pub enum CellKind {
    /// One float.
    Float {
        /// Finite, representable.
        init: f64,
    },
    /// One index.
    Index {
        /// The value after `init`.
        init: u32,
    },
    /// Floats by slot.
    Ring {
        /// At least 1.
        len: u32,
        /// Of every element; finite, representable.
        init: f64,
    },
    /// Indices by slot: the raw samples of a counter.
    Counts {
        /// At least 1.
        len: u32,
        /// Of every element; below 2^`bits`.
        init: u32,
        /// 16 or 32. Of an index that is written, an element of 16 bits keeps the low 16, and is read as them.
        bits: u8,
    },
}

/// A constant table: `rows` rows of `columns.len()` floats.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Upper case, an identifier of both languages, unique among the tables.
    pub name: String,
    /// One line: what it holds, where it comes from.
    pub doc: String,
    /// One line per column.
    pub columns: Vec<String>,
    /// At least one row; every element finite and representable.
    pub rows: Vec<Vec<f64>>,
}

/// One step function with its state.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// The specification's name, `snake_case`; prefixes everything.
    pub name: String,
    /// The float type.
    pub scalar: Scalar,
    /// Seconds between two calls, rounded to the scalar type.
    pub sample_time: f64,
    /// What the step measures; at least one.
    pub measurements: Vec<Field>,
    /// What was applied; may be empty.
    pub inputs: Vec<Field>,
    /// The state.
    pub cells: Vec<Cell>,
    /// The constants that are not in the text of an operation.
    pub tables: Vec<Table>,
    /// What a call does.
    pub body: Vec<Statement>,
    /// What a start from an estimate does once every cell has its first value; its values are not the body's.
    /// No loops, no measurements, no inputs.
    pub init_at: Option<Vec<Statement>>,
    /// What a call returns, written last.
    pub estimates: Vec<(Field, Value)>,
    /// What a call reports; of type [`Type::Status`].
    pub status: Value,
}

impl Program {
    /// Whether any operation reads the table; one that only counts a loop's rows is left out of the code.
    #[must_use]
    pub fn is_read(&self, table: TableId) -> bool {
        let reads = |statement: &Statement, row: Option<TableId>| match statement {
            Statement::Let { op: Op::Lookup { table: read, .. }, .. } => *read == table,
            Statement::Let { op: Op::Gain { .. }, .. } => row == Some(table),
            _ => false,
        };
        self.body.iter().chain(self.init_at.iter().flatten()).any(|statement| match statement {
            Statement::Loop(inner) => inner.body.iter().any(|it| reads(it, Some(inner.table))),
            _ => reads(statement, None),
        })
    }

    /// The tables that stand in the code.
    pub fn read_tables(&self) -> impl Iterator<Item = (TableId, &Table)> {
        let all = self.tables.iter().zip(0..).map(|(table, at)| (TableId(at), table));
        all.filter(|(at, _)| self.is_read(*at))
    }
}

pub(crate) fn place(index: usize) -> u16 {
    u16::try_from(index).unwrap_or_else(|_| unreachable!("a plant has at most 256 of each"))
}
