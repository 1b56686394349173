//! The instruction of each operation.

use super::super::super::{CellId, CellKind, Op, Value};
use super::super::instruction::{Class, Content, Instruction, Opcode, Operand, Place};
use super::Selection;
use super::fuse::Waiting;

impl Selection<'_> {
    /// The instruction that computes the value, if it needs one now.
    pub fn define(&mut self, value: Value, op: &Op) {
        match op {
            Op::Float(x) => self.constant(value, Class::Float, x.to_bits()),
            Op::Bool(truth) => self.constant(value, Class::Word, u64::from(*truth)),
            Op::Status(status) => self.constant(value, Class::Word, *status as u64),
            Op::Index(number) => self.constant(value, Class::Word, u64::from(*number)),
            Op::Measurement(field) => self.alias(value, Class::Float, Content::Measurement(*field)),
            Op::Count(field) => self.alias(value, Class::Word, Content::Measurement(*field)),
            Op::Given(field) => self.alias(value, Class::Float, Content::Given(*field)),
            Op::Vouched => self.alias(value, Class::Word, Content::Vouched),
            Op::Input(field) => self.alias(value, Class::Float, Content::Input(*field)),
            Op::Cell(cell) => self.read(value, *cell),
            Op::Gain { column } if self.once(value) => self.wait(value, Waiting::Gain(*column)),
            Op::Gain { column } => {
                self.compute(value, Class::Float, Opcode::Gain, [Operand::Number(*column)]);
            }
            Op::Mul(a, b) => self.product(value, *a, *b),
            Op::Add(a, b) => self.addition(value, *a, *b),
            Op::Sub(a, b) => self.difference(value, *a, *b),
            Op::Ring { ring, slot } => {
                let operands = [Operand::ReadRing(*ring), self.argument(*slot)];
                match self.program.cells[usize::from(ring.0)].kind {
                    CellKind::Counts { .. } => self.compute(value, Class::Word, Opcode::ReadCounts, operands),
                    _ => self.compute(value, Class::Float, Opcode::ReadRing, operands),
                }
            }
            Op::Lookup { table, row, column } => {
                let operands = [Operand::Number(table.0), self.argument(*row), Operand::Number(*column)];
                self.compute(value, Class::Float, Opcode::Lookup, operands);
            }
            Op::Call(function, arguments) => {
                let a = self.argument(arguments[0]);
                let b = arguments.get(1).map_or(a, |b| self.argument(*b));
                let operands = [Operand::Number(*function as u16), a, b];
                self.compute(value, Class::Float, Opcode::Call, operands);
            }
            Op::Select { then, .. } => {
                let class = self.place(*then).class;
                let opcode = match class {
                    Class::Float => Opcode::SelectFloat,
                    Class::Word => Opcode::SelectWord,
                };
                self.plain(value, class, opcode, op, &[]);
            }
            Op::Neg(_) => self.plain(value, Class::Float, Opcode::Neg, op, &[]),
            Op::Div(..) => self.plain(value, Class::Float, Opcode::Div, op, &[]),
            Op::Less(..) => self.plain(value, Class::Word, Opcode::Less, op, &[]),
            Op::LessEqual(..) => self.plain(value, Class::Word, Opcode::LessEqual, op, &[]),
            Op::InRange { low, high, .. } => {
                let limits = [*low, *high].map(|x| Place::constant(Class::Float, x.to_bits()));
                self.plain(value, Class::Word, Opcode::InRange, op, &limits);
            }
            Op::And(..) => self.plain(value, Class::Word, Opcode::And, op, &[]),
            Op::Or(..) => self.plain(value, Class::Word, Opcode::Or, op, &[]),
            Op::Not(_) => self.plain(value, Class::Word, Opcode::Not, op, &[]),
            Op::IndexLess(..) => self.plain(value, Class::Word, Opcode::IndexLess, op, &[]),
            Op::IndexEqual(..) => self.plain(value, Class::Word, Opcode::IndexEqual, op, &[]),
            Op::Advance { len, .. } => self.limited(value, Opcode::Advance, op, *len),
            Op::Retreat { len, .. } => self.limited(value, Opcode::Retreat, op, *len),
            Op::CountUp { max, .. } => self.limited(value, Opcode::CountUp, op, *max),
            Op::AtMost { max, .. } => self.limited(value, Opcode::AtMost, op, *max),
            Op::Remainder { modulus, .. } => self.limited(value, Opcode::Remainder, op, *modulus),
            Op::CountDown(_) => self.plain(value, Class::Word, Opcode::CountDown, op, &[]),
            Op::ToFloat(_) => self.plain(value, Class::Float, Opcode::ToFloat, op, &[]),
            Op::SignedToFloat(_) => self.plain(value, Class::Float, Opcode::SignedToFloat, op, &[]),
            Op::FromFloat(_) => self.plain(value, Class::Word, Opcode::FromFloat, op, &[]),
            Op::WrapAdd(..) => self.plain(value, Class::Word, Opcode::WrapAdd, op, &[]),
            Op::Difference { bits, .. } => self.limited(value, Opcode::Difference, op, (*bits).into()),
        }
    }

    /// The value as an argument.
    pub fn argument(&mut self, value: Value) -> Operand {
        Operand::Read(self.place(value))
    }

    /// The value is a constant.
    pub fn constant(&mut self, value: Value, class: Class, bits: u64) {
        self.places.insert(value, Place::constant(class, bits));
    }

    /// The value does not change during a step.
    pub fn alias(&mut self, value: Value, class: Class, content: Content) {
        self.places.insert(value, Place { class, content });
    }

    /// The value is what the cell holds now; the cell may change while the value is in use.
    pub fn read(&mut self, value: Value, cell: CellId) {
        let class = match self.program.cells[usize::from(cell.0)].kind {
            CellKind::Index { .. } => Class::Word,
            CellKind::Float { .. } | CellKind::Ring { .. } | CellKind::Counts { .. } => Class::Float,
        };
        let to = Place { class, content: Content::Value(value) };
        self.copy(to, Place { class, content: Content::Cell(cell) });
        self.places.insert(value, to);
    }

    /// An operation whose operands are the instruction's, followed by these.
    pub fn plain(&mut self, value: Value, class: Class, opcode: Opcode, op: &Op, limits: &[Place]) {
        let mut operands: Vec<Operand> = op.operands().into_iter().map(|operand| self.argument(operand)).collect();
        operands.extend(limits.iter().map(|limit| Operand::Read(*limit)));
        self.compute(value, class, opcode, operands);
    }

    /// An index operation with a constant limit.
    pub fn limited(&mut self, value: Value, opcode: Opcode, op: &Op, limit: u32) {
        let limit = Place::constant(Class::Word, u64::from(limit));
        self.plain(value, Class::Word, opcode, op, &[limit]);
    }

    /// An instruction with a result.
    pub fn compute(&mut self, value: Value, class: Class, opcode: Opcode, operands: impl IntoIterator<Item = Operand>) {
        let place = Place { class, content: Content::Value(value) };
        self.places.insert(value, place);
        self.emit(opcode, std::iter::once(Operand::Write(place)).chain(operands));
    }

    /// A copy from one register to another.
    pub fn copy(&mut self, to: Place, from: Place) {
        let opcode = match to.class {
            Class::Float => Opcode::MoveFloat,
            Class::Word => Opcode::MoveWord,
        };
        self.emit(opcode, [Operand::Write(to), Operand::Read(from)]);
    }

    /// The next instruction of the block.
    pub fn emit(&mut self, opcode: Opcode, given: impl IntoIterator<Item = Operand>) {
        let mut operands = [Operand::None; 4];
        for (operand, given) in operands.iter_mut().zip(given) {
            *operand = given;
        }
        self.block.push(Instruction { opcode, operands });
    }
}
