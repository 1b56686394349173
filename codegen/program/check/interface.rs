//! Names, texts and constants of a Program's interface, cells and tables.

use std::collections::HashSet;

use super::super::{Cell, CellKind, Field, Kind, Program, Scalar, Table};
use super::typing::{fits, representable, width};
use super::{At, CheckError, Flaw};

/// Whether everything outside of the statements is in order.
pub(super) fn check(program: &Program) -> Result<(), CheckError> {
    head(program).at(program, "program")?;
    fields(&program.measurements, |kind| kind != Kind::Index).at(program, "measurements")?;
    fields(&program.inputs, |kind| kind == Kind::Float).at(program, "inputs")?;
    let estimates = program.estimates.iter().map(|(field, _)| field);
    fields(estimates, |kind| !matches!(kind, Kind::Count { .. })).at(program, "estimates")?;
    unique(program.cells.iter().map(|cell| &cell.name)).at(program, "cells")?;
    for it in &program.cells {
        cell(it, program.scalar).at(program, format!("cell `{}`", it.name))?;
    }
    unique(program.tables.iter().map(|table| &table.name)).at(program, "tables")?;
    for it in &program.tables {
        table(it, program.scalar).at(program, format!("table `{}`", it.name))?;
    }
    Ok(())
}

/// The name, the sample time, and that something is measured.
fn head(program: &Program) -> Result<(), Flaw> {
    named(&program.name, |c| c == '_' || c.is_ascii_lowercase())?;
    representable(program.sample_time, program.scalar)?;
    if program.sample_time <= 0.0 {
        return Err(Flaw::SampleTime(program.sample_time));
    }
    if program.measurements.is_empty() { Err(Flaw::NoMeasurement) } else { Ok(()) }
}

/// Measurements, inputs or estimates, and which kinds are allowed there.
fn fields<'a>(all: impl IntoIterator<Item = &'a Field> + Clone, allowed: fn(Kind) -> bool) -> Result<(), Flaw> {
    unique(all.clone().into_iter().map(|field| &field.name))?;
    all.into_iter().try_for_each(|field| {
        identifier(&field.name)?;
        one_line(&field.unit)?;
        one_line(&field.doc)?;
        match field.kind {
            kind if !allowed(kind) => Err(Flaw::WrongPart(kind)),
            Kind::Count { bits, .. } => width(bits),
            Kind::Float | Kind::Index => Ok(()),
        }
    })
}

/// One cell.
fn cell(cell: &Cell, scalar: Scalar) -> Result<(), Flaw> {
    identifier(&cell.name)?;
    one_line(&cell.doc)?;
    match cell.kind {
        CellKind::Ring { len: 0, .. } | CellKind::Counts { len: 0, .. } => Err(Flaw::EmptyRing),
        CellKind::Float { init } | CellKind::Ring { init, .. } => representable(init, scalar),
        CellKind::Counts { init, bits, .. } => fits(init, bits),
        CellKind::Index { .. } => Ok(()),
    }
}

/// One table.
fn table(table: &Table, scalar: Scalar) -> Result<(), Flaw> {
    named(&table.name, |c| c == '_' || c.is_ascii_uppercase())?;
    one_line(&table.doc)?;
    table.columns.iter().try_for_each(|column| one_line(column))?;
    if table.rows.is_empty() || table.columns.is_empty() {
        return Err(Flaw::EmptyTable);
    }
    if let Some(row) = table.rows.iter().position(|row| row.len() != table.columns.len()) {
        return Err(Flaw::RaggedRow(row));
    }
    table.rows.iter().flatten().try_for_each(|x| representable(*x, scalar))
}

/// No name twice.
fn unique<'a>(names: impl Iterator<Item = &'a String>) -> Result<(), Flaw> {
    let mut seen = HashSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(Flaw::SameName(name.clone()));
        }
    }
    Ok(())
}

/// An identifier of Rust and of C, keywords apart.
fn identifier(name: &str) -> Result<(), Flaw> {
    named(name, |c| c == '_' || c.is_ascii_alphabetic())
}

/// A name of such characters and, from the second on, digits.
fn named(name: &str, letter: impl Fn(char) -> bool) -> Result<(), Flaw> {
    let mut rest = name.chars();
    let good = rest.next().is_some_and(&letter) && rest.all(|c| letter(c) || c.is_ascii_digit());
    if good { Ok(()) } else { Err(Flaw::Name(name.to_owned())) }
}

/// A text that can stand in a comment.
pub(super) fn one_line(text: &str) -> Result<(), Flaw> {
    if text.chars().any(char::is_control) { Err(Flaw::NotOneLine(text.to_owned())) } else { Ok(()) }
}
