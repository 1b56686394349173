//! `[observer.impulsive]`: two copies of what is not measured, reset every `window` seconds.
//!
//! **Idea.** Copies with different error dynamics start with the same error; after a window their difference
//! determines it, and a reset removes it. Reduced order, no memory of the window, exact from the first reset on.
//!
//! **Source.** 001 (mazenc-malisoff-jiang-2021-discrete-measurements): Theorem 1 with (5)-(9), Theorem 2 with (23)
//! for `measured_every`; with the corrections of window-observers, section 1 ((9), (27), (68)), and made exact for
//! sampled plants (section 2, "001 twin").
//!
//! **Conditions.** (A, C) observable at the sample time, C of full rank, some state not measured, outputs without
//! delay, nonlinearities in measured states, inputs and time only.
//!
//! **Holds.** As `hold` says; see the page.

use std::ops::Range;
use std::sync::Arc;

use super::window::{
    VERDICT_BITS, read_hold, refuse_steps, refuse_unknowns, resolution_warnings, time_warning, verdict, window_steps,
};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::copies::certificate::{certify, longest_period};
use crate::estimator::copies::errors::ErrorMap;
use crate::estimator::copies::exact::{Choice, Exact, Failure};
use crate::estimator::copies::gain::search;
use crate::estimator::copies::known::{Known, Run, knowns};
use crate::estimator::copies::proof::{Asked, prove};
use crate::estimator::copies::settle::settle;
use crate::estimator::copies::size::Size;
use crate::estimator::copies::theorem::Theorem2;
use crate::estimator::copies::{Calls, Form};
use crate::expr::{Constant, List};
use crate::numbers::{count, seconds, trimmed};
use crate::plant::Plant;
use crate::plant::features::{Feature, Limit, POSITIONS};
use crate::program::Scalar;
use crate::promise::NamedMatrix;
use crate::real::{Matrix, Precision};
use crate::sampled::coordinates::Coordinates;
use crate::sampled::model::{Between, Model};
use crate::sampled::samples::refuse_much_work;
use crate::spec::reader::Table;
use crate::spec::{Quantity, Rows};

const LIMITS: &[Limit] = &[
    POSITIONS,
    Limit::new(
        Feature::Every,
        "its resets are of all outputs at once, so that they have one rate",
        "write `measured_every` in its own table",
    ),
    Limit::new(
        Feature::Age,
        "its resets are of samples taken at the calls",
        "use `window`, which takes samples of any age",
    ),
    Limit::new(
        Feature::Delay,
        "its copies are of what is not measured now, and a late sample measures nothing now",
        "use the method `window`, which does",
    ),
    Limit::new(
        Feature::LeftOut,
        "it keeps no samples, and its copies run on the prediction of a missing one",
        "leave it out, or use `window`",
    ),
    Limit::new(Feature::Windows, "one reset sets both copies, and ends the one window", "use `window`"),
];

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "impulsive",
    summary: "two copies of what is not measured, reset every N calls; reduced order",
    source: "Mazenc, Malisoff and Jiang 2021 (discrete measurements), Theorems 1 and 2, corrected, made exact for samples",
    keys: &[
        ("window", "s", "from one reset to the next, a whole number of samples; the estimate has converged after it"),
        (
            "L",
            "matrix or \"auto\"",
            "the second copy's gain: a row per state that is not measured, a column per output",
        ),
        ("form", "\"exact\" | \"continuous\"", "of the sampled plant, or the paper's equations integrated"),
        (
            "hold",
            "\"first\" | \"third\"",
            "how nonlinear terms, and outputs in the continuous form, run between samples",
        ),
        ("measured_every", "calls", "g: only calls 0, g, 2g … are measured; 1 by default"),
        ("unproved", "\"refuse\" | \"accept\"", "for g > 1, a nonlinear plant for which the paper's condition fails"),
        ("realization", "\"auto\" | \"recursive\"", "how the step computes it"),
    ],
    realizations: &[("recursive", "both copies are carried on from call to call, and reset")],
    limits: LIMITS,
    page: include_str!("impulsive.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    window: Quantity,
    /// `None` for a search.
    gain: Option<Rows>,
    form: (Form, Range<usize>),
    hold: (Between, Range<usize>),
    /// g, with its place.
    every: (usize, Range<usize>),
    accept: bool,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let window = table.quantity("window");
    if window.is_none() && !table.has("window") {
        table.missing("window", "write `window = …`, the seconds from one reset to the next; the deadline");
    }
    let gain = if table.has_text("L") {
        table.choice("L", &[("auto", ())], ());
        None
    } else {
        table.matrix("L")
    };
    let form = table.choice("form", &[("exact", Form::Exact), ("continuous", Form::Continuous)], Form::Exact);
    let form = (form, table.key_span("form"));
    let hold = read_hold(table);
    let every = table.whole("measured_every");
    let every = match every {
        None => Some((1, table.key_span("measured_every"))),
        Some((number, span)) => match usize::try_from(number.numerator().clone()) {
            Ok(every @ 1..=MOST_CALLS) => Some((every, span)),
            _ => {
                let message = "`measured_every` must be a number of calls";
                let error = Diagnostic::error(codes::BAD_NUMBER, span, message);
                table.report(error.label(format!("between 1 and {MOST_CALLS}")));
                None
            }
        },
    };
    let accept = table.choice("unproved", &[("refuse", false), ("accept", true)], false);
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    Some(Arc::new(Keys { window: window?, gain, form, hold, every: every?, accept }))
}

/// Calls from one measurement to the next; no window is longer.
const MOST_CALLS: usize = 20_000;

/// Digits of the float that a reset must leave.
const DIGITS_LEFT: f64 = 1e2;

impl Keyed for Keys {
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        self.refuse_discrete(plant, &mut found);
        let period = window_steps(plant, &self.window, &mut found);
        refuse_steps(plant, &self.hold, &mut found);
        if let Some(period) = period {
            refuse_much_work(plant, period, &self.window.span(), &mut found);
        }
        if !found.is_empty() {
            return Err(found);
        }
        let rest = not_measured(plant, &mut found)?;
        let (Some(period), Some(rest), true) = (period, rest, found.is_empty()) else { return Err(found) };
        let knowns = knowns(plant, self.hold.0);
        let calls = self.calls(plant, period, &knowns)?;
        let condition = verdict(plant, &vec![0; plant.outputs.len()], period, &self.window.span())?;
        let gain = self.gain(plant, &rest, &calls)?;
        let choice = Choice { form: self.form.0, between: self.hold.0, period, rest, gain };
        let settled = settle(plant, &choice, &knowns, calls).map_err(|failure| self.said(plant, failure))?;
        let (mut shape, exact, mut numerics) = settled;
        numerics.condition = condition;
        self.refuse_lost_digits(plant, &exact, period)?;

        let map = ErrorMap::new(&exact);
        let asked = Asked { plant, choice: &choice, knowns: &knowns, every: self.every.1.clone(), accept: self.accept };
        let proof = prove(&asked, &exact, &map, &mut shape.calls)?;
        let notes = std::iter::once(self.gain_note(plant, &choice)).chain(proof.notes).collect();
        let warnings =
            time_warning(plant).into_iter().chain(resolution_warnings(plant)).chain(proof.warnings).collect();
        let certificate = certify(plant, &knowns, &map, &shape.calls);
        Ok(Design {
            method: METHOD.name,
            realization: "recursive",
            summary: summary(plant, &shape.calls, self.form.0),
            window_steps: period,
            valid_from_step: shape.calls.converged,
            convergence: proof.convergence,
            realizations: Vec::new(),
            notes,
            constants: constants(&exact, proof.theorem.as_ref()),
            fir: None,
            certificate,
            numerics,
            warnings,
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(shape),
        })
    }
}

impl Keys {
    fn refuse_discrete(&self, plant: &Plant, found: &mut Vec<Diagnostic>) {
        if plant.discrete && self.form.0 == Form::Continuous {
            let message = "a discrete plant has no continuous form";
            let error = Diagnostic::error(codes::METHOD_CANNOT, self.form.1.clone(), message);
            found.push(error.help("leave `form` out: the exact one is of the sampled plant, which this is"));
        }
    }

    /// N, g and the warm-up.
    fn calls(&self, plant: &Plant, period: usize, knowns: &[Known]) -> Result<Calls, Vec<Diagnostic>> {
        let (every, span) = (self.every.0, self.every.1.clone());
        if !period.is_multiple_of(every) {
            let message = "the window is not a whole number of measurements";
            let h = plant.sample_time_s();
            let near = [period / every, period / every + 1].map(|times| seconds(times.max(1) * every, h));
            let error = Diagnostic::error(codes::NOT_WHOLE, span, message)
                .label(format!("one every {every} calls"))
                .context(self.window.span(), format!("{period} calls"))
                .measured(count(period) / count(every));
            return Err(vec![error.help(format!(
                "a window of {} s or {} s",
                show(trimmed(near[0])),
                show(trimmed(near[1]))
            ))]);
        }
        let outputs_run = self.form.0 == Form::Continuous && self.hold.0 == Between::Cubics;
        let older: usize = if outputs_run || knowns.iter().any(|known| known.run == Run::Cubic) { 2 } else { 0 };
        let ages = if outputs_run { 3 } else { 1 };
        let longest = longest_period(plant.states.len(), plant.outputs.len(), ages, !plant.disturbances.is_empty());
        if period > longest {
            let message = "the window is too long for a plant of this size";
            let error = Diagnostic::error(codes::WINDOW_TOO_LONG, self.window.span(), message)
                .label(format!("{period} calls; at most {longest} are certified"))
                .measured(count(period));
            return Err(vec![error.help("a shorter window, or a longer sample time")]);
        }
        Ok(Calls { period, every, warm_up: older.next_multiple_of(every), converged: 0 })
    }

    /// L as it is given, or found.
    fn gain(&self, plant: &Plant, rest: &[usize], calls: &Calls) -> Result<Vec<Vec<Constant>>, Vec<Diagnostic>> {
        let Some((rows, span)) = &self.gain else {
            let found = search(plant, rest, calls).map_err(|failure| self.said(plant, failure))?;
            return found.ok_or_else(|| {
                let message = "no `L` was found that tells the two copies apart";
                let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message);
                vec![error.help("a longer window, a smaller `measured_every`, or an `L` of your own")]
            });
        };
        let outputs = plant.outputs.len();
        let mut found = Vec::new();
        if rows.len() != rest.len() || rows.iter().any(|row| row.len() != outputs) {
            let names: Vec<&str> = rest.iter().map(|i| plant.states[*i].label.name.as_str()).collect();
            let message = format!("`L` must be a {} x {outputs} matrix", rest.len());
            let error = Diagnostic::error(codes::SHAPE, span.clone(), message);
            return Err(vec![error.help(format!("a row each for {}, a column per output", List(&names)))]);
        }
        let rows = rows.iter().map(|row| row.iter().map(|entry| plant.constant(entry, &mut found)).collect());
        let rows: Option<Vec<Vec<Constant>>> = rows.collect();
        rows.ok_or(found)
    }

    /// A failure in words.
    fn said(&self, plant: &Plant, failure: Failure) -> Vec<Diagnostic> {
        let span = self.gain.as_ref().map_or_else(|| plant.span.clone(), |(_, span)| span.clone());
        vec![match failure {
            Failure::Plant(found) => return found,
            Failure::Alike => {
                Diagnostic::error(codes::METHOD_CANNOT, span, "this `L` does not tell the two copies apart")
                    .label("Q - P is singular: some error goes through both copies alike")
                    .measured(0.0)
                    .help("write `L = \"auto\"`")
            }
            Failure::TooFast(error) => {
                Diagnostic::error(codes::OUT_OF_RANGE, span, "the second copy is too fast for this sample time")
                    .label(error.to_string())
                    .help("write `L = \"auto\"`, or a shorter sample time")
            }
        }]
    }

    /// A reset that multiplies rounding errors by so much that nothing is left of the float.
    fn refuse_lost_digits(&self, plant: &Plant, exact: &Exact, period: usize) -> Result<(), Vec<Diagnostic>> {
        let unit = match plant.scalar {
            Scalar::F32 => f64::from(f32::EPSILON),
            Scalar::F64 => f64::EPSILON,
        };
        let blocks = exact.coordinates.blocks(&exact.phi);
        let gain = exact.gain.doubles();
        let trust = vec![1.0; plant.outputs.len()];
        let copies = [&exact.first.copy, &exact.second.copy];
        let size = Size::new(&blocks, &trust, period);
        let factor = size.map_or(f64::INFINITY, |size| size.amplification(copies, &exact.pair.x, &gain, period));
        if factor * unit * DIGITS_LEFT <= 1.0 {
            return Ok(());
        }
        let span = self.gain.as_ref().map_or_else(|| plant.span.clone(), |(_, span)| span.clone());
        let message = format!("the two copies are too alike for {}", plant.scalar);
        let help = if self.gain.is_some() { "write `L = \"auto\"`" } else { "a longer window, or `scalar = \"f64\"`" };
        let error = Diagnostic::error(codes::METHOD_CANNOT, span, message)
            .label(format!("a period and its reset multiply the rounding errors of a call by {factor:.1e}"));
        Err(vec![error.measured(factor).help(help)])
    }

    fn gain_note(&self, plant: &Plant, choice: &Choice) -> String {
        let entry = |c: &Constant| show(c.to_f64().unwrap_or(f64::NAN));
        let row = |row: &Vec<Constant>| format!("[{}]", row.iter().map(entry).collect::<Vec<_>>().join(", "));
        let rows = choice.gain.iter().map(row).collect::<Vec<_>>().join(", ");
        let states: Vec<&str> = choice.rest.iter().map(|i| plant.states[*i].label.name.as_str()).collect();
        let outputs: Vec<&str> = plant.outputs.iter().map(|o| o.label.name.as_str()).collect();
        let from = if self.gain.is_some() { "" } else { ", found by search" };
        format!("L = [{rows}] (rows {}, columns {}){from}", states.join(", "), outputs.join(", "))
    }
}

/// Places of the states that are not measured.
fn not_measured(plant: &Plant, found: &mut Vec<Diagnostic>) -> Result<Option<Vec<usize>>, Vec<Diagnostic>> {
    let model = Model::new(plant, &[], Precision::bits(VERDICT_BITS))?;
    let (n, p) = (plant.states.len(), plant.outputs.len());
    let rest = if p <= n { Coordinates::pick(&model.c.to_f64(), n) } else { None };
    match &rest {
        None => {
            let names: Vec<&str> = plant.outputs.iter().map(|o| o.label.name.as_str()).collect();
            let message = format!("the outputs {} repeat each other", List(&names));
            let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message)
                .label("this method takes each output as a state of its own");
            found.push(error.help("leave out the outputs that others show, or use the method `window`"));
        }
        Some(rest) if rest.is_empty() => {
            let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), "every state is measured")
                .label("this method estimates the states that are not");
            found.push(error.help("use the method `window`, which averages the noise of the outputs"));
        }
        Some(_) => {}
    }
    Ok(rest)
}

fn summary(plant: &Plant, calls: &Calls, form: Form) -> String {
    let h = plant.sample_time_s();
    let form = match form {
        Form::Exact => "of the sampled plant",
        Form::Continuous => "in continuous time, integrated",
    };
    format!("two copies {form}, reset every {} calls ({} s at {h} s)", calls.period, trimmed(seconds(calls.period, h)))
}

/// What reports show.
fn constants(exact: &Exact, theorem: Option<&Theorem2>) -> Vec<NamedMatrix> {
    let named = |letter, matrix: &Matrix| NamedMatrix { letter, rows: matrix.to_f64() };
    let pair = &exact.pair;
    let r1 = &Matrix::identity(pair.x.rows(), pair.x.precision()) + &pair.x;
    let mut all = Vec::new();
    match &exact.continuous {
        None => all.extend([named("Phi", &exact.phi), named("Gam", &exact.gamma)]),
        Some(continuous) => {
            let f = &continuous.f;
            all.extend([named("F11", &f.yy), named("F12", &f.yr), named("F21", &f.ry), named("F22", &f.rr)]);
        }
    }
    all.extend([named("H", &pair.h), named("G", &pair.g), named("P", &pair.p), named("Q", &pair.q)]);
    if let Some(continuous) = &exact.continuous {
        let e_inverse = continuous.e_inverse();
        if let Ok(e) = crate::real::inverse(&e_inverse) {
            all.push(named("E", &e));
        }
        all.push(named("Einv", &e_inverse));
    }
    all.extend([named("X", &pair.x), named("R1", &r1), named("R2", &-&pair.x), named("L", &exact.gain)]);
    if let Some(theorem) = theorem {
        all.push(NamedMatrix { letter: "beta", rows: vec![vec![theorem.beta]] });
        all.push(NamedMatrix { letter: "gamma", rows: vec![vec![theorem.gamma]] });
    }
    all
}
