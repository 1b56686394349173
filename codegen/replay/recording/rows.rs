//! Cells of rows: knows bytes, lines, commas and quotes; never what a cell means.

use std::io::{self, BufRead as _, BufReader, Cursor, Read};

use csv_core::{ReadFieldResult, Reader, ReaderBuilder, Terminator};

/// Bytes of the longest row that is accepted.
pub const LONGEST_ROW: usize = 1 << 20;

/// Bytes that are read at once.
const BUFFER: usize = 1 << 16;

/// What some programs write ahead of UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Rows that are being read, one at a time.
pub struct Rows<R> {
    source: BufReader<Looked<R>>,
    reader: Reader,
    separator: u8,
    row: Row,
}

/// A source whose first bytes have been looked at.
struct Looked<R> {
    first: Cursor<Vec<u8>>,
    /// A failure behind them.
    failed: Option<io::Error>,
    rest: R,
}

impl<R: Read> Read for Looked<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self.first.read(into)? {
            0 => self.failed.take().map_or_else(|| self.rest.read(into), Err),
            read => Ok(read),
        }
    }
}

/// The row that was read last.
struct Row {
    /// The cells' text, without quotes; has room for the longest row, of which only what was written takes memory.
    text: Vec<u8>,
    /// Where each cell's text ends.
    ends: Vec<usize>,
    /// Bytes of the text.
    written: usize,
    /// Bytes of the file.
    taken: usize,
    /// On which it begins, from 1.
    line: u64,
}

/// Why there is no next row.
pub enum Broken {
    /// The source failed on this line.
    Source(u64, io::Error),
    /// The row is longer than [`LONGEST_ROW`].
    Long,
    /// A quote is not closed before the end.
    Open,
}

impl<R> Rows<R> {
    /// The line on which the row that was read last begins, from 1.
    pub fn line(&self) -> u64 {
        self.row.line
    }

    /// What separates cells.
    pub fn separator(&self) -> u8 {
        self.separator
    }

    /// How many there are in the row that was read last.
    pub fn cells(&self) -> usize {
        self.row.ends.len()
    }

    /// The content of a cell without the space and the quotes around it.
    pub fn cell(&self, index: usize) -> &[u8] {
        let start = index.checked_sub(1).map_or(0, |before| self.row.ends[before]);
        self.row.text[start..self.row.ends[index]].trim_ascii()
    }
}

impl<R: Read> Rows<R> {
    /// From the first line on; `separator` tells what separates cells from the first bytes.
    pub fn new(mut source: R, separator: impl Fn(&[u8]) -> u8) -> Self {
        let mut first = Vec::new();
        let failed = source.by_ref().take(BUFFER as u64).read_to_end(&mut first).err();
        if first.starts_with(BYTE_ORDER_MARK) {
            first.drain(..BYTE_ORDER_MARK.len());
        }
        let separator = separator(&first);
        let text = vec![0; LONGEST_ROW + 1];
        let looked = Looked { first: Cursor::new(first), failed, rest: source };
        Self {
            source: BufReader::with_capacity(BUFFER, looked),
            reader: ReaderBuilder::new().terminator(Terminator::Any(b'\n')).delimiter(separator).build(),
            separator,
            row: Row { text, ends: Vec::new(), written: 0, taken: 0, line: 1 },
        }
    }

    /// Begins the next row; its first byte that is no space, a line feed where the line is blank, `None` at the end.
    pub fn begin(&mut self) -> Result<Option<u8>, Broken> {
        self.row.ends.clear();
        (self.row.written, self.row.taken, self.row.line) = (0, 0, self.reader.line());
        self.first()
    }

    /// Leaves out the rest of the line.
    pub fn skip_line(&mut self) -> Result<(), Broken> {
        self.reader.set_line(self.reader.line() + 1);
        self.source.skip_until(b'\n').map(drop).map_err(|cause| Broken::Source(self.row.line, cause))
    }

    /// The rest of the line, without its end.
    pub fn take_line(&mut self) -> Result<Vec<u8>, Broken> {
        self.reader.set_line(self.reader.line() + 1);
        let mut line = Vec::new();
        let most = LONGEST_ROW as u64 + 1;
        let read = self.source.by_ref().take(most).read_until(b'\n', &mut line);
        match read.map_err(|cause| Broken::Source(self.row.line, cause))? {
            read if read as u64 == most => Err(Broken::Long),
            _ => Ok(line),
        }
    }

    /// Reads the row that has begun.
    pub fn read(&mut self) -> Result<(), Broken> {
        while !self.read_cell()? {}
        Ok(())
    }

    /// Reads a cell and what ends it; true where that is the row's end.
    fn read_cell(&mut self) -> Result<bool, Broken> {
        // Space ahead of a quote does not count, but the reader would take the quote for a part of the text.
        let quoted = self.first()? == Some(b'"');
        let mut last = b'"';
        loop {
            let there = self.fill()?;
            let room = LONGEST_ROW + 1 - self.row.taken;
            // The last line may lack its end.
            let bytes = if there { self.source.buffer() } else { b"\n" };
            let bytes = &bytes[..bytes.len().min(room)];
            let (result, read, written) = self.reader.read_field(bytes, &mut self.row.text[self.row.written..]);
            let ended = matches!(result, ReadFieldResult::Field { .. });
            last = bytes[..read - usize::from(ended)].trim_ascii_end().last().copied().unwrap_or(last);
            if there {
                self.source.consume(read);
            }
            self.row.taken += read;
            self.row.written += written;
            match result {
                _ if self.row.taken > LONGEST_ROW => return Err(Broken::Long),
                ReadFieldResult::Field { record_end } => {
                    // The reader takes what stands behind a closing quote for text: `"1"2` must not become a number.
                    if quoted && last != b'"' {
                        self.row.text[self.row.written] = b'"';
                        self.row.written += 1;
                    }
                    self.row.ends.push(self.row.written);
                    return Ok(record_end);
                }
                _ if !there => return Err(Broken::Open),
                _ => {}
            }
        }
    }

    /// The next byte that is no space within a line, which stays; `None` at the end.
    fn first(&mut self) -> Result<Option<u8>, Broken> {
        while self.fill()? {
            let bytes = self.source.buffer();
            let space = bytes
                .iter()
                .take_while(|byte| **byte != b'\n' && **byte != self.separator && byte.is_ascii_whitespace())
                .count();
            let first = bytes.get(space).copied();
            self.source.consume(space);
            if first.is_some() {
                return Ok(first);
            }
        }
        Ok(None)
    }

    /// Has bytes in the buffer, or returns false at the end.
    fn fill(&mut self) -> Result<bool, Broken> {
        loop {
            match self.source.fill_buf() {
                Ok(bytes) => return Ok(!bytes.is_empty()),
                Err(cause) if cause.kind() == io::ErrorKind::Interrupted => {}
                Err(cause) => return Err(Broken::Source(self.reader.line(), cause)),
            }
        }
    }
}
