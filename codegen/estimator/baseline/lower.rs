//! A baseline as a Program.
//!
//! One step: look at the sample, compute the formula with what is kept of those before, and say how much of what it
//! needs is there. All of it is branch-free. A missing sample changes nothing but the time that passes.

mod adaptive_window;
mod low_pass;

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Program, Status, Value};
use crate::sampled::settled::{Settled, round};
use crate::step::ahead::Ahead;
use crate::step::guard::Guard;
use crate::step::injections::Injections;
use crate::step::report::field;
use crate::step::{front, injections};

use super::{Baseline, Law};

/// Lowers a design for its plant, a chain of two integrators.
///
/// # Errors
/// A range or constant that the target's floats cannot hold.
pub fn lower(plant: &Plant, design: &Baseline, ahead: Option<&Ahead>) -> Result<Program, Vec<Diagnostic>> {
    let guard = Guard::with_gain(plant, design.growth(), 0.0)?;
    injections::check(plant)?;
    let mut builder = Builder::new(&plant.name, plant.scalar, round(&plant.sample_time.0, plant.scalar));
    for output in &plant.outputs {
        builder.measurement(front::measurement(output));
    }
    let mut lowering = Lowering { plant, design, guard, builder, ahead };
    match &design.law {
        Law::LowPass(law) => lowering.low_pass(law),
        Law::AdaptiveWindow(law) => lowering.adaptive_window(law),
    }
    Ok(lowering.builder.finish())
}

struct Lowering<'a> {
    plant: &'a Plant,
    design: &'a Baseline,
    guard: Guard,
    builder: Builder,
    /// How the answer is moved.
    ahead: Option<&'a Ahead>,
}

impl Lowering<'_> {
    fn constant(&mut self, value: Settled) -> Value {
        self.builder.float(value.value(self.plant.scalar))
    }

    /// The sample, and whether it is good.
    fn read(&mut self) -> (Value, Value) {
        self.builder.section("the sample: outside its range, infinite or NaN means missing");
        front::read(&mut self.builder, self.plant, 0, self.guard.outputs[0])
    }

    /// A difference of samples, or the signal itself, within half a turn where it wraps.
    fn folded(&mut self, value: Value) -> Value {
        front::folded(&mut self.builder, &self.plant.outputs[0], value, self.plant.scalar)
    }

    /// The signal and its rate, and what they are worth; `good` says whether there was a sample.
    fn report(&mut self, estimate: [Value; 2], status: Value, good: Value) {
        let mut estimate = estimate.to_vec();
        if let Some(ahead) = self.ahead {
            let calls = self.builder.index_cell("calls", "calls since init", 0);
            let injections = Injections::new(self.plant, calls, Vec::new());
            estimate = ahead.moved(&mut self.builder, self.plant, &estimate, &injections, &[]);
        }
        for (state, value) in self.plant.states.iter().zip(estimate) {
            self.builder.estimate(field(&state.label.name, &state.label.unit, &state.label.doc), value);
        }
        if self.plant.coasted {
            self.coasted(good);
        }
        self.builder.report(status);
    }

    /// The calls since the newest good sample, as an answer.
    fn coasted(&mut self, good: Value) {
        let b = &mut self.builder;
        let doc = "calls since the newest accepted sample";
        let cell = b.index_cell("coasted", doc, 0);
        let none = b.index(0);
        let before = b.read(cell);
        let more = b.count_up(before, u32::MAX);
        let coasted = b.select(good, none, more);
        b.set(cell, coasted);
        b.estimate(field("coasted", "", doc), coasted);
    }

    /// Converging until it is known; then coasting, unless it is renewed.
    fn status(&mut self, known: Value, renewed: Value) -> Value {
        let [converged, coasting, converging] =
            [Status::Converged, Status::Coasting, Status::Converging].map(|status| self.builder.status(status));
        let working = self.builder.select(renewed, converged, coasting);
        self.builder.select(known, working, converging)
    }
}

/// A number of calls as a Program has it.
fn calls(count: usize) -> u32 {
    u32::try_from(count).unwrap_or_else(|_| unreachable!("the calls of a design are bounded"))
}
