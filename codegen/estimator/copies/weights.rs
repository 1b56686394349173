//! The weights of a period's samples in the estimate, for a plant and an L that are being tried.

use crate::real::Matrix;
use crate::sampled::coordinates::Blocks;

use super::exact::Pair;
use crate::dense::{Rows, both, identity, product, sum};

/// What a sample's noise does to the copies and the reset, in doubles: they decide, and are in no constant.
pub(super) struct Weights {
    rr: Rows,
    ry: Rows,
    h: Rows,
    g: Rows,
    x: Rows,
    gain: Rows,
}

impl Weights {
    pub(super) fn new(blocks: &Blocks, gain: &Matrix, pair: &Pair) -> Self {
        let double = Matrix::to_f64;
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
    fn at_reset(&self, period: usize) -> Vec<Rows> {
        let of_gain = product(&self.x, &self.gain);
        let [mut first, mut second] = both(&self.x);
        let mut weights = vec![of_gain];
        for _ in 0..period {
            weights.push(sum(&product(&first, &self.ry), &product(&second, &self.g)));
            first = product(&first, &self.rr);
            second = product(&second, &self.h);
        }
        let oldest = weights.len() - 1;
        weights[oldest] = sum(&weights[oldest], &product(&second, &self.gain));
        weights.reverse();
        weights
    }

    /// Per state of `x_r`: the gain from noise, in units of the outputs' trust, right after a reset or right before
    /// the next, whichever is larger.
    pub(super) fn worst(&self, period: usize, trust: &[f64]) -> Vec<f64> {
        let gains = |weights: &[Rows]| -> Vec<f64> {
            let of = |i: usize| weights.iter().flat_map(|w| w[i].iter().zip(trust)).map(|(w, t)| w.abs() / t).sum();
            (0..self.rr.len()).map(of).collect()
        };
        let mut weights = self.at_reset(period);
        let now = gains(&weights);
        let mut since = self.ry.clone();
        let (mut tail, mut power) = (Vec::new(), identity(self.rr.len()));
        for _ in 1..period {
            tail.push(since.clone());
            since = product(&self.rr, &since);
            power = product(&self.rr, &power);
        }
        for weight in &mut weights {
            *weight = product(&power, weight);
        }
        // The sample of the reset drives the copy too.
        if let Some(last) = tail.pop() {
            let newest = weights.len() - 1;
            weights[newest] = sum(&weights[newest], &last);
        }
        weights.extend(tail);
        let later = gains(&weights);
        now.into_iter().zip(later).map(|(now, later)| now.max(later)).collect()
    }
}
