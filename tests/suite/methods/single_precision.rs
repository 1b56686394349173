//! Claim: in single precision an estimate that moves by less than its float's last bit a call is carried on all the same,
//! and what rounding adds to an estimate is at most what the design prints of it, which is some hundred times the worst
//! that is found.
//!
//! The same samples, floats, go through the step in single and in double precision: what differs is rounding alone.
//! Right values of slow states are those of their equations: `soc = 0.6 - i t/9000`, `p = 10 + 0.6 t`, and so on.

#![expect(clippy::cast_precision_loss, reason = "a run has a million calls")]

use crate::support::depth::trials;
use crate::support::{compile, plant};

use compile::{Case, Sample, Workshop};
use deadbeat_codegen::Generated;
use deadbeat_codegen::diagnostic::codes;
use deadbeat_codegen::program::Scalar;
use deadbeat_codegen::program::interp::Interpreter;
use nalgebra::{DMatrix, DVector};
use plant::{Random, designed_in, exponential};

/// A plant whose state moves slowly, the samples and inputs of a call from the time, and what is right then.
struct Slow {
    text: &'static str,
    h: f64,
    at: fn(f64) -> [f64; 2],
    /// Of which state.
    state: usize,
    right: fn(f64) -> f64,
    /// By how much the estimate may be off after a million calls.
    most: f64,
}

/// A battery's charge at 0.02 A (2.2e-8 a call, half a float's last bit at 0.6 being 3e-8), a tank that leaks with a
/// time constant of three hours, a clock that is 20 ppm fast, a position at 20 that moves by 6e-5 a call.
const SLOW: [Slow; 4] = [
    Slow {
        text: "deadbeat = 1\nname = 'soc'\n[states]\nsoc = { derivative = '-i/9000' }\n[inputs]\ni = { unit = 'A' }\n\
               [outputs]\nv = { unit = 'V', value = '3.2 + 0.9*soc - 0.02*i', noise = 0.005 }\n[observer.kalman]\n\
               process_noise = [3e-15]\nmeasurement_noise = [25e-6]\n[target]\nsample_time = 0.01\nscalar = 'f32'\n",
        h: 0.01,
        at: |t| [3.2 + 0.9 * (0.6 - 0.02 * t / 9000.0) - 0.02 * 0.02, 0.02],
        state: 0,
        right: |t| 0.6 - 0.02 * t / 9000.0,
        most: 1e-6,
    },
    Slow {
        text: "deadbeat = 1\nname = 'tank'\n[states]\nl = { derivative = 'q - l/10000' }\n[inputs]\nq = {}\n[outputs]\n\
               y = { value = 'l', noise = 0.01, range = [0, 4] }\n[observer.kalman]\nprocess_noise = [1e-15]\n\
               measurement_noise = [1e-4]\n[target]\nsample_time = 0.01\nscalar = 'f32'\n",
        h: 0.01,
        at: |t| [3.0 - 2.0 * (-t / 10000.0).exp(), 3e-4],
        state: 0,
        right: |t| 3.0 - 2.0 * (-t / 10000.0).exp(),
        most: 2e-6,
    },
    Slow {
        text: "deadbeat = 1\nname = 'clock'\n[states]\noffset = { derivative = 'drift' }\ndrift = { derivative = '0' }\n\
               [outputs]\noffset = { value = 'offset', noise = 1e-3, range = [-2, 2] }\n[observer.luenberger]\n\
               poles = [-0.02, -0.03]\n[target]\nsample_time = 0.01\nscalar = 'f32'\n",
        h: 0.01,
        at: |t| [1.0 + 2e-5 * t, 0.0],
        state: 1,
        right: |_| 2e-5,
        most: 2e-8,
    },
    Slow {
        text: "deadbeat = 1\nname = 'position'\n[states]\np = { derivative = 'v' }\nv = { derivative = '0' }\n[outputs]\n\
               p = { value = 'p', noise = 1e-4, range = [-700, 700] }\n[observer.luenberger]\npoles = [-2, -3]\n[target]\n\
               sample_time = 1e-4\nscalar = 'f32'\n",
        h: 1e-4,
        at: |t| [10.0 + 0.6 * t, 0.0],
        state: 1,
        right: |_| 0.6,
        most: 6e-5,
    },
];

/// The nearest float.
#[expect(clippy::cast_possible_truncation, reason = "the rounding is what is meant")]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// What a call gets, as floats.
fn sample(slow: &Slow, inputs: usize, call: usize) -> Sample {
    let [y, u] = (slow.at)(call as f64 * slow.h);
    Sample { measurements: vec![single(y)], inputs: vec![single(u); inputs] }
}

/// A million calls, and the estimate is right to what is said above.
#[test]
fn what_moves_by_less_than_a_float_shows_is_carried_on() {
    for slow in &SLOW {
        let generated = designed_in(slow.text, Scalar::F32);
        let inputs = generated.program.inputs.len();
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = vec![0.0; generated.program.estimates.len()];
        let (calls, settled) = (1_000_000, generated.design.valid_from_step.min(900_000));
        let mut worst = 0.0_f64;
        for call in 0..calls {
            let Sample { measurements, inputs } = sample(slow, inputs, call);
            interpreter.step(&measurements, &inputs, &mut estimate);
            if call > settled && (call % 1000 == 0 || call + 1 == calls) {
                worst = worst.max((estimate[slow.state] - (slow.right)(call as f64 * slow.h)).abs());
            }
        }
        let certificate = &generated.design.certificate;
        let printed = certificate.error_bound[slow.state].unwrap() + certificate.rounding[slow.state];
        println!("{} off by {worst:.3e} of {printed:.3e}", generated.plant.name);
        assert!(worst <= slow.most.min(printed), "{}: off by {worst:e}", generated.plant.name);
    }
}

/// The second float survives every compiler: the same bits as the interpreter, at every level of optimisation.
#[test]
fn two_floats_are_equal_in_every_language() {
    let calls = trials(3_000, 100_000);
    let case = |slow: &Slow| {
        let generated = designed_in(slow.text, Scalar::F32);
        let low = generated.program.cells.iter().filter(|cell| cell.name.starts_with("low_")).count();
        assert!(low > 0, "{} needs a second float", generated.plant.name);
        let inputs = generated.program.inputs.len();
        Case { samples: (0..calls).map(|call| sample(slow, inputs, call)).collect(), program: generated.program }
    };
    let cases: Vec<Case> = SLOW.iter().map(case).collect();
    let expected: Vec<_> = cases.iter().map(Case::interpreted).collect();
    for (build, answers) in Workshop::new("single_precision").answers(&cases) {
        assert!(answers == expected, "{build}");
    }
}

/// Fast observers stay as they are: their rounding dies out with everything else.
#[test]
fn what_is_forgotten_soon_needs_no_second_float() {
    let text = SLOW[3].text.replace("[-2, -3]", "[-900, -1200]");
    let generated = designed_in(&text, Scalar::F32);
    assert!(generated.program.cells.iter().all(|cell| !cell.name.starts_with("low_")));
}

/// Observers of a position and a velocity by their tables, `{k}` being a speed, 1/s; and by how much what is printed may be
/// larger than what is found. The bounds of realisations that stand in for a sum are of their largest numbers throughout.
const METHODS: [(&str, &str, f64); 10] = [
    ("luenberger", "[observer.luenberger]\npoles = ['-1*{k}', '-1.5*{k}']", 150.0),
    ("kalman", "[observer.kalman]\nprocess_noise = [0, '1e-9*{k}']\nmeasurement_noise = [1e-6]", 200.0),
    ("high-gain", "[observer.high-gain]\ngain = '{k}'\npoles = [-1, -1.2]", 150.0),
    ("hold", "[observer.prescribed-time]\ntime = 0.5", 100.0),
    ("restart", "[observer.prescribed-time]\ntime = 0.5\nafter = 'restart'", 150.0),
    ("fixed-time", "[observer.fixed-time-linear]", 100.0),
    ("fir", "[observer.window]\nwindow = 0.3\nrealization = 'fir'", 150.0),
    ("two-level", "[observer.window]\nwindow = 0.3\nrealization = 'two-level'", 250.0),
    ("ping-pong", "[observer.window]\nwindow = 0.3\nrealization = 'ping-pong'", 250.0),
    ("recursive", "[observer.single-delay]\nk = 3\nwindow = 0.3\nrealization = 'recursive'", 1000.0),
];

/// Half of the last bit of a sample at the end of its range, so many times: what no bound need be closer to.
const FEW: f64 = 64.0 * 5.96e-8;

/// Plants: two integrators, an oscillator, one that dies out.
const PLANTS: [&str; 3] = ["10*u", "10*u - 9*p", "10*u - 4*p - 1.5*v"];

fn observed(plant: &str, observer: &str, speed: f64) -> String {
    format!(
        "deadbeat = 1\nname = 'rounded'\n[states]\np = {{ derivative = 'v' }}\nv = {{ derivative = '{plant}' }}\n[inputs]\nu = \
         {{}}\n[outputs]\np = {{ value = 'p', noise = 1e-3, range = [-1, 1] }}\n{}\n[target]\nsample_time = 0.002\nscalar \
         = 'f32'\n",
        observer
            .replace("'-1*{k}'", &format!("{}", -speed))
            .replace("'-1.5*{k}'", &format!("{}", -1.5 * speed))
            .replace("'1e-9*{k}'", &format!("{}", 1e-9 * speed))
            .replace("'{k}'", &format!("{speed}"))
    )
}

/// What drives the plant and what its sensor adds.
struct Sequence {
    kind: u64,
    random: Random,
    /// Per call, as a share of a turn.
    rate: f64,
    level: f64,
}

impl Sequence {
    fn new(kind: u64) -> Self {
        let mut random = Random::new(kind);
        let (rate, level) = (10.0_f64.powf(random.within(-4.0, -1.0)), random.within(0.2, 0.6));
        Self { kind, random, rate, level }
    }

    /// Where the position is to go: it stands still, turns back and forth, jumps, wanders.
    fn target(&mut self, call: usize) -> f64 {
        let turned = (self.rate * call as f64).sin();
        self.level
            * match self.kind % 4 {
                0 => 1.0,
                1 => turned,
                2 => turned.signum(),
                _ => self.random.within(-1.0, 1.0),
            }
    }

    /// Within 1e-3: none, at random, at its bound.
    fn noise(&mut self) -> f64 {
        let random = self.random.within(-1.0, 1.0);
        1e-3 * match self.kind / 4 % 3 {
            0 => 0.0,
            1 => random,
            _ => random.signum(),
        }
    }
}

/// Per state, the largest difference between the step in singles and the same step in doubles, once converged. The
/// plant moves exactly, its inputs are within 1 and its samples within their range.
fn rounded(plant: &str, single: &Generated, double: &Generated, kind: u64, calls: usize) -> Vec<f64> {
    let spring = if plant.contains("9*") {
        9.0
    } else if plant.contains("4*") {
        4.0
    } else {
        0.0
    };
    let damper = if plant.contains('v') { 1.5 } else { 0.0 };
    let motion = DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, -spring, -damper, 10.0, 0.0, 0.0, 0.0]) * 0.002;
    let motion = exponential(&motion);
    let valid = single.design.valid_from_step;
    let (mut ours, mut exact) = (Interpreter::new(&single.program), Interpreter::new(&double.program));
    let (mut a, mut b) = (vec![0.0; single.program.estimates.len()], vec![0.0; double.program.estimates.len()]);
    let mut sequence = Sequence::new(kind);
    let mut x = DVector::from_vec(vec![sequence.level, 0.0, 0.0]);
    let mut worst = vec![0.0_f64; 2];
    for call in 0..calls {
        let sample = [self::single(x[0] + sequence.noise())];
        assert!(sample[0].abs() <= 1.0, "out of range");
        let inputs = vec![x[2]; single.program.inputs.len()];
        ours.step(&sample, &inputs, &mut a);
        exact.step(&sample, &inputs, &mut b);
        if call >= valid {
            worst.iter_mut().zip(a.iter().zip(&b)).for_each(|(worst, (a, b))| *worst = worst.max((a - b).abs()));
        }
        let target = sequence.target(call);
        let wanted = spring * x[0] + damper * x[1] + 36.0 * (target - x[0]) - 12.0 * x[1];
        x[2] = self::single((0.1 * wanted).clamp(-1.0, 1.0));
        x = &motion * x;
    }
    worst
}

/// Whether an observer is slower than its plant, which its gains then slow down; its bound is looser.
fn slows_down(plant: &str, name: &str, speed: f64) -> bool {
    speed < 1.0 && name != "kalman" && plant.contains('v')
}

/// No sequence makes rounding larger than printed, and what is printed is near to the worst that is found.
#[test]
fn rounding_is_what_is_printed() {
    for plant in PLANTS {
        for (name, observer, loose) in METHODS {
            for speed in [30.0, 3.0, 0.3].into_iter().take(if observer.contains("{k}") { 3 } else { 1 }) {
                let text = observed(plant, observer, speed);
                let (single, double) = (designed_in(&text, Scalar::F32), designed_in(&text, Scalar::F64));
                let printed = single.design.certificate.rounding.clone();
                assert_eq!(printed.len(), 2, "{name} on {plant} at {speed}");
                let calls = single.design.valid_from_step + trials(4_000, 100_000);
                let mut worst = vec![0.0_f64; 2];
                for kind in 0..trials(8, 24) {
                    let found = rounded(plant, &single, &double, kind, calls);
                    worst.iter_mut().zip(found).for_each(|(worst, found)| *worst = worst.max(found));
                }
                for (worst, printed) in worst.into_iter().zip(printed) {
                    println!("{name} on {plant} at {speed}: {worst:.2e} of {printed:.2e}");
                    assert!(worst <= printed, "{name} on {plant} at {speed}: {worst:e} of {printed:e}");
                    let near = printed <= FEW || printed <= loose * worst || slows_down(plant, name, speed);
                    assert!(near, "{name} on {plant} at {speed}: {worst:e} of {printed:e}");
                }
            }
        }
    }
}

/// Where rounding is larger than what noise does, a warning says so, with its number and the way out; not in doubles.
#[test]
fn rounding_beyond_the_noise_is_warned_of() {
    let text = SLOW[3].text.replace("noise = 1e-4", "noise = 1e-7");
    let single = designed_in(&text, Scalar::F32);
    let warned: Vec<_> = single.design.warnings.iter().filter(|it| it.code == codes::ROUNDING).collect();
    let numbers: Vec<f64> = warned.iter().filter_map(|warning| warning.measured).collect();
    assert_eq!(numbers, single.design.certificate.rounding);
    for (warning, state) in warned.iter().zip(["`p`", "`v`"]) {
        assert!(warning.message.contains(state) && warning.help.as_ref().unwrap().contains("f64"), "{warning:?}");
    }
    let double = designed_in(&text, Scalar::F64);
    assert!(double.design.certificate.rounding.is_empty());
    assert!(double.design.warnings.iter().all(|warning| warning.code != codes::ROUNDING));
}
