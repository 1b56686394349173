//! A start from a given state: the first copy is carried from it by the model and the samples, and gives the estimate,
//! until the first reset does.
//!
//! The given state is of the call before the first. At the first good sample the copies start, z1 at what it has become,
//! so that both have the same error and a reset takes it away as ever.

use crate::estimator::copies::known::Run as Between;
use crate::program::{CellId, Value};
use crate::sampled::Source;
use crate::step::given;

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
        let given = cell.active(&mut self.builder);
        self.builder.or(converged, given)
    }

    /// Whether the run goes on; keeps that for the next call.
    pub(super) fn runs_given(&mut self, sampled: &Sampled, copies: &Copies, counted: &Counted) -> Option<Run> {
        let cell = self.cells.given?;
        let b = &mut self.builder;
        let mut active = cell.active(b);
        for over in [sampled.lost, copies.wild, counted.converged] {
            let goes_on = b.not(over);
            active = b.and(active, goes_on);
        }
        for (value, limit) in copies.carried.iter().zip(&self.bounds.limits) {
            let sane = b.in_range(*value, -limit, *limit);
            active = b.and(active, sane);
        }
        let vouched = cell.vouched(b);
        let vouched = b.and(active, vouched);
        cell.keep(b, active);
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
            for value in &mut values[1..] {
                *value = given::begun(&mut self.builder, self.cells.calls, now, *value);
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
                let value = given::within(b, state[*place], *limit);
                b.set(*cell, value);
            }
            running.begin(b, vouched);
            b.section("what it shows, and what that makes of the nonlinear terms");
            let mut outputs = Vec::new();
            for ((o, range), kept) in bounds.guard.outputs.iter().enumerate().zip(&cells.outputs) {
                let shown = given::shown(b, plant, &state, o, *range);
                for cell in kept {
                    b.set(*cell, shown);
                }
                outputs.push(shown);
            }
            let terms = given::terms(b, plant, cells.calls);
            for (known, kept) in design.knowns.iter().zip(&cells.knowns) {
                let Source::Injection(k) = known.source else { continue };
                if known.jumps || known.run == Between::Held {
                    continue;
                }
                let value = given::term(b, &terms, k, &outputs, bound);
                for cell in kept {
                    b.set(*cell, value);
                }
            }
        });
    }
}
