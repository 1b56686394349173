//! `deadbeat::observer!`: a specification in, the observer's items in place.
//!
//! Used through the crate `deadbeat` with its feature `macros`.

use std::path::Path;
use std::str::FromStr as _;

use deadbeat_codegen::{File, Generator, Language, Output, Settings};
use proc_macro::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser as _};

/// Expands to the observer of a specification: `Measurements`, `Inputs`, `Estimate`, `Observer`.
///
/// The path is relative to the crate's `Cargo.toml`. What the file's `[target]` says can be
/// overridden behind it. What else a build script's `Build` can say has no place here: an expansion
/// writes no files, so it has neither folder nor other languages, and each observer wants a module of
/// its own, so each has a line of its own. Put it into such a module:
///
/// ```ignore
/// mod motor {
///     deadbeat::observer!("specs/motor.toml", scalar = "f64");
/// }
/// let mut observer = motor::Observer::new();
/// ```
#[proc_macro]
pub fn observer(input: TokenStream) -> TokenStream {
    let span = input.clone().into_iter().next().map_or_else(Span::call_site, |token| token.span());
    // Spans inside an expression exist only in the fallback.
    proc_macro2::fallback::force();
    let expanded = expand(&input.to_string());
    proc_macro2::fallback::unforce();
    let tokens = expanded.and_then(|text| TokenStream::from_str(&text).map_err(|error| error.to_string()));
    tokens.unwrap_or_else(|message| compile_error(&message, span))
}

/// The items as text, or the report to show.
fn expand(arguments: &str) -> Result<String, String> {
    let (path, settings) = read_arguments(arguments)?;
    let root = std::env::var("CARGO_MANIFEST_DIR").map_err(|_| "CARGO_MANIFEST_DIR is not set".to_owned())?;
    let file = Path::new(&root).join(&path);
    let text = std::fs::read_to_string(&file).map_err(|error| format!("cannot read {}: {error}", file.display()))?;
    let generator = Generator::new(&text, &path).with(settings);
    let generated = generator.design().map_err(|report| report.render(false))?;
    let output = Output::included(&generated, generator.source()).only(&[Language::Rust]);
    let items: String = output.files().iter().map(|File { text, .. }| text.as_str()).collect();
    // The compiler expands again when the specification changes.
    Ok(format!("const _: &str = include_str!({:?});\n{items}", file.display().to_string()))
}

/// `"path"`, then settings as TOML, one behind each comma.
fn read_arguments(arguments: &str) -> Result<(String, Settings), String> {
    let usage =
        || "write observer!(\"path/to/spec.toml\") or observer!(\"path/to/spec.toml\", scalar = \"f64\")".to_owned();
    let parts = |input: ParseStream| {
        let path: syn::LitStr = input.parse()?;
        let comma: Option<syn::Token![,]> = input.parse()?;
        let rest = if comma.is_some() { input.parse()? } else { proc_macro2::TokenStream::new() };
        Ok((path, rest))
    };
    let (path, rest) = parts.parse_str(arguments).map_err(|_| usage())?;
    let settings = rest.to_string().split(',').map(str::trim).collect::<Vec<_>>().join("\n");
    let settings = Settings::from_toml(&settings).map_err(|error| format!("{error}\n{}", usage()))?;
    Ok((path.value(), settings))
}

/// `compile_error! { "message" }` at the place of the path.
fn compile_error(message: &str, span: Span) -> TokenStream {
    let mut text = Literal::string(message);
    text.set_span(span);
    let mut bang = Punct::new('!', Spacing::Alone);
    bang.set_span(span);
    let mut group = Group::new(Delimiter::Brace, TokenTree::from(text).into());
    group.set_span(span);
    [TokenTree::from(Ident::new("compile_error", span)), bang.into(), group.into()].into_iter().collect()
}
