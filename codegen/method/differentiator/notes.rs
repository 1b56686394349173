//! What the theory says of a differentiator, in words: 003 Theorem 1 for its gains, and the lag of its prediction.

use crate::decimal::show;
use crate::estimator::corrector::theorem1::{Inequalities, margin};
use crate::method::countdown::{Countdown, Numbers};
use crate::numbers::short;
use crate::plant::Plant;
use crate::real::{Precision, Rational, Real};

/// The exponent with which errors fall.
pub(super) fn exponents(plant: &Plant, countdown: &Countdown) -> Vec<String> {
    let Some(scaled) = countdown.scaled(plant) else { return Vec::new() };
    let (mu, least) = (short(margin(&scaled)), countdown.order - 1);
    vec![format!(
        "003 Theorem 1: derivative i of the error falls like (T-t)^({mu}-i); {mu} is above {least}, as it must be"
    )]
}

/// Theorem 1's inequalities where the gains are `L_i rho^i`: whether they hold.
pub(super) fn proved(plant: &Plant, countdown: &Countdown) -> Option<Option<Inequalities>> {
    let precision = Precision::bits(256);
    let time = countdown.time.evaluate(precision).ok()?;
    let gains: Vec<Real> = match &countdown.numbers {
        Numbers::HollowayKrstic(..) => return None,
        Numbers::EfimovOrlov(gains) => gains.iter().map(|l| l.evaluate(precision).ok()).collect::<Option<_>>()?,
        Numbers::Poles(_) => {
            let scaled = countdown.scaled(plant)?;
            let mut power = Real::one(precision);
            let of = |lambda: &Rational| {
                power = &power * &time;
                &Real::from_rational(lambda, precision) / &power
            };
            scaled.iter().map(of).collect()
        }
    };
    Some(Inequalities::new(&gains, &time))
}

/// What Theorem 1's inequalities come to.
pub(super) fn inequalities(plant: &Plant, countdown: &Countdown, found: Option<&Inequalities>) -> String {
    let half = 0.5 * countdown.time.to_f64().unwrap_or(f64::NAN);
    match found {
        Some(found) => format!(
            "003 Theorem 1: holds with P, gamma_1 = {} and gamma_2 = {}, in units in which P's smallest eigenvalue is 1",
            short(found.gamma_1),
            short(found.gamma_2)
        ),
        None => format!(
            "003 Theorem 1: its inequalities have no solution, as they ask for an exponent above T/2 = {}; errors of `{}` \
             vanish at T all the same",
            show(half),
            plant.outputs[0].label.name
        ),
    }
}

/// What the estimates are of a signal that is no polynomial of degree n-1.
pub(super) fn lag(plant: &Plant, order: usize, lags: bool) -> String {
    if lags {
        let lag = show(0.5 * plant.sample_time_s());
        return format!(
            "derivative i lags by i times {lag} s: off by that times derivative i+1; not with `prediction = \"exact\"`"
        );
    }
    if plant.disturbances.is_empty() {
        return format!(
            "bounds are for signals whose derivative {order} is 0; declare its size in [disturbances] for any other"
        );
    }
    format!("no lag in derivatives below {}; derivative {order} reaches the estimates as its gain says", order - 1)
}
