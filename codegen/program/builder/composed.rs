//! Forms of several operations that lowerings share; each says what it does with NaN.

use super::super::Value;
use super::Builder;

/// The most terms that are added one behind the other.
const CHAIN: usize = 4;

/// The most additions that a term of [`Builder::sum`] goes through.
pub fn additions(terms: usize) -> usize {
    if terms <= CHAIN { terms.saturating_sub(1) } else { CHAIN - 1 + additions(terms.div_ceil(CHAIN)) }
}

impl Builder {
    /// The sum in a fixed, balanced order: neighbours in groups of nearly equal size, none above
    /// four, each group from left to right; then the groups' sums likewise. The empty sum is 0.
    pub fn sum(&mut self, terms: &[Value]) -> Value {
        match *terms {
            [] => self.float(0.0),
            [first, ref rest @ ..] if terms.len() <= CHAIN => rest.iter().fold(first, |sum, term| self.add(sum, *term)),
            _ => {
                let groups = terms.len().div_ceil(CHAIN);
                let start = |group: usize| group * terms.len() / groups;
                let sums: Vec<Value> =
                    (0..groups).map(|group| self.sum(&terms[start(group)..start(group + 1)])).collect();
                self.sum(&sums)
            }
        }
    }

    /// `a + b` and what its rounding left out, exactly, whichever is larger (Knuth's two-sum): six operations that
    /// hold as long as nobody reorders them.
    pub fn two_sum(&mut self, a: Value, b: Value) -> (Value, Value) {
        let sum = self.add(a, b);
        let of_b = self.sub(sum, a);
        let of_a = self.sub(sum, of_b);
        let rest_of_b = self.sub(b, of_b);
        let rest_of_a = self.sub(a, of_a);
        (sum, self.add(rest_of_a, rest_of_b))
    }

    /// `if v <= 0 { 0 - v } else { v }`: +0 for both zeros; NaN stays NaN.
    pub fn absolute(&mut self, v: Value) -> Value {
        let zero = self.float(0.0);
        let low = self.less_equal(v, zero);
        let mirrored = self.sub(zero, v);
        self.select(low, mirrored, v)
    }

    /// 1 above zero, -1 below; a zero stays that zero and NaN stays NaN.
    pub fn sign(&mut self, v: Value) -> Value {
        let (zero, one, minus_one) = (self.float(0.0), self.float(1.0), self.float(-1.0));
        let above = self.less(zero, v);
        let below = self.less(v, zero);
        let rest = self.select(below, minus_one, v);
        self.select(above, one, rest)
    }

    /// `if b < a { b } else { a }`: `a` when they are equal or either is NaN, so NaN in `a` stays
    /// and NaN in `b` is dropped.
    pub fn minimum(&mut self, a: Value, b: Value) -> Value {
        let lower = self.less(b, a);
        self.select(lower, b, a)
    }

    /// `if a < b { b } else { a }`: `a` when they are equal or either is NaN, so NaN in `a` stays
    /// and NaN in `b` is dropped.
    pub fn maximum(&mut self, a: Value, b: Value) -> Value {
        let higher = self.less(a, b);
        self.select(higher, b, a)
    }

    /// `v` to the power `n` by repeated squaring, from the exponent's highest bit down: each bit
    /// squares, each set bit multiplies by `v` behind that. `n = 0` gives 1, for NaN too.
    pub fn power(&mut self, v: Value, n: u32) -> Value {
        let Some(highest) = n.checked_ilog2() else {
            return self.float(1.0);
        };
        (0..highest).rev().fold(v, |power, bit| {
            let square = self.mul(power, power);
            if n >> bit & 1 == 1 { self.mul(square, v) } else { square }
        })
    }
}
