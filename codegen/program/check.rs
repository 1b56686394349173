//! Whether a Program is one: every invariant that the back ends rely on.
//!
//! In: any [`Program`]. Out: nothing, or the first broken rule and its place. What it checks, in
//! this order: names, texts and constants (`interface`); definitions, scopes and types
//! (`scope`, `typing`); the ends of rings and tables (`bounds`).

mod bounds;
mod flaw;
mod interface;
mod operands;
mod scope;
#[cfg(test)]
mod tests;
pub(super) mod typing;

pub use self::flaw::{CheckError, Flaw};

use super::{Program, Statement, listing};

/// Checks every invariant of a Program.
///
/// # Errors
/// The first broken rule.
pub fn check(program: &Program) -> Result<(), CheckError> {
    interface::check(program)?;
    scope::check(program)?;
    bounds::check(program)
}

/// Where a flaw is.
trait Place {
    /// For the reader of a [`CheckError`].
    fn describe(self, program: &Program) -> String;
}

impl Place for &str {
    fn describe(self, _: &Program) -> String {
        self.to_owned()
    }
}

impl Place for String {
    fn describe(self, _: &Program) -> String {
        self
    }
}

impl Place for &Statement {
    fn describe(self, program: &Program) -> String {
        let text = listing::statement(self, program);
        format!("`{}`", text.lines().next().unwrap_or_default())
    }
}

/// Gives a flaw its place.
trait At<T> {
    /// The flaw becomes the error.
    fn at(self, program: &Program, place: impl Place) -> Result<T, CheckError>;
}

impl<T> At<T> for Result<T, Flaw> {
    fn at(self, program: &Program, place: impl Place) -> Result<T, CheckError> {
        self.map_err(|flaw| CheckError { place: place.describe(program), flaw })
    }
}
