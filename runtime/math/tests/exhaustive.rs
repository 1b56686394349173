//! Every `f32` argument there is, for the functions of one argument.
//!
//! The platform's double precision decides all but the few arguments within 8
//! of its last places of a rounding boundary; 160-bit arithmetic decides those.

#![allow(
    clippy::cast_possible_truncation,
    clippy::float_cmp,
    reason = "rounding to f32 and exact comparison are what is tested"
)]

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

type Big = FBig<HalfEven, 2>;

struct Case {
    name: &'static str,
    ours: fn(f32) -> f32,
    close: fn(f64) -> f64,
    exact: fn(&Big) -> Big,
    limit: f32,
    least: f32,
    wrong: u32,
}

macro_rules! case {
    ($ours:ident, $close:ident, $exact:ident, $least:expr, $limit:expr, $wrong:expr) => {
        Case {
            name: stringify!($ours),
            ours: deadbeat_math::$ours,
            close: f64::$close,
            exact: |x| x.$exact(),
            least: $least,
            limit: $limit,
            wrong: $wrong,
        }
    };
}

/// Bounds of the magnitude (beyond, a function is constant), and how many results are not the nearest.
const CASES: &[Case] = &[
    case!(sin_f32, sin, sin, 0.0, f32::INFINITY, 0),
    case!(cos_f32, cos, cos, 0.0, f32::INFINITY, 0),
    case!(tan_f32, tan, tan, 0.0, f32::INFINITY, 0),
    case!(asin_f32, asin, asin, 0.0, 1.0, 0),
    case!(acos_f32, acos, acos, 0.0, 1.0, 0),
    case!(atan_f32, atan, atan, 0.0, f32::INFINITY, 0),
    case!(exp_f32, exp, exp, 0.0, 110.0, 0),
    case!(log_f32, ln, ln, 0.0, f32::INFINITY, 0),
    case!(sqrt_f32, sqrt, sqrt, 0.0, f32::INFINITY, 0),
    case!(tanh_f32, tanh, tanh, 0.0, 100.0, 0),
];

/// The nearest `f32` of an exact number that is not one itself.
fn nearest(exact: &Big) -> f32 {
    let high = exact.to_f64().value();
    let rest = (exact - Big::try_from(high).expect("finite")).to_f64().value();
    if rest == 0.0 || high.to_bits() & 1 == 1 {
        return high as f32;
    }
    let outward = (rest > 0.0) == (high > 0.0);
    f64::from_bits(if outward { high.to_bits() + 1 } else { high.to_bits() - 1 }) as f32
}

fn check(case: &Case) {
    let mut wrong = 0;
    let mut settled = 0;
    for bits in case.least.to_bits()..case.limit.to_bits() {
        for x in [f32::from_bits(bits), -f32::from_bits(bits)] {
            if x == 0.0 || (x < 0.0 && matches!(case.name, "log_f32" | "sqrt_f32")) {
                continue;
            }
            let value = (case.ours)(x);
            let close = (case.close)(f64::from(x));
            if close == 0.0 {
                assert_eq!(value, 0.0);
                continue;
            }
            let low = f64::from_bits(close.to_bits() - 8) as f32;
            let high = f64::from_bits(close.to_bits() + 8) as f32;
            if value.to_bits() == low.to_bits() && low.to_bits() == high.to_bits() {
                continue;
            }
            let exact = Big::try_from(x).expect("finite").with_precision(160).value();
            let wanted = nearest(&(case.exact)(&exact));
            settled += 1;
            if value.to_bits() != wanted.to_bits() {
                wrong += 1;
                println!("{}({x:e}) = {value:e}, nearest {wanted:e}", case.name);
                assert!(wrong < 100, "{}", case.name);
            }
        }
    }
    println!("{}: {wrong} not the nearest; {settled} settled in 160 bits", case.name);
    assert!(wrong <= case.wrong, "{}", case.name);
}

#[test]
#[ignore = "minutes per function in release"]
fn every_f32_argument() {
    let only = std::env::var("DEADBEAT_FUNCTION").unwrap_or_default();
    for case in CASES.iter().filter(|case| case.name.contains(&only)) {
        check(case);
    }
}
