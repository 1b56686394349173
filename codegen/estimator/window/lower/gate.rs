//! Samples too far from what the model foretells of them: missing, until so many of them follow each other that it must
//! be the estimate that is wrong.
//!
//! What is compared is the prediction before the injections of this call are known, which need the sample: between
//! samples they count as they were.

use super::{Lowering, late_len};
use crate::plant::sensor::Gate;
use crate::program::Value;
use crate::step::logic::any;

impl Lowering<'_> {
    /// Takes from `good` what is further from its place than its gate, by its `distance`; whether one output has lost patience, so that
    /// the window starts again with its sample. Before convergence, and without a usable prediction, every sample is
    /// believed.
    pub(super) fn doubt(
        &mut self,
        distance: &[Value],
        place: &[Value],
        good: &mut [Value],
        count: Value,
    ) -> Option<Value> {
        let mut again = Vec::new();
        for (o, good) in good.iter_mut().enumerate() {
            let Some(gate) = &self.plant.outputs[o].gate else { continue };
            let known = if self.functional.irregular.is_some() {
                self.known()
            } else {
                self.had_converged(count, late_len(self.functional, o).max(1))
            };
            let far = self.is_far(o, gate, (distance[o], place[o]));
            let doubted = self.builder.and(known, far);
            let doubted = self.builder.and(*good, doubted);
            again.push(self.patience(o, gate, doubted, good));
        }
        (!again.is_empty()).then(|| any(&mut self.builder, &again))
    }

    /// Whether a sample is beyond the gate of a place that it could have.
    fn is_far(&mut self, output: usize, gate: &Gate, (distance, place): (Value, Value)) -> Value {
        let (low, high) = self.guard.outputs[output];
        let size = crate::sampled::settled::round(&gate.size, self.plant.scalar);
        let b = &mut self.builder;
        let sane = b.in_range(place, low, high);
        let near = b.in_range(distance, -size, size);
        let far = b.not(near);
        b.and(sane, far)
    }

    /// Rejects a doubted sample unless it is one too many; whether it is.
    fn patience(&mut self, output: usize, gate: &Gate, doubted: Value, good: &mut Value) -> Value {
        let limit = gate.limit.unwrap_or(self.window() - 1).max(1);
        let cell = self.cells.rejected[output].unwrap_or_else(|| unreachable!("declared with the gate"));
        let b = &mut self.builder;
        let (before, last, none) = (b.read(cell), b.index(limit - 1), b.index(0));
        let patient = b.index_less(before, last);
        let rejected = b.and(doubted, patient);
        let more = b.count_up(before, limit);
        let otherwise = b.select(*good, none, before);
        let after = b.select(rejected, more, otherwise);
        b.set(cell, after);
        let believed = b.not(rejected);
        *good = b.and(*good, believed);
        let impatient = b.not(patient);
        b.and(doubted, impatient)
    }
}
