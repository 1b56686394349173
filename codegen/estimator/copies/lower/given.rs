//! A start from a given state: the first copy is carried from it by the model and the samples, and gives the estimate,
//! until the first reset does.
//!
//! The given state is of the call before the first. At the first good sample the copies start, z1 at what it has become,
//! so that both have the same error and a reset takes it away as ever.

mod error;

use crate::program::Value;
use crate::step::given;
use crate::step::reading::Reading;

use super::count::Counted;
use super::{Copies, Lowering};
pub(super) use error::trust;

/// The first copy's run from a given state.
#[derive(Clone, Copy)]
pub(super) struct Run {
    /// Whether it is what is known of the state.
    pub(super) active: Value,
    /// Whether the caller vouched for it.
    vouched: Value,
    /// Whether the bound holds of it.
    promised: Value,
}

impl Lowering<'_> {
    /// Whether something is known of the state: by convergence, or from a given one.
    pub(super) fn or_given(&mut self, converged: Value) -> Value {
        let Some(cell) = self.cells.given else { return converged };
        let given = cell.active(&mut self.builder);
        self.builder.or(converged, given)
    }

    /// Whether the run goes on; keeps that for the next call.
    pub(super) fn runs_given(&mut self, reading: &Reading, copies: &Copies, counted: &Counted) -> Option<Run> {
        let cell = self.cells.given?;
        let b = &mut self.builder;
        let mut active = cell.active(b);
        for over in
            [Some(reading.lost), reading.again, Some(copies.wild), Some(counted.converged)].into_iter().flatten()
        {
            let goes_on = b.not(over);
            active = b.and(active, goes_on);
        }
        for (value, limit) in copies.carried.iter().zip(&self.bounds.limits) {
            let sane = b.in_range(*value, -limit, *limit);
            active = b.and(active, sane);
        }
        let vouched = cell.vouched(b);
        let vouched = b.and(active, vouched);
        let promised = cell.promised(b);
        let promised = b.and(active, promised);
        cell.keep(b, active);
        Some(Run { active, vouched, promised })
    }

    /// What the counts say of the estimate, or the caller.
    pub(super) fn with_given(&mut self, counted: Counted, run: Option<Run>) -> Counted {
        let (Some(run), Some(cell)) = (run, self.cells.given) else { return counted };
        let known = self.builder.or(counted.known, run.active);
        let converged = self.builder.or(counted.converged, run.vouched);
        let mut clean = counted.clean;
        if cell.ends() {
            let renewed = self.builder.or(counted.converged, run.promised);
            clean = self.builder.and(renewed, clean);
        }
        Counted { converged, known, clean, ..counted }
    }

    /// Writes the start from a given state, where there is one.
    pub(super) fn init_at(&mut self) {
        let Some(running) = self.cells.given else { return };
        let Self { design, bounds, builder, cells, sensors, .. } = self;
        builder.init_at(|b| {
            b.section("the given state");
            let (state, vouched) = given::state(b, sensors.plant, sensors.guard.bound);
            for ((cell, place), limit) in cells.first.iter().zip(&design.rest).zip(&bounds.limits) {
                let value = given::within(b, state[*place], *limit);
                b.set(*cell, value);
            }
            running.begin(b, vouched);
            given::show(b, sensors, &state, None, |_| false);
        });
    }
}
