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
    /// The certificate from call `valid` on.
    pub fn certify(&self, valid: usize, remaining: &Remaining) -> Certificate {
        let kernel = Kernel::new(self.plant);
        let kernel = kernel.as_ref();
        let worst = match self.cycle.len() {
            _ if self.is_constant() => self.constant(valid, kernel),
            _ if self.is_held() => self.held(valid, kernel),
            _ => self.cycling(valid, kernel),
        };
        let worst = worst.scaled(SLACK);
        let infinite = || vec![vec![f64::INFINITY; self.plant.disturbances.len()]; self.order()];
        let disturbance_gain_l1 = if kernel.is_some() { rows(&worst.disturbances) } else { infinite() };
        let error_bound = (0..self.order()).map(|i| self.bound(&worst, &disturbance_gain_l1, i)).collect();
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

    /// The worst call from V on, where the gain is the same at every sample: exactly, at each place of the cycle.
    fn constant(&self, valid: usize, kernel: Option<&Kernel>) -> Sums {
        let mut worst = Sums::new(self.plant, self.signals.len());
        let mut spent = 0.0;
        for place in 0..self.cycle.len() {
            let Some(sums) = self.ending(place, valid, kernel, &mut spent) else {
                return Sums::infinite(self.plant, self.signals.len());
            };
            worst.raise(&sums);
        }
        if valid == 0 {
            worst.raise(&self.at(0, 0, kernel).0);
        }
        worst
    }

    /// The worst call from V on of those at a place of the cycle: from it back, each call adds to the sums of those after it.
    fn ending(&self, place: usize, valid: usize, kernel: Option<&Kernel>, spent: &mut f64) -> Option<Sums> {
        let length = self.cycle.len();
        let (mut recent, mut rows) = (Sums::new(self.plant, self.signals.len()), self.back.clone());
        let mut begun = DMatrix::zeros(self.order(), self.signals.len());
        let mut transition = self.identity();
        let mut worst = recent.clone();
        let mut past = 0;
        while past < valid || transition.norm() > COMPLETE || past % length != place {
            // The call that lies so far back, by its place in the first cycle.
            let call = 1 + (place + length - 1 - past % length) % length;
            past += 1;
            rows = self.enter(&mut recent, &rows, &mut begun, call, kernel);
            transition *= self.transition(call);
            if past >= valid && past % length == place {
                let mut all = recent.clone();
                self.finish(&mut all, &rows, &begun, true);
                worst.raise(&all);
            }
            *spent += self.work();
            if *spent > 2.0 * MOST_WORK {
                return None;
            }
        }
        Some(worst)
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

    /// The worst call from V on, where the gains go round: the first round exactly, all others from two rounds back.
    fn cycling(&self, valid: usize, kernel: Option<&Kernel>) -> Sums {
        let length = self.cycle.len();
        if count(length) * count(2 * valid + 3 * length) * self.work() > 4.0 * MOST_WORK {
            return Sums::infinite(self.plant, self.signals.len());
        }
        let Some(end) = self.round_end(valid, kernel) else {
            return Sums::infinite(self.plant, self.signals.len());
        };
        let mut worst = end.clone();
        for k in 0..length {
            worst.raise(&self.at(valid + k, valid + k, kernel).0);
            // What lies further back than the round before stands in the bound of a round's end.
            let (mut sums, rows) = self.at(valid + 2 * length + k, length + k, kernel);
            sums.add(&end.carried(&(rows * &self.to)));
            worst.raise(&sums);
        }
        worst
    }

    /// A bound on the sums at the end of any round from V on: a fixed point of one round's.
    fn round_end(&self, valid: usize, kernel: Option<&Kernel>) -> Option<Sums> {
        [1, 2, 4, 8].into_iter().find_map(|rounds| self.rounds_end(valid, rounds, kernel))
    }

    /// The same from the sums of so many rounds together: a round that turns one state into another may only shrink
    /// the error over several.
    fn rounds_end(&self, valid: usize, rounds: usize, kernel: Option<&Kernel>) -> Option<Sums> {
        let length = self.cycle.len();
        let (round, rows) = self.at(valid + (rounds + 1) * length, rounds * length, kernel);
        let around = rows * &self.to;
        let mut end = self.at(valid, valid, kernel).0;
        for k in 1..rounds {
            end.raise(&self.at(valid + k * length, valid + k * length, kernel).0);
        }
        for _ in 0..10_000 {
            let mut next = end.carried(&around);
            next.add(&round);
            if !next.exceeds(&end) {
                return Some(end);
            }
            end.raise(&next);
        }
        None
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

    fn parts(&self) -> [&DMatrix<f64>; 4] {
        [&self.noise, &self.squares, &self.disturbances, &self.signals]
    }

    fn parts_mut(&mut self) -> [&mut DMatrix<f64>; 4] {
        [&mut self.noise, &mut self.squares, &mut self.disturbances, &mut self.signals]
    }

    fn map(mut self, change: impl Fn(f64) -> f64) -> Self {
        self.parts_mut().into_iter().flatten().for_each(|entry| *entry = change(*entry));
        self
    }

    /// What a transition makes of them at most; of deviations that are added as if they were of one cause.
    fn carried(&self, transition: &DMatrix<f64>) -> Self {
        let magnitudes = transition.abs();
        let [noise, _, disturbances, signals] = self.parts().map(|part| &magnitudes * part);
        let squares = (&magnitudes * self.squares.map(f64::sqrt)).map(|x| x * x);
        Self { noise, squares, disturbances, signals }
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

    /// Whether an entry is larger, beyond rounding.
    fn exceeds(&self, other: &Self) -> bool {
        let pairs = self.parts().into_iter().zip(other.parts());
        pairs.flat_map(|(a, b)| a.iter().zip(b)).any(|(a, b)| *a > *b * (1.0 + 1e-10))
    }

    fn scaled(self, factor: f64) -> Self {
        self.map(|entry| entry * factor)
    }
}
