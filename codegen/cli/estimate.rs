//! `EST.csv`: the estimate row by row, written beside its place and moved there when whole.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::replay::{Interface, Sample};

use super::Failure;
use super::files::{is_standard, unwritable};

/// `EST.csv` under way.
pub struct Estimate {
    path: PathBuf,
    /// Beside its place; `None` for standard output.
    part: Option<PathBuf>,
    file: BufWriter<Box<dyn Write>>,
    line: String,
    single: bool,
}

impl Estimate {
    /// Opens the file and writes its header.
    pub fn create(path: &Path, interface: &Interface, scalar: Scalar) -> Result<Self, Failure> {
        let part = (!is_standard(path)).then(|| {
            let mut name = path.file_name().unwrap_or_default().to_owned();
            name.push(".part");
            path.with_file_name(name)
        });
        let file: Box<dyn Write> = match &part {
            Some(part) => Box::new(File::create(part).map_err(|error| unwritable(path, &error))?),
            None => Box::new(io::stdout()),
        };
        let names: Vec<&str> = interface.answers.iter().map(|answer| answer.name.as_str()).collect();
        let line = format!("t,{},status\n", names.join(","));
        let mut estimate =
            Self { path: path.to_owned(), part, file: BufWriter::new(file), line, single: scalar == Scalar::F32 };
        estimate.flush_line()?;
        Ok(estimate)
    }

    /// Writes one row; an integer's digits are those of its float, which is exact.
    #[expect(clippy::cast_possible_truncation, reason = "an f32 program's estimates are singles, widened")]
    pub fn write(&mut self, interface: &Interface, sample: &Sample) -> Result<(), Failure> {
        let _ = write!(self.line, "{}", sample.t);
        for (value, answer) in sample.estimate.iter().zip(&interface.answers) {
            let single = self.single && !answer.integer;
            let _ = if single { write!(self.line, ",{}", *value as f32) } else { write!(self.line, ",{value}") };
        }
        self.line += match sample.status {
            Status::Converging => ",converging\n",
            Status::Converged => ",converged\n",
            Status::Coasting => ",coasting\n",
        };
        self.flush_line()
    }

    fn flush_line(&mut self) -> Result<(), Failure> {
        let result = self.file.write_all(self.line.as_bytes());
        self.line.clear();
        result.map_err(|error| unwritable(&self.path, &error))
    }

    /// Moves the file to its place.
    pub fn finish(mut self) -> Result<(), Failure> {
        let flushed = self.file.flush();
        let moved = flushed.and_then(|()| self.part.as_ref().map_or(Ok(()), |part| std::fs::rename(part, &self.path)));
        moved.map_err(|error| unwritable(&self.path, &error))
    }
}

impl Drop for Estimate {
    /// What was not finished leaves nothing behind.
    fn drop(&mut self) {
        let _ = self.part.as_ref().map(std::fs::remove_file);
    }
}
