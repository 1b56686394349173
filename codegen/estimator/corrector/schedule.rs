//! The gain of every call, in doubles: for what is promised, not for what is computed.

use nalgebra::DMatrix;

use super::exact::{Exact, Law};
use super::{After, Counting, interval};
use crate::plant::Plant;

/// K, n x p, of every call after the first sample.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// Of calls 1, 2, … until the promised one.
    pub lead: Vec<DMatrix<f64>>,
    /// Of the calls after it, over and over.
    pub cycle: Vec<DMatrix<f64>>,
}

impl Schedule {
    /// Of a design for its plant; `valid` is the call that is promised where there is a countdown. Without one there is no
    /// lead: the gains go round from the first call on.
    pub fn new(plant: &Plant, exact: &Exact, counting: Counting, valid: usize) -> Self {
        let calls = interval::calls(plant);
        match &exact.law {
            // The first sample is the cycle's first call; the columns of what is not due are zero already.
            Law::Periodic(gains) => {
                let cycle = (1..=gains.len()).map(|call| exact.law.gain(exact, counting, call)).collect();
                Self { lead: Vec::new(), cycle }
            }
            _ if counting == Counting::NONE => {
                let constant = exact.law.gain(exact, counting, counting.stop);
                Self { lead: Vec::new(), cycle: vec![constant] }.between(calls, 0)
            }
            _ => Self::at_every_sample(exact, counting, valid.div_ceil(calls)).between(calls, valid),
        }
    }

    /// Of samples that are due at every so many calls: nothing is corrected between them.
    #[must_use]
    pub fn between(self, calls: usize, valid: usize) -> Self {
        if calls == 1 {
            return self;
        }
        let of = |call: usize| {
            let sample = (call / calls).max(1);
            let gain = match self.lead.get(sample - 1) {
                Some(gain) => gain,
                None => &self.cycle[(sample - 1 - self.lead.len()) % self.cycle.len()],
            };
            if call.is_multiple_of(calls) { gain.clone() } else { DMatrix::zeros(gain.nrows(), gain.ncols()) }
        };
        let cycle = (valid + 1..=valid + calls * self.cycle.len()).map(of).collect();
        Self { lead: (1..=valid).map(of).collect(), cycle }
    }

    /// Of samples at every call.
    fn at_every_sample(exact: &Exact, counting: Counting, valid: usize) -> Self {
        let of = |left: usize| exact.law.gain(exact, counting, left);
        if counting.lead() == 0 && counting.after != After::Restart {
            let constant = of(counting.stop);
            return Self { lead: vec![constant.clone(); valid], cycle: vec![constant] };
        }
        let lead: Vec<DMatrix<f64>> = (counting.stop..counting.steps).rev().map(of).collect();
        let cycle = match (counting.after, &exact.handover) {
            (After::Handover, Some(gain)) => vec![gain.doubles()],
            (After::Restart, _) => (counting.stop..=counting.steps).rev().map(of).collect(),
            _ => vec![of(counting.stop)],
        };
        let mut all = lead;
        // A promise that comes later than the countdown's end.
        while all.len() < valid {
            let place = (all.len() - counting.lead()) % cycle.len();
            all.push(cycle[place].clone());
        }
        let turned = (all.len() - counting.lead()) % cycle.len();
        let mut cycle = cycle;
        cycle.rotate_left(turned);
        Self { lead: all, cycle }
    }
}
