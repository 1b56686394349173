//! The key `order`, a chain of integrators in the plant's place, and `prediction`, how that is carried from sample to
//! sample; for methods that take a plant as well.

use std::ops::RangeInclusive;

use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::design::no_chain;
use crate::plant::Plant;
use crate::promise::Certificate;
use crate::real::{Matrix, Precision, Real};
use crate::sampled::Signal;
use crate::sampled::model::Model;
use crate::spec::reader::Table;

/// Row of a keys' table.
pub const ORDER: (&str, &str, &str) =
    ("order", "whole number", "without a plant: the output and its first order - 1 derivatives are estimated");
/// Row of a keys' table.
pub const PREDICTION: (&str, &str, &str) = (
    "prediction",
    "\"exact\" | \"implicit-euler\"",
    "with `order`: derivatives at the sample, or the paper's own, half a sample and more late",
);

/// What the two keys say.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// n, where a chain of integrators stands for the plant.
    pub order: Option<usize>,
    /// Whether that is implicit Euler's.
    pub euler: bool,
}

/// Reads `order` alone; `None` where it is missing or wrong.
pub fn order(table: &mut Table, orders: RangeInclusive<usize>) -> Option<usize> {
    let (number, span) = table.whole("order")?;
    let order = usize::try_from(number.numerator().clone()).ok().filter(|order| orders.contains(order));
    if order.is_none() {
        let message = format!("`order` must be from {} to {}", orders.start(), orders.end());
        let error = Diagnostic::error(codes::BAD_NUMBER, span, message).measured(number.to_f64().value());
        table.report(error.help("the output and its first order - 1 derivatives are estimated"));
    }
    order
}

/// Reads both keys; a mistake gives `None`.
pub fn read(table: &mut Table, orders: RangeInclusive<usize>) -> Option<Order> {
    let given = table.has("order");
    let order = order(table, orders);
    let span = table.key_span("prediction");
    let predicted = table.has("prediction");
    let euler = table.choice("prediction", &[("exact", false), ("implicit-euler", true)], false);
    if predicted && !given {
        let message = "`prediction` is of the chain of integrators that `order` stands for";
        let error = Diagnostic::error(codes::BAD_COMBINATION, span, message);
        table.report(error.help("leave it out: a plant is predicted exactly"));
        return None;
    }
    (order.is_some() == given).then_some(Order { order, euler })
}

impl Order {
    /// The sampled plant: exact, or `Phi = (I - h A)^-1` of the chain (003 (6)), entries `h^(j-i)` for j >= i.
    ///
    /// # Errors
    /// What sampling reports.
    pub fn model(self, plant: &Plant, signals: &[Signal], p: Precision) -> Result<Model, Vec<Diagnostic>> {
        let mut model = Model::new(plant, signals, p)?;
        if self.euler {
            let h = plant.sample_time.0.evaluate(p).map_err(|_| no_chain(plant, "the sample time has no value"))?;
            let n = plant.states.len();
            let powers: Vec<Real> =
                (0..n).scan(Real::one(p), |power, _| Some(std::mem::replace(power, &*power * &h))).collect();
            model.phi = Matrix::from_fn(n, n, |i, j| if j >= i { powers[j - i].clone() } else { Real::zero(p) });
        }
        Ok(model)
    }

    /// Without the bounds that implicit Euler's lag breaks: it grows with derivatives of which no bound is declared.
    pub fn certain(self, mut certificate: Certificate) -> Certificate {
        if self.lags() {
            certificate.error_bound.iter_mut().skip(1).for_each(|bound| *bound = None);
            let gains = certificate.disturbance_gain_l1.iter_mut().skip(1);
            gains.flatten().for_each(|gain| *gain = f64::INFINITY);
        }
        certificate
    }

    /// Whether estimates are derivatives of the past; with two states they are the exact chain's.
    fn lags(self) -> bool {
        self.euler && self.order > Some(2)
    }

    /// What implicit Euler's estimates are besides; the unit is that of the sample time.
    pub fn late(self, unit: &str) -> Option<String> {
        let text = "backward differences: the i-th derivative is i/2";
        self.lags().then(|| format!("{text} {unit} late; `prediction = \"exact\"` is not"))
    }
}
