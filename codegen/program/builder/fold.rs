//! Folding: what is known while building is computed while building, in the target's own type.
//!
//! Only exact rewrites: constants whose result is finite, `1 * x`, decisions already made.
//! Deliberately absent: `x + 0` (it loses the sign of a zero), `0 * x` (it loses NaN), any
//! reassociation, any division turned into a product.

use super::super::interp::arithmetic::{
    Number, advance, at_most, count_down, count_up, difference, remainder, retreat,
};
use super::super::{Op, Scalar, Value};

/// What an operation turned out to be.
pub(super) enum Folded {
    /// A value that exists.
    Same(Value),
    /// A constant.
    Constant(Op),
}

/// The simpler form of the operation; `known` tells how a value was defined.
pub(super) fn fold<'a>(op: &Op, scalar: Scalar, known: impl Fn(Value) -> Option<&'a Op>) -> Option<Folded> {
    if let Some(constant) = by_form(op, &known) {
        return Some(Folded::Constant(constant));
    }
    decided(op, &known).map(Folded::Same).or_else(|| {
        let operands: Option<Vec<&Op>> = op.operands().into_iter().map(&known).collect();
        let operands = operands.filter(|operands| !operands.is_empty())?;
        match scalar {
            Scalar::F32 => float::<f32>(op, &operands),
            Scalar::F64 => float::<f64>(op, &operands),
        }
        .or_else(|| index(op, &operands))
        .map(Folded::Constant)
    })
}

/// The result whatever the operands hold: a comparison that can go only one way, a bound of 0.
fn by_form<'a>(op: &Op, known: &impl Fn(Value) -> Option<&'a Op>) -> Option<Op> {
    match *op {
        Op::Less(a, b) | Op::IndexLess(a, b) if a == b => Some(Op::Bool(false)),
        Op::IndexLess(_, b) if known(b) == Some(&Op::Index(0)) => Some(Op::Bool(false)),
        Op::IndexLess(a, _) if known(a) == Some(&Op::Index(u32::MAX)) => Some(Op::Bool(false)),
        Op::IndexEqual(a, b) if a == b => Some(Op::Bool(true)),
        Op::Difference { a, b, .. } if a == b => Some(Op::Index(0)),
        Op::Advance { len: 1, .. }
        | Op::Retreat { len: 1, .. }
        | Op::CountUp { max: 0, .. }
        | Op::AtMost { max: 0, .. }
        | Op::Remainder { modulus: 1, .. } => Some(Op::Index(0)),
        _ => None,
    }
}

/// One operand is the result: `1 * x`, a known condition, equal branches.
fn decided<'a>(op: &Op, known: &impl Fn(Value) -> Option<&'a Op>) -> Option<Value> {
    let truth = |value| match known(value) {
        Some(Op::Bool(truth)) => Some(*truth),
        _ => None,
    };
    let one = |value| matches!(known(value), Some(Op::Float(x)) if x.to_bits() == 1.0_f64.to_bits());
    match *op {
        Op::Mul(a, b) if one(a) => Some(b),
        Op::Mul(a, b) if one(b) => Some(a),
        Op::Select { then, otherwise, .. } if then == otherwise => Some(then),
        Op::Select { condition, then, otherwise } => truth(condition).map(|truth| if truth { then } else { otherwise }),
        Op::And(a, b) | Op::Or(a, b) if a == b => Some(a),
        Op::And(a, b) => match (truth(a), truth(b)) {
            (Some(true), _) | (_, Some(false)) => Some(b),
            (Some(false), _) | (_, Some(true)) => Some(a),
            _ => None,
        },
        Op::Or(a, b) => match (truth(a), truth(b)) {
            (Some(false), _) | (_, Some(true)) => Some(b),
            (Some(true), _) | (_, Some(false)) => Some(a),
            _ => None,
        },
        _ => None,
    }
}

/// A float operation on constants, if its result is finite, or a comparison of constants.
fn float<N: Number>(op: &Op, operands: &[&Op]) -> Option<Op> {
    let finite = |x: N| Some(x.to_f64()).filter(|x| x.is_finite()).map(Op::Float);
    let number = |x: f64| N::from_f64(x);
    match (op, operands) {
        (Op::Neg(_), [Op::Float(a)]) => finite(-number(*a)),
        (Op::Add(..), [Op::Float(a), Op::Float(b)]) => finite(number(*a) + number(*b)),
        (Op::Sub(..), [Op::Float(a), Op::Float(b)]) => finite(number(*a) - number(*b)),
        (Op::Mul(..), [Op::Float(a), Op::Float(b)]) => finite(number(*a) * number(*b)),
        (Op::Div(..), [Op::Float(a), Op::Float(b)]) => finite(number(*a) / number(*b)),
        (Op::Call(function, _), [Op::Float(a)]) => finite(N::call(*function, number(*a), N::default())),
        (Op::Call(function, _), [Op::Float(a), Op::Float(b)]) => finite(N::call(*function, number(*a), number(*b))),
        (Op::ToFloat(_), [Op::Index(a)]) => finite(N::from_index(*a)),
        (Op::SignedToFloat(_), [Op::Index(a)]) => finite(N::from_signed(*a)),
        (Op::FromFloat(_), [Op::Float(a)]) => Some(Op::Index(number(*a).to_signed())),
        (Op::Less(..), [Op::Float(a), Op::Float(b)]) => Some(Op::Bool(a < b)),
        (Op::LessEqual(..), [Op::Float(a), Op::Float(b)]) => Some(Op::Bool(a <= b)),
        (Op::InRange { low, high, .. }, [Op::Float(a)]) => Some(Op::Bool(low <= a && a <= high)),
        _ => None,
    }
}

/// An operation on index or truth constants.
fn index(op: &Op, operands: &[&Op]) -> Option<Op> {
    match (op, operands) {
        (Op::Not(_), [Op::Bool(a)]) => Some(Op::Bool(!a)),
        (Op::IndexLess(..), [Op::Index(a), Op::Index(b)]) => Some(Op::Bool(a < b)),
        (Op::IndexEqual(..), [Op::Index(a), Op::Index(b)]) => Some(Op::Bool(a == b)),
        (Op::Advance { len, .. }, [Op::Index(a)]) => Some(Op::Index(advance(*a, *len))),
        (Op::Retreat { len, .. }, [Op::Index(a)]) => Some(Op::Index(retreat(*a, *len))),
        (Op::CountUp { max, .. }, [Op::Index(a)]) => Some(Op::Index(count_up(*a, *max))),
        (Op::CountDown(_), [Op::Index(a)]) => Some(Op::Index(count_down(*a))),
        (Op::WrapAdd(..), [Op::Index(a), Op::Index(b)]) => Some(Op::Index(a.wrapping_add(*b))),
        (Op::Difference { bits, .. }, [Op::Index(a), Op::Index(b)]) => {
            Some(Op::Index(difference(*a, *b, (*bits).into())))
        }
        (Op::Remainder { modulus, .. }, [Op::Index(a)]) if *modulus > 0 => Some(Op::Index(remainder(*a, *modulus))),
        (Op::AtMost { max, .. }, [Op::Index(a)]) => Some(Op::Index(at_most(*a, *max))),
        _ => None,
    }
}
