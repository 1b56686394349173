//! The command line: reads arguments and files, calls the generator, writes what it gave.
//!
//! Text for people on standard output, diagnostics on standard error. Exit 0 fine, 1 the
//! specification or the data is wrong, 2 what is on disk differs, 3 wrong usage.

mod commands;
mod compare;
mod estimate;
mod files;
mod list;
mod progress;
mod run;
mod signals;

use std::fs;
use std::io::{self, IsTerminal as _, Read as _, Write as _};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand, ValueEnum};
use deadbeat_codegen::{Generator, Language, Report, Settings};

/// Finite-time state observers in Rust and C from a plant specification.
#[derive(Parser)]
#[command(name = "deadbeat", version, about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Everything up to the design: prints errors and warnings, writes nothing
    Check {
        /// Specifications, patterns such as 'specs/*.toml', folders of them; `-` is standard input
        #[arg(required = true)]
        specs: Vec<PathBuf>,
        #[command(flatten)]
        common: Common,
    },
    /// The design: constants, certificate, cost
    Design {
        /// A specification; `-` is standard input
        spec: PathBuf,
        /// Instead of it, the gains at this step from the first sample on, the prescribed time included
        #[arg(long, value_name = "STEP")]
        at: Option<usize>,
        #[command(flatten)]
        common: Common,
    },
    /// Writes the generated files, only those that changed
    Generate {
        /// Specifications, patterns such as 'specs/*.toml', folders of them; `-` is standard input
        #[arg(required = true)]
        specs: Vec<PathBuf>,
        #[command(flatten)]
        target: Target,
        #[command(flatten)]
        common: Common,
    },
    /// Compares a folder with what would be generated; exit 2 when stale, missing or left over
    Verify {
        /// Specifications, patterns such as 'specs/*.toml', folders of them; `-` is standard input
        #[arg(required = true)]
        specs: Vec<PathBuf>,
        #[command(flatten)]
        target: Target,
        #[command(flatten)]
        common: Common,
    },
    /// Replays a recording through the generated step and reports the errors
    Run(run::Options),
    /// Replays recordings through several steps each: a table of errors, lags, deadlines, memory and operations
    Compare(compare::Options),
    /// Methods with their keys and realisations, and targets
    List {
        /// A method, for its page
        method: Option<String>,
        #[command(flatten)]
        common: Common,
    },
}

/// Where files go, and which.
#[derive(Args)]
struct Target {
    /// The folder; for `generate`, `-` is standard output, which takes one file
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// The language, may be repeated; Rust and C by default
    #[arg(long)]
    lang: Vec<Lang>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Lang {
    Rust,
    C,
    /// The Program as text
    Step,
}

impl Target {
    fn languages(&self) -> Vec<Language> {
        let language = |lang: &Lang| match lang {
            Lang::Rust => Language::Rust,
            Lang::C => Language::C,
            Lang::Step => Language::Step,
        };
        if self.lang.is_empty() { vec![Language::Rust, Language::C] } else { self.lang.iter().map(language).collect() }
    }
}

/// What every command takes.
#[derive(Args)]
struct Common {
    /// Text for people, or JSON for machines
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// The float type, instead of the file's
    #[arg(long, value_enum)]
    scalar: Option<ScalarWord>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    Text,
    Json,
}

#[derive(Clone, Copy, ValueEnum)]
enum ScalarWord {
    F32,
    F64,
}

impl Common {
    fn settings(&self) -> Settings {
        settings(self.scalar)
    }

    fn json(&self) -> bool {
        self.format == Format::Json
    }
}

/// The settings that the float type of the command line stands for.
fn settings(scalar: Option<ScalarWord>) -> Settings {
    let scalar = scalar.map(|word| match word {
        ScalarWord::F32 => deadbeat_codegen::program::Scalar::F32,
        ScalarWord::F64 => deadbeat_codegen::program::Scalar::F64,
    });
    Settings { scalar }
}

/// How a command ends.
enum End {
    /// Exit 0.
    Fine,
    /// Exit 1, already explained.
    Wrong,
    /// Exit 2.
    Differs,
}

/// What stopped a command; the text is for standard error.
enum Failure {
    /// Exit 1: the specification, the data or the disk.
    Wrong(String),
    /// Exit 1: mistakes with their places.
    Reported(Report),
    /// Exit 3: the arguments, which only this specification or this build shows to be wrong.
    Misused(String),
}

/// Runs the program.
pub fn main() -> ExitCode {
    let ended = match Arguments::try_parse() {
        Ok(arguments) => dispatch(&arguments.command),
        Err(error) if error.use_stderr() => {
            let _ = error.print();
            return ExitCode::from(3);
        }
        Err(help) => printed(help.print()).map(|()| End::Fine),
    };
    match ended {
        Ok(End::Fine) => ExitCode::SUCCESS,
        Ok(End::Wrong) => ExitCode::from(1),
        Ok(End::Differs) => ExitCode::from(2),
        Err(Failure::Wrong(text)) => {
            eprintln!("error: {text}");
            ExitCode::from(1)
        }
        Err(Failure::Reported(report)) => {
            show(&report);
            ExitCode::from(1)
        }
        Err(Failure::Misused(text)) => {
            eprintln!("error: {text}");
            ExitCode::from(3)
        }
    }
}

fn dispatch(command: &Command) -> Result<End, Failure> {
    match command {
        Command::Check { specs, common } => commands::check(specs, common),
        Command::Design { spec, at: Some(step), common } => commands::at(spec, *step, common),
        Command::Design { spec, at: None, common } => commands::design(spec, common),
        Command::Generate { specs, target, common } => commands::generate(specs, target, common),
        Command::Verify { specs, target, common } => commands::verify(specs, target, common),
        Command::Run(options) => run::run(options),
        Command::Compare(options) => compare::compare(options),
        Command::List { method, common } => list::list(method.as_deref(), common),
    }
}

/// Refuses to read standard input twice: the second reader would find nothing.
fn one_standard_input<'a>(paths: impl IntoIterator<Item = &'a PathBuf>) -> Result<(), Failure> {
    let twice = paths.into_iter().filter(|path| path.as_os_str() == "-").nth(1).is_some();
    if twice { Err(Failure::Misused("standard input can stand for one file only".into())) } else { Ok(()) }
}

/// Reads a specification; its name in messages is the path as given, with forward slashes.
fn read_spec(path: &PathBuf, settings: Settings) -> Result<Generator, Report> {
    let name = path.to_string_lossy().replace('\\', "/");
    let bytes = if name == "-" {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        fs::read(path)
    };
    let name = if name == "-" { "standard input" } else { &name };
    Ok(Generator::read(bytes, name)?.with(settings))
}

/// A report that ends a command.
impl From<Report> for Failure {
    fn from(report: Report) -> Self {
        Self::Reported(report)
    }
}

/// Shows a report on standard error, with colours on a terminal.
fn show(report: &Report) {
    eprint!("{}", report.render(io::stderr().is_terminal()));
}

/// Prints to standard output; a closed pipe is not an error.
fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout();
    printed(out.write_all(text.as_bytes()).and_then(|()| out.flush()))
}

/// How printing went: a reader that has seen enough is fine, a full disk is not.
fn printed(result: io::Result<()>) -> Result<(), Failure> {
    match result {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Wrong(format!("cannot write standard output: {error}")))
        }
        _ => Ok(()),
    }
}
