//! How far two computations of the same constants agree.

use super::number::Real;

/// The agreement of a coarse with a fine computation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Agreement {
    /// The fewest agreeing decimal digits over all constants, relative to each fine one; infinite
    /// if all are equal, zero if some constant agrees in nothing or is missing on one side.
    pub digits: f64,
    /// Whether all constants round to the same double.
    pub same_f64: bool,
    /// Whether all constants round to the same single-precision number.
    pub same_f32: bool,
}

/// Compares constants pairwise. Exact zeros on both sides agree perfectly; an exact zero on one
/// side only agrees in no digit.
pub fn compare<'a>(mut coarse: impl Iterator<Item = &'a Real>, mut fine: impl Iterator<Item = &'a Real>) -> Agreement {
    let mut agreement = Agreement { digits: f64::INFINITY, same_f64: true, same_f32: true };
    loop {
        match (coarse.next(), fine.next()) {
            (None, None) => return agreement,
            (Some(coarse), Some(fine)) => {
                agreement.digits = agreement.digits.min(digits(coarse, fine));
                agreement.same_f64 &= coarse.to_f64().to_bits() == fine.to_f64().to_bits();
                agreement.same_f32 &= coarse.to_f32().to_bits() == fine.to_f32().to_bits();
            }
            _ => {
                return Agreement { digits: 0.0, same_f64: false, same_f32: false };
            }
        }
    }
}

/// The agreeing decimal digits of one constant.
fn digits(coarse: &Real, fine: &Real) -> f64 {
    let difference = coarse - fine;
    if difference.is_zero() {
        return f64::INFINITY;
    }
    if fine.is_zero() {
        return 0.0;
    }
    ((fine.log2_abs() - difference.log2_abs()) * std::f64::consts::LOG10_2).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::super::number::Precision;
    use super::*;

    fn reals(values: &[f64]) -> Vec<Real> {
        values.iter().map(|&x| Real::from_f64(x, Precision::bits(200)).unwrap()).collect()
    }

    #[test]
    fn the_worst_constant_decides() {
        let fine = reals(&[1.0, -1000.0, 0.0]);
        let mut coarse = fine.clone();
        let equal = compare(coarse.iter(), fine.iter());
        assert_eq!(equal, Agreement { digits: f64::INFINITY, same_f64: true, same_f32: true });
        // One part in 2^40 of the largest: 12 digits, another double, the same single.
        coarse[1] = &coarse[1] + &coarse[1].shifted(-40);
        let close = compare(coarse.iter(), fine.iter());
        assert!((close.digits - 12.041).abs() < 0.001);
        assert!(!close.same_f64 && close.same_f32);
        coarse[0] = &coarse[0] + &coarse[0].shifted(-10);
        let poor = compare(coarse.iter(), fine.iter());
        assert!((poor.digits - 3.010).abs() < 0.001 && !poor.same_f32);
    }

    #[test]
    fn a_zero_on_one_side_or_a_missing_constant_is_no_agreement() {
        let (zero, tiny) = (reals(&[0.0]), reals(&[1e-300]));
        assert!(compare(zero.iter(), tiny.iter()).digits.abs() < 1e-12);
        assert!(compare(tiny.iter(), zero.iter()).digits.abs() < 1e-12);
        assert!(!compare(tiny.iter(), [].iter()).same_f64);
        assert!(compare([].iter(), [].iter()).same_f64);
    }
}
