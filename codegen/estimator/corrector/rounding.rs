//! What rounding does to a corrector's estimate, and which coordinates need a second float against it.
//!
//! Every operation of a call loses half of its result's last bit. What is lost in a coordinate stays in it until
//! the corrections have made it good, which a slow gain takes thousands of calls to do: the error map's sums of
//! magnitudes say how much adds up. What is lost in an innovation is noise of its output, with the noise's gains.

mod sizes;

use nalgebra::DVector;

use super::errors::{Errors, Sums};
use super::{Corrector, Frame, Gain};
use crate::numbers::count;
use crate::plant::Plant;
use crate::program::Scalar;
use crate::program::builder::additions;
use crate::promise::rounding::{of_product, reading, unit};
use sizes::{Sizes, Terms, shown, size};

/// How much smaller the whole bound must become for a second float.
const BETTER: f64 = 10.0;
/// The share of the bound from noise up to which rounding goes unnoticed.
const NOTICED: f64 = 0.01;
/// Roundings of a state, beyond which it has lost too many of its digits whatever the noise.
const MANY: f64 = 1000.0;

/// The bound with its choice.
pub(super) struct Rounding {
    /// Per state, the most that rounding adds.
    pub(super) bound: Vec<f64>,
    /// Per coordinate, whether it needs a second float.
    pub(super) twofold: Vec<bool>,
}

impl Rounding {
    /// Of a design in single precision; `None` in double precision. Without a bound where the sums have none.
    pub(super) fn new(
        plant: &Plant,
        design: &Corrector,
        errors: &Errors,
        worst: &Sums,
        noise: &[Option<f64>],
    ) -> Option<Self> {
        if plant.scalar != Scalar::F32 {
            return None;
        }
        if !worst.carried.iter().chain(&worst.gained).chain(&worst.noise).all(|sum| sum.is_finite()) {
            // Too slow to be summed up is slow enough.
            return Some(Self { bound: Vec::new(), twofold: vec![errors.goes_round(); plant.states.len()] });
        }
        let model = Model { plant, design, worst, sizes: Sizes::new(plant, design, errors, worst, noise) };
        let n = plant.states.len();
        let (one, two) = (model.loses(&vec![false; n]), model.loses(&vec![true; n]));
        let best = model.total(&two, &vec![true; n]);
        let needed = |j: usize| {
            (0..n).any(|i| {
                let adds = worst.carried[(i, j)] * one.carried[j];
                let noticed = noise[i].is_some_and(|bound| adds > NOTICED * bound);
                let many = adds > MANY * unit(plant.scalar) * model.sizes.states[i];
                adds > BETTER * best[i] && (noticed || many)
            })
        };
        let twofold: Vec<bool> = (0..n).map(needed).collect();
        let bound = model.total(&model.loses(&twofold), &twofold);
        Some(Self { bound: bound.iter().copied().collect(), twofold })
    }
}

/// What one call loses, at most.
struct Loss {
    /// Per coordinate, in it.
    carried: DVector<f64>,
    /// Per coordinate, before its correction.
    predicted: DVector<f64>,
    /// Per output, in the innovation alone.
    innovations: DVector<f64>,
}

struct Model<'a> {
    plant: &'a Plant,
    design: &'a Corrector,
    worst: &'a Sums,
    sizes: Sizes,
}

impl Model<'_> {
    /// What a call loses where these coordinates are carried in two floats.
    fn loses(&self, twofold: &[bool]) -> Loss {
        let (design, sizes, unit) = (self.design, &self.sizes, unit(self.plant.scalar));
        let n = twofold.len();
        // The other float of what a term is of is left out of it; of a sum in two floats it is one term more.
        let predicted = DVector::from_iterator(
            n,
            (0..n).map(|i| {
                let terms = sizes.terms(design, i, twofold[i]);
                let two = if twofold[i] { sizes.carried[i] * unit + terms.sum() } else { 0.0 };
                let left_out = if twofold.contains(&true) { terms.sum() } else { 0.0 };
                unit * (terms.loses() + left_out + two)
            }),
        );
        let added = |i: usize| if twofold[i] { sizes.terms(design, i, true).sum() } else { sizes.carried[i] };
        let turned: f64 = self.plant.outputs.iter().filter_map(|output| output.wrap.as_ref()).map(|_| 1.0).sum();
        let own = |i: usize| {
            let turns = if twofold[i] { 0.0 } else { turned * sizes.carried[i] };
            unit * (added(i) + turns + self.turn(i))
        };
        let carried = DVector::from_iterator(n, (0..n).map(|i| predicted[i] + own(i)));
        let innovations = self.plant.outputs.iter().enumerate().map(|(o, output)| {
            let row = &design.output[o];
            let there = row.iter().zip(&sizes.predicted).enumerate().filter(|(_, (factor, _))| factor.is_some());
            let terms = there.map(|(j, (factor, x))| {
                let high = if twofold[j] { 1.0 } else { 0.0 };
                (size(*factor) * x, of_product(*factor) + high)
            });
            let terms = Terms(terms.collect());
            reading(output, unit) + unit * (terms.loses() + sizes.innovations[o])
        });
        Loss { carried, predicted, innovations: DVector::from_iterator(self.plant.outputs.len(), innovations) }
    }

    /// What a turn that is taken off loses by being a float itself, in units.
    fn turn(&self, i: usize) -> f64 {
        let turns = self.plant.outputs.iter().filter_map(|output| output.wrap.as_ref());
        let size = |wrap: &crate::plant::Wrap| {
            let turn = wrap.turn.to_f64().unwrap_or(f64::INFINITY).abs();
            match self.design.frame {
                Frame::Chain { .. } if i == 0 => turn,
                Frame::Chain { .. } => 0.0,
                Frame::Plant { .. } => turn * wrap.direction[i].to_f64().unwrap_or(f64::INFINITY).abs(),
            }
        };
        turns.map(size).sum()
    }

    /// What all calls add up to, per state.
    fn total(&self, loss: &Loss, twofold: &[bool]) -> DVector<f64> {
        let (sizes, worst, unit) = (&self.sizes, self.worst, unit(self.plant.scalar));
        let innovations = &loss.innovations + shown(self.design) * &loss.predicted;
        let corrections = &worst.gained * (&sizes.innovations * (unit * self.roundings()));
        let mut total = &worst.carried * &loss.carried + &worst.noise * innovations + corrections;
        for i in 0..twofold.len() {
            total[i] += unit * self.shows(i, twofold);
        }
        total
    }

    /// Roundings of a correction: its gain, its products and their sum.
    fn roundings(&self) -> f64 {
        let (n, p) = (self.plant.states.len(), self.plant.outputs.len());
        let gain = match &self.design.gain {
            Gain::Constant(_) | Gain::Table(_) | Gain::Periodic(_) => 1,
            // Powers, products, sums, a quotient; then M kappa + q.
            Gain::Countdown(_) => 5 * n + 6 + additions(n + 1),
            Gain::Sliding { .. } => 8 * n + 8 + additions(n + 1),
        };
        count(gain + 2 + additions(p))
    }

    /// What showing a state loses, in units.
    fn shows(&self, i: usize, twofold: &[bool]) -> f64 {
        let sizes = &self.sizes;
        match &self.design.frame {
            Frame::Plant { .. } => {
                if twofold[i] {
                    sizes.carried[i]
                } else {
                    0.0
                }
            }
            Frame::Chain { readout, .. } => {
                let there = readout[i].iter().zip(&sizes.carried).zip(twofold);
                let there = there.filter(|((factor, _), _)| factor.is_some());
                let terms = there
                    .map(|((factor, x), two)| (size(*factor) * x, of_product(*factor) + if *two { 1.0 } else { 0.0 }));
                Terms(terms.collect()).loses()
            }
        }
    }
}
