//! Names that Rust, C and the expressions can carry, each for one thing.

use super::reader::{Found, Table};
use super::{Spec, Text};
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::Function;
use crate::names;

/// A name that only expressions use.
pub(super) fn check_identifier(table: &Table, name: &Text) {
    let mut characters = name.value.chars();
    let starts = characters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    if !starts || !characters.all(|c| c.is_ascii_alphanumeric() || c == '_') {
        let message = format!("`{}` is not a name", name.value.escape_debug());
        let help = "letters without accents, digits and underscores, a letter first";
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help(help));
    } else if Function::by_name(&name.value).is_some() || ["t", "pi"].contains(&name.value.as_str()) {
        let message = format!("`{}` already means something in every expression", name.value);
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help("choose another name"));
    }
}

/// Letters of the longest name.
pub(super) const LONGEST: usize = 40;

/// A name that the generated code carries.
pub(super) fn check_name(table: &Table, name: &Text, role: &str) {
    let value = &name.value;
    let snake = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let report = |message: String, help: String| {
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help(help));
    };
    if !value.starts_with(|c: char| c.is_ascii_lowercase())
        || !value.chars().all(snake)
        || value.contains("__")
        || value.ends_with('_')
    {
        let message = format!("the {role} `{}` is not in snake_case", value.escape_debug());
        report(message, format!("generated fields carry it: write `{}`", names::snake_case(value)));
    } else if value.len() > LONGEST {
        report(
            format!("the {role} `{value}` has {} letters", value.len()),
            format!("write at most {LONGEST}: C compilers may cut long symbols"),
        );
    } else if let Some(why) = if role == "name" { names::reserved_for_a_file(value) } else { names::reserved(value) } {
        report(format!("the {role} `{value}` is {why}"), "choose another name".into());
    } else if role != "name" && role != "output" {
        check_identifier(table, name);
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
}
