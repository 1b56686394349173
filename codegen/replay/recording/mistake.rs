//! What can be wrong with a recording, a function each.

use std::fmt;

use crate::expr::edit_distance;

use super::super::grid::TimeError;
use super::Recording;
use super::rows::{Broken, LONGEST_ROW};

/// What is wrong with a recording, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordingError {
    /// The name under which the recording was opened.
    pub name: String,
    /// Line of the file, from 1.
    pub line: Option<u64>,
    /// Name of the column.
    pub column: Option<String>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.name)?;
        if let Some(line) = self.line {
            write!(f, "{line}:")?;
        }
        if let Some(column) = &self.column {
            write!(f, " column `{column}`:")?;
        }
        write!(f, " {}", self.message)
    }
}

impl std::error::Error for RecordingError {}

impl<R> Recording<R> {
    /// It has a header and nothing else.
    pub(in crate::replay) fn has_no_rows(&self) -> RecordingError {
        self.error(None, None, "the recording has no rows".into(), None)
    }

    /// The time of the row that was read last does not fit a step.
    pub(in crate::replay) fn unfit(&self, error: &TimeError) -> RecordingError {
        self.error(Some(self.rows.line()), None, error.message.clone(), error.help.clone())
    }

    /// The times of all rows do not fit a step.
    pub(in crate::replay) fn unfit_whole(&self, error: &TimeError) -> RecordingError {
        self.error(None, None, error.message.clone(), error.help.clone())
    }

    /// What is wrong with a selected cell of the row that was read last.
    pub(in crate::replay) fn complaint(&self, column: &str, message: String, help: &str) -> RecordingError {
        RecordingError {
            name: self.name.clone(),
            line: Some(self.rows.line()),
            column: Some(column.to_owned()),
            message,
            help: Some(help.to_owned()),
        }
    }

    /// The rows cannot be told.
    pub(super) fn broken(&self, broken: Broken) -> RecordingError {
        match broken {
            Broken::Source(line, cause) => self.error(Some(line), None, format!("cannot be read: {cause}"), None),
            Broken::Long => {
                let message = format!("a row is longer than {LONGEST_ROW} bytes");
                let help = "look for a quote that is not closed; lines have to end in a line feed";
                self.error(Some(self.rows.line()), None, message, Some(help.into()))
            }
            Broken::Open => {
                let help = "close the quote, or double it if it belongs to the text";
                let message = "a quote is opened and never closed".into();
                self.error(Some(self.rows.line()), None, message, Some(help.into()))
            }
        }
    }

    pub(super) fn no_header(&self) -> RecordingError {
        let help = "the first row names the columns, for example `t,theta,omega`";
        self.error(None, None, "there is no header row".into(), Some(help.into()))
    }

    pub(super) fn error(
        &self,
        line: Option<u64>,
        column: Option<usize>,
        message: String,
        help: Option<String>,
    ) -> RecordingError {
        let column = column.map(|index| self.header.columns[index].clone());
        RecordingError { name: self.name.clone(), line, column, message, help }
    }

    pub(super) fn no_names(&self) -> RecordingError {
        let message = "there is no header row: the first row has numbers only".into();
        let help = "name the columns in a row, for example `t,theta,omega`, also behind a `#`";
        self.error(Some(self.rows.line()), None, message, Some(help.into()))
    }

    pub(super) fn named_twice(&self, first: usize, second: usize) -> RecordingError {
        let name = &self.header.columns[first];
        let message = format!("columns {} and {} are both named `{name}`", first + 1, second + 1);
        self.error(None, None, message, Some("give the column that is read a name of its own".into()))
    }

    pub(super) fn missing_column(&self, name: &str) -> RecordingError {
        let named: Vec<String> = self.header.columns.iter().filter(|column| !column.is_empty()).cloned().collect();
        let list = named.iter().map(|column| format!("`{column}`")).collect::<Vec<_>>().join(", ");
        let help = match named.as_slice() {
            [only] if only.contains(char::is_whitespace) => Some(
                "cells are separated by commas, semicolons or tabs; this header looks as if they were not".to_owned(),
            ),
            _ => nearest(name, &named).map(|column| format!("did you mean `{column}`?")),
        };
        self.error(None, None, format!("there is no column `{name}`; the columns are {list}"), help)
    }

    pub(super) fn blank_line(&self, line: u64) -> RecordingError {
        let help = "write `nan` for a missing sample, or remove the line";
        self.error(Some(line), Some(0), "a blank line between two samples".into(), Some(help.into()))
    }

    pub(super) fn ragged_row(&self) -> RecordingError {
        let (found, expected) = (self.rows.cells(), self.header.columns.len());
        let count = format!("the row has {found} cell{}, the header has {expected}", if found == 1 { "" } else { "s" });
        if found < expected {
            let help =
                format!("cell {} is the first that is missing; a missing sample still needs its separator", found + 1);
            return self.error(Some(self.rows.line()), Some(found), count, Some(help));
        }
        let extra = shortened(self.rows.cell(expected));
        let help =
            format!("cell {} is the first too many; numbers are written with a point, not with a comma", expected + 1);
        self.error(Some(self.rows.line()), None, format!("{count}; no column for `{extra}`"), Some(help))
    }

    pub(super) fn not_a_number(&self, column: usize) -> RecordingError {
        let cell = self.rows.cell(column);
        let what = if std::str::from_utf8(cell).is_ok() { "a number" } else { "UTF-8" };
        let message = format!("`{}` is not {what}", shortened(cell));
        let help = format!("this is cell {} of the row; leave it empty if the sample is missing", column + 1);
        self.error(Some(self.rows.line()), Some(column), message, Some(help))
    }
}

/// A cell fit for an error message: its first characters, on one line.
pub(super) fn shortened(cell: &[u8]) -> String {
    const LONGEST: usize = 24;
    let text = String::from_utf8_lossy(&cell[..cell.len().min(4 * LONGEST + 4)]);
    let clean = |c: char| if c.is_control() { ' ' } else { c };
    let mut shown: String = text.chars().map(clean).take(LONGEST).collect();
    if text.chars().count() > LONGEST {
        shown.push('…');
    }
    shown
}

/// The name that differs least from the one that was asked for, a unit behind it aside, unless all differ in most letters.
fn nearest<'a>(name: &str, among: &'a [String]) -> Option<&'a str> {
    let (wanted, most) = (name.to_lowercase(), name.chars().count().div_ceil(2));
    let bare = |other: &str| other.split(['[', '(']).next().unwrap_or(other).trim().to_lowercase();
    among
        .iter()
        .map(|other| {
            (edit_distance(&wanted, &other.to_lowercase()).min(edit_distance(&wanted, &bare(other))), other.as_str())
        })
        .filter(|(distance, _)| *distance <= most)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, other)| other)
}
