//! Small matrices of doubles, for what is decided or summed up in them; no constant of a step is.

/// By rows.
pub(crate) type Rows = Vec<Vec<f64>>;

/// The identity.
pub(crate) fn identity(n: usize) -> Rows {
    (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

/// The product.
pub(crate) fn product(a: &Rows, b: &Rows) -> Rows {
    let cols = b.first().map_or(0, Vec::len);
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(b).map(|(x, row)| x * row[j]).sum();
    a.iter().map(|row| (0..cols).map(|j| entry(row, j)).collect()).collect()
}

/// The sum.
pub(crate) fn sum(a: &Rows, b: &Rows) -> Rows {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a + b).collect()).collect()
}

/// The transpose.
pub(crate) fn transposed(a: &Rows) -> Rows {
    (0..a.first().map_or(0, Vec::len)).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

/// The inner product.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds to a matrix.
pub(crate) fn add(sum: &mut Rows, more: &Rows) {
    sum.iter_mut().flatten().zip(more.iter().flatten()).for_each(|(sum, more)| *sum += more);
}

/// Adds the magnitudes of a matrix.
pub(crate) fn add_magnitudes(sum: &mut Rows, more: &Rows) {
    sum.iter_mut().flatten().zip(more.iter().flatten()).for_each(|(sum, more)| *sum += more.abs());
}

/// Root of the sum of squares.
pub(crate) fn frobenius(a: &Rows) -> f64 {
    a.iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

/// Orthonormal columns of the same span: Gram and Schmidt, twice for the digits.
pub(crate) fn orthonormalised(columns: &Rows) -> Rows {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mut column in transposed(columns) {
        // Squares of what is far below one would vanish.
        let largest = column.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        if largest > 0.0 {
            for x in &mut column {
                *x /= largest;
            }
        }
        for _ in 0..2 {
            for unit in &basis {
                let share = dot(unit, &column);
                column.iter_mut().zip(unit).for_each(|(x, u)| *x -= share * u);
            }
        }
        let size = dot(&column, &column).sqrt();
        if size > 0.0 {
            for x in &mut column {
                *x /= size;
            }
        }
        basis.push(column);
    }
    transposed(&basis)
}

/// What a reset takes of z1 and z2: I + X and -X.
pub(crate) fn both(x: &Rows) -> [Rows; 2] {
    let mut first = x.clone();
    first.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1.0);
    [first, x.iter().map(|row| row.iter().map(|x| -x).collect()).collect()]
}
