//! Copies of the plant as operations; what is structurally zero is not written.

use crate::program::{TableId, Value};
use crate::sampled::settled::Settled;

use super::super::realize::copy::Copy;
use super::super::realize::tables::Entries;
use super::{Lowering, Sampled};
use crate::program::place;

/// What is known of a vector's entries; `None` is zero.
pub(super) type Vector = Vec<Option<Value>>;

impl Lowering<'_> {
    /// The sum of entries times values and of further terms; `None` if there is none.
    pub(super) fn row_times(
        &mut self,
        row: &[Option<Settled>],
        values: &[Option<Value>],
        further: Option<Value>,
    ) -> Option<Value> {
        let mut terms: Vec<Value> = further.into_iter().collect();
        for (weight, value) in row.iter().zip(values) {
            if let (Some(weight), Some(value)) = (weight, value) {
                let weight = self.constant(*weight);
                terms.push(self.builder.mul(weight, *value));
            }
        }
        (!terms.is_empty()).then(|| self.builder.sum(&terms))
    }

    /// An entry of a table that exists if it has columns.
    pub(super) fn entry(&mut self, table: Option<TableId>, row: Value, column: usize) -> Value {
        let table = table.unwrap_or_else(|| unreachable!("a table without columns has no entries"));
        self.builder.lookup(table, row, place(column))
    }

    /// Signals of this call as a vector.
    fn signals(sampled: &Sampled) -> Vector {
        sampled.reading.signals.iter().map(|value| Some(*value)).collect()
    }

    /// A copy now: what was handed to this call, and the share of what the call brought.
    pub(super) fn copy_now(&mut self, copy: &Copy, handed: &[Option<Value>], sampled: &Sampled) -> Vector {
        let signals = Self::signals(sampled);
        let now = copy.end.0.iter().zip(handed).map(|(row, handed)| self.row_times(row, &signals, *handed));
        now.collect()
    }

    /// What a copy did not foresee of the samples, per output.
    pub(super) fn innovations(&mut self, copy: &Copy, now: &[Option<Value>], sampled: &Sampled) -> Vec<Value> {
        let mut innovation = |(row, sample): (&Vec<Option<Settled>>, &Value)| {
            let foreseen = self.row_times(row, now, None);
            foreseen.map_or(*sample, |foreseen| self.builder.sub(*sample, foreseen))
        };
        copy.seen.0.iter().zip(&sampled.reading.outputs).map(&mut innovation).collect()
    }

    /// What a copy hands to the next call.
    pub(super) fn hand_over(&mut self, copy: &Copy, now: &[Option<Value>], sampled: &Sampled) -> Vector {
        let signals = Self::signals(sampled);
        let samples: Vector = sampled.reading.outputs.iter().map(|sample| Some(*sample)).collect();
        let row = |entries: &Entries, i: usize| entries.0[i].clone();
        (0..copy.live.len())
            .map(|i| {
                if !copy.live[i] {
                    return None;
                }
                let constant = copy.constant.0[i][0].map(|constant| self.constant(constant));
                let moved = self.row_times(&row(&copy.step, i), now, constant);
                let injected = self.row_times(&row(&copy.inject, i), &samples, moved);
                self.row_times(&row(&copy.begin, i), &signals, injected)
            })
            .collect()
    }

    /// The sum of what is there; 0 if nothing is.
    pub(super) fn total(&mut self, terms: impl IntoIterator<Item = Option<Value>>) -> Value {
        let terms: Vec<Value> = terms.into_iter().flatten().collect();
        self.builder.sum(&terms)
    }
}
