//! One operation as one C expression.

use super::super::plan::Place;
use super::C;
use crate::names;
use crate::program::{Function, Op, Status, TableId, Value};

impl C<'_> {
    /// A value where it is used, in any function but the step itself.
    pub fn value(&self, value: Value) -> String {
        match self.plan.place(value) {
            Place::Constant(op) => self.operation(op),
            Place::Local => names::temporary(value),
            Place::Work => format!("work->{}", names::temporary(value)),
            Place::Flag(at) => format!("work->flags[{at}]"),
        }
    }

    /// A value where the step itself uses it.
    pub fn result(&self, value: Value) -> String {
        let spelled = self.value(value);
        match spelled.strip_prefix("work->") {
            Some(field) => format!("work.{field}"),
            None => spelled,
        }
    }

    /// The right-hand side of a definition.
    pub fn operation(&self, op: &Op) -> String {
        let v = |value: &Value| self.value(*value);
        match op {
            Op::Float(x) => self.float(*x),
            Op::Bool(truth) => u8::from(*truth).to_string(),
            Op::Index(number) => format!("{number}U"),
            Op::Status(status) => self.status(*status),
            Op::Neg(a) => format!("-{}", v(a)),
            Op::Not(a) => format!("!{}", v(a)),
            Op::Difference { a, b, bits: 16 } => format!("((({} - {}) + 32768U) & 65535U) - 32768U", v(a), v(b)),
            Op::Add(a, b) | Op::WrapAdd(a, b) => format!("{} + {}", v(a), v(b)),
            Op::Sub(a, b) | Op::Difference { a, b, .. } => format!("{} - {}", v(a), v(b)),
            Op::Mul(a, b) => format!("{} * {}", v(a), v(b)),
            Op::Div(a, b) => format!("{} / {}", v(a), v(b)),
            Op::Less(a, b) | Op::IndexLess(a, b) => format!("{} < {}", v(a), v(b)),
            Op::LessEqual(a, b) => format!("{} <= {}", v(a), v(b)),
            Op::IndexEqual(a, b) => format!("{} == {}", v(a), v(b)),
            Op::And(a, b) => format!("{} && {}", v(a), v(b)),
            Op::Or(a, b) => format!("{} || {}", v(a), v(b)),
            Op::Call(function, arguments) => self.call(*function, arguments),
            Op::InRange { value, low, high } => {
                let value = v(value);
                format!("({} <= {value}) && ({value} <= {})", self.float(*low), self.float(*high))
            }
            Op::Select { condition, then, otherwise } => {
                if then == otherwise {
                    v(then)
                } else {
                    format!("{} ? {} : {}", v(condition), v(then), v(otherwise))
                }
            }
            Op::Advance { slot, len } => {
                bounded(&v(slot), len - 1, |slot, last| format!("({slot} < {last}U) ? ({slot} + 1U) : 0U"))
            }
            Op::Retreat { slot, len } => bounded(&v(slot), len - 1, |slot, last| {
                format!("(({slot} >= 1U) && ({slot} < {len}U)) ? ({slot} - 1U) : {last}U")
            }),
            Op::CountUp { count, max } => {
                bounded(&v(count), *max, |count, max| format!("({count} < {max}U) ? ({count} + 1U) : {max}U"))
            }
            Op::CountDown(count) => format!("({0} > 0U) ? ({0} - 1U) : 0U", v(count)),
            Op::AtMost { value, max } => {
                bounded(&v(value), *max, |value, max| format!("({value} < {max}U) ? {value} : {max}U"))
            }
            Op::Remainder { value, modulus } => format!("{} % {modulus}U", v(value)),
            Op::ToFloat(index) => format!("({}){}", self.scalar(), v(index)),
            Op::SignedToFloat(index) => {
                let (scalar, index) = (self.scalar(), v(index));
                format!("({index} < 2147483648U) ? ({scalar}){index} : -({scalar})(0U - {index})")
            }
            Op::FromFloat(x) => {
                format!("{}_index_from_{}({})", self.plan.names.lower, self.plan.program.scalar, v(x))
            }
            Op::Measurement(at) => {
                format!("measurements->{}", self.plan.program.measurements[usize::from(*at)].name)
            }
            Op::Given(at) => format!("estimate->{}", self.plan.program.estimates[usize::from(*at)].0.name),
            Op::Vouched => format!("estimate->status == {}", self.status(Status::Converged)),
            Op::Count(at) => {
                format!("(uint32_t)measurements->{}", self.plan.program.measurements[usize::from(*at)].name)
            }
            Op::Input(at) => format!("inputs->{}", self.plan.program.inputs[usize::from(*at)].name),
            Op::Cell(cell) => self.cell_name(*cell),
            Op::Ring { ring, slot } => format!("{}[{}]", self.cell_name(*ring), v(slot)),
            Op::Lookup { table, row, column } => self.element(*table, &v(row), *column),
            Op::Gain { column } => format!("gains[{column}]"),
        }
    }

    /// `pendulum_sin_f32(a)`.
    fn call(&self, function: Function, arguments: &[Value]) -> String {
        let arguments: Vec<String> = arguments.iter().map(|argument| self.value(*argument)).collect();
        let (name, scalar) = (function.name(), self.plan.program.scalar);
        format!("{}_{name}_{scalar}({})", self.plan.names.lower, arguments.join(", "))
    }

    /// An element of a table.
    fn element(&self, table: TableId, row: &str, column: u16) -> String {
        format!("{}[{row}][{column}]", self.plan.names.prefixed_table(table))
    }

    /// A constant of the status type.
    fn status(&self, status: Status) -> String {
        let name = match status {
            Status::Converging => "CONVERGING",
            Status::Converged => "CONVERGED",
            Status::Coasting => "COASTING",
        };
        format!("{}_{name}", self.plan.names.upper)
    }
}

/// A form with a bound; a bound of 0 leaves nothing to decide, and a comparison with it would be a
/// mistake to the compiler.
fn bounded(value: &str, bound: u32, form: impl FnOnce(&str, u32) -> String) -> String {
    if bound == 0 { "0U".to_owned() } else { form(value, bound) }
}
