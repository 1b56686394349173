//! What a growing window weighs at each of its ages, in doubles: for gains and round-off, not for a step.

use crate::real::Matrix;

use super::super::Functional;
use super::ping_pong::PingPong;

/// A small matrix, by rows.
type Dense = Vec<Vec<f64>>;

/// The weights of a window of a+1 samples.
#[derive(Clone, Debug)]
pub struct AtAge {
    /// V by age: of the innovations, n x p each.
    pub innovations: Vec<Dense>,
    /// acc by age from 1: what a disturbance of the state leaves in the estimate, n x n each.
    pub accumulated: Vec<Dense>,
    /// Per state and output: sum of the magnitudes of K, of its squares.
    pub outputs: Vec<Vec<(f64, f64)>>,
    /// Per state and signal: sum of the magnitudes of M.
    pub knowns: Dense,
}

/// a b.
fn times(a: &Dense, b: &Dense) -> Dense {
    let columns = b.first().map_or(0, Vec::len);
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(x, row)| x * row[j]).sum();
    a.iter().map(|row| (0..columns).map(|j| entry(row, j)).collect()).collect()
}

/// a + s b.
fn plus(a: &Dense, s: f64, b: &Dense) -> Dense {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a + s * b).collect()).collect()
}

impl AtAge {
    /// Of a window of `age` + 1 samples.
    pub fn new(pair: &PingPong, functional: &Functional, c: &Matrix, age: usize) -> Self {
        let c = c.to_f64();
        let n = pair.copy.live.len();
        let row = age - pair.steps;
        let (step, inject) = (pair.copy.step.to_f64(), pair.copy.inject.to_f64());
        let (begin, end) = (pair.copy.begin.to_f64(), pair.copy.end.to_f64());
        let read = pair.read.at(row);
        let mut innovations: Vec<Dense> = (0..=age).map(|t| times(&read, &pair.row(age - t))).collect();
        innovations[0] = plus(&innovations[0], 1.0, &pair.direct.at(row));
        let identity: Dense = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
        let mut left = plus(&identity, -1.0, &times(&innovations[0], &c));
        let mut accumulated = Vec::new();
        let mut outputs = vec![vec![(0.0, 0.0); c.len()]; n];
        let mut add = |k: &Dense| {
            for (sums, k) in outputs.iter_mut().flatten().zip(k.iter().flatten()) {
                *sums = (sums.0 + k.abs(), sums.1 + k * k);
            }
        };
        add(&innovations[0]);
        for v in &innovations[1..] {
            add(&plus(v, 1.0, &times(&left, &inject)));
            let next = plus(&times(&left, &step), -1.0, &times(v, &c));
            accumulated.push(std::mem::replace(&mut left, next));
        }
        let mut knowns = vec![vec![0.0; functional.signals.len()]; n];
        for call in 0..=age {
            let ends = accumulated.get(call).map(|acc| times(acc, &end));
            let begins = call.checked_sub(1).map(|before| times(&accumulated[before], &begin));
            let both = match (begins, ends) {
                (Some(begins), Some(ends)) => plus(&begins, 1.0, &ends),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => continue,
            };
            for (sum, m) in knowns.iter_mut().flatten().zip(both.iter().flatten()) {
                *sum += m.abs();
            }
        }
        Self { innovations, accumulated, outputs, knowns }
    }
}
