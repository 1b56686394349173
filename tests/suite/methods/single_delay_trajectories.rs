//! Claim: with the design's constants the paper's observers run as they do in an independent program: the dynamic
//! extension (7) with (13) on the motor (65), and Theorem 2's (39), corrected, with measurements every 5 ms
//! (`tests/golden/traj_motor_000_*.json`, by another program and another integrator).
//!
//! Corrected: (13) has `R (Y - xihat_2)`, or `R (omega - xihat_2)` for Theorem 2, where the paper writes `xi_2(t)`; the
//! second line of (39) has `A_2 xihat_1`. psi is 0 before the start.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of steps are small"
)]

use crate::support::{collocation, golden, plant};

use collocation::Collocation;
use plant::{designed, matrix};
use serde_json::Value;

/// The integrator's step, s; divides the delay, the times of the files and the time between measurements.
const STEP: f64 = 0.0025;
/// Steps of the delay of 0.1 s.
const DELAY: usize = 40;

/// The paper's observer of the motor.
struct Observer {
    k: f64,
    r: Vec<f64>,
    h: Vec<f64>,
    s_inverse: Vec<Vec<f64>>,
    decay: f64,
    psi2: Vec<Vec<f64>>,
}

/// The motor's states, then `xihat_1`, `xihat_2`, `psi_1`, `psi_2`, omega.
const SIZE: usize = 3 + 2 + 1 + 2 + 2 + 1;

impl Observer {
    fn new(k: u32) -> Self {
        let generated = designed(&format!(
            "deadbeat = 1
name = 'motor'
[states]
q = {{ derivative = 'dq' }}
dq = {{ derivative = '15*i - 35*sin(q) - dq' }}
i = {{ derivative = '40*u - 36.4*dq - 200*i' }}
[inputs]
u = {{}}
[outputs]
y = {{ value = 'q' }}
[observer.single-delay]
window = 0.1
k = {k}
form = 'continuous'
[target]
sample_time = 0.005
scalar = 'f64'
"
        ));
        let column = |letter: &str| matrix(&generated, letter).iter().map(|row| row[0]).collect();
        Self {
            k: f64::from(k),
            r: column("R"),
            h: column("H"),
            s_inverse: matrix(&generated, "Sinv").to_vec(),
            decay: matrix(&generated, "exp(-k tau)")[0][0],
            psi2: matrix(&generated, "exp(-(A1' + 2kI) tau)").to_vec(),
        }
    }

    /// (13), with what is known of the output; `past` is the state a delay ago, where there was one.
    fn estimate(&self, x: &[f64], output: f64, past: Option<&[f64]>) -> [f64; 2] {
        let psi = |x: Option<&[f64]>, from: usize, i: usize| x.map_or(0.0, |x| x[from + i]);
        let bracket: Vec<f64> = (0..2)
            .map(|i| {
                let psi1 = self.decay * psi(past, 6, i) - x[6 + i];
                let back: f64 = (0..2).map(|j| self.psi2[i][j] * psi(past, 8, j)).sum();
                psi1 + x[8 + i] - back
            })
            .collect();
        let row = |i: usize| -> f64 { self.s_inverse[i].iter().zip(&bracket).map(|(s, b)| s * b).sum() };
        [0, 1].map(|i| x[3 + i] + self.r[i] * (output - x[5]) + row(i))
    }

    /// (65), (7) and (39): what drives the extension is the output, or omega.
    fn rhs(&self, t: f64, x: &[f64], by_omega: bool, past: Option<&[f64]>) -> Vec<f64> {
        let (u, y) = ((3.0 * t).sin(), if by_omega { x[10] } else { x[0] });
        let (first, second, innovation) = (x[3], x[4], y - x[5]);
        let k = self.k;
        let omega = if by_omega { self.estimate(x, y, past)[0] } else { 0.0 };
        vec![
            x[1],
            15.0 * x[2] - 35.0 * x[0].sin() - x[1],
            40.0 * u - 36.4 * x[1] - 200.0 * x[2],
            -first + 15.0 * second - 35.0 * y.sin(),
            -36.4 * first - 200.0 * second + 40.0 * u,
            first - k * x[5] + k * y,
            -k * x[6] + self.h[0] * innovation,
            -k * x[7] + self.h[1] * innovation,
            -((-1.0 + 2.0 * k) * x[8] - 36.4 * x[9]) + self.h[0] * innovation,
            -(15.0 * x[8] + (-200.0 + 2.0 * k) * x[9]) + self.h[1] * innovation,
            omega,
        ]
    }

    /// The error of (13) with omega at a step of a run.
    fn error(&self, run: &[Vec<f64>], step: usize) -> [f64; 2] {
        let past = step.checked_sub(DELAY).map(|step| run[step].as_slice());
        let estimate = self.estimate(&run[step], run[step][10], past);
        [0, 1].map(|i| estimate[i] - run[step][1 + i])
    }

    /// The states at the steps up to a time; a measurement resets omega every so many steps.
    fn run(&self, steps: usize, measured_every: Option<usize>) -> Vec<Vec<f64>> {
        let method = Collocation::new(10);
        let mut x = vec![0.0; SIZE];
        x[..3].copy_from_slice(&[0.5, 1.0, 2.0]);
        let (mut all, mut stages): (Vec<Vec<f64>>, Vec<Vec<Vec<f64>>>) = (Vec::new(), Vec::new());
        for step in 0..=steps {
            if measured_every.is_some_and(|every| step % every == 0) {
                x[10] = x[0];
            }
            all.push(x.clone());
            let past = |stage: usize| step.checked_sub(DELAY).map(|step| stages[step][stage].as_slice());
            let rhs = |stage: usize, t: f64, x: &[f64]| self.rhs(t, x, measured_every.is_some(), past(stage));
            let (next, now) = method.step(&rhs, step as f64 * STEP, STEP, &x);
            stages.push(now);
            x = next;
        }
        all
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().map_or_else(|| value.as_f64().into_iter().collect(), |all| all.iter().flat_map(numbers).collect())
}

/// The rows of a list in a golden file.
fn rows(file: &str, key: &str) -> Vec<Value> {
    let file: Value = serde_json::from_str(&golden::text(file)).unwrap();
    file[key].as_array().unwrap().clone()
}

fn step_at(time: &Value) -> usize {
    (time.as_f64().unwrap() / STEP).round() as usize
}

/// A column's largest magnitude, and the largest distance from ours.
#[derive(Clone, Copy, Default)]
struct Column {
    scale: f64,
    apart: f64,
}

impl Column {
    fn add(&mut self, ours: &[f64], theirs: &[f64]) {
        assert_eq!(ours.len(), theirs.len());
        for (ours, theirs) in ours.iter().zip(theirs) {
            self.scale = self.scale.max(theirs.abs());
            self.apart = self.apart.max((ours - theirs).abs());
        }
    }

    fn within(&self, what: &str, tolerance: f64) {
        let relative = self.apart / self.scale;
        println!("{what}: {:.1e} of {:.1e}, {relative:.1e}", self.apart, self.scale);
        assert!(relative <= tolerance, "{what}: {:e} of {:e}", self.apart, self.scale);
    }
}

/// Theorem 1: every column that is recorded to 1e-13 of its scale, and `xi_e` is `xi_1` once the delay is over.
///
/// One column is not recorded so well: `psi_2` for k = 150 is wrong by 5.4e-13 of its scale at its first record, as
/// [`the_first_fifty_milliseconds_are_those_of_mpmath`] shows.
#[test]
fn the_dynamic_extension_runs_as_recorded() {
    let columns = [("xi1", 1..3), ("xihat1", 3..5), ("xihat2", 5..6), ("psi1", 6..8), ("psi2", 8..10)];
    for k in [100, 150] {
        let observer = Observer::new(k);
        let run = observer.run(400, None);
        let (mut compared, mut estimate, mut exact) = ([Column::default(); 5], Column::default(), Column::default());
        let rows = rows("traj_motor_000_thm1", &format!("k{k}"));
        assert_eq!(rows.len(), 51);
        for row in rows {
            let step = step_at(&row["t"]);
            for ((name, place), column) in columns.iter().zip(&mut compared) {
                column.add(&run[step][place.clone()], &numbers(&row[*name]));
            }
            if let Some(past) = step.checked_sub(DELAY) {
                let ours = observer.estimate(&run[step], run[step][0], Some(&run[past]));
                estimate.add(&ours, &numbers(&row["xi_e"]));
                exact.add(&ours, &run[step][1..3]);
            }
        }
        for ((name, _), column) in columns.iter().zip(compared) {
            column.within(&format!("k = {k}, {name}"), if (k, *name) == (150, "psi2") { 6e-13 } else { 1e-13 });
        }
        estimate.within(&format!("k = {k}, xi_e"), 1e-13);
        exact.within(&format!("k = {k}, xi_e against xi_1"), 1e-13);
    }
}

/// Theorem 2, corrected: the errors of the estimate. The file's own integrator is wrong by 2.5e-11 (err11) and
/// 4.8e-11 (err12) in the first 30 ms, where the errors are large, 5e-13 and 4.1e-12 of the scale; see below.
///
/// omega is recorded right after each measurement only, where it is the output: nothing to compare.
#[test]
fn measurements_every_five_milliseconds_run_as_recorded() {
    let observer = Observer::new(100);
    let rows = rows("traj_motor_000_thm2_corrected", "rows");
    let run = observer.run(step_at(&rows[rows.len() - 1][0]), Some(2));
    let mut columns = [Column::default(); 2];
    for row in &rows {
        let error = observer.error(&run, step_at(&row[0]));
        for (i, column) in columns.iter_mut().enumerate() {
            column.add(&error[i..=i], &numbers(&row[1 + i]));
        }
    }
    assert_eq!(rows.len(), 61);
    columns[0].within("err11", 6e-13);
    columns[1].within("err12", 5e-12);
}

/// The same against 20 digits: what the files miss is theirs (`tests/golden/motor_000_starts.py`).
#[test]
fn the_first_fifty_milliseconds_are_those_of_mpmath() {
    let observer = Observer::new(100);
    let run = observer.run(20, Some(2));
    let mut errors = Column::default();
    for row in rows("motor_000_starts", "thm2_k100") {
        errors.add(&observer.error(&run, step_at(&row[0])), &numbers(&row)[1..]);
    }
    errors.within("errors of Theorem 2", 1e-14);
    let run = Observer::new(150).run(16, None);
    let mut filters = Column::default();
    for row in rows("motor_000_starts", "thm1_k150") {
        filters.add(&run[step_at(&row[0])][6..10], &numbers(&row)[1..]);
    }
    filters.within("psi_1 and psi_2 at k = 150", 1e-14);
}
