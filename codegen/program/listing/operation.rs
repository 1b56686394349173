//! The right-hand side of a definition.

use super::super::literal::float;
use super::super::{Field, Op, Program, Value};
use super::{cell, table_name};

/// The operation in the notation of the listing.
pub(super) fn text(op: &Op, program: &Program) -> String {
    let number = |x: f64| float(x, program.scalar);
    match op {
        Op::Float(x) => number(*x),
        Op::Neg(a) => format!("-{a}"),
        Op::Add(a, b) => format!("{a} + {b}"),
        Op::Sub(a, b) => format!("{a} - {b}"),
        Op::Mul(a, b) => format!("{a} * {b}"),
        Op::Div(a, b) => format!("{a} / {b}"),
        Op::Call(function, arguments) => format!("{}({})", function.name(), list(arguments)),
        Op::Less(a, b) | Op::IndexLess(a, b) => format!("{a} < {b}"),
        Op::LessEqual(a, b) => format!("{a} <= {b}"),
        Op::InRange { value, low, high } => {
            format!("{} <= {value} <= {}", number(*low), number(*high))
        }
        Op::Bool(truth) => truth.to_string(),
        Op::And(a, b) => format!("{a} and {b}"),
        Op::Or(a, b) => format!("{a} or {b}"),
        Op::Not(a) => format!("not {a}"),
        Op::Status(status) => format!("{status:?}").to_lowercase(),
        Op::Select { condition, then, otherwise } => {
            format!("if {condition} then {then} else {otherwise}")
        }
        Op::Index(number) => number.to_string(),
        Op::IndexEqual(a, b) => format!("{a} == {b}"),
        Op::Advance { slot, len } => format!("advance({slot}, {len})"),
        Op::Retreat { slot, len } => format!("retreat({slot}, {len})"),
        Op::CountUp { count, max } => format!("count_up({count}, {max})"),
        Op::CountDown(count) => format!("count_down({count})"),
        Op::AtMost { value, max } => format!("at_most({value}, {max})"),
        Op::Remainder { value, modulus } => format!("{value} % {modulus}"),
        Op::ToFloat(index) => format!("float({index})"),
        Op::SignedToFloat(index) => format!("float(signed {index})"),
        Op::FromFloat(x) => format!("integer({x})"),
        Op::WrapAdd(a, b) => format!("wrap({a} + {b})"),
        Op::Difference { a, b, bits } => format!("difference{bits}({a}, {b})"),
        Op::Measurement(at) | Op::Count(at) => format!("measurement.{}", field(&program.measurements, *at)),
        Op::Given(at) => {
            let known = program.estimates.get(usize::from(*at));
            known.map_or_else(|| format!("given.{at}"), |(field, _)| format!("given.{}", field.name))
        }
        Op::Vouched => "vouched".to_owned(),
        Op::Input(at) => format!("input.{}", field(&program.inputs, *at)),
        Op::Cell(at) => cell(*at, program),
        Op::Ring { ring, slot } => format!("{}[{slot}]", cell(*ring, program)),
        Op::Lookup { table, row, column } => {
            format!("{}[{row}].{column}", table_name(*table, program))
        }
        Op::Gain { column } => format!("row.{column}"),
    }
}

/// `t1, t2`.
fn list(values: &[Value]) -> String {
    values.iter().map(Value::to_string).collect::<Vec<_>>().join(", ")
}

/// The field's name, or its number if it is not declared.
fn field(fields: &[Field], at: u16) -> String {
    let known = fields.get(usize::from(at));
    known.map_or_else(|| at.to_string(), |field| field.name.clone())
}
