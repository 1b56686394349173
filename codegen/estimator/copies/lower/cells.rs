//! The state of the impulsive observer, and its names.

use crate::plant::Plant;
use crate::program::CellId;
use crate::program::builder::Builder;
use crate::sampled::settled::round;
use crate::step::cells::{bracketed, identifier};
use crate::step::given::Running;
use crate::step::{injections, inputs};

use super::super::Impulsive;

/// The cells; those that nothing reads are left out of the Program.
pub(super) struct Cells {
    /// z1.
    pub(super) first: Vec<CellId>,
    /// z2.
    pub(super) second: Vec<CellId>,
    /// Per output: its values one, two, three calls ago.
    pub(super) outputs: Vec<Vec<CellId>>,
    /// Per known: its values likewise.
    pub(super) knowns: Vec<Vec<CellId>>,
    /// Per input: the last good value.
    pub(super) inputs: Vec<CellId>,
    /// Calls since the start or the last reset.
    pub(super) phase: CellId,
    /// Good calls since the start, up to convergence.
    pub(super) count: CellId,
    /// Good calls in a row, up to a period.
    pub(super) clean: CellId,
    /// 1 from a bad call until a period was good.
    pub(super) coasting: CellId,
    /// Per output, where there are several: calls missing in a row.
    pub(super) missed: Vec<CellId>,
    /// Calls since the last measured one.
    pub(super) turn: CellId,
    /// Calls since init.
    pub(super) calls: CellId,
    /// 1 from a given state until convergence, 2 if it was vouched for; where there is such a start.
    pub(super) given: Option<Running>,
    /// Calls since the newest accepted sample, where the estimate says so.
    pub(super) coasted: Option<CellId>,
}

/// Values of each signal that are kept; as many as a third-order polynomial needs.
pub(super) const KEPT: usize = 3;

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

pub(super) fn declare(builder: &mut Builder, plant: &Plant, design: &Impulsive) -> Cells {
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
    let mut kept = |name: &str, text: &str, unit: &str, init: f64| -> Vec<CellId> {
        let ago = |calls: usize| if calls == 1 { "a call".to_owned() } else { format!("{calls} calls") };
        (1..=KEPT)
            .map(|calls| {
                builder.float_cell(&format!("{name}_{calls}"), &format!("{text} {} ago{unit}", ago(calls)), init)
            })
            .collect()
    };
    let outputs = plant.outputs.iter().enumerate().map(|(o, output)| {
        let (name, unit) = (&output.label.name, bracketed(&output.label.unit));
        kept(name, name, &unit, injections::initial_output(plant, o, plant.scalar))
    });
    let outputs = outputs.collect();
    let knowns = design.knowns.iter().map(|known| kept(&identifier(&known.text), &known.text, "", 0.0)).collect();
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
        builder.index_cell(&format!("missed_{name}"), &format!("calls without {name} in a row, at most a period"), 0)
    });
    let missed = missed.collect();
    let turn = builder.index_cell("turn", "calls since the last one that is measured", 0);
    let calls = builder.index_cell("calls", "calls since init", 0);
    let doc = "1 from a given state until convergence, 2 if that was vouched for";
    let given = plant.init_at.then(|| Running::declare(builder, doc));
    let coasted = plant.coasted.then(|| builder.index_cell("since", "calls since a sample was accepted", 0));
    Cells { first, second, outputs, knowns, inputs, phase, count, clean, coasting, missed, turn, calls, given, coasted }
}
