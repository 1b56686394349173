//! What a step takes and gives, by the fields of its Program: what a replay hands over, and what it may compare.

use crate::estimator::Design;
use crate::expr::Constant;
use crate::generated::Generated;
use crate::plant::moved::besides;
use crate::plant::{Plant, Wrap};
use crate::program::{Field, Kind, Status};

/// The fields of one step function.
#[derive(Clone, Debug)]
pub struct Interface {
    /// In the order of the Program.
    pub measurements: Vec<Measured>,
    /// Names of the inputs, in the order of the plant.
    pub inputs: Vec<String>,
    /// In the order of the Program.
    pub answers: Vec<Answer>,
    /// The place of the field that says how many windows have converged, where there are several.
    windows: Option<usize>,
}

/// A field of the measurements.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Of the field.
    pub name: String,
    /// What it is.
    pub kind: MeasuredKind,
}

/// What a field of the measurements is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredKind {
    /// The sample of an output.
    Sample {
        /// Its place in the plant.
        output: usize,
        /// As it is where it is an integer.
        count: Option<Count>,
    },
    /// How old the sample of an output is, s.
    Age {
        /// Its place in the plant.
        output: usize,
    },
}

/// The integer type of a counter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// 16 or 32.
    pub bits: u8,
    /// Two's complement.
    pub signed: bool,
}

/// A field of the estimate.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Of the field.
    pub name: String,
    /// As in the specification.
    pub unit: String,
    /// One line; may be empty.
    pub doc: String,
    /// A number of calls or of windows, which nothing is compared with.
    pub integer: bool,
    /// The state whose estimate it is.
    pub state: Option<usize>,
    /// The number of the window that it comes from, where there are several; the shortest is 1.
    pub window: Option<u32>,
    /// Whole multiples of these are no difference: an angle's turns.
    pub turns: Vec<f64>,
}

impl Interface {
    /// Of a design's Program.
    pub fn of(generated: &Generated) -> Self {
        let (plant, program) = (&generated.plant, &generated.program);
        let measurements = program
            .measurements
            .iter()
            .map(|field| Measured { name: field.name.clone(), kind: measured(plant, field) });
        let answers = program.estimates.iter().map(|(field, _)| {
            let (state, window) = state(plant, &field.name).map_or((None, None), |(s, w)| (Some(s), Some(w)));
            Answer {
                name: field.name.clone(),
                unit: field.unit.clone(),
                doc: field.doc.clone(),
                integer: field.kind == Kind::Index,
                state,
                window,
                turns: state.map_or_else(Vec::new, |state| turns(plant, state)),
            }
        });
        let windows =
            program.estimates.iter().position(|(field, _)| field.kind == Kind::Index && field.name == "windows");
        let inputs = plant.inputs.iter().map(|input| input.label.name.clone());
        Self { measurements: measurements.collect(), inputs: inputs.collect(), answers: answers.collect(), windows }
    }

    /// Whether a field of an estimate has converged. The status is the shortest window's; a longer one has converged
    /// when it is among those that the estimate counts.
    pub fn has_converged(&self, place: usize, estimate: &[f64], status: Status) -> bool {
        let longer = self.answers[place].window.filter(|window| *window > 1);
        let among = longer.zip(self.windows).is_none_or(|(window, windows)| f64::from(window) <= estimate[windows]);
        status != Status::Converging && among
    }

    /// The estimates of quantities, by place; not the counts of calls and windows.
    pub fn quantities(&self) -> impl Iterator<Item = (usize, &Answer)> {
        self.answers.iter().enumerate().filter(|(_, answer)| !answer.integer)
    }
}

impl MeasuredKind {
    /// Whether it is an integer.
    pub fn is_count(self) -> bool {
        matches!(self, Self::Sample { count: Some(_), .. })
    }
}

impl Count {
    /// How many counts there are until it overflows.
    pub fn turn(self) -> f64 {
        if self.bits == 16 { 65_536.0 } else { 4_294_967_296.0 }
    }

    /// The least and the greatest count.
    pub fn range(self) -> (f64, f64) {
        let turn = self.turn();
        if self.signed { (-turn / 2.0, turn / 2.0 - 1.0) } else { (0.0, turn - 1.0) }
    }
}

impl Answer {
    /// What is promised of its error where the status is converged, in its unit.
    pub fn bound(&self, design: &Design) -> Option<f64> {
        let longer = self.window.and_then(|window| usize::try_from(window).ok()?.checked_sub(2));
        let certificate =
            longer.map_or(Some(&design.certificate), |place| Some(&design.longer.get(place)?.certificate));
        certificate?.error_bound.get(self.state?).copied().flatten()
    }

    /// The difference to a reference, within half a turn where turns are no difference.
    pub fn error(&self, estimate: f64, reference: f64) -> f64 {
        fold(estimate - reference, &self.turns)
    }
}

/// A difference without the whole turns in it.
pub(crate) fn fold(difference: f64, turns: &[f64]) -> f64 {
    turns.iter().fold(difference, |d, turn| d - turn * (d / turn).round())
}

/// What a field of the measurements is, by its name: an output's, or the age of one.
fn measured(plant: &Plant, field: &Field) -> MeasuredKind {
    let name = &field.name;
    let count = match field.kind {
        Kind::Count { bits, signed } => Some(Count { bits, signed }),
        Kind::Float | Kind::Index => None,
    };
    let output = |name: &str| plant.outputs.iter().position(|output| output.label.name == name);
    match (output(name), name.strip_suffix("_age").and_then(output)) {
        (Some(output), _) => MeasuredKind::Sample { output, count },
        (None, Some(output)) => MeasuredKind::Age { output },
        (None, None) => unreachable!("`{name}` is neither an output nor the age of one"),
    }
}

/// The state that an estimate is of, and the window: its own name, or with the number of a window behind it.
fn state(plant: &Plant, name: &str) -> Option<(usize, u32)> {
    let state = |name: &str| plant.states.iter().position(|state| state.label.name == name);
    let of_window = || {
        let (name, number) = name.rsplit_once('_')?;
        Some((state(name)?, number.parse().ok()?))
    };
    state(name).map(|state| (state, 1)).or_else(of_window)
}

/// How far a state moves with a turn of each wrapped output, where it is an angle: nothing else is right modulo a number.
fn turns(plant: &Plant, state: usize) -> Vec<f64> {
    let wraps = plant.outputs.iter().enumerate().filter_map(|(o, output)| Some((o, output.wrap.as_ref()?)));
    let angle = |o: usize, wrap: &Wrap| besides(plant, o, wrap).iter().all(|it| it.state != state || it.turns);
    let moved = wraps.filter(|(o, wrap)| angle(*o, wrap));
    let moved = moved.map(|(_, wrap)| (number(&wrap.turn) * number(&wrap.direction[state])).abs());
    moved.filter(|turn| *turn > 0.0).collect()
}

/// The nearest double.
pub(crate) fn number(value: &Constant) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
