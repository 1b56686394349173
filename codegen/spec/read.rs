//! Reads a specification table by table; every mistake is pushed, none stops the reading.

use std::ops::Range;

use dashu_ratio::RBig;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::chain::{self, Form};
use super::identifiers::{check_identifier, check_name, check_names};
use super::reader::{Found, Table};
use super::sensor::Sensor;
use super::{
    Chain, Disturbance, Hold, Input, Matrices, Named, Observer, Output, Parameter, Quantity, ReadKeys, Settings, Spec,
    State, Target, Text, syntax,
};
use crate::diagnostic::{Diagnostic, Source, codes};
use crate::program::Scalar;

/// Reads a specification, and whether nothing of it had to be made up; `None` when the rest says nothing without what is
/// missing or wrong.
pub(super) fn read(source: &Source, settings: Settings, keys: ReadKeys, found: &Found) -> Option<(Spec, bool)> {
    let (document, errors) = DeTable::parse_recoverable(&source.text);
    let mut in_order: Vec<_> = errors.iter().map(|error| (error.span().unwrap_or(0..0), error)).collect();
    in_order.sort_by_key(|(span, _)| span.start);
    for (span, error) in in_order {
        let mistake = syntax::mistake(&source.text, span, error.message());
        let ends = mistake.ends;
        found.borrow_mut().push(mistake.diagnostic);
        if ends {
            break;
        }
    }
    if !errors.is_empty() {
        return None;
    }
    let whole = || Table::new("the specification".into(), document.get_ref(), 0..0, &source.text, found);
    let mut top = whole();
    read_version(&mut top);
    let name = read_name(&mut top);
    let title = line(&mut top, "title");
    let origin = line(&mut top, "source");
    let parameters = read_parameters(&mut top);
    let matrices = read_matrices(&mut top);
    let (method, observer) = read_observer(&mut top, keys);
    let form = Form::of(&top, matrices.as_ref(), observer.as_ref().map(|(_, (chain, _))| chain.order));
    let (states, next) = read_states(&mut top, matrices.as_ref(), form);
    let inputs = read_inputs(&mut top);
    let outputs = read_outputs(&mut top, form);
    let unknowns = read_unknowns(&mut top);
    let disturbances = read_disturbances(&mut top);
    let target = read_target(&mut top);
    let tables = top.finish();
    let all = name.is_some() && observer.is_some() && target.is_some();
    // What a chain is, its method's keys say; and names that an unread table declares would all be unknown.
    if form == Form::Unknown || !tables || (!all && form != Form::Equations) {
        return None;
    }
    let (observer, chain) = observer.map_or_else(|| (Observer::stand_in(method), None), |(o, chain)| (o, Some(chain)));
    let target = target.unwrap_or_else(Target::stand_in);
    let mut spec = Spec {
        source: source.clone(),
        name: name.unwrap_or_default(),
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
        observer,
        target: Target { scalar: settings.scalar.unwrap_or(target.scalar), ..target },
    };
    if let (Form::Chain(order), Some((chain, one))) = (form, chain) {
        chain::stand_in(&mut spec, order, chain, (&one, &whole()));
    }
    check_names(&spec, found);
    Some((spec, all))
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
            // So that what uses it is no mistake too.
            let absent = (number.is_none() && !entry.has("value")).then(|| {
                entry.missing("value", "write `value = …`");
                Quantity::Number(RBig::ONE, entry.span())
            });
            let named = read_named(name, &mut entry);
            entry.finish();
            number.or(absent).map(|value| Parameter { named, value })
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
    let [a, b, c, d] = ["A", "B", "C", "D"].map(|letter| table.matrix(letter));
    let matrices = Matrices { a, b, c, d, discrete, span: table.span() };
    for key in ["A", "C"] {
        if !table.has(key) {
            table.missing(key, "write it as a list of rows, such as `[[0, 1], [0, 0]]`");
        }
    }
    table.finish();
    Some(matrices)
}

/// The states, and whether they are given by `next`.
fn read_states(top: &mut Table, matrices: Option<&Matrices>, form: Form) -> (Vec<State>, bool) {
    let Some(mut table) = top.table("states", "[states]") else {
        if form == Form::Equations && !top.has("states") {
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
        let holds = [("zero", Hold::Zero), ("first", Hold::First), ("sampled", Hold::First)];
        let hold = entry.choice("hold", &holds, Hold::Zero);
        Input { named, hold, said: entry.has("hold") }
    })
}

fn read_outputs(top: &mut Table, form: Form) -> Vec<Output> {
    let by_matrices = form == Form::Matrices;
    if !by_matrices && !top.has("outputs") {
        top.missing("outputs", "write `[outputs]` with one line per measured output: `y = { value = 'q' }`");
    }
    let outputs = read_entries(top, "outputs", "[outputs]", "output", |named, entry| {
        let value = entry.text("value");
        match (&value, form) {
            (Some(text), Form::Matrices) => entry.report(
                Diagnostic::error(
                    codes::BAD_COMBINATION,
                    text.span.clone(),
                    "a plant by matrices has its outputs in `C`",
                )
                .help("leave out this key, or `[plant]`"),
            ),
            (None, Form::Equations) if !entry.has("value") => {
                entry.missing("value", "write `value = '…'`, linear in the states");
            }
            _ => {}
        }
        let range = entry.list("range");
        let (noise, delay) = (entry.quantity("noise"), entry.quantity("delay"));
        let output = Output { named, value, noise, delay, range, sensor: Sensor::read(entry) };
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

/// The observer, and what its method's keys say.
type ReadObserver = (Observer, (Chain, String));

/// The method's name as far as there is one, and what its keys say.
fn read_observer(top: &mut Table, keys: ReadKeys) -> (Option<Text>, Option<ReadObserver>) {
    if !top.has("observer") {
        top.missing("observer", "write `[observer.window]` with `window = …` s, or another method (`deadbeat list`)");
    }
    let Some(mut table) = top.table("observer", "[observer]") else { return (None, None) };
    let entries = table.entries();
    match entries.as_slice() {
        [] => {
            let error = Diagnostic::error(codes::MISSING_KEY, table.span(), "[observer] names no method");
            table.report(
                error.help("write `[observer.window]` with `window = …` s, or another method (`deadbeat list`)"),
            );
            (None, None)
        }
        _ if entries.iter().any(|(_, value)| !matches!(value.get_ref(), DeValue::Table(_))) => {
            table.report(method_as_key(&table, &entries));
            (None, None)
        }
        [(name, value)] => {
            let Some(table) = table.entry_table(name, value) else { return (None, None) };
            let mut table = table.named(format!("[observer.{}]", name.value));
            let ahead = table.quantity("ahead");
            let read = keys(name, table).map(|chain| (Observer { method: name.clone(), ahead }, chain));
            (Some(name.clone()), read)
        }
        [first, second, ..] => {
            let message = "a specification has one observer";
            table.report(
                Diagnostic::error(codes::BAD_COMBINATION, second.0.span.clone(), message)
                    .context(first.0.span.clone(), "the other")
                    .help("put the second into a file of its own"),
            );
            (None, None)
        }
    }
}

/// Keys right below `[observer]`: the method is part of the table's name.
fn method_as_key(table: &Table, entries: &[(Text, &Spanned<DeValue>)]) -> Diagnostic {
    let is_table = |value: &Spanned<DeValue>| matches!(value.get_ref(), DeValue::Table(_));
    let word = entries.iter().find_map(|(_, value)| match value.get_ref() {
        DeValue::String(word) => Some(word.to_ascii_lowercase().replace(['_', ' '], "-")),
        _ => None,
    });
    let of_table = entries.iter().find(|(_, value)| is_table(value)).map(|(name, _)| name.value.clone());
    let place =
        entries.iter().find(|(_, value)| !is_table(value)).map_or_else(|| table.span(), |(key, _)| key.span.clone());
    let method = word.or(of_table).unwrap_or_else(|| "window".into());
    let message = "the method is part of the table's name, not a key of [observer]";
    let help = format!("write `[observer.{method}]` instead of `[observer]`, and the method's keys below it");
    Diagnostic::error(codes::BAD_COMBINATION, place, message).help(help)
}

fn read_target(top: &mut Table) -> Option<Target> {
    if !top.has("target") {
        top.missing("target", "write `[target]` with `sample_time = …` s");
    }
    let mut table = top.table("target", "[target]")?;
    let sample_time = table.quantity("sample_time");
    if sample_time.is_none() && !table.has("sample_time") {
        table.missing("sample_time", "write `sample_time = …`, the seconds between two calls");
    }
    let scalar = table.choice("scalar", &[("f32", Scalar::F32), ("f64", Scalar::F64)], Scalar::F32);
    let jitter = table.quantity("jitter");
    let coasted = table.flag("coasted").unwrap_or(false);
    let exact_start = table.has_text("init_at") && table.choice("init_at", &[("exact", true)], false);
    let init_at = exact_start || table.flag("init_at").unwrap_or(false);
    table.finish();
    Some(Target { sample_time: sample_time?, scalar, jitter, coasted, init_at, exact_start })
}
