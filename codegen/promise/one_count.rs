//! What one count of a quantised output does to the estimate.
//!
//! The step itself is asked: twice the same rest, once with a sample that moves by one count and stays there, as when
//! an edge of an encoder passes. The largest difference of the answers is what an edge makes of a state that stands
//! still: for a difference of two samples, one count over the sample time.

use crate::expr::Constant;
use crate::numbers::short;
use crate::plant::{Output, Plant};
use crate::program::Program;
use crate::program::interp::Interpreter;

/// Calls before the edge and after it, in convergence times.
const PERIODS: usize = 2;
/// The most calls that are looked at.
const MOST_CALLS: usize = 20_000;

/// Per output, where it is quantised: per state, the largest difference, in the state's unit.
#[derive(Clone, Debug, Default)]
pub struct OneCount(pub Vec<Option<Vec<f64>>>);

impl OneCount {
    /// Of a step that has converged after so many calls.
    pub fn new(plant: &Plant, program: &Program, valid: usize) -> Self {
        let calls = (PERIODS * valid + 10).min(MOST_CALLS);
        let count = |o: usize| {
            let quantum = plant.outputs[o].quantum.as_ref()?.to_f64().ok()?;
            let counts = plant.outputs[o].counter.is_some();
            Some(edge(plant, program, o, if counts { 1.0 } else { quantum }, calls))
        };
        Self((0..plant.outputs.len()).map(count).collect())
    }

    /// A line per quantised output.
    pub fn notes(&self, plant: &Plant) -> Vec<String> {
        let line = |(output, moved): (&Output, &Option<Vec<f64>>)| {
            let moved = moved.as_ref()?;
            let shares = plant.states.iter().zip(moved).map(|(state, moved)| {
                let unit = if state.label.unit.is_empty() { String::new() } else { format!(" {}", state.label.unit) };
                format!("{} {}{unit}", state.label.name, short(*moved))
            });
            let shares: Vec<String> = shares.collect();
            Some(format!(
                "one count of {}, at rest, moves the estimate by up to: {}",
                output.label.name,
                shares.join("; ")
            ))
        };
        plant.outputs.iter().zip(&self.0).filter_map(line).collect()
    }
}

/// A sample that is good: the middle of the range, as whole counts where it counts.
pub(crate) fn middle(output: &Output) -> f64 {
    let number = |constant: &Constant| constant.to_f64().unwrap_or(0.0);
    let Some((low, high)) = output.raw_range.as_ref().or(output.range.as_ref()) else { return 0.0 };
    let middle = f64::midpoint(number(low), number(high))
        + if output.raw_range.is_none() { number(&output.offset) } else { 0.0 };
    match (&output.counter, &output.quantum) {
        (Some(_), Some(quantum)) => (middle / number(quantum)).round(),
        (Some(_), None) => middle.round(),
        _ => middle,
    }
}

/// The largest difference per state after an edge of an output.
fn edge(plant: &Plant, program: &Program, output: usize, height: f64, calls: usize) -> Vec<f64> {
    let n = plant.states.len();
    let inputs = vec![0.0; program.inputs.len()];
    let [mut rest, mut moved] = [(); 2].map(|()| Interpreter::new(program));
    let mut samples: Vec<f64> = plant.outputs.iter().map(middle).collect();
    let base = samples[output];
    samples.resize(program.measurements.len(), 0.0);
    let [mut still, mut after] = [(); 2].map(|()| vec![0.0; program.estimates.len()]);
    let mut largest = vec![0.0_f64; n];
    for call in 0..2 * calls {
        samples[output] = base;
        rest.step(&samples, &inputs, &mut still);
        samples[output] = if call < calls { base } else { base + height };
        moved.step(&samples, &inputs, &mut after);
        for (largest, (a, b)) in largest.iter_mut().zip(after.iter().zip(&still)) {
            *largest = largest.max((a - b).abs());
        }
    }
    largest
}
