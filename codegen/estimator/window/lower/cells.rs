//! The state of a window method, and its names.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value};
use crate::step::cells::{bracketed, identifier};
use crate::step::front::counts::Counts;

use super::super::Functional;
use super::count::longest_count;
use super::irregular::Memory;
use super::{kept_len, late_len};
use crate::step::{gate, injections, inputs};

/// What is kept of a sampled signal.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kept {
    /// The window, by slot.
    Window(CellId),
    /// The window of a counter, by slot, as it counts.
    Counts(CellId, Counts),
    /// The newest value alone.
    Newest(CellId),
}

impl Kept {
    /// The window's ring; only a step that keeps nothing but the newest value has none.
    pub(crate) fn ring(self) -> CellId {
        match self {
            Self::Window(ring) => ring,
            Self::Counts(..) | Self::Newest(_) => unreachable!("asked for by steps that keep the window as floats"),
        }
    }

    /// The value that stands at a slot; the newest one where no others are kept.
    pub(super) fn read(self, b: &mut Builder, slot: Value) -> Value {
        match self {
            Self::Window(ring) => b.read_ring(ring, slot),
            Self::Counts(ring, counts) => {
                let count = b.read_ring(ring, slot);
                counts.place(b, count)
            }
            Self::Newest(cell) => b.read(cell),
        }
    }

    /// The count that stands at a slot, with its counter.
    pub(super) fn count(self, b: &mut Builder, slot: Value) -> Option<(Value, Counts)> {
        let Self::Counts(ring, counts) = self else { return None };
        Some((b.read_ring(ring, slot), counts))
    }

    /// Keeps a value, of a counter as the nearest count.
    pub(super) fn put(self, b: &mut Builder, slot: Value, value: Value) {
        match self {
            Self::Counts(_, counts) => {
                let none = b.index(0);
                let count = counts.further(b, none, value);
                self.write(b, slot, count);
            }
            Self::Window(_) | Self::Newest(_) => self.write(b, slot, value),
        }
    }

    /// Keeps a value that becomes the newest; of a counter, its count.
    pub(super) fn write(self, b: &mut Builder, slot: Value, value: Value) {
        match self {
            Self::Window(ring) | Self::Counts(ring, _) => b.set_ring(ring, slot, value),
            Self::Newest(cell) => b.set(cell, value),
        }
    }
}

/// The cells of a window method.
pub(crate) struct Cells {
    /// Per output: samples.
    pub(crate) outputs: Vec<Kept>,
    /// Per signal: values.
    pub(crate) signals: Vec<Kept>,
    /// Per input: the last good value, where no ring holds it.
    pub(super) inputs: Vec<CellId>,
    /// Slot of age 0.
    pub(super) newest: CellId,
    /// Good samples in a row; from N+1 on predicted ones too.
    pub(super) count: CellId,
    /// Per output, where there are several: samples missing in a row.
    pub(super) missed: Vec<CellId>,
    /// Per output with a gate: samples not believed in a row.
    pub(super) rejected: Vec<Option<CellId>>,
    /// Per output, where measurements come at irregular times: calls since the newest.
    pub(super) gaps: Vec<CellId>,
    /// Calls until no replaced sample is in the window.
    pub(super) coasting: CellId,
    /// Per output: the next measurement, as far as it is known; by slot for a late one.
    pub(super) ahead: Vec<CellId>,
    /// Per late output: slot in the ring above.
    pub(super) late: Vec<Option<CellId>>,
    /// Calls since init.
    pub(super) calls: CellId,
    /// Calls since a sample was accepted, where they are asked for.
    pub(super) coasted: Option<CellId>,
    /// Of an estimate from the samples that are there.
    pub(super) memory: Option<Memory>,
}

/// Declares the cells; those that nothing reads are left out of the Program.
pub(super) fn declare(builder: &mut Builder, plant: &Plant, functional: &Functional) -> Cells {
    let window = kept_len(functional);
    let scalar = plant.scalar;
    let stores = functional.way.stores_window();
    let outputs = plant.outputs.iter().enumerate().map(|(o, output)| {
        let (name, unit) = (&output.label.name, bracketed(&output.label.unit));
        let initial = injections::initial_output(plant, o, scalar);
        let counts = Counts::of(plant, output).filter(|_| stores && functional.irregular.is_none());
        if let Some(counts) = counts {
            let ring = builder.counts(name, &format!("counts of {name} by slot"), window, counts.bits, 0);
            Kept::Counts(ring, counts)
        } else if stores {
            Kept::Window(builder.ring(name, &format!("samples of {name} by slot{unit}"), window, initial))
        } else {
            Kept::Newest(builder.float_cell(name, &format!("the newest sample of {name}{unit}"), initial))
        }
    });
    let outputs = outputs.collect();
    let signals = functional.signals.iter().map(|signal| {
        let (name, text) = (identifier(&signal.text), &signal.text);
        if stores {
            Kept::Window(builder.ring(&name, &format!("{text} by slot"), window, 0.0))
        } else {
            Kept::Newest(builder.float_cell(&name, &format!("the newest {text}"), 0.0))
        }
    });
    let signals = signals.collect();
    let inputs = inputs::cells(builder, plant);
    let newest = builder.index_cell("newest", "slot of age 0", window - 1);
    let most = longest_count(functional);
    let count =
        builder.index_cell("count", &format!("good samples in a row, then predicted ones too, at most {most}"), 0);
    let several = if plant.outputs.len() > 1 { plant.outputs.as_slice() } else { &[] };
    let missed = several.iter().map(|output| {
        let name = &output.label.name;
        builder.index_cell(
            &format!("missed_{name}"),
            &format!("samples of {name} missing in a row, at most a window"),
            0,
        )
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
    let coasted = plant.coasted && functional.irregular.is_none();
    let coasted = coasted.then(|| builder.index_cell("since", "calls since a sample was accepted", 0));
    let memory = functional.irregular.as_ref().map(|_| memory(builder, plant, functional));
    Cells {
        outputs,
        signals,
        inputs,
        newest,
        count,
        missed,
        rejected,
        gaps,
        coasting,
        ahead,
        late,
        calls,
        coasted,
        memory,
    }
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
    let coasted = builder.index_cell("since", "calls since a sample was accepted", 0);
    let ages = plant.outputs.iter().map(|output| {
        let name = &output.label.name;
        let (cell, doc) = (format!("age_{name}"), format!("ages of these over the oldest, of {name} by slot"));
        output.aged.as_ref().map(|_| builder.ring(&cell, &doc, window, 0.0))
    });
    let ages = ages.collect();
    Memory { present, next, known, late, coasted, ages }
}
