//! The reading of a call whose estimate is of the samples that are there: nothing stands in for a missing one, but where
//! a nonlinear term needs its value.

use crate::program::builder::Builder;
use crate::program::{Value, place};
use crate::sampled::Part;
use crate::step::front;
use crate::step::injections::needed;
use crate::step::kept::Kept;
use crate::step::known::Known;
use crate::step::reading::{self, Foretells, Foretold, Word};

use super::irregular::{Memory, acted};
use super::{Lowering, Sampled};

/// What is kept of a call beside the samples: where they stand, and whether there are any.
#[derive(Default)]
pub(crate) struct There {
    /// Per output: 1 for a sample, 0 for none.
    pub(super) present: Vec<Value>,
    /// Per output: the slot of the time that a sample shows.
    pub(super) slots: Vec<Value>,
    /// Per output whose samples come with their ages: this one's, over the oldest.
    pub(super) ages: Vec<Option<Value>>,
}

/// A reading for the solve.
struct Solving<'l, 'a> {
    lowering: &'l mut Lowering<'a>,
    /// Per output: whether a nonlinear term needs its value.
    feeds: Vec<bool>,
    ages: Vec<Option<Value>>,
    /// Per output: the slot where a sample of this call stands, with the one before.
    slots: Vec<(Value, Value)>,
}

impl<'a> Lowering<'a> {
    /// Reads, guards and evaluates.
    pub(super) fn sample_what_is_there(&mut self) -> Sampled<'a> {
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        let before = self.before();
        let (sensors, feeds) = (self.sensors(before), self.feeds());
        let asked = sensors.gated() || feeds.contains(&true);
        let why = asked.then_some("prediction of what the samples show");
        let mut solving = Solving { lowering: self, feeds, ages: Vec::new(), slots: Vec::new() };
        let mut reading = reading::read(&mut solving, &sensors, why);
        let Solving { feeds, ages, slots, .. } = solving;
        let there = self.of_known_past(&reading.good, &ages);
        let (zero, one) = (self.builder.float(0.0), self.builder.float(1.0));
        let present = there.iter().map(|there| self.builder.select(*there, one, zero)).collect();
        let count = self.builder.read(self.cells.count);
        let expected: Vec<Value> = if self.functional.gaps.is_some() {
            self.expected(&reading.good, count)
        } else {
            // Nothing is worse for a sample that is left out, unless a nonlinear term needs it.
            reading.good.iter().zip(&feeds).filter(|(_, feeds)| **feeds).map(|(good, _)| *good).collect()
        };
        reading.outputs = self.at_the_call(&reading, &ages, &slots);
        let newest = self.builder.advance(before, self.window());
        let there = There { present, slots: slots.into_iter().map(|(_, slot)| slot).collect(), ages };
        let sampled = self.worth(reading, newest, (&expected, Vec::new()), there);
        Sampled { samples_good: self.builder.boolean(true), ..sampled }
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
            let (calls, none) = (b.read(self.sensors.calls), b.index(0));
            let later = b.index_less(none, calls);
            *there = b.and(*there, later);
        }
        there
    }

    /// Samples with an age as if nothing had acted on the plant since then.
    fn at_the_call(
        &mut self,
        reading: &reading::Reading,
        ages: &[Option<Value>],
        slots: &[(Value, Value)],
    ) -> Vec<Value> {
        let mut moved = reading.outputs.clone();
        let Some(irregular) = &self.functional.irregular else { return moved };
        for (o, age) in ages.iter().enumerate() {
            let (Some(age), Some(law)) = (age, &irregular.ages[o]) else { continue };
            let b = &mut self.builder;
            let before: Vec<Value> = self.sensors.values.iter().map(|kept| kept.read(b, slots[o].0)).collect();
            if let Some(share) = acted(b, self.plant.scalar, law, *age, (&before, &reading.signals)) {
                let sample = b.add(moved[o], share);
                moved[o] = b.select(reading.good[o], sample, moved[o]);
            }
        }
        moved
    }

    /// Per output: whether a nonlinear term needs its value.
    fn feeds(&self) -> Vec<bool> {
        (0..self.plant.outputs.len()).map(|o| needed(self.plant, o)).collect()
    }

    pub(super) fn memory(&self) -> &Memory {
        self.cells.memory.as_ref().unwrap_or_else(|| unreachable!("declared with the solve"))
    }

    /// Where a sample of this call stands: at the slot of the time that it shows; with the slot before.
    fn slot(&mut self, output: usize) -> (Value, Value) {
        let (window, before) = (self.window(), self.before());
        let Some(cell) = self.memory().late[output] else { return (before, self.builder.advance(before, window)) };
        let before = self.builder.read(cell);
        let before = self.builder.at_most(before, window - 1);
        let slot = self.builder.advance(before, window);
        self.builder.set(cell, slot);
        (before, slot)
    }

    /// What outputs show of a state, folded where they wrap.
    fn all_shown(&mut self, state: &[Value]) -> Vec<Foretold> {
        let plant = self.plant;
        let each = plant.outputs.iter().enumerate().map(|(o, output)| {
            let predicted = self.shown(o, state);
            Foretold::at(front::folded(&mut self.builder, output, predicted, plant.scalar))
        });
        each.collect()
    }

    /// Whether the last call had an estimate.
    fn known(&mut self) -> Value {
        let known = self.memory().known;
        let (known, one) = (self.builder.read(known), self.builder.index(1));
        self.builder.index_equal(known, one)
    }
}

impl<'a> Foretells<'a> for Solving<'_, 'a> {
    fn builder(&mut self) -> &mut Builder {
        &mut self.lowering.builder
    }

    /// A sample that is too old, or of no known age, is missing; the age of none is 0.
    fn screen(&mut self, good: &mut [Value]) {
        let plant = self.lowering.plant;
        let Some(irregular) = &self.lowering.functional.irregular else { return };
        let (b, mut field) = (&mut self.lowering.builder, plant.outputs.len());
        for (law, good) in irregular.ages.iter().zip(good) {
            let Some(law) = law else {
                self.ages.push(None);
                continue;
            };
            let age = b.read_measurement(place(field));
            field += 1;
            let young = b.in_range(age, 0.0, law.oldest(plant.scalar));
            *good = b.and(*good, young);
            let scale = b.float(law.scale.value(plant.scalar));
            let share = b.mul(age, scale);
            let none = b.float(0.0);
            self.ages.push(Some(b.select(*good, share, none)));
        }
    }

    /// What runs to a value that the samples bring stays where it was.
    fn foretells(&mut self, known: &Known) -> Option<Vec<Foretold>> {
        let l = &mut *self.lowering;
        let before = l.before();
        l.builder.advance(before, l.window());
        let mut values = Vec::new();
        for (s, signal) in l.functional.signals.iter().enumerate() {
            values.push(match (known.values[s], signal.part) {
                (Some(value), _) => value,
                // The end follows its start.
                (None, Part::End) => values[s - 1],
                (None, _) => l.sensors.values[s].read(&mut l.builder, before),
            });
        }
        let state = l.predicted_state(&values);
        let foretold = l.all_shown(&state);
        self.slots = (0..foretold.len()).map(|o| l.slot(o)).collect();
        Some(foretold)
    }

    fn believed(&mut self, _output: usize) -> Value {
        self.lowering.known()
    }

    fn stands_in(&mut self, output: usize) -> Option<Value> {
        self.feeds[output].then(|| self.lowering.known())
    }

    fn last(&mut self, output: usize, kept: Kept, _newest: Option<Value>) -> Value {
        kept.read(&mut self.lowering.builder, self.slots[output].0)
    }

    fn settles(&mut self, output: usize, known: &Known, _foretold: Foretold) -> Option<Foretold> {
        let state = self.lowering.predicted_state(&known.all());
        Some(self.lowering.all_shown(&state)[output])
    }

    /// Without an estimate nothing is lost.
    fn lost(&mut self, good: Value, word: &Word) -> Value {
        let b = &mut self.lowering.builder;
        let (missing, beyond) = (b.not(good), b.not(word.sane));
        let runs_away = b.and(word.known, beyond);
        b.and(missing, runs_away)
    }
}
