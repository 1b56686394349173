//! What one count of a quantised output does to the estimate.
//!
//! The step itself is asked: twice the same rest, once with a sample that moves by one count and stays there, as when
//! an edge of an encoder passes. The largest difference of the answers is what an edge makes of a state that stands
//! still: for a difference of two samples, one count over the sample time.

use crate::describe::short;
use crate::plant::Plant;
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
        let line = |(output, moved): (&crate::plant::Output, &Option<Vec<f64>>)| {
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

/// The largest difference per state after an edge of an output.
fn edge(plant: &Plant, program: &Program, output: usize, height: f64, calls: usize) -> Vec<f64> {
    let (n, measured) = (plant.states.len(), program.measurements.len());
    let inputs = vec![0.0; program.inputs.len()];
    let [mut rest, mut moved] = [(); 2].map(|()| Interpreter::new(program));
    let mut samples = vec![0.0; measured];
    let [mut still, mut after] = [(); 2].map(|()| vec![0.0; program.estimates.len()]);
    let mut largest = vec![0.0_f64; n];
    for call in 0..2 * calls {
        samples[output] = 0.0;
        rest.step(&samples, &inputs, &mut still);
        samples[output] = if call < calls { 0.0 } else { height };
        moved.step(&samples, &inputs, &mut after);
        for (largest, (a, b)) in largest.iter_mut().zip(after.iter().zip(&still)) {
            *largest = largest.max((a - b).abs());
        }
    }
    largest
}
