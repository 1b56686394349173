//! Outputs that wrap: between resets both copies follow an output that turns on, and after each call the whole turns that
//! it has made are taken off everything that is kept, so that floats keep their digits.
//!
//! A sample is the one of all that its angle may stand for that is nearest to what the copies foretell. The plant does
//! not tell a turn, by proof (`A s = 0`, `C s = 1`): z1 moves by s, z2 by `s + L y`, nonlinear terms not at all.

use crate::program::Value;
use crate::sampled::settled::round;
use crate::sampled::weights::products;
use crate::step::front;
use crate::step::kept::Kept;

use super::Lowering;

/// What is kept of a call.
pub(super) struct Turned {
    /// Per output: its values by age.
    pub(super) outputs: Vec<Vec<Value>>,
    pub(super) first: Vec<Value>,
    pub(super) second: Vec<Value>,
}

impl Lowering<'_> {
    /// The same with whole turns taken off.
    pub(super) fn turned_back(&mut self, mut kept: Turned) -> Turned {
        let (plant, design, b) = (self.plant, self.design, &mut self.builder);
        for (o, output) in plant.outputs.iter().enumerate() {
            let Some(wrap) = &output.wrap else { continue };
            let turn = round(&wrap.turn, plant.scalar);
            let turns = front::turns(b, kept.outputs[o][0], turn);
            let size = b.float(turn);
            let whole = b.mul(turns, size);
            kept.outputs[o].iter_mut().for_each(|value| *value = b.sub(*value, whole));
            let none = b.float(0.0);
            let mut moved = vec![none; plant.outputs.len()];
            moved[o] = whole;
            let gained = products(b, &design.gain, &moved);
            for (i, place) in design.rest.iter().enumerate() {
                kept.second[i] = b.sub(kept.second[i], gained[i]);
                let size = wrap.direction[*place].times(&wrap.turn).ok().filter(|size| !size.is_zero());
                let Some(size) = size else { continue };
                let size = b.float(round(&size, plant.scalar));
                let along = b.mul(turns, size);
                for copy in [&mut kept.first[i], &mut kept.second[i]] {
                    *copy = b.sub(*copy, along);
                }
            }
        }
        kept
    }

    /// An output's values by age, now first.
    pub(super) fn ages(&mut self, output: usize, now: Value) -> Vec<Value> {
        self.sensors.outputs[output].by_age(&mut self.builder, now)
    }

    /// Keeps an output's values by age, now first, for the next call.
    pub(super) fn keep(&mut self, output: usize, values: &[Value]) {
        let Kept::Ages(cells) = self.sensors.outputs[output] else { unreachable!("values are kept by age") };
        for (cell, value) in cells.into_iter().zip(values) {
            self.builder.set(cell, *value);
        }
    }
}
