//! `k = "auto"`: the k whose single-delay observer amplifies bounded noise least.
//!
//! The sum of the logarithms of the estimated states' worst-case gains is searched over `k tau`, on a grid and then
//! by golden section, so that no state's unit counts more than another's. The window is thinned for it: k is a
//! choice, not a constant that has to be exact, and is rounded to three digits so that it can be read.

use crate::real::{Matrix, Real};

use super::innovation::Innovation;
use crate::sampled::coordinates::Coordinates;
use crate::sampled::model::Model;

/// Bits of the search, at first; the Gramian of a fast plant loses most of them.
pub const BITS: usize = 512;
/// Samples to which a window is thinned.
const SAMPLES: usize = 60;
/// `k tau` is searched between these.
const RANGE: (f64, f64) = (-12.0, 36.0);
/// Points of the grid.
const GRID: u32 = 25;
/// Steps of the golden section: to a thousandth of the grid's pitch.
const SECTIONS: u32 = 16;

/// The best k, 1/s, for a window of `steps` samples of `h` seconds; `None` where no k gives weights.
pub fn best_k(model: &Model, coordinates: &Coordinates, steps: usize, h: f64) -> Option<f64> {
    let stride = steps.div_ceil(SAMPLES);
    let (samples, h) = (steps / stride, h * crate::numbers::count(stride));
    let thinned = Model { phi: model.phi.powi(stride as u64), effects: Vec::new(), ..model.clone() };
    let tau = h * crate::numbers::count(samples);
    let cost = |x: f64| cost(&thinned, coordinates, samples, x / tau * h);
    let pitch = (RANGE.1 - RANGE.0) / f64::from(GRID - 1);
    let grid = (0..GRID).map(|i| RANGE.0 + pitch * f64::from(i));
    let (best, least) = grid.map(|x| (x, cost(x))).min_by(|a, b| a.1.total_cmp(&b.1))?;
    if !least.is_finite() {
        return None;
    }
    let x = golden(&cost, (best - pitch).max(RANGE.0), (best + pitch).min(RANGE.1));
    Some(format!("{:.2e}", x / tau).parse().unwrap_or(0.0))
}

/// The place of the least value between two bounds.
fn golden(cost: &dyn Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (high - RATIO * (high - low), low + RATIO * (high - low));
    let (mut at_a, mut at_b) = (cost(a), cost(b));
    for _ in 0..SECTIONS {
        if at_a <= at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - RATIO * (high - low);
            at_a = cost(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + RATIO * (high - low);
            at_b = cost(b);
        }
    }
    f64::midpoint(low, high)
}

/// The sum of the logarithms of the gains, for `k h`.
fn cost(model: &Model, coordinates: &Coordinates, steps: usize, kh: f64) -> f64 {
    let gains = || -> Option<f64> {
        let a = (-Real::from_f64(kh, model.phi.precision())?).checked_exp().ok()?;
        let (form, _) = Innovation::single_delay(model, coordinates, &a, steps).ok()?;
        let weights = form.weights(model, steps);
        let gain = |state: &usize| -> f64 {
            let of = |m: &Matrix| -> f64 {
                (0..m.cols()).map(|o| m.get(*state, o).to_f64().abs() / model.trust[o].to_f64()).sum()
            };
            weights.iter().map(of).sum()
        };
        Some(coordinates.rest.iter().map(gain).map(deadbeat_math::log_f64).sum())
    };
    gains().filter(|cost| cost.is_finite()).unwrap_or(f64::INFINITY)
}
