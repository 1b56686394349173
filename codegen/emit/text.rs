//! Text that comes from elsewhere, made safe for comments; and the layout of tables.

use crate::program::Field;

/// The widest line of a table.
const WIDTH: usize = 100;

/// One line without control characters and without those that change the reading direction.
pub fn plain(text: &str) -> String {
    let is_hidden = |c: char| {
        c.is_control() || matches!(c, '\u{200e}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let shown: String = text.chars().map(|c| if is_hidden(c) { ' ' } else { c }).collect();
    shown.trim_end().to_owned()
}

/// The same inside a C comment: nothing in it ends the comment, opens another or is a trigraph.
pub fn c_comment(text: &str) -> String {
    plain(text).replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?").replace("??", "? ?")
}

/// The same in Rust documentation: words that Markdown, rustdoc or clippy would read as code or
/// markup become code.
pub fn markdown(text: &str) -> String {
    let text = plain(text);
    let words: Vec<String> = text.split_whitespace().map(markdown_word).collect();
    words.join(" ")
}

/// One word of documentation.
fn markdown_word(word: &str) -> String {
    let (bare, tail) = word.split_at(word.trim_end_matches([',', ';', ':', '.']).len());
    let capitals_inside = bare.chars().skip(1).any(char::is_uppercase);
    if bare.contains(['_', '[', ']', '<', '>', '*', '#', '|', '~', '\\', '&', '`'])
        || bare.contains("::")
        || bare.contains("://")
        || (capitals_inside && bare.chars().any(char::is_lowercase))
        || bare.starts_with(['-', '+', '=']) && bare.len() == 1
    {
        format!("`{}`{tail}", bare.replace('`', "'"))
    } else {
        word.to_owned()
    }
}

/// The note on the use of a measurement that is a count.
pub const RAW_COUNT: &str = "raw count, never missing";

/// What the documentation of a field says: its description, its unit, and a note on its use.
pub fn field(field: &Field, note: &str) -> String {
    let unit = if field.unit.is_empty() && field.doc.is_empty() { "no unit" } else { &field.unit };
    let said: Vec<&str> = [&field.doc, unit, note].into_iter().filter(|text| !text.is_empty()).collect();
    said.join("; ")
}

/// The rows of a table between braces or brackets: one line each, or filled lines where one is too
/// narrow. The last row ends without a comma.
pub fn rows(rows: &[Vec<String>], [open, close]: [&str; 2]) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for row in rows {
        let line = format!("    {open}{}{close},", row.join(", "));
        if line.len() <= WIDTH {
            lines.push(line);
        } else {
            lines.push(format!("    {}", open.trim_end()));
            lines.extend(filled(row));
            lines.push(format!("    {},", close.trim_start()));
        }
    }
    if let Some(last) = lines.last_mut() {
        last.pop();
    }
    lines
}

/// Numbers in lines as full as they can be.
fn filled(row: &[String]) -> Vec<String> {
    const INDENT: &str = "        ";
    let mut lines = vec![String::from(INDENT)];
    for (at, number) in row.iter().enumerate() {
        let entry = if at + 1 < row.len() { format!("{number},") } else { number.clone() };
        let end = lines.len() - 1;
        if lines[end] == INDENT {
            lines[end].push_str(&entry);
        } else if lines[end].len() + 1 + entry.len() <= WIDTH {
            lines[end].push(' ');
            lines[end].push_str(&entry);
        } else {
            lines.push(format!("{INDENT}{entry}"));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Claim: no text leaves a C comment.
    #[test]
    fn stays_in_the_comment() {
        for text in ["*/ int x;", "/* nested", "a*/*/b", "/*/", "a\n*/", "??/\n"] {
            let safe = c_comment(text);
            assert!(!safe.contains("*/") && !safe.contains("/*") && !safe.contains('\n'), "{safe}");
        }
    }

    /// Claim: words that are code in documentation are marked as code, others stay.
    #[test]
    fn marks_code() {
        assert_eq!(markdown("rate of dc_motor, in [rad/s]"), "rate of `dc_motor`, in `[rad/s]`");
        assert_eq!(markdown("row 0 of K, 1/s^2 times s^2"), "row 0 of K, 1/s^2 times s^2");
        assert_eq!(markdown("an `odd` one"), "an `'odd'` one");
    }

    /// Claim: a row that is too wide is filled, and every number stays.
    #[test]
    fn fills_wide_rows() {
        let wide: Vec<String> = (0..30).map(|n| format!("{n}.123456")).collect();
        let lines = rows(&[wide.clone(), vec!["1.0".into()]], ["{ ", " }"]);
        assert!(lines.iter().all(|line| line.len() <= WIDTH));
        assert_eq!(lines.join("").matches('.').count(), 31);
        assert_eq!(lines.last().map(String::as_str), Some("    { 1.0 }"));
    }
}
