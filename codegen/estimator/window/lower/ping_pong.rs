//! Two copies as operations: one fills while the other is used; every N calls the filled one takes over.

use crate::program::{CellId, TableId, Value};

use super::super::realize::copy::Copy;
use super::super::realize::ping_pong::PingPong;
use super::super::realize::tables::ByPlace;
use super::copies::Vector;
use super::{Lowering, Sampled, index};

/// The state of a copy.
struct Half {
    /// Per state that is driven: what was handed on.
    handed: Vec<Option<CellId>>,
    /// Per component.
    statistic: Vec<CellId>,
    /// 1 while a replaced sample is in its window.
    replaced: CellId,
}

/// A copy during a call.
struct Running {
    handed: Vector,
    statistic: Vec<Value>,
    replaced: Value,
}

impl Lowering<'_> {
    /// The estimate from the copy that is used.
    pub(super) fn ping_pong(&mut self, pair: &PingPong, sampled: &Sampled, count: Value) -> Vec<Value> {
        let [used, filling] =
            ["used", "filling"].map(|which| self.half(&pair.copy, pair.read.0.first().map_or(0, Vec::len), which));
        self.builder.section("two copies, restarted by turns; both with the first sample of a window");
        let (row, begin, fresh) = self.turn(pair, count);
        let (before_used, before_filling) = (self.half_now(&used), self.half_now(&filling));
        let (none, zero) = (self.builder.float(0.0), self.builder.index(0));
        // A copy that has filled is used from now on; the other one starts again.
        let taken = |this: &mut Self, new: Value, old: Value, nothing: Value| {
            let taken = this.builder.select(begin, new, old);
            this.builder.select(fresh, nothing, taken)
        };
        let handed = before_filling.handed.iter().zip(&before_used.handed);
        let handed = handed.map(|(new, old)| Some(taken(self, (*new)?, (*old)?, none))).collect();
        let statistic = before_filling.statistic.iter().zip(&before_used.statistic);
        let statistic = statistic.map(|(new, old)| taken(self, *new, *old, none)).collect();
        let replaced = taken(self, before_filling.replaced, before_used.replaced, zero);
        let to_use = Running { handed, statistic, replaced };
        let restart = |this: &mut Self, old: Value, nothing: Value| this.builder.select(begin, nothing, old);
        let to_fill = Running {
            handed: before_filling.handed.iter().map(|old| Some(restart(self, (*old)?, none))).collect(),
            statistic: before_filling.statistic.iter().map(|old| restart(self, *old, none)).collect(),
            replaced: restart(self, before_filling.replaced, zero),
        };
        let tables = self.by_age(pair);
        self.builder.section("the copy that fills");
        self.run(&pair.copy, &filling, to_fill, (tables, row, begin), (&pair.filling, 0), sampled);
        self.builder.section("the copy that is used, and the estimate");
        let first_of_use = pair.filling.present().len();
        let (now, innovations, statistic) =
            self.run(&pair.copy, &used, to_use, (tables, row, fresh), (&pair.using, first_of_use), sampled);
        let first_of_read = first_of_use + pair.using.present().len();
        let first_of_direct = first_of_read + pair.read.present().len();
        let statistic: Vec<Value> = statistic;
        let mut terms: Vec<Vec<Option<Value>>> = now.into_iter().map(|now| vec![now]).collect();
        for (table, values, first) in
            [(&pair.read, &statistic, first_of_read), (&pair.direct, &innovations, first_of_direct)]
        {
            for (column, (i, j)) in table.present().into_iter().enumerate() {
                let weight = self.entry(tables, row, first + column);
                let product = self.builder.mul(weight, values[j]);
                terms[i].push(Some(product));
            }
        }
        terms.into_iter().map(|terms| self.total(terms)).collect()
    }

    fn half(&mut self, copy: &Copy, components: usize, which: &str) -> Half {
        let handed = self.plant.states.iter().zip(&copy.live).map(|(state, live)| {
            let name = &state.label.name;
            let doc = format!("{name} as the {which} copy hands it on");
            live.then(|| self.builder.float_cell(&format!("{which}_{name}"), &doc, 0.0))
        });
        let handed = handed.collect();
        let statistic = (0..components).map(|k| {
            let doc = format!("component {k} of the statistic of the {which} copy");
            self.builder.float_cell(&format!("{which}_statistic"), &doc, 0.0)
        });
        let statistic = statistic.collect();
        let doc = format!("1 while the {which} copy has seen a replaced sample");
        let replaced = self.builder.index_cell(&format!("{which}_replaced"), &doc, 0);
        Half { handed, statistic, replaced }
    }

    fn half_now(&mut self, half: &Half) -> Running {
        Running {
            handed: half.handed.iter().map(|cell| cell.map(|cell| self.builder.read(cell))).collect(),
            statistic: half.statistic.iter().map(|cell| self.builder.read(*cell)).collect(),
            replaced: self.builder.read(half.replaced),
        }
    }

    /// The row of the tables, whether the copies take turns now, and whether both start.
    fn turn(&mut self, pair: &PingPong, count: Value) -> (Value, Value, Value) {
        let cell = self.builder.index_cell("age", "calls since the copies took turns", 0);
        let fresh = self.fresh(count);
        let before = self.builder.read(cell);
        let next = self.builder.advance(before, index(pair.steps));
        let zero = self.builder.index(0);
        let row = self.builder.select(fresh, zero, next);
        self.builder.set(cell, row);
        let begin = self.builder.index_equal(row, zero);
        (row, begin, fresh)
    }

    /// Takes the samples of this call into a copy: the copy now, its innovations, its statistic.
    fn run(
        &mut self,
        copy: &Copy,
        half: &Half,
        running: Running,
        (table, row, starts): (Option<TableId>, Value, Value),
        (rows, first): (&ByPlace, usize),
        sampled: &Sampled,
    ) -> (Vector, Vec<Value>, Vec<Value>) {
        let none = self.builder.float(0.0);
        let now = self.copy_now(copy, &running.handed, sampled);
        // What was known before the first sample has no weight.
        let now: Vector = now.into_iter().map(|now| Some(self.builder.select(starts, none, now?))).collect();
        let innovations = self.innovations(copy, &now, sampled);
        let mut statistic = running.statistic;
        for (column, (k, o)) in rows.present().into_iter().enumerate() {
            let weight = self.entry(table, row, first + column);
            let product = self.builder.mul(weight, innovations[o]);
            statistic[k] = self.builder.add(statistic[k], product);
        }
        for (cell, value) in half.statistic.iter().zip(&statistic) {
            self.builder.set(*cell, *value);
        }
        for (cell, value) in half.handed.iter().zip(self.hand_over(copy, &now, sampled)) {
            if let (Some(cell), Some(value)) = (cell, value) {
                self.builder.set(*cell, value);
            }
        }
        self.replace(half, running.replaced, starts, sampled);
        (now, innovations, statistic)
    }

    /// Whether the copy's window holds a replaced sample; what was applied before its first one is outside.
    fn replace(&mut self, half: &Half, before: Value, starts: Value, sampled: &Sampled) {
        let one = self.builder.index(1);
        let interval_good = self.builder.or(sampled.interval_good, starts);
        let good = self.builder.and(sampled.newest_good, interval_good);
        let replaced = self.builder.select(good, before, one);
        self.builder.set(half.replaced, replaced);
        // Set for both copies; the one that is used is the last.
        self.replaced = Some(replaced);
    }

    /// One table for all: rows while filling, while used, read-outs, direct shares.
    fn by_age(&mut self, pair: &PingPong) -> Option<TableId> {
        let tables = [&pair.filling, &pair.using, &pair.read, &pair.direct];
        let outputs = |o: usize| self.plant.outputs[o].label.name.clone();
        let states = |i: usize| self.plant.states[i].label.name.clone();
        let docs =
            pair.filling.present().into_iter().map(|(k, o)| format!("filling component {k} from {}", outputs(o)));
        let docs = docs
            .chain(pair.using.present().into_iter().map(|(k, o)| format!("used component {k} from {}", outputs(o))));
        let docs =
            docs.chain(pair.read.present().into_iter().map(|(i, k)| format!("{} from component {k}", states(i))));
        let docs =
            docs.chain(pair.direct.present().into_iter().map(|(i, o)| format!("{} from {}", states(i), outputs(o))));
        let docs: Vec<String> = docs.collect();
        let scalar = self.plant.scalar;
        let row = |age: usize| -> Vec<f64> {
            let entries = tables.iter().flat_map(|table| table.present().into_iter().map(move |(i, j)| (table, i, j)));
            entries.map(|(table, i, j)| table.value(i, j, age, scalar)).collect()
        };
        let rows = (0..pair.steps).map(row).collect();
        let doc = "both copies, by calls since they took turns";
        (!docs.is_empty()).then(|| self.builder.table("AGES", doc, docs, rows))
    }
}
