//! The items of the file: constants, structs, and the observer with its functions.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::names;
use super::super::plan::{Access, Function, Place, Plan, Reach};
use super::super::text::{field as described, markdown};
use super::operation::status;
use super::{Rust, constant, ident};
use crate::program::{Cell, CellKind, Field, Scalar, Status, Table, TableId, Type, Value, literal};

/// The largest size in bytes that clippy lets a function take by value.
pub const BY_VALUE: usize = 256;

/// The largest size in bytes that clippy wants to be taken by value.
const SMALL: usize = 8;

impl Rust<'_> {
    /// All items.
    pub fn items(&self) -> TokenStream {
        let (step, parts) = self.plan.step();
        let tables = self.plan.program.tables.iter().enumerate().map(|(at, table)| self.table(at, table));
        let head = self.head();
        let work = self.work();
        let new = self.new_function();
        let step = self.step(step);
        let parts = parts.iter().enumerate().map(|(at, part)| self.part(at, part));
        let implementation = self.implementation();
        quote! {
            #head
            #(#tables)*
            #work
            impl Observer {
                #new
                #step
                #(#parts)*
            }
            #implementation
        }
    }

    /// What a user of the observer sees, but for its functions.
    fn head(&self) -> TokenStream {
        let program = self.plan.program;
        let scalar = scalar(self.plan);
        let sample_time = constant::float(program.sample_time, program.scalar);
        let measurements = self.interface("Sampled now.", "Measurements", &program.measurements, "NaN when missing");
        let inputs = (!program.inputs.is_empty())
            .then(|| self.interface("Applied since the previous call.", "Inputs", &program.inputs, ""));
        let estimates = program.estimates.iter().map(|(field, _)| self.field(field, ""));
        let cells = program.cells.iter().map(|cell| self.cell_field(cell));
        quote! {
            pub use ::deadbeat::Status;
            /// Seconds between two calls of [`Observer::step`].
            pub const SAMPLE_TIME: #scalar = #sample_time;
            #measurements
            #inputs
            /// The state, and how far it is to be trusted.
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct Estimate {
                #(#estimates)*
                /// what the step says of this estimate
                pub status: Status,
            }
            /// The observer's whole state; plain data.
            #[derive(Clone, Copy, Debug)]
            pub struct Observer { #(#cells)* }
        }
    }

    /// A struct that the caller fills.
    fn interface(&self, doc: &str, name: &str, fields: &[Field], note: &str) -> TokenStream {
        let name = ident(name);
        let fields = fields.iter().map(|field| self.field(field, note));
        let doc = format!(" {doc}");
        quote! {
            #[doc = #doc]
            #[derive(Clone, Copy, Debug)]
            pub struct #name { #(#fields)* }
        }
    }

    /// A public field.
    fn field(&self, field: &Field, note: &str) -> TokenStream {
        let doc = format!(" {}", markdown(&described(field, note)));
        let name = ident(&field.name);
        let scalar = scalar(self.plan);
        quote!(#[doc = #doc] pub #name: #scalar,)
    }

    /// A private field.
    fn cell_field(&self, cell: &Cell) -> TokenStream {
        let doc = documentation(&cell.doc);
        let name = ident(&cell.name);
        let scalar = scalar(self.plan);
        let r#type = match cell.kind {
            CellKind::Float { .. } => scalar,
            CellKind::Index { .. } => quote!(usize),
            CellKind::Ring { len, .. } => {
                let len = constant::index(len);
                quote!([#scalar; #len])
            }
        };
        quote!(#doc #name: #r#type,)
    }

    /// A table; the layout writes its rows.
    fn table(&self, at: usize, table: &Table) -> TokenStream {
        let title = documentation(if table.doc.is_empty() { "Gains, by column:" } else { &table.doc });
        let columns = table.columns.iter().enumerate().map(|(at, column)| {
            let doc = format!(" - `[{at}]` {}", markdown(column));
            quote!(#[doc = #doc])
        });
        let name = ident(self.plan.names.table(table_id(at)));
        let scalar = scalar(self.plan);
        let (height, width) = (length(table.rows.len()), length(table.columns.len()));
        let rows = if self.laid_out { quote!(ROWS) } else { self.rows(table) };
        quote! {
            #title
            #[doc = ""]
            #(#columns)*
            static #name: [[#scalar; #width]; #height] = #rows;
        }
    }

    /// The rows of a table.
    fn rows(&self, table: &Table) -> TokenStream {
        let rows = table.rows.iter().map(|row| {
            let row = row.iter().map(|x| constant::float(*x, self.plan.program.scalar));
            quote!([#(#row),*])
        });
        quote!([#(#rows),*])
    }

    /// The struct of the values that cross from one function to another.
    fn work(&self) -> TokenStream {
        if self.plan.crossing.is_empty() {
            return TokenStream::new();
        }
        let fields = self.plan.crossing.iter().filter(|value| matches!(self.plan.place(**value), Place::Work));
        let declared = fields.clone().map(|value| {
            let (name, r#type) = (ident(&names::temporary(*value)), self.type_of(*value));
            quote!(#name: #r#type,)
        });
        let empty = fields.map(|value| {
            let (name, nothing) = (ident(&names::temporary(*value)), self.nothing(*value));
            quote!(#name: #nothing,)
        });
        let count = length(self.plan.flags.len());
        let doc = format!(" {}", self.plan.flags.iter().map(Value::to_string).collect::<Vec<_>>().join(", "));
        let some = !self.plan.flags.is_empty();
        let flags = some.then(|| quote!(#[doc = #doc] flags: [bool; #count],));
        let no_flags = some.then(|| quote!(flags: [false; #count],));
        quote! {
            /// What one part of a step hands to the next.
            struct Work { #(#declared)* #flags }
            impl Work {
                /// Before the first part.
                const EMPTY: Self = Self { #(#empty)* #no_flags };
            }
        }
    }

    /// What a field of `Work` holds before it is written.
    fn nothing(&self, value: Value) -> TokenStream {
        match self.plan.r#type(value) {
            Type::Float => quote!(0.0),
            Type::Index => quote!(0),
            Type::Bool => quote!(false),
            Type::Status => status(Status::Converging),
        }
    }

    /// The functions that start.
    fn new_function(&self) -> TokenStream {
        let cells = self.plan.program.cells.iter().map(|cell| {
            let name = ident(&cell.name);
            let start = self.start_of(&cell.kind);
            quote!(#name: #start,)
        });
        quote! {
            /// The state before the first sample.
            #[must_use]
            pub const fn new() -> Self {
                Self { #(#cells)* }
            }
            /// Back to the state before the first sample.
            pub fn init(&mut self) {
                *self = Self::new();
            }
        }
    }

    /// What a cell holds before the first sample.
    fn start_of(&self, kind: &CellKind) -> TokenStream {
        let scalar = self.plan.program.scalar;
        match *kind {
            CellKind::Float { init } => constant::float(init, scalar),
            CellKind::Index { init } => constant::index(init),
            CellKind::Ring { len, init } => {
                let (init, len) = (constant::float(init, scalar), constant::index(len));
                quote!([#init; #len])
            }
        }
    }

    /// The step.
    fn step(&self, step: &Function) -> TokenStream {
        let program = self.plan.program;
        let inputs = (!program.inputs.is_empty()).then(|| quote!(, inputs: Inputs));
        let doc = if program.inputs.is_empty() {
            quote!(#[doc = " One sample: takes the measurements, gives the estimate."])
        } else {
            quote! {
                #[doc = " One sample: takes the measurements and the inputs applied since the previous call,"]
                #[doc = " gives the estimate."]
            }
        };
        let ignored = [("measurements", !step.reach.measurements), ("inputs", !step.reach.inputs && inputs.is_some())];
        let ignored = ignored.iter().filter(|(_, is)| *is).map(|(name, _)| ident(name));
        let work = (step.reach.work > Access::None).then(|| quote!(let mut work = Work::EMPTY;));
        let statements = self.statements(&step.items);
        let estimates = program.estimates.iter().map(|(field, value)| {
            let (name, value) = (ident(&field.name), self.value(*value));
            quote!(#name: #value,)
        });
        let status = self.value(program.status);
        quote! {
            #doc
            pub fn step(&mut self, measurements: Measurements #inputs) -> Estimate {
                #(let _ = #ignored;)*
                #work
                #statements
                Estimate { #(#estimates)* status: #status }
            }
        }
    }

    /// A function that holds a part of the step.
    fn part(&self, at: usize, part: &Function) -> TokenStream {
        let row = self.plan.row_of(part);
        let doc = match part.row {
            Some(table) => format!(" Part {} of a step, for one row of `{}`.", at + 1, self.plan.names.table(table)),
            None => format!(" Part {} of a step.", at + 1),
        };
        let name = ident(&names::part(at));
        let Reach { state, work, measurements, inputs } = part.reach;
        let program = self.plan.program;
        let parameters = [
            self.receiver(state),
            measurements.then(|| self.struct_parameter("measurements", "Measurements", program.measurements.len())),
            inputs.then(|| self.struct_parameter("inputs", "Inputs", program.inputs.len())),
            reference(work).map(|by| quote!(work: #by Work)),
            row.map(|table| self.row_parameter(table)),
        ];
        let parameters = parameters.into_iter().flatten();
        let statements = self.statements(&part.items);
        quote! {
            #[doc = #doc]
            fn #name(#(#parameters),*) { #statements }
        }
    }

    /// `self` as a part needs it.
    fn receiver(&self, access: Access) -> Option<TokenStream> {
        match access {
            Access::None => None,
            Access::Read if self.plan.state_bytes() <= SMALL => Some(quote!(self)),
            Access::Read => Some(quote!(&self)),
            Access::Write => Some(quote!(&mut self)),
        }
    }

    /// A struct of the interface, small ones by value.
    fn struct_parameter(&self, name: &str, r#type: &str, fields: usize) -> TokenStream {
        let (name, r#type) = (ident(name), ident(r#type));
        if fields * self.plan.float_bytes() <= BY_VALUE { quote!(#name: #r#type) } else { quote!(#name: &#r#type) }
    }

    /// The row, a narrow one by value.
    fn row_parameter(&self, table: TableId) -> TokenStream {
        let columns = self.plan.program.tables[usize::from(table.0)].columns.len();
        let by = (columns * self.plan.float_bytes() > BY_VALUE).then(|| quote!(&));
        let (scalar, width) = (scalar(self.plan), length(columns));
        quote!(gains: #by [#scalar; #width])
    }

    /// What generic code and `Default` need.
    fn implementation(&self) -> TokenStream {
        let program = self.plan.program;
        let inputs = if program.inputs.is_empty() { quote!(()) } else { quote!(Inputs) };
        let (pattern, argument) =
            if program.inputs.is_empty() { (quote!(()), None) } else { (quote!(inputs), Some(quote!(, inputs))) };
        let sample_time = constant::float(in_double(program.sample_time, program.scalar), Scalar::F64);
        quote! {
            impl Default for Observer {
                fn default() -> Self {
                    Self::new()
                }
            }
            impl ::deadbeat::Observer for Observer {
                type Measurements = Measurements;
                type Inputs = #inputs;
                type Estimate = Estimate;
                const SAMPLE_TIME: f64 = #sample_time;
                fn step(&mut self, measurements: Measurements, #pattern: #inputs) -> Estimate {
                    Self::step(self, measurements #argument)
                }
            }
        }
    }
}

/// `&` or `&mut`, nothing if it is not used.
fn reference(access: Access) -> Option<TokenStream> {
    match access {
        Access::None => None,
        Access::Read => Some(quote!(&)),
        Access::Write => Some(quote!(&mut)),
    }
}

/// The double of the same decimal digits: nearer to the specification's decimal than the float is.
fn in_double(value: f64, scalar: Scalar) -> f64 {
    literal::float(value, scalar).parse().unwrap_or_else(|_| unreachable!("a literal reads back"))
}

/// One line of documentation; nothing if there is nothing to say.
fn documentation(text: &str) -> Option<TokenStream> {
    let doc = format!(" {}", markdown(text));
    (!text.is_empty()).then(|| quote!(#[doc = #doc]))
}

/// The float type.
pub fn scalar(plan: &Plan) -> TokenStream {
    let scalar = ident(&plan.program.scalar.to_string());
    quote!(#scalar)
}

/// The length of an array.
fn length(length: usize) -> TokenStream {
    match u32::try_from(length) {
        Ok(length) => constant::index(length),
        Err(_) => unreachable!("tables and structs are shorter than 2^32"),
    }
}

/// The place of a table.
pub fn table_id(at: usize) -> TableId {
    match u16::try_from(at) {
        Ok(at) => TableId(at),
        Err(_) => unreachable!("a Program numbers its tables by u16"),
    }
}
