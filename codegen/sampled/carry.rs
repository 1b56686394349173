//! One sample interval of the plant, for a state that no sample corrects.

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::Value;
use crate::program::builder::Builder;
use crate::real::{Matrix, Precision, Real};

use super::Signal;
use super::model::{Effect, Model};
use super::settle::{Pass, rising};
use super::settled::Settled;
use super::weights;

/// Settled entries; `None` marks a structural zero.
type Column = Vec<Option<Settled>>;

/// One sample interval of the plant, for a state that no sample corrects.
#[derive(Clone, Debug)]
pub struct Carry {
    /// Phi, n x n.
    pub phi: Vec<Column>,
    /// Per signal, n: times the value that the interval's first call brought.
    pub begin: Vec<Column>,
    /// Per signal, n: times the value that its last call brought.
    pub end: Vec<Column>,
    /// n: what the constant terms add.
    pub constant: Column,
    /// States that other states change by in proportion to something known; empty where there are none.
    pub factors: Vec<Factor>,
}

/// A constant state times what is known.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Its place among the states.
    pub state: usize,
    /// What its value is multiplied with first.
    pub unit: f64,
    /// Per signal, n: times the value that the interval's first call brought.
    pub begin: Vec<Column>,
    /// Per signal, n: times the value that its last call brought.
    pub end: Vec<Column>,
    /// n.
    pub constant: Column,
}

impl Carry {
    /// Samples the plant; nonlinear terms run straight between samples.
    ///
    /// # Errors
    /// What sampling reports, or that the constants do not settle.
    pub fn new(plant: &Plant, signals: &[Signal]) -> Result<Self, Vec<Diagnostic>> {
        let run = |p: Precision| Model::new(plant, signals, p);
        let (carry, _, _) = rising(plant, run, Self::settled, |_| 0.0)?;
        Ok(carry)
    }

    fn settled(pass: &mut Pass, coarse: &Model, fine: &Model) -> Self {
        let n = fine.phi.rows();
        let row = |m: &Matrix, i: usize| -> Vec<Real> { (0..n).map(|j| m.get(i, j).clone()).collect() };
        let phi = (0..n).map(|i| pass.each(&row(&coarse.phi, i), &row(&fine.phi, i))).collect();
        let entries = |m: &Matrix| -> Vec<Real> { (0..n).map(|i| m.get(i, 0).clone()).collect() };
        let mut columns = |which: fn(&Effect) -> Option<&Matrix>| -> Vec<Column> {
            let both = coarse.effects.iter().zip(&fine.effects);
            both.map(|(c, f)| match (which(c), which(f)) {
                (Some(c), Some(f)) => pass.each(&entries(c), &entries(f)),
                _ => vec![None; n],
            })
            .collect()
        };
        let begin = columns(|effect| effect.at_begin.as_ref());
        let end = columns(|effect| effect.at_end.as_ref());
        let constant = pass.each(&entries(&coarse.constant), &entries(&fine.constant));
        Self { phi, begin, end, constant, factors: Vec::new() }
    }

    /// The largest sum of magnitudes, for a state and signals of magnitude 1.
    pub fn gain(&self) -> f64 {
        let size = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double.abs());
        let of = |i: usize| -> f64 {
            let columns = self.begin.iter().chain(&self.end).chain([&self.constant]);
            self.phi[i].iter().map(size).sum::<f64>() + columns.map(|column| size(&column[i])).sum::<f64>()
        };
        (0..self.phi.len()).map(of).fold(0.0, f64::max)
    }

    /// The state one call later. What overflows is for the caller to see: nothing is stored here.
    pub(crate) fn next(&self, b: &mut Builder, state: &[Value], (begin, end): (&[Value], &[Value])) -> Vec<Value> {
        let values: Vec<Value> = (self.factors.iter())
            .map(|factor| {
                let unit = b.float(factor.unit);
                b.mul(unit, state[factor.state])
            })
            .collect();
        let mut next = Vec::new();
        for (i, row) in self.phi.iter().enumerate() {
            let known = self.begin.iter().zip(begin).chain(self.end.iter().zip(end));
            let all = row.iter().zip(state).chain(known.map(|(column, value)| (&column[i], value)));
            let mut terms = weights::terms(b, all);
            terms.extend(self.constant[i].map(|entry| weights::constant(b, entry)));
            for (factor, value) in self.factors.iter().zip(&values) {
                let known = factor.begin.iter().zip(begin).chain(factor.end.iter().zip(end));
                let mut shares = weights::terms(b, known.map(|(column, value)| (&column[i], value)));
                shares.extend(factor.constant[i].map(|entry| weights::constant(b, entry)));
                if !shares.is_empty() {
                    let share = b.sum(&shares);
                    terms.push(b.mul(*value, share));
                }
            }
            next.push(b.sum(&terms));
        }
        next
    }
}
