//! What a generated observer calls: a status, a trait, and the elementary functions.
//!
//! No allocation, no `std`, no `unsafe`. The functions in [`math`] have a C twin with the same
//! operations in the same order, so that generated Rust and generated C give the same bits.
//!
//! With the feature `macros`, `observer!` turns a specification into an observer in place.
#![no_std]

pub use deadbeat_math as math;

#[cfg(feature = "macros")]
pub use deadbeat_macros::observer;

/// What a step says of its estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Status {
    /// Not yet converged: the estimate is the start, or what was last known.
    Converging = 0,
    /// Converged: the estimate is what the file's header promises.
    Converged = 1,
    /// A missing sample in the window was replaced by the model's prediction.
    Coasting = 2,
}

/// A state observer, called once a sample.
///
/// Generic code that drives an observer (a replay, a test bench, a comparison) needs no more than
/// this; the inherent `step` of a generated observer does the same.
pub trait Observer {
    /// Sampled now.
    type Measurements;
    /// Applied since the previous call; `()` when the plant has none.
    type Inputs;
    /// The state, and how far it is to be trusted.
    type Estimate;

    /// Seconds between two calls of [`step`](Observer::step).
    const SAMPLE_TIME: f64;

    /// One sample: takes the measurements and the inputs applied since the previous call, gives the estimate.
    fn step(&mut self, measurements: Self::Measurements, inputs: Self::Inputs) -> Self::Estimate;
}
