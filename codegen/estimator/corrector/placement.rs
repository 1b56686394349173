//! A constant gain by the eigenvalues of the error map, for one output.
//!
//! `(I - K C) Phi` has the eigenvalues of the predictor's `Phi - (Phi K) C`, so that Ackermann's formula for the
//! latter, with Phi taken out once, gives `K = p(Phi) (O Phi)^-1 e_n`: p the wanted characteristic polynomial, O the
//! observability matrix (Kailath 1980, 3.2 and 4.1; Franklin, Powell and Workman 1998, 8.2 for the current form).

use crate::real::{Matrix, Real, Undefined, equilibrated_columns, rank, solve};

/// A wanted eigenvalue; those that are not real come with their conjugates.
#[derive(Clone, Debug)]
pub struct Pole {
    /// Real part.
    pub re: Real,
    /// Imaginary part.
    pub im: Real,
}

impl Pole {
    /// `exp(s h)`: the eigenvalue over a sample of `h` seconds of a mode `s`, rad/s.
    ///
    /// # Errors
    /// [`Undefined`] where the exponential leaves the range of numbers.
    pub fn sampled(&self, h: &Real) -> Result<Self, Undefined> {
        let radius = (&self.re * h).checked_exp()?;
        if self.im.is_zero() {
            return Ok(Self { im: Real::zero(radius.precision()), re: radius });
        }
        let angle = &self.im * h;
        Ok(Self { re: &radius * &angle.checked_cos()?, im: &radius * &angle.checked_sin()? })
    }
}

/// The monic polynomial with these roots, highest power first. Of a pair of conjugates the one above the real axis
/// stands for both, so that the coefficients are real whatever the rounding.
pub fn polynomial(poles: &[Pole]) -> Vec<Real> {
    let mut product: Option<Vec<Real>> = None;
    for pole in poles.iter().filter(|pole| !pole.im.is_negative()) {
        let one = Real::one(pole.re.precision());
        let factor = if pole.im.is_zero() {
            vec![one, -&pole.re]
        } else {
            let square = Real::sum_of_products([(&pole.re, &pole.re), (&pole.im, &pole.im)], one.precision());
            vec![one, -pole.re.shifted(1), square]
        };
        product = Some(product.map_or_else(|| factor.clone(), |product| multiply(&product, &factor)));
    }
    product.unwrap_or_default()
}

fn multiply(a: &[Real], b: &[Real]) -> Vec<Real> {
    let p = a[0].precision().max(b[0].precision());
    let term = |k: usize| {
        let pairs = a.iter().enumerate().filter_map(|(i, a)| Some((a, b.get(k.checked_sub(i)?)?)));
        Real::sum_of_products(pairs, p)
    };
    (0..a.len() + b.len() - 1).map(term).collect()
}

/// Why there is no such gain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// More or fewer outputs than one: the eigenvalues do not determine the gain.
    Outputs(usize),
    /// The rank of the observability matrix.
    Unobservable(usize),
    /// Phi has no inverse: a mode is gone within a sample, and no correction moves it.
    Singular,
}

/// K, n x 1, such that `(I - K C) Phi` has the characteristic polynomial `wanted` (monic, highest power first, n + 1
/// coefficients).
///
/// # Errors
/// [`Failure`].
pub fn gain(phi: &Matrix, c: &Matrix, wanted: &[Real]) -> Result<Matrix, Failure> {
    let (n, p) = (phi.rows(), phi.precision());
    if c.rows() != 1 {
        return Err(Failure::Outputs(c.rows()));
    }
    let mut row = c.clone();
    let mut rows = c.clone();
    for _ in 1..n {
        row = &row * phi;
        rows = rows.vcat(&row);
    }
    let seen = rank(&equilibrated_columns(&rows).0, p.as_bits() / 2).rank;
    if seen < n {
        return Err(Failure::Unobservable(seen));
    }
    let mut last = Matrix::zeros(n, 1, p);
    last[(n - 1, 0)] = Real::one(p);
    let direction = solve(&(&rows * phi), &last).map_err(|_| Failure::Singular)?;
    let mut gain = Matrix::zeros(n, 1, p);
    for coefficient in wanted {
        gain = &(phi * &gain) + &direction.scale(coefficient);
    }
    Ok(gain)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decimal::parse;
    use crate::estimator::corrector::riccati::closed_loop;
    use crate::real::Precision;

    fn real(text: &str, p: Precision) -> Real {
        Real::from_rational(&parse(text).unwrap(), p)
    }

    fn poles(texts: &[(&str, &str)], p: Precision) -> Vec<Pole> {
        texts.iter().map(|(re, im)| Pole { re: real(re, p), im: real(im, p) }).collect()
    }

    /// The characteristic polynomial, highest power first, by Faddeev's recursion.
    fn characteristic(map: &Matrix) -> Vec<Real> {
        let (n, p) = (map.rows(), map.precision());
        let mut coefficients = vec![Real::one(p)];
        let mut m = Matrix::identity(n, p);
        for k in 1..=n {
            let product = map * &m;
            let trace = (0..n).fold(Real::zero(p), |sum, i| sum + &product[(i, i)]);
            let coefficient = -(trace / Real::from_i64(i64::try_from(k).unwrap(), p));
            m = &product + &Matrix::identity(n, p).scale(&coefficient);
            coefficients.push(coefficient);
        }
        coefficients
    }

    fn plant(n: usize, p: Precision) -> (Matrix, Matrix) {
        let mut state = 7_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(99);
            Real::from_i64((state >> 33).cast_signed() - (1 << 30), p).shifted(-30)
        };
        (Matrix::from_fn(n, n, |_, _| next()), Matrix::from_fn(1, n, |_, _| next()))
    }

    /// 60 digits of every coefficient, of the map that the gain makes and of the product of its factors.
    #[test]
    fn the_error_map_has_the_eigenvalues() {
        let p = Precision::bits(512);
        for n in 1..=8 {
            let (phi, c) = plant(n, p);
            let pairs = [("-3", "4"), ("-3", "-4"), ("-7", "30"), ("-7", "-30"), ("0.5", "9"), ("0.5", "-9")];
            let reals = [("-1.5", "0"), ("-20", "0")];
            let some = [&reals[..2 - n % 2], &pairs[..n - (2 - n % 2)]].concat();
            let h = real("0.1", p);
            let sampled: Vec<Pole> = poles(&some, p).iter().map(|pole| pole.sampled(&h).unwrap()).collect();
            let wanted = polynomial(&sampled);
            let found = characteristic(&closed_loop(&phi, &c, &gain(&phi, &c, &wanted).unwrap()));
            assert_eq!(wanted.len(), n + 1);
            for (wanted, found) in wanted.iter().zip(&found) {
                assert!((wanted - found).log2_abs() < -200.0, "{n}");
            }
        }
    }

    /// Franklin, Powell and Workman, Digital Control of Dynamic Systems, 8.2: the double integrator at h = 0.1 with
    /// the eigenvalues 0.4 +- 0.4 i: predictor 1.2, 5.2; current 0.68, 5.2.
    #[test]
    fn the_satellite_of_the_textbook() {
        let p = Precision::bits(256);
        let one = Real::one(p);
        let phi = Matrix::from_fn(2, 2, |i, j| match (i, j) {
            (0, 1) => real("0.1", p),
            (1, 0) => Real::zero(p),
            _ => one.clone(),
        });
        let c = Matrix::from_fn(1, 2, |_, j| if j == 0 { one.clone() } else { Real::zero(p) });
        let wanted = polynomial(&poles(&[("0.4", "0.4"), ("0.4", "-0.4")], p));
        let gain = gain(&phi, &c, &wanted).unwrap();
        assert!((&gain[(0, 0)] - &real("0.68", p)).log2_abs() < -240.0);
        assert!((&gain[(1, 0)] - &real("5.2", p)).log2_abs() < -240.0);
        let predictor = &phi * &gain;
        assert!((&predictor[(0, 0)] - &real("1.2", p)).log2_abs() < -240.0);
    }

    #[test]
    fn what_cannot_be_placed_is_said() {
        let p = Precision::bits(256);
        let wanted = polynomial(&poles(&[("0.4", "0"), ("0.5", "0")], p));
        let identity = Matrix::identity(2, p);
        let (phi, c) = plant(2, p);
        assert_eq!(gain(&phi, &identity, &wanted), Err(Failure::Outputs(2)));
        assert_eq!(gain(&identity, &c, &wanted), Err(Failure::Unobservable(1)));
        let shift = Matrix::from_fn(2, 2, |i, j| Real::from_i64(i64::from(i + 1 == j), p));
        let first = Matrix::from_fn(1, 2, |_, j| Real::from_i64(i64::from(j == 0), p));
        assert_eq!(gain(&shift, &first, &wanted), Err(Failure::Singular));
    }
}
