//! Normal equations in the step, `G z = b` for a symmetric positive semidefinite G, by elimination: what answers
//! `t' z` are, and their variances `t' G^-1 t` for rows with noise of variance 1.
//!
//! The number of operations is fixed. Elimination leaves a direction what the directions before it do not show as well;
//! where that is no more than its rounding, it is not divided by, and the rows that were summed do not determine every
//! unknown. As shares of the diagonal these pivots do not depend on the rows' units: a sensor with much noise is no
//! worse conditioned than one with little. Answers come from the eliminated sides alone, so that no unknown itself,
//! which may be large where nothing asks for it, is computed.

use crate::program::Value;
use crate::program::builder::Builder;

/// The upper triangle of a symmetric matrix, row by row.
pub(crate) fn triangle(n: usize) -> Vec<(usize, usize)> {
    (0..n).flat_map(|i| (i..n).map(move |j| (i, j))).collect()
}

/// What the equations say.
pub(crate) struct Answers {
    /// `t' z` for each t.
    pub(crate) values: Vec<Value>,
    /// `t' G^-1 t` for each t.
    pub(crate) variances: Vec<Value>,
    /// Whether every pivot was above its rounding.
    pub(crate) sound: Value,
}

/// The answers for the rows t, zeros of which are structural; `upper` is G's upper triangle as [`triangle`] orders it. A pivot counts above
/// `tolerance` times its diagonal, and above `floor`.
pub(crate) fn solve(
    b: &mut Builder,
    (upper, right): (&[Value], &[Value]),
    rows: &[Vec<Option<f64>>],
    (tolerance, floor): (f64, f64),
) -> Answers {
    let n = right.len();
    let mut g = vec![vec![right[0]; n]; n];
    for ((i, j), value) in triangle(n).into_iter().zip(upper) {
        g[i][j] = *value;
    }
    let mut z = right.to_vec();
    let mut asked: Vec<Vec<Option<Value>>> =
        rows.iter().map(|row| row.iter().map(|entry| entry.map(|entry| b.float(entry))).collect()).collect();
    let (tolerance, floor, one) = (b.float(tolerance), b.float(floor), b.float(1.0));
    let least: Vec<Value> = (0..n)
        .map(|k| {
            let share = b.mul(tolerance, g[k][k]);
            b.add(share, floor)
        })
        .collect();
    let mut sound = b.boolean(true);
    let (mut values, mut variances) = (vec![None; asked.len()], vec![None; asked.len()]);
    for k in 0..n {
        let above = b.less(least[k], g[k][k]);
        sound = b.and(sound, above);
        let pivot = b.select(above, g[k][k], one);
        let factors: Vec<Value> = (k + 1..n).map(|i| b.div(g[k][i], pivot)).collect();
        let row = g[k].clone();
        for (i, factor) in (k + 1..n).zip(&factors) {
            for (entry, above) in g[i].iter_mut().zip(&row).skip(i) {
                let product = b.mul(*factor, *above);
                *entry = b.sub(*entry, product);
            }
            let product = b.mul(*factor, z[k]);
            z[i] = b.sub(z[i], product);
        }
        let shown = b.div(z[k], pivot);
        for (row, (value, variance)) in asked.iter_mut().zip(values.iter_mut().zip(&mut variances)) {
            let Some(t) = row[k] else { continue };
            for (i, factor) in (k + 1..n).zip(&factors) {
                let product = b.mul(*factor, t);
                row[i] = Some(match row[i] {
                    Some(rest) => b.sub(rest, product),
                    None => b.neg(product),
                });
            }
            let part = b.mul(t, shown);
            *value = Some(value.map_or(part, |sum| b.add(sum, part)));
            let share = b.div(t, pivot);
            let part = b.mul(t, share);
            *variance = Some(variance.map_or(part, |sum| b.add(sum, part)));
        }
    }
    let mut all = |of: Vec<Option<Value>>| of.into_iter().map(|it| it.unwrap_or_else(|| b.float(0.0))).collect();
    Answers { values: all(values), variances: all(variances), sound }
}
