//! The shape "predict and correct".

pub mod sliding;
