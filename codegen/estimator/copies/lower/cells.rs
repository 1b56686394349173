//! The state of the impulsive observer, and its names.

use crate::plant::Plant;
use crate::program::CellId;
use crate::program::builder::Builder;
use crate::promise::vouched::Trust;
use crate::sampled::Source;
use crate::sampled::settled::round;
use crate::step::cells::{bracketed, identifier};
use crate::step::given::Running;
use crate::step::guard::Guard;
use crate::step::kept::Kept;
use crate::step::known::Term;
use crate::step::sensors::{Sensors, counters};
use crate::step::{gate, injections, inputs};

use super::super::Impulsive;
use super::super::known::{Known, Run};

/// The cells of the copies; those that nothing reads are left out of the Program.
pub(super) struct Cells {
    /// z1.
    pub(super) first: Vec<CellId>,
    /// z2.
    pub(super) second: Vec<CellId>,
    /// Calls since the start or the last reset.
    pub(super) phase: CellId,
    /// Good calls since the start, up to convergence.
    pub(super) count: CellId,
    /// Good calls in a row, up to a period.
    pub(super) clean: CellId,
    /// 1 from a bad call until a period was good.
    pub(super) coasting: CellId,
    /// Calls since the last measured one.
    pub(super) turn: CellId,
    /// 1 from a given state until convergence, 2 if it was vouched for; where there is such a start.
    pub(super) given: Option<Running>,
}

/// A number of calls as an index.
pub(super) fn length(calls: usize) -> u32 {
    u32::try_from(calls).unwrap_or_else(|_| unreachable!("periods are bounded"))
}

/// The count at which the observer has converged.
pub(super) fn full_count(design: &Impulsive) -> u32 {
    length(design.calls.converged + 1)
}

/// Calls of a period that is good from its first sample to its reset.
pub(super) fn period_count(design: &Impulsive) -> u32 {
    length(design.calls.warm_up + design.calls.period + 1)
}

/// Good calls after which nothing is left of what stood in for samples: between measurements errors are carried on, and
/// die out as those at the start do.
pub(super) fn clean_count(design: &Impulsive) -> u32 {
    if design.calls.every > 1 { full_count(design) } else { period_count(design) }
}

pub(super) fn declare<'a>(
    builder: &mut Builder,
    plant: &'a Plant,
    design: &Impulsive,
    (guard, trust): (Guard, Option<Trust>),
) -> (Cells, Sensors<'a>) {
    let mut first = Vec::new();
    let mut second = Vec::new();
    for place in &design.rest {
        let state = &plant.states[*place];
        let (name, unit) = (&state.label.name, bracketed(&state.label.unit));
        let initial = round(&state.initial, plant.scalar);
        let initial = if initial.is_finite() { initial } else { 0.0 };
        first.push(builder.float_cell(&format!("z1_{name}"), &format!("the first copy: {name}{unit}"), initial));
        second.push(builder.float_cell(
            &format!("z2_{name}"),
            &format!("the second copy: {name} + L y{unit}"),
            initial,
        ));
    }
    let counters = counters(builder, plant);
    let mut kept = |name: &str, text: &str, unit: &str, init: f64| {
        let ago = ["a call", "2 calls", "3 calls"];
        let mut calls = 0;
        Kept::Ages(ago.map(|ago| {
            calls += 1;
            builder.float_cell(&format!("{name}_{calls}"), &format!("{text} {ago} ago{unit}"), init)
        }))
    };
    let outputs = plant.outputs.iter().enumerate().map(|(o, output)| {
        let (name, unit) = (&output.label.name, bracketed(&output.label.unit));
        kept(name, name, &unit, injections::initial_output(plant, o, plant.scalar))
    });
    let outputs = outputs.collect();
    let values = design.knowns.iter().map(|known| kept(&identifier(&known.text), &known.text, "", 0.0)).collect();
    let inputs = inputs::cells(builder, plant);
    let phase = builder.index_cell("phase", "calls since the start or the last reset", 0);
    let most = full_count(design);
    let count =
        builder.index_cell("count", &format!("calls since the start, at most {most}; 0 while waiting for it"), 0);
    let clean = builder.index_cell("clean", &format!("good calls in a row, at most {}", clean_count(design)), 0);
    let coasting = builder.index_cell("coasting", "1 from a bad call until a whole period was good", 0);
    let several = if plant.outputs.len() > 1 { plant.outputs.as_slice() } else { &[] };
    let missed = several.iter().map(|output| {
        let name = &output.label.name;
        let doc = format!("calls without {name} in a row, at most a period");
        (builder.index_cell(&format!("missed_{name}"), &doc, 0), period_count(design))
    });
    let missed = missed.collect();
    let turn = builder.index_cell("turn", "calls since the last one that is measured", 0);
    let calls = builder.index_cell("calls", "calls since init", 0);
    let given = trust.map(|trust| Running::declare(builder, "from a given state until convergence", trust));
    let coasted = plant.coasted.then(|| builder.index_cell("since", "calls since a sample was accepted", 0));
    let terms = design.knowns.iter().map(|known| term(plant, known)).collect();
    let rejected = gate::cells(builder, plant);
    let patience = period_count(design);
    let sensors = Sensors {
        plant,
        guard,
        terms,
        newest: None,
        counters,
        outputs,
        values,
        inputs,
        calls,
        missed,
        rejected,
        patience,
        coasted,
    };
    (Cells { first, second, phase, count, clean, coasting, turn, given }, sensors)
}

/// What is known, as a reading has it.
fn term(plant: &Plant, known: &Known) -> Term {
    Term {
        source: known.source,
        ago: length(known.ago),
        needs_samples: known.needs_samples(plant),
        of_sample: !known.jumps && known.run != Run::Held,
        ramps: matches!((known.source, known.run), (Source::Input(_), Run::Straight)),
    }
}
