//! Random linear plants: up to six states, three outputs, some of them late, and two inputs of either hold;
//! continuous or discrete, stable or not, written as matrices or as equations. Entries are dyadic, so that the
//! simulation is of the same plant to the last bit.

#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use std::fmt::Write as _;

use nalgebra::{DMatrix, DVector};

use super::plant::{Hold, NOTHING_YET, Random, Run};

/// A random linear plant.
pub struct Linear {
    pub discrete: bool,
    pub equations: bool,
    pub h: f64,
    pub steps: usize,
    pub a: DMatrix<f64>,
    pub b: DMatrix<f64>,
    pub c: DMatrix<f64>,
    pub holds: Vec<Hold>,
    pub delays: Vec<usize>,
    /// Per output, where declared.
    pub noise: Vec<f64>,
    /// Per output, where declared: measured at every so many calls.
    pub every: Vec<usize>,
    /// Per output, where declared: the oldest sample that comes with its age, s.
    pub ages: Vec<f64>,
}

/// Sizes and kinds, which proptest shrinks; the numbers follow from a seed.
pub type Shape = (usize, usize, usize, (bool, bool), usize, u64);

impl Linear {
    /// The plant of a shape, with the random numbers that go on from there for what is asked of it.
    pub fn new((n, p, m, (discrete, equations), spare, seed): Shape) -> (Self, Random) {
        let mut random = Random::new(seed);
        let h = [0.0625, 0.125, 0.25][random.below(3)];
        let delays: Vec<usize> = (0..p).map(|_| if random.below(3) == 0 { 1 + random.below(3) } else { 0 }).collect();
        // Some entries are structural zeros, so that some plants do not show their state.
        let mut entry = |most: f64, zeros: usize| {
            let value = (random.within(-most, most) * 64.0).round() / 64.0;
            if random.below(10) < zeros { 0.0 } else { value }
        };
        // Discrete plants with radii around 1, continuous ones with |A| h around 1: stable and unstable.
        let most = if discrete { 2.0 / (n as f64).sqrt() } else { 2.0 };
        let a = DMatrix::from_fn(n, n, |_, _| entry(most, 3));
        let b = DMatrix::from_fn(n, m, |_, _| entry(2.0, 2));
        let mut c = DMatrix::from_fn(p, n, |_, _| entry(2.0, 4));
        for mut row in c.row_iter_mut() {
            if row.iter().all(|x| *x == 0.0) {
                row[0] = 1.0;
            }
        }
        let holds = (0..m).map(|_| if random.below(2) == 0 { Hold::Zero } else { Hold::First }).collect();
        let steps = n + delays.iter().max().unwrap() + spare;
        (
            Self {
                discrete,
                equations,
                h,
                steps,
                a,
                b,
                c,
                holds,
                delays,
                noise: Vec::new(),
                every: Vec::new(),
                ages: Vec::new(),
            },
            random,
        )
    }

    /// The specification; `observer` is a table's name with its keys beside the window, a line each.
    pub fn text(&self, observer: &str) -> String {
        // Constant weights, where several outputs of which one could be lost would else be solved for.
        let regular = self.every.is_empty() && self.ages.is_empty();
        let window = observer.starts_with("[observer.window]") && !observer.contains("missing");
        let missing = if regular && window { "\nmissing = 'predicted'" } else { "" };
        self.specification(&format!("{observer}{missing}\nwindow = {}", self.steps as f64 * self.h))
    }

    /// The specification; `observer` is a table's name with its keys, a line each.
    pub fn specification(&self, observer: &str) -> String {
        let mut text = "deadbeat = 1\nname = 'random'\n".to_owned();
        let row = |row: Vec<f64>| format!("[{}]", row.iter().map(f64::to_string).collect::<Vec<_>>().join(", "));
        let rows =
            |m: &DMatrix<f64>| m.row_iter().map(|r| row(r.iter().copied().collect())).collect::<Vec<_>>().join(", ");
        let sum = |r: Vec<f64>, letter: &str| {
            let terms = r.iter().enumerate().filter(|(_, x)| **x != 0.0);
            terms.map(|(i, x)| format!("({x})*{letter}{}", i + 1)).collect::<Vec<_>>().join(" + ")
        };
        if self.equations {
            text += "[states]\n";
            for i in 0..self.a.nrows() {
                let key = if self.discrete { "next" } else { "derivative" };
                let (states, inputs) =
                    (self.a.row(i).iter().copied().collect(), self.b.row(i).iter().copied().collect());
                let _ = writeln!(
                    text,
                    "x{} = {{ {key} = '0 + {} + {}' }}",
                    i + 1,
                    or_zero(sum(states, "x")),
                    or_zero(sum(inputs, "u"))
                );
            }
        } else {
            let time = if self.discrete { "discrete" } else { "continuous" };
            let _ = writeln!(text, "[plant]\ntime = '{time}'\nA = [{}]\nC = [{}]", rows(&self.a), rows(&self.c));
            if !self.holds.is_empty() {
                let _ = writeln!(text, "B = [{}]", rows(&self.b));
            }
        }
        if !self.holds.is_empty() {
            text += "[inputs]\n";
        }
        for (i, hold) in self.holds.iter().enumerate() {
            let _ =
                writeln!(text, "u{} = {{ hold = '{}' }}", i + 1, if *hold == Hold::Zero { "zero" } else { "first" });
        }
        text += "[outputs]\n";
        for (o, delay) in self.delays.iter().enumerate() {
            let value = if self.equations {
                format!("value = '{}'", sum(self.c.row(o).iter().copied().collect(), "x"))
            } else {
                String::new()
            };
            let late = if *delay > 0 { format!("delay = {}", *delay as f64 * self.h) } else { String::new() };
            let noise = self.noise.get(o).map_or_else(String::new, |noise| format!("noise = {noise}"));
            let every = self.every.get(o).map_or_else(String::new, |every| format!("every = {every}"));
            let age = self
                .ages
                .get(o)
                .filter(|most| **most > 0.0)
                .map_or_else(String::new, |most| format!("age = 'measured', age_max = {most}"));
            let entries: Vec<String> = [value, late, noise, every, age].into_iter().filter(|s| !s.is_empty()).collect();
            let _ = writeln!(text, "y{} = {{ {} }}", o + 1, entries.join(", "));
        }
        let _ = writeln!(text, "{observer}\n[target]\nsample_time = {}\nscalar = 'f64'", self.h);
        text
    }

    /// exp of [A B 0; 0 0 I; 0 0 0] h: Phi, the effect of a held input, and of one that rises by 1 over the interval.
    pub fn sampled(&self) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
        if self.discrete {
            let (n, m) = (self.a.nrows(), self.b.ncols());
            return (self.a.clone(), self.b.clone(), DMatrix::zeros(n, m));
        }
        self.over(self.h)
    }

    /// The same over another time, forwards or backwards.
    pub fn over(&self, time: f64) -> (DMatrix<f64>, DMatrix<f64>, DMatrix<f64>) {
        let (n, m) = (self.a.nrows(), self.b.ncols());
        let mut whole = DMatrix::zeros(n + 2 * m, n + 2 * m);
        whole.view_mut((0, 0), (n, n)).copy_from(&(&self.a * time));
        whole.view_mut((0, n), (n, m)).copy_from(&(&self.b * time));
        whole.view_mut((n, n + m), (m, m)).fill_with_identity();
        let whole = exponential(&whole);
        let part = |from: usize, width: usize| whole.view((0, from), (n, width)).into_owned();
        (part(0, n), part(n, m), part(n + m, m))
    }

    /// A run, and the error of one simulated step per state in units of u.
    pub fn run(&self, calls: usize, seed: u64) -> (Run, Vec<f64>) {
        let (n, m) = (self.a.nrows(), self.holds.len());
        let mut random = Random::new(seed);
        let (phi, held, rise) = self.sampled();
        let mut x = DVector::from_fn(n, |_, _| random.within(-1.0, 1.0));
        let knots: Vec<DVector<f64>> =
            (0..=calls).map(|_| DVector::from_fn(m, |_, _| random.within(-1.0, 1.0))).collect();
        let mut run = Run::default();
        let mut largest = DVector::zeros(n);
        for call in 0..calls {
            if call > 0 {
                let (from, to) = (&knots[call - 1], &knots[call]);
                // A discrete plant uses the value at the beginning of its step, whatever the hold.
                let rises =
                    DVector::from_fn(m, |i, _| if self.holds[i] == Hold::First { to[i] - from[i] } else { 0.0 });
                x = &phi * &x + &held * from + &rise * rises;
            }
            largest = DVector::from_fn(n, |i, _| f64::max(largest[i], x[i].abs()));
            let input = |i: usize| match self.holds[i] {
                Hold::Zero if call == 0 => NOTHING_YET,
                Hold::Zero => knots[call - 1][i],
                Hold::First => knots[call][i],
            };
            run.inputs.push((0..m).map(input).collect());
            run.states.push(x.iter().copied().collect());
            let sample = |o: usize| match call.checked_sub(self.delays[o]) {
                Some(past) => (self.c.row(o) * DVector::from_vec(run.states[past].clone()))[0],
                None => NOTHING_YET,
            };
            run.measurements.push((0..self.delays.len()).map(sample).collect());
        }
        // Each product and sum is rounded; the exponential is right to some units of its largest entries.
        let (norm, roundings) = (phi.abs().max().max(1.0), (n + 2 * m + 2) as f64);
        let exponential = if self.discrete { 0.0 } else { 32.0 * norm };
        let total = largest.sum() + 2.0 * held.abs().max().max(rise.abs().max()) * m as f64;
        let through = phi.abs() * &largest
            + held.abs() * DVector::from_element(m, 1.0)
            + rise.abs() * DVector::from_element(m, 2.0);
        let step = through.iter().map(|t| roundings * t + exponential * total).collect();
        (run, step)
    }
}

/// The exponential: halved until its norm is below 1/2, twenty terms of the series, squared again.
pub fn exponential(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let norm = matrix.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let halvings = (0..60).find(|s| norm * 0.5_f64.powi(*s) < 0.5).unwrap();
    let small = matrix * 0.5_f64.powi(halvings);
    let identity = DMatrix::identity(matrix.nrows(), matrix.nrows());
    let sum = (1..=20).rev().fold(identity.clone(), |sum, k| &identity + &small * sum / f64::from(k));
    (0..halvings).fold(sum, |power, _| &power * &power)
}

fn or_zero(text: String) -> String {
    if text.is_empty() { "0".into() } else { text }
}
