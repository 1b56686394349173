//! Reads TOML tables key by key, so that every mistake of a file is found, not just the first.
//!
//! A [`Table`] hands out values with their places, remembers which keys were asked for, and
//! reports the rest as unknown when it is finished.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::ops::Range;

use dashu_ratio::RBig;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Quantity, Text};
use crate::decimal;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::nearest;

/// Where mistakes are collected.
pub type Found = RefCell<Vec<Diagnostic>>;

/// A table being read.
pub struct Table<'a> {
    /// For messages: `[target]`, or `[outputs] y`.
    what: String,
    entries: &'a DeTable<'a>,
    span: Range<usize>,
    text: &'a str,
    asked: BTreeSet<String>,
    found: &'a Found,
}

impl<'a> Table<'a> {
    /// Starts reading.
    pub fn new(what: String, entries: &'a DeTable<'a>, span: Range<usize>, text: &'a str, found: &'a Found) -> Self {
        Self { what, entries, span, text, asked: BTreeSet::new(), found }
    }

    /// The same table under another name in messages.
    #[must_use]
    pub fn named(self, what: String) -> Self {
        Self { what, ..self }
    }

    /// The place of the whole table.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// The table's name in messages.
    pub fn what(&self) -> &str {
        &self.what
    }

    /// Whether a key is there, without reading it.
    pub fn has(&self, key: &str) -> bool {
        self.entries.get(key).is_some()
    }

    /// The place of a key, or of the table.
    pub fn key_span(&self, key: &str) -> Range<usize> {
        self.entries.get_key_value(key).map_or_else(|| self.span(), |(key, _)| key.span())
    }

    /// Pushes a mistake.
    pub fn report(&self, diagnostic: Diagnostic) {
        self.found.borrow_mut().push(diagnostic);
    }

    fn ask(&mut self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.asked.insert(key.to_owned());
        self.entries.get(key)
    }

    fn wrong_type(&self, value: &Spanned<DeValue<'a>>, key: &str, wanted: &str) {
        let message = format!("`{key}` in {} must be {wanted}", self.what);
        let found = format!("this is {}", kind_of(value.get_ref()));
        let error = Diagnostic::error(codes::WRONG_TYPE, value.span(), message).label(found);
        let is_number = matches!(value.get_ref(), DeValue::Integer(_) | DeValue::Float(_));
        self.report(match wanted {
            "a string" if is_number => error.help("write it in quotes"),
            "a table" => error.help(format!("write `{key} = {{ … }}` with its keys inside")),
            _ => error,
        });
    }

    /// Says that a key must be there.
    pub fn missing(&self, key: &str, help: &str) {
        let message = format!("{} needs `{key}`", self.what);
        self.report(Diagnostic::error(codes::MISSING_KEY, self.span(), message).help(help));
    }

    /// A string, if the key is there.
    pub fn text(&mut self, key: &str) -> Option<Text> {
        let value = self.ask(key)?;
        let text = self.as_text(value);
        if text.is_none() {
            self.wrong_type(value, key, "a string");
        }
        text
    }

    fn as_text(&self, value: &Spanned<DeValue<'a>>) -> Option<Text> {
        let DeValue::String(string) = value.get_ref() else { return None };
        let span = value.span();
        Some(Text { inner: inner_span(self.text, &span, string), value: string.to_string(), span })
    }

    /// Whether a key is there and its value is a string, without reading it.
    pub fn has_text(&self, key: &str) -> bool {
        self.entries.get(key).is_some_and(|value| matches!(value.get_ref(), DeValue::String(_)))
    }

    /// Whether a key is there and its value is this word, without reading it.
    pub fn has_word(&self, key: &str, word: &str) -> bool {
        self.entries.get(key).is_some_and(|value| matches!(value.get_ref(), DeValue::String(text) if text == word))
    }

    /// One word of a few; the default when the key is absent.
    pub fn choice<T: Copy>(&mut self, key: &str, choices: &[(&str, T)], default: T) -> T {
        let Some(text) = self.text(key) else { return default };
        if let Some((_, choice)) = choices.iter().find(|(word, _)| *word == text.value) {
            return *choice;
        }
        let words: Vec<String> = choices.iter().map(|(word, _)| format!("\"{word}\"")).collect();
        let message = format!("`{key}` cannot be \"{}\"", text.value.escape_debug());
        let mut diagnostic = Diagnostic::error(codes::BAD_CHOICE, text.span.clone(), message)
            .help(format!("write {}", words.join(" or ")));
        if let Some(close) = nearest(&text.value, choices.iter().map(|(word, _)| *word)) {
            diagnostic = diagnostic.patch(text.span, format!("\"{close}\""));
        }
        self.report(diagnostic);
        default
    }

    /// A number or a constant expression, if the key is there.
    pub fn quantity(&mut self, key: &str) -> Option<Quantity> {
        let value = self.ask(key)?;
        self.as_quantity(value, key)
    }

    fn as_quantity(&self, value: &Spanned<DeValue<'a>>, key: &str) -> Option<Quantity> {
        if let Some(text) = self.as_text(value) {
            return Some(Quantity::Expression(text));
        }
        let Some(digits) = digits_of(value.get_ref()) else {
            self.wrong_type(value, key, "a number, or a constant expression in a string");
            return None;
        };
        match digits.and_then(|d| decimal::parse(&d)) {
            Ok(number) => Some(Quantity::Number(number, value.span())),
            Err(why) => {
                let error = Diagnostic::error(codes::BAD_NUMBER, value.span(), why);
                self.report(error.help("write a decimal number, such as 1.5e-3, below 1.8e308"));
                None
            }
        }
    }

    /// A whole number as it must be, if the key is there.
    pub fn whole(&mut self, key: &str) -> Option<(RBig, Range<usize>)> {
        match self.quantity(key)? {
            Quantity::Number(number, span) if number.is_int() => Some((number, span)),
            other => {
                let message = format!("`{key}` in {} must be a whole number", self.what);
                self.report(Diagnostic::error(codes::WRONG_TYPE, other.span(), message).label("this is not"));
                None
            }
        }
    }

    /// A list of numbers, if the key is there.
    pub fn list(&mut self, key: &str) -> Option<(Vec<Quantity>, Range<usize>)> {
        let value = self.ask(key)?;
        let row = self.as_list(value, key)?;
        Some((row, value.span()))
    }

    fn as_list(&self, value: &Spanned<DeValue<'a>>, key: &str) -> Option<Vec<Quantity>> {
        let DeValue::Array(items) = value.get_ref() else {
            self.wrong_type(value, key, "a list of numbers");
            return None;
        };
        let numbers: Vec<Option<Quantity>> = items.iter().map(|item| self.as_quantity(item, key)).collect();
        numbers.into_iter().collect()
    }

    /// Whether a key is there and its value is a list, without reading it.
    pub fn has_list(&self, key: &str) -> bool {
        matches!(self.entries.get(key).map(Spanned::get_ref), Some(DeValue::Array(_)))
    }

    /// Whether a key is there and the first entry of its value is a list, without reading it.
    pub fn has_rows(&self, key: &str) -> bool {
        let value = self.entries.get(key).map(Spanned::get_ref);
        matches!(value, Some(DeValue::Array(items)) if matches!(items.first().map(Spanned::get_ref), Some(DeValue::Array(_))))
    }

    /// A truth value, if the key is there.
    pub fn flag(&mut self, key: &str) -> Option<bool> {
        let value = self.ask(key)?;
        let DeValue::Boolean(flag) = value.get_ref() else {
            self.wrong_type(value, key, "`true` or `false`");
            return None;
        };
        Some(*flag)
    }

    /// A list of numbers and of pairs of them, each with its place, if the key is there: numbers in the plane.
    pub fn complex_list(&mut self, key: &str) -> Option<Vec<(Vec<Quantity>, Range<usize>)>> {
        let value = self.ask(key)?;
        let DeValue::Array(items) = value.get_ref() else {
            self.wrong_type(value, key, "a list of numbers, or of pairs `[re, im]`");
            return None;
        };
        let one = |item: &Spanned<DeValue<'a>>| {
            let parts = match item.get_ref() {
                DeValue::Array(parts) if parts.len() == 2 => self.as_list(item, key)?,
                DeValue::Array(_) => {
                    self.wrong_type(item, key, "a list of numbers, or of pairs `[re, im]`");
                    return None;
                }
                _ => vec![self.as_quantity(item, key)?],
            };
            Some((parts, item.span()))
        };
        let numbers: Vec<Option<_>> = items.iter().map(one).collect();
        numbers.into_iter().collect()
    }

    /// A matrix as nested lists, if the key is there; rows may still differ in length.
    pub fn matrix(&mut self, key: &str) -> Option<(Vec<Vec<Quantity>>, Range<usize>)> {
        let value = self.ask(key)?;
        let DeValue::Array(rows) = value.get_ref() else {
            self.wrong_type(value, key, "a matrix: a list of rows");
            return None;
        };
        if let Some(row) = rows.iter().find(|row| !matches!(row.get_ref(), DeValue::Array(_))) {
            let message = format!("each row of `{key}` in {} must be a list of numbers", self.what);
            let error = Diagnostic::error(codes::WRONG_TYPE, row.span(), message);
            let error = error.label(format!("this is {}", kind_of(row.get_ref())));
            self.report(error.help("give each row its own brackets, also a single one: `[[1, 0]]`"));
            return None;
        }
        let rows: Vec<Option<Vec<Quantity>>> = rows.iter().map(|row| self.as_list(row, key)).collect();
        Some((rows.into_iter().collect::<Option<_>>()?, value.span()))
    }

    /// A table, if the key is there.
    pub fn table(&mut self, key: &str, what: impl Into<String>) -> Option<Table<'a>> {
        let value = self.ask(key)?;
        let DeValue::Table(table) = value.get_ref() else {
            self.wrong_type(value, key, "a table");
            return None;
        };
        Some(Table::new(what.into(), table, value.span(), self.text, self.found))
    }

    /// The entries in the order of the file.
    pub fn entries(&mut self) -> Vec<(Text, &'a Spanned<DeValue<'a>>)> {
        let mut entries: Vec<_> = self
            .entries
            .iter()
            .map(|(key, value)| {
                let name = Text { value: key.get_ref().to_string(), span: key.span(), inner: None };
                (name, value)
            })
            .collect();
        entries.sort_by_key(|(name, _)| name.span.start);
        self.asked.extend(entries.iter().map(|(name, _)| name.value.clone()));
        entries
    }

    /// An entry that is a table of its own.
    pub fn entry_table(&self, name: &Text, value: &'a Spanned<DeValue<'a>>) -> Option<Table<'a>> {
        let what = format!("`{}` in {}", name.value, self.what);
        match value.get_ref() {
            DeValue::Table(table) => Some(Table::new(what, table, value.span(), self.text, self.found)),
            other => {
                let message = format!("{what} must be a table");
                let label = format!("this is {}", kind_of(other));
                let help = format!("write `{} = {{ … }}`", name.value);
                self.report(Diagnostic::error(codes::WRONG_TYPE, value.span(), message).label(label).help(help));
                None
            }
        }
    }

    /// An entry that is a bare number or constant expression.
    pub fn entry_quantity(&self, name: &Text, value: &Spanned<DeValue<'a>>) -> Option<Quantity> {
        self.as_quantity(value, &name.value)
    }

    /// Reports every key that nobody asked for; false where one of them is a table, so that parts of the file are unread.
    pub fn finish(self) -> bool {
        let mut whole = true;
        for (key, value) in self.entries {
            if self.asked.contains(key.get_ref().as_ref()) {
                continue;
            }
            whole &= !matches!(value.get_ref(), DeValue::Table(_));
            let message = format!("{} has no key `{}`", self.what, key.get_ref().escape_debug());
            let diagnostic = Diagnostic::error(codes::UNKNOWN_KEY, key.span(), message);
            let diagnostic = match self.meant(key.get_ref()) {
                Some(close) => diagnostic.help(format!("did you mean `{close}`?")).patch(key.span(), close),
                None => {
                    let keys: Vec<&str> = self.asked.iter().map(String::as_str).collect();
                    diagnostic.help(format!("the keys are {}", keys.join(", ")))
                }
            };
            self.report(diagnostic);
        }
        whole
    }

    /// The key that was meant: what other tools call it, or one that is nearly the same.
    fn meant(&self, key: &str) -> Option<&str> {
        let lower = key.to_ascii_lowercase();
        let called = OTHER_WORDS.iter().filter(|(words, _)| words.split(' ').any(|word| word == lower));
        let asked = |name: &str| self.asked.iter().map(String::as_str).find(|known| *known == name);
        let other = called.filter_map(|(_, name)| asked(name)).find(|name| !self.has(name));
        other.or_else(|| nearest(key, self.asked.iter().map(String::as_str)))
    }
}

/// What other tools call a key.
const OTHER_WORDS: [(&str, &str); 9] = [
    ("dot der ddt deriv rhs equation xdot ode", "derivative"),
    ("update successor step", "next"),
    ("expr expression formula equation", "value"),
    ("ts dt h period sampling_time sample_period samplingtime step", "sample_time"),
    ("units", "unit"),
    ("x0 init start", "initial"),
    ("length horizon", "window"),
    ("latency lag", "delay"),
    ("description comment", "doc"),
];

/// The digits of a number, an error text for one that is not decimal, `None` for what is no number.
fn digits_of(value: &DeValue<'_>) -> Option<Result<String, String>> {
    match value {
        DeValue::Integer(integer) if integer.radix() == 10 => Some(Ok(integer.as_str().to_owned())),
        DeValue::Integer(_) => Some(Err("only decimal numbers are read".into())),
        DeValue::Float(float) if float.as_str().contains(['i', 'n']) => {
            Some(Err(format!("`{}` is not a number to compute with", float.as_str())))
        }
        DeValue::Float(float) => Some(Ok(float.as_str().to_owned())),
        _ => None,
    }
}

fn kind_of(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a truth value",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

/// Where the characters of a string start in the file, when they stand there unescaped.
fn inner_span(text: &str, span: &Range<usize>, value: &str) -> Option<usize> {
    let raw = text.get(span.clone())?;
    let at = raw.find(value).filter(|_| !value.is_empty())?;
    Some(span.start + at)
}
