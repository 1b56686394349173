//! Numbers the registers and packs the instructions into runs of equal opcodes.
//!
//! A value's register is free again behind the value's last use; constants, cells, measurements and
//! inputs keep theirs. What a loop uses from outside stays until the loop has ended.

use std::collections::HashMap;
use std::ops::Range;

use super::super::TableId;
use super::instruction::{Block, Class, Content, Instruction, Opcode, Operand, Place};

/// Instructions of one opcode: a range of [`Code::operands`].
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub opcode: Opcode,
    pub operands: Range<usize>,
}

/// What a step executes in order: these runs, once or for each row of a table.
pub(super) struct Stage {
    pub rows_of: Option<TableId>,
    pub runs: Vec<Run>,
}

/// A Program for the machine.
pub(super) struct Code {
    pub stages: Vec<Stage>,
    /// Register numbers, or plain numbers, as the opcode says.
    pub operands: Vec<[u16; 4]>,
    /// Of everything that keeps its register.
    pub fixed: HashMap<Place, u16>,
    pub estimates: Vec<(Class, u16)>,
    pub status: u16,
}

/// The code of scheduled blocks; `fixed` get a register even if no instruction names them.
pub(super) fn allocate(
    blocks: &[Block],
    fixed: impl IntoIterator<Item = Place>,
    estimates: &[Place],
    status: Place,
) -> Code {
    let mut registers = Registers::default();
    // First, so that what keeps its register gets one that no value had before.
    let named = blocks.iter().flat_map(|block| parts(block).1).flat_map(|it| it.operands.iter().filter_map(register));
    for place in named.chain(fixed).chain(estimates.iter().copied()).chain([status]).filter(|place| !is_value(place)) {
        registers.number(place);
    }
    let last_uses = last_uses(blocks, estimates, status);
    let mut code = Code { stages: vec![], operands: vec![], fixed: HashMap::new(), estimates: vec![], status: 0 };
    let mut at = 0;
    for block in blocks {
        let (rows_of, body) = parts(block);
        let mut runs: Vec<Run> = vec![];
        for instruction in body {
            code.operands.push(registers.operands(instruction, &last_uses, at));
            let end = code.operands.len();
            match runs.last_mut() {
                Some(run) if run.opcode == instruction.opcode => run.operands.end = end,
                _ => runs.push(Run { opcode: instruction.opcode, operands: end - 1..end }),
            }
            at += 1;
        }
        registers.release(&last_uses, at);
        at += 1;
        code.stages.push(Stage { rows_of, runs });
    }
    code.estimates = estimates.iter().map(|place| (place.class, registers.number(*place))).collect();
    code.status = registers.number(status);
    code.fixed = registers.numbers;
    code
}

/// The table of a loop, and the instructions.
fn parts(block: &Block) -> (Option<TableId>, &[Instruction]) {
    match block {
        Block::Once(body) => (None, body),
        Block::PerRow(table, body) => (Some(*table), body),
    }
}

/// Where each value is used last, by the place of the instruction; each block's end is a place of
/// its own. The values of the estimates and the status have none.
fn last_uses(blocks: &[Block], estimates: &[Place], status: Place) -> HashMap<Place, usize> {
    let mut first = HashMap::new();
    let mut last = HashMap::new();
    let mut at = 0;
    for block in blocks {
        let (rows_of, body) = parts(block);
        let (start, end) = (at, at + body.len());
        for instruction in body {
            for place in instruction.operands.iter().filter_map(value) {
                let outer = *first.entry(place).or_insert(at) < start;
                last.insert(place, if outer && rows_of.is_some() { end } else { at });
            }
            at += 1;
        }
        at = end + 1;
    }
    for place in estimates.iter().chain([&status]) {
        last.remove(place);
    }
    last
}

/// The register that the operand names, if it holds a value.
fn value(operand: &Operand) -> Option<Place> {
    register(operand).filter(is_value)
}

/// The register that the operand names.
fn register(operand: &Operand) -> Option<Place> {
    match *operand {
        Operand::Read(place) | Operand::Write(place) => Some(place),
        Operand::None | Operand::Number(_) | Operand::ReadRing(_) | Operand::WriteRing(_) => None,
    }
}

/// Whether the register is free behind its last use.
fn is_value(place: &Place) -> bool {
    matches!(place.content, Content::Value(_))
}

/// The numbers in use and the numbers free.
#[derive(Default)]
struct Registers {
    numbers: HashMap<Place, u16>,
    free: [Vec<u16>; 2],
    used: [usize; 2],
}

impl Registers {
    /// The operands as numbers. What is used here last is free before the result gets its number:
    /// an instruction reads before it writes.
    fn operands(&mut self, instruction: &Instruction, last_uses: &HashMap<Place, usize>, at: usize) -> [u16; 4] {
        let mut numbers = [0; 4];
        for (number, operand) in numbers.iter_mut().zip(&instruction.operands) {
            *number = match *operand {
                Operand::None | Operand::Write(_) => 0,
                Operand::Number(number) => number,
                Operand::ReadRing(ring) | Operand::WriteRing(ring) => ring.0,
                Operand::Read(place) => self.number(place),
            };
        }
        let ends = |place: &Place| last_uses.get(place) == Some(&at);
        for place in instruction.operands.iter().filter_map(value).filter(ends) {
            self.free(place);
        }
        for (number, operand) in numbers.iter_mut().zip(&instruction.operands) {
            if let Operand::Write(place) = *operand {
                *number = self.number(place);
                if ends(&place) {
                    self.free(place);
                }
            }
        }
        numbers
    }

    /// Frees what is used last at a block's end.
    fn release(&mut self, last_uses: &HashMap<Place, usize>, at: usize) {
        let mut ended: Vec<Place> =
            self.numbers.keys().filter(|place| last_uses.get(place) == Some(&at)).copied().collect();
        ended.sort_by_key(|place| self.numbers[place]);
        for place in ended {
            self.free(place);
        }
    }

    /// The number of a place, a new one if it has none.
    fn number(&mut self, place: Place) -> u16 {
        let class = place.class as usize;
        *self.numbers.entry(place).or_insert_with(|| {
            self.free[class].pop().unwrap_or_else(|| {
                self.used[class] += 1;
                u16::try_from(self.used[class] - 1).expect("at most 65536 floats and words in use at once")
            })
        })
    }

    fn free(&mut self, place: Place) {
        if let Some(number) = self.numbers.remove(&place) {
            self.free[place.class as usize].push(number);
        }
    }
}
