//! The state of a window method, and its names.

use crate::plant::Plant;
use crate::program::CellId;
use crate::program::builder::Builder;
use crate::step::cells::{bracketed, identifier};
use crate::step::guard::Guard;
use crate::step::kept::Kept;
use crate::step::known::Term;
use crate::step::sensors::{Sensors, counters};

use super::super::Functional;
use super::count::longest_count;
use super::irregular::{Memory, patience};
use super::{kept_len, late_len, window_len};
use crate::step::{gate, injections, inputs};

/// The cells of a window method.
pub(crate) struct Cells {
    /// Slot of age 0.
    pub(super) newest: CellId,
    /// Good samples in a row; from N+1 on predicted ones too.
    pub(super) count: CellId,
    /// Per output, where measurements come at irregular times: calls since the newest.
    pub(super) gaps: Vec<CellId>,
    /// Calls until no replaced sample is in the window.
    pub(super) coasting: CellId,
    /// Per output: the next measurement, as far as it is known; by slot for a late one.
    pub(super) ahead: Vec<CellId>,
    /// Per late output: slot in the ring above.
    pub(super) late: Vec<Option<CellId>>,
    /// Of an estimate from the samples that are there.
    pub(super) memory: Option<Memory>,
}

/// Declares the cells; those that nothing reads are left out of the Program.
pub(super) fn declare<'a>(
    builder: &mut Builder,
    plant: &'a Plant,
    functional: &Functional,
    guard: Guard,
) -> (Cells, Sensors<'a>) {
    let window = kept_len(functional);
    let scalar = plant.scalar;
    let stores = functional.way.stores_window();
    let counters = counters(builder, plant);
    let outputs = plant.outputs.iter().enumerate().map(|(o, output)| {
        let (name, unit) = (&output.label.name, bracketed(&output.label.unit));
        let initial = injections::initial_output(plant, o, scalar);
        if let Some(counts) = counters[o].filter(|_| stores && functional.irregular.is_none()) {
            let ring = builder.counts(name, &format!("counts of {name} by slot"), window, counts.bits, 0);
            Kept::Counts(ring, counts)
        } else if stores {
            Kept::Window(builder.ring(name, &format!("samples of {name} by slot{unit}"), window, initial))
        } else {
            Kept::Newest(builder.float_cell(name, &format!("the newest sample of {name}{unit}"), initial))
        }
    });
    let outputs = outputs.collect();
    let values = functional.signals.iter().map(|signal| {
        let (name, text) = (identifier(&signal.text), &signal.text);
        if stores {
            Kept::Window(builder.ring(&name, &format!("{text} by slot"), window, 0.0))
        } else {
            Kept::Newest(builder.float_cell(&name, &format!("the newest {text}"), 0.0))
        }
    });
    let values = values.collect();
    let inputs = inputs::cells(builder, plant);
    let newest = builder.index_cell("newest", "slot of age 0", window - 1);
    let most = longest_count(functional);
    let count =
        builder.index_cell("count", &format!("good samples in a row, then predicted ones too, at most {most}"), 0);
    let several = if plant.outputs.len() > 1 { plant.outputs.as_slice() } else { &[] };
    let missed = several.iter().enumerate().map(|(o, output)| {
        let name = &output.label.name;
        let doc = format!("samples of {name} missing in a row, at most a window");
        let cell = builder.index_cell(&format!("missed_{name}"), &doc, 0);
        (cell, if functional.irregular.is_some() { window } else { window - late_len(functional, o) })
    });
    let missed = missed.collect();
    let rejected = gate::cells(builder, plant);
    let irregular = if functional.gaps.is_some() { plant.outputs.as_slice() } else { &[] };
    let gaps = irregular.iter().map(|output| {
        let name = &output.label.name;
        builder.index_cell(&format!("since_{name}"), &format!("calls since the newest sample of {name}"), 0)
    });
    let gaps = gaps.collect();
    let coasting = builder.index_cell("coasting", "calls until no replaced sample is in the window", 0);
    let mut ahead = Vec::new();
    let mut late = Vec::new();
    for (o, output) in plant.outputs.iter().enumerate() {
        let name = &output.label.name;
        if functional.delays[o] == 0 {
            ahead.push(builder.float_cell(
                &format!("ahead_{name}"),
                &format!("the next {name}, as far as it is known"),
                0.0,
            ));
            late.push(None);
        } else {
            let len = late_len(functional, o);
            ahead.push(builder.ring(&format!("ahead_{name}"), &format!("{name} as it will arrive, by slot"), len, 0.0));
            late.push(Some(builder.index_cell(&format!("ahead_{name}_slot"), "slot of the oldest of these", 0)));
        }
    }
    let calls = builder.index_cell("calls", "calls since init", 0);
    // Where samples are left out, the solve keeps this.
    let irregular = functional.irregular.is_some();
    let since = (plant.coasted && !irregular).then(|| since(builder));
    let memory = irregular.then(|| memory(builder, plant, functional));
    let coasted = memory.as_ref().map(|memory| memory.coasted).filter(|_| plant.coasted).or(since);
    let terms = functional.signals.iter().map(Term::from).collect();
    let patience = window_len(functional) - 1;
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
    (Cells { newest, count, gaps, coasting, ahead, late, memory }, sensors)
}

fn since(builder: &mut Builder) -> CellId {
    builder.index_cell("since", "calls since a sample was accepted", 0)
}

fn memory(builder: &mut Builder, plant: &Plant, functional: &Functional) -> Memory {
    let window = kept_len(functional);
    let present = plant.outputs.iter().map(|output| {
        let name = &output.label.name;
        builder.ring(&format!("has_{name}"), &format!("1 where there is a sample of {name}, by slot"), window, 0.0)
    });
    let present = present.collect();
    let next = plant.states.iter().map(|state| {
        let name = &state.label.name;
        builder.float_cell(&format!("next_{name}"), &format!("{name} as the model predicts it, as far as known"), 0.0)
    });
    let next = next.collect();
    let known = builder.index_cell("known", "whether that comes from an estimate", 0);
    let late = plant.outputs.iter().enumerate().map(|(o, output)| {
        let delay = late_len(functional, o);
        let (name, doc) = (format!("slot_{}", output.label.name), "slot of the time that the newest sample shows");
        (delay > 0).then(|| builder.index_cell(&name, doc, window - 1 - delay))
    });
    let late = late.collect();
    let doc = "calls with samples since these were worth more than a prediction";
    let poor = builder.index_cell("poor", doc, patience(window));
    let coasted = since(builder);
    let ages = plant.outputs.iter().map(|output| {
        let name = &output.label.name;
        let (cell, doc) = (format!("age_{name}"), format!("ages of these over the oldest, of {name} by slot"));
        output.aged.as_ref().map(|_| builder.ring(&cell, &doc, window, 0.0))
    });
    let ages = ages.collect();
    Memory { present, next, known, late, poor, coasted, ages }
}
