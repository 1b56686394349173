//! The functions on their reduced ranges, shared by both widths.

pub(crate) mod arcsine;
pub(crate) mod atan;
pub(crate) mod exp2;
pub(crate) mod log;
pub(crate) mod log2_wide;
pub(crate) mod reduce;
pub(crate) mod sin_cos;
pub(crate) mod tanh;
