//! What `deadbeat design` prints: the design as text and as JSON.

use std::fmt::Write as _;

use deadbeat_codegen::internals::numbers::short;
use deadbeat_codegen::internals::output::header;
use deadbeat_codegen::internals::plant::modes::modes;
use deadbeat_codegen::program::cost::{Cost, cost};
use deadbeat_codegen::promise::{Certificate, Convergence, NamedMatrix, Phase, Realization};
use deadbeat_codegen::{Design, Generated, Language, Moment, Source, VERSION};
use serde_json::{Map, Value, json};

fn counted(generated: &Generated) -> Cost {
    cost(&generated.program, deadbeat_math::COSTS)
}

/// The design for machines; the keys are those of the manual.
pub fn json(generated: &Generated) -> Value {
    let (plant, design) = (&generated.plant, &generated.design);
    let names = |labels: Vec<&deadbeat_codegen::internals::plant::Label>| -> Vec<String> {
        labels.iter().map(|l| l.name.clone()).collect()
    };
    let constants: Map<String, Value> =
        design.constants.iter().map(|matrix| (matrix.letter.to_owned(), json!(matrix.rows))).collect();
    let fir = design.fir.as_ref().map(|fir| json!({ "known": fir.known, "K": fir.k, "M": fir.m, "c": fir.c }));
    let cost = counted(generated);
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
    json!({
        "noise_gain_l1": certificate.noise_gain_l1,
        "noise_gain_l2": certificate.noise_gain_l2,
        "disturbance_gain_l1": certificate.disturbance_gain_l1,
        "error_bound": certificate.error_bound,
        "initial_gain": certificate.initial_gain,
    })
}

/// Phases that are printed for people.
const MOST_PHASES: usize = 20;

/// The worst-case noise gains of each phase: a line for each output.
fn by_phase(generated: &Generated) -> String {
    let (plant, phases) = (&generated.plant, &generated.design.phases);
    let mut text = String::new();
    if phases.is_empty() {
        return text;
    }
    let names: Vec<&str> = plant.states.iter().map(|state| state.label.name.as_str()).collect();
    let _ =
        writeln!(text, "\nNoise gains by phase, worst case: calls k, k + {}, …; {}", phases.len(), names.join(", "));
    for (place, phase) in phases.iter().enumerate().take(MOST_PHASES) {
        for (o, output) in plant.outputs.iter().enumerate() {
            let gains: Vec<String> = phase.noise_gain_l1.iter().map(|gains| short(gains[o])).collect();
            let _ = writeln!(text, "  k = {place}, from {}: {}", output.label.name, gains.join(", "));
        }
    }
    if phases.len() > MOST_PHASES {
        let _ = writeln!(text, "  …; `--format json` has them all");
    }
    text
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

/// The decision table: what each realisation would cost, and why it may or may not run.
fn decision(design: &Design) -> String {
    let mut text = String::new();
    for (place, realization) in design.realizations.iter().enumerate() {
        let (mark, because) = match &realization.verdict {
            Ok(why) => (if place == 0 { "chosen  " } else { "possible" }, why),
            Err(why) => ("refused ", why),
        };
        let Realization { name, words, flops, constants, .. } = realization;
        let numbers = match words {
            // It was refused before there was anything to count.
            0 => format!("{:>13} {:>13} {:>17}", "-", "-", "-"),
            _ => format!("{words:>7} words {flops:>7} flops {constants:>7} constants"),
        };
        let _ = writeln!(text, "  {name:<10} {mark} {numbers}  {because}");
    }
    text
}

/// The design for people.
pub fn text(generated: &Generated) -> String {
    let design = &generated.design;
    let source = Source { name: "".into(), text: "".into() };
    let header = header::header(generated, &source, Language::Step);
    let mut text = format!("{}\n", header.title);
    // The header without its provenance and its contract.
    let body = header.lines.iter().skip_while(|line| !line.is_empty()).skip(1).take_while(|line| *line != "Contract:");
    for line in body {
        let _ = writeln!(text, "{line}");
    }
    let numerics = &design.numerics;
    let _ = writeln!(text, "Realization  {}", design.realization);
    text.push_str(&decision(design));
    let _ = writeln!(
        text,
        "Numerics     {} digits, agreeing to {:.0} with twice as many; condition {}; acc_(N+1) = {:.0e} of its history",
        numerics.digits,
        numerics.agreement,
        short(numerics.condition),
        numerics.unbiasedness
    );
    let mode = |(re, im): &(f64, f64)| match *im {
        0.0 => short(*re),
        im => format!("{}{}{}i", short(*re), if im < 0.0 { "-" } else { "+" }, short(im.abs())),
    };
    if let Some(modes) = modes(&generated.plant) {
        let list: Vec<String> = modes.iter().map(mode).collect();
        let _ = writeln!(text, "Modes        {}", list.join(", "));
    }
    text.push_str(&by_phase(generated));
    matrices(&mut text, &design.constants);
    if let Some(fir) = &design.fir {
        let _ =
            write!(text, "\nWeights by age: x_k = sum K[j] y_(k-j) + M[j] w_(k-j) + c; `--format json` has them all\n");
        let _ = writeln!(text, "K[0] = {:?}", fir.k[0]);
        if let Some(first) = fir.m.get(1).filter(|_| !fir.known.is_empty()) {
            let _ = writeln!(text, "M[1] = {first:?}   for {}", fir.known.join(", "));
        }
    }
    text
}

fn matrices(text: &mut String, all: &[NamedMatrix]) {
    for matrix in all {
        let _ = writeln!(text, "\n{}", matrix.letter);
        for row in &matrix.rows {
            let entries: Vec<String> = row.iter().map(|x| format!("{x:>24}")).collect();
            let _ = writeln!(text, "{}", entries.join(" "));
        }
    }
}

/// The gains at one step for people.
pub fn moment(moment: &Moment) -> String {
    let used = if moment.in_use { "" } else { "; the observer's countdown stops before it" };
    let mut text = format!("Step {}, {} steps before the prescribed time{used}\n", moment.step, moment.left);
    matrices(&mut text, &moment.matrices);
    text
}

/// The gains at one step for machines; what is infinite is null.
pub fn moment_json(moment: &Moment) -> Value {
    let mut all: Map<String, Value> =
        moment.matrices.iter().map(|matrix| (matrix.letter.to_owned(), json!(matrix.rows))).collect();
    all.insert("step".into(), json!(moment.step));
    all.insert("left".into(), json!(moment.left));
    all.insert("in_use".into(), json!(moment.in_use));
    Value::Object(all)
}
