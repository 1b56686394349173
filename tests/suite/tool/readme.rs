//! Claim: what the README and the manual say is what the tool does. A specification is accepted, or refused with the
//! message that stands behind it; headers, code and sessions are those of the tool; commands, options, files and links
//! exist; C compiles. (`doors.rs` compiles the README's Rust.)

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::corpus::{empty_folder, put, root, runs, succeed};
use crate::support::pages::{Block, Page, anchors, assert_quoted, links, manual, pages, words};
use deadbeat_codegen::Generator;

/// What a specification becomes: a file by its ending.
fn generated(spec: &str, ending: &str) -> String {
    let generator = Generator::new(spec, &named(spec, "toml"));
    let output = generator.generate().unwrap_or_else(|report| panic!("{}", report.render(false)));
    let name = named(spec, ending);
    output.files().iter().find(|file| file.name == name).expect("a file for each language").text.clone()
}

/// The file that a specification, by its `name`, gives.
fn named(spec: &str, ending: &str) -> String {
    let line = spec.lines().find_map(|line| line.strip_prefix("name = \"")).expect("a name");
    format!("{}.{ending}", line.trim_end_matches('"'))
}

/// Whether a block is a whole specification; others are parts of files.
fn whole(block: &Block) -> bool {
    block.language == "toml" && block.text.starts_with("deadbeat = 1")
}

/// The blocks of a language, each with the specification before it on its page.
fn behind_a_specification<'a>(page: &'a Page, language: &str) -> Vec<(&'a Block, &'a str)> {
    let before = |at: usize| page.blocks[..at].iter().rfind(|block| whole(block)).map(|block| block.text.as_str());
    let blocks = page.blocks.iter().enumerate().filter(|(_, block)| block.language == language);
    blocks
        .map(|(at, block)| (block, before(at).unwrap_or_else(|| panic!("{page}: no specification before it"))))
        .collect()
}

/// Claim: the README is read in ten minutes, and its specification has twenty lines.
#[test]
fn the_readme_is_short() {
    let readme = Page::read("README.md");
    assert!(readme.text.lines().count() <= 150, "{} lines", readme.text.lines().count());
    let wide: Vec<&str> = readme.text.lines().filter(|line| line.chars().count() > 120).collect();
    assert!(wide.is_empty(), "{wide:#?}");
    let specification = readme.blocks.iter().find(|block| whole(block)).expect("a specification");
    let lines = specification.text.lines().filter(|line| !line.trim().is_empty()).count();
    assert!(lines <= 20 && specification.text.contains("[inputs]"), "{lines} lines");
}

/// Claim: the summary lists every chapter once, and nothing else.
#[test]
fn the_summary_lists_every_chapter() {
    let listed: Vec<String> = links(&Page::read("manual/SUMMARY.md").text);
    let there: BTreeSet<String> = manual().into_iter().filter(|path| !path.ends_with("SUMMARY.md")).collect();
    assert_eq!(listed.len(), there.len());
    assert_eq!(listed.iter().map(|name| format!("manual/{name}")).collect::<BTreeSet<_>>(), there);
}

/// Claim: every relative link leads to a file, and every part of a page that is named is one of its headings.
#[test]
fn every_link_resolves() {
    let mut broken = Vec::new();
    for page in pages().into_iter().chain(["specs/README.md", "generated/README.md"].map(Page::read)) {
        for link in links(&page.text).into_iter().filter(|link| !link.starts_with("http")) {
            let (file, part) = link.split_once('#').unwrap_or((&link, ""));
            let folder = Path::new(&page.path).parent().expect("a file in a folder");
            let path = if file.is_empty() { root().join(&page.path) } else { root().join(folder).join(file) };
            let there = path.exists()
                && (part.is_empty() || anchors(&fs::read_to_string(&path).unwrap_or_default()).contains(part));
            if !there {
                broken.push(format!("{page}: {link}"));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// Claim: every specification is accepted, and every other TOML block is TOML.
#[test]
fn every_specification_is_accepted() {
    let mut accepted = 0;
    for page in pages() {
        for block in page.blocks.iter().filter(|block| block.language == "toml") {
            if whole(block) {
                let report = Generator::new(&block.text, &named(&block.text, "toml")).check();
                assert!(!report.has_errors(), "{page}\n{}", report.render(false));
                accepted += 1;
            } else if let Err(error) = toml::from_str::<toml::Table>(&block.text) {
                panic!("{page}\n{}\n{error}", block.text);
            }
        }
    }
    assert!(accepted >= 6, "{accepted}");
}

/// Claim: a message that is quoted is what the specification before it gives with the quoted lines in it, and a header
/// that is quoted is that of the specification before it.
#[test]
fn messages_and_headers_are_the_tool_s() {
    let (mut messages, mut headers) = (0, 0);
    for page in pages() {
        for (block, spec) in behind_a_specification(&page, "text") {
            if block.text.starts_with("error[") {
                let mistaken = with_quoted_lines(spec, &block.text);
                let report = Generator::new(&mistaken, &named(spec, "toml")).check();
                assert_eq!(report.render(false).trim_end(), block.text.trim_end(), "{page}");
                messages += 1;
            } else {
                assert_quoted(&block.text, &generated(spec, "h"), &page);
                headers += 1;
            }
        }
    }
    assert!(messages >= 3 && headers >= 2, "{messages} messages, {headers} headers");
}

/// A specification with the lines that a message shows, `11 | …`, in their places.
fn with_quoted_lines(spec: &str, message: &str) -> String {
    let mut lines: Vec<&str> = spec.lines().collect();
    for line in message.lines() {
        let Some((number, text)) = line.split_once(" | ") else { continue };
        if let Ok(number) = number.trim().parse::<usize>() {
            lines[number - 1] = text;
        }
    }
    lines.join("\n")
}

/// Claim: C that includes the header compiles with the generated file; other C stands in the generated file.
#[test]
fn the_c_is_right() {
    let mut compiled = 0;
    for page in pages() {
        for (block, spec) in behind_a_specification(&page, "c") {
            if !block.text.starts_with("#include") {
                assert_quoted(&block.text, &generated(spec, "c"), &page);
                continue;
            }
            let folder = empty_folder("readme_c");
            put(&folder.join(named(spec, "h")), &generated(spec, "h"));
            put(&folder.join("user.c"), &block.text);
            for compiler in ["gcc", "clang"].into_iter().filter(|compiler| runs(compiler)) {
                let mut command = Command::new(compiler);
                succeed(command.current_dir(&folder).args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-c", "user.c"]));
                compiled += 1;
            }
        }
    }
    assert!(compiled >= 2, "{compiled}: a C compiler is needed, gcc or clang");
}

/// Claim: a session gives what is shown, `...` for what is left out.
#[test]
fn sessions_are_what_the_tool_prints() {
    let mut commands = 0;
    for page in pages() {
        let folder = empty_folder("readme_sessions");
        for block in &page.blocks {
            if whole(block) {
                put(&folder.join(named(&block.text, "toml")), &block.text);
            }
            let sessions = block.text.split("$ ").filter(|_| block.language == "console").skip(1);
            for (line, shown) in sessions.filter_map(|session| session.split_once('\n')) {
                let arguments = line.strip_prefix("deadbeat ").expect("a session with the tool").split(' ');
                arguments.clone().filter(|it| it.starts_with("specs/")).for_each(|file| bring(&folder, file));
                let mut tool = Command::new(env!("CARGO_BIN_EXE_deadbeat"));
                assert_quoted(shown, &succeed(tool.current_dir(&folder).args(arguments)), &page);
                commands += 1;
            }
        }
    }
    assert!(commands >= 5, "{commands}");
}

/// A file of the repository, at the same place below a folder.
fn bring(folder: &Path, file: &str) {
    let target = folder.join(file);
    fs::create_dir_all(target.parent().expect("a file in a folder")).expect("a folder");
    fs::copy(root().join(file), target).unwrap_or_else(|error| panic!("{file}: {error}"));
}

/// Claim: commands that are shown exist, with their options, and name files of the repository where they begin with a
/// folder of it.
#[test]
fn commands_exist() {
    let mut seen = BTreeSet::new();
    for page in pages() {
        for line in page.blocks.iter().filter(|block| block.language == "sh").flat_map(|block| block.text.lines()) {
            let line = line.split(" #").next().unwrap_or_default().trim();
            let line = line.strip_prefix("cargo run --release -- ").or_else(|| line.strip_prefix("deadbeat "));
            let Some((command, arguments)) = line.map(|line| line.split_once(' ').unwrap_or((line, ""))) else {
                continue;
            };
            let help = succeed(Command::new(env!("CARGO_BIN_EXE_deadbeat")).args([command, "--help"]));
            for argument in arguments.split(' ') {
                let option = argument.starts_with("--");
                assert!(!option || words(&help).contains(&argument), "{page}: {command} {argument}\n{help}");
                assert!(!argument.starts_with("specs/") || root().join(argument).exists(), "{page}: {argument}");
            }
            seen.insert(command.to_owned());
        }
    }
    let all = ["check", "compare", "design", "generate", "list", "run", "verify"];
    assert_eq!(seen.iter().map(String::as_str).collect::<Vec<_>>(), all);
}

/// Claim: every test that is named exists, and every file of `specs/` or `generated/`.
#[test]
fn named_files_exist() {
    let mut count = 0;
    for page in pages() {
        for name in page.text.split('`').skip(1).step_by(2).filter(|name| !name.contains([' ', '*', '<'])) {
            let ours = ["tests/", "specs/", "generated/"].iter().any(|folder| name.starts_with(folder));
            let alone =
                name.strip_prefix("tests/suite/").map_or_else(|| name.to_owned(), |test| format!("tests/{test}"));
            assert!(!ours || root().join(name).exists() || root().join(&alone).exists(), "{page}: `{name}`");
            count += usize::from(ours);
        }
    }
    assert!(count > 20, "{count}");
}
