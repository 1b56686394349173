//! What can be wrong with a Program, as data.

use std::fmt;

use super::super::{CellId, Function, Kind, TableId, Type, Value};

/// Why a Program is refused, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckError {
    /// The statement as in the listing, or the part of the Program that is not a statement.
    pub place: String,
    /// What is wrong there.
    pub flaw: Flaw,
}

impl fmt::Display for CheckError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.flaw)
    }
}

impl std::error::Error for CheckError {}

/// A broken rule.
#[derive(Clone, Debug, PartialEq)]
pub enum Flaw {
    /// A value is used that is not defined before, or only inside a loop.
    Undefined(Value),
    /// A value is defined twice.
    DefinedTwice(Value),
    /// A value is used with a type that it does not have.
    WrongType {
        /// The value.
        value: Value,
        /// What its use asks for.
        expected: Type,
        /// What it is.
        found: Type,
    },
    /// A function is called with too many or too few arguments.
    Arity {
        /// The function.
        function: Function,
        /// How many arguments it is given.
        given: usize,
    },
    /// A constant is not finite, or not exact in the scalar type.
    NotRepresentable(f64),
    /// The bounds of a range contain nothing.
    EmptyRange {
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// A measurement or input is read that is not declared.
    NoSuchField(u16),
    /// A float is read as a count, or a count as a float.
    WrongField(u16),
    /// A field holds what no field of that part of the interface can.
    WrongPart(Kind),
    /// An integer of other than 16 or 32 bits.
    Width(u8),
    /// A number that does not fit into so many bits.
    TooLarge {
        /// The number.
        number: u32,
        /// How many bits there are.
        bits: u8,
    },
    /// A cell is used that is not declared.
    NoSuchCell(CellId),
    /// A ring is used as a scalar cell, or a scalar cell as a ring.
    WrongKind(CellId),
    /// A table is used that is not declared.
    NoSuchTable(TableId),
    /// A column is read that the table does not have.
    NoSuchColumn {
        /// The table.
        table: TableId,
        /// The column.
        column: u16,
    },
    /// A gain is read outside of a loop.
    GainOutsideLoop,
    /// The estimate that a start is given is read in a step.
    NotAStart,
    /// A measurement or input is read in a start.
    NoSample,
    /// A loop stands in a start.
    LoopInStart,
    /// A loop stands in a loop.
    NestedLoop,
    /// A heading stands in a loop.
    SectionInLoop,
    /// What a loop hands on is not defined in its body.
    NextNotInBody(Value),
    /// A slot or row may reach past the end.
    OutOfBounds {
        /// The slot or row.
        value: Value,
        /// The largest number it may be.
        at_most: u32,
        /// The length of the ring or the number of rows.
        len: u64,
    },
    /// A ring without a slot.
    EmptyRing,
    /// A division by zero.
    NoModulus,
    /// A table without a row or without a column.
    EmptyTable,
    /// A row of a table is shorter or longer than its list of columns.
    RaggedRow(usize),
    /// Nothing is measured.
    NoMeasurement,
    /// The time between two calls is not a positive number.
    SampleTime(f64),
    /// A name that is not an identifier in the form asked for.
    Name(String),
    /// Two of a kind have the same name.
    SameName(String),
    /// A unit, a heading or a description that is not one line.
    NotOneLine(String),
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Undefined(value) => write!(f, "{value} is not defined here"),
            Self::DefinedTwice(value) => write!(f, "{value} is defined twice"),
            Self::WrongType { value, expected, found } => {
                write!(f, "{value} is of type {found:?}, not {expected:?}")
            }
            Self::Arity { function, given } => {
                let (name, arity) = (function.name(), function.arity());
                write!(f, "{name} takes {arity} arguments, not {given}")
            }
            Self::NotRepresentable(x) => write!(f, "{x:e} is not a finite number of the scalar type"),
            Self::EmptyRange { low, high } => write!(f, "{low:e} is above {high:e}"),
            Self::NoSuchField(at) => write!(f, "there is no field {at}"),
            Self::WrongField(at) => write!(f, "field {at} is of another kind"),
            Self::WrongPart(kind) => write!(f, "{kind:?} cannot be of a field there"),
            Self::Width(bits) => write!(f, "an integer has 16 or 32 bits, not {bits}"),
            Self::TooLarge { number, bits } => write!(f, "{number} does not fit into {bits} bits"),
            Self::NoSuchCell(CellId(at)) => write!(f, "there is no cell {at}"),
            Self::WrongKind(CellId(at)) => write!(f, "cell {at} is of another kind"),
            Self::NoSuchTable(TableId(at)) => write!(f, "there is no table {at}"),
            Self::NoSuchColumn { table: TableId(at), column } => {
                write!(f, "table {at} has no column {column}")
            }
            Self::GainOutsideLoop => write!(f, "a gain outside of a loop"),
            Self::NotAStart => write!(f, "a step is not given an estimate"),
            Self::NoSample => write!(f, "a start has no measurement and no input"),
            Self::LoopInStart => write!(f, "a loop in a start"),
            Self::NestedLoop => write!(f, "a loop inside a loop"),
            Self::SectionInLoop => write!(f, "a section inside a loop"),
            Self::NextNotInBody(value) => write!(f, "{value} is not defined in the loop's body"),
            Self::OutOfBounds { value, at_most, len } => {
                write!(f, "{value} may be {at_most}, which is not below {len}")
            }
            Self::NoModulus => write!(f, "nothing is left of a division by zero"),
            Self::EmptyRing => write!(f, "a ring has at least one slot"),
            Self::EmptyTable => write!(f, "a table has at least one row and one column"),
            Self::RaggedRow(row) => write!(f, "row {row} does not have one element per column"),
            Self::NoMeasurement => write!(f, "there is no measurement"),
            Self::SampleTime(x) => write!(f, "{x:e} s is not a sample time"),
            Self::Name(name) => write!(f, "`{name}` is not an identifier of this kind"),
            Self::SameName(name) => write!(f, "the name `{name}` is used twice"),
            Self::NotOneLine(text) => write!(f, "{text:?} is not one line"),
        }
    }
}
