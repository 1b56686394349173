//! Blocks as operations: the newest one sample by sample, whole ones by their statistics, the oldest one by the
//! weights of the sum.

use crate::program::{CellId, TableId, Value};

use super::super::realize::tables::ByPlace;
use super::super::realize::two_level::{Cut, TwoLevel};
use super::copies::Vector;
use super::{Lowering, Sampled, index};
use crate::program::place;

/// Row and column of entries that are not zero.
type Pairs = Vec<(usize, usize)>;

/// The state of the blocks.
struct Blocks {
    /// Per component: statistics by block.
    statistics: Vec<CellId>,
    /// Per state that a copy drives: what blocks hand on.
    handed: Vec<Option<CellId>>,
    /// Block of the newest sample.
    block: CellId,
    /// Place of the newest sample in its block.
    place: CellId,
    /// Row of the next call's first whole block.
    row: CellId,
}

/// Where the newest sample stands.
struct Newest {
    block: Value,
    place: Value,
    first: Value,
}

impl Lowering<'_> {
    /// The estimate from blocks.
    pub(super) fn two_level(&mut self, two: &TwoLevel, sampled: &Sampled) -> Vec<Value> {
        let blocks = self.blocks(two);
        let newest = self.next_place(two.cut, &blocks);
        let mut terms = self.newest_block(two, &blocks, &newest, sampled);
        for (terms, whole) in terms.iter_mut().zip(self.whole_blocks(two, &blocks, &newest)) {
            terms.push(whole);
        }
        for (terms, oldest) in terms.iter_mut().zip(self.oldest_block(two.cut, &newest, sampled)) {
            terms.push(oldest);
        }
        let constants: Vector = self
            .functional
            .constant
            .clone()
            .into_iter()
            .map(|c| {
                let value = c.value(self.plant.scalar);
                (value != 0.0).then(|| self.builder.float(value))
            })
            .collect();
        terms
            .into_iter()
            .zip(constants)
            .map(|(terms, constant)| self.total(terms.into_iter().chain([constant])))
            .collect()
    }

    fn blocks(&mut self, two: &TwoLevel) -> Blocks {
        let slots = index(two.cut.whole + 1);
        let statistics = (0..two.rows.0.len())
            .map(|k| {
                self.builder.ring(
                    "statistic",
                    &format!("component {k} of the blocks' statistics, by block"),
                    slots,
                    0.0,
                )
            })
            .collect();
        let handed = self.plant.states.iter().zip(&two.copy.live).map(|(state, live)| {
            let name = &state.label.name;
            let doc = format!("{name} as a block's copy hands it on, by block");
            live.then(|| self.builder.ring(&format!("copy_{name}"), &doc, slots, 0.0))
        });
        let handed = handed.collect();
        let block = self.builder.index_cell("block", "block of the newest sample", 0);
        let last = index(two.cut.block - 1);
        let place = self.builder.index_cell("place", "place of the newest sample in its block", last);
        let row = self.builder.index_cell("row", "row of the newest whole block at the next call", 0);
        Blocks { statistics, handed, block, place, row }
    }

    fn next_place(&mut self, cut: Cut, blocks: &Blocks) -> Newest {
        self.builder.section("the newest block");
        let (len, slots) = (index(cut.block), index(cut.whole + 1));
        let before = self.builder.read(blocks.place);
        let place = self.builder.advance(before, len);
        let zero = self.builder.index(0);
        let first = self.builder.index_equal(place, zero);
        let here = self.builder.read(blocks.block);
        let here = self.builder.at_most(here, slots - 1);
        let after = self.builder.advance(here, slots);
        let block = self.builder.select(first, after, here);
        self.builder.set(blocks.place, place);
        self.builder.set(blocks.block, block);
        Newest { block, place, first }
    }

    /// Takes the newest sample into its block; what that block says, term by term for each state.
    fn newest_block(
        &mut self,
        two: &TwoLevel,
        blocks: &Blocks,
        newest: &Newest,
        sampled: &Sampled,
    ) -> Vec<Vec<Option<Value>>> {
        let zero = self.builder.float(0.0);
        let handed: Vector = blocks
            .handed
            .iter()
            .map(|ring| {
                ring.map(|ring| {
                    let before = self.builder.read_ring(ring, newest.block);
                    self.builder.select(newest.first, zero, before)
                })
            })
            .collect();
        let now = self.copy_now(&two.copy, &handed, sampled);
        let innovations = self.innovations(&two.copy, &now, sampled);
        let (table, rows, reads) = self.newest_table(two);
        let mut statistics: Vector = Vec::new();
        for (k, ring) in blocks.statistics.iter().enumerate() {
            let before = self.builder.read_ring(*ring, newest.block);
            let before = self.builder.select(newest.first, zero, before);
            let mut sum = before;
            for (column, (_, o)) in rows.iter().enumerate().filter(|(_, (row, _))| *row == k) {
                let weight = self.entry(table, newest.place, column);
                let product = self.builder.mul(weight, innovations[*o]);
                sum = self.builder.add(sum, product);
            }
            self.builder.set_ring(*ring, newest.block, sum);
            statistics.push(Some(sum));
        }
        let next = self.hand_over(&two.copy, &now, sampled);
        for (ring, value) in blocks.handed.iter().zip(next) {
            if let (Some(ring), Some(value)) = (ring, value) {
                self.builder.set_ring(*ring, newest.block, value);
            }
        }
        let innovations: Vector = innovations.into_iter().map(Some).collect();
        (0..now.len())
            .map(|i| {
                let mut terms = vec![now[i], self.row_times(&two.direct.0[i], &innovations, None)];
                for (column, (_, k)) in reads.iter().enumerate().filter(|(_, (row, _))| *row == i) {
                    let weight = self.entry(table, newest.place, rows.len() + column);
                    terms.push(statistics[*k].map(|statistic| self.builder.mul(weight, statistic)));
                }
                terms
            })
            .collect()
    }

    /// Rows of the statistics, then read-outs, by place in the block.
    fn newest_table(&mut self, two: &TwoLevel) -> (Option<TableId>, Pairs, Pairs) {
        let (rows, reads) = (two.rows.present(), two.read.present());
        let docs = rows.iter().map(|(k, o)| format!("component {k} from {}", self.plant.outputs[*o].label.name));
        let docs =
            docs.chain(reads.iter().map(|(i, k)| format!("{} from component {k}", self.plant.states[*i].label.name)));
        let scalar = self.plant.scalar;
        let row = |at: usize| -> Vec<f64> {
            let entries = rows.iter().map(|(k, o)| two.rows.value(*k, *o, at, scalar));
            entries.chain(reads.iter().map(|(i, k)| two.read.value(*i, *k, at, scalar))).collect()
        };
        let values = (0..two.cut.block).map(row).collect();
        let doc = "the newest block, by place of its newest sample";
        let table = (rows.len() + reads.len() > 0).then(|| self.builder.table("BLOCK", doc, docs.collect(), values));
        (table, rows, reads)
    }

    /// What whole blocks say, per state.
    fn whole_blocks(&mut self, two: &TwoLevel, blocks: &Blocks, newest: &Newest) -> Vec<Option<Value>> {
        let Cut { block, whole, .. } = two.cut;
        let (slots, rows) = (index(whole + 1), index(whole * block));
        let (reads, passes) = (two.read.present(), two.handed.present());
        if reads.is_empty() && passes.is_empty() {
            return vec![None; two.copy.live.len()];
        }
        let table = self.whole_table(two, &reads, &passes);
        let counted = (1..=whole).map(|q| vec![f64::from(index(q))]).collect();
        let counted = self.builder.table(
            "BLOCKS",
            "a row for each whole block",
            vec!["its number, newest first".into()],
            counted,
        );
        self.builder.section("whole blocks, newest first");
        let row = self.builder.read(blocks.row);
        let row = self.builder.at_most(row, rows - 1);
        let slot = self.builder.retreat(newest.block, slots);
        let states: Vec<usize> =
            (0..two.copy.live.len()).filter(|i| reads.iter().chain(&passes).any(|(state, _)| state == i)).collect();
        let mut starts = vec![self.builder.float(0.0); states.len()];
        starts.extend([slot, row]);
        let after = self.builder.loop_over(counted, &starts, |b, carried| {
            let (slot, row) = (carried[states.len()], carried[states.len() + 1]);
            let mut next = Vec::new();
            for (state, sum) in states.iter().zip(carried) {
                let mut sum = *sum;
                for (column, (i, from)) in reads.iter().chain(&passes).enumerate().filter(|(_, (i, _))| i == state) {
                    let ring = if column < reads.len() { Some(blocks.statistics[*from]) } else { blocks.handed[*from] };
                    let Some(ring) = ring else { unreachable!("state {i} takes only what is handed on") };
                    let (value, weight) = (b.read_ring(ring, slot), b.lookup(table, row, place(column)));
                    let product = b.mul(weight, value);
                    sum = b.add(sum, product);
                }
                next.push(sum);
            }
            next.extend([b.retreat(slot, slots), b.advance(row, rows)]);
            next
        });
        self.builder.set(blocks.row, after[states.len() + 1]);
        let mut sums = vec![None; two.copy.live.len()];
        states.iter().zip(&after).for_each(|(state, sum)| sums[*state] = Some(*sum));
        sums
    }

    /// Read-outs of whole blocks: for each place of the newest sample a row for each block.
    fn whole_table(&mut self, two: &TwoLevel, reads: &[(usize, usize)], passes: &[(usize, usize)]) -> TableId {
        let Cut { block, whole, .. } = two.cut;
        let name = |i: usize| &self.plant.states[i].label.name;
        let docs = reads.iter().map(|(i, k)| format!("{} from component {k}", name(*i)));
        let docs = docs.chain(passes.iter().map(|(i, j)| format!("{} from copy_{}", name(*i), name(*j))));
        let entry = |table: &ByPlace, entries: &[(usize, usize)], at: usize| -> Vec<f64> {
            entries.iter().map(|(i, j)| table.value(*i, *j, at, self.plant.scalar)).collect()
        };
        let row = |at: usize, q: usize| {
            [entry(&two.read, reads, at + q * block), entry(&two.handed, passes, at + (q - 1) * block)].concat()
        };
        let values = (0..block).flat_map(|at| (1..=whole).map(move |q| (at, q))).map(|(at, q)| row(at, q)).collect();
        let doc = "whole blocks, by place of the newest sample and then by block, newest first";
        self.builder.table("WHOLE", doc, docs.collect(), values)
    }

    /// What is left of the oldest block says, per state, oldest sample first.
    fn oldest_block(&mut self, cut: Cut, newest: &Newest, sampled: &Sampled) -> Vec<Option<Value>> {
        let functional = self.functional;
        let weights: Vec<_> = functional.outputs.iter().chain(&functional.knowns).collect();
        let kept: Vec<_> = self.sensors.outputs.iter().chain(&self.sensors.values).copied().collect();
        let names = self.plant.outputs.iter().map(|o| &o.label.name).chain(functional.signals.iter().map(|s| &s.text));
        let names: Vec<String> = names.cloned().collect();
        let n = self.plant.states.len();
        let pairs: Vec<(usize, usize)> = (0..weights.len())
            .flat_map(|s| (0..n).map(move |i| (i, s)))
            .filter(|(i, s)| weights[*s].columns[*i].is_some())
            .collect();
        if pairs.is_empty() {
            return vec![None; n];
        }
        let docs =
            pairs.iter().map(|(i, s)| format!("{} from {}", self.plant.states[*i].label.name, names[*s])).collect();
        let ages = (functional.steps + 1 - cut.tail..=functional.steps).rev();
        let rows = ages
            .map(|age| pairs.iter().map(|(i, s)| weights[*s].at(*i, age).value(self.plant.scalar)).collect())
            .collect();
        let table = self.builder.table("OLDEST", "weights by age, from the window's oldest sample", docs, rows);
        self.builder.section("the oldest block, oldest sample first; a sample that a whole block holds counts nothing");
        let len = self.window();
        let states: Vec<usize> = (0..n).filter(|i| pairs.iter().any(|(state, _)| state == i)).collect();
        let mut starts = vec![self.builder.float(0.0); states.len()];
        let oldest = self.builder.advance(sampled.newest, len);
        let left = self.builder.index(index(cut.tail - 1));
        starts.extend([oldest, left]);
        let after = self.builder.loop_over(table, &starts, |b, carried| {
            let (slot, left) = (carried[states.len()], carried[states.len() + 1]);
            let mut sums: Vec<Value> = carried[..states.len()].to_vec();
            let held = b.index_less(left, newest.place);
            let zero = b.float(0.0);
            for (column, (i, s)) in pairs.iter().enumerate() {
                let sample = kept[*s].read(b, slot);
                let counted = b.select(held, zero, sample);
                let weight = b.gain(place(column));
                let product = b.mul(weight, counted);
                let Some(at) = states.iter().position(|state| state == i) else { continue };
                sums[at] = b.add(sums[at], product);
            }
            sums.extend([b.advance(slot, len), b.count_down(left)]);
            sums
        });
        let mut sums = vec![None; n];
        states.iter().zip(&after).for_each(|(state, sum)| sums[*state] = Some(*sum));
        sums
    }
}
