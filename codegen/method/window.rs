//! `[observer.window]`: full-order least squares over the last `window` seconds, stateless.
//!
//! **Idea.** The N+1 newest samples and the inputs between them are linear equations in the state at
//! the window's start. Solved by least squares once, offline, they give the state now as a fixed
//! weighted sum of what was sampled: exact after N+1 samples whatever the initial state, with no
//! state of its own that could drift, and of all unbiased estimates from this window the one that
//! amplifies white noise least. Samples of several outputs count in units of the noise that these
//! declare, so that the design does not depend on the units that were chosen.
//!
//! **Source.** 002 (mazenc-malisoff-2022-parameters-and-states) equations (9) and (19) without
//! unknowns, made exact for sampled signals (window-observers, section 2, "stateless full-order
//! FIR"): integrals become sums over the samples, matrix exponentials powers of Phi.
//!
//! **Conditions.** (A, C) observable at the sample time; the window long enough to show every state;
//! nonlinearities in measured states, inputs and time only.
//!
//! **Holds.** Inputs that keep their value between calls are exact. Injections, and inputs with
//! `hold = "first"`, are taken as straight lines between samples: second order in the sample time.
//! An injection that depends on a held input is evaluated at both ends of each interval with that
//! interval's input, so that a jump of the input costs nothing.

mod ages;
mod directions;
mod left_out;
mod limits;
mod rates;
mod several;

use std::ops::Range;
use std::sync::Arc;

use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::window::minimax::best_rows;
use crate::estimator::window::realize::{
    Form, LeastSquares, REALIZATION_CHOICES, REALIZATIONS, Realized, Request, WORDS, Wanted, realize,
};
use crate::estimator::window::settle::settle;
use crate::estimator::window::solve::{Choice, trusted};
use crate::estimator::window::{Functional, Way};
use crate::expr::List;
use crate::numbers::{count, seconds, short, trimmed};
use crate::plant::Plant;
use crate::plant::features::Feature;
use crate::program::Scalar;
use crate::promise::{Convergence, Fir, NamedMatrix};
use crate::real::{Matrix, Precision, Real, equilibrated_columns, rank, singular_values};
use crate::sampled::model::{Between, Model, signals_between};
use crate::sampled::observability::{observability, output_powers};
use crate::sampled::samples::{refuse_much_work, whole_samples};
use crate::sampled::{Part, Signal};
use crate::spec::Quantity;
use crate::spec::reader::Table;
use crate::step::gate::LEAST;
use left_out::Missing;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "window",
    summary: "full-order least squares over the last N+1 samples, stateless",
    source: "Mazenc and Malisoff 2022 (parameters and states), (9), (19) without unknowns, made exact for samples",
    keys: &[
        ("window", "s | [s, …]", "length of the window, a whole number of samples: the deadline; several, rising"),
        ("hold", "\"first\" | \"third\"", "how nonlinear terms run between samples: order 2 (default) or 4"),
        (
            "weights",
            "\"equal\" | \"minimax\"",
            "least squares, or the smallest worst-case noise gain (quantised signals)",
        ),
        (
            "missing",
            "\"predicted\" | \"left-out\"",
            "the model's prediction stands in for a missing sample, or the step solves for those that are there",
        ),
        ("realization", REALIZATION_CHOICES, "how the step computes it"),
    ],
    realizations: &REALIZATIONS,
    limits: limits::LIMITS,
    page: include_str!("window.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    /// One, or several, rising.
    windows: Vec<Quantity>,
    weighting: Weighting,
    weights_span: Range<usize>,
    hold: (Between, Range<usize>),
    missing: (Option<Missing>, Range<usize>),
    wanted: Wanted,
    wanted_span: Range<usize>,
    /// Whether a key says how a sum with constant weights is computed.
    fixed: bool,
}

/// Which of the unbiased weights are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Weighting {
    Equal,
    Minimax,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let fixed = ["weights", "hold", "realization"].iter().any(|key| table.has(key));
    let windows = several::read(table);
    if windows.is_none() && !table.has("window") {
        table.missing(
            "window",
            "write `window = …`, the length in seconds; the deadline by which the estimate is exact",
        );
    }
    let words = [("equal", Weighting::Equal), ("minimax", Weighting::Minimax)];
    let weights_span = table.key_span("weights");
    let weighting = table.choice("weights", &words, Weighting::Equal);
    let hold = read_hold(table);
    let missing_span = table.key_span("missing");
    let missing = table.has("missing").then(|| table.choice("missing", &left_out::WORDS, Missing::Predicted));
    let missing = (missing, missing_span);
    let wanted_span = table.key_span("realization");
    let wanted = table.choice("realization", &WORDS, Wanted::Auto);
    Some(Arc::new(Keys { windows: windows?, weighting, weights_span, hold, missing, wanted, wanted_span, fixed }))
}

/// Bits at which observability is judged; a tolerance of half of them is far from any rounding.
pub(super) const VERDICT_BITS: usize = 256;
/// Bits at which the window itself is judged, until its rank is full: growing modes need more.
const VERDICTS: [usize; 3] = [VERDICT_BITS, 1_024, 4_096];

impl Keyed for Keys {
    fn asks(&self) -> Vec<(Feature, Range<usize>)> {
        let second = self.windows.get(1).map(|second| (Feature::Windows, second.span()));
        let left_out = self.missing.0 == Some(Missing::LeftOut);
        second.into_iter().chain(left_out.then(|| (Feature::LeftOut, self.missing.1.clone()))).collect()
    }

    fn observed(&self, plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        if self.leaves_out(&plant) { self.counted(plant) } else { Ok(plant) }
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        let all = several::steps(plant, &self.windows, &mut found);
        let delays = delays(plant, &mut found);
        let (Some(all), Some(delays)) = (all, delays) else { return Err(found) };
        let (steps, span) = (all[0], self.windows[0].span());
        refuse_long_delays(plant, &delays, steps, &span, &mut found);
        refuse_much_work(plant, all.iter().sum(), &span, &mut found);
        let signals = signals_between(plant, self.hold.0);
        check_hold(plant, &signals, &self.hold, steps, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let condition = verdict(plant, &delays, steps, &span)?;
        if self.leaves_out(plant) {
            let found = ages::check(plant, &signals, steps);
            if !found.is_empty() {
                return Err(found);
            }
            let pattern = rates::pattern(plant, delays.clone(), steps, &span)?;
            let design = self.left_out(plant, &signals, steps, pattern, condition);
            // What nobody asked for is no reason to refuse.
            if design.is_ok() || self.spared(plant).is_empty() {
                return design;
            }
        }
        let choice = self.choice(plant, &delays, steps)?;
        let (mut functional, exact, mut numerics) = settle(plant, &signals, &delays, steps, &choice)?;
        numerics.condition = condition;
        let mut longer = Vec::new();
        for (steps, window) in all.iter().zip(&self.windows).skip(1) {
            verdict(plant, &delays, *steps, &window.span())?;
            let choice = self.choice(plant, &delays, *steps)?;
            let (window, promised) = several::longer(plant, &signals, &delays, *steps, &choice)?;
            functional.longer.push(window);
            longer.push(promised);
        }
        let form = self.form(&delays);
        let (wanted, span) = (self.wanted, self.wanted_span.clone());
        let Realized { functional, certificate, name, realizations, notes } =
            realize(plant, Request { functional, exact: &exact, form, wanted, span })?;
        let notes = notes.into_iter().chain(several::note(&all)).chain(sensor_notes(plant, steps)).collect();
        Ok(Design {
            method: METHOD.name,
            realization: name,
            summary: self.summary(plant, &all, &functional.way),
            window_steps: steps,
            valid_from_step: steps,
            convergence: Convergence::Finite,
            realizations,
            notes,
            constants: constants(&exact.model),
            fir: Some(fir(plant, &functional)),
            certificate,
            numerics,
            warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
            longer,
            phases: Vec::new(),
            estimator: Arc::new(functional),
        })
    }
}

impl Keys {
    /// The innovation form, or why there is none.
    fn form(&self, delays: &[usize]) -> Result<&'static dyn Form, &'static str> {
        match self.weighting {
            Weighting::Minimax => Err("minimax weights follow no recursion"),
            Weighting::Equal if delays.iter().any(|delay| *delay > 0) => Err("an output arrives late"),
            Weighting::Equal => Ok(&LeastSquares),
        }
    }

    /// For minimax weights, the rows that carry them.
    fn choice(&self, plant: &Plant, delays: &[usize], steps: usize) -> Result<Choice, Vec<Diagnostic>> {
        if self.weighting == Weighting::Equal {
            return Ok(Choice::LeastSquares);
        }
        let model = Model::new(plant, &[], Precision::bits(VERDICT_BITS))?;
        let (rows, of) = observability(&output_powers(&model, steps), delays);
        let trust: Vec<Real> = of.iter().map(|(_, output)| model.trust[*output].clone()).collect();
        Ok(Choice::Rows(best_rows(&trusted(&rows, &trust), &model.phi.powi(steps as u64))))
    }

    fn summary(&self, plant: &Plant, all: &[usize], way: &Way) -> String {
        let (h, steps) = (plant.sample_time_s(), all[0]);
        let what = match self.weighting {
            Weighting::Equal => "least squares",
            Weighting::Minimax => "smallest worst-case noise gain",
        };
        if all.len() > 1 {
            return format!("{what} over the last {} at {h} s, stateless", several::lengths(all, h));
        }
        let (samples, seconds) = (steps + 1, trimmed(seconds(steps, h)));
        match way {
            Way::Fir => format!("{what} over the last {samples} samples ({seconds} s at {h} s), stateless"),
            Way::PingPong(_) => format!("{what} over at least the last {samples} samples ({seconds} s at {h} s)"),
            _ => format!("{what} over the last {samples} samples ({seconds} s at {h} s)"),
        }
    }
}

/// What the header says of outputs that wrap, and of those with a gate.
pub(super) fn sensor_notes(plant: &Plant, steps: usize) -> Vec<String> {
    let number = |constant: &crate::expr::Constant| short(constant.to_f64().unwrap_or(f64::NAN));
    let mut notes = Vec::new();
    for output in &plant.outputs {
        let (name, unit) = (&output.label.name, &output.label.unit);
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        if let Some(wrap) = &output.wrap {
            let turn = number(&wrap.turn);
            notes.push(format!("{name} wraps every {turn}{unit}: sums are of differences to the newest sample"));
        }
        if let Some(gate) = &output.gate {
            let (size, limit) =
                (number(&gate.size), gate.limit.map_or(steps.max(LEAST as usize), |limit| limit as usize));
            notes.push(format!("once converged, {name} further than {size}{unit} from its prediction is missing;"));
            notes.push(format!("after {limit} such samples in a row the observer starts again with the last of them"));
        }
    }
    notes
}

/// How nonlinear terms run between samples, with the key's place.
pub(super) fn read_hold(table: &mut Table) -> (Between, Range<usize>) {
    let place = table.key_span("hold");
    // Known, to say what is wrong with it, but not offered.
    if table.has_text("hold") && table.text("hold").is_some_and(|text| text.value == "zero") {
        return (Between::Steps, place);
    }
    (table.choice("hold", &[("first", Between::Lines), ("third", Between::Cubics)], Between::Lines), place)
}

/// Refuses to keep the last value inside nonlinear terms.
pub(super) fn refuse_steps(plant: &Plant, (between, span): &(Between, Range<usize>), found: &mut Vec<Diagnostic>) {
    if *between == Between::Steps {
        let late = plant.sample_time_s() / 2.0;
        let message = format!("nonlinear terms that keep their last value are {} s late", show(late));
        let error = Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message);
        let error = error.label("half a sample: first order in the sample time").measured(late);
        found.push(error.help("`hold = \"first\"` is of second order at the same cost, `\"third\"` of fourth"));
    }
}

/// Reports what stands against a course between samples.
pub(super) fn check_hold(
    plant: &Plant,
    signals: &[Signal],
    hold: &(Between, Range<usize>),
    steps: usize,
    found: &mut Vec<Diagnostic>,
) {
    refuse_steps(plant, hold, found);
    let (between, span) = hold;
    let refuse = |message: String| Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message);
    if *between != Between::Cubics {
        return;
    }
    if plant.discrete {
        let message = "`hold = \"third\"` is for plants in continuous time".to_owned();
        found.push(refuse(message).help("leave `hold` out: a discrete plant has nothing between samples"));
    }
    if steps < 3 {
        let message = "`hold = \"third\"` needs a window of at least 3 samples".to_owned();
        found.push(refuse(message).measured(count(steps)).help("a longer window, or `hold = \"first\"`"));
    }
    if let Some(jumps) = signals.iter().find(|signal| signal.part == Part::Start) {
        let message =
            format!("no cubic runs through `{}`: its input jumps", jumps.text.trim_end_matches(" at the start"));
        found.push(
            refuse(message).help("give the input `hold = \"first\"`, or use `hold = \"first\"` for the observer"),
        );
    }
}

/// N, from the key `window`.
pub(super) fn window_steps(plant: &Plant, window: &Quantity, found: &mut Vec<Diagnostic>) -> Option<usize> {
    let span = window.span();
    let window = plant.constant(window, found)?;
    let seconds = window.to_f64().unwrap_or(f64::NAN);
    if seconds <= 0.0 || !seconds.is_finite() {
        let message = format!("the window must be longer than 0 s, not {}", show(seconds));
        let error = Diagnostic::error(codes::BAD_NUMBER, span, message).measured(seconds);
        found.push(error.help("write the seconds after which the estimate is to be exact"));
        return None;
    }
    whole_samples(&window, &span, "the window", plant, found)
}

pub(super) fn refuse_unknowns(plant: &Plant, method: &str) -> Vec<Diagnostic> {
    let refuse = |unknown: &crate::plant::Unknown| {
        let message = format!("the method `{method}` does not estimate the unknown `{}`", unknown.label.name);
        Diagnostic::error(codes::METHOD_CANNOT, unknown.label.span.clone(), message)
            .context(plant.span.clone(), "this method estimates states only")
            .help("declare it as a state whose derivative is '0'; the method that takes unknown constants as such is `parameters`")
    };
    plant.unknowns.iter().map(refuse).collect()
}

/// Whole samples of delay, per output.
pub(super) fn delays(plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Vec<usize>> {
    let delays: Vec<Option<usize>> = plant
        .outputs
        .iter()
        .map(|output| match &output.delay {
            None => Some(0),
            Some((delay, span)) => {
                whole_samples(delay, span, &format!("the delay of `{}`", output.label.name), plant, found)
            }
        })
        .collect();
    delays.into_iter().collect()
}

pub(super) fn refuse_long_delays(
    plant: &Plant,
    delays: &[usize],
    steps: usize,
    window: &Range<usize>,
    found: &mut Vec<Diagnostic>,
) {
    for (output, delay) in plant.outputs.iter().zip(delays) {
        if let Some((_, span)) = &output.delay
            && *delay > steps
        {
            let message = format!("the delay of `{}` is longer than the window", output.label.name);
            let error = Diagnostic::error(codes::DELAY_TOO_LONG, span.clone(), message)
                .label(format!("{delay} samples"))
                .context(window.clone(), format!("{steps} samples"))
                .measured(count(*delay));
            found.push(error.help(format!("a window of more than {} s", show(count(*delay) * plant.sample_time_s()))));
        }
    }
}

/// Whether the outputs show every state, and within this window; the condition number.
pub(super) fn verdict(
    plant: &Plant,
    delays: &[usize],
    steps: usize,
    window: &Range<usize>,
) -> Result<f64, Vec<Diagnostic>> {
    let n = plant.states.len();
    let p = Precision::bits(VERDICT_BITS);
    let model = Model::new(plant, &[], p)?;
    let rows = |steps: usize| {
        let powers = output_powers(&model, steps);
        observability(&powers, delays).0
    };
    let enough = n + delays.iter().max().copied().unwrap_or(0);
    let long = rows(enough);
    let judged = rank(&equilibrated_columns(&long).0, VERDICT_BITS / 2);
    if judged.rank < n {
        return Err(vec![unobservable(plant, &long, &judged.singular_values)]);
    }
    if let Some(condition) = VERDICTS.iter().find_map(|bits| condition(plant, delays, steps, *bits).transpose()) {
        return condition;
    }
    Err(vec![if steps < enough { too_short(plant, &rows, steps, enough, window) } else { too_long(steps, n, window) }])
}

/// The condition number of the window's observability matrix; `None` when its rank is not full at this precision.
fn condition(plant: &Plant, delays: &[usize], steps: usize, bits: usize) -> Result<Option<f64>, Vec<Diagnostic>> {
    let n = plant.states.len();
    let model = Model::new(plant, &[], Precision::bits(bits))?;
    let rows = observability(&output_powers(&model, steps), delays).0;
    let scaled = equilibrated_columns(&rows).0;
    if rows.rows() < n || rank(&scaled, bits / 2).rank < n {
        return Ok(None);
    }
    let values = singular_values(&scaled);
    Ok(Some((&values[0] / &values[n - 1]).to_f64()))
}

fn too_short(
    plant: &Plant,
    rows: &dyn Fn(usize) -> Matrix,
    steps: usize,
    enough: usize,
    window: &Range<usize>,
) -> Diagnostic {
    let n = plant.states.len();
    let shown = |steps: usize| {
        let rows = rows(steps);
        if rows.rows() == 0 { 0 } else { rank(&equilibrated_columns(&rows).0, VERDICT_BITS / 2).rank.min(rows.rows()) }
    };
    let needed = (steps + 1..=enough).find(|steps| shown(*steps) == n).unwrap_or(enough);
    let here = shown(steps);
    Diagnostic::error(codes::WINDOW_TOO_SHORT, window.clone(), "the window is too short to show every state")
        .label(format!("{} samples show {here} of {n} states", steps + 1))
        .measured(count(here))
        .help(format!("a window of at least {} s", show(count(needed) * plant.sample_time_s())))
}

fn too_long(steps: usize, n: usize, window: &Range<usize>) -> Diagnostic {
    let digits = Precision::bits(VERDICTS[VERDICTS.len() - 1] / 2).as_digits();
    let message = "the plant's modes grow too far apart within the window";
    Diagnostic::error(codes::PRECISION, window.clone(), message)
        .label(format!("over {steps} samples, the outputs do not tell {n} states apart in {digits} digits"))
        .help("a shorter window, or a model without the modes that grow beyond all others")
}

/// Names the states that no window shows.
fn unobservable(plant: &Plant, rows: &Matrix, values: &[f64]) -> Diagnostic {
    let n = plant.states.len();
    let base = rank(&equilibrated_columns(rows).0, VERDICT_BITS / 2).rank;
    let hidden: Vec<&crate::plant::State> =
        (0..n)
            .filter(|j| {
                let unit = Matrix::from_fn(1, n, |_, k| {
                    if k == *j { Real::one(rows.precision()) } else { Real::zero(rows.precision()) }
                });
                rank(&equilibrated_columns(&rows.vcat(&unit)).0, VERDICT_BITS / 2).rank > base
            })
            .map(|j| &plant.states[j])
            .collect();
    let names: Vec<&str> = hidden.iter().map(|s| s.label.written.as_str()).collect();
    let outputs: Vec<String> = plant.outputs.iter().map(|output| shown(plant, output)).collect();
    let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
    let smallest = values.last().copied().unwrap_or(0.0);
    let smallest_shown = if smallest > 0.0 { format!("{smallest:.1e}") } else { "0".into() };
    if hidden.is_empty() {
        // Measuring one of them would not help: the samples are as good as parallel.
        let digits = Precision::bits(VERDICT_BITS / 2).as_digits();
        let message = format!("the outputs do not tell the states apart in {digits} digits");
        return Diagnostic::error(codes::PRECISION, plant.sample_time.1.clone(), message)
            .label(format!("rank {base} of {n}; smallest singular value {smallest_shown}"))
            .measured(smallest)
            .help(
                "a shorter sample time, or a model without the modes that grow beyond all others within a few samples",
            );
    }
    let span = hidden.first().map(|s| s.label.span.clone()).filter(|s| !s.is_empty()).unwrap_or(plant.span.clone());
    let verb = if names.len() == 1 { "state" } else { "states" };
    let output = if outputs.len() == 1 { "output" } else { "outputs" };
    let message = format!("the {verb} {} cannot be estimated from the {output} {}", List(&names), List(&outputs));
    let error = Diagnostic::error(codes::UNOBSERVABLE, span, message).measured(smallest);
    let measure =
        format!("measure {} as well, or leave the part that no output shows out of the model", one_of(&names));
    match directions::said(plant, rows, base) {
        Some(said) if names.len() > 1 => error
            .label(format!("rank {base} of {n}: {said}"))
            .help(format!("{measure}, such as by states that are differences of these")),
        _ => error.label(format!("rank {base} of {n}; smallest singular value {smallest_shown}")).help(measure),
    }
}

/// An output's name; with what it shows, where it is called like a state and shows another.
fn shown(plant: &Plant, output: &crate::plant::Output) -> String {
    let name = &output.label.written;
    let another = plant.states.iter().any(|state| state.label.written == *name) && output.equation != *name;
    if another && !output.equation.is_empty() { format!("{name} = {}", output.equation) } else { name.clone() }
}

pub(super) fn one_of(names: &[&str]) -> String {
    match names {
        [one] => format!("`{one}`"),
        _ => format!("one of {}", List(names)),
    }
}

/// Time since init loses its last digits in single precision, and ends when the calls have been counted.
pub(super) fn time_warning(plant: &Plant) -> Option<Diagnostic> {
    use crate::expr::Symbol;
    let timed = plant.injections.iter().find(|i| i.symbols().contains(&Symbol::Time))?;
    let span = timed.node.span.clone();
    let hours = |calls: f64| calls * plant.sample_time_s() / 3_600.0;
    let (calls, message, label) = match plant.scalar {
        Scalar::F32 => (16_777_216.0, "`t` loses resolution in f32", "it no longer counts every call"),
        Scalar::F64 => (4_294_967_296.0, "`t` stands still in the end", "the calls are no longer counted"),
    };
    let after = hours(calls);
    let warning = Diagnostic::warning(codes::TIME_RESOLUTION, span, message);
    Some(
        warning
            .label(format!("after {after:.1} h {label}"))
            .measured(after)
            .help("call `init` before then, or make it an input that carries the phase"),
    )
}

pub(super) fn constants(model: &Model) -> Vec<NamedMatrix> {
    vec![NamedMatrix { letter: "Phi", rows: model.phi.to_f64() }, NamedMatrix { letter: "C", rows: model.c.to_f64() }]
}

/// Samples that lose more by being stored in single precision than the noise that is declared.
pub(super) fn resolution_warnings(plant: &Plant) -> Vec<Diagnostic> {
    let single = plant.scalar == Scalar::F32;
    plant.outputs.iter().filter(|_| single).filter_map(resolution_warning).collect()
}

fn resolution_warning(output: &crate::plant::Output) -> Option<Diagnostic> {
    let (low, high) = output.range.as_ref()?;
    let largest = low.to_f64().ok()?.abs().max(high.to_f64().ok()?.abs());
    let noise = output.noise.as_ref()?.to_f64().ok().filter(|noise| *noise > 0.0)?;
    // A single has 24 bits; storing rounds by up to half of the last one.
    let rounding = largest * f64::from(f32::EPSILON) / 2.0;
    let name = &output.label.name;
    let message = format!("f32 stores `{name}` more coarsely than its noise");
    let warning = Diagnostic::warning(codes::FLOAT_RESOLUTION, output.label.span.clone(), message)
        .label(format!("rounded by up to {rounding:.1e} within its range, noise {noise:.1e}"))
        .measured(rounding)
        .help("write `scalar = \"f64\"`, or a smaller range");
    (rounding > noise).then_some(warning)
}

/// K and M by age, for reports.
pub(super) fn fir(plant: &Plant, functional: &Functional) -> Fir {
    let n = plant.states.len();
    let by_age = |entry: &dyn Fn(usize, usize) -> Vec<f64>| -> Vec<Vec<Vec<f64>>> {
        (0..=functional.steps).map(|age| (0..n).map(|i| entry(age, i)).collect()).collect()
    };
    let k = by_age(&|age, i| functional.outputs.iter().map(|w| w.at(i, age).double).collect());
    let m = by_age(&|age, i| {
        let weight = |s: usize| {
            let call_age = age.checked_sub(functional.signals[s].part.lag());
            call_age.map_or(0.0, |call_age| functional.knowns[s].at(i, call_age).double)
        };
        (0..functional.signals.len()).map(weight).collect()
    });
    let c = functional.constant.iter().map(|c| c.double).collect();
    Fir { known: functional.signals.iter().map(|s| s.text.clone()).collect(), k, m, c }
}

#[cfg(test)]
mod tests {
    use super::super::designed;

    const MOTOR: &str = r#"
deadbeat = 1
name = "motor"
[states]
q = { derivative = 'dq' }
dq = { derivative = '15*i - 35*sin(q) - dq' }
i = { derivative = '40*u - 36.4*dq - 200*i' }
[inputs]
u = {}
[outputs]
y = { value = 'q' }
[observer.window]
window = 0.1
[target]
sample_time = 1e-3
scalar = "f64"
"#;

    /// The constants settle, and the estimate is unbiased to all digits that were carried.
    #[test]
    fn the_motor_settles() {
        let (_, design) = designed(MOTOR).unwrap();
        assert_eq!(design.window_steps, 100);
        assert!(design.numerics.agreement > 17.0);
        assert!(design.numerics.unbiasedness < 1e-60);
    }

    /// Least squares has the gain 29.3 from bounded noise to velocity, the smallest possible is 21.3
    /// (window-observers, section 5, by an independent linear program).
    #[test]
    fn minimax_weights_have_the_smallest_gain() {
        let slower = MOTOR.replace("1e-3", "2e-3");
        let gain = |text: &str| designed(text).unwrap().1.certificate.noise_gain_l1[1][0];
        assert!((gain(&slower) - 29.3).abs() < 0.05);
        let minimax = gain(&slower.replace("window = 0.1", "window = 0.1\nweights = \"minimax\""));
        assert!((minimax - 21.3).abs() < 0.05, "{minimax}");
    }

    /// The newest sample of the position has the weight that the reference design gives it.
    #[test]
    fn the_first_weight_is_the_reference() {
        let (_, design) = designed(MOTOR).unwrap();
        assert_eq!(design.fir.unwrap().k[0][0][0], 0.039_815_734_113_038_96);
    }
}
