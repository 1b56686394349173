//! Which values an operation uses.

use super::super::{Op, Value};

impl Op {
    /// The values it uses, in order; a value used twice is listed twice.
    #[must_use]
    pub fn operands(&self) -> Vec<Value> {
        self.clone().operands_mut().into_iter().map(|value| *value).collect()
    }

    /// The values it uses, in order, to be renamed.
    pub(in super::super) fn operands_mut(&mut self) -> Vec<&mut Value> {
        match self {
            Self::Float(_)
            | Self::Bool(_)
            | Self::Status(_)
            | Self::Index(_)
            | Self::Measurement(_)
            | Self::Input(_)
            | Self::Count(_)
            | Self::Given(_)
            | Self::Vouched
            | Self::Cell(_)
            | Self::Gain { .. } => vec![],
            Self::Neg(a)
            | Self::Not(a)
            | Self::CountDown(a)
            | Self::ToFloat(a)
            | Self::SignedToFloat(a)
            | Self::FromFloat(a)
            | Self::InRange { value: a, .. }
            | Self::Advance { slot: a, .. }
            | Self::Retreat { slot: a, .. }
            | Self::CountUp { count: a, .. }
            | Self::AtMost { value: a, .. }
            | Self::Remainder { value: a, .. }
            | Self::Ring { slot: a, .. }
            | Self::Lookup { row: a, .. } => vec![a],
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Less(a, b)
            | Self::LessEqual(a, b)
            | Self::And(a, b)
            | Self::Or(a, b)
            | Self::IndexLess(a, b)
            | Self::IndexEqual(a, b)
            | Self::WrapAdd(a, b)
            | Self::Difference { a, b, .. } => vec![a, b],
            Self::Select { condition, then, otherwise } => vec![condition, then, otherwise],
            Self::Call(_, arguments) => arguments.iter_mut().collect(),
        }
    }
}
