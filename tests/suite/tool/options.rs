//! Claim: what one door can be asked for, the others can be, as far as they have a use for it; and the same question gets
//! the same bytes. Each door's options are read from its definition, so that a new one must be placed here.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::{Build, Generator, Language, Output, Settings};

use super::builder::two_motors;
use crate::support::corpus::{root, succeed};

/// What can be asked for: by the command line, by a build script's `Build`, by the macro; a reason where a door has no
/// use for it.
const OPTIONS: [(&str, &str, &str, Result<&str, &str>); 6] = [
    ("specifications", "<SPECS>", "spec", Ok("path")),
    ("patterns of them", "<SPECS>", "specs", Err("an expansion is the items of one observer")),
    ("float type", "--scalar", "scalar", Ok("scalar")),
    ("languages", "--lang", "language", Err("an expansion is Rust")),
    ("folder", "--out", "out_dir", Err("an expansion writes no file")),
    ("report", "--format", "run", Err("the compiler has one form for errors")),
];

fn source(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The names behind a mark, each as far as it goes.
fn names<'a>(text: &'a str, mark: &str) -> BTreeSet<&'a str> {
    let name = |rest: &'a str| rest.split(|c: char| !c.is_alphanumeric() && c != '_' && c != '-').next();
    text.split(mark).skip(1).filter_map(name).collect()
}

/// Every option of a door is in the table.
#[test]
fn each_option_has_its_place_at_every_door() {
    let help = succeed(Command::new(env!("CARGO_BIN_EXE_deadbeat")).args(["generate", "--help"]));
    let mut flags = names(&help, "\n      --");
    flags.extend(names(&help, ", --"));
    flags.remove("help");
    let flags = flags.into_iter().map(|name| format!("--{name}"));
    let command_line: BTreeSet<String> = flags.chain(help.contains("<SPECS>").then(|| "<SPECS>".to_owned())).collect();
    assert_eq!(command_line, OPTIONS.map(|(_, flag, ..)| flag.to_owned()).into(), "{help}");

    let build = source("codegen/build.rs");
    let (_, methods) = build.split_once("impl Build {").expect("its methods");
    let (methods, _) = methods.split_once("\n}\n").expect("their end");
    let mut methods = names(methods, "pub fn ");
    methods.remove("new");
    assert_eq!(methods, OPTIONS.map(|(_, _, method, _)| method).into());

    let spec = source("codegen/spec.rs");
    let (_, settings) = spec.split_once("pub struct Settings {").expect("the macro's settings");
    let (settings, _) = settings.split_once("\n}\n").expect("their end");
    let mut settings = names(settings, "pub ");
    settings.insert("path");
    assert_eq!(settings, OPTIONS.iter().filter_map(|(_, _, _, expansion)| expansion.ok()).collect());
}

/// The text of every file in a folder, by name.
fn files(folder: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(folder).expect("a folder").map(|it| it.expect("a file").path());
    let text = |path: &Path| fs::read_to_string(path).expect("a text");
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    let mut files: Vec<_> = entries.map(|path| (name(&path), text(&path))).collect();
    files.sort();
    files
}

/// A pattern that no shell has seen, each float type and each language: the command line, a build script and the library
/// make the same bytes; and for `include!`, which the macro expands to, all below the header.
#[test]
fn the_same_question_gets_the_same_bytes() {
    let folder = two_motors("options_same");
    let pattern = folder.join("specs/*.toml");
    for (word, scalar) in [(None, None), (Some("f32"), Some(Scalar::F32)), (Some("f64"), Some(Scalar::F64))] {
        for (lang, language) in [("rust", Language::Rust), ("c", Language::C), ("step", Language::Step)] {
            let [cli, built] = ["cli", "built"].map(|door| folder.join(format!("{door}_{lang}_{word:?}")));
            let mut generate = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
            generate.arg("generate").arg(&pattern).args(["--lang", lang, "--out"]).arg(&cli);
            succeed(generate.args(word.map(|word| ["--scalar", word]).iter().flatten()));
            let build = Build::new().specs(&pattern).language(language).out_dir(&built);
            let build = scalar.map_or(build.clone(), |scalar| build.scalar(scalar));
            build.run().unwrap_or_else(|report| panic!("{}", report.render(false)));
            let expected = files(&cli);
            assert_eq!(files(&built), expected, "{lang} {word:?}");

            let spec = folder.join("specs/a.toml");
            let text = fs::read_to_string(&spec).expect("the specification");
            let generator = Generator::new(&text, &spec.to_string_lossy()).with(Settings { scalar });
            let generated = generator.design().expect("a design");
            let one = |output: Output| output.only(&[language]).files().to_vec();
            for file in one(Output::new(&generated, generator.source())) {
                assert!(expected.contains(&(file.name.clone(), file.text)), "{} {word:?}", file.name);
            }
            for file in one(Output::included(&generated, generator.source())) {
                let (_, module) = expected.iter().find(|(name, _)| *name == file.name).expect("the file");
                let items = |text: &str| text[text.find("pub use ::deadbeat").unwrap_or(0)..].to_owned();
                assert!(items(&file.text) == items(module), "{} {word:?}", file.name);
            }
        }
    }
}

/// The command line and the macro use what is public: another program can do what they do.
#[test]
fn the_doors_use_what_is_promised() {
    let cli = fs::read_dir(root().join("codegen/cli")).expect("its folder").map(|it| it.expect("a file").path());
    let others = ["codegen/cli.rs", "codegen/main.rs", "codegen/macros/src/lib.rs"].map(|path| root().join(path));
    let all: Vec<_> = cli.chain(others).collect();
    assert!(all.len() > 8, "{all:?}");
    for path in all {
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(!text.contains("internals"), "{} uses what is not promised", path.display());
    }
}
