//! A constant after its one rounding, as a step carries it.

use crate::expr::Constant;
use crate::program::Scalar;
use crate::real::{Precision, Real};

/// A constant after its one rounding, in both float types.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settled {
    /// The nearest double.
    pub double: f64,
    /// The nearest single.
    pub single: f32,
}

impl Settled {
    /// Rounds once to each type.
    pub fn round(value: &Real) -> Self {
        Self { double: value.to_f64(), single: value.to_f32() }
    }

    /// As the step carries it.
    pub fn value(self, scalar: Scalar) -> f64 {
        match scalar {
            Scalar::F32 => f64::from(self.single),
            Scalar::F64 => self.double,
        }
    }
}

/// Bits at which a constant is evaluated before its one rounding.
const BITS: usize = 512;

/// A constant as the step carries it.
pub fn round(constant: &Constant, scalar: Scalar) -> f64 {
    match constant.evaluate(Precision::bits(BITS)) {
        Ok(value) => match scalar {
            Scalar::F32 => f64::from(value.to_f32()),
            Scalar::F64 => value.to_f64(),
        },
        // [`check`] refuses it.
        Err(_) => f64::NAN,
    }
}
