//! Gain laws of a countdown: what `r^n c_i` is as a polynomial in the steps left, r.
//!
//! `c_i = h^i g_i` with g of 003 (4), `L_i rho^i`, or of 004 (36), `sum_k hbar_ik mu_1^k`; `rho = mu_1 = N/r`. A law gives
//! one polynomial for each i = 1 … n, coefficients of `r^0 … r^n`, without negative ones: then the denominator
//! `r^n (1 + S_1)` is above zero for every r >= 0, r = 0 included, since `c_n` has a constant term.

use super::Counting;
use crate::real::{Matrix, Precision, Rational, Real};

/// `r^n c_i`, a row per i, by powers of r.
pub type Rows = Vec<Vec<Real>>;

/// 003 (4): `r^n c_i = L_i T^i r^(n-i)`, with L in the paper's units (1/s^i).
pub fn efimov_orlov(gains: &[Real], time: &Real) -> Rows {
    let p = time.precision();
    let mut power = Real::one(p);
    let scaled = gains.iter().map(|gain| {
        power = &power * time;
        gain * &power
    });
    monomials(scaled.collect())
}

/// All poles of `A - L C` at -p/T: `L_i T^i = C(n,i) p^i`.
pub fn poles(order: usize, pole: &Real) -> Rows {
    let p = pole.precision();
    let mut power = Real::one(p);
    let scaled = (1..=order).map(|i| {
        power = &power * pole;
        &power * &Real::from_rational(&binomial(order, i), p)
    });
    monomials(scaled.collect())
}

/// 004 (7), (36): `r^n c_i = sum_k l_(i-k) h^(i-k) C(n-i+k, k) (n+m)!/(n+m-k)! r^(n-k)` with `l_0 = 1` (section 0).
pub fn holloway_krstic(m: usize, l: &[Real], sample_time: &Real) -> Rows {
    let (n, p) = (l.len(), sample_time.precision());
    let mut steps = vec![Real::one(p)];
    for _ in 0..n {
        steps.push(&steps[steps.len() - 1] * sample_time);
    }
    let of = |i: usize| {
        let mut row = vec![Real::zero(p); n + 1];
        for k in 0..=i {
            let factor = Real::from_rational(&(binomial(n - i + k, k) * falling(n + m, k)), p);
            row[n - k] = if k == i { factor } else { &(&factor * &l[i - k - 1]) * &steps[i - k] };
        }
        row
    };
    (1..=n).map(of).collect()
}

/// `r^n c_i = Lambda_i r^(n-i)`.
fn monomials(scaled: Vec<Real>) -> Rows {
    let n = scaled.len();
    let row = |(i, gain): (usize, Real)| {
        let mut row = vec![Real::zero(gain.precision()); n + 1];
        row[n - 1 - i] = gain;
        row
    };
    scaled.into_iter().enumerate().map(row).collect()
}

/// n over k.
pub fn binomial(n: usize, k: usize) -> Rational {
    (1..=k).fold(Rational::ONE, |product, i| product * Rational::from(n + 1 - i) / Rational::from(i))
}

/// n (n-1) … (n-k+1).
pub fn falling(n: usize, k: usize) -> Rational {
    (0..k).fold(Rational::ONE, |product, i| product * Rational::from(n - i))
}

/// kappa with r steps left, in doubles: for reports.
pub fn kappa(rows: &[Vec<f64>], left: f64) -> Vec<f64> {
    let n = rows.len();
    let powers: Vec<f64> = (0..=n).scan(1.0, |power, _| Some(std::mem::replace(power, *power * left))).collect();
    let value = |row: &Vec<f64>| -> f64 { row.iter().zip(&powers).map(|(a, power)| a * power).sum() };
    let mut sums: Vec<f64> = rows.iter().map(value).collect();
    for j in (0..n - 1).rev() {
        sums[j] += sums[j + 1];
    }
    let denominator = powers[n] + sums[0];
    sums.into_iter().map(|sum| sum / denominator).collect()
}

/// kappa with `left` steps left, n x 1, at the law's precision.
pub fn exact_kappa(rows: &[Vec<Real>], left: usize) -> Matrix {
    let n = rows.len();
    let precision = rows.first().and_then(|row| row.first()).map_or(Precision::bits(64), Real::precision);
    let r = Real::from_rational(&Rational::from(left), precision);
    let powers: Vec<Real> =
        (0..=n).scan(Real::one(precision), |power, _| Some(std::mem::replace(power, &*power * &r))).collect();
    let mut sums: Vec<Real> =
        rows.iter().map(|row| Real::sum_of_products(row.iter().zip(&powers), precision)).collect();
    for j in (1..n).rev() {
        sums[j - 1] = &sums[j - 1] + &sums[j];
    }
    let denominator = sums.first().map(|first| &powers[n] + first);
    Matrix::from_fn(n, 1, |j, _| denominator.as_ref().map_or_else(|| Real::zero(precision), |all| &sums[j] / all))
}

/// By how many powers of two r is scaled down, so that its powers lie around 1 over the whole countdown.
pub fn shift(counting: Counting) -> i64 {
    let (most, least) = (crate::numbers::count(counting.steps), crate::numbers::count(counting.stop.max(1)));
    let middle = 0.5 * (Real::from_f64(most * least, Precision::bits(64)).map_or(0.0, |x| x.log2_abs()));
    #[expect(clippy::cast_possible_truncation, reason = "the logarithm of a number of steps")]
    let whole = middle.floor() as i64;
    whole
}

#[cfg(test)]
mod tests {
    use super::*;

    const P: usize = 256;

    fn real(x: f64) -> Real {
        Real::from_f64(x, Precision::bits(P)).unwrap()
    }

    /// 004 with l = 0 is 003 with `L_i T^i = C(n,i) (n+m)!/(n+m-i)!` (section 2).
    #[test]
    fn without_l_both_papers_agree() {
        for n in 2..=8 {
            for m in 1..=3 {
                let zero = vec![real(0.0); n];
                let of_004 = holloway_krstic(m, &zero, &real(0.01));
                let scaled =
                    (1..=n).map(|i| Real::from_rational(&(binomial(n, i) * falling(n + m, i)), Precision::bits(P)));
                assert_eq!(of_004, monomials(scaled.collect()));
            }
        }
    }

    /// At r = 0 every law gives kappa = 1: backward differences, 003 (12) in the limit.
    #[test]
    fn every_law_ends_in_backward_differences() {
        let laws = [
            efimov_orlov(&[46.0, 791.0, 6026.0, 17_160.0].map(real), &real(2.5)),
            poles(4, &real(10.0)),
            holloway_krstic(2, &[1.0, 2.0, 3.0, 4.0].map(real), &real(0.1)),
        ];
        for law in laws {
            let rows: Vec<Vec<f64>> = law.iter().map(|row| row.iter().map(Real::to_f64).collect()).collect();
            assert_eq!(kappa(&rows, 0.0), [1.0; 4]);
        }
    }
}
