//! The specification file: keys, names, places. Knows no mathematics.
//!
//! In: TOML text. Out: a [`Spec`], in which every key has been recognised and every name can be
//! carried by Rust and C, or all the mistakes at once. Expressions are still text.

pub mod reader;

use std::cell::RefCell;
use std::ops::Range;
use std::sync::Arc;

use dashu_ratio::RBig;
use serde::Deserialize;
use toml::de::{DeTable, DeValue};

use crate::diagnostic::{Diagnostic, Report, Source, codes};
use crate::emit::names;
use crate::expr::{Function, nearest};
use crate::method::{self, Keyed};
use crate::program::Scalar;
use reader::{Found, Table};

/// A string with its place in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// Without quotes.
    pub value: String,
    /// Of the value with its quotes, or of the key.
    pub span: Range<usize>,
    /// Where the characters start in the file, if they stand there unescaped.
    pub inner: Option<usize>,
}

impl Text {
    /// Maps bytes of the value to bytes of the file; the whole string when it is written with escapes.
    pub fn place(&self, within: Range<usize>) -> Range<usize> {
        self.inner.map_or_else(|| self.span.clone(), |start| start + within.start..start + within.end)
    }
}

/// A number, or a constant expression still to be read.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// Exactly.
    Number(RBig, Range<usize>),
    /// In a string.
    Expression(Text),
}

impl Quantity {
    /// Its place in the file.
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Number(_, span) => span.clone(),
            Self::Expression(text) => text.span.clone(),
        }
    }
}

/// A named number.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name, unit, documentation.
    pub named: Named,
    /// The number.
    pub value: Quantity,
}

/// A name with a unit and a line of documentation.
#[derive(Clone, Debug)]
pub struct Named {
    /// The name with its place.
    pub name: Text,
    /// SI unit, as written; may be empty.
    pub unit: String,
    /// One line; may be empty.
    pub doc: String,
}

/// A state.
#[derive(Clone, Debug)]
pub struct State {
    /// Name, unit, documentation.
    pub named: Named,
    /// `derivative` or `next`; absent in a plant by matrices.
    pub change: Option<Text>,
    /// The estimate before convergence, for states that are not measured.
    pub initial: Option<Quantity>,
}

/// What an input does between two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Keeps its value.
    Zero,
    /// Runs straight from one sample to the next.
    First,
}

/// A known input.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name, unit, documentation.
    pub named: Named,
    /// Between samples.
    pub hold: Hold,
}

/// A measured output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name, unit, documentation.
    pub named: Named,
    /// Linear in the states; absent in a plant by matrices.
    pub value: Option<Text>,
    /// Bound on the noise, in the output's unit.
    pub noise: Option<Quantity>,
    /// How late it arrives, s.
    pub delay: Option<Quantity>,
    /// Samples outside are treated as missing.
    pub range: Option<(Vec<Quantity>, Range<usize>)>,
}

/// A bounded unknown signal.
#[derive(Clone, Debug)]
pub struct Disturbance {
    /// Name, unit, documentation.
    pub named: Named,
    /// Bound on its magnitude.
    pub bound: Option<Quantity>,
}

/// Rows of numbers with their place.
pub type Rows = (Vec<Vec<Quantity>>, Range<usize>);

/// `[plant]`.
#[derive(Clone, Debug)]
pub struct Matrices {
    /// n x n.
    pub a: Option<Rows>,
    /// n x m.
    pub b: Option<Rows>,
    /// p x n.
    pub c: Option<Rows>,
    /// Whether they are already discrete.
    pub discrete: bool,
    /// Of the table.
    pub span: Range<usize>,
}

/// `[observer.<method>]`; its keys belong to the method.
#[derive(Clone, Debug)]
pub struct Observer {
    /// The method's name with its place.
    pub method: Text,
    /// The method with its keys read.
    pub keyed: Arc<dyn Keyed>,
}

/// What the command line, the macro's arguments and `[target]` can all say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// The float type, instead of the file's.
    #[serde(default, deserialize_with = "scalar_word")]
    pub scalar: Option<Scalar>,
}

impl Settings {
    /// Reads settings such as `scalar = "f64"`.
    pub fn from_toml(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|error| error.message().to_owned())
    }
}

fn scalar_word<'de, D: serde::Deserializer<'de>>(from: D) -> Result<Option<Scalar>, D::Error> {
    #[derive(Deserialize)]
    #[serde(rename_all = "lowercase")]
    enum Word {
        F32,
        F64,
    }
    Word::deserialize(from).map(|word| Some(if matches!(word, Word::F32) { Scalar::F32 } else { Scalar::F64 }))
}

/// A specification, as written.
#[derive(Clone, Debug)]
pub struct Spec {
    /// The text.
    pub source: Source,
    /// Prefixes everything that is generated.
    pub name: Text,
    /// One line for documentation.
    pub title: String,
    /// Where the model comes from.
    pub origin: String,
    /// In the order of the file.
    pub parameters: Vec<Parameter>,
    /// In the order of the file, which is the estimate's.
    pub states: Vec<State>,
    /// Whether the states have `next` instead of `derivative`.
    pub discrete: bool,
    /// In the order of the file.
    pub inputs: Vec<Input>,
    /// In the order of the file.
    pub outputs: Vec<Output>,
    /// Constants to estimate together with the state.
    pub unknowns: Vec<Named>,
    /// For the certificate only.
    pub disturbances: Vec<Disturbance>,
    /// A plant by matrices.
    pub matrices: Option<Matrices>,
    /// The method and its keys.
    pub observer: Observer,
    /// Seconds between two calls.
    pub sample_time: Quantity,
    /// The float type of the step.
    pub scalar: Scalar,
}

impl Spec {
    /// Reads a specification.
    pub fn parse(source: Source, settings: Settings) -> Result<Self, Report> {
        let found: Found = RefCell::new(Vec::new());
        let spec = read(&source, settings, &found);
        let found = found.into_inner();
        match spec {
            Some(spec) if found.is_empty() => Ok(spec),
            _ => Err(Report::new(source, found)),
        }
    }
}

fn read(source: &Source, settings: Settings, found: &Found) -> Option<Spec> {
    let (document, errors) = DeTable::parse_recoverable(&source.text);
    let mut in_order: Vec<_> = errors.iter().map(|error| (error.span().unwrap_or(0..0), error)).collect();
    in_order.sort_by_key(|(span, _)| span.start);
    for (span, error) in in_order {
        let message = error.message().replace('\n', ", ");
        let (help, ends) = syntax_help(&message);
        found.borrow_mut().push(Diagnostic::error(codes::SYNTAX, span, message).help(help));
        if ends {
            break;
        }
    }
    if !errors.is_empty() {
        return None;
    }
    let mut top = Table::new("the specification".into(), document.get_ref(), 0..0, &source.text, found);
    read_version(&mut top);
    let name = read_name(&mut top);
    let title = line(&mut top, "title");
    let origin = line(&mut top, "source");
    let parameters = read_parameters(&mut top);
    let matrices = read_matrices(&mut top);
    let (states, next) = read_states(&mut top, matrices.as_ref());
    let inputs = read_inputs(&mut top);
    let outputs = read_outputs(&mut top, matrices.is_some());
    let unknowns = read_unknowns(&mut top);
    let disturbances = read_disturbances(&mut top);
    let observer = read_observer(&mut top);
    let target = read_target(&mut top);
    top.finish();
    let (sample_time, scalar) = target?;
    let spec = Spec {
        source: source.clone(),
        name: name?,
        title,
        origin,
        parameters,
        states,
        discrete: next || matrices.as_ref().is_some_and(|m| m.discrete),
        inputs,
        outputs,
        unknowns,
        disturbances,
        matrices,
        observer: observer?,
        sample_time,
        scalar: settings.scalar.unwrap_or(scalar),
    };
    check_names(&spec, found);
    Some(spec)
}

/// What to do about a message of the TOML reader; and whether what it says of the rest of the file
/// follows from this one mistake.
fn syntax_help(message: &str) -> (&'static str, bool) {
    let has = |words: &[&str]| words.iter().any(|word| message.contains(word));
    if has(&["duplicate key"]) {
        ("remove or rename one of them", false)
    } else if has(&["must be quoted"]) {
        ("write numbers without a unit, and text in quotes", false)
    } else if has(&["literal string", "basic string"]) {
        ("begin and end it with the same quote on one line", true)
    } else {
        ("check the quotes, brackets and commas here and on the line before", true)
    }
}

fn read_version(top: &mut Table) {
    match top.whole("deadbeat") {
        Some((version, _)) if version == RBig::ONE => {}
        Some((version, span)) => {
            let message = format!("format version {version} is not known");
            top.report(Diagnostic::error(codes::BAD_CHOICE, span, message).help("this tool reads `deadbeat = 1`"));
        }
        None if top.has("deadbeat") => {}
        None => top.missing("deadbeat", "write `deadbeat = 1`, the format's version, in the first line"),
    }
}

fn read_name(top: &mut Table) -> Option<Text> {
    let name = top.text("name");
    match &name {
        Some(name) => check_name(top, name, "name"),
        None if top.has("name") => {}
        None => top.missing("name", "write `name = \"my_observer\"`: it prefixes every generated symbol and file"),
    }
    name
}

/// An optional line of text; line breaks would leave the comment that it is printed in.
fn line(table: &mut Table, key: &str) -> String {
    table.text(key).map(|text| printable(&text.value)).unwrap_or_default()
}

/// Text that can stand in a comment of either language.
fn printable(text: &str) -> String {
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    plain.replace("*/", "* /").replace("/*", "/ *").trim().trim_end_matches('\\').to_owned()
}

fn read_named(name: Text, table: &mut Table) -> Named {
    Named { unit: line(table, "unit"), doc: line(table, "doc"), name }
}

fn read_parameters(top: &mut Table) -> Vec<Parameter> {
    let Some(mut table) = top.table("parameters", "[parameters]") else { return Vec::new() };
    let mut parameters = Vec::new();
    for (name, value) in table.entries() {
        check_identifier(&table, &name);
        let parameter = if matches!(value.get_ref(), DeValue::Table(_)) {
            let Some(mut entry) = table.entry_table(&name, value) else { continue };
            let number = entry.quantity("value");
            if number.is_none() && !entry.has("value") {
                entry.missing("value", "write `value = …`");
            }
            let named = read_named(name, &mut entry);
            entry.finish();
            number.map(|value| Parameter { named, value })
        } else {
            let named = Named { unit: String::new(), doc: String::new(), name: name.clone() };
            table.entry_quantity(&name, value).map(|value| Parameter { named, value })
        };
        parameters.extend(parameter);
    }
    parameters
}

fn read_matrices(top: &mut Table) -> Option<Matrices> {
    let mut table = top.table("plant", "[plant]")?;
    let discrete = table.choice("time", &[("continuous", false), ("discrete", true)], false);
    let matrices =
        Matrices { a: table.matrix("A"), b: table.matrix("B"), c: table.matrix("C"), discrete, span: table.span() };
    for key in ["A", "C"] {
        if !table.has(key) {
            table.missing(key, "write it as a list of rows, such as `[[0, 1], [0, 0]]`");
        }
    }
    table.finish();
    Some(matrices)
}

/// The states, and whether they are given by `next`.
fn read_states(top: &mut Table, matrices: Option<&Matrices>) -> (Vec<State>, bool) {
    let Some(mut table) = top.table("states", "[states]") else {
        if matrices.is_none() && !top.has("states") {
            top.missing("states", "write `[states]` with one line per state, or `[plant]` with A, B and C");
        }
        return (Vec::new(), false);
    };
    let mut states = Vec::new();
    let mut kinds: [Option<Range<usize>>; 2] = [None, None];
    for (name, value) in table.entries() {
        check_name(&table, &name, "state");
        let Some(mut entry) = table.entry_table(&name, value) else { continue };
        let change = read_change(&mut entry, matrices, &mut kinds);
        let initial = entry.quantity("initial");
        let named = read_named(name, &mut entry);
        entry.finish();
        states.push(State { named, change, initial });
    }
    if states.is_empty() && matrices.is_none() {
        let error = Diagnostic::error(codes::MISSING_KEY, table.span(), "[states] is empty");
        table.report(error.help("write one line per state: `q = { unit = \"rad\", derivative = '…' }`"));
    }
    if let [Some(derivative), Some(next)] = &kinds {
        let message = "some states have `derivative` and some `next`";
        let mixed = Diagnostic::error(codes::BAD_COMBINATION, next.clone(), message)
            .context(derivative.clone(), "continuous time here")
            .help("a plant is continuous or discrete as a whole");
        table.report(mixed);
    }
    (states, kinds[1].is_some())
}

/// `derivative` or `next`, exactly one of them; neither in a plant by matrices.
fn read_change(entry: &mut Table, matrices: Option<&Matrices>, kinds: &mut [Option<Range<usize>>; 2]) -> Option<Text> {
    let (derivative, next) = (entry.text("derivative"), entry.text("next"));
    for (kind, text) in kinds.iter_mut().zip([&derivative, &next]) {
        if let Some(text) = text
            // Both at once is a mistake of its own.
            && !(derivative.is_some() && next.is_some())
        {
            kind.get_or_insert_with(|| text.span.clone());
        }
    }
    let present = derivative.as_ref().or(next.as_ref());
    match (present, matrices) {
        (Some(text), Some(_)) => {
            let message = "a plant by matrices has no equations";
            entry.report(
                Diagnostic::error(codes::BAD_COMBINATION, text.span.clone(), message)
                    .help("leave out this key, or `[plant]`"),
            );
        }
        (None, None) if !entry.has("derivative") && !entry.has("next") => {
            entry.missing("derivative", "write `derivative = '…'` (continuous time) or `next = '…'` (discrete time)");
        }
        _ => {}
    }
    if let (Some(derivative), Some(next)) = (&derivative, &next) {
        let message = format!("{} has both `derivative` and `next`", entry.what());
        entry.report(
            Diagnostic::error(codes::BAD_COMBINATION, next.span.clone(), message)
                .context(derivative.span.clone(), "the other")
                .help("a plant is continuous or discrete"),
        );
    }
    derivative.or(next)
}

fn read_inputs(top: &mut Table) -> Vec<Input> {
    read_entries(top, "inputs", "[inputs]", "input", |named, entry| {
        let hold = entry.choice("hold", &[("zero", Hold::Zero), ("first", Hold::First)], Hold::Zero);
        Input { named, hold }
    })
}

fn read_outputs(top: &mut Table, by_matrices: bool) -> Vec<Output> {
    if !by_matrices && !top.has("outputs") {
        top.missing("outputs", "write `[outputs]` with one line per measured output: `y = { value = 'q' }`");
    }
    let outputs = read_entries(top, "outputs", "[outputs]", "output", |named, entry| {
        let value = entry.text("value");
        match (&value, by_matrices) {
            (Some(text), true) => entry.report(
                Diagnostic::error(
                    codes::BAD_COMBINATION,
                    text.span.clone(),
                    "a plant by matrices has its outputs in `C`",
                )
                .help("leave out this key, or `[plant]`"),
            ),
            (None, false) if !entry.has("value") => {
                entry.missing("value", "write `value = '…'`, linear in the states");
            }
            _ => {}
        }
        let range = entry.list("range");
        let output = Output { named, value, noise: entry.quantity("noise"), delay: entry.quantity("delay"), range };
        if let Some((limits, span)) = &output.range
            && limits.len() != 2
        {
            let message = format!("`range` needs two numbers, {} given", limits.len());
            entry.report(
                Diagnostic::error(codes::WRONG_TYPE, span.clone(), message).help("write `range = [lowest, highest]`"),
            );
        }
        output
    });
    if outputs.is_empty() && top.has("outputs") && !by_matrices {
        top.report(
            Diagnostic::error(codes::MISSING_KEY, top.key_span("outputs"), "no output is measured")
                .help("write one line per measured output: `y = { value = 'q' }`"),
        );
    }
    outputs
}

fn read_unknowns(top: &mut Table) -> Vec<Named> {
    read_entries(top, "unknowns", "[unknowns]", "unknown", |named, _| named)
}

fn read_disturbances(top: &mut Table) -> Vec<Disturbance> {
    read_entries(top, "disturbances", "[disturbances]", "disturbance", |named, entry| {
        let bound = entry.quantity("bound");
        if bound.is_none() && !entry.has("bound") {
            entry.missing("bound", "write `bound = …`, the largest magnitude");
        }
        Disturbance { named, bound }
    })
}

/// The entries of a table of tables, in the order of the file.
fn read_entries<T>(
    top: &mut Table,
    key: &str,
    what: &str,
    role: &str,
    mut read: impl FnMut(Named, &mut Table) -> T,
) -> Vec<T> {
    let Some(mut table) = top.table(key, what) else { return Vec::new() };
    let mut entries = Vec::new();
    for (name, value) in table.entries() {
        check_name(&table, &name, role);
        let Some(mut entry) = table.entry_table(&name, value) else { continue };
        let named = read_named(name, &mut entry);
        entries.push(read(named, &mut entry));
        entry.finish();
    }
    entries
}

fn read_observer(top: &mut Table) -> Option<Observer> {
    if !top.has("observer") {
        top.missing("observer", "write `[observer.window]` with `window = …` s, or another method (`deadbeat list`)");
    }
    let mut table = top.table("observer", "[observer]")?;
    let entries = table.entries();
    let known = || method::METHODS.iter().map(|m| m.name);
    match entries.as_slice() {
        [] => {
            let error = Diagnostic::error(codes::MISSING_KEY, table.span(), "[observer] names no method");
            table.report(
                error.help("write `[observer.window]` with `window = …` s, or another method (`deadbeat list`)"),
            );
            None
        }
        [(name, value)] => {
            let Some(method) = method::METHODS.iter().find(|m| m.name == name.value) else {
                let message = format!("there is no observer method `{}`", name.value.escape_debug());
                let diagnostic = Diagnostic::error(codes::UNKNOWN_METHOD, name.span.clone(), message);
                table.report(match nearest(&name.value, known()) {
                    Some(close) => diagnostic.help(format!("did you mean `{close}`?")).patch(name.span.clone(), close),
                    None => diagnostic.help(format!("the methods are: {}", known().collect::<Vec<_>>().join(", "))),
                });
                return None;
            };
            let mut keys = table.entry_table(name, value)?.named(format!("[observer.{}]", method.name));
            let keyed = (method.read)(&mut keys);
            keys.finish();
            Some(Observer { method: name.clone(), keyed: keyed? })
        }
        [first, second, ..] => {
            let message = "a specification has one observer";
            table.report(
                Diagnostic::error(codes::BAD_COMBINATION, second.0.span.clone(), message)
                    .context(first.0.span.clone(), "the other")
                    .help("put the second into a file of its own"),
            );
            None
        }
    }
}

fn read_target(top: &mut Table) -> Option<(Quantity, Scalar)> {
    if !top.has("target") {
        top.missing("target", "write `[target]` with `sample_time = …` s");
    }
    let mut table = top.table("target", "[target]")?;
    let sample_time = table.quantity("sample_time");
    if sample_time.is_none() && !table.has("sample_time") {
        table.missing("sample_time", "write `sample_time = …`, the seconds between two calls");
    }
    let scalar = table.choice("scalar", &[("f32", Scalar::F32), ("f64", Scalar::F64)], Scalar::F32);
    table.finish();
    Some((sample_time?, scalar))
}

/// A name that only expressions use.
fn check_identifier(table: &Table, name: &Text) {
    let mut characters = name.value.chars();
    let starts = characters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    if !starts || !characters.all(|c| c.is_ascii_alphanumeric() || c == '_') {
        let message = format!("`{}` is not a name", name.value.escape_debug());
        let help = "letters without accents, digits and underscores, a letter first";
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help(help));
    } else if Function::by_name(&name.value).is_some() || ["t", "pi"].contains(&name.value.as_str()) {
        let message = format!("`{}` already means something in every expression", name.value);
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help("choose another name"));
    }
}

/// A name that the generated code carries.
fn check_name(table: &Table, name: &Text, role: &str) {
    const LONGEST: usize = 40;
    let value = &name.value;
    let snake = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let report = |message: String, help: String| {
        table.report(Diagnostic::error(codes::BAD_NAME, name.span.clone(), message).help(help));
    };
    if !value.starts_with(|c: char| c.is_ascii_lowercase())
        || !value.chars().all(snake)
        || value.contains("__")
        || value.ends_with('_')
    {
        let message = format!("the {role} `{}` is not in snake_case", value.escape_debug());
        report(message, format!("generated fields carry it: write `{}`", names::snake_case(value)));
    } else if value.len() > LONGEST {
        report(
            format!("the {role} `{value}` has {} letters", value.len()),
            format!("write at most {LONGEST}: C compilers may cut long symbols"),
        );
    } else if let Some(why) = if role == "name" { names::reserved_for_a_file(value) } else { names::reserved(value) } {
        report(format!("the {role} `{value}` is {why}"), "choose another name".into());
    } else if role != "name" && role != "output" {
        check_identifier(table, name);
    }
}

/// Names that expressions share must differ; so must those of one generated struct.
fn check_names(spec: &Spec, found: &Found) {
    let parameters = spec.parameters.iter().map(|p| &p.named.name);
    let states = spec.states.iter().map(|s| &s.named.name);
    let inputs = spec.inputs.iter().map(|i| &i.named.name);
    let unknowns = spec.unknowns.iter().map(|u| &u.name);
    let disturbances = spec.disturbances.iter().map(|d| &d.named.name);
    let mut seen: Vec<&Text> = Vec::new();
    for name in parameters.chain(states).chain(inputs).chain(unknowns).chain(disturbances) {
        if let Some(first) = seen.iter().find(|other| other.value == name.value) {
            let message = format!("`{}` names two things", name.value);
            let twice = Diagnostic::error(codes::DUPLICATE_NAME, name.span.clone(), message)
                .context(first.span.clone(), "the other")
                .help("rename one of them");
            found.borrow_mut().push(twice);
        }
        seen.push(name);
    }
}
