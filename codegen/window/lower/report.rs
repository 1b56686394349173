//! What a step keeps for the next prediction, and what it returns.

use crate::design::Settled;
use crate::program::{Status, Value};

use super::super::Part;
use super::count::settled;
use super::irregular::Irregularly;
use super::{Lowering, Sampled, field, injections, late_len};

impl Lowering<'_> {
    /// Keeps what the next prediction needs.
    pub(super) fn look_ahead(&mut self, estimate: &[Value], sampled: &Sampled) {
        self.builder.section("the next measurement, as far as it is known");
        for o in 0..self.plant.outputs.len() {
            let prediction = self.functional.prediction[o].clone();
            let mut terms = Vec::new();
            for (weight, state) in prediction.states.iter().zip(estimate) {
                if let Some(weight) = weight {
                    let weight = self.constant(*weight);
                    terms.push(self.builder.mul(weight, *state));
                }
            }
            for (s, signal) in self.functional.signals.iter().enumerate() {
                if let (Part::Runs | Part::Curves, Some(weight)) = (signal.part, prediction.held[s]) {
                    let weight = self.constant(weight);
                    terms.push(self.builder.mul(weight, sampled.signals[s]));
                }
            }
            if prediction.constant != Settled::default() {
                terms.push(self.constant(prediction.constant));
            }
            let sum = self.builder.sum(&terms);
            if let Some(slot) = self.cells.late[o] {
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

    /// The estimate from the samples that are there, or the start while there is none.
    pub(super) fn report_irregular(&mut self, answer: &Irregularly, sampled: &Sampled) {
        self.builder.section("the estimate; until there is one, the start");
        for (i, state) in self.plant.states.iter().enumerate() {
            let start = self.start(i, sampled);
            let value = self.builder.select(answer.usable, answer.estimate[i], start);
            self.builder.estimate(field(&state.label.name, &state.label.unit, &state.label.doc), value);
        }
        let coasting = self.builder.read(self.cells.coasting);
        let none = self.builder.index(0);
        let clean = self.builder.index_equal(coasting, none);
        let renewed = self.builder.and(answer.enough, clean);
        self.status(answer.usable, renewed);
    }

    /// Converged, or coasting where the estimate is not clean, or converging.
    fn status(&mut self, converged: Value, clean: Value) {
        let statuses = [Status::Converged, Status::Coasting, Status::Converging].map(|s| self.builder.status(s));
        let working = self.builder.select(clean, statuses[0], statuses[1]);
        let status = self.builder.select(converged, working, statuses[2]);
        self.builder.report(status);
    }

    /// The estimate, or the start while the window is not full.
    pub(super) fn report(&mut self, estimate: &[Value], sampled: &Sampled, count: Value) {
        self.builder.section("the estimate; until the window is full, the start");
        let full = self.counted(count, self.window());
        let converged = self.counted(count, settled(self.functional));
        for (i, state) in self.plant.states.iter().enumerate() {
            let start = self.start(i, sampled);
            let value = self.builder.select(full, estimate[i], start);
            self.builder.estimate(field(&state.label.name, &state.label.unit, &state.label.doc), value);
        }
        let coasting = self.replaced.unwrap_or_else(|| self.builder.read(self.cells.coasting));
        let none = self.builder.index(0);
        let clean = self.builder.index_equal(coasting, none);
        self.status(converged, clean);
    }

    /// Measured states from the newest sample, the others their `initial`.
    fn start(&mut self, state: usize, sampled: &Sampled) -> Value {
        let state = &self.plant.states[state];
        if state.measured.is_empty() {
            let initial = injections::round(&state.initial, self.plant.scalar);
            return self.builder.float(initial);
        }
        let mut terms = Vec::new();
        for (output, weight) in &state.measured {
            let weight = injections::round(weight, self.plant.scalar);
            let weight = self.builder.float(weight);
            terms.push(self.builder.mul(weight, sampled.outputs[*output]));
        }
        self.builder.sum(&terms)
    }
}
