//! `deadbeat run`: a recording in, errors, estimate and figure out.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use deadbeat_codegen::Generated;
use serde_json::{Map, Value, json};

use super::columns::{Columns, Selection, Signals};
use super::estimate::Estimate;
use super::figure::Curves;
use super::files::{explained, is_standard, nothing_overwritten, open, write_text};
use super::interface::{Answer, Interface};
use super::progress::Progress;
use super::recording::Recording;
use super::replay::{Errors, Replay};
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
    #[command(flatten)]
    signals: Signals,
    #[command(flatten)]
    common: Common,
}

/// Replays a recording.
pub fn run(options: &Options) -> Result<End, Failure> {
    one_standard_input([&options.spec, &options.log])?;
    let given = [("--out", &options.out), ("--plot", &options.plot)];
    let written: Vec<(&str, &Path)> = given.iter().filter_map(|(role, path)| Some((*role, path.as_deref()?))).collect();
    if written.iter().filter(|(_, path)| is_standard(path)).count() > 1 {
        return Err(Failure::Misused("standard output can stand for one file only".into()));
    }
    nothing_overwritten(&[("the specification", &options.spec), ("--log", &options.log)], &written)?;
    let generated = match read_spec(&options.spec, options.common.settings())?.design() {
        Ok(generated) => generated,
        Err(report) => {
            show(&report);
            return Ok(End::Wrong);
        }
    };
    show(&generated.report);
    let report = replayed(options, &generated)?;
    // A file on standard output stays free of everything else.
    if written.iter().any(|(_, path)| is_standard(path)) {
        eprint!("{report}");
    } else {
        print(&report)?;
    }
    Ok(End::Fine)
}

/// Feeds the recording to the step, writes what is asked for, and returns the report.
fn replayed(options: &Options, generated: &Generated) -> Result<String, Failure> {
    let plant = &generated.plant;
    let interface = Interface::of(generated);
    options.signals.check(&[(plant, &interface)])?;
    options.signals.check_references(&interface)?;
    let (source, name) = open(&options.log)?;
    let mut recording = Recording::open(source, &name).map_err(|error| explained(&error))?;
    let mut selection = Selection::default();
    let there = recording.columns().to_vec();
    let mut columns = Columns::find(plant, &interface, &options.signals, &there, &mut selection, true)?;
    let width = selection.apply(&mut recording).map_err(|error| explained(&error))?;

    let compared = columns.compared();
    let mut replay = Replay::new(plant, &interface, &generated.program);
    let mut curves = Curves::new(generated, &interface, &compared);
    let create = |path| Estimate::create(path, &interface, plant.scalar);
    let mut estimate = options.out.as_deref().map(create).transpose()?;
    let mut progress = Progress::new();
    let mut cells = vec![0.0; width];
    while recording.next_row(&mut cells).map_err(|error| explained(&error))? {
        let row = columns.row(&cells, &recording)?;
        let line = recording.line();
        let sample = replay.feed(&row).map_err(|why| Failure::Wrong(format!("{name}:{line}: {why}")))?;
        curves.add(&row, &sample);
        if let Some(estimate) = &mut estimate {
            estimate.write(&interface, &sample)?;
        }
        progress.show(replay.rows);
    }
    drop(progress);
    if replay.rows == 0 {
        return Err(Failure::Wrong(format!("{name}: the recording has no rows")));
    }
    if let Some(path) = &options.plot {
        write_text(path, &curves.figure(generated, &replay).to_string())?;
    }
    if let Some(estimate) = estimate {
        estimate.finish()?;
    }
    let scores = interface.answers.iter().zip(&replay.errors).zip(&compared);
    let scores: Vec<Score> = scores.filter_map(|(score, compared)| compared.then_some(score)).collect();
    Ok(if options.common.json() {
        json_report(&replay, &columns, &scores)
    } else {
        text_report(generated, &replay, &columns, &scores)
    })
}

/// A field that was compared, and its errors.
type Score<'a> = (&'a Answer, &'a Errors);

fn json_report(replay: &Replay, columns: &Columns, scores: &[Score]) -> String {
    let mut errors = Map::new();
    for (answer, error) in scores {
        errors.insert(answer.name.clone(), json!({ "rms": error.rms(), "max": error.max }));
    }
    let mut report = json!({ "rows": replay.rows, "converged_rows": replay.converged_rows, "coasting_rows": replay.coasting_rows, "errors": Value::Object(errors) });
    if columns.negative_ages > 0 {
        report["negative_ages"] = json!(columns.negative_ages);
    }
    format!("{report:#}\n")
}

fn text_report(generated: &Generated, replay: &Replay, columns: &Columns, scores: &[Score]) -> String {
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
    text += &replay.remarks(columns.negative_ages);
    if scores.is_empty() {
        text += "no column is named like a state, and no --reference was given: nothing to compare\n";
        return text;
    }
    let _ = writeln!(text, "\n{:<16} {:>12} {:>12} {:>10}  unit", "error of", "RMS", "maximum", "rows");
    for (answer, errors) in scores {
        let (rms, max) = errors.shown();
        let _ = writeln!(text, "{:<16} {rms:>12} {max:>12} {:>10}  {}", answer.name, errors.rows, answer.unit);
    }
    text
}
