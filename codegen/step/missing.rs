//! Outputs that are missing while others are not.

use crate::program::builder::Builder;
use crate::program::{CellId, Value};

use super::logic::{all, any};

/// Whether an output that is `replaced` has been missing for a whole window while another has not; `missed` has a cell
/// per output, where there are several, and its window in calls.
///
/// Its predictions would then feed on themselves, corrected by what the others see of it; nothing makes
/// that recursion stable. With every output missing it is the plant's own model, which may go on.
pub(crate) fn abandoned(b: &mut Builder, missed: &[(CellId, u32)], good: &[Value], replaced: &[bool]) -> Option<Value> {
    let gone = gone(b, missed, good);
    if gone.is_empty() {
        return None;
    }
    let feeding: Vec<Value> =
        gone.iter().zip(replaced).filter(|(_, replaced)| **replaced).map(|(gone, _)| *gone).collect();
    let (any, all) = (any(b, &feeding), all(b, &gone));
    let some_left = b.not(all);
    Some(b.and(any, some_left))
}

/// Whether each output has been missing for a whole window; counts on.
fn gone(b: &mut Builder, missed: &[(CellId, u32)], good: &[Value]) -> Vec<Value> {
    let mut gone = Vec::new();
    for ((cell, samples), good) in missed.iter().zip(good) {
        let before = b.read(*cell);
        let below = b.index(samples - 1);
        let full = b.index_less(below, before);
        let missing = b.not(*good);
        gone.push(b.and(missing, full));
        let none = b.index(0);
        let more = b.count_up(before, *samples);
        let count = b.select(*good, none, more);
        b.set(*cell, count);
    }
    gone
}
