//! A baseline as a Program.
//!
//! One step: look at the sample, compute the formula with what is kept of those before, and say how much of what it
//! needs is there. All of it is branch-free. A missing sample changes nothing but the time that passes.

mod adaptive_window;
mod low_pass;

use crate::design::Settled;
use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Program, Status, Value};
use crate::window::lower::guard::Guard;
use crate::window::lower::{field, injections};

use super::{Baseline, Law};

/// Lowers a design for its plant, a chain of two integrators.
///
/// # Errors
/// A range or constant that the target's floats cannot hold.
pub fn lower(plant: &Plant, design: &Baseline) -> Result<Program, Vec<Diagnostic>> {
    let guard = Guard::with_gain(plant, design.growth(), 0.0)?;
    injections::check(plant)?;
    let mut builder = Builder::new(&plant.name, plant.scalar, injections::round(&plant.sample_time.0, plant.scalar));
    for output in &plant.outputs {
        builder.measurement(field(&output.label.name, &output.label.unit, &output.label.doc));
    }
    let mut lowering = Lowering { plant, design, guard, builder };
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
}

impl Lowering<'_> {
    fn constant(&mut self, value: Settled) -> Value {
        self.builder.float(value.value(self.plant.scalar))
    }

    /// The sample, and whether it is good.
    fn read(&mut self) -> (Value, Value) {
        self.builder.section("the sample: outside its range, infinite or NaN means missing");
        let value = self.builder.read_measurement(0);
        let (low, high) = self.guard.outputs[0];
        (value, self.builder.in_range(value, low, high))
    }

    /// The signal and its rate, and what they are worth.
    fn report(&mut self, estimate: [Value; 2], status: Value) {
        for (state, value) in self.plant.states.iter().zip(estimate) {
            self.builder.estimate(field(&state.label.name, &state.label.unit, &state.label.doc), value);
        }
        self.builder.report(status);
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
