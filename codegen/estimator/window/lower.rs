//! A window functional as a Program.
//!
//! One step: look at the samples, predict those that are missing, evaluate the injections, store
//! everything in rings by slot, sum over the window, and keep what the next prediction needs. All
//! of it is branch-free, so that the worst case is every case.
//!
//! No input makes the state non-finite: a sample enters a ring only if it is within `Guard`'s
//! bound, chosen such that no sum over the window and no prediction can overflow.

pub(crate) mod cells;
mod copies;
mod count;
pub(crate) mod given;
pub(crate) mod guard;
mod irregular;
pub(crate) mod normal;
mod ping_pong;
pub(crate) mod predict;
mod recursive;
pub(crate) mod report;
pub(crate) mod sample;
mod sums;
mod there;
mod two_level;
mod windows;

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{Program, Value};
use crate::promise::Certificate;
use crate::sampled::carry::Carry;
use crate::sampled::settled::{Settled, round};
use crate::step::ahead::Ahead;

use super::{Functional, Way};
use crate::sampled::weights::constant;
use crate::step::guard::Guard;
use crate::step::injections;
use crate::step::reading::Reading;
use crate::step::sensors::{self, Sensors};
use cells::Cells;
use count::settled;
use given::Given;
use guard::Growth;
use predict::Unknowns;
pub(crate) use report::Standing;
use sums::Anchor;
use there::There;

/// Lowers a functional for its plant; constants that the target's floats cannot hold are reported.
pub fn lower(
    plant: &Plant,
    functional: &Functional,
    ahead: Option<&Ahead>,
    promised: &Certificate,
) -> Result<Program, Vec<Diagnostic>> {
    let carry = plant.init_at.then(|| Carry::new(plant, &functional.signals)).transpose()?;
    let linear = carry.as_ref().map_or(0.0, Carry::gain);
    let guard = guard::bound(plant, functional, Growth { linear, ..Growth::default() })?;
    injections::check(plant)?;
    let mut lowering = Lowering::new(plant, functional, guard);
    lowering.ahead = ahead;
    lowering.given = carry.map(|carry| {
        let taken = given::taken(plant, functional);
        let trust = given::trust(plant, functional, (&carry, &taken), promised);
        Given::declare(&mut lowering.builder, plant, (carry, taken), trust)
    });
    lowering.step();
    lowering.init_at(|_, _| {});
    Ok(lowering.builder.finish())
}

/// What a call brought, and what it is worth to the window.
pub(crate) struct Sampled<'a> {
    pub(crate) reading: Reading<'a>,
    /// Slot of age 0.
    pub(crate) newest: Value,
    /// Whether everything sampled now was good.
    samples_good: Value,
    /// Whether everything since the last call was good.
    interval_good: Value,
    /// Whether what was sampled now and is of now was good.
    newest_good: Value,
    /// Late outputs, and whether they were good.
    late: Vec<(usize, Value)>,
    /// Where the estimate is of the samples that are there: where they stand.
    there: There,
}

/// A step being written.
pub(crate) struct Lowering<'a> {
    pub(crate) plant: &'a Plant,
    functional: &'a Functional,
    pub(crate) builder: Builder,
    pub(crate) cells: Cells,
    pub(crate) sensors: Sensors<'a>,
    /// Unknown constants that the step finds by a regression of its own.
    pub(crate) unknowns: Option<Unknowns>,
    /// Whether the window holds a replaced sample, where copies keep that themselves: 1 or 0.
    replaced: Option<Value>,
    /// How the answer is moved.
    ahead: Option<&'a Ahead>,
    /// What is kept of a given state, where the observer can start from one.
    pub(crate) given: Option<Given>,
}

impl<'a> Lowering<'a> {
    /// Declares the interface and the cells.
    pub(crate) fn new(plant: &'a Plant, functional: &'a Functional, guard: Guard) -> Self {
        let mut builder = Builder::new(&plant.name, plant.scalar, round(&plant.sample_time.0, plant.scalar));
        let (cells, sensors) = cells::declare(&mut builder, plant, functional, guard);
        sensors::declare(&mut builder, plant);
        Self { plant, functional, builder, cells, sensors, unknowns: None, replaced: None, ahead: None, given: None }
    }

    /// A constant of the design.
    pub(crate) fn constant(&mut self, value: Settled) -> Value {
        constant(&mut self.builder, value)
    }

    fn step(&mut self) {
        let sampled = if self.functional.irregular.is_some() { self.sample_what_is_there() } else { self.sample() };
        let (before, count) = self.count(&sampled);
        self.run_given(&sampled);
        self.store(&sampled);
        if let Some(irregular) = &self.functional.irregular {
            let full = self.counted(count, self.window());
            let answer = self.irregular(irregular, &sampled, full);
            self.builder.section("the estimate; until there is one, the start");
            let (known, renewed) = (answer.usable, Some(answer.close));
            self.end_given(known);
            self.report(&answer.estimate, &sampled, &Standing { known, determined: known, renewed });
            return;
        }
        // Of outputs that wrap, less their newest sample.
        let estimate = self.estimate(&sampled, before, count);
        if !self.functional.longer.is_empty() {
            self.windows(&estimate, &sampled, count);
            return;
        }
        self.look_ahead(&estimate, &sampled);
        self.builder.section("the estimate; until the window is full, the start");
        let estimate = self.at_the_newest(&estimate, &sampled);
        let known = self.counted(count, self.window());
        let determined = self.counted(count, settled(self.functional));
        self.end_given(determined);
        self.report(&estimate, &sampled, &Standing { known, determined, renewed: None });
    }

    /// The estimate of each state, by the functional's way.
    fn estimate(&mut self, sampled: &Sampled, before: Value, count: Value) -> Vec<Value> {
        match &self.functional.way {
            Way::Fir => {
                self.builder.section("the sums over the window, newest sample first");
                self.summed(self.functional, sampled)
            }
            Way::TwoLevel(two) => self.two_level(two, sampled),
            Way::PingPong(pair) => self.ping_pong(pair, sampled, count),
            Way::Recursive(recursive) => self.recursive(recursive, sampled, before, count),
        }
    }

    /// The estimate of each state by one sum over a window.
    fn summed(&mut self, functional: &Functional, sampled: &Sampled) -> Vec<Value> {
        let kept = (self.sensors.outputs.as_slice(), self.sensors.values.as_slice());
        let newest =
            sampled.reading.outputs.iter().zip(&sampled.reading.counts).map(|(value, count)| count.unwrap_or(*value));
        let anchors: Vec<Option<Anchor>> = (self.plant.outputs.iter().zip(newest))
            .map(|(output, newest)| {
                let turn = round(&output.wrap.as_ref()?.turn, self.plant.scalar);
                Some(Anchor { newest, turn })
            })
            .collect();
        let place = (sampled.newest, kept_len(self.functional));
        sums::estimate(&mut self.builder, self.plant, functional, kept, &anchors, place)
    }

    /// The estimate from its sums: with the newest samples of outputs that wrap, each in the direction of its turn.
    pub(crate) fn at_the_newest(&mut self, estimate: &[Value], sampled: &Sampled) -> Vec<Value> {
        let mut moved = estimate.to_vec();
        for (output, newest) in self.plant.outputs.iter().zip(&sampled.reading.outputs) {
            let Some(wrap) = &output.wrap else { continue };
            for (value, direction) in moved.iter_mut().zip(&wrap.direction).filter(|(_, s)| !s.is_zero()) {
                let direction = self.builder.float(round(direction, self.plant.scalar));
                *value = self.add_product(*value, direction, *newest);
            }
        }
        moved
    }

    /// Whether this call's samples are the first of a window.
    fn fresh(&mut self, count: Value) -> Value {
        let two = self.builder.index(2);
        self.builder.index_less(count, two)
    }

    /// N+1, of the shortest window.
    pub(crate) fn window(&self) -> u32 {
        window_len(self.functional)
    }

    /// Samples that the rings hold.
    fn kept(&self) -> u32 {
        kept_len(self.functional)
    }

    fn add_product(&mut self, sum: Value, weight: Value, value: Value) -> Value {
        let product = self.builder.mul(weight, value);
        self.builder.add(sum, product)
    }

    /// Writes what was sampled into the rings.
    pub(crate) fn store(&mut self, sampled: &Sampled) {
        self.builder.section("into the window");
        self.builder.set(self.cells.newest, sampled.newest);
        let reading = &sampled.reading;
        let kept = self.sensors.outputs.iter().zip(&reading.outputs).zip(&reading.counts);
        for (o, ((kept, value), count)) in kept.enumerate() {
            let slot = sampled.there.slots.get(o).copied().unwrap_or(sampled.newest);
            kept.write(&mut self.builder, Some(slot), count.unwrap_or(*value));
            if slot != sampled.newest && self.plant.outputs[o].wrap.is_some() {
                // Until the sample of now comes, nothing has moved.
                kept.write(&mut self.builder, Some(sampled.newest), *value);
            }
        }
        let present = self.cells.memory.as_ref().map(|memory| memory.present.as_slice()).unwrap_or_default();
        for ((ring, value), slot) in present.iter().zip(&sampled.there.present).zip(&sampled.there.slots) {
            if *slot != sampled.newest {
                // The sample of now comes later.
                let none = self.builder.float(0.0);
                self.builder.set_ring(*ring, sampled.newest, none);
            }
            self.builder.set_ring(*ring, *slot, *value);
        }
        let ages = self.cells.memory.as_ref().map(|memory| memory.ages.as_slice()).unwrap_or_default();
        for (ring, age) in ages.iter().zip(&sampled.there.ages) {
            if let (Some(ring), Some(age)) = (ring, age) {
                self.builder.set_ring(*ring, sampled.newest, *age);
            }
        }
        for (kept, value) in self.sensors.values.iter().zip(&reading.signals) {
            kept.write(&mut self.builder, Some(sampled.newest), *value);
        }
        self.sensors.count_call(&mut self.builder);
    }
}

/// N+1.
pub(crate) fn window_len(functional: &Functional) -> u32 {
    u32::try_from(functional.steps + 1).unwrap_or_else(|_| unreachable!("the window's length is bounded"))
}

/// Samples that the rings hold: N+1 of the longest window.
pub(crate) fn kept_len(functional: &Functional) -> u32 {
    index(functional.longest() + 1)
}

/// Calls until samples determine the estimate of the longest window, if none is lost.
pub(crate) fn longest_calls(functional: &Functional) -> usize {
    count::longest_count(functional) as usize
}

/// Samples that a late output's predictions wait for.
pub(crate) fn late_len(functional: &Functional, output: usize) -> u32 {
    u32::try_from(functional.delays[output]).unwrap_or_else(|_| unreachable!("delays are bounded"))
}

/// A number of calls.
fn bounded(calls: usize) -> u32 {
    u32::try_from(calls).unwrap_or(u32::MAX)
}

/// A count of samples, rows or blocks as a Program has it.
fn index(count: usize) -> u32 {
    u32::try_from(count).unwrap_or_else(|_| unreachable!("the window's length is bounded"))
}
