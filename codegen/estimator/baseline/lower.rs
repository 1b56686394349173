//! A baseline as a Program.
//!
//! One step: look at the sample, compute the formula with what is kept of those before, and say how much of what it
//! needs is there. All of it is branch-free. A missing sample changes nothing but the time that passes.

mod adaptive_window;
mod low_pass;

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Program, Value};
use crate::sampled::settled::{Settled, round};
use crate::sampled::weights;
use crate::step::ahead::Ahead;
use crate::step::front::counts::Counts;
use crate::step::guard::Guard;
use crate::step::injections::Injections;
use crate::step::report::Moved;
use crate::step::{coasting, front, injections, report};

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
        weights::constant(&mut self.builder, value)
    }

    /// The sample, and whether it is good.
    fn read(&mut self) -> (Value, Value) {
        self.builder.section("the sample: outside its range, infinite or NaN means missing");
        let (b, plant) = (&mut self.builder, self.plant);
        let counter = Counts::declare(b, plant, &plant.outputs[0]);
        let (value, good) = front::read(b, plant, 0, counter, self.guard.outputs[0]);
        if let Some(counter) = counter {
            counter.keep(b, 0, good);
        }
        (value, good)
    }

    /// A difference of samples, or the signal itself, within half a turn where it wraps.
    fn folded(&mut self, value: Value) -> Value {
        front::folded(&mut self.builder, &self.plant.outputs[0], value, self.plant.scalar)
    }

    /// The signal and its rate, whether they are known, and whether by the newest sample; `good` says whether there was
    /// one.
    fn report(&mut self, estimate: [Value; 2], (known, renewed): (Value, Value), good: Value) {
        let moved = self.ahead.map(|ahead| {
            let calls = self.builder.index_cell("calls", "calls since init", 0);
            Moved { ahead, injections: Injections::new(self.plant, calls, Vec::new()), outputs: &[] }
        });
        report::estimates(&mut self.builder, self.plant, estimate.to_vec(), moved, "");
        if self.plant.coasted {
            let cell = self.builder.index_cell("coasted", "calls since the newest accepted sample", 0);
            let coasted = coasting::count(&mut self.builder, cell, &[good]);
            report::coasted(&mut self.builder, coasted);
        }
        report::status(&mut self.builder, known, renewed);
    }
}

/// A number of calls as a Program has it.
fn calls(count: usize) -> u32 {
    u32::try_from(count).unwrap_or_else(|_| unreachable!("the calls of a design are bounded"))
}
