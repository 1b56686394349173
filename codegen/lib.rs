//! deadbeat: one specification in, a step function out that has converged by a time its user chose.
//!
//! Knows the order of the stages. Never knows what one does.
//!
//! ```text
//! spec text -> Spec -> Plant -> Design -> Program -> .rs, .h + .c, .step
//! ```
//!
//! Text in, a list of files out; only [`Build`], [`Output::write_to`] and [`Output::verify`], the macro and
//! the command line touch the disk. Start at [`Generator`].

/// The rooms of the generator, for its own tests and tools. They promise nothing: any of it may change with any version.
#[doc(hidden)]
#[path = "."]
pub mod internals {
    pub mod decimal;
    pub mod diagnostic;
    pub mod emit;
    pub mod estimator;
    pub mod expr;
    pub mod generated;
    pub mod method;
    pub mod names;
    pub mod numbers;
    pub mod output;
    pub mod plant;
    pub mod program;
    pub mod promise;
    pub mod real;
    pub mod sampled;
    pub mod spec;
    pub mod step;
}

mod build;
#[cfg(feature = "replay")]
pub mod figure;
#[cfg(feature = "replay")]
pub mod replay;

use internals::{
    decimal, emit, estimator, expr, generated, method, names, numbers, output, plant, real, sampled, spec, step,
};

pub use build::{Build, build, specifications};
pub use diagnostic::{Report, Source};
pub use estimator::{Design, Estimator};
pub use generated::{Generated, VERSION};
#[doc(inline)]
pub use internals::{diagnostic, program, promise};
pub use method::matrix::Cell;
pub use method::{METHODS, Method, Moment};
pub use output::{Difference, File, Language, Output, write_whole};
pub use plant::Plant;
pub use plant::features::{Feature, Limit};
pub use spec::Settings;

use promise::one_count::OneCount;
use step::ahead::Ahead;

/// One specification on its way to code.
#[derive(Clone, Debug)]
pub struct Generator {
    source: Source,
    settings: Settings,
}

impl Generator {
    /// Takes a specification's text; `name` is what messages call it.
    pub fn new(text: &str, name: &str) -> Self {
        Self { source: Source { name: name.into(), text: text.into() }, settings: Settings::default() }
    }

    /// Takes a specification's bytes as they were read; `name` is what messages call it.
    ///
    /// # Errors
    /// They could not be read, or are no text: with the line of the first byte that is none.
    pub fn read(bytes: std::io::Result<Vec<u8>>, name: &str) -> Result<Self, Report> {
        let unread = |message, help| Report::without_place(name, diagnostic::codes::FILE, message, help);
        let bytes = bytes.map_err(|error| {
            let help = "paths are relative to the current folder; in a build script, to that of `Cargo.toml`";
            unread(format!("cannot read `{name}`: {error}"), help)
        })?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let good = error.utf8_error().valid_up_to();
            let before = String::from_utf8_lossy(&error.as_bytes()[..good]).into_owned();
            let (line, column) = Source { name: name.into(), text: before.into() }.position(good);
            let byte = error.as_bytes()[good];
            let message = format!("`{name}` is not UTF-8: byte 0x{byte:02x} in line {line}, column {column}");
            unread(message, "save it as UTF-8, or replace the letter that is not one of ASCII's")
        })?;
        Ok(Self::new(&text, name))
    }

    /// Overrides what the file's `[target]` says.
    #[must_use]
    pub fn with(mut self, settings: Settings) -> Self {
        self.settings = settings;
        self
    }

    /// The specification's text and name.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The five stages up to the Program.
    pub fn design(&self) -> Result<Generated, Report> {
        let report = |diagnostics| Report::new(self.source.clone(), diagnostics);
        let (spec, keyed) = method::read(self.source.clone(), self.settings)?;
        let (plant, mut warnings) = Plant::new(&spec)?;
        let plant = keyed.observed(plant).map_err(report)?;
        let refused = method::refusals(&plant, &spec.observer.method.value, keyed.as_ref());
        if !refused.is_empty() {
            return Err(report(refused));
        }
        let mut design = keyed.design(&plant).map_err(report)?;
        let ahead = Ahead::new(&plant).map_err(report)?;
        if let Some(ahead) = &ahead {
            design.moved(&plant, ahead);
        }
        let program = design.estimator.lower(&plant, ahead.as_ref(), &design.certificate).map_err(report)?;
        if let Err(error) = program::check::check(&program) {
            unreachable!("a lowering made an invalid Program: {error}");
        }
        let one_count = OneCount::new(&plant, &program, design.valid_from_step);
        design.notes.extend(one_count.notes(&plant));
        design.notes.extend(plant.outputs.iter().filter_map(output::header::noise_parts));
        design.notes.extend(plant::moved::notes(&plant));
        design.warnings.extend(design.rounded(&plant));
        warnings.extend(design.warnings.iter().cloned());
        Ok(Generated { plant, design, program, one_count, settings: self.settings, report: report(warnings) })
    }

    /// What the gains are at one step from the first sample on; inside, a text says why the method has nothing to show.
    pub fn at(&self, step: usize) -> Result<Result<Moment, String>, Report> {
        let plant = self.design()?.plant;
        let (_, keyed) = method::read(self.source.clone(), self.settings)?;
        Ok(keyed.at(&plant, step))
    }

    /// Everything that stands against the specification, and the warnings.
    pub fn check(&self) -> Report {
        self.design().map_or_else(|report| report, |generated| generated.report)
    }

    /// The files of every language.
    pub fn generate(&self) -> Result<Output, Report> {
        Ok(Output::new(&self.design()?, &self.source))
    }
}
