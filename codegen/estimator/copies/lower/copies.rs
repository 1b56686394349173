//! Carries both copies over one call, and resets them when a period is full.

use crate::program::Value;
use crate::sampled::weights::products;
use crate::step::kept::AGES;
use crate::step::reading::Reading;

use super::cells::length;
use super::{Copies, Lowering};

impl Lowering<'_> {
    /// Values of a term by age, from this call on. An input that runs straight has been what it is before the first.
    pub(super) fn by_age(&mut self, s: usize, now: Value) -> Vec<Value> {
        let (sensors, b) = (&self.sensors, &mut self.builder);
        let mut values = sensors.values[s].by_age(b, now);
        values[1] = sensors.begun(b, s, now);
        values
    }

    /// z1 and z2 of this call.
    pub(super) fn carry(&mut self, reading: &Reading) -> Copies {
        self.builder.section("both copies, one call on");
        let b = &mut self.builder;
        let by_age: Vec<Vec<Value>> =
            self.sensors.outputs.iter().zip(&reading.outputs).map(|(kept, now)| kept.by_age(b, *now)).collect();
        let outputs: Vec<Vec<Value>> =
            (0..=AGES as usize).map(|age| by_age.iter().map(|ages| ages[age]).collect()).collect();
        let knowns: Vec<Vec<Value>> = reading.signals.iter().enumerate().map(|(s, now)| self.by_age(s, *now)).collect();
        let design = self.design;
        let mut carried = [Vec::new(), Vec::new()];
        let both = [(&design.first, self.cells.first.clone()), (&design.second, self.cells.second.clone())];
        for ((update, cells), carried) in both.into_iter().zip(&mut carried) {
            let copy: Vec<Value> = cells.iter().map(|cell| self.builder.read(*cell)).collect();
            for row in 0..copy.len() {
                let terms = self.row_terms(update, row, &copy, (&outputs, &knowns));
                carried.push(self.builder.sum(&terms));
            }
        }
        self.reset(reading, carried)
    }

    fn reset(&mut self, reading: &Reading, [first, second]: [Vec<Value>; 2]) -> Copies {
        self.builder.section("the reset, when a period is full");
        let before = self.builder.read(self.cells.phase);
        let phase = self.builder.advance(before, length(self.design.calls.period));
        let none = self.builder.index(0);
        let full = self.builder.index_equal(phase, none);
        let gained = products(&mut self.builder, &self.design.gain, &reading.outputs);
        let mut difference = Vec::new();
        for i in 0..first.len() {
            let second = self.builder.sub(second[i], gained[i]);
            difference.push(self.builder.sub(first[i], second));
        }
        let correction = products(&mut self.builder, &self.design.reset, &difference);
        let mut after = [Vec::new(), Vec::new()];
        let mut sane = self.builder.boolean(true);
        for i in 0..first.len() {
            let common = self.builder.add(first[i], correction[i]);
            let limit = self.bounds.limits[i];
            let within = self.builder.in_range(common, -limit, limit);
            sane = self.builder.and(sane, within);
            let shifted = self.builder.add(common, gained[i]);
            after[0].push(self.builder.select(full, common, first[i]));
            after[1].push(self.builder.select(full, shifted, second[i]));
        }
        let wild = self.builder.not(sane);
        let wild = self.builder.and(full, wild);
        Copies { after, full, phase, wild, carried: first }
    }
}
