//! Gauss-Jordan elimination in rationals.

use dashu_ratio::RBig;

/// Reduces the rows over their first columns; the columns of the pivots, one per row from the first on.
pub(super) fn reduce(rows: &mut [Vec<RBig>], columns: usize) -> Vec<usize> {
    let mut pivots = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(pivot) = (done..rows.len()).find(|row| !rows[*row][column].is_zero()) else { continue };
        rows.swap(done, pivot);
        let scale = RBig::ONE / &rows[done][column];
        rows[done].iter_mut().for_each(|x| *x *= &scale);
        let source = rows[done].clone();
        for (row, entries) in rows.iter_mut().enumerate() {
            if row != done && !entries[column].is_zero() {
                let factor = entries[column].clone();
                entries.iter_mut().zip(&source).for_each(|(x, s)| *x -= &factor * s);
            }
        }
        pivots.push(column);
    }
    pivots
}
