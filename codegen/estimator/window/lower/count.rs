//! How much of the window is good: when the estimate has converged, and for how long it coasts.

use crate::program::Value;

use super::super::Functional;
use super::{Lowering, Sampled, kept_len, late_len, window_len};

impl Lowering<'_> {
    /// Good samples in a row before and now, or how the window starts again.
    pub(crate) fn count(&mut self, sampled: &Sampled) -> (Value, Value) {
        self.builder.section("how much of the window is good");
        let before = self.builder.read(self.cells.count);
        let mut converged = self.had_converged(before, 1);
        let mut interval_good = sampled.interval_good;
        if let Some(again) = sampled.reading.again {
            let goes_on = self.builder.not(again);
            converged = self.builder.and(converged, goes_on);
            interval_good = self.builder.and(interval_good, goes_on);
        }
        let (none, one) = (self.builder.index(0), self.builder.index(1));
        let more = self.builder.count_up(before, longest_count(self.functional));
        let kept = self.builder.select(sampled.reading.lost, none, more);
        let grown = self.builder.select(interval_good, more, one);
        let growing = self.builder.select(sampled.samples_good, grown, none);
        let count = self.builder.select(converged, kept, growing);
        self.builder.set(self.cells.count, count);
        self.coast(sampled);
        (before, count)
    }

    /// Whether the count has come to so many calls.
    pub(crate) fn counted(&mut self, count: Value, calls: u32) -> Value {
        let below = self.builder.index(calls - 1);
        self.builder.index_less(below, count)
    }

    /// Whether the estimate of so many calls ago had converged, by the counts before this call.
    pub(super) fn had_converged(&mut self, count: Value, ago: u32) -> Value {
        let full = self.counted(count, self.window() - 1 + ago);
        let Some(found) = self.unknowns.as_ref().map(|unknowns| unknowns.found) else { return full };
        let found = self.builder.read(found);
        let found = self.counted(found, ago);
        self.builder.and(full, found)
    }

    /// Calls until no replaced sample is in the longest window.
    fn coast(&mut self, sampled: &Sampled) {
        let window = self.kept();
        let before = self.builder.read(self.cells.coasting);
        let mut coasting = self.builder.count_down(before);
        let interval = self.builder.index(window - 1);
        coasting = self.builder.select(sampled.interval_good, coasting, interval);
        for (o, good) in &sampled.late {
            // A late sample leaves the window earlier.
            let stays = window - late_len(self.functional, *o);
            let stays = self.builder.index(stays);
            let longer = self.builder.index_less(coasting, stays);
            let raised = self.builder.select(longer, stays, coasting);
            coasting = self.builder.select(*good, coasting, raised);
        }
        // What a prediction has brought in dies out by itself only where every sample renews the window.
        let stays = self.builder.index(window.max(settled(self.functional)));
        coasting = self.builder.select(sampled.newest_good, coasting, stays);
        self.builder.set(self.cells.coasting, coasting);
    }
}

/// Where the count ends: at a full window, the longest, or where every late output has a prediction.
pub(super) fn longest_count(functional: &Functional) -> u32 {
    let latest = (0..functional.delays.len()).map(|o| late_len(functional, o)).max().unwrap_or(0);
    let full = kept_len(functional) - 1 + latest.max(1);
    full.max(settled(functional))
}

/// Calls from which on the estimate is within its bound.
pub(super) fn settled(functional: &Functional) -> u32 {
    functional.gaps.map_or_else(|| window_len(functional), |gaps| super::bounded(gaps.settled))
}
