//! Chooses the instructions of a Program.
//!
//! In: a checked Program. Out: blocks of instructions over unnumbered registers. Constants,
//! measurements and inputs need no instruction. A gain or a product that is used once waits for its
//! use and becomes part of it: `row.0 * t1`, then `t2 + t3`, is one `GainMulAdd`.

mod fuse;
mod operation;

use std::collections::HashMap;
use std::mem;

use self::fuse::Waiting;
use super::super::{Carried, CellKind, Loop, Program, Statement, Value};
use super::instruction::{Block, Class, Content, Instruction, Opcode, Operand, Place};

/// The instructions of the Program, those of its start in a first block of their own if it has one, and where its
/// estimates and its status are behind them.
pub(super) fn select(program: &Program) -> (Vec<Block>, Vec<Place>, Place) {
    let mut selection = Selection {
        program,
        uses: uses(program),
        places: HashMap::new(),
        waiting: HashMap::new(),
        block: vec![],
        blocks: vec![],
    };
    if let Some(start) = &program.init_at {
        selection.body(start);
        let start = mem::take(&mut selection.block);
        selection.blocks.push(Block::Once(start));
    }
    selection.body(&program.body);
    let estimates = program.estimates.iter().map(|(_, value)| selection.place(*value)).collect();
    let status = selection.place(program.status);
    let last = mem::take(&mut selection.block);
    selection.blocks.push(Block::Once(last));
    (selection.blocks, estimates, status)
}

/// How often each value is used.
fn uses(program: &Program) -> HashMap<Value, u32> {
    fn count(body: &[Statement], seen: &mut Vec<Value>) {
        for statement in body {
            match statement {
                Statement::Section(_) => {}
                Statement::Let { op, .. } => seen.extend(op.operands()),
                Statement::SetCell { value, .. } => seen.push(*value),
                Statement::SetRing { slot, value, .. } => seen.extend([*slot, *value]),
                Statement::Loop(inner) => {
                    count(&inner.body, seen);
                    seen.extend(inner.carried.iter().flat_map(|it| [it.start, it.next]));
                }
            }
        }
    }
    let mut seen: Vec<Value> = program.estimates.iter().map(|(_, value)| *value).collect();
    seen.push(program.status);
    count(&program.body, &mut seen);
    count(program.init_at.as_deref().unwrap_or_default(), &mut seen);
    let mut uses = HashMap::new();
    for value in seen {
        *uses.entry(value).or_default() += 1;
    }
    uses
}

/// The instructions chosen so far.
struct Selection<'a> {
    program: &'a Program,
    uses: HashMap<Value, u32>,
    /// Where the values are that have been computed.
    places: HashMap<Value, Place>,
    /// Gains and products that have not been computed.
    waiting: HashMap<Value, Waiting>,
    block: Vec<Instruction>,
    blocks: Vec<Block>,
}

impl Selection<'_> {
    /// The instructions of the statements.
    fn body(&mut self, body: &[Statement]) {
        for statement in body {
            match statement {
                Statement::Section(_) => {}
                Statement::Let { value, op } => self.define(*value, op),
                Statement::SetCell { cell, value } => {
                    let from = self.place(*value);
                    self.copy(Place { content: Content::Cell(*cell), ..from }, from);
                }
                Statement::SetRing { ring, slot, value } => {
                    let (slot, value) = (self.place(*slot), self.place(*value));
                    let operands = [Operand::WriteRing(*ring), Operand::Read(slot), Operand::Read(value)];
                    match self.program.cells[usize::from(ring.0)].kind {
                        CellKind::Counts { bits, .. } => {
                            let mask = Place::constant(Class::Word, u64::from(u32::MAX >> (32 - bits)));
                            self.emit(Opcode::WriteCounts, operands.into_iter().chain([Operand::Read(mask)]));
                        }
                        _ => self.emit(Opcode::WriteRing, operands),
                    }
                }
                Statement::Loop(inner) => self.inner(inner),
            }
        }
    }

    /// The block so far, the loop, and a new block.
    fn inner(&mut self, inner: &Loop) {
        let mut waiting: Vec<Value> = self.waiting.keys().copied().collect();
        waiting.sort_unstable();
        for value in waiting {
            self.place(value);
        }
        for Carried { value, start, .. } in &inner.carried {
            let from = self.place(*start);
            let carried = Place { content: Content::Value(*value), ..from };
            self.copy(carried, from);
            self.places.insert(*value, carried);
        }
        let before = mem::take(&mut self.block);
        self.blocks.push(Block::Once(before));

        self.body(&inner.body);
        // All of them are carried out before the first carried register changes.
        for Carried { next, .. } in &inner.carried {
            self.place(*next);
        }
        for carried in &inner.carried {
            self.hand_on(carried);
        }
        let body = mem::take(&mut self.block);
        self.blocks.push(Block::PerRow(inner.table, body));
    }

    /// Makes `next` the carried register's content: computed there at once if nothing reads the
    /// old content behind that, else copied at the body's end.
    fn hand_on(&mut self, carried: &Carried) {
        let (to, next) = (self.places[&carried.value], self.places[&carried.next]);
        let own = next.content == Content::Value(carried.next);
        match self.block.iter().position(|it| it.writes(next)).filter(|_| own) {
            Some(at) if !self.block[at + 1..].iter().any(|it| it.reads(to)) => {
                for instruction in &mut self.block[at..] {
                    instruction.rename(next, to);
                }
                self.places.insert(carried.next, to);
            }
            _ => self.copy(to, next),
        }
    }
}
