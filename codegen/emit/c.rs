//! C99, also C++: the header and the source, by the templates in `templates/c`.
//!
//! The templates hold the layout of a file; what differs from one Program to the next comes from
//! here as lines that are already spelled.

mod declaration;
mod function;
pub(super) mod math;
mod operation;
mod runtime;
mod statement;

use askama::Template;

use super::Header;
use super::plan::Plan;
use super::text::c_comment;
use crate::program::{Scalar, Type, Value, literal};

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
        cells: c.cells(),
        starts_at: plan.start().is_some(),
    })
}

/// The contents of `<name>.c`.
pub fn source(plan: &Plan, header: &Header) -> String {
    let c = C { plan };
    rendered(&SourceFile {
        name: &plan.names.lower,
        indent: indent(plan),
        title: c_comment(&header.title),
        tables: plan.program.read_tables().map(|(at, table)| c.table(at, table)).collect(),
        runtime: runtime::sources(plan),
        work: c.work_fields(),
        flags: plan.flags.iter().map(Value::to_string).collect::<Vec<_>>().join(", "),
        flag_count: plan.flags.len(),
        parts: plan.parts().map(|(at, of, part)| c.part(at, of, part)).collect(),
        starts: plan.program.cells.iter().flat_map(|cell| c.start(cell)).collect(),
        start: plan.start().map(|start| c.start_at(start)),
        step: c.step(plan.step()),
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
    /// Whether it can start from an estimate.
    starts_at: bool,
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
    /// What a start from an estimate does behind `init`.
    start: Option<Vec<String>>,
    step: Vec<String>,
    has_inputs: bool,
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
