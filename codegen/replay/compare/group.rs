//! A recording with the specifications to be compared on it, as a file of such groups gives it.
//!
//! ```toml
//! [[recording]]
//! title = "A pendulum by hand"
//! log = "../data/hand.csv"              # paths are relative to this file
//! reference_log = "../data/truth.csv"   # only where the references are not in the recording
//! references = { dq = "dq_ref" }        # Signals::reference
//! map = { t = "t_sensor" }              # Signals::map
//! age = { y = "t_sensor" }              # Signals::age
//! specs = ["hand/window.toml", "hand/kalman.toml"]
//! ```

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::super::clock::TimeUnit;
use super::super::signals::Signals;

/// What is compared on one recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// May be empty.
    pub title: String,
    /// The specifications' files.
    pub specs: Vec<PathBuf>,
    /// The recording's file.
    pub log: PathBuf,
    /// The file with the references, where they are not in the recording.
    pub reference_log: Option<PathBuf>,
    /// What its columns mean, and what is compared with them.
    pub signals: Signals,
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
    time_unit: Option<String>,
    specs: Vec<PathBuf>,
}

/// Reads a file of groups, whose paths are relative to `folder`.
///
/// # Errors
/// When the text is not TOML or has keys that mean nothing; with the place in it.
pub fn parse(text: &str, folder: &Path) -> Result<Vec<Group>, String> {
    let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
    let pairs = |table: BTreeMap<String, String>| table.into_iter().collect();
    let group = |entry: Entry| {
        let unit = |word: &String| TimeUnit::named(word).ok_or_else(|| format!("`{word}` is no unit of time"));
        Ok(Group {
            title: entry.title,
            specs: entry.specs.iter().map(|spec| folder.join(spec)).collect(),
            log: folder.join(entry.log),
            reference_log: entry.reference_log.map(|log| folder.join(log)),
            signals: Signals {
                map: pairs(entry.map),
                reference: pairs(entry.references),
                age: pairs(entry.age),
                time_unit: entry.time_unit.as_ref().map(unit).transpose()?,
            },
        })
    };
    file.recording.into_iter().map(group).collect()
}
