//! The equations of the unknowns, `S eps = b`, by L D L'.
//!
//! A pivot is what an unknown shows that neither the state nor the unknowns before it explain. Where it is
//! not above its threshold, all of them are given up for this call, and no division by it is made.

use crate::program::{Scalar, Value};

use super::Step;
use super::gather::Gathered;

impl Step<'_> {
    /// The unknowns, scaled, and whether they are determined.
    pub(super) fn solve(&mut self, gathered: &Gathered) -> (Vec<Value>, Value) {
        let q = gathered.right.len();
        let bound = self.lowering.sensors.guard.bound;
        let mut determined = self.lowering.builder.boolean(true);
        let mut l: Vec<Vec<Value>> = Vec::new();
        let mut pivots: Vec<Value> = Vec::new();
        for i in 0..q {
            // Row i of L D and of L.
            let (mut above, mut factors): (Vec<Value>, Vec<Value>) = (Vec::new(), Vec::new());
            for j in 0..i {
                let entry = self.reduced(gathered.normal[i][j], &above, &l[j]);
                above.push(entry);
                factors.push(self.lowering.builder.div(entry, pivots[j]));
            }
            let pivot = self.reduced(gathered.normal[i][i], &above, &factors);
            let passes = self.passes(pivot, gathered.energy[i], self.regression.floors[i]);
            let b = &mut self.lowering.builder;
            determined = b.and(determined, passes);
            let one = b.float(1.0);
            pivots.push(b.select(passes, pivot, one));
            l.push(factors);
        }
        let mut forward: Vec<Value> = Vec::new();
        for (right, row) in gathered.right.iter().zip(&l) {
            let value = self.reduced(*right, &forward, row);
            forward.push(value);
        }
        let mut values: Vec<Value> = Vec::new();
        for i in (0..q).rev() {
            let own = self.lowering.builder.div(forward[i], pivots[i]);
            let below: Vec<Value> = (i + 1..q).rev().map(|k| l[k][i]).collect();
            let value = self.reduced(own, &values, &below);
            values.push(value);
        }
        values.reverse();
        for value in &values {
            let b = &mut self.lowering.builder;
            let sane = b.in_range(*value, -bound, bound);
            determined = b.and(determined, sane);
        }
        (values, determined)
    }

    /// `value - sum x y`.
    fn reduced(&mut self, value: Value, xs: &[Value], ys: &[Value]) -> Value {
        let b = &mut self.lowering.builder;
        let products: Vec<Value> = xs.iter().zip(ys).map(|(x, y)| b.mul(*x, *y)).collect();
        if products.is_empty() {
            return value;
        }
        let sum = b.sum(&products);
        b.sub(value, sum)
    }

    /// Whether a pivot is a large enough share of its gamma's energy, and that more than noise gives; and both above
    /// where products lose digits.
    fn passes(&mut self, pivot: Value, energy: Value, floor: f64) -> Value {
        let plant = self.lowering.plant;
        let smallest = match plant.scalar {
            Scalar::F32 => f64::from(f32::MIN_POSITIVE / f32::EPSILON),
            Scalar::F64 => f64::MIN_POSITIVE / f64::EPSILON,
        };
        let threshold = plant.scalar_value(self.regression.threshold);
        let floor = plant.scalar_value(floor);
        let b = &mut self.lowering.builder;
        let (smallest, threshold, floor) = (b.float(smallest), b.float(threshold), b.float(floor));
        let share = b.mul(threshold, energy);
        let (large, exact, alive) = (b.less(share, pivot), b.less(smallest, pivot), b.less_equal(floor, energy));
        let large = b.and(large, exact);
        b.and(large, alive)
    }
}
