//! Files that a replay reads and writes: `-` is standard input or output, and nothing that is read is overwritten.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use deadbeat_codegen::replay::Recording;

use super::{Failure, print};

/// Whether a file is standard input or output.
pub fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// The recording, up to its header.
pub fn open(path: &Path) -> Result<Recording<Box<dyn Read>>, Failure> {
    let (source, name): (Box<dyn Read>, String) = if is_standard(path) {
        (Box::new(io::stdin()), "standard input".into())
    } else {
        let name = path.display().to_string();
        let file = File::open(path).map_err(|error| Failure::Wrong(format!("cannot read {name}: {error}")))?;
        (Box::new(file), name)
    };
    Ok(Recording::open(source, &name)?)
}

/// Writes a whole file, or prints it.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    if is_standard(path) {
        return print(text);
    }
    deadbeat_codegen::write_whole(path, text).map_err(|error| unwritable(path, &error))
}

/// Why a file could not be written.
pub fn unwritable(path: &Path, error: &io::Error) -> Failure {
    Failure::Wrong(format!("cannot write {}: {error}", path.display()))
}

/// Refuses to write a file that is read, or one file twice; each with its role in messages.
pub fn nothing_overwritten(read: &[(&str, &Path)], written: &[(&str, &Path)]) -> Result<(), Failure> {
    let mut taken: Vec<(&str, PathBuf)> =
        read.iter().filter(|(_, path)| !is_standard(path)).map(|(role, path)| (*role, place(path))).collect();
    for (role, path) in written.iter().filter(|(_, path)| !is_standard(path)) {
        let place = place(path);
        if let Some((other, _)) = taken.iter().find(|(_, there)| *there == place) {
            return Err(Failure::Misused(format!("{role} would overwrite {}, which is {other}", path.display())));
        }
        taken.push((role, place));
    }
    Ok(())
}

/// A path that is the same for the same file, as far as it exists.
fn place(path: &Path) -> PathBuf {
    let beside = || {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Some(folder.canonicalize().ok()?.join(path.file_name()?))
    };
    path.canonicalize().ok().or_else(beside).unwrap_or_else(|| path.to_owned())
}
