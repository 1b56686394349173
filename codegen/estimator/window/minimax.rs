//! The unbiased weights with the smallest worst-case noise gain.
//!
//! For one state: minimise `sum |k_r|` subject to `sum k_r O_r = c`, a linear program whose optimum
//! uses n of the rows. Any n independent rows are a start (the signs of the weights make it
//! feasible), and the simplex method goes from there; which rows it ends at is all that is kept,
//! since the weights on them are solved for again at every precision.

use crate::real::{Matrix, Precision, Real, equilibrated_columns, solve};

/// Bits at which the rows are chosen.
const BITS: usize = 256;
/// A gain that falls by less than this factor of itself, in bits, is not worth another exchange.
const TOLERANCE_BITS: f64 = -96.0;
/// Exchanges by steepest descent, per state, before the rule that cannot cycle takes over.
const STEEPEST: usize = 50;

/// Per target row of `targets` (m x n): the n rows of `rows` (r x n, full column rank) that carry its weights.
pub fn best_rows(rows: &Matrix, targets: &Matrix) -> Vec<Vec<usize>> {
    let p = Precision::bits(BITS);
    let (scaled, exponents) = equilibrated_columns(&rows.with_precision(p));
    let targets = Matrix::from_fn(targets.rows(), targets.cols(), |i, j| {
        targets.get(i, j).with_precision(p).shifted(exponents[j])
    });
    let start = independent_rows(&scaled);
    (0..targets.rows())
        .map(|i| {
            let target = targets.block(i..i + 1, 0..targets.cols());
            Exchange { rows: &scaled, target: &target, basis: start.clone() }.run()
        })
        .collect()
}

/// The weights on chosen rows: `k B = c` with B the rows (n x n), c the target (1 x n).
pub fn weights(rows: &Matrix, chosen: &[usize], target: &Matrix) -> Option<Vec<Real>> {
    let n = rows.cols();
    let basis = Matrix::from_fn(n, n, |i, j| rows.get(chosen[j], i).clone());
    let solution = solve(&basis, &target.transpose()).ok()?;
    Some((0..n).map(|j| solution.get(j, 0).clone()).collect())
}

/// n rows far from dependent: in each step the one with the largest part outside those taken.
fn independent_rows(rows: &Matrix) -> Vec<usize> {
    let n = rows.cols();
    let mut rest = rows.clone();
    let mut taken = Vec::new();
    for _ in 0..n {
        let square =
            |m: &Matrix, r: usize| Real::sum_of_products((0..n).map(|j| (m.get(r, j), m.get(r, j))), m.precision());
        let Some(best) = (0..rest.rows()).filter(|r| !taken.contains(r)).max_by_key(|r| square(&rest, *r)) else {
            break;
        };
        let norm = square(&rest, best);
        taken.push(best);
        if norm.is_zero() {
            continue;
        }
        let direction: Vec<Real> = (0..n).map(|j| rest.get(best, j).clone()).collect();
        for r in 0..rest.rows() {
            let along = Real::sum_of_products((0..n).map(|j| (rest.get(r, j), &direction[j])), rest.precision());
            let share = &along / &norm;
            for j in 0..n {
                rest[(r, j)] = rest.get(r, j) - &(&share * &direction[j]);
            }
        }
    }
    taken
}

/// The simplex method for one state.
struct Exchange<'a> {
    rows: &'a Matrix,
    target: &'a Matrix,
    basis: Vec<usize>,
}

impl Exchange<'_> {
    fn run(mut self) -> Vec<usize> {
        let most = STEEPEST * self.rows.cols() + self.rows.rows();
        for round in 0..most {
            if !self.improve(round < STEEPEST * self.rows.cols()) {
                break;
            }
        }
        self.basis.sort_unstable();
        self.basis
    }

    /// One exchange; false when none helps.
    fn improve(&mut self, steepest: bool) -> bool {
        let n = self.rows.cols();
        let p = self.rows.precision();
        let Some(weights) = weights(self.rows, &self.basis, self.target) else { return false };
        let signs = Matrix::from_fn(n, 1, |i, _| Real::from_i64(if weights[i].is_negative() { -1 } else { 1 }, p));
        let basis = Matrix::from_fn(n, n, |i, j| self.rows.get(self.basis[i], j).clone());
        let Ok(price) = solve(&basis, &signs) else { return false };
        let Some((entering, value)) = self.entering(&price, steepest) else { return false };
        let row = self.rows.block(entering..entering + 1, 0..n);
        let Ok(direction) = solve(&basis.transpose(), &row.transpose()) else { return false };
        // The weight that reaches zero first leaves.
        let leaving = (0..n)
            .filter_map(|j| {
                let along = direction.get(j, 0);
                let falls = (along.is_negative() != value.is_negative()) == weights[j].is_negative();
                (falls && !along.is_zero()).then(|| (&weights[j].abs() / &along.abs(), self.basis[j], j))
            })
            .min();
        let Some((_, _, leaving)) = leaving else { return false };
        self.basis[leaving] = entering;
        true
    }

    /// A row whose use would lower the gain, with its price.
    fn entering(&self, price: &Matrix, steepest: bool) -> Option<(usize, Real)> {
        let n = self.rows.cols();
        let one = Real::one(self.rows.precision());
        let priced = (0..self.rows.rows()).filter(|r| !self.basis.contains(r)).filter_map(|r| {
            let value = Real::sum_of_products((0..n).map(|j| (self.rows.get(r, j), price.get(j, 0))), one.precision());
            let excess = &value.abs() - &one;
            (!excess.is_negative() && excess.log2_abs() > TOLERANCE_BITS).then_some((excess, r, value))
        });
        let mut priced = priced;
        let found = if steepest { priced.max_by(|a, b| a.0.cmp(&b.0)) } else { priced.next() };
        found.map(|(_, r, value)| (r, value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slope of a line through equally good samples is best taken from the two ends.
    #[test]
    fn a_slope_uses_the_ends() {
        let p = Precision::bits(BITS);
        let rows = Matrix::from_fn(11, 2, |i, j| Real::from_i64(if j == 0 { 1 } else { i64::try_from(i).unwrap() }, p));
        let slope = Matrix::from_fn(1, 2, |_, j| Real::from_i64(i64::try_from(j).unwrap(), p));
        assert_eq!(best_rows(&rows, &slope), vec![vec![0, 10]]);
    }
}
