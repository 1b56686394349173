//! C99, also C++: the header and the source, by the templates in `templates/c`.
//!
//! The templates hold the layout of a file; what differs from one Program to the next comes from
//! here as lines that are already spelled.

mod operation;
mod runtime;
mod statement;

use askama::Template;

use super::Header;
use super::names;
use super::plan::{Access, Function, Plan};
use super::text::{c_comment, field as described, rows};
use crate::program::{Cell, CellKind, Field, Scalar, Table, TableId, Type, Value, literal};

/// The contents of `<name>.h`.
pub fn header(plan: &Plan, header: &Header) -> String {
    let c = C { plan };
    rendered(&HeaderFile {
        name: &plan.names.lower,
        indent: indent(plan),
        upper: &plan.names.upper,
        title: c_comment(&header.title),
        lines: header.lines.iter().map(|line| c_comment(line)).collect(),
        sample_time: c.float(plan.program.sample_time),
        measurements: c.fields(&plan.program.measurements, "NaN when missing"),
        inputs: c.fields(&plan.program.inputs, ""),
        estimates: c.estimates(),
        cells: in_columns(plan.program.cells.iter().map(|cell| c.cell(cell)).collect()),
    })
}

/// The contents of `<name>.c`.
pub fn source(plan: &Plan, header: &Header) -> String {
    let c = C { plan };
    let (step, parts) = plan.step();
    rendered(&SourceFile {
        name: &plan.names.lower,
        indent: indent(plan),
        title: c_comment(&header.title),
        tables: plan.program.tables.iter().zip(0..).map(|(table, at)| c.table(TableId(at), table)).collect(),
        runtime: runtime::sources(plan),
        work: plan.crossing.iter().filter_map(|value| c.work_field(*value)).collect(),
        flags: plan.flags.iter().map(Value::to_string).collect::<Vec<_>>().join(", "),
        flag_count: plan.flags.len(),
        parts: parts.iter().enumerate().map(|(at, part)| c.part(at, part)).collect(),
        starts: plan.program.cells.iter().flat_map(|cell| c.start(cell)).collect(),
        step: c.step(step),
        has_inputs: !plan.program.inputs.is_empty(),
    })
}

/// The header.
#[derive(Template)]
#[template(path = "c/header.h", escape = "none")]
struct HeaderFile<'a> {
    name: &'a str,
    indent: String,
    upper: &'a str,
    title: String,
    lines: Vec<String>,
    sample_time: String,
    measurements: Vec<String>,
    inputs: Vec<String>,
    estimates: Vec<String>,
    cells: Vec<String>,
}

/// The source.
#[derive(Template)]
#[template(path = "c/source.c", escape = "none")]
struct SourceFile<'a> {
    name: &'a str,
    indent: String,
    title: String,
    tables: Vec<TableText>,
    runtime: Vec<String>,
    /// The fields of the struct of crossing values, but for the truth values.
    work: Vec<String>,
    flags: String,
    flag_count: usize,
    parts: Vec<Part>,
    starts: Vec<String>,
    step: Vec<String>,
    has_inputs: bool,
}

/// A field of a struct: `float theta;` and what the comment behind it says.
struct Declared {
    text: String,
    doc: String,
}

/// A table.
struct TableText {
    title: String,
    columns: Vec<String>,
    /// `PENDULUM_WINDOW[51][4]`.
    name: String,
    scalar: &'static str,
    rows: Vec<String>,
}

/// A function that holds a part of the step.
struct Part {
    doc: String,
    name: String,
    parameters: String,
    lines: Vec<String>,
}

/// The Program in C.
struct C<'p> {
    plan: &'p Plan<'p>,
}

impl C<'_> {
    /// The float type.
    fn scalar(&self) -> &'static str {
        match self.plan.program.scalar {
            Scalar::F32 => "float",
            Scalar::F64 => "double",
        }
    }

    /// A float constant.
    fn float(&self, value: f64) -> String {
        let suffix = match self.plan.program.scalar {
            Scalar::F32 => "f",
            Scalar::F64 => "",
        };
        literal::float(value, self.plan.program.scalar) + suffix
    }

    /// The type of a value.
    fn type_of(&self, value: Value) -> String {
        match self.plan.r#type(value) {
            Type::Float => self.scalar().to_owned(),
            Type::Index => "uint32_t".to_owned(),
            Type::Bool => "int".to_owned(),
            Type::Status => format!("{}_status", self.plan.names.lower),
        }
    }

    /// The fields of a struct that the caller fills.
    fn fields(&self, fields: &[Field], note: &str) -> Vec<String> {
        in_columns(fields.iter().map(|field| self.field(field, note)).collect())
    }

    /// The fields of the estimate.
    fn estimates(&self) -> Vec<String> {
        let fields = self.plan.program.estimates.iter().map(|(field, _)| self.field(field, ""));
        let status = Declared {
            text: format!("{}_status status;", self.plan.names.lower),
            doc: "what the step says of this estimate".to_owned(),
        };
        in_columns(fields.chain([status]).collect())
    }

    /// A field of a struct of the interface.
    fn field(&self, field: &Field, note: &str) -> Declared {
        let text = format!("{} {};", self.scalar(), field.name);
        Declared { text, doc: c_comment(&described(field, note)) }
    }

    /// A cell as a field of the state.
    fn cell(&self, cell: &Cell) -> Declared {
        let Cell { name, doc, kind } = cell;
        let text = match kind {
            CellKind::Float { .. } => format!("{} {name};", self.scalar()),
            CellKind::Index { .. } => format!("uint32_t {name};"),
            CellKind::Ring { len, .. } => format!("{} {name}[{len}];", self.scalar()),
        };
        Declared { text, doc: c_comment(doc) }
    }

    /// The statements that give a cell its first value.
    fn start(&self, cell: &Cell) -> Vec<String> {
        let name = &cell.name;
        match cell.kind {
            CellKind::Float { init } => vec![format!("state->{name} = {};", self.float(init))],
            CellKind::Index { init } => vec![format!("state->{name} = {init}U;")],
            CellKind::Ring { len, init } => vec![
                format!("for (uint32_t slot = 0U; slot < {len}U; ++slot) {{"),
                format!("    state->{name}[slot] = {};", self.float(init)),
                "}".to_owned(),
            ],
        }
    }

    /// A table.
    fn table(&self, id: TableId, table: &Table) -> TableText {
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

    /// A field of the struct of crossing values.
    fn work_field(&self, value: Value) -> Option<String> {
        let is_flag = self.plan.flags.contains(&value);
        (!is_flag).then(|| format!("{} {}", self.type_of(value), names::temporary(value)))
    }

    /// A function that holds a part of the step.
    fn part(&self, at: usize, part: &Function) -> Part {
        let doc = match part.row {
            Some(table) => format!("Part {} of a step, for one row of {}.", at + 1, self.plan.names.prefixed_table(table)),
            None => format!("Part {} of a step.", at + 1),
        };
        let parameters: Vec<String> = self.parameters(part).into_iter().map(|(declared, _)| declared).collect();
        Part { doc, name: names::part(at), parameters: parameters.join(", "), lines: self.statements(part) }
    }

    /// The statements of the step itself.
    fn step(&self, step: &Function) -> Vec<String> {
        let program = self.plan.program;
        let reach = step.reach;
        let ignored = [
            ("state", reach.state == Access::None),
            ("measurements", !reach.measurements),
            ("inputs", !reach.inputs && !program.inputs.is_empty()),
        ];
        let mut lines: Vec<String> =
            ignored.iter().filter(|(_, is)| *is).map(|(name, _)| format!("(void){name};")).collect();
        if reach.work > Access::None {
            lines.push(format!("{}_work work;", self.plan.names.lower));
        }
        lines.extend(self.statements(step));
        if !lines.is_empty() {
            lines.push(String::new());
        }
        for (field, value) in &program.estimates {
            lines.push(format!("estimate->{} = {};", field.name, self.result(*value)));
        }
        lines.push(format!("estimate->status = {};", self.result(program.status)));
        lines
    }
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

/// What stands below `void pendulum_step(`.
fn indent(plan: &Plan) -> String {
    " ".repeat("void _step(".len() + plan.names.lower.len())
}

/// The text of a template.
fn rendered(template: &impl Template) -> String {
    match template.render() {
        Ok(text) => text + "\n",
        Err(error) => unreachable!("a template over strings renders: {error}"),
    }
}
