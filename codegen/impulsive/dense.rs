//! Small matrices of doubles, for what is decided or summed up in them; no constant of a step is.

/// By rows.
pub(super) type Rows = Vec<Vec<f64>>;

/// The identity.
pub(super) fn identity(n: usize) -> Rows {
    (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

/// The product.
pub(super) fn product(a: &Rows, b: &Rows) -> Rows {
    let cols = b.first().map_or(0, Vec::len);
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(x, row)| x * row[j]).sum();
    a.iter().map(|row| (0..cols).map(|j| entry(row, j)).collect()).collect()
}

/// The sum.
pub(super) fn sum(a: &Rows, b: &Rows) -> Rows {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a + b).collect()).collect()
}

/// What a reset takes of z1 and z2: I + X and -X.
pub(super) fn both(x: &Rows) -> [Rows; 2] {
    let mut first = x.clone();
    first.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
    [first, x.iter().map(|row| row.iter().map(|x| -x).collect()).collect()]
}
