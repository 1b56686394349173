//! A plant in coordinates in which the size of an error is the root mean square of what it does to the outputs over so
//! many calls: there what a slow observer does to an error differs from the identity by about one in so many, in every
//! direction, and doubles tell it from none.

use nalgebra::DMatrix;

use super::doubling::within_reach;
use super::errors::coordinates;
use crate::real::{Matrix, Precision, Real, inverse};

/// Bits of what is squared over and over: each squaring costs one.
const BITS: usize = 256;
/// Doublings until an error must have died out.
const MOST_DOUBLINGS: usize = 60;
/// Bits of the energy that count.
const ENOUGH_BITS: f64 = 100.0;

/// The plant in these coordinates.
#[derive(Clone, Debug)]
pub(super) struct Far {
    /// Coordinates from states, n x n.
    pub(super) to: Matrix,
    /// States from coordinates, n x n.
    pub(super) back: Matrix,
    /// One call without a correction, n x n.
    pub(super) phi: Matrix,
    /// Outputs from coordinates, p x n.
    pub(super) c: Matrix,
}

impl Far {
    /// For the size over so many calls; `None` where the outputs do not show every state.
    pub(super) fn new(phi: &Matrix, c: &Matrix, calls: usize) -> Option<Self> {
        let (to, back) = coordinates(phi, c, calls.max(phi.rows()))?;
        let bits = |matrix: Matrix| matrix.with_precision(Precision::bits(BITS));
        let (phi, c) = (bits(&(&to * phi) * &back), bits(c * &back));
        Some(Self { to: bits(to), back: bits(back), phi, c })
    }

    /// The same plant in coordinates in which no error grows from turn to turn: those of the energy of all that it will do
    /// to the outputs under the gains, n x p for states, that go round. `None` where it does not die out.
    pub(super) fn calm(&self, cycle: &[DMatrix<f64>]) -> Option<Self> {
        let near = coordinates(&self.phi, &self.c, self.phi.rows())?.0.with_precision(self.phi.precision());
        let mut energy = &near.transpose() * &near;
        let mut turns = cycle.iter().map(|gain| self.call(gain)).reduce(|turns, step| &step * &turns)?;
        for _ in 0..MOST_DOUBLINGS {
            let later = &(&turns.transpose() * &energy) * &turns;
            if later.is_zero() || later.max_abs().log2_abs() < energy.max_abs().log2_abs() - ENOUGH_BITS {
                let to = root(&energy)?;
                let back = inverse(&to).ok()?;
                let (phi, c) = (&(&to * &self.phi) * &back, &self.c * &back);
                return Some(Self { to: &to * &self.to, back: &self.back * &back, phi, c });
            }
            energy = &energy + &later;
            turns = within_reach(&(&turns * &turns))?;
        }
        None
    }

    /// What a call with this gain, n x p for states, does to an error.
    pub(super) fn call(&self, gain: &DMatrix<f64>) -> Matrix {
        let p = self.phi.precision();
        let entry = |i, j| Real::from_f64(gain[(i, j)], p).unwrap_or_else(|| Real::zero(p));
        let gain = &self.to * &Matrix::from_fn(gain.nrows(), gain.ncols(), entry);
        &self.phi - &(&gain * &(&self.c * &self.phi))
    }
}

/// The upper triangle U with `U' U` a definite matrix; `None` of any other.
fn root(definite: &Matrix) -> Option<Matrix> {
    let (n, p) = (definite.rows(), definite.precision());
    let mut root = Matrix::zeros(n, n, p);
    for i in 0..n {
        for j in i..n {
            let known = Real::sum_of_products((0..i).map(|k| (&root[(k, i)], &root[(k, j)])), p);
            let rest = &definite[(i, j)] - &known;
            root[(i, j)] = if j > i {
                rest.checked_div(&root[(i, i)]).ok()?
            } else if rest.is_negative() || rest.is_zero() {
                return None;
            } else {
                rest.checked_sqrt().ok()?
            };
        }
    }
    Some(root)
}
