//! Compiles generated observers, feeds them samples and reads what they answer, bit for bit.
//!
//! Many observers go into one executable, which reads the samples of all of them from its input
//! and writes the answers to its output as raw numbers: 300 observers cost a few compiler runs.
//!
//! The C compilers are those of gcc and clang that are found; the environment variable
//! `DEADBEAT_REQUIRE=gcc,clang` makes a missing one an error.

#![allow(dead_code, reason = "each test uses its part of this")]

#[path = "driver.rs"]
mod driver;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

use deadbeat_codegen::internals::emit;
use deadbeat_codegen::internals::emit::Header;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Field, Kind, Program, Scalar, Status};

/// What one call gets.
#[derive(Clone, Debug)]
pub struct Sample {
    /// One number for each measurement.
    pub measurements: Vec<f64>,
    /// One number for each input.
    pub inputs: Vec<f64>,
}

/// What one call answers.
#[derive(Clone, Debug)]
pub struct Answer {
    /// One number for each estimate.
    pub estimates: Vec<f64>,
    /// 0 converging, 1 converged, 2 coasting.
    pub status: u8,
}

/// NaN equals NaN, whatever its bits; 0 does not equal -0.
impl PartialEq for Answer {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        self.status == other.status
            && self.estimates.len() == other.estimates.len()
            && self.estimates.iter().zip(&other.estimates).all(same)
    }
}

/// An observer and what it is fed. The Programs of one run have different names.
///
/// One that can start from an estimate does so before call [`restart`], from the estimate of the call before.
pub struct Case {
    /// The observer.
    pub program: Program,
    /// From its first call on.
    pub samples: Vec<Sample>,
}

impl Case {
    /// What the interpreter answers.
    pub fn interpreted(&self) -> Vec<Answer> {
        let mut interpreter = Interpreter::new(&self.program);
        let mut estimates = vec![0.0; self.program.estimates.len()];
        let mut status = Status::Converging;
        let answer = |(call, sample): (usize, &Sample)| {
            if restart(self) == Some(call) {
                interpreter.start_at(&estimates, status);
            }
            status = interpreter.step(&sample.measurements, &sample.inputs, &mut estimates);
            Answer { estimates: estimates.clone(), status: status as u8 }
        };
        self.samples.iter().enumerate().map(answer).collect()
    }

    /// The samples as raw numbers.
    fn bytes(&self) -> Vec<u8> {
        let fields = || self.program.measurements.iter().chain(&self.program.inputs);
        let numbers = |it: &'_ Sample| it.measurements.iter().chain(&it.inputs).copied().collect::<Vec<f64>>();
        let raw =
            |it: &Sample| fields().zip(numbers(it)).flat_map(|(field, x)| self.raw(field, x)).collect::<Vec<u8>>();
        self.samples.iter().flat_map(raw).collect()
    }

    /// A number as the field holds it.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "as the interpreter converts")]
    fn raw(&self, field: &Field, x: f64) -> Vec<u8> {
        match (field.kind, self.program.scalar) {
            (Kind::Count { bits: 16, signed: true }, _) => (x as i16).to_ne_bytes().to_vec(),
            (Kind::Count { bits: 16, signed: false }, _) => (x as u16).to_ne_bytes().to_vec(),
            (Kind::Count { signed: true, .. }, _) => (x as i32).to_ne_bytes().to_vec(),
            (Kind::Count { signed: false, .. } | Kind::Index, _) => (x as u32).to_ne_bytes().to_vec(),
            (Kind::Float, Scalar::F32) => (x as f32).to_ne_bytes().to_vec(),
            (Kind::Float, Scalar::F64) => x.to_ne_bytes().to_vec(),
        }
    }

    /// The answers at the front of raw output, which then begins behind them.
    fn answers(&self, output: &mut &[u8]) -> Vec<Answer> {
        let answer = |_: &Sample| Answer {
            estimates: self.program.estimates.iter().map(|(field, _)| self.number(field, output)).collect(),
            status: take::<1>(output)[0],
        };
        self.samples.iter().map(answer).collect()
    }

    /// One number.
    fn number(&self, field: &Field, output: &mut &[u8]) -> f64 {
        match (field.kind, self.program.scalar) {
            (Kind::Index, _) => u32::from_ne_bytes(take(output)).into(),
            (_, Scalar::F32) => f32::from_ne_bytes(take(output)).into(),
            (_, Scalar::F64) => f64::from_ne_bytes(take(output)),
        }
    }
}

/// Before which call an observer starts from the last estimate, if it can.
pub fn restart(case: &Case) -> Option<usize> {
    (case.program.init_at.is_some() && case.samples.len() > 1).then_some(case.samples.len() / 2)
}

/// The next bytes of some output.
fn take<const N: usize>(output: &mut &[u8]) -> [u8; N] {
    let (bytes, rest) = output.split_first_chunk().expect("one answer for each sample");
    *output = rest;
    *bytes
}

/// A compiler with one set of options.
#[derive(Clone, Debug)]
pub struct Build {
    /// What messages call it: "gcc -O2".
    pub name: String,
    command: &'static str,
    options: &'static str,
}

/// The options that must not change a bit. None turns contraction off, as `-std=c99` does in gcc:
/// the emitted file does it. One level has every warning that an emitted file is free of.
const C_OPTIONS: [(&str, &str); 3] = [
    ("-O0", "-O0"),
    (
        "-O2",
        "-O2 -std=gnu99 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wundef -Wcast-qual \
         -Wstrict-prototypes -Werror",
    ),
    ("-O3 -march=native", "-O3 -march=native"),
];

/// The dialects that only have to accept the emitted file, without a warning.
const DIALECTS: [&str; 2] = [
    "-std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only",
    "-xc++ -std=c++11 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Wundef -Wcast-qual -Werror \
     -fsyntax-only",
];

/// The Rust compiler.
const RUSTC: &str = "rustc";

/// The options of rustc, at one level with its warnings as errors.
const RUST_OPTIONS: [(&str, &str); 2] = [
    ("debug", "-Copt-level=0 -Cdebug-assertions=on -Coverflow-checks=on -Dwarnings"),
    ("-O3", "-Copt-level=3 -Ctarget-cpu=native"),
];

/// Those of gcc and clang that are found.
///
/// # Panics
/// When `DEADBEAT_REQUIRE` lists one that is not.
pub fn c_compilers() -> Vec<&'static str> {
    let required = env::var("DEADBEAT_REQUIRE").unwrap_or_default();
    let runs = |name: &&str| {
        let found = Command::new(name).arg("--version").output().is_ok_and(|it| it.status.success());
        let needed = required.split(',').any(|word| word.trim() == *name);
        assert!(found || !needed, "DEADBEAT_REQUIRE lists {name}, which does not run here");
        if !found {
            eprintln!("{name} does not run here: its half of the test is left out");
        }
        found
    };
    ["gcc", "clang"].into_iter().filter(runs).collect()
}

/// Every build that must answer alike: C by each compiler at each level, Rust at two.
pub fn builds() -> Vec<Build> {
    let build = |command, (name, options)| Build { name: format!("{command} {name}"), command, options };
    let c = c_compilers().into_iter().flat_map(|it| C_OPTIONS.map(|options| build(it, options)));
    c.chain(RUST_OPTIONS.map(|options| build(RUSTC, options))).collect()
}

/// A folder for one test.
pub struct Workshop {
    folder: PathBuf,
}

impl Workshop {
    /// An empty folder below the target folder.
    pub fn new(test: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder for the test");
        Self { folder }
    }

    /// The answers of every build to every case: the name of the build, then one list for each case.
    ///
    /// # Panics
    /// With the compiler's messages, if one does not compile.
    pub fn answers(&self, cases: &[Case]) -> Vec<(String, Vec<Vec<Answer>>)> {
        self.write(cases);
        let builds = builds();
        for build in builds.iter().filter(|build| build.command == RUSTC) {
            self.runtime(build);
        }
        let jobs: Vec<(&Build, usize)> =
            (0..cases.len().div_ceil(BATCH)).flat_map(|batch| builds.iter().map(move |it| (it, batch))).collect();
        let answers = side_by_side(&jobs, |(build, batch)| {
            let first = batch * BATCH;
            let cases = &cases[first..cases.len().min(first + BATCH)];
            run(&self.compile(build, *batch), cases)
        });
        let of = |build: &Build| {
            let mine = jobs.iter().zip(&answers).filter(|((it, _), _)| it.name == build.name);
            mine.flat_map(|(_, answers)| answers.clone()).collect()
        };
        builds.iter().map(|build| (build.name.clone(), of(build))).collect()
    }

    /// Has each compiler read every emitted C file as strict C99 and as C++, all warnings as errors.
    ///
    /// # Panics
    /// With the compiler's messages.
    pub fn dialects(&self, cases: &[Case]) {
        self.write(cases);
        let jobs: Vec<(&str, &str, usize)> = (0..cases.len().div_ceil(BATCH))
            .flat_map(|batch| c_compilers().into_iter().map(move |it| (it, batch)))
            .flat_map(|(it, batch)| DIALECTS.map(|options| (it, options, batch)))
            .collect();
        side_by_side(&jobs, |(compiler, options, batch)| {
            succeed(
                Command::new(compiler).args(options.split_whitespace()).arg(self.folder.join(format!("all_{batch}.c"))),
            );
        });
    }

    /// Writes every case's files and the drivers.
    fn write(&self, cases: &[Case]) {
        let header = Header { title: "Random Program.".to_owned(), lines: vec!["A line.".to_owned()] };
        for (at, Case { program, .. }) in cases.iter().enumerate() {
            self.put(&format!("{}.rs", program.name), &emit::rust(program, &header, driver::door(at)));
            self.put(&format!("{}.h", program.name), &emit::c_header(program, &header));
            self.put(&format!("{}.c", program.name), &emit::c_source(program, &header));
        }
        for (batch, cases) in cases.chunks(BATCH).enumerate() {
            self.put(&format!("all_{batch}.c"), &driver::all(cases));
            self.put(&format!("main_{batch}.c"), &driver::c(batch, cases));
            self.put(&format!("main_{batch}.rs"), &driver::rust(cases));
        }
    }

    /// Writes one file.
    fn put(&self, name: &str, text: &str) {
        fs::write(self.folder.join(name), text).expect("a file of the test");
    }

    /// The Rust driver of a batch.
    fn main(&self, batch: usize) -> PathBuf {
        self.folder.join(format!("main_{batch}.rs"))
    }

    /// Compiles the runtime.
    fn runtime(&self, build: &Build) {
        let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("runtime");
        fs::create_dir_all(self.library(build)).expect("a folder for the runtime");
        for (name, path) in [("deadbeat_math", "math/src/lib.rs"), ("deadbeat", "src/lib.rs")] {
            let mut rustc = self.rustc(build);
            rustc.args(["--crate-type=rlib", "--crate-name", name, "--cap-lints=allow"]);
            rustc.args((name == "deadbeat").then_some("--extern=deadbeat_math"));
            succeed(rustc.arg("--out-dir").arg(self.library(build)).arg(sources.join(path)));
        }
    }

    /// Where the runtime of this build is.
    fn library(&self, build: &Build) -> PathBuf {
        self.folder.join(format!("runtime {}", build.name))
    }

    /// The Rust compiler that finds the runtime.
    fn rustc(&self, build: &Build) -> Command {
        let mut rustc = Command::new(RUSTC);
        rustc.args(["--edition=2024", "-L"]).arg(self.library(build)).args(build.options.split_whitespace());
        rustc
    }

    /// The executable of one batch by one build.
    fn compile(&self, build: &Build, batch: usize) -> PathBuf {
        let executable = self.folder.join(format!("{}_{batch}", build.name.replace(' ', "")));
        let mut compiler = if build.command == RUSTC {
            let mut rustc = self.rustc(build);
            rustc.arg("--extern=deadbeat").arg(self.main(batch));
            rustc
        } else {
            let mut compiler = Command::new(build.command);
            compiler.args(build.options.split_whitespace()).arg(self.folder.join(format!("main_{batch}.c")));
            compiler
        };
        succeed(compiler.arg("-o").arg(&executable));
        executable
    }
}

/// How many observers go into one executable; even, because of [`driver::door`].
const BATCH: usize = 50;

/// What an executable answers.
fn run(executable: &Path, cases: &[Case]) -> Vec<Vec<Answer>> {
    let input: Vec<u8> = cases.iter().flat_map(Case::bytes).collect();
    let mut child =
        Command::new(executable).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("what was compiled runs");
    let mut stdin = child.stdin.take().expect("its input");
    let writer = thread::spawn(move || stdin.write_all(&input));
    let output = child.wait_with_output().expect("its output");
    writer.join().expect("the writer").expect("all samples are read");
    assert!(output.status.success(), "{}: {}", executable.display(), output.status);
    let mut rest = output.stdout.as_slice();
    let answers = cases.iter().map(|case| case.answers(&mut rest)).collect();
    assert!(rest.is_empty(), "{} answers too much", executable.display());
    answers
}

/// Runs the command.
fn succeed(command: &mut Command) {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{messages}");
}

/// `work` on all jobs, as many at a time as the machine has processors, results in order.
fn side_by_side<J: Sync, R: Send>(jobs: &[J], work: impl Fn(&J) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = vec![];
        while let at = next.fetch_add(1, Ordering::Relaxed)
            && let Some(job) = jobs.get(at)
        {
            done.push((at, work(job)));
        }
        done
    };
    let workers = thread::available_parallelism().map_or(2, usize::from);
    let mut done: Vec<(usize, R)> = thread::scope(|scope| {
        let handles: Vec<_> = (0..workers).map(|_| scope.spawn(worker)).collect();
        handles
            .into_iter()
            .flat_map(|handle| handle.join().unwrap_or_else(|it| std::panic::resume_unwind(it)))
            .collect()
    });
    done.sort_by_key(|(at, _)| *at);
    done.into_iter().map(|(_, result)| result).collect()
}
