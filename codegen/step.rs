//! Everything of a step that is not the estimator: what is read, guarded, replaced and reported.
//!
//! Knows the plant's sensors and the builder of Programs. Never knows how a state comes from samples.

pub mod ahead;
pub mod cells;
pub mod coasting;
pub mod composed;
pub mod front;
pub mod gate;
pub mod given;
pub mod guard;
pub mod injections;
pub mod inputs;
pub mod kept;
pub mod known;
pub mod logic;
pub mod missing;
pub mod rates;
pub mod reading;
pub mod report;
pub mod sensors;
