//! `[observer.robust-exact]`: Levant's differentiator in implicit form; for a chain of integrators or a plant.
//!
//! **Idea.** Corrections that grow with roots of the innovation, the last one with its sign alone, hold a bounded highest
//! derivative at bay: the error is gone in finite time, exactly so without noise, and with noise the law weighs by
//! itself. Computed implicitly there is no chattering: the sign takes whatever value brings the innovation to 0.
//!
//! **Source.** Levant 2003 ("Higher-order sliding modes, differentiation and output-feedback control") for the law and
//! its parameters; the implicit step of prescribed-time-observers, section 5; any plant by M and q (section 3), which
//! take any correction that is a function of the innovation. See [`crate::estimator::corrector::sliding`].
//!
//! **Conditions.** Those of `fixed-time-linear`, up to six states.
//!
//! **Holds.** No time is promised: it depends on the initial error. What is certain is the error after n calls whose
//! innovations are small; the status says when that is so ([`Backward`]).

use crate::spec::Chain;
use std::sync::Arc;

use super::order::{self, Order};
use super::window::{constants, refuse_unknowns, resolution_warnings, time_warning, verdict};
use super::{Keyed, Method};
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::design::{Built, Promise, Request, build, no_chain};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::sliding::{Backward, ExactSliding, ORDERS, Sliding};
use crate::estimator::corrector::{Counting, Frame, Gain, ONE_RATE};
use crate::estimator::{Design, corrector};
use crate::expr::Constant;
use crate::numbers::{count, short};
use crate::plant::features::{Feature, Limit, POSITIONS};
use crate::plant::{Disturbance, Plant};
use crate::promise::{Certificate, Convergence, NamedMatrix};
use crate::real::Precision;
use crate::sampled::model::signals;
use crate::sampled::settled::Settled;
use crate::spec::Quantity;
use crate::spec::reader::Table;

const LIMITS: &[Limit] = &[
    Limit::new(
        Feature::Every,
        "only what is proven is offered: that n small innovations in a row bound its error, for a correction at every \
         call; missing is the bound for the calls between two corrections",
        ONE_RATE,
    ),
    corrector::AGE,
    corrector::DELAY,
    corrector::ONE_OUTPUT,
    corrector::LEFT_OUT,
    corrector::WINDOWS,
    POSITIONS,
];

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "robust-exact",
    summary: "Levant's differentiator, implicit: nothing to know but a bound on the highest derivative",
    source: "Levant 2003; Efimov and Orlov 2024 compare with it; implicit, for any plant with one output",
    keys: &[
        order::ORDER,
        (
            "lipschitz",
            "unit of the output/s^n",
            "L: bound on the n-th derivative of the output; with a plant, on what its equations leave out of it",
        ),
        order::PREDICTION,
    ],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: LIMITS,
    page: include_str!("robust-exact.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    order: Order,
    lipschitz: Quantity,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let order = order::read(table, ORDERS);
    let lipschitz = table.quantity("lipschitz");
    if lipschitz.is_none() && !table.has("lipschitz") {
        table.missing("lipschitz", "write `lipschitz = …`, a bound on the n-th derivative of the output");
    }
    Some(Arc::new(Keys { order: order?, lipschitz: lipschitz? }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain { order: self.order.order, key: Some("order"), instead: "leave out `order`" }
    }

    /// The highest derivative is what the chain does not know: a disturbance, unless one is declared.
    fn observed(&self, mut plant: Plant) -> Result<Plant, Vec<Diagnostic>> {
        let lipschitz = self.lipschitz(&plant)?;
        if let (Some(order), [output], true) =
            (self.order.order, plant.outputs.as_slice(), plant.disturbances.is_empty())
        {
            let mut label = output.label.clone();
            label.name = format!("d{order}{}", label.name);
            label.unit = String::new();
            label.doc = format!("derivative {order} of {}", output.label.name);
            let column = (1..=order).map(|i| Constant::from(crate::real::Rational::from(u8::from(i == order))));
            plant.disturbances.push(Disturbance { label, bound: lipschitz, column: column.collect() });
        }
        Ok(plant)
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse_unknowns(plant, METHOD.name);
        refuse_size(plant, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let n = plant.states.len();
        let lipschitz = self.lipschitz(plant)?;
        let condition = verdict(plant, &[0], n, &plant.span)?;
        let signals = signals(plant);
        let request = Request {
            plant,
            signals: signals.clone(),
            counting: Counting::NONE,
            scaled: self.order.order.is_some(),
            promise: Promise::At(n),
            model: &|p: Precision| self.order.model(plant, &signals, p),
            law: &|_, p: Precision| Ok((Law::Sliding(self.law(plant, &lipschitz, p)?), None)),
        };
        let mut built = build(&request)?;
        let calm = sense(plant, &mut built)?;
        let Built { corrector, exact, certificate, mut numerics, .. } = built;
        numerics.condition = condition;
        let Gain::Sliding { law, .. } = &corrector.gain else { unreachable!("the gain of this law") };
        let mut warnings: Vec<Diagnostic> = self.weak(plant, law, calm.disturbance).into_iter().collect();
        warnings.extend(time_warning(plant));
        warnings.extend(resolution_warnings(plant));
        let mut all = constants(&exact.model);
        let m = match &corrector.frame {
            Frame::Plant { spread, .. } => spread.as_ref().map(|spread| &spread.m),
            Frame::Chain { readout, .. } => Some(readout),
        };
        let number = |entry: &Option<Settled>| entry.map_or(0.0, |entry| entry.double);
        let rows = m.map(|m| m.iter().map(|row| row.iter().map(number).collect()).collect());
        all.extend(rows.map(|rows| NamedMatrix { letter: "M", rows }));
        all.push(NamedMatrix { letter: "c_n", rows: vec![vec![law.reach.double]] });
        Ok(Design {
            method: METHOD.name,
            realization: "recursive",
            summary: format!(
                "corrections by roots of the innovation, for a highest derivative up to {}",
                shown(&lipschitz)
            ),
            window_steps: n,
            valid_from_step: n,
            convergence: Convergence::Sensed { calls: n, innovation: calm.bound },
            realizations: Vec::new(),
            notes: self.notes(plant, law),
            constants: all,
            fir: None,
            certificate: self.order.certain(certificate),
            numerics,
            warnings,
            longer: Vec::new(),
            phases: Vec::new(),
            estimator: Arc::new(corrector),
        })
    }
}

/// Which innovations are explained.
struct Calm {
    /// The largest.
    bound: f64,
    /// What the disturbances explain of it.
    disturbance: f64,
}

impl Keys {
    /// L, above 0.
    fn lipschitz(&self, plant: &Plant) -> Result<Constant, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let value = plant.constant(&self.lipschitz, &mut found);
        let number = value.as_ref().map_or(f64::NAN, |value| value.to_f64().unwrap_or(f64::NAN));
        if value.is_some() && !(number > 0.0 && number.is_finite()) {
            let message = format!("`lipschitz` must be above 0, not {}", crate::decimal::show(number));
            let error = Diagnostic::error(codes::BAD_NUMBER, self.lipschitz.span(), message).measured(number);
            found.push(error.help("write a bound on the magnitude of the output's n-th derivative"));
        }
        value.filter(|_| found.is_empty()).ok_or(found)
    }

    /// The law at one precision.
    fn law(&self, plant: &Plant, lipschitz: &Constant, p: Precision) -> Result<ExactSliding, Vec<Diagnostic>> {
        let values = lipschitz.evaluate(p).ok().zip(plant.sample_time.0.evaluate(p).ok());
        let law = values.and_then(|(l, h)| ExactSliding::new(plant.states.len(), &l, &h, p).ok());
        law.ok_or_else(|| {
            let message = "a constant of the gain law has no usable value";
            vec![Diagnostic::error(codes::DOMAIN, self.lipschitz.span(), message)]
        })
    }

    /// A bound that the declared disturbances break.
    fn weak(&self, plant: &Plant, law: &Sliding, disturbance: f64) -> Option<Diagnostic> {
        let reach = law.reach.double;
        if disturbance <= reach {
            return None;
        }
        let message = "the declared disturbances are more than `lipschitz` allows for";
        let label = format!(
            "they move the next sample by up to {}, this corrects {} at once",
            short(disturbance),
            short(reach)
        );
        let warning = Diagnostic::warning(codes::WEAK, self.lipschitz.span(), message).measured(disturbance / reach);
        let value = self.lipschitz(plant).ok()?.to_f64().ok()?;
        Some(warning.label(label).help(format!("`lipschitz = {}`", short(value * disturbance / reach * 1.1))))
    }

    fn notes(&self, plant: &Plant, law: &Sliding) -> Vec<String> {
        let name = &plant.outputs[0].label.name;
        let mut notes = vec![
            "no time is promised: how long it takes grows with the initial error".to_owned(),
            format!("up to {} off its prediction, a sample of {name} is taken as it is", short(law.reach.double)),
            format!("{} steps of Newton's method a call, enough for every innovation", law.iterations(plant.scalar)),
        ];
        notes.extend(self.order.late("samples"));
        notes
    }
}

/// Writes into the design which innovations count as explained, and what is certain then.
fn sense(plant: &Plant, built: &mut Built) -> Result<Calm, Vec<Diagnostic>> {
    let model = &built.exact.model;
    let chain = built.exact.chain.as_ref().ok_or_else(|| no_chain(plant, "there is no chain form"))?;
    let backward = Backward::new(&model.phi, &model.c, &chain.m, &chain.q);
    let noise = plant.outputs[0].noise.as_ref().map_or(0.0, |noise| noise.to_f64().unwrap_or(0.0));
    let disturbance = backward.disturbance(plant).unwrap_or(0.0);
    let Gain::Sliding { law, calm } = &mut built.corrector.gain else { unreachable!("the gain of this law") };
    let bound = plant.scalar_value(law.reach.double.max(disturbance) + backward.noise * noise);
    *calm = bound;
    built.corrector.recovery = built.corrector.valid + 1;
    let short = backward.error(&law.shortfall(bound));
    let whole = built.certificate.error_bound.iter().zip(short).map(|(linear, short)| linear.map(|it| it + short));
    // The gains are those of backward differences, not of this law: what holds of it is the bound.
    let error_bound = whole.collect();
    built.certificate = Certificate { error_bound, ..Certificate::default() };
    Ok(Calm { bound, disturbance })
}

fn shown(value: &Constant) -> String {
    short(value.to_f64().unwrap_or(f64::NAN))
}

fn refuse_size(plant: &Plant, found: &mut Vec<Diagnostic>) {
    let n = plant.states.len();
    if !ORDERS.contains(&n) {
        let message = format!("`robust-exact` has parameters for {} to {} states", ORDERS.start(), ORDERS.end());
        let error = Diagnostic::error(codes::METHOD_CANNOT, plant.span.clone(), message);
        let error = error.label(format!("the plant has {n}")).measured(count(n));
        found.push(error.help("use the method `prescribed-time` or `window`, which take any number"));
    }
}
