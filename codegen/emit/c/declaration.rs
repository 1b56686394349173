//! Fields, cells and tables.

use super::super::text::{RAW_COUNT, c_comment, field as described, rows};
use super::{C, TableText};
use crate::names;
use crate::program::{Cell, CellKind, Field, Kind, Table, TableId};

/// A field of a struct: `float theta;` and what the comment behind it says.
struct Declared {
    text: String,
    doc: String,
}

impl C<'_> {
    /// The fields of a struct that the caller fills.
    pub fn fields(&self, fields: &[Field], note: &str) -> Vec<String> {
        in_columns(fields.iter().map(|field| self.field(field, note)).collect())
    }

    /// The fields of the estimate.
    pub fn estimates(&self) -> Vec<String> {
        let fields = self.plan.program.estimates.iter().map(|(field, _)| self.field(field, ""));
        let status = Declared {
            text: format!("{}_status status;", self.plan.names.lower),
            doc: "what the step says of this estimate".to_owned(),
        };
        in_columns(fields.chain([status]).collect())
    }

    /// A field of a struct of the interface.
    fn field(&self, field: &Field, note: &str) -> Declared {
        let (r#type, note) = match field.kind {
            Kind::Float => (self.scalar().to_owned(), note),
            Kind::Count { bits, signed } => (format!("{}int{bits}_t", if signed { "" } else { "u" }), RAW_COUNT),
            Kind::Index => ("uint32_t".to_owned(), note),
        };
        Declared { text: format!("{type} {};", field.name), doc: c_comment(&described(field, note)) }
    }

    /// The fields of the state.
    pub fn cells(&self) -> Vec<String> {
        in_columns(self.plan.program.cells.iter().map(|cell| self.cell(cell)).collect())
    }

    /// A cell as a field of the state.
    fn cell(&self, cell: &Cell) -> Declared {
        let Cell { name, doc, kind } = cell;
        let text = match kind {
            CellKind::Float { .. } => format!("{} {name};", self.scalar()),
            CellKind::Index { .. } => format!("uint32_t {name};"),
            CellKind::Ring { len, .. } => format!("{} {name}[{len}];", self.scalar()),
            CellKind::Counts { len, bits, .. } => format!("uint{bits}_t {name}[{len}];"),
        };
        Declared { text, doc: c_comment(doc) }
    }

    /// The statements that give a cell its first value.
    pub fn start(&self, cell: &Cell) -> Vec<String> {
        let name = &cell.name;
        match cell.kind {
            CellKind::Float { init } => vec![format!("state->{name} = {};", self.float(init))],
            CellKind::Index { init } => vec![format!("state->{name} = {init}U;")],
            CellKind::Ring { len, init } => filled(name, len, &self.float(init)),
            CellKind::Counts { len, init, .. } => filled(name, len, &format!("{init}U")),
        }
    }

    /// A table.
    pub fn table(&self, id: TableId, table: &Table) -> TableText {
        let columns = table.columns.iter().enumerate();
        let numbers: Vec<Vec<String>> =
            table.rows.iter().map(|row| row.iter().map(|x| self.float(*x)).collect()).collect();
        TableText {
            title: c_comment(if table.doc.is_empty() { "Gains, by column:" } else { &table.doc }),
            columns: columns.map(|(at, text)| format!("[{at}] {}", c_comment(text))).collect(),
            name: format!("{}[{}][{}]", self.plan.names.prefixed_table(id), table.rows.len(), table.columns.len()),
            scalar: self.scalar(),
            rows: rows(&numbers, ["{ ", " }"]),
        }
    }

    /// The fields of the struct of crossing values, but for the truth values.
    pub fn work_fields(&self) -> Vec<String> {
        let numbers = self.plan.crossing.iter().filter(|value| !self.plan.flags.contains(value));
        numbers.map(|value| format!("{} {}", self.type_of(*value), names::temporary(*value))).collect()
    }
}

/// The statements that give every element of a ring its first value.
fn filled(name: &str, len: u32, init: &str) -> Vec<String> {
    vec![
        format!("for (uint32_t slot = 0U; slot < {len}U; ++slot) {{"),
        format!("    state->{name}[slot] = {init};"),
        "}".to_owned(),
    ]
}

/// Fields with their comments below each other.
fn in_columns(fields: Vec<Declared>) -> Vec<String> {
    let width = fields.iter().map(|field| field.text.len()).max().unwrap_or(0);
    let line = |Declared { text, doc }: Declared| match doc.as_str() {
        "" => text,
        doc => format!("{text:width$} /* {doc} */"),
    };
    fields.into_iter().map(line).collect()
}
