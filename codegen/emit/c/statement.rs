//! The statements of one function.

use super::super::plan::{Function, Place};
use super::super::split::Item;
use super::super::text::c_comment;
use super::C;
use crate::names;
use crate::program::{Carried, CellId, CellKind, Loop, Op, Statement, Value};

impl C<'_> {
    /// The statements of a function, without its own indentation.
    pub fn statements(&self, function: &Function) -> Vec<String> {
        self.block(&function.items)
    }

    /// Statements, each heading with a blank line before it.
    fn block(&self, items: &[Item]) -> Vec<String> {
        let mut lines: Vec<String> = vec![];
        let mut heading = None;
        for item in items {
            if let Item::Plain(Statement::Section(text)) = item {
                heading = Some(format!("/* {} */", c_comment(text)));
                continue;
            }
            let statement = self.statement(item);
            if let Some(heading) = heading.take_if(|_| !statement.is_empty()) {
                let blank = (!lines.is_empty()).then(String::new);
                lines.extend(blank.into_iter().chain([heading]));
            }
            lines.extend(statement);
        }
        lines
    }

    /// One statement.
    fn statement(&self, item: &Item) -> Vec<String> {
        match item {
            Item::Plain(Statement::Let { value, op }) => self.definition(*value, op).into_iter().collect(),
            Item::Plain(Statement::SetCell { cell, value }) => {
                vec![format!("{} = {};", self.cell_name(*cell), self.value(*value))]
            }
            Item::Plain(Statement::SetRing { ring, slot, value }) => {
                let narrowed = match self.plan.program.cells[usize::from(ring.0)].kind {
                    CellKind::Counts { bits: 16, .. } => "(uint16_t)",
                    _ => "",
                };
                let (slot, value) = (self.value(*slot), self.value(*value));
                vec![format!("{}[{slot}] = {narrowed}{value};", self.cell_name(*ring))]
            }
            Item::Loop { source, items } => self.looped(source, items),
            Item::Call(callee) => vec![self.call_part(*callee)],
            Item::Plain(Statement::Section(_) | Statement::Loop(_)) => vec![],
        }
    }

    /// `const float t2 = t0 + t1;`, nothing for a constant.
    fn definition(&self, value: Value, op: &Op) -> Option<String> {
        let operation = self.operation(op);
        match self.plan.place(value) {
            Place::Constant(_) => None,
            Place::Local => Some(format!("const {} {} = {operation};", self.type_of(value), names::temporary(value))),
            Place::Work | Place::Flag(_) => Some(format!("{} = {operation};", self.value(value))),
        }
    }

    /// A loop over the rows of its table.
    fn looped(&self, source: &Loop, items: &[Item]) -> Vec<String> {
        let rows = self.plan.program.tables[usize::from(source.table.0)].rows.len();
        let row = self.plan.uses_row(items).then(|| {
            let table = self.plan.names.prefixed_table(source.table);
            format!("const {} *const gains = {table}[row];", self.scalar())
        });
        let nexts = source.carried.iter().filter_map(|carried| self.next(carried));
        let body = row.into_iter().chain(self.block(items)).chain(nexts);
        let starts = source.carried.iter().map(|carried| self.start_value(carried));
        starts
            .chain([format!("for (uint32_t row = 0U; row < {rows}U; ++row) {{")])
            .chain(body.map(|line| if line.is_empty() { line } else { format!("    {line}") }))
            .chain(["}".to_owned()])
            .collect()
    }

    /// The declaration of a carried value.
    fn start_value(&self, carried: &Carried) -> String {
        let start = self.value(carried.start);
        match self.plan.place(carried.value) {
            Place::Local => {
                let constant = if carried.next == carried.value { "const " } else { "" };
                let (r#type, name) = (self.type_of(carried.value), names::temporary(carried.value));
                format!("{constant}{type} {name} = {start};")
            }
            _ => format!("{} = {start};", self.value(carried.value)),
        }
    }

    /// What a carried value is in the next iteration.
    fn next(&self, carried: &Carried) -> Option<String> {
        let changes = carried.next != carried.value;
        changes.then(|| format!("{} = {};", self.value(carried.value), self.value(carried.next)))
    }

    /// A cell.
    pub fn cell_name(&self, cell: CellId) -> String {
        format!("state->{}", self.plan.program.cells[usize::from(cell.0)].name)
    }
}
