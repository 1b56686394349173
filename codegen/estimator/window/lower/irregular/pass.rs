//! One pass over the window: the normal equations of the rows that are there.

use crate::plant::{Plant, Wrap};
use crate::program::builder::Builder;
use crate::program::{CellId, Scalar, Value};
use crate::sampled::settled::Settled;
use crate::sampled::weights::{constant, row, terms};
use crate::step::front;
use crate::step::kept::Kept;

use super::super::super::irregular::{Ages, Irregular, Sparse};
use super::super::Lowering;
use super::super::normal::triangle;
use crate::program::place;
use crate::sampled::settled::round;

/// What one pass carries.
pub(super) struct Carried {
    pub(super) normal: Vec<Value>,
    pub(super) right: Vec<Value>,
    pub(super) response: Vec<Value>,
    /// Per output that wraps: how far it has moved since the oldest slot.
    pub(super) moved: Vec<Value>,
    /// How many samples there are.
    pub(super) count: Value,
    slot: Value,
}

impl Carried {
    fn flat(&self) -> Vec<Value> {
        let all = self.normal.iter().chain(&self.right).chain(&self.response).chain(&self.moved);
        all.copied().chain([self.count, self.slot]).collect()
    }

    fn of(values: &[Value], n: usize) -> Self {
        let pairs = triangle(n).len();
        Self {
            normal: values[..pairs].to_vec(),
            right: values[pairs..pairs + n].to_vec(),
            response: values[pairs + n..pairs + 2 * n].to_vec(),
            moved: values[pairs + 2 * n..values.len() - 2].to_vec(),
            count: values[values.len() - 2],
            slot: values[values.len() - 1],
        }
    }
}

/// One pass over the window.
pub(super) struct Pass<'a> {
    pub(super) irregular: &'a Irregular,
    pub(super) plant: &'a Plant,
    pub(super) scalar: Scalar,
    pub(super) len: u32,
    pub(super) outputs: &'a [Kept],
    pub(super) signals: &'a [Kept],
    pub(super) present: &'a [CellId],
    pub(super) ages: &'a [Option<CellId>],
}

/// Where a row of the window stands: as constants, or in the table.
type Entry<'a> = &'a dyn Fn(&mut Builder, usize, usize) -> Value;

impl Pass<'_> {
    /// From one sample to the next: the known response.
    fn next_interval(&self, b: &mut Builder, carried: Carried) -> Carried {
        let slot = b.advance(carried.slot, self.len);
        let begin: Vec<Value> = self.signals.iter().map(|kept| kept.read(b, carried.slot)).collect();
        let end: Vec<Value> = self.signals.iter().map(|kept| kept.read(b, slot)).collect();
        let response = (0..carried.response.len())
            .map(|i| {
                let kept = row(b, &self.irregular.phi[i], &carried.response);
                let begun = column(b, &self.irregular.begin, i, &begin);
                let ended = column(b, &self.irregular.end, i, &end);
                let constant = self.irregular.constant[i].map(|entry| constant(b, entry));
                let terms: Vec<Value> = [Some(kept), begun, ended, constant].into_iter().flatten().collect();
                b.sum(&terms)
            })
            .collect();
        let before = carried.slot;
        let moved = self.turning().zip(&carried.moved).map(|((o, wrap), moved)| {
            let (from, to) = (self.outputs[o].read(b, before), self.outputs[o].read(b, slot));
            let step = b.sub(to, from);
            let step = front::fold(b, step, round(&wrap.turn, self.scalar));
            b.add(*moved, step)
        });
        let moved = moved.collect();
        Carried { response, moved, slot, ..carried }
    }

    /// The outputs that wrap.
    pub(super) fn turning(&self) -> impl Iterator<Item = (usize, &Wrap)> {
        turning(self.plant)
    }

    /// What an output showed at a slot; of one that wraps, how far it had moved.
    fn sample(&self, b: &mut Builder, carried: &Carried, output: usize) -> Value {
        let moved = self.turning().zip(&carried.moved).find(|((o, _), _)| *o == output);
        moved.map_or_else(|| self.outputs[output].read(b, carried.slot), |(_, moved)| *moved)
    }

    /// What a sample with an age shows of the state at its slot; `None` is zero.
    fn shows(&self, b: &mut Builder, output: usize, slot: Value) -> Option<Vec<Option<Value>>> {
        let (ages, cell) = (self.irregular.ages[output].as_ref()?, self.ages[output]?);
        let age = b.read_ring(cell, slot);
        Some(ages.row.iter().map(|series| power_series(b, self.scalar, series, age)).collect())
    }

    /// The rows of one slot: `rows` by output and direction, `states` by state and direction.
    fn weights(&self, b: &mut Builder, slot: Value, rows: Entry, states: Entry) -> Vec<Vec<Value>> {
        let n = self.irregular.phi.len();
        let one = |b: &mut Builder, o: usize| -> Vec<Value> {
            let Some(shows) = self.shows(b, o, slot) else { return (0..n).map(|j| rows(b, o, j)).collect() };
            let trust = b.float(self.irregular.trust[o].value(self.scalar));
            let shows: Vec<Option<Value>> = shows.into_iter().map(|c| c.map(|c| b.mul(trust, c))).collect();
            (0..n)
                .map(|j| {
                    let mut terms = Vec::new();
                    for (i, c) in shows.iter().enumerate() {
                        if let Some(c) = c {
                            let direction = states(b, i, j);
                            terms.push(b.mul(*c, direction));
                        }
                    }
                    b.sum(&terms)
                })
                .collect()
        };
        (0..self.outputs.len()).map(|o| one(b, o)).collect()
    }

    /// What a sample shows of the known response.
    fn foreseen(&self, b: &mut Builder, output: usize, carried: &Carried) -> Value {
        let Some(shows) = self.shows(b, output, carried.slot) else {
            return row(b, &self.irregular.c[output], &carried.response);
        };
        let terms = shows.into_iter().zip(&carried.response);
        let terms: Vec<Value> = terms.filter_map(|(c, response)| Some(b.mul(c?, *response))).collect();
        b.sum(&terms)
    }

    /// Adds the samples of one slot to the normal equations.
    fn samples(&self, b: &mut Builder, mut carried: Carried, weights: &[Vec<Value>]) -> Carried {
        for (o, row) in weights.iter().enumerate() {
            let present = b.read_ring(self.present[o], carried.slot);
            carried.count = b.add(carried.count, present);
            let sample = self.sample(b, &carried, o);
            let foreseen = self.foreseen(b, o, &carried);
            let shown = b.sub(sample, foreseen);
            let trust = b.float(self.irregular.trust[o].value(self.scalar));
            let shown = b.mul(trust, shown);
            let row: Vec<Value> = row.iter().map(|weight| b.mul(present, *weight)).collect();
            for (normal, (i, j)) in carried.normal.iter_mut().zip(triangle(row.len())) {
                let product = b.mul(row[i], row[j]);
                *normal = b.add(*normal, product);
            }
            for (right, weight) in carried.right.iter_mut().zip(&row) {
                let product = b.mul(*weight, shown);
                *right = b.add(*right, product);
            }
        }
        carried
    }
}

/// A series in a value, by Horner; `None` is zero.
fn power_series(b: &mut Builder, scalar: Scalar, series: &[Option<Settled>], value: Value) -> Option<Value> {
    let mut sum: Option<Value> = None;
    for coefficient in series.iter().rev() {
        sum = sum.map(|sum| b.mul(sum, value));
        if let Some(coefficient) = coefficient {
            let coefficient = b.float(coefficient.value(scalar));
            sum = Some(sum.map_or(coefficient, |sum| b.add(sum, coefficient)));
        }
    }
    sum
}

/// What a sample of an age lacks of what has acted on the plant since then.
pub(in super::super::super::lower) fn acted(
    b: &mut Builder,
    scalar: Scalar,
    ages: &Ages,
    age: Value,
    (before, now): (&[Value], &[Value]),
) -> Option<Value> {
    let mut terms = Vec::new();
    for (effects, values) in [(&ages.now, now), (&ages.before, before)] {
        for (series, value) in effects.iter().zip(values) {
            if let Some(effect) = power_series(b, scalar, series, age) {
                terms.push(b.mul(effect, *value));
            }
        }
    }
    terms.extend(power_series(b, scalar, &ages.constant, age));
    (!terms.is_empty()).then(|| b.sum(&terms))
}

/// The outputs that wrap.
fn turning(plant: &Plant) -> impl Iterator<Item = (usize, &Wrap)> {
    plant.outputs.iter().enumerate().filter_map(|(o, output)| Some((o, output.wrap.as_ref()?)))
}

/// What signals do to a state; `None` where nothing acts.
pub(super) fn column(b: &mut Builder, effects: &Sparse, i: usize, values: &[Value]) -> Option<Value> {
    let terms = terms(b, effects.iter().map(|effect| &effect[i]).zip(values));
    (!terms.is_empty()).then(|| b.sum(&terms))
}

/// Moves a state along the direction of a turn, by so much of the output.
pub(super) fn shift(b: &mut Builder, scalar: Scalar, wrap: &Wrap, state: &mut [Value], by: Value) {
    for (state, weight) in state.iter_mut().zip(&wrap.direction).filter(|(_, weight)| !weight.is_zero()) {
        let weight = b.float(round(weight, scalar));
        let moved = b.mul(weight, by);
        *state = b.add(*state, moved);
    }
}

/// A state as the model predicts it, from the part that the last call knew and the signals of this one.
pub(super) fn predicted(b: &mut Builder, irregular: &Irregular, next: CellId, i: usize, signals: &[Value]) -> Value {
    let begun = b.read(next);
    let ended = column(b, &irregular.end, i, signals);
    ended.map_or(begun, |ended| b.add(begun, ended))
}

impl Lowering<'_> {
    /// Over the rows, oldest first.
    pub(super) fn pass(&mut self, pass: &Pass, newest: Value) -> Carried {
        let (n, scalar, irregular) = (self.plant.states.len(), pass.scalar, pass.irregular);
        let names: Vec<String> = self.plant.outputs.iter().map(|output| output.label.name.clone()).collect();
        let b = &mut self.builder;
        b.section("rows of the window, oldest first; those without a sample count nothing");
        let zero = b.float(0.0);
        let slot = b.advance(newest, pass.len);
        let (normal, moved) = (vec![zero; triangle(n).len()], pass.turning().map(|_| zero).collect());
        let start = Carried { normal, right: vec![zero; n], response: vec![zero; n], moved, count: zero, slot };
        let value = |weight: &Settled| weight.value(scalar);
        let oldest = |rows: &[Vec<Vec<Settled>>], i: usize, j: usize| rows.first().map_or(0.0, |row| value(&row[i][j]));
        let rows = |b: &mut Builder, o: usize, j: usize| b.float(oldest(&irregular.rows, o, j));
        let states = |b: &mut Builder, i: usize, j: usize| b.float(oldest(&irregular.states, i, j));
        let first = pass.weights(b, start.slot, &rows, &states);
        let start = pass.samples(b, start, &first);
        // Samples that come with their ages have their rows from the states' ways.
        let timed: Vec<usize> = (0..names.len()).filter(|o| pass.ages[*o].is_none()).collect();
        let timed_rows = |place: usize| timed.iter().flat_map(move |o| &irregular.rows[place][*o]);
        let ways = |place: usize| irregular.states.get(place).into_iter().flatten().flatten();
        let table = (1..irregular.rows.len()).map(|place| timed_rows(place).chain(ways(place)).map(value).collect());
        let mut columns: Vec<String> =
            timed.iter().flat_map(|o| (1..=n).map(|j| format!("{} in direction {j}", names[*o]))).collect();
        if !irregular.states.is_empty() {
            let states = self.plant.states.iter().map(|state| &state.label.name);
            columns.extend(states.flat_map(|name| (1..=n).map(move |j| format!("state {name} in direction {j}"))));
        }
        let table = b.table("ROWS", "orthonormal rows of the window, oldest first", columns, table.collect());
        let after = b.loop_over(table, &start.flat(), |b, values| {
            let carried = pass.next_interval(b, Carried::of(values, n));
            let column = |o: usize| timed.iter().position(|timed| *timed == o).unwrap_or(0);
            let rows = |b: &mut Builder, o: usize, j: usize| b.gain(place(column(o) * n + j));
            let states = |b: &mut Builder, i: usize, j: usize| b.gain(place((timed.len() + i) * n + j));
            let weights = pass.weights(b, carried.slot, &rows, &states);
            pass.samples(b, carried, &weights).flat()
        });
        Carried::of(&after, n)
    }
}
