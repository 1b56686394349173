//! What a step's estimate says of the next sample, against that sample: the judge of a model whose state nobody knows.
//!
//! After each call the estimate is carried by the plant's own equations to the next one, with the inputs and the measured
//! states that the recording has, in doubles. The difference to the sample that comes is the innovation. It is zero but for
//! noise where the model is right, whatever the method.

mod expected;
mod judged;

use nalgebra::DVector;

use crate::expr::Symbol;
use crate::expr::value::value;
use crate::generated::Generated;
use crate::plant::{Output, Plant};
use crate::real::Precision;
use crate::sampled::model::{Model, signals};
use crate::sampled::{Signal, Source};

use super::interface::{Answer, Interface, fold, number};

pub use judged::Residual;

/// The innovations of one replay.
#[derive(Clone, Debug)]
pub(super) struct Innovations {
    plant: Plant,
    signals: Vec<Signal>,
    model: Sampled,
    /// Per state: its place in the estimate.
    places: Vec<usize>,
    /// Per output that is sampled at once: the turns that are no difference.
    turns: Vec<Option<Vec<f64>>>,
    /// Of the newest call.
    before: Option<Before>,
    /// Per output.
    sums: Vec<Sums>,
    calls: f64,
}

/// The plant at its samples, in doubles.
#[derive(Clone, Debug)]
struct Sampled {
    phi: nalgebra::DMatrix<f64>,
    c: nalgebra::DMatrix<f64>,
    constant: DVector<f64>,
    /// Per signal: what the value at the interval's beginning and the one at its end do.
    effects: Vec<[Option<DVector<f64>>; 2]>,
}

/// What the next prediction starts from.
#[derive(Clone, Debug)]
struct Before {
    state: DVector<f64>,
    /// Per signal.
    values: Vec<f64>,
    /// Per state, NaN where it is not measured.
    measured: Vec<f64>,
}

/// Sums over the innovations of an output.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    count: u64,
    sum: f64,
    squares: f64,
    /// Of neighbours.
    products: f64,
    neighbours: u64,
    newest: Option<f64>,
    /// The largest sample.
    largest: f64,
}

impl Innovations {
    /// Of a step whose estimate is of the state now; `None` of another one.
    pub fn of(generated: &Generated, interface: &Interface) -> Option<Self> {
        let plant = &generated.plant;
        if plant.ahead.is_some() || !plant.unknowns.is_empty() {
            return None;
        }
        let place = |state: usize| {
            let shortest =
                |answer: &Answer| answer.state == Some(state) && answer.window.is_none_or(|window| window == 1);
            interface.answers.iter().position(shortest)
        };
        let places = (0..plant.states.len()).map(place).collect::<Option<_>>()?;
        let signals = signals(plant);
        let model = Sampled::new(&Model::new(plant, &signals, Precision::bits(256)).ok()?);
        let turns = |output: &Output| {
            let now = output.delay.is_none() && output.aged.is_none();
            let counts = output.counter.as_ref().map(|counter| 2.0_f64.powi(i32::from(counter.bits)) * quantum(output));
            now.then(|| output.wrap.iter().map(|wrap| number(&wrap.turn)).chain(counts).collect())
        };
        let outputs = &plant.outputs;
        Some(Self {
            signals,
            model,
            places,
            turns: outputs.iter().map(turns).collect(),
            before: None,
            sums: vec![Sums::default(); outputs.len()],
            calls: 0.0,
            plant: plant.clone(),
        })
    }

    /// Takes a call: its samples, one per output, and inputs, and what the step made of them; `known` says whether the
    /// estimate has converged.
    pub fn call(&mut self, samples: &[f64], inputs: &[f64], estimate: &[f64], known: bool) {
        let bare: Vec<f64> =
            self.plant.outputs.iter().zip(samples).map(|(output, sample)| bare(output, *sample, inputs)).collect();
        let measured: Vec<f64> = self.plant.states.iter().map(|state| measured(&state.measured, &bare)).collect();
        let values: Vec<f64> = self.signals.iter().map(|signal| self.value(signal, inputs, &measured)).collect();
        if let Some(before) = self.before.take() {
            let foretold = &self.model.c * self.model.next(&before, &values);
            for (o, output) in self.plant.outputs.iter().enumerate() {
                let Some(turns) = &self.turns[o] else { continue };
                let innovation = fold(bare[o] - foretold[o], turns);
                self.sums[o].largest = self.sums[o].largest.max(bare[o].abs());
                let gate = output.gate.as_ref().map_or(f64::INFINITY, |gate| number(&gate.size));
                self.sums[o].add(Some(innovation).filter(|it| it.is_finite() && it.abs() <= gate));
            }
        }
        self.calls += 1.0;
        if known {
            let state = DVector::from_iterator(self.places.len(), self.places.iter().map(|place| estimate[*place]));
            self.before = Some(Before { state, values, measured });
        } else {
            self.sums.iter_mut().for_each(|sums| sums.newest = None);
        }
    }

    /// The value of a signal that this call brings.
    fn value(&self, signal: &Signal, inputs: &[f64], measured: &[f64]) -> f64 {
        let k = match signal.source {
            Source::Input(input) => return inputs[input],
            Source::Injection(k) => k,
        };
        // Of the sample before, with the input since then.
        let early = signal.part.lag() == 1;
        let states = if early { self.before.as_ref().map(|before| &before.measured) } else { None };
        let time = (self.calls - if early { 1.0 } else { 0.0 }) * self.plant.sample_time_s();
        let at = |symbol: Symbol| match symbol {
            Symbol::State(state) => states.map_or(measured[state], |states| states[state]),
            Symbol::Input(input) => inputs[input],
            Symbol::Time => time,
            _ => f64::NAN,
        };
        value(&self.plant.injections[k].node.poly, &at)
    }

    /// What the innovations came to, per output that has some.
    pub fn judged(&self, generated: &Generated) -> Vec<Residual> {
        let some = self.sums.iter().enumerate().filter(|(_, sums)| sums.count >= FEWEST);
        let expected = expected::of(generated, &self.model.c, &self.model.phi, &self.places);
        some.map(|(o, sums)| {
            let output = &self.plant.outputs[o];
            let noise = output.noise.as_ref().map(number).filter(|noise| *noise > 0.0);
            let expected = expected.as_ref().map(|all| all[o]).filter(|_| noise.is_some());
            Residual::new(&self.plant, output, noise, sums, expected)
        })
        .collect()
    }
}

/// Innovations that a judgement takes.
const FEWEST: u64 = 20;

impl Sampled {
    fn new(model: &Model) -> Self {
        let column = |m: &crate::real::Matrix| m.doubles().column(0).into_owned();
        let effect =
            |e: &crate::sampled::model::Effect| [e.at_begin.as_ref().map(column), e.at_end.as_ref().map(column)];
        Self {
            phi: model.phi.doubles(),
            c: model.c.doubles(),
            constant: column(&model.constant),
            effects: model.effects.iter().map(effect).collect(),
        }
    }

    /// The state a sample later, with what the call there brings.
    fn next(&self, before: &Before, values: &[f64]) -> DVector<f64> {
        let mut next = &self.phi * &before.state + &self.constant;
        for (effect, both) in self.effects.iter().zip(before.values.iter().zip(values)) {
            for (column, value) in effect.iter().zip([both.0, both.1]) {
                if let Some(column) = column {
                    next += column * *value;
                }
            }
        }
        next
    }
}

impl Sums {
    fn add(&mut self, innovation: Option<f64>) {
        if let Some(now) = innovation {
            self.count += 1;
            self.sum += now;
            self.squares += now * now;
            if let Some(before) = self.newest {
                self.products += before * now;
                self.neighbours += 1;
            }
        }
        self.newest = innovation;
    }
}

/// One count, in the output's unit.
fn quantum(output: &Output) -> f64 {
    output.quantum.as_ref().map_or(1.0, number)
}

/// A sample as `C x` would be, NaN where it is none.
fn bare(output: &Output, sample: f64, inputs: &[f64]) -> f64 {
    let within = |value: f64, range: &Option<(crate::expr::Constant, crate::expr::Constant)>| {
        range.as_ref().is_none_or(|(low, high)| (number(low)..=number(high)).contains(&value))
    };
    let sample = if output.counter.is_some() { sample * quantum(output) } else { sample };
    let shifted = sample + output.shift().as_ref().map_or(0.0, number);
    let direct: f64 = output.feedthrough.iter().zip(inputs).map(|(factor, input)| number(factor) * input).sum();
    let bare = shifted - direct;
    if within(sample, &output.raw_range) && within(bare, &output.range) { bare } else { f64::NAN }
}

/// A state as the samples show it, NaN where they do not.
fn measured(weights: &[(usize, crate::expr::Constant)], bare: &[f64]) -> f64 {
    if weights.is_empty() {
        f64::NAN
    } else {
        weights.iter().map(|(output, weight)| number(weight) * bare[*output]).sum()
    }
}
