//! What a window of samples shows of the state: powers of C Phi, stacked.

use crate::real::Matrix;

use super::model::Model;

/// C Phi^j for j = 0 … N, p x n each.
pub fn output_powers(model: &Model, steps: usize) -> Vec<Matrix> {
    let mut powers = vec![model.c.clone()];
    for j in 0..steps {
        let next = &powers[j] * &model.phi;
        powers.push(next);
    }
    powers
}

/// The observability matrix of the window, referenced to its start, with the (state age, output) of each row.
pub fn observability(powers: &[Matrix], delays: &[usize]) -> (Matrix, Vec<(usize, usize)>) {
    let steps = powers.len() - 1;
    let n = powers[0].cols();
    let mut rows = Vec::new();
    for age in 0..=steps {
        rows.extend((0..delays.len()).filter(|i| age >= delays[*i]).map(|i| (age, i)));
    }
    let matrix = Matrix::from_fn(rows.len(), n, |r, j| powers[steps - rows[r].0].get(rows[r].1, j).clone());
    (matrix, rows)
}
