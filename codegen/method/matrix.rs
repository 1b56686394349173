//! Methods by features: what each takes of what a specification may ask for, from the limits that refusals are made of.

use std::fmt::Write as _;

use super::{METHODS, Method};
use crate::plant::features::{Feature, Limit};

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
        match self.against(feature).map(|limit| limit.words().is_none()).max() {
            None => Cell::Taken,
            Some(false) => Cell::Partly,
            Some(true) => Cell::Refused,
        }
    }

    /// Its limits in words, a line each.
    pub fn limits(&self) -> Vec<String> {
        let line = |limit: &Limit| {
            let when = limit.words().map_or(String::new(), |words| format!(" {words}"));
            format!("{}{when}: {}; {}", limit.feature.words(), limit.why, limit.instead)
        };
        self.limits.iter().map(line).collect()
    }
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
