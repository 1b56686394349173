//! Outputs with a gate: once converged, a sample further from its prediction than the gate is missing.
//!
//! What is rejected is left to the prediction like any missing sample, for each output alone. So many in a row are no
//! accident: the plant has jumped, and the observer starts again with the last of them.

use crate::program::Value;
use crate::step::front;
use crate::step::gate::Look;

use super::{Lowering, calls};

impl Lowering<'_> {
    /// Whether any output has a gate.
    pub(super) fn gated(&self) -> bool {
        self.cells.rejected.iter().any(Option::is_some)
    }

    /// Per output, whether its sample is good and is not rejected; and whether one would have been rejected once too often, so
    /// that it is not. `shown` are the predictions.
    pub(super) fn accepted(&mut self, samples: &[Value], good: &[Value], shown: &[Value]) -> (Vec<Value>, Value) {
        let (plant, b) = (self.plant, &mut self.builder);
        let mut jumped = b.boolean(false);
        let (enough, count) = (b.index(calls(self.design.valid)), b.read(self.cells.good));
        let known = b.index_less(enough, count);
        // By default as many as convergence takes, and one alone never.
        let patience = calls(self.design.valid).max(2);
        let mut accepted = good.to_vec();
        for (o, (output, rejected)) in plant.outputs.iter().zip(&self.cells.rejected).enumerate() {
            let (Some(gate), Some(rejected)) = (&output.gate, *rejected) else { continue };
            let off = b.sub(samples[o], shown[o]);
            let distance = front::folded(b, output, off, plant.scalar);
            let look = Look { gate, rejected, patience, distance, known, usable: None };
            let (good, jump) = look.judge(b, plant, good[o]);
            accepted[o] = good;
            jumped = b.or(jumped, jump);
        }
        (accepted, jumped)
    }
}
