//! A design as JSON.

use serde_json::{Map, Value, json};

use crate::generated::{Generated, VERSION};
use crate::method::Moment;
use crate::plant::Label;
use crate::plant::modes::modes;
use crate::program::cost::cost;
use crate::promise::{Certificate, Convergence, Phase, Realization};

impl Generated {
    /// The design for machines, as `deadbeat design --format json` prints it; the keys are those of the manual.
    pub fn to_json(&self) -> Value {
        all(self)
    }
}

impl Moment {
    /// The gains for machines: its matrices by their letters; what is infinite is null.
    pub fn to_json(&self) -> Value {
        let matrices = self.matrices.iter().map(|matrix| (matrix.letter.to_owned(), json!(matrix.rows)));
        let mut all: Map<String, Value> = matrices.collect();
        all.insert("step".into(), json!(self.step));
        all.insert("left".into(), json!(self.left));
        all.insert("in_use".into(), json!(self.in_use));
        Value::Object(all)
    }
}

fn all(generated: &Generated) -> Value {
    let (plant, design) = (&generated.plant, &generated.design);
    let names = |labels: Vec<&Label>| -> Vec<String> { labels.iter().map(|l| l.name.clone()).collect() };
    let constants: Map<String, Value> =
        design.constants.iter().map(|matrix| (matrix.letter.to_owned(), json!(matrix.rows))).collect();
    let fir = design.fir.as_ref().map(|fir| json!({ "known": fir.known, "K": fir.k, "M": fir.m, "c": fir.c }));
    let cost = cost(&generated.program, deadbeat_math::COSTS);
    let warnings: Vec<Value> =
        generated.report.diagnostics.iter().map(|d| json!({ "code": d.code, "message": d.message })).collect();
    let convergence = match design.convergence {
        Convergence::Finite => json!({ "radius": 0.0, "period": design.window_steps }),
        Convergence::Geometric { radius, period } => json!({ "radius": radius, "period": period }),
        Convergence::Sensed { calls, innovation } => json!({ "calls_within": calls, "innovation": innovation }),
        Convergence::Prescribed { left } => json!({ "initial_error_left": left }),
    };
    let realizations: Vec<Value> = design.realizations.iter().map(realization).collect();
    let mut all = json!({
        "deadbeat": VERSION,
        "name": plant.name,
        "method": design.method,
        "realization": design.realization,
        "n": plant.states.len(),
        "inputs": names(plant.inputs.iter().map(|u| &u.label).collect()),
        "outputs": names(plant.outputs.iter().map(|y| &y.label).collect()),
        "states": names(plant.states.iter().map(|x| &x.label).collect()),
        "unknowns": names(plant.unknowns.iter().map(|u| &u.label).collect()),
        "sample_time": plant.sample_time_s(),
        "window_steps": design.window_steps,
        "valid_from_step": design.valid_from_step,
        "convergence": convergence,
        "realizations": realizations,
        "notes": design.notes,
        "modes": modes(plant),
        "constants": constants,
        "fir": fir,
        "certificate": promised(&design.certificate),
        "one_count": generated.one_count.0,
        "cost": {
            "ram_bytes": cost.ram_bytes,
            "flash_bytes": cost.flash_bytes,
            "stack_bytes": cost.stack_bytes,
            "flops_worst": cost.flops_worst,
            "flops_mean": cost.flops_worst,
        },
        "numerics": {
            "digits": design.numerics.digits,
            "agreement": design.numerics.agreement,
            "condition": design.numerics.condition,
            "unbiasedness": design.numerics.unbiasedness,
        },
        "warnings": warnings,
    });
    if !design.longer.is_empty() {
        let longer = design.longer.iter().map(|longer| (longer.steps, &longer.certificate));
        let windows = std::iter::once((design.window_steps, &design.certificate)).chain(longer);
        all["windows"] = windows
            .map(|(steps, certificate)| json!({ "window_steps": steps, "certificate": promised(certificate) }))
            .collect();
    }
    if !design.phases.is_empty() {
        let phase = |it: &Phase| json!({ "noise_gain_l1": it.noise_gain_l1, "noise_gain_l2": it.noise_gain_l2 });
        all["phases"] = design.phases.iter().map(phase).collect();
    }
    all
}

fn promised(certificate: &Certificate) -> Value {
    let mut all = json!({
        "noise_gain_l1": certificate.noise_gain_l1,
        "noise_gain_l2": certificate.noise_gain_l2,
        "disturbance_gain_l1": certificate.disturbance_gain_l1,
        "error_bound": certificate.error_bound,
        "initial_gain": certificate.initial_gain,
        "rounding": certificate.rounding,
    });
    // Where samples are left out; without an output, null where the others do not determine the state.
    if !certificate.error_bound_with_losses.is_empty() {
        all["error_bound_with_losses"] = json!(certificate.error_bound_with_losses);
    }
    if !certificate.error_bound_without.is_empty() {
        all["error_bound_without"] = json!(certificate.error_bound_without);
    }
    all
}

fn realization(realization: &Realization) -> Value {
    let (possible, because) = match &realization.verdict {
        Ok(why) => (true, why),
        Err(why) => (false, why),
    };
    json!({
        "name": realization.name,
        "words": realization.words,
        "flops": realization.flops,
        "constants": realization.constants,
        "possible": possible,
        "because": because,
    })
}
