//! A start from a given state: the state of the call before the first step, as if a call had left it.
//!
//! Vouched for, all counts stand as after convergence and the countdown is over. Else the countdown begins, the first
//! call corrects as any other, and convergence is counted from the first good call on, as in a start from a sample.

use crate::program::Value;
use crate::sampled::{Part, Source};
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

    /// What each signal brought at the last call. An input that runs straight is taken to have been what it is at the
    /// first call, before which nothing is known of it.
    pub(super) fn begun(&mut self, known: &[Option<Value>]) -> Vec<Value> {
        let design = self.design;
        let mut begun = Vec::new();
        for ((signal, cell), now) in design.signals.iter().zip(self.cells.signals.clone()).zip(known) {
            let before = self.builder.read(cell);
            let runs = matches!((signal.source, signal.part), (Source::Input(_), Part::Runs));
            begun.push(match now {
                Some(now) if runs && self.plant.init_at => {
                    given::begun(&mut self.builder, self.cells.calls, *now, before)
                }
                _ => before,
            });
        }
        begun
    }

    /// Writes the start from a given state, where there is one.
    pub(super) fn init_at(&mut self) {
        let Some(given) = self.cells.given else { return };
        let Self { plant, design, guard, builder, cells, .. } = self;
        let (plant, bound) = (*plant, guard.bound);
        builder.init_at(|b| {
            b.section("the given state");
            let (state, vouched) = given::state(b, plant, bound);
            let carried = match &design.frame {
                Frame::Plant { .. } => state.clone(),
                Frame::Chain { entry, .. } => entry
                    .iter()
                    .flatten()
                    .map(|row| {
                        let mut terms = Vec::new();
                        for (weight, x) in row.iter().zip(&state) {
                            if let Some(weight) = weight {
                                let weight = b.float(weight.value(plant.scalar));
                                terms.push(b.mul(weight, *x));
                            }
                        }
                        let sum = b.sum(&terms);
                        given::within(b, sum, bound)
                    })
                    .collect(),
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
            b.section("what it shows, and what that makes of the nonlinear terms");
            let shown = guard.outputs.iter().enumerate();
            let outputs: Vec<Value> = shown.map(|(o, range)| given::shown(b, plant, &state, o, *range)).collect();
            for (cell, value) in cells.outputs.iter().zip(&outputs) {
                b.set(*cell, *value);
            }
            let terms = given::terms(b, plant, cells.calls);
            for (signal, cell) in design.signals.iter().zip(&cells.signals) {
                let (Source::Injection(k), Part::Runs | Part::Curves) = (signal.source, signal.part) else { continue };
                let value = given::term(b, &terms, k, &outputs, bound);
                b.set(*cell, value);
            }
        });
    }
}
