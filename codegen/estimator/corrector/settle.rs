//! Rounds a corrector once, when its constants have settled.

use super::exact::{Exact, Law};
use super::{Corrector, Counting, Frame, Gain, Grid, Polynomials, Spread, law};
use crate::diagnostic::Diagnostic;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real};
use crate::sampled::Signal;
use crate::sampled::settle::{Numerics, Pass, rising};
use crate::sampled::settled::Settled;

/// Designs at rising precision until every constant has settled.
///
/// # Errors
/// What `run` reports, or that the constants do not settle.
pub fn settle(
    plant: &Plant,
    signals: &[Signal],
    counting: Counting,
    run: &dyn Fn(Precision) -> Result<Exact, Vec<Diagnostic>>,
) -> Result<(Corrector, Exact, Numerics), Vec<Diagnostic>> {
    rising(plant, run, |pass, coarse, fine| corrector(pass, [coarse, fine], signals, counting), |_| 0.0)
}

type Both<'a> = [&'a Exact; 2];

fn corrector(pass: &mut Pass, both: Both, signals: &[Signal], counting: Counting) -> Corrector {
    let [coarse, fine] = both;
    let n = fine.model.phi.rows();
    let mut column = |get: &dyn Fn(&Exact) -> Option<Matrix>| match (get(coarse), get(fine)) {
        (Some(coarse), Some(fine)) => entries(pass, &coarse, &fine).into_iter().map(|row| row[0]).collect(),
        _ => vec![None; n],
    };
    let at_begin = (0..signals.len()).map(|s| column(&|e| e.model.effects[s].at_begin.clone())).collect();
    let at_end = (0..signals.len()).map(|s| column(&|e| e.model.effects[s].at_end.clone())).collect();
    let constant = column(&|e| Some(e.model.constant.clone()));
    let output = entries(pass, &coarse.model.c, &fine.model.c);
    let frame = frame(pass, both);
    let gain = gain(pass, both, counting);
    let handover = match (&coarse.handover, &fine.handover) {
        (Some(c), Some(f)) => coarse.into_frame(c).zip(fine.into_frame(f)).map(|(c, f)| entries(pass, &c, &f)),
        _ => None,
    };
    let (signals, twofold) = (signals.to_vec(), vec![false; n]);
    let (valid, recovery) = (0, 0);
    Corrector { frame, signals, at_begin, at_end, constant, output, gain, handover, twofold, counting, valid, recovery }
}

fn frame(pass: &mut Pass, [coarse, fine]: Both) -> Frame {
    let both = (coarse.entry.as_ref(), fine.entry.as_ref());
    match (&coarse.start, &fine.start, &coarse.chain, &fine.chain) {
        (Some(a), Some(b), Some(coarse), Some(fine)) => Frame::Chain {
            readout: entries(pass, &coarse.m, &fine.m),
            start: entries(pass, a, b).into_iter().map(|row| row[0]).collect(),
            entry: both.0.zip(both.1).map(|(coarse, fine)| entries(pass, coarse, fine)),
        },
        (.., c, f) => {
            let spread = match (c, f) {
                (Some(c), Some(f)) if fine.law.needs_chain() && !matches!(fine.law, Law::Kappa(_)) => Some(Spread {
                    m: entries(pass, &c.m, &f.m),
                    q: entries(pass, &c.q, &f.q).into_iter().map(|row| row[0]).collect(),
                }),
                _ => None,
            };
            let phi = entries(pass, &coarse.model.phi, &fine.model.phi);
            Frame::Plant { phi, growth: growth(&fine.model.phi), spread }
        }
    }
}

/// What is below this, as a power of two, is nothing beside the state that grows by it, after any number of calls.
const LEAST_GROWTH: i64 = -100;

/// Phi - I on its diagonal. Phi has settled, with hundreds of bits to spare.
fn growth(phi: &Matrix) -> Vec<Option<Settled>> {
    let least = Real::one(phi.precision()).shifted(LEAST_GROWTH);
    let each = (0..phi.rows()).map(|i| &phi[(i, i)] - &Real::one(phi.precision()));
    each.map(|growth| (growth.abs() > least).then(|| Settled::round(&growth))).collect()
}

fn gain(pass: &mut Pass, [coarse, fine]: Both, counting: Counting) -> Gain {
    match (&coarse.law, &fine.law) {
        (Law::Table(c), Law::Table(f)) => {
            Gain::Table(c.iter().zip(f).map(|(c, f)| dense(entries(pass, c, f))).collect())
        }
        (Law::Periodic(c), Law::Periodic(f)) => {
            Gain::Periodic(c.iter().zip(f).map(|(c, f)| dense(entries(pass, c, f))).collect())
        }
        (Law::Countdown(c), Law::Countdown(f)) => Gain::Countdown(polynomials(pass, c, f, counting)),
        (Law::Sliding(c), Law::Sliding(f)) => Gain::Sliding { law: c.settled(f, pass), calm: 0.0 },
        (Law::Kappa(c), Law::Kappa(f)) => {
            let whole = |exact: &Exact, kappa: &Matrix| match (&exact.chain, &exact.start) {
                (Some(chain), None) => &(&chain.m * kappa) + &chain.q,
                _ => kappa.clone(),
            };
            Gain::Constant(entries(pass, &whole(coarse, c), &whole(fine, f)))
        }
        (Law::Constant(c), Law::Constant(f)) => {
            let whole = |exact: &Exact, gain: &Matrix| exact.into_frame(gain).unwrap_or_else(|| gain.clone());
            Gain::Constant(entries(pass, &whole(coarse, c), &whole(fine, f)))
        }
        _ => unreachable!("two runs of one law"),
    }
}

fn polynomials(pass: &mut Pass, coarse: &[Vec<Real>], fine: &[Vec<Real>], counting: Counting) -> Polynomials {
    let shift = law::shift(counting);
    let n = coarse.len();
    let scaled = |rows: &[Vec<Real>]| -> Vec<Vec<Real>> {
        let row = |row: &Vec<Real>| (0..).zip(row).map(|(j, x)| x.shifted(-shift * (exponent(n) - j))).collect();
        rows.iter().map(row).collect()
    };
    let (coarse, fine) = (scaled(coarse), scaled(fine));
    let doubles: Vec<Vec<f64>> = fine.iter().map(|row| row.iter().map(Real::to_f64).collect()).collect();
    let unit = (0..shift).fold(1.0, |unit: f64, _| unit * 0.5);
    let denominator = |left: usize| {
        let r = crate::numbers::count(left) * unit;
        let powers: Vec<f64> = (0..=n).scan(1.0, |power, _| Some(std::mem::replace(power, *power * r))).collect();
        powers[n] + doubles.iter().flat_map(|row| row.iter().zip(&powers)).map(|(a, power)| a * power).sum::<f64>()
    };
    let terms = coarse.iter().zip(&fine).map(|(c, f)| pass.each(c, f)).collect();
    // All coefficients are positive: the denominator grows with r.
    Polynomials { shift, terms, smallest: denominator(counting.stop), largest: denominator(counting.steps) }
}

fn exponent(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}

/// Entries of different units; what is zero in exact arithmetic gives nothing.
fn entries(pass: &mut Pass, coarse: &Matrix, fine: &Matrix) -> Grid {
    let row = |m: &Matrix, i: usize| -> Vec<Real> { (0..m.cols()).map(|j| m[(i, j)].clone()).collect() };
    let there = |entry: Option<Settled>| entry.filter(|entry| entry.double != 0.0);
    (0..fine.rows()).map(|i| pass.each(&row(coarse, i), &row(fine, i)).into_iter().map(there).collect()).collect()
}

fn dense(grid: Grid) -> Vec<Vec<Settled>> {
    grid.into_iter().map(|row| row.into_iter().map(Option::unwrap_or_default).collect()).collect()
}
