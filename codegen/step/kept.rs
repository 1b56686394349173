//! Values of earlier calls, and how each kind of them is kept.

use crate::program::builder::Builder;
use crate::program::{CellId, Value};

use super::front::counts::Counts;

/// Calls whose values are kept where a polynomial goes through them: as many as a third-order one needs.
pub(crate) const AGES: u32 = 3;

/// What is kept of something that each call brings.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kept {
    /// The window, by slot.
    Window(CellId),
    /// The window of a counter, by slot, as it counts.
    Counts(CellId, Counts),
    /// The newest value alone.
    Newest(CellId),
    /// The newest values, the newest first.
    Ages([CellId; AGES as usize]),
}

impl Kept {
    /// The value that stands at a slot of the window; the newest one where there are no slots.
    pub(crate) fn read(self, b: &mut Builder, slot: Value) -> Value {
        self.newest(b, Some(slot))
    }

    /// The newest value, by its slot where there are slots.
    pub(crate) fn newest(self, b: &mut Builder, slot: Option<Value>) -> Value {
        match self {
            Self::Window(ring) => b.read_ring(ring, place(slot)),
            Self::Counts(ring, counts) => {
                let count = b.read_ring(ring, place(slot));
                counts.place(b, count)
            }
            Self::Newest(cell) | Self::Ages([cell, ..]) => b.read(cell),
        }
    }

    /// The value of so many calls ago, at least one; the newest one where no others are kept.
    pub(crate) fn ago(self, b: &mut Builder, newest: Option<Value>, calls: u32) -> Value {
        match self {
            Self::Ages(cells) => b.read(cells[calls.clamp(1, AGES) as usize - 1]),
            _ => self.newest(b, newest),
        }
    }

    /// Values by age from this call on: what is known now, then what is kept.
    pub(crate) fn by_age(self, b: &mut Builder, now: Value) -> Vec<Value> {
        let Self::Ages(cells) = self else { unreachable!("asked for by steps that keep values by age") };
        std::iter::once(now).chain(cells.into_iter().map(|cell| b.read(cell))).collect()
    }

    /// The count that stands at a slot, with its counter.
    pub(crate) fn count(self, b: &mut Builder, slot: Option<Value>) -> Option<(Value, Counts)> {
        let Self::Counts(ring, counts) = self else { return None };
        Some((b.read_ring(ring, place(slot)), counts))
    }

    /// Keeps a value that becomes the newest; of a counter, its count.
    pub(crate) fn write(self, b: &mut Builder, slot: Option<Value>, value: Value) {
        match self {
            Self::Window(ring) | Self::Counts(ring, _) => b.set_ring(ring, place(slot), value),
            Self::Newest(cell) => b.set(cell, value),
            Self::Ages(cells) => {
                let values = self.by_age(b, value);
                for (cell, value) in cells.into_iter().zip(values) {
                    b.set(cell, value);
                }
            }
        }
    }

    /// In a start: as if it had been so ever before; of a counter, the nearest count.
    pub(crate) fn begin(self, b: &mut Builder, slot: Option<Value>, value: Value) {
        match self {
            Self::Counts(_, counts) => {
                let none = b.index(0);
                let count = counts.further(b, none, value);
                self.write(b, slot, count);
            }
            Self::Window(_) | Self::Newest(_) => self.write(b, slot, value),
            Self::Ages(cells) => cells.into_iter().for_each(|cell| b.set(cell, value)),
        }
    }
}

/// A slot of a window.
fn place(slot: Option<Value>) -> Value {
    slot.unwrap_or_else(|| unreachable!("who keeps a window knows its slots"))
}
