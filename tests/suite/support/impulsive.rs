//! Random linear plants for the impulsive observer, and what rounding can do to it.

#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(clippy::cast_precision_loss, reason = "sizes of plants and counts of steps are small")]

use deadbeat_codegen::internals::estimator::copies::{Grid, Impulsive};
use deadbeat_codegen::internals::sampled::settled::Settled;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Generated, Generator};
use nalgebra::{DMatrix, DVector};

use super::plant::{NOTHING_YET, Random, Run, UNIT, designed, matrix};

/// Sizes and kinds, which proptest shrinks; the numbers follow from a seed.
pub type Sizes = (usize, usize, usize, bool, usize, u64);

/// A random linear plant with held inputs. Entries are dyadic, so that the simulation is of the same plant.
pub struct Linear {
    pub discrete: bool,
    pub h: f64,
    /// N.
    pub steps: usize,
    pub a: DMatrix<f64>,
    pub b: DMatrix<f64>,
    pub c: DMatrix<f64>,
    /// L; `None` leaves it to the tool.
    pub gain: Option<DMatrix<f64>>,
}

impl Linear {
    pub fn new((n, p, m, discrete, spare, seed): Sizes) -> Self {
        let p = p.min(n - 1);
        let mut random = Random::new(seed);
        let h = [0.0625, 0.125, 0.25][random.below(3)];
        let mut entry = |most: f64, zeros: usize| {
            let value = (random.within(-most, most) * 64.0).round() / 64.0;
            if random.below(10) < zeros { 0.0 } else { value }
        };
        let most = if discrete { 2.0 / (n as f64).sqrt() } else { 2.0 };
        let a = DMatrix::from_fn(n, n, |_, _| entry(most, 3));
        let b = DMatrix::from_fn(n, m, |_, _| entry(2.0, 2));
        // Few zeros: outputs that repeat each other are refused.
        let c = DMatrix::from_fn(p, n, |_, _| entry(2.0, 1));
        let gain = DMatrix::from_fn(n - p, p, |_, _| entry(1.0, 1));
        let gain = if random.below(2) == 0 { Some(gain) } else { None };
        Self { discrete, h, steps: n + spare, a, b, c, gain }
    }

    /// The specification, with more keys of the method.
    pub fn text(&self, keys: &str) -> String {
        let row = |row: Vec<f64>| format!("[{}]", row.iter().map(f64::to_string).collect::<Vec<_>>().join(", "));
        let rows =
            |m: &DMatrix<f64>| m.row_iter().map(|r| row(r.iter().copied().collect())).collect::<Vec<_>>().join(", ");
        let time = if self.discrete { "discrete" } else { "continuous" };
        let inputs = if self.b.ncols() > 0 { format!("B = [{}]\n", rows(&self.b)) } else { String::new() };
        let gain = self.gain.as_ref().map_or_else(String::new, |gain| format!("L = [{}]\n", rows(gain)));
        format!(
            "deadbeat = 1\nname = 'random'\n[plant]\ntime = '{time}'\nA = [{}]\nC = [{}]\n{inputs}[observer.impulsive]\n\
             window = {}\n{gain}{keys}\n[target]\nsample_time = {}\nscalar = 'f64'\n",
            rows(&self.a),
            rows(&self.c),
            self.steps as f64 * self.h,
            self.h
        )
    }

    /// Phi and the effect of a held input.
    pub fn sampled(&self) -> (DMatrix<f64>, DMatrix<f64>) {
        let (n, m) = (self.a.nrows(), self.b.ncols());
        if self.discrete {
            return (self.a.clone(), self.b.clone());
        }
        let mut whole = DMatrix::zeros(n + m, n + m);
        whole.view_mut((0, 0), (n, n)).copy_from(&(&self.a * self.h));
        whole.view_mut((0, n), (n, m)).copy_from(&(&self.b * self.h));
        let whole = exponential(&whole);
        (whole.view((0, 0), (n, n)).into_owned(), whole.view((0, n), (n, m)).into_owned())
    }

    /// A run from a random state, and the error of one simulated step per state in units of u.
    pub fn run(&self, calls: usize, seed: u64) -> (Run, Vec<f64>) {
        let mut random = Random::new(seed);
        let start = DVector::from_fn(self.a.nrows(), |_, _| random.within(-1.0, 1.0));
        self.run_from(start, calls, &mut random)
    }

    /// A run from a state.
    pub fn run_from(&self, start: DVector<f64>, calls: usize, random: &mut Random) -> (Run, Vec<f64>) {
        let (n, m) = (self.a.nrows(), self.b.ncols());
        let (phi, held) = self.sampled();
        let mut x = start;
        let mut run = Run::default();
        let mut largest = DVector::zeros(n);
        let mut applied = DVector::from_element(m, NOTHING_YET);
        for call in 0..calls {
            if call > 0 {
                applied = DVector::from_fn(m, |_, _| random.within(-1.0, 1.0));
                x = &phi * &x + &held * &applied;
            }
            largest = DVector::from_fn(n, |i, _| f64::max(largest[i], x[i].abs()));
            run.inputs.push(applied.iter().copied().collect());
            run.states.push(x.iter().copied().collect());
            run.measurements.push((&self.c * &x).iter().copied().collect());
        }
        // Each product and sum is rounded; the exponential is right to some units of its largest entries.
        let exponential = if self.discrete { 0.0 } else { 32.0 * phi.abs().max().max(1.0) };
        let total = largest.sum() + held.abs().max() * m as f64;
        let through = phi.abs() * &largest + held.abs() * DVector::from_element(m, 1.0);
        (run, through.iter().map(|t| (n + m + 2) as f64 * t + exponential * total).collect())
    }
}

/// The exponential: halved until its norm is below 1/2, twenty terms of the series, squared again.
fn exponential(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let norm = matrix.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let halvings = (0..60).find(|s| norm * 0.5_f64.powi(*s) < 0.5).unwrap();
    let small = matrix * 0.5_f64.powi(halvings);
    let identity = DMatrix::identity(matrix.nrows(), matrix.nrows());
    let sum = (1..=20).rev().fold(identity.clone(), |sum, k| &identity + &small * sum / f64::from(k));
    (0..halvings).fold(sum, |power, _| &power * &power)
}

/// The shape of an impulsive design.
pub fn impulsive(generated: &Generated) -> &Impulsive {
    generated.design.estimator.downcast_ref::<Impulsive>().expect("an impulsive design")
}

fn dense(grid: &Grid, cols: usize) -> DMatrix<f64> {
    DMatrix::from_fn(grid.len(), cols, |i, j| grid[i][j].map_or(0.0, |entry: Settled| entry.double))
}

/// Per state: the most by which rounding can move the estimate from the simulated state, in the exact form.
///
/// A call rounds every product with its constant, and every sum: (terms + 3) u of the sum of magnitudes, for either
/// copy; the simulation rounds its states likewise. A period carries these errors with the copies' own powers, the
/// reset multiplies them by R1 and R2, and rounds its own sums; from there z1's powers carry them on.
pub fn rounding(generated: &Generated, run: &Run, step: &[f64]) -> Vec<f64> {
    let design = impulsive(generated);
    let (rest, n) = (design.rest.len(), generated.plant.states.len());
    let p = n - rest;
    let named = |letter: &str| {
        let rows = matrix(generated, letter);
        DMatrix::from_fn(rows.len(), rows[0].len(), |i, j| rows[i][j])
    };
    let (x, r1, gain) = (named("X"), named("R1"), named("L").abs());
    let back = dense(&design.back, n).abs();
    let into = dense(&design.back, n).try_inverse().unwrap().abs();
    let sizes = |rows: &[Vec<f64>], count: usize| {
        DVector::from_fn(count, |i, _| rows.iter().map(|row| row[i].abs()).fold(0.0, f64::max))
    };
    let states = sizes(&run.states, n);
    let outputs = sizes(&run.measurements, p);
    let inputs = sizes(&run.inputs, generated.plant.inputs.len());
    let reduced = &into * &states;
    let rests = reduced.rows(p, rest).into_owned();
    let simulated = &into * DVector::from_column_slice(step);
    let (of_outputs, of_rests) = (simulated.rows(0, p).into_owned(), simulated.rows(p, rest).into_owned());

    // Per copy: the error that a call adds, and the sum of what a period of them becomes behind the reset.
    let copy = |update: &deadbeat_codegen::internals::estimator::copies::Update,
                common: &DVector<f64>,
                plant: &DVector<f64>,
                reset: &DMatrix<f64>| {
        let own = dense(&update.copy, rest);
        let mut powers = vec![DMatrix::identity(rest, rest)];
        for j in 0..design.calls.period {
            powers.push(&powers[j] * &own);
        }
        // Until the first reset a copy is off by what it carries on of the first state.
        let carried = powers.iter().map(|power| power.abs() * &rests).reduce(|a, b| a.sup(&b)).unwrap();
        let size = common + &carried;
        let known = |i: usize| -> f64 {
            update
                .knowns
                .iter()
                .zip(inputs.iter())
                .map(|(taps, u)| taps[0][i].map_or(0.0, |t| t.double.abs()) * u)
                .sum()
        };
        let all =
            own.abs() * &size + dense(&update.outputs[1], p).abs() * &outputs + DVector::from_fn(rest, |i, _| known(i));
        let terms = (n + p + inputs.len() + 3) as f64;
        let added = all * terms + plant;
        let sum = powers.iter().map(|power| (reset * power).abs() * &added).sum::<DVector<f64>>();
        (size, added, sum, powers)
    };
    let (first_size, added, first, powers) = copy(&design.first, &rests, &of_rests, &r1);
    let shifted = &rests + &gain * &outputs;
    let (second_size, _, second, _) = copy(&design.second, &shifted, &(&of_rests + &gain * &of_outputs), &x);
    let differences = &first_size + &second_size + &gain * &outputs;
    let at_reset = &first + &second + x.abs() * &differences * (rest + p + 4) as f64 + &first_size * 2.0;
    let mut worst = DVector::zeros(rest);
    let mut since: DVector<f64> = DVector::zeros(rest);
    for power in &powers {
        worst = worst.sup(&(power.abs() * &at_reset + &since));
        since += power.abs() * &added;
    }
    let mut error = DVector::zeros(n);
    error.rows_mut(p, rest).copy_from(&worst);
    // The sample itself is C x rounded.
    error.rows_mut(0, p).copy_from(&(outputs.clone() * (n + 1) as f64));
    let total = &back * &error + &back * &reduced * (n + 2) as f64;
    total.iter().map(|bound| UNIT * bound).collect()
}

/// What one period makes of the error of z1: a column per state that is not measured, from a run in which the plant
/// is at rest and z1 starts at 1 there. `keys` are more of the method's.
pub fn period_map(linear: &Linear, keys: &str) -> Option<(Generated, DMatrix<f64>)> {
    let text = linear.text(keys);
    let generated = Generator::new(&text, "random.toml").design().ok()?;
    let design = impulsive(&generated);
    let (n, rest) = (linear.a.nrows(), design.rest.len());
    let mut map = DMatrix::zeros(rest, rest);
    for (unit, place) in design.rest.iter().enumerate() {
        let states: Vec<String> =
            (0..n).map(|i| format!("x{} = {{ initial = {} }}", i + 1, u8::from(i == *place))).collect();
        let started = designed(&text.replace("[observer", &format!("[states]\n{}\n[observer", states.join("\n"))));
        let mut interpreter = Interpreter::new(&started.program);
        let mut estimate = vec![0.0; n];
        for _ in 0..=design.calls.warm_up + design.calls.period {
            interpreter.step(&vec![0.0; linear.c.nrows()], &[], &mut estimate);
        }
        let cells = interpreter.cells();
        for (i, place) in design.rest.iter().enumerate() {
            let name = format!("z1_x{}", place + 1);
            map[(i, unit)] = cells.iter().find(|(cell, _)| *cell == name).map_or(f64::NAN, |(_, held)| held[0]);
        }
    }
    Some((generated, map))
}

/// The largest magnitude of an eigenvalue.
pub fn radius(map: &DMatrix<f64>) -> f64 {
    map.complex_eigenvalues().iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max)
}
