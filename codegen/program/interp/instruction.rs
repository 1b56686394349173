//! What the interpreter's machine can do.
//!
//! An instruction has an opcode and up to four operands. Its meaning is that of the [`Op`]s it
//! stands for, each rounded by itself: `MulAdd` rounds the product, then the sum.
//!
//! [`Op`]: super::super::Op

use super::super::{CellId, TableId, Value};

/// What an instruction does; `d` is its first operand, `a`, `b`, `c` the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Opcode {
    /// Float `d = a`.
    MoveFloat,
    /// Word `d = a`.
    MoveWord,
    /// `d = -a`.
    Neg,
    /// `d = a + b`.
    Add,
    /// `d = a - b`.
    Sub,
    /// `d = a * b`.
    Mul,
    /// `d = a / b`.
    Div,
    /// `d = a * b + c`, two roundings.
    MulAdd,
    /// `d = c - a * b`, two roundings.
    MulSub,
    /// `d = row[a]`.
    Gain,
    /// `d = row[a] * b`.
    GainMul,
    /// `d = row[a] * b + c`, two roundings.
    GainMulAdd,
    /// `d = function a of (b, c)`.
    Call,
    /// `d = a < b`.
    Less,
    /// `d = a <= b`.
    LessEqual,
    /// `d = b <= a && a <= c`.
    InRange,
    /// `d = a && b`.
    And,
    /// `d = a || b`.
    Or,
    /// `d = !a`.
    Not,
    /// Float `d = if a { b } else { c }`.
    SelectFloat,
    /// Word `d = if a { b } else { c }`.
    SelectWord,
    /// `d = a < b`.
    IndexLess,
    /// `d = a == b`.
    IndexEqual,
    /// The slot behind `a` in a ring of `b`.
    Advance,
    /// The slot before `a` in a ring of `b`.
    Retreat,
    /// One more than `a`, up to `b`.
    CountUp,
    /// One less than `a`, down to 0.
    CountDown,
    /// The smaller of `a` and `b`.
    AtMost,
    /// What is left of `a` divided by `b`.
    Remainder,
    /// `d = a as float`.
    ToFloat,
    /// `d = a as signed as float`.
    SignedToFloat,
    /// `d = a as signed`.
    FromFloat,
    /// `d = a + b` modulo 2^32.
    WrapAdd,
    /// `d = a - b` modulo 2^`c`, extended.
    Difference,
    /// `d = ring a [b]`.
    ReadRing,
    /// `ring d [a] = b`.
    WriteRing,
    /// `d = counts a [b]`.
    ReadCounts,
    /// `counts d [a] = b & c`.
    WriteCounts,
    /// `d = table a [row b][column c]`.
    Lookup,
}

/// The two register files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Class {
    /// Floats.
    Float,
    /// Indices, truth values and statuses.
    Word,
}

/// What a register holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Content {
    /// A value of the Program; its register is reused behind its last use.
    Value(Value),
    /// A constant: the bits of a double, or a word.
    Constant(u64),
    /// A scalar cell.
    Cell(CellId),
    /// A measurement.
    Measurement(u16),
    /// An input.
    Input(u16),
    /// A field of the estimate that a start is given.
    Given(u16),
    /// Whether the caller vouches for it.
    Vouched,
}

/// A register before it has a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Place {
    pub class: Class,
    pub content: Content,
}

impl Place {
    /// A constant: the bits of a double, or a word.
    pub fn constant(class: Class, bits: u64) -> Self {
        Self { class, content: Content::Constant(bits) }
    }
}

/// One operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operand {
    /// Not used by this opcode.
    None,
    /// The result.
    Write(Place),
    /// An argument.
    Read(Place),
    /// A column, a table, or a function.
    Number(u16),
    /// A ring that is read.
    ReadRing(CellId),
    /// A ring that is written.
    WriteRing(CellId),
}

/// One instruction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instruction {
    pub opcode: Opcode,
    pub operands: [Operand; 4],
}

impl Instruction {
    /// Whether its result goes there.
    pub fn writes(&self, place: Place) -> bool {
        self.operands.contains(&Operand::Write(place))
    }

    /// Whether it uses what is there.
    pub fn reads(&self, place: Place) -> bool {
        self.operands.contains(&Operand::Read(place))
    }

    /// Lets it use one register in the place of another.
    pub fn rename(&mut self, old: Place, new: Place) {
        for operand in &mut self.operands {
            match operand {
                Operand::Read(place) | Operand::Write(place) if *place == old => *place = new,
                _ => {}
            }
        }
    }
}

/// Instructions that are executed together.
pub(super) enum Block {
    /// Once.
    Once(Vec<Instruction>),
    /// Once for each row of the table.
    PerRow(TableId, Vec<Instruction>),
}
