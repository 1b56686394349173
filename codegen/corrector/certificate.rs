//! What is promised of a corrector, for any schedule of gains: what is left of an initial error, and the largest
//! errors from noise and disturbances, at every call from the promised one on.
//!
//! The error moves by `e = (I - K C) Phi e`, noise v enters by -K v, a disturbance by (I - K C) before its correction.
//! At the promised call V all sums of magnitudes are exact. After it, what entered before V is bounded entry by entry
//! by the magnitudes of the transition from V on, and what entered since is summed exactly, so that the gains printed
//! are those of the worst call or above (prescribed-time-observers, section 6). Standard deviations for white noise
//! follow from the covariance, without any bound.
//!
//! All of it is in doubles, in coordinates in which the size of an error is the root mean square of what it does to
//! the outputs over the calls until V: there, no unit makes a small error look large.

use super::exact::Exact;
use super::schedule::Schedule;
use crate::dense::{
    Rows as Dense, add, add_magnitudes, dot, frobenius, identity, orthonormalised, outer, product, transposed,
};
use crate::design::Certificate;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, inverse, orthonormal};
use crate::window::certificate::{Kernel, slope};
use crate::window::{Signal, Source, count};

/// Calls over which the size of an error is measured, at most; spread over all until V.
const MOST_LOOKS: usize = 256;
/// What may be left of the transition when the sums over the past count as complete.
const COMPLETE: f64 = 1e-12;
/// For what is left out by that, and for the rounding of sums of up to 1e6 terms.
const SLACK: f64 = 1.0 + 1e-9;
/// Multiplications spent on the calls after V.
const MOST_WORK: f64 = 4e8;

/// How the errors move.
pub struct Errors<'a> {
    plant: &'a Plant,
    signals: &'a [Signal],
    schedule: &'a Schedule,
    /// (coordinates from states, states from coordinates), n x n.
    to: Dense,
    back: Dense,
    phi: Dense,
    c: Dense,
    /// Per signal: its effects at the beginning and at the end of an interval, n x 1, in states.
    effects: Vec<[Vec<f64>; 2]>,
    gains: Gains,
}

/// Of every call, in the coordinates.
struct Gains {
    lead: Vec<Dense>,
    cycle: Vec<Dense>,
}

/// What is left of an initial error at a call.
#[derive(Clone, Debug)]
pub struct Remaining {
    /// Of the worst initial error of the states that the first sample does not show, in size.
    pub share: f64,
    /// Per state, per initial error of a state.
    pub by_state: Dense,
}

impl<'a> Errors<'a> {
    /// For a design and its schedule; `None` where the coordinates cannot be formed.
    pub fn new(plant: &'a Plant, signals: &'a [Signal], exact: &Exact, schedule: &'a Schedule) -> Option<Self> {
        let model = &exact.model;
        let n = plant.states.len();
        let back = size(&model.phi, &model.c, schedule.lead.len().max(n))?;
        let to = inverse(&back).ok()?;
        let effect = |part: &Option<Matrix>| match part {
            Some(column) => column.iter().map(Real::to_f64).collect(),
            None => vec![0.0; n],
        };
        let effects = model.effects.iter().map(|e| [effect(&e.at_begin), effect(&e.at_end)]).collect();
        let phi = (&(&to * &model.phi) * &back).to_f64();
        let c = (&model.c * &back).to_f64();
        let (to, back) = (to.to_f64(), back.to_f64());
        let of = |gains: &[Dense]| gains.iter().map(|gain| product(&to, gain)).collect();
        let gains = Gains { lead: of(&schedule.lead), cycle: of(&schedule.cycle) };
        Some(Self { plant, signals, schedule, to, back, phi, c, effects, gains })
    }

    /// What is left of an initial error at a call.
    pub fn remaining(&self, call: usize) -> Remaining {
        let mut transition = identity(self.phi.len());
        for k in 1..=call {
            transition = product(&self.transition(k), &transition);
        }
        self.left(&transition)
    }

    /// The first call at which at most this share is left; `None` when there is none among so many.
    pub fn reaches(&self, share: f64, most: usize) -> Option<(usize, Remaining)> {
        let mut transition = identity(self.phi.len());
        for call in 0..=most {
            if call > 0 {
                transition = product(&self.transition(call), &transition);
            }
            let left = self.left(&transition);
            if left.share <= share {
                return Some((call, left));
            }
        }
        None
    }

    fn left(&self, transition: &Dense) -> Remaining {
        let hidden: Vec<usize> = (0..self.phi.len()).filter(|i| self.plant.states[*i].measured.is_empty()).collect();
        let columns: Dense = self.to.iter().map(|row| hidden.iter().map(|j| row[*j]).collect()).collect();
        let by_state = product(&product(&self.back, transition), &self.to);
        let share = if hidden.is_empty() { 0.0 } else { frobenius(&product(transition, &orthonormalised(&columns))) };
        Remaining { share, by_state }
    }

    /// The spectral radius of the last gain's transition.
    pub fn radius(&self) -> f64 {
        let step = self.transition(self.gains.lead.len() + self.gains.cycle.len());
        let n = step.len();
        let matrix = nalgebra::DMatrix::from_fn(n, n, |i, j| step[i][j]);
        matrix.complex_eigenvalues().iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max)
    }

    /// The gain of a call, from 1.
    fn gain(&self, call: usize) -> &Dense {
        match self.gains.lead.get(call - 1) {
            Some(gain) => gain,
            None => &self.gains.cycle[(call - 1 - self.gains.lead.len()) % self.gains.cycle.len()],
        }
    }

    /// I - K C of a call.
    fn correction(&self, call: usize) -> Dense {
        let mut correction = identity(self.phi.len());
        for (row, gain) in correction.iter_mut().zip(self.gain(call)) {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry -= gain.iter().zip(&self.c).map(|(gain, c)| gain * c[j]).sum::<f64>();
            }
        }
        correction
    }

    /// (I - K C) Phi of a call.
    fn transition(&self, call: usize) -> Dense {
        product(&self.correction(call), &self.phi)
    }

    /// The certificate from call `valid` on.
    pub fn certify(&self, valid: usize) -> Certificate {
        let kernel = Kernel::new(self.plant);
        let at = self.at(valid, valid, kernel.as_ref(), true);
        let worst = if self.gains.cycle.len() == 1 {
            self.held(&at, valid, kernel.as_ref())
        } else {
            self.cycling(&at, valid, kernel.as_ref())
        };
        let noise_gain_l2 = self.deviations(valid);
        let infinite = || vec![vec![f64::INFINITY; self.plant.disturbances.len()]; self.phi.len()];
        let disturbance_gain_l1 = if kernel.is_some() { worst.disturbances.clone() } else { infinite() };
        let error_bound = (0..self.phi.len()).map(|i| self.bound(&worst, &disturbance_gain_l1, i)).collect();
        let initial_gain = self.remaining(valid).by_state;
        Certificate { noise_gain_l1: worst.noise, noise_gain_l2, disturbance_gain_l1, error_bound, initial_gain }
    }

    /// Sums of magnitudes at a call over what entered in the last `calls` of them, and with the first sample.
    fn at(&self, call: usize, calls: usize, kernel: Option<&Kernel>, start: bool) -> Sums {
        let mut sums = Sums::new(self.plant, self.signals.len());
        let mut rows = self.back.clone();
        // What a signal's value at a call does by the interval that it begins.
        let mut begun: Dense = vec![vec![0.0; self.signals.len()]; rows.len()];
        for k in (call + 1 - calls..=call).rev() {
            add_magnitudes(&mut sums.noise, &product(&rows, self.gain(k)));
            let acc = product(&product(&rows, &self.correction(k)), &self.to);
            if let Some(kernel) = kernel {
                kernel.add(&acc, &mut sums.disturbances);
            }
            for (s, [begin, end]) in self.effects.iter().enumerate() {
                for (i, row) in acc.iter().enumerate() {
                    sums.signals[i][s] += (begun[i][s] + dot(row, end)).abs();
                    begun[i][s] = dot(row, begin);
                }
            }
            rows = product(&rows, &self.transition(k));
        }
        add_magnitudes(&mut sums.signals, &begun);
        if start {
            let starts = product(&product(&rows, &self.to), &self.starts());
            add_magnitudes(&mut sums.noise, &starts);
        }
        sums
    }

    /// The weights of the first sample in the state at the start, n x p.
    fn starts(&self) -> Dense {
        let p = self.plant.outputs.len();
        let row = |state: &crate::plant::State| {
            let mut row = vec![0.0; p];
            state.measured.iter().for_each(|(o, weight)| row[*o] = weight.to_f64().unwrap_or(0.0));
            row
        };
        self.plant.states.iter().map(row).collect()
    }

    /// The worst call from V on, where the gain stays.
    fn held(&self, at: &Sums, valid: usize, kernel: Option<&Kernel>) -> Sums {
        let step = self.transition(valid + 1);
        let mut worst = at.clone();
        let mut recent = Sums::new(self.plant, self.signals.len());
        let mut transition = identity(self.phi.len());
        let n = count(self.phi.len());
        let most = MOST_WORK / (n * n * n * 4.0);
        let mut calls = 0.0;
        while frobenius(&transition) > COMPLETE {
            // One call further back, for a call that lies one more after V.
            let rows = product(&self.back, &transition);
            self.enter(&mut recent, &rows, valid + 1, kernel);
            transition = product(&transition, &step);
            let carried = at.carried(&product(&product(&self.back, &transition), &self.to));
            worst.raise(&recent, Some(&carried));
            calls += 1.0;
            if calls > most {
                return Sums::infinite(self.plant, self.signals.len());
            }
        }
        worst.scaled(SLACK)
    }

    /// Adds what enters at one call of the schedule.
    fn enter(&self, sums: &mut Sums, rows: &Dense, call: usize, kernel: Option<&Kernel>) {
        add_magnitudes(&mut sums.noise, &product(rows, self.gain(call)));
        let acc = product(&product(rows, &self.correction(call)), &self.to);
        if let Some(kernel) = kernel {
            kernel.add(&acc, &mut sums.disturbances);
        }
        for (s, [begin, end]) in self.effects.iter().enumerate() {
            for (i, row) in acc.iter().enumerate() {
                sums.signals[i][s] += dot(row, begin).abs() + dot(row, end).abs();
            }
        }
    }

    /// The worst call from V on, where the gains go round: a fixed point of the sums over one round, then each place.
    fn cycling(&self, at: &Sums, valid: usize, kernel: Option<&Kernel>) -> Sums {
        let (n, length) = (self.phi.len(), self.gains.cycle.len());
        if count(length) * count(length) * count(n * n * n) * 4.0 > 10.0 * MOST_WORK {
            return Sums::infinite(self.plant, self.signals.len());
        }
        let round = self.at(valid + length, length, kernel, false);
        let mut around = identity(n);
        for k in valid + 1..=valid + length {
            around = product(&self.transition(k), &around);
        }
        let around = product(&product(&self.back, &around), &self.to);
        // What is at the end of a round at most: of all rounds before.
        let mut end = at.clone();
        for _ in 0..10_000 {
            let mut next = end.carried(&around);
            next.add(&round);
            if !next.exceeds(&end) {
                break;
            }
            end.raise(&next, None);
        }
        let mut again = end.carried(&around);
        again.add(&round);
        if again.exceeds(&end) {
            return Sums::infinite(self.plant, self.signals.len());
        }
        let mut worst = end.clone();
        let mut transition = identity(n);
        for k in 1..length {
            transition = product(&self.transition(valid + k), &transition);
            let carried = end.carried(&product(&product(&self.back, &transition), &self.to));
            worst.raise(&self.at(valid + k, k, kernel, false), Some(&carried));
        }
        worst.scaled(SLACK)
    }

    /// The largest standard deviations from call V on, per state, per output, for white noise of deviation 1.
    fn deviations(&self, valid: usize) -> Dense {
        let (n, p) = (self.phi.len(), self.plant.outputs.len());
        let mut worst = vec![vec![0.0_f64; p]; n];
        let starts = product(&self.to, &self.starts());
        for o in 0..p {
            let mut covariance = outer(&starts.iter().map(|row| row[o]).collect::<Vec<_>>());
            let mut still = 0;
            let mut call = 0;
            let most = valid + 4 * self.gains.cycle.len() + 100_000;
            while still <= self.gains.cycle.len() && call < most {
                call += 1;
                let step = self.transition(call);
                covariance = product(&product(&step, &covariance), &transposed(&step));
                add(&mut covariance, &outer(&self.gain(call).iter().map(|row| row[o]).collect::<Vec<_>>()));
                if call < valid {
                    continue;
                }
                let states = product(&product(&self.back, &covariance), &transposed(&self.back));
                still += 1;
                for i in 0..n {
                    let deviation = states[i][i].max(0.0).sqrt();
                    if deviation > worst[i][o] * (1.0 + 1e-9) {
                        worst[i][o] = deviation;
                        still = 0;
                    }
                }
            }
        }
        worst
    }

    fn bound(&self, worst: &Sums, disturbances: &Dense, state: usize) -> Option<f64> {
        let mut bound = 0.0;
        for (o, output) in self.plant.outputs.iter().enumerate() {
            let level = output.noise.as_ref()?.to_f64().ok()?;
            bound += worst.noise[state][o] * level;
            for (s, signal) in self.signals.iter().enumerate() {
                if let Source::Injection(k) = signal.source {
                    bound += worst.signals[state][s] * slope(self.plant, k, o)? * level;
                }
            }
        }
        for (disturbance, gain) in self.plant.disturbances.iter().zip(&disturbances[state]) {
            bound += gain * disturbance.bound.to_f64().ok()?;
        }
        bound.is_finite().then_some(bound)
    }

    /// The schedule that this is of.
    pub fn schedule(&self) -> &Schedule {
        self.schedule
    }
}

/// Sums of magnitudes, per state.
#[derive(Clone, Debug)]
struct Sums {
    /// Per output.
    noise: Dense,
    /// Per disturbance.
    disturbances: Dense,
    /// Per signal.
    signals: Dense,
}

impl Sums {
    fn new(plant: &Plant, signals: usize) -> Self {
        let zeros = |columns: usize| vec![vec![0.0; columns]; plant.states.len()];
        Self {
            noise: zeros(plant.outputs.len()),
            disturbances: zeros(plant.disturbances.len()),
            signals: zeros(signals),
        }
    }

    fn infinite(plant: &Plant, signals: usize) -> Self {
        let mut sums = Self::new(plant, signals);
        sums.parts_mut().into_iter().flatten().flatten().for_each(|entry| *entry = f64::INFINITY);
        sums
    }

    fn parts(&self) -> [&Dense; 3] {
        [&self.noise, &self.disturbances, &self.signals]
    }

    fn parts_mut(&mut self) -> [&mut Dense; 3] {
        [&mut self.noise, &mut self.disturbances, &mut self.signals]
    }

    /// What a transition makes of them at most.
    fn carried(&self, transition: &Dense) -> Self {
        let magnitudes: Dense = transition.iter().map(|row| row.iter().map(|x| x.abs()).collect()).collect();
        let [noise, disturbances, signals] = self.parts().map(|part| product(&magnitudes, part));
        Self { noise, disturbances, signals }
    }

    fn add(&mut self, other: &Self) {
        for (mine, theirs) in self.parts_mut().into_iter().zip(other.parts()) {
            add(mine, theirs);
        }
    }

    /// The larger of both, entry by entry; `more` is added to the other.
    fn raise(&mut self, other: &Self, more: Option<&Self>) {
        let mut other = other.clone();
        if let Some(more) = more {
            other.add(more);
        }
        for (mine, theirs) in self.parts_mut().into_iter().zip(other.parts()) {
            let entries = mine.iter_mut().flatten().zip(theirs.iter().flatten());
            entries.for_each(|(mine, theirs)| *mine = mine.max(*theirs));
        }
    }

    /// Whether an entry is larger, beyond rounding.
    fn exceeds(&self, other: &Self) -> bool {
        let pairs = self.parts().into_iter().zip(other.parts());
        pairs.flat_map(|(a, b)| a.iter().flatten().zip(b.iter().flatten())).any(|(a, b)| *a > *b * (1.0 + 1e-10))
    }

    fn scaled(mut self, factor: f64) -> Self {
        self.parts_mut().into_iter().flatten().flatten().for_each(|entry| *entry *= factor);
        self
    }
}

/// Coordinates in which the size of an error is the root mean square of the outputs over the calls: states from them.
fn size(phi: &Matrix, c: &Matrix, calls: usize) -> Option<Matrix> {
    let p = Precision::bits(512);
    let (phi, mut row) = (phi.with_precision(p), c.with_precision(p));
    let stride = calls.div_ceil(MOST_LOOKS).max(1);
    let far = phi.powi(u64::try_from(stride).ok()?);
    let mut rows = row.clone();
    // The first n calls in any case: fewer would not show every state.
    for _ in 1..phi.rows() {
        row = &row * &phi;
        rows = rows.vcat(&row);
    }
    for _ in (phi.rows()..calls).step_by(stride) {
        row = &row * &far;
        rows = rows.vcat(&row);
    }
    let (_, inverse) = orthonormal(&rows).ok()?;
    let looks = Real::from_i64(i64::try_from(rows.rows()).ok()?, p).checked_sqrt().ok()?;
    Some(inverse.scale(&looks))
}
