//! The size of an error: the root mean square of what it does to the outputs over some calls.

use crate::real::{Matrix, Precision, Real, inverse, orthonormal};

/// Calls over which the size of an error is measured, at most; spread over all until V.
const MOST_LOOKS: usize = 256;

/// Coordinates in which the size of an error is the root mean square of the outputs over so many calls, from states;
/// and states from them.
pub(in super::super) fn coordinates(phi: &Matrix, c: &Matrix, calls: usize) -> Option<(Matrix, Matrix)> {
    let p = Precision::bits(512);
    let (phi, mut row) = (phi.with_precision(p), c.with_precision(p));
    let stride = calls.div_ceil(MOST_LOOKS).max(1);
    let far = phi.powi(u64::try_from(stride).ok()?);
    let mut rows = row.clone();
    // The first n calls in any case: fewer would not show every state.
    for _ in 1..phi.rows() {
        row = &row * &phi;
        rows = rows.vcat(&row);
    }
    for _ in (phi.rows()..calls).step_by(stride) {
        row = &row * &far;
        rows = rows.vcat(&row);
    }
    let (_, back) = orthonormal(&rows).ok()?;
    let looks = Real::from_i64(i64::try_from(rows.rows()).ok()?, p).checked_sqrt().ok()?;
    let back = back.scale(&looks);
    Some((inverse(&back).ok()?, back))
}
