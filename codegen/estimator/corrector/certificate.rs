//! What is promised of a corrector, for any schedule of gains: the largest errors from noise and disturbances at every
//! call from the promised one, V, on; and what is left of an initial error at V.
//!
//! At a call the sums of magnitudes over all that entered before are exact. They are formed for the calls after V until
//! what entered before V has died out, and for each place of a countdown that goes round; whatever is left of the past
//! beyond that is bounded by the magnitudes of the transition since. The gains printed are those of the worst call, or
//! above by what is so bounded (prescribed-time-observers, section 6, has exact ones for 003's example; the tests
//! compare).

use nalgebra::DMatrix;

use super::errors::{Errors, Remaining, Sums};
use super::past::Past;
use crate::numbers::count;
use crate::plant::Plant;
use crate::promise::Certificate;
use crate::promise::kernel::{Kernel, slope};
use crate::real::rows;
use crate::sampled::Source;

/// What may be left of a transition when the sums over the past count as complete.
const COMPLETE: f64 = 1e-12;
/// What may be left of it when its share is bounded instead of formed.
const SMALL: f64 = 1e-3;
/// For what is left out by that, and for the rounding of sums of up to 1e6 terms.
const SLACK: f64 = 1.0 + 1e-9;
/// Multiplications spent on exact sums.
const MOST_WORK: f64 = 2e8;

impl Errors<'_> {
    /// The largest sums of any call from `valid` on.
    pub(super) fn worst(&self, valid: usize) -> Sums {
        let kernel = Kernel::new(self.plant);
        let kernel = kernel.as_ref();
        let worst = if self.goes_round() { self.turning(valid, kernel) } else { self.held(valid, kernel) };
        let mut worst = worst.scaled(SLACK);
        if kernel.is_none() {
            worst.disturbances.fill(f64::INFINITY);
        }
        worst
    }

    /// The certificate from the call on from which these sums are.
    pub(super) fn certify(&self, worst: &Sums, remaining: &Remaining) -> Certificate {
        let disturbance_gain_l1 = rows(&worst.disturbances);
        let error_bound = (0..self.order()).map(|i| self.bound(worst, &disturbance_gain_l1, i)).collect();
        Certificate {
            noise_gain_l2: rows(&worst.squares.map(f64::sqrt)),
            noise_gain_l1: rows(&worst.noise),
            disturbance_gain_l1,
            error_bound,
            initial_gain: rows(&remaining.by_state),
            ..Certificate::default()
        }
    }

    /// Multiplications of a call's exact sums, per call before it.
    fn work(&self) -> f64 {
        let n = count(self.order());
        n * n * (3.0 * n + count(self.plant.outputs.len() + self.plant.disturbances.len()))
    }

    /// The worst call from V on, where the gains go round from the first call on.
    fn turning(&self, valid: usize, kernel: Option<&Kernel>) -> Sums {
        let infinite = || Sums::infinite(self.plant, self.signals.len());
        Past::new(self, kernel, valid).and_then(|past| past.worst_from(valid)).unwrap_or_else(infinite)
    }

    /// The worst call from V on, where every sample of an output has the same gain from there on.
    fn held(&self, valid: usize, kernel: Option<&Kernel>) -> Sums {
        let (at_valid, _) = self.at(valid, valid, kernel);
        let mut worst = at_valid.clone();
        let (mut transition, mut spent, mut exactly) = (self.identity(), 0.0, valid);
        // Exactly, until little is left of what was before V.
        while transition.norm() > SMALL && spent < MOST_WORK {
            exactly += 1;
            transition = self.transition(exactly) * transition;
            worst.raise(&self.at(exactly, exactly, kernel).0);
            spent += count(exactly) * self.work();
        }
        for place in 0..self.cycle.len() {
            let Some(sums) = self.later(place, (valid, &at_valid), exactly, kernel, &mut spent) else {
                return Sums::infinite(self.plant, self.signals.len());
            };
            worst.raise(&sums);
        }
        worst
    }

    /// The worst call beyond those of exact sums, of those at a place of the cycle: what was before V as a bound.
    fn later(
        &self,
        place: usize,
        (valid, at_valid): (usize, &Sums),
        exactly: usize,
        kernel: Option<&Kernel>,
        spent: &mut f64,
    ) -> Option<Sums> {
        let length = self.cycle.len();
        let (mut recent, mut rows) = (Sums::new(self.plant, self.signals.len()), self.back.clone());
        let mut begun = DMatrix::zeros(self.order(), self.signals.len());
        let mut transition = self.identity();
        let mut worst = recent.clone();
        let mut past = 0;
        while transition.norm() > COMPLETE || past % length != place {
            // The call that lies so far back, by its place in the first cycle from V on.
            let call = valid + 1 + (place + length - 1 - past % length) % length;
            past += 1;
            rows = self.enter(&mut recent, &rows, &mut begun, call, kernel);
            transition *= self.transition(call);
            if valid + past > exactly && past % length == place {
                let mut all = at_valid.carried(&(&self.back * &transition * &self.to));
                all.add(&recent);
                // A signal's value at V also begins the first interval after it.
                self.finish(&mut all, &rows, &begun, false);
                worst.raise(&all);
            }
            *spent += self.work();
            if *spent > 2.0 * MOST_WORK {
                return None;
            }
        }
        Some(worst)
    }

    fn bound(&self, worst: &Sums, disturbances: &[Vec<f64>], state: usize) -> Option<f64> {
        let mut bound = 0.0;
        for (o, output) in self.plant.outputs.iter().enumerate() {
            let level = output.noise.as_ref()?.to_f64().ok()?;
            bound += worst.noise[(state, o)] * level;
            for (s, signal) in self.signals.iter().enumerate() {
                if let Source::Injection(k) = signal.source {
                    bound += worst.signals[(state, s)] * slope(self.plant, k, o)? * level;
                }
            }
        }
        for (disturbance, gain) in self.plant.disturbances.iter().zip(&disturbances[state]) {
            bound += gain * disturbance.bound.to_f64().ok()?;
        }
        bound.is_finite().then_some(bound)
    }
}

impl Sums {
    fn infinite(plant: &Plant, signals: usize) -> Self {
        Self::new(plant, signals).map(|_| f64::INFINITY)
    }

    fn parts(&self) -> [&DMatrix<f64>; 6] {
        [&self.noise, &self.squares, &self.disturbances, &self.signals, &self.carried, &self.gained]
    }

    fn parts_mut(&mut self) -> [&mut DMatrix<f64>; 6] {
        let Self { noise, squares, disturbances, signals, carried, gained } = self;
        [noise, squares, disturbances, signals, carried, gained]
    }

    fn map(mut self, change: impl Fn(f64) -> f64) -> Self {
        self.parts_mut().into_iter().flatten().for_each(|entry| *entry = change(*entry));
        self
    }

    /// What a transition makes of them at most; of deviations that are added as if they were of one cause.
    fn carried(&self, transition: &DMatrix<f64>) -> Self {
        let magnitudes = transition.abs();
        let [noise, _, disturbances, signals, carried, gained] = self.parts().map(|part| &magnitudes * part);
        let squares = (&magnitudes * self.squares.map(f64::sqrt)).map(|x| x * x);
        Self { noise, squares, disturbances, signals, carried, gained }
    }

    fn add(&mut self, other: &Self) {
        for (mine, theirs) in self.parts_mut().into_iter().zip(other.parts()) {
            *mine += theirs;
        }
    }

    /// The larger of both, entry by entry.
    fn raise(&mut self, other: &Self) {
        for (mine, theirs) in self.parts_mut().into_iter().zip(other.parts()) {
            mine.zip_apply(theirs, |mine, theirs| *mine = mine.max(theirs));
        }
    }

    /// Whether an entry is larger.
    pub(super) fn exceeds(&self, other: &Self) -> bool {
        let pairs = self.parts().into_iter().zip(other.parts());
        pairs.flat_map(|(a, b)| a.iter().zip(b)).any(|(a, b)| a > b)
    }

    fn scaled(self, factor: f64) -> Self {
        self.map(|entry| entry * factor)
    }
}
