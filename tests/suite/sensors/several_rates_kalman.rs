//! Claim: `kalman` with outputs at several rates: on random plants the gains are those of the covariance recursion, and at
//! the promised call no more is left of an initial error than is printed; what is not due is not looked at and not
//! missing; the cycle counts on whatever is missing.

#![allow(clippy::cast_precision_loss, reason = "counts of calls and samples are small")]

use crate::support::depth::trials;
use crate::support::plant;

use std::fmt::Write as _;

use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Generated, Generator};
use nalgebra::{DMatrix, DVector};
use plant::{Random, corpus, designed, exponential, matrix};

const H: f64 = 0.125;

/// A random plant with two outputs, each due at every so many calls.
struct Rates {
    a: DMatrix<f64>,
    c: DMatrix<f64>,
    every: [usize; 2],
}

impl Rates {
    fn new(random: &mut Random) -> Self {
        let n = 2 + random.below(3);
        let mut entry = |most: f64| (random.within(-most, most) * 64.0).round() / 64.0;
        let a = DMatrix::from_fn(n, n, |_, _| entry(1.5));
        let c = DMatrix::from_fn(2, n, |_, _| entry(2.0));
        let every = [[1, 4], [3, 1], [2, 3], [5, 1], [4, 6], [2, 2]][random.below(6)];
        Self { a, c, every }
    }

    fn text(&self) -> String {
        let rows = |m: &DMatrix<f64>| -> String {
            let row = |r: usize| m.row(r).iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
            (0..m.nrows()).map(|r| format!("[{}]", row(r))).collect::<Vec<_>>().join(", ")
        };
        let mut text =
            format!("deadbeat = 1\nname = 'r'\n[plant]\nA = [{}]\nC = [{}]\n[outputs]\n", rows(&self.a), rows(&self.c));
        for (o, every) in self.every.iter().enumerate() {
            let _ = writeln!(text, "y{o} = {{ every = {every} }}");
        }
        let process = vec!["1e-3"; self.a.nrows()].join(", ");
        let _ = write!(
            text,
            "[observer.kalman]\nprocess_noise = [{process}]\nmeasurement_noise = [1e-2, 2e-2]\n[target]\n\
             sample_time = {H}\nscalar = 'f64'\n"
        );
        text
    }

    /// Gains of a cycle by the recursion, from 400 cycles on.
    fn gains(&self, calls: usize) -> Vec<DMatrix<f64>> {
        let n = self.a.nrows();
        let phi = exponential(&(&self.a * H));
        let mut p = DMatrix::identity(n, n);
        let mut gains = vec![DMatrix::zeros(n, 2); calls];
        for call in 0..400 * calls {
            let due: Vec<usize> = (0..2).filter(|o| call % self.every[*o] == 0).collect();
            let c = self.c.select_rows(&due);
            let r = DMatrix::from_fn(due.len(), due.len(), |i, j| if i == j { [1e-2, 2e-2][due[i]] } else { 0.0 });
            let mut whole = DMatrix::zeros(n, 2);
            if !due.is_empty() {
                let gain = &p * c.transpose() * (&c * &p * c.transpose() + r).try_inverse().unwrap();
                due.iter().enumerate().for_each(|(place, o)| whole.set_column(*o, &gain.column(place)));
                p = &p - &gain * &c * &p;
            }
            gains[call % calls] = whole;
            p = &phi * &p * phi.transpose() + DMatrix::identity(n, n) * 1e-3;
        }
        gains
    }
}

/// Random plants that have a filter, designed.
fn plants(count: usize) -> Vec<(Rates, Generated)> {
    let mut random = Random::new(23);
    let drawn = std::iter::repeat_with(|| Rates::new(&mut random)).take(2 * count);
    let designed = drawn.filter_map(|rates| {
        let text = rates.text();
        Generator::new(&text, "r.toml").design().ok().map(|generated| (rates, generated))
    });
    let found: Vec<_> = designed.take(count).collect();
    assert_eq!(found.len(), count, "most random plants have a filter");
    found
}

fn sizes() -> usize {
    trials(4, 200)
}

#[test]
fn gains_are_those_of_the_recursion() {
    for (rates, generated) in plants(sizes()) {
        let n = rates.a.nrows();
        let rows = matrix(&generated, "K");
        let expected = rates.gains(rows.len() / n);
        for (call, gain) in expected.iter().enumerate() {
            let size = gain.amax().max(1e-3);
            for i in 0..n {
                for o in 0..2 {
                    let (ours, theirs) = (rows[call * n + i][o], gain[(i, o)]);
                    // The recursion in doubles: covariances lose half of their digits where they differ much.
                    assert!((ours - theirs).abs() < 1e-7 * size, "{:?}, call {call}: {ours} and {theirs}", rates.every);
                    assert!(ours != 0.0 || call % rates.every[o] != 0, "{:?}, call {call}", rates.every);
                }
            }
        }
    }
}

/// Without noise: the error at the printed call is the printed matrix times the initial one. What is not due is garbage.
#[test]
fn what_is_left_of_an_initial_error_is_what_is_printed() {
    let mut random = Random::new(5);
    for (rates, generated) in plants(sizes()) {
        let (n, valid) = (rates.a.nrows(), generated.design.valid_from_step);
        let phi = exponential(&(&rates.a * H));
        let mut x = DVector::from_fn(n, |_, _| random.within(-1.0, 1.0));
        let mut interpreter = Interpreter::new(&generated.program);
        let (mut first, mut size) = (DVector::zeros(n), 0.0_f64);
        for call in 0..=valid {
            let y = &rates.c * &x;
            let shown = |o: usize| if call % rates.every[o] == 0 { y[o] } else { [f64::NAN, 1e6][(call + o) % 2] };
            let mut estimate = vec![0.0; n];
            let status = interpreter.step(&[shown(0), shown(1)], &[], &mut estimate);
            let expected = if call < valid { Status::Converging } else { Status::Converged };
            assert_eq!(status, expected, "{:?}, call {call} of {valid}", rates.every);
            let error = DVector::from_vec(estimate) - &x;
            size = size.max(x.amax());
            if call == 0 {
                first = error;
            } else if call == valid {
                let rows = &generated.design.certificate.initial_gain;
                for (i, row) in rows.iter().enumerate() {
                    let left: f64 = row.iter().zip(first.iter()).map(|(gain, error)| gain * error).sum();
                    // Each call rounds numbers of this size a few times; gains are below 10.
                    let rounding = 1e-14 * valid as f64 * size;
                    assert!((error[i] - left).abs() < rounding, "{:?}: {} and {left}", rates.every, error[i]);
                }
            }
            x = &phi * x;
        }
    }
}

/// Calls 0 … 9 of the car's position are lost: it starts with call 10, at which both are due, as if that were the first.
#[test]
fn the_cycle_counts_on_whatever_is_missing() {
    let generated = designed(&corpus("car_rates"));
    let (valid, recovery) = (generated.design.valid_from_step, recovery(&generated));
    let mut interpreter = Interpreter::new(&generated.program);
    let mut estimate = [0.0; 3];
    let from = 10 + valid;
    let lost = from + 7;
    for call in 0..from + recovery + 30 {
        let due = call % 5 == 0;
        let position = if due && call >= 10 { 0.4 * call as f64 } else { f64::NAN };
        let speed = if call == lost { f64::NAN } else { 20.0 };
        let status = interpreter.step(&[speed, position], &[0.0], &mut estimate);
        let expected = match call {
            _ if call < from => Status::Converging,
            _ if (lost..lost + recovery).contains(&call) => Status::Coasting,
            _ => Status::Converged,
        };
        assert_eq!(status, expected, "call {call}, from {from}, lost {lost}");
        if call >= from {
            assert!((estimate[0] - 0.4 * call as f64).abs() < 1e-4 && (estimate[1] - 20.0).abs() < 1e-4, "call {call}");
        }
    }
}

fn recovery(generated: &Generated) -> usize {
    generated
        .design
        .estimator
        .downcast_ref::<deadbeat_codegen::internals::estimator::corrector::Corrector>()
        .expect("a corrector")
        .recovery
}
