//! A specification without a plant: the chain of integrators that stands for it.
//!
//! A method whose key `order` stands for the plant ([`Chain`]) estimates the
//! output and its derivatives. The chain is written here as a user would write it: states `y`, `dy`, `d2y`, … each
//! the derivative of the one before, and the output the first of them. Every later stage reads it like any plant.

use std::ops::Range;

use super::identifiers::{LONGEST, check_identifier};
use super::reader::Table;
use super::{Chain, Disturbance, Input, Matrices, Named, Spec, State, Text};
use crate::diagnostic::{Diagnostic, codes};
use crate::names::reserved;
use crate::numbers::count;

/// How a file gives the plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// States with equations, outputs with values.
    Equations,
    /// A, B and C in `[plant]`.
    Matrices,
    /// By the method's key `order`, for this number of states.
    Chain(usize),
    /// Perhaps by `order`: nothing else gives it, and the method's keys could not be read.
    Unknown,
}

impl Form {
    /// Which of them a file has; `read` are the method's keys, if they could be read.
    pub(super) fn of(top: &Table, matrices: Option<&Matrices>, read: Option<Option<usize>>) -> Self {
        match (matrices, read) {
            (_, Some(Some(order))) => Self::Chain(order),
            (Some(_), _) => Self::Matrices,
            (None, None) if top.has("observer") && !top.has("states") => Self::Unknown,
            (None, _) => Self::Equations,
        }
    }
}

/// Puts the chain in the place of the plant that the file does not declare; mistakes are reported to `top`, that of a
/// second output as `one` says it.
pub(super) fn stand_in(spec: &mut Spec, order: usize, chain: Chain, (one, top): (&str, &Table)) {
    refuse_another_plant(spec, chain, top);
    if top.has("states") || top.has("plant") {
        return;
    }
    let [output] = spec.outputs.as_mut_slice() else {
        return refuse_outputs(spec, chain, (one, top));
    };
    if let Some(value) = &output.value {
        let message = "the output of a chain of integrators is its first state";
        let error = Diagnostic::error(codes::BAD_COMBINATION, value.span.clone(), message);
        return top.report(error.help("leave out `value`: the output and its derivatives are estimated"));
    }
    let states = states(&output.named, order, &forcing(&spec.disturbances));
    check_derived_names(&states, top);
    output.value = Some(states[0].named.name.clone());
    spec.states = states;
}

/// A file that gives the plant twice.
fn refuse_another_plant(spec: &Spec, chain: Chain, top: &Table) {
    let place: Range<usize> = spec.observer.method.span.clone();
    for key in ["states", "plant"].into_iter().filter(|key| top.has(key)) {
        let method = &spec.observer.method.value;
        let (subject, label) = match chain.key {
            Some(key) => (format!("`{key}` in [observer.{method}]"), format!("`{key}` is given here")),
            None => (format!("[observer.{method}]"), "the method".to_owned()),
        };
        let message = format!("{subject} stands for a plant, and [{key}] is one");
        let error = Diagnostic::error(codes::BAD_COMBINATION, top.key_span(key), message);
        top.report(error.context(place.clone(), label).help(chain.instead));
    }
    let inputs = spec.inputs.iter().map(|Input { named, .. }| (named, "input"));
    let unknowns = spec.unknowns.iter().map(|named| (named, "unknown"));
    for (named, what) in inputs.chain(unknowns) {
        let message = format!("the {what} `{}` enters no chain of integrators", named.name.value);
        let error = Diagnostic::error(codes::BAD_COMBINATION, named.name.span.clone(), message);
        top.report(error.help("leave it out, or write the plant that it enters"));
    }
}

fn refuse_outputs(spec: &Spec, chain: Chain, (one, top): (&str, &Table)) {
    // None at all is reported where outputs are read.
    let [_, second, ..] = spec.outputs.as_slice() else { return };
    let outputs = spec.outputs.len();
    let error = Diagnostic::error(codes::BAD_COMBINATION, second.named.name.span.clone(), one);
    let error = error.label(format!("one of {outputs}")).measured(count(outputs));
    let label = chain.key.map_or_else(|| "the method".to_owned(), |key| format!("`{key}` is for one output"));
    let error = error.context(spec.observer.method.span.clone(), label);
    top.report(error.help("put each signal into a file of its own"));
}

/// The output's name is an expression's now, and those of its derivatives are the generated code's.
fn check_derived_names(states: &[State], top: &Table) {
    let output = &states[0].named.name;
    if output.value.chars().all(|c| c.is_ascii_alphanumeric()) {
        check_identifier(top, output);
    }
    for (i, state) in states.iter().enumerate().skip(1) {
        let name = &state.named.name.value;
        let why = match reserved(name) {
            Some(why) => why.to_owned(),
            None if name.len() > LONGEST => format!("longer than the {LONGEST} letters that C compilers tell apart"),
            None => continue,
        };
        let message = format!("derivative {i} of `{}` would be called `{name}`, which is {why}", output.value);
        let error = Diagnostic::error(codes::BAD_NAME, output.span.clone(), message);
        return top.report(error.help("choose another name for the output"));
    }
}

/// What drives the last derivative: the disturbances, or nothing.
fn forcing(disturbances: &[Disturbance]) -> String {
    let names: Vec<&str> = disturbances.iter().map(|d| d.named.name.value.as_str()).collect();
    if names.is_empty() { "0".to_owned() } else { names.join(" + ") }
}

/// The output and its derivatives up to order - 1, each the derivative of the one before.
fn states(output: &Named, order: usize, forcing: &str) -> Vec<State> {
    let text = |value: String| Text { value, span: output.name.span.clone(), inner: None };
    let name = |i: usize| match i {
        0 => output.name.value.clone(),
        1 => format!("d{}", output.name.value),
        _ => format!("d{i}{}", output.name.value),
    };
    let state = |i: usize| State {
        named: Named { name: text(name(i)), unit: per_second(&output.unit, i), doc: documented(output, i) },
        change: Some(text(if i + 1 == order { forcing.to_owned() } else { name(i + 1) })),
        initial: None,
    };
    (0..order).map(state).collect()
}

/// The line for the i-th derivative.
fn documented(output: &Named, i: usize) -> String {
    match i {
        0 => output.doc.clone(),
        1 => format!("derivative of {}", output.name.value),
        _ => format!("derivative {i} of {}", output.name.value),
    }
}

/// A unit over the i-th power of the second: `rad`, `rad/s`, `rad/s^2`; empty if it is not given.
fn per_second(unit: &str, i: usize) -> String {
    let (base, power) = match unit.rsplit_once("/s") {
        Some((base, "")) => (base, 1),
        Some((base, rest)) => match rest.strip_prefix('^').and_then(|digits| digits.parse::<usize>().ok()) {
            Some(power @ 1..=99) => (base, power),
            _ => (unit, 0),
        },
        None => (unit, 0),
    };
    match power + i {
        _ if unit.is_empty() || i == 0 => unit.to_owned(),
        1 => format!("{base}/s"),
        power => format!("{base}/s^{power}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(unit: &str, order: usize, forcing: &str) -> Vec<[String; 3]> {
        let name = Text { value: "angle".into(), span: 0..0, inner: None };
        let states = states(&Named { name, unit: unit.into(), doc: String::new() }, order, forcing);
        let change = |state: &State| state.change.as_ref().map(|text| text.value.clone()).unwrap_or_default();
        states.iter().map(|s| [s.named.name.value.clone(), s.named.unit.clone(), change(s)]).collect()
    }

    #[test]
    fn each_state_is_the_derivative_of_the_one_before() {
        let expected = [["angle", "rad", "dangle"], ["dangle", "rad/s", "d2angle"], ["d2angle", "rad/s^2", "w + v"]];
        assert_eq!(chain("rad", 3, "w + v"), expected);
    }

    #[test]
    fn units_that_are_rates_already_and_none() {
        let units = |unit: &str| chain(unit, 3, "0").into_iter().map(|[_, unit, _]| unit).collect::<Vec<_>>();
        assert_eq!(units("m/s"), ["m/s", "m/s^2", "m/s^3"]);
        assert_eq!(units("m/s^2"), ["m/s^2", "m/s^3", "m/s^4"]);
        assert_eq!(units("m/step"), ["m/step", "m/step/s", "m/step/s^2"]);
        assert_eq!(units(""), ["", "", ""]);
    }
}
