//! The plant at its samples: transition matrix, holds, signals, constants rounded once, what samples show of the state.
//!
//! Knows the exact plant and multiprecision. Never knows how a state is estimated, nor a step.

pub mod carry;
pub mod coordinates;
pub mod model;
pub mod observability;
pub mod samples;
pub mod settle;
pub mod settled;
pub mod signal;
pub mod unknowns;
pub mod weights;

pub use signal::{Part, Signal, Source};
