//! One operation as one Rust expression.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::plan::Place;
use super::item::integer_name;
use super::{Rust, constant, ident};
use crate::program::{CellId, CellKind, Function, Kind, Op, Status, TableId, Value};

impl Rust<'_> {
    /// A value where it is used.
    pub fn value(&self, value: Value) -> TokenStream {
        match self.plan.place(value) {
            Place::Constant(op) => self.operation(op),
            Place::Local | Place::Work | Place::Flag(_) => self.variable(value),
        }
    }

    /// A value that is not a constant, by its name.
    pub fn variable(&self, value: Value) -> TokenStream {
        let name = ident(&self.plan.names.temporary(value));
        match self.plan.place(value) {
            Place::Work => quote!(work.#name),
            Place::Flag(at) => {
                let at = proc_macro2::Literal::usize_unsuffixed(at);
                quote!(work.flags[#at])
            }
            Place::Constant(_) | Place::Local => quote!(#name),
        }
    }

    /// The right-hand side of a definition.
    pub fn operation(&self, op: &Op) -> TokenStream {
        if let [a, b] = op.operands()[..]
            && a == b
            && let Some(twice) = self.same_operands(op, a)
        {
            return twice;
        }
        match op {
            Op::Float(x) => constant::float(*x, self.plan.program.scalar),
            Op::Bool(truth) => quote!(#truth),
            Op::Index(number) => constant::index(*number),
            Op::Status(status) => self::status(*status),
            Op::Neg(a) => self.prefix(&quote!(-), *a),
            Op::Not(a) => self.prefix(&quote!(!), *a),
            Op::Add(a, b) => self.infix(*a, &quote!(+), *b),
            Op::Sub(a, b) => self.infix(*a, &quote!(-), *b),
            Op::Mul(a, b) => self.infix(*a, &quote!(*), *b),
            Op::Div(a, b) => self.infix(*a, &quote!(/), *b),
            Op::Less(a, b) | Op::IndexLess(a, b) => self.infix(*a, &quote!(<), *b),
            Op::LessEqual(a, b) => self.infix(*a, &quote!(<=), *b),
            Op::IndexEqual(a, b) => self.infix(*a, &quote!(==), *b),
            Op::And(a, b) => self.infix(*a, &quote!(&&), *b),
            Op::Or(a, b) => self.infix(*a, &quote!(||), *b),
            Op::Call(function, arguments) => self.call(*function, arguments),
            Op::InRange { value, low, high } => self.in_range(*value, *low, *high),
            Op::Select { condition, then, otherwise } => self.select(*condition, *then, *otherwise),
            Op::Advance { slot, len } => self.advance(*slot, *len),
            Op::Retreat { slot, len } => self.retreat(*slot, *len),
            Op::CountUp { count, max } => self.count_up(*count, *max),
            Op::CountDown(count) => self.count_down(*count),
            Op::AtMost { value, max } => self.at_most(*value, *max),
            Op::Remainder { value, modulus } => self.remainder(*value, *modulus),
            Op::ToFloat(index) => self.to_float(*index),
            Op::SignedToFloat(index) => self.math(&format!("{}_from_signed", self.plan.program.scalar), &[*index]),
            Op::FromFloat(x) => self.math(&format!("index_from_{}", self.plan.program.scalar), &[*x]),
            Op::WrapAdd(a, b) => self.math("wrap_add", &[*a, *b]),
            Op::Difference { a, b, bits } => self.math(&format!("difference_{bits}"), &[*a, *b]),
            Op::Given(at) => field(&quote!(estimate), &self.plan.program.estimates[usize::from(*at)].0.name),
            Op::Vouched => quote!(estimate.status == Status::Converged),
            Op::Count(at) => self.count(*at),
            Op::Measurement(at) => field(&quote!(measurements), &self.plan.program.measurements[usize::from(*at)].name),
            Op::Input(at) => field(&quote!(inputs), &self.plan.program.inputs[usize::from(*at)].name),
            Op::Cell(cell) => field(&quote!(self), &self.plan.program.cells[usize::from(cell.0)].name),
            Op::Ring { ring, slot } => self.read_element(*ring, *slot),
            Op::Lookup { table, row, column } => self.lookup(*table, *row, *column),
            Op::Gain { column } => {
                let column = proc_macro2::Literal::u16_unsuffixed(*column);
                quote!(gains[#column])
            }
        }
    }

    /// `-a`, `!a`.
    fn prefix(&self, sign: &TokenStream, a: Value) -> TokenStream {
        let a = self.value(a);
        quote!(#sign #a)
    }

    /// `a + b`.
    fn infix(&self, a: Value, sign: &TokenStream, b: Value) -> TokenStream {
        let (a, b) = (self.value(a), self.value(b));
        quote!(#a #sign #b)
    }

    /// The operations on one value twice that clippy takes for mistakes, `a - a` and the like: the
    /// second operand gets a name of its own.
    fn same_operands(&self, op: &Op, a: Value) -> Option<TokenStream> {
        let sign = match op {
            Op::Sub(..) => quote!(-),
            Op::Div(..) => quote!(/),
            Op::Less(..) | Op::IndexLess(..) => quote!(<),
            Op::LessEqual(..) => quote!(<=),
            Op::IndexEqual(..) => quote!(==),
            Op::And(..) => quote!(&&),
            Op::Or(..) => quote!(||),
            _ => return None,
        };
        let a = self.value(a);
        Some(quote!({ let same = #a; #a #sign same }))
    }

    /// `math::sin_f32(a)`.
    fn call(&self, function: Function, arguments: &[Value]) -> TokenStream {
        self.math(&format!("{}_{}", function.name(), self.plan.program.scalar), arguments)
    }

    /// A function of the runtime.
    fn math(&self, name: &str, arguments: &[Value]) -> TokenStream {
        let name = ident(name);
        let arguments = arguments.iter().map(|argument| self.value(*argument));
        quote!(::deadbeat::math::#name(#(#arguments),*))
    }

    /// A measurement that is a count.
    fn count(&self, at: u16) -> TokenStream {
        let measured = &self.plan.program.measurements[usize::from(at)];
        let count = field(&quote!(measurements), &measured.name);
        match measured.kind {
            Kind::Count { bits, signed } => extended(bits, signed, &count),
            Kind::Float | Kind::Index => count,
        }
    }

    /// An element of a ring.
    fn read_element(&self, ring: CellId, slot: Value) -> TokenStream {
        let element = self.element(ring, slot);
        match self.plan.program.cells[usize::from(ring.0)].kind {
            CellKind::Counts { bits, .. } => extended(bits, false, &element),
            _ => element,
        }
    }

    /// `(low..=high).contains(&a)`.
    fn in_range(&self, value: Value, low: f64, high: f64) -> TokenStream {
        let scalar = self.plan.program.scalar;
        let (low, high) = (constant::float(low, scalar), constant::float(high, scalar));
        let value = self.value(value);
        quote!((#low..=#high).contains(&#value))
    }

    /// `if condition { then } else { otherwise }`.
    fn select(&self, condition: Value, then: Value, otherwise: Value) -> TokenStream {
        let condition = self.value(condition);
        if then == otherwise {
            return self.value(then);
        }
        let index = |value| match self.plan.place(value) {
            Place::Constant(Op::Index(number)) => Some(*number),
            _ => None,
        };
        if (index(then), index(otherwise)) == (Some(1), Some(0)) {
            return quote!(usize::from(#condition));
        }
        if (index(then), index(otherwise)) == (Some(0), Some(1)) {
            return quote!(usize::from(!#condition));
        }
        let (then, otherwise) = (self.value(then), self.value(otherwise));
        quote!(if #condition { #then } else { #otherwise })
    }

    /// The next slot of a ring.
    fn advance(&self, slot: Value, len: u32) -> TokenStream {
        self.bounded(slot, len - 1, |slot, last| quote!(if #slot < #last { #slot + 1 } else { 0 }))
    }

    /// The slot before. Without a comparison: the compiler sees the bound whatever it knows of
    /// `slot`, and drops the check of an index that a loop carries.
    fn retreat(&self, slot: Value, len: u32) -> TokenStream {
        self.bounded(slot, len - 1, |slot, last| quote!(#slot.wrapping_sub(1).min(#last)))
    }

    /// One more, up to the end of the count.
    fn count_up(&self, count: Value, max: u32) -> TokenStream {
        self.bounded(count, max, |count, max| quote!(if #count < #max { #count + 1 } else { #max }))
    }

    /// The smaller of the two.
    fn at_most(&self, value: Value, max: u32) -> TokenStream {
        self.bounded(value, max, |value, max| quote!(#value.min(#max)))
    }

    /// What is left of a division.
    fn remainder(&self, value: Value, modulus: u32) -> TokenStream {
        let (value, modulus) = (self.value(value), constant::index(modulus));
        quote!(#value % #modulus)
    }

    /// A form with a bound; a bound of 0 leaves nothing to decide, and a comparison with it would
    /// be a mistake to the compiler.
    fn bounded(
        &self,
        value: Value,
        bound: u32,
        form: impl FnOnce(TokenStream, TokenStream) -> TokenStream,
    ) -> TokenStream {
        if bound == 0 { quote!(0) } else { form(self.value(value), constant::index(bound)) }
    }

    /// One less, down to 0.
    fn count_down(&self, count: Value) -> TokenStream {
        let count = self.value(count);
        quote!(#count.saturating_sub(1))
    }

    /// The index as a float.
    fn to_float(&self, index: Value) -> TokenStream {
        self.math(&format!("{}_from_index", self.plan.program.scalar), &[index])
    }

    /// An element of a table.
    fn lookup(&self, table: TableId, row: Value, column: u16) -> TokenStream {
        let row = self.index(row, self.plan.program.tables[usize::from(table.0)].rows.len());
        let table = ident(self.plan.names.table(table));
        let column = proc_macro2::Literal::u16_unsuffixed(column);
        quote!(#table[#row][#column])
    }
}

/// An integer as an index.
fn extended(bits: u8, signed: bool, count: &TokenStream) -> TokenStream {
    let name = ident(&format!("index_from_{}", integer_name(bits, signed)));
    quote!(::deadbeat::math::#name(#count))
}

/// `self.name`.
pub fn field(of: &TokenStream, name: &str) -> TokenStream {
    let name = ident(name);
    quote!(#of.#name)
}

/// A status.
pub fn status(status: Status) -> TokenStream {
    match status {
        Status::Converging => quote!(Status::Converging),
        Status::Converged => quote!(Status::Converged),
        Status::Coasting => quote!(Status::Coasting),
    }
}
