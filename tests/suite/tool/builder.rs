//! Claim: a build script can ask for all that `deadbeat generate` can: several specifications, patterns, languages, float
//! type, folder; what it gets are the same files; and whatever is wrong, nothing is written and the report says it all.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::{Build, Language, Report};

use super::doors::{expected, motor, rust_call, rust_main};
use crate::support::corpus::{cargo, empty_folder, put, root, succeed};

/// The specification of the motor under another name.
fn named(name: &str) -> String {
    let text = motor().replacen("name = \"dc_motor\"", &format!("name = \"{name}\""), 1);
    assert!(text.contains(name), "the specification has a name");
    text
}

/// A folder `specs` with the motor twice, as `first` and `second`, a hidden file and one that is no specification.
pub fn two_motors(test: &str) -> PathBuf {
    let folder = empty_folder(test);
    put(&folder.join("specs/a.toml"), &named("first"));
    put(&folder.join("specs/b.toml"), &named("second"));
    put(&folder.join("specs/.c.toml"), "not finished");
    put(&folder.join("specs/notes.txt"), "not a specification");
    folder
}

/// What is said of a request that cannot be met, and that its folder was not made.
fn refused(build: Build, out: &Path) -> (Report, String) {
    let report = build.out_dir(out).run().expect_err("it cannot be met");
    assert!(!out.exists(), "something was written into {}", out.display());
    assert!(report.has_errors());
    let text = report.render(false);
    (report, text)
}

/// Claim: the builder's files are those of the command line, byte for byte, whichever way the specifications are named.
#[test]
fn the_command_line_s_files() {
    let folder = two_motors("builder_same");
    let (specs, out) = (folder.join("specs"), folder.join("built"));
    let languages = |build: Build| build.language(Language::Rust).language(Language::C).language(Language::Step);
    let build = languages(Build::new().spec(specs.join("b.toml")).specs(specs.join("*.toml")).scalar(Scalar::F64));
    let paths = build.clone().out_dir(&out).run().unwrap_or_else(|report| panic!("{}", report.render(false)));
    let names = ["rs", "h", "c", "step"].map(|suffix| ["second", "first"].map(|name| format!("{name}.{suffix}")));
    let order: Vec<PathBuf> =
        (0..2).flat_map(|spec| names.iter().map(move |it| &it[spec])).map(|it| out.join(it)).collect();
    assert_eq!(paths, order);

    let generated = folder.join("generated");
    let mut generate = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
    generate.arg("generate").args(["a.toml", "b.toml"].map(|name| specs.join(name))).args(["--scalar", "f64"]);
    generate.args(["--lang", "rust", "--lang", "c", "--lang", "step", "--out"]).arg(&generated);
    succeed(&mut generate);
    for path in &paths {
        let same = generated.join(path.file_name().expect("a file"));
        assert_eq!(fs::read_to_string(path).expect("built"), fs::read_to_string(same).expect("generated"));
    }

    let changed = || fs::metadata(&paths[0]).and_then(|it| it.modified()).expect("a time");
    let before = changed();
    assert_eq!(build.out_dir(&out).run(), Ok(order), "all files, also where none has changed");
    assert_eq!(changed(), before, "a file that has not changed is not touched");
    let rust = Build::new().specs(&specs).out_dir(folder.join("rust")).run().expect("a folder is a pattern");
    assert_eq!(rust, ["first.rs", "second.rs"].map(|name| folder.join("rust").join(name)));
}

/// Claim: one wrong specification of several, and one that is not there, keep all from being written, and one report
/// says both with their places.
#[test]
fn all_or_nothing() {
    let folder = two_motors("builder_wrong");
    let specs = folder.join("specs");
    put(&specs.join("b.toml"), &named("second").replace("b1*i - a1*sin(q)", "b1*i - a1*sin(r)"));
    let (report, text) =
        refused(Build::new().specs(specs.join("*.toml")).spec(specs.join("c.toml")), &folder.join("out"));
    assert_eq!(report.others.len(), 1, "{text}");
    assert!(text.contains("error[DB0202]") && text.contains("b.toml:"), "{text}");
    assert!(text.contains("error[DB0501]") && text.contains("c.toml"), "{text}");
    let json = report.to_json().to_string();
    assert!(["DB0202", "DB0501"].iter().all(|code| json.contains(code)), "{json}");
}

/// Claim: what cannot be met is an error with a way out.
#[test]
fn requests_that_cannot_be_met() {
    let folder = two_motors("builder_refused");
    let (specs, out) = (folder.join("specs"), folder.join("out"));
    let says = |build: Build, words: &[&str]| {
        let (report, text) = refused(build, &out);
        assert!(words.iter().all(|word| text.contains(word)), "{words:?}\n{text}");
        assert!(report.diagnostics.iter().all(|it| it.help.is_some()), "{text}");
    };
    says(Build::new(), &["DB0502", "no specification", ".spec("]);
    says(Build::new().spec(specs.join("c.toml")), &["DB0501", "cannot read", "c.toml", "Cargo.toml"]);
    says(Build::new().specs(specs.join("*.tml")), &["DB0502", "no file fits", "*.tml"]);
    says(Build::new().specs(folder.join("sp*/a.toml")), &["DB0501", "cannot read the folder", "the last part"]);
    put(&specs.join("b.toml"), &named("first"));
    says(Build::new().specs(&specs), &["DB0502", "a.toml` and `", "b.toml` are both named `first`"]);
    assert!(std::env::var_os("OUT_DIR").is_none(), "this package has no build script");
    let report = Build::new().spec(specs.join("a.toml")).run().expect_err("no folder");
    assert!(report.render(false).contains("OUT_DIR"));
    // A file stands where the folder should be.
    let report = Build::new().spec(specs.join("a.toml")).out_dir(specs.join("notes.txt")).run().expect_err("a file");
    assert!(report.render(false).contains("cannot write into"), "{}", report.render(false));
}

/// Claim: a file that is asked for twice is one file, however it is written; the command line takes it so too. Two files
/// of one name stay a mistake.
#[test]
fn a_file_that_is_asked_for_twice_is_one() {
    let folder = two_motors("builder_twice");
    let specs = folder.join("specs");
    let again = specs.join("../specs/./a.toml");
    let built = Build::new().spec(specs.join("a.toml")).spec(&again).specs(specs.join("./*.toml"));
    let built = built.out_dir(folder.join("built")).run().unwrap_or_else(|report| panic!("{}", report.render(false)));
    assert_eq!(built, ["first.rs", "second.rs"].map(|name| folder.join("built").join(name)));
    let generate = |arguments: &[&Path]| {
        let mut generate = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
        generate.arg("generate").args(arguments).args(["--lang", "rust", "--out"]).arg(folder.join("generated"));
        generate.output().expect("it runs")
    };
    let output = generate(&[&specs.join("a.toml"), &again, &specs]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(String::from_utf8_lossy(&output.stdout).lines().count(), 2);
    put(&folder.join("copy.toml"), &named("first"));
    let output = generate(&[&specs.join("a.toml"), &folder.join("copy.toml")]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("two specifications are named `first`"));
    let output = generate(&[&specs.join("*.tml")]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("no file fits the pattern"));
}

/// Claim: in a real build script, Rust for `include!` goes to `OUT_DIR` and C where it is asked for; both give the bits
/// of the interpreter, and cargo runs the script again when a specification or a pattern's folder changes.
#[test]
fn a_real_build_script() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("builder_user");
    put(&folder.join("motor.toml"), &motor());
    put(&folder.join("more/a.toml"), &named("first"));
    let (runtime, codegen) = (root().join("runtime").display().to_string(), root().display().to_string());
    let manifest = format!(
        "[package]\nname = \"builder_user\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\ndeadbeat = {{ path = {runtime:?} }}\n\n\
         [build-dependencies]\ndeadbeat-codegen = {{ path = {codegen:?}, default-features = false }}\n\n\
         [profile.dev]\ndebug = false\n\n[profile.dev.build-override]\ndebug = false\n"
    );
    put(&folder.join("Cargo.toml"), &manifest);
    if !folder.join("Cargo.lock").exists() {
        fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
    }
    let script = "use deadbeat_codegen::{Build, Language, Report, program::Scalar};

fn all() -> Result<(), Report> {
    Build::new().spec(\"motor.toml\").specs(\"more/*.toml\").scalar(Scalar::F64).run()?;
    Build::new().spec(\"motor.toml\").language(Language::C).out_dir(\"c\").run().map(drop)
}

fn main() {
    all().unwrap_or_else(|report| panic!(\"{}\", report.render(false)));
}
";
    put(&folder.join("build.rs"), script);
    let module = |name: &str| format!("mod {name} {{\n    include!(concat!(env!(\"OUT_DIR\"), \"/{name}.rs\"));\n}}\n");
    let calls = rust_call("dc_motor", "f64") + &rust_call("first", "f64") + "    println!(env!(\"OUT_DIR\"));\n";
    put(&folder.join("src/main.rs"), &rust_main(&(module("dc_motor") + &module("first")), &calls));

    // The folder of the other build scripts: the generator is built there already, or will be once.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("doors_target");
    let printed = succeed(cargo(&folder, &target).args(["run", "--offline", "--quiet"]));
    let bits = expected(Scalar::F64).repeat(2);
    let out = printed.strip_prefix(&bits).unwrap_or_else(|| panic!("{printed}\nbut should be\n{bits}"));
    let told = fs::read_to_string(Path::new(out.trim()).with_file_name("output")).expect("what the script printed");
    for path in ["motor.toml", "more", "more/a.toml"] {
        assert!(told.lines().any(|line| line == format!("cargo::rerun-if-changed={path}")), "{path}:\n{told}");
    }
    let c = fs::read_to_string(folder.join("c/dc_motor.c")).expect("the file in C");
    let own = fs::read_to_string(root().join("generated/c/dc_motor.c")).expect("the same of the corpus");
    // They differ in what they say of where they come from.
    let code = |text: &str| text[text.find("#include").expect("code")..].to_owned();
    assert_eq!(code(&c), code(&own));
}
