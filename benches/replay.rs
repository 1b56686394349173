//! How long a replay and a generation take, and how much memory: figures, no verdict.
//!
//! `cargo bench --bench replay`; medians of repeated runs, one process.

#![allow(clippy::cast_precision_loss, reason = "figures for people")]

use std::fmt::Write as _;
use std::fs;
use std::io::{BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use deadbeat_codegen::Generator;
use deadbeat_codegen::program::interp::Interpreter;

/// The rows of the long recording.
const ROWS: usize = 1_000_000;
/// Repetitions behind a median.
const REPEATED: usize = 5;

fn main() {
    interpreter();
    command_line();
    corpus();
    long_windows();
}

fn specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("specs")
}

fn read(name: &str) -> String {
    fs::read_to_string(specs().join(name)).unwrap()
}

/// The median time of some runs.
fn median(repeated: usize, mut run: impl FnMut()) -> Duration {
    let mut times: Vec<Duration> = (0..repeated)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed()
        })
        .collect();
    times.sort();
    times[repeated / 2]
}

/// A motor's angle and voltage, near enough to one: what a step computes does not depend on them.
fn sample(row: usize) -> (f64, f64) {
    let t = row as f64 * 1e-3;
    ((1.3 * t).sin() + 0.1 * (17.0 * t).cos(), if (row / 250).is_multiple_of(2) { 4.0 } else { -3.0 })
}

/// A million steps of a window of 101 samples of a plant with three states.
fn interpreter() {
    println!("interpreter, dc_motor, window of 101 samples, 3 states, {ROWS} rows");
    for scalar in ["f32", "f64"] {
        let text = read("dc_motor.toml").replace("scalar = \"f32\"", &format!("scalar = \"{scalar}\""));
        let generated = Generator::new(&text, "dc_motor.toml").design().unwrap();
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = [0.0; 3];
        let time = median(REPEATED, || {
            for row in 0..ROWS {
                let (y, u) = sample(row);
                interpreter.step(&[y], &[u], &mut estimate);
            }
        });
        println!("  {scalar}: {:.3} s, {:.0} ns a row", time.as_secs_f64(), time.as_secs_f64() * 1e9 / ROWS as f64);
    }
}

/// `deadbeat run` with an estimate and a figure, and the most memory it had, for two lengths.
fn command_line() {
    let folder = std::env::temp_dir().join(format!("deadbeat-bench-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    println!("deadbeat run, dc_motor, with --out and --plot");
    let mut first = None;
    for rows in [ROWS / 10, ROWS] {
        let log = folder.join(format!("{rows}.csv"));
        write_recording(&log, rows);
        let mut peak = None;
        let time = median(3, || peak = run(&folder, &log));
        let peak = peak.map_or("not known".to_owned(), |kib| {
            let ratio = f64::from(kib) / f64::from(*first.get_or_insert(kib));
            format!("{:.1} MiB, {ratio:.2} of the shorter", f64::from(kib) / 1_024.0)
        });
        let csv = fs::metadata(&log).unwrap().len() as f64 / 1e6;
        println!("  {rows} rows ({csv:.1} MB): {:.3} s, most memory {peak}", time.as_secs_f64());
    }
    fs::remove_dir_all(&folder).unwrap();
}

fn write_recording(path: &Path, rows: usize) {
    let mut file = BufWriter::new(fs::File::create(path).unwrap());
    writeln!(file, "t,y,u").unwrap();
    for row in 0..rows {
        let (y, u) = sample(row);
        writeln!(file, "{:.3},{y:.6},{u}", row as f64 * 1e-3).unwrap();
    }
}

/// One run; the largest resident memory that was seen, in KiB, where the system tells.
fn run(folder: &Path, log: &Path) -> Option<u32> {
    let mut child = Command::new(env!("CARGO_BIN_EXE_deadbeat"))
        .arg("run")
        .arg(specs().join("dc_motor.toml"))
        .arg("--log")
        .arg(log)
        .arg("--out")
        .arg(folder.join("estimate.csv"))
        .arg("--plot")
        .arg(folder.join("figure.svg"))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut peak = None;
    loop {
        peak = high_water(&child).or(peak);
        match child.try_wait().unwrap() {
            Some(status) => {
                assert!(status.success());
                return peak;
            }
            None => std::thread::sleep(Duration::from_millis(1)),
        }
    }
}

/// The high water mark of the memory of a child that still runs.
fn high_water(child: &Child) -> Option<u32> {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches("kB").trim().parse().ok()
}

/// Generation of every specification of the corpus, all languages.
fn corpus() {
    println!("generation, all languages");
    let mut names: Vec<String> = fs::read_dir(specs())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| Path::new(name).extension().is_some_and(|e| e == "toml"))
        .collect();
    names.sort();
    let mut whole = Duration::ZERO;
    for name in names {
        let text = read(&name);
        let time = median(REPEATED, || drop(Generator::new(&text, &name).generate().unwrap()));
        whole += time;
        println!("  {name}: {:.1} ms", time.as_secs_f64() * 1e3);
    }
    println!("  the whole corpus: {:.1} ms", whole.as_secs_f64() * 1e3);
}

/// A chain of three masses, six states: how generation grows with the window.
fn long_windows() {
    println!("generation, six states, one output, one input");
    let mut text = "deadbeat = 1\nname = \"chain\"\n[states]\n".to_owned();
    for i in 1..=3 {
        let _ = writeln!(text, "x{i} = {{ derivative = 'v{i}' }}");
    }
    text += "v1 = { derivative = '90*(x2 - x1) - 120*x1 - 0.5*v1' }\n";
    text += "v2 = { derivative = '90*(x1 - x2) + 70*(x3 - x2) - 0.4*v2' }\n";
    text += "v3 = { derivative = '70*(x2 - x3) - 0.3*v3 + u/0.8' }\n";
    text += "[inputs]\nu = {}\n[outputs]\ny = { value = 'x1' }\n";
    let mut first = None;
    for steps in [100, 1_000, 10_000] {
        let text = format!(
            "{text}[observer.window]\nwindow = {}\n[target]\nsample_time = 0.001\nscalar = \"f64\"\n",
            f64::from(steps) / 1e3
        );
        let mut result = None;
        let time = median(if steps < 10_000 { 3 } else { 1 }, || {
            result = Some(Generator::new(&text, "chain.toml").generate());
        });
        let outcome = match result.unwrap() {
            Ok(output) => format!("{} bytes", output.files().iter().map(|file| file.text.len()).sum::<usize>()),
            Err(report) => format!("refused: {}", report.diagnostics[0].message),
        };
        let seconds = time.as_secs_f64();
        println!(
            "  N = {steps}: {seconds:.3} s, {:.1} times the shortest; {outcome}",
            seconds / *first.get_or_insert(seconds)
        );
    }
}
