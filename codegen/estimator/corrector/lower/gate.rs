//! Outputs with a gate: once converged, a sample further from its prediction than the gate is missing.
//!
//! What is rejected is left to the prediction like any missing sample, for each output alone. So many in a row are no
//! accident: the plant has jumped, and the observer starts again with the last of them.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value};
use crate::sampled::settled::round;
use crate::step::front;

use super::super::Corrector;
use super::{Lowering, Predicted, calls};

/// Rejected samples in a row that start the observer again: by default as many as convergence takes, and one alone never.
fn limit(plant: &Plant, design: &Corrector, output: usize) -> Option<u32> {
    let gate = plant.outputs[output].gate.as_ref()?;
    Some(gate.limit.unwrap_or_else(|| calls(design.valid).max(2)).max(1))
}

/// Per output with a gate, its count.
pub(super) fn cells(b: &mut Builder, plant: &Plant, design: &Corrector) -> Vec<Option<CellId>> {
    let cell = |(o, output): (usize, &crate::plant::Output)| {
        let limit = limit(plant, design, o)?;
        let name = &output.label.name;
        let doc = format!("samples of {name} rejected in a row, below {limit}");
        Some(b.index_cell(&format!("rejected_{name}"), &doc, 0))
    };
    plant.outputs.iter().enumerate().map(cell).collect()
}

impl Lowering<'_> {
    /// Whether any output has a gate.
    pub(super) fn gated(&self) -> bool {
        self.cells.rejected.iter().any(Option::is_some)
    }

    /// Per output, whether its sample is good and is not rejected; and whether one would have been rejected once too often, so
    /// that it is not. `shown` are the predictions.
    pub(super) fn accepted(&mut self, samples: &[Value], good: &[Value], shown: &[Value]) -> (Vec<Value>, Value) {
        let mut jumped = self.builder.boolean(false);
        let enough = self.builder.index(calls(self.design.valid));
        let count = self.builder.read(self.cells.good);
        let known = self.builder.index_less(enough, count);
        let mut accepted = good.to_vec();
        for (o, cell) in self.cells.rejected.clone().into_iter().enumerate() {
            let output = &self.plant.outputs[o];
            let (Some(cell), Some(gate), Some(limit)) = (cell, &output.gate, limit(self.plant, self.design, o)) else {
                continue;
            };
            let (size, b) = (round(&gate.size, self.plant.scalar), &mut self.builder);
            let off = b.sub(samples[o], shown[o]);
            let off = front::folded(b, output, off, self.plant.scalar);
            let close = b.in_range(off, -size, size);
            let far = b.not(close);
            let far = b.and(far, known);
            let far = b.and(far, good[o]);
            let before = b.read(cell);
            let more = b.count_up(before, limit);
            let last = b.index(limit - 1);
            let over = b.index_less(last, more);
            let jump = b.and(far, over);
            jumped = b.or(jumped, jump);
            let stays = b.not(over);
            let rejected = b.and(far, stays);
            let kept = b.not(rejected);
            accepted[o] = b.and(good[o], kept);
            let none = b.index(0);
            let waiting = b.select(good[o], none, before);
            let count = b.select(rejected, more, waiting);
            b.set(cell, count);
        }
        (accepted, jumped)
    }

    /// Counts the calls since the newest accepted sample of any output.
    pub(super) fn count_coasted(&mut self, predicted: &Predicted) {
        let b = &mut self.builder;
        let any = predicted.good.iter().fold(b.boolean(false), |any, good| b.or(any, *good));
        let none = b.index(0);
        let before = b.read(self.cells.coasted);
        let more = b.count_up(before, u32::MAX);
        let coasted = b.select(any, none, more);
        b.set(self.cells.coasted, coasted);
    }
}
