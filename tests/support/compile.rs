//! Compiles generated observers, feeds them samples and reads what they answer, bit for bit.
//!
//! Many observers go into one executable, which reads the samples of all of them from its input
//! and writes the answers to its output as raw numbers: 300 observers cost a few compiler runs.
//!
//! The C compilers are those of gcc and clang that are found; the environment variable
//! `DEADBEAT_REQUIRE=gcc,clang` makes a missing one an error.

#![allow(dead_code, reason = "each test uses its part of this")]

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

use deadbeat_codegen::emit::{self, Door, Header};
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Field, Program, Scalar};

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
        let answer = |sample: &Sample| {
            let mut estimates = vec![0.0; self.program.estimates.len()];
            let status = interpreter.step(&sample.measurements, &sample.inputs, &mut estimates);
            Answer { estimates, status: status as u8 }
        };
        self.samples.iter().map(answer).collect()
    }

    /// The samples as raw numbers.
    fn bytes(&self) -> Vec<u8> {
        let numbers = self.samples.iter().flat_map(|it| it.measurements.iter().chain(&it.inputs));
        match self.program.scalar {
            #[expect(clippy::cast_possible_truncation, reason = "as the interpreter rounds")]
            Scalar::F32 => numbers.flat_map(|x| (*x as f32).to_ne_bytes()).collect(),
            Scalar::F64 => numbers.flat_map(|x| x.to_ne_bytes()).collect(),
        }
    }

    /// The answers at the front of raw output, which then begins behind them.
    fn answers(&self, output: &mut &[u8]) -> Vec<Answer> {
        let answer = |_: &Sample| Answer {
            estimates: self.program.estimates.iter().map(|_| self.number(output)).collect(),
            status: take::<1>(output)[0],
        };
        self.samples.iter().map(answer).collect()
    }

    /// One number.
    fn number(&self, output: &mut &[u8]) -> f64 {
        match self.program.scalar {
            Scalar::F32 => f32::from_ne_bytes(take(output)).into(),
            Scalar::F64 => f64::from_ne_bytes(take(output)),
        }
    }
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
    options: &'static [&'static str],
}

/// The options that must not change a bit. None turns contraction off, as `-std=c99` does in gcc:
/// the emitted file does it. One level has every warning that an emitted file is free of.
const C_OPTIONS: [(&str, &[&str]); 3] = [
    ("-O0", &["-O0"]),
    (
        "-O2",
        &[
            "-O2", "-std=gnu99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow",
            "-Wundef", "-Wcast-qual", "-Wstrict-prototypes", "-Werror",
        ],
    ),
    ("-O3 -march=native", &["-O3", "-march=native"]),
];

/// The dialects that only have to accept the emitted file, without a warning.
const DIALECTS: [&[&str]; 2] = [
    &["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only"],
    &[
        "-xc++", "-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow",
        "-Wundef", "-Wcast-qual", "-Werror", "-fsyntax-only",
    ],
];

/// The options of rustc, at one level with its warnings as errors.
const RUST_OPTIONS: [(&str, &[&str]); 2] = [
    ("debug", &["-Copt-level=0", "-Cdebug-assertions=on", "-Coverflow-checks=on", "-Dwarnings"]),
    ("-O3", &["-Copt-level=3", "-Ctarget-cpu=native"]),
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
    let build = |command, (name, options): (&str, &'static [&'static str])| {
        Build { name: format!("{command} {name}"), command, options }
    };
    let c = c_compilers().into_iter().flat_map(|it| C_OPTIONS.map(|options| build(it, options)));
    c.chain(RUST_OPTIONS.map(|options| build("rustc", options))).collect()
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
        for (_, options) in RUST_OPTIONS {
            self.runtime(options);
        }
        let jobs: Vec<(&Build, usize)> =
            (0..cases.len().div_ceil(BATCH)).flat_map(|batch| builds.iter().map(move |it| (it, batch))).collect();
        let answers = side_by_side(&jobs, |(build, batch)| {
            let first = batch * BATCH;
            let cases = &cases[first..cases.len().min(first + BATCH)];
            self.run(&self.compile(build, *batch), cases)
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
        let jobs: Vec<(&str, &[&str], usize)> = (0..cases.len().div_ceil(BATCH))
            .flat_map(|batch| c_compilers().into_iter().map(move |it| (it, batch)))
            .flat_map(|(it, batch)| DIALECTS.map(|options| (it, options, batch)))
            .collect();
        side_by_side(&jobs, |(compiler, options, batch)| {
            succeed(Command::new(compiler).args(*options).arg(self.folder.join(format!("all_{batch}.c"))));
        });
    }

    /// Writes every case's files and the drivers.
    fn write(&self, cases: &[Case]) {
        let header = Header { title: "Random Program.".to_owned(), lines: vec!["A line.".to_owned()] };
        for Case { program, .. } in cases {
            self.put(&format!("{}.rs", program.name), &emit::rust(program, &header, Door::File));
            self.put(&format!("{}.h", program.name), &emit::c_header(program, &header));
            self.put(&format!("{}.c", program.name), &emit::c_source(program, &header));
        }
        for (batch, cases) in cases.chunks(BATCH).enumerate() {
            let all: String = cases.iter().map(|it| format!("#include \"{}.c\"\n", it.program.name)).collect();
            self.put(&format!("all_{batch}.c"), &all);
            self.put(&format!("main_{batch}.c"), &c_driver(batch, cases));
            self.put(&format!("main_{batch}.rs"), &rust_driver(cases));
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
    fn runtime(&self, options: &[&str]) {
        let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("runtime");
        fs::create_dir_all(self.library(options)).expect("a folder for the runtime");
        for (name, path) in [("deadbeat_math", "math/src/lib.rs"), ("deadbeat", "src/lib.rs")] {
            let mut rustc = self.rustc(options);
            rustc.args(["--crate-type=rlib", "--crate-name", name, "--cap-lints=allow"]);
            rustc.args((name == "deadbeat").then_some("--extern=deadbeat_math"));
            succeed(rustc.arg("--out-dir").arg(self.library(options)).arg(sources.join(path)));
        }
    }

    /// Where the runtime compiled with these options is.
    fn library(&self, options: &[&str]) -> PathBuf {
        self.folder.join(format!("runtime{}", options[0]))
    }

    /// The Rust compiler that finds the runtime.
    fn rustc(&self, options: &[&str]) -> Command {
        let mut rustc = Command::new("rustc");
        rustc.args(["--edition=2024", "-L"]).arg(self.library(options)).args(options);
        rustc
    }

    /// The executable of one batch by one build.
    fn compile(&self, build: &Build, batch: usize) -> PathBuf {
        let executable = self.folder.join(format!("{}_{batch}", build.name.replace(' ', "")));
        let mut compiler = if build.command == "rustc" {
            let mut rustc = self.rustc(build.options);
            rustc.arg("--extern=deadbeat").arg(self.main(batch));
            rustc
        } else {
            let mut compiler = Command::new(build.command);
            compiler.args(build.options).arg(self.folder.join(format!("main_{batch}.c")));
            compiler
        };
        succeed(compiler.arg("-o").arg(&executable));
        executable
    }

    /// What an executable answers.
    fn run(&self, executable: &Path, cases: &[Case]) -> Vec<Vec<Answer>> {
        let input: Vec<u8> = cases.iter().flat_map(Case::bytes).collect();
        let mut child = Command::new(executable)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("what was compiled runs");
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
}

/// How many observers go into one executable.
const BATCH: usize = 50;

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
        handles.into_iter().flat_map(|handle| handle.join().unwrap_or_else(|it| std::panic::resume_unwind(it))).collect()
    });
    done.sort_by_key(|(at, _)| *at);
    done.into_iter().map(|(_, result)| result).collect()
}

/// One line of text for each field.
fn each<'f>(fields: impl IntoIterator<Item = &'f Field>, line: impl Fn(&str) -> String) -> String {
    fields.into_iter().map(|field| line(&field.name)).collect::<Vec<_>>().concat()
}

/// The fields of the estimate.
fn estimates(program: &Program) -> impl Iterator<Item = &Field> {
    program.estimates.iter().map(|(field, _)| field)
}

/// A C main function that runs the batch's observers one after the other.
fn c_driver(batch: usize, cases: &[Case]) -> String {
    let runs = cases.iter().map(c_run).collect::<Vec<_>>().concat();
    let calls = cases.iter().map(|it| format!("    run_{}();\n", it.program.name)).collect::<Vec<_>>().concat();
    format!(
        "#include <stdio.h>
#include <stdlib.h>
#include \"all_{batch}.c\"

static void get(void *to, size_t size)
{{
    if (fread(to, size, 1, stdin) != 1) {{
        exit(1);
    }}
}}

static void put(const void *from, size_t size)
{{
    if (fwrite(from, size, 1, stdout) != 1) {{
        exit(1);
    }}
}}
{runs}
int main(void)
{{
{calls}    return 0;
}}
"
    )
}

/// The C function that runs one observer.
fn c_run(Case { program, samples }: &Case) -> String {
    let (name, count) = (&program.name, samples.len());
    let get = |of: &str, fields| each(fields, |field| format!("        get(&{of}.{field}, sizeof {of}.{field});\n"));
    let measurements = get("measurements", &program.measurements);
    let inputs = get("inputs", &program.inputs);
    let estimates = each(estimates(program), |field| format!("        put(&estimate.{field}, sizeof estimate.{field});\n"));
    let (declared, passed) = if program.inputs.is_empty() {
        (String::new(), "")
    } else {
        (format!("    {name}_inputs inputs;\n"), "&inputs, ")
    };
    format!(
        "
static void run_{name}(void)
{{
    {name}_state state;
    {name}_measurements measurements;
{declared}    {name}_estimate estimate;
    int call;
    {name}_init(&state);
    for (call = 0; call < {count}; ++call) {{
        unsigned char status;
{measurements}{inputs}        {name}_step(&state, &measurements, {passed}&estimate);
{estimates}        status = (unsigned char)estimate.status;
        put(&status, sizeof status);
    }}
}}
"
    )
}

/// A Rust main function that runs the batch's observers one after the other.
fn rust_driver(cases: &[Case]) -> String {
    let modules = cases.iter().map(|it| format!("pub mod {};\n", it.program.name)).collect::<Vec<_>>().concat();
    let runs = cases.iter().map(rust_run).collect::<Vec<_>>().concat();
    format!(
        "use std::io::{{Read, Write}};

{modules}
fn get<const N: usize>(input: &mut impl Read) -> [u8; N] {{
    let mut raw = [0; N];
    input.read_exact(&mut raw).unwrap();
    raw
}}

fn main() {{
    let mut input = std::io::BufReader::new(std::io::stdin());
    let mut output = std::io::BufWriter::new(std::io::stdout());
{runs}}}
"
    )
}

/// The Rust statements that run one observer.
fn rust_run(Case { program, samples }: &Case) -> String {
    let (name, scalar, count) = (&program.name, program.scalar, samples.len());
    let get = |fields| each(fields, |field| format!("{field}: {scalar}::from_ne_bytes(get(&mut input)), "));
    let measurements = get(&program.measurements);
    let inputs = get(&program.inputs);
    let passed =
        if program.inputs.is_empty() { String::new() } else { format!(", {name}::Inputs {{ {inputs} }}") };
    let estimates = each(estimates(program), |field| {
        format!("        output.write_all(&estimate.{field}.to_ne_bytes()).unwrap();\n")
    });
    format!(
        "    let mut observer = {name}::Observer::default();
    observer.init();
    for _ in 0..{count} {{
        let estimate = observer.step({name}::Measurements {{ {measurements} }}{passed});
{estimates}        output.write_all(&[estimate.status as u8]).unwrap();
    }}
"
    )
}
