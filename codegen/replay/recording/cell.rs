//! What a cell means: a number, a time, or a missing sample.

use super::super::clock::stamp;
use super::super::selection::Meaning;

/// Words for a missing sample, in small letters.
const MISSING: [&str; 14] =
    ["", "nan", "-nan", "nan(ind)", "-nan(ind)", "null", "nil", "none", "na", "n/a", "#n/a", "-", "--", "missing"];

/// Whether a cell is a missing sample.
pub(super) fn is_missing(cell: &str) -> bool {
    cell.len() <= 9 && MISSING.contains(&cell.to_ascii_lowercase().as_str())
}

/// Whether a cell is a number that is there; `comma` allows a decimal comma.
pub(super) fn is_number(cell: &str, comma: bool) -> bool {
    number(cell, comma).is_some_and(|value| !value.is_nan())
}

/// What a cell is worth, NaN when the sample is missing; `comma` allows a decimal comma.
pub(super) fn read(cell: &[u8], meaning: Meaning, comma: bool) -> Option<f64> {
    let text = std::str::from_utf8(cell).ok()?;
    let found = if is_missing(text) { Some(f64::NAN) } else { number(text, comma) };
    match meaning {
        Meaning::Number(factor) => found.map(|value| value * factor),
        Meaning::Time(unit) => found.map(|time| unit.seconds(time)).or_else(|| stamp(text)),
    }
}

fn number(text: &str, comma: bool) -> Option<f64> {
    if comma && text.matches(',').count() == 1 && !text.contains('.') {
        return text.replacen(',', ".", 1).parse().ok();
    }
    text.parse().ok()
}
