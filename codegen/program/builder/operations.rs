//! One method for each operation; what it computes is said at [`Op`].

use super::super::{CellId, Function, Op, Status, TableId, Value};
use super::Builder;

impl Builder {
    /// A constant, finite and representable in the Program's scalar type.
    pub fn float(&mut self, x: f64) -> Value {
        self.push(Op::Float(x))
    }

    /// `-a`.
    pub fn neg(&mut self, a: Value) -> Value {
        self.push(Op::Neg(a))
    }

    /// `a + b`.
    pub fn add(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Add(a, b))
    }

    /// `a - b`.
    pub fn sub(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Sub(a, b))
    }

    /// `a * b`.
    pub fn mul(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Mul(a, b))
    }

    /// `a / b`.
    pub fn div(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Div(a, b))
    }

    /// An elementary function.
    pub fn call(&mut self, function: Function, arguments: &[Value]) -> Value {
        self.push(Op::Call(function, arguments.to_vec()))
    }

    /// `a < b`; false when one is NaN.
    pub fn less(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Less(a, b))
    }

    /// `a <= b`; false when one is NaN.
    pub fn less_equal(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::LessEqual(a, b))
    }

    /// `low <= value && value <= high`; false for NaN.
    pub fn in_range(&mut self, value: Value, low: f64, high: f64) -> Value {
        self.push(Op::InRange { value, low, high })
    }

    /// A truth constant.
    pub fn boolean(&mut self, truth: bool) -> Value {
        self.push(Op::Bool(truth))
    }

    /// `a && b`.
    pub fn and(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::And(a, b))
    }

    /// `a || b`.
    pub fn or(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::Or(a, b))
    }

    /// `!a`.
    pub fn not(&mut self, a: Value) -> Value {
        self.push(Op::Not(a))
    }

    /// A status constant.
    pub fn status(&mut self, status: Status) -> Value {
        self.push(Op::Status(status))
    }

    /// `if condition { then } else { otherwise }`, of any type.
    pub fn select(&mut self, condition: Value, then: Value, otherwise: Value) -> Value {
        self.push(Op::Select { condition, then, otherwise })
    }

    /// An index constant.
    pub fn index(&mut self, number: u32) -> Value {
        self.push(Op::Index(number))
    }

    /// Index `a < b`.
    pub fn index_less(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::IndexLess(a, b))
    }

    /// Index `a == b`.
    pub fn index_equal(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::IndexEqual(a, b))
    }

    /// The slot after `slot` in a ring of `len`.
    pub fn advance(&mut self, slot: Value, len: u32) -> Value {
        self.push(Op::Advance { slot, len })
    }

    /// The slot before `slot` in a ring of `len`.
    pub fn retreat(&mut self, slot: Value, len: u32) -> Value {
        self.push(Op::Retreat { slot, len })
    }

    /// One more, up to `max`.
    pub fn count_up(&mut self, count: Value, max: u32) -> Value {
        self.push(Op::CountUp { count, max })
    }

    /// One less, down to 0.
    pub fn count_down(&mut self, count: Value) -> Value {
        self.push(Op::CountDown(count))
    }

    /// The index, or `max` if it is larger.
    pub fn at_most(&mut self, value: Value, max: u32) -> Value {
        self.push(Op::AtMost { value, max })
    }

    /// The index as a float.
    pub fn to_float(&mut self, index: Value) -> Value {
        self.push(Op::ToFloat(index))
    }

    /// The index as a signed number of 32 bits, as a float.
    pub fn signed_to_float(&mut self, index: Value) -> Value {
        self.push(Op::SignedToFloat(index))
    }

    /// The float, cut off towards zero, as a signed number of 32 bits.
    pub fn from_float(&mut self, x: Value) -> Value {
        self.push(Op::FromFloat(x))
    }

    /// `a + b` modulo 2^32.
    pub fn wrap_add(&mut self, a: Value, b: Value) -> Value {
        self.push(Op::WrapAdd(a, b))
    }

    /// `a - b` modulo 2^`bits`, 16 or 32, its sign extended to 32 bits.
    pub fn wrap_difference(&mut self, a: Value, b: Value, bits: u8) -> Value {
        self.push(Op::Difference { a, b, bits })
    }

    /// What is left of an index when it is divided by a number.
    pub fn remainder(&mut self, value: Value, modulus: u32) -> Value {
        self.push(Op::Remainder { value, modulus })
    }

    /// A measurement that is a count.
    pub fn read_count(&mut self, field: u16) -> Value {
        self.push(Op::Count(field))
    }

    /// A field of the estimate that a start is given; only in [`Builder::init_at`].
    pub fn given(&mut self, field: u16) -> Value {
        self.push(Op::Given(field))
    }

    /// Whether the caller vouches for that estimate.
    pub fn vouched(&mut self) -> Value {
        self.push(Op::Vouched)
    }

    /// A measurement.
    pub fn read_measurement(&mut self, field: u16) -> Value {
        self.push(Op::Measurement(field))
    }

    /// An input.
    pub fn read_input(&mut self, field: u16) -> Value {
        self.push(Op::Input(field))
    }

    /// A scalar cell as it is now.
    pub fn read(&mut self, cell: CellId) -> Value {
        self.push(Op::Cell(cell))
    }

    /// An element of a ring as it is now.
    pub fn read_ring(&mut self, ring: CellId, slot: Value) -> Value {
        self.push(Op::Ring { ring, slot })
    }

    /// An element of a table.
    pub fn lookup(&mut self, table: TableId, row: Value, column: u16) -> Value {
        self.push(Op::Lookup { table, row, column })
    }

    /// An element of the row that the loop is at; only inside [`Builder::loop_over`].
    pub fn gain(&mut self, column: u16) -> Value {
        self.push(Op::Gain { column })
    }
}
