//! Rows so far, on a terminal only.

use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

/// A line on standard error that counts rows, and is gone when the work is done.
pub struct Progress {
    terminal: bool,
    shown: Option<Instant>,
}

impl Progress {
    /// Nothing shown yet.
    pub fn new() -> Self {
        Self { terminal: io::stderr().is_terminal(), shown: None }
    }

    /// Now and then, how many rows there were.
    pub fn show(&mut self, rows: u64) {
        let due = || self.shown.is_none_or(|shown| shown.elapsed() > Duration::from_millis(200));
        if self.terminal && rows.is_multiple_of(4_096) && due() {
            eprint!("\r{rows} rows");
            self.shown = Some(Instant::now());
        }
    }
}

impl Drop for Progress {
    /// Clears the line, also in front of an error.
    fn drop(&mut self) {
        if self.shown.is_some() {
            eprint!("\r\x1b[K");
        }
    }
}
