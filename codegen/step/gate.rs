//! Samples too far from what the model foretells of them: missing, until so many of them follow each other that it must
//! be the estimate that is wrong.

use crate::plant::sensor::Gate;
use crate::plant::{Output, Plant};
use crate::program::builder::Builder;
use crate::program::{CellId, Value};
use crate::sampled::settled::round;

/// The fewest samples in a row that are no accident, where the gate does not say how many: outliers come in bursts.
pub const LEAST: u32 = 10;

/// Per output with a gate, the count of its samples rejected in a row.
pub(crate) fn cells(b: &mut Builder, plant: &Plant) -> Vec<Option<CellId>> {
    let cell = |output: &Output| {
        let name = &output.label.name;
        let doc = format!("samples of {name} rejected in a row");
        output.gate.as_ref().map(|_| b.index_cell(&format!("rejected_{name}"), &doc, 0))
    };
    plant.outputs.iter().map(cell).collect()
}

/// A sample that is looked at.
pub(crate) struct Look<'a> {
    /// How far from its prediction it may be.
    pub(crate) gate: &'a Gate,
    /// The count of those rejected before it.
    pub(crate) rejected: CellId,
    /// Rejected samples in a row that are no accident, where the gate does not say how many: the plant has jumped.
    pub(crate) patience: u32,
    /// How far it is from its prediction.
    pub(crate) distance: Value,
    /// Whether the estimate that foretells it has converged.
    pub(crate) known: Value,
    /// Whether the prediction is one that a sample could be.
    pub(crate) usable: Value,
}

impl Look<'_> {
    /// Whether the sample is still good; and whether it is one too many to be rejected, so that the observer starts
    /// again with it.
    pub(crate) fn judge(&self, b: &mut Builder, plant: &Plant, good: Value) -> (Value, Value) {
        let size = round(&self.gate.size, plant.scalar);
        let limit = self.gate.limit.unwrap_or(self.patience.max(LEAST)).max(1);
        let near = b.in_range(self.distance, -size, size);
        let far = b.not(near);
        let far = b.and(self.usable, far);
        let doubted = b.and(self.known, far);
        let doubted = b.and(good, doubted);
        let (before, last, none) = (b.read(self.rejected), b.index(limit - 1), b.index(0));
        let patient = b.index_less(before, last);
        let rejected = b.and(doubted, patient);
        let more = b.count_up(before, limit);
        let otherwise = b.select(good, none, before);
        let after = b.select(rejected, more, otherwise);
        b.set(self.rejected, after);
        let believed = b.not(rejected);
        let impatient = b.not(patient);
        (b.and(good, believed), b.and(doubted, impatient))
    }
}
