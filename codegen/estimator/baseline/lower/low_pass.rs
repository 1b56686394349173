//! Held difference and low pass: a new quotient with each change of the signal, filtered at every call.

use crate::program::{CellId, Value};

use super::super::LowPass;
use super::{Lowering, calls};

/// What is kept.
struct Cells {
    /// The newest sample.
    last: CellId,
    /// Calls since it changed.
    since: CellId,
    /// The quotient at its last change.
    quotient: CellId,
    /// The filter.
    rate: CellId,
    /// Good calls, at most one more than convergence takes.
    good: CellId,
    /// Good calls in a row, likewise.
    clean: CellId,
}

impl Lowering<'_> {
    /// The whole step.
    pub(super) fn low_pass(&mut self, law: &LowPass) {
        let cells = self.low_pass_cells();
        let (sample, good) = self.read();
        let none = self.builder.index(0);
        let count = self.builder.read(cells.good);
        let begun = self.builder.index_less(none, count);
        let quotient = self.quotient(law, &cells, (sample, good, begun));
        self.builder.section("the filter");
        let rate = self.builder.read(cells.rate);
        let entering = self.constant(law.entering);
        let entering = self.builder.mul(entering, quotient);
        let rate = match law.kept {
            Some(kept) => {
                let kept = self.constant(kept);
                let kept = self.builder.mul(kept, rate);
                self.builder.add(kept, entering)
            }
            None => entering,
        };
        self.builder.set(cells.rate, rate);
        let last = self.builder.read(cells.last);
        let standing = self.low_pass_standing(&cells, count, (good, begun));
        self.report([last, rate], standing, good);
    }

    fn low_pass_cells(&mut self) -> Cells {
        let (signal, rate) = (&self.plant.states[0].label.name, &self.plant.states[1].label.name);
        let (valid, recovery) = (self.design.valid, self.design.recovery);
        let b = &mut self.builder;
        Cells {
            last: b.float_cell(&format!("last_{signal}"), &format!("the newest sample of {signal}"), 0.0),
            since: b.index_cell("since", "calls since it changed", 0),
            quotient: b.float_cell("quotient", &format!("change of {signal} over its time, at the last change"), 0.0),
            rate: b.float_cell(rate, &format!("{rate} as last estimated"), 0.0),
            good: b.index_cell("good", &format!("good calls, at most {}", valid + 1), 0),
            clean: b.index_cell("clean", &format!("good calls in a row, at most {recovery}"), 0),
        }
    }

    /// The change of the signal over the time since the change before; as it was where there is none.
    fn quotient(&mut self, law: &LowPass, cells: &Cells, (sample, good, begun): (Value, Value, Value)) -> Value {
        self.builder.section("the quotient: new where the sample has changed");
        let period = self.constant(law.period);
        let b = &mut self.builder;
        let (zero, none) = (b.float(0.0), b.index(0));
        let last = b.read(cells.last);
        let step = b.sub(sample, last);
        let step = self.folded(step);
        let b = &mut self.builder;
        let both = b.and(good, begun);
        let step = b.select(both, step, zero);
        let (rose, fell) = (b.less(zero, step), b.less(step, zero));
        let changed = b.or(rose, fell);
        let since = b.read(cells.since);
        let waited = b.count_up(since, u32::MAX);
        let elapsed = b.to_float(waited);
        let elapsed = b.mul(period, elapsed);
        let fresh = b.div(step, elapsed);
        let held = b.read(cells.quotient);
        let quotient = b.select(changed, fresh, held);
        let fresh_start = b.not(begun);
        let restart = b.or(changed, fresh_start);
        let since = b.select(restart, none, waited);
        let newest = b.select(good, sample, last);
        b.set(cells.quotient, quotient);
        b.set(cells.since, since);
        b.set(cells.last, newest);
        quotient
    }

    /// Counts the good calls since the start, and those in a row: whether there are enough of each.
    fn low_pass_standing(&mut self, cells: &Cells, count: Value, (good, begun): (Value, Value)) -> (Value, Value) {
        let (valid, recovery) = (calls(self.design.valid), calls(self.design.recovery));
        let b = &mut self.builder;
        let more = b.count_up(count, valid + 1);
        let count = b.select(good, more, count);
        b.set(cells.good, count);
        let (none, all) = (b.index(0), b.index(recovery));
        let clean = b.read(cells.clean);
        let more = b.count_up(clean, recovery);
        let clean = b.select(good, more, none);
        let clean = b.select(begun, clean, all);
        b.set(cells.clean, clean);
        let (enough, recovered) = (b.index(valid), b.index(recovery - 1));
        (b.index_less(enough, count), b.index_less(recovered, clean))
    }
}
