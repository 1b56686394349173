//! Claim: the house has one way down. Every `crate::…`, `super::…` and `self::…` path of `codegen/` leads to the own room
//! or to a lower floor of the table in ARCHITECTURE.md: never up, and never sideways.
//!
//! A room is a module with all that stands below it, unless the table names a room in there. Modules under
//! `#[cfg(test)]` may look anywhere: they are no part of the library.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A path in a source file, from the crate's root, with the line that it stands on.
type Arrow = (Vec<String>, usize);

/// The table of rooms: module path to floor.
struct House {
    floors: BTreeMap<Vec<String>, usize>,
}

/// What a path names where it names nothing of a lower room: the crate's root.
const ROOT: &str = "lib";

impl House {
    /// The rows `| floor | room, … | … |` behind the heading "## Rooms".
    fn new(architecture: &str) -> Self {
        let mut floors = BTreeMap::new();
        let (_, section) = architecture.split_once("\n## Rooms").expect("a section of rooms");
        for row in section.lines().skip(1).take_while(|line| !line.starts_with("## ")) {
            let cells: Vec<&str> = row.split('|').map(str::trim).collect();
            let Some(floor) = cells.get(1).and_then(|cell| cell.parse().ok()) else { continue };
            for room in cells[2].split(',') {
                let room = room.trim().trim_matches('`').split('/').map(str::to_owned).collect();
                assert_eq!(floors.insert(room, floor), None, "{row}: a room stands twice");
            }
        }
        Self { floors }
    }

    /// The innermost room of a module or of something in it.
    fn room(&self, path: &[String]) -> &[String] {
        let innermost = (1..=path.len()).rev().find_map(|end| self.floors.get_key_value(&path[..end]));
        innermost.map_or_else(|| [].as_slice(), |(room, _)| room.as_slice())
    }

    fn floor(&self, room: &[String]) -> usize {
        *self.floors.get(room).unwrap_or_else(|| panic!("no room {}", room.join("/")))
    }

    /// Everything that is wrong with a file's arrows, a line each.
    fn wrong(&self, name: &str, module: &[String], text: &str) -> Vec<String> {
        let own = self.room(module);
        if own.is_empty() {
            return vec![format!("{name} stands in no room of ARCHITECTURE.md")];
        }
        let mut wrong = Vec::new();
        for (path, line) in arrows(text, module) {
            let named = self.room(&path);
            let other = if named.is_empty() { &[ROOT.to_owned()][..] } else { named };
            let (from, to) = (self.floor(own), self.floor(other));
            if own != other && from <= to {
                let way = if from == to { "sideways" } else { "up" };
                let (own, other) = (own.join("/"), other.join("/"));
                wrong.push(format!(
                    "{name}:{line}: `{}` leads {way}: {own} (floor {from}) to {other} (floor {to})",
                    path.join("::")
                ));
            }
        }
        wrong
    }
}

/// Every path of a file that starts at the crate, at a parent or at the module itself.
fn arrows(text: &str, module: &[String]) -> Vec<Arrow> {
    let mut found = Vec::new();
    let stream: TokenStream = text.parse().unwrap_or_else(|error| panic!("{}: {error}", module.join("/")));
    scan(stream, module, &mut found);
    found
}

fn scan(stream: TokenStream, module: &[String], found: &mut Vec<Arrow>) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        if let Some(end) = test_module(&tokens[at..]) {
            at += end;
            continue;
        }
        let starts = !(at >= 2 && is_colon(&tokens[at - 1]) && is_colon(&tokens[at - 2]));
        match &tokens[at] {
            TokenTree::Ident(word) if starts && leads_on(&tokens[at..]) => {
                let mut base = if *word == "crate" { Vec::new() } else { module.to_vec() };
                if *word == "super" {
                    base.pop();
                }
                at += 1 + path(&tokens[at + 1..], &base, word.span().start().line, found);
            }
            TokenTree::Group(group) => {
                scan(group.stream(), module, found);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// `#[cfg(test)] mod name { … }` or `#[cfg(test)] mod name;`: how many tokens it has.
fn test_module(tokens: &[TokenTree]) -> Option<usize> {
    let [TokenTree::Punct(hash), TokenTree::Group(attribute), rest @ ..] = tokens else { return None };
    let test = attribute.stream().to_string().replace(' ', "") == "cfg(test)";
    let named = rest.iter().position(|token| matches!(token, TokenTree::Ident(word) if word == "mod"))?;
    // Between the attribute and `mod` only a visibility stands.
    (hash.as_char() == '#' && test && named <= 2).then_some(2 + named + 3)
}

/// What follows `base` behind a `crate`, `super` or `self`: `::name`, `::{…}`, `::*`. Returns the tokens that were read.
fn path(tokens: &[TokenTree], base: &[String], line: usize, found: &mut Vec<Arrow>) -> usize {
    let mut whole = base.to_vec();
    let mut at = 0;
    while tokens.len() > at + 2 && is_colon(&tokens[at]) && is_colon(&tokens[at + 1]) {
        match &tokens[at + 2] {
            TokenTree::Ident(word) if word == "super" => {
                whole.pop();
            }
            TokenTree::Ident(word) => whole.push(word.to_string()),
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                for tree in inner.split(|token| matches!(token, TokenTree::Punct(it) if it.as_char() == ',')) {
                    if let Some(TokenTree::Ident(word)) = tree.first() {
                        let mut branch = whole.clone();
                        if word != "self" {
                            branch.push(word.to_string());
                        }
                        path(&tree[1..], &branch, word.span().start().line, found);
                    }
                }
                return at + 3;
            }
            _ => break,
        }
        at += 3;
    }
    found.push((whole, line));
    at
}

/// Whether a path starts here: `self` alone is a value, and `pub(super)` leads nowhere.
fn leads_on(tokens: &[TokenTree]) -> bool {
    let [TokenTree::Ident(word), one, two, ..] = tokens else { return false };
    (*word == "crate" || *word == "super" || *word == "self") && is_colon(one) && is_colon(two)
}

fn is_colon(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(it) if it.as_char() == ':')
}

/// The library's source files with their modules; the binary, the doors of the command line and the macro are other crates.
fn files() -> Vec<(PathBuf, Vec<String>)> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).expect("a folder of the project") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                walk(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("codegen");
    let mut found = Vec::new();
    walk(&root, &mut found);
    found.sort();
    let module = |path: &PathBuf| {
        let inside = path.strip_prefix(&root).expect("within codegen").with_extension("");
        inside.iter().map(|part| part.to_string_lossy().into_owned()).collect::<Vec<String>>()
    };
    let modules = found.into_iter().map(|path| (path.clone(), module(&path)));
    modules.filter(|(_, module)| !["main", "cli", "macros"].contains(&module[0].as_str())).collect()
}

fn house() -> House {
    House::new(include_str!("../../ARCHITECTURE.md"))
}

/// The sources of the library keep to the table.
#[test]
fn every_arrow_runs_down() {
    let house = house();
    let mut wrong = Vec::new();
    for (path, module) in files() {
        let name = path.strip_prefix(env!("CARGO_MANIFEST_DIR")).expect("within the project").display().to_string();
        let text = fs::read_to_string(&path).expect("a source file");
        wrong.extend(house.wrong(&name, &module, &text));
    }
    assert!(wrong.is_empty(), "{} arrows:\n{}", wrong.len(), wrong.join("\n"));
}

/// Every room of the table stands, and begins with what it knows and what it never knows.
#[test]
fn every_room_says_what_it_never_knows() {
    let files = files();
    let mut wrong = Vec::new();
    for room in house().floors.keys() {
        let Some((path, _)) = files.iter().find(|(_, module)| module == room) else {
            wrong.push(format!("{}: no such room", room.join("/")));
            continue;
        };
        let text = fs::read_to_string(path).expect("a source file");
        let doc: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim).collect();
        let doc = doc.join(" ");
        if !(doc.contains("Knows ") && doc.contains("ever knows ")) {
            wrong.push(format!("{}: its first lines do not say what it knows and never knows", path.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Arrows that run up or sideways are found in every spelling, with file, line and both rooms.
#[test]
fn an_arrow_that_runs_up_is_found() {
    let table = "\n## Rooms\n| floor | room | what |\n|---|---|---|\n| 0 | `ground` | |\n| 1 | `middle` | |\n\
                 | 2 | `one/left`, `one/right` | |\n| 3 | `one` | |\n| 4 | `lib` | |\n## More\n| 9 | `no` | |\n";
    let house = House::new(table);
    let module = |name: &str| name.split('/').map(str::to_owned).collect::<Vec<String>>();
    let middle = |text: &str| house.wrong("codegen/middle/a.rs", &module("middle/a"), text);
    for good in [
        "use crate::ground::{a, b::{self, C}};",
        "use super::b;\nuse self::c::D;",
        "pub(crate) fn f() -> crate::ground::A { super::g() }",
        "#[cfg(test)]\nmod tests {\n    use crate::one::Two;\n}",
    ] {
        assert_eq!(middle(good), Vec::<String>::new(), "{good}");
    }
    for (bad, line) in [
        ("\nuse crate::one::left::A;", 2),
        ("use crate::{ground::A,\n one::{left, B}};", 2),
        ("fn f() {\n let x = [crate::one::left::g()];\n}", 2),
        ("use super::super::one::left::A;", 1),
        ("use crate::Generator;", 1),
        ("#[cfg(test)]\nuse crate::one::Two;", 2),
    ] {
        let wrong = middle(bad);
        assert!(!wrong.is_empty(), "{bad}");
        assert!(wrong[0].starts_with(&format!("codegen/middle/a.rs:{line}: ")), "{bad}: {wrong:?}");
        assert!(wrong[0].contains("leads up: middle (floor 1) to "), "{bad}: {wrong:?}");
    }
    let sideways = house.wrong("codegen/one/left.rs", &module("one/left"), "use super::right::A;");
    assert!(sideways[0].contains("leads sideways: one/left (floor 2) to one/right (floor 2)"), "{sideways:?}");
}
