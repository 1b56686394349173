//! Reads a recording, a CSV file of numbers, one row at a time.
//!
//! In goes any byte stream; out come the selected columns of each row as numbers. Memory does not
//! grow with the recording: one row is held, and no row may be longer than [`LONGEST_ROW`], so that a
//! quote which is never closed cannot swallow the file. Every mistake is a [`RecordingError`] that
//! names the line and the column.
//!
//! The format is RFC 4180 with commas. A byte order mark, and blank lines and `#` comments before
//! the header are skipped; blank lines are skipped between rows as well, except when there is just one
//! column, where they could be missing samples. Space around cells does not count. A cell may be
//! quoted and may then hold commas, line breaks and doubled quotes. Cells that are not selected are
//! counted but not read, so that they may hold anything.

use std::fmt;
use std::io::{BufRead, BufReader, Read};
use std::ops::Range;

use super::steps::TimeError;

/// Bytes of the longest row that is accepted.
const LONGEST_ROW: usize = 1 << 20;

/// Bytes that are read at once.
const BUFFER: usize = 1 << 16;

/// A recording that is being read.
pub struct Recording<R> {
    source: BufReader<R>,
    name: String,
    columns: Vec<String>,
    /// Which columns [`Recording::next_row`] delivers, in which order.
    selection: Vec<usize>,
    row: Row,
}

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

impl<R: Read> Recording<R> {
    /// Reads up to the header; `name` stands for the recording in errors.
    ///
    /// All columns are selected until [`Recording::select`] is called.
    ///
    /// # Errors
    /// When there is no header, or its names are empty, not unique or not UTF-8.
    pub fn open(source: R, name: &str) -> Result<Self, RecordingError> {
        let mut recording = Self {
            source: BufReader::with_capacity(BUFFER, source),
            name: name.to_owned(),
            columns: Vec::new(),
            selection: Vec::new(),
            row: Row::default(),
        };
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
        self.row.line
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
        if self.row.cells.len() != self.columns.len() {
            return Err(self.ragged_row());
        }
        for (value, &column) in into.iter_mut().zip(&self.selection) {
            *value = number(self.row.cell(column)).ok_or_else(|| self.not_a_number(column))?;
        }
        Ok(true)
    }

    fn read_header(&mut self) -> Result<(), RecordingError> {
        loop {
            if !self.read_line_of_row()? {
                let help = "the first row names the columns, for example `t,theta,omega`";
                return Err(self.error(None, None, "there is no header row".into(), Some(help.into())));
            }
            if self.row.line == 1 && self.row.bytes.starts_with(b"\xef\xbb\xbf") {
                self.row.bytes.drain(..3);
            }
            if !self.row.is_blank() && !self.row.bytes.trim_ascii_start().starts_with(b"#") {
                break;
            }
        }
        self.finish_row()?;
        for index in 0..self.row.cells.len() {
            let name = self.header_name(index)?;
            self.columns.push(name);
        }
        Ok(())
    }

    fn header_name(&self, index: usize) -> Result<String, RecordingError> {
        let cell = self.row.cell(index);
        let refuse =
            |message: String, help: &str| Err(self.error(Some(self.row.line), None, message, Some(help.to_owned())));
        let Ok(text) = std::str::from_utf8(cell) else {
            let message = format!("the name of column {} is not UTF-8: `{}`", index + 1, shortened(cell));
            return refuse(message, "save the recording as UTF-8");
        };
        let name = text.replace("\"\"", "\"");
        if name.is_empty() {
            let message = format!("column {} of {} has no name", index + 1, self.row.cells.len());
            return refuse(message, "name the column, or remove a comma at the end of the header");
        }
        if let Some(first) = self.columns.iter().position(|other| *other == name) {
            let message = format!("columns {} and {} are both named `{name}`", first + 1, index + 1);
            return refuse(message, "give every column a name of its own");
        }
        Ok(name)
    }

    /// Reads the next row that is not blank, or returns false at the end.
    fn read_row(&mut self) -> Result<bool, RecordingError> {
        let mut blank = None;
        while self.read_line_of_row()? {
            if !self.row.is_blank() {
                if let (Some(line), [_]) = (blank, self.columns.as_slice()) {
                    return Err(self.blank_line(line));
                }
                self.finish_row()?;
                return Ok(true);
            }
            blank.get_or_insert(self.row.line);
        }
        Ok(false)
    }

    /// Reads the first line of the next row, or returns false at the end.
    fn read_line_of_row(&mut self) -> Result<bool, RecordingError> {
        self.row.bytes.clear();
        self.row.quoted = false;
        self.row.line = self.row.next_line;
        self.append_line()
    }

    /// Reads on while a quote is open, then finds the cells.
    fn finish_row(&mut self) -> Result<(), RecordingError> {
        while self.row.quoted {
            if !self.append_line()? {
                let help = "close the quote, or double it if it belongs to the text";
                let message = "a quote is opened and never closed".into();
                return Err(self.error(Some(self.row.line), None, message, Some(help.into())));
            }
        }
        self.row.split();
        Ok(())
    }

    /// Appends a line of the file to the row, or returns false at the end of the file.
    fn append_line(&mut self) -> Result<bool, RecordingError> {
        let start = self.row.bytes.len();
        let room = LONGEST_ROW + 1 - start;
        let read = self.source.by_ref().take(room as u64).read_until(b'\n', &mut self.row.bytes);
        let read =
            read.map_err(|cause| self.error(Some(self.row.next_line), None, format!("cannot be read: {cause}"), None))?;
        if self.row.bytes.len() > LONGEST_ROW {
            let message = format!("a row is longer than {LONGEST_ROW} bytes");
            let help = "look for a quote that is not closed; lines have to end in a line feed";
            return Err(self.error(Some(self.row.line), None, message, Some(help.into())));
        }
        self.row.quoted = self.row.bytes[start..].iter().fold(self.row.quoted, |quoted, &byte| quoted ^ (byte == b'"'));
        self.row.next_line += 1;
        Ok(read > 0)
    }
}

/// The errors, one function each.
impl<R> Recording<R> {
    /// It has a header and nothing else.
    pub(super) fn has_no_rows(&self) -> RecordingError {
        self.error(None, None, "the recording has no rows".into(), None)
    }

    /// The time of the row that was read last does not fit a step.
    pub(super) fn unfit(&self, error: &TimeError) -> RecordingError {
        self.error(Some(self.row.line), None, error.message.clone(), error.help.clone())
    }

    /// What is wrong with a selected cell of the row that was read last.
    pub(super) fn complaint(&self, column: &str, message: String, help: &str) -> RecordingError {
        RecordingError {
            name: self.name.clone(),
            line: Some(self.row.line),
            column: Some(column.to_owned()),
            message,
            help: Some(help.to_owned()),
        }
    }

    fn error(&self, line: Option<u64>, column: Option<usize>, message: String, help: Option<String>) -> RecordingError {
        let column = column.map(|index| self.columns[index].clone());
        RecordingError { name: self.name.clone(), line, column, message, help }
    }

    fn missing_column(&self, name: &str) -> RecordingError {
        let list = self.columns.iter().map(|column| format!("`{column}`")).collect::<Vec<_>>().join(", ");
        let help = match self.columns.as_slice() {
            [only] if only.contains(';') || only.contains('\t') => {
                Some("cells are separated by commas; this header looks as if they were not".to_owned())
            }
            _ => nearest(name, &self.columns).map(|column| format!("did you mean `{column}`?")),
        };
        self.error(None, None, format!("there is no column `{name}`; the columns are {list}"), help)
    }

    fn blank_line(&self, line: u64) -> RecordingError {
        let help = "write `nan` for a missing sample, or remove the line";
        self.error(Some(line), Some(0), "a blank line between two samples".into(), Some(help.into()))
    }

    fn ragged_row(&self) -> RecordingError {
        let (found, expected) = (self.row.cells.len(), self.columns.len());
        let count = format!("the row has {found} cell{}, the header has {expected}", if found == 1 { "" } else { "s" });
        if found < expected {
            let help =
                format!("cell {} is the first that is missing; a missing sample still needs its comma", found + 1);
            return self.error(Some(self.row.line), Some(found), count, Some(help));
        }
        let extra = shortened(self.row.cell(expected));
        let help =
            format!("cell {} is the first too many; numbers are written with a point, not with a comma", expected + 1);
        self.error(Some(self.row.line), None, format!("{count}; no column for `{extra}`"), Some(help))
    }

    fn not_a_number(&self, column: usize) -> RecordingError {
        let cell = self.row.cell(column);
        let what = if std::str::from_utf8(cell).is_ok() { "a number" } else { "UTF-8" };
        let message = format!("`{}` is not {what}", shortened(cell));
        let help = format!("this is cell {} of the row; leave it empty if the sample is missing", column + 1);
        self.error(Some(self.row.line), Some(column), message, Some(help))
    }
}

/// One row as it stands in the file, and where its cells are.
struct Row {
    bytes: Vec<u8>,
    cells: Vec<Range<usize>>,
    /// Whether the bytes so far break off within a quoted cell.
    quoted: bool,
    /// The line on which the row begins, from 1.
    line: u64,
    /// The line that will be read next.
    next_line: u64,
}

impl Default for Row {
    fn default() -> Self {
        Self { bytes: Vec::new(), cells: Vec::new(), quoted: false, line: 1, next_line: 1 }
    }
}

impl Row {
    fn is_blank(&self) -> bool {
        self.bytes.trim_ascii().is_empty()
    }

    /// Finds the cells: they end at the commas outside of quotes.
    fn split(&mut self) {
        self.cells.clear();
        let (mut start, mut quoted) = (0, false);
        for (at, &byte) in self.bytes.iter().enumerate() {
            match byte {
                b'"' => quoted = !quoted,
                b',' if !quoted => {
                    self.cells.push(start..at);
                    start = at + 1;
                }
                _ => {}
            }
        }
        self.cells.push(start..self.bytes.len());
    }

    /// The content of a cell without the space and the quotes around it; doubled quotes stay doubled.
    fn cell(&self, index: usize) -> &[u8] {
        match self.bytes[self.cells[index].clone()].trim_ascii() {
            [b'"', inner @ .., b'"'] => inner.trim_ascii(),
            cell => cell,
        }
    }
}

/// The number in a cell, NaN when the sample is missing.
fn number(cell: &[u8]) -> Option<f64> {
    if cell.is_empty() {
        return Some(f64::NAN);
    }
    std::str::from_utf8(cell).ok()?.parse().ok()
}

/// A cell fit for an error message: its first characters, on one line.
fn shortened(cell: &[u8]) -> String {
    const LONGEST: usize = 24;
    let text = String::from_utf8_lossy(&cell[..cell.len().min(4 * LONGEST + 4)]);
    let clean = |c: char| if c.is_control() { ' ' } else { c };
    let mut shown: String = text.chars().map(clean).take(LONGEST).collect();
    if text.chars().count() > LONGEST {
        shown.push('…');
    }
    shown
}

/// The name that differs least from the one that was asked for, unless all differ in most letters.
fn nearest<'a>(name: &str, among: &'a [String]) -> Option<&'a str> {
    let (wanted, most) = (name.to_lowercase(), name.chars().count().div_ceil(2));
    among
        .iter()
        .map(|other| (edit_distance(&wanted, &other.to_lowercase()), other.as_str()))
        .filter(|(distance, _)| *distance <= most)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, other)| other)
}

/// How many letters have to be inserted, removed or replaced to turn `a` into `b` (Levenshtein).
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != *to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open(text: &[u8]) -> Result<Recording<&[u8]>, RecordingError> {
        Recording::open(text, "r.csv")
    }

    fn rows(text: &str, names: &[&str]) -> Result<Vec<Vec<f64>>, RecordingError> {
        let mut recording = open(text.as_bytes())?;
        recording.select(names)?;
        let (mut rows, mut row) = (Vec::new(), vec![0.0; names.len()]);
        while recording.next_row(&mut row)? {
            rows.push(row.clone());
        }
        Ok(rows)
    }

    fn complaint(text: &str, names: &[&str]) -> String {
        rows(text, names).unwrap_err().to_string()
    }

    #[test]
    fn selected_columns_come_in_the_order_of_the_selection() {
        let mut recording = open(b"t,a,b\n1,2,3\n").unwrap();
        assert_eq!(recording.columns(), ["t", "a", "b"]);
        assert_eq!(recording.select(&["b", "t"]).unwrap(), [2, 0]);
        let mut row = [0.0; 2];
        assert!(recording.next_row(&mut row).unwrap());
        assert_eq!((row, recording.line()), ([3.0, 1.0], 2));
        assert!(!recording.next_row(&mut row).unwrap());
        assert!(!recording.next_row(&mut row).unwrap());
    }

    #[test]
    fn the_preamble_is_tolerated() {
        let text = "\u{feff}# rig 3, \"left\n\n  # 1 kHz\r\n t , \"a \"\"x\"\"\" ,b\r\n1,2,3";
        assert_eq!(open(text.as_bytes()).unwrap().columns(), ["t", "a \"x\"", "b"]);
        assert_eq!(rows(text, &["t", "b"]).unwrap(), [[1.0, 3.0]]);
        assert_eq!(complaint(&text.replace('3', "x"), &["b"]), "r.csv:5: column `b`: `x` is not a number");
    }

    #[test]
    fn zero_rows_are_not_an_error() {
        assert!(rows("t,a", &["t"]).unwrap().is_empty());
        assert!(rows("t,a\r\n\r\n", &["t"]).unwrap().is_empty());
    }

    #[test]
    fn a_header_is_required() {
        assert_eq!(complaint("", &[]), "r.csv: there is no header row");
        assert_eq!(complaint("\n# only\n", &[]), "r.csv: there is no header row");
    }

    #[test]
    fn names_in_the_header_are_unique_and_not_empty() {
        assert_eq!(complaint("t,a, t\n", &[]), "r.csv:1: columns 1 and 3 are both named `t`");
        assert_eq!(complaint("#\nt,,a\n", &[]), "r.csv:2: column 2 of 3 has no name");
        let error = open(b"t,\xe9\n").err().unwrap();
        assert_eq!(error.to_string(), "r.csv:1: the name of column 2 is not UTF-8: `\u{fffd}`");
    }

    #[test]
    fn a_missing_column_lists_the_others_and_suggests_the_nearest() {
        let error = rows("t,theta,omega\n", &["t", "teta"]).unwrap_err();
        assert_eq!(error.to_string(), "r.csv: there is no column `teta`; the columns are `t`, `theta`, `omega`");
        assert_eq!(error.help.as_deref(), Some("did you mean `theta`?"));
        assert_eq!(rows("t,theta\n", &["Theta"]).unwrap_err().help.as_deref(), Some("did you mean `theta`?"));
        assert_eq!(rows("t,theta\n", &["voltage"]).unwrap_err().help, None);
        assert!(rows("t;theta\n1;2\n", &["t"]).unwrap_err().help.unwrap().contains("commas"));
    }

    #[test]
    fn missing_samples_and_special_numbers() {
        let text = "a,b,c,d,e,f\n, NaN ,\"\",nan,inf,-Infinity\n1e3,.5,-0,+2,\" 7 \",1E-300\n";
        let rows = rows(text, &["a", "b", "c", "d", "e", "f"]).unwrap();
        assert!(rows[0][..4].iter().all(|v| v.is_nan()));
        assert_eq!(rows[0][4..], [f64::INFINITY, f64::NEG_INFINITY]);
        assert_eq!(rows[1], [1e3, 0.5, 0.0, 2.0, 7.0, 1e-300]);
    }

    #[test]
    fn a_bad_number_is_named_by_line_and_column() {
        let error = rows("t,theta\n0,1\n1,1.2.3\n", &["theta"]).unwrap_err();
        assert_eq!(error.to_string(), "r.csv:3: column `theta`: `1.2.3` is not a number");
        assert!(error.help.unwrap().starts_with("this is cell 2 of the row"));
        assert_eq!(complaint("t\n1 2\n", &["t"]), "r.csv:2: column `t`: `1 2` is not a number");
        assert_eq!(complaint("t\n# note\n", &["t"]), "r.csv:2: column `t`: `# note` is not a number");
        assert_eq!(complaint("a,b\n1,\"2\n3\"\n", &["b"]), "r.csv:2: column `b`: `2 3` is not a number");
        let long = format!("t\n{}\n", "ä".repeat(500));
        assert_eq!(complaint(&long, &["t"]), format!("r.csv:2: column `t`: `{}…` is not a number", "ä".repeat(24)));
    }

    #[test]
    fn columns_that_are_not_selected_may_hold_anything() {
        assert_eq!(rows("t,note\n1,\"a, b\"\n2,\"x\n\"\"y\"\"\"\n", &["t"]).unwrap(), [[1.0], [2.0]]);
    }

    #[test]
    fn lines_are_counted_through_quotes_blank_lines_and_every_line_end() {
        for end in ["\n", "\r\n"] {
            let text = ["t,note", "1,\"two", "lines\"", "", "  ", "2,b", "x,c"].join(end);
            assert_eq!(complaint(&text, &["t"]), "r.csv:7: column `t`: `x` is not a number");
        }
    }

    #[test]
    fn a_ragged_row_is_named_by_line_and_column() {
        let few = rows("t,a,b\n1,2,3\n1,2\n", &["t"]).unwrap_err();
        assert_eq!(few.to_string(), "r.csv:3: column `b`: the row has 2 cells, the header has 3");
        assert!(few.help.unwrap().starts_with("cell 3 is the first that is missing"));
        let many = rows("t,a\n1,2,5\n", &["t"]).unwrap_err();
        assert_eq!(many.to_string(), "r.csv:2: the row has 3 cells, the header has 2; no column for `5`");
        assert!(many.help.unwrap().starts_with("cell 3 is the first too many"));
        assert_eq!(complaint("t,a\n1\n", &["t"]), "r.csv:2: column `a`: the row has 1 cell, the header has 2");
    }

    #[test]
    fn a_blank_line_in_a_single_column_is_not_guessed_at() {
        assert_eq!(complaint("y\n1\n\n2\n", &["y"]), "r.csv:3: column `y`: a blank line between two samples");
        assert_eq!(rows("y\n1\nnan\n2\n\n\n", &["y"]).unwrap().len(), 3);
    }

    #[test]
    fn invalid_utf_8_is_an_error_in_a_selected_cell() {
        let mut recording = open(b"t,a\n1,2\xff\n").unwrap();
        let error = recording.next_row(&mut [0.0; 2]).unwrap_err();
        assert_eq!(error.to_string(), "r.csv:2: column `a`: `2\u{fffd}` is not UTF-8");
    }

    #[test]
    fn an_open_quote_ends_in_an_error_and_not_in_memory() {
        assert_eq!(complaint("t,a\n1,\"2\n3,4\n", &["t"]), "r.csv:2: a quote is opened and never closed");
        let long = format!("t,a\n0,0\n1,\"2\n{}", "3,4\n".repeat(LONGEST_ROW));
        assert_eq!(complaint(&long, &["t"]), "r.csv:3: a row is longer than 1048576 bytes");
    }

    #[test]
    fn a_source_that_fails_is_reported_with_its_line() {
        struct Broken;
        impl Read for Broken {
            fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
                Err(std::io::Error::other("unplugged"))
            }
        }
        let mut recording = Recording::open(b"t\n1\n".chain(Broken), "-").unwrap();
        assert!(recording.next_row(&mut [0.0]).unwrap());
        assert_eq!(recording.next_row(&mut [0.0]).unwrap_err().to_string(), "-:3: cannot be read: unplugged");
    }
}
