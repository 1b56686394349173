//! How large the numbers of a solve become, for samples of magnitude 1, and what rounding does to them.

use super::{Ages, Irregular, Sparse};
use crate::numbers::count;
use crate::sampled::settled::Settled;

impl Irregular {
    /// The largest entry of a row, for rows of samples with an age at any of them: those of Q are at most 1.
    fn largest_entry(&self) -> f64 {
        let of = |(ages, trust): (&Ages, &Settled)| {
            let row = ages.largest_row();
            let entry = |state: &Vec<Vec<Settled>>, j: usize| -> f64 {
                row.iter().zip(state).map(|(c, direction)| c * direction[j].double.abs()).sum::<f64>() * trust.double
            };
            let largest = |state: &Vec<Vec<Settled>>| (0..row.len()).map(|j| entry(state, j)).fold(0.0, f64::max);
            self.states.iter().map(largest).fold(0.0, f64::max)
        };
        let aged = self.ages.iter().zip(&self.trust).filter_map(|(ages, trust)| Some((ages.as_ref()?, trust)));
        aged.map(of).fold(1.0, f64::max)
    }

    /// The largest magnitude in a step for samples of magnitude 1, from above.
    ///
    /// What elimination leaves of the right-hand sides is at most the root of what it leaves of their diagonals, times the
    /// root sum of squares of what the rows showed; so is an answer, with the root of its variance, and each of its parts.
    /// Twice that with rounding.
    pub fn largest_gain(&self) -> f64 {
        let size = |weight: &Option<Settled>| weight.map_or(0.0, |weight| weight.double.abs());
        let sum = |row: &Vec<Option<Settled>>| row.iter().map(size).sum::<f64>();
        let n = self.phi.len();
        let mut response = vec![0.0; n];
        let mut largest = vec![0.0_f64; n];
        let moved = |i: usize| -> f64 {
            let of = |effects: &Sparse| effects.iter().map(|effect| size(&effect[i])).sum::<f64>();
            of(&self.begin) + of(&self.end) + size(&self.constant[i])
        };
        for _ in 0..self.rows.len() {
            let kept =
                |i: usize| -> f64 { self.phi[i].iter().zip(&response).map(|(weight, r)| size(weight) * r).sum() };
            response = (0..n).map(|i| kept(i) + moved(i)).collect();
            largest.iter_mut().zip(&response).for_each(|(largest, r)| *largest = largest.max(*r));
        }
        let response = largest.iter().copied().fold(0.0, f64::max);
        let trust = self.trust.iter().map(|trust| trust.double).fold(0.0, f64::max);
        let seen = self.c.iter().map(sum).fold(0.0, f64::max);
        let entry = self.largest_entry();
        let aged = self.ages.iter().flatten();
        let shown = aged.fold(1.0 + seen * response, |most, ages| {
            let seen = ages.largest_row().iter().sum::<f64>();
            most.max(1.0 + ages.largest_share() + seen * response)
        });
        let right = count(self.rows.len() * self.c.len()) * trust * shown * entry;
        let square = self.worth.scale.iter().flatten().fold(0.0_f64, |most, scale| most.max(*scale)) * self.worth.most;
        let rows = deadbeat_math::sqrt_f64(count(self.rows.len() * self.c.len()));
        let solved = 2.0 * right.max(deadbeat_math::sqrt_f64(square) * rows * trust * shown);
        let phi = self.phi.iter().map(sum).fold(1.0, f64::max);
        (solved + response) * phi + (0..n).map(moved).fold(0.0, f64::max)
    }

    /// K for some samples, by age of the state that they show from 0, n x p each, in doubles; `None` where they do not
    /// determine the state.
    pub fn weights(&self, there: &dyn Fn(usize, usize) -> bool) -> Option<Vec<nalgebra::DMatrix<f64>>> {
        let (n, p, steps) = (self.phi.len(), self.c.len(), self.rows.len() - 1);
        let dense = |sparse: &Sparse| {
            nalgebra::DMatrix::from_fn(sparse.len(), n, |i, j| sparse[i][j].map_or(0.0, |weight| weight.double))
        };
        let row = |age: usize, o: usize| nalgebra::DVector::from_fn(n, |j, _| self.rows[steps - age][o][j].double);
        let mut normal = nalgebra::DMatrix::zeros(n, n);
        for age in 0..=steps {
            for o in (0..p).filter(|o| there(age, *o)) {
                normal += row(age, o) * row(age, o).transpose();
            }
        }
        let through = dense(&self.through) * normal.cholesky()?.inverse();
        let weights = |age: usize| {
            let columns: Vec<_> = (0..p)
                .map(|o| {
                    let column = &through * row(age, o) * self.trust[o].double;
                    if there(age, o) { column } else { column * 0.0 }
                })
                .collect();
            nalgebra::DMatrix::from_columns(&columns)
        };
        Some((0..=steps).map(weights).collect())
    }

    /// How often rounding errors of the sums reach a state, with the samples of the pattern at the worst call.
    ///
    /// A sum over the rows is off by some units of its terms; the solve and the way to the newest sample multiply that
    /// by `|Phi^N R^-1| |G^-1|`. A direction that has died out by then may be poorly determined.
    pub fn amplification(&self) -> f64 {
        let (n, steps) = (self.phi.len(), self.rows.len() - 1);
        let mut worst = 0.0_f64;
        for phase in self.pattern.phases() {
            let mut normal = nalgebra::DMatrix::zeros(n, n);
            let mut terms = nalgebra::DVector::zeros(n);
            for age in 0..=steps {
                for (o, (row, trust)) in self.rows[steps - age].iter().zip(&self.trust).enumerate() {
                    if self.pattern.there(phase, age, o) {
                        let row = nalgebra::DVector::from_fn(n, |j, _| row[j].double);
                        normal += &row * row.transpose();
                        terms += row.abs() * trust.double;
                    }
                }
            }
            let Some(inverse) = normal.cholesky().map(|factor| factor.inverse()) else { return f64::INFINITY };
            let through = nalgebra::DMatrix::from_fn(n, n, |i, j| self.through[i][j].map_or(0.0, |w| w.double.abs()));
            worst = worst.max((through * inverse.abs() * terms).max());
        }
        worst
    }
}
