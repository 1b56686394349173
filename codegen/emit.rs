//! The emitters: a Program in, the text of one language out.
//!
//! Knows a finished Program, the header that it is given, one language each. Never knows a plant, a design or a method.
//!
//! An emitter spells and lays out; an emitter that computes is a bug. Every operation of the
//! Program becomes one statement, in the Program's order, with the same temporaries `t0`, `t1`, …
//! in both languages, so that the two files can be compared line for line. Constants have no
//! statement of their own: they stand where they are used.
//!
//! Invariant: nothing but the Program and the header reaches the output, so the same two give the
//! same bytes everywhere.

mod c;
mod plan;
mod rust;
mod split;
#[cfg(test)]
mod tests;
mod text;

use proc_macro2::TokenStream;

use crate::program::Program;
use plan::Plan;

/// What the top of every generated file says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    /// One line: "Finite-time observer of …".
    pub title: String,
    /// Plain text, complete: provenance, plant, method, certificate, cost, contract.
    pub lines: Vec<String>,
}

/// How the Rust file gets into the user's crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// As a module file: the header is the module's documentation.
    File,
    /// By `include!`, where inner documentation is not allowed: the header is a comment.
    Include,
}

/// The contents of `<name>.rs`.
#[must_use]
pub fn rust(program: &Program, header: &Header, door: Door) -> String {
    rust::file(&Plan::new(program), header, door)
}

/// The same items as tokens, for a macro.
#[must_use]
pub fn rust_tokens(program: &Program) -> TokenStream {
    rust::tokens(&Plan::new(program))
}

/// The contents of `<name>.h`.
#[must_use]
pub fn c_header(program: &Program, header: &Header) -> String {
    c::header(&Plan::new(program), header)
}

/// The contents of `<name>.c`.
#[must_use]
pub fn c_source(program: &Program, header: &Header) -> String {
    c::source(&Plan::new(program), header)
}
