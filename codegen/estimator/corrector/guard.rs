//! Which samples may enter, and how far a state may go, such that nothing overflows.
//!
//! With samples, known signals and states within the bound b, every sum of one step is at most its gain
//! times b, below a sixteenth of the largest float. The step looks at the new state: one beyond b starts again. So no
//! input and no number of calls makes the state non-finite, whatever the plant; b is above 1e20 for any sensible plant.

use super::{Corrector, Frame, Gain, Grid};
use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::sampled::settled::Settled;
use crate::step::guard::{Guard, lost};

/// Finds the bound.
///
/// # Errors
/// A constant that the target's floats cannot hold, or gains too large for any bound.
pub fn bound(plant: &Plant, design: &Corrector) -> Result<Guard, Vec<Diagnostic>> {
    refuse_lost(plant, design)?;
    Guard::with_gain(plant, largest(plant, design), 0.0)
}

fn entries(grid: &Grid) -> Vec<Settled> {
    grid.iter().flatten().flatten().copied().collect()
}

/// The constants in groups, none of which may vanish as a whole.
fn constants(design: &Corrector) -> Vec<Vec<Settled>> {
    let mut all: Vec<Vec<Settled>> = vec![entries(&design.output)];
    let columns = design.at_begin.iter().chain(&design.at_end).chain(std::iter::once(&design.constant));
    all.extend(columns.map(|column| column.iter().flatten().copied().collect()));
    match &design.frame {
        Frame::Plant { phi, growth, spread } => {
            all.push(entries(phi));
            all.push(growth.iter().zip(&design.twofold).filter(|(_, two)| **two).filter_map(|(x, _)| *x).collect());
            if let Some(spread) = spread {
                all.push(entries(&spread.m));
                all.push(spread.q.iter().flatten().copied().collect());
            }
        }
        Frame::Chain { readout, start, entry } => {
            all.extend(entry.iter().map(entries));
            all.push(entries(readout));
            all.push(start.iter().flatten().copied().collect());
        }
    }
    match &design.gain {
        Gain::Constant(gain) => all.push(entries(gain)),
        Gain::Table(rows) | Gain::Periodic(rows) => all.push(rows.iter().flatten().flatten().copied().collect()),
        Gain::Countdown(law) => all.push(entries(&law.terms)),
        Gain::Sliding { law, .. } => {
            all.extend([vec![law.reach], vec![law.inverse], law.ratios.clone(), law.terms.clone()]);
        }
    }
    all.extend(design.handover.iter().map(entries));
    all
}

fn refuse_lost(plant: &Plant, design: &Corrector) -> Result<(), Vec<Diagnostic>> {
    let smallest = match plant.scalar {
        Scalar::F32 => f64::from(f32::MIN_POSITIVE),
        Scalar::F64 => f64::MIN_POSITIVE,
    };
    for group in constants(design) {
        if let Some(beyond) = group.iter().find(|c| !c.value(plant.scalar).is_finite()) {
            return Err(vec![lost(plant, "large", beyond.double)]);
        }
        let largest = group.iter().map(|c| c.double.abs()).fold(0.0, f64::max);
        if largest > 0.0 && largest < smallest {
            return Err(vec![lost(plant, "small", largest)]);
        }
    }
    Ok(())
}

fn size(entry: Option<Settled>) -> f64 {
    entry.map_or(0.0, |entry| entry.double.abs())
}

fn row_sums(grid: &Grid) -> Vec<f64> {
    grid.iter().map(|row| row.iter().map(|x| size(*x)).sum()).collect()
}

/// Per state, the largest sum of magnitudes in its prediction, for signals and states of magnitude 1.
fn predicted(plant: &Plant, design: &Corrector) -> Vec<f64> {
    let n = plant.states.len();
    let carried = match &design.frame {
        Frame::Plant { phi, .. } => row_sums(phi),
        Frame::Chain { .. } => (0..n).map(|i| crate::numbers::count(n - i)).collect(),
    };
    let known = |i: usize| -> f64 {
        let columns = design.at_begin.iter().chain(&design.at_end).chain(std::iter::once(&design.constant));
        // A guess of a signal counts once more.
        2.0 * columns.map(|column| size(column[i])).sum::<f64>()
    };
    // Two floats: |Phi - 1| is at most |Phi| + 1, and the state itself is added to what it grows by.
    let twofold = |i: usize| if design.twofold[i] { 3.0 } else { 0.0 };
    carried.iter().enumerate().map(|(i, carried)| carried + known(i) + twofold(i)).collect()
}

/// The largest innovation, for samples, signals and states of magnitude 1.
pub fn innovation(plant: &Plant, design: &Corrector) -> f64 {
    let predicted = predicted(plant, design);
    let shown = |row: &Vec<Option<Settled>>| row.iter().zip(&predicted).map(|(c, x)| size(*c) * x).sum::<f64>();
    design.output.iter().map(shown).fold(1.0, |most: f64, shown| most.max(1.0 + shown))
}

/// The largest sum of magnitudes in a step, for samples, signals and states of magnitude 1; at least 1.
fn largest(plant: &Plant, design: &Corrector) -> f64 {
    let n = plant.states.len();
    let (predicted, innovation) = (predicted(plant, design), innovation(plant, design));
    let scaled = |sums: Vec<f64>| sums.into_iter().map(|sum| sum * innovation).collect::<Vec<f64>>();
    let ones = || vec![innovation; n];
    let mut gained = match &design.gain {
        Gain::Constant(gain) => scaled(row_sums(gain)),
        Gain::Table(rows) | Gain::Periodic(rows) => {
            let most = |i: usize| rows.iter().map(|k| k[i].iter().map(|x| x.double.abs()).sum()).fold(0.0, f64::max);
            scaled((0..n).map(most).collect())
        }
        Gain::Countdown(law) => {
            let before = innovation / law.smallest.min(1.0) + law.largest;
            ones().into_iter().map(|kappa: f64| kappa.max(before)).collect()
        }
        Gain::Sliding { law, .. } => vec![law.growth(innovation); n],
    };
    if let Frame::Plant { spread: Some(spread), .. } = &design.frame {
        let spread = row_sums(&spread.m).into_iter().zip(&spread.q).map(|(m, q)| innovation * (m + size(*q)));
        gained = gained.into_iter().zip(spread).map(|(a, b)| a.max(b)).collect();
    }
    if let Some(gain) = &design.handover {
        gained = gained.into_iter().zip(scaled(row_sums(gain))).map(|(a, b)| a.max(b)).collect();
    }
    let corrected: Vec<f64> = predicted.iter().zip(&gained).map(|(x, k)| x + k).collect();
    let shown = match &design.frame {
        Frame::Plant { .. } => 1.0,
        Frame::Chain { readout, .. } => row_sums(readout).into_iter().fold(1.0, f64::max),
    };
    let measured = |state: &crate::plant::State| -> f64 {
        state.measured.iter().map(|(_, w)| w.to_f64().unwrap_or(0.0).abs()).sum::<f64>()
            + state.initial.to_f64().unwrap_or(0.0).abs()
    };
    let starts = plant.states.iter().map(measured);
    corrected.into_iter().map(|x| x * shown).chain(starts).chain([innovation]).fold(1.0, f64::max)
}
