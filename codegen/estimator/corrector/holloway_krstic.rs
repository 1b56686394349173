//! 004's constants, exactly: the transformation's pbar, its inverse qbar, the gain polynomials hbar.
//!
//! Both ways: by the recursion of Lemma 1 ((18)-(23)) and in the closed form that it collapses to
//! (prescribed-time-observers, section 2: found by fit, verified exactly on a grid, not proved; the tests here verify
//! it again). Rows i = 1 … n, columns j = 1 … i, and powers of `mu_1` k = 0 … i for hbar.
//!
//! Misprints: in (8), (9) the last factor is the error of the first state; in (24), (25) `-l_i z_1`; Theorem 1's
//! interval ends at t0 + T.

use super::law::{binomial, falling};
use crate::real::Rational;

/// Lower triangles, or rows of polynomials.
pub type Rows = Vec<Vec<Rational>>;

fn whole(n: usize) -> Rational {
    Rational::from(n)
}

fn power(base: &Rational, n: usize) -> Rational {
    (0..n).fold(Rational::ONE, |product, _| product * base)
}

fn lower(n: usize, entry: impl Fn(usize, usize) -> Rational) -> Rows {
    let cell = |i: usize, j: usize| if j > i { Rational::ZERO } else { entry(i, j) };
    (1..=n).map(|i| (1..=n).map(|j| cell(i, j)).collect()).collect()
}

/// `pbar_ij = (-1)^(i-j) C(n-j, i-j) (n+m+i-j-1)! / ((n+m-1)! T^(i-j))`.
pub fn pbar(n: usize, m: usize, time: &Rational) -> Rows {
    lower(n, |i, j| {
        let d = i - j;
        let size = binomial(n - j, d) * falling(n + m + d - 1, d) / power(time, d);
        if d % 2 == 0 { size } else { -size }
    })
}

/// `qbar_ij = C(n-j, i-j) (n+m)! / ((n+m-(i-j))! T^(i-j))`.
pub fn qbar(n: usize, m: usize, time: &Rational) -> Rows {
    lower(n, |i, j| binomial(n - j, i - j) * falling(n + m, i - j) / power(time, i - j))
}

/// `hbar_ik = l_(i-k) C(n-i+k, k) (n+m)! / ((n+m-k)! T^k)` with `l_0 = 1`: `g_i = sum_k hbar_ik mu_1^k` (36).
pub fn hbar(m: usize, l: &[Rational], time: &Rational) -> Rows {
    let n = l.len();
    let entry = |i: usize, k: usize| {
        let factor = binomial(n - i + k, k) * falling(n + m, k) / power(time, k);
        if k == i { factor } else { factor * &l[i - k - 1] }
    };
    (1..=n).map(|i| (0..=i).map(|k| entry(i, k)).collect()).collect()
}

/// pbar by (18)-(21).
pub fn pbar_by_recursion(n: usize, m: usize, time: &Rational) -> Rows {
    let mut p = vec![vec![Rational::ZERO; n + 1]; n + 2];
    (1..=n).for_each(|i| p[i][i] = Rational::ONE);
    for i in (2..=n).rev() {
        for j in (2..=i).rev() {
            let below = if i == n { Rational::ZERO } else { p[i + 1][j].clone() };
            p[i][j - 1] = below - whole(n + m + i - j) / time * &p[i][j];
        }
    }
    (1..=n).map(|i| (1..=n).map(|j| p[i][j].clone()).collect()).collect()
}

/// hbar by (22), (23): the powers of `mu_1` collected.
pub fn hbar_by_recursion(m: usize, l: &[Rational], time: &Rational) -> Rows {
    let n = l.len();
    let p = pbar_by_recursion(n, m, time);
    let mut rows: Rows = Vec::new();
    for i in 1..=n {
        let mut row = vec![Rational::ZERO; i + 1];
        row[0].clone_from(&l[i - 1]);
        let next = if i == n { Rational::ZERO } else { p[i][0].clone() };
        row[i] += whole(n + m + i - 1) / time * &p[i - 1][0] - next;
        for (j, earlier) in rows.iter().enumerate() {
            for (k, coefficient) in earlier.iter().enumerate() {
                row[k + i - 1 - j] -= coefficient * &p[i - 1][j];
            }
        }
        rows.push(row);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(a: i64, b: i64) -> Rational {
        Rational::from(a) / Rational::from(b)
    }

    fn product(a: &Rows, b: &Rows) -> Rows {
        let n = a.len();
        let entry = |i: usize, j: usize| (0..n).fold(Rational::ZERO, |sum, k| sum + &a[i][k] * &b[k][j]);
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    }

    /// Recursion and closed form are the same rationals for orders to 10; qbar is the inverse of pbar.
    #[test]
    fn closed_forms_are_the_recursions() {
        for n in 2..=10 {
            for m in [1, 2, 3, 7] {
                for time in [ratio(1, 1), ratio(5, 2), ratio(3, 10)] {
                    let p = pbar(n, m, &time);
                    assert_eq!(p, pbar_by_recursion(n, m, &time), "order {n}, m {m}");
                    let one = lower(n, |i, j| if i == j { Rational::ONE } else { Rational::ZERO });
                    assert_eq!(product(&p, &qbar(n, m, &time)), one);
                    for scale in 0..3_i64 {
                        let l: Vec<Rational> =
                            (1..=n).map(|i| ratio(scale * i64::try_from(i * i).unwrap(), 3)).collect();
                        assert_eq!(hbar(m, &l, &time), hbar_by_recursion(m, &l, &time), "order {n}, m {m}");
                    }
                }
            }
        }
    }

    /// Proposition 1's last row, (28), is the closed form's.
    #[test]
    fn the_last_row_is_proposition_1() {
        for (n, m) in [(3, 1), (5, 2), (8, 3)] {
            let time = ratio(5, 2);
            for j in 1..n {
                let size = falling(2 * n + m - j - 1, n - j) / power(&time, n - j);
                let expected = if (n - j) % 2 == 0 { size } else { -size };
                assert_eq!(pbar(n, m, &time)[n - 1][j - 1], expected);
            }
        }
    }
}
