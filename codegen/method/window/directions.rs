//! Which motions of the state no output shows, in words: "`zs`, `zu` and `zr` moved together change no output".

use crate::expr::List;
use crate::numbers::short;
use crate::plant::Plant;
use crate::real::{Matrix, Real, equilibrated_columns};

/// Bits below a column's largest entry at which an entry is rounding: what the rank is judged by.
const ROUNDING: i64 = 200;
/// The most directions that are told.
const MOST: usize = 3;

/// What is moved together, of rows of which so many are independent; nothing where the rows do not tell clearly.
pub(super) fn said(plant: &Plant, rows: &Matrix, rank: usize) -> Option<String> {
    let all = directions(rows, rank)?;
    let told: Vec<String> = all.iter().take(MOST).map(|direction| moved(plant, direction)).collect();
    let first = told.first()?;
    let others: Vec<String> = told[1..].iter().map(|other| format!("nor do {other}")).collect();
    let rest = if all.len() > MOST { ", …" } else { "" };
    let verb = if all[0].iter().filter(|x| **x != 0.0).count() == 1 { "changes" } else { "change" };
    let mut said = format!("{first} {verb} no output");
    for other in others {
        said = format!("{said}, {other}");
    }
    Some(said + rest)
}

/// One direction: names that move alike, or each with its share.
fn moved(plant: &Plant, direction: &[f64]) -> String {
    let parts: Vec<(&str, f64)> = plant
        .states
        .iter()
        .zip(direction)
        .filter(|(_, x)| **x != 0.0)
        .map(|(s, x)| (s.label.written.as_str(), *x))
        .collect();
    let names: Vec<&str> = parts.iter().map(|(name, _)| *name).collect();
    if names.len() == 1 {
        return format!("{} alone", List(&names));
    }
    if parts.iter().all(|(_, x)| (x - 1.0).abs() < 1e-9) {
        return format!("{} moved together", List(&names));
    }
    let each: Vec<String> = parts.iter().map(|(name, x)| format!("`{name}` by {}", short(*x))).collect();
    format!("{} moved together", each.join(", "))
}

/// A basis of what the rows do not show, each direction with its least entry at 1 and whole numbers where they are.
fn directions(rows: &Matrix, rank: usize) -> Option<Vec<Vec<f64>>> {
    let n = rows.cols();
    let (scaled, shifts) = equilibrated_columns(rows);
    let mut table: Vec<Vec<Real>> =
        (0..scaled.rows()).map(|i| (0..n).map(|j| scaled[(i, j)].clone()).collect()).collect();
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..n {
        let done = pivots.len();
        let size = |row: &usize| table[*row][column].top();
        let Some(best) = (done..table.len()).max_by_key(size) else { break };
        if table[best][column].top().is_none_or(|top| top < -ROUNDING) {
            continue;
        }
        table.swap(done, best);
        let source = table[done].clone();
        for (_, entries) in table.iter_mut().enumerate().filter(|(row, _)| *row != done) {
            let factor = entries[column].checked_div(&source[column]).ok()?;
            if !factor.is_zero() {
                for (x, s) in entries.iter_mut().zip(&source) {
                    *x = &*x - &(&factor * s);
                }
                entries[column] = Real::zero(scaled.precision());
            }
        }
        pivots.push(column);
    }
    if pivots.len() != rank {
        return None;
    }
    let free = (0..n).filter(|column| !pivots.contains(column));
    Some(free.filter_map(|column| direction(&table, &pivots, column, &shifts)).collect())
}

/// With 1 for one free state, what the others must be, in the states' own units.
fn direction(table: &[Vec<Real>], pivots: &[usize], free: usize, shifts: &[i64]) -> Option<Vec<f64>> {
    let mut entries = vec![0.0; shifts.len()];
    entries[free] = 1.0;
    for (row, pivot) in pivots.iter().enumerate() {
        // Columns were scaled by these powers of two.
        let entry = table[row][free].checked_div(&table[row][*pivot]).ok()?;
        entries[*pivot] = -entry.shifted(shifts[*pivot] - shifts[free]).to_f64();
    }
    let largest = entries.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let entries: Vec<f64> = entries.iter().map(|x| if x.abs() < 1e-12 * largest { 0.0 } else { *x }).collect();
    let least = entries.iter().filter(|x| **x != 0.0).fold(f64::INFINITY, |least, x| least.min(x.abs()));
    let first = entries.iter().find(|x| **x != 0.0)?.signum();
    let whole = |x: f64| if (x - x.round()).abs() < 1e-9 * x.abs().max(1.0) { x.round() } else { x };
    Some(entries.iter().map(|x| whole(x * first / least)).collect())
}
