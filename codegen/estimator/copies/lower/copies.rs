//! Carries both copies over one call, and resets them when a period is full.

use crate::program::{CellId, Value};

use super::cells::length;
use super::{Copies, Lowering, Sampled};

impl Lowering<'_> {
    /// Values by age from this call on: what is known now, then what the cells keep.
    pub(super) fn by_age(&mut self, now: Value, kept: &[CellId]) -> Vec<Value> {
        let kept = kept.iter().map(|cell| self.builder.read(*cell));
        std::iter::once(now).chain(kept).collect()
    }

    /// Moves values on by one call.
    pub(super) fn shift(&mut self, kept: &[CellId], now: Value) {
        let values = self.by_age(now, kept);
        for (cell, value) in kept.iter().zip(values) {
            self.builder.set(*cell, value);
        }
    }

    /// z1 and z2 of this call.
    pub(super) fn carry(&mut self, sampled: &Sampled) -> Copies {
        self.builder.section("both copies, one call on");
        // Per age: the outputs; per known: its ages.
        let outputs: Vec<Vec<Value>> = (self.cells.outputs.clone().iter().zip(&sampled.outputs))
            .map(|(kept, now)| self.by_age(*now, kept))
            .collect();
        let outputs: Vec<Vec<Value>> =
            (0..=super::cells::KEPT).map(|age| outputs.iter().map(|ages| ages[age]).collect()).collect();
        let knowns: Vec<Vec<Value>> = (self.cells.knowns.clone().iter().zip(&sampled.knowns))
            .enumerate()
            .map(|(s, (kept, now))| self.known_by_age(s, *now, kept))
            .collect();
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
        self.reset(sampled, carried)
    }

    fn reset(&mut self, sampled: &Sampled, [first, second]: [Vec<Value>; 2]) -> Copies {
        self.builder.section("the reset, when a period is full");
        let before = self.builder.read(self.cells.phase);
        let phase = self.builder.advance(before, length(self.design.calls.period));
        let none = self.builder.index(0);
        let full = self.builder.index_equal(phase, none);
        let gained = self.products(&self.design.gain, &sampled.outputs);
        let mut difference = Vec::new();
        for i in 0..first.len() {
            let second = self.builder.sub(second[i], gained[i]);
            difference.push(self.builder.sub(first[i], second));
        }
        let correction = self.products(&self.design.reset, &difference);
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
