//! Claims about the parts as texts; `twin` compiles and runs them.

mod twin;

use super::*;

/// Claim: every name that a part uses is defined by a part, once, and no later than where it is used: nothing is
/// missing, there is no circle, and the order of [`PARTS`] is one in which C can be read.
#[test]
fn every_name_is_defined_where_it_is_used() {
    let mut defined = BTreeSet::new();
    for part in PARTS {
        for name in part.defined() {
            assert!(defined.insert(name), "{name} is defined twice");
        }
        for name in names(part.text) {
            assert!(defined.contains(name), "{}: {name} is not defined yet", part.name);
        }
    }
}

/// Claim: each file of the folder is a part, and defines its name or a group of constants.
#[test]
fn every_file_is_a_part() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/codegen/emit/c/math");
    let paths = std::fs::read_dir(folder).expect("the folder of the parts").map(|it| it.expect("an entry").path());
    let is_c = |path: &std::path::PathBuf| path.extension().is_some_and(|it| it == "c");
    let stems = paths.filter(is_c).map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned());
    let files: BTreeSet<String> = stems.collect();
    let parts: BTreeSet<String> = PARTS.iter().map(|part| part.name.to_owned()).collect();
    assert_eq!(files, parts);
    assert_eq!(parts.len(), PARTS.len(), "a part twice");
    for part in PARTS {
        assert!(part.defined().next().is_some(), "{} defines nothing", part.name);
    }
}

/// Claim: a part includes nothing, and what it has at file scope carries the prefix.
#[test]
fn parts_keep_to_the_prefix() {
    for part in PARTS {
        assert!(!part.text.contains("#include"), "{}", part.name);
        for line in part.text.lines().filter(|line| line.starts_with("static") || line.starts_with("#define")) {
            assert!(names(line).next().is_some(), "{line}");
        }
    }
}

/// Claim: what a function of single precision requires has no double in it.
#[test]
fn single_precision_uses_no_double() {
    let functions = PARTS.iter().filter(|part| part.name.ends_with("_f32"));
    for part in functions.flat_map(|function| closure(BTreeSet::from([function.name.to_owned()]))) {
        let text = without_comments(part.text);
        let words = |c: char| !c.is_alphanumeric() && c != '_' && c != '.';
        assert!(!text.split(words).any(|word| word == "double"), "{}", part.name);
        assert!(!text.contains("f64"), "{}", part.name);
        for word in text.split(words).filter(|word| word.starts_with(char::is_numeric)) {
            assert!(!word.contains('.') || word.ends_with('f'), "{}: {word}", part.name);
        }
    }
}

/// The text between the comments.
fn without_comments(text: &str) -> String {
    text.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code)).collect()
}
