//! Fuses a gain with the product, and a product with the sum, that are its only uses.

use super::super::super::{Op, Value};
use super::super::instruction::{Class, Opcode, Operand, Place};
use super::Selection;

/// An operation that has not been carried out because its one use may include it.
#[derive(Clone, Copy)]
pub(super) enum Waiting {
    Gain(u16),
    Product(Place, Place),
    GainProduct(u16, Place),
}

impl Selection<'_> {
    /// Where the value is; carries it out if it waits.
    pub fn place(&mut self, value: Value) -> Place {
        match self.waiting.remove(&value) {
            None => {}
            Some(Waiting::Gain(column)) => {
                self.compute(value, Class::Float, Opcode::Gain, [Operand::Number(column)]);
            }
            Some(Waiting::Product(a, b)) => {
                self.compute(value, Class::Float, Opcode::Mul, [a, b].map(Operand::Read));
            }
            Some(Waiting::GainProduct(column, a)) => {
                let operands = [Operand::Number(column), Operand::Read(a)];
                self.compute(value, Class::Float, Opcode::GainMul, operands);
            }
        }
        self.places[&value]
    }

    /// `a * b`, with a gain that waits for it; waits itself if it is used once.
    pub fn product(&mut self, value: Value, a: Value, b: Value) {
        let product = match (self.waiting.get(&a), self.waiting.get(&b)) {
            (Some(Waiting::Gain(column)), _) => (Some((*column, a)), b),
            (_, Some(Waiting::Gain(column))) => (Some((*column, b)), a),
            _ => (None, a),
        };
        let waiting = match product {
            (Some((column, gain)), other) => {
                self.waiting.remove(&gain);
                Waiting::GainProduct(column, self.place(other))
            }
            (None, _) => Waiting::Product(self.place(a), self.place(b)),
        };
        self.wait(value, waiting);
        if !self.once(value) {
            self.place(value);
        }
    }

    /// `a + b`, with a product that waits for it.
    pub fn addition(&mut self, value: Value, a: Value, b: Value) {
        let (product, other) = if self.is_product(b) { (b, a) } else { (a, b) };
        match self.waiting.get(&product).copied() {
            Some(Waiting::Product(x, y)) => {
                self.waiting.remove(&product);
                let operands = [Operand::Read(x), Operand::Read(y), self.argument(other)];
                self.compute(value, Class::Float, Opcode::MulAdd, operands);
            }
            Some(Waiting::GainProduct(column, x)) => {
                self.waiting.remove(&product);
                let operands = [Operand::Number(column), Operand::Read(x), self.argument(other)];
                self.compute(value, Class::Float, Opcode::GainMulAdd, operands);
            }
            _ => self.plain(value, Class::Float, Opcode::Add, &Op::Add(a, b), &[]),
        }
    }

    /// `a - b`, with a product that waits for it.
    pub fn difference(&mut self, value: Value, a: Value, b: Value) {
        if let Some(Waiting::Product(x, y)) = self.waiting.get(&b).copied() {
            self.waiting.remove(&b);
            let operands = [Operand::Read(x), Operand::Read(y), self.argument(a)];
            self.compute(value, Class::Float, Opcode::MulSub, operands);
        } else {
            self.plain(value, Class::Float, Opcode::Sub, &Op::Sub(a, b), &[]);
        }
    }

    pub fn is_product(&self, value: Value) -> bool {
        matches!(self.waiting.get(&value), Some(Waiting::Product(..) | Waiting::GainProduct(..)))
    }

    pub fn once(&self, value: Value) -> bool {
        self.uses.get(&value) == Some(&1)
    }

    pub fn wait(&mut self, value: Value, waiting: Waiting) {
        self.waiting.insert(value, waiting);
    }
}
