//! Methods by features: what each takes of what a specification may ask for, from the limits that refusals are made of.

use std::fmt::Write as _;

use super::{METHODS, Method};
use crate::plant::features::{Feature, Limit, When};

/// What a method says to a feature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// It takes it.
    Taken,
    /// It takes it from some specifications.
    Partly,
    /// It refuses it.
    Refused,
}

impl Method {
    /// What stands against a feature.
    pub fn against(&self, feature: Feature) -> impl Iterator<Item = &'static Limit> {
        self.limits.iter().filter(move |limit| limit.feature == feature)
    }

    /// Whether it takes a feature.
    pub fn cell(&self, feature: Feature) -> Cell {
        match self.against(feature).map(|limit| matches!(limit.when, When::Always)).max() {
            None => Cell::Taken,
            Some(false) => Cell::Partly,
            Some(true) => Cell::Refused,
        }
    }

    /// Its limits in words, a line each.
    pub fn limits(&self) -> Vec<String> {
        let line = |limit: &Limit| {
            let when = limit.when.words().map_or(String::new(), |words| format!(" {words}"));
            format!("`{}`{when}: {}; {}", limit.feature.key(), limit.why, limit.instead)
        };
        self.limits.iter().map(line).collect()
    }
}

/// The matrix as text, a method in each line.
pub fn text() -> String {
    let keys = Feature::ALL.map(Feature::key);
    let heads = keys.map(|key| format!("{key:<6}"));
    let mut text = format!("  {:<17} {}\n", "", heads.join("  ").trim_end());
    for method in METHODS {
        let cells = Feature::ALL.iter().zip(keys).map(|(feature, key)| {
            let cell = match method.cell(*feature) {
                Cell::Taken => "yes",
                Cell::Partly => "partly",
                Cell::Refused => "-",
            };
            format!("{cell:<width$}", width = key.len().max(6))
        });
        let _ = writeln!(text, "  {:<17} {}", method.name, cells.collect::<Vec<_>>().join("  ").trim_end());
    }
    text
}

/// The matrix and its reasons as Markdown.
pub fn markdown() -> String {
    let keys = Feature::ALL.map(|feature| format!("`{}`", feature.key()));
    let mut text = format!("| method | {} |\n|---|{}\n", keys.join(" | "), "---|".repeat(keys.len()));
    for method in METHODS {
        let cells = Feature::ALL.map(|feature| match method.cell(feature) {
            Cell::Taken => "yes",
            Cell::Partly => "partly",
            Cell::Refused => "no",
        });
        let _ = writeln!(text, "| `{}` | {} |", method.name, cells.join(" | "));
    }
    for method in METHODS.iter().filter(|method| !method.limits.is_empty()) {
        let _ = write!(text, "\n**`{}`** cannot take\n\n", method.name);
        for line in method.limits() {
            let _ = writeln!(text, "- {line}.");
        }
    }
    text
}
