//! What a step keeps for the next prediction, and what it returns.

use crate::program::Value;
use crate::sampled::settled::Settled;
use crate::sampled::weights::terms;
use crate::step::report::{self, Moved, start};

use super::{Lowering, Sampled, late_len};
use crate::sampled::Part;

/// How far an estimate can be trusted.
pub(crate) struct Standing {
    /// Whether there is one; else the start is given.
    pub(crate) known: Value,
    /// Whether it has converged.
    pub(crate) determined: Value,
    /// Whether it comes from samples, where it may come from the model alone.
    pub(crate) renewed: Option<Value>,
}

impl Lowering<'_> {
    /// Keeps what the next prediction needs.
    ///
    /// The estimate is less the newest samples of outputs that wrap. That moves no other output; of the output itself
    /// it leaves how far it will move, and for a late one, whose sample comes later, its newest sample is added.
    pub(crate) fn look_ahead(&mut self, estimate: &[Value], sampled: &Sampled) {
        self.builder.section("the next measurement, as far as it is known");
        for o in 0..self.plant.outputs.len() {
            let prediction = self.functional.prediction[o].clone();
            let mut terms = terms(&mut self.builder, prediction.states.iter().zip(estimate));
            for (s, signal) in self.functional.signals.iter().enumerate() {
                if let (Part::Runs | Part::Curves, Some(weight)) = (signal.part, self.held(o, s)) {
                    let weight = self.factor(&weight);
                    terms.push(self.builder.mul(weight, sampled.reading.signals[s]));
                }
            }
            if prediction.constant != Settled::default() {
                terms.push(self.constant(prediction.constant));
            }
            let mut sum = self.builder.sum(&terms);
            if let Some(slot) = self.cells.late[o] {
                if self.plant.outputs[o].wrap.is_some() {
                    sum = self.builder.add(sum, sampled.reading.outputs[o]);
                }
                let len = late_len(self.functional, o);
                let before = self.builder.read(slot);
                let before = self.builder.at_most(before, len - 1);
                self.builder.set_ring(self.cells.ahead[o], before, sum);
                let after = self.builder.advance(before, len);
                self.builder.set(slot, after);
            } else {
                self.builder.set(self.cells.ahead[o], sum);
            }
        }
    }

    /// The estimate where it is known, else the start; and how far it can be trusted.
    pub(crate) fn report(&mut self, estimate: &[Value], sampled: &Sampled, standing: &Standing) {
        self.show(estimate, sampled, standing.known, "");
        self.show_coasted(sampled);
        self.stand(standing);
    }

    /// Estimates under the states' names, with something behind them; where they are not known, the start.
    pub(super) fn show(&mut self, estimate: &[Value], sampled: &Sampled, known: Value, behind: &str) {
        let mut answer = Vec::new();
        for (i, estimate) in estimate.iter().enumerate() {
            let start = start(&mut self.builder, self.plant, i, &sampled.reading.outputs);
            let value = self.builder.select(known, *estimate, start);
            answer.push(self.or_given(i, value));
        }
        let moved = self.ahead.map(|ahead| {
            let injections = self.sensors.injections(&sampled.reading.known.injections.inputs);
            Moved { ahead, injections, outputs: &sampled.reading.outputs }
        });
        report::estimates(&mut self.builder, self.plant, answer, moved, behind);
    }

    /// Calls since the newest accepted sample, where they are asked for.
    pub(super) fn show_coasted(&mut self, sampled: &Sampled) {
        if let Some(coasted) = sampled.reading.coasted {
            report::coasted(&mut self.builder, coasted);
        }
    }

    /// The status.
    pub(super) fn stand(&mut self, standing: &Standing) {
        let coasting = self.replaced.unwrap_or_else(|| self.builder.read(self.cells.coasting));
        // A replaced sample leaves the shortest window first; the count is of the longest.
        let longer = self.kept() - self.window();
        let mut clean = if longer == 0 {
            let none = self.builder.index(0);
            self.builder.index_equal(coasting, none)
        } else {
            let left = self.builder.index(longer + 1);
            self.builder.index_less(coasting, left)
        };
        if let Some(renewed) = self.or_promised(standing.renewed, standing.determined) {
            clean = self.builder.and(renewed, clean);
        }
        let determined = self.or_vouched(standing.determined);
        report::status(&mut self.builder, determined, clean);
    }
}
