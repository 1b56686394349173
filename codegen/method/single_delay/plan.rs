//! What a single-delay design has decided before its numbers are exact, and those numbers at a precision.

use std::ops::Range;

use super::Keys;
use crate::diagnostic::{Diagnostic, codes};
use crate::estimator::window::continuous::Form;
use crate::estimator::window::innovation::{Innovation, SingleDelay};
use crate::estimator::window::solve::Exact;
use crate::estimator::window::tune;
use crate::expr::Constant;
use crate::plant::Plant;
use crate::promise::NamedMatrix;
use crate::real::{Matrix, Precision, Real, Singular, inverse};
use crate::sampled::Signal;
use crate::sampled::coordinates::Coordinates;
use crate::sampled::model::Model;

/// What a design has decided before its numbers are exact.
pub(super) struct Plan {
    pub(super) steps: usize,
    /// k, 1/s.
    pub(super) k: Constant,
    pub(super) rest: Vec<usize>,
    pub(super) signals: Vec<Signal>,
}

impl Plan {
    pub(super) fn form(&self, keys: &Keys) -> Form {
        Form { rest: self.rest.clone(), k: self.k.clone(), steps: self.steps, between: keys.hold.0 }
    }

    /// `e^{-kh}`.
    pub(super) fn factor(&self, plant: &Plant, p: Precision) -> Option<Real> {
        let h = plant.sample_time.0.evaluate(p).ok()?;
        (-(self.k.evaluate(p).ok()? * h)).checked_exp().ok()
    }

    pub(super) fn innovation(
        &self,
        plant: &Plant,
        model: &Model,
        p: Precision,
    ) -> Result<(Innovation, SingleDelay, Coordinates), Vec<Diagnostic>> {
        let refuse = || vec![refuse_gramian(plant, &format!("not at {} bits", p.as_bits()))];
        let coordinates = Coordinates::new(&model.c, self.rest.clone()).map_err(|_| refuse())?;
        let a = self.factor(plant, p).ok_or_else(refuse)?;
        let (form, constants) = Innovation::single_delay(model, &coordinates, &a, self.steps).map_err(|_| refuse())?;
        Ok((form, constants, coordinates))
    }

    /// The innovation forms of windows of so many samples.
    pub(super) fn innovations(
        &self,
        plant: &Plant,
        model: &Model,
        steps: Range<usize>,
    ) -> Result<Vec<Innovation>, Singular> {
        let none = Singular { column: 0 };
        let coordinates = Coordinates::new(&model.c, self.rest.clone())?;
        let a = self.factor(plant, model.phi.precision()).ok_or(none)?;
        let all = Innovation::single_delays(model, &coordinates, &a, steps)?;
        Ok(all.into_iter().map(|(form, _)| form).collect())
    }

    /// The discrete-exact twin.
    pub(super) fn exact(&self, plant: &Plant, p: Precision) -> Result<Exact, Vec<Diagnostic>> {
        let model = Model::new(plant, &self.signals, p)?;
        let (form, _, _) = self.innovation(plant, &model, p)?;
        let weights = form.weights(&model, self.steps);
        Ok(Exact::from_weights(model, &self.signals, &weights))
    }

    /// The paper's integrals.
    pub(super) fn continuous(&self, keys: &Keys, plant: &Plant, p: Precision) -> Result<Exact, Vec<Diagnostic>> {
        self.form(keys).exact(plant, &self.signals, p)
    }

    /// S, N, R and what belongs to them, at one precision.
    pub(super) fn constants(
        &self,
        keys: &Keys,
        plant: &Plant,
        p: Precision,
    ) -> Result<Vec<NamedMatrix>, Vec<Diagnostic>> {
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

/// The states that are estimated: those that the outputs show least.
pub(super) fn rest(plant: &Plant) -> Result<Vec<usize>, Vec<Diagnostic>> {
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

pub(super) fn refuse_gramian(plant: &Plant, why: &str) -> Diagnostic {
    Diagnostic::error(codes::PRECISION, plant.span.clone(), "the reduced observer's Gramian cannot be inverted")
        .label(why)
        .help("a shorter window, or `[observer.window]`, which needs no invertible transition matrix")
}
