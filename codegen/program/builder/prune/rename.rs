//! Writes the statements that live under their new numbers.

use std::collections::HashMap;

use super::super::super::{Carried, CellId, Loop, Op, Statement, TableId, Value};
use super::Live;

/// The new number of everything that lives.
pub(super) struct Renaming<'a> {
    live: &'a Live,
    values: HashMap<Value, Value>,
    cells: Vec<u16>,
    tables: Vec<u16>,
    columns: Vec<Vec<u16>>,
}

impl<'a> Renaming<'a> {
    /// Cells, tables and columns close up; values get their numbers as they are met.
    pub fn new(live: &'a Live) -> Self {
        Self {
            live,
            values: HashMap::new(),
            cells: ranks(&live.cells),
            tables: ranks(&live.tables),
            columns: live.columns.iter().map(|columns| ranks(columns)).collect(),
        }
    }

    /// The new number of a value that lives.
    pub fn value(&self, value: Value) -> Value {
        self.values[&value]
    }

    /// The statements that live, without sections that have become empty.
    pub fn top_level(&mut self, body: Vec<Statement>) -> Vec<Statement> {
        let mut rest = self.statements(body, None).into_iter().peekable();
        let mut kept = vec![];
        while let Some(statement) = rest.next() {
            let empty = matches!(rest.peek(), None | Some(Statement::Section(_)));
            if !(empty && matches!(statement, Statement::Section(_))) {
                kept.push(statement);
            }
        }
        kept
    }

    /// The statements that live, in a loop over `row` or at the top level.
    fn statements(&mut self, body: Vec<Statement>, row: Option<TableId>) -> Vec<Statement> {
        body.into_iter().filter_map(|statement| self.statement(statement, row)).collect()
    }

    /// The statement, if it lives.
    fn statement(&mut self, statement: Statement, row: Option<TableId>) -> Option<Statement> {
        let lives = |cell: CellId| self.live.cells[usize::from(cell.0)];
        Some(match statement {
            Statement::Section(text) => Statement::Section(text),
            Statement::Let { value, op } => {
                let op = self.live(value).then(|| self.op(op, row))?;
                Statement::Let { value: self.define(value), op }
            }
            Statement::SetCell { cell, value } => {
                lives(cell).then(|| Statement::SetCell { cell: self.cell(cell), value: self.value(value) })?
            }
            Statement::SetRing { ring, slot, value } => lives(ring).then(|| Statement::SetRing {
                ring: self.cell(ring),
                slot: self.value(slot),
                value: self.value(value),
            })?,
            Statement::Loop(inner) => Statement::Loop(self.inner(inner)?),
        })
    }

    /// The loop, if anything in it lives.
    fn inner(&mut self, Loop { table, mut carried, body }: Loop) -> Option<Loop> {
        carried.retain(|carried| self.live(carried.value));
        for Carried { value, start, .. } in &mut carried {
            *start = self.value(*start);
            *value = self.define(*value);
        }
        let body = self.statements(body, Some(table));
        for Carried { next, .. } in &mut carried {
            *next = self.value(*next);
        }
        (!body.is_empty()).then(|| Loop { table: self.table(table), carried, body })
    }

    /// The operation with its references renamed.
    fn op(&self, mut op: Op, row: Option<TableId>) -> Op {
        for operand in op.operands_mut() {
            *operand = self.value(*operand);
        }
        match &mut op {
            Op::Cell(cell) | Op::Ring { ring: cell, .. } => *cell = self.cell(*cell),
            Op::Lookup { table, column, .. } => {
                *column = self.column(*table, *column);
                *table = self.table(*table);
            }
            Op::Gain { column } => {
                let table = row.unwrap_or_else(|| unreachable!("a gain is in a loop"));
                *column = self.column(table, *column);
            }
            _ => {}
        }
        op
    }

    /// The next free number becomes the value's.
    fn define(&mut self, value: Value) -> Value {
        let number = u32::try_from(self.values.len()).unwrap_or_else(|_| unreachable!("no more values than before"));
        self.values.insert(value, Value(number));
        Value(number)
    }

    fn live(&self, value: Value) -> bool {
        self.live.values[value.0 as usize]
    }

    fn cell(&self, cell: CellId) -> CellId {
        CellId(self.cells[usize::from(cell.0)])
    }

    fn table(&self, table: TableId) -> TableId {
        TableId(self.tables[usize::from(table.0)])
    }

    fn column(&self, table: TableId, column: u16) -> u16 {
        self.columns[usize::from(table.0)][usize::from(column)]
    }
}

/// How many flags before each are set: the new number of each that is.
fn ranks(flags: &[bool]) -> Vec<u16> {
    flags
        .iter()
        .scan(0_u16, |rank, flag| {
            let mine = *rank;
            *rank = rank.wrapping_add(u16::from(*flag));
            Some(mine)
        })
        .collect()
}
