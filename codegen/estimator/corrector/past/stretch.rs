//! Some calls of the past in a row, newest first: what they do together to a row that leads from the newest of them, and
//! intervals around what each of them does.

use std::ops::Range;

use nalgebra::{DMatrix, RowDVector};

use super::super::rounds::norm;

/// Which columns are of one cause: noise, disturbances by parts of an interval, signals, what rounding adds.
#[derive(Clone, Debug)]
pub(super) struct Within {
    /// p.
    pub(super) outputs: usize,
    /// d.
    pub(super) disturbances: usize,
    /// Parts of an interval.
    pub(super) parts: usize,
    /// Known signals.
    pub(super) signals: usize,
    /// What rounding adds, where that is asked for: to each coordinate that the step carries, and, per output, to each by
    /// the terms that its correction is the sum of.
    pub(super) carried: usize,
    /// Length of a part, squared, s^2; 0 for a discrete plant.
    pub(super) square: f64,
}

impl Within {
    /// Causes outside the step.
    pub(super) fn known(&self) -> usize {
        self.outputs + self.disturbances + self.signals
    }

    /// Causes.
    pub(super) fn causes(&self) -> usize {
        self.known() + self.carried
    }

    /// The columns of a cause.
    pub(super) fn columns(&self, cause: usize) -> Range<usize> {
        let last = self.outputs + self.disturbances;
        let start = |cause: usize| match cause {
            _ if cause <= self.outputs => cause,
            _ if cause <= last => self.outputs + (cause - self.outputs) * self.parts,
            _ => self.outputs + self.disturbances * self.parts + (cause - last),
        };
        start(cause)..start(cause + 1)
    }

    /// The disturbance that a cause is.
    pub(super) fn disturbance(&self, cause: usize) -> Option<usize> {
        cause.checked_sub(self.outputs).filter(|d| *d < self.disturbances)
    }

    /// Columns of all causes.
    pub(super) fn width(&self) -> usize {
        self.columns(self.causes()).start
    }
}

/// A row with its length.
pub(super) type Measured<'a> = (&'a RowDVector<f64>, f64);

/// Calls in a row.
#[derive(Clone, Debug)]
pub(super) struct Stretch {
    /// How many.
    pub(super) calls: f64,
    /// What they do to a row, n x n, and by how much they make one longer at most.
    pub(super) transition: DMatrix<f64>,
    pub(super) longest: f64,
    /// The sum of what enters, n x columns.
    pub(super) sums: DMatrix<f64>,
    /// Around what enters at each call, and around the first sample's weights after each, n x (columns + p): boxes, and
    /// balls, which grow less over many calls.
    pub(super) low: DMatrix<f64>,
    pub(super) high: DMatrix<f64>,
    pub(super) middle: DMatrix<f64>,
    /// None of what never enters: a sample that is not due says nothing of a sign.
    pub(super) radius: Vec<Option<f64>>,
    /// Bound on a disturbance's slope within an interval, for rows of magnitude 1; n x d.
    pub(super) slope: DMatrix<f64>,
    /// The sum of squares per column, n x n each; of noise only, within a turn.
    pub(super) energy: Vec<DMatrix<f64>>,
}

impl Stretch {
    /// These calls, and then older ones.
    pub(super) fn then(&self, older: &Self) -> Self {
        let t = &self.transition;
        let (positive, negative) = (t.map(|x| x.max(0.0)), t.map(|x| x.min(0.0)));
        let mut low = &positive * &older.low + &negative * &older.high;
        let mut high = &positive * &older.high + &negative * &older.low;
        let mut middle = t * &older.middle;
        let mut radius = self.radius.clone();
        for (column, radius) in radius.iter_mut().enumerate() {
            let Some(mine) = *radius else {
                *radius = older.radius[column].map(|theirs| self.longest * theirs);
                continue;
            };
            let of_mine = |i: usize| (self.low[(i, column)], self.high[(i, column)], self.middle[(i, column)]);
            let Some(theirs) = older.radius[column] else {
                for i in 0..t.nrows() {
                    (low[(i, column)], high[(i, column)], middle[(i, column)]) = of_mine(i);
                }
                continue;
            };
            let apart = (self.middle.column(column) - middle.column(column)).norm();
            let ball = 0.5 * apart + mine.max(self.longest * theirs);
            for i in 0..t.nrows() {
                let ((below, above, one), other) = (of_mine(i), middle[(i, column)]);
                let central = 0.5 * (one + other);
                low[(i, column)] = low[(i, column)].min(below).max(central - ball);
                high[(i, column)] = high[(i, column)].max(above).min(central + ball);
                middle[(i, column)] = central;
            }
            *radius = Some(ball);
        }
        let energy = self.energy.iter().zip(&older.energy).map(|(mine, theirs)| mine + t * theirs * t.transpose());
        let transition = t * &older.transition;
        Self {
            calls: self.calls + older.calls,
            longest: norm(&transition),
            transition,
            sums: &self.sums + t * &older.sums,
            low,
            high,
            middle,
            radius,
            slope: self.slope.zip_map(&(t.abs() * &older.slope), f64::max),
            energy: energy.collect(),
        }
    }

    /// The interval that has what a column does for a row of this length at every call.
    pub(super) fn around(&self, (row, length): Measured, column: usize) -> (f64, f64) {
        let Some(radius) = self.radius[column] else { return (0.0, 0.0) };
        let (low, high, middle) = (self.low.column(column), self.high.column(column), self.middle.column(column));
        let (mut below, mut above, mut central) = (0.0, 0.0, 0.0);
        for (i, x) in row.iter().enumerate() {
            let (at_least, at_most) = if *x >= 0.0 { (low[i], high[i]) } else { (high[i], low[i]) };
            below += x * at_least;
            above += x * at_most;
            central += x * middle[i];
        }
        let far = length * radius;
        (below.max(central - far), above.min(central + far))
    }

    /// The steepest that a disturbance's kernel is for a row at any call.
    pub(super) fn steepest(&self, row: &RowDVector<f64>, disturbance: usize) -> f64 {
        row.iter().zip(self.slope.column(disturbance).iter()).map(|(x, slope)| x.abs() * slope).sum()
    }

    /// The sum of magnitudes of a cause, where each of its columns keeps its sign over all calls.
    pub(super) fn of_one_sign(&self, measured: Measured, cause: usize, within: &Within) -> Option<f64> {
        let (row, _) = measured;
        // Twice what a kernel can change within a part: its edges have the sign too, and nothing cancels within.
        let margin = within.disturbance(cause).map_or(0.0, |d| 2.0 * self.steepest(row, d) * within.square);
        let mut sum = 0.0;
        for column in within.columns(cause) {
            let (below, above) = self.around(measured, column);
            if below < margin && above > -margin {
                return None;
            }
            sum += row.iter().zip(self.sums.column(column).iter()).map(|(x, s)| x * s).sum::<f64>().abs();
        }
        Some(sum)
    }

    /// A bound on the sum of magnitudes of a cause: so many calls of the largest.
    pub(super) fn at_most(&self, measured: Measured, cause: usize, within: &Within) -> f64 {
        let largest = |column| {
            let (below, above) = self.around(measured, column);
            below.abs().max(above.abs())
        };
        self.calls * within.columns(cause).map(largest).sum::<f64>() + self.cancelled(measured.0, cause, within)
    }

    /// A bound by the energy, after Cauchy and Schwarz; where that is known.
    pub(super) fn by_energy(&self, row: &RowDVector<f64>, cause: usize, within: &Within) -> Option<f64> {
        let columns = within.columns(cause);
        let energies = self.energy.get(columns)?;
        let root = |energy: &DMatrix<f64>| deadbeat_math::sqrt_f64(self.calls * square(row, energy));
        Some(energies.iter().map(root).sum::<f64>() + self.cancelled(row, cause, within))
    }

    /// What may cancel within the parts of an interval, over all calls.
    fn cancelled(&self, row: &RowDVector<f64>, cause: usize, within: &Within) -> f64 {
        let each = |d| 0.5 * self.steepest(row, d) * within.square * crate::numbers::count(within.parts);
        self.calls * within.disturbance(cause).map_or(0.0, each)
    }
}

/// `row E row'`, which is not negative.
pub(super) fn square(row: &RowDVector<f64>, energy: &DMatrix<f64>) -> f64 {
    (row * energy).iter().zip(row.iter()).map(|(a, b)| a * b).sum::<f64>().max(0.0)
}
