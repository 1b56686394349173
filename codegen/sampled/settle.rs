//! Rounds a design's constants once, when they have settled.
//!
//! Every design runs at d and at 2d digits, d rising until each constant rounds to the same double
//! and the same single; a run that ends early for want of digits ([`codes::PRECISION`]) is none. A constant that is zero in exact arithmetic never does: it shrinks with the
//! precision instead, and is recognised by that; so is one below 2^-384 (1e-115) of its column.

use crate::diagnostic::{Diagnostic, codes};
use crate::plant::Plant;
use crate::real::{Agreement, Precision, Real, compare};

use super::settled::Settled;

/// Bits of the first run; the second has twice as many.
pub(crate) const FIRST_BITS: usize = 256;

/// Bits of the last run that is tried.
pub(crate) const LAST_BITS: usize = 4_096;

/// Bits of a constant that rounding errors may have spoiled while it still counts as vanishing.
const GUARD_BITS: f64 = 128.0;

/// Runs at rising precision until what `round` takes of two runs has settled: that, the finer run, the record.
pub(crate) fn rising<T, F>(
    plant: &Plant,
    run: impl Fn(Precision) -> Result<T, Vec<Diagnostic>>,
    round: impl Fn(&mut Pass, &T, &T) -> F,
    unbiasedness: impl Fn(&T) -> f64,
) -> Result<(F, T, Numerics), Vec<Diagnostic>> {
    rising_from(plant, FIRST_BITS, run, round, unbiasedness)
}

/// The same from a precision on.
fn rising_from<T, F>(
    plant: &Plant,
    bits: usize,
    run: impl Fn(Precision) -> Result<T, Vec<Diagnostic>>,
    round: impl Fn(&mut Pass, &T, &T) -> F,
    unbiasedness: impl Fn(&T) -> f64,
) -> Result<(F, T, Numerics), Vec<Diagnostic>> {
    let (mut precision, mut coarse) = first(&run, Precision::bits(bits.max(FIRST_BITS)))?;
    let mut agreement;
    loop {
        let fine = run(precision.doubled())?;
        let mut pass = Pass::new(precision);
        let rounded = round(&mut pass, &coarse, &fine);
        let result = pass.agreement();
        agreement = result.digits;
        let unbiasedness = unbiasedness(&fine);
        if result.same_f64 && result.same_f32 && unbiasedness < 1e-30 {
            let numerics = Numerics { digits: precision.as_digits(), agreement, condition: 0.0, unbiasedness };
            return Ok((rounded, fine, numerics));
        }
        precision = precision.doubled();
        if precision.as_bits() > LAST_BITS {
            return Err(vec![refusal(plant, agreement, unbiasedness)]);
        }
        coarse = fine;
    }
}

/// The first run, at so many bits or as many more as it takes until it comes to an end.
fn first<T>(
    run: impl Fn(Precision) -> Result<T, Vec<Diagnostic>>,
    mut precision: Precision,
) -> Result<(Precision, T), Vec<Diagnostic>> {
    let short_of_digits = |found: &[Diagnostic]| found.iter().all(|mistake| mistake.code == codes::PRECISION);
    loop {
        match run(precision) {
            Err(found) if precision.as_bits() < LAST_BITS && short_of_digits(&found) => precision = precision.doubled(),
            other => return other.map(|found| (precision, found)),
        }
    }
}

/// Rounds further constants of a design, given in groups of one unit; structural zeros give nothing. `settled` is
/// the precision of the finer run at which the design's own constants had settled.
///
/// # Errors
/// What `run` reports, or that the constants do not settle.
pub fn settle_groups(
    plant: &Plant,
    settled: Precision,
    run: &dyn Fn(Precision) -> Result<Vec<Vec<Real>>, Vec<Diagnostic>>,
) -> Result<Vec<Option<Vec<Settled>>>, Vec<Diagnostic>> {
    let round = |pass: &mut Pass, coarse: &Vec<Vec<Real>>, fine: &Vec<Vec<Real>>| -> Vec<_> {
        coarse.iter().zip(fine).map(|(c, f)| pass.group(c, f)).collect()
    };
    Ok(rising_from(plant, settled.as_bits() / 2, run, round, |_| 0.0)?.0)
}

/// The same without the proof: for numbers that are only compared.
///
/// # Errors
/// What `run` reports.
pub fn round_groups(
    settled: Precision,
    run: &dyn Fn(Precision) -> Result<Vec<Vec<Real>>, Vec<Diagnostic>>,
) -> Result<Vec<Option<Vec<Settled>>>, Vec<Diagnostic>> {
    let round = |group: Vec<Real>| {
        (!group.iter().all(Real::is_zero)).then(|| group.iter().map(Settled::round).collect::<Vec<_>>())
    };
    Ok(run(settled)?.into_iter().map(round).collect())
}

pub(crate) fn refusal(plant: &Plant, agreement: f64, unbiasedness: f64) -> Diagnostic {
    if agreement >= 17.0 {
        let message = "the estimate would be biased";
        return Diagnostic::error(codes::CHECK_FAILED, plant.span.clone(), message)
            .label(format!("acc_(N+1) is {unbiasedness:.1e} of its history, not 0"))
            .measured(unbiasedness);
    }
    let message = format!("the constants do not settle at {LAST_BITS} bits");
    Diagnostic::error(codes::PRECISION, plant.span.clone(), message)
        .label(format!("two runs agree to {agreement:.1} digits"))
        .measured(agreement)
        .help("a shorter window, or a model without modes that decay within a sample")
}

/// One comparison of two runs.
pub(crate) struct Pass {
    precision: Precision,
    coarse: Vec<Real>,
    fine: Vec<Real>,
    settled: Vec<Settled>,
}

impl Pass {
    /// Of a run at this precision with one at twice as many digits.
    pub(crate) fn new(precision: Precision) -> Self {
        Self { precision, coarse: Vec::new(), fine: Vec::new(), settled: Vec::new() }
    }

    /// How far both runs agree on what was rounded.
    pub(crate) fn agreement(&self) -> Agreement {
        compare(self.coarse.iter(), self.fine.iter())
    }

    /// Rounds numbers of one unit; exact zeros on both sides are structural and give nothing.
    pub(crate) fn group(&mut self, coarse: &[Real], fine: &[Real]) -> Option<Vec<Settled>> {
        if coarse.iter().chain(fine).all(Real::is_zero) {
            return None;
        }
        let scale = fine.iter().map(Real::log2_abs).fold(f64::NEG_INFINITY, f64::max);
        let bits = crate::numbers::count(self.precision.as_bits());
        let vanishes = |c: &Real, f: &Real| {
            let (c, f) = (c.log2_abs(), f.log2_abs());
            let small = c < scale - bits + GUARD_BITS && f < scale - 2.0 * bits + GUARD_BITS;
            small || f < c - 0.75 * bits
        };
        self.settled.clear();
        for (c, f) in coarse.iter().zip(fine) {
            let gone = vanishes(c, f);
            let (c, f) =
                if gone { (Real::zero(self.precision), Real::zero(self.precision)) } else { (c.clone(), f.clone()) };
            self.settled.push(Settled::round(&f));
            self.coarse.push(c);
            self.fine.push(f);
        }
        Some(self.settled.clone())
    }

    /// Rounds numbers of different units; each structural zero gives nothing.
    pub(crate) fn each(&mut self, coarse: &[Real], fine: &[Real]) -> Vec<Option<Settled>> {
        let one = |pass: &mut Self, i: usize| pass.group(&coarse[i..=i], &fine[i..=i]).map(|s| s[0]);
        (0..coarse.len()).map(|i| one(self, i)).collect()
    }
}

/// How the arithmetic went.
#[derive(Clone, Copy, Debug, Default)]
pub struct Numerics {
    /// Decimal digits of the coarser run.
    pub digits: usize,
    /// Decimal digits to which both runs agree, over all constants.
    pub agreement: f64,
    /// Of the observability matrix with columns scaled to one.
    pub condition: f64,
    /// Largest entry of `acc_{N+1}` against its history; 0 in exact arithmetic.
    pub unbiasedness: f64,
}
