//! Which samples may enter the state: a bound such that nothing computed from them overflows.
//!
//! All sums are linear in what entered, so they are bounded by multiples of the bound b on samples and signals, b at
//! least 1, and it is enough that the largest multiple times b is below a sixteenth of the largest float.
//!
//! 1. What stands for an output is a sample within b or its range, a prediction that was found within it, or the
//!    value before: at most b. Signals are guarded likewise.
//! 2. Right after a start or a reset z1 is at most `limit` times b, entry by entry, since the step looks: a reset
//!    that gives more starts the observer again. The limit is twice what N+1 samples of size b can give in exact
//!    arithmetic, so that only rounding errors beyond all use, or predictions that feed on themselves, reach it.
//! 3. In between, r calls later, z1 is `A^r z1 + sum_j A^j (what entered)`: bounded with the powers of the copy's
//!    own matrix for the at most N calls of a period, and so is z2.
//!
//! No input and no number of calls without samples can therefore make the state non-finite.

use nalgebra::{DMatrix, DVector};

use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::sampled::settled::Settled;
use crate::step::guard::{Guard, lost};

use super::weights::both;
use super::{Grid, Impulsive, Update};

/// Bounds on what a reset may give.
#[derive(Debug)]
pub struct Bounds {
    /// Per entry of z1: the largest magnitude after a reset.
    pub limits: Vec<f64>,
}

/// How far beyond exact arithmetic's largest a reset may come.
const SLACK: f64 = 2.0;

impl Bounds {
    /// Finds the bounds, and those on samples, inputs and injections; a constant that the target's floats cannot hold is
    /// an error.
    pub fn new(plant: &Plant, design: &Impulsive) -> Result<(Self, Guard), Vec<Diagnostic>> {
        refuse_lost_constants(plant, design)?;
        let multiples = Multiples::new(plant, design);
        let guard = Guard::with_gain(plant, multiples.largest, 0.0)?;
        let limits = multiples.limits.iter().map(|limit| plant.scalar_value(limit * guard.bound)).collect();
        Ok((Self { limits }, guard))
    }
}

/// The constants by matrix and column, without absent ones.
fn constants(design: &Impulsive) -> Vec<Vec<Settled>> {
    let entries = |grid: &Grid| grid.iter().flatten().flatten().copied().collect::<Vec<_>>();
    let mut all = vec![entries(&design.gain), entries(&design.back)];
    for update in [&design.first, &design.second, &design.predictor] {
        all.push(entries(&update.copy));
        all.extend(update.outputs.iter().map(entries));
        all.extend(update.knowns.iter().flatten().map(|column| column.iter().flatten().copied().collect()));
        all.push(update.constant.iter().flatten().copied().collect());
    }
    all
}

/// Refuses constants beyond the target's floats, and matrices all of whose entries are below them; but X, which is
/// that small where the first copy forgets by itself.
fn refuse_lost_constants(plant: &Plant, design: &Impulsive) -> Result<(), Vec<Diagnostic>> {
    let smallest = match plant.scalar {
        Scalar::F32 => f64::from(f32::MIN_POSITIVE),
        Scalar::F64 => f64::MIN_POSITIVE,
    };
    let reset: Vec<Settled> = design.reset.iter().flatten().flatten().copied().collect();
    let all = constants(design);
    if let Some(beyond) = all.iter().chain([&reset]).flatten().find(|c| !c.value(plant.scalar).is_finite()) {
        return Err(vec![lost(plant, "large", beyond.double)]);
    }
    for group in &all {
        let largest = group.iter().map(|c| c.double.abs()).fold(0.0, f64::max);
        if largest > 0.0 && largest < smallest {
            return Err(vec![lost(plant, "small", largest)]);
        }
    }
    Ok(())
}

/// Entries as doubles, absent ones as 0.
fn doubles(grid: &Grid, cols: usize) -> DMatrix<f64> {
    let value = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double);
    DMatrix::from_fn(grid.len(), cols, |i, j| grid[i].get(j).map_or(0.0, value))
}

/// Sums of magnitudes by row.
fn sizes(matrix: &DMatrix<f64>) -> DVector<f64> {
    matrix.abs().column_sum()
}

/// What enters an update, a column each, with the constant terms last.
fn entering(update: &Update, outputs: usize) -> DMatrix<f64> {
    let of_outputs = update.outputs.iter().map(|grid| doubles(grid, outputs));
    let columns = update.knowns.iter().flatten().chain(std::iter::once(&update.constant));
    let columns = columns.map(|column| doubles(&column.iter().map(|entry| vec![*entry]).collect(), 1));
    let parts: Vec<DMatrix<f64>> = of_outputs.chain(columns).collect();
    let columns: Vec<_> = parts.iter().flat_map(DMatrix::column_iter).collect();
    DMatrix::from_columns(&columns)
}

/// Bounds as multiples of b.
struct Multiples {
    limits: DVector<f64>,
    largest: f64,
}

impl Multiples {
    fn new(plant: &Plant, design: &Impulsive) -> Self {
        let (p, rest) = (plant.outputs.len(), design.rest.len());
        let [first, second] = [&design.first, &design.second].map(|update| doubles(&update.copy, rest));
        let [into_first, into_second] = [&design.first, &design.second].map(|update| entering(update, p));
        let (reset, gain) = (doubles(&design.reset, rest), doubles(&design.gain, p));
        let initial = |i: &usize| plant.states[*i].initial.to_f64().unwrap_or(0.0).abs();
        let starts = DVector::from_iterator(rest, design.rest.iter().map(initial));

        // From a common start at 0: what N+1 samples give, by the copies' weights in the reset from its call back.
        let [mut kept, mut taken] = both(&reset);
        let mut given = sizes(&(&reset * &gain));
        for _ in 0..design.calls.period {
            given += sizes(&(&kept * &into_first + &taken * &into_second));
            kept *= &first;
            taken *= &second;
        }
        given += sizes(&(&taken * &gain));
        let limits = SLACK * given + starts;

        let of_gain = sizes(&gain);
        let period = design.calls.period;
        let z1 = largest_over(period, &first, &into_first, &limits);
        let z2 = largest_over(period, &second, &into_second, &(&limits + &of_gain));
        let difference = &z1 + &z2 + &of_gain;
        let after = reset.abs() * &difference + &z1;
        let new_second = &after + &of_gain;
        // A prediction guesses the signals' newest values from up to three before: at most 7 of them.
        let predictor = &design.predictor;
        let predicted = doubles(&predictor.copy, rest).abs() * &z1 + 8.0 * sizes(&entering(predictor, p));
        let of_first = first.abs() * &z1 + sizes(&into_first);
        let of_second = second.abs() * &z2 + sizes(&into_second);
        let n = plant.states.len();
        let carried = DVector::from_fn(n, |j, _| if j < p { 1.0 } else { z1[j - p].max(after[j - p]) });
        let estimate = doubles(&design.back, n).abs() * carried;
        let measured =
            |s: &crate::plant::State| -> f64 { s.measured.iter().map(|(_, w)| w.to_f64().unwrap_or(0.0).abs()).sum() };
        let shown = plant.states.iter().map(measured);
        let all = [of_first, of_second, predicted, difference, new_second, estimate];
        let all = all.iter().flat_map(DVector::iter).copied().chain(shown);
        let largest = all.fold(1.0, |largest: f64, x| if x.is_finite() { largest.max(x) } else { f64::INFINITY });
        Self { limits, largest }
    }
}

/// The largest magnitudes of a copy over a period, for what enters at most 1.
fn largest_over(period: usize, copy: &DMatrix<f64>, entering: &DMatrix<f64>, start: &DVector<f64>) -> DVector<f64> {
    let mut power = DMatrix::identity(copy.nrows(), copy.nrows());
    let mut entered = DVector::zeros(copy.nrows());
    let mut largest = start.clone();
    for _ in 0..period {
        entered += sizes(&(&power * entering));
        power *= copy;
        largest.zip_apply(&(power.abs() * start + &entered), |largest, x| *largest = largest.max(x));
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::designed;

    /// A period of samples at the bound stays where the bounds say, on a plant that grows by 1e3 over a period, in
    /// both float types.
    #[test]
    fn what_enters_at_the_bound_does_not_overflow() {
        let text = "deadbeat = 1\nname = 'f'\n[states]\nx = { derivative = 'v' }\nv = { derivative = '49*x' }\n[outputs]\n\
                    x = { value = 'x' }\n[observer.impulsive]\nwindow = 1\n[target]\nsample_time = 0.05\nscalar = 'f32'\n";
        for text in [text.to_owned(), text.replace("f32", "f64")] {
            let (plant, design) = designed(&text).unwrap();
            let shape = design.estimator.downcast_ref::<Impulsive>().unwrap();
            let (_, guard) = Bounds::new(&plant, shape).unwrap();
            let program = design.estimator.lower(&plant, None, &design.certificate).unwrap();
            let mut interpreter = crate::program::interp::Interpreter::new(&program);
            let bound = guard.bound;
            let mut estimate = [0.0; 2];
            for call in 0..200 {
                // The signs that a reset's weights have, and others.
                let sign = if call * call % 7 < 3 { 1.0 } else { -1.0 };
                interpreter.step(&[sign * bound], &[], &mut estimate);
                assert!(estimate.iter().all(|x| x.is_finite()));
                assert!(interpreter.cells().iter().flat_map(|(_, held)| held).all(|x| x.is_finite()));
            }
        }
    }
}
