//! The first half of a step: reads the samples and what else is known, guards it, and predicts the state.

use crate::program::Value;
use crate::sampled::{Part, Signal, Source};
use crate::step::injections::{Injections, Moment, Samples};
use crate::step::logic::all;
use crate::step::{front, inputs, known, rates};

use super::super::Frame;
use super::{Lowering, Predicted};

impl Lowering<'_> {
    /// The state before its correction.
    pub(super) fn predict(&mut self) -> Predicted {
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let count = self.plant.outputs.len();
        let (b, plant, ranges) = (&mut self.builder, self.plant, &self.guard.outputs);
        let read: Vec<(Value, Value)> = (0..count).map(|o| front::read(b, plant, o, ranges[o])).collect();
        let (inputs, mut fine) = self.read_inputs();
        let (b, ranges) = (&mut self.builder, &self.guard.outputs);
        let (samples, good): (Vec<Value>, Vec<Value>) =
            (0..count).map(|o| front::without_inputs(b, plant, o, read[o], &inputs, ranges[o])).unzip();
        let due = rates::due(&mut self.builder, plant, &self.cells.due);
        let good: Vec<Value> =
            good.into_iter().zip(&due).map(|(good, due)| due.map_or(good, |due| self.builder.and(good, due))).collect();
        let measured = rates::measured(&mut self.builder, &good, &due);
        self.builder.section("prediction by the plant");
        let injections = Injections::new(self.plant, self.cells.calls, inputs);
        let known: Vec<Option<Value>> =
            (0..self.design.signals.len()).map(|s| self.known_before(s, &injections, &mut fine)).collect();
        let base = self.carried(&known);
        let guess = (!self.is_plain(&known)).then(|| self.guess(&base, &known));
        let (good, measured, jumped) = match (self.gated(), &guess) {
            (true, Some(guess)) => {
                let (good, jumped) = self.accepted(&samples, &good, guess);
                let measured = rates::measured(&mut self.builder, &good, &due);
                (good, measured, jumped)
            }
            _ => (good, measured, self.builder.boolean(false)),
        };
        let complete = all(&mut self.builder, &good);
        let outputs = self.stand_ins(&samples, &good, guess.as_deref());
        let state = self.complete(base, &known, &outputs, &injections, &mut fine);
        for (cell, value) in self.cells.outputs.clone().into_iter().zip(&outputs) {
            self.builder.set(cell, *value);
        }
        fine.push(measured);
        let fine = all(&mut self.builder, &fine);
        Predicted { outputs, good, measured, complete, fine, jumped, state, inputs: injections.inputs }
    }

    /// The inputs, and which were good.
    fn read_inputs(&mut self) -> (Vec<Value>, Vec<Value>) {
        let (b, bound) = (&mut self.builder, self.guard.bound);
        self.cells.inputs.iter().enumerate().map(|(u, last)| inputs::read(b, u, bound, *last)).unzip()
    }

    /// Whether a signal can only be had with the samples of this call.
    fn needs_samples(signal: &Signal) -> bool {
        matches!(signal.source, Source::Injection(_)) && matches!(signal.part, Part::Runs | Part::Curves | Part::End)
    }

    /// A signal that needs no sample of this call.
    fn known_before(&mut self, s: usize, injections: &Injections, fine: &mut Vec<Value>) -> Option<Value> {
        let signal = &self.design.signals[s];
        if Self::needs_samples(signal) {
            return None;
        }
        let value = match signal.source {
            Source::Input(u) => injections.inputs[u],
            Source::Injection(k) if signal.part == Part::Start => {
                let past: Vec<Value> =
                    self.cells.outputs.clone().into_iter().map(|cell| self.builder.read(cell)).collect();
                let value = injections.evaluate(&mut self.builder, k, &Moment::Ago(1), Samples::These(&past));
                self.guarded(s, k, value, fine)
            }
            Source::Injection(k) => {
                let value = injections.evaluate(&mut self.builder, k, &Moment::Now, Samples::These(&[]));
                self.guarded(s, k, value, fine)
            }
        };
        Some(value)
    }

    /// An injection's value, with the last good one in place of a bad one.
    fn guarded(&mut self, s: usize, k: usize, value: Value, fine: &mut Vec<Value>) -> Value {
        let cell = self.cells.signals[s];
        let (used, good) = known::guarded(&mut self.builder, &self.guard, k, value, |b| b.read(cell));
        if let Some(good) = good {
            fine.push(good);
            self.builder.set(cell, used);
        }
        used
    }

    /// What the last state and what is known already make of the state now.
    fn carried(&mut self, known: &[Option<Value>]) -> Vec<Value> {
        let design = self.design;
        let state: Vec<Value> = self.cells.state.clone().into_iter().map(|cell| self.builder.read(cell)).collect();
        if let Frame::Chain { .. } = design.frame {
            return self.integrated(&state);
        }
        let Frame::Plant { phi, .. } = &design.frame else { unreachable!("the other frame") };
        let begin = self.begun(known);
        let rows = (0..state.len()).map(|i| {
            let mut terms = Vec::new();
            self.push_products(&mut terms, &phi[i], &state);
            for (s, known) in known.iter().enumerate() {
                self.push_products(&mut terms, &[design.at_begin[s][i]], &[begin[s]]);
                if let Some(known) = known {
                    self.push_products(&mut terms, &[design.at_end[s][i]], &[*known]);
                }
            }
            if let Some(constant) = design.constant[i] {
                terms.push(self.constant(constant));
            }
            self.builder.sum(&terms)
        });
        rows.collect()
    }

    /// Implicit Euler of the chain in scaled coordinates: each the sum of itself and all above it.
    fn integrated(&mut self, state: &[Value]) -> Vec<Value> {
        let mut next = state.to_vec();
        for i in (0..state.len() - 1).rev() {
            next[i] = self.builder.add(state[i], next[i + 1]);
        }
        next
    }

    /// Whether nothing asks what a sample should be before it is looked at.
    fn is_plain(&self, known: &[Option<Value>]) -> bool {
        known.iter().all(Option::is_some) && !self.looks_back() && !self.gated()
    }

    /// What the model predicts of each output, with what is known before the samples.
    fn guess(&mut self, base: &[Value], known: &[Option<Value>]) -> Vec<Value> {
        let design = self.design;
        let mut guess = base.to_vec();
        for (s, signal) in design.signals.iter().enumerate().filter(|(s, _)| known[*s].is_none()) {
            // Until the sample is there, the end of the interval is taken like its beginning.
            let start =
                design.signals.iter().position(|other| other.source == signal.source && other.part == Part::Start);
            let value = match (signal.part, start.and_then(|start| known[start])) {
                (Part::End, Some(start)) => start,
                _ => self.builder.read(self.cells.signals[s]),
            };
            for (i, x) in guess.iter_mut().enumerate() {
                let mut terms = vec![*x];
                self.push_products(&mut terms, &[design.at_end[s][i]], &[value]);
                *x = self.builder.sum(&terms);
            }
        }
        self.shown(&guess)
    }

    /// Per output, the sample or what the model predicts of it.
    fn stand_ins(&mut self, samples: &[Value], good: &[Value], predicted: Option<&[Value]>) -> Vec<Value> {
        let Some(predicted) = predicted else { return samples.to_vec() };
        let each = samples.iter().enumerate().map(|(o, sample)| {
            let (low, high) = self.guard.outputs[o];
            let sane = self.builder.in_range(predicted[o], low, high);
            let last = self.builder.read(self.cells.outputs[o]);
            let instead = self.builder.select(sane, predicted[o], last);
            self.builder.select(good[o], *sample, instead)
        });
        each.collect()
    }

    /// Whether a signal is evaluated with the samples of the call before.
    fn looks_back(&self) -> bool {
        self.design.signals.iter().any(|signal| signal.part == Part::Start)
    }

    /// Adds what depends on the samples of now.
    fn complete(
        &mut self,
        base: Vec<Value>,
        known: &[Option<Value>],
        outputs: &[Value],
        injections: &Injections,
        fine: &mut Vec<Value>,
    ) -> Vec<Value> {
        let design = self.design;
        let mut state = base;
        for (s, signal) in design.signals.iter().enumerate() {
            let value = match (known[s], signal.source) {
                (Some(value), _) => value,
                (None, Source::Injection(k)) => {
                    let value = injections.evaluate(&mut self.builder, k, &Moment::Now, Samples::These(outputs));
                    let value = self.guarded(s, k, value, fine);
                    for (i, x) in state.iter_mut().enumerate() {
                        if let Some(weight) = design.at_end[s][i] {
                            let weight = self.constant(weight);
                            let product = self.builder.mul(weight, value);
                            *x = self.builder.add(*x, product);
                        }
                    }
                    value
                }
                (None, Source::Input(_)) => unreachable!("an input is known before the samples"),
            };
            self.builder.set(self.cells.signals[s], value);
        }
        state
    }
}
