//! `deadbeat run`: a recording in, errors, estimate and figure out.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufWriter, IsTerminal as _, Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;
use deadbeat_codegen::Generated;
use deadbeat_codegen::plant::Plant;
use deadbeat_codegen::program::{Program, Scalar, Status};
use serde_json::{Map, Value, json};

use super::figure::Curves;
use super::recording::{Recording, RecordingError};
use super::replay::{Replay, Row, Sample};
use super::{Common, End, Failure, one_standard_input, print, read_spec, show};

/// Arguments of `deadbeat run`.
#[derive(Args)]
pub struct Options {
    /// A specification; `-` is standard input
    spec: PathBuf,
    /// The recording, with a header row; `-` is standard input
    #[arg(long, value_name = "IN.csv")]
    log: PathBuf,
    /// Writes the estimate; `-` is standard output
    #[arg(long, value_name = "EST.csv")]
    out: Option<PathBuf>,
    /// Draws measurements, estimate, reference and error; `-` is standard output
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,
    /// An output, an input or the time `t` that has another name in the recording, may be repeated
    #[arg(long, value_name = "NAME=COLUMN", value_parser = renaming)]
    map: Vec<(String, String)>,
    /// A state and the column to compare it with, may be repeated
    #[arg(long, value_name = "STATE=COLUMN", value_parser = renaming)]
    reference: Vec<(String, String)>,
    #[command(flatten)]
    common: Common,
}

fn renaming(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, column)) if !name.is_empty() && !column.is_empty() => Ok((name.to_owned(), column.to_owned())),
        _ => Err("write NAME=COLUMN".into()),
    }
}

/// What is wrong with a recording, and what to do.
fn explained(error: &RecordingError) -> Failure {
    let help = error.help.as_ref().map_or(String::new(), |help| format!("\nhelp: {help}"));
    Failure::Wrong(format!("{error}{help}"))
}

/// Whether a file is standard input or output.
fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Replays a recording.
pub fn run(options: &Options) -> Result<End, Failure> {
    one_standard_input([&options.spec, &options.log])?;
    let written = || options.out.iter().chain(&options.plot);
    if written().filter(|path| is_standard(path)).count() > 1 {
        return Err(Failure::Misused("standard output can stand for one file only".into()));
    }
    nothing_overwritten(options)?;
    let generated = match read_spec(&options.spec, options.common.settings())?.design() {
        Ok(generated) => generated,
        Err(report) => {
            show(&report);
            return Ok(End::Wrong);
        }
    };
    show(&generated.report);
    let plant = &generated.plant;
    let (source, name) = open(&options.log)?;
    let mut recording = Recording::open(source, &name).map_err(|error| explained(&error))?;
    let columns = Columns::find(plant, options, recording.columns())?;
    let names: Vec<&str> = columns.names.iter().map(String::as_str).collect();
    recording.select(&names).map_err(|error| explained(&error))?;

    let mut replay = Replay::new(plant, &generated.program);
    let mut curves = Curves::new(&generated, &columns.compared());
    let mut estimate = options.out.as_ref().map(|path| Estimate::create(path, &generated.program)).transpose()?;
    let mut progress = Progress::new();
    let mut cells = vec![0.0; names.len()];
    while recording.next_row(&mut cells).map_err(|error| explained(&error))? {
        let row = columns.row(&cells);
        let line = recording.line();
        let sample = replay.feed(&row).map_err(|why| Failure::Wrong(format!("{name}:{line}: {why}")))?;
        curves.add(&row, &sample);
        if let Some(estimate) = &mut estimate {
            estimate.write(&sample)?;
        }
        progress.show(replay.rows);
    }
    drop(progress);
    if replay.rows == 0 {
        return Err(Failure::Wrong(format!("{name}: the recording has no rows")));
    }
    if let Some(path) = &options.plot {
        write_text(path, &curves.figure(&generated, &replay).to_string())?;
    }
    if let Some(estimate) = estimate {
        estimate.finish()?;
    }
    let compared = columns.compared();
    let report = if options.common.json() {
        json_report(plant, &replay, &compared)
    } else {
        text_report(&generated, &replay, &compared)
    };
    // A file on standard output stays free of everything else.
    if written().any(|path| is_standard(path)) {
        eprint!("{report}");
    } else {
        print(&report)?;
    }
    Ok(End::Fine)
}

/// Refuses to write a file that is read, or one file twice.
fn nothing_overwritten(options: &Options) -> Result<(), Failure> {
    let read = [("the specification", &options.spec), ("--log", &options.log)];
    let mut taken: Vec<(&str, PathBuf)> =
        read.into_iter().filter(|(_, path)| !is_standard(path)).map(|(role, path)| (role, place(path))).collect();
    for (role, path) in [("--out", &options.out), ("--plot", &options.plot)] {
        let Some(path) = path.as_ref().filter(|path| !is_standard(path)) else { continue };
        let place = place(path);
        if let Some((other, _)) = taken.iter().find(|(_, there)| *there == place) {
            return Err(Failure::Misused(format!("{role} would overwrite {}, which is {other}", path.display())));
        }
        taken.push((role, place));
    }
    Ok(())
}

/// A path that is the same for the same file, as far as it exists.
fn place(path: &Path) -> PathBuf {
    let beside = || {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Some(folder.canonicalize().ok()?.join(path.file_name()?))
    };
    path.canonicalize().ok().or_else(beside).unwrap_or_else(|| path.to_owned())
}

/// The recording's bytes and its name in messages.
fn open(path: &PathBuf) -> Result<(Box<dyn Read>, String), Failure> {
    let name = path.display().to_string();
    if name == "-" {
        return Ok((Box::new(io::stdin()), "standard input".into()));
    }
    let file = File::open(path).map_err(|error| Failure::Wrong(format!("cannot read {name}: {error}")))?;
    Ok((Box::new(file), name))
}

/// Which columns of the recording are read, and as what.
struct Columns {
    names: Vec<String>,
    timed: bool,
    outputs: usize,
    inputs: usize,
    /// Per state: its place among the references.
    references: Vec<Option<usize>>,
}

impl Columns {
    fn find(plant: &Plant, options: &Options, there: &[String]) -> Result<Self, Failure> {
        let renamed = |name: &str| {
            let found = options.map.iter().find(|(from, _)| from == name);
            found.map_or_else(|| name.to_owned(), |(_, column)| column.clone())
        };
        let known = |name: &str| {
            let mut labels = plant.outputs.iter().map(|o| &o.label).chain(plant.inputs.iter().map(|i| &i.label));
            name == "t" || labels.any(|label| label.name == name)
        };
        if let Some((name, _)) = options.map.iter().find(|(name, _)| !known(name)) {
            return Err(Failure::Misused(format!(
                "--map: `{name}` is neither an output nor an input of the specification, nor `t`"
            )));
        }
        if let Some((name, _)) =
            options.reference.iter().find(|(name, _)| plant.states.iter().all(|s| s.label.name != *name))
        {
            return Err(Failure::Misused(format!("--reference: `{name}` is not a state of the specification")));
        }
        // A time that was named with --map must be there; one that was not may be absent.
        let time = renamed("t");
        let timed = time != "t" || there.contains(&time);
        let mut names: Vec<String> = if timed { vec![time] } else { Vec::new() };
        names.extend(plant.outputs.iter().map(|o| renamed(&o.label.name)));
        names.extend(plant.inputs.iter().map(|u| renamed(&u.label.name)));
        let mut references = Vec::new();
        for state in &plant.states {
            let given = options.reference.iter().find(|(name, _)| *name == state.label.name).map(|(_, column)| column);
            let column = given.or_else(|| there.iter().find(|column| **column == state.label.name));
            references.push(column.map(|column| {
                names.push(column.clone());
                names.len() - 1
            }));
        }
        Ok(Self { names, timed, outputs: plant.outputs.len(), inputs: plant.inputs.len(), references })
    }

    fn row(&self, cells: &[f64]) -> Row {
        let first = usize::from(self.timed);
        let (outputs, rest) = cells[first..].split_at(self.outputs);
        let reference = |place: &Option<usize>| place.map_or(f64::NAN, |place| cells[place]);
        Row {
            t: self.timed.then(|| cells[0]),
            outputs: outputs.to_vec(),
            inputs: rest[..self.inputs].to_vec(),
            references: self.references.iter().map(reference).collect(),
        }
    }

    /// Per state: whether it is compared.
    fn compared(&self) -> Vec<bool> {
        self.references.iter().map(Option::is_some).collect()
    }
}

/// `EST.csv` under way: written beside its place, moved there when whole.
struct Estimate {
    path: PathBuf,
    /// Beside its place; `None` for standard output.
    part: Option<PathBuf>,
    file: BufWriter<Box<dyn Write>>,
    line: String,
    single: bool,
}

impl Estimate {
    fn create(path: &Path, program: &Program) -> Result<Self, Failure> {
        let part = (!is_standard(path)).then(|| {
            let mut name = path.file_name().unwrap_or_default().to_owned();
            name.push(".part");
            path.with_file_name(name)
        });
        let file: Box<dyn Write> = match &part {
            Some(part) => Box::new(File::create(part).map_err(|error| unwritable(part, &error))?),
            None => Box::new(io::stdout()),
        };
        let names: Vec<&str> = program.estimates.iter().map(|(field, _)| field.name.as_str()).collect();
        let line = format!("t,{},status\n", names.join(","));
        let mut estimate = Self {
            path: path.to_owned(),
            part,
            file: BufWriter::new(file),
            line,
            single: program.scalar == Scalar::F32,
        };
        estimate.flush_line()?;
        Ok(estimate)
    }

    #[expect(clippy::cast_possible_truncation, reason = "an f32 program's estimates are singles, widened")]
    fn write(&mut self, sample: &Sample) -> Result<(), Failure> {
        let _ = write!(self.line, "{}", sample.t);
        for value in &sample.estimate {
            let _ = if self.single { write!(self.line, ",{}", *value as f32) } else { write!(self.line, ",{value}") };
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

    fn finish(mut self) -> Result<(), Failure> {
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

fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    if is_standard(path) {
        return print(text);
    }
    deadbeat_codegen::write_whole(path, text).map_err(|error| unwritable(path, &error))
}

fn unwritable(path: &Path, error: &io::Error) -> Failure {
    Failure::Wrong(format!("cannot write {}: {error}", path.display()))
}

/// Rows so far, on a terminal only.
struct Progress {
    terminal: bool,
    shown: Option<Instant>,
}

impl Progress {
    fn new() -> Self {
        Self { terminal: io::stderr().is_terminal(), shown: None }
    }

    fn show(&mut self, rows: u64) {
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

fn json_report(plant: &Plant, replay: &Replay, compared: &[bool]) -> String {
    let mut errors = Map::new();
    for ((state, error), _) in plant.states.iter().zip(&replay.errors).zip(compared).filter(|(_, compared)| **compared)
    {
        errors.insert(state.label.name.clone(), json!({ "rms": error.rms(), "max": error.max }));
    }
    let report = json!({ "rows": replay.rows, "converged_rows": replay.converged_rows, "coasting_rows": replay.coasting_rows, "errors": Value::Object(errors) });
    format!("{report:#}\n")
}

fn text_report(generated: &Generated, replay: &Replay, compared: &[bool]) -> String {
    let plant = &generated.plant;
    let (rows, converged) = (replay.rows, replay.converged_rows);
    let from = replay.converged_from.map_or_else(|| "from none".to_owned(), |call| format!("from call {call}"));
    let coasting = match replay.coasting_rows {
        0 => String::new(),
        coasting => format!(", {coasting} of these coasting"),
    };
    let mut text = format!(
        "{}: {}\n{rows} rows, {converged} of them converged ({from}){coasting}\n",
        plant.name, generated.design.summary
    );
    if !replay.timed() {
        let h = plant.sample_time_s();
        let _ = writeln!(text, "the recording has no column `t`: its rows are taken to be {h} s apart");
    }
    if replay.left_out > 0 {
        let _ =
            writeln!(text, "{} samples that the recording's time leaves out were treated as missing", replay.left_out);
    }
    if !compared.contains(&true) {
        text += "no column is named like a state, and no --reference was given: nothing to compare\n";
        return text;
    }
    let _ = writeln!(text, "\n{:<16} {:>12} {:>12} {:>10}  unit", "error of", "RMS", "maximum", "rows");
    for ((state, errors), _) in plant.states.iter().zip(&replay.errors).zip(compared).filter(|(_, compared)| **compared)
    {
        let (rms, max) = errors.shown();
        let _ =
            writeln!(text, "{:<16} {rms:>12} {max:>12} {:>10}  {}", state.label.name, errors.rows, state.label.unit);
    }
    text
}
