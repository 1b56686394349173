//! The gain law of the robust exact differentiator: Levant's, as implicit Euler computes it.
//!
//! **Law.** In the scaled chain (`xi_i = h^(i-1) x_i`) the innovation `e = y - xi-_1` is corrected by
//! `xi_j = xi-_j + S_j sign(e)`, `S_j = sum_{i >= j} c_i z^(n-i)`, `c_i = h^i lambda_i L^(i/n)`, where `z^n` is the
//! innovation that the correction leaves: `z^n + c_1 z^(n-1) + … + c_n = |e|`. Up to `|e| = c_n` the sign of nothing
//! takes whatever is there: z = 0, `S_j = |e|`, and the estimate is the backward differences of the last n samples.
//! (Prescribed-time observers, section 5; Levant 2003 for the law and its recursive parameters.)
//!
//! **Scaled.** With `z = c_n^(1/n) w` and `x = |e|/c_n - 1` the equation is `w^n + d_1 w^(n-1) + … + d_(n-1) w = x`,
//! `d_i = lambda_i/lambda_n^(i/n)`: its coefficients are positive and depend on the order alone. So do the start and
//! the number of iterations; the sample time and L enter by `c_n` only.
//!
//! **Newton from above.** The left side q is increasing and convex, so from above every step stays above. Three
//! bounds, for the ratio t of an iterate to the root:
//! 1. From t one step leads to at most `t - t (1 - t^(-n))/n`: that is the step for `w^n`, and the step for `w^m`,
//!    `t - t (1 - t^(-m))/m`, is the less the smaller m; a polynomial's step is a mean of its powers' steps.
//! 2. With `t = 1 + s` that is at most `1 + (n-1)/2 s^2`, as `w q''/q' <= n-1`.
//! 3. The start `min(x/d_(n-1), 2^k)`, `2^k` above the n-th root of x by at most 2, is above the root by at most the
//!    ratio at which both bounds are equal, since the first grows with the root and the second falls.
//!
//! So a number of iterations is enough for every innovation, however large, once it is for that ratio.

mod bound;
mod step;

pub use bound::Backward;

use crate::program::Scalar;
use crate::real::{Precision, Real, Undefined};
use crate::sampled::settle::Pass;
use crate::sampled::settled::Settled;

/// Orders with published parameters: n states, so n-1 derivatives.
pub const ORDERS: std::ops::RangeInclusive<usize> = 2..=6;

/// The recursive parameters of Levant's differentiator in tenths, from the highest derivative's on.
const RECURSIVE: [i64; 6] = [11, 15, 20, 30, 50, 80];

/// The law's constants at one precision.
#[derive(Clone, Debug)]
pub struct ExactSliding {
    /// `c_n`: the innovation that a correction takes away whole, in units of the output.
    pub reach: Real,
    /// `1/c_n`.
    pub inverse: Real,
    /// `d_1 … d_(n-1)`.
    pub ratios: Vec<Real>,
    /// `c_n d_i`, i = 1 … n-1, in units of the output.
    pub terms: Vec<Real>,
}

/// The law's constants, rounded once; as in [`ExactSliding`].
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "said there")]
pub struct Sliding {
    pub reach: Settled,
    pub inverse: Settled,
    pub ratios: Vec<Settled>,
    pub terms: Vec<Settled>,
}

/// `lambda_1 … lambda_n` for n states: `lambda_1` is the recursive parameter of its place, and
/// `lambda_i = (recursive of i) lambda_(i-1)^((n-i)/(n-i+1))`.
///
/// # Errors
/// None for [`ORDERS`]; a power's for others.
pub fn parameters(order: usize, p: Precision) -> Result<Vec<Real>, Undefined> {
    let mut lambdas: Vec<Real> = Vec::new();
    for left in (0..order).rev() {
        let tenths = RECURSIVE.get(left).ok_or(Undefined::OutOfRange)?;
        let own = quotient(*tenths, 10, p)?;
        lambdas.push(match lambdas.last() {
            None => own,
            Some(before) => &own * &before.checked_powf(&quotient(whole(left), whole(left + 1), p)?)?,
        });
    }
    Ok(lambdas)
}

impl ExactSliding {
    /// For n states, `lipschitz` > 0 on the magnitude of the n-th derivative, in units of the output per s^n, and the
    /// sample time in s.
    ///
    /// # Errors
    /// A power beyond all range.
    pub fn new(order: usize, lipschitz: &Real, sample_time: &Real, p: Precision) -> Result<Self, Undefined> {
        let lambdas = parameters(order, p)?;
        let last = lambdas.last().ok_or(Undefined::OutOfRange)?;
        let reach = &(last * lipschitz) * &sample_time.checked_powi(whole(order))?;
        let inverse = Real::one(p).checked_div(&reach)?;
        let mut ratios = Vec::new();
        for (i, lambda) in (1..order).zip(&lambdas) {
            ratios.push(lambda.checked_div(&last.checked_powf(&quotient(whole(i), whole(order), p)?)?)?);
        }
        let terms = ratios.iter().map(|ratio| ratio * &reach).collect();
        Ok(Self { reach, inverse, ratios, terms })
    }

    /// Rounded once, with a finer run.
    pub(crate) fn settled(&self, fine: &Self, pass: &mut Pass) -> Sliding {
        let mut all = |coarse: &[Real], fine: &[Real]| -> Vec<Settled> {
            pass.each(coarse, fine).into_iter().map(Option::unwrap_or_default).collect()
        };
        let one = |values: Vec<Settled>| values[0];
        Sliding {
            reach: one(all(std::slice::from_ref(&self.reach), std::slice::from_ref(&fine.reach))),
            inverse: one(all(std::slice::from_ref(&self.inverse), std::slice::from_ref(&fine.inverse))),
            ratios: all(&self.ratios, &fine.ratios),
            terms: all(&self.terms, &fine.terms),
        }
    }
}

impl Sliding {
    /// n: the states.
    pub fn order(&self) -> usize {
        self.ratios.len() + 1
    }

    /// The largest number that the step meets on its way to the corrections, for innovations up to `largest`; at
    /// least that.
    pub fn growth(&self, largest: f64) -> f64 {
        let n = count(self.order());
        let ratios = self.doubles();
        // q of the start, which is at most `start_ratio` above the root; then Horner's partial sums and q' for w < 1.
        let highest = power(start_ratio(&ratios), self.order()) * (largest * self.inverse.double).max(1.0);
        let small = 1.0 + ratios.iter().sum::<f64>();
        largest.max(n * highest.max(small))
    }

    /// Newton steps that bring every start to its root, to the last bit of the float but for rounding.
    pub fn iterations(&self, scalar: Scalar) -> usize {
        let rounding = match scalar {
            Scalar::F32 => f64::from(f32::EPSILON) / 4.0,
            Scalar::F64 => f64::EPSILON / 4.0,
        };
        let n = count(self.order());
        let mut above = start_ratio(&self.doubles()) - 1.0;
        let mut steps = 0;
        while above > rounding {
            let ratio = 1.0 + above;
            // Bound 2 where bound 1 would lose its digits.
            above = if above < 0.01 {
                (n - 1.0) / 2.0 * above * above
            } else {
                ratio - ratio * (1.0 - 1.0 / power(ratio, self.order())) / n - 1.0
            };
            steps += 1;
        }
        steps
    }

    /// `|S_j - |e||` of the largest innovation, per j: by how much a correction falls short of that of backward
    /// differences, which takes the whole innovation. It grows with the innovation.
    pub fn shortfall(&self, innovation: f64) -> Vec<f64> {
        let excess = (innovation * self.inverse.double - 1.0).max(0.0);
        let ratios = self.doubles();
        let mut root = start(&ratios, excess);
        for _ in 0..self.iterations(Scalar::F64) {
            let (value, slope) = polynomial(&ratios, root);
            root -= (value - excess) / slope;
        }
        // What is left: z^n, and the terms before the j-th.
        let mut left = power(root, self.order());
        let mut all = vec![left];
        for (i, ratio) in ratios.iter().enumerate() {
            left += ratio * power(root, self.order() - 1 - i);
            all.push(left);
        }
        all.into_iter().map(|left| left * self.reach.double).collect()
    }

    fn doubles(&self) -> Vec<f64> {
        self.ratios.iter().map(|ratio| ratio.double).collect()
    }
}

/// q and q' at w, by Horner.
fn polynomial(ratios: &[f64], w: f64) -> (f64, f64) {
    let (mut value, mut slope) = (1.0, 0.0);
    for ratio in ratios.iter().copied().chain([0.0]) {
        slope = slope * w + value;
        value = value * w + ratio;
    }
    (value, slope)
}

/// The iteration's start for an excess x: bound 3.
fn start(ratios: &[f64], excess: f64) -> f64 {
    let order = ratios.len() + 1;
    let linear = excess / ratios.last().copied().unwrap_or(1.0);
    let mut doubling = 1.0;
    while power(doubling, order) <= excess && doubling.is_finite() {
        doubling *= 2.0;
    }
    linear.min(doubling)
}

/// The largest ratio of a start to its root: where `q(w)/(d_(n-1) w)`, which grows, meets `2 q(w)^(1/n)/w`, which falls.
fn start_ratio(ratios: &[f64]) -> f64 {
    let order = ratios.len() + 1;
    let last = ratios.last().copied().unwrap_or(1.0);
    let linear = |w: f64| polynomial(ratios, w).0 / (last * w);
    // Equal when q^(n-1) = (2 d)^n: no root is needed to see which is larger.
    let grows_past = |w: f64| {
        let value = polynomial(ratios, w).0;
        power(value, order - 1) > power(2.0 * last, order)
    };
    let (mut low, mut high) = (0.0, 1.0);
    while !grows_past(high) {
        high *= 2.0;
    }
    // Far more halvings than a double has digits.
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if grows_past(middle) { high = middle } else { low = middle }
    }
    linear(high)
}

fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

fn count(n: usize) -> f64 {
    u32::try_from(n).map_or(f64::INFINITY, f64::from)
}

fn whole(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}

fn quotient(over: i64, under: i64, p: Precision) -> Result<Real, Undefined> {
    Real::from_i64(over, p).checked_div(&Real::from_i64(under, p))
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn p() -> Precision {
        Precision::bits(256)
    }

    fn doubles(order: usize) -> Vec<f64> {
        parameters(order, p()).unwrap().iter().map(Real::to_f64).collect()
    }

    /// Levant's parameters in the form without recursion, as they are published to two decimals (Levant and Livne
    /// 2020 for two to five states; the sixth is of 8, not of 7).
    #[test]
    fn the_parameters_are_the_published_ones() {
        let published: [&[f64]; 4] =
            [&[1.5, 1.1], &[2.0, 2.12, 1.1], &[3.0, 4.16, 3.06, 1.1], &[5.0, 10.03, 9.30, 4.57, 1.1]];
        for expected in published {
            let found = doubles(expected.len());
            assert_eq!(found.len(), expected.len());
            for (found, expected) in found.iter().zip(expected) {
                // Half a unit of the second decimal, and Levant's cutting of 4.575 to 4.57.
                assert!((found - expected).abs() < 0.006, "{found} {expected}");
            }
        }
        // 8, 5 8^(4/5), 3 (…)^(3/4), …: by hand.
        let by_hand = [8.0, 26.390_158, 34.929_963, 21.371, 6.934_27, 1.1];
        for (found, expected) in doubles(6).iter().zip(by_hand) {
            assert!((found - expected).abs() < 1e-3, "{found} {expected}");
        }
        assert!(parameters(7, p()).is_err());
    }

    pub(super) fn law_of(order: usize, lipschitz: f64, sample_time: f64) -> (ExactSliding, Sliding) {
        let real = |x: f64| Real::from_f64(x, p()).unwrap();
        let exact = ExactSliding::new(order, &real(lipschitz), &real(sample_time), p()).unwrap();
        let all = |values: &[Real]| values.iter().map(Settled::round).collect();
        let rounded = Sliding {
            reach: Settled::round(&exact.reach),
            inverse: Settled::round(&exact.inverse),
            ratios: all(&exact.ratios),
            terms: all(&exact.terms),
        };
        (exact, rounded)
    }

    fn law(order: usize, lipschitz: f64, sample_time: f64) -> Sliding {
        law_of(order, lipschitz, sample_time).1
    }

    /// Only `c_n` knows the sample time and L; it is `lambda_n h^n L`, and the terms are the law's `c_i z^(n-i)` with
    /// `z = c_n^(1/n) w`.
    #[test]
    fn the_scaled_law_is_the_law() {
        let (order, h, l) = (4_usize, 0.01_f64, 2600.0_f64);
        let law = self::law(order, l, h);
        assert!((law.reach.double / (1.1 * h.powi(4) * l) - 1.0).abs() < 1e-15);
        let lambdas = doubles(order);
        let w = 3.0_f64;
        let z = law.reach.double.powf(0.25) * w;
        for i in 1..order {
            let c = h.powi(i32::try_from(i).unwrap()) * lambdas[i - 1] * l.powf(count(i) / 4.0);
            let plain = c * power(z, order - i);
            let scaled = law.terms[i - 1].double * power(w, order - i);
            // A dozen roundings in doubles.
            assert!((plain / scaled - 1.0).abs() < 1e-14, "{i}: {plain} {scaled}");
        }
        let other = self::law(order, 3.0, 0.5);
        assert_eq!(law.ratios, other.ratios);
    }

    /// The number of iterations, by the three bounds; and no start that was tried needs more, over all magnitudes.
    #[test]
    fn the_iterations_are_enough_for_every_innovation() {
        for (order, single, double) in [(2, 5, 6), (3, 7, 8), (4, 8, 9), (5, 11, 12), (6, 13, 15)] {
            let law = self::law(order, 1.0, 1.0);
            assert_eq!((law.iterations(Scalar::F32), law.iterations(Scalar::F64)), (single, double), "{order}");
            let ratios = law.doubles();
            let widest = start_ratio(&ratios);
            // From one root to the next by a thousandth: the excess is that of a known root.
            let mut root = 1e-12_f64;
            while root < 1e45 {
                let excess = polynomial(&ratios, root).0;
                let mut w = start(&ratios, excess);
                assert!(w >= root * (1.0 - 1e-15) && w <= root * widest * (1.0 + 1e-12), "{order}: {w} {root}");
                for _ in 0..double {
                    let (value, slope) = polynomial(&ratios, w);
                    w -= (value - excess) / slope;
                }
                // Rounding of the value, n operations, over w q'/q >= 1, and of the excess.
                assert!((w / root - 1.0).abs() <= 2.0 * count(order) * f64::EPSILON, "{order}: {w} {root}");
                root *= 1.001;
            }
        }
    }

    /// Up to the reach a correction takes all; beyond it `S_1` leaves `z^n` and `S_n` takes `c_n`.
    #[test]
    fn the_shortfall_is_what_backward_differences_would_take_more() {
        for order in ORDERS {
            let law = self::law(order, 7.0, 0.1);
            let reach = law.reach.double;
            assert!(law.shortfall(reach).iter().all(|left| *left == 0.0));
            for innovation in [1.5 * reach, 20.0 * reach, 1e9 * reach] {
                let left = law.shortfall(innovation);
                assert_eq!(left.len(), order);
                assert!(left.windows(2).all(|pair| pair[0] < pair[1]));
                let last = left[order - 1];
                assert!((last / (innovation - reach) - 1.0).abs() < 1e-13, "{order}: {last}");
            }
        }
    }
}
