//! Values of nonlinear terms as they are used: the last good one in place of one that is not finite or beyond the guard.

use crate::program::Value;
use crate::program::builder::Builder;

use super::guard::Guard;

/// A term's value, `last` in place of a bad one; and whether it was good, where it may be bad.
pub(crate) fn guarded(
    b: &mut Builder,
    guard: &Guard,
    injection: usize,
    value: Value,
    last: impl FnOnce(&mut Builder) -> Value,
) -> (Value, Option<Value>) {
    if !guard.injections[injection] {
        return (value, None);
    }
    let good = b.in_range(value, -guard.bound, guard.bound);
    let last = last(b);
    (b.select(good, value, last), Some(good))
}
