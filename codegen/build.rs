//! The build script's door: `deadbeat_codegen::build("specs/motor.toml")`.

use std::path::{Path, PathBuf};

use crate::emit::{self, Door};
use crate::output::{Language, header, write_whole};
use crate::{Generator, Report};

/// Generates the observer of a specification into `OUT_DIR` as `<name>.rs`, for one `include!`.
///
/// To be called from a build script: tells cargo to run it again when the specification changes.
/// A mistake in the specification is printed with its place, and ends the build.
pub fn build(spec: impl AsRef<Path>) {
    let spec = spec.as_ref();
    println!("cargo::rerun-if-changed={}", spec.display());
    let Some(folder) = std::env::var_os("OUT_DIR") else {
        fail("OUT_DIR is not set: `deadbeat_codegen::build` belongs into a build script");
    };
    if let Err(message) = generate(spec, &PathBuf::from(folder)) {
        fail(&message);
    }
}

fn generate(spec: &Path, folder: &Path) -> Result<(), String> {
    let display = spec.display().to_string();
    let text = std::fs::read_to_string(spec).map_err(|error| format!("cannot read {display}: {error}"))?;
    let generator = Generator::new(&text, &display);
    let rendered = |report: Report| report.render(false);
    let generated = generator.design().map_err(rendered)?;
    for line in generated.report.render(false).lines().filter(|line| !line.is_empty()) {
        println!("cargo::warning={line}");
    }
    let header = header::header(&generated, generator.source(), Language::Rust);
    let text = emit::rust(&generated.program, &header, Door::Include);
    let path = folder.join(format!("{}.rs", generated.program.name));
    write_whole(&path, &text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}

fn fail(message: &str) -> ! {
    eprintln!("{message}");
    std::process::exit(1)
}
