//! An expression's value in doubles, for checks and reports; with the runtime's own elementary functions, so
//! that it is the same on every machine.

use deadbeat_math as math;

use super::poly::{Atom, Poly};
use super::{Function, Symbol, further};

/// The value, given what varies; not a number where it has none.
pub fn value(poly: &Poly, at: &dyn Fn(Symbol) -> f64) -> f64 {
    let term = |(monomial, coefficient): (&super::Monomial, &dashu_ratio::RBig)| {
        monomial.factors().iter().fold(coefficient.to_f64().value(), |product, (atom, exponent)| {
            let power = (0..exponent.unsigned_abs()).fold(1.0, |power, _| power * of_atom(atom, at));
            if *exponent < 0 { product / power } else { product * power }
        })
    };
    poly.terms().map(term).sum()
}

fn of_atom(atom: &Atom, at: &dyn Fn(Symbol) -> f64) -> f64 {
    match atom {
        Atom::Pi => std::f64::consts::PI,
        Atom::Symbol(symbol) => at(*symbol),
        Atom::Reciprocal(sum) => 1.0 / value(sum, at),
        Atom::Call(function, arguments) => {
            let values: Vec<f64> = arguments.iter().map(|argument| value(argument, at)).collect();
            of_call(*function, &values)
        }
    }
}

fn of_call(function: Function, values: &[f64]) -> f64 {
    let x = values[0];
    match function {
        Function::Sin => math::sin_f64(x),
        Function::Cos => math::cos_f64(x),
        Function::Tan => math::tan_f64(x),
        Function::Asin => math::asin_f64(x),
        Function::Acos => math::acos_f64(x),
        Function::Atan => math::atan_f64(x),
        Function::Atan2 => math::atan2_f64(x, values[1]),
        Function::Exp => math::exp_f64(x),
        Function::Log => math::log_f64(x),
        Function::Sqrt => math::sqrt_f64(x),
        Function::Abs => x.abs(),
        Function::Sign if x == 0.0 => 0.0,
        Function::Sign => x.signum(),
        Function::Min => x.min(values[1]),
        Function::Max => x.max(values[1]),
        Function::Tanh => math::tanh_f64(x),
        Function::Pow => math::pow_f64(x, values[1]),
        _ => further::double(function, values).unwrap_or(f64::NAN),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Rational;

    #[test]
    fn a_polynomial_of_functions_has_its_value() {
        let t = Poly::from(Atom::Symbol(Symbol::Time));
        let sine = Poly::call(Function::Sin, vec![t.clone()]).unwrap();
        let sum = sine.times(&t.power(-2).unwrap()).unwrap().plus(&Poly::from(Rational::from(3))).unwrap();
        let expected = math::sin_f64(0.7) / (0.7 * 0.7) + 3.0;
        assert!((value(&sum, &|_| 0.7) - expected).abs() < 1e-15);
    }
}
