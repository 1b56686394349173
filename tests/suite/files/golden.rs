//! Claim: `generated/{rust,c,step}` hold what the corpus generates, byte for byte and nothing else, and every
//! method of the registry can be seen in the corpus, in `generated/`, in the README and in the manual.
//!
//! `DEADBEAT_BLESS=1` rewrites them; their difference in a review is the description of the
//! change.

use crate::support::corpus;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::OnceLock;
use std::{env, fs};

use corpus::{Entry, corpus, root, side_by_side};
use deadbeat_codegen::{Generator, Language, METHODS};

/// The folder of each language below `generated/`.
const FOLDERS: [(&str, Language); 3] = [("rust", Language::Rust), ("c", Language::C), ("step", Language::Step)];

/// Every file that belongs into `generated/`, by its path.
fn wanted() -> BTreeMap<PathBuf, String> {
    let files = side_by_side(&corpus(), |entry: &Entry| {
        let generator = Generator::new(&entry.text, &format!("specs/{}.toml", entry.stem));
        let output = generator.generate().unwrap_or_else(|report| panic!("{}", report.render(false)));
        output.files().to_vec()
    });
    let place = |language| FOLDERS.iter().find(|(_, it)| *it == language).expect("a folder for each language").0;
    let folder = root().join("generated");
    files.into_iter().flatten().map(|file| (folder.join(place(file.language)).join(&file.name), file.text)).collect()
}

/// Every file that is in the folders of the languages.
fn found() -> Vec<PathBuf> {
    let folders = FOLDERS.iter().filter_map(|(name, _)| fs::read_dir(root().join("generated").join(name)).ok());
    folders.flatten().map(|entry| entry.expect("an entry of generated/").path()).collect()
}

/// What belongs there; with `DEADBEAT_BLESS=1` it is written there, before any test looks.
fn wanted_and_blessed() -> &'static BTreeMap<PathBuf, String> {
    static WANTED: OnceLock<BTreeMap<PathBuf, String>> = OnceLock::new();
    WANTED.get_or_init(|| {
        let wanted = wanted();
        if env::var("DEADBEAT_BLESS").is_ok_and(|value| value == "1") {
            for path in found().into_iter().filter(|path| !wanted.contains_key(path)) {
                fs::remove_file(path).expect("a left-over file goes");
            }
            for (path, text) in &wanted {
                corpus::put(path, text);
            }
        }
        wanted
    })
}

/// What differs first, for a message.
fn first_difference(found: &str, wanted: &str) -> String {
    let lines = found.lines().zip(wanted.lines()).enumerate();
    let differing = lines.filter(|(_, (a, b))| a != b).map(|(at, (a, b))| format!("line {}\n- {a}\n+ {b}", at + 1));
    differing.into_iter().next().unwrap_or_else(|| "one is longer".to_owned())
}

/// Claim: `generated/{rust,c,step}` are what the corpus generates; no file is missing, stale or left over.
#[test]
fn generated_files_are_up_to_date() {
    let wanted = wanted_and_blessed();
    let mut wrong = Vec::new();
    for (path, text) in wanted {
        let name = path.strip_prefix(root()).unwrap_or(path).display();
        match fs::read(path) {
            Ok(found) if found == text.as_bytes() => {}
            Ok(found) => {
                wrong.push(format!("{name}: {}", first_difference(&String::from_utf8_lossy(&found), text)));
            }
            Err(error) => wrong.push(format!("{name}: {error}")),
        }
    }
    let left_over = found().into_iter().filter(|path| !wanted.contains_key(path));
    wrong.extend(left_over.map(|path| format!("{}: no specification makes it", path.display())));
    assert!(wrong.is_empty(), "DEADBEAT_BLESS=1 rewrites generated/\n{}", wrong.join("\n"));
}

/// Claim: every method has a specification in the corpus and a row in the README's and the manual's tables.
#[test]
fn every_method_can_be_seen() {
    wanted_and_blessed();
    let corpus = corpus();
    let pages = ["README.md", "manual/choosing.md"]
        .map(|path| (path, fs::read_to_string(root().join(path)).unwrap_or_default()));
    let mut missing = Vec::new();
    for method in METHODS {
        let table = format!("[observer.{}]", method.name);
        let users: Vec<&Entry> = corpus.iter().filter(|it| it.text.lines().any(|line| line.trim() == table)).collect();
        if users.is_empty() {
            missing.push(format!("specs/{}.toml: {table}", method.name));
        }
        let mentioned = |entry: &&Entry| {
            let step = root().join("generated/step").join(format!("{}.step", entry.stem));
            fs::read_to_string(step).is_ok_and(|text| text.contains(&format!("# Method     {}: ", method.name)))
        };
        if !users.iter().any(mentioned) {
            missing.push(format!("generated/step/*.step: # Method     {}: …", method.name));
        }
        for (path, text) in &pages {
            if !text.lines().any(|line| line.starts_with(&format!("| `{}` |", method.name))) {
                missing.push(format!("{path}: | `{}` | {} | {} |", method.name, method.summary, method.source));
            }
        }
    }
    assert!(missing.is_empty(), "a method is not shown everywhere; these lines are missing:\n{}", missing.join("\n"));
}

/// Claim: the corpus uses no method that the registry does not have.
#[test]
fn every_table_of_the_corpus_is_a_method() {
    for entry in corpus() {
        let used = entry.text.lines().filter_map(|line| line.trim().strip_prefix("[observer.")?.strip_suffix(']'));
        for name in used {
            assert!(METHODS.iter().any(|method| method.name == name), "specs/{}.toml: {name}", entry.stem);
        }
    }
}

/// Claim: no dependency chooses its arithmetic by the processor it runs on; some constants come from matrices of doubles.
#[test]
fn no_arithmetic_depends_on_the_processor() {
    let lock = fs::read_to_string(root().join("Cargo.lock")).expect("Cargo.lock");
    assert!(lock.contains("name = \"nalgebra\""));
    assert!(!lock.contains("name = \"matrixmultiply\""), "nalgebra's feature `std` brings it in");
}
