//! Measures every function on pseudo-random arguments and asserts the documented accuracy.
//!
//! For `f64` the reference is 120-bit arithmetic. For `f32` it is the platform's
//! double precision, and 120-bit arithmetic wherever that lies within 8 of its
//! last places of a rounding boundary.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::float_cmp,
    reason = "rounding to f32 and exact comparison are what is tested"
)]

use std::f64::consts::FRAC_PI_2;

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

type Big = FBig<HalfEven, 2>;

const PRECISION: usize = 120;
const DOUBLE_COUNT: u32 = 20_000;
const SINGLE_COUNT: u32 = 100_000;

/// Pseudo-random numbers (xorshift).
struct Dice(u64);

impl Dice {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// True once in n times.
    fn once_in(&mut self, n: u64) -> bool {
        (self.bits() >> 16).is_multiple_of(n)
    }

    /// Uniform in [0, 1).
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// Either sign.
    fn signed(&mut self, x: f64) -> f64 {
        if self.once_in(2) { x } else { -x }
    }

    /// Positive with a uniform logarithm.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        (low + (high - low) * self.unit()).exp2()
    }

    /// Half uniform up to a limit, half with a uniform logarithm from 2^low to the limit.
    fn spread(&mut self, low: f64, limit: f64) -> f64 {
        let x = if self.once_in(2) { self.unit() * limit } else { self.size(low, limit.log2()) };
        self.signed(x)
    }
}

/// Draws arguments, given the exponent of the least normal number of the format.
type Draw = fn(&mut Dice, f64) -> (f64, f64);

fn draw_angle(dice: &mut Dice, least: f64) -> (f64, f64) {
    let multiple = (dice.unit() * 60_000.0).floor() * FRAC_PI_2;
    if dice.once_in(8) {
        return (dice.signed(multiple), 0.0);
    }
    if dice.once_in(8) {
        return (dice.size(17.0, -least), 0.0);
    }
    (dice.spread(least, 1e5), 0.0)
}

fn draw_unit(dice: &mut Dice, least: f64) -> (f64, f64) {
    let near_one = 1.0 - dice.size(-23.0, -1.0);
    if dice.once_in(4) {
        return (dice.signed(near_one), 0.0);
    }
    (dice.spread(least, 1.0), 0.0)
}

fn draw_any(dice: &mut Dice, least: f64) -> (f64, f64) {
    let x = dice.spread(-10.0, 10.0);
    if dice.once_in(2) {
        return (x, 0.0);
    }
    (dice.spread(least, (-least).exp2()), 0.0)
}

fn draw_exponent(dice: &mut Dice, least: f64) -> (f64, f64) {
    (dice.spread(-70.0, -least * 0.73), 0.0)
}

fn draw_positive(dice: &mut Dice, least: f64) -> (f64, f64) {
    let offset = dice.size(-23.0, -1.0);
    if dice.once_in(4) {
        return (1.0 + dice.signed(offset), 0.0);
    }
    (dice.size(least - 10.0, -least), 0.0)
}

fn draw_point(dice: &mut Dice, least: f64) -> (f64, f64) {
    let x = dice.size(least / 2.0, -least / 2.0);
    let y = dice.size(least / 2.0, -least / 2.0);
    let beside = x * dice.size(-10.0, 10.0);
    let y = if dice.once_in(8) { y } else { beside };
    (dice.signed(y), dice.signed(x))
}

fn draw_power(dice: &mut Dice, least: f64) -> (f64, f64) {
    let base = draw_positive(dice, least).0;
    let limit = (-least * 1.02 / base.log2().abs()).min(1e30);
    let part = if dice.once_in(2) { dice.unit() } else { dice.size(-20.0, 0.0) };
    (base, dice.signed(limit * part))
}

fn draw_small(dice: &mut Dice, least: f64) -> (f64, f64) {
    (dice.spread(least, 24.0), 0.0)
}

/// A function, its two references, its arguments, the largest error for `f64` in ulp.
struct Case {
    name: &'static str,
    single: fn(f32, f32) -> f32,
    double: fn(f64, f64) -> f64,
    close: fn(f64, f64) -> f64,
    exact: fn(&Big, &Big) -> Big,
    draw: Draw,
    bound: f64,
}

macro_rules! one_or_two {
    (1 $kind:ident $function:path) => {
        |x, _| $function(x)
    };
    (2 big $function:path) => {
        |x, y| $function(x, y)
    };
    (2 $kind:ident $function:path) => {
        $function
    };
}

macro_rules! cases {
    ($($name:ident $arity:tt $single:ident $double:ident $exact:ident $draw:ident $bound:expr;)*) => {
        $(
            mod $name {
                fn case() -> super::Case {
                    super::Case {
                        name: stringify!($name),
                        single: one_or_two!($arity f32 deadbeat_math::$single),
                        double: one_or_two!($arity f64 deadbeat_math::$double),
                        close: one_or_two!($arity f64 f64::$exact),
                        exact: one_or_two!($arity big super::Big::$exact),
                        draw: super::$draw,
                        bound: $bound,
                    }
                }

                #[test]
                fn random() {
                    super::measure(&case(), 1);
                }

                #[test]
                #[ignore = "twenty times as many arguments"]
                fn deep() {
                    super::measure(&case(), 20);
                }
            }
        )*
    };
}

cases! {
    sin 1 sin_f32 sin_f64 sin draw_angle 0.51;
    cos 1 cos_f32 cos_f64 cos draw_angle 0.51;
    tan 1 tan_f32 tan_f64 tan draw_angle 0.51;
    asin 1 asin_f32 asin_f64 asin draw_unit 0.51;
    acos 1 acos_f32 acos_f64 acos draw_unit 0.51;
    atan 1 atan_f32 atan_f64 atan draw_any 0.51;
    atan2 2 atan2_f32 atan2_f64 atan2 draw_point 0.51;
    exp 1 exp_f32 exp_f64 exp draw_exponent 0.51;
    log 1 log_f32 log_f64 ln draw_positive 0.51;
    sqrt 1 sqrt_f32 sqrt_f64 sqrt draw_positive 0.5;
    tanh 1 tanh_f32 tanh_f64 tanh draw_small 0.51;
    pow 2 pow_f32 pow_f64 powf draw_power 0.52;
}

fn big(x: f64) -> Big {
    Big::try_from(x).expect("finite").with_precision(PRECISION).value()
}

/// |value - exact| in units of the last place of a format with so many digits and least exponent.
fn error(value: f64, exact: &Big, digits: i32, least: i32) -> f64 {
    let size = exact.to_f64().value().abs();
    let exponent = i32::try_from(size.to_bits() >> 52).expect("positive") - 1023;
    let unit = exponent.max(least) - digits;
    let difference: Big = exact - Big::try_from(value).expect("finite");
    let scaled = difference << isize::try_from(-unit).expect("small");
    scaled.to_f64().value().abs()
}

/// The largest error for `f64` and where.
fn double_error(case: &Case, count: u32) -> (f64, f64, f64) {
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let mut worst = (0.0, 0.0, 0.0);
    for _ in 0..count {
        let (x, y) = (case.draw)(&mut dice, -1022.0);
        let value = (case.double)(x, y);
        if x == 0.0 || !value.is_finite() || (case.close)(x, y) == 0.0 {
            continue;
        }
        let e = error(value, &(case.exact)(&big(x), &big(y)), 52, -1022);
        if e > worst.0 {
            worst = (e, x, y);
        }
    }
    worst
}

/// The largest error for `f32` and how many results are not the nearest.
fn single_error(case: &Case, count: u32) -> (f64, u32) {
    let mut dice = Dice(0xD1B5_4A32_D192_ED03);
    let mut worst: f64 = 0.0;
    let mut wrong = 0;
    for _ in 0..count {
        let (x, y) = (case.draw)(&mut dice, -126.0);
        let (x, y) = (x as f32, y as f32);
        let value = (case.single)(x, y);
        let close = (case.close)(f64::from(x), f64::from(y));
        if x == 0.0 || close == 0.0 || !value.is_finite() {
            continue;
        }
        let low = f64::from_bits(close.to_bits() - 8) as f32;
        let high = f64::from_bits(close.to_bits() + 8) as f32;
        if low.to_bits() == high.to_bits() && value.to_bits() == low.to_bits() {
            continue;
        }
        let exact = (case.exact)(&big(f64::from(x)), &big(f64::from(y)));
        let e = error(f64::from(value), &exact, 23, -126);
        wrong += u32::from(e > 0.5);
        worst = worst.max(e);
    }
    (worst, wrong)
}

fn measure(case: &Case, times: u32) {
    let (double, x, y) = double_error(case, DOUBLE_COUNT * times);
    let (single, wrong) = single_error(case, SINGLE_COUNT * times);
    println!(
        "{:5} f64 {double:.4} ulp (at {x:e}, {y:e}); f32 {wrong} of {} not the nearest",
        case.name,
        SINGLE_COUNT * times,
    );
    assert!(double <= case.bound, "{} {x:e} {y:e}: {double} ulp", case.name);
    assert!(single <= 1.0 && wrong <= times, "{}: {wrong} not the nearest", case.name);
}
