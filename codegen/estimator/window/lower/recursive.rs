//! The filter with one delayed innovation as operations, with one copy or with two that take turns.

use crate::program::{CellId, Value};

use super::super::realize::recursive::Recursive;
use super::copies::Vector;
use super::{Lowering, Sampled, index};

/// The state of a copy with its filter.
struct Filter {
    /// Per state that is driven: what was handed on.
    handed: Vec<Option<CellId>>,
    /// Per component.
    filter: Vec<CellId>,
}

/// The same as values.
struct Running {
    handed: Vector,
    filter: Vec<Value>,
}

impl Lowering<'_> {
    /// The estimate from the filter.
    pub(super) fn recursive(
        &mut self,
        recursive: &Recursive,
        sampled: &Sampled,
        before: Value,
        count: Value,
    ) -> Vec<Value> {
        if recursive.turns {
            return self.by_turns(recursive, sampled, count);
        }
        // A full window before this call: its oldest innovation leaves now.
        let full = self.counted(before, self.window());
        self.alone(recursive, sampled, full, count)
    }

    fn alone(&mut self, recursive: &Recursive, sampled: &Sampled, full: Value, count: Value) -> Vec<Value> {
        let filter = self.filter(recursive, "");
        let rings = self.innovation_rings("innovation");
        self.builder.section("copy and filter; they start with the first sample of a window");
        let fresh = self.fresh(count);
        let none = self.builder.float(0.0);
        let before = self.filter_now(&filter);
        let running = self.unless(fresh, before);
        let old: Vec<Value> = rings
            .iter()
            .map(|ring| {
                let old = self.builder.read_ring(*ring, sampled.newest);
                let old = self.builder.select(full, old, none);
                self.builder.select(fresh, none, old)
            })
            .collect();
        let (estimate, innovations) = self.filtered(recursive, &filter, &running, Some(&old), fresh, sampled);
        for (ring, v) in rings.iter().zip(&innovations) {
            self.builder.set_ring(*ring, sampled.newest, *v);
        }
        estimate
    }

    /// Two copies: the one that has filled takes over every N calls.
    fn by_turns(&mut self, recursive: &Recursive, sampled: &Sampled, count: Value) -> Vec<Value> {
        let [used, filling] = ["used_", "filling_"].map(|which| self.filter(recursive, which));
        let rings = [self.innovation_rings("innovation"), self.innovation_rings("innovation")];
        let turn = self.builder.index_cell("age", "calls since the copies took turns", 0);
        let which = self.builder.index_cell("ring", "whose innovations the copy in use has", 0);
        self.builder.section("two copies with their filters, restarted by turns");
        let fresh = self.fresh(count);
        let (zero, one, none) = (self.builder.index(0), self.builder.index(1), self.builder.float(0.0));
        let before = self.builder.read(turn);
        let next = self.builder.advance(before, index(recursive.steps));
        let row = self.builder.select(fresh, zero, next);
        self.builder.set(turn, row);
        let begin = self.builder.index_equal(row, zero);
        let was = self.builder.read(which);
        let was_first = self.builder.index_equal(was, zero);
        let other = self.builder.select(was_first, one, zero);
        let is = self.builder.select(begin, other, was);
        self.builder.set(which, is);
        let first = self.builder.index_equal(is, zero);

        let (before_used, before_filling) = (self.filter_now(&used), self.filter_now(&filling));
        let taken = self.choose(begin, &before_filling, &before_used);
        let to_use = self.unless(fresh, taken);
        let to_fill = self.unless(begin, before_filling);
        let old: Vec<Value> = rings[0]
            .iter()
            .zip(&rings[1])
            .map(|(a, b)| {
                let (a, b) = (self.builder.read_ring(*a, sampled.newest), self.builder.read_ring(*b, sampled.newest));
                let old = self.builder.select(first, a, b);
                // Just filled: everything is still in its window.
                self.builder.select(begin, none, old)
            })
            .collect();
        let (_, of_filling) = self.filtered(recursive, &filling, &to_fill, None, begin, sampled);
        let (estimate, of_used) = self.filtered(recursive, &used, &to_use, Some(&old), fresh, sampled);
        for ((a, b), (used, filling)) in rings[0].iter().zip(&rings[1]).zip(of_used.iter().zip(&of_filling)) {
            let (to_a, to_b) =
                (self.builder.select(first, *used, *filling), self.builder.select(first, *filling, *used));
            self.builder.set_ring(*a, sampled.newest, to_a);
            self.builder.set_ring(*b, sampled.newest, to_b);
        }
        estimate
    }

    fn filter(&mut self, recursive: &Recursive, which: &str) -> Filter {
        let handed = self.plant.states.iter().zip(&recursive.copy.live).map(|(state, live)| {
            let name = &state.label.name;
            let doc = format!("{name} as the {}copy hands it on", which.replace('_', " "));
            live.then(|| self.builder.float_cell(&format!("{which}copy_{name}"), &doc, 0.0))
        });
        let handed = handed.collect();
        let filter = (0..recursive.filter.0.len())
            .map(|k| self.builder.float_cell(&format!("{which}filter"), &format!("component {k} of the filter"), 0.0));
        Filter { handed, filter: filter.collect() }
    }

    fn innovation_rings(&mut self, name: &str) -> Vec<CellId> {
        let window = self.window();
        let ring = |output: &crate::plant::Output| {
            let doc = format!("innovations of {} by slot", output.label.name);
            self.builder.ring(name, &doc, window, 0.0)
        };
        self.plant.outputs.iter().map(ring).collect()
    }

    fn filter_now(&mut self, filter: &Filter) -> Running {
        Running {
            handed: filter.handed.iter().map(|cell| cell.map(|cell| self.builder.read(cell))).collect(),
            filter: filter.filter.iter().map(|cell| self.builder.read(*cell)).collect(),
        }
    }

    /// Zero where a condition holds.
    fn unless(&mut self, condition: Value, running: Running) -> Running {
        let none = self.builder.float(0.0);
        let mut keep = |value: Value| self.builder.select(condition, none, value);
        Running {
            handed: running.handed.into_iter().map(|value| value.map(&mut keep)).collect(),
            filter: running.filter.into_iter().map(&mut keep).collect(),
        }
    }

    fn choose(&mut self, condition: Value, then: &Running, otherwise: &Running) -> Running {
        let mut pick = |(a, b): (&Value, &Value)| self.builder.select(condition, *a, *b);
        let handed = then.handed.iter().zip(&otherwise.handed);
        let handed = handed.map(|(a, b)| Some(pick((a.as_ref()?, b.as_ref()?)))).collect();
        Running { handed, filter: then.filter.iter().zip(&otherwise.filter).map(pick).collect() }
    }

    /// Takes the samples of this call into a copy and its filter: the estimate and the innovations.
    fn filtered(
        &mut self,
        recursive: &Recursive,
        cells: &Filter,
        running: &Running,
        old: Option<&[Value]>,
        starts: Value,
        sampled: &Sampled,
    ) -> (Vec<Value>, Vec<Value>) {
        let none = self.builder.float(0.0);
        let now = self.copy_now(&recursive.copy, &running.handed, sampled);
        // What was known before the first sample has no weight.
        let now: Vector = now.into_iter().map(|now| Some(self.builder.select(starts, none, now?))).collect();
        let innovations = self.innovations(&recursive.copy, &now, sampled);
        let (v, f): (Vector, Vector) =
            (innovations.iter().copied().map(Some).collect(), running.filter.iter().copied().map(Some).collect());
        let old: Option<Vector> = old.map(|old| old.iter().copied().map(Some).collect());
        let mut filter: Vector = Vec::new();
        for (k, cell) in cells.filter.iter().enumerate() {
            let kept = self.row_times(&recursive.filter.0[k], &f, None);
            let added = self.row_times(&recursive.input.0[k], &v, kept);
            let gone = old.as_ref().and_then(|old| self.row_times(&recursive.delayed.0[k], old, None));
            let added = self.total([added]);
            let sum = gone.map_or(added, |gone| self.builder.sub(added, gone));
            self.builder.set(*cell, sum);
            filter.push(Some(sum));
        }
        let next = self.hand_over(&recursive.copy, &now, sampled);
        for (cell, value) in cells.handed.iter().zip(next) {
            if let (Some(cell), Some(value)) = (cell, value) {
                self.builder.set(*cell, value);
            }
        }
        let estimate = (0..now.len())
            .map(|i| {
                let read = self.row_times(&recursive.output.0[i], &filter, now[i]);
                let read = self.row_times(&recursive.direct.0[i], &v, read);
                self.total([read])
            })
            .collect();
        (estimate, innovations)
    }
}
