//! The longest line that fits: all fits in one loop over the samples, then all their deviations in another over the
//! pairs of a window and a sample in it.
//!
//! What is kept is what the signal moved from sample to sample, and in how many calls: a lost sample is a longer way, not
//! a row of its own, and the sums are of differences to the newest sample, however far the signal has come.

use crate::numbers::count;
use crate::program::{CellId, Value};

use super::super::AdaptiveWindow;
use super::{Lowering, calls};

/// What is kept.
struct Cells {
    /// The newest sample.
    last: CellId,
    /// Calls since it, at most one more than the window is long.
    since: CellId,
    /// By slot: what the signal moved to a sample from the one before.
    moves: CellId,
    /// By slot: in how many calls.
    gaps: CellId,
    /// Slot of the newest move.
    newest: CellId,
    /// Samples, at most N + 1.
    samples: CellId,
    /// By window: the line's slope against age, per call.
    slopes: CellId,
    /// By window: the line at the newest sample, off it.
    levels: CellId,
    /// The slope that was chosen, per call.
    slope: CellId,
    /// The line at the newest sample, off it.
    level: CellId,
    /// Whether there is a line: 1 or 0.
    known: CellId,
}

/// A line: its slope against age per call, and its value at the newest sample, off it.
#[derive(Clone, Copy)]
struct Line {
    slope: Value,
    level: Value,
}

impl Lowering<'_> {
    /// The whole step.
    pub(super) fn adaptive_window(&mut self, law: &AdaptiveWindow) {
        let cells = self.window_cells(law);
        let (sample, good) = self.read();
        let since = self.move_on(law, &cells, sample, good);
        self.fit(law, &cells);
        let (line, usable) = self.longest(law, &cells);
        self.builder.section("the estimate: the line at this call, and its slope");
        let (zero, none, one) = (self.builder.float(0.0), self.builder.index(0), self.builder.index(1));
        let b = &mut self.builder;
        let known = b.read(cells.known);
        let before = b.index_equal(known, one);
        let known = b.select(good, usable, before);
        let kept = [cells.slope, cells.level].map(|cell| b.read(cell));
        let chosen = [line.slope, line.level].map(|value| b.select(usable, value, zero));
        let [slope, level] = [0, 1].map(|i| b.select(good, chosen[i], kept[i]));
        b.set(cells.slope, slope);
        b.set(cells.level, level);
        let flag = b.select(known, one, none);
        b.set(cells.known, flag);
        let last = b.read(cells.last);
        let past = b.to_float(since);
        let run = b.mul(slope, past);
        let off = b.sub(level, run);
        let signal = b.add(last, off);
        let signal = self.folded(signal);
        let period = self.constant(law.period);
        let rate = self.builder.div(slope, period);
        let rate = self.builder.sub(zero, rate);
        self.report([signal, rate], (known, good), good);
    }

    fn window_cells(&mut self, law: &AdaptiveWindow) -> Cells {
        let (n, name) = (calls(law.longest), &self.plant.states[0].label.name);
        let b = &mut self.builder;
        Cells {
            last: b.float_cell(&format!("last_{name}"), &format!("the newest sample of {name}"), 0.0),
            since: b.index_cell("since", &format!("calls since it, at most {}", n + 1), 0),
            moves: b.ring("moves", &format!("what {name} moved from sample to sample, by slot"), n, 0.0),
            // Never 0, not even where there has been no sample: ages must differ.
            gaps: b.ring("gaps", "in how many calls, by slot", n, 1.0),
            newest: b.index_cell("newest", "slot of the newest move", n - 1),
            samples: b.index_cell("samples", &format!("good samples, at most {}", n + 1), 0),
            slopes: b.ring("slopes", "slope against age of the line through so many moves", n, 0.0),
            levels: b.ring("levels", "that line at the newest sample, off it", n, 0.0),
            slope: b.float_cell("slope", "slope against age of the line that was chosen", 0.0),
            level: b.float_cell("level", "that line at the newest sample, off it", 0.0),
            known: b.index_cell("known", "1 where there is a line", 0),
        }
    }

    /// Puts a good sample into the window; the calls since the newest one.
    fn move_on(&mut self, law: &AdaptiveWindow, cells: &Cells, sample: Value, good: Value) -> Value {
        let n = calls(law.longest);
        let b = &mut self.builder;
        let last = b.read(cells.last);
        let since = b.read(cells.since);
        let waited = b.count_up(since, n + 1);
        let none = b.index(0);
        // The first sample is the end of no move: what is written for it is in no window.
        let moved = b.sub(sample, last);
        let moved = self.folded(moved);
        let b = &mut self.builder;
        let gap = b.to_float(waited);
        let newest = b.read(cells.newest);
        let newest = b.at_most(newest, n - 1);
        let next = b.advance(newest, n);
        let newest = b.select(good, next, newest);
        let kept = [cells.moves, cells.gaps].map(|ring| b.read_ring(ring, newest));
        let moved = b.select(good, moved, kept[0]);
        let gap = b.select(good, gap, kept[1]);
        b.set_ring(cells.moves, newest, moved);
        b.set_ring(cells.gaps, newest, gap);
        b.set(cells.newest, newest);
        let since = b.select(good, none, waited);
        b.set(cells.since, since);
        let last = b.select(good, sample, last);
        b.set(cells.last, last);
        let samples = b.read(cells.samples);
        let more = b.count_up(samples, n + 1);
        let samples = b.select(good, more, samples);
        b.set(cells.samples, samples);
        since
    }

    /// The lines by least squares through the newest n + 1 samples, for every n.
    fn fit(&mut self, law: &AdaptiveWindow, cells: &Cells) {
        let n = calls(law.longest);
        let b = &mut self.builder;
        b.section("the line through each number of samples");
        let rows = (1..=law.longest).map(|moves| vec![count(moves)]).collect();
        let table = b.table("WINDOWS", "windows by length", vec!["moves".to_owned()], rows);
        let (none, zero, one) = (b.index(0), b.float(0.0), b.float(1.0));
        let newest = b.read(cells.newest);
        let newest = b.at_most(newest, n - 1);
        let starts = [newest, none, zero, zero, one, zero, zero, zero, zero];
        b.loop_over(table, &starts, |b, carried| {
            let [slot, window, age, off, points, ages, squares, offs, products] = carried else {
                unreachable!("as many as there are starts")
            };
            let (gap, moved) = (b.read_ring(cells.gaps, *slot), b.read_ring(cells.moves, *slot));
            let (age, off, points) = (b.add(*age, gap), b.sub(*off, moved), b.add(*points, one));
            let (square, product) = (b.mul(age, age), b.mul(age, off));
            let (ages, squares) = (b.add(*ages, age), b.add(*squares, square));
            let (offs, products) = (b.add(*offs, off), b.add(*products, product));
            let (whole, part) = (b.mul(points, squares), b.mul(ages, ages));
            let determinant = b.sub(whole, part);
            let (whole, part) = (b.mul(points, products), b.mul(ages, offs));
            let slope = b.sub(whole, part);
            let slope = b.div(slope, determinant);
            let part = b.mul(slope, ages);
            let level = b.sub(offs, part);
            let level = b.div(level, points);
            b.set_ring(cells.slopes, *window, slope);
            b.set_ring(cells.levels, *window, level);
            let (slot, window) = (b.retreat(*slot, n), b.advance(*window, n));
            vec![slot, window, age, off, points, ages, squares, offs, products]
        });
    }

    /// The longest of them, and whether there is one: from the newest two samples on, until one leaves a sample too far off.
    fn longest(&mut self, law: &AdaptiveWindow, cells: &Cells) -> (Line, Value) {
        let n = calls(law.longest);
        let deviation = law.deviation.value(self.plant.scalar);
        let b = &mut self.builder;
        b.section("the longest that leaves no sample further off than the deviation");
        let (none, two, zero, most) = (b.index(0), b.index(2), b.float(0.0), b.float(count(law.longest)));
        let (newest, samples) = (b.read(cells.newest), b.read(cells.samples));
        let newest = b.at_most(newest, n - 1);
        let first = Line { slope: b.read_ring(cells.slopes, none), level: b.read_ring(cells.levels, none) };
        let gap = b.read_ring(cells.gaps, newest);
        let (near, one) = (b.less_equal(gap, most), b.index(1));
        let several = b.index_less(one, samples);
        let usable = b.and(near, several);
        if law.longest == 1 {
            return (first, usable);
        }
        let pairs =
            (2..=law.longest).flat_map(|moves| (0..=moves).map(move |sample| vec![count(moves), count(sample)]));
        let columns = vec!["moves".to_owned(), "sample".to_owned()];
        let table = b.table("PAIRS", "each window with each of its samples", columns, pairs.collect());
        let yes = b.boolean(true);
        let starts = [two, none, newest, zero, zero, yes, usable, first.slope, first.level];
        let found = b.loop_over(table, &starts, |b, carried| {
            let [moves, sample, slot, age, off, within, growing, slope, level] = carried else {
                unreachable!("as many as there are starts")
            };
            let window = b.count_down(*moves);
            let window = b.at_most(window, n - 1);
            let line = Line { slope: b.read_ring(cells.slopes, window), level: b.read_ring(cells.levels, window) };
            let shown = b.mul(line.slope, *age);
            let shown = b.add(line.level, shown);
            let apart = b.sub(*off, shown);
            let close = b.in_range(apart, -deviation, deviation);
            let within = b.and(*within, close);
            let last = b.index_equal(*sample, *moves);
            let (near, there) = (b.less_equal(*age, most), b.index_less(*moves, samples));
            let fits = b.and(within, near);
            let fits = b.and(fits, there);
            let fits = b.and(fits, *growing);
            let taken = b.and(last, fits);
            let (slope, level) = (b.select(taken, line.slope, *slope), b.select(taken, line.level, *level));
            let growing = b.select(last, fits, *growing);
            let within = b.select(last, yes, within);
            let (gap, moved) = (b.read_ring(cells.gaps, *slot), b.read_ring(cells.moves, *slot));
            let (older, further) = (b.add(*age, gap), b.sub(*off, moved));
            let (age, off) = (b.select(last, zero, older), b.select(last, zero, further));
            let (behind, longer, next) = (b.retreat(*slot, n), b.count_up(*moves, n), b.count_up(*sample, n));
            let slot = b.select(last, newest, behind);
            let (moves, sample) = (b.select(last, longer, *moves), b.select(last, none, next));
            vec![moves, sample, slot, age, off, within, growing, slope, level]
        });
        (Line { slope: found[7], level: found[8] }, usable)
    }
}
