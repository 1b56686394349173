//! Which cells of a recording are read, and as what.

use std::io::Read;

use super::clock::TimeUnit;
use super::recording::{Recording, RecordingError};

/// A column, and what its cells are.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Source {
    pub column: String,
    pub meaning: Meaning,
}

/// What the cells of a column are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meaning {
    /// Numbers, which are multiplied by this.
    Number(f64),
    /// Times of this unit, or stamps of the calendar.
    Time(TimeUnit),
}

impl Source {
    /// What somebody names, among the columns that are there: a column, or one with a factor, as in `vel*0.001534` and
    /// `angle*pi/180`.
    pub fn named(text: &str, there: &[String]) -> Self {
        let plain = || Self { column: text.to_owned(), meaning: Meaning::Number(1.0) };
        if there.iter().any(|column| column == text) {
            return plain();
        }
        let signs = text.char_indices().filter(|(_, c)| matches!(c, '*' | '/'));
        let split = |(at, _): (usize, char)| {
            let (before, behind) = text.split_at(at);
            let column = |name: &str, factor| Self { column: name.trim().to_owned(), meaning: Meaning::Number(factor) };
            let ahead = || Some(column(behind.strip_prefix('*')?, product(&format!("*{before}"))?));
            product(behind).map(|factor| column(before, factor)).or_else(ahead)
        };
        signs.into_iter().find_map(split).filter(|source| !source.column.is_empty()).unwrap_or_else(plain)
    }

    /// Times in a column.
    pub fn time(column: &str, unit: TimeUnit) -> Self {
        Self { column: column.to_owned(), meaning: Meaning::Time(unit) }
    }
}

/// The value of `*a/b*c`, of numbers and pi.
fn product(text: &str) -> Option<f64> {
    let mut value = 1.0;
    let mut rest = text;
    while !rest.is_empty() {
        let sign = rest.chars().next()?;
        let behind = &rest[1..];
        let end = behind.find(['*', '/']).unwrap_or(behind.len());
        let number = match behind[..end].trim() {
            "pi" => std::f64::consts::PI,
            number => number.parse().ok().filter(|number: &f64| number.is_finite())?,
        };
        value = if sign == '*' { value * number } else { value / number };
        rest = &behind[end..];
    }
    Some(value)
}

/// Cells to be read, each once.
#[derive(Clone, Debug, Default)]
pub(super) struct Selection {
    sources: Vec<Source>,
}

impl Selection {
    /// The place among the selected cells.
    pub fn place(&mut self, source: Source) -> usize {
        self.sources.iter().position(|other| *other == source).unwrap_or_else(|| {
            self.sources.push(source);
            self.sources.len() - 1
        })
    }

    /// Whether a column is among them.
    pub fn has(&self, column: &str) -> bool {
        self.sources.iter().any(|source| source.column == column)
    }

    /// Makes a recording deliver them; the cells of a row have this many places.
    pub fn apply<R: Read>(&self, recording: &mut Recording<R>) -> Result<usize, RecordingError> {
        recording.choose(&self.sources)?;
        Ok(self.sources.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_may_have_a_factor_unless_a_column_is_called_so() {
        let there = ["vel".to_owned(), "a/2".to_owned(), "speed m/s".to_owned()];
        let named = |text: &str| {
            let source = Source::named(text, &there);
            let Meaning::Number(factor) = source.meaning else { panic!("{text}") };
            (source.column, factor)
        };
        let is = |column: &str, factor: f64| (column.to_owned(), factor);
        assert_eq!(named("vel"), is("vel", 1.0));
        assert_eq!(named("vel*0.001534"), is("vel", 0.001_534));
        assert_eq!(named("vel * pi / 180"), is("vel", std::f64::consts::PI / 180.0));
        assert_eq!(named("-2.5*vel"), is("vel", -2.5));
        assert_eq!(named("a/2"), is("a/2", 1.0));
        assert_eq!(named("speed m/s*3.6"), is("speed m/s", 3.6));
        assert_eq!(named("none m/s"), is("none m/s", 1.0));
    }
}
