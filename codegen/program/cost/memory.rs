//! Bytes: of the state, the tables, the stack, the code.

use std::collections::HashMap;

use super::super::check::typing::Context;
use super::super::{CellKind, Op, Program, Scalar, Statement, Type, Value};

/// The state: a structure of the cells in order, each at a multiple of its element's size, on a
/// target whose indices have 4 bytes. A structure cannot be empty: without a cell it is one word.
pub(super) fn ram(program: &Program) -> u64 {
    let float = u64::from(program.scalar.bytes());
    let mut end: u64 = 0;
    let mut widest = WORD;
    for cell in &program.cells {
        let (size, count) = match cell.kind {
            CellKind::Float { .. } => (float, 1),
            CellKind::Index { .. } => (WORD, 1),
            CellKind::Ring { len, .. } => (float, u64::from(len)),
            CellKind::Counts { len, bits, .. } => (u64::from(bits / 8), u64::from(len)),
        };
        end = end.next_multiple_of(size) + size * count;
        widest = widest.max(size);
    }
    end.next_multiple_of(widest).max(WORD)
}

/// The tables in the code, without padding: all elements have the same size.
pub(super) fn tables(program: &Program) -> u64 {
    let elements: usize = program.read_tables().map(|(_, table)| table.rows.len() * table.columns.len()).sum();
    elements as u64 * u64::from(program.scalar.bytes())
}

/// Bytes of an index, a truth value or a status.
const WORD: u64 = 4;

/// Saved registers, return addresses, arguments and alignment of a step and of what it is cut into:
/// two frames of at most 32 words.
const FRAMES: u64 = 2 * 32 * WORD;

/// The deepest elementary function of the runtime.
const CALL_FRAMES: u64 = 256;

/// Every value in a place of its own, and once more for what a step that is cut into functions
/// passes from one to the next; a counter for each loop; the frames.
pub(super) fn stack(program: &Program) -> u64 {
    let float = u64::from(program.scalar.bytes());
    let size = |r#type: &Type| if *r#type == Type::Float { float } else { WORD };
    let values: u64 = types(program).values().map(size).sum();
    let loops = program.body.iter().filter(|statement| matches!(statement, Statement::Loop(_)));
    let calls = if operations(program).any(|op| matches!(op, Op::Call(..))) { CALL_FRAMES } else { 0 };
    2 * values + WORD * loops.count() as u64 + FRAMES + calls
}

/// The tables, and for each statement the instructions that it takes in Thumb-2 code without any
/// optimisation, all operands in memory: 4 bytes each.
pub(super) fn flash(program: &Program) -> u64 {
    let statements: u64 = program.body.iter().map(|statement| code(statement, program.scalar)).sum();
    let returned = MOVE * (program.estimates.len() as u64 + 1);
    let start = program.init_at.as_ref();
    let start = start.map_or(0, |it| FRAME + it.iter().map(|one| code(one, program.scalar)).sum::<u64>());
    tables(program) + FRAME + statements + returned + start
}

/// Entering and leaving a function, and preparing what `init` sets.
const FRAME: u64 = 128;
/// A load and a store.
const MOVE: u64 = 16;
/// Counting, comparing, jumping, and the row's address.
const LOOP: u64 = 40;

/// Bytes of code of a statement.
fn code(statement: &Statement, scalar: Scalar) -> u64 {
    match statement {
        Statement::Section(_) => 0,
        Statement::Let { op, .. } => operation(op, scalar),
        Statement::SetCell { .. } => MOVE,
        Statement::SetRing { .. } => 2 * MOVE,
        Statement::Loop(inner) => {
            // A carried value is copied at the start, to a temporary and from it at the end.
            let carried = 3 * MOVE * inner.carried.len() as u64;
            LOOP + carried + inner.body.iter().map(|it| code(it, scalar)).sum::<u64>()
        }
    }
}

/// Bytes of code of an operation: its instructions, and its constants in the literal pool.
fn operation(op: &Op, scalar: Scalar) -> u64 {
    let constant = u64::from(scalar.bytes());
    match op {
        Op::Float(_) => MOVE + constant,
        Op::Given(_) | Op::Vouched => MOVE,
        Op::Bool(_) | Op::Status(_) | Op::Index(_) | Op::Measurement(_) | Op::Count(_) | Op::Input(_) | Op::Cell(_) => {
            MOVE
        }
        Op::Neg(_) | Op::Not(_) | Op::ToFloat(_) => MOVE + 8,
        Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::Div(..) | Op::And(..) | Op::Or(..) | Op::WrapAdd(..) => MOVE + 12,
        Op::Call(..) | Op::FromFloat(_) | Op::Ring { .. } | Op::Lookup { .. } | Op::Gain { .. } => 2 * MOVE,
        Op::Less(..) | Op::LessEqual(..) | Op::IndexLess(..) | Op::IndexEqual(..) => 2 * MOVE + 8,
        Op::Select { .. }
        | Op::Advance { .. }
        | Op::Retreat { .. }
        | Op::CountUp { .. }
        | Op::CountDown(_)
        | Op::AtMost { .. }
        | Op::Difference { .. }
        | Op::Remainder { .. }
        | Op::SignedToFloat(_) => 3 * MOVE,
        Op::InRange { .. } => 4 * MOVE + 2 * constant,
    }
}

/// All operations, those in loops included.
fn operations(program: &Program) -> impl Iterator<Item = &Op> {
    let flat = program.body.iter().flat_map(|statement| match statement {
        Statement::Loop(inner) => inner.body.iter().collect(),
        _ => vec![statement],
    });
    flat.filter_map(|statement| match statement {
        Statement::Let { op, .. } => Some(op),
        _ => None,
    })
}

/// The type of every value.
fn types(program: &Program) -> HashMap<Value, Type> {
    let mut types = HashMap::new();
    for statement in &program.body {
        match statement {
            Statement::Loop(inner) => {
                for carried in &inner.carried {
                    types.insert(carried.value, types[&carried.start]);
                }
                let context = Context::of(program, Some(inner.table));
                inner.body.iter().for_each(|statement| define(statement, &context, &mut types));
            }
            _ => define(statement, &Context::of(program, None), &mut types),
        }
    }
    types
}

/// Adds the value that a statement defines.
fn define(statement: &Statement, context: &Context, types: &mut HashMap<Value, Type>) {
    if let Statement::Let { value, op } = statement {
        let r#type = context.type_of(op, |operand| Ok(types[&operand]));
        types.insert(*value, r#type.unwrap_or_else(|flaw| unreachable!("the program is checked: {flaw}")));
    }
}
