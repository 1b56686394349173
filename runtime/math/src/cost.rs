//! What a call costs at most.

/// The operations of the longest path through each function, rounded up to tens.
///
/// Counted in the C text with all calls expanded: every operator on integers
/// (there are none on floating-point numbers) and every comparison is one. A
/// shift or sum of 64 bits is two or three instructions on a 32-bit core, so
/// instructions are about one and a half times as many.
pub const COSTS: &[(&str, u32)] = &[
    ("sin_f32", 250),
    ("cos_f32", 250),
    ("tan_f32", 440),
    ("asin_f32", 670),
    ("acos_f32", 670),
    ("atan_f32", 490),
    ("atan2_f32", 540),
    ("exp_f32", 210),
    ("log_f32", 450),
    ("sqrt_f32", 120),
    ("tanh_f32", 350),
    ("pow_f32", 700),
    ("sin_f64", 310),
    ("cos_f64", 310),
    ("tan_f64", 500),
    ("asin_f64", 670),
    ("acos_f64", 670),
    ("atan_f64", 490),
    ("atan2_f64", 540),
    ("exp_f64", 240),
    ("log_f64", 450),
    ("sqrt_f64", 160),
    ("tanh_f64", 350),
    ("pow_f64", 660),
];
