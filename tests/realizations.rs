//! Claim: every realisation of a window computes the same functional. On random plants, with samples that
//! fit no plant at all, its estimates are those of the plain sum to the rounding that the designs print, at
//! every call; missing samples, restarts and outliers leave nothing behind; statuses are the same.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

#[path = "support/plant.rs"]
mod plant;

use std::fmt::Write as _;

use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::program::{Scalar, Status};
use deadbeat_codegen::{Generated, Generator, Settings};
use nalgebra::DMatrix;
use plant::{Random, functional, matrix};

use Status::Converging;

/// A random linear plant as text, without its observer.
fn random_plant(random: &mut Random) -> String {
    let (n, p, m) = (1 + random.below(4), 1 + random.below(2), random.below(3));
    let discrete = random.below(2) == 0;
    let mut entry = |most: f64, zeros: usize| {
        let value = (random.within(-most, most) * 64.0).round() / 64.0;
        if random.below(10) < zeros { 0.0 } else { value }
    };
    // Discrete plants with radii up to 1, continuous ones that decay or grow by up to e in ten samples.
    let most = if discrete { 1.0 / (n as f64).sqrt() } else { 1.6 };
    let mut rows = |rows: usize, columns: usize, most: f64, zeros: usize| {
        let row = |_| format!("[{}]", (0..columns).map(|_| entry(most, zeros).to_string()).collect::<Vec<_>>().join(", "));
        (0..rows).map(row).collect::<Vec<_>>().join(", ")
    };
    let (a, b, c) = (rows(n, n, most, 2), rows(n, m, 1.0, 2), rows(p, n, 1.0, 1));
    let time = if discrete { "discrete" } else { "continuous" };
    let mut text = format!("deadbeat = 1\nname = 'random'\n[plant]\ntime = '{time}'\nA = [{a}]\nC = [{c}]\n");
    if m > 0 {
        let _ = writeln!(text, "B = [{b}]\n[inputs]");
    }
    for i in 0..m {
        let hold = if random.below(2) == 0 { "zero" } else { "first" };
        let _ = writeln!(text, "u{i} = {{ hold = '{hold}' }}");
    }
    text += "[outputs]\n";
    (0..p).for_each(|o| drop(writeln!(text, "y{o} = {{}}")));
    text
}

/// With its observer; `None` where a plant does not show its state or the realisation is refused.
fn realized(plant: &str, steps: usize, realization: &str) -> Option<Generated> {
    let observer = format!(
        "[observer.window]\nwindow = {}\nrealization = '{realization}'\n[target]\nsample_time = 0.0625\nscalar = 'f64'\n",
        steps as f64 * 0.0625
    );
    Generator::new(&format!("{plant}{observer}"), "test.toml").design().ok()
}

/// Samples and inputs that fit no plant, with gaps and outliers.
struct Feed {
    measurements: Vec<Vec<f64>>,
    inputs: Vec<Vec<f64>>,
}

impl Feed {
    fn new(generated: &Generated, calls: usize, random: &mut Random) -> Self {
        let (p, m) = (generated.plant.outputs.len(), generated.plant.inputs.len());
        let mut row = |width: usize| (0..width).map(|_| random.within(-1.0, 1.0)).collect::<Vec<f64>>();
        let measurements = (0..calls).map(|_| row(p)).collect();
        let inputs = (0..calls).map(|_| row(m)).collect();
        Self { measurements, inputs }
    }

    /// The largest magnitude over some calls.
    fn size(&self, calls: std::ops::RangeInclusive<usize>) -> f64 {
        let rows = self.measurements[calls.clone()].iter().chain(&self.inputs[calls]);
        rows.flatten().filter(|x| x.is_finite()).fold(0.0, |largest, x| largest.max(x.abs()))
    }

    fn through(&self, generated: &Generated) -> Vec<(Vec<f64>, Status)> {
        let mut interpreter = Interpreter::new(&generated.program);
        let step = |(y, u): (&Vec<f64>, &Vec<f64>)| {
            let mut estimate = vec![0.0; generated.plant.states.len()];
            let status = interpreter.step(y, u, &mut estimate);
            (estimate, status)
        };
        self.measurements.iter().zip(&self.inputs).map(step).collect()
    }
}

/// The round-off that the design prints, per state, for samples of magnitude 1.
fn round_off(generated: &Generated) -> Vec<f64> {
    let functional = functional(generated);
    functional.way.load().cloned().unwrap_or_else(|| functional.load(&generated.plant)).round_off
}

/// Plants, each with the sum and another realisation of the same window.
fn pairs(realization: &str, count: usize) -> Vec<(Generated, Generated, u64)> {
    let mut found = Vec::new();
    for seed in 0..4 * count as u64 {
        let mut random = Random::new(seed);
        let (plant, steps) = (random_plant(&mut random), 16 + random.below(40));
        if let (Some(sum), Some(other)) = (realized(&plant, steps, "fir"), realized(&plant, steps, realization)) {
            assert_eq!(other.design.realization, realization);
            found.push((sum, other, seed));
        }
        if found.len() == count {
            return found;
        }
    }
    panic!("only {} plants of {count} take the realisation {realization}", found.len());
}

/// Where an outlier, a restart and a gap are put, of a run of `calls` calls.
fn disturb(feed: &mut Feed, steps: usize) -> (usize, usize) {
    let (restart, outlier) = (steps / 2, 3 * steps + 5);
    feed.measurements[restart].fill(f64::NAN);
    feed.measurements[outlier][0] = 1e9;
    if let Some(first) = feed.inputs[outlier + 3].first_mut() {
        *first = -1e9;
    }
    (restart, outlier)
}

/// Without missing samples after convergence nothing is predicted: both compute the same functional of the
/// same samples, and differ by rounding of what is in the window now, whatever was in it before.
#[test]
fn blocks_are_the_sum() {
    let mut worst = 0.0_f64;
    for (sum, other, seed) in pairs("two-level", 80) {
        let steps = sum.design.window_steps;
        let mut feed = Feed::new(&sum, 8 * steps, &mut Random::new(seed + 1_000));
        let (restart, _) = disturb(&mut feed, steps);
        let (expected, found) = (feed.through(&sum), feed.through(&other));
        let bounds: Vec<f64> = round_off(&sum).iter().zip(round_off(&other)).map(|(a, b)| a + b).collect();
        for (call, ((x, status), (y, other_status))) in expected.iter().zip(&found).enumerate() {
            assert_eq!(status, other_status, "seed {seed}, call {call}");
            assert_eq!(*status == Converging, call <= restart + steps, "seed {seed}, call {call}");
            if *status == Converging {
                assert_eq!(x, y);
                continue;
            }
            let size = feed.size(call - steps..=call);
            for (i, (a, b)) in x.iter().zip(y).enumerate() {
                let share = (a - b).abs() / (bounds[i] * size);
                worst = worst.max(share);
                assert!(share <= 1.0, "seed {seed}, call {call}, state {i}: {a} {b}, {share} of the bound");
            }
        }
    }
    println!("at most {worst:.2} of the bound");
}

/// How much a rounding error of the plant's state grows over some calls.
fn growth(generated: &Generated, calls: usize) -> f64 {
    let phi = matrix(generated, "Phi");
    let phi = DMatrix::from_fn(phi.len(), phi.len(), |i, j| phi[i][j]);
    let mut power = DMatrix::identity(phi.nrows(), phi.nrows());
    let mut largest = 1.0_f64;
    for _ in 0..calls {
        power = &power * &phi;
        largest = largest.max(power.abs().max());
    }
    largest
}

/// A ping-pong estimate is the sum over the window that began with the copy in use: N+1 to 2N samples.
#[test]
fn copies_that_take_turns_are_the_sum_over_a_growing_window() {
    let mut worst = 0.0_f64;
    let mut plants = 0;
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let (plant, steps) = (random_plant(&mut random), 8 + random.below(6));
        let Some(pair) = realized(&plant, steps, "ping-pong") else { continue };
        let sums: Vec<Generated> = (steps..2 * steps).filter_map(|age| realized(&plant, age, "fir")).collect();
        if sums.len() < steps {
            continue;
        }
        plants += 1;
        let mut feed = Feed::new(&pair, 12 * steps, &mut Random::new(seed + 1_000));
        let (restart, _) = disturb(&mut feed, steps);
        let found = feed.through(&pair);
        let expected: Vec<_> = sums.iter().map(|sum| feed.through(sum)).collect();
        let bounds: Vec<Vec<f64>> = sums.iter().map(round_off).collect();
        for (call, (y, status)) in found.iter().enumerate() {
            if call <= restart + steps {
                assert_eq!(*status, Converging);
                continue;
            }
            assert_eq!(*status, Status::Converged, "seed {seed}, call {call}");
            let row = (call - restart - 1) % steps;
            let (x, of_sum) = &expected[row][call];
            assert_eq!(*of_sum, Status::Converged);
            let size = feed.size(call - steps - row..=call);
            for (i, own) in round_off(&pair).iter().enumerate() {
                let share = (x[i] - y[i]).abs() / ((own + bounds[row][i]) * size);
                worst = worst.max(share);
                assert!(share <= 1.0, "seed {seed}, call {call}, state {i}: {} {}, {share} of the bound", x[i], y[i]);
            }
        }
    }
    println!("{plants} plants, at most {worst:.2} of the bound");
    assert!(plants >= 60, "only {plants} plants take it");
}
