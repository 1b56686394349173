//! 002's constants in continuous time, by the exosystem.
//!
//! With `gamma_i = D_i w`, `w' = S w`, one Gramian over tau of `A_a = [[A, D], [0, S]]`, `[C 0]` contains
//! everything (window-observers, section 2): `E = G_11`, `kappa(gamma_t) = -G_12 w(t)`, and `E_h`, theta of Theorem 2 are
//! the blocks of `exp(-A_a' h) G exp(-A_a h)`. W is that of (4): the paper's (25)-(27) add `W(0)` to it, which is
//! wrong unless gamma vanishes before t = 0.

use crate::expr::{Constant, Monomial, Poly, Symbol};
use crate::plant::{Plant, Unknown};
use crate::real::{
    Matrix, NormTooLarge, Precision, Rational, Real, Singular, exponential, gramian, inverse, zero_order_hold,
};

use super::augment::own_states;
use super::functions::{closure, monomials};

/// A gamma as the output of an exosystem.
#[derive(Clone, Debug)]
pub struct Exosystem {
    /// w, functions of time.
    pub members: Vec<Poly>,
    /// D, n x members.
    pub enters: Vec<Vec<Constant>>,
    /// S.
    pub change: Vec<Vec<Constant>>,
}

impl Exosystem {
    /// That of an unknown whose gamma is a sum of functions of time that close; `None` for others.
    pub fn of(unknown: &Unknown) -> Option<Self> {
        let n = unknown.gamma.len();
        let parts = monomials(unknown, n);
        let mut system = super::functions::System::new();
        for monomial in parts.keys() {
            system.extend(closure(monomial)?);
        }
        let names: Vec<&Monomial> = system.keys().collect();
        let entry = |i: usize, m: &Monomial| parts.get(m).map_or_else(Constant::default, |column| column[i].clone());
        Some(Self {
            members: names.iter().map(|m| Poly::monomial((*m).clone(), Rational::ONE)).collect(),
            enters: (0..n).map(|i| names.iter().map(|m| entry(i, m)).collect()).collect(),
            change: names
                .iter()
                .map(|row| names.iter().map(|m| system[*row].get(*m).cloned().unwrap_or_default()).collect())
                .collect(),
        })
    }

    /// w(t), in doubles.
    pub fn at(&self, t: f64) -> Vec<f64> {
        let time = |symbol: Symbol| if symbol == Symbol::Time { t } else { f64::NAN };
        self.members.iter().map(|poly| crate::expr::value::value(poly, &time)).collect()
    }
}

/// Times of the paper, s.
#[derive(Clone, Copy, Debug)]
pub struct Times<'a> {
    /// tau.
    pub window: &'a Real,
    /// T.
    pub integration: &'a Real,
    /// h.
    pub delay: &'a Real,
}

/// The constants that belong to one unknown; times w(t) where they have a column per member.
#[derive(Clone, Debug)]
pub struct Constants {
    /// E, n x n, (2).
    pub e: Matrix,
    /// E^-1.
    pub e_inverse: Matrix,
    /// kappa, n x members, (3).
    pub kappa: Matrix,
    /// W, 1 x members, (4).
    pub w: Matrix,
    /// `E_h`, n x n, (42).
    pub e_h: Matrix,
    /// theta, n x members, (43).
    pub theta: Matrix,
}

/// Why there are none.
#[derive(Clone, Debug)]
pub enum Trouble {
    /// An exponential that is too large.
    TooLarge(NormTooLarge),
    /// E cannot be inverted.
    Singular(Singular),
    /// A constant without a value.
    Domain(String),
}

/// The constants of an augmented continuous plant with one output, for one of its unknowns.
pub fn constants(plant: &Plant, exosystem: &Exosystem, times: Times, p: Precision) -> Result<Constants, Trouble> {
    let (n, m) = (own_states(plant), exosystem.members.len());
    let value = |constant: &Constant| constant.evaluate(p).map_err(|error| Trouble::Domain(error.0));
    let mut whole = Matrix::zeros(n + m, n + m, p);
    for i in 0..n {
        for j in 0..n {
            whole[(i, j)] = value(&plant.a[i][j])?;
        }
        for j in 0..m {
            whole[(i, n + j)] = value(&exosystem.enters[i][j])?;
        }
    }
    for i in 0..m {
        for j in 0..m {
            whole[(n + i, n + j)] = value(&exosystem.change[i][j])?;
        }
    }
    let mut c = Matrix::zeros(1, n + m, p);
    for j in 0..n {
        c[(0, j)] = value(&plant.c[0][j])?;
    }
    let negative = |matrix: &Matrix| matrix.scale(&-Real::one(p));
    let joint = gramian(&whole, &c, times.window).map_err(Trouble::TooLarge)?;
    let e = joint.block(0..n, 0..n);
    let e_inverse = inverse(&e).map_err(Trouble::Singular)?;
    let kappa = negative(&joint.block(0..n, n..n + m));
    let (a, enters) = (whole.block(0..n, 0..n), whole.block(0..n, n..n + m));
    let back = negative(&whole.block(n..n + m, n..n + m));
    let (_, past) = zero_order_hold(&back, &Matrix::identity(m, p), times.integration).map_err(Trouble::TooLarge)?;
    let rate = &c.block(0..1, 0..n) * &(&(&(&a * &e_inverse) * &kappa) + &enters);
    let earlier = exponential(&negative(&whole.scale(times.delay))).map_err(Trouble::TooLarge)?;
    let late = &(&earlier.transpose() * &joint) * &earlier;
    Ok(Constants {
        w: &rate * &past,
        e_h: late.block(0..n, 0..n),
        theta: negative(&late.block(0..n, n..n + m)),
        e,
        e_inverse,
        kappa,
    })
}
