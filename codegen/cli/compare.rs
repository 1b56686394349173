//! `deadbeat compare`: recordings through several steps each, as a table with a row per specification.

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use deadbeat_codegen::replay::compare::{Contest, Entrant, Group, Track, group, report};
use deadbeat_codegen::{Generator, Settings, figure};

use super::files::{is_standard, nothing_overwritten, open, write_text};
use super::progress::{Progress, alive};
use super::signals::Signals;
use super::{End, Failure, ScalarWord, one_standard_input, print, read_spec, settings, show};

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
    #[arg(long, value_name = "TABLE.toml", conflicts_with_all = ["specs", "log", "reference_log", "plot", "map", "reference", "age", "time_unit"])]
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
        return tables(&groups(table)?, settings, options.format);
    }
    let group = Group {
        title: String::new(),
        specs: options.specs.clone(),
        log: options.log.clone().unwrap_or_default(),
        reference_log: options.reference_log.clone(),
        signals: options.signals.given(),
    };
    let plot = options.plot.as_deref();
    let read = read(&group);
    one_standard_input(read.iter().map(|(_, path)| *path))?;
    let read: Vec<(&str, &Path)> = read.into_iter().map(|(role, path)| (role, path.as_path())).collect();
    nothing_overwritten(&read, &plot.map(|path| ("--plot", path)).into_iter().collect::<Vec<_>>())?;
    let Some(contest) = held(&group, settings)? else { return Ok(End::Wrong) };
    let report = match options.format {
        Format::Text => report::text(&contest),
        Format::Json => format!("{:#}\n", report::json(&contest)),
        Format::Markdown => report::markdown(&contest),
    };
    if let Some(path) = plot {
        write_text(path, &figure::of_contest(&contest).to_string())?;
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
        let Some(contest) = held(group, settings)? else { return Ok(End::Wrong) };
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

/// Reads a file of groups.
fn groups(path: &Path) -> Result<Vec<Group>, Failure> {
    let name = path.display();
    let text = fs::read_to_string(path).map_err(|error| Failure::Wrong(format!("cannot read {name}: {error}")))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    group::parse(&text, folder).map_err(|error| Failure::Wrong(format!("{name}: {error}")))
}

/// The files that a group reads, with their roles in messages.
fn read(group: &Group) -> Vec<(&'static str, &PathBuf)> {
    let specs = group.specs.iter().map(|path| ("a specification", path));
    let references = group.reference_log.iter().map(|path| ("--reference-log", path));
    specs.chain([("--log", &group.log)]).chain(references).collect()
}

/// Replays a group's recording; `None` when a specification is wrong, which has been said.
fn held(group: &Group, settings: Settings) -> Result<Option<Contest>, Failure> {
    let Some(entrants) = entrants(group, settings)? else { return Ok(None) };
    // Wrong arguments are said before files are opened.
    let interfaces: Vec<_> = entrants.iter().map(Entrant::interface).collect();
    group.signals.check(&interfaces)?;
    let columns: Vec<&str> = group.signals.reference.iter().map(|(_, column)| column.as_str()).collect();
    let tracks = |path: &Path| -> Result<Vec<Track>, Failure> {
        Ok(Track::read(open(path)?, &columns, group.signals.time_unit)?)
    };
    let elsewhere = group.reference_log.as_deref().map(tracks).transpose()?;
    let mut progress = Progress::new();
    let log = open(&group.log)?;
    let mut contest =
        Contest::hold(entrants, &group.signals, log, elsewhere.as_deref(), &mut |rows| progress.show(rows))?;
    contest.title.clone_from(&group.title);
    Ok(Some(contest))
}

/// Designs every specification; `None` when one is wrong.
fn entrants(group: &Group, settings: Settings) -> Result<Option<Vec<Entrant>>, Failure> {
    if group.signals.reference.is_empty() {
        return Err(Failure::Misused("name what to compare with: --reference STATE=COLUMN".into()));
    }
    if group.specs.is_empty() {
        return Err(Failure::Misused(format!("no specification is named for {}", group.log.display())));
    }
    let mut all = Vec::new();
    let mut wrong = false;
    for path in &group.specs {
        match alive(&read_spec(path, settings)?, Generator::design) {
            Ok(generated) => {
                show(&generated.report);
                all.push(Entrant::new(&path.display().to_string(), generated, &group.signals)?);
            }
            Err(report) => {
                show(&report);
                wrong = true;
            }
        }
    }
    Ok((!wrong).then_some(all))
}
