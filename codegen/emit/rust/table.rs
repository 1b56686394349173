//! The constants of the file: its tables, and the struct of what crosses between functions.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::plan::Place;
use super::super::text::markdown;
use super::item::{documentation, scalar};
use super::operation::status;
use super::{Rust, constant, ident};
use crate::program::{Status, Table, TableId, Type, Value};

impl Rust<'_> {
    /// A table; the layout writes its rows.
    pub fn table(&self, at: TableId, table: &Table) -> TokenStream {
        let title = documentation(if table.doc.is_empty() { "Gains, by column:" } else { &table.doc });
        let columns = table.columns.iter().enumerate().map(|(at, column)| {
            let doc = format!(" - `[{at}]` {}", markdown(column));
            quote!(#[doc = #doc])
        });
        let name = ident(self.plan.names.table(at));
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
    pub fn work(&self) -> TokenStream {
        if self.plan.crossing.is_empty() {
            return TokenStream::new();
        }
        let fields = self.plan.crossing.iter().filter(|value| matches!(self.plan.place(**value), Place::Work));
        let declared = fields.clone().map(|value| {
            let (name, r#type) = (ident(&self.plan.names.temporary(*value)), self.type_of(*value));
            quote!(#name: #r#type,)
        });
        let empty = fields.map(|value| {
            let (name, nothing) = (ident(&self.plan.names.temporary(*value)), self.nothing(*value));
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
}

/// The length of an array.
pub fn length(length: usize) -> TokenStream {
    match u32::try_from(length) {
        Ok(length) => constant::index(length),
        Err(_) => unreachable!("tables and structs are shorter than 2^32"),
    }
}
