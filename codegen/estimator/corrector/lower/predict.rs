//! The state before its correction: what the plant makes of the last one, with all that is known of this call.

use crate::program::Value;
use crate::program::builder::Builder;
use crate::sampled::Part;
use crate::sampled::weights::{constant, push_products};
use crate::step::known::Known;
use crate::step::logic::all;
use crate::step::rates;
use crate::step::reading::{self, Foretells, Foretold};

use super::super::Frame;
use super::{Lowering, Predicted, calls};

impl<'a> Lowering<'a> {
    /// Reads the call and predicts the state.
    pub(super) fn predict(&mut self) -> Predicted<'a> {
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let sensors = self.sensors.clone();
        let reading = reading::read(self, &sensors, Some("prediction by the plant"));
        let measured = rates::measured(&mut self.builder, &reading.good, &self.due);
        let complete = all(&mut self.builder, &reading.good);
        let moved = self.completed(&reading.known);
        let state = self.all_reached(&moved);
        let b = &mut self.builder;
        let values = sensors.values.iter().zip(&reading.signals);
        for (kept, value) in values.chain(sensors.outputs.iter().zip(&reading.outputs)) {
            kept.write(b, None, *value);
        }
        let fine: Vec<Value> = reading.known.good().chain([measured]).collect();
        let fine = all(b, &fine);
        Predicted { reading, measured, complete, fine, moved, state }
    }

    /// What the last state and what needs no sample make of the state now; of what two floats carry, what it grows by.
    fn carried(&mut self, known: &Known) -> Vec<Value> {
        let state: Vec<Value> = self.cells.state.iter().map(|cell| self.builder.read(*cell)).collect();
        let design = self.design;
        let Frame::Plant { phi, growth, .. } = &design.frame else { return self.integrated(&state) };
        let (sensors, b) = (&self.sensors, &mut self.builder);
        let mut begin = Vec::new();
        for (s, now) in known.values.iter().enumerate() {
            begin.push(match now {
                Some(now) => sensors.begun(b, s, *now),
                None => sensors.values[s].newest(b, None),
            });
        }
        let mut next = Vec::new();
        for i in 0..phi.len() {
            let mut terms = Vec::new();
            self.push_low(i, &mut terms);
            let (sensors, b) = (&self.sensors, &mut self.builder);
            push_products(b, &mut terms, &design.prediction(phi, growth, i), &state);
            for (s, term) in sensors.terms.iter().enumerate() {
                push_products(b, &mut terms, &[design.at_begin[s][i]], &[begin[s]]);
                if let (Some(known), false) = (known.values[s], term.needs_samples) {
                    push_products(b, &mut terms, &[design.at_end[s][i]], &[known]);
                }
            }
            terms.extend(design.constant[i].map(|entry| constant(b, entry)));
            next.push(b.sum(&terms));
        }
        next
    }

    /// Implicit Euler of the chain in scaled coordinates: each the sum of itself and all above it.
    fn integrated(&mut self, state: &[Value]) -> Vec<Value> {
        let mut moved = state.to_vec();
        let mut above: Option<Value> = None;
        for i in (0..state.len()).rev() {
            let own = self.cells.low[i].map_or(state[i], |cell| self.builder.read(cell));
            moved[i] = above.map_or(own, |above| self.builder.add(own, above));
            above = Some(self.reached(i, moved[i]));
        }
        moved
    }

    /// The same with what needs the samples of now.
    fn completed(&mut self, known: &Known) -> Vec<Value> {
        let mut state = self.carried(known);
        let b = &mut self.builder;
        for (s, term) in self.sensors.terms.iter().enumerate() {
            let (Some(value), true) = (known.values[s], term.needs_samples) else { continue };
            for (x, weight) in state.iter_mut().zip(&self.design.at_end[s]) {
                if let Some(weight) = weight {
                    let weight = constant(b, *weight);
                    let product = b.mul(weight, value);
                    *x = b.add(*x, product);
                }
            }
        }
        state
    }

    /// Whether somebody asks what a sample should be before it is looked at.
    fn is_asked(&self) -> bool {
        self.sensors.gated() || self.sensors.terms.iter().any(|term| term.needs_samples || term.ago > 0)
    }
}

impl<'a> Foretells<'a> for Lowering<'a> {
    fn builder(&mut self) -> &mut Builder {
        &mut self.builder
    }

    fn screen(&mut self, good: &mut [Value]) {
        let b = &mut self.builder;
        self.due = rates::due(b, self.plant, &self.cells.due);
        for (good, due) in good.iter_mut().zip(&self.due) {
            *good = due.map_or(*good, |due| b.and(*good, due));
        }
    }

    /// Until the samples are there, the end of the interval is taken like its beginning.
    fn foretells(&mut self, known: &Known) -> Option<Vec<Foretold>> {
        let mut state = self.carried(known);
        if !self.is_asked() {
            return None;
        }
        let (design, sensors, b) = (self.design, &self.sensors, &mut self.builder);
        for (s, signal) in design.signals.iter().enumerate().filter(|(s, _)| known.values[*s].is_none()) {
            let start =
                design.signals.iter().position(|other| other.source == signal.source && other.part == Part::Start);
            let value = match (signal.part, start.and_then(|start| known.values[start])) {
                (Part::End, Some(start)) => start,
                _ => sensors.values[s].newest(b, None),
            };
            for (i, x) in state.iter_mut().enumerate() {
                let mut terms = vec![*x];
                push_products(b, &mut terms, &[design.at_end[s][i]], &[value]);
                *x = b.sum(&terms);
            }
        }
        let state = self.all_reached(&state);
        Some(self.shown(&state).into_iter().map(Foretold::at).collect())
    }

    fn believed(&mut self, _output: usize) -> Value {
        let b = &mut self.builder;
        let (enough, count) = (b.index(calls(self.design.valid)), b.read(self.cells.good));
        b.index_less(enough, count)
    }

    /// The state is the best that there is, converged or not.
    fn stands_in(&mut self, _output: usize) -> Option<Value> {
        Some(self.builder.boolean(true))
    }

    /// The correction itself does without a sample that is missing.
    fn settles(&mut self, _output: usize, _known: &Known, _foretold: Foretold) -> Option<Foretold> {
        None
    }
}
