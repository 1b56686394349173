//! What the window cannot take: mostly of samples with an age, and where samples are left out.

use super::Keys;
use crate::expr::Constant;
use crate::plant::features::{Against, Case, Feature, Limit, UNTURNED, holds, is_coarse, nonlinear_term};

/// The most states of a plant that is no chain of integrators.
const MOST_STATES: usize = 3;
/// The most states of a chain of integrators.
const LONGEST_CHAIN: usize = 4;

/// The limits.
pub(super) const LIMITS: &[Limit] = &[
    Limit::new(
        Feature::Counter,
        "rows of samples that are there are of positions, and single precision does not hold every count of 32 bits",
        "write `wrap`, a turn of at most 2^24 counts, a `range` within 2^24 counts of 0, or `scalar = \"f64\"`, or leave \
         out `missing`",
    )
    .when(
        "of 32 bits in f32, unless `wrap` is a turn of at most 2^24 counts or `range` within these, where samples are left \
         out",
        |case| holds(leaves_out(case) && is_coarse(case)),
    ),
    UNTURNED,
    Limit::new(Feature::Gate, "the sample is late, and no prediction of it is kept", "leave out `gate` or `delay`")
        .when("of a late output, where samples are left out", |case| {
            holds(leaves_out(case) && case.output().1.delay.is_some())
        }),
    Limit::new(
        Feature::Every,
        "the term acts at every call, and no sample says what it is in between",
        "measure it at every call, or `[observer.impulsive]` with `measured_every`",
    )
    .when("of an output in a nonlinear term", nonlinear_term),
    Limit::new(
        Feature::Age,
        "a discrete plant has nothing between samples",
        "write the plant in continuous time, or leave out `age`",
    )
    .when("of a discrete plant", |case| holds(case.plant.discrete)),
    Limit::new(
        Feature::Age,
        "each sample costs the step the powers of its age times those of A, which are offered for 3 states, or 4 in a chain",
        "fewer states, or samples at the times of calls: `missing = \"left-out\"`",
    )
    .when("of more than 3 states, or 4 in a chain", large),
    Limit::new(Feature::Age, "its delay is part of its age", "add the delay to the age").when("of a late output", late),
    Limit::new(Feature::Age, "a gate compares with the prediction for the time of a call", "leave out `age` or `gate`")
        .when("of an output with a gate", gated),
    Limit::new(Feature::Age, "the input at that time is not known", "take the input out of the sample before the call")
        .when("of an output with an input in it", |case| {
            holds(case.output().1.feedthrough.iter().any(|factor| !factor.is_zero()))
        }),
    Limit::new(Feature::Age, "the term needs it at the time of each call", "measure it at the calls, without `age`")
        .when("of an output in a nonlinear term", nonlinear_term),
    Limit::new(
        Feature::Windows,
        "each window would cost the step a solve of its own, and one is offered",
        "write one length, or `missing = \"predicted\"`",
    )
    .when("where samples are left out", several),
];

fn leaves_out(case: &Case) -> bool {
    case.keys::<Keys>().leaves_out(case.plant)
}

fn several(case: &Case) -> Against {
    let place = case.keys::<Keys>().missing.1.clone();
    leaves_out(case).then_some(Some((place, "the step solves for the rows that are there")))
}

fn late(case: &Case) -> Against {
    let (_, delay) = case.output().1.delay.as_ref()?;
    Some(Some((delay.clone(), "the delay")))
}

fn gated(case: &Case) -> Against {
    let gate = case.output().1.gate.as_ref()?;
    Some(Some((gate.span.clone(), "predictions are of the time of a call")))
}

fn large(case: &Case) -> Against {
    let states = &case.plant.states;
    let most = if is_nilpotent(&case.plant.a) { LONGEST_CHAIN } else { MOST_STATES };
    Some(Some((states.get(most)?.label.span.clone(), "one state too many")))
}

/// Whether the powers of A end: chains of integrators.
fn is_nilpotent(a: &[Vec<Constant>]) -> bool {
    let n = a.len();
    let mut reaches: Vec<Vec<bool>> = a.iter().map(|row| row.iter().map(|x| !x.is_zero()).collect()).collect();
    for k in 0..n {
        for i in 0..n {
            for j in 0..n {
                reaches[i][j] |= reaches[i][k] && reaches[k][j];
            }
        }
    }
    (0..n).all(|i| !reaches[i][i])
}
