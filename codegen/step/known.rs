//! What is known at a call besides the samples: inputs and nonlinear terms, each as it is used.
//!
//! In place of one that is not finite or beyond the guard stands the last good one.

use crate::plant::Hold;
use crate::program::Value;
use crate::program::builder::Builder;
use crate::sampled::{Part, Signal, Source};

use super::injections::{Injections, Moment, Samples};
use super::inputs;
use super::sensors::Sensors;

/// An input or a nonlinear term, as an estimator asks for it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    /// What it is.
    pub(crate) source: Source,
    /// Calls since the samples that it is evaluated with; the inputs are those of this call.
    pub(crate) ago: u32,
    /// Whether it can only be had with the samples of this call.
    pub(crate) needs_samples: bool,
    /// Whether it belongs to the sample, as a value that runs does; else to the interval since the last call.
    pub(crate) of_sample: bool,
    /// Whether it is an input that runs straight from the last call's value.
    pub(crate) ramps: bool,
}

impl From<&Signal> for Term {
    fn from(signal: &Signal) -> Self {
        let injected = matches!(signal.source, Source::Injection(_));
        let runs = matches!(signal.part, Part::Runs | Part::Curves);
        Self {
            source: signal.source,
            ago: u32::from(injected && signal.part == Part::Start),
            needs_samples: injected && (runs || signal.part == Part::End),
            of_sample: injected && runs,
            ramps: !injected && signal.part == Part::Runs,
        }
    }
}

/// What is known at a call, as far as it has been evaluated.
pub(crate) struct Known<'a> {
    pub(crate) injections: Injections<'a>,
    /// Per term.
    pub(crate) values: Vec<Option<Value>>,
    /// Per value that may be bad: whether it belongs to the sample, and whether it was good.
    good: Vec<(bool, Value)>,
}

impl<'a> Known<'a> {
    /// The inputs of this call.
    pub(crate) fn inputs(b: &mut Builder, sensors: &Sensors<'a>) -> Self {
        let (mut used, mut good) = (Vec::new(), Vec::new());
        for (u, input) in sensors.plant.inputs.iter().enumerate() {
            let (value, fine) = match sensors.input(u) {
                Some(kept) => {
                    let (value, fine) = inputs::sample(b, u, sensors.guard.bound);
                    let last = kept.newest(b, sensors.newest);
                    (b.select(fine, value, last), fine)
                }
                None => inputs::read(b, u, sensors.guard.bound, sensors.inputs[u]),
            };
            used.push(value);
            good.push((input.hold != Hold::Zero, fine));
        }
        let injections = Injections::new(sensors.plant, sensors.calls, used);
        Self { injections, values: vec![None; sensors.terms.len()], good }
    }

    /// Evaluates what needs no sample of this call.
    pub(crate) fn before_the_samples(&mut self, b: &mut Builder, sensors: &Sensors) {
        self.evaluate(b, sensors, None);
    }

    /// Evaluates the rest.
    pub(crate) fn with_the_samples(&mut self, b: &mut Builder, sensors: &Sensors, samples: &[Value]) {
        self.evaluate(b, sensors, Some(samples));
    }

    fn evaluate(&mut self, b: &mut Builder, sensors: &Sensors, samples: Option<&[Value]>) {
        for (s, term) in sensors.terms.iter().enumerate().filter(|(_, term)| term.needs_samples == samples.is_some()) {
            let k = match term.source {
                Source::Input(u) => {
                    self.values[s] = Some(self.injections.inputs[u]);
                    continue;
                }
                Source::Injection(k) => k,
            };
            let past = |b: &mut Builder, o: usize| sensors.outputs[o].ago(b, sensors.newest, term.ago);
            let value = if term.ago == 0 {
                let samples = Samples::These(samples.unwrap_or_default());
                self.injections.evaluate(b, k, &Moment::Now, samples)
            } else {
                self.injections.evaluate(b, k, &Moment::Ago(term.ago), Samples::Kept(&past))
            };
            self.values[s] = Some(self.guarded(b, sensors, (s, k), value));
        }
    }

    /// A term's value, the last one in place of a bad one.
    fn guarded(&mut self, b: &mut Builder, sensors: &Sensors, (s, k): (usize, usize), value: Value) -> Value {
        if !sensors.guard.injections[k] {
            return value;
        }
        let bound = sensors.guard.bound;
        let good = b.in_range(value, -bound, bound);
        let last = sensors.values[s].newest(b, sensors.newest);
        self.good.push((sensors.terms[s].of_sample, good));
        b.select(good, value, last)
    }

    /// Per term, its value.
    pub(crate) fn all(&self) -> Vec<Value> {
        self.values.iter().flatten().copied().collect()
    }

    /// Per value that may be bad and belongs to the sample: whether it was good.
    pub(crate) fn of_sample(&self) -> Vec<Value> {
        self.good.iter().filter(|(of_sample, _)| *of_sample).map(|(_, good)| *good).collect()
    }

    /// Likewise, of the interval since the last call.
    pub(crate) fn of_interval(&self) -> Vec<Value> {
        self.good.iter().filter(|(of_sample, _)| !*of_sample).map(|(_, good)| *good).collect()
    }

    /// Both, in the order in which they were looked at.
    pub(crate) fn good(&self) -> impl Iterator<Item = Value> {
        self.good.iter().map(|(_, good)| *good)
    }
}
