//! Small dense matrices of [`Real`].

use std::ops::{Add, Index, IndexMut, Mul, Neg, Range, Sub};

use super::number::{Precision, Real};

/// A dense matrix, stored by rows. Either dimension may be zero.
///
/// The precision is the largest of its elements, remembered so that an empty matrix has one;
/// results carry the larger precision of the operands. Operations on unsuitable shapes are
/// programming errors and panic.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Matrix {
    rows: usize,
    cols: usize,
    data: Vec<Real>,
    precision: Precision,
}

impl Matrix {
    /// The zero matrix.
    #[must_use]
    pub fn zeros(rows: usize, cols: usize, p: Precision) -> Self {
        Self { rows, cols, data: vec![Real::zero(p); rows * cols], precision: p }
    }

    /// The identity.
    #[must_use]
    pub fn identity(n: usize, p: Precision) -> Self {
        let mut identity = Self::zeros(n, n, p);
        for i in 0..n {
            identity[(i, i)] = Real::one(p);
        }
        identity
    }

    /// The matrix with the element `element(i, j)` in row `i`, column `j`.
    #[must_use]
    pub fn from_fn(rows: usize, cols: usize, mut element: impl FnMut(usize, usize) -> Real) -> Self {
        let mut data = Vec::with_capacity(rows * cols);
        for i in 0..rows {
            for j in 0..cols {
                data.push(element(i, j));
            }
        }
        let precision = data.iter().map(Real::precision).max().unwrap_or_else(|| Precision::bits(0));
        Self { rows, cols, data, precision }
    }

    /// [`Matrix::from_fn`] for a shape that may be empty: a precision of at least `p`.
    fn shaped(rows: usize, cols: usize, p: Precision, element: impl FnMut(usize, usize) -> Real) -> Self {
        let made = Self::from_fn(rows, cols, element);
        Self { precision: made.precision.max(p), ..made }
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns.
    #[must_use]
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// The precision of results computed from this matrix.
    #[must_use]
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// Every element rounded to precision `p`.
    #[must_use]
    pub fn with_precision(&self, p: Precision) -> Self {
        let data = self.data.iter().map(|x| x.with_precision(p)).collect();
        Self { data, precision: p, ..*self }
    }

    /// The element in row `i`, column `j`.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> &Real {
        &self[(i, j)]
    }

    /// The elements, row by row.
    pub fn iter(&self) -> impl Iterator<Item = &Real> {
        self.data.iter()
    }

    /// The matrix of the images of the elements.
    #[must_use]
    pub fn map(&self, function: impl FnMut(&Real) -> Real) -> Self {
        let data: Vec<Real> = self.data.iter().map(function).collect();
        let precision = data.iter().map(Real::precision).max().unwrap_or(self.precision);
        Self { data, precision, ..*self }
    }

    /// The transpose.
    #[must_use]
    pub fn transpose(&self) -> Self {
        Self::shaped(self.cols, self.rows, self.precision, |i, j| self[(j, i)].clone())
    }

    /// Every element times `factor`.
    #[must_use]
    pub fn scale(&self, factor: &Real) -> Self {
        Self { precision: self.precision.max(factor.precision()), ..self.map(|x| x * factor) }
    }

    /// Every element times `2^k`, exactly.
    #[must_use]
    pub fn shifted(&self, k: i64) -> Self {
        self.map(|x| x.shifted(k))
    }

    /// `self` with `right` to its right.
    ///
    /// # Panics
    /// If the numbers of rows differ.
    #[must_use]
    pub fn hcat(&self, right: &Self) -> Self {
        assert_eq!(self.rows, right.rows, "hcat needs equally many rows");
        let p = self.precision.max(right.precision);
        Self::shaped(self.rows, self.cols + right.cols, p, |i, j| {
            if j < self.cols { self[(i, j)].clone() } else { right[(i, j - self.cols)].clone() }
        })
    }

    /// `self` with `below` below it.
    ///
    /// # Panics
    /// If the numbers of columns differ.
    #[must_use]
    pub fn vcat(&self, below: &Self) -> Self {
        assert_eq!(self.cols, below.cols, "vcat needs equally many columns");
        let p = self.precision.max(below.precision);
        Self::shaped(self.rows + below.rows, self.cols, p, |i, j| {
            if i < self.rows { self[(i, j)].clone() } else { below[(i - self.rows, j)].clone() }
        })
    }

    /// The block of the given rows and columns.
    ///
    /// # Panics
    /// If it extends past the matrix.
    #[must_use]
    pub fn block(&self, rows: Range<usize>, cols: Range<usize>) -> Self {
        assert!(rows.end <= self.rows && cols.end <= self.cols, "block inside the matrix");
        Self::shaped(rows.len(), cols.len(), self.precision, |i, j| self[(rows.start + i, cols.start + j)].clone())
    }

    /// Overwrites the block whose upper left corner is at row `i`, column `j`.
    ///
    /// # Panics
    /// If it extends past the matrix.
    pub fn set_block(&mut self, i: usize, j: usize, block: &Self) {
        for row in 0..block.rows {
            for col in 0..block.cols {
                self[(i + row, j + col)] = block[(row, col)].clone();
            }
        }
        self.precision = self.precision.max(block.precision);
    }

    /// Column `j` as an `n x 1` matrix.
    #[must_use]
    pub fn column(&self, j: usize) -> Self {
        self.block(0..self.rows, j..j + 1)
    }

    /// The largest column sum of magnitudes; zero for an empty matrix.
    #[must_use]
    pub fn norm_1(&self) -> Real {
        self.transpose().norm_inf()
    }

    /// The largest row sum of magnitudes; zero for an empty matrix.
    #[must_use]
    pub fn norm_inf(&self) -> Real {
        let zero = Real::zero(self.precision);
        let row_sum = |i: usize| (0..self.cols).fold(zero.clone(), |sum, j| sum + self[(i, j)].abs());
        (0..self.rows).map(row_sum).max().unwrap_or(zero)
    }

    /// The largest magnitude; zero for an empty matrix.
    #[must_use]
    pub fn max_abs(&self) -> Real {
        self.data.iter().map(Real::abs).max().unwrap_or_else(|| Real::zero(self.precision))
    }

    /// Whether every element is exactly zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.data.iter().all(Real::is_zero)
    }

    /// The nearest doubles, row by row.
    #[must_use]
    pub fn to_f64(&self) -> Vec<Vec<f64>> {
        (0..self.rows).map(|i| (0..self.cols).map(|j| self[(i, j)].to_f64()).collect()).collect()
    }

    /// The power `self^n`, by repeated squaring with guard bits for the multiplications.
    ///
    /// # Panics
    /// If the matrix is not square.
    #[must_use]
    pub fn powi(&self, n: u64) -> Self {
        assert_eq!(self.rows, self.cols, "powers need a square matrix");
        let working = self.precision.plus(32 + 2 * (u64::BITS - n.leading_zeros()) as usize);
        let base = self.with_precision(working);
        let mut power = Self::identity(self.rows, working);
        for bit in (0..u64::BITS - n.leading_zeros()).rev() {
            power = &power * &power;
            if n >> bit & 1 == 1 {
                power = &power * &base;
            }
        }
        power.with_precision(self.precision)
    }

    /// The elements combined pairwise.
    fn zip(&self, other: &Self, combine: impl Fn(&Real, &Real) -> Real) -> Self {
        assert_eq!((self.rows, self.cols), (other.rows, other.cols), "equal shapes");
        let data = self.data.iter().zip(&other.data).map(|(a, b)| combine(a, b)).collect();
        Self { data, precision: self.precision.max(other.precision), ..*self }
    }
}

impl Index<(usize, usize)> for Matrix {
    type Output = Real;
    fn index(&self, (i, j): (usize, usize)) -> &Real {
        assert!(j < self.cols, "column {j} of {}", self.cols);
        &self.data[i * self.cols + j]
    }
}

/// Assigned elements should not exceed the precision of the matrix.
impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut Real {
        assert!(j < self.cols, "column {j} of {}", self.cols);
        &mut self.data[i * self.cols + j]
    }
}

/// Each element by [`Real::sum_of_products`]: practically correctly rounded.
impl Mul for &Matrix {
    type Output = Matrix;
    fn mul(self, right: &Matrix) -> Matrix {
        assert_eq!(self.cols, right.rows, "inner dimensions");
        let p = self.precision.max(right.precision);
        Matrix::shaped(self.rows, right.cols, p, |i, j| {
            let pairs = (0..self.cols).map(|k| (&self[(i, k)], &right[(k, j)]));
            Real::sum_of_products(pairs, p)
        })
    }
}

impl Add for &Matrix {
    type Output = Matrix;
    fn add(self, other: &Matrix) -> Matrix {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for &Matrix {
    type Output = Matrix;
    fn sub(self, other: &Matrix) -> Matrix {
        self.zip(other, |a, b| a - b)
    }
}

impl Neg for &Matrix {
    type Output = Matrix;
    fn neg(self) -> Matrix {
        self.map(|x| -x)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The matrix of the integers `numerators` over `denominator`, by rows.
    pub(crate) fn fractions<const C: usize>(numerators: &[[i64; C]], denominator: i64, p: Precision) -> Matrix {
        Matrix::from_fn(numerators.len(), C, |i, j| {
            Real::from_i64(numerators[i][j], p) / Real::from_i64(denominator, p)
        })
    }

    /// Reproducible elements between -1 and 1.
    pub(crate) fn arbitrary(rows: usize, cols: usize, p: Precision) -> Matrix {
        let mut state = 7_u64;
        Matrix::from_fn(rows, cols, |_, _| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(99);
            Real::rounded(((state >> 12).cast_signed() - (1 << 51)).into(), -51, p)
        })
    }

    /// `log2` of the largest difference relative to the largest element of `b`.
    pub(crate) fn distance(a: &Matrix, b: &Matrix) -> f64 {
        (a - b).max_abs().log2_abs() - b.max_abs().log2_abs()
    }

    #[test]
    fn shapes_and_products_are_those_of_matrix_algebra() {
        let p = Precision::bits(64);
        let a = fractions(&[[1, 2, 3], [4, 5, 6]], 1, p);
        let square = &a * &a.transpose();
        assert_eq!(square, fractions(&[[14, 32], [32, 77]], 1, p));
        assert_eq!(square.powi(3), &(&square * &square) * &square);
        assert_eq!(square.powi(0), Matrix::identity(2, p));
        assert_eq!(a.hcat(&a).block(0..2, 2..5), fractions(&[[3, 1, 2], [6, 4, 5]], 1, p));
        assert_eq!(a.vcat(&a).column(1), fractions(&[[2], [5], [2], [5]], 1, p));
        assert_eq!((&(&a - &a) + &a).scale(&Real::from_i64(2, p)), a.shifted(1));
        assert_eq!(a.norm_1().to_f64().to_bits(), 9.0_f64.to_bits());
        assert_eq!((-&a).norm_inf().to_f64().to_bits(), 15.0_f64.to_bits());
        assert_eq!(a.max_abs(), Real::from_i64(6, p));
        assert_eq!(a.to_f64(), vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]]);
    }

    #[test]
    fn empty_matrices_keep_their_precision() {
        let p = Precision::bits(99);
        let empty = Matrix::zeros(3, 0, p);
        assert_eq!((&empty * &empty.transpose()).precision(), p);
        assert_eq!((&empty * &empty.transpose()), Matrix::zeros(3, 3, p));
        assert!(empty.norm_1().is_zero() && empty.norm_inf().is_zero());
        assert_eq!(empty.hcat(&Matrix::identity(3, p)), Matrix::identity(3, p));
    }
}
