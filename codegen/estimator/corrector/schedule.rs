//! The gain of every call, in doubles: for what is promised, not for what is computed.

use super::exact::{Exact, Law};
use super::{After, Counting};
use crate::dense::Rows as Dense;

/// K, n x p, of every call after the first sample.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// Of calls 1, 2, … until the promised one.
    pub lead: Vec<Dense>,
    /// Of the calls after it, over and over.
    pub cycle: Vec<Dense>,
}

impl Schedule {
    /// Of a design; `valid` is the call that is promised where the gain is constant.
    pub fn new(exact: &Exact, counting: Counting, valid: usize) -> Self {
        let of = |left: usize| exact.law.gain(exact, counting, left);
        if let Law::Periodic(gains) = &exact.law {
            // The first sample is the cycle's first call.
            let cycle = (valid + 1..=valid + gains.len()).map(of).collect();
            return Self { lead: (1..=valid).map(of).collect(), cycle };
        }
        if counting.lead() == 0 && counting.after != After::Restart {
            let constant = of(counting.stop);
            return Self { lead: vec![constant.clone(); valid], cycle: vec![constant] };
        }
        let lead: Vec<Dense> = (counting.stop..counting.steps).rev().map(of).collect();
        let cycle = match (counting.after, &exact.handover) {
            (After::Handover, Some(gain)) => vec![gain.to_f64()],
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
