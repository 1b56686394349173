//! Rust: the file, or its items as tokens.

mod constant;
mod function;
mod index;
mod item;
mod layout;
mod operation;
mod statement;
mod table;

use proc_macro2::{Ident, Span, TokenStream};

use super::plan::Plan;
use super::text::{markdown, plain};
use super::{Door, Header};

/// The Program in Rust tokens.
struct Rust<'p> {
    plan: &'p Plan<'p>,
    /// Whether the tokens are for [`layout`], which makes comments of statement documentation and
    /// spells the tables itself.
    laid_out: bool,
}

/// The contents of the file.
pub fn file(plan: &Plan, header: &Header, door: Door) -> String {
    let top = match door {
        Door::File => documentation(header),
        Door::Include => comment(header),
    };
    let items = Rust { plan, laid_out: true }.items();
    format!("{top}\n{}", layout::text(items, plan))
}

/// The items alone.
pub fn tokens(plan: &Plan) -> TokenStream {
    Rust { plan, laid_out: false }.items()
}

/// The header as the documentation of the module. The lines are preformatted: their columns stay,
/// and nothing in them is markup.
fn documentation(header: &Header) -> String {
    let mut top = format!("//! {}\n//!\n//! ```text\n", markdown(&header.title));
    for line in &header.lines {
        top.push_str(format!("//! {}", plain(line).replace("```", "'''")).trim_end());
        top.push('\n');
    }
    top + "//! ```\n"
}

/// The header as a comment.
fn comment(header: &Header) -> String {
    let title = [header.title.clone(), String::new()];
    let lines = title.iter().chain(&header.lines).map(|line| format!("// {}", plain(line)));
    lines.map(|line| line.trim_end().to_owned() + "\n").collect()
}

/// An identifier.
fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}
