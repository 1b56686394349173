//! What is known offline of an excitation that depends on time alone.
//!
//! The regression is run over windows along the horizon, in doubles. A window counts as exciting where
//! every pivot passes, as in the step. Unknowns whose factors depend on more are left out: what holds for a part
//! of the equations is necessary for the whole.

use crate::expr::Symbol;
use crate::expr::value::value;
use crate::numbers::count;
use crate::plant::Plant;
use crate::real::{Matrix, Precision, Real, singular_values};
use crate::sampled::Source;
use crate::sampled::unknowns::functions::Functions;

use super::{Drive, Entry, Regression};

/// Windows that are looked at.
const WINDOWS: usize = 1_000;
/// Windows that overlap at each sample.
const OVERLAP: usize = 8;
/// Products that are computed at most, a fraction of a second.
const MOST_WORK: usize = 40_000_000;

/// What the windows show.
#[derive(Clone, Debug)]
pub struct Excitation {
    /// Unknowns that are functions of time alone, by place among the regression's.
    pub unknowns: Vec<usize>,
    /// Windows that were looked at.
    pub windows: usize,
    /// The end of the last of them, s.
    pub until: f64,
    /// Those that excite.
    pub exciting: usize,
    /// The end of the first that does not, s.
    pub first_failure: Option<f64>,
    /// The smallest pivot over its gamma's energy, in the worst and in the best window.
    pub share: (f64, f64),
    /// In the best window: whose pivot that is, and the smallest singular value of S scaled to a diagonal of
    /// energies of one.
    pub weakest: (usize, f64),
    /// Where all of them are functions of time: the largest gain from bounded noise over the exciting windows, per
    /// state of the plant and output.
    pub gains: Option<Vec<Vec<f64>>>,
}

/// Looks at the windows; `None` where no gamma depends on time alone.
pub fn excitation(plant: &Plant, functions: &Functions, regression: &Regression) -> Option<Excitation> {
    let unknowns: Vec<usize> = (0..regression.unknowns.len()).filter(|i| functions.of_time(plant, *i)).collect();
    if unknowns.is_empty() {
        return None;
    }
    let steps = regression.carrier.steps;
    let stride = (steps / OVERLAP).max(1);
    let work = (steps + 1) * unknowns.len() * regression.own * (regression.own + 2 * regression.states.len());
    let windows = WINDOWS.min(MOST_WORK / work.max(1)).max(1);
    let doubles = Doubles::new(plant, regression, unknowns.clone());
    let h = plant.sample_time_s();
    let all = unknowns.len() == regression.unknowns.len();
    let mut result = Excitation {
        unknowns,
        windows,
        until: count((windows - 1) * stride + steps) * h,
        exciting: 0,
        first_failure: None,
        share: (f64::INFINITY, 0.0),
        weakest: (0, 0.0),
        gains: all.then(|| vec![vec![0.0; plant.outputs.len()]; plant.states.len()]),
    };
    for window in 0..windows {
        let seen = doubles.window(window * stride, h);
        let (place, share) = seen.weakest();
        if share > result.share.1 || window == 0 {
            result.share.1 = share;
            result.weakest = (result.unknowns[place], seen.smallest_singular_value());
        }
        result.share.0 = result.share.0.min(share);
        if share > regression.threshold {
            result.exciting += 1;
            if let Some(gains) = &mut result.gains {
                doubles.add_gains(&seen, gains);
            }
        } else if result.first_failure.is_none() {
            result.first_failure = Some(count(window * stride + steps) * h);
        }
    }
    Some(result)
}

/// The regression's constants as doubles.
struct Doubles<'a> {
    plant: &'a Plant,
    regression: &'a Regression,
    unknowns: Vec<usize>,
    phi: Vec<Vec<f64>>,
    shown: Vec<Vec<f64>>,
    through: Vec<Vec<f64>>,
}

/// One window: per unknown.
struct Seen {
    /// What the state cannot explain, by sample and output.
    left: Vec<Vec<f64>>,
    /// The energy of what is shown.
    energy: Vec<f64>,
    /// The response at the window's end, less what the state explains of it; per state of the regression.
    end: Vec<Vec<f64>>,
}

fn row(entries: &[Entry]) -> Vec<f64> {
    entries.iter().map(|entry| entry.map_or(0.0, |e| e.double)).collect()
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

impl<'a> Doubles<'a> {
    fn new(plant: &'a Plant, regression: &'a Regression, unknowns: Vec<usize>) -> Self {
        let matrix = |rows: &[Vec<Entry>]| rows.iter().map(|entries| row(entries)).collect();
        let (phi, shown) = (matrix(&regression.phi), matrix(&regression.shown));
        Self { plant, regression, unknowns, phi, shown, through: matrix(&regression.through) }
    }

    /// The value of each signal that is a function of time, at a call.
    fn signals(&self, call: usize, h: f64) -> Vec<f64> {
        let t = count(call) * h;
        let of = |source: Source| match source {
            Source::Injection(k) if self.plant.injections[k].symbols().iter().all(|s| *s == Symbol::Time) => {
                value(&self.plant.injections[k].node.poly, &|_| t)
            }
            _ => 0.0,
        };
        self.regression.carrier.signals.iter().map(|signal| of(signal.source)).collect()
    }

    /// The window that starts at a call.
    fn window(&self, first: usize, h: f64) -> Seen {
        let steps = self.regression.carrier.steps;
        let signals: Vec<Vec<f64>> = (first..=first + steps).map(|call| self.signals(call, h)).collect();
        let mut seen = Seen { left: Vec::new(), energy: Vec::new(), end: Vec::new() };
        for i in &self.unknowns {
            let (mut shown, end) = self.response(&self.regression.gammas[*i], &signals);
            seen.energy.push(dot(&shown, &shown));
            let n = self.regression.states.len();
            let columns = || self.regression.rows.iter().flatten();
            let share = |k: usize| columns().zip(&shown).map(|(o, v)| o[k].double * v).sum::<f64>();
            let shares: Vec<f64> = (0..n).map(share).collect();
            for (o, v) in columns().zip(&mut shown) {
                *v -= o.iter().zip(&shares).map(|(o, c)| o.double * c).sum::<f64>();
            }
            seen.left.push(shown);
            let explained = self.through.iter().map(|row| dot(row, &shares));
            seen.end.push(explained.zip(end).map(|(explained, end)| end - explained).collect());
        }
        seen
    }

    /// What a gamma shows, by sample and output, and its response at the end, per state of the regression.
    fn response(&self, drive: &Drive, signals: &[Vec<f64>]) -> (Vec<f64>, Vec<f64>) {
        let steps = self.regression.carrier.steps;
        let mut state = vec![0.0; self.regression.states.len()];
        let mut shown = Vec::new();
        let pushes: Vec<(usize, Vec<f64>, Vec<f64>)> =
            (0..drive.begin.len()).map(|s| (s, row(&drive.begin[s]), row(&drive.end[s]))).collect();
        for j in 0..=steps {
            if j > 0 {
                let mut next: Vec<f64> = self.phi.iter().map(|row| dot(row, &state)).collect();
                for (s, begin, end) in &pushes {
                    for (x, (b, e)) in next.iter_mut().zip(begin.iter().zip(end)) {
                        *x += b * signals[j - 1][*s] + e * signals[j][*s];
                    }
                }
                state = next;
            }
            for (o, row) in self.shown.iter().enumerate() {
                let arrived = j + self.regression.carrier.delays[o] <= steps;
                shown.push(if arrived { dot(row, &state) } else { 0.0 });
            }
        }
        (shown, state)
    }

    /// Raises the gains to those of one window.
    fn add_gains(&self, seen: &Seen, gains: &mut [Vec<f64>]) {
        let regression = self.regression;
        let Some(weights) = seen.weights() else { return };
        let outputs = self.plant.outputs.len();
        let trust = |place: usize| regression.trust[place % outputs].double;
        let rows: Vec<&Vec<crate::sampled::settled::Settled>> = regression.rows.iter().flatten().collect();
        let mut raise = |state: usize, weight: &dyn Fn(usize) -> f64| {
            let mut sums = vec![0.0; outputs];
            (0..rows.len()).for_each(|place| sums[place % outputs] += (weight(place) * trust(place)).abs());
            gains[state].iter_mut().zip(sums).for_each(|(gain, sum)| *gain = gain.max(sum));
        };
        for (i, (state, scale)) in regression.unknowns.iter().zip(&regression.scales).enumerate() {
            raise(*state, &|place| weights[i][place] * scale);
        }
        for (a, state) in regression.states.iter().enumerate() {
            raise(*state, &|place| {
                let own: f64 = rows[place].iter().zip(&self.through[a]).map(|(o, t)| o.double * t).sum();
                own + weights.iter().zip(&seen.end).map(|(w, end)| w[place] * end[a]).sum::<f64>()
            });
        }
    }
}

impl Seen {
    /// S, scaled to energies of one.
    fn normal(&self) -> Vec<Vec<f64>> {
        let size: Vec<f64> = self.energy.iter().map(|g| deadbeat_math::sqrt_f64(*g).max(f64::MIN_POSITIVE)).collect();
        let entry = |i: usize, j: usize| dot(&self.left[i], &self.left[j]) / size[i] / size[j];
        (0..size.len()).map(|i| (0..size.len()).map(|j| entry(i, j)).collect()).collect()
    }

    /// The smallest pivot of that, with its place.
    fn weakest(&self) -> (usize, f64) {
        let mut s = self.normal();
        let mut weakest = (0, f64::INFINITY);
        for i in 0..s.len() {
            let pivot = s[i][i].max(0.0);
            if pivot < weakest.1 {
                weakest = (i, pivot);
            }
            let (done, rest) = s.split_at_mut(i + 1);
            for row in rest {
                let factor = if pivot > 0.0 { row[i] / pivot } else { 0.0 };
                row.iter_mut().zip(&done[i]).skip(i).for_each(|(x, y)| *x -= factor * y);
            }
        }
        weakest
    }

    fn smallest_singular_value(&self) -> f64 {
        let (p, s) = (Precision::bits(128), self.normal());
        let real = |x: f64| Real::from_f64(x, p).unwrap_or_else(|| Real::zero(p));
        let matrix = Matrix::from_fn(s.len(), s.len(), |i, j| real(s[i][j]));
        singular_values(&matrix).last().map_or(0.0, Real::to_f64)
    }

    /// `S^-1 e`: what each sample counts in each scaled unknown.
    fn weights(&self) -> Option<Vec<Vec<f64>>> {
        let p = Precision::bits(128);
        let q = self.left.len();
        let real = |x: f64| Real::from_f64(x, p).unwrap_or_else(|| Real::zero(p));
        let inverse =
            crate::real::inverse(&Matrix::from_fn(q, q, |i, j| real(dot(&self.left[i], &self.left[j])))).ok()?;
        let inverse = inverse.to_f64();
        let weight = |i: usize, place: usize| (0..q).map(|j| inverse[i][j] * self.left[j][place]).sum();
        Some((0..q).map(|i| (0..self.left[i].len()).map(|place| weight(i, place)).collect()).collect())
    }
}
