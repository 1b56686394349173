//! Which unknowns the outputs tell apart from the state and from each other.
//!
//! Over a long window, x and eps are found together exactly when the Schur complement
//! `P_gg - P_gx E^-1 P_xg` of the joint Gramian is not singular (window-observers, section 2): what
//! the unknowns do to the outputs, less what a change of the state could do as well.

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::List;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, equilibrated_columns, least_squares, rank, singular_values};
use crate::sampled::model::Model;
use crate::sampled::observability::{observability, output_powers};

use super::augment::own_states;

/// Bits at which it is judged; a tolerance of half of them is far from any rounding.
const BITS: usize = 256;

/// Refuses unknowns of constant gamma that no window tells apart, for a plant whose states are observable.
pub fn check(plant: &Plant, delays: &[usize]) -> Result<(), Vec<Diagnostic>> {
    let n = plant.states.len();
    let model = Model::new(plant, &[], Precision::bits(BITS))?;
    let enough = n + delays.iter().max().copied().unwrap_or(0);
    let rows = equilibrated_columns(&observability(&output_powers(&model, enough), delays).0).0;
    let base = rank(&rows, BITS / 2).rank;
    if base == n {
        return Ok(());
    }
    let hidden = |j: &usize| {
        let one = |k: usize| if k == *j { Real::one(rows.precision()) } else { Real::zero(rows.precision()) };
        rank(&rows.vcat(&Matrix::from_fn(1, n, |_, k| one(k))), BITS / 2).rank > base
    };
    let hidden: Vec<usize> = (0..n).filter(hidden).collect();
    Err(vec![refusal(plant, &hidden, schur(&rows, own_states(plant)))])
}

/// The smallest singular value of the Schur complement, for rows `[O | G]` with n columns of O.
fn schur(rows: &Matrix, n: usize) -> f64 {
    let (states, unknowns) = (rows.block(0..rows.rows(), 0..n), rows.block(0..rows.rows(), n..rows.cols()));
    let Ok(share) = least_squares(&states, &unknowns) else { return 0.0 };
    let rest = &unknowns - &(&states * &share);
    singular_values(&rest).last().map_or(0.0, |smallest| (smallest * smallest).to_f64())
}

fn refusal(plant: &Plant, hidden: &[usize], smallest: f64) -> Diagnostic {
    let n = own_states(plant);
    let names = |of: &dyn Fn(usize) -> bool| -> Vec<&str> {
        hidden.iter().filter(|j| of(**j)).map(|j| plant.states[*j].label.name.as_str()).collect()
    };
    let (states, unknowns) = (names(&|j| j < n), names(&|j| j >= n));
    let shown = if smallest > 0.0 { format!("{smallest:.1e}") } else { "0".into() };
    let label = format!("smallest singular value of the Schur complement {shown}, in scaled units");
    if unknowns.is_empty() {
        let message = "the outputs hardly tell the unknowns apart from the states";
        let error = Diagnostic::error(codes::PRECISION, plant.span.clone(), message).label(label).measured(smallest);
        return error.help("a shorter sample time, or fewer unknowns");
    }
    let first = hidden.iter().find(|j| **j >= n).map_or(plant.span.clone(), |j| plant.states[*j].label.span.clone());
    let noun = if unknowns.len() == 1 { "unknown" } else { "unknowns" };
    let message = match states.as_slice() {
        [] => format!("the outputs do not tell the {noun} {} apart", List(&unknowns)),
        [_] => format!("the outputs do not tell the {noun} {} apart from the state {}", List(&unknowns), List(&states)),
        _ => format!("the outputs do not tell the {noun} {} apart from the states {}", List(&unknowns), List(&states)),
    };
    let give_up = match unknowns.as_slice() {
        [one] => format!("make `{one}` a parameter"),
        _ => format!("make one of {} a parameter", List(&unknowns)),
    };
    let help = match states.as_slice() {
        [] => format!("another output that they move differently, or {give_up}"),
        [one] => format!("measure `{one}` as well, or {give_up}"),
        _ => format!("measure one of {} as well, or {give_up}", List(&states)),
    };
    Diagnostic::error(codes::UNOBSERVABLE, first, message).label(label).measured(smallest).help(help)
}
