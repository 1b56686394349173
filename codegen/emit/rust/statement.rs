//! The statements of one function.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::plan::{Access, Place, Reach};
use super::super::split::Item;
use super::super::text::plain;
use super::function::BY_VALUE;
use super::item::{integer_name, scalar};
use super::operation::field;
use super::table::length;
use super::{Rust, ident};
use crate::names;
use crate::program::{Carried, CellKind, Loop, Op, Statement, TableId, Type, Value};

impl Rust<'_> {
    /// The statements, each below the heading that stands before it.
    pub fn statements(&self, items: &[Item]) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut heading = TokenStream::new();
        for item in items {
            if let Item::Plain(Statement::Section(text)) = item {
                heading = self.heading(text);
                continue;
            }
            let statement = self.statement(item);
            if !statement.is_empty() {
                tokens.extend(std::mem::take(&mut heading));
                tokens.extend(statement);
            }
        }
        tokens
    }

    /// A heading as documentation of the next statement, of which the layout makes a comment.
    fn heading(&self, text: &str) -> TokenStream {
        let text = format!(" {}", plain(text));
        if self.laid_out { quote!(#[doc = #text]) } else { TokenStream::new() }
    }

    /// One statement.
    fn statement(&self, item: &Item) -> TokenStream {
        match item {
            Item::Plain(Statement::Let { value, op }) => self.definition(*value, op),
            Item::Plain(Statement::SetCell { cell, value }) => {
                let cell = field(&quote!(self), &self.plan.program.cells[usize::from(cell.0)].name);
                let value = self.value(*value);
                quote!(#cell = #value;)
            }
            Item::Plain(Statement::SetRing { ring, slot, value }) => {
                let (element, value) = (self.element(*ring, *slot), self.value(*value));
                match self.plan.program.cells[usize::from(ring.0)].kind {
                    CellKind::Counts { bits, .. } => {
                        let narrowed = ident(&format!("{}_from_index", integer_name(bits, false)));
                        quote!(#element = ::deadbeat::math::#narrowed(#value);)
                    }
                    _ => quote!(#element = #value;),
                }
            }
            Item::Loop { source, items } => self.looped(source, items),
            Item::Call(callee) => self.call_part(*callee),
            Item::Plain(Statement::Section(_) | Statement::Loop(_)) => TokenStream::new(),
        }
    }

    /// `let t2 = t0 + t1;`, nothing for a constant.
    fn definition(&self, value: Value, op: &Op) -> TokenStream {
        let operation = self.operation(op);
        let name = self.variable(value);
        match (self.plan.place(value), op) {
            (Place::Constant(_), _) => TokenStream::new(),
            (Place::Local, Op::Float(_) | Op::Index(_)) => {
                let r#type = self.type_of(value);
                quote!(let #name: #r#type = #operation;)
            }
            (Place::Local, _) => quote!(let #name = #operation;),
            (Place::Work | Place::Flag(_), _) => quote!(#name = #operation;),
        }
    }

    /// A loop over the rows of its table.
    fn looped(&self, source: &Loop, items: &[Item]) -> TokenStream {
        let starts = source.carried.iter().map(|carried| self.start(carried));
        let nexts = source.carried.iter().map(|carried| self.next(carried));
        let body = self.statements(items);
        if !self.plan.program.is_read(source.table) {
            let rows = length(self.plan.program.tables[usize::from(source.table.0)].rows.len());
            return quote!(#(#starts)* for _ in 0..#rows { #body #(#nexts)* });
        }
        let row = if self.plan.uses_row(items) { quote!(gains) } else { quote!(_) };
        let table = ident(self.plan.names.table(source.table));
        quote!(#(#starts)* for #row in &#table { #body #(#nexts)* })
    }

    /// The declaration of a carried value.
    fn start(&self, carried: &Carried) -> TokenStream {
        let name = self.variable(carried.value);
        let start = self.value(carried.start);
        if let Place::Local = self.plan.place(carried.value) {
            let r#type = self.type_of(carried.value);
            let changes = (carried.next != carried.value).then(|| quote!(mut));
            quote!(let #changes #name: #r#type = #start;)
        } else {
            quote!(#name = #start;)
        }
    }

    /// What a carried value is in the next iteration.
    fn next(&self, carried: &Carried) -> TokenStream {
        if carried.next == carried.value {
            return TokenStream::new();
        }
        let (name, next) = (self.variable(carried.value), self.value(carried.next));
        quote!(#name = #next;)
    }

    /// The call of a function that holds a part of the step.
    fn call_part(&self, callee: usize) -> TokenStream {
        let function = &self.plan.functions[callee];
        let name = ident(&names::part(callee));
        let Reach { state, work, measurements, inputs, given } = function.reach;
        let arguments = [
            measurements.then(|| self.struct_argument(&quote!(measurements), self.plan.program.measurements.len())),
            inputs.then(|| self.struct_argument(&quote!(inputs), self.plan.program.inputs.len())),
            given.then(|| quote!(estimate)),
            work_argument(work, function.row.is_some()),
            self.plan.row_of(function).map(|table| self.row_argument(table)),
        ];
        let arguments = arguments.into_iter().flatten();
        let receiver = if state == Access::None { quote!(Self::) } else { quote!(self.) };
        quote!(#receiver #name(#(#arguments),*);)
    }

    /// A struct of the interface, small ones by value.
    fn struct_argument(&self, name: &TokenStream, fields: usize) -> TokenStream {
        if fields * self.plan.float_bytes() <= BY_VALUE { name.clone() } else { quote!(&#name) }
    }

    /// The estimate that a start is given.
    pub fn estimate_argument(&self) -> TokenStream {
        self.struct_argument(&quote!(estimate), self.plan.program.estimates.len() + 1)
    }

    /// The row, a narrow one by value.
    fn row_argument(&self, table: TableId) -> TokenStream {
        let columns = self.plan.program.tables[usize::from(table.0)].columns.len();
        if columns * self.plan.float_bytes() <= BY_VALUE { quote!(*gains) } else { quote!(gains) }
    }

    /// The type of a value.
    pub fn type_of(&self, value: Value) -> TokenStream {
        match self.plan.r#type(value) {
            Type::Float => scalar(self.plan),
            Type::Index => quote!(usize),
            Type::Bool => quote!(bool),
            Type::Status => quote!(Status),
        }
    }
}

/// The values that cross; inside a part they come as a reference.
fn work_argument(access: Access, nested: bool) -> Option<TokenStream> {
    match access {
        Access::None => None,
        _ if nested => Some(quote!(work)),
        Access::Read => Some(quote!(&work)),
        Access::Write => Some(quote!(&mut work)),
    }
}
