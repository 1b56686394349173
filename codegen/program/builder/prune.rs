//! Pruning: what neither an estimate nor the status depends on is not written.
//!
//! A cell lives if something that lives reads it, so an accumulator that only feeds itself goes.
//! Removing it changes no result: an operation has no effect but its value.

mod rename;

use std::collections::HashMap;
use std::mem;

use self::rename::Renaming;
use super::super::{Carried, CellId, Op, Program, Statement, Table, TableId, Value};

/// The Program without dead values, cells, loops, tables, columns and empty sections; its values
/// renumbered in order of definition.
pub(super) fn prune(program: Program) -> Program {
    let live = Live::of(&program);
    let mut names = Renaming::new(&live);
    Program {
        body: names.top_level(program.body),
        init_at: program.init_at.map(|start| names.top_level(start)),
        estimates: (program.estimates.into_iter()).map(|(field, value)| (field, names.value(value))).collect(),
        status: names.value(program.status),
        cells: kept(program.cells, &live.cells),
        tables: kept(program.tables.into_iter().zip(&live.columns), &live.tables)
            .into_iter()
            .map(|(table, columns)| narrowed(table, columns))
            .collect(),
        ..program
    }
}

/// The elements whose flag is set.
fn kept<T>(all: impl IntoIterator<Item = T>, flags: &[bool]) -> Vec<T> {
    all.into_iter().zip(flags).filter_map(|(one, flag)| flag.then_some(one)).collect()
}

/// The table with the flagged columns.
fn narrowed(table: Table, columns: &[bool]) -> Table {
    Table {
        rows: table.rows.into_iter().map(|row| kept(row, columns)).collect(),
        columns: kept(table.columns, columns),
        ..table
    }
}

/// Where a value comes from.
#[derive(Clone, Copy)]
enum Origin<'a> {
    /// An operation, with the table of the loop around it.
    Op(&'a Op, Option<TableId>),
    /// A loop over that table.
    Carried(&'a Carried, TableId),
}

/// What every value and every cell comes from.
#[derive(Default)]
struct Survey<'a> {
    origins: HashMap<Value, Origin<'a>>,
    /// The values that a write uses, with the table of the loop around it.
    writes: HashMap<CellId, Vec<(Value, Option<TableId>)>>,
}

impl<'a> Survey<'a> {
    /// Adds the statements, which stand in a loop over `row` or at the top level.
    fn add(&mut self, body: &'a [Statement], row: Option<TableId>) {
        for statement in body {
            match statement {
                Statement::Section(_) => {}
                Statement::Let { value, op } => {
                    self.origins.insert(*value, Origin::Op(op, row));
                }
                Statement::SetCell { cell, value } => {
                    self.writes.entry(*cell).or_default().push((*value, row));
                }
                Statement::SetRing { ring, slot, value } => {
                    self.writes.entry(*ring).or_default().extend([(*slot, row), (*value, row)]);
                }
                Statement::Loop(inner) => {
                    for carried in &inner.carried {
                        self.origins.insert(carried.value, Origin::Carried(carried, inner.table));
                    }
                    self.add(&inner.body, Some(inner.table));
                }
            }
        }
    }
}

/// What lives.
struct Live {
    values: Vec<bool>,
    cells: Vec<bool>,
    tables: Vec<bool>,
    columns: Vec<Vec<bool>>,
}

impl Live {
    /// Everything that the estimates and the status depend on.
    fn of(program: &Program) -> Self {
        let mut survey = Survey::default();
        survey.add(&program.body, None);
        survey.add(program.init_at.as_deref().unwrap_or_default(), None);
        let size = survey.origins.keys().map(|value| value.0 as usize + 1).max().unwrap_or(0);
        let mut live = Self {
            values: vec![false; size],
            cells: vec![false; program.cells.len()],
            tables: vec![false; program.tables.len()],
            columns: program.tables.iter().map(|table| vec![false; table.columns.len()]).collect(),
        };
        let mut due: Vec<Value> = program.estimates.iter().map(|(_, value)| *value).collect();
        due.push(program.status);
        while let Some(value) = due.pop() {
            if !mem::replace(&mut live.values[value.0 as usize], true) {
                live.follow(survey.origins[&value], &survey, &mut due);
            }
        }
        for (columns, table) in live.columns.iter_mut().zip(&live.tables) {
            // A loop that only counts rows still needs a table with a column.
            columns[0] |= *table && !columns.contains(&true);
        }
        live
    }

    /// Marks what a live value comes from; values go into `due`.
    fn follow(&mut self, origin: Origin, survey: &Survey, due: &mut Vec<Value>) {
        let (op, row) = match origin {
            Origin::Op(op, row) => (op, row),
            Origin::Carried(carried, table) => {
                self.tables[usize::from(table.0)] = true;
                due.extend([carried.start, carried.next]);
                return;
            }
        };
        due.extend(op.operands());
        match (op, row) {
            (Op::Cell(cell) | Op::Ring { ring: cell, .. }, _) => self.read(*cell, survey, due),
            (Op::Lookup { table, column, .. }, _) => self.column(*table, *column),
            (Op::Gain { column }, Some(table)) => self.column(table, *column),
            _ => {}
        }
    }

    /// A live value reads the cell: every write of it lives.
    fn read(&mut self, cell: CellId, survey: &Survey, due: &mut Vec<Value>) {
        if mem::replace(&mut self.cells[usize::from(cell.0)], true) {
            return;
        }
        for (value, row) in survey.writes.get(&cell).into_iter().flatten() {
            due.push(*value);
            if let Some(table) = row {
                self.tables[usize::from(table.0)] = true;
            }
        }
    }

    /// A live value reads the column.
    fn column(&mut self, table: TableId, column: u16) {
        self.tables[usize::from(table.0)] = true;
        self.columns[usize::from(table.0)][usize::from(column)] = true;
    }
}
