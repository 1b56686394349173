//! What an estimate from the samples of a call is worth: up to where it is solved for, and up to where a bound holds.
//!
//! Every answer is a sum over rows, `t' G^-1 q` times what a row showed. With rows in units of noise their errors are at
//! most 1, so that an answer from m rows errs by at most `sqrt(m v)`, `v = t' G^-1 t`, by Cauchy and Schwarz: the step
//! knows both, for whatever samples came. A disturbance shows in the rows too; what least squares over all rows take in of
//! it, they pass on, and what they leave of it, r, is an error of rows as noise is, of which an answer takes at most
//! `|r| sqrt(v)`. So the bound is `sqrt(v) (sqrt(m) + rho)` beside what all rows pass on, rho the sum of all `|r|`.

use crate::numbers::count;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::promise::kernel::{Kernel, slope};
use crate::sampled::Source;
use nalgebra::DMatrix;

use super::super::Functional;
use super::super::certificate::{disturbance_gains, error_bound};
use super::super::solve::Exact;
use super::equations::{Eliminated, There};
use super::{Irregular, limit};

/// Limits on what an estimate is worth. `v` is what a state's variance is of [`Worth::scale`], the largest of all states.
#[derive(Clone, Debug, Default)]
pub struct Worth {
    /// Per state: the square of the bound on `sqrt(v) (sqrt(m) + rho)`; `None` for a state that no sample moves.
    pub scale: Vec<Option<f64>>,
    /// Per state: a power of two near the bound itself, in which the step reckons so that no square leaves the floats.
    pub unit: Vec<f64>,
    /// `v (per_sample m + fixed)` is at most 1 while the bound holds, for m samples.
    pub per_sample: f64,
    /// See there.
    pub fixed: f64,
    /// The largest v of an estimate that is better than the model's prediction.
    pub usual: f64,
    /// The largest v of an estimate at all.
    pub most: f64,
    /// The smallest share of a diagonal that is more than rounding.
    pub tolerance: f64,
}

/// The bound while samples are lost: at least so many times that of the samples that are due.
const LOSSES: f64 = 2.0;
/// And so many times what the step can know of these.
const MARGIN: f64 = 1.5;
/// An estimate with a variance beyond so many times the usual is worse than a prediction of the model.
const WORSE: f64 = 64.0;
/// And beyond so many times that it is none.
const NOTHING: f64 = 1e6;

/// The smallest share of a diagonal that elimination may leave: the rounding of sums is then a ten-thousandth of an answer
/// in single precision, which is a condition of the equations of 1e4, and in double precision one of 1e12.
fn smallest_share(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32 => 1e-4,
        Scalar::F64 => 1e-12,
    }
}

/// The largest power of two that is no larger; of a normal number.
fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits())
}

/// The largest error of a sample in units of its row; `None` where a noise is not declared.
fn unit_of_noise(plant: &Plant, irregular: &Irregular) -> Option<f64> {
    let noise = |(output, trust): (&crate::plant::Output, &crate::sampled::settled::Settled)| {
        Some(output.noise.as_ref()?.to_f64().ok()? * trust.double)
    };
    plant.outputs.iter().zip(&irregular.trust).map(noise).try_fold(0.0_f64, |most, noise| Some(most.max(noise?)))
}

impl Irregular {
    /// Which samples of the pattern are there when those of one output are lost, or of none, at a phase.
    fn due(&self, phase: usize, lost: Option<usize>) -> impl Fn(usize, usize) -> bool + '_ {
        move |age, o| lost != Some(o) && self.pattern.there(phase, age, o)
    }

    /// Equations of the samples of the pattern at every phase, and where they come with ages, of several.
    fn references(&self, lost: Option<usize>) -> Option<Vec<Eliminated>> {
        let half = (self.rows.len() - 1) / 2;
        let now = |_: usize| 0.0;
        let late = |_: usize| 1.0;
        let short = |age: usize| if age < half { 1.0 } else { 0.0 };
        let aged = lost.is_none() && self.ages.iter().any(Option::is_some);
        let shares: Vec<&dyn Fn(usize) -> f64> = if aged { vec![&now, &late, &short] } else { vec![&now] };
        let mut all = Vec::new();
        for phase in self.pattern.phases() {
            for share in &shares {
                all.push(self.eliminated(&There { at: &self.due(phase, lost), share: *share })?);
            }
        }
        Some(all)
    }

    /// The limits, for samples of the pattern; `gaps` says that the times between two may be anything up to its own. And
    /// per state the bound that then holds, in units of the rows.
    pub fn judge(&mut self, plant: &Plant, functional: &Functional, exact: &Exact, gaps: bool) {
        let Some(due) = self.references(None) else { return };
        let asked = self.asked();
        let most = due.iter().map(Eliminated::count).fold(0.0, f64::max);
        let rho = self.leaves(plant, functional, exact).unwrap_or(0.0);
        // (sqrt(m) + rho)^2 <= per_sample m + fixed, with equality for all samples.
        let root = deadbeat_math::sqrt_f64(most);
        let (per_sample, fixed) = (1.0 + rho / root, rho * (rho + root));
        let known = |it: &Eliminated| if gaps { most } else { it.count() };
        let bound = |t: &Vec<f64>| {
            let worst = |of: &dyn Fn(&Eliminated) -> f64| due.iter().map(of).fold(0.0, f64::max);
            let direct = worst(&|it| it.largest(t) + rho * deadbeat_math::sqrt_f64(it.variance(t)));
            let square = worst(&|it| it.variance(t) * (per_sample * known(it) + fixed));
            let bound = (LOSSES * direct * LOSSES * direct).max(MARGIN * MARGIN * square);
            (bound > 0.0).then_some(bound)
        };
        let scale: Vec<Option<f64>> = asked.iter().map(bound).collect();
        let share = |it: &Eliminated| {
            let of = asked.iter().zip(&scale).filter_map(|(t, scale)| Some(it.variance(t) / (*scale)?));
            of.fold(0.0, f64::max)
        };
        let worst = |all: &[Eliminated]| all.iter().map(share).fold(0.0, f64::max);
        let least = due.iter().map(|it| it.tolerance).fold(1.0, f64::min);
        let tolerance = smallest_share(plant.scalar).min(least / 4.0).max(limit(plant));
        let lost = (0..plant.outputs.len()).filter_map(|o| self.references(Some(o)));
        let lost = lost.filter(|all| all.iter().all(|it| it.tolerance > tolerance));
        let usual = WORSE * lost.map(|all| worst(&all)).fold(worst(&due), f64::max);
        let unit = scale.iter().map(|scale| scale.map_or(1.0, |scale| power_of_two(deadbeat_math::sqrt_f64(scale))));
        let unit = unit.collect();
        self.worth = Worth { scale, unit, per_sample, fixed, usual, most: NOTHING * usual, tolerance };
    }

    /// Whether the step solves for the state when one output is lost.
    pub fn determined_without(&self, lost: usize) -> bool {
        let tolerance = self.worth.tolerance;
        self.references(Some(lost)).is_some_and(|all| all.iter().all(|it| it.tolerance > tolerance))
    }

    /// Per state: the largest error of an estimate that is within the limits; `None` where something is unbounded.
    pub fn bound_with_losses(&self, plant: &Plant, functional: &Functional, exact: &Exact) -> Vec<Option<f64>> {
        let disturbed = disturbance_gains(plant, &exact.accumulated);
        let none = vec![0.0; plant.outputs.len()];
        let bound = |i: usize| {
            self.leaves(plant, functional, exact)?;
            let knowns: Vec<f64> = functional.knowns.iter().map(|weights| weights.l1(i)).collect();
            let passed = error_bound(plant, functional, &none, &disturbed[i], &knowns)?;
            let own = deadbeat_math::sqrt_f64(self.worth.scale[i].unwrap_or(0.0));
            Some(passed + own * unit_of_noise(plant, self)?)
        };
        (0..self.phi.len()).map(bound).collect()
    }

    /// What least squares over all rows leave of disturbances, and of noise in nonlinear terms, in units of noise;
    /// `None` where something is unbounded.
    fn leaves(&self, plant: &Plant, functional: &Functional, exact: &Exact) -> Option<f64> {
        let noise = unit_of_noise(plant, self).filter(|noise| *noise > 0.0)?;
        let mut terms = Vec::new();
        for (effect, signal) in exact.model.effects.iter().zip(&functional.signals) {
            let Source::Injection(k) = signal.source else { continue };
            let mut steep = 0.0;
            for (o, output) in plant.outputs.iter().enumerate() {
                steep += slope(plant, k, o)? * output.noise.as_ref()?.to_f64().ok()?;
            }
            if steep > 0.0 {
                terms.push((effect, steep));
            }
        }
        if plant.disturbances.is_empty() && terms.is_empty() {
            return Some(0.0);
        }
        if self.ages.iter().any(Option::is_some) {
            // At other times of samples other shares are left.
            return None;
        }
        let (kernel, n) = (Kernel::new(plant)?, self.phi.len());
        let mut gains = DMatrix::zeros(n, plant.disturbances.len());
        let mut left = 0.0;
        for kicks in self.left_of_kicks() {
            let of = |column: &crate::real::Matrix| {
                kicks.iter().enumerate().map(|(i, size)| size * column.get(i, 0).to_f64().abs()).sum::<f64>()
            };
            kernel.add(&DMatrix::from_fn(n, n, |i, j| if i == j { kicks[i] } else { 0.0 }), &mut gains);
            for (effect, steep) in &terms {
                left += steep * [&effect.at_begin, &effect.at_end].into_iter().flatten().map(of).sum::<f64>();
            }
        }
        for (d, disturbance) in plant.disturbances.iter().enumerate() {
            left += gains.column(d).iter().sum::<f64>() * disturbance.bound.to_f64().ok()?;
        }
        (left / noise).is_finite().then_some(left / noise)
    }

    /// By age of the interval in which it happens, and state: how much of a kick of the state is left in the rows.
    fn left_of_kicks(&self) -> Vec<Vec<f64>> {
        let (n, p, steps) = (self.phi.len(), self.c.len(), self.rows.len() - 1);
        let at = |row: &[Option<crate::sampled::settled::Settled>], j: usize| row[j].map_or(0.0, |entry| entry.double);
        let through = |m: &Vec<Vec<f64>>| -> Vec<Vec<f64>> {
            let entry = |row: &Vec<f64>, j: usize| (0..n).map(|k| row[k] * at(&self.phi[k], j)).sum();
            m.iter().map(|row| (0..n).map(|j| entry(row, j)).collect()).collect()
        };
        // Per row so far: what it shows of a kick just before the newest of them; and the sum of all, by direction.
        let mut shown: Vec<Vec<f64>> = Vec::new();
        let mut taken = vec![vec![0.0; n]; n];
        let mut all = Vec::new();
        for age in 0..steps {
            (shown, taken) = (through(&shown), through(&taken));
            for o in (0..p).filter(|o| self.pattern.shows(age, *o)) {
                let row: Vec<f64> = (0..n).map(|j| self.trust[o].double * at(&self.c[o], j)).collect();
                for (taken, q) in taken.iter_mut().zip(&self.rows[steps - age][o]) {
                    taken.iter_mut().zip(&row).for_each(|(sum, entry)| *sum += q.double * entry);
                }
                shown.push(row);
            }
            let size = |j: usize| {
                let whole: f64 = shown.iter().map(|row| row[j] * row[j]).sum();
                let part: f64 = taken.iter().map(|row| row[j] * row[j]).sum();
                // The difference of two sums in doubles: never less than their rounding.
                deadbeat_math::sqrt_f64((whole - part).max(count(shown.len()) * f64::EPSILON * whole))
            };
            all.push((0..n).map(size).collect());
        }
        all
    }
}
