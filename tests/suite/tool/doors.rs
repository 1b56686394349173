//! Claim: every way into a user's project works as the README says: a build script, a macro, C and
//! C++; and a mistake in the specification reaches the user with its place.
//!
//! The cargo projects are one workspace with a target folder that stays, so that the generator is
//! built once.

use crate::support::pages::Page;
use crate::support::{compile, corpus};

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use compile::c_compilers;
use corpus::{cargo, empty_folder, put, root, runs, succeed};
use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Generator, Settings};

/// Calls of the observer in each user's program: more than the window.
const CALLS: u32 = 300;

/// The specification that the users have.
pub(super) fn motor() -> String {
    fs::read_to_string(root().join("specs/dc_motor.toml")).expect("a specification of the corpus")
}

/// The same with a mistake, and the line that it is in.
fn wrong_motor() -> (String, usize) {
    let text = motor();
    let wrong = text.replace("b1*i - a1*sin(q)", "b1*i - a1*sin(r)");
    let line = wrong.lines().position(|line| line.contains("sin(r)")).expect("the mistake") + 1;
    (wrong, line)
}

/// What every user's program prints: the last estimate of the same samples, as the interpreter has it.
///
/// The samples are quotients of small integers by powers of two: the same in every language.
pub(super) fn expected(scalar: Scalar) -> String {
    let generator = Generator::new(&motor(), "motor.toml").with(Settings { scalar: Some(scalar) });
    let program = generator.design().unwrap_or_else(|report| panic!("{}", report.render(false))).program;
    let mut interpreter = Interpreter::new(&program);
    let mut estimate = [0.0; 3];
    let mut status = None;
    for call in 0..CALLS {
        let (y, u) = (f64::from(call * 37 % 101) / 1024.0, f64::from(call % 7) - 3.0);
        status = Some(interpreter.step(&[y], &[u], &mut estimate));
    }
    #[expect(clippy::cast_possible_truncation, reason = "an estimate of the f32 Program is an f32")]
    let bits = |x: f64| match scalar {
        Scalar::F32 => u64::from((x as f32).to_bits()),
        Scalar::F64 => x.to_bits(),
    };
    let [q, dq, i] = estimate.map(bits);
    format!("{q:x} {dq:x} {i:x} {}\n", status.map_or(9, |it| it as u8))
}

/// A Rust main function that drives an observer of `module` through the trait.
pub(super) fn rust_main(modules: &str, calls: &str) -> String {
    format!(
        "#![deny(warnings)] // of unused items too, in modules that nobody exports
{modules}

/// Generic code: it knows the trait and nothing of the motor.
fn replay<O: deadbeat::Observer>(mut observer: O, sample: impl Fn(u32) -> (O::Measurements, O::Inputs)) -> Option<O::Estimate> {{
    assert!(O::SAMPLE_TIME == 1e-3);
    (0..{CALLS}).map(|call| {{
        let (measurements, inputs) = sample(call);
        observer.step(measurements, inputs)
    }}).last()
}}

fn main() {{
{calls}}}
"
    )
}

/// The statements that replay one module's observer and print its last estimate.
pub(super) fn rust_call(module: &str, scalar: &str) -> String {
    format!(
        "    let estimate = replay({module}::Observer::new(), |call| {{
        let y = (f64::from(call * 37 % 101) / 1024.0) as {scalar};
        let u = (f64::from(call % 7) - 3.0) as {scalar};
        ({module}::Measurements {{ y }}, {module}::Inputs {{ u }})
    }}).expect(\"calls\");
    println!(\"{{:x}} {{:x}} {{:x}} {{}}\", estimate.q.to_bits(), estimate.dq.to_bits(), estimate.i.to_bits(), estimate.status as u8);
"
    )
}

/// The workspace of the Rust users: one with a build script, one with the macro, and each with a mistake.
fn users() -> &'static Path {
    static USERS: OnceLock<PathBuf> = OnceLock::new();
    USERS.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("doors_users");
        let members = ["built", "built_wrong", "expanded", "expanded_wrong", "expanded_unknown", "readme"];
        let workspace = format!("[workspace]\nresolver = \"3\"\nmembers = {members:?}\n\n[profile.dev]\ndebug = false\n\n[profile.dev.build-override]\ndebug = false\n");
        put(&folder.join("Cargo.toml"), &workspace);
        // The versions that this repository was built with are the ones that are there.
        if !folder.join("Cargo.lock").exists() {
            fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
        }
        let (runtime, codegen) = (root().join("runtime").display().to_string(), root().display().to_string());
        let built = format!(
            "edition = \"2024\"\n\n[dependencies]\ndeadbeat = {{ path = {runtime:?} }}\n\n[build-dependencies]\n\
             deadbeat-codegen = {{ path = {codegen:?}, default-features = false }}\n"
        );
        let expanded = format!("edition = \"2024\"\n\n[dependencies]\ndeadbeat = {{ path = {runtime:?}, features = [\"macros\"] }}\n");
        let both = built.replace("/runtime\" }", "/runtime\", features = [\"macros\"] }");
        let readme = Page::read("README.md");
        for name in members {
            let dependencies = if name.starts_with("built") { &built } else { &expanded };
            let dependencies = if name == "readme" { &both } else { dependencies };
            put(&folder.join(name).join("Cargo.toml"), &format!("[package]\nname = \"{name}\"\n{dependencies}"));
            let text = if name.ends_with("_wrong") { wrong_motor().0 } else { motor() };
            let text = if name == "readme" { readme.block("toml", "deadbeat = 1").to_owned() } else { text };
            put(&folder.join(name).join("motor.toml"), &text);
        }
        let (script, main) = readme_rust(&readme);
        put(&folder.join("readme/build.rs"), &script);
        put(&folder.join("readme/src/main.rs"), &main);
        let include = "mod dc_motor {\n    include!(concat!(env!(\"OUT_DIR\"), \"/dc_motor.rs\"));\n}";
        for name in ["built", "built_wrong"] {
            put(&folder.join(name).join("build.rs"), "fn main() {\n    deadbeat_codegen::build(\"motor.toml\");\n}\n");
            put(&folder.join(name).join("src/main.rs"), &rust_main(include, &rust_call("dc_motor", "f32")));
        }
        let modules = "mod single {\n    deadbeat::observer!(\"motor.toml\");\n}\n\
                       mod double {\n    deadbeat::observer!(\"motor.toml\", scalar = \"f64\");\n}";
        let calls = rust_call("single", "f32") + &rust_call("double", "f64");
        put(&folder.join("expanded/src/main.rs"), &rust_main(modules, &calls));
        put(&folder.join("expanded_wrong/src/main.rs"), "mod motor {\n    deadbeat::observer!(\"motor.toml\");\n}\n\nfn main() {}\n");
        put(
            &folder.join("expanded_unknown/src/main.rs"),
            "mod motor {\n    deadbeat::observer!(\"motor.toml\", scalr = \"f64\");\n}\n\nfn main() {}\n",
        );
        folder
    })
}

/// The README's Rust: `build.rs`, and `src/main.rs` with the module of the build script and, beside it, of the macro.
fn readme_rust(readme: &Page) -> (String, String) {
    let (script, main) = readme.block("rust", "fn main() {").split_once('\n').expect("two files");
    let (_, door) = readme.text.split_once("**a macro**").expect("the third door");
    let (include, expansion) = (main.lines().next().expect("a module"), door.split('`').nth(1).expect("a module"));
    assert!(include.starts_with("mod motor {") && expansion.starts_with("mod motor {"), "{include}\n{expansion}");
    let rest = "{
        let mut observer = motor::Observer::new();
        (0..1000).map(|_| speed(&mut observer, 0.0, 0.0)).last()
    }";
    let in_place = main.replace(include, expansion);
    let main = format!(
        "{main}
mod in_place {{
    {in_place}
    pub fn at_rest() -> Option<f32> {rest}
}}

fn main() {{
    println!(\"{{:?}} {{:?}}\", {rest}, in_place::at_rest());
}}
"
    );
    (script.to_owned(), main)
}

/// A cargo command in the users' workspace.
fn users_cargo(arguments: &[&str]) -> Command {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("doors_target");
    let mut command = cargo(users(), &target);
    command.args(arguments).args(["--offline", "--quiet"]).env("CARGO_TERM_COLOR", "never");
    command
}

/// What a cargo command that must fail says.
fn fails(arguments: &[&str]) -> String {
    let Output { status, stderr, .. } = users_cargo(arguments).output().expect("cargo runs");
    let text = String::from_utf8_lossy(&stderr).into_owned();
    assert!(!status.success(), "{arguments:?} should fail\n{text}");
    text
}

/// Claim: a build script of one line and one `include!` give an observer with the interpreter's bits.
#[test]
fn a_build_script() {
    assert_eq!(succeed(&mut users_cargo(&["run", "-p", "built"])), expected(Scalar::F32));
}

/// Claim: the README's Rust compiles as it stands, by the build script and by the macro, and knows a motor at rest.
#[test]
fn the_readme_s_rust() {
    assert_eq!(succeed(&mut users_cargo(&["run", "-p", "readme"])), "Some(0.0) Some(0.0)\n");
}

/// Claim: a mistake in the specification ends the build with the report, which names file and line.
#[test]
fn a_build_script_with_a_mistake() {
    let text = fails(&["build", "-p", "built_wrong"]);
    assert!(text.contains(&format!("motor.toml:{}:", wrong_motor().1)), "{text}");
    assert!(text.contains("error[DB0202]") && text.contains("`r`"), "{text}");
    assert!(!text.contains("panicked"), "a mistake of the user is not a panic:\n{text}");
}

/// Claim: a user of the build script does not compile what only the command line needs.
#[test]
fn a_build_script_needs_no_command_line() {
    let mut tree = users_cargo(&["tree", "-p", "built", "-e", "normal,build", "--target", "all", "--prefix", "none"]);
    let tree = succeed(&mut tree);
    assert!(tree.contains("deadbeat-codegen "), "{tree}");
    for word in ["clap", "similar", "serde_json", "proptest"] {
        assert!(!tree.lines().any(|line| line.split(' ').next() == Some(word)), "{word}:\n{tree}");
    }
}

/// Claim: the macro gives the same observer in place, in the file's scalar and in another, and
/// generic code over the trait drives both.
#[test]
fn a_macro() {
    let printed = succeed(&mut users_cargo(&["run", "-p", "expanded"]));
    assert_eq!(printed, expected(Scalar::F32) + &expected(Scalar::F64));
}

/// Claim: a mistake in the specification is one error of the compiler, at the macro's argument, that
/// holds the report.
#[test]
fn a_macro_with_a_mistake() {
    let text = fails(&["build", "-p", "expanded_wrong"]);
    assert!(text.contains(&format!("motor.toml:{}:", wrong_motor().1)), "{text}");
    assert!(text.contains("error[DB0202]") && text.contains("src/main.rs:2:"), "{text}");
    let errors = text.lines().filter(|line| line.starts_with("error: ") && !line.contains("could not compile"));
    assert_eq!(errors.count(), 1, "{text}");
    let text = fails(&["build", "-p", "expanded_unknown"]);
    assert!(text.contains("scalr") && text.contains("scalar = "), "{text}");
}

/// The files that `deadbeat generate motor.toml --lang c --out .` makes in a user's folder.
fn generated_c(test: &str) -> PathBuf {
    let folder = empty_folder(test);
    put(&folder.join("motor.toml"), &motor());
    let mut generate = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
    succeed(generate.current_dir(&folder).args(["generate", "motor.toml", "--lang", "c", "--out", "."]));
    let mut names: Vec<_> = fs::read_dir(&folder).expect("files").map(|it| it.expect("a file").file_name()).collect();
    names.sort();
    assert_eq!(names, ["dc_motor.c", "dc_motor.h", "motor.toml"]);
    folder
}

/// Claim: a C user compiles the two files with a main of his own, and needs nothing else.
#[test]
fn a_c_user() {
    let folder = generated_c("doors_c");
    let main = format!(
        "#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include \"dc_motor.h\"

static uint32_t bits(float x)
{{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}}

int main(void)
{{
    dc_motor_state state;
    dc_motor_estimate estimate = {{0}};
    dc_motor_init(&state);
    for (uint32_t call = 0; call < {CALLS}; ++call) {{
        const dc_motor_measurements measurements = {{ .y = (float)(call * 37 % 101) / 1024.0f }};
        const dc_motor_inputs inputs = {{ .u = (float)(call % 7) - 3.0f }};
        dc_motor_step(&state, &measurements, &inputs, &estimate);
    }}
    printf(\"%\" PRIx32 \" %\" PRIx32 \" %\" PRIx32 \" %d\\n\", bits(estimate.q), bits(estimate.dq), bits(estimate.i),
           (int)estimate.status);
    return 0;
}}
"
    );
    put(&folder.join("main.c"), &main);
    assert!(!c_compilers().is_empty(), "a C compiler is needed: gcc or clang");
    for compiler in c_compilers() {
        let mut command = Command::new(compiler);
        command.current_dir(&folder).args([
            "-std=c99",
            "-O2",
            "-ffp-contract=off",
            "main.c",
            "dc_motor.c",
            "-o",
            "main",
        ]);
        succeed(&mut command);
        assert_eq!(succeed(&mut Command::new(folder.join("main"))), expected(Scalar::F32), "{compiler}");
    }
}

/// Claim: a C++ user includes the header, and compiles the source as C or as C++.
#[test]
fn a_cpp_user() {
    let folder = generated_c("doors_cpp");
    let main = format!(
        "#include <cinttypes>
#include <cstdio>
#include <cstring>

#include \"dc_motor.h\"

class Motor {{
public:
    Motor() {{ dc_motor_init(&state_); }}

    dc_motor_estimate step(const dc_motor_measurements &measurements, const dc_motor_inputs &inputs)
    {{
        dc_motor_estimate estimate;
        dc_motor_step(&state_, &measurements, &inputs, &estimate);
        return estimate;
    }}

private:
    dc_motor_state state_;
}};

static std::uint32_t bits(float x)
{{
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}}

int main()
{{
    Motor motor;
    dc_motor_estimate estimate = dc_motor_estimate();
    for (unsigned call = 0; call < {CALLS}; ++call) {{
        const dc_motor_measurements measurements = {{ static_cast<float>(call * 37 % 101) / 1024.0f }};
        const dc_motor_inputs inputs = {{ static_cast<float>(call % 7) - 3.0f }};
        estimate = motor.step(measurements, inputs);
    }}
    std::printf(\"%\" PRIx32 \" %\" PRIx32 \" %\" PRIx32 \" %d\\n\", bits(estimate.q), bits(estimate.dq), bits(estimate.i),
                static_cast<int>(estimate.status));
    return estimate.status == DC_MOTOR_CONVERGED ? 0 : 1;
}}
"
    );
    put(&folder.join("main.cpp"), &main);
    for (c, cpp) in [("gcc", "g++"), ("clang", "clang++")] {
        if !c_compilers().contains(&c) || !runs(cpp) {
            continue;
        }
        let warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"];
        let object = |compiler: &str, language: &[&str]| {
            let mut command = Command::new(compiler);
            command.current_dir(&folder).args(["-O2", "-ffp-contract=off", "-c"]).args(language).args([
                "dc_motor.c",
                "-o",
                "motor.o",
            ]);
            succeed(&mut command);
        };
        for (compiler, language) in [(c, &["-std=c99"][..]), (cpp, &["-x", "c++", "-std=c++11"])] {
            object(compiler, language);
            let mut command = Command::new(cpp);
            command
                .current_dir(&folder)
                .args(["-std=c++11", "-O2"])
                .args(warnings)
                .args(["main.cpp", "motor.o", "-o", "main"]);
            succeed(&mut command);
            assert_eq!(
                succeed(&mut Command::new(folder.join("main"))),
                expected(Scalar::F32),
                "{compiler} {language:?}"
            );
        }
    }
}
