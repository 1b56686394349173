//! A start from a given state and given unknowns: the model runs with them until the window is full, and they stand as
//! found until the signals excite the unknowns.

use crate::estimator::window::lower::given::{self, Given};
use crate::promise::Certificate;
use crate::sampled::carry::{Carry, Factor};
use crate::sampled::settled::Settled;

use super::super::{Drive, Entry, Regression};
use super::Step;

impl Step<'_> {
    /// Declares what a start from a given state keeps, where there is such a start.
    pub(super) fn declare_given(&mut self, promised: &Certificate) {
        let plant = self.lowering.plant;
        if plant.init_at {
            let carry = carry(self.regression, plant.states.len());
            let taken = vec![false; plant.states.len()];
            let trust = given::trust(plant, &self.regression.carrier, (&carry, &taken), promised);
            self.lowering.given = Some(Given::declare(&mut self.lowering.builder, plant, (carry, taken), trust));
        }
    }

    /// Writes the start, where there is one.
    pub(super) fn init_at(&mut self) {
        let (regression, found, values, longest) = (self.regression, self.found, self.values.clone(), self.longest());
        let bound = self.lowering.sensors.guard.bound;
        self.lowering.init_at(|b, state| {
            b.section("the given unknowns stand as found");
            let longest = b.index(longest);
            b.set(found, longest);
            for ((place, scale), cell) in regression.unknowns.iter().zip(&regression.scales).zip(values) {
                let unit = b.float(scale.recip());
                let value = b.mul(unit, state[*place]);
                let (sane, zero) = (b.in_range(value, -bound, bound), b.float(0.0));
                let value = b.select(sane, value, zero);
                b.set(cell, value);
            }
        });
    }
}

/// One call of the model with its unknowns, by place in the plant.
fn carry(regression: &Regression, n: usize) -> Carry {
    let spread = |entries: &[Entry]| -> Vec<Entry> {
        let mut column = vec![None; n];
        for (place, entry) in regression.states.iter().zip(entries).take(regression.own) {
            column[*place] = *entry;
        }
        column
    };
    let all = |columns: &[Vec<Entry>]| -> Vec<Vec<Entry>> { columns.iter().map(|column| spread(column)).collect() };
    let mut phi = vec![vec![None; n]; n];
    for (place, row) in regression.states.iter().zip(&regression.phi) {
        for (from, entry) in regression.states.iter().zip(row) {
            phi[*place][*from] = *entry;
        }
    }
    for place in &regression.unknowns {
        phi[*place][*place] = Some(Settled { double: 1.0, single: 1.0 });
    }
    let factor = |((place, scale), drive): ((&usize, &f64), &Drive)| Factor {
        state: *place,
        unit: scale.recip(),
        begin: all(&drive.begin),
        end: all(&drive.end),
        constant: spread(&drive.constant),
    };
    let unknowns = regression.unknowns.iter().zip(&regression.scales);
    Carry {
        phi,
        begin: all(&regression.known.begin),
        end: all(&regression.known.end),
        constant: spread(&regression.known.constant),
        factors: unknowns.zip(&regression.gammas).map(factor).collect(),
    }
}
