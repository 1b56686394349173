//! What is large and what is small for a plant, whatever its units; and what rounding costs, measured so.

use crate::real::{Matrix, Real, inverse};
use crate::sampled::coordinates::Blocks;

use crate::dense::{Rows, both, identity, product};

/// What is large and what is small for a plant, whatever its units.
pub struct Size {
    /// Of `x_r`: what one unit of the outputs' trust, once in the window, leaves unknown of it.
    rest: Vec<f64>,
    /// Of the entries of L.
    pub(super) gain: Rows,
    /// S with `S S' = W^-1`, W the Gramian of `x_r` over the window: what is alike in its columns' coordinates.
    root: Rows,
    /// A first L, `-W^-1 Phi_yr'`, in these coordinates.
    pub(super) start: Rows,
}

impl Size {
    /// Of a sampled plant.
    pub fn new(blocks: &Blocks, trust: &[f64], period: usize) -> Option<Self> {
        let (p, rest, precision) = (blocks.yr.rows(), blocks.rr.rows(), blocks.rr.precision());
        let mut weights = Matrix::zeros(p, p, precision);
        for (o, trust) in trust.iter().enumerate() {
            weights[(o, o)] = Real::from_f64(*trust, precision)?;
        }
        let mut gramian = Matrix::zeros(rest, rest, precision);
        let mut seen = &weights * &blocks.yr;
        for _ in 0..period {
            gramian = &gramian + &(&seen.transpose() * &seen);
            seen = &seen * &blocks.rr;
        }
        let spread = inverse(&gramian).ok()?;
        let root = square_root(&spread)?;
        let samples = Real::from_f64(crate::numbers::count(period), precision)?.checked_sqrt().ok()?;
        let start = (&root.transpose() * &(&weights * &blocks.yr).transpose()).scale(&-&samples).to_f64();
        let root = root.map(|x| x / &samples).to_f64();
        let samples = samples.to_f64();
        let size = |i: usize| deadbeat_math::sqrt_f64(spread.get(i, i).to_f64().max(0.0));
        let sizes: Vec<f64> = (0..rest).map(size).collect();
        let gain: Rows = sizes.iter().map(|size| trust.iter().map(|trust| size * trust / samples).collect()).collect();
        let fine = start.iter().chain(&root).flatten().all(|x| x.is_finite());
        let fine = fine && gain.iter().flatten().all(|x| x.is_normal());
        fine.then_some(Self { rest: sizes, gain, root, start })
    }

    /// L from these coordinates.
    pub(super) fn gain_of(&self, alike: &Rows, trust: &[f64]) -> Rows {
        let mut gain = product(&self.root, alike);
        for row in &mut gain {
            row.iter_mut().zip(trust).for_each(|(x, trust)| *x *= trust);
        }
        gain
    }

    /// By how much a period and its reset multiply the rounding error of one call: the sum over the calls of what
    /// both copies, as large as they become from a wrong start, add to the estimate.
    pub fn amplification(&self, [first, second]: [&Matrix; 2], x: &Matrix, gain: &Rows, period: usize) -> f64 {
        let (first, second) = (first.to_f64(), second.to_f64());
        let [mut kept, mut taken] = both(&x.to_f64());
        // z2 is of the size of x_r + L y.
        let shift = |j: usize| self.rest[j] * gain[j].iter().zip(&self.gain[j]).map(|(l, s)| l.abs() / s).sum::<f64>();
        let shifted: Vec<f64> = (0..gain.len()).map(|j| self.rest[j] + shift(j)).collect();
        let (of_first, of_second) = (grown(&first, &self.rest, period), grown(&second, &self.rest, period));
        let mut sums = vec![0.0; gain.len()];
        for call in (0..period).rev() {
            for (i, sum) in sums.iter_mut().enumerate() {
                let share = |j: usize| {
                    let own = kept[i][j].abs() * (self.rest[j] + of_first[call][j]);
                    own + taken[i][j].abs() * (shifted[j] + of_second[call][j])
                };
                *sum += (0..gain.len()).map(share).sum::<f64>() / self.rest[i];
            }
            kept = product(&kept, &first);
            taken = product(&taken, &second);
        }
        sums.into_iter().fold(0.0, |largest: f64, sum| if sum.is_finite() { largest.max(sum) } else { f64::INFINITY })
    }
}

/// What an error of these sizes becomes in a copy, by call.
fn grown(copy: &Rows, sizes: &[f64], period: usize) -> Vec<Vec<f64>> {
    let mut power = identity(copy.len());
    let mut all = Vec::new();
    for _ in 0..period {
        power = product(copy, &power);
        all.push(power.iter().map(|row| row.iter().zip(sizes).map(|(x, size)| x.abs() * size).sum()).collect());
    }
    all
}

/// The lower triangular root of a symmetric positive matrix, after Cholesky.
fn square_root(matrix: &Matrix) -> Option<Matrix> {
    let n = matrix.rows();
    let mut root = Matrix::zeros(n, n, matrix.precision());
    for i in 0..n {
        for j in 0..=i {
            let known = Real::sum_of_products((0..j).map(|k| (&root[(i, k)], &root[(j, k)])), matrix.precision());
            let left = matrix.get(i, j) - &known;
            root[(i, j)] = if i == j { left.checked_sqrt().ok()? } else { left.checked_div(&root[(j, j)]).ok()? };
        }
    }
    Some(root)
}
