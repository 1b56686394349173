//! Everything between a specification and its files: the plant, its design, the step, and what was said of them.
//!
//! Knows the stages' values. Never knows where a specification came from, nor what becomes of it.

use crate::diagnostic::Report;
use crate::estimator::Design;
use crate::plant::Plant;
use crate::program::Program;
use crate::promise::one_count::OneCount;
use crate::spec::Settings;

/// The tool's version, which every generated file names.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Everything between a specification and its files.
#[derive(Clone, Debug)]
pub struct Generated {
    /// The plant, exactly.
    pub plant: Plant,
    /// The observer, exactly.
    pub design: Design,
    /// What a step does.
    pub program: Program,
    /// What one count of a quantised output does.
    pub one_count: OneCount,
    /// What was said beside the specification.
    pub settings: Settings,
    /// Warnings; no errors.
    pub report: Report,
}
