//! What the observer foretells of its outputs, and what stands for those that are not there or not measured now.

use crate::estimator::copies::known::Run;
use crate::program::Value;
use crate::program::builder::Builder;
use crate::sampled::weights::constant;
use crate::step::kept::AGES;
use crate::step::known::Known;
use crate::step::logic::all;
use crate::step::reading::{self, Foretells, Foretold, Reading};

use super::Lowering;
use super::cells::length;

impl<'a> Lowering<'a> {
    /// Reads the samples; those of a call that is not measured are none.
    pub(super) fn read(&mut self) -> Reading<'a> {
        self.builder.section("samples: outside its range, infinite or NaN means missing");
        self.due();
        self.believed(0);
        let sensors = self.sensors.clone();
        reading::read(self, &sensors, Some("prediction, for a sample that is missing or not measured now"))
    }

    /// Whether this call is one that is measured.
    pub(super) fn due(&mut self) -> Value {
        let every = length(self.design.calls.every);
        if every == 1 {
            return self.builder.boolean(true);
        }
        let turn = self.builder.read(self.cells.turn);
        let turn = self.builder.at_most(turn, every - 1);
        let none = self.builder.index(0);
        self.builder.index_equal(turn, none)
    }

    /// Whether every sample of this call, as far as it is measured, was good.
    pub(super) fn samples_good(&mut self, reading: &Reading) -> Value {
        let due = self.due();
        let b = &mut self.builder;
        let idle = b.not(due);
        let fine: Vec<Value> = reading.good.iter().map(|good| b.or(*good, idle)).collect();
        let fine: Vec<Value> = fine.into_iter().chain(reading.known.of_sample()).collect();
        all(b, &fine)
    }

    /// A term's value of this call before the samples are looked at: extrapolated where it needs them.
    fn guess(&mut self, s: usize, known: &Known) -> Value {
        let (term, of_known) = (self.sensors.terms[s], &self.design.knowns[s]);
        if let (false, Some(value)) = (term.needs_samples, known.values[s]) {
            return value;
        }
        let b = &mut self.builder;
        let past: Vec<Value> = if of_known.jumps {
            // The same function at the samples before, with this interval's input; the nearest stands last.
            let earlier = self.sensors.terms.iter().zip(&known.values).rev();
            earlier
                .filter_map(|(other, value)| value.filter(|_| other.source == term.source && other.ago > 0))
                .collect()
        } else {
            (1..=AGES).map(|ago| self.sensors.values[s].ago(b, None, ago)).collect()
        };
        match (of_known.run, past.as_slice()) {
            (Run::Cubic, [one, two, three, ..]) => {
                // The parabola through three values, one step on: 3 (one - two) + three.
                let rise = b.sub(*one, *two);
                let factor = b.float(3.0);
                let rise = b.mul(factor, rise);
                b.add(rise, *three)
            }
            (_, [one, ..]) => *one,
            (_, []) => unreachable!("a value that needs the samples has one before"),
        }
    }

    /// What an output should be now, with the guesses for what is not known before the samples are.
    fn predict(&mut self, output: usize, guesses: &[Value]) -> Value {
        let b = &mut self.builder;
        let copy: Vec<Value> = self.cells.first.iter().map(|cell| b.read(*cell)).collect();
        let before: Vec<Value> = self.sensors.outputs.iter().map(|kept| kept.newest(b, None)).collect();
        let knowns: Vec<Vec<Value>> = guesses.iter().enumerate().map(|(s, guess)| self.by_age(s, *guess)).collect();
        // The predictor uses the outputs of the call before alone; those of now are what it predicts.
        let outputs = [before.clone(), before];
        let design = self.design;
        let terms = self.row_terms(&design.predictor, output, &copy, (&outputs, &knowns));
        self.builder.sum(&terms)
    }
}

impl<'a> Foretells<'a> for Lowering<'a> {
    fn builder(&mut self) -> &mut Builder {
        &mut self.builder
    }

    fn unfolds(&self) -> bool {
        true
    }

    fn screen(&mut self, good: &mut [Value]) {
        let due = self.due();
        for good in good {
            *good = self.builder.and(due, *good);
        }
    }

    fn foretells(&mut self, known: &Known) -> Option<Vec<Foretold>> {
        let guesses: Vec<Value> = (0..self.sensors.terms.len()).map(|s| self.guess(s, known)).collect();
        let each = (0..self.plant.outputs.len()).map(|o| Foretold::at(self.predict(o, &guesses)));
        Some(each.collect())
    }

    fn believed(&mut self, _output: usize) -> Value {
        let converged = self.was_converged();
        self.or_given(converged)
    }

    /// Between measured calls it is the nearest within the range.
    fn instead(&mut self, output: usize, (predicted, usable): (Value, Value), last: Value) -> (Value, Value) {
        let missing = self.builder.select(usable, predicted, last);
        if self.design.calls.every == 1 {
            return (missing, usable);
        }
        let due = self.due();
        let (low, high) = self.sensors.guard.outputs[output];
        let b = &mut self.builder;
        let (low, high) = (b.float(low), b.float(high));
        let above = b.maximum(low, predicted);
        let within = b.minimum(above, high);
        let idle = b.not(due);
        (b.select(due, missing, within), b.or(idle, usable))
    }

    fn settles(&mut self, output: usize, known: &Known, foretold: Foretold) -> Option<Foretold> {
        let mut place = foretold.place;
        for (s, of_known) in self.design.predictor.knowns.iter().enumerate() {
            let weight = of_known[0][output].filter(|_| self.sensors.terms[s].needs_samples);
            if let (Some(weight), Some(value)) = (weight, known.values[s]) {
                let guess = self.guess(s, known);
                let b = &mut self.builder;
                let weight = constant(b, weight);
                let change = b.sub(value, guess);
                let product = b.mul(weight, change);
                place = b.add(place, product);
            }
        }
        Some(Foretold::at(place))
    }

    fn present(&mut self, good: &[Value]) -> Vec<Value> {
        if self.design.calls.every == 1 {
            return good.to_vec();
        }
        let due = self.due();
        let b = &mut self.builder;
        let none = b.index(0);
        let present = self.sensors.missed.iter().zip(good).map(|((cell, _), good)| {
            let missed = b.read(*cell);
            let before = b.index_equal(missed, none);
            b.select(due, *good, before)
        });
        present.collect()
    }
}
