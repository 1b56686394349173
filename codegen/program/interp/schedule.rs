//! Reorders the instructions of a block so that equal opcodes follow each other.
//!
//! The machine decodes an opcode once for a run of instructions. Order matters only between a write
//! and the reads and writes of the same register or ring; those keep their order, so every
//! instruction computes what it did.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::super::CellId;
use super::instruction::{Instruction, Opcode, Operand, Place};

/// The same instructions, in longer runs.
pub(super) fn schedule(block: &[Instruction]) -> Vec<Instruction> {
    let (mut open, followers) = dependencies(block);
    let mut ready: BTreeMap<Opcode, BTreeSet<usize>> = BTreeMap::new();
    for at in (0..block.len()).filter(|at| open[*at] == 0) {
        ready.entry(block[at].opcode).or_default().insert(at);
    }
    let mut scheduled = Vec::with_capacity(block.len());
    let mut current = None;
    while let Some(opcode) = continued(current, &ready) {
        let Some(at) = ready.get_mut(&opcode).and_then(BTreeSet::pop_first) else { break };
        scheduled.push(block[at]);
        current = Some(opcode);
        for follower in &followers[at] {
            open[*follower] -= 1;
            if open[*follower] == 0 {
                ready.entry(block[*follower].opcode).or_default().insert(*follower);
            }
        }
    }
    scheduled
}

/// The current opcode while it has instructions, else that of the earliest instruction.
fn continued(current: Option<Opcode>, ready: &BTreeMap<Opcode, BTreeSet<usize>>) -> Option<Opcode> {
    let waiting = |opcode: &Opcode| ready.get(opcode).is_some_and(|set| !set.is_empty());
    current.filter(waiting).or_else(|| {
        let earliest = ready.iter().filter_map(|(opcode, set)| Some((set.first()?, *opcode))).min();
        earliest.map(|(_, opcode)| opcode)
    })
}

/// What an instruction may have to wait for.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Resource {
    Register(Place),
    Ring(CellId),
}

/// Who wrote a resource last, and who read that.
#[derive(Default)]
struct History {
    writer: Option<usize>,
    readers: Vec<usize>,
}

/// For each instruction, how many others it waits for, and who waits for it.
fn dependencies(block: &[Instruction]) -> (Vec<usize>, Vec<Vec<usize>>) {
    let mut histories: HashMap<Resource, History> = HashMap::new();
    let mut open = vec![0; block.len()];
    let mut followers = vec![vec![]; block.len()];
    for (at, instruction) in block.iter().enumerate() {
        let mut before = BTreeSet::new();
        for (resource, writes) in instruction.operands.iter().filter_map(resource) {
            let history = histories.entry(resource).or_default();
            before.extend(history.writer);
            if writes {
                before.extend(history.readers.drain(..));
                history.writer = Some(at);
            } else {
                history.readers.push(at);
            }
        }
        before.remove(&at);
        open[at] = before.len();
        for earlier in before {
            followers[earlier].push(at);
        }
    }
    (open, followers)
}

/// The resource of an operand, and whether it is written.
fn resource(operand: &Operand) -> Option<(Resource, bool)> {
    match *operand {
        Operand::None | Operand::Number(_) => None,
        Operand::Write(place) => Some((Resource::Register(place), true)),
        Operand::Read(place) => Some((Resource::Register(place), false)),
        Operand::ReadRing(ring) => Some((Resource::Ring(ring), false)),
        Operand::WriteRing(ring) => Some((Resource::Ring(ring), true)),
    }
}
