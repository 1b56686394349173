//! Two copies of the plant that are restarted by turns: a window of N+1 to 2N samples without storing any.
//!
//! Every N calls the copy that has run longer starts again (window-observers, section 3, "ping-pong"). Each
//! gathers a statistic `s = sum R_i v_i` of its innovations from its start; with a the age of its start,
//!
//! `x_k = xc_k + D_a v_k + C_a s`, a = N … 2N-1,
//!
//! is the functional of the window that begins there. Nothing is subtracted that was added before. A copy
//! starts at zero, not at the estimate: what a copy knows is then a function of its own samples alone, and an
//! outlier leaves nothing behind when its copies have started again. What stands against it is that a copy of
//! an unstable plant grows for 2N calls (round-off of eps e^(2 lambda tau)); the bound counts that, and refuses.

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, Singular};

use super::super::Functional;
use super::super::solve::Exact;
use super::ages::AtAge;
use super::basis::{Basis, kept};
use super::copy::{self, Copy};
use super::form::{Form, rows};
use super::tables::{ByPlace, Groups, Rounded};
use super::{Depth, Load, Refusal, VERDICT_BITS};
use crate::numbers::count;
use crate::sampled::model::Model;

/// The most operations of the certificate over all ages, a few seconds.
const MOST_WORK: usize = 600_000_000;

/// A ping-pong realisation with settled constants.
#[derive(Clone, Debug)]
pub struct PingPong {
    /// N: a copy is used from this age on, and for as many calls.
    pub steps: usize,
    /// The copy, with the plant's constant terms.
    pub copy: Copy,
    /// R while a copy fills, by place from its start, f x p.
    pub filling: ByPlace,
    /// R while it is used, by place less N.
    pub using: ByPlace,
    /// C by age less N, n x f.
    pub read: ByPlace,
    /// D by age less N, n x p.
    pub direct: ByPlace,
    /// What it costs and how well it computes.
    pub load: Load,
}

impl PingPong {
    /// Designs two copies for a functional.
    ///
    /// # Errors
    /// Why it cannot be.
    pub fn new(
        plant: &Plant,
        functional: &Functional,
        exact: &Exact,
        form: &dyn Form,
        depth: Depth,
    ) -> Result<Self, Refusal> {
        let (n, p, s) = (exact.model.phi.rows(), exact.model.c.rows(), functional.signals.len());
        let steps = functional.steps;
        if steps * steps * 2 * n * n * (n + p + s) > MOST_WORK {
            let why = format!("{steps} ages of {n} states are more than tables by age are designed for");
            return Err(Refusal::measured(why, count(steps)));
        }
        let model = Model::new(plant, &functional.signals, Precision::bits(VERDICT_BITS)).map_err(Refusal::Broken)?;
        let dynamics = form.dynamics(&model)?;
        let stay = kept(&rows(&dynamics, 2 * steps));
        let f = stay.len();
        let run = |precision: Precision| -> Result<Vec<Vec<Real>>, Vec<Diagnostic>> {
            let model = Model::new(plant, &functional.signals, precision)?;
            let broken = |error: Singular| vec![super::singular(plant, error)];
            let dynamics = form.dynamics(&model).map_err(broken)?;
            let raw = rows(&dynamics, 2 * steps);
            let basis = Basis::new(&raw, &stay).ok_or_else(|| broken(Singular { column: 0 }))?;
            let rows: Vec<Matrix> = raw.iter().map(|row| basis.row(row)).collect();
            let reads = form.read_outs(&model, steps..2 * steps).map_err(broken)?;
            let mut groups = Groups::default();
            copy::add(&mut groups, &model, &dynamics, true);
            groups.by_place(&rows[..steps]);
            groups.by_place(&rows[steps..]);
            groups.by_place(&reads.iter().map(|read| basis.read(&read.read)).collect::<Vec<_>>());
            groups.by_place(&reads.iter().map(|read| read.direct.clone()).collect::<Vec<_>>());
            Ok(groups.0)
        };
        let bits = exact.model.phi.precision();
        let mut rounded = Rounded(depth.round(plant, bits, &run)?.into_iter());
        let copy = Copy::take(&mut rounded, (n, p, s));
        let (filling, using) = (rounded.by_place(f, p), rounded.by_place(f, p));
        let (read, direct) = (rounded.by_place(n, f), rounded.by_place(n, p));
        let mut pair = Self { steps, copy, filling, using, read, direct, load: Load::default() };
        let ages: Vec<usize> = match depth {
            Depth::Look => (0..=4).map(|quarter| steps + (steps - 1) * quarter / 4).collect(),
            Depth::Settle => (steps..2 * steps).collect(),
        };
        pair.load = pair.weigh(plant, functional, exact, &ages);
        Ok(pair)
    }

    /// R at a place from a copy's start.
    pub fn row(&self, place: usize) -> Vec<Vec<f64>> {
        match place.checked_sub(self.steps) {
            Some(place) => self.using.at(place),
            None => self.filling.at(place),
        }
    }

    /// The most that this computes with, and what rounding may do to it, for samples of magnitude 1.
    fn weigh(&self, plant: &Plant, functional: &Functional, exact: &Exact, ages: &[usize]) -> Load {
        let (n, f, p) = (plant.states.len(), self.read.0.first().map_or(0, Vec::len), plant.outputs.len());
        let sizes = self.copy.sizes(2 * self.steps);
        let seen = self.copy.seen.magnitudes();
        let innovations: Vec<Vec<f64>> =
            sizes.iter().map(|(used, _)| (0..p).map(|o| 1.0 + dot(&seen[o], used)).collect()).collect();
        let terms: Vec<Vec<f64>> = sizes.iter().map(|(used, handed)| self.copy.terms(used, handed)).collect();
        // The statistics by call since the start, in magnitude.
        let mut statistics = vec![vec![0.0; f]];
        for (place, innovation) in innovations.iter().enumerate() {
            let row = self.row(place);
            let before = &statistics[place];
            statistics.push(
                (0..f)
                    .map(|k| before[k] + row[k].iter().zip(innovation).map(|(r, v)| r.abs() * v).sum::<f64>())
                    .collect(),
            );
        }
        let unit = crate::promise::rounding::unit(plant.scalar);
        let copied = self.copy.roundings();
        let mut load = Load { gain: 1.0, round_off: vec![0.0; n], ..Load::default() };
        for age in ages {
            let at = AtAge::new(self, functional, &exact.model.c, *age);
            let read = self.read.at(age - self.steps);
            for i in 0..n {
                let summed: f64 = (0..f).map(|k| read[i][k].abs() * statistics[age + 1][k]).sum();
                let now = sizes[*age].0[i]
                    + self.direct.at(age - self.steps)[i]
                        .iter()
                        .zip(&innovations[*age])
                        .map(|(d, v)| d.abs() * v)
                        .sum::<f64>();
                let disturbed: f64 = at
                    .accumulated
                    .iter()
                    .enumerate()
                    .map(|(t, acc)| acc[i].iter().zip(&terms[age - t]).map(|(a, x)| a.abs() * x).sum::<f64>())
                    .sum();
                let shown: f64 = at
                    .innovations
                    .iter()
                    .enumerate()
                    .map(|(t, v)| v[i].iter().zip(&innovations[age - t]).map(|(a, x)| a.abs() * x).sum::<f64>())
                    .sum();
                // Each product of a statistic is rounded with its weight, and once in each later addition.
                let chain = count((age + 1) * p + f + p + 6);
                let round_off = chain * summed
                    + count(f + p + 4) * now
                    + copied * (disturbed + terms[*age][i])
                    + count(n + 2) * shown;
                load.round_off[i] = load.round_off[i].max(unit * round_off);
                load.gain = load.gain.max(summed + now);
            }
        }
        let cells = terms.iter().chain(&innovations).chain(&statistics).flatten();
        load.gain = cells.fold(load.gain, |a, b| a.max(*b));
        let present = |table: &ByPlace| table.present().len();
        let live = self.copy.live.iter().filter(|live| **live).count();
        load.words = 2 * (live + f) + functional.signals.len() + 2 * p + 5;
        load.constants =
            self.steps * [&self.filling, &self.using, &self.read, &self.direct].into_iter().map(present).sum::<usize>();
        load.flops = 2 * (self.copy.flops() + p)
            + 2 * [&self.filling, &self.using, &self.read, &self.direct].into_iter().map(present).sum::<usize>()
            + n;
        load
    }

    /// All numbers, in columns of one unit.
    pub fn columns(&self) -> Vec<Vec<crate::sampled::settled::Settled>> {
        let tables = [&self.filling, &self.using, &self.read, &self.direct];
        let tables = tables.into_iter().flat_map(ByPlace::columns).cloned();
        tables.chain(self.copy.numbers().map(|x| vec![x])).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
