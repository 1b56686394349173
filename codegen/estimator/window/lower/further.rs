//! How far samples are from where they should be, and where a missing count should be: of a counter, in counts, so that
//! nothing is lost however far it has counted.

use super::Lowering;
use crate::program::{Value, place};
use crate::step::front;

impl Lowering<'_> {
    /// How far a sample is from the place that it should have.
    pub(super) fn distance(
        &mut self,
        output: usize,
        (measured, expected): (Value, Value),
        predicted: Value,
        before: Value,
    ) -> Value {
        let (sensor, scalar, b) = (&self.plant.outputs[output], self.plant.scalar, &mut self.builder);
        let distance = match self.cells.outputs[output].count(b, before) {
            Some((last, counts)) => {
                let now = b.read_count(place(output));
                let moved = counts.moved(b, now, last);
                b.sub(moved, predicted)
            }
            None => b.sub(measured, expected),
        };
        front::folded(b, sensor, distance, scalar)
    }

    /// What enters the window of an output that is kept as a count, in its unit and as that: the sample if it is good,
    /// else the count that is nearest to so much further than the last one, if that is usable.
    pub(super) fn counted_further(
        &mut self,
        output: usize,
        (good, usable): (Value, Value),
        further: Value,
        before: Value,
    ) -> Option<(Value, Option<Value>)> {
        let b = &mut self.builder;
        let (last, counts) = self.cells.outputs[output].count(b, before)?;
        let now = b.read_count(place(output));
        let foretold = counts.further(b, last, further);
        let instead = b.select(usable, foretold, last);
        let count = b.select(good, now, instead);
        Some((counts.place(b, count), Some(count)))
    }
}
