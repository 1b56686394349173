//! What the observer promises: sums of magnitudes over what one unit of noise does from its call on.
//!
//! The estimate at a call is a linear functional of the samples of the last whole period and of those since; where
//! only every g-th call is measured, of all before, with weights that fall from period to period. Gains are those
//! of the worst call of a period. They are sums over the responses of [`ErrorMap`], so they include what a sample
//! does to the copies, the resets and the predictions that it enters. What they leave out is the run of signals
//! between samples, and, for nonlinear terms, what [`ErrorMap`] does not see: the slope of these is taken as in the
//! method `window` where every call is measured; where not, no bound is given.

use nalgebra::DMatrix;

use crate::plant::Plant;
use crate::promise::Certificate;
use crate::promise::kernel::{Kernel, slope};
use crate::sampled::Source;

use super::Calls;
use super::errors::{ErrorMap, MOST_PERIODS};
use super::known::{Known, depends_on_outputs};
use crate::real::{Matrix, rows};

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
    let nothing = |columns: usize| vec![DMatrix::<f64>::zeros(n, columns); calls.period];
    let (mut l1, mut squares) = (nothing(p), nothing(p));
    let noise = map.noise.doubles();
    let sampled = |call: usize| call.is_multiple_of(calls.every);
    maps.responses(&|_, age| (age == 0).then_some(&noise), &sampled, &mut |phase, response| {
        l1[phase].zip_apply(response, |sum, x| *sum += x.abs());
        squares[phase].zip_apply(response, |sum, x| *sum += x * x);
    });
    let disturbance_gain_l1 = disturbance_gains(plant, map, &maps);
    let noise_gain_l1 = rows(&worst(&l1));
    let noise_gain_l2 = rows(&worst(&squares).map(deadbeat_math::sqrt_f64));
    let through_terms = through_terms(plant, knowns, map, &maps);
    let bound = |i: usize| error_bound(plant, &noise_gain_l1[i], &disturbance_gain_l1[i], through_terms.as_ref(), i);
    let error_bound = (0..n).map(bound).collect();
    Certificate { noise_gain_l1, noise_gain_l2, disturbance_gain_l1, error_bound, ..Certificate::default() }
}

/// Per state and column, the largest over the calls of a period.
fn worst(by_phase: &[DMatrix<f64>]) -> DMatrix<f64> {
    let mut worst = by_phase[0].clone();
    for gains in by_phase {
        worst.zip_apply(gains, |worst, x| *worst = worst.max(x));
    }
    worst
}

fn disturbance_gains(plant: &Plant, map: &ErrorMap, maps: &Maps) -> Vec<Vec<f64>> {
    let (n, count) = (plant.states.len(), plant.disturbances.len());
    if count == 0 {
        return vec![Vec::new(); n];
    }
    let Some(kernel) = Kernel::new(plant) else { return vec![vec![f64::INFINITY; count]; n] };
    let disturbed = [map.disturbed[0].doubles(), map.disturbed[1].doubles()];
    let mut gains = vec![DMatrix::zeros(n, count); maps.calls.period];
    let added =
        |call: usize, age: usize| (age == 0).then(|| &disturbed[usize::from(call.is_multiple_of(maps.calls.every))]);
    maps.responses(&added, &|_| true, &mut |phase, response| kernel.add(response, &mut gains[phase]));
    rows(&worst(&gains))
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
        let columns: Vec<DMatrix<f64>> = map.knowns[s].iter().map(Matrix::doubles).collect();
        let mut gains = vec![DMatrix::<f64>::zeros(n, 1); maps.calls.period];
        maps.responses(&|_, age| columns.get(age), &|_| true, &mut |phase, response| {
            gains[phase].zip_apply(response, |gain, x| *gain += x.abs());
        });
        through.iter_mut().zip(&worst(&gains)).for_each(|(sum, gain)| *sum += gain * level);
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
    free: DMatrix<f64>,
    measured: DMatrix<f64>,
    reset: DMatrix<f64>,
    estimate: DMatrix<f64>,
}

impl<'a> Maps<'a> {
    fn new(map: &ErrorMap, calls: &'a Calls) -> Self {
        Self {
            calls,
            free: map.free.doubles(),
            measured: map.measured.doubles(),
            reset: map.reset.doubles(),
            estimate: map.estimate.doubles(),
        }
    }

    /// Follows a unit that enters at each call of a period of which `enters` holds: `added` by call and age is what
    /// it adds to the errors, `visit` gets each call's place in its period and the error of the plant's states.
    fn responses<'b>(
        &self,
        added: &dyn Fn(usize, usize) -> Option<&'b DMatrix<f64>>,
        enters: &dyn Fn(usize) -> bool,
        visit: &mut dyn FnMut(usize, &DMatrix<f64>),
    ) {
        for first in (1..=self.calls.period).filter(|call| enters(*call)) {
            let Some(start) = added(first, 0) else { continue };
            let mut errors = start.clone();
            let mut peaks = vec![0.0; errors.nrows()];
            for call in first.. {
                if call > first {
                    let measured = call.is_multiple_of(self.calls.every);
                    errors = if measured { &self.measured } else { &self.free } * errors;
                    if let Some(more) = added(call, call - first) {
                        errors += more;
                    }
                }
                let reset = call.is_multiple_of(self.calls.period);
                if reset {
                    errors = &self.reset * errors;
                }
                if reset && self.is_over(call, &errors, &peaks) {
                    break;
                }
                raise(&mut peaks, &errors);
                visit(call % self.calls.period, &(&self.estimate * &errors));
            }
        }
    }

    fn is_over(&self, call: usize, errors: &DMatrix<f64>, peaks: &[f64]) -> bool {
        let most = if self.calls.every == 1 { LASTING } else { 2 * MOST_PERIODS };
        call >= most * self.calls.period
            || errors.row_iter().zip(peaks).all(|(row, peak)| row.iter().all(|x| x.abs() <= OVER * peak))
    }
}

fn raise(peaks: &mut [f64], errors: &DMatrix<f64>) {
    for (peak, row) in peaks.iter_mut().zip(errors.row_iter()) {
        *peak = row.iter().fold(*peak, |peak, x| peak.max(x.abs()));
    }
}
