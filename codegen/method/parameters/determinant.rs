//! Assumption 2 of 002: whether `det M(t)` of (5) vanishes, for factors of time; and the constants that say so.

use super::super::window::VERDICT_BITS;
use crate::numbers::seconds;
use crate::plant::Plant;
use crate::real::{Precision, Real};
use crate::sampled::unknowns::paper::{Constants, Exosystem, Times, constants};
use crate::sampled::unknowns::stages::{Stages, Theorem};

/// Calls at which det M(t) is looked at.
const CALLS: usize = 20_000;

/// The first time at which `det M(t)` of (5) changes its sign; `None` where it does not, or M is not that of Theorem 1.
pub(super) fn vanishing(plant: &Plant, stages: &Stages, shifts: &[usize]) -> Option<f64> {
    if stages.theorem != Theorem::One {
        return None;
    }
    let exosystems: Vec<Exosystem> = plant.unknowns.iter().map(Exosystem::of).collect::<Option<_>>()?;
    let rows: Vec<Vec<f64>> = exosystems
        .iter()
        .map(|exosystem| Some(continuous(plant, exosystem, stages)?.w.to_f64()[0].clone()))
        .collect::<Option<_>>()?;
    let h = plant.sample_time_s();
    let from = shifts.last().copied().unwrap_or(0) + stages.window + stages.integration;
    let entry = |i: usize, call: usize| -> f64 {
        rows[i].iter().zip(exosystems[i].at(seconds(call, h))).map(|(w, member)| w * member).sum()
    };
    let determinant = |call: usize| {
        let matrix = (0..shifts.len()).map(|i| shifts.iter().map(|shift| entry(i, call - shift)).collect()).collect();
        determinant(matrix)
    };
    let mut before = determinant(from);
    (from..from + CALLS).find_map(|call| {
        let now = determinant(call);
        let changes = now == 0.0 || (now < 0.0) != (before < 0.0);
        before = now;
        changes.then(|| seconds(call, h))
    })
}

/// By elimination with the largest pivots.
fn determinant(mut rows: Vec<Vec<f64>>) -> f64 {
    let mut product = 1.0;
    for k in 0..rows.len() {
        let largest = (k..rows.len()).fold(k, |best, i| if rows[i][k].abs() > rows[best][k].abs() { i } else { best });
        if rows[largest][k] == 0.0 {
            return 0.0;
        }
        if largest != k {
            rows.swap(largest, k);
            product = -product;
        }
        product *= rows[k][k];
        let (done, rest) = rows.split_at_mut(k + 1);
        for row in rest {
            let factor = row[k] / done[k][k];
            row.iter_mut().zip(&done[k]).for_each(|(x, y)| *x -= factor * y);
        }
    }
    product
}

/// 002's constants in continuous time.
pub(super) fn continuous(plant: &Plant, exosystem: &Exosystem, stages: &Stages) -> Option<Constants> {
    let p = Precision::bits(VERDICT_BITS);
    let h = plant.sample_time.0.evaluate(p).ok()?;
    let time = |samples: usize| Some(&h * &Real::from_i64(i64::try_from(samples).ok()?, p));
    let (window, integration, delay) = (time(stages.window)?, time(stages.integration)?, time(stages.delay)?);
    let times = Times { window: &window, integration: &integration, delay: &delay };
    constants(plant, exosystem, times, p).ok()
}
