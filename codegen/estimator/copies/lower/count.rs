//! How many calls were good: when the observer starts, has converged, and coasts.

use crate::program::Value;
use crate::step::logic::all;
use crate::step::reading::Reading;

use super::cells::{clean_count, full_count, length};
use super::{Copies, Lowering};

/// What the counts say of this call.
pub(super) struct Counted {
    /// Whether the copies start now, or wait for it.
    pub(super) starting: Value,
    /// Whether the estimate has converged.
    pub(super) converged: Value,
    /// Whether there is one.
    pub(super) known: Value,
    /// Whether no replaced sample is in it.
    pub(super) clean: Value,
}

impl Lowering<'_> {
    /// Whether the last call was converged.
    pub(super) fn was_converged(&mut self) -> Value {
        let count = self.builder.read(self.cells.count);
        let below = self.builder.index(full_count(self.design) - 1);
        self.builder.index_less(below, count)
    }

    pub(super) fn count(&mut self, reading: &Reading, copies: &Copies) -> Counted {
        let good = [self.samples_good(reading), all(&mut self.builder, &reading.known.of_interval())];
        let [samples_good, interval_good] = good;
        self.builder.section("how much of the period is good");
        let mut converged = self.was_converged();
        let mut interval_good = interval_good;
        if let Some(again) = reading.again {
            let goes_on = self.builder.not(again);
            converged = self.builder.and(converged, goes_on);
            interval_good = self.builder.and(interval_good, goes_on);
        }
        let lost = self.builder.or(reading.lost, copies.wild);
        let (none, one) = (self.builder.index(0), self.builder.index(1));

        let before = self.builder.read(self.cells.count);
        let more = self.builder.count_up(before, full_count(self.design));
        let due = self.due();
        // The copies start at a sample, with nothing of the interval before it.
        let first = self.builder.select(due, one, none);
        let waiting = self.builder.index_equal(before, none);
        let interval_lost = self.builder.not(interval_good);
        let begins = self.builder.or(waiting, interval_lost);
        let growing = self.builder.select(begins, first, more);
        let unbroken = self.builder.or(converged, samples_good);
        let kept = self.builder.select(converged, more, growing);
        let kept = self.builder.select(unbroken, kept, none);
        let count = self.builder.select(lost, none, kept);
        self.builder.set(self.cells.count, count);

        let clean = self.clean([samples_good, interval_good], copies);
        let last_start = self.builder.index(length(self.design.calls.warm_up + 2));
        let starting = self.builder.index_less(count, last_start);
        let below = self.builder.index(full_count(self.design) - 1);
        let converged = self.builder.index_less(below, count);
        Counted { starting, converged, known: converged, clean }
    }

    /// Whether no replaced sample is in the estimate.
    fn clean(&mut self, [samples_good, interval_good]: [Value; 2], copies: &Copies) -> Value {
        let (none, one) = (self.builder.index(0), self.builder.index(1));
        let before = self.builder.read(self.cells.clean);
        let whole = clean_count(self.design);
        let more = self.builder.count_up(before, whole);
        let since = self.builder.select(interval_good, more, one);
        let clean = self.builder.select(samples_good, since, none);
        self.builder.set(self.cells.clean, clean);

        let good = self.builder.and(samples_good, interval_good);
        let below = self.builder.index(whole - 1);
        let enough = self.builder.index_less(below, clean);
        let renewed = self.builder.and(copies.full, enough);
        let coasting = self.builder.read(self.cells.coasting);
        let coasting = self.builder.select(renewed, none, coasting);
        let coasting = self.builder.select(good, coasting, one);
        self.builder.set(self.cells.coasting, coasting);
        self.builder.index_equal(coasting, none)
    }
}
