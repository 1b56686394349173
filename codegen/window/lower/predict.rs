//! What a missing sample is replaced by: the model's prediction of it.
//!
//! The part that was known at the end of the last call stands in a cell; the inputs since then are
//! added, and once the injections that run between samples are known, their rise.

use crate::program::Value;

use super::super::Part;
use super::{Lowering, late_len};

impl Lowering<'_> {
    /// What an output should measure now, with the signals that are known before the sample is.
    pub(super) fn predict(&mut self, output: usize, signals: &[Option<Value>]) -> Value {
        if let Some(slot) = self.cells.late[output] {
            let slot = self.builder.read(slot);
            let slot = self.builder.at_most(slot, late_len(self.functional, output) - 1);
            return self.builder.read_ring(self.cells.ahead[output], slot);
        }
        let mut sum = self.builder.read(self.cells.ahead[output]);
        for (s, value) in signals.iter().enumerate() {
            let prediction = &self.functional.prediction[output];
            let weight = match self.functional.signals[s].part {
                // For a start also its end's share, as long as the end is not known.
                Part::Held | Part::Start => prediction.held[s],
                Part::Runs | Part::Curves | Part::End => None,
            };
            if let (Some(value), Some(weight)) = (value, weight) {
                sum = self.add_product(sum, weight, *value);
            }
        }
        sum
    }

    /// The prediction once the signals that run between samples are known at both ends.
    pub(super) fn refine(&mut self, output: usize, predicted: Value, signals: &[Value], newest_before: Value) -> Value {
        let mut sum = predicted;
        for (s, signal) in self.functional.signals.iter().enumerate() {
            let begin = match signal.part {
                Part::Runs | Part::Curves => self.cells.signals[s].read(&mut self.builder, newest_before),
                Part::End => signals[s - 1],
                Part::Held | Part::Start => continue,
            };
            if let Some(weight) = self.functional.prediction[output].end[s] {
                let rise = self.builder.sub(signals[s], begin);
                sum = self.add_product(sum, weight, rise);
            }
        }
        sum
    }
}
