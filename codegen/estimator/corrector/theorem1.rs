//! What 003 Theorem 1 says of gains `L_i rho^i` in continuous time.
//!
//! **Exponent margin.** In the time `T ln rho` the scaled error obeys `A - L C - Delta`, `Delta = diag(0 … n-1) / T` (6),
//! (8). Times T, in the output's unit: `A - Lambda C - diag(0 … n-1)` with `Lambda_i = L_i T^i`. The error's component i
//! decays as `rho^(i-1-mu)`, mu its smallest decay rate: prescribed-time convergence needs mu > n-1, and that is exact.
//! T > 2n-2 (Remark 3) is sufficient only: it comes of asking the Lyapunov function for the decay rate 1/2, which is
//! mu > T/2 and depends on the unit of time. The paper's own T = 2.5, n = 4 has T < 6, and mu = 29.9.
//!
//! **The inequalities.** For given L they hold for some P exactly if mu > T/2. P is taken from
//! `(A_L - Delta + I/2)' P + P (A_L - Delta + I/2) = -W`, which leaves `Q_11 = -W`; `gamma_1` and `gamma_2` follow from the
//! Schur complement in `Q_11`: `diag(gamma_1, gamma_2) >= [P b, -P L]' W^-1 [P b, -P L]`.

use crate::real::{Matrix, Precision, Rational, Real, singular_values, solve};

/// Halvings of the interval that holds the margin: below the last bit of a double, whatever the coefficients.
const HALVINGS: usize = 192;

/// mu: minus the largest real part of the eigenvalues of `A - Lambda C - diag(0 … n-1)`, from `Lambda_i = L_i T^i >= 0`.
///
/// Hurwitz's criterion in rationals decides each half, so that nothing depends on rounding.
pub fn margin(scaled: &[Rational]) -> f64 {
    let polynomial = characteristic(scaled);
    let n = scaled.len();
    // The roots' sum is minus the second coefficient; their mean is no further to the right than the rightmost.
    let mut above = &polynomial[n - 1] / Rational::from(n.max(1)) + Rational::ONE;
    // Cauchy's bound on roots, of a monic polynomial.
    let mut below = polynomial.iter().fold(-Rational::ONE, |below, term| below.min(-Rational::ONE - term));
    let two = Rational::from(2);
    for _ in 0..HALVINGS {
        let middle = (&above + &below) / &two;
        if stable(&shifted(&polynomial, &middle)) { below = middle } else { above = middle }
    }
    below.to_f64().value()
}

/// Whether mu > n - 1, exactly: errors vanish at T.
pub fn vanishes(scaled: &[Rational]) -> bool {
    let needed = Rational::from(scaled.len().saturating_sub(1));
    stable(&shifted(&characteristic(scaled), &needed))
}

/// Of `A - Lambda C - diag(0 … n-1)`: `prod_(j=0..n-1) (s+j) + sum_i Lambda_i prod_(j=i..n-1) (s+j)`, by powers of s.
fn characteristic(scaled: &[Rational]) -> Vec<Rational> {
    let mut product = vec![Rational::ONE];
    let mut sum = scaled.last().map_or(vec![], |last| vec![last.clone()]);
    for j in (0..scaled.len()).rev() {
        product = times_root(&product, &Rational::from(j));
        let factor = if j == 0 { &Rational::ONE } else { &scaled[j - 1] };
        sum.resize(product.len(), Rational::ZERO);
        sum.iter_mut().zip(&product).for_each(|(sum, term)| *sum = &*sum + factor * term);
    }
    sum
}

/// Times s + a.
fn times_root(polynomial: &[Rational], a: &Rational) -> Vec<Rational> {
    let mut product = vec![Rational::ZERO; polynomial.len() + 1];
    for (i, term) in polynomial.iter().enumerate() {
        product[i] = &product[i] + a * term;
        product[i + 1] = &product[i + 1] + term;
    }
    product
}

/// p(s - by): stable if every root of p lies left of -by.
fn shifted(polynomial: &[Rational], by: &Rational) -> Vec<Rational> {
    let minus = -by.clone();
    polynomial.iter().rev().fold(Vec::new(), |sum, term| {
        let mut next = times_root(&sum, &minus);
        next[0] = &next[0] + term;
        next
    })
}

/// Whether every root has a negative real part; by Routh's rows, exactly.
fn stable(polynomial: &[Rational]) -> bool {
    let row = |from: usize| polynomial.iter().rev().skip(from).step_by(2).cloned().collect::<Vec<Rational>>();
    let (mut above, mut below) = (row(0), row(1));
    let positive = |row: &[Rational]| row.first().is_some_and(|first| *first > Rational::ZERO);
    if !positive(&above) {
        return false;
    }
    while !below.is_empty() {
        if !positive(&below) {
            return false;
        }
        let ratio = &above[0] / &below[0];
        let next = |i: usize| &above[i] - below.get(i).map_or(Rational::ZERO, |term| &ratio * term);
        let next = (1..above.len()).map(next).collect();
        above = std::mem::replace(&mut below, next);
    }
    true
}

/// A P, `gamma_1`, `gamma_2` for which the inequalities hold, in the plant's units and with the smallest eigenvalue of P
/// at 1: `|e_i| <= rho^(i-1) (rho^(-T/2) sqrt(e0' P e0) + sqrt(gamma_1 iota) |phi^(n)| + sqrt(gamma_2) |v|)`.
#[derive(Clone, Debug)]
pub struct Inequalities {
    /// n x n.
    pub p: Vec<Vec<f64>>,
    /// Of the n-th derivative.
    pub gamma_1: f64,
    /// Of the noise.
    pub gamma_2: f64,
}

impl Inequalities {
    /// For L, n x 1 in 1/s^i, and T in s; `None` where none hold: mu <= T/2.
    pub fn new(gains: &[Real], time: &Real) -> Option<Self> {
        let (n, p) = (gains.len(), time.precision());
        let half = &Real::one(p) / &Real::from_i64(2, p);
        let a = Matrix::from_fn(n, n, |i, j| match (i, j) {
            _ if j == i + 1 => Real::one(p),
            (i, 0) => -&gains[i],
            _ => Real::zero(p),
        });
        let delta = |i: usize| &Real::from_rational(&Rational::from(i), p) / time;
        let decay = Matrix::from_fn(n, n, |i, j| if i == j { &half - &delta(i) } else { Real::zero(p) });
        let w = weights(gains, p);
        let matrix = lyapunov(&(&a + &decay), &w)?;
        if !positive_definite(&matrix) {
            return None;
        }
        let inputs = Matrix::from_fn(n, 2, |i, j| match (i, j) {
            (i, 1) => -&gains[i],
            (i, _) if i + 1 == n => Real::one(p),
            _ => Real::zero(p),
        });
        let enters = &matrix * &inputs;
        let g = &enters.transpose() * &solve(&w, &enters).ok()?;
        let least = singular_values(&matrix).pop()?;
        let scaled = |x: &Real| (x / &least).to_f64();
        // diag(gamma) - G >= 0 with both raised by the same share of their own.
        let (g_1, g_2) = (g.get(0, 0), g.get(1, 1));
        let share = &Real::one(p) + &(g.get(0, 1).abs() / (g_1 * g_2).checked_sqrt().ok()?);
        let (gamma_1, gamma_2) = (scaled(&(g_1 * &share)), scaled(&(g_2 * &share)));
        let p = matrix.to_f64().iter().map(|row| row.iter().map(|x| x / least.to_f64()).collect()).collect();
        Some(Self { p, gamma_1, gamma_2 })
    }
}

/// W, diagonal: each state in the unit in which the error's rate `L_n^(1/n)` is near 1, to a power of two.
fn weights(gains: &[Real], p: Precision) -> Matrix {
    let n = gains.len();
    let rate = gains.last().map_or(0.0, Real::log2_abs) / crate::numbers::count(n.max(1));
    #[expect(clippy::cast_possible_truncation, reason = "the logarithm of a constant that a double holds")]
    let octaves = if rate.is_finite() { rate.round() as i64 } else { 0 };
    let of = |i: usize| (0..i).fold(Real::one(p), |weight, _| weight.shifted(-2 * octaves));
    Matrix::from_fn(n, n, |i, j| if i == j { of(i) } else { Real::zero(p) })
}

/// P of `a' P + P a = -w`, n x n, by its n^2 linear equations; `None` where two eigenvalues of a add up to zero.
fn lyapunov(a: &Matrix, w: &Matrix) -> Option<Matrix> {
    let (n, p) = (a.rows(), a.precision());
    let equations = Matrix::from_fn(n * n, n * n, |row, column| {
        let ((i, j), (k, l)) = ((row / n, row % n), (column / n, column % n));
        let left = if j == l { a.get(k, i).clone() } else { Real::zero(p) };
        let right = if i == k { a.get(l, j).clone() } else { Real::zero(p) };
        left + right
    });
    let right = Matrix::from_fn(n * n, 1, |row, _| -w.get(row / n, row % n));
    let entries = solve(&equations, &right).ok()?;
    Some(Matrix::from_fn(n, n, |i, j| entries.get(i * n + j, 0).clone()))
}

/// By Cholesky's pivots, n x n.
fn positive_definite(matrix: &Matrix) -> bool {
    let n = matrix.rows();
    let mut left = matrix.clone();
    for k in 0..n {
        let pivot = left.get(k, k).clone();
        if pivot.is_zero() || pivot.is_negative() {
            return false;
        }
        left = Matrix::from_fn(n, n, |i, j| left.get(i, j) - &(&(left.get(i, k) * left.get(k, j)) / &pivot));
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimator::corrector::law::{binomial, falling};

    fn rational(numerator: i64, denominator: u64) -> Rational {
        Rational::from_parts(numerator.into(), denominator.into())
    }

    /// `Lambda_i = L_i T^i` of the paper's L.
    fn paper(time: &Rational) -> Vec<Rational> {
        let mut power = Rational::ONE;
        let scaled = [46, 791, 6026, 17_160].map(|l| {
            power = &power * time;
            Rational::from(l) * &power
        });
        scaled.to_vec()
    }

    fn reals(numbers: &[Rational]) -> Vec<Real> {
        numbers.iter().map(|x| Real::from_rational(x, Precision::bits(256))).collect()
    }

    fn inequalities(l: &[Rational], time: &Rational) -> Option<Inequalities> {
        Inequalities::new(&reals(l), &reals(std::slice::from_ref(time))[0])
    }

    /// 004 with l = 0 has the exponents n+m … 2n+m-1.
    #[test]
    fn the_margin_of_004_is_n_plus_m() {
        for n in 2..=8 {
            for m in [1, 2, 5] {
                let scaled: Vec<Rational> = (1..=n).map(|i| binomial(n, i) * falling(n + m, i)).collect();
                // Below the last bit: 192 halvings.
                assert!((margin(&scaled) - crate::numbers::count(n + m)).abs() < 1e-14, "n = {n}, m = {m}");
                assert!(vanishes(&scaled));
            }
        }
    }

    /// The paper's L loses its margin when T alone is shortened (prescribed-time-observers, section 1).
    #[test]
    fn the_margin_of_the_papers_gains() {
        for (time, expected) in [((5, 2), 29.9), ((1, 1), 12.6), ((1, 2), 6.8), ((1, 10), 2.1)] {
            let scaled = paper(&rational(time.0, time.1));
            // The notes have one decimal.
            assert!((margin(&scaled) - expected).abs() <= 0.05, "{time:?}: {}", margin(&scaled));
            assert_eq!(vanishes(&scaled), expected > 3.0);
        }
    }

    /// At the margin exactly nothing vanishes: the criterion is strict.
    #[test]
    fn a_margin_of_n_less_one_is_not_enough() {
        // (s+1)(s+2) = s (s+1) + Lambda_1 (s+1) + Lambda_2: exponents 1 and 2 for n = 2.
        assert!(!vanishes(&[rational(2, 1), rational(0, 1)]));
        assert!(!vanishes(&[rational(-1, 1), rational(5, 1)]));
        assert!(margin(&[rational(0, 1), rational(1_000_000, 1)]) < 1.0);
    }

    /// The inequality of Theorem 1 with the P, `gamma_1`, `gamma_2` that are given: its matrix has no positive eigenvalue.
    #[test]
    fn the_inequalities_hold_for_the_papers_example() {
        let l: Vec<Rational> = [46, 791, 6026, 17_160].map(Rational::from).to_vec();
        let found = inequalities(&l, &rational(5, 2)).unwrap();
        let gains = [46.0, 791.0, 6026.0, 17_160.0];
        let n = 4;
        let p = nalgebra::DMatrix::from_fn(n, n, |i, j| found.p[i][j]);
        let closed = nalgebra::DMatrix::from_fn(n, n, |i, j| {
            let shift = f64::from(u8::from(j == i + 1));
            let gain = if j == 0 { gains[i] } else { 0.0 };
            let delta = if i == j { crate::numbers::count(i) / 2.5 } else { 0.0 };
            shift - gain - delta
        });
        let smallest = p.clone().symmetric_eigenvalues().min();
        // The largest eigenvalue is about 1e6: its rounding is that of 1e-10.
        assert!((smallest - 1.0).abs() < 1e-8, "{smallest}");
        let q = closed.transpose() * &p + &p * &closed + &p;
        let gain = nalgebra::DVector::from_row_slice(&gains);
        let mut whole = nalgebra::DMatrix::zeros(n + 2, n + 2);
        whole.view_mut((0, 0), (n, n)).copy_from(&q);
        let last = p.column(n - 1).into_owned();
        let noise = -(&p * gain);
        for (place, column) in [(n, last), (n + 1, noise)] {
            whole.view_mut((0, place), (n, 1)).copy_from(&column);
            whole.view_mut((place, 0), (1, n)).copy_from(&column.transpose());
        }
        whole[(n, n)] = -found.gamma_1;
        whole[(n + 1, n + 1)] = -found.gamma_2;
        // In units in which the diagonal is -1: a congruence, so that rounding is relative.
        let scale: Vec<f64> = (0..n + 2).map(|i| (-whole[(i, i)]).sqrt().recip()).collect();
        let scaled = nalgebra::DMatrix::from_fn(n + 2, n + 2, |i, j| whole[(i, j)] * scale[i] * scale[j]);
        let largest = scaled.symmetric_eigenvalues().max();
        // On the boundary by construction: gamma could not be smaller in both.
        assert!(largest < 1e-6, "{largest}");
        assert!(largest > -1e-6, "{largest}");
    }

    /// Errors that vanish at T, and yet no P: the decay rate 1/2 is of the unit of time.
    #[test]
    fn a_long_time_has_no_inequalities_although_errors_vanish() {
        let time = rational(100, 1);
        let scaled: Vec<Rational> = (1..=3).map(|i| binomial(3, i) * falling(5, i)).collect();
        let l: Vec<Rational> = (0..3).map(|i| (0..=i).fold(scaled[i].clone(), |l, _| l / &time)).collect();
        assert!(vanishes(&scaled));
        assert!(inequalities(&l, &time).is_none());
        let short = rational(9, 1);
        let l: Vec<Rational> = (0..3).map(|i| (0..=i).fold(scaled[i].clone(), |l, _| l / &short)).collect();
        // mu = 5 > T/2 = 4.5.
        assert!(inequalities(&l, &short).is_some());
    }
}
