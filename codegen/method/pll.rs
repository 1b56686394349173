//! `[observer.pll]`: the tracking loop of motor drives, by its bandwidth.
//!
//! **Idea.** A position and a velocity that follow the sensor: `p += h w; e = y - p; p += h kp e; w += h ki e`, with
//! kp = 2 b and ki = b^2, the critically damped loop of a continuous sensor. It is `alpha-beta` with alpha = kp h and
//! beta = ki h^2.
//!
//! **Source.** Gardner 2005, "Phaselock Techniques", chapter 2, for the loop of second order; in this sampled form
//! what motor drives ship (`ODrive`, moteus, Tinymovr, VESC).
//!
//! **Conditions.** One output without delay; kp h below 1, as drives demand: a sample never pulls the position past it.

use crate::spec::Chain;
use std::sync::Arc;

use super::constant::{Asked, Outputs, design, refuse};
use super::{Keyed, Method, between};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::interval;
use crate::estimator::{Design, corrector};
use crate::expr::Constant;
use crate::numbers::short;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real};
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "pll",
    summary: "the tracking loop of motor drives: a signal and its rate, by a bandwidth",
    source: "Gardner 2005, chapter 2; sampled as motor drives ship it",
    keys: &[("bandwidth", "rad/s", "b: kp = 2 b, ki = b^2; below half the sampling rate, 1/(2 h)")],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: corrector::OF_A_CHAIN,
    page: include_str!("pll.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    bandwidth: Quantity,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let bandwidth = table.quantity("bandwidth");
    if bandwidth.is_none() && !table.has("bandwidth") {
        table.missing("bandwidth", "write `bandwidth = …`, in rad/s: how fast the loop follows");
    }
    Some(Arc::new(Keys { bandwidth: bandwidth? }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain {
            order: Some(2),
            key: None,
            instead: "`[observer.luenberger]` and `[observer.kalman]` have a constant gain for a plant of your own",
        }
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse(plant, METHOD.name, Outputs::One);
        let bandwidth = self.checked(plant, &mut found);
        let Some(bandwidth) = bandwidth.filter(|_| found.is_empty()) else { return Err(found) };
        let law = |_: &_, p: Precision| {
            let numbers = bandwidth.evaluate(p).ok().zip(interval::time(plant, p).ok());
            numbers.map(|(b, h)| Law::Constant(gain(&b, &h))).ok_or_else(|| vec![self.no_number()])
        };
        let (b, h) = (bandwidth.to_f64().unwrap_or(f64::NAN), interval::seconds(plant));
        let summary =
            format!("tracking loop of {} rad/s: kp = {} 1/s, ki = {} 1/s^2", show(b), short(2.0 * b), short(b * b));
        let late = between::late(plant, 2.0 / b - 0.5 * h, "2/b - h/2");
        let notes = |_: &_| Ok(vec![late.clone()]);
        design(
            plant,
            Asked {
                method: METHOD.name,
                outputs: Outputs::One,
                summary,
                warnings: Vec::new(),
                law: &law,
                notes: &notes,
            },
        )
    }
}

impl Keys {
    /// b, above 0, with kp h below 1.
    fn checked(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Constant> {
        let bandwidth = plant.constant(&self.bandwidth, found)?;
        let (b, h) = (bandwidth.to_f64().unwrap_or(f64::NAN), interval::seconds(plant));
        if b <= 0.0 {
            let error = Diagnostic::error(codes::BAD_NUMBER, self.bandwidth.span(), "the bandwidth must be above 0");
            found.push(error.measured(b).help("write how fast the loop is to follow, in rad/s"));
            return None;
        }
        if 2.0 * b * h >= 1.0 {
            let message = match interval::calls(plant) {
                1 => "the bandwidth is too large for this sample time".to_owned(),
                _ => format!("the bandwidth is too large for samples {} s apart", between::apart(plant)),
            };
            let error = Diagnostic::error(codes::OUT_OF_RANGE, self.bandwidth.span(), message);
            let error = error.label(format!("kp h = 2 b h = {}; it must be below 1", short(2.0 * b * h)));
            let help = format!("below {} rad/s, or a shorter sample time", short(0.5 / h));
            found.push(error.measured(2.0 * b * h).help(help));
            return None;
        }
        Some(bandwidth)
    }

    fn no_number(&self) -> Diagnostic {
        Diagnostic::error(codes::DOMAIN, self.bandwidth.span(), "the bandwidth has no usable value")
    }
}

/// `K = [kp h, ki h]`, 2 x 1.
fn gain(b: &Real, h: &Real) -> Matrix {
    let kp = (b * h).shifted(1);
    let ki = &(b * b) * h;
    Matrix::from_fn(2, 1, |i, _| if i == 0 { kp.clone() } else { ki.clone() })
}
