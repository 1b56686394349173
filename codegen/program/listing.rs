//! A Program as text for people: one statement per line, made to be read and compared.
//!
//! In: any [`Program`], even one that [`check`](super::check::check) refuses. Out: text that
//! depends on nothing else. `=` defines a value, `:=` writes a cell; numbers are spelled by
//! [`literal`](super::literal), a number without a point is an index.

mod operation;

use super::literal::float;
use super::{CellId, CellKind, Field, Kind, Loop, Program, Statement, Table, TableId};

/// The whole Program.
#[must_use]
pub fn listing(program: &Program) -> String {
    let mut text = format!(
        "program {}: {}, one step every {} s\n",
        program.name,
        program.scalar,
        float(program.sample_time, program.scalar)
    );
    let estimates: Vec<Field> = program.estimates.iter().map(|(field, _)| field.clone()).collect();
    block(&mut text, "measurements", fields(&program.measurements));
    block(&mut text, "inputs", fields(&program.inputs));
    block(&mut text, "estimates", fields(&estimates));
    block(&mut text, "cells", cells(program));
    for it in &program.tables {
        block(&mut text, &format!("table {}", it.name), table(it, program));
    }
    block(&mut text, "init_at", statements(program.init_at.as_deref().unwrap_or_default(), program));
    block(&mut text, "step", statements(&program.body, program));
    block(&mut text, "return", returned(program));
    text
}

/// A heading with indented lines below it; nothing if there are none.
fn block(text: &mut String, heading: &str, lines: Vec<String>) {
    if lines.is_empty() {
        return;
    }
    text.push('\n');
    text.push_str(heading);
    text.push('\n');
    for line in lines {
        text.push_str(format!("  {line}").trim_end());
        text.push('\n');
    }
}

/// `name [unit]  description`, one line each, in columns.
fn fields(fields: &[Field]) -> Vec<String> {
    let named = |field: &Field| {
        let name = match field.kind {
            Kind::Float => field.name.clone(),
            Kind::Count { bits, signed } => format!("{}: {}{bits}", field.name, if signed { 'i' } else { 'u' }),
            Kind::Index => format!("{}: index", field.name),
        };
        if field.unit.is_empty() { name } else { format!("{name} [{}]", field.unit) }
    };
    columns(fields.iter().map(|field| (named(field), field.doc.clone())).collect())
}

/// `name = start  description`, one line each, in columns.
fn cells(program: &Program) -> Vec<String> {
    let started = |kind: &CellKind| match *kind {
        CellKind::Float { init } => float(init, program.scalar),
        CellKind::Index { init } => init.to_string(),
        CellKind::Ring { len, init } => format!("{len} * {}", float(init, program.scalar)),
        CellKind::Counts { len, init, bits } => format!("{len} * {init} of {bits} bits"),
    };
    let named = program.cells.iter().map(|cell| (format!("{} = {}", cell.name, started(&cell.kind)), cell.doc.clone()));
    columns(named.collect())
}

/// The second entries begin below each other.
fn columns(lines: Vec<(String, String)>) -> Vec<String> {
    let width = lines.iter().map(|(first, _)| first.chars().count()).max().unwrap_or(0);
    lines.into_iter().map(|(first, second)| format!("{first:width$}  {second}")).collect()
}

/// Its description, that of each column, then one row per line.
fn table(table: &Table, program: &Program) -> Vec<String> {
    let head = std::iter::once(format!("# {}", table.doc));
    let columns = (table.columns.iter().enumerate()).map(|(at, column)| format!("# .{at} {column}"));
    let rows = table.rows.iter().map(|row| {
        let row: Vec<String> = row.iter().map(|x| float(*x, program.scalar)).collect();
        row.join(", ")
    });
    head.chain(columns).chain(rows).collect()
}

/// The statements.
fn statements(body: &[Statement], program: &Program) -> Vec<String> {
    let mut lines = vec![];
    for it in body {
        let text = statement(it, program);
        lines.extend(text.lines().map(str::to_owned));
    }
    lines
}

/// What the call returns.
fn returned(program: &Program) -> Vec<String> {
    let estimates = program.estimates.iter().map(|(field, value)| format!("{} = {value}", field.name));
    estimates.chain([format!("status = {}", program.status)]).collect()
}

/// One statement; a loop is several lines.
#[must_use]
pub fn statement(statement: &Statement, program: &Program) -> String {
    match statement {
        Statement::Section(text) => format!("# {text}"),
        Statement::Let { value, op } => format!("{value} = {}", operation::text(op, program)),
        Statement::SetCell { cell: at, value } => format!("{} := {value}", cell(*at, program)),
        Statement::SetRing { ring, slot, value } => {
            format!("{}[{slot}] := {value}", cell(*ring, program))
        }
        Statement::Loop(inner) => looped(inner, program),
    }
}

/// The loop's head, what it carries, its body.
fn looped(inner: &Loop, program: &Program) -> String {
    let head = format!("for each row of {}", table_name(inner.table, program));
    let carried = inner
        .carried
        .iter()
        .map(|carried| format!("  carry {} = {}, then {}", carried.value, carried.start, carried.next));
    let body = inner.body.iter().flat_map(|it| {
        let text = statement(it, program);
        text.lines().map(|line| format!("  {line}")).collect::<Vec<_>>()
    });
    let lines: Vec<String> = std::iter::once(head).chain(carried).chain(body).collect();
    lines.join("\n")
}

/// The cell's name, or its number if it is not declared.
fn cell(CellId(at): CellId, program: &Program) -> String {
    let known = program.cells.get(usize::from(at));
    known.map_or_else(|| format!("cell{at}"), |cell| cell.name.clone())
}

/// The table's name, or its number if it is not declared.
fn table_name(TableId(at): TableId, program: &Program) -> String {
    let known = program.tables.get(usize::from(at));
    known.map_or_else(|| format!("TABLE{at}"), |table| table.name.clone())
}

#[cfg(test)]
mod tests {
    use super::super::builder::Builder;
    use super::super::{Field, Scalar, Status};
    use super::*;

    /// Claim: the listing is this text, to the last blank.
    #[test]
    fn text() {
        let field = |name: &str, unit: &str, doc: &str| Field {
            name: name.to_owned(),
            unit: unit.to_owned(),
            doc: doc.to_owned(),
            kind: Kind::Float,
        };
        let mut b = Builder::new("mean_rate", Scalar::F32, 0.125);
        let y = b.measurement(field("y", "rad", "shaft angle"));
        let u = b.input(field("u", "", ""));
        let head = b.index_cell("head", "newest sample", 0);
        let window = b.ring("window", "the last samples of y", 2, 0.0);
        let columns = vec!["on the window, 1/s".to_owned()];
        let table = b.table("GAINS", "weights of the window", columns, vec![vec![8.0], vec![-8.0]]);

        b.section("newest sample");
        let (measured, before) = (b.read_measurement(y), b.read(head));
        let slot = b.advance(before, 2);
        b.set_ring(window, slot, measured);
        b.set(head, slot);
        b.section("weighted sum");
        let start = b.read_input(u);
        let ends = b.loop_over(table, &[slot, start], |b, carried| {
            let (sample, gain) = (b.read_ring(window, carried[0]), b.gain(0));
            let product = b.mul(gain, sample);
            vec![b.retreat(carried[0], 2), b.add(carried[1], product)]
        });
        let status = b.status(Status::Converged);
        b.estimate(field("rate", "rad/s", ""), ends[1]);
        b.report(status);

        let expected = "\
program mean_rate: f32, one step every 0.125 s

measurements
  y [rad]  shaft angle

inputs
  u

estimates
  rate [rad/s]

cells
  head = 0          newest sample
  window = 2 * 0.0  the last samples of y

table GAINS
  # weights of the window
  # .0 on the window, 1/s
  8.0
  -8.0

step
  # newest sample
  t0 = measurement.y
  t1 = head
  t2 = advance(t1, 2)
  window[t2] := t0
  head := t2
  # weighted sum
  t3 = input.u
  for each row of GAINS
    carry t4 = t2, then t9
    carry t5 = t3, then t10
    t6 = window[t4]
    t7 = row.0
    t8 = t7 * t6
    t9 = retreat(t4, 2)
    t10 = t5 + t8
  t11 = converged

return
  rate = t5
  status = t11
";
        assert_eq!(listing(&b.finish()), expected);
    }
}
