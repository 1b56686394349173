//! Signs of life, on a terminal only: rows so far, and how long a design has taken.

use std::io::{self, IsTerminal as _};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

use deadbeat_codegen::Generator;

/// Works on a specification, and from the first second on says for how long on a terminal.
pub fn alive<T>(generator: &Generator, work: impl FnOnce(&Generator) -> T) -> T {
    let _life = io::stderr().is_terminal().then(|| Life::new(&generator.source().name));
    work(generator)
}

/// A line on standard error that counts seconds, and is gone when the work is done.
struct Life {
    /// Nothing is ever sent: the other end hears when this one is dropped.
    done: Option<Sender<()>>,
    shown: Option<JoinHandle<bool>>,
}

impl Life {
    fn new(name: &str) -> Self {
        let (done, is_done) = channel();
        let (name, begun) = (name.to_owned(), Instant::now());
        let show = move || {
            let mut shown = false;
            while is_done.recv_timeout(Duration::from_secs(1)).is_err_and(|over| over == RecvTimeoutError::Timeout) {
                eprint!("\r{name}: designing, {} s", begun.elapsed().as_secs());
                shown = true;
            }
            shown
        };
        Self { done: Some(done), shown: Some(spawn(show)) }
    }
}

impl Drop for Life {
    /// Clears the line, also in front of an error.
    fn drop(&mut self) {
        self.done.take();
        if self.shown.take().is_some_and(|shown| shown.join().unwrap_or(true)) {
            eprint!("\r\x1b[K");
        }
    }
}

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
