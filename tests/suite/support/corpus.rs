//! The corpus, `specs/*.toml`: every specification designed in its scalar, or in both, and signals to feed it.
//!
//! A subject is a specification under the name `<name>_f32` or `<name>_f64`, so that all of them
//! fit into one program. Nothing else of the text is changed.

#![allow(dead_code, reason = "each test uses its part of this")]

use super::depth::deep;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::{Generated, Generator, Output, Settings};

/// One specification of the corpus.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Of the file, without `.toml`.
    pub stem: String,
    /// Where it is.
    pub path: PathBuf,
    /// All of it.
    pub text: String,
}

/// One specification in one scalar.
pub struct Subject {
    /// With the scalar behind it.
    pub name: String,
    /// Of the specification's file.
    pub stem: String,
    /// All stages.
    pub generated: Generated,
    /// All files.
    pub output: Output,
}

/// A signal's centre and amplitude, a power of two, so that `centre + amplitude * x` is rounded once.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    pub centre: f64,
    pub amplitude: f64,
}

/// `specs/*.toml`, by name.
pub fn corpus() -> Vec<Entry> {
    let folder = root().join("specs");
    let mut paths: Vec<PathBuf> = fs::read_dir(&folder)
        .expect("the corpus")
        .map(|entry| entry.expect("an entry of the corpus").path())
        .filter(|path| path.extension().is_some_and(|it| it == "toml"))
        .collect();
    paths.sort();
    assert!(!paths.is_empty(), "no specification in {}", folder.display());
    let entry = |path: PathBuf| Entry {
        stem: path.file_stem().expect("a name").to_string_lossy().into_owned(),
        text: fs::read_to_string(&path).expect("a specification"),
        path,
    };
    paths.into_iter().map(entry).collect()
}

/// The scalar that a specification names; f32 where it names none.
fn own_scalar(entry: &Entry) -> Scalar {
    if entry.text.lines().any(|line| line.trim() == "scalar = \"f64\"") { Scalar::F64 } else { Scalar::F32 }
}

/// The whole corpus, designed once for each test program; when [`deep`], in the scalar that it does not name, too.
pub fn subjects() -> &'static [Subject] {
    static SUBJECTS: OnceLock<Vec<Subject>> = OnceLock::new();
    SUBJECTS.get_or_init(|| {
        let jobs: Vec<(Entry, Scalar)> =
            corpus().into_iter().flat_map(|it| [(it.clone(), Scalar::F32), (it, Scalar::F64)]).collect();
        let jobs: Vec<_> = jobs.into_iter().filter(|(entry, scalar)| deep() || own_scalar(entry) == *scalar).collect();
        side_by_side(&jobs, |(entry, scalar)| subject(entry, *scalar))
    })
}

fn subject(entry: &Entry, scalar: Scalar) -> Subject {
    let (was, is) = (format!("name = \"{}\"", entry.stem), format!("name = \"{}_{scalar}\"", entry.stem));
    assert!(entry.text.contains(&was), "specs/{}.toml has the name of its file", entry.stem);
    let text = entry.text.replacen(&was, &is, 1);
    let generator = Generator::new(&text, &format!("{}.toml", entry.stem)).with(Settings { scalar: Some(scalar) });
    let generated = generator.design().unwrap_or_else(|report| panic!("{}", report.render(false)));
    let output = Output::new(&generated, generator.source());
    Subject { name: generated.program.name.clone(), stem: entry.stem.clone(), generated, output }
}

impl Subject {
    /// The text of the file that ends so.
    pub fn file(&self, suffix: &str) -> &str {
        let name = format!("{}.{suffix}", self.name);
        &self.output.files().iter().find(|file| file.name == name).expect("a file for each language").text
    }

    /// The scalar.
    pub fn scalar(&self) -> Scalar {
        self.generated.program.scalar
    }

    /// Calls until it has converged, and N at least.
    pub fn window(&self) -> usize {
        self.generated.design.window_steps.max(self.generated.design.valid_from_step)
    }

    /// Measurements that are inside their range.
    pub fn measured(&self) -> Vec<Span> {
        let number = |it: &deadbeat_codegen::internals::expr::Constant| it.to_f64().expect("a range of numbers");
        let span = |output: &deadbeat_codegen::internals::plant::Output| match output
            .raw_range
            .as_ref()
            .or(output.range.as_ref())
        {
            Some((low, high)) => {
                let (low, high) = (number(low), number(high));
                Span { centre: f64::midpoint(low, high), amplitude: power_of_two_below(0.45 * (high - low)).min(16.0) }
            }
            None => Span { centre: 0.0, amplitude: 1.0 },
        };
        // Ages follow the outputs.
        let aged = self.generated.plant.outputs.iter().filter_map(|output| output.aged.as_ref());
        let ages = aged.map(|aged| {
            let half = number(&aged.most) / 2.0;
            Span { centre: half, amplitude: power_of_two_below(half) }
        });
        self.generated.plant.outputs.iter().map(span).chain(ages).collect()
    }

    /// Inputs.
    pub fn applied(&self) -> Vec<Span> {
        self.generated.plant.inputs.iter().map(|_| Span { centre: 0.25, amplitude: 2.0 }).collect()
    }
}

fn power_of_two_below(x: f64) -> f64 {
    x.log2().floor().exp2()
}

/// Numbers that are as good as random, and the same everywhere (xorshift64).
pub struct Random(pub u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// True in one of `n` cases.
    pub fn one_in(&mut self, n: u64) -> bool {
        (self.bits() >> 11).is_multiple_of(n)
    }

    /// One of the numbers.
    pub fn among(&mut self, numbers: &[f64]) -> f64 {
        let at = (self.bits() >> 11) % numbers.len() as u64;
        numbers[usize::try_from(at).expect("below the length")]
    }

    /// In [-1, 1), exactly: 53 bits.
    #[expect(clippy::cast_precision_loss, reason = "53 bits are exact in a double")]
    pub fn signed(&mut self) -> f64 {
        2.0 * ((self.bits() >> 11) as f64 / 9_007_199_254_740_992.0) - 1.0
    }
}

/// What no measurement should be: infinities, NaN, subnormals, huge values, both zeros.
pub const ODD: [f64; 16] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e-45,
    -1e-39,
    1e38,
    -1e38,
    3.0e35,
    1e300,
    0.0,
    -0.0,
];

/// The repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// An empty folder for one test, below the target folder.
pub fn empty_folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

/// Writes a file unless it is already so; cargo then builds nothing again.
pub fn put(path: &Path, text: &str) {
    if fs::read_to_string(path).is_ok_and(|found| found == text) {
        return;
    }
    fs::create_dir_all(path.parent().expect("a file in a folder")).expect("a folder of the test");
    fs::write(path, text).expect("a file of the test");
}

/// Runs a command that must succeed; gives what it printed.
pub fn succeed(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let (out, messages) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{command:?}\n{out}\n{messages}");
    out.into_owned()
}

/// A cargo that reaches no network, has its own target folder, and knows nothing of the one outside.
pub fn cargo(project: &Path, target: &Path) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(project).env("CARGO_TARGET_DIR", target).env("CARGO_NET_OFFLINE", "true");
    for variable in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "RUSTC_WORKSPACE_WRAPPER", "CARGO_BUILD_TARGET"] {
        cargo.env_remove(variable);
    }
    cargo
}

/// Whether a tool runs here.
///
/// # Panics
/// When `DEADBEAT_REQUIRE` lists it and it does not.
pub fn runs(tool: &str) -> bool {
    let found = Command::new(tool).arg("--version").output().is_ok_and(|it| it.status.success());
    let required = env::var("DEADBEAT_REQUIRE").unwrap_or_default();
    assert!(found || !required.split(',').any(|word| word.trim() == tool), "DEADBEAT_REQUIRE lists {tool}");
    if !found {
        eprintln!("{tool} does not run here: its part of the test is left out");
    }
    found
}

/// `work` on all jobs, as many at a time as the machine has processors, results in order.
pub fn side_by_side<J: Sync, R: Send>(jobs: &[J], work: impl Fn(&J) -> R + Sync) -> Vec<R> {
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
        let joined = handles.into_iter().map(|it| it.join().unwrap_or_else(|why| std::panic::resume_unwind(why)));
        joined.flatten().collect()
    });
    done.sort_by_key(|(at, _)| *at);
    done.into_iter().map(|(_, result)| result).collect()
}
