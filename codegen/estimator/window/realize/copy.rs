//! The copy of the plant that a realisation runs: `xc+ = (Phi - L C) xc + L y + (what is known)`.
//!
//! What a call hands to the next is the copy as far as it is known then; the next call adds the share of the
//! values that it brings. So neither samples nor inputs of the call before have to be kept.

use crate::real::Matrix;

use super::form::Dynamics;
use super::tables::{Entries, Groups, Rounded};
use crate::sampled::model::Model;

/// A copy with settled constants.
#[derive(Clone, Debug)]
pub struct Copy {
    /// `Phi - L C`, n x n.
    pub step: Entries,
    /// L, n x p.
    pub inject: Entries,
    /// Times a signal's value at the interval's beginning, n x signals.
    pub begin: Entries,
    /// Times its value at the end, n x signals.
    pub end: Entries,
    /// C, p x n.
    pub seen: Entries,
    /// n x 1: the constant terms, where the copy carries them.
    pub constant: Entries,
    /// States that anything drives; the others stay zero when the copy starts at zero.
    pub live: Vec<bool>,
}

/// Adds a copy's constants.
pub fn add(groups: &mut Groups, model: &Model, dynamics: &Dynamics, constant: bool) {
    groups.entries(&dynamics.copy);
    groups.entries(&dynamics.inject);
    groups.entries(&effects(model, |effect| effect.at_begin.as_ref()));
    groups.entries(&effects(model, |effect| effect.at_end.as_ref()));
    groups.entries(&model.c);
    let none = Matrix::zeros(model.phi.rows(), 1, model.phi.precision());
    groups.entries(if constant { &model.constant } else { &none });
}

fn effects(model: &Model, part: impl Fn(&crate::sampled::model::Effect) -> Option<&Matrix>) -> Matrix {
    let (n, p) = (model.phi.rows(), model.phi.precision());
    let zero = Matrix::zeros(n, 1, p);
    let columns: Vec<&Matrix> = model.effects.iter().map(|effect| part(effect).unwrap_or(&zero)).collect();
    Matrix::from_fn(n, columns.len(), |i, s| columns[s].get(i, 0).clone())
}

impl Copy {
    /// Takes back what [`add`] added, for n states, p outputs and s signals.
    pub fn take(rounded: &mut Rounded, (n, p, s): (usize, usize, usize)) -> Self {
        let mut copy = Self {
            step: rounded.entries(n, n),
            inject: rounded.entries(n, p),
            begin: rounded.entries(n, s),
            end: rounded.entries(n, s),
            seen: rounded.entries(p, n),
            constant: rounded.entries(n, 1),
            live: vec![false; n],
        };
        copy.live = copy.driven();
        copy
    }

    /// What inputs, constants or the injection reach, and whatever follows from there.
    fn driven(&self) -> Vec<bool> {
        let any = |entries: &Entries, i: usize| entries.0[i].iter().any(Option::is_some);
        let drives = [&self.inject, &self.begin, &self.end, &self.constant];
        let mut live: Vec<bool> = (0..self.step.0.len()).map(|i| drives.iter().any(|d| any(d, i))).collect();
        for _ in 0..live.len() {
            let before = live.clone();
            for (i, row) in self.step.0.iter().enumerate() {
                live[i] |= row.iter().zip(&before).any(|(x, driven)| *driven && x.is_some());
            }
        }
        live
    }

    /// Per call since the copy started at zero: the largest magnitude of each state, when it is used and when
    /// it is handed on, for samples and signals of magnitude 1.
    pub fn sizes(&self, calls: usize) -> Vec<(Vec<f64>, Vec<f64>)> {
        let step = self.step.to_f64();
        let (n, p, s) = (step.len(), self.inject.0.first().map_or(0, Vec::len), self.end.0.first().map_or(0, Vec::len));
        let (inject, begin, end, constant) =
            (self.inject.to_f64(), self.begin.to_f64(), self.end.to_f64(), self.constant.to_f64());
        // Response to one unit of each source at one call, to be summed in magnitude over the calls.
        let mut sources: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
        let column = |m: &[Vec<f64>], j: usize| -> Vec<f64> { m.iter().map(|row| row[j]).collect() };
        (0..p).for_each(|o| sources.push((vec![0.0; n], column(&inject, o))));
        (0..s).for_each(|j| sources.push((column(&end, j), column(&begin, j))));
        sources.push((vec![0.0; n], column(&constant, 0)));
        let (mut used, mut handed) = (vec![0.0; n], vec![0.0; n]);
        let mut sizes = Vec::new();
        for call in 0..calls {
            let mut carried = Vec::new();
            for (now, later) in &mut sources {
                let after: Vec<f64> = (0..n)
                    .map(|i| {
                        let moved: f64 = step[i].iter().zip(now.iter()).map(|(a, x)| a * x).sum();
                        if call == 0 { moved + later[i] } else { moved }
                    })
                    .collect();
                used.iter_mut().zip(now.iter()).for_each(|(sum, x)| *sum += x.abs());
                carried.push(after);
            }
            handed.iter_mut().enumerate().for_each(|(i, sum): (usize, &mut f64)| {
                *sum += carried.iter().map(|after| after[i].abs()).sum::<f64>();
            });
            sizes.push((used.clone(), handed.clone()));
            sources.iter_mut().zip(carried).for_each(|((now, _), after)| *now = after);
        }
        sizes
    }

    /// Roundings of a state per call, in units of half an ulp of the largest of its terms.
    pub fn roundings(&self) -> f64 {
        let terms = |row: usize| {
            [&self.step, &self.inject, &self.begin, &self.end, &self.constant]
                .iter()
                .map(|m| m.0[row].iter().flatten().count())
                .sum::<usize>()
        };
        crate::numbers::count((0..self.step.0.len()).map(terms).max().unwrap_or(0) + 2)
    }

    /// The sum of magnitudes of a state's terms in one call, from the sizes of the call before.
    pub fn terms(&self, used: &[f64], handed: &[f64]) -> Vec<f64> {
        let size = |m: &Entries, i: usize| m.0[i].iter().flatten().map(|x| x.double.abs()).sum::<f64>();
        let row = |i: usize| {
            let moved: f64 = self.step.0[i].iter().zip(used).map(|(a, x)| a.map_or(0.0, |a| a.double.abs()) * x).sum();
            let known = size(&self.inject, i) + size(&self.begin, i) + size(&self.end, i) + size(&self.constant, i);
            if self.live[i] { handed[i] + moved + known } else { 0.0 }
        };
        (0..self.step.0.len()).map(row).collect()
    }

    /// Additions and multiplications of a call.
    pub fn flops(&self) -> usize {
        let all = |m: &Entries| m.numbers().count();
        let moved: usize = self
            .step
            .0
            .iter()
            .map(|row| row.iter().zip(&self.live).filter(|(x, live)| **live && x.is_some()).count())
            .sum();
        let seen: usize = self
            .seen
            .0
            .iter()
            .map(|row| row.iter().zip(&self.live).filter(|(x, live)| **live && x.is_some()).count())
            .sum();
        2 * (moved + seen + all(&self.inject) + all(&self.begin) + all(&self.end)) + all(&self.constant)
    }

    /// All numbers.
    pub fn numbers(&self) -> impl Iterator<Item = crate::sampled::settled::Settled> {
        [&self.step, &self.inject, &self.begin, &self.end, &self.seen, &self.constant]
            .into_iter()
            .flat_map(Entries::numbers)
    }
}
