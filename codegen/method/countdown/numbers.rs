//! The numbers of a gain law, and what stands against them.

use std::ops::Range;

use super::keys::{Keys, LawKeys};
use crate::decimal::show;
use crate::diagnostic::{Diagnostic, codes};
use crate::expr::{Constant, List};
use crate::numbers::count;
use crate::plant::Plant;
use crate::real::Rational;
use crate::spec::Quantity;

/// A law with its numbers.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// L, T.
    EfimovOrlov(Vec<Constant>),
    /// m, l.
    HollowayKrstic(usize, Vec<Constant>),
    /// p.
    Poles(Constant),
}

pub(super) fn numbers(plant: &Plant, keys: &Keys, order: usize, found: &mut Vec<Diagnostic>) -> Option<Numbers> {
    match &keys.law {
        // So that a ten-thousandth of the worst initial error is left with N/10 steps left, at any order.
        None => Some(Numbers::Poles(Constant::from(Rational::from(10.max((4 * order).saturating_sub(8)))))),
        Some(LawKeys::Poles(p)) => {
            let value = plant.constant(p, found)?;
            positive(&value, "p", &p.span(), found).then_some(Numbers::Poles(value))
        }
        Some(LawKeys::EfimovOrlov(list, span)) => {
            let values = listed(plant, list, span, ("L", order), found)?;
            let mut each = values.iter().zip(list).enumerate();
            let above = each.all(|(i, (v, place))| positive(v, &format!("L_{}", i + 1), &place.span(), found));
            above.then_some(Numbers::EfimovOrlov(values))
        }
        Some(LawKeys::HollowayKrstic(m, list, span)) => {
            let values = match list {
                None => vec![Constant::default(); order],
                Some(list) => listed(plant, list, span, ("l", order), found)?,
            };
            if *m == 0 {
                let error = Diagnostic::error(codes::BAD_NUMBER, span.clone(), "`m` must be at least 1").measured(0.0);
                found.push(error.help("write `m = 1`"));
                return None;
            }
            let below = values.iter().position(|v| v.to_f64().unwrap_or(f64::NAN) < 0.0);
            if let Some(i) = below {
                let message = format!("l_{} must not be below 0", i + 1);
                let number = values[i].to_f64().unwrap_or(f64::NAN);
                let place = list.as_ref().map_or_else(|| span.clone(), |list| list[i].span());
                let error = Diagnostic::error(codes::BAD_NUMBER, place, message).measured(number);
                found.push(
                    error.help("take the coefficients of a polynomial with all roots to the left, such as [2, 1]"),
                );
                return None;
            }
            if let Some(root) = unstable(&values) {
                let message = "the polynomial s^n + l_1 s^(n-1) + … + l_n is not stable";
                let error = Diagnostic::error(codes::BAD_NUMBER, span.clone(), message).measured(root);
                let label = format!("a root has the real part {}", crate::numbers::short(root));
                found.push(
                    error.label(label).help("leave `l` out, or take one with all roots to the left, such as [2, 1]"),
                );
                return None;
            }
            Some(Numbers::HollowayKrstic(*m, values))
        }
    }
}

/// The real part of the rightmost root of `s^n + l_1 s^(n-1) + … + l_n`, where it is not to the left; all l = 0 are 003's
/// form.
fn unstable(l: &[Constant]) -> Option<f64> {
    let l: Vec<f64> = l.iter().map(|x| x.to_f64().unwrap_or(f64::NAN)).collect();
    if l.iter().all(|x| *x == 0.0) {
        return None;
    }
    let n = l.len();
    let companion = |i: usize, j: usize| f64::from(u8::from(j == i + 1)) - if j == 0 { l[i] } else { 0.0 };
    let roots = nalgebra::DMatrix::from_fn(n, n, companion).complex_eigenvalues();
    let (right, size) = roots.iter().fold((f64::NEG_INFINITY, 0.0_f64), |(right, size), z| {
        (z.re.max(right), size.max((z.re * z.re + z.im * z.im).sqrt()))
    });
    // A root on the axis is found off it by the n-th root of the rounding at most.
    (right >= -1e-9 * size).then_some(right)
}

fn positive(value: &Constant, name: &str, span: &Range<usize>, found: &mut Vec<Diagnostic>) -> bool {
    let number = value.to_f64().unwrap_or(f64::NAN);
    if number > 0.0 {
        return true;
    }
    let message = format!("{name} must be above 0, not {}", show(number));
    let error = Diagnostic::error(codes::BAD_NUMBER, span.clone(), message).measured(number);
    let label = "without it the gains' denominator may vanish";
    found.push(error.label(label).help("take gains whose poles lie to the left, such as `poles = { p = 10 }`"));
    false
}

/// As many numbers as there are states.
pub fn listed(
    plant: &Plant,
    list: &[Quantity],
    span: &Range<usize>,
    (name, wanted): (&str, usize),
    found: &mut Vec<Diagnostic>,
) -> Option<Vec<Constant>> {
    let values: Vec<Option<Constant>> = list.iter().map(|q| plant.constant(q, found)).collect();
    let values: Vec<Constant> = values.into_iter().collect::<Option<_>>()?;
    if values.len() == wanted {
        return Some(values);
    }
    let states: Vec<&str> = plant.states.iter().map(|s| s.label.name.as_str()).collect();
    let message = format!("`{name}` needs {wanted} numbers, one per state");
    let error = Diagnostic::error(codes::SHAPE, span.clone(), message).measured(count(values.len()));
    found.push(error.label(format!("these are {}", values.len())).help(format!("the states are {}", List(&states))));
    None
}
