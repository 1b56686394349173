//! Cells of rows: knows bytes, lines, commas and quotes; never what a cell means.

use std::io::{self, BufRead as _, BufReader, Chain, Cursor, Read};

use csv_core::{ReadFieldResult, Reader, ReaderBuilder, Terminator};

/// Bytes of the longest row that is accepted.
pub const LONGEST_ROW: usize = 1 << 20;

/// Bytes that are read at once.
const BUFFER: usize = 1 << 16;

/// What some programs write ahead of UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Rows that are being read, one at a time.
pub struct Rows<R> {
    source: BufReader<Chain<Cursor<Vec<u8>>, R>>,
    /// A failure of the source while its first bytes were looked at.
    failed: Option<io::Error>,
    reader: Reader,
    row: Row,
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
    /// From the first line on.
    pub fn new(mut source: R) -> Self {
        let mut first = Vec::new();
        let read = source.by_ref().take(BYTE_ORDER_MARK.len() as u64).read_to_end(&mut first);
        if first == BYTE_ORDER_MARK {
            first.clear();
        }
        let text = vec![0; LONGEST_ROW + 1];
        Self {
            source: BufReader::with_capacity(BUFFER, Cursor::new(first).chain(source)),
            failed: read.err(),
            reader: ReaderBuilder::new().terminator(Terminator::Any(b'\n')).build(),
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
            let space = bytes.iter().take_while(|byte| **byte != b'\n' && byte.is_ascii_whitespace()).count();
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
            let filled = self.failed.take().map_or_else(|| self.source.fill_buf(), Err);
            match filled {
                Ok(bytes) => return Ok(!bytes.is_empty()),
                Err(cause) if cause.kind() == io::ErrorKind::Interrupted => {}
                Err(cause) => return Err(Broken::Source(self.reader.line(), cause)),
            }
        }
    }
}
