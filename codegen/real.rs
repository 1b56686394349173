//! Multiprecision reals and the small dense matrices built on them.
//!
//! Knows digits, small matrices. Never knows what a number is for.
//!
//! Every constant the generator emits is computed here, at a precision far above the one it is
//! printed in, and rounded to the target format exactly once. All arithmetic rounds to nearest,
//! ties to even, and nothing depends on the platform: floating-point hardware is used for size
//! estimates only, and there only for operations IEEE 754 defines exactly.
//!
//! One idea per submodule:
//!
//! | module              | content                                                        |
//! |---------------------|----------------------------------------------------------------|
//! | [`number`]          | the scalar [`Real`]: representation, rounding, comparison      |
//! | [`arithmetic`]      | `+ - * /`, square root, integer powers, sums of products       |
//! | `accumulate`        | sums of products, exactly                                      |
//! | [`elementary`]      | exponential, logarithm, trigonometry: checked, never panicking |
//! | [`conversion`]      | to and from rationals, `f64`, `f32`, decimal text              |
//! | [`matrix`]          | the dense [`Matrix`]                                           |
//! | [`balance`]         | exact power-of-two scalings                                    |
//! | [`mod@exponential`] | matrix exponential, zero-order and first-order hold            |
//! | [`mod@solve`]       | LU: linear systems, inverse, determinant                       |
//! | [`orthogonal`]      | Householder QR: least squares, pseudo-inverse                  |
//! | [`singular`]        | one-sided Jacobi: singular values, rank, condition             |
//! | [`mod@gramian`]     | the finite-horizon observability Gramian                       |
//! | [`agreement`]       | how far two computations of the same constants agree           |

mod accumulate;
pub mod agreement;
pub mod arithmetic;
pub mod balance;
pub mod conversion;
pub mod elementary;
pub mod exponential;
pub mod gramian;
pub mod matrix;
pub mod number;
pub mod orthogonal;
pub mod singular;
pub mod solve;

pub use agreement::{Agreement, compare};
pub use balance::{balanced, equilibrated_columns, unbalanced};
pub use elementary::Undefined;
pub use exponential::{NormTooLarge, exponential, first_order_hold, third_order_hold, zero_order_hold};
pub use gramian::{gramian, weighted_gramian};
pub use matrix::{Matrix, rows};
pub use number::{Precision, Real};
pub use orthogonal::{RankDeficient, least_squares, orthonormal, pseudo_inverse};
pub use singular::{Rank, condition, rank, singular_values};
pub use solve::{Singular, determinant, inverse, solve};

/// An exact constant, as written by the user.
pub type Rational = dashu_ratio::RBig;
