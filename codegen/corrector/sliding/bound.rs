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
//! and is 0 up to `c_n`. Nothing older enters: n innovations within a reach bound the error, whatever was before.

use crate::real::{Matrix, Precision, Real};

/// Sums of magnitudes over the last n calls.
#[derive(Clone, Debug)]
pub struct Backward {
    /// n x n: of the error, per unit of the shortfall of each `S_j`.
    pub shortfall: Vec<Vec<f64>>,
    /// n: of the error, per unit of noise.
    pub noise: Vec<f64>,
    /// n x d: of the error, per unit of each thing that enters unknown.
    pub entering: Vec<Vec<f64>>,
    /// Of the innovation that backward differences have, per unit of noise: 2^n for the chain.
    pub innovation_noise: f64,
    /// Likewise, per unit of each thing that enters.
    pub innovation_entering: Vec<f64>,
}

impl Backward {
    /// Of a plant with one output: Phi n x n, C 1 x n, M n x n and q n x 1 of its chain form, and n x d what a unit of
    /// each unknown thing adds to the state over an interval, entry by entry at most.
    pub fn new(phi: &Matrix, c: &Matrix, m: &Matrix, q: &Matrix, entering: &Matrix) -> Self {
        let (n, p) = (phi.rows(), phi.precision());
        let ones = Matrix::from_fn(n, 1, |_, _| Real::one(p));
        let gain = &(m * &ones) + q;
        let keeps = &Matrix::identity(n, p) - &(&gain * c);
        let z = &keeps * phi;
        let (own, into) = (magnitudes(entering), c * phi);
        let mut power = Matrix::identity(n, p);
        let mut sums = Self {
            shortfall: vec![vec![0.0; n]; n],
            noise: vec![0.0; n],
            entering: vec![vec![0.0; entering.cols()]; n],
            innovation_noise: 1.0,
            innovation_entering: rows_times(&magnitudes(c), &own).into_iter().next().unwrap_or_default(),
        };
        for _ in 0..n {
            let of_noise = &power * &gain;
            add(&mut sums.shortfall, &magnitudes(&(&power * m)));
            for (sum, row) in sums.noise.iter_mut().zip(magnitudes(&of_noise)) {
                *sum += row[0];
            }
            let carried = &power * &keeps;
            add(&mut sums.entering, &rows_times(&magnitudes(&carried), &own));
            sums.innovation_noise += magnitudes(&(&into * &of_noise))[0][0];
            let through = rows_times(&magnitudes(&(&into * &carried)), &own);
            for (sum, more) in sums.innovation_entering.iter_mut().zip(&through[0]) {
                *sum += more;
            }
            power = &power * &z;
        }
        sums
    }

    /// The largest error of each state, for shortfalls, a bound on the noise and one on each thing that enters.
    pub fn error(&self, shortfall: &[f64], noise: f64, entering: &[f64]) -> Vec<f64> {
        let product = |row: &[f64], by: &[f64]| row.iter().zip(by).map(|(a, b)| a * b).sum::<f64>();
        let states = self.noise.iter().zip(&self.shortfall).zip(&self.entering);
        states.map(|((own, short), enters)| own * noise + product(short, shortfall) + product(enters, entering)).collect()
    }
}

fn magnitudes(matrix: &Matrix) -> Vec<Vec<f64>> {
    matrix.to_f64().into_iter().map(|row| row.into_iter().map(f64::abs).collect()).collect()
}

fn add(sums: &mut [Vec<f64>], more: &[Vec<f64>]) {
    for (sum, more) in sums.iter_mut().flatten().zip(more.iter().flatten()) {
        *sum += more;
    }
}

fn rows_times(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let columns = b.first().map_or(0, Vec::len);
    let entry = |row: &[f64], j: usize| row.iter().zip(b).map(|(x, y)| x * y[j]).sum();
    a.iter().map(|row| (0..columns).map(|j| entry(row, j)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::law_of;
    use super::*;

    fn p() -> Precision {
        Precision::bits(256)
    }

    fn real(x: i64) -> Real {
        Real::from_i64(x, p())
    }

    /// The chain at h = 1 as implicit Euler has it: Phi = (I - A)^-1, M = I, q = 0.
    fn chain(n: usize) -> [Matrix; 4] {
        let phi = Matrix::from_fn(n, n, |i, j| real(i64::from(j >= i)));
        let c = Matrix::from_fn(1, n, |_, j| real(i64::from(j == 0)));
        // M of that model of the chain: its own coordinates.
        [phi, c, Matrix::identity(n, p()), Matrix::zeros(n, 1, p())]
    }

    /// Of the chain they are sums of binomial coefficients: 2^(i-1) for the (i-1)-th difference of n+1 samples, and
    /// 2^n for the innovation, which is the n-th.
    #[test]
    fn of_the_chain_they_are_binomial() {
        for n in 2..=6 {
            let [phi, c, m, q] = chain(n);
            // A unit of the n-th difference enters all states alike.
            let enters = Matrix::from_fn(n, 1, |_, _| real(1));
            let sums = Backward::new(&phi, &c, &m, &q, &enters);
            for (i, noise) in sums.noise.iter().enumerate() {
                assert_eq!(*noise, f64::from(1 << i), "{n} {i}");
            }
            assert_eq!(sums.innovation_noise, f64::from(1 << n));
            // The estimate of y itself is the sample.
            assert_eq!(sums.entering[0], [0.0]);
        }
    }

    /// In a run with noise the bound holds at every call behind n innovations within the reach, and the error comes
    /// near it: both ways of being wrong would show.
    #[test]
    fn the_bound_holds_and_is_no_fancy() {
        for n in 2..=6_usize {
            let (_, law) = law_of(n, 1.0, 1.0);
            let [phi, c, m, q] = chain(n);
            let sums = Backward::new(&phi, &c, &m, &q, &Matrix::zeros(n, 0, p()));
            for noise in [0.01, 3.0, 500.0] {
                let reach = law.reach.double + sums.innovation_noise * noise;
                let bounds = sums.error(&law.shortfall(reach), noise, &[]);
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
