//! What both loops over the window do at each sample: responses advance, outputs show them.

use crate::estimator::window::lower::Lowering;
use crate::program::builder::Builder;
use crate::program::{CellId, Scalar, TableId, Value};
use crate::sampled::settled::Settled;

use super::super::{Drive, Entry, Regression};

/// What the loops read.
pub struct Window<'a> {
    pub(super) regression: &'a Regression,
    outputs: Vec<CellId>,
    signals: Vec<CellId>,
    len: u32,
    scalar: Scalar,
    /// o by sample, from the second on.
    pub(super) table: TableId,
}

/// What an iteration hands to the next, besides its sums.
#[derive(Clone)]
pub struct Running {
    /// Slot of this sample's signals, and of outputs without delay.
    pub slot: Value,
    /// Per output: slot of a late one.
    pub late: Vec<Option<Value>>,
    /// r, as many as the plant's own states.
    pub known: Vec<Value>,
    /// p, likewise.
    pub gammas: Vec<Vec<Value>>,
}

/// One sample of one output.
pub struct Shown {
    /// o, n.
    pub columns: Vec<Value>,
    /// y - C r.
    pub measured: Value,
    /// C `p_i`, q.
    pub gammas: Vec<Value>,
}

impl Running {
    /// As a loop carries it.
    pub fn flat(&self) -> Vec<Value> {
        let slots = std::iter::once(self.slot).chain(self.late.iter().copied().flatten());
        slots.chain(self.known.iter().copied()).chain(self.gammas.iter().flatten().copied()).collect()
    }

    /// The same shape with what a loop carries.
    pub fn with(&self, carried: &[Value]) -> Self {
        let mut values = carried.iter().copied();
        let mut next = || values.next().unwrap_or_else(|| unreachable!("a loop carries what it was started with"));
        Self {
            slot: next(),
            late: self.late.iter().map(|slot| slot.map(|_| next())).collect(),
            known: self.known.iter().map(|_| next()).collect(),
            gammas: self.gammas.iter().map(|p| p.iter().map(|_| next()).collect()).collect(),
        }
    }
}

impl<'a> Window<'a> {
    /// Declares the table.
    pub fn new(lowering: &mut Lowering, regression: &'a Regression) -> Self {
        let plant = lowering.plant;
        let (n, steps, delays) = (regression.states.len(), regression.carrier.steps, &regression.carrier.delays);
        let late: Vec<usize> = (0..delays.len()).filter(|o| delays[*o] > 0).collect();
        let name = |o: usize| &plant.outputs[o].label.name;
        let columns = (0..delays.len()).flat_map(|o| (1..=n).map(move |k| format!("column {k} at {}", name(o))));
        let arrived = late.iter().map(|o| format!("1 where {} has arrived", name(*o)));
        let row = |j: usize| -> Vec<f64> {
            let columns = regression.rows[j].iter().flatten().map(|entry| entry.value(plant.scalar));
            let arrived = late.iter().map(|o| if j + delays[*o] <= steps { 1.0 } else { 0.0 });
            columns.chain(arrived).collect()
        };
        let doc = "what the outputs show of the state at the window's start, orthonormal, by sample from the second";
        let rows = (1..=steps).map(row).collect();
        let table = lowering.builder.table("SHOWN", doc, columns.chain(arrived).collect(), rows);
        Self {
            regression,
            outputs: lowering.cells.outputs.iter().map(|kept| kept.ring()).collect(),
            signals: lowering.cells.signals.iter().map(|kept| kept.ring()).collect(),
            len: lowering.window(),
            scalar: plant.scalar,
            table,
        }
    }

    /// n.
    pub fn n(&self) -> usize {
        self.regression.states.len()
    }

    /// q.
    pub fn q(&self) -> usize {
        self.regression.gammas.len()
    }

    /// A constant of the design.
    fn constant(&self, b: &mut Builder, entry: Settled) -> Value {
        b.float(entry.value(self.scalar))
    }

    fn product(&self, b: &mut Builder, entry: Settled, value: Value) -> Value {
        let entry = self.constant(b, entry);
        b.mul(entry, value)
    }

    /// From one sample to the next.
    pub fn advance(&self, b: &mut Builder, before: &Running) -> Running {
        let slot = b.advance(before.slot, self.len);
        let late = before.late.iter().map(|slot| slot.map(|slot| b.advance(slot, self.len))).collect();
        let slots = (before.slot, slot);
        let known = self.respond(b, &self.regression.known, &before.known, slots);
        let drives = self.regression.gammas.iter().zip(&before.gammas);
        let gammas = drives.map(|(drive, state)| self.respond(b, drive, state, slots)).collect();
        Running { slot, late, known, gammas }
    }

    /// `Phi state + what drives it` over the interval between two slots.
    fn respond(&self, b: &mut Builder, drive: &Drive, state: &[Value], (begin, end): (Value, Value)) -> Vec<Value> {
        (0..self.regression.own)
            .map(|i| {
                let mut terms = Vec::new();
                for (entry, x) in self.regression.phi[i].iter().zip(state) {
                    terms.extend(entry.map(|entry| self.product(b, entry, *x)));
                }
                for (shares, slot) in [(&drive.begin, begin), (&drive.end, end)] {
                    for (share, ring) in shares.iter().zip(&self.signals) {
                        if let Some(entry) = share[i] {
                            let value = b.read_ring(*ring, slot);
                            terms.push(self.product(b, entry, value));
                        }
                    }
                }
                terms.extend(drive.constant[i].map(|entry| self.constant(b, entry)));
                b.sum(&terms)
            })
            .collect()
    }

    /// What the window's first sample of an output shows: there the responses are zero.
    pub fn shown_first(&self, b: &mut Builder, start: &Running, output: usize) -> Shown {
        let columns = self.regression.rows[0][output].iter().map(|entry| self.constant(b, *entry)).collect();
        let sample = b.read_ring(self.outputs[output], start.late[output].unwrap_or(start.slot));
        let measured = self.product(b, self.regression.trust[output], sample);
        Shown { columns, measured, gammas: vec![b.float(0.0); self.q()] }
    }

    /// What a sample of an output shows; only inside a loop over the table.
    pub fn shown(&self, b: &mut Builder, now: &Running, output: usize) -> Shown {
        let n = self.n();
        let place = |column: usize| u16::try_from(column).unwrap_or_else(|_| unreachable!("256 outputs of 256 states"));
        let columns = (0..n).map(|k| b.gain(place(output * n + k))).collect();
        let sample = b.read_ring(self.outputs[output], now.late[output].unwrap_or(now.slot));
        let sample = self.product(b, self.regression.trust[output], sample);
        let seen = self.see(b, output, &now.known);
        let mut measured = b.sub(sample, seen);
        let mut gammas: Vec<Value> = now.gammas.iter().map(|state| self.see(b, output, state)).collect();
        if now.late[output].is_some() {
            let before = now.late[..output].iter().flatten().count();
            let arrived = b.gain(place(self.outputs.len() * n + before));
            measured = b.mul(arrived, measured);
            for value in &mut gammas {
                *value = b.mul(arrived, *value);
            }
        }
        Shown { columns, measured, gammas }
    }

    /// Trust times C, of one output.
    fn see(&self, b: &mut Builder, output: usize, state: &[Value]) -> Value {
        let entries: &[Entry] = &self.regression.shown[output];
        let terms: Vec<Value> = entries
            .iter()
            .zip(state)
            .filter_map(|(entry, x)| Some(((*entry)?, *x)))
            .map(|(e, x)| self.product(b, e, x))
            .collect();
        b.sum(&terms)
    }
}
