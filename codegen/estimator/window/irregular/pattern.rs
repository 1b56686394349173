//! Which samples come when none is lost: each output at every g-th call, and late by its delay.

use crate::sampled::model::Model;
use crate::sampled::observability::output_powers;

/// Regular times of all outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// Per output: g; measured at calls 0, g, 2g, …
    every: Vec<usize>,
    /// Per output: whole samples of delay.
    delays: Vec<usize>,
}

impl Pattern {
    /// Of outputs that are measured at every g-th call and arrive late.
    pub fn new(every: Vec<usize>, delays: Vec<usize>) -> Self {
        Self { every, delays }
    }

    /// Outputs that are measured together.
    pub fn together(outputs: usize, every: usize) -> Self {
        Self::new(vec![every; outputs], vec![0; outputs])
    }

    /// Calls after which it begins again, which are as many phases of a window; `None` for too many to count.
    pub fn period(&self) -> Option<usize> {
        let mut every = self.every.iter();
        every.try_fold(1_usize, |period, every| (period / common_divisor(period, *every)).checked_mul(*every))
    }

    /// The phases.
    pub fn phases(&self) -> std::ops::Range<usize> {
        0..self.period().unwrap_or(0)
    }

    /// Whole samples of delay, per output.
    pub fn delays(&self) -> &[usize] {
        &self.delays
    }

    /// Whether a sample of an output can ever show the state of this age.
    pub fn shows(&self, age: usize, output: usize) -> bool {
        age >= self.delays[output]
    }

    /// Whether a call of this phase has had the sample that shows the state of this age.
    pub fn there(&self, phase: usize, age: usize, output: usize) -> bool {
        let every = self.every[output];
        age.checked_sub(self.delays[output]).is_some_and(|age| age % every == phase % every)
    }

    /// How many directions of the state a window of so many steps shows at its worst phase, without the samples of one
    /// output or with those of all; in doubles.
    pub fn shown(&self, model: &Model, steps: usize, lost: Option<usize>) -> usize {
        let rows = output_powers(model, steps);
        let rows: Vec<Vec<Vec<f64>>> = rows.iter().rev().map(super::Matrix::to_f64).collect();
        let n = model.phi.rows();
        let of_phase = |phase: usize| {
            let there = |age: usize| {
                let outputs = (0..self.every.len()).filter(move |o| lost != Some(*o) && self.there(phase, age, *o));
                outputs.map(move |o| (age, o))
            };
            let all: Vec<&Vec<f64>> = (0..=steps).flat_map(there).map(|(age, o)| &rows[age][o]).collect();
            rank(&all, n)
        };
        self.phases().map(of_phase).min().unwrap_or(0)
    }
}

/// What is below this share of a column's largest entry is rounding.
const NOTHING: f64 = 1e-10;

/// The rank of rows in doubles, their columns scaled to one, by elimination with the largest pivot.
fn rank(rows: &[&Vec<f64>], n: usize) -> usize {
    let scale: Vec<f64> = (0..n).map(|j| rows.iter().fold(0.0_f64, |most, row| most.max(row[j].abs()))).collect();
    let scaled = |row: &Vec<f64>| (0..n).map(|j| if scale[j] > 0.0 { row[j] / scale[j] } else { 0.0 }).collect();
    let mut rest: Vec<Vec<f64>> = rows.iter().map(|row| scaled(row)).collect();
    let mut left: Vec<usize> = (0..n).collect();
    while !left.is_empty() {
        let entries = rest.iter().enumerate().flat_map(|(i, row)| left.iter().map(move |j| (row[*j].abs(), i, *j)));
        let Some((size, i, j)) = entries.max_by(|a, b| a.0.total_cmp(&b.0)) else { break };
        if size < NOTHING {
            break;
        }
        let pivot = rest.swap_remove(i);
        for row in &mut rest {
            let factor = row[j] / pivot[j];
            row.iter_mut().zip(&pivot).for_each(|(x, above)| *x -= factor * above);
        }
        left.retain(|k| *k != j);
    }
    n - left.len()
}

fn common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { common_divisor(b, a % b) }
}
