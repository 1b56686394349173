//! What both loops over the window do at each sample: responses advance, outputs show them.

use crate::estimator::window::lower::Lowering;
use crate::program::builder::Builder;
use crate::program::{TableId, Value, place};
use crate::sampled::settled::round;
use crate::sampled::weights::{constant, product, row, terms};
use crate::step::front;
use crate::step::kept::Kept;

use super::super::{Drive, Regression};

/// What the loops read.
pub struct Window<'a> {
    pub(super) regression: &'a Regression,
    outputs: Vec<Kept>,
    signals: Vec<Kept>,
    /// Per output that wraps: its turn.
    turns: Vec<Option<f64>>,
    len: u32,
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
    /// Per output that wraps: how far it has moved since the window's first sample.
    pub moved: Vec<Option<Value>>,
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
        let slots = std::iter::once(self.slot).chain(self.late.iter().chain(&self.moved).copied().flatten());
        slots.chain(self.known.iter().copied()).chain(self.gammas.iter().flatten().copied()).collect()
    }

    /// The same shape with what a loop carries.
    pub fn with(&self, carried: &[Value]) -> Self {
        let mut values = carried.iter().copied();
        let mut next = || values.next().unwrap_or_else(|| unreachable!("a loop carries what it was started with"));
        Self {
            slot: next(),
            late: self.late.iter().map(|slot| slot.map(|_| next())).collect(),
            moved: self.moved.iter().map(|moved| moved.map(|_| next())).collect(),
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
            outputs: lowering.sensors.outputs.clone(),
            signals: lowering.sensors.values.clone(),
            turns: plant.outputs.iter().map(|o| Some(round(&o.wrap.as_ref()?.turn, plant.scalar))).collect(),
            len: lowering.window(),
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

    /// From one sample to the next.
    pub fn advance(&self, b: &mut Builder, before: &Running) -> Running {
        let slot = b.advance(before.slot, self.len);
        let late: Vec<Option<Value>> =
            before.late.iter().map(|slot| slot.map(|slot| b.advance(slot, self.len))).collect();
        let moved = (0..late.len()).map(|o| self.moved(b, before, (slot, late[o]), o)).collect();
        let slots = (before.slot, slot);
        let known = self.respond(b, &self.regression.known, &before.known, slots);
        let drives = self.regression.gammas.iter().zip(&before.gammas);
        let gammas = drives.map(|(drive, state)| self.respond(b, drive, state, slots)).collect();
        Running { slot, late, moved, known, gammas }
    }

    /// How far an output that wraps has moved at the next slots; of a late one, as far as it has arrived.
    fn moved(
        &self,
        b: &mut Builder,
        before: &Running,
        (slot, late): (Value, Option<Value>),
        output: usize,
    ) -> Option<Value> {
        let (turn, moved, kept) = (self.turns[output]?, before.moved[output]?, self.outputs[output]);
        let (from, to) = (before.late[output].unwrap_or(before.slot), late.unwrap_or(slot));
        let step = match (kept.count(b, Some(from)), kept.count(b, Some(to))) {
            (Some((from, counts)), Some((to, _))) => counts.moved(b, to, from),
            _ => {
                let (from, to) = (kept.read(b, from), kept.read(b, to));
                let step = b.sub(to, from);
                front::fold(b, step, turn)
            }
        };
        let step = match late {
            Some(_) => {
                let arrived = self.arrived(b, before, output);
                b.mul(arrived, step)
            }
            None => step,
        };
        Some(b.add(moved, step))
    }

    /// 1 where a late output's sample has arrived, else 0; only inside a loop over the table.
    fn arrived(&self, b: &mut Builder, now: &Running, output: usize) -> Value {
        let before = now.late[..output].iter().flatten().count();
        b.gain(place(self.outputs.len() * self.n() + before))
    }

    /// `Phi state + what drives it` over the interval between two slots.
    fn respond(&self, b: &mut Builder, drive: &Drive, state: &[Value], (begin, end): (Value, Value)) -> Vec<Value> {
        (0..self.regression.own)
            .map(|i| {
                let mut terms = terms(b, self.regression.phi[i].iter().zip(state));
                for (shares, slot) in [(&drive.begin, begin), (&drive.end, end)] {
                    for (share, ring) in shares.iter().zip(&self.signals) {
                        if let Some(entry) = share[i] {
                            let value = ring.read(b, slot);
                            terms.push(product(b, entry, value));
                        }
                    }
                }
                terms.extend(drive.constant[i].map(|entry| constant(b, entry)));
                b.sum(&terms)
            })
            .collect()
    }

    /// What the window's first sample of an output shows: there the responses are zero.
    pub fn shown_first(&self, b: &mut Builder, start: &Running, output: usize) -> Shown {
        let columns = self.regression.rows[0][output].iter().map(|entry| constant(b, *entry)).collect();
        let sample = match start.moved[output] {
            Some(moved) => moved,
            None => self.outputs[output].read(b, start.late[output].unwrap_or(start.slot)),
        };
        let measured = product(b, self.regression.trust[output], sample);
        Shown { columns, measured, gammas: vec![b.float(0.0); self.q()] }
    }

    /// What a sample of an output shows; only inside a loop over the table.
    pub fn shown(&self, b: &mut Builder, now: &Running, output: usize) -> Shown {
        let n = self.n();
        let columns = (0..n).map(|k| b.gain(place(output * n + k))).collect();
        let sample = match now.moved[output] {
            Some(moved) => moved,
            None => self.outputs[output].read(b, now.late[output].unwrap_or(now.slot)),
        };
        let sample = product(b, self.regression.trust[output], sample);
        let seen = self.see(b, output, &now.known);
        let mut measured = b.sub(sample, seen);
        let mut gammas: Vec<Value> = now.gammas.iter().map(|state| self.see(b, output, state)).collect();
        if now.late[output].is_some() {
            let arrived = self.arrived(b, now, output);
            measured = b.mul(arrived, measured);
            for value in &mut gammas {
                *value = b.mul(arrived, *value);
            }
        }
        Shown { columns, measured, gammas }
    }

    /// Trust times C, of one output.
    fn see(&self, b: &mut Builder, output: usize, state: &[Value]) -> Value {
        row(b, &self.regression.shown[output], state)
    }
}
