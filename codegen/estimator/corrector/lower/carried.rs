//! States in two floats: one call may add less to a state than half of its last bit, and a slow gain takes thousands of
//! calls to make good what each of them lost.
//!
//! `x = high + low`. A call adds up what the state grows by, with its correction, in the float's precision of that
//! growth; the sum with `high` is exact in two floats. What is shown, and what the innovation is of, is `high`, which is
//! the state to half of its last bit.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value};

use super::super::{Corrector, Frame};
use super::Lowering;

/// A coordinate after its correction.
#[derive(Clone, Copy)]
pub(super) struct Carried {
    pub(super) high: Value,
    /// What it leaves out, where a second float carries it.
    pub(super) low: Option<Value>,
}

/// The second floats.
pub(super) fn cells(b: &mut Builder, plant: &Plant, design: &Corrector) -> Vec<Option<CellId>> {
    let name = |i: usize| match design.frame {
        Frame::Plant { .. } => plant.states[i].label.name.clone(),
        Frame::Chain { .. } => format!("xi{}", i + 1),
    };
    let cell = |(i, twofold): (usize, &bool)| {
        let name = name(i);
        twofold.then(|| b.float_cell(&format!("low_{name}"), &format!("what {name} leaves out by its rounding"), 0.0))
    };
    design.twofold.iter().enumerate().map(cell).collect()
}

impl Lowering<'_> {
    /// Adds what the first float of a coordinate leaves out to the terms of its growth.
    pub(super) fn push_low(&mut self, i: usize, terms: &mut Vec<Value>) {
        terms.extend(self.cells.low[i].map(|cell| self.builder.read(cell)));
    }

    /// A coordinate by what it has moved to, or grown by where two floats carry it.
    pub(super) fn reached(&mut self, i: usize, moved: Value) -> Value {
        if !self.design.twofold[i] {
            return moved;
        }
        let high = self.builder.read(self.cells.state[i]);
        self.builder.add(high, moved)
    }

    /// All of them.
    pub(super) fn all_reached(&mut self, moved: &[Value]) -> Vec<Value> {
        moved.iter().enumerate().map(|(i, moved)| self.reached(i, *moved)).collect()
    }

    /// With their corrections.
    pub(super) fn corrected(&mut self, moved: &[Value], corrections: &[Value]) -> Vec<Carried> {
        let mut corrected = Vec::new();
        for (i, (moved, more)) in moved.iter().zip(corrections).enumerate() {
            let sum = self.builder.add(*moved, *more);
            let carried = Carried { high: sum, low: None };
            corrected.push(if self.design.twofold[i] { self.two_floats(i, sum) } else { carried });
        }
        corrected
    }

    fn two_floats(&mut self, i: usize, growth: Value) -> Carried {
        let high = self.builder.read(self.cells.state[i]);
        let (high, low) = self.builder.two_sum(high, growth);
        Carried { high, low: Some(low) }
    }

    /// Without some of it.
    pub(super) fn taken_off(&mut self, carried: Carried, share: Value) -> Carried {
        let Some(low) = carried.low else {
            return Carried { high: self.builder.sub(carried.high, share), low: None };
        };
        let none = self.builder.float(0.0);
        let less = self.builder.sub(none, share);
        let (high, rest) = self.builder.two_sum(carried.high, less);
        Carried { high, low: Some(self.builder.add(low, rest)) }
    }

    /// Writes what a coordinate leaves out; nothing, in a start.
    pub(super) fn store_low(&mut self, i: usize, low: Option<Value>, again: Value) {
        let Some((cell, low)) = self.cells.low[i].zip(low) else { return };
        let none = self.builder.float(0.0);
        let low = self.builder.select(again, none, low);
        self.builder.set(cell, low);
    }
}
