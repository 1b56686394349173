//! Layout of the Rust file: prettyplease, then what it does not do.
//!
//! It knows no comments and no blank lines, and breaks a table into one number a line. So headings
//! come as documentation of statements and become comments here, tables come as the name `ROWS`
//! and get their rows here, and functions and types get a blank line before them.

use proc_macro2::TokenStream;

use super::super::plan::Plan;
use super::super::text;
use super::constant;
use crate::program::{Scalar, Table};

/// The text of the items.
pub fn text(items: TokenStream, plan: &Plan) -> String {
    let file = match syn::parse2(items) {
        Ok(file) => file,
        Err(error) => unreachable!("the emitter wrote items: {error}"),
    };
    let mut tables = plan.program.read_tables().map(|(_, table)| table).peekable();
    let mut lines: Vec<String> = vec![];
    for line in prettyplease::unparse(&file).lines() {
        let line = commented(line);
        if lines.last().is_some_and(|before| is_apart(before, &line)) {
            lines.push(String::new());
        }
        match (line.strip_suffix("ROWS;"), tables.peek()) {
            (Some(start), Some(table)) => {
                lines.push(format!("{start}["));
                lines.extend(rows(table, plan.program.scalar));
                lines.push("];".to_owned());
                tables.next();
            }
            _ => lines.push(line),
        }
    }
    lines.join("\n") + "\n"
}

/// The line, with the documentation of a statement as a comment: it is what is deeper than the
/// functions and fields of an item.
fn commented(line: &str) -> String {
    let code = line.trim_start();
    let indent = &line[..line.len() - code.len()];
    match code.strip_prefix("/// ") {
        Some(text) if indent.len() >= 8 => format!("{indent}// {text}"),
        _ => line.to_owned(),
    }
}

/// Whether a blank line goes between two lines: before an item, a function or a heading, but not
/// at the start of a block or inside what belongs together.
fn is_apart(before: &str, line: &str) -> bool {
    let starts = |line: &str, words: &[&str]| words.iter().any(|word| line.trim_start().starts_with(word));
    let depth = line.len() - line.trim_start().len();
    let belongs = starts(before, &["///", "#[", "//"]) || before.ends_with('{');
    let begins = match depth {
        0 => starts(line, &["///", "#[", "pub ", "impl ", "struct ", "static "]),
        4 => before == "    }" && line != "}",
        _ => starts(line, &["// "]),
    };
    begins && !belongs
}

/// The rows of a table.
fn rows(table: &Table, scalar: Scalar) -> Vec<String> {
    let spelled = |x: &f64| constant::float(*x, scalar).to_string().replace(' ', "");
    let cells: Vec<Vec<String>> = table.rows.iter().map(|row| row.iter().map(spelled).collect()).collect();
    let mut lines = text::rows(&cells, ["[", "]"]);
    if let Some(last) = lines.last_mut() {
        last.push(',');
    }
    lines
}
