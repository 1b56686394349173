//! The law's step: corrections from an innovation, branch-free and in a fixed number of operations.

use crate::program::builder::Builder;
use crate::program::{Scalar, Value};
use crate::sampled::weights::constant;

use super::{Sliding, power};

impl Sliding {
    /// Writes `S_1 sign(e) … S_n sign(e)` for an innovation e of at most `largest`, in units of the output; 0 for 0.
    ///
    /// Where `1/c_n` times `largest` or a constant is beyond the float, the caller has refused.
    pub fn corrections(&self, b: &mut Builder, innovation: Value, largest: f64) -> Vec<Value> {
        let zero = b.float(0.0);
        let size = b.absolute(innovation);
        let reach = constant(b, self.reach);
        let taken = b.minimum(size, reach);
        let beyond = b.sub(size, taken);
        let inverse = constant(b, self.inverse);
        let excess = b.mul(beyond, inverse);
        let root = self.root(b, excess, largest);

        let (one, minus_one) = (b.float(1.0), b.float(-1.0));
        let negative = b.less(innovation, zero);
        let sign = b.select(negative, minus_one, one);
        let mut sum = taken;
        let mut corrections = vec![b.mul(sign, sum)];
        let mut root_power = root;
        for (place, term) in self.terms.iter().enumerate().rev() {
            let term = constant(b, *term);
            let term = b.mul(term, root_power);
            sum = b.add(sum, term);
            corrections.push(b.mul(sign, sum));
            if place > 0 {
                root_power = b.mul(root_power, root);
            }
        }
        corrections.reverse();
        corrections
    }

    /// The w at which q is the excess.
    fn root(&self, b: &mut Builder, excess: Value, largest: f64) -> Value {
        let start = self.start(b, excess, largest);
        let rows = vec![vec![0.0]; self.iterations(b.scalar())];
        let newton = b.table("NEWTON", "Newton steps for the root of the gain law", vec!["not read".to_owned()], rows);
        let ratios: Vec<Value> = self.ratios.iter().map(|ratio| constant(b, *ratio)).collect();
        let root = b.loop_over(newton, &[start], |b, carried| {
            let w = carried[0];
            let (value, slope) = polynomial(b, &ratios, w);
            let above = b.sub(value, excess);
            let step = b.div(above, slope);
            vec![b.sub(w, step)]
        });
        root[0]
    }

    /// A start above the root: by the last term alone, or twice the power of two below the excess's n-th root.
    fn start(&self, b: &mut Builder, excess: Value, largest: f64) -> Value {
        let one = b.float(1.0);
        let rows = self.scales(largest, b.scalar());
        let mut scale = one;
        if !rows.is_empty() {
            let columns = ["2^(n k)", "2^(-n k)", "2^k"].map(str::to_owned).to_vec();
            let scales = b.table("SCALES", "powers of two for the start of Newton's method", columns, rows);
            let found = b.loop_over(scales, &[excess, one], |b, carried| {
                let (rest, scale) = (carried[0], carried[1]);
                let (threshold, down, up) = (b.gain(0), b.gain(1), b.gain(2));
                let fits = b.less_equal(threshold, rest);
                let less = b.mul(rest, down);
                let more = b.mul(scale, up);
                vec![b.select(fits, less, rest), b.select(fits, more, scale)]
            });
            scale = found[1];
        }
        let two = b.float(2.0);
        let above = b.mul(two, scale);
        let last = self.ratios.last().copied().unwrap_or_default();
        let last = constant(b, last);
        let linear = b.div(excess, last);
        b.minimum(linear, above)
    }

    /// `2^(n k)`, `2^(-n k)` and `2^k` for k = …, 4, 2, 1, as far as an excess can be.
    fn scales(&self, largest: f64, scalar: Scalar) -> Vec<Vec<f64>> {
        let order = self.order();
        // The float's normal numbers, up and down.
        let exponents = match scalar {
            Scalar::F32 => 126,
            Scalar::F64 => 1022,
        };
        let highest = largest * self.inverse.double;
        let two_to = |k: usize| power(2.0, k);
        let doubled = (0..10).map(|places| 1_usize << places);
        let within = doubled.take_while(|k| two_to(order * k) <= highest && order * k <= exponents);
        let rows = within.map(|k| vec![two_to(order * k), 1.0 / two_to(order * k), two_to(k)]);
        let mut rows: Vec<Vec<f64>> = rows.collect();
        rows.reverse();
        rows
    }
}

/// q and q' at w.
fn polynomial(b: &mut Builder, ratios: &[Value], w: Value) -> (Value, Value) {
    let one = b.float(1.0);
    let (mut value, mut slope) = (one, one);
    for ratio in ratios {
        let rising = b.mul(value, w);
        value = b.add(rising, *ratio);
        let rising = b.mul(slope, w);
        slope = b.add(rising, value);
    }
    (b.mul(value, w), slope)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{law_of, p};
    use super::super::{ExactSliding, ORDERS, whole};
    use super::*;
    use crate::program::interp::Interpreter;
    use crate::program::{Field, Kind, Program, Status};
    use crate::real::Real;

    /// The corrections as estimates of a measured innovation.
    fn program(law: &Sliding, scalar: Scalar, largest: f64) -> Program {
        let mut b = Builder::new("law", scalar, 1.0);
        let field = |name: String| Field { name, unit: String::new(), doc: String::new(), kind: Kind::Float };
        b.measurement(field("e".to_owned()));
        let e = b.read_measurement(0);
        for (j, correction) in law.corrections(&mut b, e, largest).into_iter().enumerate() {
            b.estimate(field(format!("s{j}")), correction);
        }
        let status = b.status(Status::Converged);
        b.report(status);
        b.finish()
    }

    /// `S_1 … S_n` of the law as it is printed, with the exact constants: z by bisection.
    fn printed(law: &ExactSliding, innovation: f64) -> Vec<Real> {
        let order = law.ratios.len() + 1;
        let size = Real::from_f64(innovation, p()).unwrap();
        if size <= law.reach {
            return vec![size; order];
        }
        let excess = &(&size / &law.reach) - &Real::one(p());
        let q = |w: &Real| {
            let powers = (1..=order).rev().map(|m| w.checked_powi(whole(m)).unwrap());
            let one = Real::one(p());
            let coefficients = std::iter::once(&one).chain(&law.ratios);
            powers.zip(coefficients).fold(Real::zero(p()), |sum, (power, d)| &sum + &(&power * d))
        };
        let (mut low, mut high) = (Real::zero(p()), &excess + &Real::one(p()));
        for _ in 0..1400 {
            let middle = (&low + &high).shifted(-1);
            if q(&middle) > excess { high = middle } else { low = middle }
        }
        let mut sum = law.reach.clone();
        let mut sums = vec![sum.clone()];
        for (i, term) in law.terms.iter().enumerate().rev() {
            sum = &sum + &(term * &high.checked_powi(whole(order - 1 - i)).unwrap());
            sums.push(sum.clone());
        }
        sums.reverse();
        sums
    }

    /// The corrections are those of the printed law for every magnitude of innovation, to rounding; odd in it; finite.
    #[test]
    fn the_step_is_the_law_for_every_innovation() {
        for scalar in [Scalar::F32, Scalar::F64] {
            let (epsilon, exponents): (f64, &[i32]) = match scalar {
                Scalar::F32 => (f64::from(f32::EPSILON), &[-30, -12, -6, -4, -2, -1, 0, 1, 3, 7, 14, 18]),
                Scalar::F64 => (f64::EPSILON, &[-200, -12, -6, -4, -2, -1, 0, 1, 3, 7, 14, 40, 200]),
            };
            for order in ORDERS {
                let (exact, law) = law_of(order, 2600.0, 0.125);
                let reach = law.reach.value(scalar);
                let largest = 10.0_f64.powi(*exponents.last().unwrap() + 1) * reach;
                let mut step = Interpreter::new(&program(&law, scalar, largest));
                for exponent in exponents {
                    for factor in [1.0, 1.000_001, 1.3, 2.7, 6.1] {
                        let e = scalar_value(reach * (10.0_f64.powi(*exponent) * factor), scalar);
                        let (mut plus, mut minus) = (vec![0.0; order], vec![0.0; order]);
                        step.step(&[e], &[], &mut plus);
                        step.step(&[-e], &[], &mut minus);
                        for (j, expected) in printed(&exact, e).iter().enumerate() {
                            let error = (plus[j] / expected.to_f64() - 1.0).abs();
                            // The value and the slope are n products and sums each, the power and the sum of the
                            // correction n again, the constants one rounding each.
                            let allowed = 4.0 * f64::from(u32::try_from(order).unwrap()) * epsilon;
                            assert!(error <= allowed, "{scalar} {order} {e:e} S_{}: {error:e}", j + 1);
                            assert_eq!(minus[j], -plus[j]);
                        }
                    }
                }
                let mut zero = vec![1.0; order];
                step.step(&[0.0], &[], &mut zero);
                assert!(zero.iter().all(|s| *s == 0.0));
            }
        }
    }

    fn scalar_value(x: f64, scalar: Scalar) -> f64 {
        match scalar {
            Scalar::F32 => f64::from(single(x)),
            Scalar::F64 => x,
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "it is the rounding that is meant")]
    fn single(x: f64) -> f32 {
        x as f32
    }

    /// Whatever the step meets stays below the growth that is promised to the guard: at the largest innovation that
    /// the float can take by it, nothing overflows.
    #[test]
    fn nothing_overflows_at_the_largest_innovation() {
        for scalar in [Scalar::F32, Scalar::F64] {
            for order in ORDERS {
                for (lipschitz, sample_time) in [(1.0, 1e-3), (1e4, 1.0), (1e-6, 0.1)] {
                    let (_, law) = law_of(order, lipschitz, sample_time);
                    let most = match scalar {
                        Scalar::F32 => f64::from(f32::MAX),
                        Scalar::F64 => f64::MAX,
                    };
                    let largest = scalar_value(most / 16.0 / law.growth(1.0), scalar);
                    assert!(law.growth(largest) <= most);
                    let mut step = Interpreter::new(&program(&law, scalar, largest));
                    let mut corrections = vec![0.0; order];
                    for share in [1.0, 0.5, 1e-3, 1e-9] {
                        let e = scalar_value(largest * share, scalar);
                        step.step(&[e], &[], &mut corrections);
                        assert!(corrections.iter().all(|s| s.is_finite() && *s <= e * 1.001), "{scalar} {order}");
                        assert!(corrections[0] > 0.0 && corrections.windows(2).all(|pair| pair[0] >= pair[1]));
                    }
                }
            }
        }
    }
}
