//! Unknown constants as states of the plant.

use crate::expr::Constant;
use crate::plant::{Plant, State, Unknown};

/// The plant with one state per unknown behind its own, named as the user named it.
///
/// A constant gamma is that state's column of A; one that varies is left to the unknown itself.
#[must_use]
pub fn augmented(mut plant: Plant) -> Plant {
    let n = plant.states.len();
    for (place, unknown) in plant.unknowns.iter().enumerate() {
        let column = constant_gamma(unknown).unwrap_or_else(|| vec![Constant::default(); n]);
        let own = if plant.discrete { Constant::one() } else { Constant::default() };
        for (row, entry) in plant.a.iter_mut().zip(column) {
            row.push(entry);
        }
        let mut row = vec![Constant::default(); n + place];
        row.push(own);
        plant.a.push(row);
        let keeps = if plant.discrete { unknown.label.name.clone() } else { "0".into() };
        plant.states.push(State {
            label: unknown.label.clone(),
            initial: Constant::default(),
            measured: Vec::new(),
            equation: keeps,
        });
    }
    let (all, zero) = (plant.states.len(), Constant::default);
    plant.a.iter_mut().chain(&mut plant.c).for_each(|row| row.resize_with(all, zero));
    plant.b.resize_with(all, || vec![zero(); plant.inputs.len()]);
    plant.offset.resize_with(all, zero);
    plant.injections.iter_mut().for_each(|injection| injection.column.resize_with(all, zero));
    plant.disturbances.iter_mut().for_each(|disturbance| disturbance.column.resize_with(all, zero));
    // A turn moves no unknown.
    let turns = plant.outputs.iter_mut().flat_map(|output| &mut output.wrap);
    turns.for_each(|wrap| wrap.direction.resize_with(all, zero));
    plant
}

/// gamma, when nothing in it varies; n x 1.
pub fn constant_gamma(unknown: &Unknown) -> Option<Vec<Constant>> {
    unknown.gamma.iter().map(|entry| Constant::try_from(entry.clone()).ok()).collect()
}

/// The first state that is an unknown of an augmented plant: the number of the plant's own.
pub fn own_states(plant: &Plant) -> usize {
    plant.states.len() - plant.unknowns.len()
}

/// Unknowns of an augmented plant whose gamma varies, by place.
pub fn varying(plant: &Plant) -> Vec<usize> {
    (0..plant.unknowns.len()).filter(|i| constant_gamma(&plant.unknowns[*i]).is_none()).collect()
}

/// An augmented plant without the states of some unknowns.
#[must_use]
pub fn without(plant: &Plant, unknowns: &[usize]) -> Plant {
    let n = own_states(plant);
    let kept: Vec<usize> = (0..plant.states.len()).filter(|j| *j < n || !unknowns.contains(&(j - n))).collect();
    let pick = |row: &Vec<Constant>| -> Vec<Constant> { kept.iter().map(|j| row[*j].clone()).collect() };
    let mut rest = plant.clone();
    rest.states = kept.iter().map(|j| plant.states[*j].clone()).collect();
    let turns = rest.outputs.iter_mut().flat_map(|output| &mut output.wrap);
    turns.for_each(|wrap| wrap.direction = pick(&wrap.direction));
    rest.a = kept.iter().map(|i| pick(&plant.a[*i])).collect();
    rest.b = kept.iter().map(|i| plant.b[*i].clone()).collect();
    rest.c = plant.c.iter().map(pick).collect();
    rest.offset = pick(&plant.offset);
    rest.injections.iter_mut().for_each(|injection| injection.column = pick(&injection.column));
    rest.disturbances.iter_mut().for_each(|disturbance| disturbance.column = pick(&disturbance.column));
    rest.unknowns =
        (0..plant.unknowns.len()).filter(|i| !unknowns.contains(i)).map(|i| plant.unknowns[i].clone()).collect();
    rest
}
