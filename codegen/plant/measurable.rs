//! Which states are known at the samples.

use dashu_base::BitTest as _;
use dashu_ratio::RBig;

use super::elimination::reduce;
use crate::expr::Constant;

/// Which states the undelayed outputs give at once, and by which weights.
#[derive(Clone, Debug)]
pub struct Measurable {
    /// Per state: outputs and weights; empty when it is not measured.
    pub weights: Vec<Vec<(usize, Constant)>>,
    /// Per state: whether a delayed output shows it.
    pub(super) late: Vec<bool>,
    /// Per state: whether its equation says that it does not change; empty where that is not asked.
    pub(super) constant: Vec<bool>,
}

impl Measurable {
    /// Looks at the rows of C; `delayed` marks those that arrive late.
    pub fn new(c: &[Vec<Constant>], delayed: &[bool]) -> Self {
        let n = c.first().map_or(0, Vec::len);
        let rows: Vec<usize> = (0..c.len()).filter(|i| !delayed[*i]).collect();
        let late = (0..n).map(|j| (0..c.len()).any(|i| delayed[i] && !c[i][j].is_zero())).collect();
        let weights = by_elimination(c, &rows, n).unwrap_or_else(|| by_single_entries(c, &rows, n));
        Self { weights, late, constant: Vec::new() }
    }

    /// Whether a state is known at once.
    pub(super) fn shows(&self, state: usize) -> bool {
        !self.weights[state].is_empty()
    }
}

/// Rows times bits of [C | I] from which on elimination, whose entries grow with each row, takes too long.
const MOST_BITS: usize = 1_000_000;

/// Gauss-Jordan elimination of [C | I] in rationals; `None` when an entry is not rational.
fn by_elimination(c: &[Vec<Constant>], rows: &[usize], n: usize) -> Option<Vec<Vec<(usize, Constant)>>> {
    let p = rows.len();
    let mut table: Vec<Vec<RBig>> = Vec::new();
    for (place, row) in rows.iter().enumerate() {
        let mut entries: Vec<RBig> = c[*row].iter().map(Constant::as_rational).collect::<Option<_>>()?;
        entries.extend((0..p).map(|k| if k == place { RBig::ONE } else { RBig::ZERO }));
        table.push(entries);
    }
    let bits = |x: &RBig| x.numerator().bit_len() + x.denominator().bit_len();
    if p * table.iter().flatten().map(bits).sum::<usize>() > MOST_BITS {
        return None;
    }
    let done = reduce(&mut table, n).len();
    let mut weights = vec![Vec::new(); n];
    for row in &table[..done] {
        let states: Vec<usize> = (0..n).filter(|j| !row[*j].is_zero()).collect();
        if let [state] = states.as_slice() {
            let entries = (0..p).filter(|k| !row[n + k].is_zero());
            weights[*state] = entries.map(|k| (rows[k], Constant::from(row[n + k].clone()))).collect();
        }
    }
    Some(weights)
}

/// Rows of C with one entry.
fn by_single_entries(c: &[Vec<Constant>], rows: &[usize], n: usize) -> Vec<Vec<(usize, Constant)>> {
    let mut weights = vec![Vec::new(); n];
    for row in rows {
        let states: Vec<usize> = (0..n).filter(|j| !c[*row][*j].is_zero()).collect();
        if let [state] = states.as_slice()
            && let Ok(inverse) = c[*row][*state].poly().reciprocal()
            && let Ok(weight) = Constant::try_from(inverse)
        {
            weights[*state] = vec![(*row, weight)];
        }
    }
    weights
}
