//! What the observer promises: sums of magnitudes over what one unit of noise does from its call on.
//!
//! The estimate at a call is a linear functional of the samples of the last whole period and of those since; where
//! only every g-th call is measured, of all before, with weights that fall from period to period. Gains are those
//! of the worst call of a period. They are sums over the responses of [`ErrorMap`], so they include what a sample
//! does to the copies, the resets and the predictions that it enters. What they leave out is the run of signals
//! between samples, and, for nonlinear terms, what [`ErrorMap`] does not see: the slope of these is taken as in the
//! method `window` where every call is measured; where not, no bound is given.

use crate::plant::Plant;
use crate::promise::Certificate;
use crate::promise::kernel::{Kernel, slope};
use crate::sampled::Source;

use super::Calls;
use super::errors::{ErrorMap, MOST_PERIODS};
use super::known::{Known, depends_on_outputs};
use crate::dense::{Rows, product, sum};

/// What is left of a response when it counts as over; gains are that exact.
const OVER: f64 = 1e-10;
/// Multiplications that a certificate may take.
const MOST_WORK: f64 = 2e9;
/// Periods after which a response is over where every call is measured: its own, and one for what is left in z2 by
/// a sample that a reset used.
const LASTING: usize = 3;

/// The longest period, in calls, that is certified for a plant with so many states, outputs and disturbances.
pub fn longest_period(states: usize, outputs: usize, ages: usize, disturbed: bool) -> usize {
    let size = 2 * (states - outputs) + outputs * ages;
    let columns = outputs + if disturbed { states } else { 0 };
    let each = crate::numbers::count(LASTING * size * size * columns);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a positive number below 2^31")]
    let longest = deadbeat_math::sqrt_f64(MOST_WORK / each) as usize;
    longest
}

/// Sums up a design.
pub fn certify(plant: &Plant, knowns: &[Known], map: &ErrorMap, calls: &Calls) -> Certificate {
    let maps = Maps::new(map, calls);
    let (n, p) = (plant.states.len(), plant.outputs.len());
    let nothing = |columns: usize| vec![vec![vec![0.0; columns]; n]; calls.period];
    let (mut l1, mut squares) = (nothing(p), nothing(p));
    let noise = map.noise.to_f64();
    let sampled = |call: usize| call.is_multiple_of(calls.every);
    maps.responses(&|_, age| (age == 0).then_some(&noise), &sampled, &mut |phase, response| {
        for ((response, l1), squares) in response.iter().zip(&mut l1[phase]).zip(&mut squares[phase]) {
            for ((x, l1), square) in response.iter().zip(l1).zip(squares) {
                *l1 += x.abs();
                *square += x * x;
            }
        }
    });
    let disturbance_gain_l1 = disturbance_gains(plant, map, &maps);
    let noise_gain_l1 = worst(&l1);
    let noise_gain_l2: Rows =
        worst(&squares).iter().map(|row| row.iter().map(|x| deadbeat_math::sqrt_f64(*x)).collect()).collect();
    let through_terms = through_terms(plant, knowns, map, &maps);
    let bound = |i: usize| error_bound(plant, &noise_gain_l1[i], &disturbance_gain_l1[i], through_terms.as_ref(), i);
    let error_bound = (0..n).map(bound).collect();
    Certificate { noise_gain_l1, noise_gain_l2, disturbance_gain_l1, error_bound, initial_gain: Vec::new() }
}

/// Per state and column, the largest over the calls of a period.
fn worst(by_phase: &[Rows]) -> Rows {
    let mut worst = by_phase[0].clone();
    for rows in by_phase {
        for (worst, row) in worst.iter_mut().zip(rows) {
            worst.iter_mut().zip(row).for_each(|(worst, x)| *worst = worst.max(*x));
        }
    }
    worst
}

fn disturbance_gains(plant: &Plant, map: &ErrorMap, maps: &Maps) -> Rows {
    let (n, count) = (plant.states.len(), plant.disturbances.len());
    if count == 0 {
        return vec![Vec::new(); n];
    }
    let Some(kernel) = Kernel::new(plant) else { return vec![vec![f64::INFINITY; count]; n] };
    let disturbed = [map.disturbed[0].to_f64(), map.disturbed[1].to_f64()];
    let mut gains = vec![vec![vec![0.0; count]; n]; maps.calls.period];
    let added =
        |call: usize, age: usize| (age == 0).then(|| &disturbed[usize::from(call.is_multiple_of(maps.calls.every))]);
    maps.responses(&added, &|_| true, &mut |phase, response| kernel.add(response, &mut gains[phase]));
    worst(&gains)
}

/// Per state, what noise of the declared level does by way of the nonlinear terms; `None` without a bound.
fn through_terms(plant: &Plant, knowns: &[Known], map: &ErrorMap, maps: &Maps) -> Option<Vec<f64>> {
    let n = plant.states.len();
    let mut through = vec![0.0; n];
    for (s, known) in knowns.iter().enumerate() {
        let Source::Injection(k) = known.source else { continue };
        if !depends_on_outputs(&plant.injections[k].symbols()) {
            continue;
        }
        if maps.calls.every > 1 {
            return None;
        }
        let mut level = 0.0;
        for (o, output) in plant.outputs.iter().enumerate() {
            level += slope(plant, k, o)? * output.noise.as_ref()?.to_f64().ok()?;
        }
        let columns: Vec<Rows> = map.knowns[s].iter().map(crate::real::Matrix::to_f64).collect();
        let mut gains = vec![vec![vec![0.0]; n]; maps.calls.period];
        maps.responses(&|_, age| columns.get(age), &|_| true, &mut |phase, response| {
            gains[phase].iter_mut().zip(response).for_each(|(gain, x)| gain[0] += x[0].abs());
        });
        through.iter_mut().zip(worst(&gains)).for_each(|(sum, gain)| *sum += gain[0] * level);
    }
    Some(through)
}

fn error_bound(
    plant: &Plant,
    noise: &[f64],
    disturbance: &[f64],
    through_terms: Option<&Vec<f64>>,
    state: usize,
) -> Option<f64> {
    let mut bound = through_terms?[state];
    for (output, gain) in plant.outputs.iter().zip(noise) {
        bound += gain * output.noise.as_ref()?.to_f64().ok()?;
    }
    for (d, gain) in plant.disturbances.iter().zip(disturbance) {
        bound += gain * d.bound.to_f64().ok()?;
    }
    bound.is_finite().then_some(bound)
}

/// The error maps in doubles.
struct Maps<'a> {
    calls: &'a Calls,
    free: Rows,
    measured: Rows,
    reset: Rows,
    estimate: Rows,
}

impl<'a> Maps<'a> {
    fn new(map: &ErrorMap, calls: &'a Calls) -> Self {
        Self {
            calls,
            free: map.free.to_f64(),
            measured: map.measured.to_f64(),
            reset: map.reset.to_f64(),
            estimate: map.estimate.to_f64(),
        }
    }

    /// Follows a unit that enters at each call of a period of which `enters` holds: `added` by call and age is what
    /// it adds to the errors, `visit` gets each call's place in its period and the error of the plant's states.
    fn responses<'b>(
        &self,
        added: &dyn Fn(usize, usize) -> Option<&'b Rows>,
        enters: &dyn Fn(usize) -> bool,
        visit: &mut dyn FnMut(usize, &Rows),
    ) {
        for first in (1..=self.calls.period).filter(|call| enters(*call)) {
            let Some(start) = added(first, 0) else { continue };
            let mut errors = start.clone();
            let mut peaks = vec![0.0; errors.len()];
            for call in first.. {
                if call > first {
                    let measured = call.is_multiple_of(self.calls.every);
                    errors = product(if measured { &self.measured } else { &self.free }, &errors);
                    if let Some(more) = added(call, call - first) {
                        errors = sum(&errors, more);
                    }
                }
                let reset = call.is_multiple_of(self.calls.period);
                if reset {
                    errors = product(&self.reset, &errors);
                }
                if reset && self.is_over(call, &errors, &peaks) {
                    break;
                }
                raise(&mut peaks, &errors);
                visit(call % self.calls.period, &product(&self.estimate, &errors));
            }
        }
    }

    fn is_over(&self, call: usize, errors: &Rows, peaks: &[f64]) -> bool {
        let most = if self.calls.every == 1 { LASTING } else { 2 * MOST_PERIODS };
        call >= most * self.calls.period
            || errors.iter().zip(peaks).all(|(row, peak)| row.iter().all(|x| x.abs() <= OVER * peak))
    }
}

fn raise(peaks: &mut [f64], errors: &Rows) {
    for (peak, row) in peaks.iter_mut().zip(errors) {
        *peak = row.iter().fold(*peak, |peak, x| peak.max(x.abs()));
    }
}
