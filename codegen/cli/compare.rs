//! `deadbeat compare`: recordings through several steps each, and what the estimates are worth beside each other.
//!
//! In go specifications, a recording and the columns to compare with; out comes a table with a row per specification.
//! All are scored over the same rows, those on which every one of them has converged. Series are kept for that: 8 bytes
//! a row for the time, and for each specification and each reference.

mod contest;
mod figure;
mod group;
mod report;
mod score;
mod track;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use deadbeat_codegen::Settings;

use self::contest::Contest;
use self::group::Group;
use super::columns::Signals;
use super::files::{is_standard, nothing_overwritten, write_text};
use super::{End, Failure, ScalarWord, one_standard_input, print, settings};

/// Arguments of `deadbeat compare`.
#[derive(Args)]
pub struct Options {
    /// Specifications; `-` is standard input
    #[arg(required_unless_present = "table")]
    specs: Vec<PathBuf>,
    /// The recording, with a header row; `-` is standard input
    #[arg(long, value_name = "IN.csv", required_unless_present = "table")]
    log: Option<PathBuf>,
    /// The recording that the references are in, with a column `t` of its own; straight lines between its rows
    #[arg(long, value_name = "REF.csv")]
    reference_log: Option<PathBuf>,
    /// Draws all estimates with the reference, and their errors; `-` is standard output
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,
    /// Instead of all that, a TOML file of recordings with their specifications and references: a table for each
    #[arg(long, value_name = "TABLE.toml", conflicts_with_all = ["specs", "log", "reference_log", "plot", "map", "reference", "age"])]
    table: Option<PathBuf>,
    #[command(flatten)]
    signals: Signals,
    /// Text for people, JSON for machines, or Markdown for a page
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// The float type, instead of the files'
    #[arg(long, value_enum)]
    scalar: Option<ScalarWord>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    Text,
    Json,
    Markdown,
}

/// Replays recordings through several steps.
pub fn compare(options: &Options) -> Result<End, Failure> {
    let settings = settings(options.scalar);
    if let Some(table) = &options.table {
        return tables(&group::read(table)?, settings, options.format);
    }
    let group = Group {
        title: String::new(),
        specs: options.specs.clone(),
        log: options.log.clone().unwrap_or_default(),
        reference_log: options.reference_log.clone(),
        signals: options.signals.clone(),
    };
    let plot = options.plot.as_deref();
    one_standard_input(group.read().map(|(_, path)| path))?;
    let read: Vec<(&str, &Path)> = group.read().map(|(role, path)| (role, path.as_path())).collect();
    nothing_overwritten(&read, &plot.map(|path| ("--plot", path)).into_iter().collect::<Vec<_>>())?;
    let Some(contest) = Contest::hold(&group, settings)? else { return Ok(End::Wrong) };
    let report = match options.format {
        Format::Text => report::text(&contest),
        Format::Json => format!("{:#}\n", report::json(&contest)),
        Format::Markdown => report::markdown(&contest),
    };
    if let Some(path) = plot {
        write_text(path, &figure::figure(&contest).to_string())?;
    }
    // A figure on standard output stays free of everything else.
    if plot.is_some_and(is_standard) {
        eprint!("{report}");
    } else {
        print(&report)?;
    }
    Ok(End::Fine)
}

/// A table for each group of a file.
fn tables(groups: &[Group], settings: Settings, format: Format) -> Result<End, Failure> {
    let mut contests = Vec::new();
    for group in groups {
        let Some(contest) = Contest::hold(group, settings)? else { return Ok(End::Wrong) };
        contests.push(contest);
    }
    let joined = |report: fn(&Contest) -> String| contests.iter().map(report).collect::<Vec<_>>().join("\n");
    print(&match format {
        Format::Text => joined(report::text),
        Format::Json => {
            let all: Vec<_> = contests.iter().map(report::json).collect();
            format!("{:#}\n", serde_json::json!({ "recordings": all }))
        }
        Format::Markdown => joined(report::markdown),
    })?;
    Ok(End::Fine)
}
