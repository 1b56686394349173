//! Coordinates in which the outputs are the first states: `(y, x_r) = T x`.
//!
//! The reduced-order observers (000 (2), 001 (3)-(4)) estimate `x_r` alone. The rows of T below C pick
//! states of the plant, those that the outputs show least, so that a plant whose outputs are states keeps
//! its own.

use crate::real::{Matrix, Singular, inverse};

/// The change of coordinates for a C of full rank.
#[derive(Clone, Debug)]
pub struct Coordinates {
    /// Places of the plant's states that make up `x_r`.
    pub rest: Vec<usize>,
    /// T, n x n: C above the picked states.
    pub into: Matrix,
    /// T^-1.
    pub back: Matrix,
}

/// A matrix in these coordinates, cut between outputs and the rest.
#[derive(Clone, Debug)]
pub struct Blocks {
    /// p x p.
    pub yy: Matrix,
    /// p x (n-p).
    pub yr: Matrix,
    /// (n-p) x p.
    pub ry: Matrix,
    /// (n-p) x (n-p).
    pub rr: Matrix,
}

impl Coordinates {
    /// The states that make up `x_r`, decided in doubles, so that every precision decides alike; `None` when the
    /// rank of C is not full.
    pub fn pick(c: &[Vec<f64>], states: usize) -> Option<Vec<usize>> {
        // What is below this of the largest entry of its row is a rounding error of the elimination.
        const NOTHING: f64 = 1e-9;
        let mut rows = c.to_vec();
        let mut rest: Vec<usize> = (0..states).collect();
        for done in 0..rows.len() {
            let scale = c[done].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            let row = rows[done].clone();
            let shown = rest.iter().copied().fold(None, |best: Option<usize>, j| match best {
                Some(best) if row[best].abs() >= row[j].abs() => Some(best),
                _ => Some(j),
            })?;
            if row[shown].abs() <= scale * NOTHING {
                return None;
            }
            rest.retain(|j| *j != shown);
            for below in &mut rows[done + 1..] {
                let factor = below[shown] / row[shown];
                below.iter_mut().zip(&row).for_each(|(x, pivot)| *x -= factor * pivot);
            }
        }
        Some(rest)
    }

    /// T for the picked states.
    pub fn new(c: &Matrix, rest: Vec<usize>) -> Result<Self, Singular> {
        let (p, n) = (c.rows(), c.cols());
        let identity = Matrix::identity(n, c.precision());
        let into =
            Matrix::from_fn(
                n,
                n,
                |i, j| {
                    if i < p { c.get(i, j).clone() } else { identity.get(rest[i - p], j).clone() }
                },
            );
        let back = inverse(&into)?;
        Ok(Self { rest, into, back })
    }

    /// p.
    pub fn outputs(&self) -> usize {
        self.into.rows() - self.rest.len()
    }

    /// `T m T^-1`, cut.
    pub fn blocks(&self, m: &Matrix) -> Blocks {
        let (p, n) = (self.outputs(), self.into.rows());
        let m = &(&self.into * m) * &self.back;
        Blocks { yy: m.block(0..p, 0..p), yr: m.block(0..p, p..n), ry: m.block(p..n, 0..p), rr: m.block(p..n, p..n) }
    }

    /// `T column`, cut between outputs and the rest.
    pub fn cut(&self, columns: &Matrix) -> (Matrix, Matrix) {
        let (p, n) = (self.outputs(), self.into.rows());
        let columns = &self.into * columns;
        (columns.block(0..p, 0..columns.cols()), columns.block(p..n, 0..columns.cols()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::{Precision, Real};

    #[test]
    fn outputs_come_first_and_what_they_show_least_is_the_rest() {
        let p = Precision::bits(128);
        let c = [[0, 1, 0, 0], [4, 0, 1, 0]];
        let matrix = Matrix::from_fn(2, 4, |i, j| Real::from_i64(c[i][j], p));
        let rest = Coordinates::pick(&matrix.to_f64(), 4).unwrap();
        assert_eq!(rest, [2, 3]);
        let coordinates = Coordinates::new(&matrix, rest).unwrap();
        assert_eq!(coordinates.outputs(), 2);
        let seen = &matrix * &coordinates.back;
        assert_eq!(seen.to_f64(), [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]);
        let phi = Matrix::from_fn(4, 4, |i, j| Real::from_i64(i64::from(i == j) * 2, p));
        let blocks = coordinates.blocks(&phi);
        assert_eq!(blocks.rr.to_f64(), [[2.0, 0.0], [0.0, 2.0]]);
        assert!(blocks.yr.is_zero() && blocks.ry.is_zero());
    }

    #[test]
    fn outputs_that_repeat_each_other_have_no_coordinates() {
        assert_eq!(Coordinates::pick(&[vec![1.0, 2.0, 0.0], vec![2.0, 4.0, 0.0]], 3), None);
        assert_eq!(Coordinates::pick(&[vec![0.0, 0.0]], 2), None);
    }
}
