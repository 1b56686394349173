//! The items of the file: what its users see, the tables, and the observer with its functions.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::plan::Plan;
use super::super::text::{RAW_COUNT, field as described, markdown};
use super::{Rust, constant, ident};
use crate::program::{Cell, CellKind, Field, Kind, Scalar, literal};

impl Rust<'_> {
    /// All items.
    pub fn items(&self) -> TokenStream {
        let tables = self.plan.program.read_tables().map(|(at, table)| self.table(at, table));
        let head = self.head();
        let work = self.work();
        let new = self.new_function();
        let start = self.plan.start().map(|start| self.start_at(start));
        let step = self.step(self.plan.step());
        let parts = self.plan.parts().map(|(at, of, part)| self.part(at, of, part));
        let implementation = self.implementation();
        quote! {
            #head
            #(#tables)*
            #work
            impl Observer {
                #new
                #start
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
        let (r#type, note) = match field.kind {
            Kind::Float => (scalar(self.plan), note),
            Kind::Count { bits, signed } => (integer(bits, signed), RAW_COUNT),
            Kind::Index => (integer(32, false), note),
        };
        let doc = format!(" {}", markdown(&described(field, note)));
        let name = ident(&field.name);
        quote!(#[doc = #doc] pub #name: #r#type,)
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
            CellKind::Counts { len, bits, .. } => {
                let (integer, len) = (integer(bits, false), constant::index(len));
                quote!([#integer; #len])
            }
        };
        quote!(#doc #name: #r#type,)
    }

    /// What generic code and `Default` need.
    fn implementation(&self) -> TokenStream {
        let program = self.plan.program;
        let inputs = if program.inputs.is_empty() { quote!(()) } else { quote!(Inputs) };
        let (pattern, argument) =
            if program.inputs.is_empty() { (quote!(()), None) } else { (quote!(inputs), Some(quote!(, inputs))) };
        let decimal = constant::float(in_double(program.sample_time, program.scalar), Scalar::F64);
        // Used in any case, so that a module that nobody exports gives no warning.
        let (sample_time, used) = match program.scalar {
            Scalar::F64 => (quote!(SAMPLE_TIME), None),
            Scalar::F32 => (
                decimal,
                Some(quote!(
                    const _: f32 = SAMPLE_TIME;
                )),
            ),
        };
        quote! {
            #used
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

/// The double of the same decimal digits: nearer to the specification's decimal than the float is.
fn in_double(value: f64, scalar: Scalar) -> f64 {
    literal::float(value, scalar).parse().unwrap_or_else(|_| unreachable!("a literal reads back"))
}

/// One line of documentation; nothing if there is nothing to say.
pub fn documentation(text: &str) -> Option<TokenStream> {
    let doc = format!(" {}", markdown(text));
    (!text.is_empty()).then(|| quote!(#[doc = #doc]))
}

/// An integer type.
fn integer(bits: u8, signed: bool) -> TokenStream {
    let name = ident(&integer_name(bits, signed));
    quote!(#name)
}

/// The name of an integer type.
pub fn integer_name(bits: u8, signed: bool) -> String {
    format!("{}{bits}", if signed { 'i' } else { 'u' })
}

/// The float type.
pub fn scalar(plan: &Plan) -> TokenStream {
    let scalar = ident(&plan.program.scalar.to_string());
    quote!(#scalar)
}
