//! The files of a specification: made in memory, all or none, written or compared on request.
//!
//! Knows what a specification became, paths. Never knows how anything in a file was computed.

pub mod header;
mod report;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::diagnostic::Source;
use crate::emit::{self, Door};
use crate::generated::Generated;
use crate::program::listing::listing;

/// What a file is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Language {
    /// `<name>.rs`.
    Rust,
    /// `<name>.h` and `<name>.c`.
    C,
    /// `<name>.step`: the Program, for readers and reviews.
    Step,
}

/// One generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Without a folder.
    pub name: String,
    /// What it is written in.
    pub language: Language,
    /// All of it.
    pub text: String,
}

/// The files of one specification.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    files: Vec<File>,
    inputs: Vec<String>,
}

/// How a folder differs from what would be generated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Difference {
    /// The file is not there.
    Missing(PathBuf),
    /// The file has another content.
    Stale {
        /// Where it is.
        path: PathBuf,
        /// What stands there.
        found: String,
        /// What should.
        wanted: String,
    },
    /// The file says that it was generated, but nothing generates it.
    LeftOver(PathBuf),
}

impl Output {
    /// Emits every language, Rust as a module's file.
    pub fn new(generated: &Generated, source: &Source) -> Self {
        Self::through(Door::File, generated, source)
    }

    /// Emits every language, Rust for `include!` within a module: what a build script writes and the macro expands to.
    pub fn included(generated: &Generated, source: &Source) -> Self {
        Self::through(Door::Include, generated, source)
    }

    /// Emits every language, Rust for its way into the user's crate.
    pub(crate) fn through(door: Door, generated: &Generated, source: &Source) -> Self {
        let program = &generated.program;
        let name = &program.name;
        let header = |language| header::header(generated, source, language);
        let file = |suffix: &str, language, text| File { name: format!("{name}.{suffix}"), language, text };
        let files = vec![
            file("rs", Language::Rust, emit::rust(program, &header(Language::Rust), door)),
            file("h", Language::C, emit::c_header(program, &header(Language::C))),
            file("c", Language::C, emit::c_source(program, &header(Language::C))),
            file("step", Language::Step, header::commented(&header(Language::Step), "#") + &listing(program)),
        ];
        Self { files, inputs: vec![source.name.to_string()] }
    }

    /// Only the files of some languages.
    #[must_use]
    pub fn only(mut self, languages: &[Language]) -> Self {
        self.files.retain(|file| languages.contains(&file.language));
        self
    }

    /// The files, in a fixed order.
    pub fn files(&self) -> &[File] {
        &self.files
    }

    /// What the files depend on: the names of the specifications.
    pub fn inputs(&self) -> &[String] {
        &self.inputs
    }

    /// Files of a folder that stand where one of these would, and do not say that they were generated.
    pub fn in_the_way(&self, folder: &Path) -> Vec<PathBuf> {
        let foreign =
            |path: &PathBuf| fs::read(path).is_ok_and(|found| !found.trim_ascii().is_empty() && !is_ours(&found));
        self.files.iter().map(|file| folder.join(&file.name)).filter(foreign).collect()
    }

    /// Writes the files whose content has changed; gives their paths.
    ///
    /// Each is written beside its place and then moved there, so that no reader sees half a file.
    ///
    /// # Errors
    /// Those of the disk; and where a file stands in the way that was not generated, which stays as it is.
    pub fn write_to(&self, folder: &Path) -> io::Result<Vec<PathBuf>> {
        if let Some(path) = self.in_the_way(folder).first() {
            let message = format!("{} was not generated, and is not overwritten", path.display());
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, message));
        }
        fs::create_dir_all(folder)?;
        let mut written = Vec::new();
        for file in &self.files {
            let path = folder.join(&file.name);
            if fs::read(&path).is_ok_and(|found| found == file.text.as_bytes()) {
                continue;
            }
            write_whole(&path, &file.text)?;
            written.push(path);
        }
        Ok(written)
    }

    /// Compares a folder with the files of several specifications; empty when it is up to date. Line ends do not count,
    /// nor does the fingerprint of the specification's text, which its comments change too.
    pub fn verify(outputs: &[Self], folder: &Path) -> io::Result<Vec<Difference>> {
        let mut differences = Vec::new();
        let mut wanted = BTreeSet::new();
        for file in outputs.iter().flat_map(|output| &output.files) {
            let path = folder.join(&file.name);
            match fs::read(&path) {
                Ok(found) => {
                    let found = String::from_utf8_lossy(&found).replace("\r\n", "\n");
                    if header::without_fingerprint(&found) != header::without_fingerprint(&file.text) {
                        let wanted = file.text.clone();
                        differences.push(Difference::Stale { path: path.clone(), found, wanted });
                    }
                }
                Err(error) if error.kind() == io::ErrorKind::NotFound => {
                    differences.push(Difference::Missing(path.clone()));
                }
                Err(error) => return Err(error),
            }
            wanted.insert(path);
        }
        differences.extend(left_over(folder, &wanted)?);
        Ok(differences)
    }
}

/// Files of the wanted languages that say they were generated, but are not wanted.
///
/// A file of another language may be the work of another call, and is none of this one's business.
fn left_over(folder: &Path, wanted: &BTreeSet<PathBuf>) -> io::Result<Vec<Difference>> {
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(error),
    };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.map(|e| e.path())).collect::<io::Result<_>>()?;
    paths.sort();
    let ours = |path: &PathBuf| {
        let known = wanted.iter().any(|wanted| wanted.extension() == path.extension());
        known && fs::read(path).is_ok_and(|text| is_ours(&text))
    };
    Ok(paths.into_iter().filter(|path| !wanted.contains(path) && ours(path)).map(Difference::LeftOver).collect())
}

/// Whether a file says that it was generated.
fn is_ours(text: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&text[..text.len().min(4_000)]);
    header::GENERATED.iter().any(|mark| head.contains(mark))
}

/// Writes a file beside its place and moves it there.
pub fn write_whole(path: &Path, text: &str) -> io::Result<()> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    let part = path.with_file_name(name);
    fs::write(&part, text)?;
    fs::rename(&part, path).inspect_err(|_| drop(fs::remove_file(&part)))
}
