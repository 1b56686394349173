//! What is known besides the outputs, and what it does over one sample interval.
//!
//! A signal is evaluated once a call, or, when it jumps with a held input, at each of the samples that its
//! polynomial goes through with the input of the interval, so that a jump costs nothing. Its taps are the factors
//! of its newest values in the state at the interval's end.

use std::collections::BTreeSet;

use crate::expr::Symbol;
use crate::plant::combine::{Change, change};
use crate::plant::{Hold, Plant};
use crate::real::{Matrix, NormTooLarge, Real, first_order_hold, third_order_hold, zero_order_hold};
use crate::sampled::Source;

use crate::sampled::model::Between;

/// Something known at each call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// What it is.
    pub source: Source,
    /// In the user's names.
    pub text: String,
    /// Calls since the samples that it is evaluated with; the inputs are those of this call.
    pub ago: usize,
    /// How it runs over an interval.
    pub run: Run,
    /// Whether it is evaluated again at every sample of its polynomial, with one tap each.
    pub jumps: bool,
}

/// How a signal runs over a sample interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// Constant since the call before.
    Held,
    /// Straight from the call before.
    Straight,
    /// On the polynomial through this call's value and three before.
    Cubic,
    /// A discrete plant's: the value at the call before, for the whole step.
    Begin,
}

impl From<Between> for Run {
    fn from(between: Between) -> Self {
        match between {
            Between::Lines | Between::Steps => Self::Straight,
            Between::Cubics => Self::Cubic,
        }
    }
}

impl Run {
    /// Values that it goes through.
    pub const fn taps(self) -> usize {
        match self {
            Self::Held => 1,
            Self::Straight | Self::Begin => 2,
            Self::Cubic => 4,
        }
    }
}

impl Known {
    /// Values of its own that enter an interval, by age from 0.
    pub fn taps(&self) -> usize {
        if self.jumps { 1 } else { self.run.taps() }
    }

    /// Whether its value now needs the outputs of this call.
    pub fn needs_samples(&self, plant: &Plant) -> bool {
        let Source::Injection(k) = self.source else { return false };
        self.ago == 0 && depends_on_outputs(&plant.injections[k].symbols())
    }
}

/// Whether a state is among what something depends on.
pub fn depends_on_outputs(symbols: &BTreeSet<Symbol>) -> bool {
    symbols.iter().any(|symbol| matches!(symbol, Symbol::State(_)))
}

/// Everything known besides the outputs.
pub fn knowns(plant: &Plant, between: Between) -> Vec<Known> {
    let mut all = Vec::new();
    for (u, input) in plant.inputs.iter().enumerate() {
        if plant.b.iter().any(|row| !row[u].is_zero()) {
            // An input that runs straight does so whatever the hold of the nonlinear terms.
            let run = if input.hold == Hold::Zero { Run::Held } else { running(plant, Between::Lines) };
            all.push(Known { source: Source::Input(u), text: input.label.name.clone(), ago: 0, run, jumps: false });
        }
    }
    for (k, injection) in plant.injections.iter().enumerate() {
        let known = |run, ago, jumps| {
            let text = if ago == 0 { injection.text.clone() } else { format!("{}, {ago} before", injection.text) };
            Known { source: Source::Injection(k), text, ago, run, jumps }
        };
        match change(&injection.node.poly, |u| plant.inputs[u].hold) {
            Change::Held => all.push(known(Run::Held, 0, false)),
            Change::Runs => all.push(known(running(plant, between), 0, false)),
            Change::RunsAndJumps if plant.discrete => all.push(known(Run::Begin, 1, true)),
            Change::RunsAndJumps => {
                let run = Run::from(between);
                all.extend((0..run.taps()).rev().map(|ago| known(run, ago, true)));
            }
        }
    }
    all
}

fn running(plant: &Plant, between: Between) -> Run {
    if plant.discrete { Run::Begin } else { between.into() }
}

/// The factors of a signal's values, newest first, in the state at the end of one interval of `x' = a x + b w` of
/// length h; without h, of one step of `x+ = a x + b w`. Shapes as b.
pub fn taps(run: Run, a: &Matrix, b: &Matrix, h: Option<&Real>) -> Result<Vec<Matrix>, NormTooLarge> {
    let Some(h) = h else {
        let nothing = Matrix::zeros(b.rows(), b.cols(), b.precision());
        return Ok(if run == Run::Held { vec![b.clone()] } else { vec![nothing, b.clone()] });
    };
    Ok(match run {
        Run::Held | Run::Begin => vec![zero_order_hold(a, b, h)?.1],
        Run::Straight => {
            let (_, begin, end) = first_order_hold(a, b, h)?;
            vec![end, begin]
        }
        Run::Cubic => {
            let mut taps = third_order_hold(a, b, h, 2)?.to_vec();
            taps.reverse();
            taps
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::designed;
    use crate::real::Precision;

    /// Whatever the run, a value that stays does what a held one does.
    #[test]
    fn taps_add_up_to_the_held_one() {
        let p = Precision::bits(256);
        let number = |x: i64| Real::from_i64(x, p) / Real::from_i64(10, p);
        let (a, b) = (
            Matrix::from_fn(2, 2, |i, j| number([[0, 10], [-30, -2]][i][j])),
            Matrix::from_fn(2, 1, |i, _| number([3, 7][i])),
        );
        let h = number(1);
        let held = &taps(Run::Held, &a, &b, Some(&h)).unwrap()[0];
        for run in [Run::Straight, Run::Cubic] {
            let taps = taps(run, &a, &b, Some(&h)).unwrap();
            assert_eq!(taps.len(), run.taps());
            let sum = taps.iter().skip(1).fold(taps[0].clone(), |sum, tap| &sum + tap);
            assert!((&sum - held).max_abs().log2_abs() < -240.0);
        }
        assert_eq!(taps(Run::Begin, &a, &b, None).unwrap()[1], b);
    }

    /// A term with a held input is evaluated at every sample of its polynomial; one without, once.
    #[test]
    fn terms_that_jump_are_evaluated_anew() {
        let text = "deadbeat = 1\nname = 'm'\n[states]\nx = { derivative = 'v' }\nv = { derivative = 'u*x^2 + cos(x) + u' }\n\
                    [inputs]\nu = {}\n[outputs]\nx = { value = 'x' }\n[observer.impulsive]\nwindow = 0.1\nhold = 'third'\n\
                    [target]\nsample_time = 0.01\n";
        let (plant, _) = designed(text).unwrap();
        let all = knowns(&plant, Between::Cubics);
        let kinds: Vec<(usize, usize)> = all.iter().map(|known| (known.ago, known.taps())).collect();
        assert_eq!(kinds, [(0, 1), (0, 4), (3, 1), (2, 1), (1, 1), (0, 1)]);
        assert_eq!(all.iter().filter(|known| known.needs_samples(&plant)).count(), 2);
    }
}
