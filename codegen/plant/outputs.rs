//! Outputs: what they show of the state, what they have of inputs and constants, and their sensors.

use crate::decimal;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::poly::PolyError;
use crate::expr::{Constant, Poly, Symbol};
use crate::spec::{self, Hold, Quantity, Text};

use super::reading::{Reading, label, one_line};
use super::sensor::Sensor;
use super::{Label, Output, Plant, split, turn, words};

impl Reading<'_> {
    /// What a sample has besides the states; the declared range is of the sample.
    pub(super) fn add_direct(
        &mut self,
        output: &mut Output,
        (inputs, constant): (Vec<Constant>, Constant),
    ) -> Option<()> {
        let delay = output.delay.as_ref().map(|(_, span)| span.clone());
        let has_inputs = inputs.iter().any(|factor| !factor.is_zero());
        if let (true, Some(span)) = (has_inputs, delay) {
            let message = format!("`{}` has an input in it and arrives late", output.label.name);
            let error = Diagnostic::error(codes::BAD_COMBINATION, span, message);
            self.found.push(error.help("subtract the input of that time before the call, and leave it out of `value`"));
            return None;
        }
        if has_inputs {
            self.warn_of_held(output, &inputs);
            output.feedthrough = inputs;
            output.raw_range = output.range.take();
        }
        if let Some((low, high)) = &output.range {
            let (low, high) = (low.minus(&constant), high.minus(&constant));
            let label = output.label.clone();
            output.range = Some((self.fits(low, &label)?, self.fits(high, &label)?));
        }
        output.offset = constant;
        Some(())
    }

    /// An output with an input in it that is held until the call, which nobody said of it: was it not sampled together?
    fn warn_of_held(&mut self, output: &Output, factors: &[Constant]) {
        let held = |input: &&spec::Input| input.hold == Hold::Zero && !input.said;
        let inside = self.spec.inputs.iter().zip(factors).filter(|(_, factor)| !factor.is_zero());
        let Some(input) = inside.map(|(input, _)| input).find(held) else { return };
        let (name, of) = (&input.named.name.value, &output.label.written);
        let message =
            format!("`{of}` has the held input `{name}` in it: the value of the interval that ends at the sample");
        let warning = Diagnostic::warning(codes::HELD_IN_OUTPUT, input.named.name.span.clone(), message);
        let warning = warning.label("of a recording, the row before").context(output.label.span.clone(), "this output");
        self.found.push(warning.help(
            "write `hold = \"sampled\"` if it is sampled together with the output, or `hold = \"zero\"` if it is as it says",
        ));
    }

    /// Proves the turns.
    pub(super) fn with_turns(&mut self, mut plant: Plant, sensors: &[Sensor]) -> Option<Plant> {
        let mut proven = true;
        for (o, sensor) in sensors.iter().enumerate() {
            match turn::wrap(&plant, o, sensor) {
                Ok(wrap) => {
                    let output = &mut plant.outputs[o];
                    if wrap.is_some() && output.raw_range.is_none() {
                        output.raw_range = output.range.take();
                    }
                    output.wrap = wrap;
                }
                Err(error) => {
                    self.found.push(*error);
                    proven = false;
                }
            }
        }
        proven.then_some(plant)
    }

    /// An output with its sensor; `sample_time` and `jitter` as far as they could be read.
    pub(super) fn output(
        &mut self,
        output: &spec::Output,
        (sample_time, jitter): (Option<&Constant>, Option<&Constant>),
    ) -> Option<(Output, Sensor)> {
        let noise = self.at_least_zero(output.noise.as_ref(), "the bound of the noise", "write its largest magnitude");
        let delay =
            self.at_least_zero(output.delay.as_ref(), "a delay", "write by how many seconds the measurement is late");
        let range = self.range(output);
        let delay = delay?.filter(|d| !d.is_zero()).zip(output.delay.as_ref().map(Quantity::span));
        let range_span = output.range.as_ref().map_or_else(|| output.named.name.span.clone(), |(_, span)| span.clone());
        let equation = output.value.as_ref().map(one_line).unwrap_or_default();
        let sensor = self.sensor(output, sample_time, jitter)?;
        let label = label(&output.named);
        let parts = self.fits(sensor.noise(noise?, jitter), &label)?;
        let sum = parts.iter().try_fold(Constant::default(), |sum, (_, part)| sum.plus(part));
        let noise = self.fits(sum, &label)?;
        let counter = sensor.counter.as_ref().map(|(counter, _)| *counter);
        let read = Output {
            noise: (!parts.is_empty()).then_some(noise),
            noise_parts: if parts.len() > 1 { parts } else { Vec::new() },
            delay,
            range: range?,
            range_span,
            equation,
            max_rate: sensor.max_rate.clone(),
            quantum: sensor.quantum.clone(),
            floor: sensor.floor,
            counter,
            gate: sensor.gate.clone(),
            every: sensor.every,
            every_span: sensor.every_span.clone(),
            aged: sensor.aged.clone(),
            ..plain_output(label)
        };
        Some((read, sensor))
    }

    /// The result of an exact computation, unless it is too large.
    fn fits<T>(&mut self, result: Result<T, PolyError>, output: &Label) -> Option<T> {
        if result.is_err() {
            let message = format!("the numbers of `{}` are too long to compute with", output.name);
            let error = Diagnostic::error(codes::TOO_LARGE, output.span.clone(), message);
            self.found.push(error.help("write fewer digits"));
        }
        result.ok()
    }

    fn range(&mut self, output: &spec::Output) -> Option<Option<(Constant, Constant)>> {
        let Some((limits, span)) = &output.range else { return Some(None) };
        let [low, high] = limits.as_slice() else { unreachable!("the spec stage counted two limits") };
        let (low, high) = (self.constant(low), self.constant(high));
        let (low, high) = (low?, high?);
        let values = (low.to_f64().unwrap_or(f64::NAN), high.to_f64().unwrap_or(f64::NAN));
        if values.0 < values.1 {
            return Some(Some((low, high)));
        }
        let message = format!("the range from {} to {} is empty", decimal::show(values.0), decimal::show(values.1));
        self.found.push(
            Diagnostic::error(codes::BAD_NUMBER, span.clone(), message).help("write `range = [lowest, highest]`"),
        );
        None
    }

    /// Coefficients of the output; it must be affine in states and inputs.
    pub(super) fn output_row(&mut self, text: &Text) -> Option<Shown> {
        let node = self.node(text)?;
        let mut row = vec![Poly::default(); self.spec.states.len()];
        let mut inputs = vec![Poly::default(); self.spec.inputs.len()];
        let mut constant = Poly::default();
        for (monomial, coefficient) in node.poly.terms() {
            let (fixed, varying) = monomial.split();
            let place = match varying.as_symbol() {
                Some(Symbol::State(j)) => &mut row[j],
                Some(Symbol::Input(i)) => &mut inputs[i],
                None if varying.symbols().is_empty() => &mut constant,
                _ => {
                    let message = "an output must be linear in the states and inputs, with constant factors";
                    let what = words::shortened(words::describe(&varying, &self.known));
                    let span = split::culprit(&node, &varying, varying.symbols().first().copied());
                    let error = Diagnostic::error(codes::OUTPUT_NOT_LINEAR, span, message);
                    let help = "write a sum of states and inputs with constant factors, and a constant; undo curves of the sensor before the call";
                    self.found.push(error.label(format!("this contains `{what}`")).help(help));
                    return None;
                }
            };
            let term = Poly::monomial(fixed, coefficient.clone());
            *place = std::mem::take(place).plus(&term).ok()?;
        }
        if row.iter().all(Poly::is_zero) {
            let error = Diagnostic::error(codes::OUTPUT_NOT_LINEAR, node.span, "this output shows no state");
            self.found
                .push(error.label("everything in it cancels").help("write a sum of states with constant factors"));
            return None;
        }
        let inputs = self.constants(inputs, &text.span);
        let constant = self.constants(vec![constant], &text.span);
        Some(Shown { states: self.constants(row, &text.span)?, inputs: inputs?, constant: constant?.pop()? })
    }
}

/// What an output shows.
pub(super) struct Shown {
    /// Per state.
    pub(super) states: Vec<Constant>,
    /// Per input.
    pub(super) inputs: Vec<Constant>,
    /// What else.
    pub(super) constant: Constant,
}

/// An output of which nothing but its name is said.
pub(super) fn plain_output(label: Label) -> Output {
    Output {
        label,
        noise: None,
        noise_parts: Vec::new(),
        delay: None,
        range: None,
        raw_range: None,
        range_span: 0..0,
        equation: String::new(),
        feedthrough: Vec::new(),
        offset: Constant::default(),
        wrap: None,
        max_rate: None,
        quantum: None,
        floor: false,
        counter: None,
        gate: None,
        every: 1,
        every_span: 0..0,
        aged: None,
    }
}
