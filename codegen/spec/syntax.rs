//! Mistakes of the TOML reader in words that say what to write.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, codes, floor_boundary, letters};

/// A mistake of the file's form.
pub(super) struct Mistake {
    /// With its way out.
    pub(super) diagnostic: Diagnostic,
    /// Whether what the reader says of the rest of the file follows from this one.
    pub(super) ends: bool,
}

/// What the reader's message about a place in the text comes to.
pub(super) fn mistake(text: &str, span: Range<usize>, message: &str) -> Mistake {
    let message = message.replace('\n', ", ");
    let error = |span, message: String| Diagnostic::error(codes::SYNTAX, span, message);
    if let Some((place, point)) = decimal_comma(text, span.start) {
        let diagnostic = error(place.clone(), "a comma ends the number".into());
        let help = format!("write a decimal point: `{point}`");
        return Mistake { diagnostic: diagnostic.help(help).patch(place, point), ends: true };
    }
    if let Some((place, name)) = foreign_name(text, span.start)
        && message.contains("key")
    {
        let found = text.get(place.clone()).unwrap_or_default();
        let help = match letters::spelt_out(found) {
            Some(ascii) => format!("names are ASCII letters, digits and underscores: write `{ascii}`"),
            None => "names are ASCII letters, digits and underscores".into(),
        };
        return Mistake { diagnostic: error(place, format!("`{name}` is not a name")).help(help), ends: true };
    }
    let (help, ends) = help(&message);
    Mistake { diagnostic: error(span, message).help(help), ends }
}

/// What to do about another message, and whether it ends the list.
fn help(message: &str) -> (&'static str, bool) {
    let has = |words: &[&str]| words.iter().any(|word| message.contains(word));
    if has(&["duplicate key"]) {
        ("remove or rename one of them", false)
    } else if has(&["must be quoted"]) {
        ("write numbers without a unit, and text in quotes", false)
    } else if has(&["literal string", "basic string"]) {
        ("begin and end it with the same quote on one line", true)
    } else {
        ("check the quotes, brackets and commas here and on the line before", true)
    }
}

/// A number with a comma for its point, `= 12,0` outside of a list, at or before a place of its line; and the same with a
/// point.
fn decimal_comma(text: &str, at: usize) -> Option<(Range<usize>, String)> {
    let at = floor_boundary(text, at);
    let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
    let line = text[start..].lines().next().unwrap_or_default();
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    for (equals, _) in line.match_indices('=') {
        let rest = line[equals + 1..].trim_start_matches(' ');
        let begin = line.len() - rest.len();
        let sign = usize::from(rest.starts_with(['-', '+']));
        let whole = digits(&rest[sign..]);
        let behind = &rest[sign + whole..];
        let parts = behind.strip_prefix(',').map_or(0, digits);
        let comma = begin + sign + whole;
        if whole > 0 && parts > 0 && (start + begin..=start + comma + parts + 1).contains(&at) {
            let end = comma + 1 + parts;
            let number = line[begin..end].replace(',', ".");
            return Some((start + begin..start + end, number));
        }
    }
    None
}

/// A bare key with letters that are none of ASCII's, around a place; and how it is shown.
fn foreign_name(text: &str, at: usize) -> Option<(Range<usize>, String)> {
    let at = floor_boundary(text, at);
    let of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    let before = text[..at].chars().rev().take_while(|c| of_name(*c)).map(char::len_utf8).sum::<usize>();
    let behind = text[at..].chars().take_while(|c| of_name(*c)).map(char::len_utf8).sum::<usize>();
    let place = at - before..at + behind;
    let name = &text[place.clone()];
    (!name.is_ascii()).then(|| (place.clone(), name.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A decimal comma is found in its line, and a list's comma is none.
    #[test]
    fn decimal_commas_are_found() {
        let found = |text: &str, at: &str| decimal_comma(text, text.find(at).unwrap() + 1).map(|(_, point)| point);
        assert_eq!(found("a = 1\nk = { value = 12,0, unit = 'V' }", ",0,").as_deref(), Some("12.0"));
        assert_eq!(found("k = -0,5", ",5").as_deref(), Some("-0.5"));
        assert_eq!(found("k = [1,0", ",0"), None);
        assert_eq!(found("k = { a = 1, b = 2,5 }", "2,").as_deref(), Some("2.5"));
    }
}
