//! Reads a recording, a CSV file of numbers, one row at a time.
//!
//! In goes any byte stream; out come the selected columns of each row as numbers. Memory does not
//! grow with the recording: one row is held, and no row may be longer than 1 MiB, so that a quote which is
//! never closed cannot swallow the file. Every mistake is a [`RecordingError`] that
//! names the line and the column.
//!
//! The format is RFC 4180 with commas. A byte order mark, and blank lines and `#` comments before
//! the header are skipped; blank lines are skipped between rows as well, except when there is just one
//! column, where they could be missing samples. Space around cells does not count. A cell may be
//! quoted and may then hold commas, line breaks and doubled quotes. Cells that are not selected are
//! counted but not read, so that they may hold anything.

mod mistake;
mod rows;
#[cfg(test)]
mod tests;

use std::io::Read;

pub use mistake::RecordingError;

use mistake::shortened;
use rows::Rows;

/// A recording that is being read.
pub struct Recording<R> {
    rows: Rows<R>,
    name: String,
    columns: Vec<String>,
    /// Which columns [`Recording::next_row`] delivers, in which order.
    selection: Vec<usize>,
}

impl<R: Read> Recording<R> {
    /// Reads up to the header; `name` stands for the recording in errors.
    ///
    /// All columns are selected until [`Recording::select`] is called.
    ///
    /// # Errors
    /// When there is no header, or its names are empty, not unique or not UTF-8.
    pub fn open(source: R, name: &str) -> Result<Self, RecordingError> {
        let (columns, selection) = (Vec::new(), Vec::new());
        let mut recording = Self { rows: Rows::new(source), name: name.to_owned(), columns, selection };
        recording.read_header()?;
        recording.selection = (0..recording.columns.len()).collect();
        Ok(recording)
    }

    /// The name under which it was opened.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The names in the header.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// The line of the row that was read last, from 1; a row over several lines begins there.
    pub fn line(&self) -> u64 {
        self.rows.line()
    }

    /// Chooses the columns that [`Recording::next_row`] delivers, and returns their positions.
    ///
    /// # Errors
    /// When the header has no such column.
    pub fn select(&mut self, names: &[&str]) -> Result<Vec<usize>, RecordingError> {
        let find = |name: &&str| {
            self.columns.iter().position(|column| column == name).ok_or_else(|| self.missing_column(name))
        };
        self.selection = names.iter().map(find).collect::<Result<_, _>>()?;
        Ok(self.selection.clone())
    }

    /// Reads the selected cells of the next row, or returns false at the end.
    ///
    /// An empty cell or `nan` is a missing sample, NaN; `inf` is infinity.
    ///
    /// # Errors
    /// When the row has too few or too many cells, or a selected cell is not a number.
    ///
    /// # Panics
    /// When `into` has not one place per selected column.
    pub fn next_row(&mut self, into: &mut [f64]) -> Result<bool, RecordingError> {
        assert_eq!(into.len(), self.selection.len(), "one place per selected column");
        if !self.read_row()? {
            return Ok(false);
        }
        if self.rows.cells() != self.columns.len() {
            return Err(self.ragged_row());
        }
        for (value, &column) in into.iter_mut().zip(&self.selection) {
            *value = number(self.rows.cell(column)).ok_or_else(|| self.not_a_number(column))?;
        }
        Ok(true)
    }

    fn read_header(&mut self) -> Result<(), RecordingError> {
        loop {
            match self.rows.begin().map_err(|broken| self.broken(broken))? {
                None => return Err(self.no_header()),
                Some(b'#' | b'\n') => self.rows.skip_line().map_err(|broken| self.broken(broken))?,
                Some(_) => break,
            }
        }
        self.rows.read().map_err(|broken| self.broken(broken))?;
        for index in 0..self.rows.cells() {
            let name = self.header_name(index)?;
            self.columns.push(name);
        }
        Ok(())
    }

    fn header_name(&self, index: usize) -> Result<String, RecordingError> {
        let cell = self.rows.cell(index);
        let refuse =
            |message: String, help: &str| Err(self.error(Some(self.line()), None, message, Some(help.to_owned())));
        let Ok(name) = std::str::from_utf8(cell) else {
            let message = format!("the name of column {} is not UTF-8: `{}`", index + 1, shortened(cell));
            return refuse(message, "save the recording as UTF-8");
        };
        if name.is_empty() {
            let message = format!("column {} of {} has no name", index + 1, self.rows.cells());
            return refuse(message, "name the column, or remove a comma at the end of the header");
        }
        if let Some(first) = self.columns.iter().position(|other| *other == name) {
            let message = format!("columns {} and {} are both named `{name}`", first + 1, index + 1);
            return refuse(message, "give every column a name of its own");
        }
        Ok(name.to_owned())
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
        if let (Some(line), [_]) = (blank, self.columns.as_slice()) {
            return Err(self.blank_line(line));
        }
        self.rows.read().map_err(|broken| self.broken(broken))?;
        Ok(true)
    }
}

/// The number in a cell, NaN when the sample is missing.
fn number(cell: &[u8]) -> Option<f64> {
    if cell.is_empty() {
        return Some(f64::NAN);
    }
    std::str::from_utf8(cell).ok()?.parse().ok()
}
