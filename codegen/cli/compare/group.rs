//! A recording with the specifications to be compared on it, as the command line or a file of such groups gives it.
//!
//! ```toml
//! [[recording]]
//! title = "A pendulum by hand"
//! log = "../data/hand.csv"              # paths are relative to this file
//! reference_log = "../data/truth.csv"   # only where the references are not in the recording
//! references = { dq = "dq_ref" }        # --reference
//! map = { t = "t_sensor" }              # --map
//! age = { y = "t_sensor" }              # --age
//! specs = ["hand/window.toml", "hand/kalman.toml"]
//! ```

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::super::Failure;
use super::super::columns::Signals;

/// What is compared on one recording.
pub struct Group {
    /// May be empty.
    pub title: String,
    pub specs: Vec<PathBuf>,
    pub log: PathBuf,
    pub reference_log: Option<PathBuf>,
    pub signals: Signals,
}

impl Group {
    /// The files that are read, with their roles in messages.
    pub fn read(&self) -> impl Iterator<Item = (&'static str, &PathBuf)> {
        let specs = self.specs.iter().map(|path| ("a specification", path));
        let references = self.reference_log.iter().map(|path| ("--reference-log", path));
        specs.chain([("--log", &self.log)]).chain(references)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    recording: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    #[serde(default)]
    title: String,
    log: PathBuf,
    reference_log: Option<PathBuf>,
    references: BTreeMap<String, String>,
    #[serde(default)]
    map: BTreeMap<String, String>,
    #[serde(default)]
    age: BTreeMap<String, String>,
    specs: Vec<PathBuf>,
}

/// Reads a file of groups.
pub fn read(path: &Path) -> Result<Vec<Group>, Failure> {
    let name = path.display();
    let text = fs::read_to_string(path).map_err(|error| Failure::Wrong(format!("cannot read {name}: {error}")))?;
    let file: File = toml::from_str(&text).map_err(|error| Failure::Wrong(format!("{name}: {error}")))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let pairs = |table: BTreeMap<String, String>| table.into_iter().collect();
    let group = |entry: Entry| Group {
        title: entry.title,
        specs: entry.specs.iter().map(|spec| folder.join(spec)).collect(),
        log: folder.join(entry.log),
        reference_log: entry.reference_log.map(|log| folder.join(log)),
        signals: Signals { map: pairs(entry.map), reference: pairs(entry.references), age: pairs(entry.age) },
    };
    Ok(file.recording.into_iter().map(group).collect())
}
