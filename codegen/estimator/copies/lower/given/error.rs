//! How the error of the first copy's run from a given state moves, and for how long that is within the bound.

use nalgebra::DMatrix;

use super::super::super::{Grid, Impulsive};
use crate::plant::Plant;
use crate::promise::Certificate;
use crate::promise::kernel::slope;
use crate::promise::vouched::{Run, Trust};
use crate::sampled::Source;
use crate::sampled::settled::Settled;

/// For how many calls the run is trusted. Between measurements what stands in feeds on itself, and nothing is.
pub(in super::super) fn trust(plant: &Plant, design: &Impulsive, promised: &Certificate) -> Trust {
    let (n, p) = (plant.states.len(), plant.outputs.len());
    let rest = design.rest.len();
    let entry = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double);
    let doubles = |grid: &Grid, columns: usize| DMatrix::from_fn(grid.len(), columns, |i, j| entry(&grid[i][j]));
    let back = doubles(&design.back, n);
    let most = if design.calls.every == 1 { design.calls.converged } else { 0 };
    // Invertible by its making; else nothing is trusted.
    let (into, most) = back.clone().try_inverse().map_or((DMatrix::zeros(n, n), 0), |into| (into, most));
    let mut map = DMatrix::zeros(n, n);
    map.view_mut((p, p), (rest, rest)).copy_from(&doubles(&design.first.copy, rest));
    let level = |o: usize| plant.outputs[o].noise.as_ref().and_then(|noise| noise.to_f64().ok()).unwrap_or(0.0);
    let mut columns: Vec<DMatrix<f64>> = Vec::new();
    let column = |of: &dyn Fn(usize) -> f64| DMatrix::from_fn(n, 1, |i, _| if i < p { 0.0 } else { of(i - p) });
    for o in 0..p {
        for (age, weights) in design.first.outputs.iter().enumerate() {
            let mut enters = column(&|i| entry(&weights[i][o]) * level(o));
            match age {
                0 => enters[(o, 0)] = level(o),
                1 => {
                    (0..rest).for_each(|i| map[(p + i, o)] = entry(&weights[i][o]));
                    continue;
                }
                _ => {}
            }
            columns.push(enters);
        }
        for (known, ages) in design.knowns.iter().zip(&design.first.knowns) {
            let Source::Injection(k) = known.source else { continue };
            let off = slope(plant, k, o).unwrap_or(0.0) * level(o);
            columns.extend(ages.iter().map(|weights| column(&|i| entry(&weights[i]) * off)));
        }
    }
    let enters = DMatrix::from_fn(n, columns.len(), |i, column| columns[column][(i, 0)]);
    let disturbed = DMatrix::from_fn(n, n, |i, j| if i < p { 0.0 } else { into[(i, j)] });
    Run { map, start: into, enters, disturbed, shown: back }.trust(plant, promised, most)
}
