//! Outputs that wrap: the state stays within half a turn of zero, and its samples too, so that floats keep their digits
//! after any number of turns.
//!
//! The innovation is folded, and after each correction whole turns are taken off the state along the output's direction s,
//! with or without a sample: the plant does not tell the difference, by proof (`A s = 0`, `C s = 1`).
//!
//! Two motions a turn per sample apart show the same samples, so that a folded innovation alone could settle on the wrong
//! one. A state that moves by more than half a turn from one call to the next is none that samples could tell: it starts
//! again.

use crate::plant::sensor::Wrap;
use crate::program::Value;
use crate::sampled::settled::round;
use crate::step::front;

use super::super::Frame;
use super::Lowering;
use super::carried::Carried;

impl Lowering<'_> {
    /// The outputs that wrap.
    fn wrapped(&self) -> Vec<(usize, Wrap)> {
        let outputs = self.plant.outputs.iter().enumerate();
        outputs.filter_map(|(o, output)| Some((o, output.wrap.clone()?))).collect()
    }

    /// The state with whole turns taken off.
    pub(super) fn turned_back(&mut self, corrected: Vec<Carried>) -> Vec<Carried> {
        let mut state = corrected;
        let scalar = self.plant.scalar;
        for (o, wrap) in self.wrapped() {
            let high: Vec<Value> = state.iter().map(|carried| carried.high).collect();
            let shown = self.shown(&high)[o];
            let turns = front::turns(&mut self.builder, shown, round(&wrap.turn, scalar));
            for (i, x) in state.iter_mut().enumerate() {
                let size = match self.design.frame {
                    // The chain's first coordinate is its signal, and what the others are made of does not move.
                    Frame::Chain { .. } if i == 0 => Some(wrap.turn.clone()),
                    Frame::Chain { .. } => None,
                    Frame::Plant { .. } => wrap.direction[i].times(&wrap.turn).ok().filter(|size| !size.is_zero()),
                };
                if let Some(size) = size {
                    let size = self.builder.float(round(&size, scalar));
                    let whole = self.builder.mul(turns, size);
                    *x = self.taken_off(*x, whole);
                }
            }
        }
        state
    }

    /// Whether an output that wraps is predicted half a turn and more from where the state was.
    pub(super) fn spun(&mut self, shown: &[Value]) -> Value {
        let mut spun = self.builder.boolean(false);
        let wrapped = self.wrapped();
        if wrapped.is_empty() {
            return spun;
        }
        let state: Vec<Value> = self.cells.state.clone().into_iter().map(|cell| self.builder.read(cell)).collect();
        let before = self.shown(&state);
        for (o, wrap) in wrapped {
            let half = self.plant.scalar_value(0.5 * round(&wrap.turn, self.plant.scalar));
            let moved = self.builder.sub(shown[o], before[o]);
            let slow = self.builder.in_range(moved, -half, half);
            let fast = self.builder.not(slow);
            spun = self.builder.or(spun, fast);
        }
        spun
    }
}
