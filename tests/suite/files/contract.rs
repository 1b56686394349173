//! Claim: the contract that every generated file prints holds on the whole corpus, in the scalar that each
//! specification names, and in CI in the other too: a test for each of its lines.

use crate::support::depth::deep;
use crate::support::{compile, corpus, fleet};

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use compile::c_compilers;
use corpus::{ODD, Random, Subject, empty_folder, put, root, runs, side_by_side, subjects, succeed};
use deadbeat_codegen::internals::estimator::window::{Functional, Way};
use deadbeat_codegen::internals::output::header::CONTRACT;
use deadbeat_codegen::program::cost::{Cost, cost};
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Program, Scalar, Status};
use deadbeat_codegen::promise::Convergence;

/// Every warning that GENERATED.md names, as an error.
const STRICT_C: [&str; 12] = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Wundef",
    "-Wcast-qual",
    "-Wstrict-prototypes",
    "-Wunused-macros",
    "-Werror",
];

/// The same as C++.
const STRICT_CPP: [&str; 12] = [
    "-x",
    "c++",
    "-std=c++11",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Wundef",
    "-Wcast-qual",
    "-Werror",
];

/// What a distribution's compiler may add by default, and no file asks for.
const BARE: [&str; 3] = ["-fno-stack-protector", "-fno-asynchronous-unwind-tables", "-fno-pic"];

/// The files of every subject.
fn files() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = empty_folder("contract");
        for subject in subjects() {
            for file in subject.output.files() {
                put(&folder.join(&file.name), &file.text);
            }
        }
        folder
    })
}

/// One subject's C file, compiled with all warnings as errors.
struct Object {
    subject: &'static Subject,
    compiler: &'static str,
    level: &'static str,
    path: PathBuf,
}

impl Object {
    fn label(&self) -> String {
        format!("{} {} {}", self.compiler, self.level, self.subject.name)
    }
}

/// Every subject by every compiler, unoptimised and optimised, with the stack that each function uses.
fn objects() -> &'static [Object] {
    static OBJECTS: OnceLock<Vec<Object>> = OnceLock::new();
    OBJECTS.get_or_init(|| {
        let folder = files();
        let mut jobs = Vec::new();
        for compiler in c_compilers() {
            for level in ["-O0", "-O2"] {
                jobs.extend(subjects().iter().map(|subject| (subject, compiler, level)));
            }
        }
        side_by_side(&jobs, |&(subject, compiler, level)| {
            let path = folder.join(format!("{}_{compiler}{level}.o", subject.name));
            let mut command = Command::new(compiler);
            command.args(STRICT_C).args(BARE).args([level, "-fstack-usage", "-c"]);
            succeed(command.arg(folder.join(format!("{}.c", subject.name))).arg("-o").arg(&path));
            Object { subject, compiler, level, path }
        })
    })
}

/// What `nm` prints: kind and name of each symbol.
fn symbols(object: &Path, options: &[&str]) -> Vec<(char, String)> {
    let text = succeed(Command::new("nm").args(options).arg(object));
    let symbol = |line: &str| {
        let mut words = line.split_whitespace().rev();
        let name = words.next().expect("a name").to_owned();
        (words.next().and_then(|kind| kind.chars().next()).expect("a kind"), name)
    };
    text.lines().map(symbol).collect()
}

/// C without its comments; what stood there is a space.
fn without_comments(text: &str) -> String {
    let mut rest = text;
    let mut code = String::new();
    while let Some((before, after)) = rest.split_once("/*") {
        code = code + before + " ";
        rest = after.split_once("*/").expect("a comment ends").1;
    }
    code + rest
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c| !is_word(c)).filter(|word| !word.is_empty())
}

/// The functions of a C or Rust file that are defined at the given indent, each with those that it
/// calls.
fn call_graph(code: &str, indent: &str, names: &BTreeSet<String>) -> BTreeMap<String, BTreeSet<String>> {
    let mut graph: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut current = None;
    for line in code.lines() {
        let depth_is_ours = line.starts_with(indent) && !line[indent.len()..].starts_with([' ', '}', '/', '#']);
        if depth_is_ours && let Some(name) = words(line).find(|word| names.contains(*word)) {
            current = Some(name.to_owned());
            graph.entry(name.to_owned()).or_default();
        } else if let Some(current) = &current {
            let called = words(line).filter(|word| names.contains(*word)).map(str::to_owned);
            graph.get_mut(current).expect("just entered").extend(called);
        }
    }
    graph
}

/// The functions that a C file defines.
fn c_functions(code: &str) -> BTreeSet<String> {
    let lines: Vec<&str> = code.lines().collect();
    let mut names = BTreeSet::new();
    for (at, line) in lines.iter().enumerate().filter(|(_, line)| **line == "{") {
        let head = lines[..at].iter().rev().take_while(|it| !it.is_empty()).find(|it| !it.starts_with(' '));
        let head = head.unwrap_or_else(|| panic!("the head of a function: {line}"));
        let name = head.split_once('(').expect("a parameter list").0;
        names.insert(words(name).last().expect("a name").to_owned());
    }
    names
}

/// The largest sum of weights along a path of calls.
///
/// # Panics
/// If a function can come back to itself.
fn deepest(
    graph: &BTreeMap<String, BTreeSet<String>>,
    from: &str,
    weight: &dyn Fn(&str) -> u64,
    path: &mut Vec<String>,
) -> u64 {
    assert!(!path.iter().any(|it| it == from), "{from} comes back to itself: {path:?}");
    path.push(from.to_owned());
    let below = graph[from].iter().map(|callee| deepest(graph, callee, weight, path)).max().unwrap_or(0);
    path.pop();
    weight(from) + below
}

fn counted(subject: &Subject) -> Cost {
    cost(&subject.generated.program, deadbeat_math::COSTS)
}

/// Claim: ten lines, ten tests; whoever adds a line adds its test.
#[test]
fn every_line_has_its_test() {
    let tests = include_str!("contract.rs");
    for line in 1..=CONTRACT.len() {
        assert!(tests.contains(&format!("fn line_{line:02}_")), "line {line}: {}", CONTRACT[line - 1]);
    }
    for subject in subjects() {
        for (place, line) in CONTRACT.iter().enumerate() {
            for suffix in ["h", "rs", "step"] {
                let text = subject.file(suffix);
                assert!(text.contains(&format!("{:>2}. {line}\n", place + 1)), "{}.{suffix}: {line}", subject.name);
            }
        }
    }
}

/// Claim: a compiled file asks for nothing, by gcc in any case, by clang where it is told that there is no library, without
/// which it may call memset and memcpy of itself; it holds no variable, includes nothing but types and limits, and no function comes back
/// to itself. That the Rust file needs only `core` and the runtime is shown by line 6's crate.
#[test]
fn line_01_no_heap_no_recursion_no_globals_no_library() {
    for object in objects() {
        for (kind, name) in symbols(&object.path, &[]) {
            let label = object.label();
            let own = object.compiler == "clang" && ["memset", "memcpy"].contains(&name.as_str());
            assert!(kind != 'U' || own, "{label} needs {name}");
            assert!(!"dDbBCgGsS".contains(kind), "{label} has the variable {name}");
        }
    }
    for compiler in c_compilers() {
        for (subject, level) in subjects().iter().flat_map(|subject| ["-O2", "-Os"].map(|level| (subject, level))) {
            if !deep() && (compiler == "gcc") != (level == "-O2") {
                continue;
            }
            let object = files().join(format!("{}_{compiler}_freestanding.o", subject.name));
            let mut command = Command::new(compiler);
            command.current_dir(files()).args(["-std=c99", "-ffreestanding", level]).args(BARE);
            // On x86, gcc writes a short fill in place that it calls memset for elsewhere.
            let calls = compiler == "gcc" && cfg!(target_arch = "x86_64");
            command.args(calls.then_some("-mstringop-strategy=libcall"));
            succeed(command.arg("-c").arg(format!("{}.c", subject.name)).arg("-o").arg(&object));
            let needed: Vec<String> =
                symbols(&object, &[]).into_iter().filter(|(kind, _)| *kind == 'U').map(|(_, name)| name).collect();
            assert!(needed.is_empty(), "{} by {compiler} {level} needs {needed:?}", subject.name);
        }
    }
    for subject in subjects() {
        let own = format!("#include \"{}.h\"", subject.name);
        for suffix in ["c", "h"] {
            for line in subject.file(suffix).lines().filter(|line| line.trim_start().starts_with("#include")) {
                let known = ["#include <stdint.h>", "#include <float.h>", &own];
                assert!(known.contains(&line), "{}.{suffix}: {line}", subject.name);
            }
        }
        let code = without_comments(subject.file("c"));
        let functions = c_functions(&code);
        let graph = call_graph(&code, "", &functions);
        assert_eq!(graph.len(), functions.len(), "{}: a definition for each function", subject.name);
        for function in &functions {
            deepest(&graph, function, &|_| 1, &mut vec![]);
        }

        let rust = subject.file("rs");
        let functions: BTreeSet<String> =
            rust.lines().filter_map(|line| Some(words(line.split_once("fn ")?.1).next()?.to_owned())).collect();
        // The inherent functions; the trait's `step` calls the inherent one of the same name.
        let inherent = rust.split("impl Default").next().expect("the first part");
        let code: String = (inherent.lines().filter(|line| !line.trim_start().starts_with("//")))
            .map(|line| line.to_owned() + "\n")
            .collect();
        let graph = call_graph(&code, "    ", &functions.into_iter().filter(|it| it != "default").collect());
        assert!(graph.contains_key("step"), "{}: {graph:?}", subject.name);
        for function in graph.keys() {
            deepest(&graph, function, &|_| 1, &mut vec![]);
        }
        for line in rust.lines().filter(|line| line.trim_start().starts_with("static ")) {
            assert!(line.starts_with("static ") && line.contains(": [["), "{}: a table: {line}", subject.name);
        }
        for path in rust.split("::").zip(rust.split("::").skip(1)).filter(|(before, _)| !before.ends_with(is_word)) {
            let known = path.1.starts_with("deadbeat") || path.1.starts_with("core");
            assert!(known, "{}: ::{}", subject.name, path.1.lines().next().unwrap_or(""));
        }
    }
}

/// Claim: loops run to constants; the state has the printed size; the stack of the deepest path of
/// calls, without optimisation and with it, and the flash of a step are at most what is printed.
#[test]
fn line_02_the_printed_cost_is_a_bound() {
    let (mut wrong, mut tightest) = (Vec::new(), Vec::new());
    for subject in subjects() {
        let cost = counted(subject);
        for suffix in ["h", "rs", "step"] {
            let text = subject.file(suffix);
            let state = format!("state {} bytes, constants {} bytes", cost.ram_bytes, cost.table_bytes);
            let most = format!("stack {} bytes, flash {} bytes", cost.stack_bytes, cost.flash_bytes);
            assert!(text.contains(&state) && text.contains(&most), "{}.{suffix} prints its cost", subject.name);
        }
        for (name, loops) in [("c", &["for (", "while ("][..]), ("rs", &["for ", "while ", "loop "][..])] {
            let code = without_comments(subject.file(name));
            for line in code.lines().map(str::trim_start).filter(|line| loops.iter().any(|it| line.starts_with(it))) {
                let bounded = match name {
                    "c" => constant_bound(line, &code),
                    _ => line.starts_with("for ") && (line.contains(" in &") || line.contains(" in 0..")),
                };
                assert!(bounded, "{}.{name}: {line}", subject.name);
            }
        }
    }
    for object in objects() {
        let used = stack(object);
        let printed = counted(object.subject).stack_bytes;
        tightest.push((used * 100 / printed, object.label()));
        if used > printed {
            wrong.push(format!("{}: stack {used} bytes, printed {printed}", object.label()));
        }
    }
    eprintln!("the tightest bound on the stack, in percent: {:?}", tightest.iter().max());
    let jobs: Vec<(&Subject, &str)> =
        c_compilers().into_iter().flat_map(|it| subjects().iter().map(move |subject| (subject, it))).collect();
    wrong.extend(side_by_side(&jobs, |(subject, compiler)| flash(subject, compiler)).into_iter().flatten());
    for compiler in c_compilers() {
        let check = |it: &Subject| {
            let (name, bytes) = (&it.name, counted(it).ram_bytes);
            format!(
                "#include \"{name}.h\"\ntypedef char {name}_has_its_size[sizeof({name}_state) == {bytes} ? 1 : -1];\n"
            )
        };
        let checks: String = subjects().iter().map(check).collect();
        let path = files().join("sizes.c");
        put(&path, &checks);
        succeed(Command::new(compiler).args(["-std=c99", "-fsyntax-only"]).arg(&path));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// `for (uint32_t row = 0U; row < 51U; ++row) {`: the bound is a number, or a macro or constant
/// that the file defines.
fn constant_bound(line: &str, code: &str) -> bool {
    let condition = line.split(';').nth(1).unwrap_or("").trim();
    let Some((counter, bound)) = condition.split_once(" < ").or_else(|| condition.split_once(" > ")) else {
        return false;
    };
    let number = |text: &str| text.trim_end_matches('U').parse::<u64>().is_ok();
    let defined = code.contains(&format!("#define {bound} "));
    counter.chars().all(is_word) && (number(bound) || defined)
}

/// Bytes of stack that `step` takes, along its deepest path; inlined functions have no entry.
fn stack(object: &Object) -> u64 {
    let text = fs::read_to_string(object.path.with_extension("su")).expect("the compiler's notes");
    let mut used = BTreeMap::new();
    for line in text.lines() {
        let columns: Vec<&str> = line.split('\t').collect();
        let [place, bytes, kind] = columns[..] else { panic!("{}: {line}", object.label()) };
        // Bounded: the frame is aligned at run time, which the number includes.
        assert!(["static", "dynamic,bounded"].contains(&kind), "{}: {line}", object.label());
        let name = place.rsplit(':').next().expect("a name").to_owned();
        used.insert(name, bytes.parse::<u64>().expect("bytes"));
    }
    let code = without_comments(object.subject.file("c"));
    let graph = call_graph(&code, "", &c_functions(&code));
    let weight = |name: &str| used.get(name).copied().unwrap_or(0);
    deepest(&graph, &format!("{}_step", object.subject.name), &weight, &mut vec![])
}

/// What is wrong with the printed flash. The elementary functions' own size is that of the same
/// compilation without inlining; most subjects have none.
fn flash(subject: &Subject, compiler: &str) -> Option<String> {
    let object = |options: &[&str], suffix: &str| {
        let path = files().join(format!("{}_{compiler}_{suffix}.o", subject.name));
        let mut command = Command::new(compiler);
        command.args(["-std=c99", "-Os", "-c"]).args(BARE).args(options);
        succeed(command.arg(files().join(format!("{}.c", subject.name))).arg("-o").arg(&path));
        path
    };
    let printed = counted(subject).flash_bytes;
    let tables: Vec<String> = (subject.generated.program.tables.iter())
        .map(|table| format!("{}_{}", subject.name, table.name).to_uppercase())
        .collect();
    let ours = |name: &str| {
        ["init", "step"].iter().any(|it| name == format!("{}_{it}", subject.name))
            || name.starts_with(&format!("{}_part_", subject.name))
            || tables.iter().any(|table| name == table)
            || name.starts_with('.')
    };
    let mut elementary = 0;
    if c_functions(&without_comments(subject.file("c"))).iter().any(|name| !ours(name)) {
        let apart = object(&["-fno-inline"], "apart");
        let sizes = succeed(Command::new("nm").args(["-S", "-t", "d"]).arg(&apart));
        for line in sizes.lines() {
            let columns: Vec<&str> = line.split_whitespace().collect();
            let [_, size, kind, name] = columns[..] else { continue };
            if !ours(name) && "tTrR".contains(kind) {
                elementary += size.parse::<u64>().expect("a size");
            }
        }
    }
    let used = text_bytes(&object(&[], "small"));
    (used > printed + elementary).then(|| {
        format!("{compiler} -Os {}: flash {used} bytes, printed {printed} and elementary {elementary}", subject.name)
    })
}

/// Bytes of code and constants.
fn text_bytes(object: &Path) -> u64 {
    let table = succeed(Command::new("size").arg(object));
    let numbers = table.lines().nth(1).expect("a row of sizes");
    numbers.split_whitespace().next().and_then(|it| it.parse().ok()).expect("bytes of text")
}

/// Claim: a compiled file shows `init` and `step`, `init_at` where it is asked for, and nothing else; every macro has the prefix; all
/// observers of the corpus link into one program, in C and in Rust, where two instances of each run
/// by turns and give the bits that they give alone, which are the same in both languages.
#[test]
fn line_03_prefix_and_instances() {
    for object in objects() {
        let name = &object.subject.name;
        let shown: BTreeSet<String> =
            symbols(&object.path, &["-g"]).into_iter().filter(|(kind, _)| *kind != 'U').map(|it| it.1).collect();
        let mut expected = BTreeSet::from([format!("{name}_init"), format!("{name}_step")]);
        expected.extend(object.subject.generated.program.init_at.iter().map(|_| format!("{name}_init_at")));
        assert_eq!(shown, expected, "{}", object.label());
    }
    for compiler in c_compilers() {
        let macros = |text: &str, name: &str| -> BTreeSet<String> {
            let path = files().join(name);
            put(&path, text);
            let text = succeed(Command::new(compiler).args(["-std=c99", "-dM", "-E"]).arg(&path));
            text.lines().filter_map(|line| words(line).nth(1).map(str::to_owned)).collect()
        };
        let bare = macros("#include <stdint.h>\n#include <float.h>\n", &format!("bare_{compiler}.c"));
        for subject in subjects() {
            let text = format!("#include \"{}.c\"\n", subject.name);
            let prefix = subject.name.to_uppercase() + "_";
            let added = &macros(&text, &format!("macros_{}_{compiler}.c", subject.name)) - &bare;
            assert!(added.contains(&format!("{prefix}SAMPLE_TIME")), "{added:?}");
            assert!(added.iter().all(|name| name.starts_with(&prefix)), "{}: {added:?}", subject.name);
        }
    }
    for compiler in c_compilers() {
        assert_eq!(together(compiler), rust_hashes(), "{compiler} and Rust");
    }
}

/// The optimised objects of a compiler.
fn optimised(compiler: &str) -> impl Iterator<Item = &'static PathBuf> {
    objects().iter().filter(move |it| it.compiler == compiler && it.level == "-O2").map(|it| &it.path)
}

/// What the C program with a compiler's optimised objects prints.
fn together(compiler: &str) -> String {
    static PRINTED: OnceLock<BTreeMap<&'static str, String>> = OnceLock::new();
    let print = |compiler: &&'static str| {
        let (source, program) = (files().join("together.c"), files().join(format!("together_{compiler}")));
        let mut command = Command::new(compiler);
        command.args(STRICT_C).arg("-O1").arg(&source).args(optimised(compiler)).arg("-o").arg(&program);
        succeed(command.args(["-no-pie", "-lm"]));
        (*compiler, succeed(&mut Command::new(&program)))
    };
    let printed = PRINTED.get_or_init(|| {
        put(&files().join("together.c"), &fleet::together(subjects()));
        side_by_side(&c_compilers(), print).into_iter().collect()
    });
    printed[compiler].clone()
}

/// The crate that has every generated Rust file as a module, and nothing but `core` and the runtime.
fn rust_crate() -> &'static Path {
    static CRATE: OnceLock<PathBuf> = OnceLock::new();
    CRATE.get_or_init(|| {
        let project = Path::new(env!("CARGO_TARGET_TMPDIR")).join("contract_crate");
        let runtime = root().join("runtime").display().to_string();
        let manifest = format!(
            "[package]\nname = \"contract\"\nedition = \"2024\"\n\n[dependencies]\ndeadbeat = {{ path = {runtime:?} }}\n\n[workspace]\n"
        );
        put(&project.join("Cargo.toml"), &manifest);
        let lock = fs::read_to_string(root().join("Cargo.lock")).expect("the workspace's lock file");
        if !project.join("Cargo.lock").exists() {
            put(&project.join("Cargo.lock"), &lock);
        }
        let modules = subjects().iter().fold(String::new(), |text, it| text + "pub mod " + &it.name + ";\n");
        put(&project.join("src/lib.rs"), &format!("//! Every observer.\n#![no_std]\n#![forbid(unsafe_code)]\n\n{modules}"));
        for subject in subjects() {
            put(&project.join(format!("src/{}.rs", subject.name)), subject.file("rs"));
        }
        put(&project.join("src/main.rs"), &fleet::together_in_rust(subjects()));
        project
    })
}

fn crate_target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("contract_target")
}

/// What the Rust program with all observers prints.
fn rust_hashes() -> &'static str {
    static PRINTED: OnceLock<String> = OnceLock::new();
    let run = || succeed(corpus::cargo(rust_crate(), &crate_target()).args(["run", "--offline", "--quiet"]));
    PRINTED.get_or_init(run)
}

/// Claim: the code of a float observer has no `double` in it: no word, no literal without its
/// suffix, no promotion, no instruction that converts or computes in double.
#[test]
fn line_04_float_code_has_no_double() {
    let single = |subject: &&Subject| subject.scalar() == Scalar::F32;
    for subject in subjects().iter().filter(single) {
        for suffix in ["c", "h"] {
            let code = without_comments(subject.file(suffix));
            assert!(words(&code).all(|word| word != "double"), "{}.{suffix}", subject.name);
            for literal in float_literals(&code) {
                assert!(literal.ends_with('f'), "{}.{suffix}: {literal}", subject.name);
            }
        }
        let doubles = subject.file("rs").lines().filter(|line| !line.trim_start().starts_with("//"));
        for line in doubles.filter(|line| line.contains("f64")) {
            assert!(line.trim_start().starts_with("const SAMPLE_TIME: f64 = "), "{}.rs: {line}", subject.name);
        }
    }
    // -Wdouble-promotion and -Werror are among the options of all objects.
    assert!(STRICT_C.contains(&"-Wdouble-promotion") && !objects().is_empty());
    if runs("objdump") && cfg!(target_arch = "x86_64") {
        for object in objects().iter().filter(|it| single(&it.subject)) {
            let code = succeed(Command::new("objdump").args(["-d", "--no-show-raw-insn"]).arg(&object.path));
            let read = |name: &str| code.contains(&format!("\t{name}ss")) || code.contains(&format!("\t{name}ps"));
            assert!(read("mul") && read("add"), "{}: its sums can be read", object.label());
            for instruction in code.lines().filter_map(|line| line.split('\t').nth(1)) {
                let name = instruction.split_whitespace().next().unwrap_or("");
                let double = name.contains("ss2sd") || name.contains("sd2s") || name.contains("sd2si");
                let computes = ["addsd", "subsd", "mulsd", "divsd", "ucomisd", "comisd", "cvtsi2sd"];
                let computes = computes.iter().any(|it| name.trim_start_matches('v').starts_with(it));
                assert!(!double && !computes, "{}: {instruction}", object.label());
            }
        }
    } else {
        eprintln!("line 4: no objdump of x86-64 here; the compiler's -Wdouble-promotion alone has been asked");
    }
}

/// Numbers with a point or a decimal exponent.
fn float_literals(code: &str) -> Vec<&str> {
    let mut literals = Vec::new();
    let bytes = code.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let before = at.checked_sub(1).map_or(' ', |it| char::from(bytes[it]));
        if !bytes[at].is_ascii_digit() || is_word(before) || before == '.' {
            at += 1;
            continue;
        }
        let mut end = at;
        while end < bytes.len() {
            let signed =
                "+-".contains(char::from(bytes[end])) && bytes[end - 1] == b'e' && !code[at..].starts_with("0x");
            if !(is_word(char::from(bytes[end])) || bytes[end] == b'.' || signed) {
                break;
            }
            end += 1;
        }
        let literal = &code[at..end];
        if !literal.starts_with("0x") && !literal.starts_with("0X") && literal.contains(['.', 'e', 'E']) {
            literals.push(literal);
        }
        at = end;
    }
    literals
}

/// Claim: every number in the tables of the C and the Rust file, read back in its type, is the
/// designed constant, bit for bit.
#[test]
fn line_05_literals_read_back() {
    for subject in subjects() {
        let program = &subject.generated.program;
        let functional = subject.generated.design.estimator.downcast_ref::<Functional>();
        let weighted = functional.is_some_and(|it| !matches!(it.way, Way::Recursive(_)));
        // A short window is written out: its weights stand in the step.
        let short = subject.generated.design.window_steps < 8;
        assert!(!weighted || short || !program.tables.is_empty(), "{}: a window has its weights", subject.name);
        for (_, table) in program.read_tables() {
            let designed: Vec<u64> = table.rows.iter().flatten().map(|x| x.to_bits()).collect();
            let upper = format!("{}_{}[", subject.name, table.name).to_uppercase();
            let c = numbers(subject.file("c"), &upper, "};", program.scalar);
            let rust = numbers(subject.file("rs"), &format!("static {}: ", table.name), "];", program.scalar);
            assert_eq!(c, designed, "{}.c: {}", subject.name, table.name);
            assert_eq!(rust, designed, "{}.rs: {}", subject.name, table.name);
        }
    }
}

/// The numbers between the `=` behind a name and the end of the table, widened.
fn numbers(text: &str, name: &str, end: &str, scalar: Scalar) -> Vec<u64> {
    let from = text.find(name).unwrap_or_else(|| panic!("a table {name}"));
    let table = text[from..].split_once(" = ").expect("its rows").1;
    let table = &table[..table.find(end).expect("its end")];
    let pieces = table.split(|c: char| !(is_word(c) || "+-.".contains(c))).filter(|piece| !piece.is_empty());
    let number = |piece: &str| match scalar {
        Scalar::F32 => {
            f64::from(piece.replace('_', "").trim_end_matches('f').parse::<f32>().expect("a number")).to_bits()
        }
        Scalar::F64 => piece.replace('_', "").parse::<f64>().expect("a number").to_bits(),
    };
    pieces.map(number).collect()
}

/// Claim: no warning as C99 (every object of these tests is compiled so) and as C++, from rustc and
/// from `clippy::pedantic`, and no allow list in the files.
#[test]
fn line_06_no_warnings() {
    assert!(!objects().is_empty(), "a C compiler is needed: gcc or clang");
    let jobs: Vec<(&str, &Subject)> =
        c_compilers().into_iter().flat_map(|it| subjects().iter().map(move |subject| (it, subject))).collect();
    side_by_side(&jobs, |(compiler, subject)| {
        let mut command = Command::new(compiler);
        command.args(STRICT_CPP).args(["-O1", "-c"]).arg(files().join(format!("{}.c", subject.name)));
        succeed(command.arg("-o").arg(files().join(format!("{}_{compiler}_cpp.o", subject.name))));
    });
    for subject in subjects() {
        for suffix in ["rs", "c", "h"] {
            let text = subject.file(suffix);
            for word in ["allow(", "expect(", "diagnostic ignored", "NOLINT", "cppcheck-suppress"] {
                assert!(!text.contains(word), "{}.{suffix} allows something: {word}", subject.name);
            }
        }
    }
    let mut clippy = corpus::cargo(rust_crate(), &crate_target());
    clippy.args([
        "clippy",
        "--offline",
        "--quiet",
        "--lib",
        "--",
        "-D",
        "warnings",
        "-D",
        "missing-docs",
        "-W",
        "clippy::pedantic",
    ]);
    succeed(&mut clippy);
}

/// Claim: the file itself turns fused multiply-add off: the machine's instructions, clang's default
/// contraction and gcc's `-ffp-contract=fast` change no bit; `-ffast-math` is refused. (The
/// comparison with the interpreter and Rust is `equal_corpus`.)
///
/// Not claimed, because no file can hold it: clang with an explicit `-ffp-contract=fast` fuses
/// whatever the pragmas say, and tells the preprocessor nothing of it.
#[test]
fn line_07_contraction_is_off_by_the_file() {
    let folder = files();
    put(&folder.join("together_07.c"), &fleet::together(subjects()));
    let all: Vec<PathBuf> = subjects().iter().map(|it| folder.join(format!("{}.c", it.name))).collect();
    let printed = side_by_side(&c_compilers(), |compiler| {
        let fused = if *compiler == "clang" { "-ffp-contract=on" } else { "-ffp-contract=fast" };
        let program = folder.join(format!("together_07_{compiler}_fused"));
        let mut command = Command::new(compiler);
        command.args(["-O3", "-march=native", fused]).arg(folder.join("together_07.c")).args(&all);
        succeed(command.arg("-o").arg(&program).arg("-lm"));
        succeed(&mut Command::new(&program))
    });
    for (compiler, fused) in c_compilers().iter().zip(&printed) {
        // Strict C99 of a processor that has no such instruction.
        assert_eq!(*fused, together(compiler), "{compiler}");
        assert_eq!(*fused, printed[0], "{compiler}");
    }
    for compiler in c_compilers() {
        let mut command = Command::new(compiler);
        let refused = command.args(["-ffast-math", "-fsyntax-only"]).arg(&all[0]).output().expect("the compiler");
        let why = String::from_utf8_lossy(&refused.stderr);
        assert!(!refused.status.success() && why.contains("needs IEEE 754 arithmetic"), "{compiler}: {why}");
    }
}

/// Claim: the same specification gives the same bytes in another folder, language, time zone, home,
/// by another path, and with other line ends; and no path, host or date is in them.
#[test]
fn line_08_same_bytes_everywhere() {
    let folder = empty_folder("contract_08");
    let specs = corpus::corpus();
    let first = folder.join("first");
    let elsewhere = folder.join("else where");
    fs::create_dir_all(&elsewhere).expect("a folder");
    let tool = || Command::new(env!("CARGO_BIN_EXE_deadbeat"));
    let languages = ["--lang", "rust", "--lang", "c", "--lang", "step"];

    let relative = specs.iter().map(|it| format!("specs/{}.toml", it.stem));
    let mut plain = tool();
    plain.current_dir(root()).arg("generate").args(relative).args(languages).arg("--out").arg(&first);
    succeed(plain.env("LC_ALL", "C").env("TZ", "UTC"));

    let second = elsewhere.join("second");
    let mut other = tool();
    other.current_dir(&elsewhere).arg("generate").args(specs.iter().map(|it| &it.path)).args(languages);
    other.args(["--out", "second"]).env("LC_ALL", "tr_TR.UTF-8").env("LANG", "de_DE.UTF-8").env("TZ", "Asia/Kathmandu");
    succeed(other.env("HOME", "/nowhere").env("USER", "somebody").env("SOURCE_DATE_EPOCH", "1"));

    let third = folder.join("third");
    side_by_side(&specs, |spec| {
        let mut child = tool();
        child.current_dir(&elsewhere).args(["generate", "-"]).args(languages).arg("--out").arg(&third);
        let mut child =
            child.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the tool");
        let text = spec.text.replace('\n', "\r\n");
        std::io::Write::write_all(&mut child.stdin.take().expect("its input"), text.as_bytes()).expect("it reads");
        assert!(child.wait().expect("it ends").success(), "{}", spec.stem);
    });

    let mut names: Vec<_> = fs::read_dir(&first).expect("files").map(|it| it.expect("a file").file_name()).collect();
    names.sort();
    assert_eq!(names.len(), 4 * specs.len());
    let host = fs::read_to_string("/etc/hostname").unwrap_or_default().trim().to_owned();
    for name in names {
        let text = fs::read_to_string(first.join(&name)).expect("text");
        for other in [&second, &third] {
            assert!(
                fs::read_to_string(other.join(&name)).is_ok_and(|it| it == text),
                "{} in {other:?}",
                name.display()
            );
        }
        assert!(!text.contains(&*root().to_string_lossy()) && !text.contains("specs/"), "{}: a path", name.display());
        // A short host name could be a word of the text.
        assert!(host.len() < 8 || !text.contains(&host), "{}: the host's name", name.display());
        let digits = text.as_bytes().windows(10).find(|it| {
            it.iter()
                .enumerate()
                .all(|(at, byte)| if [4, 7].contains(&at) { *byte == b'-' } else { byte.is_ascii_digit() })
        });
        assert!(digits.is_none(), "{}: a date", name.display());
        assert!(!text.contains("__DATE__") && !text.contains("__TIME__") && !text.contains("__FILE__"));
        assert!(!text.contains('\r'), "{}: line ends", name.display());
    }
}

/// Claim: C++ includes the headers and links; pointers to constants are enough for what is only
/// read; no struct is empty, all are plain data; and a copy by memcpy in mid-run has the same future.
#[test]
fn line_09_const_correct_and_plain_data() {
    let folder = files();
    put(&folder.join("together.cpp"), &fleet::together_in_cpp(subjects()));
    for subject in subjects() {
        for suffix in ["c", "h"] {
            let code = without_comments(subject.file(suffix));
            assert!(!code.contains("[0]]") && !code.contains("[0U]") && !code.contains("{\n}"), "{}", subject.name);
            let declared =
                code.lines().filter(|line| line.ends_with(';') && line.contains("[0]") && !line.contains('='));
            assert_eq!(declared.count(), 0, "{}: an array without elements", subject.name);
        }
    }
    for (compiler, cpp) in [("gcc", "g++"), ("clang", "clang++")] {
        if !c_compilers().contains(&compiler) || !runs(cpp) {
            continue;
        }
        let program = folder.join(format!("together_{cpp}"));
        let mut command = Command::new(cpp);
        command.args(&STRICT_CPP[2..]).arg("-O1").arg(folder.join("together.cpp")).args(optimised(compiler));
        succeed(command.arg("-o").arg(&program).arg("-no-pie"));
        assert_eq!(succeed(&mut Command::new(&program)), rust_hashes(), "{cpp}");
    }
}

/// Steps of each phase of an abused observer, at least.
const PHASE: usize = 256;
/// Steps of the interpreter, over the whole corpus; unoptimised builds take fewer.
const INTERPRETED: usize = if cfg!(debug_assertions) { 100_000 } else { 1_000_000 };
/// The specifications whose plant is unstable, so that a prediction runs away.
const UNSTABLE: [&str; 4] = ["inverted_cart", "magnetic_levitation", "pendulum", "pendulum_impulsive"];

/// Claim: whatever the bits of measurements and inputs, the interpreter's state and estimates stay
/// finite.
#[test]
fn line_10_inputs_of_any_bits() {
    side_by_side(&subjects().iter().collect::<Vec<_>>(), |subject| abuse(subject, INTERPRETED / 40));
}

/// Claim: the same when a sensor of an unstable plant is gone for good.
#[test]
fn line_10_a_sensor_that_is_gone_for_good() {
    let unstable = |it: &&Subject| UNSTABLE.contains(&it.stem.as_str());
    let chosen: Vec<&Subject> = subjects().iter().filter(unstable).collect();
    assert_eq!(chosen.len(), if deep() { 2 } else { 1 } * UNSTABLE.len());
    side_by_side(&chosen, |subject| gone(subject, INTERPRETED / 4));
}

/// Claim: the same in C, a million steps without its sensors for every unstable plant, under the
/// sanitizers where there are some.
#[test]
fn line_10_compiled_code_takes_any_bits() {
    let folder = files();
    put(&folder.join("abuse.c"), &fleet::abuse(subjects(), &UNSTABLE, phase));
    let all: Vec<PathBuf> = subjects().iter().map(|it| folder.join(format!("{}.c", it.name))).collect();
    put(&folder.join("nothing.c"), "int main(void)\n{\n    return 0;\n}\n");
    let sanitized = ["-g", "-fsanitize=undefined,address,float-cast-overflow", "-fno-sanitize-recover=all"];
    let mut jobs = Vec::new();
    for compiler in c_compilers() {
        let objects: Vec<&PathBuf> = optimised(compiler).collect();
        jobs.push((compiler, "fast", vec!["-O2", "-no-pie"], objects, ["20000", "1000000"]));
        let nothing = folder.join(format!("nothing_{compiler}"));
        let mut links = Command::new(compiler);
        links.args(sanitized).arg(folder.join("nothing.c")).arg("-o").arg(&nothing);
        let links = links.output().is_ok_and(|it| it.status.success());
        if links && Command::new(&nothing).status().is_ok_and(|it| it.success()) {
            let options = [&["-O1"], &sanitized[..]].concat();
            jobs.push((compiler, "sanitized", options, all.iter().collect(), ["4000", "20000"]));
        } else {
            eprintln!("line 10: {compiler} has no sanitizers here; its sanitized run is left out");
        }
    }
    side_by_side(&jobs, |(compiler, label, options, observers, steps)| {
        let program = folder.join(format!("abuse_{compiler}_{label}"));
        let mut command = Command::new(compiler);
        command.arg("-std=c99").args(options).arg(folder.join("abuse.c")).args(observers);
        succeed(command.arg("-o").arg(&program).arg("-lm"));
        succeed(Command::new(&program).args(steps));
    });
}

/// Steps of each phase: enough to converge, twice.
fn phase(subject: &Subject) -> usize {
    PHASE.max(2 * subject.window() + 2)
}

/// Random bits, odd numbers, plausible numbers and nothing at all, by turns.
fn abuse(subject: &Subject, steps: usize) {
    let phase = phase(subject);
    let mut random = Random::new(subject.name.len() as u64);
    let (measured, applied) = (subject.measured(), subject.applied());
    let mut run = Run::new(&subject.generated.program);
    // What converges by its innovations alone does so at rest.
    let sensed = matches!(subject.generated.design.convergence, Convergence::Sensed { .. });
    let spread = if sensed { 0.0 } else { 1.0 };
    for step in 0..steps {
        let mut number = |span: &corpus::Span| {
            let plausible = span.centre + spread * span.amplitude * random.signed();
            let any = any_bits(subject.scalar(), random.bits());
            match step / phase % 4 {
                1 => any,
                2 if random.one_in(8) => any,
                2 if random.one_in(8) => random.among(&ODD),
                3 if !random.one_in(64) => f64::NAN,
                _ => plausible,
            }
        };
        let measurements: Vec<f64> = measured.iter().map(&mut number).collect();
        let inputs: Vec<f64> = applied.iter().map(&mut number).collect();
        run.step(&measurements, &inputs);
    }
    assert!(run.seen.len() == 3 || steps < 4 * phase, "{}: every status is reached, {:?}", subject.name, run.seen);
}

/// Converges, then measures nothing any more.
fn gone(subject: &Subject, steps: usize) {
    let mut random = Random::new(9);
    let (measured, applied) = (subject.measured(), subject.applied());
    let mut run = Run::new(&subject.generated.program);
    for step in 0..steps {
        let there = step < phase(subject);
        let mut number = |span: &corpus::Span| span.centre + span.amplitude * random.signed();
        let inputs: Vec<f64> = applied.iter().map(&mut number).collect();
        let measurements: Vec<f64> = measured.iter().map(|span| if there { number(span) } else { f64::NAN }).collect();
        run.step(&measurements, &inputs);
        assert!(step + 1 != phase(subject) || run.last == Some(Status::Converged), "{}: converged first", subject.name);
    }
    assert_ne!(run.last, Some(Status::Converged), "{}: nothing was measured", subject.name);
}

/// A float of the scalar with these bits, widened.
#[expect(clippy::cast_possible_truncation, reason = "the low half of random bits")]
fn any_bits(scalar: Scalar, bits: u64) -> f64 {
    match scalar {
        Scalar::F32 => f32::from_bits(bits as u32).into(),
        Scalar::F64 => f64::from_bits(bits),
    }
}

/// The interpreter, watched.
struct Run<'p> {
    program: &'p Program,
    interpreter: Interpreter,
    estimates: Vec<f64>,
    steps: usize,
    seen: BTreeSet<u8>,
    last: Option<Status>,
}

impl<'p> Run<'p> {
    fn new(program: &'p Program) -> Self {
        let estimates = vec![0.0; program.estimates.len()];
        Self { program, interpreter: Interpreter::new(program), estimates, steps: 0, seen: BTreeSet::new(), last: None }
    }

    /// The state is looked at every 16 steps: what is not finite stays in a window for longer.
    fn step(&mut self, measurements: &[f64], inputs: &[f64]) {
        let status = self.interpreter.step(measurements, inputs, &mut self.estimates);
        let place = || format!("{}, step {}, {measurements:?}, {inputs:?}", self.program.name, self.steps);
        assert!(self.estimates.iter().all(|x| x.is_finite()), "{}: {:?}", place(), self.estimates);
        if self.steps.is_multiple_of(16) {
            for (name, held) in self.interpreter.cells() {
                assert!(held.iter().all(|x| x.is_finite()), "{}: {name} holds {held:?}", place());
            }
        }
        self.seen.insert(status as u8);
        self.last = Some(status);
        self.steps += 1;
    }
}
