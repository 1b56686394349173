//! A design as text for people; [`json`] has it for machines.

#[cfg(feature = "json")]
mod json;

use std::fmt::Write as _;

use super::{Language, header};
use crate::diagnostic::Source;
use crate::estimator::Design;
use crate::generated::Generated;
use crate::method::Moment;
use crate::numbers::short;
use crate::plant::modes::modes;
use crate::promise::{NamedMatrix, Realization};

impl Generated {
    /// The design for people, as `deadbeat design` prints it: what the header of its files says, how it may be realised,
    /// its numerics, modes and matrices. The words may change with any version.
    pub fn to_text(&self) -> String {
        text(self)
    }
}

impl Moment {
    /// The gains for people, as `deadbeat design --at` prints them. The words may change with any version.
    pub fn to_text(&self) -> String {
        let used = if self.in_use { "" } else { "; the observer's countdown stops before it" };
        let mut text = format!("Step {}, {} steps before the prescribed time{used}\n", self.step, self.left);
        matrices(&mut text, &self.matrices);
        text
    }
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
fn text(generated: &Generated) -> String {
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
