//! Several windows over one ring of samples: a sum for each, and what is shown until the longer ones are full.

use super::count::settled;
use super::{Lowering, Sampled, Standing, index, window_len};
use crate::program::{Field, Kind, Value};

impl Lowering<'_> {
    /// The longer windows, the prediction, the estimates and the status; `shortest` is the shortest window's estimate.
    ///
    /// A window that is not full yet shows what the next shorter one shows, so that the last of them is at any time
    /// the estimate of the longest window that is full; missing samples are predicted from it.
    pub(super) fn windows(&mut self, shortest: &[Value], sampled: &Sampled, count: Value) {
        let functional = self.functional;
        let mut full = vec![self.counted(count, self.window())];
        let mut estimates = vec![shortest.to_vec()];
        for longer in &functional.longer {
            let text = format!("the sums over a window of {} samples", longer.steps + 1);
            self.builder.section(&text);
            let sums = self.summed(longer, sampled);
            let here = self.counted(count, window_len(longer));
            let shorter = &estimates[estimates.len() - 1];
            let values =
                sums.iter().zip(shorter).map(|(sum, shorter)| self.builder.select(here, *sum, *shorter)).collect();
            full.push(here);
            estimates.push(values);
        }
        self.look_ahead(&estimates[estimates.len() - 1], sampled);
        self.builder.section("the estimates, shortest window first; until one is full, the start");
        let known = full[0];
        let determined = self.counted(count, settled(functional));
        self.end_given(determined);
        for (place, estimate) in estimates.iter().enumerate() {
            let estimate = self.at_the_newest(estimate, sampled);
            let behind = if place == 0 { String::new() } else { format!("_{}", place + 1) };
            self.show(&estimate, sampled, known, &behind);
        }
        let converged = self.converged_windows(&full);
        let (name, doc) = ("windows", "how many windows have converged without a replaced sample, shortest first");
        let field = Field { name: name.into(), unit: String::new(), doc: doc.into(), kind: Kind::Index };
        self.builder.estimate(field, converged);
        self.show_coasted(sampled);
        self.stand(&Standing { known, determined, renewed: None });
    }

    /// How many windows are full of good samples: every shorter one of such a window is, too.
    fn converged_windows(&mut self, full: &[Value]) -> Value {
        let coasting = self.builder.read(self.cells.coasting);
        let mut converged = self.builder.index(0);
        for (place, (window, full)) in self.functional.windows().zip(full).enumerate() {
            let left = self.builder.index(self.kept() - window_len(window) + 1);
            let clean = self.builder.index_less(coasting, left);
            let good = self.builder.and(*full, clean);
            let number = self.builder.index(index(place + 1));
            converged = self.builder.select(good, number, converged);
        }
        converged
    }
}
