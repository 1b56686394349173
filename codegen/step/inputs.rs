//! The inputs as they are used: the last good value in place of one that is not finite or beyond the guard.

use crate::plant::Plant;
use crate::program::builder::Builder;
use crate::program::{CellId, Value, place};

/// Per input, the cell of its last good value.
pub(crate) fn cells(b: &mut Builder, plant: &Plant) -> Vec<CellId> {
    let cell =
        |input: &crate::plant::Input| b.float_cell(&format!("last_{}", input.label.name), "the last good value", 0.0);
    plant.inputs.iter().map(cell).collect()
}

/// One input and whether it was good.
pub(crate) fn read(b: &mut Builder, input: usize, bound: f64, last: CellId) -> (Value, Value) {
    let (value, good) = sample(b, input, bound);
    let before = b.read(last);
    let used = b.select(good, value, before);
    b.set(last, used);
    (used, good)
}

/// One input as it comes, and whether it is good.
pub(crate) fn sample(b: &mut Builder, input: usize, bound: f64) -> (Value, Value) {
    let value = b.read_input(place(input));
    (value, b.in_range(value, -bound, bound))
}
