//! The observer's functions.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::plan::{Access, Function, Reach};
use super::item::scalar;
use super::table::length;
use super::{Rust, constant, ident};
use crate::names;
use crate::program::{CellKind, Kind, TableId};

/// The largest size in bytes that clippy lets a function take by value.
pub const BY_VALUE: usize = 256;

/// The largest size in bytes that clippy wants to be taken by value.
const SMALL: usize = 8;

impl Rust<'_> {
    /// The functions that start.
    pub fn new_function(&self) -> TokenStream {
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
            CellKind::Counts { len, init, .. } => {
                let (init, len) = (constant::index(init), constant::index(len));
                quote!([#init; #len])
            }
        }
    }

    /// The start from an estimate.
    pub fn start_at(&self, start: &Function) -> TokenStream {
        let ignored = (!start.reach.given).then(|| quote!(let _ = estimate;));
        let work = (start.reach.work > Access::None).then(|| quote!(let mut work = Work::EMPTY;));
        let statements = self.statements(&start.items);
        let parameter = self.estimate_parameter();
        let argument = self.estimate_argument();
        quote! {
            /// The state behind the call that gave an estimate: the first step is one sample time later. A status of
            /// [`Status::Converged`] vouches for it, and the first step answers that status at once.
            #[must_use]
            pub fn at(estimate: Estimate) -> Self {
                let mut observer = Self::new();
                observer.start(#argument);
                observer
            }
            /// Sets what an estimate says of the state.
            fn start(&mut self, #parameter) {
                #ignored
                #work
                #statements
            }
        }
    }

    /// The step.
    pub fn step(&self, step: &Function) -> TokenStream {
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
            match field.kind {
                Kind::Index => quote!(#name: ::deadbeat::math::u32_from_index(#value),),
                Kind::Float | Kind::Count { .. } => quote!(#name: #value,),
            }
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

    /// A function that holds a part of the step or of the start.
    pub fn part(&self, at: usize, of: &str, part: &Function) -> TokenStream {
        let row = self.plan.row_of(part);
        let doc = match part.row {
            Some(table) => format!(" Part {} of {of}, for one row of `{}`.", at + 1, self.plan.names.table(table)),
            None => format!(" Part {} of {of}.", at + 1),
        };
        let name = ident(&names::part(at));
        let Reach { state, work, measurements, inputs, given } = part.reach;
        let program = self.plan.program;
        let parameters = [
            self.receiver(state),
            measurements.then(|| self.struct_parameter("measurements", "Measurements", program.measurements.len())),
            inputs.then(|| self.struct_parameter("inputs", "Inputs", program.inputs.len())),
            given.then(|| self.estimate_parameter()),
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

    /// The estimate that a start is given; its status counts as a number.
    fn estimate_parameter(&self) -> TokenStream {
        self.struct_parameter("estimate", "Estimate", self.plan.program.estimates.len() + 1)
    }

    /// The row, a narrow one by value.
    fn row_parameter(&self, table: TableId) -> TokenStream {
        let columns = self.plan.program.tables[usize::from(table.0)].columns.len();
        let by = (columns * self.plan.float_bytes() > BY_VALUE).then(|| quote!(&));
        let (scalar, width) = (scalar(self.plan), length(columns));
        quote!(gains: #by [#scalar; #width])
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
