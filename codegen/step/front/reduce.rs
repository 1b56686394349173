//! A sample brought within half a turn of zero, however many turns it has made: to about the last bit of the result.
//!
//! With whole turns n, `y - n w` would be off by the rounding of `n w` and by n times that of w, and would jump by it
//! where n changes. So w stands in parts, the first with so few digits that n times them are exact (Cody and Waite,
//! Software Manual for the Elementary Functions, 1980).

use super::{in_scalar, turns};
use crate::expr::Constant;
use crate::program::builder::Builder;
use crate::program::{Scalar, Value};
use crate::real::{Precision, Real};
use crate::sampled::settled::round;

/// Bits at which a turn is taken apart.
const BITS: usize = 512;

/// A sample less its whole turns; a sample within half a turn stays as it is, bit for bit.
pub(super) fn reduce(b: &mut Builder, value: Value, turn: &Constant, scalar: Scalar) -> Value {
    let whole = turns(b, value, round(turn, scalar));
    let parts = parts(turn, scalar);
    parts.into_iter().fold(value, |rest, part| {
        let part = b.float(part);
        let taken = b.mul(whole, part);
        b.sub(rest, taken)
    })
}

/// The parts of a turn, largest first: exact times up to 2^13 turns in single precision, 2^20 in double; the last one
/// rounded once. What is zero is left out.
fn parts(turn: &Constant, scalar: Scalar) -> Vec<f64> {
    let (digits, count) = match scalar {
        Scalar::F32 => (11, 2),
        Scalar::F64 => (33, 1),
    };
    let Ok(mut rest) = turn.evaluate(Precision::bits(BITS)) else { return vec![round(turn, scalar)] };
    let mut parts = Vec::new();
    for _ in 0..count {
        let part = in_scalar(cut(rest.to_f64(), digits), scalar);
        parts.push(part);
        rest = &rest - &Real::from_f64(part, Precision::bits(BITS)).unwrap_or_else(|| rest.clone());
    }
    parts.push(match scalar {
        Scalar::F32 => f64::from(rest.to_f32()),
        Scalar::F64 => rest.to_f64(),
    });
    parts.retain(|part| *part != 0.0);
    parts
}

/// The first binary digits of a number.
fn cut(value: f64, digits: u32) -> f64 {
    let others = (1_u64 << (f64::MANTISSA_DIGITS - digits)) - 1;
    f64::from_bits(value.to_bits() & !others)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parts of 2 pi add up to it, and a whole number has one.
    #[test]
    fn a_turn_in_parts() {
        let turn = |text: &str| Constant::from(crate::decimal::parse(text).unwrap());
        assert_eq!(parts(&turn("360"), Scalar::F32), [360.0]);
        assert_eq!(parts(&turn("65536"), Scalar::F64), [65_536.0]);
        let third = parts(&turn("0.1"), Scalar::F32);
        assert_eq!(third.len(), 3);
        assert!((third.iter().sum::<f64>() - 0.1).abs() < 1e-15);
        let whole = 8_191.0_f32;
        // Eleven digits times thirteen fit into a single.
        #[expect(clippy::cast_possible_truncation, reason = "a part is a single")]
        let part = third[0] as f32;
        assert_eq!(f64::from(whole * part), 8_191.0 * third[0]);
    }
}
