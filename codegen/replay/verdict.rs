//! What a replay came to.

use crate::estimator::Design;
use crate::numbers::short;

use super::interface::Answer;
use super::residual::Residual;

/// What a replay came to.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Rows fed.
    pub rows: u64,
    /// Rows with a converged or coasting estimate.
    pub converged_rows: u64,
    /// Those of them that coast.
    pub coasting_rows: u64,
    /// The first such call, from 1.
    pub converged_from: Option<u64>,
    /// Samples that the recording's time left out.
    pub left_out: u64,
    /// Samples of a later time than their row's, by the sensor's own clock.
    pub negative_ages: u64,
    /// What was compared, in the order of the estimate's fields.
    pub compared: Vec<Compared>,
    /// The samples against what the estimates before them foretold, per output.
    pub residuals: Vec<Residual>,
    /// What the recording has that a report should not keep silent about, a line each.
    pub remarks: Vec<String>,
}

/// A quantity that was compared with a column.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The field of the estimate.
    pub answer: Answer,
    /// Over the rows on which it has converged and the column is finite.
    pub errors: Errors,
}

/// Errors of one compared quantity after convergence, in its unit.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    sum_of_squares: f64,
    /// Largest magnitude; `None` when nothing was compared.
    pub max: Option<f64>,
    /// Rows compared.
    pub rows: u64,
    /// Of these, rows with a bound: converged, of a state that has one.
    pub bounded: u64,
    /// Of these, rows whose error is beyond the bound.
    pub beyond: u64,
}

impl Verdict {
    /// The errors of a quantity; `None` when there was no column to compare it with.
    pub fn errors(&self, name: &str) -> Option<&Errors> {
        self.compared.iter().find(|compared| compared.answer.name == name).map(|compared| &compared.errors)
    }

    /// The verdict for machines; the keys are those of the manual.
    #[cfg(feature = "json")]
    pub fn to_json(&self) -> serde_json::Value {
        let error = |it: &Compared| {
            let mut error = serde_json::json!({ "rms": it.errors.rms(), "max": it.errors.max });
            if let Some(share) = it.errors.share_beyond() {
                error["beyond_bound"] = share.into();
            }
            (it.answer.name.clone(), error)
        };
        let errors: serde_json::Map<String, serde_json::Value> = self.compared.iter().map(error).collect();
        let mut report = serde_json::json!({
            "rows": self.rows,
            "converged_rows": self.converged_rows,
            "coasting_rows": self.coasting_rows,
            "errors": errors,
        });
        if !self.residuals.is_empty() {
            report["residuals"] = self.residuals.iter().map(Residual::to_json).collect();
        }
        if self.negative_ages > 0 {
            report["negative_ages"] = self.negative_ages.into();
        }
        report
    }
}

impl Compared {
    /// The share of rows beyond the bound that a design promises, in a line; `None` where there is none.
    pub fn beyond(&self, design: &Design) -> Option<String> {
        let (share, bound) = self.errors.share_beyond().zip(self.answer.bound(design))?;
        let (name, unit, rows) = (&self.answer.name, &self.answer.unit, self.errors.bounded);
        Some(format!("{name}: {} % of {rows} rows beyond the bound, {} {unit}", short(100.0 * share), short(bound)))
    }
}

impl Errors {
    pub(super) fn add(&mut self, error: f64, bound: Option<f64>) {
        self.bounded += u64::from(bound.is_some());
        self.beyond += u64::from(bound.is_some_and(|bound| error.abs() > bound));
        self.sum_of_squares += error * error;
        self.max = Some(self.max.map_or(error.abs(), |max| max.max(error.abs())));
        self.rows += 1;
    }

    /// Root mean square; `None` when nothing was compared.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub fn rms(&self) -> Option<f64> {
        (self.rows > 0).then(|| (self.sum_of_squares / self.rows as f64).sqrt())
    }

    /// The share of the rows with a bound that are beyond it; `None` when there are none.
    #[expect(clippy::cast_precision_loss, reason = "a recording has fewer than 2^53 rows")]
    pub fn share_beyond(&self) -> Option<f64> {
        (self.bounded > 0).then(|| self.beyond as f64 / self.bounded as f64)
    }

    /// Root mean square and largest magnitude for people, `-` when nothing was compared.
    pub fn shown(&self) -> (String, String) {
        let shown = |value: Option<f64>| value.map_or_else(|| "-".into(), short);
        (shown(self.rms()), shown(self.max))
    }
}
