//! A start from a given state: the first copy is carried from it by the model and the samples, and gives the estimate,
//! until the first reset does.
//!
//! The given state is of the call before the first. At the first good sample the copies start, z1 at what it has become,
//! so that both have the same error and a reset takes it away as ever.

use crate::estimator::copies::known::Run as Between;
use crate::program::{CellId, Value};
use crate::sampled::Source;
use crate::step::given;
use crate::step::injections::{Injections, Moment, Samples};

use super::count::Counted;
use super::{Copies, Lowering, Sampled};

/// The first copy's run from a given state.
#[derive(Clone, Copy)]
pub(super) struct Run {
    /// Whether it is what is known of the state.
    pub(super) active: Value,
    /// Whether the caller vouched for it.
    vouched: Value,
}

impl Lowering<'_> {
    /// Whether something is known of the state: by convergence, or from a given one.
    pub(super) fn or_given(&mut self, converged: Value) -> Value {
        let Some(cell) = self.cells.given else { return converged };
        let (running, none) = (self.builder.read(cell), self.builder.index(0));
        let given = self.builder.index_less(none, running);
        self.builder.or(converged, given)
    }

    /// Whether the run goes on; keeps that for the next call.
    pub(super) fn runs_given(&mut self, sampled: &Sampled, copies: &Copies, counted: &Counted) -> Option<Run> {
        let cell = self.cells.given?;
        let b = &mut self.builder;
        let (running, none, one) = (b.read(cell), b.index(0), b.index(1));
        let mut active = b.index_less(none, running);
        for over in [sampled.lost, copies.wild, counted.converged] {
            let goes_on = b.not(over);
            active = b.and(active, goes_on);
        }
        for (value, limit) in copies.carried.iter().zip(&self.bounds.limits) {
            let sane = b.in_range(*value, -limit, *limit);
            active = b.and(active, sane);
        }
        let vouched = b.index_less(one, running);
        let vouched = b.and(active, vouched);
        let kept = b.select(active, running, none);
        b.set(cell, kept);
        Some(Run { active, vouched })
    }

    /// What the counts say of the estimate, or the caller.
    pub(super) fn with_given(&mut self, counted: Counted, run: Option<Run>) -> Counted {
        let Some(run) = run else { return counted };
        let known = self.builder.or(counted.known, run.active);
        let converged = self.builder.or(counted.converged, run.vouched);
        Counted { converged, known, ..counted }
    }

    /// Values of a known by age. An input that runs straight is taken to have been what it is at the first call, before
    /// which nothing is known of it.
    pub(super) fn known_by_age(&mut self, s: usize, now: Value, kept: &[CellId]) -> Vec<Value> {
        let mut values = self.by_age(now, kept);
        let known = &self.design.knowns[s];
        if self.cells.given.is_some() && matches!((known.source, known.run), (Source::Input(_), Between::Straight)) {
            let (calls, none) = (self.builder.read(self.cells.calls), self.builder.index(0));
            let first = self.builder.index_equal(calls, none);
            for value in &mut values[1..] {
                *value = self.builder.select(first, now, *value);
            }
        }
        values
    }

    /// Writes the start from a given state, where there is one.
    pub(super) fn init_at(&mut self) {
        let Some(running) = self.cells.given else { return };
        let Self { plant, design, bounds, builder, cells, .. } = self;
        let (plant, bound) = (*plant, bounds.guard.bound);
        builder.init_at(|b| {
            b.section("the given state");
            let (state, vouched) = given::state(b, plant, bound);
            for ((cell, place), limit) in cells.first.iter().zip(&design.rest).zip(&bounds.limits) {
                let (sane, zero) = (b.in_range(state[*place], -limit, *limit), b.float(0.0));
                let value = b.select(sane, state[*place], zero);
                b.set(*cell, value);
            }
            let (one, two) = (b.index(1), b.index(2));
            let trusted = b.select(vouched, two, one);
            b.set(running, trusted);
            b.section("what it shows, and what that makes of the nonlinear terms");
            let mut outputs = Vec::new();
            for ((o, range), kept) in bounds.guard.outputs.iter().enumerate().zip(&cells.outputs) {
                let shown = given::shown(b, plant, &state, o, *range);
                for cell in kept {
                    b.set(*cell, shown);
                }
                outputs.push(shown);
            }
            let zeros = plant.inputs.iter().map(|_| b.float(0.0)).collect();
            let injections = Injections::new(plant, cells.calls, zeros);
            for (known, kept) in design.knowns.iter().zip(&cells.knowns) {
                let Source::Injection(k) = known.source else { continue };
                if known.jumps || known.run == Between::Held {
                    continue;
                }
                let value = injections.evaluate(b, k, &Moment::Given, Samples::These(&outputs));
                let (sane, zero) = (b.in_range(value, -bound, bound), b.float(0.0));
                let value = b.select(sane, value, zero);
                for cell in kept {
                    b.set(*cell, value);
                }
            }
        });
    }
}
