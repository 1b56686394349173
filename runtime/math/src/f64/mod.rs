//! The functions for `f64`.

pub(crate) mod arc;
pub(crate) mod exp;
pub(crate) mod format;
pub(crate) mod log;
pub(crate) mod pow;
pub(crate) mod reduce;
pub(crate) mod sin_cos_tan;
pub(crate) mod sqrt;
pub(crate) mod tanh;
