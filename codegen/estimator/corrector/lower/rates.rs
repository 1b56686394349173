//! Outputs at several rates: which are due at a call, counted from the first call on, whatever is missing.
//!
//! A sample that is not due is not looked at and not missing. The observer starts with a call at which every output is due.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value};
use crate::step::logic::all;

use super::{Lowering, Predicted, calls};

/// Per output that is not due at every call, its count.
pub(super) fn cells(b: &mut Builder, plant: &Plant) -> Vec<Option<CellId>> {
    let cell = |output: &crate::plant::Output| {
        let name = &output.label.name;
        (output.every > 1).then(|| b.index_cell(&format!("until_{name}"), &format!("calls until {name} is due"), 0))
    };
    plant.outputs.iter().map(cell).collect()
}

impl Lowering<'_> {
    /// Per output that is not due at every call, whether it is due now.
    pub(super) fn due(&mut self) -> Vec<Option<Value>> {
        let cells = self.cells.due.clone();
        let each = cells.into_iter().zip(&self.plant.outputs).map(|(cell, output)| {
            let (cell, b) = (cell?, &mut self.builder);
            let (none, most) = (b.index(0), b.index(calls(output.every - 1)));
            let before = b.read(cell);
            let due = b.index_equal(before, none);
            let fewer = b.count_down(before);
            let until = b.select(due, most, fewer);
            b.set(cell, until);
            Some(due)
        });
        each.collect()
    }

    /// Whether a call counts: with one output, each that has its sample; with several, each that has those that are due.
    pub(super) fn counts(&self, predicted: &Predicted) -> Value {
        if self.plant.outputs.len() == 1 { predicted.complete } else { predicted.measured }
    }

    /// Whether there is a sample of every output that is due.
    pub(super) fn measured(&mut self, good: &[Value], due: &[Option<Value>]) -> Value {
        let each = good.iter().zip(due).map(|(good, due)| match due {
            Some(due) => {
                let waits = self.builder.not(*due);
                self.builder.or(*good, waits)
            }
            None => *good,
        });
        let each: Vec<Value> = each.collect();
        all(&mut self.builder, &each)
    }
}
