//! `[observer.alpha-beta]`: the fixed-gain tracker of a signal and its rate, or its acceleration too.
//!
//! **Idea.** Predict by the chain of integrators, correct by the innovation e: the signal by alpha e, its rate by
//! (beta/h) e, its acceleration by (gamma/h^2) e. One number says how much a new sample counts; the others follow such
//! that all poles of the error lie in one place, r: the gains of a least-squares line or parabola whose samples count
//! r times as much with each that follows ("critically damped", "fading memory").
//!
//! **Source.** Benedict and Bordner 1962 for the filter; the rule from Brookner 1998, "Tracking and Kalman Filtering
//! Made Easy", after Morrison 1969 (the fading-memory polynomial filter): with two states alpha = 1 - r^2,
//! beta = (1 - r)^2; with three alpha = 1 - r^3, beta = 3/2 (1 - r)^2 (1 + r), gamma = (1 - r)^3.
//!
//! **Conditions.** One output without delay; alpha between 0 and 1.

use crate::spec::Chain;
use std::sync::Arc;

use super::constant::{Asked, Outputs, design, refuse};
use super::{Keyed, Method, between, order};
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
    name: "alpha-beta",
    summary: "the fixed-gain tracker: a signal and its rate, by how much a new sample counts",
    source: "Benedict and Bordner 1962; the rule from Brookner 1998 (fading memory)",
    keys: &[
        ("alpha", "0 … 1", "how much of the innovation corrects the signal"),
        ("beta", "number", "by h, of the rate; by default all poles of the error lie in one place"),
        ("order", "2 | 3", "3: the acceleration is estimated too; 2 by default"),
        ("gamma", "number", "with `order = 3` and `beta`: by h^2, of the acceleration"),
    ],
    realizations: &[("recursive", "the state is carried on from call to call, and corrected")],
    limits: corrector::OF_A_CHAIN,
    page: include_str!("alpha-beta.md"),
    read,
};

/// The method's keys.
#[derive(Clone, Debug)]
struct Keys {
    order: usize,
    /// alpha alone, or every gain.
    gains: Vec<Quantity>,
}

fn read(table: &mut Table) -> Option<Arc<dyn Keyed>> {
    table.choice("realization", &[("auto", ()), ("recursive", ())], ());
    let order = if table.has("order") { order::order(table, 2..=3) } else { Some(2) };
    let alpha = table.quantity("alpha");
    if alpha.is_none() && !table.has("alpha") {
        table.missing("alpha", "write `alpha = …`, between 0 and 1: how much a new sample counts");
    }
    let given = [table.quantity("beta"), table.quantity("gamma")];
    let order = order?;
    let wanted = [true, order == 3];
    let present = ["beta", "gamma"].map(|key| table.has(key));
    if present[1] && !wanted[1] {
        let message = "`gamma` corrects an acceleration, which `order = 2` does not have";
        let error = Diagnostic::error(codes::BAD_COMBINATION, table.key_span("gamma"), message);
        table.report(error.help("leave it out, or write `order = 3`"));
        return None;
    }
    if order == 3 && present[0] != present[1] {
        let (there, missing) = if present[0] { ("beta", "gamma") } else { ("gamma", "beta") };
        let message = format!("`{there}` is given and `{missing}` is not");
        let error = Diagnostic::error(codes::BAD_COMBINATION, table.key_span(there), message);
        table.report(error.help("write both, or neither: then the rule gives them from `alpha`"));
        return None;
    }
    let more = given.into_iter().zip(present).filter(|(_, there)| *there).map(|(value, _)| value);
    let gains = std::iter::once(alpha).chain(more).collect::<Option<Vec<Quantity>>>()?;
    Some(Arc::new(Keys { order, gains }))
}

impl Keyed for Keys {
    fn chain(&self) -> Chain {
        Chain {
            order: Some(self.order),
            key: None,
            instead: "`[observer.luenberger]` and `[observer.kalman]` have a constant gain for a plant of your own",
        }
    }

    fn design(&self, plant: &Plant) -> Result<Design, Vec<Diagnostic>> {
        let mut found = refuse(plant, METHOD.name, Outputs::One);
        let values: Vec<Option<Constant>> = self.gains.iter().map(|gain| plant.constant(gain, &mut found)).collect();
        let Some(values) = values.into_iter().collect::<Option<Vec<Constant>>>() else { return Err(found) };
        self.check(&values, &mut found);
        if !found.is_empty() {
            return Err(found);
        }
        let law = |_: &_, p: Precision| {
            let gains = self.at(&values, p).zip(interval::time(plant, p).ok());
            let gains = gains.map(|(gains, h)| Law::Constant(scaled(&gains, &h)));
            gains.ok_or_else(|| vec![self.no_number()])
        };
        let gains = self.at(&values, Precision::bits(256)).ok_or_else(|| vec![self.no_number()])?;
        let gains: Vec<f64> = gains.iter().map(Real::to_f64).collect();
        let named = ["alpha", "beta", "gamma"].iter().zip(&gains);
        let named = named.map(|(name, value)| format!("{name} = {}", short(*value))).collect::<Vec<_>>().join(", ");
        let rule = if self.ruled() { ", all poles of the error in one place" } else { "" };
        let late = match self.order {
            2 => {
                let samples = gains[0] / gains[1] - 0.5;
                between::late(plant, samples * interval::seconds(plant), "(alpha/beta - 1/2) h")
            }
            _ => "at constant acceleration nothing is late".to_owned(),
        };
        let notes = |_: &_| Ok(vec![late.clone()]);
        let asked = Asked {
            method: METHOD.name,
            outputs: Outputs::One,
            summary: format!("{named}{rule}"),
            warnings: Vec::new(),
            law: &law,
            notes: &notes,
        };
        design(plant, asked)
    }
}

impl Keys {
    /// Whether the rule gives all but alpha.
    fn ruled(&self) -> bool {
        self.gains.len() == 1
    }

    /// What stands against the numbers.
    fn check(&self, values: &[Constant], found: &mut Vec<Diagnostic>) {
        let numbers: Vec<f64> = values.iter().map(|value| value.to_f64().unwrap_or(f64::NAN)).collect();
        let alpha = numbers[0];
        if alpha <= 0.0 || alpha >= 1.0 {
            let message = format!("`alpha` must be between 0 and 1, not {}", show(alpha));
            let error = Diagnostic::error(codes::BAD_NUMBER, self.gains[0].span(), message).measured(alpha);
            found.push(error.help("0.1 smooths, 0.9 follows; `[observer.fixed-time-linear]` is what 1 would be"));
            return;
        }
        for ((name, value), gain) in ["beta", "gamma"].iter().zip(&numbers[1..]).zip(&self.gains[1..]) {
            if *value <= 0.0 {
                let message = format!("`{name}` must be above 0, not {}", show(*value));
                let error = Diagnostic::error(codes::BAD_NUMBER, gain.span(), message).measured(*value);
                found.push(error.help("leave it out: the rule gives it from `alpha`"));
            }
        }
        let most = 4.0 - 2.0 * alpha;
        if let (2, Some(beta)) = (self.order, numbers.get(1).filter(|beta| **beta >= most)) {
            let error = Diagnostic::error(codes::OUT_OF_RANGE, self.gains[1].span(), "the estimate would run away");
            let error = error.label(format!("`beta` must be below 4 - 2 alpha = {}", short(most))).measured(*beta);
            found.push(error.help("leave it out: the rule gives it from `alpha`"));
        }
    }

    /// alpha, beta and with three states gamma at one precision.
    fn at(&self, values: &[Constant], p: Precision) -> Option<Vec<Real>> {
        let given = values.iter().map(|value| value.evaluate(p).ok()).collect::<Option<Vec<Real>>>()?;
        if !self.ruled() {
            return Some(given);
        }
        let alpha = given.first()?;
        let one = Real::one(p);
        let rest = &one - alpha;
        if self.order == 2 {
            let r = rest.checked_sqrt().ok()?;
            let short = &one - &r;
            return Some(vec![alpha.clone(), &short * &short]);
        }
        let three = Real::from_i64(3, p);
        let r = rest.checked_powf(&(&one / &three)).ok()?;
        let short = &one - &r;
        let square = &short * &short;
        let beta = (&(&square * &(&one + &r)) * &three).shifted(-1);
        Some(vec![alpha.clone(), beta, &square * &short])
    }

    fn no_number(&self) -> Diagnostic {
        Diagnostic::error(codes::DOMAIN, self.gains[0].span(), "a gain has no usable value")
    }
}

/// `K = [alpha, beta/h, gamma/h^2]`, n x 1.
fn scaled(gains: &[Real], h: &Real) -> Matrix {
    let mut power = Real::one(h.precision());
    let entries: Vec<Real> = gains
        .iter()
        .map(|gain| {
            let entry = gain / &power;
            power = &power * h;
            entry
        })
        .collect();
    Matrix::from_fn(entries.len(), 1, |i, _| entries[i].clone())
}
