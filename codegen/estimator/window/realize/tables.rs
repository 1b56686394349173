//! Constants of a realisation on their way from matrices to settled numbers: out as groups of one unit, back
//! in the same order.

use crate::program::Scalar;
use crate::real::{Matrix, Real};
use crate::sampled::settled::Settled;

/// The entries of a matrix; `None` marks a structural zero.
#[derive(Clone, Debug, Default)]
pub struct Entries(pub Vec<Vec<Option<Settled>>>);

/// A matrix by age or place; `None` marks an entry that is zero at every one.
#[derive(Clone, Debug, Default)]
pub struct ByPlace(pub Vec<Vec<Option<Vec<Settled>>>>);

/// Groups in the order in which they were added.
#[derive(Default)]
pub struct Groups(pub Vec<Vec<Real>>);

impl Groups {
    /// Every entry has a unit of its own.
    pub fn entries(&mut self, matrix: &Matrix) {
        self.0.extend(matrix.iter().map(|x| vec![x.clone()]));
    }

    /// An entry has one unit at every place.
    pub fn by_place(&mut self, matrices: &[Matrix]) {
        let (rows, columns) = matrices.first().map_or((0, 0), |m| (m.rows(), m.cols()));
        for i in 0..rows {
            for j in 0..columns {
                self.0.push(matrices.iter().map(|m| m.get(i, j).clone()).collect());
            }
        }
    }
}

/// What has become of groups.
pub struct Rounded(pub std::vec::IntoIter<Option<Vec<Settled>>>);

impl Rounded {
    fn next(&mut self) -> Option<Vec<Settled>> {
        // What vanishes in exact arithmetic at every place is as good as a structural zero.
        self.0.next().flatten().filter(|group| group.iter().any(|x| x.double != 0.0))
    }

    /// What [`Groups::entries`] added.
    pub fn entries(&mut self, rows: usize, columns: usize) -> Entries {
        let mut row = || (0..columns).map(|_| self.next().map(|group| group[0])).collect();
        Entries((0..rows).map(|_| row()).collect())
    }

    /// What [`Groups::by_place`] added.
    pub fn by_place(&mut self, rows: usize, columns: usize) -> ByPlace {
        let mut row = || (0..columns).map(|_| self.next()).collect();
        ByPlace((0..rows).map(|_| row()).collect())
    }
}

impl Entries {
    /// Whether nothing is there.
    pub fn is_empty(&self) -> bool {
        self.0.iter().flatten().all(Option::is_none)
    }

    /// The magnitudes as doubles.
    pub fn magnitudes(&self) -> Vec<Vec<f64>> {
        let size = |x: &Option<Settled>| x.map_or(0.0, |x| x.double.abs());
        self.0.iter().map(|row| row.iter().map(size).collect()).collect()
    }

    /// All numbers.
    pub fn numbers(&self) -> impl Iterator<Item = Settled> {
        self.0.iter().flatten().flatten().copied()
    }
}

impl ByPlace {
    /// The magnitude of an entry at a place.
    pub fn magnitude(&self, i: usize, j: usize, place: usize) -> f64 {
        self.0[i][j].as_ref().map_or(0.0, |column| column[place].double.abs())
    }

    /// An entry at a place as a step carries it.
    pub fn value(&self, i: usize, j: usize, place: usize, scalar: Scalar) -> f64 {
        self.0[i][j].as_ref().map_or(0.0, |column| column[place].value(scalar))
    }

    /// Entries that are not zero everywhere, by row and column.
    pub fn present(&self) -> Vec<(usize, usize)> {
        let row = |i: usize| self.0[i].iter().enumerate().filter(|(_, x)| x.is_some()).map(move |(j, _)| (i, j));
        (0..self.0.len()).flat_map(row).collect()
    }

    /// All columns.
    pub fn columns(&self) -> impl Iterator<Item = &Vec<Settled>> {
        self.0.iter().flatten().flatten()
    }
}

impl Entries {
    /// The entries as doubles.
    pub fn to_f64(&self) -> Vec<Vec<f64>> {
        let value = |x: &Option<Settled>| x.map_or(0.0, |x| x.double);
        self.0.iter().map(|row| row.iter().map(value).collect()).collect()
    }
}

impl ByPlace {
    /// The matrix at a place, as doubles.
    pub fn at(&self, place: usize) -> Vec<Vec<f64>> {
        let value = |x: &Option<Vec<Settled>>| x.as_ref().map_or(0.0, |column| column[place].double);
        self.0.iter().map(|row| row.iter().map(value).collect()).collect()
    }
}
