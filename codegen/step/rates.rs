//! Outputs at several rates: which are due at a call, counted from the first call on, whatever is missing.
//!
//! A sample that is not due is not looked at and not missing. The first call is one at which every output is due.

use crate::plant::{Output, Plant};
use crate::program::builder::Builder;
use crate::program::{CellId, Value};

use super::logic::all;

/// Per output that is not due at every call, its count.
pub(crate) fn cells(b: &mut Builder, plant: &Plant) -> Vec<Option<CellId>> {
    let cell = |output: &Output| {
        let name = &output.label.name;
        (output.every > 1).then(|| b.index_cell(&format!("until_{name}"), &format!("calls until {name} is due"), 0))
    };
    plant.outputs.iter().map(cell).collect()
}

/// Per output that is not due at every call, whether it is due now.
pub(crate) fn due(b: &mut Builder, plant: &Plant, cells: &[Option<CellId>]) -> Vec<Option<Value>> {
    let each = cells.iter().zip(&plant.outputs).map(|(cell, output)| {
        let cell = (*cell)?;
        let last = u32::try_from(output.every - 1).unwrap_or(u32::MAX);
        let (none, most) = (b.index(0), b.index(last));
        let before = b.read(cell);
        let due = b.index_equal(before, none);
        let fewer = b.count_down(before);
        let until = b.select(due, most, fewer);
        b.set(cell, until);
        Some(due)
    });
    each.collect()
}

/// Whether there is a sample of every output that is due.
pub(crate) fn measured(b: &mut Builder, good: &[Value], due: &[Option<Value>]) -> Value {
    let each = good.iter().zip(due).map(|(good, due)| match due {
        Some(due) => {
            let waits = b.not(*due);
            b.or(*good, waits)
        }
        None => *good,
    });
    let each: Vec<Value> = each.collect();
    all(b, &each)
}
