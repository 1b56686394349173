//! Truths taken together.

use crate::program::Value;
use crate::program::builder::Builder;

/// Whether all of some truths hold.
pub(crate) fn all(b: &mut Builder, values: &[Value]) -> Value {
    let first = b.boolean(true);
    values.iter().fold(first, |sum, value| b.and(sum, *value))
}

/// Whether one of some truths holds.
pub(crate) fn any(b: &mut Builder, values: &[Value]) -> Value {
    let first = b.boolean(false);
    values.iter().fold(first, |sum, value| b.or(sum, *value))
}
