//! `[observer.parameters]`: the state and unknown constants together, from the last `window` seconds.
//!
//! **Idea.** `x' = A x + ... + sum_i eps_i gamma_i` with unknown constants `eps_i`. The samples of a window are
//! linear equations in the state at its start and in the `eps_i`; solved together by least squares they
//! give both, exactly, after N+1 samples (`form = "joint"`). Constant gammas give a functional with constant
//! weights; with gammas that vary the equations are set up and solved in every call (`parameters/regressing.rs`).
//!
//! **Source.** 002 (mazenc-malisoff-2022-parameters-and-states), Theorems 1, 2 and 3, which find the `eps_i`
//! in a second stage from the state's first (`form = "paper"`, `parameters/two_stages.rs`). The joint form is one stage
//! (window-observers, section 2: one Gramian of the plant and its exosystem contains everything, kappa is
//! minus its off-diagonal block), needs no Assumption 2, and takes any number of outputs and unknowns.
//!
//! **Conditions.** (A, C) observable; the Schur complement of the joint Gramian not singular
//! (`parameters/identifiable.rs`).

mod determinant;
mod regressing;
mod two_stages;

use std::ops::Range;
use std::sync::Arc;

use super::window::{
    constants, delays, fir, refuse_long_delays, resolution_warnings, time_warning, verdict, window_steps,
};
use super::{Keyed, Method};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::window::Functional;
use crate::estimator::window::realize::{
    Form, LeastSquares, REALIZATION_CHOICES, Realized, Request, WORDS, Wanted, realize,
};
use crate::estimator::window::settle::settle;
use crate::estimator::window::solve::{Choice, Exact};
use crate::numbers::{seconds, trimmed};
use crate::plant::Plant;
use crate::plant::features::{Against, Case, Feature, Limit, POSITIONS, holds};
use crate::promise::{Convergence, NamedMatrix};
use crate::sampled::model::signals;
use crate::sampled::samples::refuse_much_work;
use crate::sampled::settle::Numerics;
use crate::sampled::unknowns::augment::{augmented, varying, without};
use crate::sampled::unknowns::functions::with_functions;
use crate::sampled::unknowns::identifiable;
use crate::spec::Quantity;
use crate::spec::reader::Table;
use two_stages::Paper;

const AS_STATES: &str =
    "the method `window`, with unknowns whose factors are constant as states whose derivative is '0'";
const JOINT: &str = "leave `form` out: the joint form takes this";

const LIMITS: &[Limit] = &[
    POSITIONS,
    Limit::new(Feature::Every, "its window takes a sample of every output at every call", AS_STATES),
    Limit::new(Feature::Age, "its regression is of samples taken at the calls", AS_STATES),
    Limit::new(Feature::Delay, "Theorem 3, for discrete plants, has no delay", JOINT)
        .when("of a discrete plant, with `form = \"paper\"`", |case| holds(is_paper(case) && case.plant.discrete)),
    Limit::new(Feature::Delay, "Theorem 2, for a delay, has one unknown", JOINT)
        .when("with several unknowns and `form = \"paper\"`", second_unknown),
    Limit::new(Feature::Outputs, "the paper's theorems are for one output", JOINT)
        .when("with `form = \"paper\"`", |case| holds(is_paper(case))),
    Limit::new(
        Feature::LeftOut,
        "only what is designed for is offered: whether the samples that are there tell the unknowns apart would have \
         to be judged in every call",
        AS_STATES,
    ),
    Limit::new(
        Feature::Windows,
        "only what is designed for is offered: what tells its unknowns apart is judged for one window",
        AS_STATES,
    ),
    Limit::new(
        Feature::Ahead,
        "the factor of an unknown varies, and nothing says how it goes on",
        "leave it out, and carry the estimate on where the factor is known",
    )
    .when("where the factor of an unknown varies", |case| holds(!varying(case.plant).is_empty())),
    Limit::new(Feature::InitAt, "its two stages have no model of an unknown whose factor varies", "`form = \"joint\"`")
        .when("with `form = \"paper\"`, where the factor of an unknown varies", |case| {
            holds(is_paper(case) && !varying(case.plant).is_empty())
        }),
];

fn is_paper(case: &Case) -> bool {
    case.keys::<Keys>().paper.is_some()
}

fn second_unknown(case: &Case) -> Against {
    let second = case.plant.unknowns.get(1).filter(|_| is_paper(case))?;
    Some(Some((second.label.span.clone(), "the second unknown")))
}

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "parameters",
    summary: "the state and unknown constants together, over the last N+1 samples",
    source: "Mazenc and Malisoff 2022 (parameters and states), Theorems 1, 2, 3, made exact for samples",
    keys: &[
        ("window", "s", "length of the window, a whole number of samples; the estimate has converged after it"),
        ("form", "\"joint\" | \"paper\"", "one least-squares problem, or the paper's two stages"),
        ("integration_window", "s", "T of the paper's second stage; as long as `window` by default"),
        ("shifts", "list of s", "tau_i of the paper, one per unknown; `[0]` by default"),
        (
            "excitation",
            "number",
            "share of an unknown's effect that the state must not explain; 1e-3 in f32, 1e-6 in f64 (varying factors)",
        ),
        ("realization", REALIZATION_CHOICES, "how the step computes it, where all factors are constant"),
    ],
    realizations: &[
        (
            "fir",
            "one weighted sum over the stored samples; no state that can drift (constant factors; others as for `window`)",
        ),
        ("regression", "responses and equations over the stored samples in every call (varying factors)"),
    ],
    limits: LIMITS,
    page: include_str!("parameters.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    window: Quantity,
    paper: Option<Paper>,
    excitation: Option<Quantity>,
    wanted: (Wanted, Range<usize>),
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let window = table.quantity("window");
    if window.is_none() && !table.has("window") {
        table.missing(
            "window",
            "write `window = …`, the length in seconds; the deadline by which the estimate is exact",
        );
    }
    let paper = table.choice("form", &[("joint", false), ("paper", true)], false);
    let stages = Paper { integration: table.quantity("integration_window"), shifts: table.list("shifts") };
    for key in ["integration_window", "shifts"] {
        if !paper && table.has(key) {
            let message = format!("`{key}` belongs to `form = \"paper\"`");
            let error = Diagnostic::error(codes::BAD_COMBINATION, table.key_span(key), message);
            table.report(error.help("leave it out: the joint form has one stage"));
        }
    }
    let excitation = table.quantity("excitation");
    if paper && table.has("excitation") {
        let message = "`excitation` belongs to `form = \"joint\"`";
        let error = Diagnostic::error(codes::BAD_COMBINATION, table.key_span("excitation"), message);
        table.report(error.help("leave it out"));
    }
    let place = table.key_span("realization");
    let wanted = (table.choice("realization", &WORDS, Wanted::Auto), place);
    Some(Arc::new(Keys { window: window?, paper: paper.then_some(stages), excitation, wanted }))
}

/// A window that fits the plant.
struct Frame {
    /// N.
    steps: usize,
    /// Whole samples, per output.
    delays: Vec<usize>,
    /// Of the joint observability matrix.
    condition: f64,
}

impl Keyed for Keys {
    fn observed(&self, plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        if plant.unknowns.is_empty() {
            let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), "there is no unknown to estimate");
            return Err(vec![error.help("declare it under [unknowns], or use the method `window`")]);
        }
        with_functions(augmented(plant))
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        if let Some(paper) = &self.paper {
            return two_stages::design(plant, &self.window, paper, &self.wanted);
        }
        let frame = Frame::new(plant, &self.window)?;
        if !varying(plant).is_empty() {
            self.refuse_realization()?;
            return regressing::design(plant, &frame, self.excitation.as_ref());
        }
        let settled = settle(plant, &signals(plant), &frame.delays, frame.steps, &Choice::LeastSquares)?;
        let constants = constants(&settled.1.model);
        let late = frame.delays.iter().any(|delay| *delay > 0);
        let form: Result<&dyn Form, _> = if late { Err("an output arrives late") } else { Ok(&LeastSquares) };
        functional(plant, &frame, settled, (form, &self.wanted), (summary(plant, frame.steps), constants))
    }
}

impl Keys {
    /// With varying factors there is one way to compute the step.
    fn refuse_realization(&self) -> Result<(), Vec<Diagnostic>> {
        let (wanted, place) = &self.wanted;
        if *wanted == Wanted::Auto {
            return Ok(());
        }
        let message = "unknowns with varying factors are found by a regression in the step";
        let error = Diagnostic::error(codes::REALIZATION, place.clone(), message);
        Err(vec![error.help("leave `realization` out")])
    }
}

impl Frame {
    /// Refuses windows that are none, states that are not seen, unknowns that are not told apart.
    fn new(plant: &Plant, window: &Quantity) -> Result<Self, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let steps = window_steps(plant, window, &mut found);
        let delays = delays(plant, &mut found);
        let (Some(steps), Some(delays)) = (steps, delays) else { return Err(found) };
        let span = window.span();
        refuse_long_delays(plant, &delays, steps, &span, &mut found);
        refuse_much_work(plant, steps, &span, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let every: Vec<usize> = (0..plant.unknowns.len()).collect();
        verdict(&without(plant, &every), &delays, steps, &span)?;
        let base = without(plant, &varying(plant));
        identifiable::check(&base, &delays)?;
        let condition = verdict(&base, &delays, steps, &span)?;
        Ok(Self { steps, delays, condition })
    }
}

/// A functional with constant weights.
fn functional(
    plant: &Plant,
    frame: &Frame,
    (functional, exact, numerics): (Functional, Exact, Numerics),
    (form, (wanted, place)): (Result<&dyn Form, &'static str>, &(Wanted, Range<usize>)),
    (summary, constants): (String, Vec<NamedMatrix>),
) -> Result<Design, Vec<Diagnostic>> {
    let request = Request { functional, exact: &exact, form, wanted: *wanted, span: place.clone() };
    let Realized { functional, mut certificate, name, realizations, notes } = realize(plant, request)?;
    // What the regression's own sums lose is not in it.
    certificate.rounding = Vec::new();
    Ok(Design {
        method: METHOD.name,
        realization: name,
        summary,
        window_steps: frame.steps,
        valid_from_step: frame.steps,
        convergence: Convergence::Finite,
        realizations,
        notes,
        constants,
        fir: Some(fir(plant, &functional)),
        certificate,
        numerics: Numerics { condition: frame.condition, ..numerics },
        warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
        longer: Vec::new(),
        phases: Vec::new(),
        estimator: Arc::new(functional),
    })
}

fn summary(plant: &Plant, steps: usize) -> String {
    let h = plant.sample_time_s();
    format!(
        "joint least squares for states and unknowns over the last {} samples ({} s at {h} s)",
        steps + 1,
        trimmed(seconds(steps, h))
    )
}
