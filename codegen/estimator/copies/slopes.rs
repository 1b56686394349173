//! The nonlinear terms as linear ones: their slopes in the outputs, at the ends of what the ranges allow.
//!
//! Where every call is measured these slopes do nothing to the convergence. Between measurements they do: the
//! prediction is fed back through them. A slope that stays at one end is not all that a plant can do, so the radius
//! it gives proves nothing; but it is what the error does near a state where it is so.

use crate::expr::Symbol;
use crate::expr::bounds::{Interval, derivative, enclose};
use crate::plant::Plant;
use crate::promise::kernel::range;
use crate::real::{Matrix, Real};
use crate::sampled::Source;

use super::exact::{Exact, ExactUpdate};
use super::known::Known;

/// Ends that are tried in every combination; where there are more, all low and all high ones.
const MOST_ENDS: usize = 4;

/// Slopes by injection and output.
pub type Slopes = Vec<Vec<f64>>;

/// The combinations of ends; `None` where a slope has no bound.
pub fn corners(plant: &Plant) -> Option<Vec<Slopes>> {
    let mut intervals: Vec<Vec<Interval>> = Vec::new();
    for injection in &plant.injections {
        let mut row = Vec::new();
        for o in 0..plant.outputs.len() {
            let mut slope = Interval::point(0.0);
            for (j, state) in plant.states.iter().enumerate() {
                let Some((_, weight)) = state.measured.iter().find(|(output, _)| *output == o) else { continue };
                let own = enclose(&derivative(&injection.node.poly, Symbol::State(j))?, &|symbol| range(plant, symbol));
                slope = slope.plus(own.times(Interval::point(weight.to_f64().ok()?)));
            }
            row.push(Some(slope).filter(|slope| slope.magnitude().is_finite())?);
        }
        intervals.push(row);
    }
    let open = intervals.iter().flatten().filter(|slope| slope.low < slope.high).count();
    let choices = if open <= MOST_ENDS { 1_usize << open } else { 2 };
    let corner = |choice: usize| -> Slopes {
        let mut place = 0;
        let mut end = |slope: &Interval| {
            let high = if open <= MOST_ENDS { choice >> place & 1 == 1 } else { choice == 1 };
            place += usize::from(slope.low < slope.high);
            if high { slope.high } else { slope.low }
        };
        intervals.iter().map(|row| row.iter().map(&mut end).collect()).collect()
    };
    Some((0..choices).map(corner).collect())
}

/// The observer of the plant whose nonlinear terms have these slopes.
pub fn sloped(exact: &Exact, knowns: &[Known], slopes: &Slopes) -> Exact {
    let ages = knowns.iter().map(|known| known.ago + known.taps()).max().unwrap_or(0);
    let ages = ages.max(exact.first.outputs.len());
    let update = |update: &ExactUpdate| -> ExactUpdate {
        let (rows, cols, p) = (update.copy.rows(), exact.gain.cols(), exact.phi.precision());
        let mut outputs = update.outputs.clone();
        outputs.resize(ages, Matrix::zeros(rows, cols, p));
        for (known, taps) in knowns.iter().zip(&update.knowns) {
            let Source::Injection(k) = known.source else { continue };
            let slope =
                Matrix::from_fn(1, cols, |_, o| Real::from_f64(slopes[k][o], p).unwrap_or_else(|| Real::zero(p)));
            for (age, tap) in taps.iter().enumerate() {
                let output = &mut outputs[known.ago + age];
                *output = &*output + &(tap * &slope);
            }
        }
        ExactUpdate { outputs, ..update.clone() }
    };
    Exact {
        first: update(&exact.first),
        second: update(&exact.second),
        predictor: update(&exact.predictor),
        ..exact.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::designed;

    #[test]
    fn corners_are_the_ends_of_the_slopes() {
        let text = "deadbeat = 1\nname = 'p'\n[states]\nx = { derivative = 'v' }\nv = { derivative = '-sin(x) + 0.5*x^2' }\n[outputs]\n\
                    x = { value = 'x', range = [-1, 2] }\n[observer.impulsive]\nwindow = 1\n[target]\nsample_time = 0.1\n";
        let (plant, _) = designed(text).unwrap();
        let found = corners(&plant).unwrap();
        // One function for one state: -cos(x) + x is in [-2, 3].
        assert_eq!(found, [vec![vec![-2.0]], vec![vec![3.0]]]);
        let (plant, _) = designed(&text.replace(", range = [-1, 2]", "")).unwrap();
        assert_eq!(corners(&plant), None);
    }
}
