//! `deadbeat list`: methods with their keys and realisations, what each takes, targets.

use std::fmt::Write as _;

use deadbeat_codegen::{Cell, Feature, METHODS, Method};
use serde_json::{Value, json};

use super::{Common, End, Failure, print};

/// `deadbeat list`
pub fn list(method: Option<&str>, common: &Common) -> Result<End, Failure> {
    if let Some(name) = method {
        let method = Method::named(name).map_err(Failure::Misused)?;
        print(&if common.json() { format!("{:#}\n", method_json(method)) } else { page(method) })?;
        return Ok(End::Fine);
    }
    if common.json() {
        let methods: Vec<Value> = METHODS.iter().map(method_json).collect();
        print(&format!(
            "{:#}\n",
            json!({ "methods": methods, "scalars": ["f32", "f64"], "languages": ["rust", "c"] })
        ))?;
        return Ok(End::Fine);
    }
    let mut text = String::from("Methods\n");
    for method in METHODS {
        let _ = writeln!(text, "  {:<16} {}\n  {:<16} source: {}", method.name, method.summary, "", method.source);
        for (name, what) in method.realizations {
            let _ = writeln!(text, "  {:<16} realization {name}: {what}", "");
        }
    }
    text += "Features; what `partly` and `-` mean, `deadbeat list METHOD` says\n";
    text += &matrix();
    text += "Targets\n  rust, f32 or f64   no_std, no allocation; needs the crate `deadbeat`\n";
    text += "  c, f32 or f64      C99, also C++ and MSVC; needs nothing\n";
    text += "`deadbeat list METHOD` prints a method's page.\n";
    print(&text)?;
    Ok(End::Fine)
}

fn page(method: &Method) -> String {
    let mut text = format!("[observer.{}]  {}\nSource: {}\n\nKeys\n", method.name, method.summary, method.source);
    let width = method.keys.iter().map(|(_, kind, _)| kind.chars().count()).max().unwrap_or(0);
    let names = method.keys.iter().map(|(key, ..)| key.chars().count()).max().unwrap_or(0).max(12);
    for (key, kind, meaning) in method.keys {
        let _ = writeln!(text, "  {key:<names$} {kind:<width$}  {meaning}");
    }
    let _ = write!(text, "\nRealizations\n");
    for (name, what) in method.realizations {
        let _ = writeln!(text, "  {name:<12} {what}");
    }
    if !method.limits.is_empty() {
        text += "\nCannot take\n";
        for line in method.limits() {
            let _ = writeln!(text, "  {line}");
        }
    }
    format!("{text}\n{}", method.page)
}

fn method_json(method: &Method) -> Value {
    let keys: Vec<Value> = method
        .keys
        .iter()
        .map(|(key, kind, meaning)| json!({ "key": key, "value": kind, "meaning": meaning }))
        .collect();
    let realizations: Vec<&str> = method.realizations.iter().map(|(name, _)| *name).collect();
    let cannot: Vec<Value> = method
        .limits
        .iter()
        .map(|it| json!({ "key": it.feature.key(), "when": it.words(), "why": it.why, "instead": it.instead }))
        .collect();
    json!({ "name": method.name, "summary": method.summary, "source": method.source, "keys": keys, "realizations": realizations, "cannot": cannot })
}

/// Methods by features, a method in each line.
fn matrix() -> String {
    let keys = Feature::ALL.map(Feature::key);
    let heads = keys.map(|key| format!("{key:<6}"));
    let mut text = format!("  {:<17} {}\n", "", heads.join(" ").trim_end());
    for method in METHODS {
        let cells = Feature::ALL.iter().zip(keys).map(|(feature, key)| {
            let cell = match method.cell(*feature) {
                Cell::Taken => "yes",
                Cell::Partly => "partly",
                Cell::Refused => "-",
            };
            format!("{cell:<width$}", width = key.len().max(6))
        });
        let _ = writeln!(text, "  {:<17} {}", method.name, cells.collect::<Vec<_>>().join(" ").trim_end());
    }
    text
}
