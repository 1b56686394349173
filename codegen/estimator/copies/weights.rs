//! The weights of a period's samples in the estimate, for a plant and an L that are being tried.

use nalgebra::DMatrix;

use crate::real::Matrix;
use crate::sampled::coordinates::Blocks;

use super::exact::Pair;

/// What a sample's noise does to the copies and the reset, in doubles: they decide, and are in no constant.
pub(super) struct Weights {
    rr: DMatrix<f64>,
    ry: DMatrix<f64>,
    h: DMatrix<f64>,
    g: DMatrix<f64>,
    x: DMatrix<f64>,
    gain: DMatrix<f64>,
}

impl Weights {
    pub(super) fn new(blocks: &Blocks, gain: &Matrix, pair: &Pair) -> Self {
        let double = Matrix::doubles;
        Self {
            rr: double(&blocks.rr),
            ry: double(&blocks.ry),
            h: double(&pair.h),
            g: double(&pair.g),
            x: double(&pair.x),
            gain: double(gain),
        }
    }

    /// The weights of the period's samples in z1 right after a reset, oldest first: N+1 matrices, (n-p) x p.
    fn at_reset(&self, period: usize) -> Vec<DMatrix<f64>> {
        let of_gain = &self.x * &self.gain;
        let [mut first, mut second] = both(&self.x);
        let mut weights = vec![of_gain];
        for _ in 0..period {
            weights.push(&first * &self.ry + &second * &self.g);
            first *= &self.rr;
            second *= &self.h;
        }
        let oldest = weights.len() - 1;
        weights[oldest] += second * &self.gain;
        weights.reverse();
        weights
    }

    /// Per state of `x_r`: the gain from noise, in units of the outputs' trust, right after a reset or right before
    /// the next, whichever is larger.
    pub(super) fn worst(&self, period: usize, trust: &[f64]) -> Vec<f64> {
        let gains = |weights: &[DMatrix<f64>]| -> Vec<f64> {
            let of = |i: usize| {
                weights.iter().flat_map(|w| trust.iter().enumerate().map(move |(o, t)| w[(i, o)].abs() / t)).sum()
            };
            (0..self.rr.nrows()).map(of).collect()
        };
        let mut weights = self.at_reset(period);
        let now = gains(&weights);
        let mut since = self.ry.clone();
        let (mut tail, mut power) = (Vec::new(), DMatrix::identity(self.rr.nrows(), self.rr.nrows()));
        for _ in 1..period {
            tail.push(since.clone());
            since = &self.rr * since;
            power = &self.rr * power;
        }
        for weight in &mut weights {
            *weight = &power * &*weight;
        }
        // The sample of the reset drives the copy too.
        if let Some(last) = tail.pop() {
            let newest = weights.len() - 1;
            weights[newest] += last;
        }
        weights.extend(tail);
        let later = gains(&weights);
        now.into_iter().zip(later).map(|(now, later)| now.max(later)).collect()
    }
}

/// What a reset takes of z1 and z2: I + X and -X.
pub(super) fn both(x: &DMatrix<f64>) -> [DMatrix<f64>; 2] {
    [DMatrix::identity(x.nrows(), x.nrows()) + x, -x]
}
