//! How large the sums of a regression get, so that what enters is bounded such that none overflows.
//!
//! Responses are linear in the samples: at most the sum of the magnitudes of their impulse responses. The
//! equations are sums of products of two responses, and the estimate adds products of an unknown, at most
//! the bound itself, and a response.

use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::lower::guard::Growth;
use crate::expr::Symbol;
use crate::expr::bounds::derivative;
use crate::plant::Plant;
use crate::promise::kernel::slope;
use crate::sampled::{Signal, Source};

use super::{Drive, Entry, Regression};

/// Refuses constants that the target's floats cannot hold.
pub fn check(plant: &Plant, regression: &Regression) -> Result<(), Vec<Diagnostic>> {
    let drives = regression.gammas.iter().chain([&regression.known]);
    let driven = drives.flat_map(|d| d.begin.iter().chain(&d.end).chain([&d.constant]));
    let matrices = regression.phi.iter().chain(&regression.shown).chain(&regression.through);
    let ahead = regression.held.iter().chain(&regression.end).flatten();
    let entries = driven.chain(matrices).chain(ahead).flatten().flatten().copied();
    let rows = regression.rows.iter().flatten().flatten().copied();
    let constants = entries.chain(rows).chain(regression.trust.iter().copied()).map(|entry| {
        let finite = entry.value(plant.scalar).is_finite();
        (entry.double, finite)
    });
    // A power of two: it is there as it is, or not at all.
    let scales =
        regression.scales.iter().map(|scale| (*scale, plant.scalar_value(*scale).to_bits() == scale.to_bits()));
    let Some((value, _)) = constants.chain(scales).find(|(_, fits)| !fits) else { return Ok(()) };
    let message = format!("a constant of the design does not fit into {}", plant.scalar);
    let error = Diagnostic::error(codes::OUT_OF_RANGE, plant.span.clone(), message).measured(value);
    let help = "choose units in which states, outputs and unknowns have similar sizes, or write `scalar = \"f64\"`";
    Err(vec![error.label(format!("this design has {value:.1e}")).help(help)])
}

/// What the largest sums of a step are, for samples of magnitude 1.
pub fn growth(plant: &Plant, regression: &Regression) -> Growth {
    let phi = doubles(&regression.phi);
    let shown = doubles(&regression.shown);
    let steps = regression.carrier.steps;
    let of = |drive: &Drive| reach(&phi, &columns(drive), &shown, steps);
    let (known, seen) = of(&regression.known);
    let responses: Vec<(Vec<f64>, f64)> = regression.gammas.iter().map(of).collect();
    // Sums of magnitudes over o: along a sample, and along the window.
    let rows: Vec<&Vec<Vec<crate::sampled::settled::Settled>>> = regression.rows.iter().collect();
    let across = rows.iter().flat_map(|r| r.iter()).map(|o| o.iter().map(|x| x.double.abs()).sum()).fold(0.0, f64::max);
    let n = regression.states.len();
    let down = |k: usize| -> f64 { rows.iter().flat_map(|r| r.iter()).map(|o| o[k].double.abs()).sum() };
    let down = (0..n).map(down).fold(0.0, f64::max);
    let left = 1.0 + across * down;
    // What wraps is summed up from sample to sample.
    let summed = if plant.outputs.iter().any(|output| output.wrap.is_some()) { steps } else { 1 };
    let sample = crate::numbers::count(summed);
    let equations = crate::numbers::count(rows.len() * regression.trust.len());
    let measured = (sample + seen) * left;
    let regressor = responses.iter().map(|(_, v)| v * left).fold(0.0, f64::max);
    let normal = equations * regressor * regressor.max(measured);

    let through = doubles(&regression.through);
    let total = |row: &[f64]| row.iter().map(|x| x.abs()).sum::<f64>();
    let state = |a: usize| -> (f64, f64) {
        let spread = total(&through[a]) * down;
        let own: f64 = responses.iter().map(|(p, v)| p[a] + spread * v).sum();
        (known[a] + spread * (sample + seen), own)
    };
    let states: Vec<(f64, f64)> = (0..n).map(state).collect();
    let mut growth = Growth { linear: sample + seen, square: normal };
    for (linear, square) in &states {
        growth.linear = growth.linear.max(*linear);
        growth.square = growth.square.max(*square);
    }
    for scale in &regression.scales {
        growth.linear = growth.linear.max(*scale);
    }
    for (o, prediction) in regression.carrier.prediction.iter().enumerate() {
        let weights: Vec<f64> =
            regression.states.iter().map(|j| prediction.states[*j].map_or(0.0, |w| w.double.abs())).collect();
        let sum = |pick: fn(&(f64, f64)) -> f64| weights.iter().zip(&states).map(|(w, s)| w * pick(s)).sum::<f64>();
        let signals: f64 = prediction.held.iter().chain(&prediction.end).flatten().map(|w| 2.0 * w.double.abs()).sum();
        let believed = regression.held[o].iter().chain(&regression.end[o]).flatten().flatten();
        let believed: f64 = believed.map(|w| 2.0 * w.double.abs()).sum();
        growth.linear = growth.linear.max(sum(|s| s.0) + signals + prediction.constant.double.abs());
        growth.square = growth.square.max(sum(|s| s.1) + believed);
    }
    growth
}

/// Per unknown, 25 times the energy that noise of the declared size, independent from sample to sample, gives its
/// regressor: what excites must be five times as large as noise in the factor's own outputs. 0 where none is declared,
/// or the factor is not linear in them: a bound on its slope may be far above what it ever is.
pub fn noise_floors(plant: &Plant, regression: &Regression) -> Vec<f64> {
    let (phi, shown) = (doubles(&regression.phi), doubles(&regression.shown));
    let signals = &regression.carrier.signals;
    let level = |signal: &Signal| -> Option<f64> {
        let Source::Injection(k) = signal.source else { return Some(0.0) };
        let poly = &plant.injections[k].node.poly;
        let of_states = poly.symbols().into_iter().filter(|symbol| matches!(symbol, Symbol::State(_)));
        let linear = of_states.into_iter().all(|s| derivative(poly, s).is_some_and(|slope| slope.symbols().is_empty()));
        if !linear {
            return None;
        }
        let of = |(o, output): (usize, &crate::plant::Output)| -> Option<f64> {
            let slope = slope(plant, k, o)?;
            if slope == 0.0 { Some(0.0) } else { Some(slope * output.noise.as_ref()?.to_f64().ok()?) }
        };
        plant.outputs.iter().enumerate().map(of).sum()
    };
    let levels: Vec<Option<f64>> = signals.iter().map(level).collect();
    let rows = crate::numbers::count(regression.rows.len() * regression.trust.len());
    let floor = |drive: &Drive| -> f64 {
        let noisy: Option<Vec<Vec<f64>>> = drive
            .begin
            .iter()
            .zip(&levels)
            .chain(drive.end.iter().zip(&levels))
            .filter(|(column, _)| column.iter().any(Option::is_some))
            .map(|(column, level)| level.map(|level| row(column).iter().map(|x| x * level).collect()))
            .collect();
        noisy.map_or(0.0, |noisy| 25.0 * rows * energy(&phi, noisy, &shown, regression.carrier.steps))
    };
    regression.gammas.iter().map(floor).map(|floor| if floor.is_finite() { floor } else { 0.0 }).collect()
}

/// The sum of squares of what impulses show over a window, of the output that shows most.
fn energy(phi: &[Vec<f64>], mut impulses: Vec<Vec<f64>>, shown: &[Vec<f64>], steps: usize) -> f64 {
    let mut sums = vec![0.0_f64; shown.len()];
    for _ in 0..steps {
        for impulse in &mut impulses {
            for (sum, row) in sums.iter_mut().zip(shown) {
                let seen: f64 = row.iter().zip(&*impulse).map(|(c, x)| c * x).sum();
                *sum += seen * seen;
            }
            *impulse = phi.iter().map(|row| row.iter().zip(&*impulse).map(|(a, x)| a * x).sum()).collect();
        }
    }
    sums.into_iter().fold(0.0, f64::max)
}

/// The most that responses from zero can come to while one sample interval is computed, for values of
/// magnitude 1: per state, and of what is shown.
pub fn reach(phi: &[Vec<f64>], columns: &[Vec<f64>], shown: &[Vec<f64>], steps: usize) -> (Vec<f64>, f64) {
    let n = phi.len();
    let mut sums = vec![0.0_f64; n];
    let mut impulses = columns.to_vec();
    for _ in 0..steps {
        for impulse in &mut impulses {
            sums.iter_mut().zip(&*impulse).for_each(|(sum, x)| *sum += x.abs());
            *impulse = phi.iter().map(|row| row.iter().zip(&*impulse).map(|(a, x)| a * x).sum()).collect();
        }
    }
    // One more product with Phi, term by term.
    let within: Vec<f64> = (0..n)
        .map(|i| {
            let through: f64 = phi[i].iter().zip(&sums).map(|(a, s)| a.abs() * s).sum();
            through + columns.iter().map(|column| column[i].abs()).sum::<f64>()
        })
        .collect();
    let seen = shown.iter().map(|row| row.iter().zip(&within).map(|(c, x)| c.abs() * x).sum()).fold(0.0, f64::max);
    (within, seen)
}

fn columns(drive: &Drive) -> Vec<Vec<f64>> {
    let constant = std::iter::once(&drive.constant);
    drive.begin.iter().chain(&drive.end).chain(constant).map(|column| row(column)).collect()
}

fn doubles(rows: &[Vec<Entry>]) -> Vec<Vec<f64>> {
    rows.iter().map(|entries| row(entries)).collect()
}

fn row(entries: &[Entry]) -> Vec<f64> {
    entries.iter().map(|entry| entry.map_or(0.0, |e| e.double)).collect()
}
