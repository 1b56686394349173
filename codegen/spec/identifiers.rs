//! Names that Rust, C and the expressions can carry, each for one thing.

use super::reader::{Found, Table};
use super::{Spec, Text};
use crate::diagnostic::{Diagnostic, codes, letters};
use crate::expr::Function;
use crate::names;

/// A name that only expressions use.
pub(super) fn check_identifier(table: &Table, name: &Text) {
    let mut characters = name.value.chars();
    let starts = characters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    if !starts || !characters.all(|c| c.is_ascii_alphanumeric() || c == '_') {
        let message = format!("`{}` is not a name", name.value.escape_debug());
        let help = letters::spelt_out(&name.value).map_or_else(
            || "letters without accents, digits and underscores, a letter first".into(),
            |ascii| format!("names are ASCII letters, digits and underscores: write `{ascii}`"),
        );
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help(help));
    } else if Function::names().chain(["t", "pi"]).any(|known| known == name.value) {
        let message = format!("`{}` already means something in every expression", name.value);
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help("choose another name"));
    }
}

/// Letters of the longest name.
pub(super) const LONGEST: usize = 40;

/// A name that the generated code carries, but for its capitals.
pub(super) fn check_name(table: &Table, name: &Text, role: &str) {
    let value = &name.value;
    let of_file = role == "name";
    let fits = |c: char| {
        c.is_ascii_digit() || c == '_' || if of_file { c.is_ascii_lowercase() } else { c.is_ascii_alphabetic() }
    };
    let report = |message: String, help: String| {
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help(help));
    };
    if !value.starts_with(|c: char| fits(c) && c.is_ascii_alphabetic())
        || !value.chars().all(fits)
        || value.contains("__")
        || value.ends_with('_')
    {
        let spelt = letters::spelt_out(value);
        let proposed = spelt.as_deref().unwrap_or(value);
        if of_file {
            let message = format!("the {role} `{}` is not in snake_case", value.escape_debug());
            report(message, format!("generated files and symbols carry it: write `{}`", names::snake_case(proposed)));
        } else {
            let message = format!("the {role} `{}` cannot be a name of generated code", value.escape_debug());
            let help = "ASCII letters, digits and single underscores, a letter first";
            let proposed = if spelt.is_some() { proposed.to_owned() } else { names::snake_case(proposed) };
            report(message, format!("{help}: write `{proposed}`"));
        }
    } else if names::field(value).len() > LONGEST {
        report(
            format!("the {role} `{value}` has {} letters", names::field(value).len()),
            format!("write at most {LONGEST}: C compilers may cut long symbols"),
        );
    } else if let Some(why) = if of_file { names::reserved_for_a_file(value) } else { names::reserved(value) } {
        report(format!("the {role} `{value}` is {why}"), "choose another name".into());
    } else if !of_file && role != "output" {
        check_identifier(table, name);
    }
}

/// Fields of generated structs: no two of one field, none that is called as a type of the header.
fn check_fields(spec: &Spec, found: &Found) {
    let states = spec.states.iter().map(|s| &s.named.name).chain(spec.unknowns.iter().map(|u| &u.name));
    let inputs = spec.inputs.iter().map(|i| &i.named.name);
    let outputs: Vec<&Text> = spec.outputs.iter().map(|o| &o.named.name).collect();
    for names in [states.chain(inputs).collect(), outputs] {
        let mut seen: Vec<&Text> = Vec::new();
        for name in names {
            let field = names::field(&name.value);
            if let Some(why) = names::type_of_the_header(&spec.name.value, &field) {
                let message = format!("`{}` is {why}", name.value);
                let error = Diagnostic::error(codes::BAD_NAME, name.span.clone(), message);
                found.borrow_mut().push(error.help("choose another name"));
            }
            let same = |other: &&&Text| other.value != name.value && names::field(&other.value) == field;
            if let Some(first) = seen.iter().find(same) {
                let message = format!("`{}` and `{}` would be one field, `{field}`", first.value, name.value);
                let twice = Diagnostic::error(codes::DUPLICATE_NAME, name.span.clone(), message);
                let twice = twice.context(first.span.clone(), "the other");
                found.borrow_mut().push(twice.help("rename one: generated fields have no capital letters"));
            }
            seen.push(name);
        }
    }
}

/// Names that expressions share must differ; so must those of one generated struct.
pub(super) fn check_names(spec: &Spec, found: &Found) {
    let parameters = spec.parameters.iter().map(|p| &p.named.name);
    let states = spec.states.iter().map(|s| &s.named.name);
    let inputs = spec.inputs.iter().map(|i| &i.named.name);
    let unknowns = spec.unknowns.iter().map(|u| &u.name);
    let disturbances = spec.disturbances.iter().map(|d| &d.named.name);
    let mut seen: Vec<&Text> = Vec::new();
    for name in parameters.chain(states).chain(inputs).chain(unknowns).chain(disturbances) {
        if let Some(first) = seen.iter().find(|other| other.value == name.value) {
            let message = format!("`{}` names two things", name.value);
            let twice = Diagnostic::error(codes::DUPLICATE_NAME, name.span.clone(), message)
                .context(first.span.clone(), "the other")
                .help("rename one of them");
            found.borrow_mut().push(twice);
        }
        seen.push(name);
    }
    check_fields(spec, found);
}
