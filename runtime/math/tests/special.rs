//! Special values as in Annex F of C99, the canonical NaN, symmetry, monotony.

#![allow(
    clippy::cast_possible_truncation,
    clippy::float_cmp,
    reason = "rounding to f32 and exact comparison are what is tested"
)]

use deadbeat_math::*;

const INF: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;
const PI: f64 = std::f64::consts::PI;
const HALF_PI: f64 = std::f64::consts::FRAC_PI_2;
const QUARTER_PI: f64 = std::f64::consts::FRAC_PI_4;

type Unary = (&'static str, fn(f64) -> f64, fn(f32) -> f32);
type Binary = (&'static str, fn(f64, f64) -> f64, fn(f32, f32) -> f32);

const SIN: Unary = ("sin", sin_f64, sin_f32);
const COS: Unary = ("cos", cos_f64, cos_f32);
const TAN: Unary = ("tan", tan_f64, tan_f32);
const ASIN: Unary = ("asin", asin_f64, asin_f32);
const ACOS: Unary = ("acos", acos_f64, acos_f32);
const ATAN: Unary = ("atan", atan_f64, atan_f32);
const EXP: Unary = ("exp", exp_f64, exp_f32);
const LOG: Unary = ("log", log_f64, log_f32);
const SQRT: Unary = ("sqrt", sqrt_f64, sqrt_f32);
const TANH: Unary = ("tanh", tanh_f64, tanh_f32);
const ATAN2: Binary = ("atan2", atan2_f64, atan2_f32);
const POW: Binary = ("pow", pow_f64, pow_f32);

/// Equal bits, and a NaN only the canonical one.
fn same(value: f64, wanted: f64) -> bool {
    let wanted = if wanted.is_nan() { 0x7FF8_0000_0000_0000 } else { wanted.to_bits() };
    value.to_bits() == wanted
}

fn same_f32(value: f32, wanted: f64) -> bool {
    let wanted = if wanted.is_nan() { 0x7FC0_0000 } else { (wanted as f32).to_bits() };
    value.to_bits() == wanted
}

fn unary((name, double, single): Unary, table: &[(f64, f64)]) {
    for &(x, wanted) in table {
        assert!(same(double(x), wanted), "{name}_f64({x:e}) = {:e}", double(x));
        let value = single(x as f32);
        assert!(same_f32(value, wanted), "{name}_f32({x:e}) = {value:e}");
    }
}

fn binary((name, double, single): Binary, table: &[(f64, f64, f64)]) {
    for &(x, y, wanted) in table {
        assert!(same(double(x, y), wanted), "{name}_f64({x:e}, {y:e}) = {:e}", double(x, y));
        let value = single(x as f32, y as f32);
        assert!(same_f32(value, wanted), "{name}_f32({x:e}, {y:e}) = {value:e}");
    }
}

#[test]
fn trigonometric() {
    unary(SIN, &[(0.0, 0.0), (-0.0, -0.0), (INF, NAN), (-INF, NAN), (NAN, NAN), (-NAN, NAN)]);
    unary(COS, &[(0.0, 1.0), (-0.0, 1.0), (1e-30, 1.0), (INF, NAN), (-INF, NAN), (NAN, NAN)]);
    unary(TAN, &[(0.0, 0.0), (-0.0, -0.0), (INF, NAN), (-INF, NAN), (NAN, NAN)]);
}

#[test]
fn inverse_trigonometric() {
    unary(ASIN, &[(0.0, 0.0), (-0.0, -0.0), (1.0, HALF_PI), (-1.0, -HALF_PI)]);
    unary(ASIN, &[(1.001, NAN), (-INF, NAN), (INF, NAN), (NAN, NAN)]);
    unary(ACOS, &[(1.0, 0.0), (0.0, HALF_PI), (-0.0, HALF_PI), (-1.0, PI)]);
    unary(ACOS, &[(-1.001, NAN), (INF, NAN), (-INF, NAN), (NAN, NAN)]);
    unary(ATAN, &[(0.0, 0.0), (-0.0, -0.0), (INF, HALF_PI), (-INF, -HALF_PI), (NAN, NAN)]);
    unary(ATAN, &[(1.0, QUARTER_PI), (-1.0, -QUARTER_PI)]);
}

#[test]
fn two_argument_arctangent() {
    binary(ATAN2, &[(0.0, 0.0, 0.0), (-0.0, 0.0, -0.0), (0.0, -0.0, PI), (-0.0, -0.0, -PI)]);
    binary(ATAN2, &[(0.0, 3.0, 0.0), (-0.0, 3.0, -0.0), (0.0, -3.0, PI), (-0.0, -3.0, -PI)]);
    binary(ATAN2, &[(3.0, 0.0, HALF_PI), (3.0, -0.0, HALF_PI), (-3.0, 0.0, -HALF_PI)]);
    binary(ATAN2, &[(3.0, INF, 0.0), (-3.0, INF, -0.0), (3.0, -INF, PI), (-3.0, -INF, -PI)]);
    binary(ATAN2, &[(INF, 3.0, HALF_PI), (-INF, -3.0, -HALF_PI), (INF, 0.0, HALF_PI)]);
    binary(ATAN2, &[(INF, INF, QUARTER_PI), (-INF, INF, -QUARTER_PI)]);
    binary(ATAN2, &[(INF, -INF, 3.0 * QUARTER_PI), (-INF, -INF, -3.0 * QUARTER_PI)]);
    binary(ATAN2, &[(NAN, 1.0, NAN), (1.0, NAN, NAN), (NAN, INF, NAN), (0.0, NAN, NAN)]);
    binary(ATAN2, &[(1.0, 1.0, QUARTER_PI), (-1.0, 1.0, -QUARTER_PI), (1e-30, -1e30, PI)]);
}

#[test]
fn exponential_and_logarithm() {
    unary(EXP, &[(0.0, 1.0), (-0.0, 1.0), (INF, INF), (-INF, 0.0), (NAN, NAN)]);
    unary(EXP, &[(800.0, INF), (-800.0, 0.0), (1e30, INF), (-1e30, 0.0), (1e-30, 1.0)]);
    unary(LOG, &[(0.0, -INF), (-0.0, -INF), (1.0, 0.0), (INF, INF), (-1.0, NAN), (-INF, NAN)]);
    unary(LOG, &[(NAN, NAN), (-NAN, NAN), (-1e-30, NAN), (2.0, std::f64::consts::LN_2)]);
}

#[test]
fn exponential_at_its_limits() {
    assert!(exp_f64(709.782_712_893_384).is_finite());
    assert_eq!(exp_f64(709.782_712_893_385), INF);
    assert_eq!(exp_f64(-745.133), f64::from_bits(1));
    assert_eq!(exp_f64(-745.134), 0.0);
    assert!(exp_f32(88.722_83).is_finite());
    assert_eq!(exp_f32(88.722_84), f32::INFINITY);
    assert_eq!(exp_f32(-103.972), f32::from_bits(1));
    assert_eq!(exp_f32(-103.973), 0.0);
}

#[test]
fn root_and_hyperbolic_tangent() {
    unary(SQRT, &[(0.0, 0.0), (-0.0, -0.0), (INF, INF), (-1.0, NAN), (-INF, NAN), (NAN, NAN)]);
    unary(SQRT, &[(1.0, 1.0), (4.0, 2.0), (2.25, 1.5), (0.25, 0.5)]);
    unary(TANH, &[(0.0, 0.0), (-0.0, -0.0), (INF, 1.0), (-INF, -1.0), (NAN, NAN)]);
    unary(TANH, &[(31.0, 1.0), (-31.0, -1.0), (32.0, 1.0), (1e30, 1.0)]);
}

#[test]
fn power_of_zero_and_infinity() {
    binary(POW, &[(0.0, -3.0, INF), (-0.0, -3.0, -INF), (0.0, -2.0, INF), (-0.0, -2.0, INF)]);
    binary(POW, &[(0.0, -2.5, INF), (-0.0, -2.5, INF), (0.0, -INF, INF), (-0.0, -INF, INF)]);
    binary(POW, &[(0.0, 3.0, 0.0), (-0.0, 3.0, -0.0), (-0.0, 2.0, 0.0), (-0.0, 2.5, 0.0)]);
    binary(POW, &[(-INF, -3.0, -0.0), (-INF, -2.0, 0.0), (-INF, 3.0, -INF), (-INF, 2.0, INF)]);
    binary(POW, &[(-INF, 2.5, INF), (-INF, -2.5, 0.0), (INF, -1.0, 0.0), (INF, 1.0, INF)]);
}

#[test]
fn power_of_one_and_to_infinity() {
    binary(POW, &[(-1.0, INF, 1.0), (-1.0, -INF, 1.0), (1.0, NAN, 1.0), (1.0, INF, 1.0)]);
    binary(POW, &[(5.0, 0.0, 1.0), (NAN, 0.0, 1.0), (NAN, -0.0, 1.0), (INF, 0.0, 1.0)]);
    binary(POW, &[(0.5, -INF, INF), (2.0, -INF, 0.0), (0.5, INF, 0.0), (2.0, INF, INF)]);
    binary(POW, &[(-0.5, -INF, INF), (-2.0, -INF, 0.0), (-0.5, INF, 0.0), (-2.0, INF, INF)]);
    binary(POW, &[(-1.0, 3.0, -1.0), (-1.0, 4.0, 1.0), (-1.0, 0.5, NAN), (-1.0, 1e30, 1.0)]);
}

#[test]
fn power_of_ordinary_numbers() {
    binary(POW, &[(-2.0, 0.5, NAN), (-2.0, 3.0, -8.0), (-2.0, 2.0, 4.0), (-2.0, -1.0, -0.5)]);
    binary(POW, &[(NAN, 1.0, NAN), (2.0, NAN, NAN), (-NAN, 2.0, NAN), (-INF, NAN, NAN)]);
    binary(POW, &[(2.0, 0.5, std::f64::consts::SQRT_2), (9.0, 0.5, 3.0), (10.0, 2.0, 100.0)]);
    binary(POW, &[(2.0, 1e30, INF), (2.0, -1e30, 0.0), (-2.0, 1025.0, -INF), (0.5, 1e30, 0.0)]);
    assert_eq!(pow_f64(2.0, -1074.0), f64::from_bits(1));
    assert_eq!(pow_f32(2.0, -149.0), f32::from_bits(1));
    assert_eq!(pow_f64(-2.0, 9_007_199_254_740_991.0), -INF);
    assert_eq!(pow_f64(-1.0, 9_007_199_254_740_991.0), -1.0);
    assert_eq!(pow_f64(-1.0, 9_007_199_254_740_992.0), 1.0);
}

/// Squares of small integers often lie exactly between two numbers.
#[test]
fn powers_that_are_rounding_ties_go_to_even() {
    for x in 4_097_usize..8_192 {
        assert_eq!(pow_f32(f32_from_index(x), 2.0), f32_from_index(x * x), "{x}");
        let big = f64_from_index(x) * 16_384.0 + 1.0;
        assert_eq!(pow_f64(big, 2.0), big * big, "{big}");
        let big = f64_from_index(x * 16_384 + 1);
        assert_eq!(pow_f64(big, 2.0), big * big, "{big}");
    }
}

#[test]
fn subnormal_arguments_come_back() {
    for bits in [1_u32, 2, 3, 0x1234, 0x007F_FFFF, 0x0080_0000] {
        let (x, z) = (f32::from_bits(bits), f64::from_bits(u64::from(bits)));
        for (name, double, single) in [SIN, TAN, ASIN, ATAN, TANH] {
            assert_eq!(single(x).to_bits(), bits, "{name}");
            assert_eq!(single(-x).to_bits(), bits | 0x8000_0000, "{name}");
            assert_eq!(double(z), z, "{name}");
        }
        assert_eq!(sqrt_f32(x), x.sqrt());
        assert_eq!(sqrt_f64(z), z.sqrt());
        assert_eq!(atan2_f64(z, 1.0), z);
    }
}

/// The `f64` that comes closest to a multiple of pi/2.
#[test]
fn the_hardest_angle_to_reduce() {
    let x = 6_381_956_970_095_103.0 * 2.0_f64.powi(797);
    assert_eq!(cos_f64(x), -4.687_165_924_254_628e-19);
    assert_eq!(sin_f64(x), 1.0);
    assert_eq!(tan_f64(x).abs(), 2.133_485_385_753_704e18);
}

/// Pseudo-random bits (xorshift).
fn next(seed: &mut u64) -> u64 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    seed.wrapping_mul(0x2545_F491_4F6C_DD1D)
}

#[test]
fn any_bits_keep_symmetry_and_range() {
    let mut seed = 0x9E37_79B9_7F4A_7C15;
    for _ in 0..20_000 {
        let x = f64::from_bits(next(&mut seed));
        let z = f32::from_bits((next(&mut seed) >> 32) as u32);
        for (name, double, single) in [SIN, TAN, ASIN, ATAN, TANH] {
            assert!(same(double(-x), -double(x)), "{name} {x:e}");
            assert!(same_f32(single(-z), -f64::from(single(z))), "{name} {z:e}");
        }
        assert!(same(cos_f64(-x), cos_f64(x)));
        for value in [sin_f64(x), cos_f64(x), tanh_f64(x)] {
            assert!(value.is_nan() || value.abs() <= 1.0, "{x:e}");
        }
        for value in [sin_f32(z), cos_f32(z), tanh_f32(z)] {
            assert!(value.is_nan() || value.abs() <= 1.0, "{z:e}");
        }
    }
}

#[test]
fn steps_of_one_place_keep_order() {
    let mut seed = 0xD1B5_4A32_D192_ED03;
    for _ in 0..20_000 {
        let bits = 0x3000_0000 + (next(&mut seed) >> 32) as u32 % 0x1000_0000;
        let (x, above) = (f32::from_bits(bits), f32::from_bits(bits + 1));
        for (name, _, single) in [ATAN, EXP, LOG, SQRT, TANH] {
            assert!(single(x) <= single(above), "{name} {x:e}");
        }
        let bits = u64::from(bits - 0x1000_0000) << 32 | next(&mut seed) >> 33;
        let (x, above) = (f64::from_bits(bits), f64::from_bits(bits + 1));
        for (name, double, _) in [EXP, LOG, SQRT, TANH, ATAN] {
            assert!(double(x) <= double(above), "{name} {x:e}");
        }
    }
}

#[test]
fn integers_convert() {
    assert_eq!(f64_from_index(4_294_967_295), 4_294_967_295.0);
    assert_eq!(f32_from_index(4_294_967_295), 4_294_967_296.0);
    assert_eq!(f32_from_index(16_777_217), 16_777_216.0);
}

/// Claim: counts of 16 and 32 bits are numbers of 32 bits whatever `usize` has, and conversions end where they say.
#[test]
fn counts_convert() {
    assert_eq!((index_from_i16(-1), index_from_u16(65_535)), (4_294_967_295, 65_535));
    assert_eq!((index_from_i32(i32::MIN), index_from_u32(u32::MAX)), (2_147_483_648, 4_294_967_295));
    assert_eq!((u16_from_index(0x1_2345), u32_from_index(4_294_967_295)), (0x2345, u32::MAX));
    assert_eq!(wrap_add(4_294_967_295, 2), 1);
    assert_eq!((difference_32(1, 4), difference_16(1, 4)), (4_294_967_293, 4_294_967_293));
    assert_eq!((difference_16(2, 65_535), difference_16(0x8000, 0)), (3, 4_294_934_528));
    assert_eq!(f64_from_signed(4_294_967_295), -1.0);
    assert_eq!((f32_from_signed(2_147_483_648), f32_from_signed(2_147_483_647)), (-2_147_483_648.0, 2_147_483_648.0));
    for (x, whole) in [(1.99, 1_i32), (-1.99, -1), (1e-40, 0), (-3e9, i32::MIN), (f64::NEG_INFINITY, i32::MIN)] {
        assert_eq!(index_from_f64(x), index_from_i32(whole));
        assert_eq!(index_from_f32(x as f32), index_from_i32(whole));
    }
    for x in [3e9, f64::INFINITY] {
        assert_eq!((index_from_f64(x), index_from_f32(x as f32)), (2_147_483_647, 2_147_483_520));
    }
    assert_eq!((index_from_f64(f64::NAN), index_from_f32(f32::NAN)), (0, 0));
}
