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
//! **Corrected.** (7)'s psi_2 is stable only if 2k > -min Re eig(A1), which the paper does not say: k = 75 on its
//! motor has the eigenvalue +47.2 1/s; the recursive realisation refuses it, the sum over the window needs no such
//! condition, nor any inverse of `A1 + kI`. (13) uses `xi_2(t)` where only Y is known: `R (Y - xihat_2)`, so that
//! (15) misses `|R| |delta_2|`, and (41) needs `q1 + |R|`. (39)'s second line has `A_2 xihat_1`. (38)'s varsigma_3 has
//! `e^{ks}`. The paper's bounds are 1e9 times too large to be of use; the certificate sums the weights themselves.

use std::ops::{Range, RangeInclusive};
use std::sync::Arc;

use super::window::{
    check_hold, fir, read_hold, refuse_unknowns, resolution_warnings, time_warning, verdict, window_steps,
};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::describe::short;
use crate::design::{Certificate, Convergence, Design, NamedMatrix, Shape};
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Constant, Symbol};
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, Singular, inverse};
use crate::spec::Quantity;
use crate::spec::reader::Table;
use crate::window::certificate::slope;
use crate::window::continuous::Form;
use crate::window::coordinates::Coordinates;
use crate::window::innovation::Innovation;
use crate::window::intermittent::{Condition, Lifted, noise_gains};
use crate::window::irregular;
use crate::window::model::{Between, Model, signals_between};
use crate::window::realize::{self, ByInnovation, REALIZATION_CHOICES, REALIZATIONS, Realized, Request, WORDS, Wanted};
use crate::window::settle::{Bias, settle, settle_runs};
use crate::window::solve::{Choice, Exact};
use crate::window::tune::{self, best_k};
use crate::window::{Functional, Gaps, Signal, count, refuse_much_work, seconds, trimmed, whole_samples};

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "single-delay",
    summary: "reduced-order Gramian observer over a window, one delay; also for measurements at irregular times",
    source: "Mazenc and Malisoff 2022 (single delay), Theorems 1 and 2, corrected and made exact for samples",
    keys: &[
        ("window", "s", "tau, a whole number of samples; the estimate has converged after it"),
        ("k", "1/s or \"auto\"", "shapes the weights; any real number; \"auto\" (default): the smallest noise gain"),
        ("form", "\"exact\" | \"continuous\"", "the sampled twin (default), or the paper's integrals from samples"),
        ("hold", "\"first\" | \"third\"", "how nonlinear terms run between samples: order 2 (default) or 4"),
        ("intermittent", "{ min = s, max = s }", "measurements come at irregular times, so far apart"),
        ("unproved", "\"refuse\" | \"accept\"", "what to do when the paper's condition for that does not hold"),
        ("realization", REALIZATION_CHOICES, "how the step computes it"),
    ],
    realizations: &REALIZATIONS,
    page: include_str!("single-delay.md"),
    read,
};

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

/// The shortest and the longest time between two measurements.
#[derive(Clone, Debug)]
struct Intermittent {
    min: Quantity,
    max: Quantity,
    place: Range<usize>,
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

/// What a design has decided before its numbers are exact.
struct Plan {
    steps: usize,
    /// k, 1/s.
    k: Constant,
    rest: Vec<usize>,
    signals: Vec<Signal>,
}

impl Keyed for Keys {
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        found.extend(refuse_delays(plant));
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
        let mut warnings: Vec<Diagnostic> = time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect();
        let mut notes = plan.notes(self, numerics.unbiasedness);
        let convergence = self.irregular(plant, &plan, &mut functional, &exact, &mut notes, &mut warnings)?;
        let innovation = ByInnovation(|model: &Model, steps: usize| plan.innovation_at(plant, model, steps));
        let form: Result<&dyn realize::Form, _> =
            if self.form.0 { Err("integrals from samples follow no recursion") } else { Ok(&innovation) };
        let (wanted, span) = (self.wanted, self.wanted_span.clone());
        let realized = realize::realize(plant, Request { functional, exact: &exact, form, wanted, span })?;
        notes.extend(realized.notes);
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
            constants: plan.constants(self, plant)?,
            fir: Some(fir(plant, &functional)),
            certificate,
            numerics,
            warnings,
            shape: Shape::Window(functional),
        })
    }
}

/// With predictions in place of samples: what their noise does, which they carry on.
///
/// What disturbances do between measurements, and noise inside nonlinear terms, is not bounded here.
fn with_gaps(
    plant: &Plant,
    mut certificate: Certificate,
    functional: &Functional,
    exact: &Exact,
    gaps: Gaps,
) -> Certificate {
    let next = (&exact.model.c * &exact.model.phi).to_f64();
    let periods = (gaps.settled - functional.steps).div_ceil(gaps.most);
    (certificate.noise_gain_l1, certificate.noise_gain_l2) = noise_gains(functional, &next, gaps.most, periods);
    certificate.disturbance_gain_l1.iter_mut().flatten().for_each(|gain| *gain = f64::INFINITY);
    let bounded = plant.disturbances.is_empty() && is_linear(plant);
    let bound = |gains: &Vec<f64>| -> Option<f64> {
        let levels = plant.outputs.iter().map(|output| output.noise.as_ref()?.to_f64().ok());
        gains.iter().zip(levels).try_fold(0.0, |sum, (gain, level)| Some(sum + gain * level?)).filter(|_| bounded)
    };
    certificate.error_bound = certificate.noise_gain_l1.iter().map(bound).collect();
    certificate
}

fn refuse_delays(plant: &Plant) -> Vec<Diagnostic> {
    let late = plant.outputs.iter().filter_map(|output| Some((output, output.delay.as_ref()?)));
    let refuse = |(output, (delay, span)): (&crate::plant::Output, &(Constant, Range<usize>))| {
        let message = format!("`single-delay` needs outputs without delay; `{}` has one", output.label.name);
        let error = Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message);
        error.measured(delay.to_f64().unwrap_or(f64::NAN)).help("`[observer.window]` takes outputs that arrive late")
    };
    late.map(refuse).collect()
}

/// The states that are estimated: those that the outputs show least.
fn rest(plant: &Plant) -> Result<Vec<usize>, Vec<Diagnostic>> {
    let n = plant.states.len();
    let c: Vec<Vec<f64>> =
        plant.c.iter().map(|row| row.iter().map(|c| c.to_f64().unwrap_or(f64::NAN)).collect()).collect();
    let refuse = |span: &Range<usize>, message: &str| {
        let span = if span.is_empty() { &plant.span } else { span };
        Diagnostic::error(codes::METHOD_CANNOT, span.clone(), message)
    };
    if let Some(repeats) = (0..c.len()).find(|o| Coordinates::pick(&c[..=*o], n).is_none()) {
        let label = &plant.outputs[repeats].label;
        let error = refuse(&label.span, &format!("the output `{}` repeats what the ones before it show", label.name));
        return Err(vec![error.help("leave it out, or use `[observer.window]`, which averages over all")]);
    }
    let rest = Coordinates::pick(&c, n).unwrap_or_default();
    if rest.is_empty() {
        let help = "nothing is left to estimate; to average noise away use `[observer.window]`";
        return Err(vec![refuse(&plant.span, "every state is measured").help(help)]);
    }
    if forgets(plant, &rest)? {
        let error = refuse(&plant.span, "the plant forgets part of its state within a sample");
        let error = error.label("without the outputs, the transition from sample to sample is singular");
        return Err(vec![error.help("`[observer.window]` needs no inverse of the transition")]);
    }
    Ok(rest)
}

/// Whether a discrete plant's `Phi_rr` is singular; where that of a sampled plant nearly is, more digits may help.
fn forgets(plant: &Plant, rest: &[usize]) -> Result<bool, Vec<Diagnostic>> {
    if !plant.discrete {
        return Ok(false);
    }
    let model = Model::new(plant, &[], Precision::bits(tune::BITS))?;
    let coordinates = Coordinates::new(&model.c, rest.to_vec());
    Ok(coordinates.is_ok_and(|coordinates| inverse(&coordinates.blocks(&model.phi).rr).is_err()))
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
        let model = Model::new(plant, &[], Precision::bits(tune::BITS))?;
        let best = Coordinates::new(&model.c, rest.to_vec())
            .ok()
            .and_then(|coordinates| best_k(&model, &coordinates, steps, plant.sample_time_s()));
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

    /// Whether measurements at irregular times are enough, and what that makes of the functional.
    fn irregular(
        &self,
        plant: &Plant,
        plan: &Plan,
        functional: &mut Functional,
        exact: &Exact,
        notes: &mut Vec<String>,
        warnings: &mut Vec<Diagnostic>,
    ) -> Result<Convergence, Vec<Diagnostic>> {
        let Some(intermittent) = &self.intermittent else { return Ok(Convergence::Finite) };
        let gaps = intermittent.steps(plant)?;
        let most = *gaps.end();
        let next = (&exact.model.c * &exact.model.phi).to_f64();
        let slowest = Lifted::slowest(functional, &next, gaps);
        let (gap, radius) = slowest.map_or((most, f64::NAN), |(gap, lifted)| (gap, lifted.radius));
        let periods = slowest.and_then(|(_, lifted)| lifted.periods);
        let Some(periods) = periods.filter(|_| radius < 1.0) else {
            return Err(vec![self.diverges(intermittent, plant, radius, gap)]);
        };
        notes.push(format!(
            "linear part: with a measurement every {gap} samples the error's spectral radius is {} a period",
            short(radius)
        ));
        let verdict = self.proof(plant, plan, intermittent, radius, notes);
        if let Err(unproved) = verdict {
            if !self.accept {
                return Err(vec![unproved]);
            }
            warnings.push(Diagnostic { level: crate::diagnostic::Level::Warning, ..unproved });
        }
        functional.gaps = Some(Gaps { most, settled: plan.steps + 1 + periods * gap });
        Ok(Convergence::Geometric { radius, period: gap })
    }

    fn diverges(&self, intermittent: &Intermittent, plant: &Plant, radius: f64, gap: usize) -> Diagnostic {
        let message = "with measurements so far apart the error does not die out";
        let label = format!("spectral radius {} over {gap} samples; it must be below 1", short(radius));
        Diagnostic::error(codes::METHOD_CANNOT, intermittent.max.span(), message).label(label).measured(radius).help(
            format!(
                "measure more often than every {} s, a smaller `k`, or a longer window",
                show(seconds(gap, plant.sample_time_s()))
            ),
        )
    }

    /// 000 Theorem 2's condition; an error that says by what factor it does not hold.
    fn proof(
        &self,
        plant: &Plant,
        plan: &Plan,
        intermittent: &Intermittent,
        radius: f64,
        notes: &mut Vec<String>,
    ) -> Result<(), Diagnostic> {
        let accept =
            format!("`unproved = \"accept\"` relies on the linear part, whose spectral radius is {}", short(radius));
        let unproved = |message: String| {
            Diagnostic::error(codes::METHOD_CANNOT, intermittent.place.clone(), message).help(accept.clone())
        };
        let condition = self.condition(plant, plan, intermittent);
        let Some(condition) = condition else {
            let why = "000 Theorem 2 says nothing here: it needs continuous time, k > 0 for which `A1 + k I` can be \
                       inverted, and bounded slopes over declared ranges";
            notes.push(why.into());
            return Err(unproved("convergence at irregular times is not proved for this plant".into()).label(why));
        };
        if let Some(rate) = condition.rate {
            notes.push(format!("000 Theorem 2 holds: T mu = {}, rate {} 1/s", short(condition.product), short(rate)));
            return Ok(());
        }
        let factor = short(condition.product);
        notes.push(format!("000 Theorem 2 does not hold: T mu = {factor}, mu = {} 1/s", short(condition.mu)));
        let message = "the condition of 000 Theorem 2 for irregular measurements does not hold";
        Err(unproved(message.into())
            .label(format!("T mu = {factor}; it must be below 1"))
            .measured(condition.product)
            .help(format!("{accept}; or at most {} s between measurements", short(1.0 / condition.mu))))
    }

    fn condition(&self, plant: &Plant, plan: &Plan, intermittent: &Intermittent) -> Option<Condition> {
        let k = plan.k.to_f64().ok().filter(|k| *k > 0.0)?;
        if plant.discrete {
            return None;
        }
        let form = plan.form(self);
        let (constants, matrices, coordinates) =
            form.constants(plant, &plan.signals, Precision::bits(tune::BITS)).ok()?;
        let lipschitz = lipschitz(plant, &coordinates, &coordinates.blocks(&matrices.a), k)?;
        let tau = seconds(plan.steps, plant.sample_time_s());
        let gap = plant.constant(&intermittent.max, &mut Vec::new())?.to_f64().ok()?;
        Condition::new(&constants, k, tau, gap, lipschitz)
    }
}

/// K1 and K2 of 000 (3): how steeply F1 and F2 change with Y, in the coordinates.
fn lipschitz(
    plant: &Plant,
    coordinates: &Coordinates,
    blocks: &crate::window::coordinates::Blocks,
    k: f64,
) -> Option<(f64, f64)> {
    let p = plant.outputs.len();
    let norm = |m: &Matrix| crate::real::singular_values(m).first().map_or(0.0, Real::to_f64);
    let shift = Matrix::identity(p, blocks.yy.precision()).scale(&Real::from_f64(k, blocks.yy.precision())?);
    let (mut k1, mut k2) = (norm(&blocks.ry), norm(&(&blocks.yy + &shift)));
    for (i, injection) in plant.injections.iter().enumerate() {
        if !depends_on_states(injection) {
            continue;
        }
        let squares = (0..p).map(|o| slope(plant, i, o)).try_fold(0.0, |sum, slope| Some(sum + slope? * slope?))?;
        let steepest = deadbeat_math::sqrt_f64(squares);
        let precision = blocks.yy.precision();
        let column = |j: usize| injection.column[j].evaluate(precision).unwrap_or_else(|_| Real::zero(precision));
        let column = Matrix::from_fn(plant.states.len(), 1, |j, _| column(j));
        let (y, rest) = coordinates.cut(&column);
        k1 += norm(&rest) * steepest;
        k2 += norm(&y) * steepest;
    }
    Some((k1, k2))
}

impl Intermittent {
    /// The gaps in samples; both times must be whole samples, the first not the longer.
    fn steps(&self, plant: &Plant) -> Result<RangeInclusive<usize>, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let mut steps = |time: &Quantity, what: &str| {
            let value = plant.constant(time, &mut found)?;
            whole_samples(&value, &time.span(), what, plant, &mut found)
        };
        let min = steps(&self.min, "the shortest time between measurements");
        let max = steps(&self.max, "the longest time between measurements");
        match (min, max) {
            (Some(min), Some(max)) if (1..=max).contains(&min) => Ok(min..=max),
            (Some(min), Some(max)) => {
                let message = "`intermittent` needs 0 < min <= max";
                let error = Diagnostic::error(codes::BAD_NUMBER, self.place.clone(), message);
                let error = error.label(format!("{min} and {max} samples")).measured(count(min));
                Err(vec![error.help("min is the shortest, max the longest time from one measurement to the next")])
            }
            _ => Err(found),
        }
    }
}

/// Whether nothing nonlinear depends on what is measured.
fn is_linear(plant: &Plant) -> bool {
    !plant.injections.iter().any(depends_on_states)
}

fn depends_on_states(injection: &crate::plant::Injection) -> bool {
    injection.symbols().iter().any(|symbol| matches!(symbol, Symbol::State(_)))
}

/// The largest round-off of the solve, in units of the samples, that is accepted.
const LARGEST_ROUNDING: f64 = 1e-2;

impl Intermittent {
    /// For linear plants: least squares over the samples that are there, in finite time.
    fn least_squares(
        &self,
        plant: &Plant,
        signals: &[Signal],
        steps: usize,
        condition: f64,
    ) -> Result<Design, Vec<Diagnostic>> {
        let most = *self.steps(plant)?.end();
        let delays = vec![0; plant.outputs.len()];
        let (mut functional, exact, mut numerics) = settle(plant, signals, &delays, steps, &Choice::LeastSquares)?;
        numerics.condition = condition;
        let irregular = irregular::design(plant, signals, steps, most)?;
        let rounding = irregular::unit(plant.scalar) * irregular.amplification(most);
        let certificate = irregular::certify(plant, &irregular, &exact, most);
        let refuse = |message: &str, label: String, number: f64| {
            let error = Diagnostic::error(codes::WINDOW_TOO_SHORT, self.max.span(), message);
            vec![
                error
                    .label(label)
                    .measured(number)
                    .help("measure more often, or leave the fast states out of the model"),
            ]
        };
        if irregular.pivot < 16.0 * irregular.threshold || rounding > LARGEST_ROUNDING {
            let message = "a motion of the plant dies out between two measurements";
            let label = format!(
                "smallest pivot {} with one every {most} samples, round-off {} of the samples in {}",
                short(irregular.pivot),
                short(rounding),
                plant.scalar
            );
            return Err(refuse(message, label, irregular.pivot));
        }
        let Some(certificate) = certificate else {
            let message = "measurements so far apart do not show every state within the window";
            return Err(refuse(message, format!("a measurement every {most} samples"), irregular.pivot));
        };
        functional.irregular = Some(irregular);
        let h = plant.sample_time_s();
        let window = trimmed(seconds(steps, h));
        Ok(Design {
            method: METHOD.name,
            realization: "solve",
            summary: format!(
                "least squares over the samples that are there of the last {} ({window} s at {h} s)",
                steps + 1
            ),
            window_steps: steps,
            valid_from_step: steps,
            convergence: Convergence::Finite,
            realizations: Vec::new(),
            notes: vec![
                format!(
                    "gains with a measurement every {most} samples; round-off then {} of the samples",
                    short(rounding)
                ),
                "a linear plant needs no condition on gaps: 000 Theorem 2 is not used (give `k` to use it)".into(),
            ],
            constants: vec![
                NamedMatrix { letter: "Phi", rows: exact.model.phi.to_f64() },
                NamedMatrix { letter: "C", rows: exact.model.c.to_f64() },
            ],
            fir: None,
            certificate,
            numerics,
            warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
            shape: Shape::Window(functional),
        })
    }
}

fn refuse_gramian(plant: &Plant, why: &str) -> Diagnostic {
    Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), "the reduced observer's Gramian cannot be inverted")
        .label(why)
        .help("`[observer.window]` needs no invertible transition matrix")
}

impl Plan {
    fn form(&self, keys: &Keys) -> Form {
        Form { rest: self.rest.clone(), k: self.k.clone(), steps: self.steps, between: keys.hold.0 }
    }

    /// `e^{-kh}`.
    fn factor(&self, plant: &Plant, p: Precision) -> Option<Real> {
        let h = plant.sample_time.0.evaluate(p).ok()?;
        (-(self.k.evaluate(p).ok()? * h)).checked_exp().ok()
    }

    fn innovation(
        &self,
        plant: &Plant,
        model: &Model,
        p: Precision,
    ) -> Result<(Innovation, crate::window::innovation::SingleDelay, Coordinates), Vec<Diagnostic>> {
        let refuse = || vec![refuse_gramian(plant, &format!("not at {} bits", p.as_bits()))];
        let coordinates = Coordinates::new(&model.c, self.rest.clone()).map_err(|_| refuse())?;
        let a = self.factor(plant, p).ok_or_else(refuse)?;
        let (form, constants) = Innovation::single_delay(model, &coordinates, &a, self.steps).map_err(|_| refuse())?;
        Ok((form, constants, coordinates))
    }

    /// The innovation form of a window of so many samples.
    fn innovation_at(&self, plant: &Plant, model: &Model, steps: usize) -> Result<Innovation, Singular> {
        let none = Singular { column: 0 };
        let coordinates = Coordinates::new(&model.c, self.rest.clone())?;
        let a = self.factor(plant, model.phi.precision()).ok_or(none)?;
        Ok(Innovation::single_delay(model, &coordinates, &a, steps)?.0)
    }

    /// The discrete-exact twin.
    fn exact(&self, plant: &Plant, p: Precision) -> Result<Exact, Vec<Diagnostic>> {
        let model = Model::new(plant, &self.signals, p)?;
        let (form, _, _) = self.innovation(plant, &model, p)?;
        let weights = form.weights(&model, self.steps);
        Ok(Exact::from_weights(model, &self.signals, &weights))
    }

    /// The paper's integrals.
    fn continuous(&self, keys: &Keys, plant: &Plant, p: Precision) -> Result<Exact, Vec<Diagnostic>> {
        self.form(keys).exact(plant, &self.signals, p)
    }

    fn notes(&self, keys: &Keys, unbiasedness: f64) -> Vec<String> {
        if keys.form.0 {
            let note = "integrals from samples leave this share of the state at the window's start";
            return vec![format!("{note}: {}", short(unbiasedness))];
        }
        Vec::new()
    }

    /// S, N, R and what belongs to them.
    fn constants(&self, keys: &Keys, plant: &Plant) -> Result<Vec<NamedMatrix>, Vec<Diagnostic>> {
        let p = Precision::bits(4 * 256);
        let named = |letter: &'static str, m: &Matrix| NamedMatrix { letter, rows: m.to_f64() };
        let scalar = |letter: &'static str, x: &Real| NamedMatrix { letter, rows: vec![vec![x.to_f64()]] };
        if keys.form.0 {
            let (c, _, _) = self.form(keys).constants(plant, &self.signals, p)?;
            let mut all = vec![
                named("A1", &c.a1),
                named("A2", &c.a2),
                named("S", &c.s),
                named("N", &c.n),
                named("R", &c.r),
                named("Sinv", &c.s_inverse),
                scalar("exp(-k tau)", &c.decay),
                named("exp(-(A1' + 2kI) tau)", &c.psi2),
            ];
            all.extend(c.h.as_ref().map(|h| named("H", h)));
            return Ok(all);
        }
        let model = Model::new(plant, &self.signals, p)?;
        let (_, c, _) = self.innovation(plant, &model, p)?;
        let a = self.factor(plant, p).unwrap_or_else(|| Real::zero(p));
        Ok(vec![
            named("Phi", &model.phi),
            named("C", &model.c),
            scalar("a", &a),
            named("S", &c.s),
            named("N", &c.n),
            named("R", &c.r),
        ])
    }
}
