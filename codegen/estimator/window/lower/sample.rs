//! The first half of a step: reads the samples, guards them, predicts those that are missing, and
//! evaluates the injections.

use crate::plant::Hold;
use crate::program::Value;
use crate::program::builder::Builder;
use crate::step::logic::{all, any};
use crate::step::missing::abandoned;
use crate::step::{coasting, front, inputs, known};

use super::{Lowering, Sampled, late_len};
use crate::sampled::{Part, Source};
use crate::step::injections::{Injections, Moment, Samples};

/// The signals of this call, as far as they are known.
pub(super) struct Signals<'a> {
    pub(super) injections: Injections<'a>,
    /// Per signal.
    pub(super) values: Vec<Option<Value>>,
    /// Whether what was sampled now was good: one per sample that may be bad.
    pub(super) now: Vec<Value>,
    /// Whether what was applied since the last call was good.
    pub(super) since: Vec<Value>,
}

impl<'a> Lowering<'a> {
    /// Reads, guards, predicts and evaluates.
    pub(crate) fn sample(&mut self) -> Sampled {
        let window = self.kept();
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let before = self.builder.read(self.cells.newest);
        let before = self.builder.at_most(before, window - 1);
        let count = self.builder.read(self.cells.count);
        let converged = self.had_converged(count, 1);
        let outputs = self.plant.outputs.len();
        let read = (0..outputs).map(|o| self.read_output(o)).collect();
        let mut signals = self.read_signals(before);
        let (measured, mut good): (Vec<Value>, Vec<Value>) =
            self.without_inputs(read, &signals.injections.inputs).into_iter().unzip();

        self.builder.section("prediction, for a sample that is missing");
        let newest = self.builder.advance(before, window);
        self.known_before_the_samples(&mut signals, before);
        let predicted: Vec<Value> = (0..outputs).map(|o| self.predict(o, &signals.values)).collect();
        let last: Vec<Value> =
            self.cells.outputs.clone().iter().map(|kept| kept.read(&mut self.builder, before)).collect();
        let place: Vec<Value> = (0..outputs).map(|o| self.placed(o, predicted[o], last[o])).collect();
        let distance: Vec<Value> =
            (0..outputs).map(|o| self.distance(o, (measured[o], place[o]), predicted[o], before)).collect();
        let again = self.doubt(&distance, &place, &mut good, count);
        let candidates: Vec<Value> = (0..outputs)
            .map(|o| {
                // The injections are guarded for samples within the range; so must be what stands in for one.
                let (low, high) = self.guard.outputs[o];
                let sane = self.builder.in_range(place[o], low, high);
                let usable = self.builder.and(converged, sane);
                let instead = self.builder.select(usable, place[o], last[o]);
                self.builder.select(good[o], measured[o], instead)
            })
            .collect();
        self.known_with_the_samples(&mut signals, before, &candidates);
        let values: Vec<Value> = signals.values.into_iter().flatten().collect();
        let mut lost = Vec::new();
        let (stored, counts) = (0..outputs)
            .map(|o| {
                let further = self.refine(o, predicted[o], &values, before);
                let refined = self.placed(o, further, last[o]);
                let (low, high) = self.guard.outputs[o];
                let sane = self.builder.in_range(refined, low, high);
                // A late sample is predicted from an estimate of some calls ago, which must have converged.
                let known = self.had_converged(count, late_len(self.functional, o).max(1));
                let usable = self.builder.and(known, sane);
                let instead = self.builder.select(usable, refined, last[o]);
                let covered = self.builder.or(good[o], usable);
                lost.push(self.builder.not(covered));
                if let Some(stored) = self.counted_further(o, (good[o], usable), further, before) {
                    return stored;
                }
                (self.builder.select(good[o], measured[o], instead), None)
            })
            .unzip();

        let coasted = self.cells.coasted.map(|cell| coasting::count(&mut self.builder, cell, &good));
        let patience = |o: usize| window - late_len(self.functional, o);
        let missed: Vec<_> = self.cells.missed.iter().enumerate().map(|(o, cell)| (*cell, patience(o))).collect();
        lost.extend(abandoned(&mut self.builder, &missed, &good));
        let (late, on_time): (Vec<_>, Vec<_>) =
            self.expected(good, count).into_iter().enumerate().partition(|(o, _)| self.functional.delays[*o] > 0);
        let on_time: Vec<Value> = on_time.into_iter().map(|(_, good)| good).chain(signals.now).collect();
        let newest_good = all(&mut self.builder, &on_time);
        let samples_good = late.iter().fold(newest_good, |all, (_, good)| self.builder.and(all, *good));
        let interval_good = all(&mut self.builder, &signals.since);
        let lost = any(&mut self.builder, &lost);
        Sampled {
            newest,
            samples_good,
            interval_good,
            newest_good,
            late,
            lost,
            again,
            outputs: stored,
            counts,
            signals: values,
            inputs: signals.injections.inputs,
            present: Vec::new(),
            slots: Vec::new(),
            coasted,
            ages: Vec::new(),
        }
    }

    /// Whether each sample is good, or missing as measurements at irregular times are.
    pub(super) fn expected(&mut self, good: Vec<Value>, count: Value) -> Vec<Value> {
        let Some(gaps) = self.functional.gaps else { return good };
        // Predictions need a first sample; a solve over what is there does not.
        let started =
            if self.functional.irregular.is_some() { self.builder.boolean(true) } else { self.counted(count, 1) };
        let most = super::bounded(gaps.most);
        let mut expected = Vec::new();
        for (good, cell) in good.into_iter().zip(self.cells.gaps.clone()) {
            let before = self.builder.read(cell);
            let more = self.builder.count_up(before, most);
            let none = self.builder.index(0);
            let missing = self.builder.select(good, none, more);
            self.builder.set(cell, missing);
            let longest = self.builder.index(most);
            let within = self.builder.index_less(missing, longest);
            let foreseen = self.builder.and(started, within);
            expected.push(self.builder.or(good, foreseen));
        }
        expected
    }

    /// A sample, with its inputs still in it.
    pub(super) fn read_output(&mut self, output: usize) -> (Value, Value) {
        front::read(&mut self.builder, self.plant, output, self.guard.outputs[output])
    }

    /// Samples without the inputs that they have in them.
    pub(super) fn without_inputs(&mut self, samples: Vec<(Value, Value)>, inputs: &[Value]) -> Vec<(Value, Value)> {
        let (b, plant, ranges) = (&mut self.builder, self.plant, &self.guard.outputs);
        let each = samples.into_iter().zip(ranges).enumerate();
        each.map(|(o, (sample, range))| front::without_inputs(b, plant, o, sample, inputs, *range)).collect()
    }

    /// The inputs, with the last good value in place of a bad one.
    pub(super) fn read_signals(&mut self, before: Value) -> Signals<'a> {
        let mut signals = Signals {
            injections: Injections::new(self.plant, self.cells.calls, Vec::new()),
            values: vec![None; self.functional.signals.len()],
            now: Vec::new(),
            since: Vec::new(),
        };
        for (u, input) in self.plant.inputs.iter().enumerate() {
            let (value, good) = self.read_input(u, before);
            signals.injections.inputs.push(value);
            if input.hold == Hold::Zero { signals.since.push(good) } else { signals.now.push(good) }
        }
        signals
    }

    fn read_input(&mut self, u: usize, before: Value) -> (Value, Value) {
        let bound = self.guard.bound;
        if let Some(s) = self.functional.signals.iter().position(|s| s.source == Source::Input(u)) {
            let (value, good) = inputs::sample(&mut self.builder, u, bound);
            let last = self.cells.signals[s].read(&mut self.builder, before);
            return (self.builder.select(good, value, last), good);
        }
        inputs::read(&mut self.builder, u, bound, self.cells.inputs[u])
    }

    /// Signals that need no sample of this call: inputs, what is constant since the last call, and
    /// the starts of intervals.
    pub(super) fn known_before_the_samples(&mut self, signals: &mut Signals, before: Value) {
        for (s, signal) in self.functional.signals.iter().enumerate() {
            let moment = match (signal.part, signal.source) {
                (Part::Start, _) => Moment::Ago(1),
                (Part::Held, _) | (_, Source::Input(_)) => Moment::Now,
                _ => continue,
            };
            let (value, good) = self.signal(s, signals, &moment, before, &[]);
            signals.since.extend(good);
            signals.values[s] = Some(value);
        }
    }

    /// Signals that depend on the samples of this call.
    pub(super) fn known_with_the_samples(&mut self, signals: &mut Signals, before: Value, samples: &[Value]) {
        for (s, signal) in self.functional.signals.iter().enumerate() {
            if signals.values[s].is_some() {
                continue;
            }
            let (value, good) = self.signal(s, signals, &Moment::Now, before, samples);
            if matches!(signal.part, Part::Runs | Part::Curves) {
                signals.now.extend(good);
            } else {
                signals.since.extend(good);
            }
            signals.values[s] = Some(value);
        }
    }

    /// The value of a signal, with the last good one in place of a bad one; and whether it was good, where it
    /// may be bad.
    fn signal(
        &mut self,
        s: usize,
        signals: &Signals,
        moment: &Moment,
        before: Value,
        samples: &[Value],
    ) -> (Value, Option<Value>) {
        let k = match self.functional.signals[s].source {
            Source::Input(u) => return (signals.injections.inputs[u], None),
            Source::Injection(k) => k,
        };
        let outputs = &self.cells.outputs;
        let read = |b: &mut Builder, o: usize| outputs[o].read(b, before);
        let samples = if matches!(moment, Moment::Ago(_)) { Samples::Kept(&read) } else { Samples::These(samples) };
        let value = signals.injections.evaluate(&mut self.builder, k, moment, samples);
        let kept = self.cells.signals[s];
        known::guarded(&mut self.builder, &self.guard, k, value, |b| kept.read(b, before))
    }
}
