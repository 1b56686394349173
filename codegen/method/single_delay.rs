//! `[observer.single-delay]`: the reduced-order Gramian observer with one delay.
//!
//! **Idea.** Only what is not measured is estimated. In coordinates `(y, x_r)` a copy of the plant is driven by the
//! measurement; its innovation over the last `window` seconds, weighted by an observability Gramian, corrects it. One
//! delay, the window, whatever the number of states. A real number k shapes the weights: it trades the newest sample
//! against the older ones and never decides about convergence.
//!
//! **Source.** 000 (mazenc-malisoff-2022-single-delay), Theorem 1: (4)-(7), (13); Theorem 2: (36)-(43) for
//! measurements at irregular times. By default the discrete-exact twin (window-observers, section 2): integrals
//! become sums over the samples, `e^{A1 r}` powers of Phi, so that the estimate is exact to rounding at any sample
//! time; `form = "continuous"` samples the paper's integrals instead.
//!
//! **Conditions.** (A, C) observable, C of full rank, outputs without delay; nonlinear terms in measured states,
//! inputs and time only.
//!
//! **Corrected.** (7)'s `psi_2` is stable only if 2k > -min Re eig(A1), which the paper does not say: k = 75 on its
//! motor has the eigenvalue +47.2 1/s; the recursive realisation refuses it, the sum over the window needs no such
//! condition, nor any inverse of `A1 + kI`. (13) uses `xi_2(t)` where only Y is known: `R (Y - xihat_2)`, so that
//! (15) misses `|R| |delta_2|`, and (41) needs `q1 + |R|`. (39)'s second line has `A_2 xihat_1`. (38)'s `varsigma_3` has
//! `e^{ks}`. The paper's bounds are 1e9 times too large to be of use; the certificate sums the weights themselves.

mod gaps;
mod plan;

use std::ops::Range;
use std::sync::Arc;

use super::window::{
    check_hold, fir, read_hold, refuse_unknowns, resolution_warnings, sensor_notes, time_warning, verdict, window_steps,
};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::Design;
use crate::estimator::window::realize::{
    self, ByInnovation, REALIZATION_CHOICES, REALIZATIONS, Realized, Request, WORDS, Wanted,
};
use crate::estimator::window::settle::{Bias, settle_runs};
use crate::estimator::window::tune::{self, best_k};
use crate::expr::Constant;
use crate::numbers::{seconds, short, trimmed};
use crate::plant::Plant;
use crate::plant::features::{Feature, Limit, UNTURNED, holds, is_coarse};
use crate::real::Precision;
use crate::sampled::coordinates::Coordinates;
use crate::sampled::model::{Between, Model, signals_between};
use crate::sampled::samples::refuse_much_work;
use crate::sampled::settle::LAST_BITS;
use crate::spec::Quantity;
use crate::spec::reader::Table;
use gaps::{is_linear, with_gaps};
use plan::{Plan, refuse_gramian, rest};

const LIMITS: &[Limit] = &[
    Limit::new(
        Feature::Wrap,
        "its integrals from samples are no sums of differences",
        "`form = \"exact\"`, or the method `window`",
    )
    .when("with `form = \"continuous\"`", |case| holds(case.keys::<Keys>().form.0)),
    Limit::new(
        Feature::Counter,
        "it solves for positions, and single precision does not hold every count of 32 bits",
        "write `wrap`, a turn of at most 2^24 counts, a `range` within 2^24 counts of 0, or `scalar = \"f64\"`",
    )
    .when(
        "of 32 bits in f32, unless `wrap` is a turn of at most 2^24 counts or `range` within these, with `intermittent`",
        |case| holds(case.keys::<Keys>().intermittent.is_some() && is_coarse(case)),
    ),
    UNTURNED,
    Limit::new(
        Feature::Every,
        "its weights are of a sample at every call of the window",
        "its key `intermittent`, or the method `window`",
    ),
    Limit::new(
        Feature::Age,
        "its weights are of samples taken at the calls",
        "the method `window`, which takes samples of any age",
    ),
    Limit::new(
        Feature::Delay,
        "its theorem has one delay, the window, and a late output would bring a second",
        "`[observer.window]` takes outputs that arrive late",
    ),
    Limit::new(
        Feature::LeftOut,
        "its weights are of all samples of the window, and others would be needed for those that are there",
        "its key `intermittent`, or the method `window`",
    ),
    Limit::new(Feature::Windows, "its theorem has one delay, the window", "the method `window`, which takes several"),
];

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "single-delay",
    summary: "reduced-order Gramian observer over a window, one delay; also for measurements at irregular times",
    source: "Mazenc and Malisoff 2022 (single delay), Theorems 1 and 2, corrected and made exact for samples",
    keys: &[
        ("window", "s", "tau, a whole number of samples; the estimate has converged after it"),
        ("k", "1/s or \"auto\"", "shapes the weights; any real number; \"auto\" (default): a small noise gain"),
        ("form", "\"exact\" | \"continuous\"", "the sampled twin (default), or the paper's integrals from samples"),
        ("hold", "\"first\" | \"third\"", "how nonlinear terms run between samples: order 2 (default) or 4"),
        ("intermittent", "{ min = s, max = s }", "measurements come at irregular times, so far apart"),
        ("unproved", "\"refuse\" | \"accept\"", "what to do when the paper's condition for that does not hold"),
        ("realization", REALIZATION_CHOICES, "how the step computes it"),
    ],
    realizations: &REALIZATIONS,
    limits: LIMITS,
    page: include_str!("single-delay.md"),
    read,
};

/// Bits of the matrices that are reported, at least.
const REPORTED: usize = 4 * 256;

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    window: Quantity,
    /// `None` for "auto".
    k: Option<Quantity>,
    /// Whether the paper's integrals are asked for, and where.
    form: (bool, Range<usize>),
    hold: (Between, Range<usize>),
    intermittent: Option<Intermittent>,
    accept: bool,
    wanted: Wanted,
    wanted_span: Range<usize>,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    let window = table.quantity("window");
    if window.is_none() && !table.has("window") {
        table.missing("window", "write `window = …`, the delay tau in seconds, by which the estimate is exact");
    }
    let k = table.quantity("k").filter(|k| !matches!(k, Quantity::Expression(text) if text.value == "auto"));
    let place = table.key_span("form");
    let form = (table.choice("form", &[("exact", false), ("continuous", true)], false), place);
    let hold = read_hold(table);
    let intermittent = read_intermittent(table);
    let accept = table.choice("unproved", &[("refuse", false), ("accept", true)], false);
    let wanted_span = table.key_span("realization");
    let wanted = table.choice("realization", &WORDS, Wanted::Auto);
    Some(Arc::new(Keys { window: window?, k, form, hold, intermittent, accept, wanted, wanted_span }))
}

/// The shortest and the longest time between two measurements.
#[derive(Clone, Debug)]
struct Intermittent {
    min: Quantity,
    max: Quantity,
    place: Range<usize>,
}

fn read_intermittent(table: &mut Table) -> Option<Intermittent> {
    let mut gaps = table.table("intermittent", "`intermittent`")?;
    let mut time = |key: &str| {
        let time = gaps.quantity(key);
        if time.is_none() && !gaps.has(key) {
            gaps.missing(key, "write `intermittent = { min = …, max = … }`, the times between measurements in seconds");
        }
        time
    };
    let (min, max, place) = (time("min"), time("max"), gaps.span());
    gaps.finish();
    Some(Intermittent { min: min?, max: max?, place })
}

impl Keyed for Keys {
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        found.extend(self.refuse_discrete(plant));
        let steps = window_steps(plant, &self.window, &mut found);
        let Some(steps) = steps else { return Err(found) };
        refuse_much_work(plant, steps, &self.window.span(), &mut found);
        let signals = signals_between(plant, self.hold.0);
        check_hold(plant, &signals, &self.hold, steps, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let condition = verdict(plant, &vec![0; plant.outputs.len()], steps, &self.window.span())?;
        if let (Some(intermittent), None, true) = (&self.intermittent, &self.k, is_linear(plant)) {
            return intermittent.least_squares(plant, &signals, steps, condition);
        }
        let rest = rest(plant)?;
        let k = self.k(plant, &rest, steps)?;
        let plan = Plan { steps, k, rest, signals };
        let bias = if self.form.0 { Bias::OfSampling } else { Bias::None };
        let run = |p: Precision| if self.form.0 { plan.continuous(self, plant, p) } else { plan.exact(plant, p) };
        let (mut functional, exact, mut numerics) =
            settle_runs(plant, &plan.signals, &vec![0; plant.outputs.len()], steps, bias, &run)?;
        numerics.condition = condition;
        let settled = exact.model.phi.precision();
        let mut warnings: Vec<Diagnostic> = time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect();
        let mut notes = Vec::new();
        if self.form.0 {
            let note = "integrals from samples leave this share of the state at the window's start";
            notes.push(format!("{note}: {}", short(numerics.unbiasedness)));
        }
        let convergence = self.irregular(plant, &plan, &mut functional, &exact, &mut notes, &mut warnings)?;
        let innovation = ByInnovation(|model: &Model, steps: Range<usize>| plan.innovations(plant, model, steps));
        let form: Result<&dyn realize::Form, _> =
            if self.form.0 { Err("integrals from samples follow no recursion") } else { Ok(&innovation) };
        let (wanted, span) = (self.wanted, self.wanted_span.clone());
        let realized = realize::realize(plant, Request { functional, exact: &exact, form, wanted, span })?;
        notes.extend(realized.notes);
        notes.extend(sensor_notes(plant, steps));
        let Realized { functional, mut certificate, name, realizations, .. } = realized;
        if let Some(gaps) = functional.gaps {
            certificate = with_gaps(plant, certificate, &functional, &exact, gaps);
        }
        Ok(Design {
            method: METHOD.name,
            realization: name,
            summary: self.summary(plant, &plan),
            window_steps: steps,
            valid_from_step: functional.gaps.map_or(steps, |gaps| gaps.settled - 1),
            convergence,
            realizations,
            notes,
            constants: plan.constants(self, plant, settled.max(Precision::bits(REPORTED)))?,
            fir: Some(fir(plant, &functional)),
            certificate,
            numerics,
            warnings,
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(functional),
        })
    }
}

impl Keys {
    fn refuse_discrete(&self, plant: &Plant) -> Option<Diagnostic> {
        let message = "`form = \"continuous\"` needs a plant in continuous time";
        let error = Diagnostic::error(codes::METHOD_CANNOT, self.form.1.clone(), message);
        (self.form.0 && plant.discrete).then(|| error.help("leave `form` out: the exact form is for samples"))
    }

    /// k as given, or the best.
    fn k(&self, plant: &Plant, rest: &[usize], steps: usize) -> Result<Constant, Vec<Diagnostic>> {
        let mut found = Vec::new();
        if let Some(k) = &self.k {
            let Some(value) = plant.constant(k, &mut found) else {
                let help = "write a number in 1/s, an expression of [parameters], or \"auto\"";
                return Err(found.into_iter().map(|mistake| mistake.help(help)).collect());
            };
            let size = value.to_f64().unwrap_or(f64::NAN) * plant.sample_time_s();
            // e^{-kh} beyond this is no factor to weigh samples with.
            return if size.abs() < 50.0 {
                Ok(value)
            } else {
                let error = Diagnostic::error(codes::OUT_OF_RANGE, k.span(), "`k` is too large for this sample time");
                let error = error.label(format!("k times the sample time is {}", show(size))).measured(size);
                let most = show(50.0 / plant.sample_time_s());
                let help = format!("less than {most} 1/s; `k = \"auto\"` finds the one with the smallest noise gain");
                Err(vec![error.help(help)])
            };
        }
        // As many digits as some k needs.
        let (mut best, mut bits) = (None, tune::BITS);
        while best.is_none() && bits <= LAST_BITS {
            let model = Model::new(plant, &[], Precision::bits(bits))?;
            let coordinates = Coordinates::new(&model.c, rest.to_vec()).ok();
            best = coordinates.and_then(|coordinates| best_k(&model, &coordinates, steps, plant.sample_time_s()));
            bits *= 2;
        }
        let decimal = best.and_then(|k| crate::decimal::parse(&format!("{k:e}")).ok());
        decimal.map(Constant::from).ok_or_else(|| vec![refuse_gramian(plant, "no k gives weights for this window")])
    }

    fn summary(&self, plant: &Plant, plan: &Plan) -> String {
        let h = plant.sample_time_s();
        let form = if self.form.0 { "the paper's integrals from samples" } else { "sampled twin" };
        format!(
            "{form} over the last {} samples ({} s at {h} s), k = {} 1/s",
            plan.steps + 1,
            trimmed(seconds(plan.steps, h)),
            short(plan.k.to_f64().unwrap_or(f64::NAN))
        )
    }
}
