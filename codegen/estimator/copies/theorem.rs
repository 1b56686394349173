//! What 001's Theorem 2 says of a plant that is measured at some of the calls only.
//!
//! Corrected where the print is wrong (window-observers, section 1): (27) has F12 in place of F21, as its own proof
//! does in (60). It speaks of the observer in continuous time; |.| is the 2-norm.

use crate::expr::List;
use crate::plant::Plant;
use crate::promise::kernel::slope;
use crate::real::{Matrix, Real, Undefined, singular_values};

use super::exact::Continuous;

/// The theorem's numbers; times in s.
#[derive(Clone, Debug)]
pub struct Theorem2 {
    /// Lipschitz constants of f1 and f2 in the outputs, over their declared ranges; (21), (22).
    pub lipschitz: [f64; 2],
    /// (26).
    pub beta: f64,
    /// (27), corrected.
    pub gamma: f64,
    /// mu gamma(mu), which must be below 1; (28).
    pub condition: f64,
    /// The mu below which it is.
    pub longest_s: f64,
    /// The rate of (29), 1/s, where the condition holds.
    pub rate: Option<f64>,
}

/// f1 and f2's Lipschitz constants; or the texts of the terms whose slope has no bound.
pub fn lipschitz(plant: &Plant, into: &[Vec<f64>]) -> Result<[f64; 2], Vec<String>> {
    let p = plant.outputs.len();
    let mut unbounded = Vec::new();
    // Bounds on the entries of the Jacobian, n x p; its Frobenius norm is above the 2-norm.
    let mut jacobian = vec![vec![0.0; p]; plant.states.len()];
    for (k, injection) in plant.injections.iter().enumerate() {
        for o in 0..p {
            let Some(slope) = slope(plant, k, o) else {
                unbounded.push(injection.text.clone());
                break;
            };
            for (row, weights) in jacobian.iter_mut().zip(into) {
                let through = weights.iter().zip(&injection.column).map(|(t, c)| t * c.to_f64().unwrap_or(f64::NAN));
                row[o] += through.sum::<f64>().abs() * slope;
            }
        }
    }
    if !unbounded.is_empty() {
        return Err(unbounded);
    }
    let norm = |rows: &[Vec<f64>]| deadbeat_math::sqrt_f64(rows.iter().flatten().map(|x| x * x).sum());
    Ok([norm(&jacobian[..p]), norm(&jacobian[p..])])
}

impl Theorem2 {
    /// For mu and nu in s.
    ///
    /// # Errors
    /// Where a bound is beyond all numbers.
    pub fn new(
        continuous: &Continuous,
        gain: &Matrix,
        lipschitz: [f64; 2],
        mu: &Real,
        nu: &Real,
    ) -> Result<Self, Undefined> {
        let precision = gain.precision();
        let norm = |m: &Matrix| singular_values(m).into_iter().next().unwrap_or_else(|| Real::zero(precision));
        let number = |x: f64| Real::from_f64(x, precision).ok_or(Undefined::OutOfRange);
        let (f, pair) = (&continuous.f, &continuous.pair);
        let (f1, f2) = (number(lipschitz[0])?, number(lipschitz[1])?);
        let f3 = &f2 + &(&norm(gain) * &f1);
        let (own, second) = (&norm(&f.rr) * nu, &norm(&pair.h) * nu);
        let driven = norm(&f.ry) + &f2;
        let twice = own.shifted(1).checked_exp()? * &driven;
        let mixed = (&own + &second).checked_exp()? * (norm(&pair.g) + &f3);
        let beta = own.checked_exp()? * &driven + norm(&continuous.e_inverse()) * (mixed + twice);

        let one = Real::one(precision);
        let into_outputs = norm(&f.yr).max(f1);
        let factor = ((nu * &beta).shifted(1) + &one) * into_outputs;
        let fast = norm(&f.yy);
        let gamma = ((mu * &fast).checked_exp()? * &factor).max(one);
        let condition = (mu * &gamma).to_f64();
        let rate = (condition < 1.0).then(|| -deadbeat_math::log_f64(condition) / (mu.to_f64() + 2.0 * nu.to_f64()));
        let longest_s = longest(fast.to_f64(), factor.to_f64());
        Ok(Self { lipschitz, beta: beta.to_f64(), gamma: gamma.to_f64(), condition, longest_s, rate })
    }
}

/// The root of mu max(1, factor exp(mu fast)) = 1, which rises with mu: by bisection, at most 1.
fn longest(fast: f64, factor: f64) -> f64 {
    let holds = |mu: f64| mu * f64::max(1.0, factor * deadbeat_math::exp_f64(mu * fast)) < 1.0;
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..100 {
        let middle = f64::midpoint(low, high);
        if holds(middle) { low = middle } else { high = middle }
    }
    low
}

/// Terms as a message names them.
pub fn named(terms: &[String]) -> String {
    List(&terms.iter().map(String::as_str).collect::<Vec<_>>()).to_string()
}

#[cfg(test)]
mod tests {
    use crate::method::designed;

    const PENDULUM: &str = "deadbeat = 1\nname = 'p'\n[states]\nx1 = { derivative = 'x2' }\nx2 = { derivative = '-sin(x1)' }\n\
                            [outputs]\nx1 = { value = 'x1' }\n[observer.impulsive]\nwindow = 1\nL = [[-1]]\nmeasured_every = 9\n\
                            [target]\nsample_time = '1/90'\nscalar = 'f64'\n";

    /// 1 + 6 e / (e - 1) = 10.4919, so that mu must be below 0.09531 s: 0.1 s is not, 0.09 s (of nu = 0.99 s) is.
    #[test]
    fn the_corrected_condition_decides() {
        let refused = designed(PENDULUM).unwrap_err();
        assert!(refused.contains("mu gamma(mu) = 1.0492, not below 1; mu < 0.09531 s would be"), "{refused}");
        let (_, accepted) = designed(&PENDULUM.replace("= 9\n", "= 9\nunproved = 'accept'\n")).unwrap();
        assert_eq!(accepted.warnings.len(), 1);
        let closer = PENDULUM.replace("'1/90'", "0.01").replace("window = 1", "window = 0.99");
        let (_, proved) = designed(&closer).unwrap();
        assert!(proved.warnings.is_empty());
        assert!(proved.notes.iter().any(|note| note.contains("< 1: proved")), "{:?}", proved.notes);
    }

    /// A slope without a bound proves nothing, and says what would bound it.
    #[test]
    fn an_unbounded_slope_is_said() {
        let cubic = PENDULUM.replace("-sin(x1)", "-x1^3").replace("= 9", "= 3");
        let refused = designed(&cubic).unwrap_err();
        assert!(refused.contains("no bound on the slope of `x1^3`: declare the outputs' `range`"), "{refused}");
        let bounded = cubic.replace("value = 'x1'", "value = 'x1', range = [-0.5, 0.5]");
        assert!(designed(&bounded).is_ok());
    }
}
