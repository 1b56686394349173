//! What stands ahead of a recording's rows: what separates its cells, the names of its columns, a row of their units.

use super::cell::{is_missing, is_number};

/// The names of a recording's columns.
#[derive(Clone, Debug, Default)]
pub(in crate::replay) struct Header {
    /// A name may be empty, or stand several times.
    pub columns: Vec<String>,
    /// What a row of units says of each, empty where there is none.
    pub units: Vec<String>,
}

/// What separates cells, by the first bytes of a recording: a line `sep=;` says it; else it is a semicolon or a tab where
/// the first line that is neither blank nor a comment, or the comment ahead of it, has one and no comma.
pub(super) fn separator(first: &[u8]) -> u8 {
    if let Some([sign, b'\r' | b'\n', ..]) = first.strip_prefix(b"sep=") {
        return *sign;
    }
    let lines = || first.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii);
    let is_row = |line: &&[u8]| !line.is_empty() && !line.starts_with(b"#");
    let Some(row) = lines().find(is_row) else { return b',' };
    let has = |sign: u8| {
        let mut quoted = false;
        row.iter().any(|byte| {
            quoted ^= *byte == b'"';
            !quoted && *byte == sign
        })
    };
    match (has(b';'), has(b'\t'), has(b',')) {
        (true, _, _) => b';',
        (false, true, false) => b'\t',
        // Numbers with decimal commas, of which each cell has one at most.
        (false, true, true) if row.split(|byte| *byte == b'\t').all(is_number_with_comma) => b'\t',
        _ => b',',
    }
}

fn is_number_with_comma(cell: &[u8]) -> bool {
    std::str::from_utf8(cell).is_ok_and(|text| is_number(text.trim(), true))
}

/// The names in a comment, where the header is one.
pub(super) fn commented(line: &[u8], separator: u8) -> Vec<String> {
    let line = String::from_utf8_lossy(line);
    let names = line.trim().trim_start_matches('#').split(char::from(separator));
    names.map(|name| name.trim().trim_matches('"').trim().to_owned()).collect()
}

/// Whether a row has numbers and nothing else, so that it names no columns.
pub(super) fn has_numbers_only(cells: &[&str], comma: bool) -> bool {
    cells.iter().all(|cell| is_number(cell, comma) || is_missing(cell))
        && cells.iter().any(|cell| is_number(cell, comma))
}

/// Whether a row has units: short words, of which none is a number.
pub(super) fn has_units(cells: &[&str], comma: bool) -> bool {
    let is_unit = |cell: &str| {
        let letter = cell.chars().any(|c| c.is_alphabetic() || matches!(c, '°' | '%'));
        letter && !is_number(cell, comma) && !cell.starts_with('#') && cell.chars().count() <= 16
    };
    cells.iter().all(|cell| is_unit(cell) || is_missing(cell) || matches!(*cell, "[]" | "()" | "[-]" | "(-)"))
        && cells.iter().any(|cell| is_unit(cell) && !is_missing(cell))
}
