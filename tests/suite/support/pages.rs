//! The pages for people: the README and the chapters of the manual, their blocks, links and headings.

#![allow(dead_code, reason = "each test uses its part of this")]

use std::collections::BTreeSet;
use std::path::Path;
use std::{fmt, fs};

/// A Markdown file.
pub struct Page {
    /// From the repository's root.
    pub path: String,
    /// All of it, line ends as `\n`.
    pub text: String,
    /// Its fenced blocks.
    pub blocks: Vec<Block>,
}

/// A fenced block.
pub struct Block {
    /// What stands behind the fence.
    pub language: String,
    /// Between the fences, with a line end behind each line.
    pub text: String,
}

impl Page {
    /// A file of the repository.
    pub fn read(path: &str) -> Self {
        let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path);
        let text = text.replace("\r\n", "\n");
        // Every second part is within a fence; a fence stands at the beginning of a line.
        let parts: Vec<&str> = text.split("\n```").collect();
        assert!(parts.len() % 2 == 1, "{path}: a fence is not closed");
        let block = |part: &&str| {
            let (language, text) = part.split_once('\n').unwrap_or((part, ""));
            assert!(!language.is_empty(), "{path}: a block without a language:\n{text}");
            Block { language: language.to_owned(), text: format!("{text}\n") }
        };
        let blocks = parts.iter().skip(1).step_by(2).map(block).collect();
        Self { path: path.to_owned(), text, blocks }
    }

    /// The blocks of a language that begin with some text.
    pub fn block(&self, language: &str, start: &str) -> &str {
        let found = self.blocks.iter().find(|block| block.language == language && block.text.starts_with(start));
        &found.unwrap_or_else(|| panic!("{self}: no {language} block `{start}`")).text
    }
}

impl fmt::Display for Page {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.path)
    }
}

/// The files of `manual/`.
pub fn manual() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("manual");
    let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("an entry").file_name().into_string().expect("text");
    let mut names: Vec<String> = fs::read_dir(folder).expect("the manual").map(name).collect();
    names.sort();
    names.retain(|name| Path::new(name).extension().is_some_and(|it| it == "md"));
    names.iter().map(|name| format!("manual/{name}")).collect()
}

/// The README and the manual.
pub fn pages() -> Vec<Page> {
    std::iter::once("README.md".to_owned()).chain(manual()).map(|path| Page::read(&path)).collect()
}

/// Where the links lead, in order; not those within fenced blocks.
pub fn links(text: &str) -> Vec<String> {
    let prose: String = text.split("\n```").step_by(2).collect();
    let targets = prose.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    targets.map(str::to_owned).collect()
}

/// What a link may name behind `#`: the headings in small letters, hyphens for blanks, other signs left out.
pub fn anchors(text: &str) -> BTreeSet<String> {
    let prose = text.split("\n```").step_by(2).flat_map(str::lines);
    let slug = |heading: &str| {
        let kept = heading.trim().to_lowercase().replace(' ', "-");
        kept.chars().filter(|it| it.is_alphanumeric() || matches!(it, '-' | '_')).collect()
    };
    prose.filter(|line| line.starts_with('#')).map(|line| slug(line.trim_start_matches('#'))).collect()
}

/// The words of a help page, without what stands around them.
pub fn words(text: &str) -> BTreeSet<&str> {
    text.split(|it: char| !(it.is_alphanumeric() || it == '-' || it == '_')).collect()
}

/// Every line of a quotation stands in a text, in this order; `...` leaves some out.
pub fn assert_quoted(quotation: &str, text: &str, page: &Page) {
    let mut lines = text.lines().map(|line| line.trim_start_matches([' ', '*']).trim_end());
    for line in quotation.lines().map(str::trim).filter(|line| !line.is_empty() && *line != "...") {
        assert!(
            lines.any(|found| found == line),
            "{page}: `{line}` is not what the tool says, or not behind the line before:\n{text}"
        );
    }
}
