//! `[observer.high-gain]`: a constant gain that grows with the i-th power of one number.
//!
//! **Idea.** In the coordinates of a chain of integrators, injections `L_i gain^i` make the error as fast as `gain`
//! says, whatever the plant's own dynamics: one number to turn. What it cannot know (the last derivative) is left with
//! 1/gain of its size; noise is amplified by gain^(i-1).
//!
//! **Source.** Khalil 2017, "High-Gain Observers in Nonlinear Feedback Control", chapter 2; 003 (4) with a constant
//! rho. Sampled by implicit Euler, `c_i = h^i L_i gain^i`, and taken to any observable plant by M and q
//! (prescribed-time-observers, sections 0 and 3), so that it is stable at every sample time.
//!
//! **Conditions.** (C, A) observable with one output at the sample time, no mode that is gone within a sample, no
//! delay, nonlinearities in measured states, inputs and time only.

use std::ops::Range;
use std::sync::Arc;

use super::constant::{Asked, Outputs, design, refuse};
use super::countdown::listed;
use super::poles::{self, Exact, Poles};
use super::{Keyed, Method};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::corrector::exact::Law;
use crate::estimator::corrector::interval;
use crate::estimator::corrector::placement::{Pole, polynomial};
use crate::estimator::{Design, corrector};
use crate::expr::Constant;
use crate::numbers::short;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real};
use crate::spec::Quantity;
use crate::spec::reader::Table;

/// The registry's entry.
pub const METHOD: Method = Method {
    name: "high-gain",
    summary: "a constant gain that one number makes faster; one output",
    source: "Khalil 2017, chapter 2; Efimov and Orlov 2024, (4) with constant rho; implicit, for any plant",
    keys: &[
        ("gain", "1/s", "the i-th derivative's error is corrected by L_i gain^i"),
        (
            "poles",
            "dimensionless",
            "as many as states, below 0: of s^n + L_1 s^(n-1) + … + L_n; times `gain`, in rad/s",
        ),
        ("L", "list", "instead of `poles`: L_1 … L_n, above 0"),
    ],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: corrector::OF_ONE_OUTPUT,
    page: include_str!("high-gain.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    gain: Quantity,
    law: Written,
}

/// The polynomial.
#[derive(Clone, Debug)]
enum Written {
    Poles(Poles),
    Coefficients(Vec<Quantity>, Range<usize>),
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let gain = table.quantity("gain");
    if gain.is_none() && !table.has("gain") {
        table.missing("gain", "write `gain = …`, in 1/s: how fast the error dies out");
    }
    let poles = poles::read(table);
    let coefficients = table.list("L");
    let law = match (poles, coefficients) {
        (Some(_), Some((_, span))) => {
            let message = "`poles` and `L` say the same thing twice";
            let error = Diagnostic::error(codes::BAD_COMBINATION, span, message);
            table.report(error.context(table.key_span("poles"), "the other").help("leave one of them out"));
            None
        }
        (Some(poles), None) => Some(Written::Poles(poles)),
        (None, Some((list, span))) => Some(Written::Coefficients(list, span)),
        (None, None) => {
            if !table.has("poles") && !table.has("L") {
                table.missing(
                    "poles",
                    "write `poles = [-1, …]`, one per state, or the polynomial's coefficients `L = [..]`",
                );
            }
            None
        }
    };
    Some(Arc::new(Keys { gain: gain?, law: law? }))
}

/// The keys' numbers.
enum Numbers {
    Poles(Vec<Exact>),
    Coefficients(Vec<Constant>),
}

impl Keyed for Keys {
    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse(plant, METHOD.name, Outputs::One);
        let gain = plant.constant(&self.gain, &mut found);
        let value = gain.as_ref().map_or(f64::NAN, |gain| gain.to_f64().unwrap_or(f64::NAN));
        if gain.is_some() && value <= 0.0 {
            let error = Diagnostic::error(codes::BAD_NUMBER, self.gain.span(), "the gain must be above 0");
            found.push(error.measured(value).help("write how fast the error is to die out, in 1/s"));
        }
        let numbers = self.numbers(plant, &mut found);
        let (Some(gain), Some(numbers), true) = (gain, numbers, found.is_empty()) else { return Err(found) };
        let law = |_: &_, p: Precision| {
            let speed = interval::time(plant, p).ok().zip(gain.evaluate(p).ok());
            let speed = speed.map(|(h, gain)| &h * &gain).ok_or_else(|| self.no_number())?;
            Ok(Law::Kappa(kappa(&numbers.coefficients(p), &speed)))
        };
        let summary = format!(
            "errors corrected by L_i gain^i, gain = {} 1/s ({} per sample); implicit Euler",
            show(value),
            short(value * interval::seconds(plant))
        );
        let notes = |_: &_| {
            let coefficients: Vec<String> =
                numbers.coefficients(Precision::bits(256)).iter().map(|l| short(l.to_f64())).collect();
            Ok(vec![format!("L = [{}]", coefficients.join(", "))])
        };
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
    fn numbers(&self, plant: &Plant, found: &mut Vec<Diagnostic>) -> Option<Numbers> {
        match &self.law {
            Written::Poles(poles) => poles.check(plant, found).map(Numbers::Poles),
            Written::Coefficients(list, span) => {
                let values = listed(plant, list, span, ("L", plant.states.len()), found)?;
                let wrong = values.iter().position(|value| value.to_f64().is_ok_and(|value| value <= 0.0));
                if let Some(i) = wrong {
                    let message = format!("L_{} must be above 0", i + 1);
                    let error = Diagnostic::error(codes::BAD_NUMBER, list[i].span(), message);
                    let error = error.measured(values[i].to_f64().unwrap_or(f64::NAN));
                    found.push(error.help(
                        "a polynomial without a positive coefficient has roots to the right; write `poles` instead",
                    ));
                    return None;
                }
                Some(Numbers::Coefficients(values))
            }
        }
    }

    fn no_number(&self) -> Vec<Diagnostic> {
        vec![Diagnostic::error(codes::DOMAIN, self.gain.span(), "a constant of the gain has no usable value")]
    }
}

impl Numbers {
    /// L at one precision.
    fn coefficients(&self, p: Precision) -> Vec<Real> {
        match self {
            Self::Poles(poles) => {
                let poles: Vec<Pole> = poles.iter().map(|pole| pole.at(p)).collect();
                polynomial(&poles).split_off(1)
            }
            Self::Coefficients(values) => {
                values.iter().map(|value| value.evaluate(p).unwrap_or_else(|_| Real::zero(p))).collect()
            }
        }
    }
}

/// `kappa_j = S_j / (1 + S_1)`, n x 1, with `S_j = sum_(i>=j) c_i` and `c_i = L_i (gain h)^i`; every `L_i` above 0.
fn kappa(coefficients: &[Real], speed: &Real) -> Matrix {
    let p = speed.precision();
    let mut power = Real::one(p);
    let mut sums: Vec<Real> = Vec::new();
    for coefficient in coefficients {
        power = &power * speed;
        sums.push(coefficient * &power);
    }
    for j in (1..sums.len()).rev() {
        sums[j - 1] = &sums[j - 1] + &sums[j];
    }
    let one = Real::one(p);
    let denominator = sums.first().map_or_else(|| one.clone(), |first| &one + first);
    Matrix::from_fn(sums.len(), 1, |j, _| &sums[j] / &denominator)
}
