//! How large an index can get, for any content of the cells.
//!
//! Every operation bounds its result by a constant, its operand's bound or the larger of two, so
//! the bounds of what a loop carries are constants of its body: iterating from the start's bounds
//! upwards ends.

use std::collections::HashMap;

use super::super::{Loop, Op, Program, Statement, Value};
use super::{At, CheckError, Flaw};

/// Whether every slot and row is below its end. The Program's types are known to be right.
pub(super) fn check(program: &Program) -> Result<(), CheckError> {
    let mut bounds = Bounds { program, known: HashMap::new() };
    bounds.body(program.init_at.as_deref().unwrap_or_default())?;
    bounds.body(&program.body)
}

/// The largest number that each index can be.
struct Bounds<'a> {
    program: &'a Program,
    known: HashMap<Value, u32>,
}

impl Bounds<'_> {
    /// Bounds every value of the statements and checks each slot and row.
    fn body(&mut self, body: &[Statement]) -> Result<(), CheckError> {
        for statement in body {
            match statement {
                Statement::Section(_) | Statement::SetCell { .. } => {}
                Statement::Let { value, op } => {
                    self.reads(op).at(self.program, statement)?;
                    self.known.insert(*value, self.bound(op));
                }
                Statement::SetRing { ring, slot, .. } => {
                    let len = self.context().ring(*ring);
                    len.and_then(|len| self.below(*slot, len.into())).at(self.program, statement)?;
                }
                Statement::Loop(inner) => {
                    self.settle(inner);
                    self.body(&inner.body)?;
                }
            }
        }
        Ok(())
    }

    /// Finds the bounds of what a loop carries: the smallest that no iteration exceeds.
    fn settle(&mut self, inner: &Loop) {
        for carried in &inner.carried {
            self.known.insert(carried.value, self.of(carried.start));
        }
        loop {
            for statement in &inner.body {
                if let Statement::Let { value, op } = statement {
                    self.known.insert(*value, self.bound(op));
                }
            }
            let mut settled = true;
            for carried in &inner.carried {
                let next = self.of(carried.next);
                if next > self.of(carried.value) {
                    self.known.insert(carried.value, next);
                    settled = false;
                }
            }
            if settled {
                return;
            }
        }
    }

    /// The bound of an operation's result; anything for what is not an index.
    fn bound(&self, op: &Op) -> u32 {
        match *op {
            Op::Index(number) => number,
            Op::Advance { len, .. } | Op::Retreat { len, .. } => len - 1,
            Op::CountUp { max, .. } => max,
            Op::Remainder { modulus, .. } => modulus.saturating_sub(1),
            Op::AtMost { value, max } => self.of(value).min(max),
            Op::CountDown(value) => self.of(value),
            Op::Select { then, otherwise, .. } => self.of(then).max(self.of(otherwise)),
            _ => u32::MAX,
        }
    }

    /// The bound of a value.
    fn of(&self, value: Value) -> u32 {
        self.known.get(&value).copied().unwrap_or(u32::MAX)
    }

    /// Whether what the operation reads exists.
    fn reads(&self, op: &Op) -> Result<(), Flaw> {
        match *op {
            Op::Ring { ring, slot } => self.below(slot, self.context().ring(ring)?.into()),
            Op::Lookup { table, row, .. } => self.below(row, self.context().table(table)?.rows.len() as u64),
            _ => Ok(()),
        }
    }

    /// Whether the value is below `len` whatever happens.
    fn below(&self, value: Value, len: u64) -> Result<(), Flaw> {
        let at_most = self.of(value);
        if u64::from(at_most) < len { Ok(()) } else { Err(Flaw::OutOfBounds { value, at_most, len }) }
    }

    fn context(&self) -> super::typing::Context<'_> {
        super::typing::Context::of(self.program, None)
    }
}
