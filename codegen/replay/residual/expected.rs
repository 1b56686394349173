//! How large innovations are where the model is right and noise is all there is.
//!
//! The step is asked: twice the same rest, once with one sample that is off by its noise. What that does to the following
//! predictions, squared and summed, is what white noise of that size does.

use nalgebra::{DMatrix, DVector};

use crate::generated::Generated;
use crate::program::Status;
use crate::program::interp::Interpreter;
use crate::promise::one_count::middle;

use super::super::interface::number;
use super::quantum;

/// Of the innovations of one output.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expected {
    /// Root mean square, in the output's unit, with noise that is as large as its bound at every sample.
    pub rms: f64,
    /// Correlation of neighbours.
    pub lag_one: f64,
}

/// The most calls of a rest, and of what follows a sample that is off.
const MOST_CALLS: usize = 4000;

/// Per output; `None` where noise is not declared, or the step has not converged after some thousand calls.
pub(super) fn of(
    generated: &Generated,
    c: &DMatrix<f64>,
    phi: &DMatrix<f64>,
    places: &[usize],
) -> Option<Vec<Expected>> {
    let plant = &generated.plant;
    let noise: Vec<f64> =
        plant.outputs.iter().map(|output| output.noise.as_ref().map(number)).collect::<Option<_>>()?;
    let calls = (2 * generated.design.valid_from_step + 10).min(MOST_CALLS);
    let onwards = c * phi;
    let mut sums = vec![[0.0_f64; 2]; noise.len()];
    for (o, output) in plant.outputs.iter().enumerate() {
        // A counter is off by whole counts.
        let height = if output.counter.is_some() { 1.0 } else { noise[o] };
        let scale = if output.counter.is_some() { noise[o] / quantum(output) } else { 1.0 };
        let mut newest = vec![0.0; noise.len()];
        newest[o] = noise[o];
        let mut add = |now: &[f64], before: Option<&[f64]>| {
            for (r, sums) in sums.iter_mut().enumerate() {
                sums[0] += now[r] * now[r];
                sums[1] += before.map_or(0.0, |before| before[r] * now[r]);
            }
        };
        add(&newest, None);
        for moved in responses(generated, o, height, calls, places)? {
            let now: Vec<f64> = (&onwards * moved * -scale).iter().copied().collect();
            add(&now, Some(&newest));
            newest = now;
        }
    }
    Some(
        sums.into_iter()
            .map(|[squares, products]| Expected { rms: squares.sqrt(), lag_one: products / squares })
            .collect(),
    )
}

/// What a sample that is off by so much does to the estimates from its call on.
fn responses(
    generated: &Generated,
    output: usize,
    height: f64,
    calls: usize,
    places: &[usize],
) -> Option<Vec<DVector<f64>>> {
    let (plant, program) = (&generated.plant, &generated.program);
    let inputs = vec![0.0; program.inputs.len()];
    let mut samples: Vec<f64> = plant.outputs.iter().map(middle).collect();
    samples.resize(program.measurements.len(), 0.0);
    let [mut rest, mut off] = [(); 2].map(|()| Interpreter::new(program));
    let [mut still, mut moved] = [(); 2].map(|()| vec![0.0; program.estimates.len()]);
    let mut status = Status::Converging;
    for _ in 0..calls {
        off.step(&samples, &inputs, &mut moved);
        status = rest.step(&samples, &inputs, &mut still);
    }
    if status == Status::Converging {
        return None;
    }
    let mut responses = Vec::new();
    for call in 0..calls {
        rest.step(&samples, &inputs, &mut still);
        let right = samples[output];
        samples[output] += if call == 0 { height } else { 0.0 };
        off.step(&samples, &inputs, &mut moved);
        samples[output] = right;
        responses.push(DVector::from_iterator(places.len(), places.iter().map(|place| moved[*place] - still[*place])));
    }
    Some(responses)
}
