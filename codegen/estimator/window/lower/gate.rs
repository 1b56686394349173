//! Which samples are looked at, and with what they are compared: the prediction before the injections of this call are
//! known, which need the sample; between samples they count as they were.

use super::{Lowering, late_len};
use crate::program::Value;
use crate::step::gate::Look;
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
            let (Some(gate), Some(rejected)) = (&self.plant.outputs[o].gate, self.cells.rejected[o]) else { continue };
            let known = if self.functional.irregular.is_some() {
                self.known()
            } else {
                self.had_converged(count, late_len(self.functional, o).max(1))
            };
            let (low, high) = self.guard.outputs[o];
            let usable = Some(self.builder.in_range(place[o], low, high));
            let look = Look { gate, rejected, patience: self.window() - 1, distance: distance[o], known, usable };
            let (still, jumped) = look.judge(&mut self.builder, self.plant, *good);
            *good = still;
            again.push(jumped);
        }
        (!again.is_empty()).then(|| any(&mut self.builder, &again))
    }
}
