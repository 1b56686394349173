//! A start from a given state: the state of the call before the first step, as if a call had left it.
//!
//! Vouched for, all counts stand as after convergence and the countdown is over. Else the countdown begins, the first
//! call corrects as any other, and convergence is counted from the first good call on, as in a start from a sample.

use crate::program::Value;
use crate::sampled::weights::products;
use crate::step::given;

use super::super::Frame;
use super::{Lowering, Predicted, calls};

impl Lowering<'_> {
    /// Whether the observer waits for its first sample, and has not been given a state instead.
    pub(super) fn without_a_state(&mut self, waiting: Value) -> Value {
        let Some(cell) = self.cells.given else { return waiting };
        let (given, none) = (self.builder.read(cell), self.builder.index(0));
        let without = self.builder.index_equal(given, none);
        self.builder.and(waiting, without)
    }

    /// From the first good call on, and in a new start, the given state is the observer's own or gone.
    pub(super) fn has_begun(&mut self, predicted: &Predicted, again: Value) {
        let Some(cell) = self.cells.given else { return };
        let (given, none) = (self.builder.read(cell), self.builder.index(0));
        let over = self.builder.or(predicted.measured, again);
        let kept = self.builder.select(over, none, given);
        self.builder.set(cell, kept);
    }

    /// Writes the start from a given state, where there is one.
    pub(super) fn init_at(&mut self) {
        let Some(given) = self.cells.given else { return };
        let Self { plant, design, builder, cells, sensors, .. } = self;
        let (plant, bound) = (*plant, sensors.guard.bound);
        builder.init_at(|b| {
            b.section("the given state");
            let (state, vouched) = given::state(b, plant, bound);
            let carried = match &design.frame {
                Frame::Plant { .. } => state.clone(),
                Frame::Chain { entry, .. } => {
                    let entry = entry.as_deref().unwrap_or_default();
                    products(b, entry, &state).into_iter().map(|value| given::within(b, value, bound)).collect()
                }
            };
            for (cell, value) in cells.state.iter().zip(&carried) {
                b.set(*cell, *value);
            }
            b.section("how far it is trusted");
            let (none, one) = (b.index(0), b.index(1));
            let counts = [
                (cells.left, 0, calls(design.counting.lead())),
                (cells.good, calls(design.valid + 1), 0),
                (cells.clean, calls(design.recovery), calls(design.recovery)),
            ];
            for (cell, trusted, begun) in counts {
                let (trusted, begun) = (b.index(trusted), b.index(begun));
                let count = b.select(vouched, trusted, begun);
                b.set(cell, count);
            }
            let begins = b.select(vouched, none, one);
            b.set(given, begins);
            given::show(b, sensors, &state, None, |_| false);
        });
    }
}
