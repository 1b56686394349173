//! Two levels: statistics of whole blocks, and the oldest, partly left block sample by sample.
//!
//! The window is cut at fixed calls into blocks of b samples (window-observers, section 3, "two-level"). Each
//! block runs a copy of the plant that starts at zero with the block, gathers its innovations into a statistic
//! `s = sum R_i v_i`, and leaves s and what its copy hands to the next block, h. With a the age of a block's
//! first sample,
//!
//! `x_k = c + xc_k + D v_k + C_pos s_newest + sum_whole (C_a s + acc_(a-b+1) h) + sum_oldest (K_j y + M_j w)`.
//!
//! Nothing lives longer than its block, so that no unstable mode is met for more than b samples, and every
//! call does the same operations.

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Singular};

use super::super::Functional;
use super::super::solve::Exact;
use super::basis::{Basis, kept};
use super::copy::{self, Copy};
use super::form::{Form, rows};
use super::tables::{ByPlace, Entries, Groups, Rounded};
use super::{Depth, Load, Refusal, VERDICT_BITS};
use crate::numbers::count;
use crate::sampled::model::Model;

/// A two-level realisation with settled constants.
#[derive(Clone, Debug)]
pub struct TwoLevel {
    /// Where the window is cut.
    pub cut: Cut,
    /// The copy of a block, without the plant's constant terms.
    pub copy: Copy,
    /// D, n x p.
    pub direct: Entries,
    /// R by place in the block, f x p.
    pub rows: ByPlace,
    /// C by age of a block's first sample, n x f.
    pub read: ByPlace,
    /// acc by age of a block's first sample less b, n x n.
    pub handed: ByPlace,
    /// What it costs and how well it computes.
    pub load: Load,
}

/// Where a window of N+1 samples is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// b.
    pub block: usize,
    /// Whole blocks besides the newest, which may be partial.
    pub whole: usize,
    /// Ages from the end of the last whole block, at its newest, to the window's end.
    pub tail: usize,
}

impl Cut {
    /// Blocks of b samples. The oldest whole block begins inside the window, so that what was known before
    /// the window's first sample has no weight at all.
    fn new(steps: usize, block: usize) -> Option<Self> {
        let whole = (steps / block).checked_sub(1).filter(|whole| *whole > 0)?;
        Some(Self { block, whole, tail: steps - block * whole })
    }

    /// Ages of a block's first sample that a call may meet.
    fn ages(self) -> usize {
        self.block * (self.whole + 1)
    }
}

/// Additions and multiplications of the estimate: whole blocks and the oldest one.
fn work(cut: Cut, (n, f, live): (usize, usize, usize), signals: usize) -> usize {
    2 * n * (cut.whole * (f + live) + cut.tail * signals)
}

/// The cheapest cut whose blocks show every state.
fn best(steps: usize, sizes: (usize, usize, usize), signals: usize) -> Option<Cut> {
    let shortest = 2 * sizes.1.max(2);
    let cuts = (shortest..=steps / 2).filter_map(|block| Cut::new(steps, block));
    cuts.min_by_key(|cut| work(*cut, sizes, signals))
}

/// The constants at a precision.
struct Constants {
    direct: Matrix,
    rows: Vec<Matrix>,
    read: Vec<Matrix>,
    handed: Vec<Matrix>,
}

fn constants(
    model: &Model,
    form: &dyn Form,
    steps: usize,
    cut: Cut,
    stay: &[(usize, i64)],
) -> Result<Constants, Singular> {
    let dynamics = form.dynamics(model)?;
    let raw = rows(&dynamics, cut.block);
    let basis = Basis::new(&raw, stay).ok_or(Singular { column: 0 })?;
    let last = form.read_outs(model, steps..steps + 1)?.remove(0);
    // P F^a for a = N, N-1, … by F^-1.
    let mut reads = vec![last.read];
    for _ in 0..steps {
        reads.push(&reads[reads.len() - 1] * &dynamics.back);
    }
    reads.reverse();
    // acc_1 = I - V_0 C, acc_(i+1) = acc_i (Phi - L C) - V_i C with V_i = P F^i G.
    let weight = |age: usize| &reads[age] * &dynamics.input;
    let mut at =
        &Matrix::identity(model.phi.rows(), model.phi.precision()) - &(&(&last.direct + &weight(0)) * &model.c);
    let mut handed = Vec::new();
    for age in 1..=cut.block * cut.whole {
        let next = &(&at * &dynamics.copy) - &(&weight(age) * &model.c);
        handed.push(std::mem::replace(&mut at, next));
    }
    let rows = raw.iter().map(|row| basis.row(row)).collect();
    let read = reads[..cut.ages()].iter().map(|read| basis.read(read)).collect();
    Ok(Constants { direct: last.direct, rows, read, handed })
}

impl TwoLevel {
    /// Designs blocks for a functional.
    ///
    /// # Errors
    /// Why it cannot be: the window is too short, a block does not show every state, constants do not settle.
    pub fn new(
        plant: &Plant,
        functional: &Functional,
        exact: &Exact,
        form: &dyn Form,
        depth: Depth,
    ) -> Result<Self, Refusal> {
        let (n, p, s) = (exact.model.phi.rows(), exact.model.c.rows(), functional.signals.len());
        let model = Model::new(plant, &functional.signals, Precision::bits(VERDICT_BITS)).map_err(Refusal::Broken)?;
        let dynamics = form.dynamics(&model)?;
        let live = if s > 0 || !dynamics.inject.is_zero() { n } else { 0 };
        let cut = best(functional.steps, (n, dynamics.input.rows(), live), p + s)
            .ok_or_else(|| Refusal::because(format!("{} samples are too few for two blocks", functional.steps + 1)))?;
        let stay = kept(&rows(&dynamics, cut.block));
        let f = stay.len();
        let run = |precision: Precision| -> Result<Vec<Vec<crate::real::Real>>, Vec<Diagnostic>> {
            let model = Model::new(plant, &functional.signals, precision)?;
            let broken = |error: Singular| vec![super::singular(plant, error)];
            let dynamics = form.dynamics(&model).map_err(broken)?;
            let constants = constants(&model, form, functional.steps, cut, &stay).map_err(broken)?;
            let mut groups = Groups::default();
            copy::add(&mut groups, &model, &dynamics, false);
            groups.entries(&constants.direct);
            groups.by_place(&constants.rows);
            groups.by_place(&constants.read);
            groups.by_place(&constants.handed);
            Ok(groups.0)
        };
        let bits = exact.model.phi.precision();
        let mut rounded = Rounded(depth.round(plant, bits, &run)?.into_iter());
        let copy = Copy::take(&mut rounded, (n, p, s));
        let direct = rounded.entries(n, p);
        let (rows, read) = (rounded.by_place(f, p), rounded.by_place(n, f));
        let mut handed = rounded.by_place(n, n);
        for row in &mut handed.0 {
            // What never leaves zero is handed to nobody.
            row.iter_mut().zip(&copy.live).filter(|(_, live)| !**live).for_each(|(column, _)| *column = None);
        }
        let mut two = Self { cut, copy, direct, rows, read, handed, load: Load::default() };
        two.load = two.weigh(plant, functional, exact);
        Ok(two)
    }

    /// The most that this computes with, and what rounding may do to it, for samples of magnitude 1.
    fn weigh(&self, plant: &Plant, functional: &Functional, exact: &Exact) -> Load {
        let Cut { block, whole, tail } = self.cut;
        let (n, f, p) = (plant.states.len(), self.rows.0.len(), plant.outputs.len());
        let sizes = self.copy.sizes(block);
        let (used, handed) = sizes.last().cloned().unwrap_or_default();
        let seen = self.copy.seen.magnitudes();
        let innovation = |o: usize| 1.0 + seen[o].iter().zip(&used).map(|(c, x)| c * x).sum::<f64>();
        let innovations: Vec<f64> = (0..p).map(innovation).collect();
        let statistic = |k: usize| -> f64 {
            (0..block).map(|i| (0..p).map(|o| self.rows.magnitude(k, o, i) * innovations[o]).sum::<f64>()).sum()
        };
        let statistics: Vec<f64> = (0..f).map(statistic).collect();
        let signals = p + functional.signals.len();

        // By state: what the read-outs of all blocks add up to at a place of the newest one, at most.
        let blocks = |i: usize, place: usize| -> (f64, f64) {
            let read = |age: usize| (0..f).map(|k| self.read.magnitude(i, k, age) * statistics[k]).sum::<f64>();
            let pass = |age: usize| (0..n).map(|j| self.handed.magnitude(i, j, age - block) * handed[j]).sum::<f64>();
            let ages = (1..=whole).map(|q| place + q * block);
            (read(place) + ages.clone().map(read).sum::<f64>(), ages.map(pass).sum())
        };
        let largest = |i: usize| {
            (0..block).map(|place| blocks(i, place)).fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)))
        };
        let oldest = |i: usize| -> f64 {
            let ages = functional.steps + 1 - tail..=functional.steps;
            let weights = functional.outputs.iter().chain(&functional.knowns);
            weights.map(|w| ages.clone().map(|age| w.at(i, age).double.abs()).sum::<f64>()).sum()
        };
        let direct = self.direct.magnitudes();
        let unit = crate::promise::rounding::unit(plant.scalar);
        // Each term of a sum is rounded with its weight, with its product, and once in each later addition.
        let chain = count(2 + whole * (f + n) + tail * signals + 4);
        let within = count(block * p + 3) + chain;
        let of_copy = self.copy.terms(&used, &handed);
        let copied = self.copy.roundings();
        let mut load = Load { gain: 1.0, round_off: Vec::new(), ..Load::default() };
        for i in 0..n {
            let (read, passed) = largest(i);
            let tail = oldest(i);
            let now = used[i] + (0..p).map(|o| direct[i][o] * innovations[o]).sum::<f64>();
            let constant = functional.constant[i].double.abs();
            let sum = read + passed + tail + now + constant;
            // A rounding of the copy is a disturbance of the state; one of an innovation counts by its weight.
            let disturbed: f64 = exact
                .accumulated
                .iter()
                .map(|acc| (0..n).map(|j| acc.get(i, j).abs().to_f64() * of_copy[j]).sum::<f64>())
                .sum::<f64>()
                + of_copy[i];
            let shown: f64 = (0..p)
                .map(|o| {
                    let weight = functional.outputs[o].l1(i) + direct[i][o];
                    weight * innovations[o]
                })
                .sum();
            let round_off =
                within * read + chain * (passed + tail + now + constant) + copied * disturbed + count(n + 2) * shown;
            load.round_off.push(unit * round_off);
            load.gain = load.gain.max(sum);
        }
        let cells = [&used, &handed, &of_copy, &innovations, &statistics];
        load.gain = cells.into_iter().flatten().fold(load.gain, |a, b| a.max(*b));
        let live = self.copy.live.iter().filter(|live| **live).count();
        let signals_kept = signals * (functional.steps + 1);
        load.words = signals_kept + (whole + 1) * (f + live) + 3;
        let present = |table: &ByPlace| table.present().len();
        load.constants = block * (present(&self.rows) + present(&self.read))
            + whole * block * (present(&self.read) + present(&self.handed))
            + tail * functional.pairs();
        load.flops = self.copy.flops()
            + p
            + 2 * (present(&self.rows) + present(&self.read) + self.direct.numbers().count())
            + 2 * whole * (present(&self.read) + present(&self.handed))
            + 2 * tail * functional.pairs()
            + 2 * n;
        load
    }

    /// All numbers, in columns of one unit.
    pub fn columns(&self) -> Vec<Vec<crate::sampled::settled::Settled>> {
        let tables = [&self.rows, &self.read, &self.handed].into_iter().flat_map(ByPlace::columns).cloned();
        tables.chain(self.copy.numbers().chain(self.direct.numbers()).map(|x| vec![x])).collect()
    }
}
