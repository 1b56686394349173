//! The shape "predict and correct".

pub mod noise;
pub mod placement;
pub mod riccati;
