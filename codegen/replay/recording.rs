//! Reads a recording, a CSV file of numbers, one row at a time.
//!
//! In goes any byte stream; out come the selected columns of each row as numbers. Memory does not
//! grow with the recording: one row is held, and no row may be longer than 1 MiB, so that a quote which is
//! never closed cannot swallow the file. Every mistake is a [`RecordingError`] that
//! names the line and the column.
//!
//! The format is RFC 4180, with commas, semicolons or tabs, as the header shows; with semicolons and tabs numbers may have
//! decimal commas. A byte order mark, and blank lines and `#` comments before
//! the header are skipped, but for the last comment where it is the header; so is a row of units behind it. Blank lines are
//! skipped between rows as well, except when there is just one
//! column, where they could be missing samples. Space around cells does not count. A cell may be
//! quoted and may then hold separators, line breaks and doubled quotes. Cells that are not selected are
//! counted but not read, so that they may hold anything, and columns that are not selected may have no name or one twice.

mod cell;
mod header;
mod mistake;
mod rows;
#[cfg(test)]
mod tests;

use std::io::Read;

pub(in crate::replay) use header::Header;
pub use mistake::RecordingError;

use super::selection::{Meaning, Source};
use mistake::shortened;
use rows::Rows;

/// A recording that is being read.
pub struct Recording<R> {
    rows: Rows<R>,
    name: String,
    header: Header,
    /// Which columns [`Recording::next_row`] delivers, in which order and as what.
    selection: Vec<(usize, Meaning)>,
    /// What came of the first row, which is read with the header.
    first: Option<Result<bool, RecordingError>>,
}

impl<R: Read> Recording<R> {
    /// Reads up to the first row; `name` stands for the recording in errors.
    ///
    /// All columns are selected until [`Recording::select`] is called.
    ///
    /// # Errors
    /// When there is no header, or its names are not UTF-8.
    pub fn open(source: R, name: &str) -> Result<Self, RecordingError> {
        let rows = Rows::new(source, header::separator);
        let mut recording =
            Self { rows, name: name.to_owned(), header: Header::default(), selection: Vec::new(), first: None };
        recording.read_header()?;
        recording.selection =
            (0..recording.header.columns.len()).map(|column| (column, Meaning::Number(1.0))).collect();
        if recording.first.is_none() {
            recording.first = Some(recording.read_row());
            recording.take_units();
        }
        Ok(recording)
    }

    /// The name under which it was opened.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The names in the header.
    pub fn columns(&self) -> &[String] {
        &self.header.columns
    }

    /// The names, and what a row of units says.
    pub(super) fn header(&self) -> &Header {
        &self.header
    }

    /// The line of the row that was read last, from 1; a row over several lines begins there.
    pub fn line(&self) -> u64 {
        self.rows.line()
    }

    /// Chooses the columns that [`Recording::next_row`] delivers, and returns their positions.
    ///
    /// # Errors
    /// When the header has no such column, or several.
    pub fn select(&mut self, names: &[&str]) -> Result<Vec<usize>, RecordingError> {
        let plain = |name: &&str| Source { column: (*name).to_owned(), meaning: Meaning::Number(1.0) };
        self.choose(&names.iter().map(plain).collect::<Vec<_>>())?;
        Ok(self.selection.iter().map(|(column, _)| *column).collect())
    }

    /// Chooses the cells that [`Recording::next_row`] delivers, and what they mean.
    pub(super) fn choose(&mut self, sources: &[Source]) -> Result<(), RecordingError> {
        let find = |source: &Source| {
            let named = |(_, column): &(usize, &String)| **column == source.column;
            let mut found = self.header.columns.iter().enumerate().filter(named).map(|(place, _)| place);
            let first = found.next().ok_or_else(|| self.missing_column(&source.column))?;
            found.next().map_or(Ok((first, source.meaning)), |second| Err(self.named_twice(first, second)))
        };
        self.selection = sources.iter().map(find).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// Reads the selected cells of the next row, or returns false at the end.
    ///
    /// An empty cell, `nan`, `NULL`, `N/A`, `-` or another word for it is a missing sample, NaN; `inf` is infinity.
    ///
    /// # Errors
    /// When the row has too few or too many cells, or a selected cell is not a number.
    ///
    /// # Panics
    /// When `into` has not one place per selected column.
    pub fn next_row(&mut self, into: &mut [f64]) -> Result<bool, RecordingError> {
        assert_eq!(into.len(), self.selection.len(), "one place per selected column");
        if !self.first.take().unwrap_or_else(|| self.read_row())? {
            return Ok(false);
        }
        let (cells, columns) = (self.rows.cells(), self.header.columns.len());
        // What ends in separators has cells without a meaning.
        if cells < columns || (columns..cells).any(|extra| !self.rows.cell(extra).is_empty()) {
            return Err(self.ragged_row());
        }
        for (value, &(column, meaning)) in into.iter_mut().zip(&self.selection) {
            *value =
                cell::read(self.rows.cell(column), meaning, self.comma()).ok_or_else(|| self.not_a_number(column))?;
        }
        Ok(true)
    }

    /// Whether numbers may have a decimal comma.
    fn comma(&self) -> bool {
        self.rows.separator() != b','
    }

    fn read_header(&mut self) -> Result<(), RecordingError> {
        let mut comment = Vec::new();
        loop {
            match self.rows.begin().map_err(|broken| self.broken(broken))? {
                None => return Err(self.no_header()),
                Some(b'#') => comment = self.rows.take_line().map_err(|broken| self.broken(broken))?,
                Some(b'\n') => self.rows.skip_line().map_err(|broken| self.broken(broken))?,
                Some(_) => {
                    self.rows.read().map_err(|broken| self.broken(broken))?;
                    if !self.rows.cell(0).starts_with(b"sep=") {
                        break;
                    }
                }
            }
        }
        if self.cells().is_some_and(|cells| header::has_numbers_only(&cells, self.comma())) {
            let names = header::commented(&comment, self.rows.separator());
            if names.len() != self.rows.cells() || comment.is_empty() {
                return Err(self.no_names());
            }
            self.header.columns = names;
            self.first = Some(Ok(true));
            return Ok(());
        }
        self.header.columns = (0..self.rows.cells()).map(|index| self.header_name(index)).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// The cells of the row that was read last, where they are UTF-8.
    fn cells(&self) -> Option<Vec<&str>> {
        (0..self.rows.cells()).map(|index| std::str::from_utf8(self.rows.cell(index)).ok()).collect()
    }

    /// Keeps the units where the first row has them, and reads the next.
    fn take_units(&mut self) {
        let found = self.first.as_ref().is_some_and(|first| *first == Ok(true));
        let Some(cells) = self.cells().filter(|cells| found && header::has_units(cells, self.comma())) else { return };
        self.header.units = cells.iter().map(|cell| (*cell).to_owned()).collect();
        self.first = Some(self.read_row());
    }

    fn header_name(&self, index: usize) -> Result<String, RecordingError> {
        let cell = self.rows.cell(index);
        std::str::from_utf8(cell).map(str::to_owned).map_err(|_| {
            let message = format!("the name of column {} is not UTF-8: `{}`", index + 1, shortened(cell));
            self.error(Some(self.line()), None, message, Some("save the recording as UTF-8".into()))
        })
    }

    /// Reads the next row that is not blank, or returns false at the end.
    fn read_row(&mut self) -> Result<bool, RecordingError> {
        let mut blank = None;
        loop {
            match self.rows.begin().map_err(|broken| self.broken(broken))? {
                None => return Ok(false),
                Some(b'\n') => {
                    blank.get_or_insert(self.line());
                    self.rows.skip_line().map_err(|broken| self.broken(broken))?;
                }
                Some(_) => break,
            }
        }
        if let (Some(line), [_]) = (blank, self.header.columns.as_slice()) {
            return Err(self.blank_line(line));
        }
        self.rows.read().map_err(|broken| self.broken(broken))?;
        Ok(true)
    }
}
