//! Patterns of files: `specs/*.toml`.

use std::io;
use std::path::{Path, PathBuf};

use super::shown;
use crate::Report;
use crate::diagnostic::codes;

const HELP: &str = "each `*` stands for any characters in the last part of a path: `specs/*.toml`";

/// The files of a pattern, by name; at least one.
pub fn files(path: &Path) -> Result<Vec<PathBuf>, Report> {
    let (name, folder) = (shown(path), folder(path));
    let last = path.file_name().unwrap_or_default().to_string_lossy();
    let wrong = |code, message| Report::without_place(&name, code, message, HELP);
    let unread = |error| wrong(codes::FILE, format!("cannot read the folder `{}`: {error}", shown(folder)));
    let entries: Vec<_> = std::fs::read_dir(folder).and_then(io::Result::from_iter).map_err(unread)?;
    let fits = |name: &str| name.starts_with('.') == last.starts_with('.') && fits(&last, name);
    let names = entries.iter().map(std::fs::DirEntry::file_name).filter(|name| fits(&name.to_string_lossy()));
    // `with_file_name` keeps the folder as it was written.
    let mut files: Vec<PathBuf> = names.map(|name| path.with_file_name(name)).filter(|file| file.is_file()).collect();
    files.sort();
    if files.is_empty() { Err(wrong(codes::REQUEST, format!("no file fits the pattern `{name}`"))) } else { Ok(files) }
}

/// Where the files of a pattern are.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether a name is the pattern's, each `*` of which stands for any characters.
fn fits(pattern: &str, name: &str) -> bool {
    let Some((start, rest)) = pattern.split_once('*') else { return pattern == name };
    let Some(name) = name.strip_prefix(start) else { return false };
    name.char_indices().map(|(at, _)| at).chain([name.len()]).any(|at| fits(rest, &name[at..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Claim: a star stands for any characters or none, everything else for itself.
    #[test]
    fn stars_stand_for_any_characters() {
        for (pattern, name) in
            [("*.toml", "a.toml"), ("*", ""), ("a*b*c", "a-b-bc"), ("é*ü", "éöü"), ("a.toml", "a.toml")]
        {
            assert!(fits(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [("*.toml", "a.tom"), ("", "a"), ("a*b*c", "a-c-b"), ("a*a", "a"), ("a.toml", "a.tomlx")]
        {
            assert!(!fits(pattern, name), "{pattern} {name}");
        }
    }
}
