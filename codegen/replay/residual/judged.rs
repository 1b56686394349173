//! What the innovations of an output came to, and what that says.

use crate::numbers::short;
use crate::plant::{Output, Plant};
use crate::program::Scalar;

use super::Sums;
use super::expected::Expected;

/// What the innovations of an output came to: the samples against what the estimates before them foretold.
#[derive(Clone, Debug)]
pub struct Residual {
    /// The output.
    pub output: String,
    /// Its unit.
    pub unit: String,
    /// How many there were.
    pub count: u64,
    /// Root mean square, in the unit.
    pub rms: f64,
    /// Mean, in the unit.
    pub mean: f64,
    /// Correlation of neighbours.
    pub lag_one: f64,
    /// The declared noise, in the unit.
    pub noise: Option<f64>,
    /// How many times the root mean square is what noise as large as declared at every sample makes of it.
    pub times: Option<f64>,
    /// What all that says, a sentence.
    pub verdict: String,
}

/// A correlation, beyond that of noise in the estimate itself, that noise has not.
const CORRELATED: f64 = 0.3;
/// How many deviations of a mean of noise a mean is that noise has not; and the least share of the root mean square.
const BIASED: (f64, f64) = (8.0, 0.1);

/// Roundings of the largest sample that an estimate may be off by.
const ROUNDING: f64 = 64.0;

impl Residual {
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub(super) fn new(
        plant: &Plant,
        output: &Output,
        noise: Option<f64>,
        sums: &Sums,
        expected: Option<Expected>,
    ) -> Self {
        let count = sums.count as f64;
        let (rms, mean) = ((sums.squares / count).sqrt(), sums.sum / count);
        let neighbours = sums.neighbours.max(1) as f64;
        let lag_one = if rms > 0.0 { sums.products / neighbours / (rms * rms) } else { 0.0 };
        let times = expected.map(|expected| rms / expected.rms);
        let after = expected.map_or(0.0, |expected| expected.lag_one.min(0.0));
        let follows = lag_one - after > CORRELATED;
        let biased = mean.abs() > (BIASED.0 / count.sqrt()).max(BIASED.1) * rms;
        let unit = match plant.scalar {
            Scalar::F32 => f64::from(f32::EPSILON),
            Scalar::F64 => f64::EPSILON,
        };
        let verdict = if rms <= ROUNDING * unit * sums.largest {
            "nothing but rounding is left".into()
        } else {
            verdict(times, follows || biased, output.quantum.is_some())
        };
        Self {
            output: output.label.name.clone(),
            unit: output.label.unit.clone(),
            count: sums.count,
            rms,
            mean,
            lag_one,
            noise,
            times,
            verdict,
        }
    }

    /// In one line, with its verdict.
    pub fn shown(&self) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let noise =
            self.noise.map_or_else(String::new, |noise| format!(", {} of the declared noise", short(self.rms / noise)));
        format!(
            "residual of {}: {}{unit} RMS{noise}, mean {}{unit}, lag-1 correlation {:.2}; {}",
            self.output,
            short(self.rms),
            short(self.mean),
            self.lag_one,
            self.verdict
        )
    }

    /// For machines; the keys are those of the manual.
    #[cfg(feature = "json")]
    pub fn to_json(&self) -> serde_json::Value {
        serde_json::json!({
            "output": self.output,
            "count": self.count,
            "rms": self.rms,
            "mean": self.mean,
            "lag_1": self.lag_one,
            "noise": self.noise,
            "times": self.times,
            "verdict": self.verdict,
        })
    }
}

/// What a residual says: how many `times` it is what noise can make of it; whether it `stays` from sample to sample as
/// noise does not; whether the sensor counts, so that its error stays where nothing moves.
fn verdict(times: Option<f64>, stays: bool, counts: bool) -> String {
    match (times, stays) {
        (Some(times), true) if times > 1.0 => {
            format!("the model is wrong: by {} times what the noise can do, and not by chance", short(times))
        }
        (Some(times), false) if times > 1.0 => format!("the model or the noise is wrong by {} times", short(times)),
        (Some(times), _) if times < 0.1 => {
            format!("the noise is declared {} times as large as it is", short(1.0 / times))
        }
        (_, true) if counts => {
            "within the noise, but it stays from sample to sample, as counts do at rest and a wrong model does".into()
        }
        (None, true) => "it stays from sample to sample as noise does not: the model is wrong".into(),
        (Some(_), true) => {
            "within the noise, but it stays from sample to sample as white noise does not: the model is wrong, or the \
             sensor's noise is not white"
                .into()
        }
        (Some(_), false) => "the model and the declared noise explain the samples".into(),
        (None, false) => "with the outputs' `noise` declared, it would say whether they are explained".into(),
    }
}
