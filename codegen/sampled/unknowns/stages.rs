//! 002's two stages as weights, for one output and one unknown of constant gamma, made exact for samples.
//!
//! Sums over samples stand for the paper's integrals and powers of Phi for its exponentials; they tend to
//! them with the sample time and are exact for any. With `B_j = C Phi^-j`, and `P_j` what gamma does to the
//! state in j samples, `B_j x_m = y_(m-j) + eps B_j P_j`, so that with `E = sum B' B`, `kappa = sum B' B P`
//!
//! `x_m = E^-1 (sum B_j' y_(m-j) + eps kappa)`, the first stage (002 (19), (54), (75)).
//!
//! The second stage finds eps: from `C (x_k - x_(k-T))` against the sum of `C (Phi - I) x_m` between
//! (Theorem 1, (10), (23)); or from what the first stage, at the delay's begin, says of `y_m` itself, averaged
//! over T (Theorem 2, (57)); or likewise from the samples before `y_m` (Theorem 3, (66)).

use crate::real::{Matrix, Real, Singular, inverse};
use crate::sampled::model::Model;

/// Which of 002's theorems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theorem {
    /// Continuous time, no delay.
    One,
    /// Continuous time, a delayed measurement.
    Two,
    /// Discrete time.
    Three,
}

/// The lengths of both stages in samples.
#[derive(Clone, Copy, Debug)]
pub struct Stages {
    /// Which theorem.
    pub theorem: Theorem,
    /// tau; in Theorem 3 the number of samples before the newest (the paper's n).
    pub window: usize,
    /// T; in Theorem 2 the paper has tau here, in Theorem 3 it is r.
    pub integration: usize,
    /// `tau_1`, by which Theorem 1 takes eps late.
    pub shift: usize,
    /// h, of the measurement.
    pub delay: usize,
}

/// The first stage: `x_m = sum first_j y_(m-j) + eps share`.
pub struct First {
    /// `E^-1 B_j'` by call age, n x 1; nothing at ages that it does not use.
    pub weights: Vec<Option<Matrix>>,
    /// E; `E_h`, F.
    pub gramian: Matrix,
    /// kappa; theta, M; n x 1.
    pub kappa: Matrix,
    /// `E^-1 kappa`.
    pub share: Matrix,
}

impl Stages {
    /// State ages that the weights reach back to.
    pub fn steps(&self) -> usize {
        match self.theorem {
            Theorem::One => self.window + self.integration + self.shift,
            Theorem::Two => self.window + self.integration + 2 * self.delay,
            Theorem::Three => self.window + self.integration,
        }
    }

    /// The first stage for a plant whose last state is the unknown.
    ///
    /// # Errors
    /// If Phi cannot be inverted, or the window does not show every state.
    pub fn first(&self, model: &Model) -> Result<First, Singular> {
        let (phi, gamma, c) = parts(model);
        let (n, p) = (phi.rows(), phi.precision());
        let backwards = inverse(&phi)?;
        let skipped = if self.theorem == Theorem::Three { 1 } else { self.delay };
        let last = if self.theorem == Theorem::Three { self.window } else { self.window + self.delay };
        let (mut row, mut moved) = (c, Matrix::zeros(n, 1, p));
        let (mut gramian, mut kappa) = (Matrix::zeros(n, n, p), Matrix::zeros(n, 1, p));
        let mut rows = Vec::new();
        for age in 0..=last {
            if age >= skipped {
                gramian = &gramian + &(&row.transpose() * &row);
                kappa = &kappa + &(&row.transpose() * &(&row * &moved));
                rows.push(Some(row.transpose()));
            } else if self.theorem == Theorem::Three {
                rows.push(None);
            }
            row = &row * &backwards;
            moved = &(&phi * &moved) + &gamma;
        }
        let inverted = inverse(&gramian)?;
        let weights = rows.into_iter().map(|row| row.map(|row| &inverted * &row)).collect();
        let share = &inverted * &kappa;
        Ok(First { weights, gramian, kappa, share })
    }

    /// What eps is multiplied by in the second stage, per sample: W / T, or the root of rho / T.
    pub fn divisor(&self, model: &Model, first: &First) -> Real {
        let (phi, gamma, c) = parts(model);
        let seen = match self.theorem {
            Theorem::One => &c * &(&(&(&phi - &Matrix::identity(phi.rows(), phi.precision())) * &first.share) + &gamma),
            Theorem::Two | Theorem::Three => &c * &first.share,
        };
        seen.get(0, 0).clone()
    }

    /// K by call age, (n+1) x 1 each: of the plant's states, then of eps.
    ///
    /// # Errors
    /// As [`Stages::first`], or if the second stage does not see eps.
    pub fn weights(&self, model: &Model) -> Result<Vec<Matrix>, Singular> {
        let (phi, _, c) = parts(model);
        let (n, p) = (phi.rows(), phi.precision());
        let first = self.first(model)?;
        let calls = self.steps() + 1 - self.delay;
        let mut eps = vec![Real::zero(p); calls];
        let mut add = |age: usize, value: Real| eps[age] = &eps[age] + &value;
        let divisor = self.divisor(model, &first);
        let samples = match self.theorem {
            Theorem::One => self.integration,
            Theorem::Two | Theorem::Three => self.integration + 1,
        };
        let unseen = Singular { column: n };
        let whole = &divisor * &Real::from_i64(i64::try_from(samples).unwrap_or(i64::MAX), p);
        let scale = Real::one(p).checked_div(&whole).map_err(|_| unseen)?;
        let through = match self.theorem {
            Theorem::One => &c * &(&phi - &Matrix::identity(n, p)),
            Theorem::Two | Theorem::Three => c.clone(),
        };
        let explained: Vec<Option<Real>> =
            first.weights.iter().map(|w| w.as_ref().map(|w| &(&through * w).get(0, 0).clone() * &scale)).collect();
        let ages = match self.theorem {
            Theorem::One => {
                add(self.shift, scale.clone());
                add(self.shift + self.integration, -scale.clone());
                self.shift + 1..=self.shift + self.integration
            }
            Theorem::Two | Theorem::Three => {
                (0..=self.integration).for_each(|age| add(age, scale.clone()));
                self.delay..=self.delay + self.integration
            }
        };
        for age in ages {
            for (j, value) in explained.iter().enumerate() {
                if let Some(value) = value {
                    add(age + j, -value.clone());
                }
            }
        }
        let column = |age: usize| {
            let own = first.weights.get(age).and_then(Option::as_ref);
            Matrix::from_fn(n + 1, 1, |i, _| match own {
                _ if i == n => eps[age].clone(),
                Some(own) => own.get(i, 0) + &(first.share.get(i, 0) * &eps[age]),
                None => first.share.get(i, 0) * &eps[age],
            })
        };
        Ok((0..calls).map(column).collect())
    }
}

/// Phi, Gamma, C of the plant without the unknown, which is the last state.
fn parts(model: &Model) -> (Matrix, Matrix, Matrix) {
    let n = model.phi.rows() - 1;
    (model.phi.block(0..n, 0..n), model.phi.block(0..n, n..n + 1), model.c.block(0..1, 0..n))
}
