//! Indices of rings and tables, so spelled that the compiler drops every check of them.
//!
//! A checked Program stays in bounds, but the compiler has to see it. It does for what a bounding
//! operation just gave, and for what a loop carries if every iteration bounds it anew by `min`.
//! Elsewhere (behind a comparison that it has simplified away, or in a function of its own) it
//! may not, and the index gets a `min` where it is used, which changes no value.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::plan::{Origin, Place};
use super::operation::field;
use super::{Rust, constant};
use crate::program::{Carried, CellId, CellKind, Op, Value};

impl Rust<'_> {
    /// An element of a ring.
    pub fn element(&self, ring: CellId, slot: Value) -> TokenStream {
        let cell = &self.plan.program.cells[usize::from(ring.0)];
        let len = match cell.kind {
            CellKind::Ring { len, .. } | CellKind::Counts { len, .. } => len as usize,
            CellKind::Float { .. } | CellKind::Index { .. } => 1,
        };
        let (name, slot) = (field(&quote!(self), &cell.name), self.index(slot, len));
        quote!(#name[#slot])
    }

    /// An index below `len`.
    pub fn index(&self, value: Value, len: usize) -> TokenStream {
        let spelled = self.value(value);
        match u32::try_from(len) {
            Ok(len) if !self.is_evident(value, len) => {
                let last = constant::index(len - 1);
                quote!(#spelled.min(#last))
            }
            _ => spelled,
        }
    }

    /// Whether the compiler sees that a value is below `len`.
    fn is_evident(&self, value: Value, len: u32) -> bool {
        self.is_here(value)
            && match self.plan.origin(value) {
                Origin::Op(Op::Select { then, otherwise, .. }) => {
                    self.is_evident(*then, len) && self.is_evident(*otherwise, len)
                }
                Origin::Op(op) => bound(op).is_some_and(|bound| bound < len),
                Origin::Carried(Carried { start, next, .. }) => {
                    self.is_evident(*start, len) && self.is_bounded_anew(*next, len)
                }
            }
    }

    /// Whether a value is spelled as the `min` of something and less than `len`.
    fn is_bounded_anew(&self, value: Value, len: u32) -> bool {
        match self.plan.origin(value) {
            Origin::Op(op @ (Op::Index(_) | Op::Retreat { .. } | Op::AtMost { .. })) => {
                self.is_here(value) && bound(op).is_some_and(|bound| bound < len)
            }
            _ => false,
        }
    }

    /// Whether the function that uses a value defines it.
    fn is_here(&self, value: Value) -> bool {
        matches!(self.plan.place(value), Place::Local | Place::Constant(_))
    }
}

/// The largest result of an operation, if its form shows one.
fn bound(op: &Op) -> Option<u32> {
    match *op {
        Op::Index(number) => Some(number),
        Op::Advance { len, .. } | Op::Retreat { len, .. } => Some(len - 1),
        Op::CountUp { max, .. } | Op::AtMost { max, .. } => Some(max),
        Op::Remainder { modulus, .. } => modulus.checked_sub(1),
        _ => None,
    }
}
