//! What is certain of the error whenever the last n innovations were small.
//!
//! Backward differences correct by `K e`, `K = M (1 … 1)' + q`, and `Z = (I - K C) Phi` has `Z^n = 0`. The law corrects
//! by less: in chain coordinates `S_j` instead of `|e|`. The error (estimate minus truth) is therefore
//!
//! ```text
//! err_k = sum_{j=0}^{n-1} Z^j ( K v - (I - K C) d - M s sign(e) )   at call k-j,   s_j = |e| - S_j
//! ```
//!
//! with noise v, what the plant does not know of the interval d, and a shortfall s that grows with the innovation
//! and is 0 up to `c_n`. Nothing older enters: n innovations within a bound are a bound on the error, whatever was
//! before. The sums over v and d are those of the corrector's certificate for the constant gain K.

use crate::dense::{Rows, add_magnitudes, dot, transposed};
use crate::expr::Constant;
use crate::plant::{Disturbance, Plant};
use crate::real::{Matrix, Precision, Real, zero_order_hold};

/// Sums over the last n calls.
#[derive(Clone, Debug)]
pub struct Backward {
    /// n x n: of the error, per unit of the shortfall of each `S_j`.
    shortfall: Rows,
    /// Of the innovation that backward differences have, per unit of noise: 2^n for the chain.
    pub noise: f64,
    /// 1 x n each: of that innovation, what a change of the state at the end of an interval does, newest first.
    into: Vec<Rows>,
}

impl Backward {
    /// Of a sampled plant with one output: Phi n x n, C 1 x n, with M n x n and q n x 1 of its chain form.
    pub fn new(phi: &Matrix, c: &Matrix, m: &Matrix, q: &Matrix) -> Self {
        let (n, p) = (phi.rows(), phi.precision());
        let ones = Matrix::from_fn(n, 1, |_, _| Real::one(p));
        let gain = &(m * &ones) + q;
        let keeps = &Matrix::identity(n, p) - &(&gain * c);
        let z = &keeps * phi;
        let ahead = c * phi;
        let mut sums = Self { shortfall: vec![vec![0.0; n]; n], noise: 1.0, into: vec![c.to_f64()] };
        let mut power = Matrix::identity(n, p);
        for _ in 0..n {
            add_magnitudes(&mut sums.shortfall, &(&power * m).to_f64());
            let next = &ahead * &power;
            sums.noise += (&next * &gain).get(0, 0).to_f64().abs();
            sums.into.push((&next * &keeps).to_f64());
            power = &power * &z;
        }
        sums
    }

    /// The largest error of each state by shortfalls alone.
    pub fn error(&self, shortfall: &[f64]) -> Vec<f64> {
        self.shortfall.iter().map(|row| dot(row, shortfall)).collect()
    }

    /// What the plant's disturbances within their bounds do to the innovation of backward differences at most, where
    /// they keep their value over a sample interval; `None` where the plant is too fast for its sample time.
    pub fn disturbance(&self, plant: &Plant) -> Option<f64> {
        let held = transposed(&held(plant)?.to_f64());
        let gain = |column: &Vec<f64>| self.into.iter().map(|row| dot(&row[0], column).abs()).sum::<f64>();
        let bound = |d: &Disturbance| d.bound.to_f64().unwrap_or(f64::INFINITY);
        Some(held.iter().zip(&plant.disturbances).map(|(column, d)| gain(column) * bound(d)).sum())
    }
}

/// n x d: what each disturbance does to the state over an interval, per unit.
fn held(plant: &Plant) -> Option<Matrix> {
    let (n, p) = (plant.states.len(), Precision::bits(256));
    let value = |constant: &Constant| constant.evaluate(p).unwrap_or_else(|_| Real::zero(p));
    let all = Matrix::from_fn(n, plant.disturbances.len(), |i, d| value(&plant.disturbances[d].column[i]));
    if plant.discrete || plant.disturbances.is_empty() {
        return Some(all);
    }
    let a = Matrix::from_fn(n, n, |i, j| value(&plant.a[i][j]));
    zero_order_hold(&a, &all, &value(&plant.sample_time.0)).ok().map(|(_, held)| held)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{law_of, p};
    use super::*;

    /// The chain at h = 1 as implicit Euler has it: Phi = (I - A)^-1, M = I, q = 0.
    fn backward(n: usize) -> Backward {
        let real = |there: bool| Real::from_i64(i64::from(there), p());
        let phi = Matrix::from_fn(n, n, |i, j| real(j >= i));
        let c = Matrix::from_fn(1, n, |_, j| real(j == 0));
        Backward::new(&phi, &c, &Matrix::identity(n, p()), &Matrix::zeros(n, 1, p()))
    }

    /// The innovation is the n-th difference of n+1 samples: sums of binomial coefficients. What enters the state
    /// between samples makes a difference by its own n-1 differences and what is older.
    #[test]
    fn of_the_chain_they_are_binomial() {
        for n in 2..=6 {
            let sums = backward(n);
            assert_eq!(sums.noise, f64::from(1 << n));
            assert_eq!(sums.into.len(), n + 1);
            // A step of y itself is met by the n-th difference with the coefficients of the (n-1)-th.
            let steps: f64 = sums.into.iter().map(|row| row[0][0].abs()).sum();
            assert_eq!(steps, f64::from(1 << (n - 1)));
        }
    }

    /// In a run with noise the bound holds at every call behind n innovations within a bound, and the error comes near
    /// it: both ways of being wrong would show.
    #[test]
    fn the_bound_holds_and_is_no_fancy() {
        for n in 2..=6_usize {
            let (_, law) = law_of(n, 1.0, 1.0);
            let sums = backward(n);
            for noise in [0.01, 3.0, 500.0] {
                let reach = law.reach.double + sums.noise * noise;
                // The (i-1)-th difference of noise, and the shortfall.
                let short = sums.error(&law.shortfall(reach));
                let bounds: Vec<f64> = (0..n).map(|i| f64::from(1 << i) * noise + short[i]).collect();
                let (mut xi, mut seed, mut within, mut closest) = (vec![0.0; n], 1_u64, 0, 0.0_f64);
                xi[n - 1] = 20.0;
                for call in 0..20_000 {
                    seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    let v = if seed >> 63 == 0 { noise } else { -noise };
                    for i in (0..n - 1).rev() {
                        xi[i] += xi[i + 1];
                    }
                    let e = v - xi[0];
                    let short = law.shortfall(e.abs());
                    xi.iter_mut().zip(&short).for_each(|(xi, short)| *xi += e.signum() * (e.abs() - short));
                    within = if e.abs() <= reach { within + 1 } else { 0 };
                    if within >= n {
                        // The truth is 0; rounding of numbers that were far larger.
                        let worst = xi.iter().zip(&bounds).map(|(xi, bound)| xi.abs() / (bound + 1e-9));
                        closest = worst.fold(closest, f64::max);
                        assert!(closest <= 1.0, "{n} {noise} {call}: {xi:?} {bounds:?}");
                    }
                }
                assert!(closest > 0.01, "{n} {noise}: {closest}");
            }
        }
    }
}
