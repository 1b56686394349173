//! Claim: an observer that starts from a given state goes on from it as if a call had given it: vouched for, it is
//! converged from the first call on, and exact for linear plants; otherwise it converges at the promised call, whatever
//! was given; and no given number makes an estimate other than finite.

#![allow(clippy::cast_precision_loss, reason = "counts of calls are small")]

use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::promise::Convergence;
use deadbeat_codegen::{Generated, Generator};

/// An oscillator with an input that keeps its value, one that runs straight, a constant and a known motion.
const PLANT: &str = "\
deadbeat = 1
name = 'm'
[states]
q = { derivative = 'v', initial = 0.3 }
v = { derivative = '2*u + f + 0.5 - 4*q - 0.3*v' }
[inputs]
u = {}
f = { hold = 'first' }
[outputs]
q = { value = 'q' }
[target]
sample_time = 0.02
scalar = 'f64'
init_at = true
";

/// A chain of integrators for methods that take no plant: a parabola is a trajectory of it.
const CHAIN: &str = "\
deadbeat = 1
name = 'm'
[outputs]
y = {}
[target]
sample_time = 0.02
scalar = 'f64'
init_at = true
";

/// Every method, in every shape and way that a step can have.
const OBSERVERS: [&str; 22] = [
    "[observer.window]\nwindow = 0.4\nmissing = 'left-out'",
    "[observer.window]\nwindow = 0.4\nrealization = 'fir'",
    "[observer.window]\nwindow = 0.4\nrealization = 'two-level'",
    "[observer.window]\nwindow = 0.4\nrealization = 'ping-pong'",
    "[observer.window]\nwindow = 0.4\nhold = 'third'",
    "[observer.window]\nwindow = [0.2, 0.4]",
    "[observer.window]\nwindow = 0.4\nweights = 'minimax'",
    "[observer.single-delay]\nwindow = 0.4",
    "[observer.single-delay]\nwindow = 0.4\nk = 25\nrealization = 'recursive'",
    "[observer.single-delay]\nwindow = 0.4\nintermittent = { min = 0.02, max = 0.06 }",
    "[observer.impulsive]\nwindow = 0.4",
    "[observer.impulsive]\nwindow = 0.4\nhold = 'third'",
    "[observer.impulsive]\nwindow = 0.4\nmeasured_every = 2",
    "[observer.prescribed-time]\ntime = 0.4",
    "[observer.prescribed-time]\ntime = 0.4\nafter = 'restart'",
    "[observer.prescribed-time]\ntime = 0.4\nafter = 'handover'\nprocess_noise = [0, 1e-4]\nmeasurement_noise = [1e-4]",
    "[observer.prescribed-time]\ntime = 0.4\nkalman = { process_noise = [0, 1e-4], measurement_noise = [1e-4], \
     initial_deviation = 1 }",
    "[observer.luenberger]\npoles = [-9, -12]",
    "[observer.kalman]\nprocess_noise = [0, 1e-4]\nmeasurement_noise = [1e-4]",
    "[observer.high-gain]\ngain = 15\npoles = [-1, -1.2]",
    "[observer.fixed-time-linear]",
    "[observer.robust-exact]\nlipschitz = 5",
];

const CHAINS: [&str; 3] = [
    "[observer.differentiator]\norder = 3\ntime = 0.4",
    "[observer.fixed-time-linear]\norder = 3",
    "[observer.robust-exact]\norder = 3\nlipschitz = 5",
];

fn designed(text: &str) -> Generated {
    let generator = Generator::new(text, "m.toml");
    generator.design().unwrap_or_else(|report| panic!("{}\n{text}", report.render(false)))
}

/// The state and the inputs at a call; call 0 is the first.
struct Sample {
    state: Vec<f64>,
    /// Which was applied since the call before; which is applied now.
    inputs: Vec<f64>,
}

/// What the plant does from the call before the first on, by Runge and Kutta's method with steps so small that their
/// errors are below rounding.
fn oscillator(calls: usize) -> Trajectory {
    let start = vec![0.7, -1.1];
    let (mut state, mut samples) = (start.clone(), Vec::new());
    let (h, parts) = (0.02, 50);
    // It rests before the first call, so that it is what it will be then.
    let straight = |call: usize| if call < 2 { 0.0 } else { 0.8 * ((call - 1) as f64 * 0.3).sin() };
    for call in 0..calls {
        let u = if call / 7 % 2 == 0 { 0.9 } else { -0.4 };
        let (from, to) = (straight(call), straight(call + 1));
        for part in 0..parts {
            let rate = |state: &[f64], time: f64| {
                let f = from + (to - from) * time;
                vec![state[1], 2.0 * u + f + 0.5 - 4.0 * state[0] - 0.3 * state[1]]
            };
            let at = f64::from(part) / f64::from(parts);
            let step = 1.0 / f64::from(parts);
            let moved = |by: &[f64], share: f64| -> Vec<f64> {
                state.iter().zip(by).map(|(x, rate)| x + h * step * share * rate).collect()
            };
            let first = rate(&state, at);
            let second = rate(&moved(&first, 0.5), at + 0.5 * step);
            let third = rate(&moved(&second, 0.5), at + 0.5 * step);
            let fourth = rate(&moved(&third, 1.0), at + step);
            for i in 0..2 {
                state[i] += h * step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]);
            }
        }
        samples.push(Sample { state: state.clone(), inputs: vec![u, to] });
    }
    (start, samples)
}

/// A parabola and its derivatives.
fn parabola(calls: usize) -> Trajectory {
    let at = |time: f64| vec![0.4 - 1.5 * time + 2.0 * time * time, 4.0 * time - 1.5, 4.0];
    let sample = |call: usize| Sample { state: at(call as f64 * 0.02), inputs: vec![] };
    (at(-0.02), (0..calls).map(sample).collect())
}

/// Estimates and statuses from a given state on; `missing` says of which calls there is no sample.
fn run(
    generated: &Generated,
    (given, status): (&[f64], Status),
    samples: &[Sample],
    missing: impl Fn(usize) -> bool,
) -> Vec<(Vec<f64>, Status)> {
    let mut observer = Interpreter::new(&generated.program);
    let mut estimate = vec![0.0; generated.program.estimates.len()];
    estimate[..given.len()].copy_from_slice(given);
    observer.start_at(&estimate, status);
    let answer = |(call, sample): (usize, &Sample)| {
        let measured = if missing(call) { f64::NAN } else { sample.state[0] };
        let status = observer.step(&[measured], &sample.inputs, &mut estimate);
        (estimate.clone(), status)
    };
    samples.iter().enumerate().map(answer).collect()
}

/// The state at the call before the first, and everything from there on.
type Trajectory = (Vec<f64>, Vec<Sample>);

/// All observers with a trajectory of their plant.
fn all() -> Vec<(String, Generated, Trajectory)> {
    let plants = OBSERVERS.iter().map(|observer| (PLANT, *observer, oscillator(120)));
    let chains = CHAINS.iter().map(|observer| (CHAIN, *observer, parabola(120)));
    plants
        .chain(chains)
        .map(|(plant, observer, truth)| {
            (observer.to_owned(), designed(&plant.replace("[target]", &format!("{observer}\n[target]"))), truth)
        })
        .collect()
}

/// The largest distance of an estimate from the state.
fn error(estimate: &[f64], sample: &Sample) -> f64 {
    estimate.iter().zip(&sample.state).map(|(estimate, x)| (estimate - x).abs()).fold(0.0, f64::max)
}

/// Claim: vouched for, every call from the first on is converged and exact. Rounding is some 1e-16 of samples of size 1
/// times gains of at most 1e4 or so in these designs; what stays after a hundred calls is below 1e-9.
#[test]
fn a_vouched_start_is_exact_from_the_first_call_on() {
    for (observer, generated, (start, samples)) in all() {
        for (call, (estimate, status)) in
            run(&generated, (&start, Status::Converged), &samples, |_| false).iter().enumerate()
        {
            let off = error(estimate, &samples[call]);
            assert!(off < 1e-9, "{observer}, call {call}: {off:e}");
            assert_eq!(*status, Status::Converged, "{observer}, call {call}");
        }
    }
}

/// Claim: a given state that nobody vouches for, however wrong, is left behind at the promised call: until then the
/// status is converging, from then on it is converged; and the estimate is exact then where the method is exact.
#[test]
fn another_start_converges_at_the_promised_call() {
    for (observer, generated, (start, samples)) in all() {
        let design = &generated.design;
        let given: Vec<f64> = start.iter().map(|x| x + 0.4).collect();
        let answers = run(&generated, (&given, Status::Converging), &samples, |_| false);
        if matches!(design.convergence, Convergence::Sensed { .. }) {
            assert_eq!(answers[0].1, Status::Converging, "{observer}");
            assert_eq!(answers[samples.len() - 1].1, Status::Converged, "{observer}");
            continue;
        }
        let promised = design.valid_from_step;
        for (call, (estimate, status)) in answers.iter().enumerate() {
            let expected = if call < promised { Status::Converging } else { Status::Converged };
            assert_eq!(*status, expected, "{observer}, call {call} of {promised}");
            if call >= promised && design.convergence == Convergence::Finite {
                let off = error(estimate, &samples[call]);
                assert!(off < 1e-9, "{observer}, call {call}: {off:e}");
            }
        }
    }
}

/// Claim: until samples determine the estimate, it is the given state as the model carries it, and not the start.
#[test]
fn before_convergence_the_model_runs_from_the_given_state() {
    for (observer, generated, (start, samples)) in all() {
        let answers = run(&generated, (&start, Status::Converging), &samples, |_| false);
        for (call, (estimate, _)) in answers.iter().enumerate() {
            let off = error(estimate, &samples[call]);
            assert!(off < 1e-9, "{observer}, call {call}: {off:e}");
        }
    }
}

/// Claim: while samples are missing from the first call on, a vouched state is carried by the model, exactly where
/// inputs are known; and the first sample does not take its place.
#[test]
fn a_vouched_state_outlives_missing_samples() {
    for (observer, generated, (start, samples)) in all() {
        let answers = run(&generated, (&start, Status::Converged), &samples, |call| call < 10);
        for (call, (estimate, status)) in answers.iter().enumerate() {
            let off = error(estimate, &samples[call]);
            assert!(off < 1e-9, "{observer}, call {call}: {off:e}");
            // Between measurements at every second call nothing is missing.
            assert!(
                call > 9 || observer.contains("measured_every") || *status != Status::Converging,
                "{observer}, {call}"
            );
        }
    }
}

/// Claim: whatever the bits of a given state, estimates are finite, and nobody can vouch for numbers that are none.
#[test]
fn any_bits_can_be_given() {
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -f64::MAX, 1e300, f64::MIN_POSITIVE, -0.0];
    for (observer, generated, (start, samples)) in all() {
        for (first, second) in odd.iter().flat_map(|first| odd.iter().map(move |second| (*first, *second))) {
            let mut given = start.clone();
            (given[0], given[1]) = (first, second);
            let answers = run(&generated, (&given, Status::Converged), &samples[..60], |call| call % 9 == 4);
            assert!(answers.iter().all(|(estimate, _)| estimate.iter().all(|x| x.is_finite())), "{observer} {given:?}");
            if !(first.is_finite() && second.is_finite()) {
                assert_ne!(answers[0].1, Status::Converged, "{observer} {given:?}");
            }
        }
    }
}

/// Claim: what a step returned starts another observer where the first one is: the same estimates follow. A corrector
/// with constant gains carries nothing else, and they are the same to the bit.
#[test]
fn an_estimate_goes_on_where_it_was() {
    let text = PLANT
        .replace("[target]", "[observer.luenberger]\npoles = [-9, -12]\n[target]")
        .replace("f = { hold = 'first' }", "f = {}");
    let generated = designed(&text);
    let (_, samples) = oscillator(200);
    let (mut first, mut second) = (Interpreter::new(&generated.program), Interpreter::new(&generated.program));
    let (mut estimate, mut other) = (vec![0.0; 2], vec![0.0; 2]);
    let mut status = Status::Converging;
    for (call, sample) in samples.iter().enumerate() {
        if call == 100 {
            second.start_at(&estimate, status);
        }
        status = first.step(&sample.state[..1], &sample.inputs, &mut estimate);
        if call >= 100 {
            assert_eq!(second.step(&sample.state[..1], &sample.inputs, &mut other), status);
            assert_eq!(
                estimate.iter().map(|x| x.to_bits()).collect::<Vec<_>>(),
                other.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
            );
        }
    }
}

/// Claim: unknown constants are given with the state, in factors that stay and in factors that vary; what the model
/// does of both is exact for a trajectory on which the factor is linear in time.
#[test]
fn unknowns_are_given_too() {
    for (factor, unknown) in [("load", 0.6), ("load*t", 0.6)] {
        let text = format!(
            "deadbeat = 1\nname = 'm'\n[states]\nq = {{ derivative = 'v' }}\nv = {{ derivative = 'u + {factor}' }}\n\
             [inputs]\nu = {{}}\n[outputs]\nq = {{ value = 'q' }}\n[unknowns]\nload = {{}}\n\
             [observer.parameters]\nwindow = 0.4\n[target]\nsample_time = 0.02\nscalar = 'f64'\ninit_at = true\n"
        );
        let generated = designed(&text);
        // v' = 0.3 + load or 0.3 + load t, with t from the first call on.
        let at = |time: f64| {
            let (v, q) = match factor {
                "load" => (unknown * time, unknown * time * time / 2.0),
                _ => (unknown * time * time / 2.0, unknown * time * time * time / 6.0),
            };
            vec![1.0 + 0.2 * time + 0.15 * time * time + q, 0.2 + 0.3 * time + v, unknown]
        };
        let samples: Vec<Sample> =
            (0..80).map(|call| Sample { state: at(f64::from(call) * 0.02), inputs: vec![0.3] }).collect();
        for (call, (estimate, status)) in
            run(&generated, (&at(-0.02), Status::Converged), &samples, |_| false).iter().enumerate()
        {
            let off = error(estimate, &samples[call]);
            assert!(off < 1e-8, "{factor}, call {call}: {off:e}");
            assert_eq!(*status, Status::Converged, "{factor}, call {call}");
        }
    }
}
