//! Rounds the observer's numbers once, when they have settled at rising precision.

use crate::plant::Plant;
use crate::real::{Matrix, Precision};
use crate::sampled::settle::{FIRST_BITS, LAST_BITS, Numerics, Pass, refusal};
use crate::sampled::settled::Settled;

use super::exact::{Choice, Exact, ExactUpdate, Failure, exact};
use super::known::Known;
use super::{Calls, Grid, Impulsive, Update};

/// A reset that leaves more than this of the error that it should take away is no reset.
const LEFT: f64 = 1e-30;

/// Designs at rising precision until everything has settled.
pub fn settle(
    plant: &Plant,
    choice: &Choice,
    knowns: &[Known],
    calls: Calls,
) -> Result<(Impulsive, Exact, Numerics), Failure> {
    let mut precision = Precision::bits(FIRST_BITS);
    let mut coarse = exact(plant, choice, knowns, precision);
    loop {
        let fine = exact(plant, choice, knowns, precision.doubled());
        let last = precision.doubled().as_bits() > LAST_BITS;
        match (&coarse, fine) {
            (_, Err(failure)) if last || !matches!(failure, Failure::Alike) => return Err(failure),
            (Ok(before), Ok(fine)) => {
                let mut pass = Pass::new(precision);
                let settled = impulsive(&mut pass, before, &fine, choice, knowns, calls);
                let agreement = pass.agreement();
                let left = fine.left();
                if agreement.same_f64 && agreement.same_f32 && left < LEFT {
                    let (digits, agreement) = (precision.as_digits(), agreement.digits);
                    return Ok((settled, fine, Numerics { digits, agreement, condition: 0.0, unbiasedness: left }));
                }
                if last {
                    return Err(Failure::Plant(vec![refusal(plant, agreement.digits, left)]));
                }
                coarse = Ok(fine);
            }
            // What cannot be told apart at this precision may be at a higher one.
            (Err(_), fine) | (Ok(_), fine @ Err(_)) => coarse = fine,
        }
        precision = precision.doubled();
    }
}

fn impulsive(
    pass: &mut Pass,
    coarse: &Exact,
    fine: &Exact,
    choice: &Choice,
    knowns: &[Known],
    calls: Calls,
) -> Impulsive {
    let mut grid = |of: &dyn Fn(&Exact) -> &Matrix| grid(pass, of(coarse), of(fine));
    let gain = grid(&|e| &e.gain);
    let reset = grid(&|e| &e.pair.x);
    let back = grid(&|e| &e.coordinates.back);
    Impulsive {
        calls,
        form: choice.form,
        between: choice.between,
        rest: choice.rest.clone(),
        knowns: knowns.to_vec(),
        first: update(pass, &coarse.first, &fine.first),
        second: update(pass, &coarse.second, &fine.second),
        predictor: update(pass, &coarse.predictor, &fine.predictor),
        gain,
        reset,
        back,
    }
}

fn update(pass: &mut Pass, coarse: &ExactUpdate, fine: &ExactUpdate) -> Update {
    let copy = grid(pass, &coarse.copy, &fine.copy);
    let outputs = coarse.outputs.iter().zip(&fine.outputs).map(|(c, f)| grid(pass, c, f)).collect();
    let knowns = coarse.knowns.iter().zip(&fine.knowns);
    let knowns = knowns.map(|(c, f)| c.iter().zip(f).map(|(c, f)| column(pass, c, f)).collect()).collect();
    Update { copy, outputs, knowns, constant: column(pass, &coarse.constant, &fine.constant) }
}

fn column(pass: &mut Pass, coarse: &Matrix, fine: &Matrix) -> Vec<Option<Settled>> {
    let rows = grid(pass, coarse, fine);
    rows.into_iter().map(|row| row[0]).collect()
}

/// Each entry rounded; what is zero, structurally or by vanishing with the precision, is left out.
fn grid(pass: &mut Pass, coarse: &Matrix, fine: &Matrix) -> Grid {
    let cols = coarse.cols();
    let coarse: Vec<_> = coarse.iter().cloned().collect();
    let fine: Vec<_> = fine.iter().cloned().collect();
    let settled = pass.each(&coarse, &fine);
    let kept = settled.into_iter().map(|entry| entry.filter(|entry| *entry != Settled::default()));
    let kept: Vec<_> = kept.collect();
    if cols == 0 { Vec::new() } else { kept.chunks(cols).map(<[_]>::to_vec).collect() }
}
