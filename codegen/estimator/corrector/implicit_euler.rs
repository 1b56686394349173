//! 003 (efimov-orlov-2024-implicit-euler): the implicit Euler discretisation of a chain of n integrators with
//! time-varying gains, in closed form and exactly.
//!
//! `x_{k+1} = Z (x_k + h g y_{k+1})`, `Z = (I - h (A - g C))^-1` (10), with gains `g_i(t)` that grow without bound
//! towards T: `L_i rho^i` in 003, polynomials in rho in 004. Written with `c_i = h^i g_i`, `S_j = c_j + … + c_n`,
//! `kappa_j = S_j / O`:
//!
//! ```text
//! O = 1 + S_1                                    (12)
//! F_j = h^-j kappa_j                             (13)
//! Z_ij = h^(j-i) [j >= i] - h^j F_i              (12), its K(t)/O(t) multiplied out
//! ```
//!
//! With r = (T - t) / h steps left, everything is multiplied by r^n, so that the limits at T are values like others:
//! kappa = (1, …, 1), Z(T) = -h^(j-i) below the diagonal and zero elsewhere, Z(T)^n = 0.
//!
//! **In the paper's text.** (12), (13) and the limits are right as printed. In Theorem 2 `L = U P^-1` does not conform;
//! it is P^-1 U, as in Theorem 1. `Q_k >= 0` must read `<= 0` in both places before the Schur complement. `O(t) > 0`
//! needs every `L_i >= 0`, which is more than A - L C - Delta Hurwitz asks for.

use crate::real::Rational;

/// The gains at one instant, n of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gains {
    /// r^n.
    pub power: Rational,
    /// `r^n c_i = r^n h^i g_i`.
    pub scaled: Vec<Rational>,
}

impl Gains {
    /// 003 (4): `g_i = L_i (T / (T - t))^i`, hence `r^n c_i = L_i T^i r^(n-i)`.
    pub fn efimov_orlov(l: &[Rational], time: &Rational, left: &Rational) -> Self {
        let scaled = (1..=l.len()).map(|i| &l[i - 1] * power(time, i) * power(left, l.len() - i));
        Self { power: power(left, l.len()), scaled: scaled.collect() }
    }
}

/// Z, F and O at one instant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImplicitEuler {
    /// n x n; h to the power column - row.
    pub z: Vec<Vec<Rational>>,
    /// n x 1; 1/s to the power of the row.
    pub f: Vec<Rational>,
    /// `None` at T, where it is infinite.
    pub o: Option<Rational>,
}

impl ImplicitEuler {
    /// For gains at one instant and the sample time, s; `None` where they do not determine it: O = 0, or h = 0.
    pub fn new(gains: &Gains, h: &Rational) -> Option<Self> {
        let sums = sums(&gains.scaled);
        let denominator = &gains.power + sums.first()?;
        if denominator.is_zero() || h.is_zero() {
            return None;
        }
        let n = sums.len();
        let f: Vec<Rational> = (0..n).map(|i| &sums[i] / (&denominator * power(h, i + 1))).collect();
        let entry = |i: usize, j: usize| {
            let rises = if j >= i { power(h, j - i) } else { Rational::ZERO };
            rises - power(h, j + 1) * &f[i]
        };
        let z = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let o = (!gains.power.is_zero()).then(|| &denominator / &gains.power);
        Some(Self { z, f, o })
    }
}

/// A power, 0^0 = 1.
fn power(base: &Rational, exponent: usize) -> Rational {
    (0..exponent).fold(Rational::ONE, |power, _| power * base)
}

/// Each the sum of those from it on.
fn sums(terms: &[Rational]) -> Vec<Rational> {
    let mut sums = terms.to_vec();
    for i in (1..sums.len()).rev() {
        sums[i - 1] = &sums[i - 1] + &sums[i];
    }
    sums
}

/// M, n x n: from the scaled states of the implicit Euler chain to those of the exactly discretised one.
///
/// `M (I - A)^-1 = e^A M` and `e_1' M = e_1'`: the same observer in other coordinates. Row i holds the coefficients
/// of (-ln(1 - z))^(i-1), the powers of d/dt in backward differences, up to z^(n-1).
pub fn output_map(n: usize) -> Vec<Vec<Rational>> {
    let mut row = unit(n);
    let logarithm: Vec<Rational> = (0..n).map(|j| if j == 0 { Rational::ZERO } else { over(j) }).collect();
    let mut rows = Vec::with_capacity(n);
    for _ in 0..n {
        let next = product(&row, &logarithm);
        rows.push(std::mem::replace(&mut row, next));
    }
    rows
}

fn unit(n: usize) -> Vec<Rational> {
    (0..n).map(|j| if j == 0 { Rational::ONE } else { Rational::ZERO }).collect()
}

fn over(j: usize) -> Rational {
    Rational::ONE / Rational::from(j)
}

/// Of two power series, to the length of the first.
fn product(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let coefficient = |j: usize| (0..=j).fold(Rational::ZERO, |sum, i| sum + &a[i] * &b[j - i]);
    (0..a.len()).map(coefficient).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::{Matrix, Precision, Real, inverse};

    type Rows = Vec<Vec<Rational>>;

    fn times(a: &Rows, b: &Rows) -> Rows {
        let n = a.len();
        let entry = |i: usize, j: usize| (0..n).fold(Rational::ZERO, |sum, k| sum + &a[i][k] * &b[k][j]);
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    }

    fn rows(n: usize, entry: impl Fn(usize, usize) -> Rational) -> Rows {
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    }

    fn rational(numerator: i64, denominator: u64) -> Rational {
        Rational::from_parts(numerator.into(), denominator.into())
    }

    fn example(n: usize) -> (Vec<Rational>, Rational, Rational) {
        let l = (1..=n).map(|i| rational(7 + 13 * i64::try_from(i * i).unwrap(), 3)).collect();
        (l, rational(5, 2), rational(1, 100))
    }

    /// 003 (12) against I - h (A - D L C) itself, in rationals: no tolerance.
    #[test]
    fn the_closed_form_is_the_inverse() {
        for n in 2..=8 {
            let (l, time, h) = example(n);
            for left in [249, 100, 3, 1] {
                let left = Rational::from(left);
                let euler = ImplicitEuler::new(&Gains::efimov_orlov(&l, &time, &left), &h).unwrap();
                let rho = &time / (&h * &left);
                let inverse = rows(n, |i, j| {
                    let identity = if i == j { Rational::ONE } else { Rational::ZERO };
                    let shift = if j == i + 1 { h.clone() } else { Rational::ZERO };
                    let gain = if j == 0 { &h * &l[i] * power(&rho, i + 1) } else { Rational::ZERO };
                    identity - shift + gain
                });
                let identity = rows(n, |i, j| if i == j { Rational::ONE } else { Rational::ZERO });
                assert_eq!(times(&euler.z, &inverse), identity, "n = {n}");
                let gain: Vec<Rational> = (0..n).map(|i| &l[i] * power(&rho, i + 1)).collect();
                let f: Vec<Rational> =
                    euler.z.iter().map(|row| (0..n).fold(Rational::ZERO, |sum, k| sum + &row[k] * &gain[k])).collect();
                assert_eq!(euler.f, f, "F = Z D L, n = {n}");
            }
        }
    }

    /// The same against a numerical inverse in 60 digits.
    #[test]
    fn the_closed_form_is_a_numerical_inverse_to_55_digits() {
        let p = Precision::digits(60);
        for n in 2..=8 {
            let (l, time, h) = example(n);
            let left = Rational::from(7);
            let gains = Gains::efimov_orlov(&l, &time, &left);
            let z = ImplicitEuler::new(&gains, &h).unwrap().z;
            let real = |x: &Rational| Real::from_rational(x, p);
            let inverted = inverse(&Matrix::from_fn(n, n, |i, j| {
                let gain =
                    if j == 0 { real(&(&gains.scaled[i] / (&gains.power * power(&h, i)))) } else { Real::zero(p) };
                let shift = if j == i + 1 { real(&h) } else { Real::zero(p) };
                let identity = if i == j { Real::one(p) } else { Real::zero(p) };
                identity - shift + gain
            }))
            .unwrap();
            // Of the largest entry; 5 digits are left to the elimination.
            let largest = inverted.max_abs();
            let tolerance = largest * real(&Rational::from_parts(1.into(), dashu_int::UBig::from(10_u8).pow(55)));
            for (entry, exact) in inverted.iter().zip(z.iter().flatten()) {
                assert!((entry - &real(exact)).abs() <= tolerance, "n = {n}");
            }
        }
    }

    #[test]
    fn at_the_prescribed_time_it_is_nilpotent() {
        for n in 2..=8 {
            let (l, time, h) = example(n);
            let euler = ImplicitEuler::new(&Gains::efimov_orlov(&l, &time, &Rational::ZERO), &h).unwrap();
            assert_eq!(euler.o, None);
            let expected = rows(n, |i, j| if j < i { -(Rational::ONE / power(&h, i - j)) } else { Rational::ZERO });
            assert_eq!(euler.z, expected);
            let product = |count: usize| (1..count).fold(euler.z.clone(), |power, _| times(&power, &euler.z));
            let zero = rows(n, |_, _| Rational::ZERO);
            assert_ne!(product(n - 1), zero, "n = {n}");
            assert_eq!(product(n), zero, "n = {n}");
        }
    }

    /// `M (I - A)^-1 = e^A M` and `e_1' M = e_1'`, exactly.
    #[test]
    fn the_output_map_is_a_similarity() {
        for n in 2..=8 {
            let m = output_map(n);
            let ones = rows(n, |i, j| if j >= i { Rational::ONE } else { Rational::ZERO });
            let factorial = |k: usize| (1..=k).fold(Rational::ONE, |product, i| product * Rational::from(i));
            let exponential = rows(n, |i, j| if j >= i { Rational::ONE / factorial(j - i) } else { Rational::ZERO });
            assert_eq!(times(&m, &ones), times(&exponential, &m), "n = {n}");
            assert_eq!(m[0], unit(n));
        }
    }

    #[test]
    fn what_does_not_determine_it_is_refused() {
        let (l, time, h) = example(2);
        let none = Gains::efimov_orlov(&[Rational::ZERO, Rational::ZERO], &time, &Rational::ZERO);
        assert_eq!(ImplicitEuler::new(&none, &h), None);
        assert_eq!(ImplicitEuler::new(&Gains::efimov_orlov(&l, &time, &Rational::ONE), &Rational::ZERO), None);
        assert_eq!(ImplicitEuler::new(&Gains { power: Rational::ONE, scaled: Vec::new() }, &h), None);
    }
}
