//! The two loops over the window.
//!
//! The first carries the responses `p_i` and r from zero at the window's start, and sums their shares of the
//! orthonormal columns: `c_i = sum o' (C p_i)`, `d = sum o' (y - C r)`. The second carries them again and
//! sums what is left, `e_i = C p_i - o c_i`, against itself and against what is left of the samples.

use crate::program::Value;
use crate::program::builder::Builder;

use super::responses::{Running, Shown, Window};

/// A response at the window's end.
pub struct Response {
    /// As many as the plant's own states.
    pub state: Vec<Value>,
    /// c, n; of the known response d.
    pub shares: Vec<Value>,
}

/// What the loops give.
pub struct Gathered {
    /// Of everything known.
    pub known: Response,
    /// Of each gamma.
    pub gammas: Vec<Response>,
    /// Per output that wraps: how far it has moved over the window.
    pub moved: Vec<Option<Value>>,
    /// Per gamma: the energy of what it shows.
    pub energy: Vec<Value>,
    /// S, up to the diagonal.
    pub normal: Vec<Vec<Value>>,
    /// `sum e (y - C r)`.
    pub right: Vec<Value>,
}

/// Both loops, from the first sample.
pub fn gather(window: &Window, b: &mut Builder, start: &Running) -> Gathered {
    let outputs = start.late.len();
    let first: Vec<Shown> = (0..outputs).map(|o| window.shown_first(b, start, o)).collect();
    let (end, mut shares, energy) = project(window, b, start, &first);
    let (normal, right) = equations(window, b, start, &first, &shares);
    let known = Response { state: end.known, shares: shares.pop().unwrap_or_default() };
    let gammas = end.gammas.into_iter().zip(shares).map(|(state, shares)| Response { state, shares }).collect();
    Gathered { known, gammas, moved: end.moved, energy, normal, right }
}

/// The first loop: the responses at the end, their shares c and d, the energies.
fn project(
    window: &Window,
    b: &mut Builder,
    start: &Running,
    first: &[Shown],
) -> (Running, Vec<Vec<Value>>, Vec<Value>) {
    let (n, q) = (window.n(), window.q());
    let zero = b.float(0.0);
    let mut starts = start.flat();
    let running = starts.len();
    starts.extend(std::iter::repeat_n(zero, q * n));
    for k in 0..n {
        let terms: Vec<Value> = first.iter().map(|shown| b.mul(shown.columns[k], shown.measured)).collect();
        starts.push(b.sum(&terms));
    }
    starts.extend(std::iter::repeat_n(zero, q));
    let energies = running + (q + 1) * n;
    let after = b.loop_over(window.table, &starts, |b, carried| {
        let now = window.advance(b, &start.with(&carried[..running]));
        let (mut shares, mut energy) = (carried[running..energies].to_vec(), carried[energies..].to_vec());
        for o in 0..first.len() {
            let shown = window.shown(b, &now, o);
            for (i, value) in shown.gammas.iter().chain([&shown.measured]).enumerate() {
                for (sum, column) in shares[i * n..].iter_mut().zip(&shown.columns) {
                    *sum = added(b, *sum, *column, *value);
                }
            }
            for (sum, value) in energy.iter_mut().zip(&shown.gammas) {
                *sum = added(b, *sum, *value, *value);
            }
        }
        now.flat().into_iter().chain(shares).chain(energy).collect()
    });
    let shares = after[running..energies].chunks(n).map(<[Value]>::to_vec).collect();
    (start.with(&after[..running]), shares, after[energies..].to_vec())
}

/// The second loop: the equations of what the state cannot explain.
fn equations(
    window: &Window,
    b: &mut Builder,
    start: &Running,
    first: &[Shown],
    shares: &[Vec<Value>],
) -> (Vec<Vec<Value>>, Vec<Value>) {
    let q = window.q();
    let mut sums = vec![b.float(0.0); q * (q + 1) / 2 + q];
    for shown in first {
        add_equations(b, &mut sums, shown, shares);
    }
    let mut starts = start.flat();
    let running = starts.len();
    starts.extend(sums);
    let after = b.loop_over(window.table, &starts, |b, carried| {
        let now = window.advance(b, &start.with(&carried[..running]));
        let mut sums = carried[running..].to_vec();
        for o in 0..first.len() {
            let shown = window.shown(b, &now, o);
            add_equations(b, &mut sums, &shown, shares);
        }
        now.flat().into_iter().chain(sums).collect()
    });
    let mut sums = after[running..].iter().copied();
    let normal = (0..q).map(|i| sums.by_ref().take(i + 1).collect()).collect();
    (normal, sums.collect())
}

/// Adds one sample: the products of what is left of the gammas, then those with what is left of the sample.
fn add_equations(b: &mut Builder, sums: &mut [Value], shown: &Shown, shares: &[Vec<Value>]) {
    let mut left = |value: Value, shares: &[Value]| {
        let terms: Vec<Value> =
            shown.columns.iter().zip(shares).map(|(column, share)| b.mul(*column, *share)).collect();
        let explained = b.sum(&terms);
        b.sub(value, explained)
    };
    let gammas: Vec<Value> = shown.gammas.iter().zip(shares).map(|(value, shares)| left(*value, shares)).collect();
    let measured = left(shown.measured, &shares[gammas.len()]);
    let pairs = (0..gammas.len()).flat_map(|i| (0..=i).map(move |j| (i, j)));
    let products = pairs.map(|(i, j)| (gammas[i], gammas[j])).chain(gammas.iter().map(|e| (*e, measured)));
    for (sum, (x, y)) in sums.iter_mut().zip(products) {
        *sum = added(b, *sum, x, y);
    }
}

fn added(b: &mut Builder, sum: Value, x: Value, y: Value) -> Value {
    let product = b.mul(x, y);
    b.add(sum, product)
}
