//! Normal equations in the step: `G z = b` for a symmetric positive semidefinite G, by `L D L'`.
//!
//! The number of operations is fixed. A pivot at or below the threshold is not divided by; it says that the rows that
//! were summed do not determine every unknown.

use crate::program::Value;
use crate::program::builder::Builder;

/// The upper triangle of a symmetric matrix, row by row.
pub(crate) fn triangle(n: usize) -> Vec<(usize, usize)> {
    (0..n).flat_map(|i| (i..n).map(move |j| (i, j))).collect()
}

/// z, and whether every pivot was above the threshold; `upper` is G's upper triangle as [`triangle`] orders it.
pub(crate) fn solve(b: &mut Builder, upper: &[Value], right: &[Value], threshold: f64) -> (Vec<Value>, Value) {
    let n = right.len();
    let mut g = vec![vec![None; n]; n];
    for ((i, j), value) in triangle(n).into_iter().zip(upper) {
        g[i][j] = Some(*value);
    }
    let at = |g: &Vec<Vec<Option<Value>>>, i: usize, j: usize| g[i][j].unwrap_or(right[0]);
    let mut z = right.to_vec();
    let mut enough = b.boolean(true);
    let (least, one) = (b.float(threshold), b.float(1.0));
    let mut pivots = Vec::new();
    for k in 0..n {
        let pivot = at(&g, k, k);
        let above = b.less(least, pivot);
        enough = b.and(enough, above);
        let pivot = b.select(above, pivot, one);
        pivots.push(pivot);
        for i in k + 1..n {
            let factor = b.div(at(&g, k, i), pivot);
            for j in i..n {
                let product = b.mul(factor, at(&g, k, j));
                g[i][j] = Some(b.sub(at(&g, i, j), product));
            }
            let product = b.mul(factor, z[k]);
            z[i] = b.sub(z[i], product);
        }
    }
    for k in (0..n).rev() {
        let mut sum = z[k];
        for (j, known) in z.iter().enumerate().skip(k + 1) {
            let product = b.mul(at(&g, k, j), *known);
            sum = b.sub(sum, product);
        }
        z[k] = b.div(sum, pivots[k]);
    }
    (z, enough)
}
