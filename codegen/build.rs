//! The build script's door: `deadbeat_codegen::build("specs/motor.toml")`, and [`Build`] for all that can be said.
//!
//! Knows the calls of a generator, the environment of a build script. Never knows a design from the inside.

mod pattern;

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::path::{Path, PathBuf};

use crate::diagnostic::codes;
use crate::emit::Door;
use crate::output::{Language, Output};
use crate::program::Scalar;
use crate::{Generated, Generator, Report, Settings};

/// Generates the observer of a specification into `OUT_DIR` as `<name>.rs`, for one `include!`.
///
/// To be called from a build script: tells cargo to run it again when the specification changes.
/// A mistake in the specification is printed with its place, and ends the build. It is the shortest
/// use of [`Build`].
pub fn build(spec: impl AsRef<Path>) {
    if let Err(report) = Build::new().spec(spec).run() {
        eprint!("{}", report.render(false));
        std::process::exit(1);
    }
}

/// What a build script asks for: specifications, languages, float type and folder, as `deadbeat generate` takes them.
///
/// ```no_run
/// use deadbeat_codegen::program::Scalar;
/// use deadbeat_codegen::{Build, Language};
///
/// let built = Build::new().specs("specs/*.toml").scalar(Scalar::F64).language(Language::C).out_dir("firmware").run();
/// let files = built.unwrap_or_else(|report| {
///     eprint!("{}", report.render(false));
///     std::process::exit(1)
/// });
/// ```
///
/// Paths are relative to the current folder, which for a build script is that of its `Cargo.toml`. What stays with the
/// command line: specifications on standard input, which a build script does not have, JSON, and `verify`, since a
/// build makes its files anew.
#[derive(Clone, Debug, Default)]
#[must_use = "nothing is generated before `run`"]
pub struct Build {
    wanted: Vec<Wanted>,
    settings: Settings,
    languages: Vec<Language>,
    folder: Option<PathBuf>,
}

/// Specifications, in the order in which they were asked for.
#[derive(Clone, Debug)]
enum Wanted {
    Spec(PathBuf),
    Pattern(PathBuf),
}

impl Build {
    /// Asks for nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a specification.
    pub fn spec(mut self, path: impl AsRef<Path>) -> Self {
        self.wanted.push(Wanted::Spec(path.as_ref().to_owned()));
        self
    }

    /// Adds all files of a pattern, by name: each `*` in its last part stands for any characters, but for a dot in
    /// front. A folder stands for `*.toml` in it.
    ///
    /// At least one file must be there. One that was asked for already, however it was written, is taken once.
    pub fn specs(mut self, pattern: impl AsRef<Path>) -> Self {
        self.wanted.push(Wanted::Pattern(pattern.as_ref().to_owned()));
        self
    }

    /// Sets the float type of all of them, instead of what each file's `[target]` says.
    pub fn scalar(mut self, scalar: Scalar) -> Self {
        self.settings.scalar = Some(scalar);
        self
    }

    /// Adds a language; Rust alone when none is named.
    ///
    /// A `.rs` within `OUT_DIR` is for `include!`; elsewhere it is the file of a module, as `deadbeat generate` makes
    /// it. The other languages' files are the same everywhere.
    pub fn language(mut self, language: Language) -> Self {
        self.languages.push(language);
        self
    }

    /// Sets the folder of the files, which is made where it is missing; `OUT_DIR` unless it is said.
    pub fn out_dir(mut self, folder: impl AsRef<Path>) -> Self {
        self.folder = Some(folder.as_ref().to_owned());
        self
    }

    /// Generates all files, or none: the paths of all of them, also of those that stood there already.
    ///
    /// Files that have not changed are not touched. In a build script cargo is told to run it again when a
    /// specification, or the folder of a pattern, changes, and shows warnings; elsewhere they go to standard error.
    ///
    /// # Errors
    /// Everything that is wrong with any of the specifications; nothing is written then. A file that cannot be read or
    /// written, a pattern that no file fits, two specifications of one name, no specification or folder at all.
    pub fn run(self) -> Result<Vec<PathBuf>, Report> {
        let folder = self.folder.clone().or_else(|| env::var_os("OUT_DIR").map(PathBuf::from)).ok_or_else(no_folder)?;
        let specs = self.specifications()?;
        let all = together(specs.iter().map(|spec| self.designed(spec)))?;
        one_file_each(&specs, &all)?;
        let is_included = env::var_os("OUT_DIR").is_some_and(|out| folder.starts_with(out));
        let door = if is_included { Door::Include } else { Door::File };
        let languages = if self.languages.is_empty() { &[Language::Rust] } else { &self.languages[..] };
        let mut paths = vec![];
        for (generator, generated) in &all {
            warn(&generated.report);
            let output = Output::through(door, generated, generator.source()).only(languages);
            output.write_to(&folder).map_err(|error| {
                let (folder, help) = (shown(&folder), "name a folder that can be written by `.out_dir(…)`");
                Report::without_place(&folder, codes::FILE, format!("cannot write into `{folder}`: {error}"), help)
            })?;
            paths.extend(output.files().iter().map(|file| folder.join(&file.name)));
        }
        Ok(paths)
    }

    /// The files that were asked for, each once.
    fn specifications(&self) -> Result<Vec<PathBuf>, Report> {
        let found = together(self.wanted.iter().map(|wanted| match wanted {
            Wanted::Spec(path) => {
                rerun_if_changed(path);
                Ok(vec![path.clone()])
            }
            Wanted::Pattern(path) => {
                let path = of_folder(path);
                rerun_if_changed(pattern::folder(&path));
                let files = pattern::files(&path)?;
                for file in &files {
                    rerun_if_changed(file);
                }
                Ok(files)
            }
        }))?;
        let once = once(found.into_iter().flatten());
        let nothing = || {
            let message = "no specification is asked for".to_owned();
            Report::without_place("", codes::REQUEST, message, "name one by `.spec(\"motor.toml\")`")
        };
        if once.is_empty() { Err(nothing()) } else { Ok(once) }
    }

    /// Everything between a specification and its files.
    fn designed(&self, spec: &Path) -> Result<(Generator, Generated), Report> {
        let name = shown(spec);
        let generator = Generator::read(std::fs::read(spec), &name)?.with(self.settings);
        let generated = generator.design()?;
        Ok((generator, generated))
    }
}

/// The files that paths and patterns stand for, each once, as the arguments of `deadbeat generate` do: each `*` in the last
/// part of a path stands for any characters, and a folder for `*.toml` in it.
///
/// # Errors
/// A pattern that no file fits, or whose folder cannot be read. Whether a path without `*` can be read is not looked at.
pub fn specifications(named: &[PathBuf]) -> Result<Vec<PathBuf>, Report> {
    let found = together(named.iter().map(|path| {
        let is_pattern = !path.exists() && path.file_name().is_some_and(|name| name.to_string_lossy().contains('*'));
        if path.is_dir() || is_pattern { pattern::files(&of_folder(path)) } else { Ok(vec![path.clone()]) }
    }))?;
    Ok(once(found.into_iter().flatten()))
}

/// A folder's specifications as a pattern; other paths as they are.
fn of_folder(path: &Path) -> PathBuf {
    if path.is_dir() { path.join("*.toml") } else { path.to_owned() }
}

/// Each file once, as it was written first: `./a.toml` and a link to it are `a.toml`.
fn once(paths: impl Iterator<Item = PathBuf>) -> Vec<PathBuf> {
    let mut places = BTreeSet::new();
    // What is not there is itself, and said when it is read.
    paths.filter(|path| places.insert(path.canonicalize().unwrap_or_else(|_| path.clone()))).collect()
}

/// All results, or all reports as one.
fn together<T>(results: impl Iterator<Item = Result<T, Report>>) -> Result<Vec<T>, Report> {
    let (mut all, mut reports) = (vec![], vec![]);
    for result in results {
        match result {
            Ok(one) => all.push(one),
            Err(report) => reports.push(report),
        }
    }
    Report::all(reports).map_or(Ok(all), Err)
}

/// Refuses two specifications that would write the same files.
fn one_file_each(specs: &[PathBuf], all: &[(Generator, Generated)]) -> Result<(), Report> {
    let mut first = BTreeMap::new();
    together(specs.iter().zip(all).map(|(spec, (_, generated))| {
        let name = &generated.program.name;
        let Some(other) = first.insert(name, spec) else { return Ok(()) };
        let message = format!("`{}` and `{}` are both named `{name}`", shown(other), shown(spec));
        let help = "give one of them another `name`: both would write the same files";
        Err(Report::without_place(&shown(spec), codes::REQUEST, message, help))
    }))
    .map(drop)
}

fn no_folder() -> Report {
    let message = "there is no folder to write into: `OUT_DIR` is not set".to_owned();
    Report::without_place("", codes::REQUEST, message, "call it from a build script, or name one by `.out_dir(…)`")
}

/// A path in messages and in generated files: with forward slashes on every system.
fn shown(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// Whether cargo listens to what is printed: of all programs that have `OUT_DIR`, only build scripts have `HOST`.
fn in_build_script() -> bool {
    env::var_os("OUT_DIR").is_some() && env::var_os("HOST").is_some()
}

fn rerun_if_changed(path: &Path) {
    if in_build_script() {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

/// Shows warnings where they are seen.
fn warn(report: &Report) {
    for line in report.render(false).lines().filter(|line| !line.is_empty()) {
        if in_build_script() {
            println!("cargo::warning={line}");
        } else {
            eprintln!("{line}");
        }
    }
}
