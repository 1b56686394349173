//! What the innovation adds to the state: one function per kind of gain.

use crate::program::Value;
use crate::sampled::settled::Settled;
use crate::sampled::weights::{products, push_products};

use super::super::{After, Corrector, Frame, Gain, Polynomials, Spread, guard};
use super::{Lowering, calls};

impl Lowering<'_> {
    /// The correction of each state, and what is left of the countdown where there is one.
    pub(super) fn correct(&mut self, innovation: &[Value], measured: Value) -> (Vec<Value>, Option<Value>) {
        let design = self.design;
        let before = self.builder.read(self.cells.left);
        let left = counts_down(design).then(|| self.count_down(before, measured));
        let corrections = match (&design.gain, left) {
            (Gain::Constant(gain), _) => products(&mut self.builder, gain, innovation),
            (Gain::Periodic(rows), _) => self.by_phase(rows, innovation),
            (Gain::Table(rows), Some(left)) => self.by_table(rows, left, innovation),
            (Gain::Countdown(law), Some(left)) => {
                let kappa = self.by_countdown(law, left, innovation[0]);
                self.spread(kappa, innovation[0])
            }
            (Gain::Sliding { law, .. }, _) => {
                let largest = self.sensors.guard.bound * guard::innovation(self.plant, design);
                let corrections = law.corrections(&mut self.builder, innovation[0], largest);
                self.spread(corrections, innovation[0])
            }
            (Gain::Table(_) | Gain::Countdown(_), None) => unreachable!("these follow a countdown"),
        };
        let Some(steady) = &design.handover else { return (corrections, left) };
        let after = products(&mut self.builder, steady, innovation);
        let none = self.builder.index(0);
        let over = self.builder.index_equal(before, none);
        let chosen = corrections.into_iter().zip(after).map(|(now, after)| self.builder.select(over, after, now));
        (chosen.collect(), left)
    }

    /// The calls of the countdown that are left, this one done; without a sample it waits.
    fn count_down(&mut self, before: Value, measured: Value) -> Value {
        let lead = calls(self.design.counting.lead());
        let within = self.builder.at_most(before, lead);
        let mut next = self.builder.count_down(within);
        if self.design.counting.after == After::Restart {
            let none = self.builder.index(0);
            let over = self.builder.index_equal(within, none);
            let lead = self.builder.index(lead);
            next = self.builder.select(over, lead, next);
        }
        self.builder.select(measured, next, within)
    }

    /// K e with a row of gains per call; the last call's stands first.
    fn by_table(&mut self, rows: &[Vec<Vec<Settled>>], left: Value, innovation: &[Value]) -> Vec<Value> {
        let scalar = self.plant.scalar;
        let names = self.plant.states.iter().flat_map(|state| {
            self.plant.outputs.iter().map(|output| format!("{} from {}", state.label.name, output.label.name))
        });
        let names = names.collect();
        let values = rows.iter().rev().map(|k| k.iter().flatten().map(|x| x.value(scalar)).collect()).collect();
        let table = self.builder.table("GAINS", "gain by calls of the countdown that are left", names, values);
        let row = self.builder.at_most(left, calls(rows.len() - 1));
        let outputs = innovation.len();
        let each = (0..self.plant.states.len()).map(|i| {
            let terms = innovation.iter().enumerate().map(|(o, e)| {
                let gain = self.builder.lookup(table, row, crate::program::place(i * outputs + o));
                self.builder.mul(gain, *e)
            });
            let terms: Vec<Value> = terms.collect();
            self.builder.sum(&terms)
        });
        each.collect()
    }

    /// K e with a row of gains for each call of the cycle.
    fn by_phase(&mut self, rows: &[Vec<Vec<Settled>>], innovation: &[Value]) -> Vec<Value> {
        let scalar = self.plant.scalar;
        let (states, outputs) = (self.plant.states.len(), innovation.len());
        let names = self.plant.states.iter().flat_map(|state| {
            self.plant.outputs.iter().map(|output| format!("{} from {}", state.label.name, output.label.name))
        });
        let names = names.collect();
        let values = rows.iter().map(|k| k.iter().flatten().map(|x| x.value(scalar)).collect()).collect();
        let table = self.builder.table("GAINS", "gain by calls since every output was due", names, values);
        let phase = self.builder.read(self.cells.phase);
        let row = self.builder.at_most(phase, calls(rows.len() - 1));
        let next = self.builder.advance(row, calls(rows.len()));
        self.builder.set(self.cells.phase, next);
        let each = (0..states).map(|i| {
            let terms = innovation.iter().enumerate().map(|(o, e)| {
                let gain = self.builder.lookup(table, row, crate::program::place(i * outputs + o));
                self.builder.mul(gain, *e)
            });
            let terms: Vec<Value> = terms.collect();
            self.builder.sum(&terms)
        });
        each.collect()
    }

    /// kappa e from the steps left: `S_j / (r^n + S_1)`, all times `r'^n` (section 0 of prescribed-time-observers).
    fn by_countdown(&mut self, law: &Polynomials, left: Value, innovation: Value) -> Vec<Value> {
        let n = law.terms.len();
        let unit = (0..law.shift).fold(1.0, |unit: f64, _| unit * 0.5);
        let left = self.builder.to_float(left);
        let unit_value = self.builder.float(unit);
        let scaled = self.builder.mul(unit_value, left);
        let stop = self.builder.float(crate::numbers::count(self.design.counting.stop) * unit);
        let r = self.builder.add(scaled, stop);
        let mut powers = vec![self.builder.float(1.0), r];
        for _ in 1..n {
            powers.push(self.builder.mul(powers[powers.len() - 1], r));
        }
        let terms: Vec<Value> = products(&mut self.builder, &law.terms, &powers);
        let mut sums = terms.clone();
        for j in (0..n - 1).rev() {
            sums[j] = self.builder.add(terms[j], sums[j + 1]);
        }
        let denominator = self.builder.add(powers[n], sums[0]);
        let quotient = self.builder.div(innovation, denominator);
        sums.into_iter().map(|sum| self.builder.mul(sum, quotient)).collect()
    }

    /// From the chain's coordinates into the states: M kappa e + q e.
    fn spread(&mut self, kappa: Vec<Value>, innovation: Value) -> Vec<Value> {
        let design = self.design;
        let Frame::Plant { spread: Some(Spread { m, q }), .. } = &design.frame else { return kappa };
        let each = m.iter().zip(q).map(|(row, q)| {
            let mut terms = Vec::new();
            push_products(&mut self.builder, &mut terms, row, &kappa);
            push_products(&mut self.builder, &mut terms, &[*q], &[innovation]);
            self.builder.sum(&terms)
        });
        each.collect()
    }
}

/// Whether the gains of a design follow a countdown.
fn counts_down(design: &Corrector) -> bool {
    design.counting.lead() > 0 || matches!(design.gain, Gain::Countdown(_))
}
