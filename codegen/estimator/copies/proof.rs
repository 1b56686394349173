//! Why the estimate converges, and how fast: always for a sample at every call, else by what the errors do between
//! measurements, and for nonlinear plants by 001's Theorem 2.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Constant;
use crate::numbers::{seconds, short, trimmed};
use crate::plant::Plant;
use crate::promise::Convergence;
use crate::real::{Matrix, Precision, Real};
use crate::sampled::coordinates::Coordinates;
use crate::sampled::model::Model;

use super::errors::{ErrorMap, MOST_PERIODS, periods, spectral_radius};
use super::exact::{Choice, Exact, in_continuous_time};
use super::known::{Known, depends_on_outputs};
use super::slopes::{corners, sloped};
use super::theorem::{Theorem2, lipschitz, named};
use super::{Calls, Form};

/// What is to be proved.
pub struct Asked<'a> {
    /// Of this plant.
    pub plant: &'a Plant,
    /// For this design.
    pub choice: &'a Choice,
    /// With these signals.
    pub knowns: &'a [Known],
    /// The place of `measured_every`.
    pub every: Range<usize>,
    /// Whether a convergence without proof is accepted.
    pub accept: bool,
}

/// What was found.
pub struct Proof {
    /// How the estimate converges.
    pub convergence: Convergence,
    /// The theorem's numbers, where it speaks of the plant.
    pub theorem: Option<Theorem2>,
    /// For reports.
    pub notes: Vec<String>,
    /// What was accepted.
    pub warnings: Vec<Diagnostic>,
}

/// Bits at which the theorem's numbers are computed, and once more where these do not suffice.
const BITS: [usize; 2] = [512, 2_048];

/// Finds out how the estimate converges, and when, which it writes into `calls`.
pub fn prove(asked: &Asked, exact: &Exact, map: &ErrorMap, calls: &mut Calls) -> Result<Proof, Vec<Diagnostic>> {
    let mut proof = Proof { convergence: Convergence::Finite, theorem: None, notes: Vec::new(), warnings: Vec::new() };
    if calls.every == 1 {
        calls.converged = calls.warm_up + calls.period;
        return Ok(proof);
    }
    proof.convergence = asked.contraction(exact, map, calls, &mut proof.notes)?;
    asked.theorem(calls, &mut proof)?;
    Ok(proof)
}

impl Asked<'_> {
    fn linear(&self) -> bool {
        !self.plant.injections.iter().any(|injection| depends_on_outputs(&injection.symbols()))
    }

    fn diverges(&self, radius: f64, message: &str) -> Vec<Diagnostic> {
        let error = Diagnostic::error(codes::UNPROVED, self.every.clone(), message).measured(radius);
        let error = error.label(format!("spectral radius {radius:.4} from reset to reset"));
        vec![error.help("a smaller `measured_every`, or `L = \"auto\"`")]
    }

    /// By what the errors contract from reset to reset.
    fn contraction(
        &self,
        exact: &Exact,
        map: &ErrorMap,
        calls: &mut Calls,
        notes: &mut Vec<String>,
    ) -> Result<Convergence, Vec<Diagnostic>> {
        let h = self.plant.sample_time_s();
        let period = map.period(calls);
        let radius = spectral_radius(&period);
        let (mu, nu) = (trimmed(seconds(calls.every, h)), trimmed(seconds(calls.period, h)));
        notes.push(format!(
            "Measured every {} calls, mu = {mu} s: the linear part's error map over {nu} s has the spectral radius {}",
            calls.every,
            short(radius)
        ));
        if radius >= 1.0 {
            return Err(self.diverges(radius, "the errors between measurements grow from reset to reset"));
        }
        let mut slowest = (radius, period);
        if let Some((radius, period)) = self.steepest(exact, calls, notes).filter(|found| found.0 > radius) {
            if radius < 1.0 {
                slowest = (radius, period);
            } else if !self.accept {
                let message = "the errors between measurements grow where the nonlinear terms are steepest";
                return Err(self.diverges(radius, message));
            }
        }
        let (radius, period) = slowest;
        let Some(periods) = periods(&period) else {
            let message = format!("the estimate needs more than {MOST_PERIODS} windows to converge");
            return Err(self.diverges(radius, &message));
        };
        calls.converged = calls.warm_up + periods * calls.period;
        let finite = self.linear() && radius == 0.0 && self.choice.form == Form::Exact;
        Ok(if finite { Convergence::Finite } else { Convergence::Geometric { radius, period: calls.period } })
    }

    /// The slowest contraction with the nonlinear terms' slopes at the ends of what is declared.
    fn steepest(&self, exact: &Exact, calls: &Calls, notes: &mut Vec<String>) -> Option<(f64, Matrix)> {
        if self.linear() {
            return None;
        }
        let maps = corners(self.plant)?;
        let maps = maps.iter().map(|slopes| ErrorMap::new(&sloped(exact, self.knowns, slopes)).period(calls));
        let (radius, period) = maps.map(|map| (spectral_radius(&map), map)).max_by(|(a, _), (b, _)| a.total_cmp(b))?;
        notes.push(format!(
            "  and with the slopes of the nonlinear terms at the ends of what is declared, at most {}",
            short(radius)
        ));
        Some((radius, period))
    }

    /// 001's Theorem 2, where it speaks of this plant; what it asks and is not given is an error, or a warning.
    fn theorem(&self, calls: &Calls, proof: &mut Proof) -> Result<(), Vec<Diagnostic>> {
        let against = match self.theorem_2(calls) {
            Ok(theorem) => {
                proof.notes.extend(notes(&theorem));
                let against = (theorem.condition >= 1.0).then(|| {
                    let longest = short(theorem.longest_s);
                    let label =
                        format!("mu gamma(mu) = {:.4}, not below 1; mu < {longest} s would be", theorem.condition);
                    (label, Some(theorem.condition))
                });
                proof.theorem = Some(theorem);
                against
            }
            Err(label) => {
                proof.notes.push(format!("Theorem 2 does not apply: {label}"));
                Some((label, None))
            }
        };
        // A linear plant's errors move as the map says, whatever a sufficient condition says of it.
        let Some((label, measured)) = against.filter(|_| !self.linear()) else { return Ok(()) };
        let message = "the convergence between measurements is not proved";
        if self.accept {
            let warning = Diagnostic::warning(codes::UNPROVED, self.every.clone(), message).label(label);
            proof.warnings.push(Diagnostic { measured, ..warning });
            return Ok(());
        }
        let error = Diagnostic::error(codes::UNPROVED, self.every.clone(), message).label(label);
        let help = "a smaller `measured_every`, or `unproved = \"accept\"`: the linear part's errors do contract";
        Err(vec![Diagnostic { measured, ..error }.help(help)])
    }

    /// The theorem's numbers, or why there are none.
    fn theorem_2(&self, calls: &Calls) -> Result<Theorem2, String> {
        let (plant, choice) = (self.plant, self.choice);
        if plant.discrete {
            return Err("it is of plants in continuous time".into());
        }
        let at = |bits: usize| in_continuous_time(plant, choice, Precision::bits(bits));
        let continuous =
            at(BITS[0]).or_else(|_| at(BITS[1])).map_err(|_| "E is singular in continuous time".to_owned())?;
        let precision = continuous.f.yy.precision();
        let model = Model::new(plant, &[], precision).map_err(|_| "the plant cannot be sampled".to_owned())?;
        let coordinates = Coordinates::new(&model.c, choice.rest.clone()).map_err(|error| error.to_string())?;
        let lipschitz = lipschitz(plant, &coordinates.into.to_f64())
            .map_err(|terms| format!("no bound on the slope of {}: declare the outputs' `range`", named(&terms)))?;
        let value = |c: &Constant| c.evaluate(precision).unwrap_or_else(|_| Real::zero(precision));
        let h = value(&plant.sample_time.0);
        let times = |calls: usize| &h * &Real::from_i64(i64::try_from(calls).unwrap_or(i64::MAX), precision);
        let gain = Matrix::from_fn(choice.gain.len(), plant.outputs.len(), |i, o| value(&choice.gain[i][o]));
        Theorem2::new(&continuous, &gain, lipschitz, &times(calls.every), &times(calls.period))
            .map_err(|_| "its bounds are beyond all numbers".to_owned())
    }
}

fn notes(theorem: &Theorem2) -> [String; 2] {
    let [f1, f2] = theorem.lipschitz.map(short);
    let (beta, gamma, condition) = (short(theorem.beta), short(theorem.gamma), short(theorem.condition));
    let longest = short(theorem.longest_s);
    let first = format!(
        "Theorem 2 (in continuous time): Lipschitz constants {f1} and {f2}, beta = {beta} 1/s, gamma(mu) = {gamma} 1/s"
    );
    let second = match theorem.rate {
        Some(rate) => {
            format!(
                "  mu gamma(mu) = {condition} < 1: proved, at a rate of {} 1/s; so for mu < {longest} s",
                short(rate)
            )
        }
        None => format!("  mu gamma(mu) = {condition}: too large by that factor; proved for mu < {longest} s"),
    };
    [first, second]
}
