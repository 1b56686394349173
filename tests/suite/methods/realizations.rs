//! Claim: every realisation of a window computes the same functional. On random plants, with samples that
//! fit no plant at all, its estimates are those of the plain sum to the rounding that the designs print, at
//! every call; missing samples, restarts and outliers leave nothing behind; statuses are the same.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "counts of calls and samples are small"
)]

use crate::support::{plant, truths};

use std::fmt::Write as _;

use deadbeat_codegen::diagnostic::{Diagnostic, codes};
use deadbeat_codegen::internals::estimator::window::Way;
use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Generated, Generator};
use nalgebra::DMatrix;
use plant::{Random, Run, corpus, designed, edited, functional, integration_rounding, matrix, rounding};
use truths::{inverted_cart, truth};

use Status::{Coasting, Converged, Converging};

/// What plants are drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Continuous or discrete, decaying and growing.
    Any,
    /// Continuous, every mode growing: their least-squares filter decays.
    Growing,
    /// Continuous, every mode decaying.
    Decaying,
}

/// A random linear plant as text, without its observer.
fn random_plant(random: &mut Random, kind: Kind) -> String {
    let (n, p, m) = (1 + random.below(4), 1 + random.below(2), random.below(3));
    let discrete = kind == Kind::Any && random.below(2) == 0;
    let shift = match kind {
        Kind::Any => 0.0,
        Kind::Growing => 1.0,
        Kind::Decaying => -2.0,
    };
    let mut entry = |most: f64, zeros: usize| {
        let value = (random.within(-most, most) * 64.0).round() / 64.0;
        if random.below(10) < zeros { 0.0 } else { value }
    };
    // Discrete plants with radii up to 1, continuous ones that decay or grow by up to e in ten samples.
    let most = if discrete { 1.0 / (n as f64).sqrt() } else { 1.6 };
    let mut rows = |rows: usize, columns: usize, most: f64, zeros: usize| {
        let row =
            |_| format!("[{}]", (0..columns).map(|_| entry(most, zeros).to_string()).collect::<Vec<_>>().join(", "));
        (0..rows).map(row).collect::<Vec<_>>().join(", ")
    };
    let (b, c) = (rows(n, m, 1.0, 2), rows(p, n, 1.0, 1));
    let a = (0..n).map(|i| {
        let row = (0..n)
            .map(|j| entry(most, 2) * if kind == Kind::Any { 1.0 } else { 0.25 } + if i == j { shift } else { 0.0 });
        format!("[{}]", row.map(|x| x.to_string()).collect::<Vec<_>>().join(", "))
    });
    let a = a.collect::<Vec<_>>().join(", ");
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
    for o in 0..p {
        let _ = writeln!(text, "y{o} = {{}}");
    }
    text
}

/// With an observer; `None` where a plant does not show its state or the realisation is refused.
fn realized(plant: &str, method: &str, steps: usize, realization: &str) -> Option<Generated> {
    let window = steps as f64 * 0.0625;
    let k = if method == "single-delay" { "k = 3\n" } else { "" };
    let observer = format!("[observer.{method}]\nwindow = {window}\n{k}realization = '{realization}'\n");
    let observer = format!("{observer}[target]\nsample_time = 0.0625\nscalar = 'f64'\n");
    Generator::new(&format!("{plant}{observer}"), "test.toml").design().ok()
}

/// Samples and inputs that fit no plant.
struct Feed {
    measurements: Vec<Vec<f64>>,
    inputs: Vec<Vec<f64>>,
}

impl Feed {
    fn new(generated: &Generated, calls: usize, random: &mut Random) -> Self {
        let (p, m) = (generated.plant.outputs.len(), generated.plant.inputs.len());
        let mut rows = |width: usize| -> Vec<Vec<f64>> {
            (0..calls).map(|_| (0..width).map(|_| random.within(-1.0, 1.0)).collect()).collect()
        };
        Self { measurements: rows(p), inputs: rows(m) }
    }

    /// A restart before convergence, and afterwards an outlier of an output and one of an input.
    fn disturb(&mut self, steps: usize) -> usize {
        let (restart, outlier) = (steps / 2, 3 * steps + 5);
        self.measurements[restart].fill(f64::NAN);
        self.measurements[outlier][0] = 1e9;
        if let Some(first) = self.inputs[outlier + 3].first_mut() {
            *first = -1e9;
        }
        restart
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

/// The round-off that the design promises, per state, for samples of magnitude 1.
fn round_off(generated: &Generated) -> Vec<f64> {
    let functional = functional(generated);
    functional.way.load().cloned().unwrap_or_else(|| functional.load(&generated.plant)).round_off
}

/// Plants with the sum and another realisation of the same window.
fn pairs(kind: Kind, method: &str, realization: &str, count: usize) -> Vec<(Generated, Generated, u64)> {
    let mut found = Vec::new();
    for seed in 0..6 * count as u64 {
        let mut random = Random::new(seed);
        let (plant, steps) = (random_plant(&mut random, kind), 16 + random.below(40));
        let both = realized(&plant, method, steps, "fir").zip(realized(&plant, method, steps, realization));
        if let Some((sum, other)) = both {
            assert_eq!(other.design.realization, realization);
            found.push((sum, other, seed));
        }
        if found.len() == count {
            return found;
        }
    }
    panic!("only {} plants of {count} take the realisation {realization}", found.len());
}

/// The largest share of the bound that one difference has; no difference has none, whatever the bound.
fn share(a: f64, b: f64, bound: f64) -> f64 {
    if a.to_bits() == b.to_bits() || a == b { 0.0 } else { (a - b).abs() / bound }
}

/// Both compute the same functional of the same samples, and differ by the rounding of what a realisation holds:
/// samples of `memory` windows.
fn same_functional((sum, other, seed): &(Generated, Generated, u64), memory: usize, outliers: bool) -> f64 {
    let steps = sum.design.window_steps;
    let mut feed = Feed::new(sum, 8 * steps, &mut Random::new(seed + 1_000));
    let restart = if outliers { feed.disturb(steps) } else { steps / 2 };
    feed.measurements[restart].fill(f64::NAN);
    let (expected, found) = (feed.through(sum), feed.through(other));
    let bounds: Vec<f64> = round_off(sum).iter().zip(round_off(other)).map(|(a, b)| a + b).collect();
    let mut worst = 0.0_f64;
    for (call, ((x, status), (y, other_status))) in expected.iter().zip(&found).enumerate() {
        assert_eq!(status, other_status, "seed {seed}, call {call}");
        assert_eq!(*status == Converging, call <= restart + steps, "seed {seed}, call {call}");
        if *status == Converging {
            assert_eq!(x, y);
            continue;
        }
        let size = feed.size(call.saturating_sub(memory * steps)..=call);
        for (i, (a, b)) in x.iter().zip(y).enumerate() {
            let share = share(*a, *b, bounds[i] * size);
            worst = worst.max(share);
            assert!(share <= 1.0, "seed {seed}, call {call}, state {i}: {a} {b}, {share} of the bound");
        }
    }
    worst
}

/// Blocks hold what the sum holds, the window: an outlier is gone with it.
#[test]
fn blocks_are_the_sum() {
    let of_window = pairs(Kind::Any, "window", "two-level", 60);
    let of_single_delay = pairs(Kind::Any, "single-delay", "two-level", 20);
    let worst = of_window.iter().chain(&of_single_delay).map(|pair| same_functional(pair, 1, true)).fold(0.0, f64::max);
    println!("at most {worst:.2} of the bound");
}

/// Where the filter decays and the copy does not, two copies take turns: an outlier is gone after two windows.
#[test]
fn a_filter_with_two_copies_is_the_sum() {
    let all = pairs(Kind::Growing, "window", "recursive", 30);
    assert!(all.iter().all(|(_, other, _)| matches!(&functional(other).way, Way::Recursive(filter) if filter.turns)));
    let worst = all.iter().map(|pair| same_functional(pair, 2, true)).fold(0.0, f64::max);
    println!("at most {worst:.2} of the bound");
}

/// Where both decay one copy goes on for ever.
#[test]
fn a_filter_with_one_copy_is_the_sum() {
    let all: Vec<_> = pairs(Kind::Decaying, "single-delay", "recursive", 30)
        .into_iter()
        .filter(|(_, other, _)| matches!(&functional(other).way, Way::Recursive(filter) if !filter.turns))
        .collect();
    assert!(all.len() >= 20, "only {} with one copy", all.len());
    // Its memory has no end, and no outlier is in it.
    let worst = all.iter().map(|pair| same_functional(pair, 8, false)).fold(0.0, f64::max);
    println!("at most {worst:.2} of the bound");
}

/// What rounding leaves of an outlier in a filter with one copy falls by the radius that the design prints.
#[test]
fn an_outlier_s_rounding_dies_out_in_a_filter_with_one_copy() {
    let text = edited(&corpus("motor_single_delay"), "k = \"auto\"", "k = 100\nrealization = \"recursive\"");
    let text = edited(&text, " - a1*sin(q)", "");
    let generated = designed(&text);
    let Way::Recursive(filter) = &functional(&generated).way else { panic!("recursive") };
    let steps = generated.design.window_steps;
    let mut feed = Feed::new(&generated, 100 * steps, &mut Random::new(1));
    feed.measurements.iter_mut().chain(&mut feed.inputs).flatten().for_each(|x| *x = 0.0);
    feed.measurements[2 * steps][0] = 1e9;
    let answers = feed.through(&generated);
    let bounds = round_off(&generated);
    for (call, (x, _)) in answers.iter().enumerate().skip(3 * steps + 2) {
        let left = 1e9 * filter.radius.powi((call - 3 * steps) as i32);
        for (i, x) in x.iter().enumerate() {
            // The bound is for rounding at every call; this is of the calls that had the outlier.
            assert!(x.abs() <= bounds[i] * left, "call {call}, state {i}: {x}, {}", bounds[i] * left);
        }
    }
    assert!(answers.last().is_some_and(|(x, status)| *status == Converged && x.iter().all(|x| x.abs() < 1e-3)));
}

/// A ping-pong estimate is the sum over the window that began with the copy in use: N+1 to 2N samples.
#[test]
fn copies_that_take_turns_are_the_sum_over_a_growing_window() {
    let (mut worst, mut plants) = (0.0_f64, 0);
    for seed in 0..160 {
        if plants == 60 {
            break;
        }
        let mut random = Random::new(seed);
        // Windows of every length have the same functional only with the same k.
        let method = if seed % 4 == 0 { "single-delay" } else { "window" };
        let (plant, steps) = (random_plant(&mut random, Kind::Any), 8 + random.below(6));
        let plant = plant.as_str();
        let of = |age: usize, realization: &str| realized(plant, method, age, realization);
        let Some(pair) = of(steps, "ping-pong") else { continue };
        let sums: Vec<Generated> = (steps..2 * steps).filter_map(|age| of(age, "fir")).collect();
        if sums.len() < steps {
            continue;
        }
        plants += 1;
        let mut feed = Feed::new(&pair, 12 * steps, &mut Random::new(seed + 1_000));
        let restart = feed.disturb(steps);
        let found = feed.through(&pair);
        let expected: Vec<_> = sums.iter().map(|sum| feed.through(sum)).collect();
        let bounds: Vec<Vec<f64>> = sums.iter().map(round_off).collect();
        for (call, (y, status)) in found.iter().enumerate() {
            if call <= restart + steps {
                assert_eq!(*status, Converging);
                continue;
            }
            assert_eq!(*status, Converged, "seed {seed}, call {call}");
            let row = (call - restart - 1) % steps;
            let (x, of_sum) = &expected[row][call];
            assert_eq!(*of_sum, Converged);
            let size = feed.size(call - steps - row..=call);
            for (i, own) in round_off(&pair).iter().enumerate() {
                let share = share(x[i], y[i], (own + bounds[row][i]) * size);
                worst = worst.max(share);
                assert!(share <= 1.0, "seed {seed}, call {call}, state {i}: {} {}, {share} of the bound", x[i], y[i]);
            }
        }
    }
    println!("{plants} plants, at most {worst:.2} of the bound");
    assert!(plants == 60, "only {plants} plants take it");
}

/// A corpus plant that is linear, under a realisation.
fn linear(name: &str, realization: &str) -> (Generated, plant::Truth) {
    let (text, truth) = match name {
        "inverted_cart" => (edited(&corpus(name), " + 0.3*sin(2*pi*1.5*t)", ""), inverted_cart(0.0)),
        _ => (corpus(name), truth(name).unwrap()),
    };
    let text = text.replace("realization = \"ping-pong\"\n", "");
    let line = text.lines().find(|line| line.starts_with("window = ")).unwrap().to_owned();
    (designed(&text.replace(&line, &format!("{line}\nrealization = '{realization}'"))), truth)
}

/// The largest entry that the powers of Phi reach over some calls: how much a rounding error grows.
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

/// Missing samples are predicted as by the sum: bursts and windows of nothing leave the estimate at the state.
#[test]
fn predictions_are_exact_for_linear_plants() {
    type Pattern = (&'static str, fn(usize, usize, usize) -> bool);
    let patterns: [Pattern; 4] = [
        ("a burst", |k, _, n| (n + 9..n + 16).contains(&k)),
        ("every fifth call", |k, _, n| k > n + 8 && k % 5 == 0),
        ("the first output for half a window", |k, o, n| o == 0 && (n + 8..n + 8 + n / 2).contains(&k)),
        ("three windows of nothing", |k, _, n| (n + 8..4 * n + 8).contains(&k)),
    ];
    for name in ["inverted_cart", "thermal_stack", "mass_chain", "small_memory"] {
        for realization in ["two-level", "ping-pong"] {
            let (generated, truth) = linear(name, realization);
            let n = generated.design.valid_from_step;
            let run = truth.run(generated.plant.sample_time_s(), 1, 7 * n, 5);
            for (what, missing) in &patterns {
                let mut fed = run.clone();
                let mut predictions = 0;
                for (k, sample) in fed.measurements.iter_mut().enumerate() {
                    let gone: Vec<bool> = (0..sample.len()).map(|o| missing(k, o, n)).collect();
                    predictions += usize::from(gone.contains(&true));
                    sample.iter_mut().zip(gone).filter(|(_, gone)| *gone).for_each(|(y, _)| *y = f64::NAN);
                }
                let answers = fed.through(&generated);
                let factor = (1 + predictions) as f64 * growth(&generated, predictions);
                let bounds: Vec<f64> = all_rounding(&generated, &truth, &run).iter().map(|b| b * factor).collect();
                let errors = answers.errors(&run, (n..7 * n).filter(|k| answers.statuses[*k] != Converging));
                assert!(
                    errors.iter().zip(&bounds).all(|(e, b)| e <= b),
                    "{name}, {realization}, {what}: {errors:?}, bounds {bounds:?}"
                );
                assert_eq!(
                    *answers.statuses.last().unwrap(),
                    if *what == "every fifth call" { Coasting } else { Converged }
                );
            }
        }
    }
}

/// Rounding of the simulation and of the step.
fn all_rounding(generated: &Generated, truth: &plant::Truth, run: &Run) -> Vec<f64> {
    let step = if truth.discrete {
        run.sizes(0).iter().map(|x| 4.0 * x).collect()
    } else {
        integration_rounding(generated, run)
    };
    let rows = run.measurements.iter().chain(&run.inputs).flatten();
    let size = rows.fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // What is rounded off a state reaches a window of up to 2N samples by as many more of acc.
    let simulated = rounding(generated, run, &step, &[]).into_iter().map(|b| 2.0 * b);
    simulated.zip(round_off(generated)).map(|(a, b)| a + b * size).collect()
}

/// With two copies by turns the status is Coasting while the window of the copy in use holds a prediction.
#[test]
fn coasting_lasts_while_the_copy_in_use_holds_a_prediction() {
    let (generated, truth) = linear("small_memory", "ping-pong");
    let n = generated.design.valid_from_step;
    let run = truth.run(generated.plant.sample_time_s(), 1, 8 * n, 5);
    for missing in 2 * n..3 * n {
        for input in [false, true] {
            let mut fed = run.clone();
            let row = if input { &mut fed.inputs[missing] } else { &mut fed.measurements[missing] };
            row[0] = f64::NAN;
            let answers = fed.through(&generated);
            for (call, status) in answers.statuses.iter().enumerate().skip(n) {
                // Copies start at calls 0, N, 2N, …; the one in use has run for N calls at least.
                let start = call / n * n - n;
                // An input acts on the interval before its call, which the first sample of a copy does not need.
                let held = call >= missing && if input { missing > start } else { missing >= start };
                assert_eq!(*status, if held { Coasting } else { Converged }, "missing at {missing}, call {call}");
            }
        }
    }
}

/// No bits make a step fail: estimates stay finite, and are right again once good samples fill the window.
#[test]
fn no_input_bits_get_stuck_in_any_realisation() {
    let mut texts = vec![edited(&corpus("motor_single_delay"), "k = \"auto\"", "k = 100\nrealization = \"recursive\"")];
    for realization in ["two-level", "ping-pong"] {
        texts.push(edited(
            &corpus("dc_motor"),
            "window = 0.1",
            &format!("window = 0.1\nrealization = \"{realization}\""),
        ));
    }
    let growing = "deadbeat = 1\nname = 'growing'\n[plant]\nA = [[0.5, 1], [-1, 0.5]]\nB = [[0], [1]]\nC = [[1, 0]]\n[inputs]\nu = {}\n\
                   [outputs]\ny = {}\n[observer.window]\nwindow = 1\nrealization = 'recursive'\n[target]\nsample_time = 0.02\nscalar = 'f64'\n";
    texts.push(growing.into());
    for text in texts {
        let generated = designed(&text);
        let (n, mut random) = (generated.plant.states.len(), Random::new(3));
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimate = vec![0.0; n];
        for call in 0..40_000 {
            let (bad, phase) = (f64::from_bits(random.bits()), call / 500 % 4);
            let good = random.within(-1.0, 1.0);
            let y = if phase == 0 || (phase == 1 && random.below(8) > 0) { good } else { bad };
            let u = if phase < 2 { good } else { f64::from_bits(random.bits()) };
            interpreter.step(&[y], &[u], &mut estimate);
            assert!(estimate.iter().all(|x| x.is_finite()), "{}, call {call}: {estimate:?}", generated.program.name);
        }
    }
}

/// The one diagnostic of a specification that is refused.
fn refused(text: &str) -> Diagnostic {
    let report = Generator::new(text, "test.toml").design().err().unwrap_or_else(|| panic!("nothing is refused"));
    assert_eq!(report.diagnostics.len(), 1, "{}", report.render(false));
    report.diagnostics[0].clone()
}

/// What may not run is refused with its number, and with what may run instead.
#[test]
fn refusals_name_the_number_and_the_way_out() {
    let single = |k: &str| {
        edited(&corpus("motor_single_delay"), "k = \"auto\"", &format!("k = {k}\nrealization = \"recursive\""))
    };
    let forced = |name: &str, realization: &str| {
        let text = corpus(name);
        let line = text.lines().find(|line| line.starts_with("window = ")).unwrap().to_owned();
        text.replace(&line, &format!("{line}\nrealization = '{realization}'"))
    };
    // psi_2 of k = 75: -150 + 197.2 1/s (window-observers, section 1).
    let cases: [(String, &str, Option<f64>); 6] = [
        (single("75"), "its filter has a mode of +47.2 1/s", Some(47.2)),
        (
            forced("dc_motor", "recursive"),
            "its filter runs the plant backwards and has a mode of +197.2 1/s",
            Some(197.2),
        ),
        (forced("late_position", "two-level"), "an output arrives late", None),
        (forced("magnetic_levitation", "ping-pong"), "minimax weights follow no recursion", None),
        (forced("motor_continuous", "two-level"), "integrals from samples follow no recursion", None),
        (forced("motor_intermittent", "ping-pong"), "measurements come at irregular times", None),
    ];
    for (text, why, number) in cases {
        let found = refused(&text);
        assert_eq!(found.code, codes::REALIZATION);
        assert!(found.labels[0].text.contains(why), "{}", found.labels[0].text);
        assert!(text[found.labels[0].span.clone()].starts_with("realization"), "the place is the key");
        match number {
            Some(number) => assert!((found.measured.unwrap() - number).abs() < 0.05, "{:?}", found.measured),
            None => assert!(found.measured.is_none()),
        }
        assert!(found.help.as_ref().unwrap().contains("`realization = \"fir\"`"), "{:?}", found.help);
    }
    designed(&single("100"));
    // A copy of this plant grows by e^(2 * 3 * 5) = 1e13 while it runs: too far for f32, not for f64.
    let fast = "deadbeat = 1\nname = 'fast'\n[plant]\nA = [[3, 0], [1, 0]]\nB = [[1], [0]]\nC = [[0, 1]]\n[inputs]\nu = {}\n[outputs]\ny = {}\n\
                [observer.window]\nwindow = 5\nrealization = 'ping-pong'\n[target]\nsample_time = 0.05\nscalar = 'f32'\n";
    let found = refused(fast);
    assert!(found.labels[0].text.starts_with("in f32, round-off could reach"), "{}", found.labels[0].text);
    assert!(found.measured.unwrap() > 1e-3);
}

/// The decision: the sum for short windows, blocks for long ones, and whatever its user asks for.
#[test]
fn the_best_realisation_is_chosen_and_the_wanted_one_taken() {
    let name = |text: &str| designed(text).design.realization;
    assert_eq!(name(&corpus("dc_motor")), "fir");
    let long = corpus("long_window");
    assert_eq!(name(&long), "two-level");
    assert_eq!(name(&edited(&long, "window = 4.0", "window = 4.0\nrealization = \"fir\"")), "fir");
    assert_eq!(name(&edited(&long, "window = 4.0", "window = 0.2")), "fir");
    let list = designed(&long).design.realizations;
    assert_eq!(list.iter().map(|r| r.name).collect::<Vec<_>>(), ["two-level", "fir", "ping-pong", "recursive"]);
    assert!(2 * list[0].flops < list[1].flops);
}

/// Numbers of the decision table are those of the step: its additions and multiplications beyond what every step
/// does to predict, its state, its tables.
#[test]
fn the_table_s_numbers_are_the_step_s() {
    for (text, realization) in [(corpus("long_window"), "two-level"), (corpus("small_memory"), "ping-pong")] {
        let generated = designed(&text);
        let cost = deadbeat_codegen::program::cost::cost(&generated.program, deadbeat_math::COSTS);
        let row = &generated.design.realizations[0];
        assert_eq!(row.name, realization);
        assert_eq!(cost.table_bytes, 8 * row.constants as u64);
        let flops = cost.additions + cost.multiplications;
        // Prediction and injections: a few terms per output.
        assert!(flops.abs_diff(row.flops as u64) <= 24, "{flops} and {}", row.flops);
        assert!((cost.ram_bytes / 8).abs_diff(row.words as u64) <= 8, "{} and {}", cost.ram_bytes / 8, row.words);
    }
}
