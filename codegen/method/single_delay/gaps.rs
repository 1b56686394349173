//! Measurements at irregular times: 000 Theorem 2 for a nonlinear plant, least squares over what is there for a linear one.

use std::ops::RangeInclusive;
use std::sync::Arc;

use super::plan::Plan;
use super::{Intermittent, Keys, METHOD};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, Level, codes};
use crate::estimator::Design;
use crate::estimator::window::intermittent::{Condition, Lifted, noise_gains};
use crate::estimator::window::irregular::{self, Pattern};
use crate::estimator::window::settle::settle;
use crate::estimator::window::solve::{Choice, Exact};
use crate::estimator::window::{Functional, Gaps, tune};
use crate::expr::Symbol;
use crate::method::window::{resolution_warnings, time_warning};
use crate::numbers::{count, seconds, short, trimmed};
use crate::plant::Plant;
use crate::promise::kernel::slope;
use crate::promise::{Certificate, Convergence, NamedMatrix};
use crate::real::{Matrix, Precision, Real, singular_values};
use crate::sampled::Signal;
use crate::sampled::coordinates::{Blocks, Coordinates};
use crate::sampled::samples::whole_samples;
use crate::spec::Quantity;

impl Keys {
    /// Whether measurements at irregular times are enough, and what that makes of the functional.
    pub(super) fn irregular(
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
            return Err(vec![intermittent.diverges(plant, radius, gap)]);
        };
        notes.push(format!(
            "linear part: with a measurement every {gap} samples the error's spectral radius is {} a period",
            short(radius)
        ));
        let verdict = self.proof(plant, plan, intermittent, radius, notes);
        if let Err(unproved) = verdict {
            if !self.accept {
                return Err(vec![*unproved]);
            }
            warnings.push(Diagnostic { level: Level::Warning, ..*unproved });
        }
        functional.gaps = Some(Gaps { most, settled: plan.steps + 1 + periods * gap });
        Ok(Convergence::Geometric { radius, period: gap })
    }

    /// 000 Theorem 2's condition; an error that says by what factor it does not hold.
    fn proof(
        &self,
        plant: &Plant,
        plan: &Plan,
        intermittent: &Intermittent,
        radius: f64,
        notes: &mut Vec<String>,
    ) -> Result<(), Box<Diagnostic>> {
        let accept =
            format!("`unproved = \"accept\"` relies on the linear part, whose spectral radius is {}", short(radius));
        let unproved = |message: String| {
            Diagnostic::error(codes::UNPROVED, intermittent.place.clone(), message).help(accept.clone())
        };
        let condition = self.condition(plant, plan, intermittent);
        let Some(condition) = condition else {
            let why = "Theorem 2 says nothing here: it needs continuous time, k > 0 for which `A1 + k I` can be \
                       inverted, and bounded slopes over declared ranges";
            notes.push(why.into());
            return Err(Box::new(
                unproved("convergence at irregular times is not proved for this plant".into()).label(why),
            ));
        };
        if let Some(rate) = condition.rate {
            notes.push(format!(
                "Theorem 2 (of the continuous observer) holds: T mu = {}, rate {} 1/s",
                short(condition.product),
                short(rate)
            ));
            return Ok(());
        }
        let factor = short(condition.product);
        notes.push(format!(
            "Theorem 2 (of the continuous observer) does not hold: T mu = {factor}, mu = {} 1/s",
            short(condition.mu)
        ));
        let message = "the condition of Theorem 2 for irregular measurements does not hold";
        let unproved = unproved(message.into()).label(format!("T mu = {factor}; it must be below 1"));
        let help = format!("{accept}; or at most {} s between measurements", short(1.0 / condition.mu));
        Err(Box::new(unproved.measured(condition.product).help(help)))
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
fn lipschitz(plant: &Plant, coordinates: &Coordinates, blocks: &Blocks, k: f64) -> Option<(f64, f64)> {
    let p = plant.outputs.len();
    let norm = |m: &Matrix| singular_values(m).first().map_or(0.0, Real::to_f64);
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

/// With predictions in place of samples: what their noise does, which they carry on.
///
/// What disturbances do between measurements, and noise inside nonlinear terms, is not bounded here.
pub(super) fn with_gaps(
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
    certificate.rounding = Vec::new();
    // The longest gap throughout is the sparsest pattern, but not proved to be the worst.
    certificate.error_bound = vec![None; plant.states.len()];
    certificate
}

impl Intermittent {
    fn diverges(&self, plant: &Plant, radius: f64, gap: usize) -> Diagnostic {
        let message = "with measurements so far apart the error does not die out";
        let label = format!("spectral radius {} over {gap} samples; it must be below 1", short(radius));
        let often = show(seconds(gap, plant.sample_time_s()));
        let help = format!("measure more often than every {often} s, a smaller `k`, or a longer window");
        Diagnostic::error(codes::METHOD_CANNOT, self.max.span(), message).label(label).measured(radius).help(help)
    }

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
pub(super) fn is_linear(plant: &Plant) -> bool {
    !plant.injections.iter().any(depends_on_states)
}

fn depends_on_states(injection: &crate::plant::Injection) -> bool {
    injection.symbols().iter().any(|symbol| matches!(symbol, Symbol::State(_)))
}

/// The largest round-off of the solve, in units of the samples, that is accepted.
const LARGEST_ROUNDING: f64 = 1e-2;

impl Intermittent {
    /// For linear plants: least squares over the samples that are there, in finite time.
    pub(super) fn least_squares(
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
        let pattern = Pattern::together(plant.outputs.len(), most);
        let mut irregular = irregular::design(plant, signals, steps, pattern)?;
        irregular.judge(plant, &functional, &exact, true);
        let rounding = irregular::unit(plant.scalar) * irregular.amplification();
        let certificate = irregular::certify(plant, &functional, &irregular, &exact);
        let refuse = |message: &str, label: String, number: f64, help: &str| {
            let error = Diagnostic::error(codes::WINDOW_TOO_SHORT, self.max.span(), message);
            vec![error.label(label).measured(number).help(help)]
        };
        let Some((mut certificate, _)) = certificate else {
            let message = "measurements so far apart do not show every state within the window";
            return Err(refuse(
                message,
                format!("one every {most} samples, {} in the window", steps / most),
                irregular.pivot,
                "a longer window, or measure more often",
            ));
        };
        if irregular.pivot < 16.0 * irregular::limit(plant) || rounding > LARGEST_ROUNDING {
            let message = "a motion of the plant dies out between two measurements";
            let label = format!(
                "smallest pivot {} with one every {most} samples, round-off {} of the samples in {}",
                short(irregular.pivot),
                short(rounding),
                plant.scalar
            );
            let help = "measure more often, or leave the fast states out of the model";
            return Err(refuse(message, label, irregular.pivot, help));
        }
        // Patterns within the declared gaps may cost more than regular ones, so that these bound nothing.
        certificate.error_bound = vec![None; plant.states.len()];
        certificate.error_bound_without.iter_mut().flatten().for_each(|bounds| bounds.fill(None));
        functional.irregular = Some(irregular);
        functional.gaps = Some(Gaps { most, settled: steps + 1 });
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
                    "gains with a measurement every {most} samples, other patterns may cost more; round-off then {} of the samples",
                    short(rounding)
                ),
                "a linear plant needs no condition on gaps: Theorem 2 is not used (give `k` to use it)".into(),
            ],
            constants: vec![
                NamedMatrix { letter: "Phi", rows: exact.model.phi.to_f64() },
                NamedMatrix { letter: "C", rows: exact.model.c.to_f64() },
            ],
            fir: None,
            certificate,
            numerics,
            warnings: time_warning(plant).into_iter().chain(resolution_warnings(plant)).collect(),
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(functional),
        })
    }
}
