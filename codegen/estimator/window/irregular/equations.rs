//! The normal equations of samples that are there, as the step has them; in doubles, in one order, as constants of the
//! step come from them.

use super::Irregular;

/// Which samples are there.
pub struct There<'a> {
    /// By age of the state that they show, and output.
    pub at: &'a dyn Fn(usize, usize) -> bool,
    /// Where samples come with their ages: those, by age, over the oldest.
    pub share: &'a dyn Fn(usize) -> f64,
}

/// Equations after elimination.
pub struct Eliminated {
    /// The rows of the samples that are there.
    rows: Vec<Vec<f64>>,
    /// Upper triangular.
    upper: Vec<Vec<f64>>,
    /// The smallest pivot.
    pub pivot: f64,
    /// The smallest share that elimination left of a diagonal.
    pub tolerance: f64,
}

impl Irregular {
    /// Rows of samples that are there.
    fn rows_of(&self, there: &There) -> Vec<Vec<f64>> {
        let (n, steps) = (self.phi.len(), self.rows.len() - 1);
        let row = |age: usize, o: usize| -> Vec<f64> {
            let place = steps - age;
            let Some(ages) = &self.ages[o] else { return self.rows[place][o].iter().map(|w| w.double).collect() };
            let power = |series: &Vec<Option<crate::sampled::settled::Settled>>| {
                let terms = series.iter().rev().map(|c| c.map_or(0.0, |c| c.double));
                terms.fold(0.0, |sum, c| sum * (there.share)(age) + c)
            };
            let shows: Vec<f64> = ages.row.iter().map(|series| self.trust[o].double * power(series)).collect();
            (0..n).map(|j| shows.iter().zip(&self.states[place]).map(|(c, way)| c * way[j].double).sum()).collect()
        };
        let all = (0..=steps).flat_map(|age| (0..self.c.len()).map(move |o| (age, o)));
        all.filter(|(age, o)| (there.at)(*age, *o)).map(|(age, o)| row(age, o)).collect()
    }

    /// Eliminates; `None` where a pivot vanishes.
    pub fn eliminated(&self, there: &There) -> Option<Eliminated> {
        let (n, rows) = (self.phi.len(), self.rows_of(there));
        let mut upper = vec![vec![0.0; n]; n];
        for row in &rows {
            for (i, upper) in upper.iter_mut().enumerate() {
                upper.iter_mut().zip(row).for_each(|(sum, entry)| *sum += row[i] * entry);
            }
        }
        let diagonal: Vec<f64> = (0..n).map(|k| upper[k][k]).collect();
        let (mut smallest, mut tolerance) = (f64::INFINITY, f64::INFINITY);
        for (k, diagonal) in diagonal.into_iter().enumerate() {
            let pivot = upper[k][k];
            if pivot <= 0.0 {
                return None;
            }
            smallest = smallest.min(pivot);
            tolerance = tolerance.min(pivot / diagonal);
            let above = upper[k].clone();
            for below in &mut upper[k + 1..] {
                let factor = below[k] / pivot;
                below.iter_mut().zip(&above).for_each(|(x, above)| *x -= factor * above);
            }
        }
        Some(Eliminated { rows, upper, pivot: smallest, tolerance })
    }

    /// What the step asks of the solution, per state.
    pub fn asked(&self) -> Vec<Vec<f64>> {
        self.through
            .iter()
            .map(|row| row.iter().map(|entry| entry.map_or(0.0, |entry| entry.double)).collect())
            .collect()
    }
}

impl Eliminated {
    /// How many samples there are.
    pub fn count(&self) -> f64 {
        crate::numbers::count(self.rows.len())
    }

    /// `L^-1 t`.
    fn forward(&self, asked: &[f64]) -> Vec<f64> {
        let mut left = asked.to_vec();
        for k in 0..left.len() {
            for i in k + 1..left.len() {
                left[i] -= self.upper[k][i] / self.upper[k][k] * left[k];
            }
        }
        left
    }

    /// `t' G^-1 t`: the variance of an answer, for rows with noise of variance 1.
    pub fn variance(&self, asked: &[f64]) -> f64 {
        self.forward(asked).iter().enumerate().map(|(k, left)| left * left / self.upper[k][k]).sum()
    }

    /// The sum of the magnitudes of an answer's weights, one a row.
    pub fn largest(&self, asked: &[f64]) -> f64 {
        let mut z = self.forward(asked);
        for k in (0..z.len()).rev() {
            let known: f64 = (k + 1..z.len()).map(|j| self.upper[k][j] * z[j]).sum();
            z[k] = (z[k] - known) / self.upper[k][k];
        }
        let weight = |row: &Vec<f64>| row.iter().zip(&z).map(|(a, b)| a * b).sum::<f64>().abs();
        self.rows.iter().map(weight).sum()
    }
}
