//! The first half of a step: reads the samples, guards them, predicts those that are not there, and evaluates what
//! is known besides.

use crate::program::Value;
use crate::sampled::Source;
use crate::step::injections::{Injections, Moment, Samples};
use crate::step::logic::{all, any};
use crate::step::missing::abandoned;
use crate::step::{coasting, front, inputs, known};

use super::cells::{length, period_count};
use super::{Lowering, Sampled};
use crate::estimator::copies::known::Run;
use crate::plant::Hold;

/// What is known at a call, as far as it has been evaluated.
struct Signals<'a> {
    injections: Injections<'a>,
    /// Per known.
    values: Vec<Option<Value>>,
    /// Whether what was sampled now was good: one per value that may be bad.
    now: Vec<Value>,
    /// Whether what was applied since the last call was good.
    since: Vec<Value>,
}

impl<'a> Lowering<'a> {
    /// Reads, guards, predicts and evaluates.
    pub(super) fn sample(&mut self) -> Sampled {
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let due = self.due();
        let converged = self.was_converged();
        let converged = self.or_given(converged);
        let count = self.plant.outputs.len();
        let read: Vec<(Value, Value)> = (0..count).map(|o| self.read_output(o, due)).collect();
        let last: Vec<Value> = self.cells.outputs.iter().map(|kept| self.builder.read(kept[0])).collect();
        let mut signals = self.read_inputs();
        let (b, ranges, inputs) = (&mut self.builder, &self.bounds.guard.outputs, &signals.injections.inputs);
        let (measured, good): (Vec<Value>, Vec<Value>) =
            (0..count).map(|o| front::without_inputs(b, self.plant, o, read[o], inputs, ranges[o])).unzip();

        self.builder.section("prediction, for a sample that is missing or not measured now");
        self.evaluate(&mut signals, false, &[]);
        let guesses: Vec<Value> = (0..self.design.knowns.len()).map(|s| self.guess(s, &signals)).collect();
        let predicted: Vec<Value> = (0..count).map(|o| self.predict(o, &guesses)).collect();
        let candidates: Vec<Value> =
            (0..count).map(|o| self.stand_in(o, predicted[o], last[o], (due, converged)).0).collect();
        let candidates: Vec<Value> =
            (0..count).map(|o| self.builder.select(good[o], measured[o], candidates[o])).collect();
        self.evaluate(&mut signals, true, &candidates);
        let values: Vec<Value> = signals.values.iter().flatten().copied().collect();

        let mut lost = Vec::new();
        let mut outputs = Vec::new();
        for o in 0..count {
            let refined = self.refine(o, predicted[o], &guesses, &values);
            let (instead, usable) = self.stand_in(o, refined, last[o], (due, converged));
            let covered = self.builder.or(good[o], usable);
            lost.push(self.builder.not(covered));
            outputs.push(self.builder.select(good[o], measured[o], instead));
        }
        let window = period_count(self.design);
        let missed: Vec<_> = self.cells.missed.iter().map(|cell| (*cell, window)).collect();
        let there = self.there(&good, due);
        lost.extend(abandoned(&mut self.builder, &missed, &there));
        let idle = self.builder.not(due);
        let fine: Vec<Value> = good.iter().map(|good| self.builder.or(*good, idle)).collect();
        let fine: Vec<Value> = fine.into_iter().chain(signals.now).collect();
        Sampled {
            due,
            samples_good: all(&mut self.builder, &fine),
            interval_good: all(&mut self.builder, &signals.since),
            lost: any(&mut self.builder, &lost),
            outputs,
            knowns: values,
            inputs: signals.injections.inputs,
            coasted: self.cells.coasted.map(|cell| coasting::count(&mut self.builder, cell, &good)),
        }
    }

    /// Whether this call is one that is measured.
    fn due(&mut self) -> Value {
        let every = length(self.design.calls.every);
        if every == 1 {
            return self.builder.boolean(true);
        }
        let turn = self.builder.read(self.cells.turn);
        let turn = self.builder.at_most(turn, every - 1);
        let none = self.builder.index(0);
        self.builder.index_equal(turn, none)
    }

    fn read_output(&mut self, output: usize, due: Value) -> (Value, Value) {
        let range = self.bounds.guard.outputs[output];
        let (value, good) = front::read(&mut self.builder, self.plant, output, range);
        (value, self.builder.and(due, good))
    }

    /// What stands for an output that has no sample, and whether it may: a prediction within the range after
    /// convergence, else the value before. Between measured calls it is the nearest within the range.
    fn stand_in(
        &mut self,
        output: usize,
        predicted: Value,
        last: Value,
        (due, converged): (Value, Value),
    ) -> (Value, Value) {
        let (low, high) = self.bounds.guard.outputs[output];
        let sane = self.builder.in_range(predicted, low, high);
        let usable = self.builder.and(converged, sane);
        let missing = self.builder.select(usable, predicted, last);
        if self.design.calls.every == 1 {
            return (missing, usable);
        }
        let (low, high) = (self.builder.float(low), self.builder.float(high));
        let above = self.builder.maximum(low, predicted);
        let within = self.builder.minimum(above, high);
        let idle = self.builder.not(due);
        (self.builder.select(due, missing, within), self.builder.or(idle, usable))
    }

    /// Per output, whether it was there at the last measured call.
    fn there(&mut self, good: &[Value], due: Value) -> Vec<Value> {
        if self.design.calls.every == 1 || self.cells.missed.is_empty() {
            return good.to_vec();
        }
        let none = self.builder.index(0);
        let cells = self.cells.missed.clone();
        let before = cells.iter().map(|cell| {
            let missed = self.builder.read(*cell);
            self.builder.index_equal(missed, none)
        });
        let before: Vec<Value> = before.collect();
        good.iter().zip(before).map(|(good, before)| self.builder.select(due, *good, before)).collect()
    }

    /// The inputs, with the last good value in place of a bad one.
    fn read_inputs(&mut self) -> Signals<'a> {
        let mut signals = Signals {
            injections: Injections::new(self.plant, self.cells.calls, Vec::new()),
            values: vec![None; self.design.knowns.len()],
            now: Vec::new(),
            since: Vec::new(),
        };
        let bound = self.bounds.guard.bound;
        for (u, input) in self.plant.inputs.iter().enumerate() {
            let (used, good) = inputs::read(&mut self.builder, u, bound, self.cells.inputs[u]);
            signals.injections.inputs.push(used);
            if input.hold == Hold::Zero { signals.since.push(good) } else { signals.now.push(good) }
        }
        signals
    }

    /// Evaluates what needs the samples of this call, or what does not.
    fn evaluate(&mut self, signals: &mut Signals, with_samples: bool, outputs: &[Value]) {
        let design = self.design;
        for (s, known) in design.knowns.iter().enumerate() {
            if known.needs_samples(self.plant) != with_samples {
                continue;
            }
            let k = match known.source {
                Source::Input(u) => {
                    signals.values[s] = Some(signals.injections.inputs[u]);
                    continue;
                }
                Source::Injection(k) => k,
            };
            let value = if known.ago == 0 {
                signals.injections.evaluate(&mut self.builder, k, &Moment::Now, Samples::These(outputs))
            } else {
                let cells: Vec<_> = self.cells.outputs.iter().map(|kept| kept[known.ago - 1]).collect();
                let past: Vec<Value> = cells.into_iter().map(|cell| self.builder.read(cell)).collect();
                let ago = Moment::Ago(length(known.ago));
                signals.injections.evaluate(&mut self.builder, k, &ago, Samples::These(&past))
            };
            signals.values[s] = Some(self.guarded(s, k, value, signals));
        }
    }

    /// An injection's value, with the last good one in place of a bad one.
    fn guarded(&mut self, s: usize, k: usize, value: Value, signals: &mut Signals) -> Value {
        let last = self.cells.knowns[s][0];
        let (used, good) = known::guarded(&mut self.builder, &self.bounds.guard, k, value, |b| b.read(last));
        let known = &self.design.knowns[s];
        // A value that runs belongs to the sample; one of an interval alone to the interval.
        let of_sample = !known.jumps && known.run != Run::Held;
        if of_sample {
            signals.now.extend(good);
        } else {
            signals.since.extend(good);
        }
        used
    }

    /// A known's value of this call before the samples are looked at: extrapolated where it needs them.
    fn guess(&mut self, s: usize, signals: &Signals) -> Value {
        if let Some(value) = signals.values[s] {
            return value;
        }
        let known = self.design.knowns[s].clone();
        let past: Vec<Value> = if known.jumps {
            // The same function at the samples before, with this interval's input; the nearest stands last.
            let of = |other: &crate::estimator::copies::known::Known| other.source == known.source && other.ago > 0;
            let places = self.design.knowns.iter().enumerate().filter(|(_, other)| of(other)).map(|(place, _)| place);
            places.rev().filter_map(|place| signals.values[place]).collect()
        } else {
            self.cells.knowns[s].iter().map(|cell| self.builder.read(*cell)).collect()
        };
        match (known.run, past.as_slice()) {
            (Run::Cubic, [one, two, three, ..]) => {
                // The parabola through three values, one step on: 3 (one - two) + three.
                let rise = self.builder.sub(*one, *two);
                let factor = self.builder.float(3.0);
                let rise = self.builder.mul(factor, rise);
                self.builder.add(rise, *three)
            }
            (_, [one, ..]) => *one,
            (_, []) => unreachable!("a value that needs the samples has one before"),
        }
    }

    /// What an output should be now, with the guesses for what is not known before the samples are.
    fn predict(&mut self, output: usize, guesses: &[Value]) -> Value {
        let copy: Vec<Value> = self.cells.first.clone().into_iter().map(|cell| self.builder.read(cell)).collect();
        let before: Vec<Value> =
            self.cells.outputs.clone().into_iter().map(|kept| self.builder.read(kept[0])).collect();
        let mut knowns = Vec::new();
        for (s, (kept, guess)) in self.cells.knowns.clone().iter().zip(guesses).enumerate() {
            knowns.push(self.known_by_age(s, *guess, kept));
        }
        // The predictor uses the outputs of the call before alone; those of now are what it predicts.
        let outputs = [before.clone(), before];
        let design = self.design;
        let terms = self.row_terms(&design.predictor, output, &copy, (&outputs, &knowns));
        self.builder.sum(&terms)
    }

    /// The prediction once the guesses have become values.
    fn refine(&mut self, output: usize, predicted: Value, guesses: &[Value], values: &[Value]) -> Value {
        let design = self.design;
        let mut sum = predicted;
        for (s, known) in design.knowns.iter().enumerate() {
            if !known.needs_samples(self.plant) {
                continue;
            }
            if let Some(weight) = design.predictor.knowns[s][0][output] {
                let weight = self.constant(weight);
                let change = self.builder.sub(values[s], guesses[s]);
                let product = self.builder.mul(weight, change);
                sum = self.builder.add(sum, product);
            }
        }
        sum
    }
}
