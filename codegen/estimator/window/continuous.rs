//! The single-delay observer as its paper prints it: integrals over the window, taken from samples.
//!
//! In the coordinates of 000 (2), `x1' = A1 x1 + F1(Y)`, `x2' = A2 x1 - k x2 + F2(Y)`, the estimate is
//! `xhat1 + R v - S^-1 integral of e^{ks} lambda(s)' v(t+s)` (000 (28)) with `v = Y - xhat2` and copies that are
//! driven by Y. Between samples v, and Y inside F1 and F2, run as asked for (straight lines or cubics); kernels and
//! copies are integrated exactly. So is nothing approximated but the course between samples, and that leaves an
//! error of its order, where the sampled twin ([`super::innovation`]) leaves none.
//!
//! The kernel is an exponential itself: `g(s) = e^{-ks} lambda(-s)'` and `q' = -(A1' + 2kI) q`, `q(0) = A2'`,
//! `g' = -k g + q`. Nothing inverts `A1 + kI`.

use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::real::{
    Matrix, NormTooLarge, Precision, Real, exponential, gramian, inverse, third_order_hold, zero_order_hold,
};

use super::solve;
use super::solve::{Exact, accumulate, first_ages, known_weights, of_constant};
use crate::sampled::coordinates::{Blocks, Coordinates};
use crate::sampled::model::{Between, Matrices, Model, continuous_effect};
use crate::sampled::observability::output_powers;
use crate::sampled::{Part, Signal};

/// The paper's constants (000 (4)-(7)).
#[derive(Clone, Debug)]
pub struct Constants {
    /// A1, (n-p) x (n-p).
    pub a1: Matrix,
    /// A2, p x (n-p).
    pub a2: Matrix,
    /// S, (n-p) x (n-p).
    pub s: Matrix,
    /// N, (n-p) x p.
    pub n: Matrix,
    /// R = S^-1 N.
    pub r: Matrix,
    /// S^-1.
    pub s_inverse: Matrix,
    /// H, (n-p) x p, where `A1 + kI` can be inverted.
    pub h: Option<Matrix>,
    /// `e^{-k tau}`.
    pub decay: Real,
    /// `e^{-(A1' + 2kI) tau}`.
    pub psi2: Matrix,
    /// What outputs count by, squared, p x p: S and N have it between lambda' and lambda.
    pub weight: Matrix,
}

/// Why there are none.
#[derive(Clone, Copy, Debug)]
pub enum Refused {
    /// A matrix grows beyond what is computed.
    TooFast(NormTooLarge),
    /// S cannot be inverted at this precision.
    Singular,
}

impl From<NormTooLarge> for Refused {
    fn from(error: NormTooLarge) -> Self {
        Self::TooFast(error)
    }
}

impl Constants {
    /// For `x1' = A1 x1 + …`, `x2' = A2 x1 - k x2 + …` over `tau` seconds; `trust`, p x p, is what outputs count by.
    ///
    /// # Errors
    /// [`Refused`] where a matrix grows too far within tau, or S cannot be inverted.
    pub fn new(blocks: &Blocks, k: &Real, tau: &Real, trust: &Matrix) -> Result<Self, Refused> {
        let (a1, a2) = (blocks.rr.clone(), blocks.yr.clone());
        let (rest, p, precision) = (a1.rows(), a2.rows(), a1.precision());
        let shifted = &a1 + &Matrix::identity(rest, precision).scale(k);
        // lambda(r) is the lower left block of -e^{block r}.
        let mut block = Matrix::zeros(rest + p, rest + p, precision);
        block.set_block(0, 0, &shifted);
        block.set_block(rest, 0, &a2);
        let mut seen = Matrix::zeros(p, rest + p, precision);
        seen.set_block(0, rest, trust);
        let s = gramian(&block, &seen, tau)?.block(0..rest, 0..rest);
        let eye = Matrix::identity(rest + p, precision);
        let (_, integral) = zero_order_hold(&-&block, &eye, tau)?;
        let weight = &trust.transpose() * trust;
        let n = (-&(&integral.block(rest..rest + p, 0..rest).transpose() * &weight)).with_precision(precision);
        let s_inverse = inverse(&s).map_err(|_| Refused::Singular)?;
        let r = &s_inverse * &n;
        let h = inverse(&shifted).ok().map(|inverse| &inverse.transpose() * &a2.transpose());
        let decay = (-(k * tau)).checked_exp().map_err(|_| Refused::Singular)?;
        let unstable = &a1.transpose() + &Matrix::identity(rest, precision).scale(k).shifted(1);
        let psi2 = exponential(&-&unstable.scale(tau))?;
        Ok(Self { a1, a2, s, n, r, s_inverse, h, decay, psi2, weight })
    }
}

/// What the sampled form needs beside the plant.
#[derive(Clone, Debug)]
pub struct Form {
    /// Places of the states that are estimated.
    pub rest: Vec<usize>,
    /// k, 1/s.
    pub k: crate::expr::Constant,
    /// N.
    pub steps: usize,
    /// How v and Y run between samples.
    pub between: Between,
}

impl Form {
    /// The constants at one precision, with the plant's matrices and the coordinates.
    pub fn constants(
        &self,
        plant: &Plant,
        signals: &[Signal],
        precision: Precision,
    ) -> Result<(Constants, Matrices, Coordinates), Vec<Diagnostic>> {
        let matrices = Matrices::new(plant, signals, precision)?;
        let refused = |message: &str| {
            let error = Diagnostic::error(codes::PRECISION, plant.span.clone(), message);
            vec![error.help("the exact form: `form = \"exact\"`, the default")]
        };
        let coordinates = Coordinates::new(&matrices.c, self.rest.clone())
            .map_err(|_| refused("the outputs repeat each other to all digits"))?;
        let k = self.k.evaluate(precision).map_err(|_| refused("`k` has no usable value"))?;
        let tau = &matrices.h * Real::from_i64(i64::try_from(self.steps).unwrap_or(i64::MAX), precision);
        let constants = Constants::new(&coordinates.blocks(&matrices.a), &k, &tau, &trust(plant, precision));
        let constants = constants.map_err(|error| match error {
            Refused::TooFast(error) => matrices.too_fast(plant, error),
            Refused::Singular => refused("the Gramian S cannot be inverted"),
        })?;
        Ok((constants, matrices, coordinates))
    }

    /// The functional at one precision.
    pub fn exact(&self, plant: &Plant, signals: &[Signal], precision: Precision) -> Result<Exact, Vec<Diagnostic>> {
        let (constants, matrices, coordinates) = self.constants(plant, signals, precision)?;
        let model = Model::new(plant, signals, precision)?;
        let sampled = Sampled::new(self, &constants, &matrices, &coordinates, signals, plant);
        let sampled = sampled.map_err(|error| matrices.too_fast(plant, error))?;
        let copy = &sampled.copy;
        let (accumulated, unbiasedness) =
            accumulate(copy, &sampled.innovations, &output_powers(copy, self.steps), precision);
        let into_plant = |weights: Vec<Vec<Real>>| back_to(&coordinates.back, &weights);
        let (driven, own) = copy.effects.split_at(plant.outputs.len());
        let part = sampled.part;
        let of_outputs: Vec<Vec<Vec<Real>>> =
            driven.iter().map(|effect| known_weights(effect, &accumulated, part)).collect();
        let by_age = sampled.innovations.iter().enumerate().map(|(age, v)| {
            let driven = |i: usize, o: usize| of_outputs[o][i].get(age).cloned();
            let total = Matrix::from_fn(v.rows(), v.cols(), |i, o| {
                driven(i, o).map_or_else(|| v.get(i, o).clone(), |more| v.get(i, o) + &more)
            });
            &coordinates.back * &total
        });
        let by_age: Vec<Matrix> = by_age.collect();
        let delays = vec![0; plant.outputs.len()];
        let knowns = own.iter().zip(signals).map(|(effect, s)| into_plant(known_weights(effect, &accumulated, s.part)));
        let knowns = knowns.collect();
        let constant = into_plant(of_constant(&accumulated, &copy.constant).into_iter().map(|c| vec![c]).collect());
        let constant = constant.into_iter().map(|mut c| c.remove(0)).collect();
        let prediction = (0..delays.len()).map(|o| solve::predict(&model, signals, o, 0)).collect();
        let accumulated = accumulated.iter().map(|acc| &(&coordinates.back * acc) * &coordinates.into).collect();
        Ok(Exact {
            outputs: solve::by_output(&by_age, &delays),
            first: first_ages(&model.effects),
            model,
            knowns,
            constant,
            prediction,
            accumulated,
            unbiasedness,
        })
    }
}

/// Outputs count by one over their noise where all declare it; diagonal, p x p.
fn trust(plant: &Plant, precision: Precision) -> Matrix {
    let trust = crate::sampled::model::trust(plant, precision);
    let zero = Real::zero(precision);
    Matrix::from_fn(trust.len(), trust.len(), |i, j| if i == j { trust[i].clone() } else { zero.clone() })
}

/// Weights by coordinate and age as weights by state and age.
fn back_to(back: &Matrix, weights: &[Vec<Real>]) -> Vec<Vec<Real>> {
    let p = back.precision();
    let ages = weights.first().map_or(0, Vec::len);
    let at = |i: usize, age: usize| {
        weights.iter().enumerate().fold(Real::zero(p), |sum, (j, row)| sum + back.get(i, j) * &row[age])
    };
    (0..back.rows()).map(|i| (0..ages).map(|age| at(i, age)).collect()).collect()
}

/// The copies over one sample interval, and the weights of the innovations.
struct Sampled {
    /// In the coordinates; its first effects are those of Y, then those of the signals.
    copy: Model,
    /// How Y runs.
    part: Part,
    /// By age, n x p.
    innovations: Vec<Matrix>,
}

impl Sampled {
    fn new(
        form: &Form,
        constants: &Constants,
        matrices: &Matrices,
        coordinates: &Coordinates,
        signals: &[Signal],
        plant: &Plant,
    ) -> Result<Self, NormTooLarge> {
        let precision = matrices.a.precision();
        let (p, rest) = (coordinates.outputs(), coordinates.rest.len());
        let blocks = coordinates.blocks(&matrices.a);
        let k = form.k.evaluate(precision).unwrap_or_else(|_| Real::zero(precision));
        let scaled = |size: usize, factor: &Real| Matrix::identity(size, precision).scale(factor);
        let mut a = Matrix::zeros(p + rest, p + rest, precision);
        a.set_block(0, 0, &scaled(p, &-&k));
        a.set_block(0, p, &constants.a2);
        a.set_block(p, p, &constants.a1);
        let driven = (&blocks.yy + &scaled(p, &k)).vcat(&blocks.ry);
        let part = if form.between == Between::Cubics { Part::Curves } else { Part::Runs };
        let mut effects = Vec::new();
        for o in 0..p {
            effects.push(continuous_effect(part, &a, &driven.column(o), &matrices.h)?);
        }
        for (signal, column) in signals.iter().zip(&matrices.columns) {
            effects.push(continuous_effect(signal.part, &a, &(&coordinates.into * column), &matrices.h)?);
        }
        let (phi, constant) = zero_order_hold(&a, &(&coordinates.into * &matrices.offset), &matrices.h)?;
        let mut c = Matrix::zeros(p, p + rest, precision);
        c.set_block(0, 0, &Matrix::identity(p, precision));
        let trust_by_output = crate::sampled::model::trust(plant, precision);
        let copy = Model { phi, c, effects, constant, trust: trust_by_output };
        let innovations = innovation_weights(form, constants, &k, &matrices.h, &trust(plant, precision))?;
        Ok(Self { copy, part, innovations })
    }
}

/// R on the newest, and the integral's weights by age.
fn innovation_weights(
    form: &Form,
    constants: &Constants,
    k: &Real,
    h: &Real,
    trust: &Matrix,
) -> Result<Vec<Matrix>, NormTooLarge> {
    let precision = k.precision();
    let (rest, p) = (constants.a1.rows(), constants.a2.rows());
    let scaled = |factor: &Real| Matrix::identity(rest, precision).scale(factor);
    let mut kernel = Matrix::zeros(2 * rest, 2 * rest, precision);
    kernel.set_block(0, 0, &scaled(&-k));
    kernel.set_block(0, rest, &scaled(&Real::one(precision)));
    kernel.set_block(rest, rest, &-&(&constants.a1.transpose() + &scaled(k).shifted(1)));
    let weight = &trust.transpose() * trust;
    let input = Matrix::zeros(rest, p, precision).vcat(&(&constants.a2.transpose() * &weight));
    let through = exponential(&kernel.scale(h))?;
    let curve = |start| third_order_hold(&kernel, &input, h, start);
    let shapes: Vec<Vec<Matrix>> = match form.between {
        Between::Lines | Between::Steps => {
            let (_, older, newer) = crate::real::first_order_hold(&kernel, &input, h)?;
            vec![vec![older, newer]]
        }
        Between::Cubics => vec![curve(0)?.to_vec(), curve(1)?.to_vec(), curve(2)?.to_vec()],
    };
    let mut integral = vec![Matrix::zeros(rest, p, precision); form.steps + 1];
    let mut power = Matrix::identity(2 * rest, precision);
    for newer in 0..form.steps {
        // From age `newer + 1` to age `newer`.
        let start = match form.between {
            Between::Lines | Between::Steps => 0,
            Between::Cubics if newer == 0 => 2,
            Between::Cubics => usize::from(newer + 1 < form.steps),
        };
        for (node, factor) in shapes[start].iter().enumerate() {
            let age = newer + 1 + start - node;
            integral[age] = &integral[age] + &(&power * factor).block(0..rest, 0..p);
        }
        power = &power * &through;
    }
    let eye = Matrix::identity(p, precision);
    let weights = integral.iter().enumerate().map(|(age, integral)| {
        let integral = &constants.s_inverse * integral;
        if age == 0 { eye.vcat(&(&constants.r - &integral)) } else { Matrix::zeros(p, p, precision).vcat(&-&integral) }
    });
    Ok(weights.collect())
}
