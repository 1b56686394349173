//! Claim: the command line does what its manual says: every command, its output for people and for
//! machines, its exit code (0 fine, 1 the specification or the data is wrong, 2 what is on disk
//! differs, 3 wrong usage), and that nothing half-made stays on the disk.

use crate::support::corpus;

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

use corpus::{empty_folder, root};
use deadbeat_codegen::METHODS;
use serde_json::Value;

/// How a command ended.
struct Ended {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Ended {
    fn is(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "\n{}\n{}", self.out, self.err);
        self
    }

    fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}\n{}", self.out))
    }

    /// Standard error has all of these.
    fn complains(self, words: &[&str]) -> Self {
        for word in words {
            assert!(self.err.contains(word), "`{word}` is not in\n{}", self.err);
        }
        self
    }
}

/// A folder with a command line in it.
struct Desk(PathBuf);

impl Desk {
    /// With two specifications of the corpus.
    fn new(test: &str) -> Self {
        let desk = Self(empty_folder(&format!("cli_{test}")));
        for stem in ["pendulum", "dc_motor"] {
            fs::copy(root().join(format!("specs/{stem}.toml")), desk.0.join(format!("{stem}.toml"))).expect("a copy");
        }
        desk
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).expect("a file of the test");
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn names(&self, folder: &str) -> Vec<String> {
        let Ok(entries) = fs::read_dir(self.path(folder)) else { return Vec::new() };
        let mut names: Vec<String> =
            entries.map(|it| it.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn fed(&self, line: &str, input: &str) -> Ended {
        let mut command = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
        command.current_dir(&self.0).args(line.split_whitespace());
        let mut child =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it runs");
        // A command that refuses does not read to the end.
        let _ = child.stdin.take().expect("its input").write_all(input.as_bytes());
        let output = child.wait_with_output().expect("it ends");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        Ended { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
    }

    fn run(&self, line: &str) -> Ended {
        self.fed(line, "")
    }

    /// The pendulum's text with a mistake under another name.
    fn write_bad(&self, name: &str) {
        let bad = self.read("pendulum.toml").replace("gravity*sin(theta)", "gravty*sin(theta)");
        self.write(name, &bad);
    }
}

/// Rows of a recording of a pendulum that hangs still but for a little swing: `t,theta`.
fn swing(rows: usize) -> Vec<String> {
    #[expect(clippy::cast_precision_loss, reason = "few rows")]
    let row = |k: usize| {
        let t = k as f64 * 1e-3;
        format!("{t},{}", std::f64::consts::PI + 0.01 * (8.0 * t).cos())
    };
    (0..rows).map(row).collect()
}

fn recording(rows: &[String]) -> String {
    format!("t,theta\n{}\n", rows.join("\n"))
}

/// Claim: wrong usage is 3, help and version are 0, and a file that is not there is 1.
#[test]
fn usage() {
    let desk = Desk::new("usage");
    for line in [
        "",
        "chek pendulum.toml",
        "check",
        "generate pendulum.toml",
        "verify pendulum.toml",
        "run pendulum.toml",
        "check --format xml pendulum.toml",
        "check --scalar f16 pendulum.toml",
        "generate pendulum.toml --out gen --lang cobol",
        "run pendulum.toml --log x.csv --map theta",
        "list nosuch",
        "check - -",
        "run - --log -",
    ] {
        let ended = desk.run(line).is(3);
        assert!(!ended.err.is_empty() && ended.out.is_empty(), "{line}: said on standard error");
    }
    assert!(desk.run("--help").is(0).out.contains("generate"));
    assert!(desk.run("--version").is(0).out.contains(env!("CARGO_PKG_VERSION")));
    desk.run("check nosuch.toml").is(1).complains(&["cannot read `nosuch.toml`"]);
    desk.run("run pendulum.toml --log nosuch.csv").is(1).complains(&["cannot read nosuch.csv"]);
    assert_eq!(desk.names("."), ["dc_motor.toml", "pendulum.toml"], "nothing was written");
}

/// Claim: what cannot be printed is a failure, except that a reader has seen enough.
#[cfg(target_os = "linux")]
#[test]
fn printing() {
    let desk = Desk::new("printing");
    let ended = |line: &str, out: Stdio| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
        command.current_dir(&desk.0).args(line.split_whitespace()).stdin(Stdio::null());
        let output = command.stdout(out).stderr(Stdio::piped()).spawn().and_then(std::process::Child::wait_with_output);
        let output = output.expect("it ends");
        let err = String::from_utf8(output.stderr).expect("text");
        Ended { code: output.status.code(), out: String::new(), err }
    };
    desk.write("log.csv", &recording(&swing(100)));
    for line in [
        "list",
        "--help",
        "check pendulum.toml",
        "design pendulum.toml",
        "run pendulum.toml --log log.csv",
        "run pendulum.toml --log log.csv --plot -",
        "run pendulum.toml --log log.csv --out -",
    ] {
        let full = fs::File::options().write(true).open("/dev/full").expect("a full disk");
        ended(line, full.into()).is(1).complains(&["error: cannot write"]);
    }
    for line in ["list", "--help", "design pendulum.toml"] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let ended = ended(line, writer.into()).is(0);
        assert!(!ended.err.contains("error"), "{line}: {}", ended.err);
    }
}

/// Claim: `check` counts what is fine, says the rest on standard error, and gives JSON on demand.
#[test]
fn check() {
    let desk = Desk::new("check");
    desk.write_bad("bad.toml");
    assert_eq!(desk.run("check pendulum.toml dc_motor.toml").is(0).out, "2 of 2 fine\n");
    let ended = desk.run("check pendulum.toml bad.toml").is(1).complains(&["error[DB0202]", "bad.toml:"]);
    assert_eq!(ended.out, "1 of 2 fine\n");
    // A file that is not there, or is no text, says nothing of the others.
    fs::write(desk.path("latin.toml"), b"deadbeat = 1\nname = \"caf\xe9\"\n").expect("a file");
    let ended = desk.run("check pendulum.toml nosuch.toml latin.toml bad.toml").is(1);
    assert_eq!(ended.out, "1 of 4 fine\n");
    ended.complains(&[
        "cannot read `nosuch.toml`",
        "`latin.toml` is not UTF-8: byte 0xe9 in line 2, column 12",
        "bad.toml:",
    ]);
    fs::remove_file(desk.path("latin.toml")).expect("it was there");
    let text = desk.read("bad.toml");
    desk.fed("check -", &text).is(1).complains(&["standard input:"]);
    assert_eq!(desk.fed("check -", &desk.read("pendulum.toml")).is(0).out, "1 of 1 fine\n");

    assert_eq!(desk.run("check pendulum.toml --format json").is(0).json(), Value::Array(Vec::new()));
    let found = desk.run("check bad.toml --format json").is(1).json();
    let line = text.lines().position(|line| line.contains("gravty")).expect("the mistake") + 1;
    assert_eq!(found[0]["code"], "DB0202");
    assert_eq!(found[0]["level"], "error");
    assert_eq!(found[0]["file"], "bad.toml");
    assert_eq!(found[0]["line"], line);
    for key in ["message", "column", "label", "measured", "help", "patch"] {
        assert!(found[0].get(key).is_some(), "{key}");
    }
    assert_eq!(desk.names("."), ["bad.toml", "dc_motor.toml", "pendulum.toml"]);
}

/// Claim: `design` prints constants and certificate, and as JSON the keys of the manual with the
/// shapes of the plant; a bad specification is 1 with nothing on standard output.
#[test]
fn design() {
    let desk = Desk::new("design");
    desk.write_bad("bad.toml");
    let text = desk.run("design dc_motor.toml").is(0).out;
    assert!(text.contains("Converged  from call 101") && text.contains("Numerics"), "{text}");
    let ended = desk.run("design bad.toml --format json").is(1).complains(&["error[DB0202]"]);
    assert!(ended.out.is_empty());

    let json = desk.run("design dc_motor.toml --format json").is(0).json();
    let keys = [
        "deadbeat",
        "name",
        "method",
        "realization",
        "n",
        "inputs",
        "outputs",
        "states",
        "unknowns",
        "sample_time",
        "window_steps",
        "valid_from_step",
        "constants",
        "fir",
        "certificate",
        "cost",
        "numerics",
        "warnings",
    ];
    for key in keys {
        assert!(json.get(key).is_some(), "{key}");
    }
    assert_eq!(json["states"], serde_json::json!(["q", "dq", "i"]));
    assert_eq!((json["n"].as_u64(), json["window_steps"].as_u64()), (Some(3), Some(100)));
    let (k, m) = (json["fir"]["K"].as_array().expect("K"), json["fir"]["M"].as_array().expect("M"));
    assert_eq!((k.len(), m.len()), (101, 101), "ages 0 to N");
    assert_eq!((k[0].as_array().map(Vec::len), k[0][0].as_array().map(Vec::len)), (Some(3), Some(1)));
    let known = json["fir"]["known"].as_array().expect("known").len();
    assert!(m.iter().all(|rows| {
        rows.as_array().is_some_and(|it| it.iter().all(|row| row.as_array().is_some_and(|r| r.len() == known)))
    }));
    // A zero-order hold: what is applied now has not acted yet. (A nonlinear injection has: it is sampled.)
    assert_eq!(json["fir"]["known"][0], "u");
    assert!((0..3).all(|i| m[0][i][0] == 0.0), "{}", m[0]);
    for (part, keys) in [
        ("certificate", &["noise_gain_l1", "noise_gain_l2", "disturbance_gain_l1", "error_bound"][..]),
        ("cost", &["ram_bytes", "flash_bytes", "flops_worst", "flops_mean"]),
        ("numerics", &["digits", "agreement", "condition"]),
    ] {
        for key in keys {
            assert!(!json[part][key].is_null(), "{part}.{key}");
        }
    }
    let double = desk.run("design dc_motor.toml --format json --scalar f64").is(0).json();
    assert_eq!(double["constants"], json["constants"], "the design does not depend on the scalar");
    assert_ne!(double["cost"]["ram_bytes"], json["cost"]["ram_bytes"]);
}

/// Claim: `design --at` prints the gains of one step, the prescribed time included, for people and for machines; a step
/// beyond it, and a method without such gains, are wrong usage that names the way out.
#[test]
fn design_at_a_step() {
    let desk = Desk::new("at");
    for stem in ["differentiator", "oscillator"] {
        fs::copy(root().join(format!("specs/{stem}.toml")), desk.path(&format!("{stem}.toml"))).expect("a copy");
    }
    let text = desk.run("design differentiator.toml --at 250").is(0).out;
    assert!(text.contains("Step 250, 0 steps before the prescribed time; the observer's countdown stops"), "{text}");
    let json = desk.run("design differentiator.toml --at 250 --format json").is(0).json();
    assert_eq!(
        (json["step"].as_u64(), json["left"].as_u64(), json["in_use"].as_bool()),
        (Some(250), Some(0), Some(false))
    );
    assert_eq!(json["Z"][1], serde_json::json!([-100.0, 0.0, 0.0, 0.0]));
    assert_eq!(json["F"][3][0].as_f64(), Some(1e8));
    assert!(json["O"][0][0].is_null());
    let before = desk.run("design differentiator.toml --at 249 --format json").is(0).json();
    assert_eq!((before["O"][0][0].as_f64(), before["in_use"].as_bool()), (Some(769_528.5), Some(true)));
    // At T the error of the oscillator is gone after two calls, as many as it has states.
    let json = desk.run("design oscillator.toml --at 100 --format json").is(0).json();
    let entry = |i: usize, j: usize| json["transition"][i][j].as_f64().expect("a number");
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let terms = [0, 1].map(|k| entry(i, k) * entry(k, j));
        // Of two products of rounded numbers.
        let rounding = 4.0 * f64::EPSILON * terms.iter().map(|x| x.abs()).sum::<f64>();
        assert!(terms.iter().sum::<f64>().abs() <= rounding, "{terms:?}");
    }
    assert_eq!(json["K"][0][0].as_f64(), Some(1.0));
    desk.run("design differentiator.toml --at 251").is(3).complains(&["the prescribed time is step 250"]);
    desk.run("design dc_motor.toml --at 3").is(3).complains(&["`differentiator` and `prescribed-time`"]);
}

/// Claim: `generate` writes both languages by default, and only files that changed.
#[test]
fn generate() {
    let desk = Desk::new("generate");
    let names = ["dc_motor.c", "dc_motor.h", "dc_motor.rs", "pendulum.c", "pendulum.h", "pendulum.rs"];
    let ended = desk.run("generate pendulum.toml dc_motor.toml --out gen").is(0);
    assert_eq!(desk.names("gen"), names);
    assert_eq!(ended.out.lines().filter(|line| line.starts_with("wrote ")).count(), 6, "{}", ended.out);

    let long_ago = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
    let age = |name: &str| {
        let file = fs::File::options().write(true).open(desk.path("gen").join(name)).expect("a file");
        file.set_modified(long_ago).expect("its time");
    };
    let is_old = |name: &str| {
        let time = fs::metadata(desk.path("gen").join(name)).and_then(|it| it.modified()).expect("its time");
        time == long_ago
    };
    for name in names {
        age(name);
    }
    assert_eq!(desk.run("generate pendulum.toml dc_motor.toml --out gen").is(0).out, "nothing has changed\n");
    assert!(names.iter().all(|name| is_old(name)), "files that are right are left alone");
    let edited = desk.read("gen/pendulum.c") + "something else\n";
    desk.write("gen/pendulum.c", &edited);
    let json = desk.run("generate pendulum.toml dc_motor.toml --out gen --format json").is(0).json();
    assert_eq!(json, serde_json::json!({ "written": ["gen/pendulum.c"] }));
    assert!(names.iter().all(|name| is_old(name) == (*name != "pendulum.c")));

    desk.run("generate pendulum.toml --lang step --out deep/er").is(0);
    assert_eq!(desk.names("deep/er"), ["pendulum.step"]);
    desk.fed("generate - --lang c --out piped", &desk.read("pendulum.toml")).is(0);
    assert_eq!(desk.names("piped"), ["pendulum.c", "pendulum.h"]);
    assert_eq!(desk.read("piped/pendulum.c"), desk.read("gen/pendulum.c"));
    desk.run("generate pendulum.toml --lang c --scalar f64 --out double").is(0);
    assert!(desk.read("double/pendulum.h").contains("double theta"));
    desk.write("occupied", "a file where a folder should be");
    desk.run("generate pendulum.toml --out occupied").is(1).complains(&["cannot write into occupied"]);
}

/// Claim: nothing is written when one of two specifications is bad, is not there, or has the other's
/// name.
#[test]
fn generate_writes_all_or_nothing() {
    let desk = Desk::new("all_or_nothing");
    desk.write_bad("bad.toml");
    desk.run("generate pendulum.toml bad.toml --out gen").is(1).complains(&["error[DB0202]", "bad.toml:"]);
    desk.run("generate pendulum.toml nosuch.toml --out gen").is(1).complains(&["nosuch.toml"]);
    desk.write("again.toml", &desk.read("pendulum.toml"));
    let ended = desk.run("generate pendulum.toml again.toml --out gen").is(1);
    ended.complains(&["two specifications are named `pendulum`"]);
    desk.run("verify pendulum.toml again.toml --out gen").is(1).complains(&["two specifications"]);
    assert!(!desk.path("gen").exists());
}

/// Claim: a file that does not say it was generated is not overwritten, and nothing is written beside it; a folder is never
/// called `-`, which is standard output for one file.
#[test]
fn generate_overwrites_nothing_that_it_did_not_make() {
    let desk = Desk::new("by_hand");
    fs::create_dir(desk.path("src")).expect("a folder");
    let by_hand = "/* mine */\nint main(void) { return 0; }\n";
    desk.write("src/dc_motor.c", by_hand);
    let line = "generate pendulum.toml dc_motor.toml --lang c --out src";
    desk.run(line).is(1).complains(&["dc_motor.c was not generated by deadbeat", "not overwritten"]);
    assert_eq!((desk.read("src/dc_motor.c").as_str(), desk.names("src")), (by_hand, vec!["dc_motor.c".to_owned()]));
    fs::remove_file(desk.path("src/dc_motor.c")).expect("it is there");
    desk.run(line).is(0);
    let edited = desk.read("src/dc_motor.c").replace("dc_motor_init", "dc_motor_start");
    desk.write("src/dc_motor.c", &edited);
    assert!(desk.run(line).is(0).out.contains("wrote"), "its own file is replaced");

    let printed = desk.run("generate pendulum.toml --lang step --out -").is(0).out;
    desk.run("generate pendulum.toml --lang step --out src").is(0);
    assert_eq!(printed, desk.read("src/pendulum.step"));
    desk.run("generate pendulum.toml --out -").is(3).complains(&["--out is a folder", "--lang rust"]);
    desk.run("generate pendulum.toml dc_motor.toml --lang rust --out -").is(3).complains(&["--out is a folder"]);
    desk.run("verify pendulum.toml --lang c --out -").is(3).complains(&["--out is the folder"]);
    assert!(!desk.path("-").exists());
}

/// Claim: neither a comment in the specification nor the line ends of a checkout make a file stale; a number does.
#[test]
fn verify_overlooks_comments_and_line_ends() {
    let desk = Desk::new("overlooked");
    desk.run("generate pendulum.toml --out gen").is(0);
    let spec = desk.read("pendulum.toml");
    desk.write("pendulum.toml", &format!("# a remark\n{spec}"));
    for name in desk.names("gen") {
        desk.write(&format!("gen/{name}"), &desk.read(&format!("gen/{name}")).replace('\n', "\r\n"));
    }
    assert!(desk.run("verify pendulum.toml --out gen").is(0).out.contains("up to date"));
    desk.write("pendulum.toml", &spec.replace("64.2189", "64.2190"));
    let stale = desk.run("verify pendulum.toml --lang c --out gen").is(2).out;
    assert!(stale.contains("stale: gen/pendulum.c") && !stale.contains('\r'), "{stale}");
}

/// Claim: `verify` is 0 when all is as generated, and 2 with a unified diff when a file is stale,
/// missing or left over; it touches nothing.
#[test]
fn verify() {
    let desk = Desk::new("verify");
    desk.run("generate pendulum.toml dc_motor.toml --out gen").is(0);
    let line = "verify pendulum.toml dc_motor.toml --out gen";
    assert_eq!(desk.run(line).is(0).out, "gen is up to date\n");
    assert_eq!(desk.run(&format!("{line} --format json")).is(0).json(), serde_json::json!({ "differences": [] }));

    let stale = desk.read("gen/pendulum.c").replacen("0.0f", "1.0f", 1);
    desk.write("gen/pendulum.c", &stale);
    let out = desk.run(line).is(2).out;
    for part in
        ["stale: gen/pendulum.c\n", "--- gen/pendulum.c (on disk)\n", "+++ gen/pendulum.c (generated)\n", "\n@@ -"]
    {
        assert!(out.contains(part), "{part}\n{out}");
    }
    let changed = |sign: char| {
        out.lines()
            .find(|line| line.starts_with(sign) && !line.starts_with([sign; 3].iter().collect::<String>().as_str()))
    };
    assert!(changed('-').is_some_and(|line| line.contains("1.0f")), "{out}");
    assert!(changed('+').is_some_and(|line| line.contains("0.0f")), "{out}");
    assert_eq!(desk.read("gen/pendulum.c"), stale, "verify writes nothing");

    fs::remove_file(desk.path("gen/dc_motor.rs")).expect("a file goes");
    let out = desk.run(line).is(2).out;
    assert!(out.contains("missing: gen/dc_motor.rs\n"), "{out}");

    desk.run(line.replace("verify", "generate").as_str()).is(0);
    desk.write("gen/mine.c", "/* a file that no tool made */\n");
    let out = desk.run("verify dc_motor.toml --out gen").is(2).out;
    let left_over: Vec<&str> =
        out.lines().filter_map(|line| line.strip_prefix("left over, no specification makes it: ")).collect();
    assert_eq!(left_over, ["gen/pendulum.c", "gen/pendulum.h", "gen/pendulum.rs"], "{out}");
    assert_eq!(desk.run("verify dc_motor.toml pendulum.toml --lang rust --out gen").is(0).out, "gen is up to date\n");
    let json = desk.run("verify dc_motor.toml --lang rust --out gen --format json").is(2).json();
    assert_eq!(json, serde_json::json!({ "differences": [{ "kind": "left over", "path": "gen/pendulum.rs" }] }));
    let json = desk.run("verify dc_motor.toml --lang step --out nosuch --format json").is(2).json();
    assert_eq!(json["differences"][0]["kind"], "missing");
    desk.write_bad("bad.toml");
    desk.run("verify bad.toml --out gen").is(1).complains(&["error[DB0202]"]);
}

/// Claim: `list` shows every method of the registry, with its page, and JSON on demand.
#[test]
fn list() {
    let desk = Desk::new("list");
    let (text, json) = (desk.run("list").is(0).out, desk.run("list --format json").is(0).json());
    assert_eq!(json["scalars"], serde_json::json!(["f32", "f64"]));
    assert_eq!(json["methods"].as_array().map(Vec::len), Some(METHODS.len()));
    for (place, method) in METHODS.iter().enumerate() {
        assert!(text.contains(method.name) && text.contains(method.summary) && text.contains(method.source), "{text}");
        let listed = &json["methods"][place];
        assert_eq!((listed["name"].as_str(), listed["summary"].as_str()), (Some(method.name), Some(method.summary)));
        assert_eq!(listed["keys"].as_array().map(Vec::len), Some(method.keys.len()));
        let page = desk.run(&format!("list {}", method.name)).is(0).out;
        for word in method.keys.iter().flat_map(|(key, _, meaning)| [key, meaning]) {
            assert!(page.contains(word), "{page}");
        }
        for (name, _) in method.realizations {
            assert!(page.contains(name), "{page}");
        }
        assert_eq!(desk.run(&format!("list {} --format json", method.name)).is(0).json(), *listed);
    }
    desk.run("list windw").is(3).complains(&["there is no method `windw`; did you mean `window`?"]);
    desk.run("list nosuch").is(3).complains(&["there is no method `nosuch`", METHODS[0].name]);
}

/// Claim: `run` writes the estimate row by row with its status; an empty cell, `nan` and `inf` are
/// missing samples, which are bridged once converged.
#[test]
fn run_writes_the_estimate() {
    let desk = Desk::new("run");
    let mut rows = swing(400);
    for (row, cell) in [(120, ""), (200, "nan"), (201, "NaN"), (260, "inf"), (261, "-inf")] {
        rows[row] = format!("{},{cell}", rows[row].split(',').next().expect("its time"));
    }
    desk.write("log.csv", &recording(&rows));
    let ended = desk.run("run pendulum.toml --log log.csv --out est.csv").is(0);
    assert!(ended.out.contains("400 rows, 350 of them converged (from call 51)"), "{}", ended.out);

    let estimate = desk.read("est.csv");
    let mut lines = estimate.lines();
    assert_eq!(lines.next(), Some("t,theta,omega,status"));
    let cells: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(cells.len(), 400);
    // The window has 51 samples: a missing one is in the next 51 windows.
    let coasting = |row: usize| [120, 200, 201, 260, 261].iter().any(|missing| (*missing..missing + 51).contains(&row));
    for (row, cells) in cells.iter().enumerate() {
        let status = if row < 50 {
            "converging"
        } else if coasting(row) {
            "coasting"
        } else {
            "converged"
        };
        assert_eq!((cells.len(), cells[3]), (4, status), "row {row}");
        assert_eq!(cells[0], rows[row].split(',').next().expect("its time"));
        let number = |cell: &str| cell.parse::<f64>().expect("a number");
        assert!(number(cells[1]).is_finite() && number(cells[2]).is_finite(), "row {row}");
    }
    assert_eq!(cells[0][2], "0", "before convergence, the initial value");
    assert_eq!(desk.names("."), ["dc_motor.toml", "est.csv", "log.csv", "pendulum.toml"]);

    // Without times, rows are at the sample time; standard input and output stand for files.
    let untimed: String =
        recording(&rows).lines().map(|line| line.split_once(',').expect("two cells").1.to_owned() + "\n").collect();
    let untimed = untimed.replace("\n\n", "\n\"\"\n");
    let piped = desk.fed("run pendulum.toml --log - --out -", &untimed).is(0);
    assert!(piped.err.contains("400 rows"), "the report gives way to the file: {}", piped.err);
    let without_time =
        |text: &str| text.lines().map(|line| line.split_once(',').expect("cells").1.to_owned()).collect::<Vec<_>>();
    assert_eq!(without_time(&piped.out), without_time(&estimate));
}

/// Claim: `--map` reads a column under another name, `--reference` compares with one, and the report
/// has RMS and maximum over the converged rows, also as JSON.
#[test]
fn run_compares() {
    let desk = Desk::new("compare");
    let rows: Vec<String> = swing(300);
    let named = rows.iter().map(|row| row.clone() + ",2.5").collect::<Vec<_>>().join("\n");
    desk.write("log.csv", &format!("t,encoder,speed\n{named}\n"));
    let line = "run pendulum.toml --log log.csv --map theta=encoder --reference omega=speed";
    let text = desk.run(line).is(0).out;
    assert!(text.contains("error of") && text.contains("omega") && text.contains("rad/s"), "{text}");
    let json = desk.run(&format!("{line} --format json")).is(0).json();
    assert_eq!((json["rows"].as_u64(), json["converged_rows"].as_u64()), (Some(300), Some(250)));
    let errors = json["errors"].as_object().expect("errors");
    assert_eq!(errors.keys().collect::<Vec<_>>(), ["omega"], "only what has a reference");
    // The true speed is at most 0.08 rad/s; the reference says 2.5.
    let (rms, max) = (errors["omega"]["rms"].as_f64().expect("rms"), errors["omega"]["max"].as_f64().expect("max"));
    assert!((2.3..2.7).contains(&rms) && rms <= max && max < 2.7, "{rms} {max}");
    let state = desk.run("run pendulum.toml --log log.csv --map theta=encoder").is(0).out;
    assert!(state.contains("nothing to compare"), "{state}");

    desk.run("run pendulum.toml --log log.csv --map tetha=encoder").is(3).complains(&["--map", "`tetha`"]);
    desk.run("run pendulum.toml --log log.csv --reference speed=speed").is(3).complains(&["--reference", "`speed`"]);
    desk.run("run pendulum.toml --log log.csv").is(1).complains(&["there is no column `theta`", "`encoder`"]);
    desk.write("near.csv", "t,teta\n0,1\n");
    desk.run("run pendulum.toml --log near.csv")
        .is(1)
        .complains(&["there is no column `theta`", "did you mean `teta`?"]);
}

/// Claim: a state that is named like its output is not compared with the noisy measurement, unless `--reference` says
/// so; a column of the state's name is compared when the step reads another one.
#[test]
fn run_compares_no_state_with_its_own_measurement() {
    let desk = Desk::new("own_measurement");
    desk.write("log.csv", &recording(&swing(300)));
    let errors =
        |line: &str| desk.run(&format!("run pendulum.toml {line} --format json")).is(0).json()["errors"].clone();
    assert_eq!(errors("--log log.csv"), serde_json::json!({}));
    desk.run("run pendulum.toml --log log.csv").is(0).out.find("nothing to compare").expect("it says so");
    let asked = errors("--log log.csv --reference theta=theta");
    assert!(asked["theta"]["rms"].as_f64().is_some_and(|rms| rms > 0.0), "{asked}");
    // The encoder is another column: `theta` is the truth.
    let rows: Vec<String> = swing(300).iter().map(|row| format!("{row},3.1")).collect();
    desk.write("two.csv", &format!("t,theta,encoder\n{}\n", rows.join("\n")));
    let apart = errors("--log two.csv --map theta=encoder");
    assert!(apart["theta"]["rms"].as_f64().is_some_and(|rms| (0.03..0.06).contains(&rms)), "{apart}");
}

/// Claim: a mistake in a recording is named by line and column, ends with 1, and leaves neither the
/// estimate nor a part of it nor a figure; an estimate of an earlier run stays as it was.
#[test]
fn run_names_mistakes_and_leaves_nothing() {
    let desk = Desk::new("mistakes");
    let good = swing(300);
    let with = |row: usize, text: &str| {
        let mut rows = good.clone();
        text.clone_into(&mut rows[row]);
        recording(&rows)
    };
    let slow: Vec<String> = swing(600).into_iter().step_by(2).collect();
    let cases: [(&str, String, &[&str]); 8] = [
        ("ragged", with(200, "0.2"), &["log.csv:202:", "column `theta`", "the row has 1 cell, the header has 2"]),
        ("too long", with(200, "0.2,3,4"), &["log.csv:202:", "the row has 3 cells, the header has 2"]),
        ("not a number", with(200, "0.2,3.1x"), &["log.csv:202:", "column `theta`", "`3.1x` is not a number", "help:"]),
        ("time runs back", with(200, "0.1,3.1"), &["log.csv:202:", "time does not rise"]),
        ("time jumps", with(299, "1e9,3.1"), &["log.csv:301:", "jumps"]),
        ("wrong rate", recording(&slow), &["log.csv:", "rows are 0.002000 s apart", "sample time is 0.001 s"]),
        ("no rows", "t,theta\n".to_owned(), &["the recording has no rows"]),
        ("no header", String::new(), &["there is no header row"]),
    ];
    desk.write("kept.csv", "of an earlier run\n");
    for (what, text, words) in cases {
        desk.write("log.csv", &text);
        let ended = desk.run("run pendulum.toml --log log.csv --out est.csv --plot est.svg").is(1);
        assert!(ended.out.is_empty(), "{what}: {}", ended.out);
        ended.complains(words);
        desk.run("run pendulum.toml --log log.csv --out kept.csv").is(1);
        assert_eq!(desk.read("kept.csv"), "of an earlier run\n", "{what}");
        assert_eq!(desk.names("."), ["dc_motor.toml", "kept.csv", "log.csv", "pendulum.toml"], "{what}");
    }
    desk.write("log.csv", &recording(&good));
    desk.run("run pendulum.toml --log log.csv --out nosuch/est.csv").is(1).complains(&["cannot write"]);
    desk.run("run pendulum.toml --log log.csv --out est.csv --plot nosuch/est.svg").is(1).complains(&["cannot write"]);
    assert!(!desk.names(".").iter().any(|name| name.starts_with("est")), "{:?}", desk.names("."));
}

/// Claim: a recording whose rows each look near the sample time is still refused when its mean rate
/// is another one, with the measured spacing and a way out; jitter, a drifting clock and gaps are
/// fine and make no missing samples of their own.
#[test]
fn run_refuses_another_rate() {
    let desk = Desk::new("rate");
    let at = |time: &dyn Fn(f64) -> f64| {
        let rows: Vec<String> = (0..3000).map(|k| format!("{:.9},3.1", time(f64::from(k) * 1e-3))).collect();
        recording(&rows)
    };
    // The mean is that of the whole recording, of which 1 % and two samples would be drift.
    for (factor, spacing) in [(1.3, "0.001300 s"), (0.8, "0.000800 s"), (1.02, "0.001020 s")] {
        desk.write("log.csv", &at(&|t| 5.0 + factor * t));
        let words = ["log.csv:", spacing, "sample time is 0.001 s", "help:", "`sample_time`", "resample"];
        desk.run("run pendulum.toml --log log.csv --out est.csv").is(1).complains(&words);
        assert!(!desk.path("est.csv").exists(), "{factor}");
    }
    // Behind a gap too: its samples are steps.
    desk.write("log.csv", &at(&|t| if t < 1.5 { t } else { t + 0.3 + 0.3 * (t - 1.5) }));
    desk.run("run pendulum.toml --log log.csv").is(1).complains(&["log.csv:", "in the mean", "help:"]);

    for factor in [1.001, 0.999] {
        desk.write("log.csv", &at(&|t| 1.7e9 + factor * t));
        let out = desk.run("run pendulum.toml --log log.csv").is(0).out;
        assert!(out.contains("3000 rows") && !out.contains("leaves out"), "{factor}: {out}");
    }
    desk.write("log.csv", &at(&|t| t + 2e-4 * (1e4 * t).sin()));
    assert!(!desk.run("run pendulum.toml --log log.csv").is(0).out.contains("leaves out"));
    // The row behind the pause is at 1800.36 samples by its own time, or at 1800.9, of which 0.35 were drift before it.
    for (factor, left_out) in [(1.0002, "300 samples"), (1.0005, "301 samples")] {
        desk.write("log.csv", &at(&|t| factor * if t < 1.5 { t } else { t + 0.3 }));
        let out = desk.run("run pendulum.toml --log log.csv").is(0).out;
        assert!(out.contains(&format!("{left_out} that the recording's time")), "{factor}: {out}");
    }
}

/// Claim: what was never compared has no error, rather than a perfect one, and the figure counts the
/// rows that were compared.
#[test]
fn run_scores_only_what_it_compared() {
    let desk = Desk::new("scores");
    // The estimate is converged in rows 50 to 299; theta is compared in 50 to 149, omega in those of `omega`.
    let write = |theta: &dyn Fn(usize) -> bool, omega: &dyn Fn(usize) -> bool| {
        let cell = |there: bool| if there { "0.5" } else { "" };
        let rows = swing(300).into_iter().enumerate();
        let rows: Vec<String> = rows.map(|(k, row)| format!("{row},{},{}", cell(theta(k)), cell(omega(k)))).collect();
        desk.write("log.csv", &format!("t,theta,angle,omega\n{}\n", rows.join("\n")));
    };
    let line = "run pendulum.toml --log log.csv --reference theta=angle";
    write(&|k| k < 150, &|k| k < 50);
    let json = desk.run(&format!("{line} --format json")).is(0).json();
    assert_eq!(json["errors"]["omega"], serde_json::json!({ "rms": null, "max": null }));
    assert!(json["errors"]["theta"]["rms"].is_f64() && json["errors"]["theta"]["max"].is_f64(), "{json}");
    let text = desk.run(&format!("{line} --plot out.svg")).is(0).out;
    let row = |name: &str| {
        let found = text.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("{name}\n{text}"));
        found.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(row("omega")[1..], ["-", "-", "0", "rad/s"]);
    assert_eq!(row("theta")[3..], ["100", "rad"]);
    let words = |svg: &str| {
        let start = svg.find("<desc").expect("a description");
        svg[start..].split("</desc>").next().expect("it ends").split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let svg = desk.read("out.svg");
    assert!(svg.contains("- RMS, - maximum"), "the panel's title");
    let said = words(&svg);
    for part in ["error over converged rows: theta ", " rad over 100; ", "omega - RMS, - maximum rad/s over 0"] {
        assert!(said.contains(part), "{part}\n{said}");
    }

    write(&|k| k < 150, &|k| k < 150);
    desk.run(&format!("{line} --plot out.svg")).is(0);
    let said = words(&desk.read("out.svg"));
    assert!(said.contains("error over 100 converged rows: theta "), "{said}");
}

/// Claim: `run` refuses to write a file that it reads, or one file twice, under whatever name.
#[test]
fn run_overwrites_nothing_that_it_reads() {
    let desk = Desk::new("overwrite");
    let (log, spec) = (recording(&swing(300)), desk.read("pendulum.toml"));
    desk.write("log.csv", &log);
    fs::create_dir(desk.path("sub")).expect("a folder");
    let whole = desk.path("log.csv");
    for (rest, words) in [
        ("--out log.csv".to_owned(), ["--out", "--log"]),
        ("--out ./sub/../log.csv".to_owned(), ["--out", "--log"]),
        (format!("--plot {}", whole.display()), ["--plot", "--log"]),
        ("--out ./pendulum.toml".to_owned(), ["--out", "the specification"]),
        ("--plot pendulum.toml".to_owned(), ["--plot", "the specification"]),
        ("--out new --plot new".to_owned(), ["--plot", "--out"]),
        ("--out new --plot ./sub/../new".to_owned(), ["--plot", "--out"]),
        ("--out nosuch/new --plot nosuch/new".to_owned(), ["--plot", "--out"]),
    ] {
        let ended = desk.run(&format!("run pendulum.toml --log log.csv {rest}")).is(3).complains(&words);
        assert!(ended.out.is_empty(), "{rest}: {}", ended.out);
    }
    assert_eq!((desk.read("log.csv"), desk.read("pendulum.toml")), (log.clone(), spec));
    assert_eq!(desk.names("."), ["dc_motor.toml", "log.csv", "pendulum.toml", "sub"], "nothing was written");
    // Standard input is not standard output, and a file of that name elsewhere is another file.
    desk.fed("run pendulum.toml --log - --out -", &log).is(0);
    desk.run("run pendulum.toml --log log.csv --out sub/log.csv").is(0);
}

/// Claim: samples that the recording's time leaves out are missing samples, and are counted.
#[test]
fn run_bridges_gaps_in_time() {
    let desk = Desk::new("gaps");
    let rows: Vec<String> =
        swing(400).into_iter().enumerate().filter(|(k, _)| !(200..210).contains(k)).map(|it| it.1).collect();
    desk.write("log.csv", &recording(&rows));
    let ended = desk.run("run pendulum.toml --log log.csv --out est.csv").is(0);
    assert!(ended.out.contains("10 samples that the recording's time leaves out"), "{}", ended.out);
    let estimate = desk.read("est.csv");
    let status = |t: &str| {
        estimate.lines().find(|line| line.starts_with(&format!("{t},"))).and_then(|line| line.rsplit(',').next())
    };
    assert_eq!(status("0.199"), Some("converged"));
    assert_eq!(status("0.205"), None, "no row, no estimate");
    assert_eq!(
        (status("0.21"), status("0.259"), status("0.26")),
        (Some("coasting"), Some("coasting"), Some("converged"))
    );
}

/// Claim: the figure is well-formed XML that a screen reader can name and describe; its texts are
/// the specification's.
#[test]
fn run_plots() {
    let desk = Desk::new("plot");
    let odd = desk.read("pendulum.toml").replace("title = \"Velocity", "title = \"<A & B> Velocity");
    desk.write("pendulum.toml", &odd);
    desk.write("log.csv", &recording(&swing(400)));
    desk.run("run pendulum.toml --log log.csv --plot out.svg").is(0);
    let svg = desk.read("out.svg");
    let elements = well_formed(&svg);
    assert_eq!(elements[0], "svg");
    assert_eq!(elements.iter().filter(|it| *it == "title").count(), 1);
    assert_eq!(elements.iter().filter(|it| *it == "desc").count(), 1);
    assert!(svg.contains("&lt;A &amp; B&gt; Velocity"), "the title is escaped");
    assert!(elements.contains(&"path".to_owned()) && svg.contains("omega"), "curves and their names");
    let piped = desk.run("run pendulum.toml --log log.csv --plot -").is(0);
    assert_eq!(piped.out, svg);
    desk.run("run pendulum.toml --log log.csv --plot - --out -").is(3);
    assert_eq!(desk.names("."), ["dc_motor.toml", "log.csv", "out.svg", "pendulum.toml"]);
}

/// The elements of an XML document, in order.
///
/// # Panics
/// If tags do not nest, an attribute is not quoted or given twice, or a sign is not escaped.
fn well_formed(text: &str) -> Vec<String> {
    let text = text.trim_start();
    let text = if text.starts_with("<?xml") { text.split_once("?>").expect("the declaration ends").1 } else { text };
    let (mut open, mut seen) = (Vec::new(), Vec::new());
    for piece in text.trim().split('<').skip(1) {
        let (tag, content) = piece.split_once('>').expect("a tag ends");
        assert!(!content.contains('>') && escapes(content), "text: {content}");
        assert!(!open.is_empty() || seen.is_empty() || tag.starts_with('/'), "one root: {tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "tags nest");
            continue;
        }
        let (name, attributes) = tag.trim_end_matches('/').split_once(' ').unwrap_or((tag.trim_end_matches('/'), ""));
        let mut names = Vec::new();
        let mut rest = attributes.trim();
        while !rest.is_empty() {
            let (attribute, behind) = rest.split_once("=\"").expect("a quoted attribute");
            let (value, behind) = behind.split_once('"').expect("the quote ends");
            assert!(escapes(value) && !names.contains(&attribute), "{tag}");
            names.push(attribute);
            rest = behind.trim_start();
        }
        seen.push(name.to_owned());
        if !tag.ends_with('/') {
            open.push(name.to_owned());
        }
    }
    assert!(open.is_empty(), "{open:?} does not end");
    seen
}

/// Whether every `&` begins an entity of XML.
fn escapes(text: &str) -> bool {
    let entities = ["amp;", "lt;", "gt;", "quot;", "apos;", "#"];
    text.split('&').skip(1).all(|behind| entities.iter().any(|entity| behind.starts_with(entity)))
}

/// Claim: the recording of the repository runs as the README says.
#[test]
fn run_on_the_recording_of_the_repository() {
    let desk = Desk::new("recorded");
    let log: &Path = &root().join("specs/data/pendulum_free_swing_1khz.csv");
    let header = fs::read_to_string(log).expect("the recording");
    let columns = header.lines().find(|line| !line.starts_with('#')).expect("a header");
    assert!(columns.contains("theta"), "{columns}");
    let ended = desk.run(&format!("run pendulum.toml --log {} --format json", log.display())).is(0);
    let json = ended.json();
    assert!(json["rows"].as_u64() > Some(50_000) && json["rows"].as_u64() > json["converged_rows"].as_u64());
}

/// Claim: the time may have another name, and a recording without one is said to be taken at the sample time.
#[test]
fn run_finds_the_time_or_says_that_there_is_none() {
    let desk = Desk::new("time");
    let rows: Vec<String> = (0..200).map(|k| format!("{:.3},3.1", f64::from(2 * k) * 1e-3)).collect();
    desk.write("log.csv", &recording(&rows).replacen("t,", "seconds,", 1));
    let out = desk.run("run pendulum.toml --log log.csv").is(0).out;
    assert!(out.contains("no column `t`: its rows are taken to be 0.001 s apart"), "{out}");
    desk.run("run pendulum.toml --log log.csv --map t=seconds").is(1).complains(&["sample time is 0.001 s"]);
    desk.run("run pendulum.toml --log log.csv --map t=minutes").is(1).complains(&["minutes"]);
}
