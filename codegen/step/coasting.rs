//! Calls since the newest accepted sample of any output: how long the model alone has carried the estimate.

use crate::program::builder::Builder;
use crate::program::{CellId, Value};

use super::logic::any;

/// Counts on; `good` are the samples that were accepted.
pub(crate) fn count(b: &mut Builder, cell: CellId, good: &[Value]) -> Value {
    let accepted = any(b, good);
    let (none, before) = (b.index(0), b.read(cell));
    let more = b.count_up(before, u32::MAX);
    let since = b.select(accepted, none, more);
    b.set(cell, since);
    since
}
