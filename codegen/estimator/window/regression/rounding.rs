//! The one rounding of a regression's numbers, when they have settled.

use crate::estimator::window::settle::prediction;
use crate::estimator::window::{Functional, Prediction, Way, Weights};
use crate::real::{Matrix, Precision, Real};
use crate::sampled::model::Effect;
use crate::sampled::settle::Pass;
use crate::sampled::settled::Settled;
use crate::sampled::unknowns::augment::own_states;

use super::exact::{Exact, Problem};
use super::{Drive, Entry, Regression};

impl Problem<'_> {
    /// Takes what of two runs has settled.
    pub(super) fn round(&self, pass: &mut Pass, coarse: &Exact, fine: &Exact, shifts: &[i64]) -> Regression {
        let (n, all) = (fine.model.phi.rows(), self.plant.states.len());
        let (own, nothing) = (own_states(self.plant), Matrix::zeros(n, 1, Precision::bits(64)));
        let unknowns: Vec<usize> = self.functions.unknowns.iter().map(|i| own + i).collect();
        let states: Vec<usize> = (0..all).filter(|j| !unknowns.contains(j)).collect();
        let none = |count: usize| vec![Weights { first: 0, columns: vec![None; all] }; count];
        let predictions = coarse.prediction.iter().zip(&fine.prediction).map(|(c, f)| prediction(pass, c, f));
        let prediction: Vec<Prediction> = predictions
            .map(|found| {
                let mut wide = vec![None; all];
                states.iter().zip(&found.states).for_each(|(j, entry)| wide[*j] = *entry);
                Prediction { states: wide, ..found }
            })
            .collect();
        let ahead = |pass: &mut Pass, o: usize, s: usize, end: bool| -> Vec<Entry> {
            let share = |exact: &Exact, i: usize| exact.ahead(self.signals, (o, self.delays[o]), s, i, end);
            (0..unknowns.len()).map(|i| one(pass, &share(coarse, i), &share(fine, i))).collect()
        };
        let both = |pass: &mut Pass, end: bool| -> Vec<Vec<Vec<Entry>>> {
            let output = |pass: &mut Pass, o| (0..self.signals.len()).map(|s| ahead(pass, o, s, end)).collect();
            (0..self.delays.len()).map(|o| output(pass, o)).collect()
        };
        let (held, end) = (both(pass, false), both(pass, true));
        Regression {
            carrier: Functional {
                steps: self.steps,
                delays: self.delays.to_vec(),
                signals: self.signals.to_vec(),
                outputs: none(self.delays.len()),
                knowns: none(self.signals.len()),
                constant: vec![Settled::default(); all],
                prediction,
                gaps: None,
                irregular: None,
                way: Way::Fir,
                longer: Vec::new(),
            },
            states,
            own,
            unknowns,
            scales: shifts.iter().map(|e| power_of_two(*e)).collect(),
            phi: entries(pass, &coarse.model.phi, &fine.model.phi),
            known: drive(
                pass,
                (&coarse.model.effects, &fine.model.effects),
                (&coarse.model.constant, &fine.model.constant),
            ),
            gammas: coarse
                .gammas
                .iter()
                .zip(&fine.gammas)
                .map(|(c, f)| drive(pass, (c, f), (&nothing, &nothing)))
                .collect(),
            trust: coarse.trust.iter().zip(&fine.trust).map(|(c, f)| one(pass, c, f).unwrap_or_default()).collect(),
            shown: entries(pass, &coarse.shown, &fine.shown),
            rows: self.rows(pass, coarse, fine),
            through: entries(pass, &coarse.through, &fine.through),
            held,
            end,
            threshold: self.threshold,
            floors: vec![0.0; shifts.len()],
        }
    }

    /// o, a column of the window at a time: what is small in it is settled against what is large.
    fn rows(&self, pass: &mut Pass, coarse: &Exact, fine: &Exact) -> Vec<Vec<Vec<Settled>>> {
        let n = fine.through.cols();
        let mut rows = vec![vec![vec![Settled::default(); n]; self.delays.len()]; self.steps + 1];
        for o in 0..self.delays.len() {
            for k in 0..n {
                let column =
                    |exact: &Exact| -> Vec<Real> { exact.rows.iter().map(|row| row.get(o, k).clone()).collect() };
                let settled = pass.group(&column(coarse), &column(fine)).unwrap_or_default();
                rows.iter_mut().zip(settled).for_each(|(row, entry)| row[o][k] = entry);
            }
        }
        rows
    }
}

fn power_of_two(exponent: i64) -> f64 {
    Real::one(Precision::bits(64)).shifted(exponent).to_f64()
}

fn one(pass: &mut Pass, coarse: &Real, fine: &Real) -> Entry {
    pass.group(std::slice::from_ref(coarse), std::slice::from_ref(fine)).map(|settled| settled[0])
}

fn entries(pass: &mut Pass, coarse: &Matrix, fine: &Matrix) -> Vec<Vec<Entry>> {
    let row =
        |pass: &mut Pass, i: usize| (0..fine.cols()).map(|j| one(pass, coarse.get(i, j), fine.get(i, j))).collect();
    (0..fine.rows()).map(|i| row(pass, i)).collect()
}

fn drive(pass: &mut Pass, effects: (&[Effect], &[Effect]), constant: (&Matrix, &Matrix)) -> Drive {
    let n = constant.0.rows();
    let mut column = |coarse: Option<&Matrix>, fine: Option<&Matrix>| -> Vec<Entry> {
        let (Some(coarse), Some(fine)) = (coarse, fine) else { return vec![None; n] };
        (0..n).map(|i| one(pass, coarse.get(i, 0), fine.get(i, 0))).collect()
    };
    let pairs = || effects.0.iter().zip(effects.1);
    let begin = pairs().map(|(c, f)| column(c.at_begin.as_ref(), f.at_begin.as_ref())).collect();
    let end = pairs().map(|(c, f)| column(c.at_end.as_ref(), f.at_end.as_ref())).collect();
    Drive { begin, end, constant: column(Some(constant.0), Some(constant.1)) }
}
