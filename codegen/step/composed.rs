//! Functions that a step makes of others: log10, log2, exp2, sinh, cosh, cbrt, floor, hypot.
//!
//! Their operations are the Program's, so that they have the same bits in every language. Each is as accurate as its parts
//! allow, which the tests below measure against multiprecision; a value that is no number stays none.

use crate::expr::Function;
use crate::program::builder::Builder;
use crate::program::{self, Scalar, Value};

/// A function of values; `None` for those that a Program has itself.
pub fn call(b: &mut Builder, function: Function, values: &[Value]) -> Option<Value> {
    let x = values[0];
    Some(match function {
        Function::Log10 => logarithm(b, x, [std::f64::consts::LOG10_E, LOG10_E_REST]),
        Function::Log2 => logarithm(b, x, [std::f64::consts::LOG2_E, LOG2_E_REST]),
        Function::Exp2 => {
            let two = b.float(2.0);
            b.call(program::Function::Pow, &[two, x])
        }
        Function::Cosh => grown(b, x).1,
        Function::Sinh => sinh(b, x),
        Function::Cbrt => cbrt(b, x),
        Function::Floor => floor(b, x),
        Function::Hypot => hypot(b, x, values[1]),
        _ => return None,
    })
}

/// What the double of log10(e) is too small by.
const LOG10_E_REST: f64 = 1.098_319_650_216_765e-17;
/// What the double of log2(e) is too small by.
const LOG2_E_REST: f64 = 2.035_527_374_093_103_3e-17;

/// The natural logarithm times a constant in two parts.
fn logarithm(b: &mut Builder, x: Value, [scale, rest]: [f64; 2]) -> Value {
    let natural = b.call(program::Function::Log, &[x]);
    let (scale, rest) = match b.scalar() {
        Scalar::F64 => (scale, rest),
        Scalar::F32 => (single(scale), single(scale - single(scale))),
    };
    let (scale, rest) = (b.float(scale), b.float(rest));
    let (large, small) = (b.mul(natural, scale), b.mul(natural, rest));
    b.add(large, small)
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to the nearest single is what is asked")]
fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

/// |x|, cosh x and the magnitude of sinh x where it is not small.
fn grown(b: &mut Builder, x: Value) -> (Value, Value, Value) {
    let (size, half) = (b.absolute(x), b.float(0.5));
    let grown = b.call(program::Function::Exp, &[size]);
    let (rising, falling) = (b.mul(half, grown), b.div(half, grown));
    let (cosh, sinh) = (b.add(rising, falling), b.sub(rising, falling));
    (size, cosh, sinh)
}

/// Below 1 the exponentials cancel: there it is tanh times cosh.
fn sinh(b: &mut Builder, x: Value) -> Value {
    let (size, cosh, large) = grown(b, x);
    let (tanh, one, zero) = (b.call(program::Function::Tanh, &[size]), b.float(1.0), b.float(0.0));
    let small = b.mul(tanh, cosh);
    let is_small = b.less(size, one);
    let magnitude = b.select(is_small, small, large);
    let (below, mirrored) = (b.less(x, zero), b.neg(magnitude));
    b.select(below, mirrored, magnitude)
}

/// A power, and one step of Newton's method for what the rounded exponent spoils: with a logarithm of 700, 60 of its last
/// places.
fn cbrt(b: &mut Builder, x: Value) -> Value {
    let (size, zero, three) = (b.absolute(x), b.float(0.0), b.float(3.0));
    let third = match b.scalar() {
        Scalar::F64 => 1.0 / 3.0,
        Scalar::F32 => single(1.0 / 3.0),
    };
    let third = b.float(third);
    let near = b.call(program::Function::Pow, &[size, third]);
    let square = b.mul(near, near);
    let cube = b.mul(square, near);
    let (off, slope) = (b.sub(cube, size), b.mul(three, square));
    let off = b.div(off, slope);
    let root = b.sub(near, off);
    let above = b.less(zero, size);
    let root = b.select(above, root, size);
    let (below, mirrored) = (b.less(x, zero), b.neg(root));
    b.select(below, mirrored, root)
}

/// Adding and subtracting a number from which on floats are whole rounds to the nearest whole number.
fn floor(b: &mut Builder, x: Value) -> Value {
    let whole = b.float(match b.scalar() {
        Scalar::F32 => 8_388_608.0,
        Scalar::F64 => 4_503_599_627_370_496.0,
    });
    let (size, zero, one) = (b.absolute(x), b.float(0.0), b.float(1.0));
    let near = b.add(size, whole);
    let near = b.sub(near, whole);
    let (less, more) = (b.sub(near, one), b.add(near, one));
    let (is_above, is_below) = (b.less(size, near), b.less(near, size));
    let (down, up) = (b.select(is_above, less, near), b.select(is_below, more, near));
    let (negative, mirrored) = (b.less(x, zero), b.neg(up));
    let floor = b.select(negative, mirrored, down);
    let has_parts = b.less(size, whole);
    b.select(has_parts, floor, x)
}

/// The larger side times the root of one and the square of their quotient: nothing overflows before the result does.
fn hypot(b: &mut Builder, x: Value, y: Value) -> Value {
    let (x, y) = (b.absolute(x), b.absolute(y));
    let longer = b.less(x, y);
    let (large, small) = (b.select(longer, y, x), b.select(longer, x, y));
    let (zero, one) = (b.float(0.0), b.float(1.0));
    let quotient = b.div(small, large);
    let square = b.mul(quotient, quotient);
    let sum = b.add(one, square);
    let root = b.call(program::Function::Sqrt, &[sum]);
    let length = b.mul(large, root);
    let is_zero = b.less_equal(large, zero);
    // Where y is no number, x is `large`.
    let nothing = b.add(large, small);
    b.select(is_zero, nothing, length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Constant, Poly};
    use crate::program::interp::Interpreter;
    use crate::program::{Field, Kind, Status};
    use crate::real::{Precision, Rational, Real};

    fn field(name: &str) -> Field {
        Field { name: name.to_owned(), unit: String::new(), doc: String::new(), kind: Kind::Float }
    }

    /// A Program that computes a function of its two measurements.
    fn program(function: Function, scalar: Scalar) -> program::Program {
        let mut b = Builder::new("example", scalar, 0.125);
        let places = [b.measurement(field("a")), b.measurement(field("b"))];
        let values = places.map(|place| b.read_measurement(place));
        let value = call(&mut b, function, &values).unwrap();
        b.estimate(field("value"), value);
        let status = b.status(Status::Converged);
        b.report(status);
        b.finish()
    }

    fn value(interpreter: &mut Interpreter, arguments: [f64; 2]) -> f64 {
        let mut estimate = [0.0];
        interpreter.step(&arguments, &[], &mut estimate);
        estimate[0]
    }

    /// At 160 bits.
    fn exactly(function: Function, arguments: &[f64]) -> Real {
        let p = Precision::bits(160);
        let exact = |x: &f64| Poly::from(Real::from_f64(*x, p).unwrap().to_rational().unwrap());
        let poly = Poly::call(function, arguments.iter().map(exact).collect()).unwrap();
        Constant::try_from(poly).unwrap().evaluate(p).unwrap()
    }

    /// Pseudo-random numbers in [0, 1).
    struct Dice(u64);

    impl Dice {
        fn unit(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            f64::from(u32::try_from(self.0 >> 32).unwrap()) / 4_294_967_296.0
        }

        /// Either sign, half uniform up to a limit, half with a uniform logarithm.
        fn spread(&mut self, least: f64, limit: f64) -> f64 {
            let size = if self.unit() < 0.5 {
                limit * self.unit()
            } else {
                (least + (limit.log2() - least) * self.unit()).exp2()
            };
            if self.unit() < 0.5 { -size } else { size }
        }
    }

    /// Draws the arguments of a function, for a scalar with exponents down to `least`.
    fn draw(function: Function, dice: &mut Dice, least: f64) -> Vec<f64> {
        match function {
            Function::Log10 | Function::Log2 if dice.unit() < 0.3 => vec![1.0 + dice.spread(-20.0, 0.5)],
            Function::Log10 | Function::Log2 | Function::Cbrt => vec![dice.spread(least, (-least).exp2()).abs()],
            Function::Exp2 => vec![dice.spread(-20.0, -least - 1.0)],
            Function::Hypot => {
                let x = dice.spread(least / 2.0, (-least / 2.0).exp2());
                vec![x, x * dice.spread(-10.0, 1000.0)]
            }
            _ => vec![dice.spread(least / 2.0, -least * 0.69)],
        }
    }

    /// The distance of two numbers in units in the last place of the exact one.
    fn apart(ours: f64, exact: &Real, scalar: Scalar) -> f64 {
        let bits = if scalar == Scalar::F32 { 24 } else { 53 };
        let off = (&Real::from_f64(ours, exact.precision()).unwrap() - exact).abs();
        off.shifted(bits - exact.top().unwrap()).to_f64()
    }

    /// The largest error in units in the last place, of 4,000 arguments each. Roundings add up to as much: of a logarithm three,
    /// each up to one in the last place where a mantissa is near 1; measured against mpmath: at most 2.04, of `sinh` in f32.
    #[test]
    fn composed_functions_are_accurate() {
        for (function, most) in [
            (Function::Log10, 2.1),
            (Function::Log2, 2.1),
            (Function::Exp2, 1.1),
            (Function::Cosh, 1.6),
            (Function::Sinh, 2.2),
            (Function::Cbrt, 1.4),
            (Function::Hypot, 2.0),
        ] {
            for (scalar, least) in [(Scalar::F32, -120.0), (Scalar::F64, -1000.0)] {
                let program = program(function, scalar);
                let (mut interpreter, mut dice, mut worst) =
                    (Interpreter::new(&program), Dice(0x9e37_79b9_7f4a_7c15), (0.0, vec![]));
                for _ in 0..4_000 {
                    let mut arguments = draw(function, &mut dice, least);
                    if scalar == Scalar::F32 {
                        for x in &mut arguments {
                            *x = single(*x);
                        }
                    }
                    let exact = exactly(function, &arguments);
                    if exact.is_zero() {
                        continue;
                    }
                    let ours = value(&mut interpreter, [arguments[0], arguments.last().copied().unwrap()]);
                    let off = apart(ours, &exact, scalar);
                    if off > worst.0 {
                        worst = (off, arguments);
                    }
                }
                println!("{function:?} {scalar}: {:.3} ulp at {:?}", worst.0, worst.1);
                assert!(worst.0 <= most, "{function:?} {scalar}: {} ulp at {:?}", worst.0, worst.1);
                assert!(worst.0 > 0.45, "{function:?} {scalar}: measured nothing");
            }
        }
    }

    /// A floor is exact, also of whole numbers, huge ones and what is next to them.
    #[test]
    fn floors_are_exact() {
        for scalar in [Scalar::F32, Scalar::F64] {
            let program = program(Function::Floor, scalar);
            let (mut interpreter, mut dice) = (Interpreter::new(&program), Dice(7));
            for k in 0..4_000_i32 {
                let whole = f64::from(k % 200 - 100);
                let x = match k % 4 {
                    0 => whole,
                    1 => whole + dice.spread(-20.0, 0.5),
                    2 => dice.spread(-30.0, 1e7),
                    _ => dice.spread(-30.0, 1e30),
                };
                let x = if scalar == Scalar::F32 { single(x) } else { x };
                assert_eq!(value(&mut interpreter, [x, 0.0]), x.floor(), "{scalar}: {x}");
            }
        }
    }

    /// What is no number stays none, whichever argument it is; a length of nothing is nothing.
    #[test]
    fn what_has_no_value_has_none() {
        let all = [
            Function::Log10,
            Function::Log2,
            Function::Exp2,
            Function::Cosh,
            Function::Sinh,
            Function::Cbrt,
            Function::Floor,
        ];
        for scalar in [Scalar::F32, Scalar::F64] {
            for function in all {
                let program = program(function, scalar);
                assert!(value(&mut Interpreter::new(&program), [f64::NAN, 1.0]).is_nan(), "{function:?}");
            }
            let program = program(Function::Hypot, scalar);
            let mut hypot = Interpreter::new(&program);
            for arguments in [[f64::NAN, 0.0], [0.0, f64::NAN], [1.0, f64::NAN], [f64::NAN, 1.0]] {
                assert!(value(&mut hypot, arguments).is_nan(), "{arguments:?}");
            }
            assert_eq!(value(&mut hypot, [0.0, 0.0]), 0.0);
            assert_eq!(value(&mut hypot, [-3.0, 4.0]), 5.0);
        }
    }

    /// The two parts of the constants are those of the logarithms.
    #[test]
    fn the_constants_are_logarithms() {
        let p = Precision::bits(160);
        for (n, large, small) in
            [(10, std::f64::consts::LOG10_E, LOG10_E_REST), (2, std::f64::consts::LOG2_E, LOG2_E_REST)]
        {
            let exact =
                Real::one(p).checked_div(&Real::from_rational(&Rational::from(n), p).checked_ln().unwrap()).unwrap();
            assert_eq!((&exact - &Real::from_f64(large, p).unwrap()).to_f64(), small);
        }
    }
}
