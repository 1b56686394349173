//! Executes code: one tight loop for each run of an opcode.
//!
//! A register number is a `u16` and a register file has 2^16 places, so that no access to a
//! register needs a check of its bound.

use super::super::Function;
use super::allocate::Run;
use super::arithmetic::{Number, advance, at_most, count_down, count_up, difference, remainder, retreat};
use super::instruction::Opcode;

/// How many registers a file has.
const FILE: usize = 1 << 16;

/// A constant table.
pub(super) struct Rows<F> {
    pub columns: usize,
    pub elements: Vec<F>,
}

/// Everything that changes.
pub(super) struct Memory<F> {
    pub floats: Box<[F; FILE]>,
    pub words: Box<[u32; FILE]>,
    /// By cell; empty for other cells.
    pub rings: Vec<Vec<F>>,
    /// By cell; empty for other cells.
    pub counts: Vec<Vec<u32>>,
}

impl<F: Number> Memory<F> {
    /// Registers of zero, and these rings.
    pub fn new(rings: Vec<Vec<F>>, counts: Vec<Vec<u32>>) -> Self {
        Self { floats: file(), words: file(), rings, counts }
    }

    /// The runs in order; `row` is where the loop is.
    #[inline]
    pub fn execute(&mut self, runs: &[Run], operands: &[[u16; 4]], tables: &[Rows<F>], row: &[F]) {
        for run in runs {
            self.run(run.opcode, &operands[run.operands.clone()], tables, row);
        }
    }

    /// Every instruction of one run.
    #[inline]
    fn run(&mut self, opcode: Opcode, run: &[[u16; 4]], tables: &[Rows<F>], row: &[F]) {
        let Self { floats: f, words: w, rings, counts } = self;
        match opcode {
            Opcode::MoveFloat => each(run, |[d, a, ..]| f[d] = f[a]),
            Opcode::MoveWord => each(run, |[d, a, ..]| w[d] = w[a]),
            Opcode::Neg => each(run, |[d, a, ..]| f[d] = -f[a]),
            Opcode::Add => each(run, |[d, a, b, _]| f[d] = f[a] + f[b]),
            Opcode::Sub => each(run, |[d, a, b, _]| f[d] = f[a] - f[b]),
            Opcode::Mul => each(run, |[d, a, b, _]| f[d] = f[a] * f[b]),
            Opcode::Div => each(run, |[d, a, b, _]| f[d] = f[a] / f[b]),
            Opcode::MulAdd => each(run, |[d, a, b, c]| f[d] = f[a] * f[b] + f[c]),
            Opcode::MulSub => each(run, |[d, a, b, c]| f[d] = f[c] - f[a] * f[b]),
            Opcode::Gain => each(run, |[d, a, ..]| f[d] = row[a]),
            Opcode::GainMul => each(run, |[d, a, b, _]| f[d] = row[a] * f[b]),
            Opcode::GainMulAdd => each(run, |[d, a, b, c]| f[d] = row[a] * f[b] + f[c]),
            Opcode::Call => each(run, |[d, a, b, c]| f[d] = F::call(Function::ALL[a], f[b], f[c])),
            Opcode::Less => each(run, |[d, a, b, _]| w[d] = u32::from(f[a] < f[b])),
            Opcode::LessEqual => each(run, |[d, a, b, _]| w[d] = u32::from(f[a] <= f[b])),
            Opcode::InRange => {
                each(run, |[d, a, b, c]| w[d] = u32::from(f[b] <= f[a] && f[a] <= f[c]));
            }
            Opcode::And => each(run, |[d, a, b, _]| w[d] = w[a] & w[b]),
            Opcode::Or => each(run, |[d, a, b, _]| w[d] = w[a] | w[b]),
            Opcode::Not => each(run, |[d, a, ..]| w[d] = 1 - w[a]),
            Opcode::SelectFloat => {
                each(run, |[d, a, b, c]| f[d] = if w[a] != 0 { f[b] } else { f[c] });
            }
            Opcode::SelectWord => {
                each(run, |[d, a, b, c]| w[d] = if w[a] != 0 { w[b] } else { w[c] });
            }
            Opcode::IndexLess => each(run, |[d, a, b, _]| w[d] = u32::from(w[a] < w[b])),
            Opcode::IndexEqual => each(run, |[d, a, b, _]| w[d] = u32::from(w[a] == w[b])),
            Opcode::Advance => each(run, |[d, a, b, _]| w[d] = advance(w[a], w[b])),
            Opcode::Retreat => each(run, |[d, a, b, _]| w[d] = retreat(w[a], w[b])),
            Opcode::CountUp => each(run, |[d, a, b, _]| w[d] = count_up(w[a], w[b])),
            Opcode::CountDown => each(run, |[d, a, ..]| w[d] = count_down(w[a])),
            Opcode::AtMost => each(run, |[d, a, b, _]| w[d] = at_most(w[a], w[b])),
            Opcode::Remainder => each(run, |[d, a, b, _]| w[d] = remainder(w[a], w[b])),
            Opcode::ToFloat => each(run, |[d, a, ..]| f[d] = F::from_index(w[a])),
            Opcode::SignedToFloat => each(run, |[d, a, ..]| f[d] = F::from_signed(w[a])),
            Opcode::FromFloat => each(run, |[d, a, ..]| w[d] = f[a].to_signed()),
            Opcode::WrapAdd => each(run, |[d, a, b, _]| w[d] = w[a].wrapping_add(w[b])),
            Opcode::Difference => each(run, |[d, a, b, c]| w[d] = difference(w[a], w[b], w[c])),
            Opcode::ReadRing => each(run, |[d, a, b, _]| f[d] = rings[a][w[b] as usize]),
            Opcode::WriteRing => each(run, |[d, a, b, _]| rings[d][w[a] as usize] = f[b]),
            Opcode::ReadCounts => each(run, |[d, a, b, _]| w[d] = counts[a][w[b] as usize]),
            Opcode::WriteCounts => each(run, |[d, a, b, c]| counts[d][w[a] as usize] = w[b] & w[c]),
            Opcode::Lookup => each(run, |[d, a, b, c]| {
                f[d] = tables[a].elements[w[b] as usize * tables[a].columns + c];
            }),
        }
    }
}

/// Executes the instructions in order.
#[inline(always)]
#[expect(clippy::inline_always, reason = "each call is the body of a hot loop")]
fn each(run: &[[u16; 4]], mut execute: impl FnMut([usize; 4])) {
    for operands in run {
        execute(operands.map(usize::from));
    }
}

/// A register file of zeros.
#[expect(clippy::unnecessary_box_returns, reason = "it is too large for the stack")]
fn file<T: Copy + Default>() -> Box<[T; FILE]> {
    let file = vec![T::default(); FILE].into_boxed_slice();
    file.try_into().unwrap_or_else(|_| unreachable!("it has that length"))
}
