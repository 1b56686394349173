//! The first half of a step whose estimate is of the samples that are there: nothing stands in for a missing one, but
//! where a nonlinear term needs its value.

use crate::expr::Symbol;
use crate::program::Value;
use crate::step::{coasting, front};

use super::irregular::{Memory, acted};
use super::sample::Signals;
use super::{Lowering, Sampled};
use crate::program::place;
use crate::sampled::settled::round;
use crate::sampled::{Part, Source};
use crate::step::logic::{all, any};
use crate::step::missing::gone;

impl Lowering<'_> {
    /// Reads, guards and evaluates.
    pub(super) fn sample_what_is_there(&mut self) -> Sampled {
        let window = self.window();
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let before = self.builder.read(self.cells.newest);
        let before = self.builder.at_most(before, window - 1);
        let outputs = self.plant.outputs.len();
        let read = (0..outputs).map(|o| self.read_output(o)).collect();
        let mut signals = self.read_signals(before);
        let (measured, mut good): (Vec<Value>, Vec<Value>) =
            self.without_inputs(read, &signals.injections.inputs).into_iter().unzip();
        let newest = self.builder.advance(before, window);
        let ages = self.read_ages(&mut good);
        let feeds = self.feeds();
        let gated = self.plant.outputs.iter().any(|output| output.gate.is_some());
        let foreseen = (gated || feeds.contains(&true)).then(|| {
            self.builder.section("prediction of what the samples show");
            self.known_before_the_samples(&mut signals, before);
            self.foresee(&signals.values, before)
        });
        let again = foreseen.as_ref().filter(|_| gated).and_then(|state| {
            let places: Vec<Value> = (0..outputs).map(|o| self.stand_in(o, state).0).collect();
            let distance: Vec<Value> = (0..outputs).map(|o| self.off(o, measured[o], places[o])).collect();
            let count = self.builder.read(self.cells.count);
            self.doubt(&distance, &places, &mut good, count)
        });
        let (zero, one) = (self.builder.float(0.0), self.builder.float(1.0));
        let slots: Vec<(Value, Value)> = (0..outputs).map(|o| self.slot(o, before, newest)).collect();
        let used: Vec<Value> = (0..outputs)
            .map(|o| {
                let last = self.cells.outputs[o].read(&mut self.builder, slots[o].0);
                let instead = if feeds[o] { self.instead(o, foreseen.as_deref(), last) } else { last };
                self.builder.select(good[o], measured[o], instead)
            })
            .collect();
        let there = self.of_known_past(&good, &ages);
        let present = there.iter().map(|there| self.builder.select(*there, one, zero)).collect();
        let count = self.builder.read(self.cells.count);
        let expected = if self.functional.gaps.is_some() {
            self.expected(good.clone(), count)
        } else {
            // Nothing is worse for a sample that is left out, unless a nonlinear term needs it.
            good.iter().zip(&feeds).filter(|(_, feeds)| **feeds).map(|(good, _)| *good).collect()
        };
        if foreseen.is_none() {
            self.known_before_the_samples(&mut signals, before);
        }
        self.known_with_the_samples(&mut signals, before, &used);
        let Signals { injections, values, now, since } = signals;
        let values: Vec<Value> = values.into_iter().flatten().collect();
        let used = self.at_the_call(used, &good, &ages, (&slots, &values));
        let (outputs, lost) = match foreseen {
            Some(_) if feeds.contains(&true) => self.settle_stand_ins(&feeds, (&measured, &good), &used, &values),
            _ => (used, Vec::new()),
        };
        let lost = any(&mut self.builder, &lost);
        let cell = self.plant.coasted.then(|| self.memory().coasted);
        let coasted = cell.map(|cell| coasting::count(&mut self.builder, cell, &good));
        let samples_good = self.builder.boolean(true);
        let of_now: Vec<Value> = expected.into_iter().chain(now).collect();
        let (interval_good, newest_good) = (all(&mut self.builder, &since), all(&mut self.builder, &of_now));
        let late = Vec::new();
        Sampled {
            newest,
            samples_good,
            interval_good,
            newest_good,
            late,
            lost,
            again,
            counts: vec![None; outputs.len()],
            outputs,
            signals: values,
            inputs: injections.inputs,
            present,
            slots: slots.into_iter().map(|(_, slot)| slot).collect(),
            coasted,
            ages,
        }
    }

    /// Per output whose samples come with their ages: that over the oldest, 0 where there is no sample; one that is too
    /// old, or of no known age, is missing.
    fn read_ages(&mut self, good: &mut [Value]) -> Vec<Option<Value>> {
        let Some(irregular) = &self.functional.irregular else { return Vec::new() };
        let (mut ages, mut field, scalar) = (Vec::new(), self.plant.outputs.len(), self.plant.scalar);
        for (law, good) in irregular.ages.iter().zip(good) {
            let Some(law) = law else {
                ages.push(None);
                continue;
            };
            let b = &mut self.builder;
            let age = b.read_measurement(place(field));
            field += 1;
            let young = b.in_range(age, 0.0, law.oldest(scalar));
            *good = b.and(*good, young);
            let scale = b.float(law.scale.value(scalar));
            let share = b.mul(age, scale);
            let none = b.float(0.0);
            ages.push(Some(b.select(*good, share, none)));
        }
        ages
    }

    /// Samples that count: not those of the first call that show a time before it, as nobody says what acted on the
    /// plant then.
    fn of_known_past(&mut self, good: &[Value], ages: &[Option<Value>]) -> Vec<Value> {
        let mut there = good.to_vec();
        if self.functional.signals.is_empty() {
            return there;
        }
        let b = &mut self.builder;
        for (there, _) in there.iter_mut().zip(ages).filter(|(_, age)| age.is_some()) {
            let (calls, none) = (b.read(self.cells.calls), b.index(0));
            let later = b.index_less(none, calls);
            *there = b.and(*there, later);
        }
        there
    }

    /// How far a sample is from its place; folded where it wraps.
    fn off(&mut self, output: usize, measured: Value, place: Value) -> Value {
        let (plant, b) = (self.plant, &mut self.builder);
        let off = b.sub(measured, place);
        front::folded(b, &plant.outputs[output], off, plant.scalar)
    }

    /// Samples with an age as if nothing had acted on the plant since then.
    fn at_the_call(
        &mut self,
        used: Vec<Value>,
        good: &[Value],
        ages: &[Option<Value>],
        (slots, signals): (&[(Value, Value)], &[Value]),
    ) -> Vec<Value> {
        let Some(irregular) = &self.functional.irregular else { return used };
        let mut moved = used;
        for (o, age) in ages.iter().enumerate() {
            let (Some(age), Some(law)) = (age, &irregular.ages[o]) else { continue };
            let kept = self.cells.signals.clone();
            let before: Vec<Value> = kept.iter().map(|kept| kept.read(&mut self.builder, slots[o].0)).collect();
            let b = &mut self.builder;
            if let Some(share) = acted(b, self.plant.scalar, law, *age, (&before, signals)) {
                let sample = b.add(moved[o], share);
                moved[o] = b.select(good[o], sample, moved[o]);
            }
        }
        moved
    }

    /// Per output: whether a nonlinear term needs its value.
    fn feeds(&self) -> Vec<bool> {
        let mut feeds = vec![false; self.plant.outputs.len()];
        for signal in &self.functional.signals {
            let Source::Injection(k) = signal.source else { continue };
            for symbol in self.plant.injections[k].symbols() {
                let Symbol::State(j) = symbol else { continue };
                self.plant.states[j].measured.iter().for_each(|(o, _)| feeds[*o] = true);
            }
        }
        feeds
    }

    pub(super) fn memory(&self) -> &Memory {
        self.cells.memory.as_ref().unwrap_or_else(|| unreachable!("declared with the solve"))
    }

    /// Where a sample of this call stands: at the slot of the time that it shows; with the slot before.
    fn slot(&mut self, output: usize, before: Value, newest: Value) -> (Value, Value) {
        let Some(cell) = self.memory().late[output] else { return (before, newest) };
        let window = self.window();
        let before = self.builder.read(cell);
        let before = self.builder.at_most(before, window - 1);
        let slot = self.builder.advance(before, window);
        self.builder.set(cell, slot);
        (before, slot)
    }

    /// The state as the model predicts it before the samples are known: what runs to a value that they bring stays
    /// where it was.
    fn foresee(&mut self, signals: &[Option<Value>], before: Value) -> Vec<Value> {
        let mut values = Vec::new();
        for (s, signal) in self.functional.signals.iter().enumerate() {
            values.push(match (signals[s], signal.part) {
                (Some(value), _) => value,
                // The end follows its start.
                (None, Part::End) => values[s - 1],
                (None, _) => self.cells.signals[s].read(&mut self.builder, before),
            });
        }
        self.predicted_state(&values)
    }

    /// What the model predicts of an output where there is an estimate, else what it showed last.
    fn instead(&mut self, output: usize, state: Option<&[Value]>, last: Value) -> Value {
        let Some(state) = state else { return last };
        let (predicted, sane) = self.stand_in(output, state);
        let known = self.known();
        let usable = self.builder.and(known, sane);
        self.builder.select(usable, predicted, last)
    }

    /// What an output shows of a predicted state, folded where it wraps; and whether a sample may be so.
    fn stand_in(&mut self, output: usize, state: &[Value]) -> (Value, Value) {
        let (plant, (low, high)) = (self.plant, self.guard.outputs[output]);
        let predicted = self.shown(output, state);
        let b = &mut self.builder;
        let predicted = front::folded(b, &plant.outputs[output], predicted, plant.scalar);
        let (low, high) = plant.outputs[output].wrap.as_ref().map_or((low, high), |wrap| {
            let turn = round(&wrap.turn, plant.scalar);
            (low.max(-turn), high.min(turn))
        });
        (predicted, b.in_range(predicted, low, high))
    }

    /// What the window keeps for nonlinear terms, now that the signals are known at both ends; and whether to start
    /// again: a prediction beyond the range, or one that has fed on itself for a window.
    fn settle_stand_ins(
        &mut self,
        feeds: &[bool],
        (measured, good): (&[Value], &[Value]),
        used: &[Value],
        signals: &[Value],
    ) -> (Vec<Value>, Vec<Value>) {
        let state = self.predicted_state(signals);
        let known = self.known();
        let mut lost = Vec::new();
        let mut kept = Vec::new();
        for o in 0..measured.len() {
            if !feeds[o] {
                kept.push(used[o]);
                continue;
            }
            let (predicted, sane) = self.stand_in(o, &state);
            let usable = self.builder.and(known, sane);
            let instead = self.builder.select(usable, predicted, used[o]);
            kept.push(self.builder.select(good[o], measured[o], instead));
            let (missing, beyond) = (self.builder.not(good[o]), self.builder.not(sane));
            let runs_away = self.builder.and(known, beyond);
            lost.push(self.builder.and(missing, runs_away));
        }
        let window = self.window();
        let missed: Vec<_> = self.cells.missed.iter().map(|cell| (*cell, window)).collect();
        let gone = gone(&mut self.builder, &missed, good);
        if !gone.is_empty() {
            let feeding: Vec<Value> =
                gone.iter().zip(feeds).filter(|(_, feeds)| **feeds).map(|(gone, _)| *gone).collect();
            let (some, all) = (any(&mut self.builder, &feeding), all(&mut self.builder, &gone));
            let some_left = self.builder.not(all);
            lost.push(self.builder.and(some, some_left));
        }
        (kept, lost)
    }

    /// Whether the last call had an estimate.
    pub(super) fn known(&mut self) -> Value {
        let known = self.memory().known;
        let (known, one) = (self.builder.read(known), self.builder.index(1));
        self.builder.index_equal(known, one)
    }
}
