//! Declares fields, cells and tables.

use super::super::check::typing::{fits, representable};
use super::super::{Cell, CellId, CellKind, Field, Table, TableId};
use super::Builder;

impl Builder {
    /// Declares the next measurement.
    pub fn measurement(&mut self, field: Field) -> u16 {
        self.program.measurements.push(field);
        number(self.program.measurements.len() - 1)
    }

    /// Declares the next input.
    pub fn input(&mut self, field: Field) -> u16 {
        self.program.inputs.push(field);
        number(self.program.inputs.len() - 1)
    }

    /// Declares a cell of one float; a name in use gets `_2`, `_3`, … behind it.
    pub fn float_cell(&mut self, name: &str, doc: &str, init: f64) -> CellId {
        self.require(name, representable(init, self.scalar()));
        self.cell(name, doc, CellKind::Float { init })
    }

    /// Declares a cell of one index; named as [`Builder::float_cell`].
    pub fn index_cell(&mut self, name: &str, doc: &str, init: u32) -> CellId {
        self.cell(name, doc, CellKind::Index { init })
    }

    /// Declares `len` floats by slot; named as [`Builder::float_cell`].
    pub fn ring(&mut self, name: &str, doc: &str, len: u32, init: f64) -> CellId {
        assert!(len >= 1, "ring `{name}` has no slot");
        self.require(name, representable(init, self.scalar()));
        self.cell(name, doc, CellKind::Ring { len, init })
    }

    /// Declares `len` indices by slot, of which the low 16 or 32 `bits` are kept; named as
    /// [`Builder::float_cell`].
    pub fn counts(&mut self, name: &str, doc: &str, len: u32, bits: u8, init: u32) -> CellId {
        assert!(len >= 1, "ring `{name}` has no slot");
        self.require(name, fits(init, bits));
        self.cell(name, doc, CellKind::Counts { len, init, bits })
    }

    /// Declares a cell.
    fn cell(&mut self, name: &str, doc: &str, kind: CellKind) -> CellId {
        let name = unique(name, |name| self.program.cells.iter().any(|cell| cell.name == name));
        self.program.cells.push(Cell { name, doc: doc.to_owned(), kind });
        self.shared.declare();
        CellId(number(self.program.cells.len() - 1))
    }

    /// Declares a constant table, `rows` of as many floats as `columns` has descriptions; a name
    /// in use gets `_2`, `_3`, … behind it.
    pub fn table(&mut self, name: &str, doc: &str, columns: Vec<String>, rows: Vec<Vec<f64>>) -> TableId {
        assert!(!columns.is_empty() && !rows.is_empty(), "table `{name}` is empty");
        assert!(rows.iter().all(|row| row.len() == columns.len()), "table `{name}` is ragged");
        for x in rows.iter().flatten() {
            self.require(name, representable(*x, self.scalar()));
        }
        let name = unique(name, |name| self.program.tables.iter().any(|table| table.name == name));
        self.program.tables.push(Table { name, doc: doc.to_owned(), columns, rows });
        TableId(number(self.program.tables.len() - 1))
    }
}

/// A place as a number of the Program.
fn number(place: usize) -> u16 {
    u16::try_from(place).expect("at most 65536 fields, cells or tables")
}

/// The name itself, or the first of `name_2`, `name_3`, … that is not taken.
fn unique(name: &str, taken: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|number: u32| format!("{name}_{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| !taken(name)).unwrap_or_else(|| unreachable!("there are names without end"))
}
