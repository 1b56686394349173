//! A regression as a Program.
//!
//! One step: samples, predictions and rings as for every window method; two loops over the window, oldest
//! sample first, the second over what the first left; then the equations of the unknowns and the state.
//! The operations are the same in every call. Where the signals do not excite the unknowns, they keep
//! their last good values.

mod gather;
mod given;
mod responses;
mod solve;

use crate::diagnostic::Diagnostic;
use crate::estimator::window::lower::predict::Unknowns;
use crate::estimator::window::lower::{Lowering, Sampled, Standing, guard, late_len};
use crate::plant::Plant;
use crate::program::{CellId, Program, Value};
use crate::promise::Certificate;
use crate::sampled::settled::round;
use crate::sampled::weights::push_products;
use crate::step::injections;

use super::Regression;
use super::bound::{check, growth};
use gather::{Gathered, gather};
use responses::{Running, Window};

/// Lowers a regression for its plant; constants that the target's floats cannot hold are reported.
pub fn lower(plant: &Plant, regression: &Regression, promised: &Certificate) -> Result<Program, Vec<Diagnostic>> {
    check(plant, regression)?;
    let guard = guard::bound(plant, &regression.carrier, growth(plant, regression))?;
    injections::check(plant)?;
    let mut step = Step::new(Lowering::new(plant, &regression.carrier, guard), regression);
    step.declare_given(promised);
    step.write();
    step.init_at();
    Ok(step.lowering.builder.finish())
}

struct Step<'a> {
    lowering: Lowering<'a>,
    regression: &'a Regression,
    /// Calls in a row since which the unknowns are known.
    found: CellId,
    /// The unknowns' last good values.
    values: Vec<CellId>,
    /// Per late output: slot of its oldest sample of the window.
    late: Vec<Option<CellId>>,
}

impl<'a> Step<'a> {
    fn new(mut lowering: Lowering<'a>, regression: &'a Regression) -> Self {
        let plant = lowering.plant;
        let b = &mut lowering.builder;
        let found = b.index_cell("found", "calls in a row since which the unknowns are known", 0);
        let values: Vec<CellId> = regression
            .unknowns
            .iter()
            .map(|j| {
                let name = &plant.states[*j].label.name;
                b.float_cell(&format!("found_{name}"), &format!("the last good {name}, scaled"), 0.0)
            })
            .collect();
        let late = (0..plant.outputs.len())
            .map(|o| {
                let name = &plant.outputs[o].label.name;
                let doc = format!("slot of the oldest {name} that the window uses");
                let delay = late_len(&regression.carrier, o);
                (delay > 0).then(|| b.index_cell(&format!("oldest_{name}"), &doc, delay))
            })
            .collect();
        let unknowns =
            Unknowns { found, values: values.clone(), held: regression.held.clone(), end: regression.end.clone() };
        lowering.unknowns = Some(unknowns);
        Self { lowering, regression, found, values, late }
    }

    fn write(&mut self) {
        let sampled = self.lowering.sample();
        let (_, count) = self.lowering.count(&sampled);
        self.lowering.run_given(&sampled);
        self.lowering.store(&sampled);
        let start = self.start(&sampled);
        let window = Window::new(&mut self.lowering, self.regression);
        let gathered = gather(&window, &mut self.lowering.builder, &start);
        self.lowering.builder.section("the unknowns, where the signals excite them");
        let (values, determined) = self.solve(&gathered);
        let full = self.lowering.counted(count, self.lowering.window());
        let good = self.lowering.builder.and(full, determined);
        let known = self.known(full, good);
        let values = self.keep(&values, good);
        self.lowering.builder.section("the estimate; until the unknowns have been found, the start");
        let estimate = self.estimate(&gathered, &values);
        let estimate = self.off_the_newest(estimate, &gathered);
        self.lowering.look_ahead(&estimate, &sampled);
        let estimate = self.lowering.at_the_newest(&estimate, &sampled);
        self.lowering.end_given(known);
        let standing = Standing { known, determined: good, renewed: None };
        self.lowering.report(&estimate, &sampled, &standing);
    }

    /// At the window's first sample: where the oldest samples stand, and responses of zero.
    fn start(&mut self, sampled: &Sampled) -> Running {
        let len = self.lowering.window();
        let b = &mut self.lowering.builder;
        b.section("the responses over the window, oldest sample first");
        let slot = b.advance(sampled.newest, len);
        let late = self
            .late
            .iter()
            .map(|cell| {
                let cell = (*cell)?;
                let before = b.read(cell);
                let before = b.at_most(before, len - 1);
                let slot = b.advance(before, len);
                b.set(cell, slot);
                Some(slot)
            })
            .collect();
        let known = vec![b.float(0.0); self.regression.own];
        let gammas = vec![known.clone(); self.regression.gammas.len()];
        let moved = self.lowering.plant.outputs.iter().map(|output| output.wrap.as_ref().map(|_| b.float(0.0)));
        let moved = moved.collect();
        Running { slot, late, moved, known, gammas }
    }

    /// Calls for which it is kept that the unknowns are known.
    fn longest(&self) -> u32 {
        (0..self.late.len()).map(|o| late_len(&self.regression.carrier, o)).max().unwrap_or(0).max(1)
    }

    /// Whether the unknowns are known: found now, or once since the window is full.
    fn known(&mut self, full: Value, good: Value) -> Value {
        let longest = self.longest();
        let given = self.lowering.runs_given();
        let before = self.lowering.builder.read(self.found);
        let once = self.lowering.counted(before, 1);
        let b = &mut self.lowering.builder;
        let either = b.or(good, once);
        let known = b.and(full, either);
        let (more, none) = (b.count_up(before, longest), b.index(0));
        // A given state brings its unknowns along.
        let kept = given.map_or(none, |given| b.select(given, before, none));
        let found = b.select(known, more, kept);
        b.set(self.found, found);
        known
    }

    /// The new values where they are good, else the last good ones.
    fn keep(&mut self, values: &[Value], good: Value) -> Vec<Value> {
        let b = &mut self.lowering.builder;
        let keep = |(cell, value): (&CellId, &Value)| {
            let last = b.read(*cell);
            let kept = b.select(good, *value, last);
            b.set(*cell, kept);
            kept
        };
        self.values.iter().zip(values).map(keep).collect()
    }

    /// An estimate off the window's first samples of outputs that wrap, as one off their newest.
    fn off_the_newest(&mut self, mut estimate: Vec<Value>, gathered: &Gathered) -> Vec<Value> {
        let plant = self.lowering.plant;
        let b = &mut self.lowering.builder;
        for (output, moved) in plant.outputs.iter().zip(&gathered.moved) {
            let (Some(wrap), Some(moved)) = (&output.wrap, moved) else { continue };
            for (value, direction) in estimate.iter_mut().zip(&wrap.direction).filter(|(_, s)| !s.is_zero()) {
                let direction = b.float(round(direction, plant.scalar));
                let along = b.mul(direction, *moved);
                *value = b.sub(*value, along);
            }
        }
        estimate
    }

    /// `x = Phi^N R^-1 (d - sum eps c) + r + sum eps p`, and the unknowns, by place in the plant.
    fn estimate(&mut self, gathered: &Gathered, values: &[Value]) -> Vec<Value> {
        let regression = self.regression;
        let mut coordinates = Vec::new();
        for (k, d) in gathered.known.shares.iter().enumerate() {
            let b = &mut self.lowering.builder;
            let taken: Vec<Value> =
                gathered.gammas.iter().zip(values).map(|(gamma, value)| b.mul(*value, gamma.shares[k])).collect();
            let taken = b.sum(&taken);
            coordinates.push(b.sub(*d, taken));
        }
        let mut estimate = vec![None; self.lowering.plant.states.len()];
        for (a, place) in regression.states.iter().enumerate() {
            let mut terms: Vec<Value> = gathered.known.state.get(a).copied().into_iter().collect();
            push_products(&mut self.lowering.builder, &mut terms, &regression.through[a], &coordinates);
            for (gamma, value) in gathered.gammas.iter().zip(values) {
                let moved = gamma.state.get(a).map(|p| self.lowering.builder.mul(*value, *p));
                terms.extend(moved);
            }
            estimate[*place] = Some(self.lowering.builder.sum(&terms));
        }
        for ((place, scale), value) in regression.unknowns.iter().zip(&regression.scales).zip(values) {
            let scale = self.lowering.builder.float(*scale);
            estimate[*place] = Some(self.lowering.builder.mul(scale, *value));
        }
        estimate.into_iter().flatten().collect()
    }
}
