//! `deadbeat run`: a recording in, errors, estimate and figure out.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use deadbeat_codegen::figure::Curves;
use deadbeat_codegen::replay::{Compared, Interface, Replay, Verdict};
use deadbeat_codegen::{Generated, Generator};

use super::estimate::Estimate;
use super::files::{is_standard, nothing_overwritten, open, write_text};
use super::progress::{Progress, alive};
use super::signals::Signals;
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
    let generated = match alive(&read_spec(&options.spec, options.common.settings())?, Generator::design) {
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
    let signals = options.signals.given();
    // Wrong arguments are said before files are opened.
    let interface = Interface::of(generated);
    signals.check(&[&interface])?;
    signals.check_references(&interface)?;
    let mut replay = Replay::new(generated, open(&options.log)?, &signals)?;

    let mut curves = Curves::new(&replay);
    let create = |path| Estimate::create(path, &interface, generated.plant.scalar);
    let mut estimate = options.out.as_deref().map(create).transpose()?;
    let mut progress = Progress::new();
    for (row, step) in (1..).zip(replay.by_ref()) {
        let step = step?;
        curves.add(&step);
        if let Some(estimate) = &mut estimate {
            estimate.write(&interface, &step.sample)?;
        }
        progress.show(row);
    }
    drop(progress);
    let verdict = replay.verdict();
    if let Some(path) = &options.plot {
        write_text(path, &curves.figure(&verdict).to_string())?;
    }
    if let Some(estimate) = estimate {
        estimate.finish()?;
    }
    Ok(if options.common.json() { format!("{:#}\n", verdict.to_json()) } else { text_report(generated, &verdict) })
}

fn text_report(generated: &Generated, verdict: &Verdict) -> String {
    let plant = &generated.plant;
    let (rows, converged) = (verdict.rows, verdict.converged_rows);
    let from = verdict.converged_from.map_or_else(|| "from none".to_owned(), |call| format!("from call {call}"));
    let coasting = match verdict.coasting_rows {
        0 => String::new(),
        coasting => format!(", {coasting} of these coasting"),
    };
    let mut text = format!(
        "{}: {}\n{rows} rows, {converged} of them converged ({from}){coasting}\n",
        plant.name, generated.design.summary
    );
    for remark in &verdict.remarks {
        let _ = writeln!(text, "{remark}");
    }
    for residual in &verdict.residuals {
        let _ = writeln!(text, "{}", residual.shown());
    }
    if verdict.compared.is_empty() {
        text += "no column is named like a state, and no --reference was given: nothing to compare\n";
        return text;
    }
    let _ = writeln!(text, "\n{:<16} {:>12} {:>12} {:>10}  unit", "error of", "RMS", "maximum", "rows");
    for Compared { answer, errors } in &verdict.compared {
        let (rms, max) = errors.shown();
        let _ = writeln!(text, "{:<16} {rms:>12} {max:>12} {:>10}  {}", answer.name, errors.rows, answer.unit);
    }
    for line in verdict.compared.iter().filter_map(|it| it.beyond(&generated.design)) {
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}
