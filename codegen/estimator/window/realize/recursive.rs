//! A filter with one delayed innovation: `f_k = F f_(k-1) + G v_k - F^(N+1) G v_(k-N-1)`.
//!
//! `x_k = xc_k + D v_k + P f_k` (000 (13) with `psi_1` and `psi_2` as modes of F). What is added to f is subtracted N+1
//! calls later, after the filter's own arithmetic: whatever rounding leaves of it stays in f and must die out by
//! itself. So every mode of F has to decay, and so has every mode of the copy, or two copies take turns: each
//! starts at zero, with its filter and its innovations, and is used once its window is full.

use nalgebra::{DMatrix, Schur};

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, Singular, inverse};

use super::super::Functional;
use super::super::solve::Exact;
use super::copy::{self, Copy};
use super::form::Form;
use super::tables::{Entries, Groups, Rounded};
use super::{Depth, Load, Refusal, VERDICT_BITS};
use crate::numbers::count;
use crate::sampled::model::Model;

/// The largest radius of a mode: rounding adds up to at most 1000 roundings, and an outlier's rounding falls to
/// 1/e in at most 1000 calls (window-observers, section 3: rho <= 1 - 1e-3).
const LARGEST_RADIUS: f64 = 1.0 - 1e-3;
/// Calls after which what decays by that radius is a millionth, a billionth, nothing.
const HORIZON: usize = 20_000;
/// Sweeps of the QR algorithm before it is given up.
const SWEEPS: usize = 10_000;

/// A recursive realisation with settled constants.
#[derive(Clone, Debug)]
pub struct Recursive {
    /// N.
    pub steps: usize,
    /// Whether two copies take turns.
    pub turns: bool,
    /// The copy, with the plant's constant terms.
    pub copy: Copy,
    /// D, n x p.
    pub direct: Entries,
    /// F, f x f.
    pub filter: Entries,
    /// G, f x p.
    pub input: Entries,
    /// `F^(N+1) G`, f x p.
    pub delayed: Entries,
    /// P, n x f.
    pub output: Entries,
    /// The largest radius of a mode of F.
    pub radius: f64,
    /// What it costs and how well it computes.
    pub load: Load,
}

/// The constants at a precision.
struct Constants {
    direct: Matrix,
    filter: Matrix,
    delayed: Matrix,
    output: Matrix,
}

fn constants(model: &Model, form: &dyn Form, steps: usize) -> Result<Constants, Singular> {
    let dynamics = form.dynamics(model)?;
    let last = form.read_outs(model, steps..steps + 1)?.remove(0);
    let filter = inverse(&dynamics.back)?;
    let delayed = &filter.powi(steps as u64 + 1) * &dynamics.input;
    Ok(Constants { direct: last.direct, output: &last.read * &dynamics.back.powi(steps as u64), filter, delayed })
}

impl Recursive {
    /// Designs the filter for a functional.
    ///
    /// # Errors
    /// Why it cannot be: a mode of F that does not decay, with the number.
    pub fn new(
        plant: &Plant,
        functional: &Functional,
        exact: &Exact,
        form: &dyn Form,
        depth: Depth,
    ) -> Result<Self, Refusal> {
        let (n, p, s) = (exact.model.phi.rows(), exact.model.c.rows(), functional.signals.len());
        let steps = functional.steps;
        let model = Model::new(plant, &functional.signals, Precision::bits(VERDICT_BITS)).map_err(Refusal::Broken)?;
        let dynamics = form.dynamics(&model)?;
        let radius = radius(&inverse(&dynamics.back)?);
        let of_copy = self::radius(&dynamics.copy);
        if radius.is_none_or(|radius| radius > LARGEST_RADIUS) {
            return Err(grows(plant, radius, form.runs_backwards()));
        }
        let f = dynamics.input.rows();
        let run = |precision: Precision| -> Result<Vec<Vec<Real>>, Vec<Diagnostic>> {
            let model = Model::new(plant, &functional.signals, precision)?;
            let broken = |error: Singular| vec![super::singular(plant, error)];
            let dynamics = form.dynamics(&model).map_err(broken)?;
            let constants = constants(&model, form, steps).map_err(broken)?;
            let mut groups = Groups::default();
            copy::add(&mut groups, &model, &dynamics, true);
            groups.entries(&constants.direct);
            groups.entries(&constants.filter);
            groups.entries(&dynamics.input);
            groups.entries(&constants.delayed);
            groups.entries(&constants.output);
            Ok(groups.0)
        };
        let bits = exact.model.phi.precision();
        let mut rounded = Rounded(depth.round(plant, bits, &run)?.into_iter());
        let mut filter = Self {
            steps,
            turns: of_copy.is_none_or(|radius| radius > LARGEST_RADIUS),
            copy: Copy::take(&mut rounded, (n, p, s)),
            direct: rounded.entries(n, p),
            filter: rounded.entries(f, f),
            input: rounded.entries(f, p),
            delayed: rounded.entries(f, p),
            output: rounded.entries(n, f),
            radius: radius.unwrap_or(0.0),
            load: Load::default(),
        };
        filter.load = filter.weigh(plant, functional, exact);
        Ok(filter)
    }

    /// The most that this computes with, and what rounding may do to it, for samples of magnitude 1.
    fn weigh(&self, plant: &Plant, functional: &Functional, exact: &Exact) -> Load {
        let (n, f, p) = (plant.states.len(), self.filter.0.len(), plant.outputs.len());
        let life = if self.turns { 2 * self.steps } else { HORIZON };
        let sizes = self.copy.sizes(life).pop().unwrap_or_default();
        let (used, handed) = (&sizes.0, &sizes.1);
        let terms = self.copy.terms(used, handed);
        let seen = self.copy.seen.magnitudes();
        let innovation = |o: usize| 1.0 + seen[o].iter().zip(used).map(|(c, x)| c * x).sum::<f64>();
        let innovations: Vec<f64> = (0..p).map(innovation).collect();
        // f holds at most N+1 innovations; while it starts, a delayed one may be subtracted that it never had.
        let gathered = self.responses(&self.input.to_f64(), &innovations, self.steps + 1);
        let foreign = self.responses(&self.delayed.to_f64(), &innovations, self.steps + 1);
        let state: Vec<f64> = gathered.iter().zip(&foreign).map(|(a, b)| a + b).collect();
        let magnitude = |m: &Entries, i: usize, v: &[f64]| -> f64 {
            m.0[i].iter().zip(v).map(|(x, v)| x.map_or(0.0, |x| x.double.abs()) * v).sum()
        };
        let added: Vec<f64> = (0..f)
            .map(|k| {
                let old = magnitude(&self.filter, k, &gathered);
                old + magnitude(&self.input, k, &innovations) + magnitude(&self.delayed, k, &innovations)
            })
            .collect();
        // What a rounding of f leaves in the estimate, over its whole life.
        let echoes = self.echoes();
        let unit = crate::promise::rounding::unit(plant.scalar);
        let mut load = Load { gain: 1.0, round_off: Vec::new(), ..Load::default() };
        for i in 0..n {
            let echo: f64 = echoes[i].iter().zip(&added).map(|(e, x)| e * x).sum();
            let read = magnitude(&self.output, i, &gathered);
            let direct = magnitude(&self.direct, i, &innovations);
            let disturbed: f64 = exact
                .accumulated
                .iter()
                .map(|acc| (0..n).map(|j| acc.get(i, j).abs().to_f64() * terms[j]).sum::<f64>())
                .sum();
            let shown: f64 = (0..p).map(|o| innovations[o] * self.weight_of_innovation(i, o)).sum();
            load.round_off.push(
                unit * (count(f + 2 * p + 4) * echo
                    + count(f + p + 4) * (read + direct + used[i])
                    + self.copy.roundings() * (disturbed + terms[i])
                    + count(n + 2) * shown),
            );
            load.gain = load.gain.max(magnitude(&self.output, i, &state) + direct + used[i]);
        }
        let cells = [&terms, used, handed, &innovations, &state];
        load.gain = cells.into_iter().flatten().chain(&added).fold(load.gain, |a, b| a.max(*b));
        let live = self.copy.live.iter().filter(|live| **live).count();
        let copies = if self.turns { 2 } else { 1 };
        load.words = copies * (live + f + p * (self.steps + 1)) + functional.signals.len() + 2 * p + 3 + copies;
        let numbers = |m: &Entries| m.numbers().count();
        let filter = numbers(&self.filter) + numbers(&self.input) + numbers(&self.delayed);
        load.flops =
            copies * (self.copy.flops() + p + 2 * filter) + 2 * (numbers(&self.direct) + numbers(&self.output));
        load
    }

    /// Sums of `|F^i B| v` over so many calls.
    fn responses(&self, input: &[Vec<f64>], v: &[f64], calls: usize) -> Vec<f64> {
        let filter = self.filter.to_f64();
        let f = filter.len();
        let mut columns: Vec<Vec<f64>> = (0..v.len()).map(|o| input.iter().map(|row| row[o]).collect()).collect();
        let mut sums = vec![0.0; f];
        for _ in 0..calls {
            for (column, v) in columns.iter_mut().zip(v) {
                sums.iter_mut().zip(column.iter()).for_each(|(sum, x)| *sum += x.abs() * v);
                *column = filter.iter().map(|row| row.iter().zip(column.iter()).map(|(a, x)| a * x).sum()).collect();
            }
        }
        sums
    }

    /// Per state and component: the sum of `|P F^i|` over i.
    fn echoes(&self) -> Vec<Vec<f64>> {
        let (filter, output) = (self.filter.to_f64(), self.output.to_f64());
        let f = filter.len();
        let mut rows = output;
        let mut sums = vec![vec![0.0; f]; rows.len()];
        for _ in 0..HORIZON {
            for (sums, row) in sums.iter_mut().zip(&mut rows) {
                sums.iter_mut().zip(row.iter()).for_each(|(sum, x)| *sum += x.abs());
                *row = (0..f).map(|k| row.iter().zip(&filter).map(|(x, filter)| x * filter[k]).sum()).collect();
            }
        }
        sums
    }

    /// The sum of the magnitudes of the innovations' weights in the window.
    fn weight_of_innovation(&self, state: usize, output: usize) -> f64 {
        let filter = self.filter.to_f64();
        let row: Vec<f64> = self.output.0[state].iter().map(|x| x.map_or(0.0, |x| x.double)).collect();
        let mut column: Vec<f64> = self.input.to_f64().iter().map(|row| row[output]).collect();
        let mut sum = self.direct.0[state][output].map_or(0.0, |d| d.double.abs());
        for _ in 0..=self.steps {
            sum += row.iter().zip(&column).map(|(a, b)| a * b).sum::<f64>().abs();
            column = filter.iter().map(|row| row.iter().zip(&column).map(|(a, x)| a * x).sum()).collect();
        }
        sum
    }

    /// All numbers, in columns of one unit.
    pub fn columns(&self) -> Vec<Vec<crate::sampled::settled::Settled>> {
        let all = [&self.direct, &self.filter, &self.input, &self.output].into_iter().flat_map(Entries::numbers);
        all.chain(self.copy.numbers()).map(|x| vec![x]).collect()
    }
}

/// The largest magnitude of an eigenvalue; `None` when the QR algorithm does not settle.
fn radius(matrix: &Matrix) -> Option<f64> {
    let rows = matrix.to_f64();
    let dense = DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]);
    if dense.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let schur = Schur::try_new(dense, f64::EPSILON, SWEEPS)?;
    let sizes = schur.complex_eigenvalues();
    Some(sizes.iter().map(|z| deadbeat_math::sqrt_f64(z.re * z.re + z.im * z.im)).fold(0.0, f64::max))
}

fn grows(plant: &Plant, radius: Option<f64>, backwards: bool) -> Refusal {
    let Some(radius) = radius else {
        return Refusal::because("the modes of its filter cannot be found".into());
    };
    let filter = if backwards { "its filter runs the plant backwards and has" } else { "its filter has" };
    if plant.discrete {
        let why = format!("{filter} a mode of radius {radius:.4}; up to {LARGEST_RADIUS} dies out");
        return Refusal::measured(why, radius);
    }
    let rate = |radius: f64| deadbeat_math::log_f64(radius) / plant.sample_time_s();
    let (own, most) = (rate(radius), rate(LARGEST_RADIUS));
    Refusal::measured(format!("{filter} a mode of {own:+.1} 1/s; below {most:.2} 1/s it dies out"), own)
}
