//! What a missing sample is replaced by: the model's prediction of it.
//!
//! The part that was known at the end of the last call stands in a cell; the inputs since then are
//! added, and once the injections that run between samples are known, their rise.

use crate::program::Value;
use crate::step::front::folded;

use super::{Lowering, late_len};
use crate::program::CellId;
use crate::sampled::Part;
use crate::sampled::settled::Settled;

/// Unknown constants that the step finds by a regression of its own.
pub(crate) struct Unknowns {
    /// Calls in a row since which they are known, at most as many as a late output waits.
    pub(crate) found: CellId,
    /// Per unknown: its last good value, in the regression's own units.
    pub(crate) values: Vec<CellId>,
    /// Per output, signal and unknown: what [`super::super::Prediction`] has per signal, for a unit of the unknown.
    pub(crate) held: Vec<Vec<Vec<Option<Settled>>>>,
    /// Likewise, of the end of the step alone.
    pub(crate) end: Vec<Vec<Vec<Option<Settled>>>>,
}

/// What a signal's value counts in an output's prediction.
pub(super) enum Factor {
    /// A constant.
    Fixed(Settled),
    /// Unknowns, each with a constant.
    Believed(Vec<(CellId, Settled)>),
}

impl Lowering<'_> {
    /// What an output should measure now, with the signals that are known before the sample is; of one that wraps and
    /// is not late, how far it should have moved: [`Lowering::placed`].
    pub(super) fn predict(&mut self, output: usize, signals: &[Option<Value>]) -> Value {
        if let Some(slot) = self.cells.late[output] {
            let slot = self.builder.read(slot);
            let slot = self.builder.at_most(slot, late_len(self.functional, output) - 1);
            return self.builder.read_ring(self.cells.ahead[output], slot);
        }
        let mut sum = self.builder.read(self.cells.ahead[output]);
        for (s, value) in signals.iter().enumerate() {
            let weight = match self.functional.signals[s].part {
                // For a start also its end's share, as long as the end is not known.
                Part::Held | Part::Start => self.held(output, s),
                Part::Runs | Part::Curves | Part::End => None,
            };
            if let (Some(value), Some(weight)) = (value, weight) {
                let weight = self.factor(&weight);
                sum = self.add_product(sum, weight, *value);
            }
        }
        sum
    }

    /// Where an output should be, from what [`Lowering::predict`] says and the sample of the call before.
    pub(super) fn placed(&mut self, output: usize, predicted: Value, last: Value) -> Value {
        let sensor = &self.plant.outputs[output];
        let on_time = sensor.wrap.is_some() && self.functional.delays[output] == 0;
        let place = if on_time { self.builder.add(last, predicted) } else { predicted };
        folded(&mut self.builder, sensor, place, self.plant.scalar)
    }

    /// What a value counts that is held over the step; of a start, with its end's.
    pub(super) fn held(&self, output: usize, signal: usize) -> Option<Factor> {
        let fixed = self.functional.prediction[output].held[signal];
        fixed.map(Factor::Fixed).or_else(|| self.believed(&self.unknowns.as_ref()?.held[output][signal]))
    }

    /// What the part of a value counts that stands at the end of the step.
    fn end(&self, output: usize, signal: usize) -> Option<Factor> {
        let fixed = self.functional.prediction[output].end[signal];
        fixed.map(Factor::Fixed).or_else(|| self.believed(&self.unknowns.as_ref()?.end[output][signal]))
    }

    fn believed(&self, weights: &[Option<Settled>]) -> Option<Factor> {
        let values = self.unknowns.iter().flat_map(|unknowns| &unknowns.values);
        let terms: Vec<(CellId, Settled)> = values.zip(weights).filter_map(|(cell, w)| Some((*cell, (*w)?))).collect();
        (!terms.is_empty()).then_some(Factor::Believed(terms))
    }

    /// A factor as a value.
    pub(super) fn factor(&mut self, factor: &Factor) -> Value {
        let terms = match factor {
            Factor::Fixed(weight) => return self.constant(*weight),
            Factor::Believed(terms) => terms,
        };
        let products: Vec<Value> = terms
            .iter()
            .map(|(cell, weight)| {
                let weight = self.constant(*weight);
                let value = self.builder.read(*cell);
                self.builder.mul(weight, value)
            })
            .collect();
        self.builder.sum(&products)
    }

    /// The prediction once the signals that run between samples are known at both ends.
    pub(super) fn refine(&mut self, output: usize, predicted: Value, signals: &[Value], newest_before: Value) -> Value {
        let mut sum = predicted;
        for (s, signal) in self.functional.signals.iter().enumerate() {
            let begin = match signal.part {
                Part::Runs | Part::Curves => self.sensors.values[s].read(&mut self.builder, newest_before),
                Part::End => signals[s - 1],
                Part::Held | Part::Start => continue,
            };
            if let Some(weight) = self.end(output, s) {
                let rise = self.builder.sub(signals[s], begin);
                let weight = self.factor(&weight);
                sum = self.add_product(sum, weight, rise);
            }
        }
        sum
    }
}
