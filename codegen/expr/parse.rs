//! Text to syntax tree. `syn` reads the tokens; precedence is ours, since Rust's `^` binds weaker
//! than `+`. Depth and length are bounded, so that no text can exhaust the stack.

use std::ops::Range;

use dashu_ratio::RBig;
use proc_macro2::Span;
use syn::ext::IdentExt as _;
use syn::parse::{ParseStream, Parser};
use syn::{Ident, Lit, Token, token};

use crate::decimal;
use crate::diagnostic::{floor_boundary, letters};

/// Longest expression, in bytes; a plant with more should be given by matrices.
const MAX_LENGTH: usize = 4_096;
/// Deepest nesting of parentheses, signs and powers together.
const MAX_DEPTH: usize = 48;

/// Stands between a message and its help, since an error of `syn` carries one text.
const HELP: char = '\n';

/// A syntax tree with its place in the expression's text.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: Kind,
    /// Bytes of the expression's text.
    pub span: Range<usize>,
}

/// The forms of an expression. Sums and products are flat, so that long ones are not deep.
#[derive(Clone, Debug)]
pub enum Kind {
    /// A decimal, exactly.
    Number(RBig),
    /// A name not yet looked up, or `t`, or `pi`.
    Name(String),
    /// Terms; `true` marks a subtracted one.
    Sum(Vec<(bool, Expr)>),
    /// Factors; `true` marks a divisor.
    Product(Vec<(bool, Expr)>),
    /// `-a`.
    Negative(Box<Expr>),
    /// `a ^ b`.
    Power(Box<Expr>, Box<Expr>),
    /// `f(a, …)`; whether `f` exists is looked up later.
    Call(String, Vec<Expr>),
}

/// Why a text is not an expression, and where in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Bytes of the expression's text.
    pub span: Range<usize>,
    /// One line.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
}

/// Reads an expression.
pub fn parse(text: &str) -> Result<Expr, ParseError> {
    refuse_unreadable(text)?;
    let depth = std::cell::Cell::new(0);
    let parser = |input: ParseStream| {
        let expr = sum(input, &depth)?;
        if input.is_empty() { Ok(expr) } else { Err(unexpected(input)) }
    };
    parser.parse_str(text).map_err(|error| {
        let whole = error.to_string();
        let (message, help) =
            whole.split_once(HELP).map_or((whole.as_str(), None), |(message, help)| (message, Some(help)));
        let message = match message {
            "cannot parse string into token stream" | "lex error" => {
                "this is neither a number nor a name nor an operator"
            }
            message => message,
        };
        ParseError { span: clamp(error.span(), text), message: message.into(), help: help.map(str::to_owned) }
    })
}

/// What must be refused before the text reaches a tokenizer: emptiness, length, depth, foreign characters.
fn refuse_unreadable(text: &str) -> Result<(), ParseError> {
    let refuse = |span: Range<usize>, message: String, help: Option<&str>| {
        Err(ParseError { span, message, help: help.map(str::to_owned) })
    };
    if text.trim().is_empty() {
        return refuse(0..text.len(), "the expression is empty".into(), Some("write 0 where nothing is added"));
    }
    if text.len() > MAX_LENGTH {
        let message = format!("the expression has {} bytes; at most {MAX_LENGTH} are read", text.len());
        return refuse(0..text.len(), message, Some("split it over more states, or give a linear plant by matrices"));
    }
    let mut open = Vec::new();
    for (at, c) in text.char_indices() {
        let here = at..at + c.len_utf8();
        match c {
            '(' => open.push(here.clone()),
            ')' if open.pop().is_none() => {
                return refuse(here, "this parenthesis closes nothing".into(), Some("remove it, or open one before"));
            }
            '*' if text[at..].starts_with("**") => {
                return refuse(at..at + 2, "`**` is not an operator".into(), Some("write powers with `^`"));
            }
            '/' if text[at..].starts_with("//") || text[at..].starts_with("/*") => {
                return refuse(
                    at..at + 2,
                    "comments are not read inside an expression".into(),
                    Some("write it behind `#`, after the expression"),
                );
            }
            ')'
            | 'a'..='z'
            | 'A'..='Z'
            | '0'..='9'
            | '_'
            | '.'
            | '+'
            | '-'
            | '*'
            | '/'
            | '^'
            | ','
            | ' '
            | '\t'
            | '\n'
            | '\r' => {}
            _ => {
                let message = format!("`{}` means nothing in an expression", c.escape_debug());
                let help = instead_of(c, text);
                return refuse(here, message, Some(&help));
            }
        }
        if open.len() > MAX_DEPTH {
            return refuse(
                here,
                format!("parentheses nest deeper than {MAX_DEPTH}"),
                Some("name a part of it as a parameter or a state"),
            );
        }
    }
    match open.pop() {
        Some(here) => refuse(here, "this parenthesis is never closed".into(), Some("write `)` where it ends")),
        None => Ok(()),
    }
}

/// How to write what a sign that means nothing here was meant for.
fn instead_of(c: char, text: &str) -> String {
    let help = match c {
        '−' | '–' | '—' | '‐' | '‑' => "write a minus as `-`: this is another sign that looks like one",
        '°' => "angles are in radians: write `*pi/180`",
        '[' | ']' | '{' | '}' => "write parentheses: `( )`",
        '·' | '×' | '∙' | '⋅' => "write `*` for a product",
        '÷' | '∕' => "write `/` for a quotient",
        '²' | '³' => "write powers with `^`",
        '√' => "write `sqrt(…)`",
        '=' if !text.contains(['<', '>', '!', '?']) && !text.contains("==") => {
            "write the right-hand side alone: the name before the table says what it is of"
        }
        '|' if !text.contains("||") => "write a magnitude as `abs(…)`",
        '%' => "there is no remainder: write `a - b*floor(a/b)`",
        '<' | '>' | '=' | '?' | ':' | '&' | '|' | '!' | '≤' | '≥' => {
            "there are no conditions: write `min`, `max`, `clamp`, `abs` or `sign`, such as `(1 + sign(u))/2` for `u > 0`"
        }
        '\'' | '"' => "a derivative is a state: give it a name and an equation of its own",
        c => {
            let other = "names, numbers, + - * / ^ ( ) and commas are all there is";
            return letters::spelt(c)
                .map_or_else(|| other.into(), |name| format!("write `{name}`: names are ASCII letters"));
        }
    };
    help.to_owned()
}

type Depth<'a> = &'a std::cell::Cell<usize>;

fn sum(input: ParseStream, depth: Depth) -> syn::Result<Expr> {
    let first = product(input, depth)?;
    let mut terms = vec![(false, first)];
    while let Some(minus) = take_sign(input)? {
        terms.push((minus, product(input, depth)?));
    }
    Ok(flat(terms, Kind::Sum))
}

fn product(input: ParseStream, depth: Depth) -> syn::Result<Expr> {
    let first = signed(input, depth)?;
    let mut factors = vec![(false, first)];
    while input.peek(Token![*]) || input.peek(Token![/]) {
        let divided = input.peek(Token![/]);
        if divided {
            input.parse::<Token![/]>()?;
        } else {
            input.parse::<Token![*]>()?;
        }
        factors.push((divided, signed(input, depth)?));
    }
    Ok(flat(factors, Kind::Product))
}

/// `-a^2` is `-(a^2)`; the sign binds tighter than `*`.
fn signed(input: ParseStream, depth: Depth) -> syn::Result<Expr> {
    let start = input.span().byte_range().start;
    match take_sign(input)? {
        None => power(input, depth),
        Some(minus) => {
            let inner = deeper(input, depth, signed)?;
            if !minus {
                return Ok(inner);
            }
            let span = start..inner.span.end;
            Ok(Expr { kind: Kind::Negative(Box::new(inner)), span })
        }
    }
}

/// `a^b^c` is `a^(b^c)`.
fn power(input: ParseStream, depth: Depth) -> syn::Result<Expr> {
    let base = atom(input, depth)?;
    if !input.peek(Token![^]) {
        return Ok(base);
    }
    input.parse::<Token![^]>()?;
    let exponent = deeper(input, depth, signed)?;
    let span = base.span.start..exponent.span.end;
    Ok(Expr { kind: Kind::Power(Box::new(base), Box::new(exponent)), span })
}

fn atom(input: ParseStream, depth: Depth) -> syn::Result<Expr> {
    let span = input.span().byte_range();
    if input.peek(token::Paren) {
        let content;
        let paren = syn::parenthesized!(content in input);
        let inner = deeper(&content, depth, sum)?;
        if !content.is_empty() {
            return Err(unexpected(&content));
        }
        let span = span.start..paren.span.close().byte_range().end;
        return Ok(Expr { kind: inner.kind, span });
    }
    if input.peek(Lit) {
        return number(input);
    }
    if input.peek(Ident::peek_any) {
        return name_or_call(input, depth);
    }
    let message = match () {
        () if input.is_empty() => {
            "the expression ends where a number, a name or `(` should follow\ncomplete it, or remove the last operator"
        }
        () if input.peek(Token![.]) => "a number begins with a digit\nwrite 0.5 instead of .5",
        () => "a number, a name or `(` is missing here\nremove an operator, or write what it acts on",
    };
    Err(syn::Error::new(input.span(), message))
}

fn number(input: ParseStream) -> syn::Result<Expr> {
    let literal: Lit = input.parse()?;
    let at = literal.span();
    let (digits, suffix) = match &literal {
        Lit::Int(int) => (int.base10_digits().to_owned(), int.suffix().to_owned()),
        Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix().to_owned()),
        _ => {
            return Err(syn::Error::new(
                at,
                format!("only numbers can be written here{HELP}write 1 for true and 0 for false"),
            ));
        }
    };
    if !suffix.is_empty() {
        let message = format!(
            "an operator is missing before `{suffix}`{HELP}write `{digits}*{suffix}` for a product; a number carries no unit"
        );
        return Err(syn::Error::new(at, message));
    }
    let written = at.source_text().unwrap_or_default();
    if written.starts_with(['0']) && written[1..].starts_with(['x', 'o', 'b']) {
        return Err(syn::Error::new(at, format!("only decimal numbers are read{HELP}write it in decimal digits")));
    }
    let value = decimal::parse(&digits)
        .map_err(|why| syn::Error::new(at, format!("{why}{HELP}write a decimal number, such as 1.5e-3")))?;
    Ok(Expr { kind: Kind::Number(value), span: at.byte_range() })
}

fn name_or_call(input: ParseStream, depth: Depth) -> syn::Result<Expr> {
    let ident = Ident::parse_any(input)?;
    let start = ident.span().byte_range();
    let name = ident.to_string();
    if !input.peek(token::Paren) {
        return Ok(Expr { kind: Kind::Name(name), span: start });
    }
    let content;
    let paren = syn::parenthesized!(content in input);
    let mut arguments = Vec::new();
    while !content.is_empty() {
        arguments.push(deeper(&content, depth, sum)?);
        if content.is_empty() {
            break;
        }
        if !content.peek(Token![,]) {
            return Err(unexpected(&content));
        }
        content.parse::<Token![,]>()?;
    }
    let span = start.start..paren.span.close().byte_range().end;
    Ok(Expr { kind: Kind::Call(name, arguments), span })
}

/// Takes a `+` or `-` if one is there; `true` for `-`.
fn take_sign(input: ParseStream) -> syn::Result<Option<bool>> {
    if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        return Ok(Some(true));
    }
    if input.peek(Token![+]) {
        input.parse::<Token![+]>()?;
        return Ok(Some(false));
    }
    Ok(None)
}

/// One level down, refused beyond [`MAX_DEPTH`].
fn deeper(input: ParseStream, depth: Depth, read: fn(ParseStream, Depth) -> syn::Result<Expr>) -> syn::Result<Expr> {
    if depth.get() >= MAX_DEPTH {
        let message = format!(
            "signs, powers and parentheses nest deeper than {MAX_DEPTH}{HELP}name a part of it as a parameter or a state"
        );
        return Err(syn::Error::new(input.span(), message));
    }
    depth.set(depth.get() + 1);
    let result = read(input, depth);
    depth.set(depth.get() - 1);
    result
}

fn flat(mut parts: Vec<(bool, Expr)>, kind: fn(Vec<(bool, Expr)>) -> Kind) -> Expr {
    if parts.len() == 1 && !parts[0].0 {
        return parts.remove(0).1;
    }
    let span = parts[0].1.span.start..parts[parts.len() - 1].1.span.end;
    Expr { kind: kind(parts), span }
}

fn unexpected(input: ParseStream) -> syn::Error {
    let message = if input.peek(Token![,]) {
        "a comma separates the arguments of a function, and nothing else\nwrite decimals with a point: 1.5"
    } else {
        "an operator is missing here\nwrite `*` for a product"
    };
    syn::Error::new(input.span(), message)
}

/// The span as bytes of `text`; `syn` gives the end of input an empty one.
fn clamp(span: Span, text: &str) -> Range<usize> {
    let range = span.byte_range();
    if range.end == 0 || range.start >= text.len() {
        let last = text.trim_end().len();
        return floor_boundary(text, last.saturating_sub(1))..last;
    }
    range.start..range.end.min(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Powers bind tighter than signs, signs than products, products than sums.
    #[test]
    fn precedence_is_that_of_the_field() {
        let Kind::Sum(terms) = parse("-a*x^2 + b/c").unwrap().kind else { panic!("a sum") };
        let Kind::Product(factors) = &terms[0].1.kind else { panic!("a product") };
        assert!(matches!(factors[0].1.kind, Kind::Negative(_)));
        assert!(matches!(factors[1].1.kind, Kind::Power(..)));
    }

    /// Spans are those of the text.
    #[test]
    fn spans_point_at_the_characters() {
        let Kind::Sum(terms) = parse("aa + sin(b )*cc").unwrap().kind else { panic!("a sum") };
        assert_eq!(terms[1].1.span, 5..15);
    }

    /// No text exhausts the stack or slips through.
    #[test]
    fn unreadable_texts_are_refused() {
        let deep = format!("{}x{}", "(".repeat(2_000), ")".repeat(2_000));
        let signs = format!("{}x", "-".repeat(4_000));
        let powers = vec!["x"; 2_000].join("^");
        for text in [
            "", " ", "a +", "(a", "a)", "a b", "2x", "1..2", "'x'", "a; b", "é", "f(a,,b)", "a ** b", "1e99999", &deep,
            &signs, &powers,
        ] {
            assert!(parse(text).is_err(), "{text:.40}");
        }
        let long = vec!["x"; 2_000].join("+");
        assert!(parse(&long).is_ok());
    }
}
