//! The estimate from the samples that are there: one pass over the window, then a small solve.
//!
//! The pass goes from the oldest row to the newest. It carries what is known to have moved the state since the
//! window's start, so that what a sample shows beyond that is the start's doing; rows without a sample count nothing.
//! Where too few samples determine the state, the model's prediction from the last estimate stands in; where those that
//! do are worth little, for some windows at most. [`Worth`](super::super::irregular::Worth) has the limits.

mod pass;

use crate::program::{CellId, Scalar, Value};
use crate::step::front;

use super::super::irregular::Irregular;
use super::normal::solve;
use super::{Lowering, Sampled};
use crate::sampled::settled::round;
use crate::sampled::weights::{constant, row};
pub(super) use pass::acted;
use pass::{Carried, Pass, column, predicted, shift};

/// What the solve keeps from call to call.
pub(super) struct Memory {
    /// Per output: 1 for a sample, 0 for none; by slot.
    pub(super) present: Vec<CellId>,
    /// Per state: the model's prediction, as far as it is known.
    pub(super) next: Vec<CellId>,
    /// Whether that prediction comes from an estimate.
    pub(super) known: CellId,
    /// Per late output: the slot of the time that its newest sample shows.
    pub(super) late: Vec<Option<CellId>>,
    /// Calls with samples since these gave an estimate that is better than the model's prediction.
    pub(super) poor: CellId,
    /// Calls since a sample was accepted.
    pub(super) coasted: CellId,
    /// Per output whose samples come with their ages: those, over the oldest; by slot.
    pub(super) ages: Vec<Option<CellId>>,
}

/// An estimate that not every call can renew.
pub(super) struct Irregularly {
    /// Per state.
    pub(super) estimate: Vec<Value>,
    /// Whether it is of the samples, and they are worth what is promised.
    pub(super) close: Value,
    /// Whether it is one.
    pub(super) usable: Value,
}

/// What the samples of a call say.
struct Judged {
    /// Per state.
    solved: Vec<Value>,
    /// Whether they determine it.
    sound: Value,
    /// Whether that is better than the model's prediction.
    good: Value,
    /// Whether its error is as promised.
    close: Value,
    /// Whether there is any.
    some: Value,
}

/// Calls with samples that are worth less than a prediction, until they are taken: a window that runs dry, one that fills
/// again, and one more, for regular samples to come to their worth.
pub(super) fn patience(window: u32) -> u32 {
    window.saturating_mul(3)
}

/// Below this, what elimination leaves of a diagonal has lost digits to the floats' range.
fn smallest_pivot(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32 => f64::from(f32::MIN_POSITIVE / f32::EPSILON),
        Scalar::F64 => f64::MIN_POSITIVE / f64::EPSILON,
    }
}

impl Lowering<'_> {
    /// The state as the model predicts it, with the signals of this call.
    pub(super) fn predicted_state(&mut self, signals: &[Value]) -> Vec<Value> {
        let Some(irregular) = &self.functional.irregular else { return Vec::new() };
        let next = self.memory().next.clone();
        let b = &mut self.builder;
        next.iter().enumerate().map(|(i, next)| predicted(b, irregular, *next, i, signals)).collect()
    }

    /// What an output shows of a state.
    pub(super) fn shown(&mut self, output: usize, state: &[Value]) -> Value {
        let Some(irregular) = &self.functional.irregular else { unreachable!("asked for by the solve") };
        row(&mut self.builder, &irregular.c[output], state)
    }

    /// The estimate, and whether it comes from samples, or at least from the model.
    pub(super) fn irregular(&mut self, irregular: &Irregular, sampled: &Sampled, full: Value) -> Irregularly {
        let (outputs, signals) = (self.sensors.outputs.clone(), self.sensors.values.clone());
        let memory = self.cells.memory.take().unwrap_or_else(|| unreachable!("declared with the solve"));
        let (scalar, len) = (self.plant.scalar, self.window());
        let plant = self.plant;
        let (present, ages) = (memory.present.as_slice(), memory.ages.as_slice());
        let pass = Pass { irregular, plant, scalar, len, outputs: &outputs, signals: &signals, present, ages };
        let passed = self.pass(&pass, sampled.newest);
        let mut judged = self.judged(irregular, &passed);
        let b = &mut self.builder;
        for (solved, response) in judged.solved.iter_mut().zip(&passed.response) {
            *solved = b.add(*solved, *response);
        }
        for ((o, wrap), moved) in pass.turning().zip(&passed.moved) {
            // Where the window's oldest slot was, seen from the newest sample.
            let newest = outputs[o].read(b, sampled.newest);
            let from = b.sub(newest, *moved);
            shift(b, scalar, wrap, &mut judged.solved, from);
        }
        let answer = self.fall_back(&pass, &memory, sampled, judged, full);
        self.cells.memory = Some(memory);
        answer
    }

    /// What the normal equations say of the state now, beside the known response, and what that is worth.
    fn judged(&mut self, irregular: &Irregular, passed: &Carried) -> Judged {
        let (scalar, worth) = (self.plant.scalar, &irregular.worth);
        let constant = |x: f64| self.plant.scalar_value(x);
        let b = &mut self.builder;
        b.section("the state from the samples that are there, and its variance");
        let asked = irregular.through.iter().zip(&worth.unit);
        let asked: Vec<Vec<Option<f64>>> = asked
            .map(|(row, unit)| row.iter().map(|entry| Some(entry.as_ref()?.value(scalar) / unit)).collect())
            .collect();
        let limits = (constant(worth.tolerance), smallest_pivot(scalar));
        let answers = solve(b, (&passed.normal, &passed.right), &asked, limits);
        let mut solved = Vec::new();
        for (value, unit) in answers.values.into_iter().zip(&worth.unit) {
            let unit = b.float(*unit);
            solved.push(b.mul(unit, value));
        }
        b.section("what it is worth");
        let mut worst = b.float(0.0);
        for ((variance, scale), unit) in answers.variances.into_iter().zip(&worth.scale).zip(&worth.unit) {
            let Some(scale) = scale else { continue };
            let share = b.float(constant(unit * unit / scale));
            let share = b.mul(variance, share);
            worst = b.maximum(worst, share);
        }
        let [usual, most, per_sample, fixed, one] =
            [worth.usual, worth.most, worth.per_sample, worth.fixed, 1.0].map(|x| b.float(constant(x)));
        let within = b.less_equal(worst, most);
        let sound = b.and(answers.sound, within);
        let good = b.less_equal(worst, usual);
        let good = b.and(sound, good);
        let samples = b.mul(per_sample, passed.count);
        let samples = b.add(samples, fixed);
        let bound = b.mul(worst, samples);
        let close = b.less_equal(bound, one);
        let close = b.and(good, close);
        let none = b.float(0.0);
        let some = b.less(none, passed.count);
        Judged { solved, sound, good, close, some }
    }

    /// The model's prediction where too few samples came; and what the next call needs for that.
    fn fall_back(
        &mut self,
        pass: &Pass,
        memory: &Memory,
        sampled: &Sampled,
        Judged { solved, sound, good, close, some }: Judged,
        full: Value,
    ) -> Irregularly {
        let (irregular, bound, b) = (pass.irregular, self.sensors.guard.bound, &mut self.builder);
        b.section("without enough samples, the model's prediction");
        let (none, one, zero) = (b.index(0), b.index(1), b.float(0.0));
        let known = b.read(memory.known);
        let mut usable = b.index_equal(known, one);
        let mut estimate = Vec::new();
        let mut turned: Option<Vec<Value>> = None;
        for (o, wrap) in pass.turning() {
            let n = solved.len();
            let mut state = turned.take().unwrap_or_else(|| {
                (0..n).map(|i| predicted(b, irregular, memory.next[i], i, &sampled.reading.signals)).collect()
            });
            let turn = round(&wrap.turn, pass.scalar);
            let shown = row(b, &irregular.c[o], &state);
            let turns = front::turns(b, shown, turn);
            let back = b.float(-turn);
            let back = b.mul(turns, back);
            shift(b, pass.scalar, wrap, &mut state, back);
            turned = Some(state);
        }
        let predicted: Vec<Value> = match turned {
            Some(state) => state,
            None => (0..solved.len())
                .map(|i| predicted(b, irregular, memory.next[i], i, &sampled.reading.signals))
                .collect(),
        };
        for predicted in &predicted {
            let sane = b.in_range(*predicted, -bound, bound);
            usable = b.and(usable, sane);
        }
        // A poor estimate is one where there is no other, and no prediction is trusted longer than this against samples;
        // without any it is the plant's own model, which may go on.
        let before = b.read(memory.poor);
        let more = b.count_up(before, patience(pass.len));
        let more = b.select(some, more, before);
        let poor = b.select(good, none, more);
        b.set(memory.poor, poor);
        let trusted = b.index(patience(pass.len));
        let trusted = b.index_less(poor, trusted);
        let trusted = b.and(trusted, usable);
        let longer = b.not(trusted);
        let better = b.or(good, longer);
        let enough = b.and(sound, better);
        for (solved, predicted) in solved.into_iter().zip(predicted) {
            estimate.push(b.select(enough, solved, predicted));
        }
        let any = b.or(enough, usable);
        let usable = b.and(full, any);
        let keep = b.select(usable, one, none);
        b.set(memory.known, keep);
        for (i, cell) in memory.next.iter().enumerate() {
            let kept = row(b, &irregular.phi[i], &estimate);
            let begun = column(b, &irregular.begin, i, &sampled.reading.signals);
            let constant = irregular.constant[i].map(|entry| constant(b, entry));
            let terms: Vec<Value> = [Some(kept), begun, constant].into_iter().flatten().collect();
            let sum = b.sum(&terms);
            let sane = b.in_range(sum, -bound, bound);
            let next = b.select(sane, sum, zero);
            b.set(*cell, next);
        }
        Irregularly { estimate, close, usable }
    }
}
