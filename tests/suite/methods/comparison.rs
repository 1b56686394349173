//! Claim: what the manual says of the methods against each other is what the designs do: on 003's signal and noise, on
//! white noise, and on a step of the sensor. `tests/golden/comparison.md` is the table; `DEADBEAT_BLESS=1 cargo test
//! --test suite comparison::` makes it.
//!
//! 003's Table 1 is no part of it: it cannot be had from the paper's text (see the page of `fixed-time-linear`).

#![allow(clippy::cast_precision_loss, reason = "counts of calls are small")]

use std::fmt::Write as _;
use std::{env, fs};

use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Generated, Generator};

/// 003's example: n = 4, T = 2.5 s.
const TIME: f64 = 2.5;
/// Seeds of 003's noise, from the one of the reference trajectories on.
const SEEDS: u64 = 32;
const FIRST_SEED: u64 = 20_240_427;
/// Size of the white noise, one standard deviation, and of the step.
const LEVEL: f64 = 1e-3;

/// A method of the table, with the text of its specification for a sample time.
struct Row {
    what: &'static str,
    text: Box<dyn Fn(f64) -> String>,
}

fn specification(tables: &str, h: f64) -> String {
    format!("deadbeat = 1\nname = 'c'\n{tables}\n[target]\nsample_time = {h}\nscalar = 'f64'\n")
}

/// A method that takes the chain by its order.
fn by_order(what: &'static str, method: &'static str, keys: impl Fn(f64) -> String + 'static) -> Row {
    let text =
        move |h: f64| specification(&format!("[outputs]\ny = {{}}\n[observer.{method}]\norder = 4\n{}", keys(h)), h);
    Row { what, text: Box::new(text) }
}

/// A method that takes the chain as a plant, driven by a disturbance; noise by its bound.
fn by_plant(what: &'static str, method: &'static str, keys: impl Fn(f64) -> String + 'static) -> Row {
    by_noisy_plant(what, method, |_| 1.0, 1.0, keys)
}

fn by_noisy_plant(
    what: &'static str,
    method: &'static str,
    noise: impl Fn(f64) -> f64 + 'static,
    drive: f64,
    keys: impl Fn(f64) -> String + 'static,
) -> Row {
    let text = move |h: f64| {
        let tables = format!(
            "[states]\ny = {{ derivative = 'dy' }}\ndy = {{ derivative = 'd2y' }}\nd2y = {{ derivative = 'd3y' }}\n\
             d3y = {{ derivative = 'w' }}\n[outputs]\ny = {{ value = 'y', noise = {:e} }}\n[disturbances]\n\
             w = {{ bound = {drive:e} }}\n[observer.{method}]\n{}",
            noise(h),
            keys(h)
        );
        specification(&tables, h)
    };
    Row { what, text: Box::new(text) }
}

/// 003's gains.
const PAPER: &str = "time = 2.5\nefimov-orlov = { L = [46, 791, 6026, 17160] }";

/// Kalman takes a bound as that of a uniform number, whose variance is a third of its square. The paper's noise,
/// 10 h^3 (u + sin 35 t), has a mean square of (10 h^3)^2 5/6; the fourth derivative, 12 t + 2401 sin 7 t, one of
/// about 2401^2/2.
fn paper_noise(h: f64) -> f64 {
    10.0 * h * h * h * 2.5_f64.sqrt()
}

const FOURTH: f64 = 2940.6;

fn rows() -> Vec<Row> {
    let euler = |keys: &str| format!("{keys}\nprediction = 'implicit-euler'");
    let restart = format!("{PAPER}\nafter = 'restart'\nstop_before = 1");
    let restart_euler = euler(&restart);
    // 0.2 s and 0.06 s before the prescribed time.
    let hold = |h: f64| format!("{PAPER}\nstop_before = {}", if h > 0.05 { 2 } else { 6 });
    let steps = |n: u32| move |h: f64| format!("window = '{n}*{h}'");
    vec![
        by_order("differentiator: restart, 003 (21)", "differentiator", move |_| restart_euler.clone()),
        by_order("the same, exact prediction", "differentiator", move |_| restart.clone()),
        by_order("differentiator: hold at r = 2, 6", "differentiator", hold),
        by_plant("high-gain: gain = 2, 003's L", "high-gain", |_| "gain = 2\nL = [46, 791, 6026, 17160]".into()),
        by_order("fixed-time-linear: backward differences", "fixed-time-linear", move |_| euler("")),
        by_order("fixed-time-linear: exact prediction", "fixed-time-linear", |_| String::new()),
        by_order("robust-exact: L = 2600, implicit Euler", "robust-exact", move |_| euler("lipschitz = 2600")),
        by_order("robust-exact: L = 2600", "robust-exact", |_| "lipschitz = 2600".into()),
        by_noisy_plant("kalman: noise and 4th derivative as they are", "kalman", paper_noise, FOURTH, |_| {
            String::new()
        }),
        by_noisy_plant("kalman: 4th derivative 10 times that", "kalman", paper_noise, 10.0 * FOURTH, |_| String::new()),
        by_noisy_plant(
            "kalman: noise 1e-3, 4th derivative 1",
            "kalman",
            |_| 3.0_f64.sqrt() * LEVEL,
            3.0_f64.sqrt(),
            |_| String::new(),
        ),
        by_plant("window: 5 samples", "window", steps(4)),
        by_plant("window: 7 samples", "window", steps(6)),
        by_plant("window: 25 samples", "window", steps(24)),
    ]
}

fn designed(text: &str) -> Generated {
    Generator::new(text, "comparison.toml").design().unwrap_or_else(|report| panic!("{text}\n{}", report.render(false)))
}

/// 003's signal and its derivatives; the crate's own sine, the same on every machine.
fn signal(t: f64) -> [f64; 4] {
    let (sin, cos) = (deadbeat_math::sin_f64(7.0 * t), deadbeat_math::cos_f64(7.0 * t));
    [
        0.1 * t * t * t * t * t - 100.0 * t + sin + 1000.0,
        0.5 * t * t * t * t - 100.0 + 7.0 * cos,
        2.0 * t * t * t - 49.0 * sin,
        6.0 * t * t - 343.0 * cos,
    ]
}

fn cubic(t: f64) -> [f64; 4] {
    [0.5 * t * t * t - t * t + 3.0 * t + 1.0, 1.5 * t * t - 2.0 * t + 3.0, 3.0 * t - 2.0, 3.0]
}

/// The reference trajectories' generator: uniform in [0, 1).
struct Congruence(u64);

impl Congruence {
    /// The reference's own run, and others far from it.
    fn run(number: u64) -> Self {
        Self((FIRST_SEED + number * 0x9e37_79b9) % (1 << 31))
    }

    fn draw(&mut self) -> f64 {
        self.0 = (self.0 * 1_103_515_245 + 12_345) % (1 << 31);
        self.0 as f64 / 2_147_483_648.0
    }
}

/// The errors of the calls in [3T, 4T), for a truth and what is added to it at each call.
fn errors(
    generated: &Generated,
    h: f64,
    truth: impl Fn(f64) -> [f64; 4],
    mut added: impl FnMut(usize, f64) -> f64,
) -> Vec<[f64; 4]> {
    let period = (TIME / h).round();
    let mut interpreter = Interpreter::new(&generated.program);
    let mut all = Vec::new();
    for (call, k) in (0..).map(|call| (call, call as f64)).take_while(|(_, k)| *k < 4.0 * period) {
        let (x, mut estimate) = (truth(k * h), [0.0; 4]);
        interpreter.step(&[x[0] + added(call, k * h)], &[], &mut estimate);
        if k >= 3.0 * period {
            all.push(std::array::from_fn(|i| estimate[i] - x[i]));
        }
    }
    all
}

/// The integral of the error's norm, 003's signal and noise, mean over the seeds.
fn integral(generated: &Generated, h: f64) -> f64 {
    let one = |seed: u64| {
        let mut random = Congruence::run(seed);
        let noise = |_: usize, t: f64| 10.0 * h * h * h * (random.draw() + deadbeat_math::sin_f64(35.0 * t));
        let norms = errors(generated, h, signal, noise).into_iter();
        h * norms.map(|e| deadbeat_math::sqrt_f64(e.iter().map(|e| e * e).sum::<f64>())).sum::<f64>()
    };
    (0..SEEDS).map(one).sum::<f64>() / SEEDS as f64
}

/// The mean magnitude of the third derivative's error, per standard deviation of white noise.
fn white(generated: &Generated, h: f64) -> f64 {
    let one = |seed: u64| {
        let mut random = Congruence::run(seed);
        // The low bits of such a generator repeat soon, the high ones do not; uniform noise of that deviation.
        let noise = |_: usize, _: f64| LEVEL * deadbeat_math::sqrt_f64(3.0) * (2.0 * random.draw() - 1.0);
        let all = errors(generated, h, cubic, noise);
        all.iter().map(|e| e[3].abs()).sum::<f64>() / all.len() as f64 / LEVEL
    };
    (0..SEEDS).map(one).sum::<f64>() / SEEDS as f64
}

/// The largest error of the third derivative, per unit of a step of the sensor a fifth of a period behind 3T.
fn step(generated: &Generated, h: f64) -> f64 {
    let from = (3.2 * TIME / h).round();
    let all = errors(generated, h, cubic, |call, _| if call as f64 >= from { LEVEL } else { 0.0 });
    all.iter().map(|e| e[3].abs()).fold(0.0, f64::max) / LEVEL
}

fn three(x: f64) -> String {
    if x >= 9999.5 {
        return format!("{x:.2e}");
    }
    let digits = usize::from(x < 99.95) + usize::from(x < 9.995);
    format!("{x:.digits$}")
}

/// The table, computed.
fn table() -> String {
    let mut text = String::from(
        "| | signal, h = 0.1 | 0.01 | white, 0.1 | 0.01 | step, 0.1 | 0.01 |\n|---|---|---|---|---|---|---|\n",
    );
    for row in rows() {
        let designs = [0.1, 0.01].map(|h| (designed(&(row.text)(h)), h));
        let mut cells = String::new();
        for measure in [integral, white, step] {
            for (generated, h) in &designs {
                let _ = write!(cells, " {} |", three(measure(generated, *h)));
            }
        }
        let _ = writeln!(text, "| {} |{cells}", row.what);
    }
    text
}

fn read(path: &str) -> String {
    fs::read_to_string(format!("{}/{path}", env!("CARGO_MANIFEST_DIR"))).unwrap_or_default()
}

#[test]
fn the_table_is_what_the_designs_do() {
    let computed = table();
    println!("{computed}");
    let path = "tests/golden/comparison.md";
    if env::var("DEADBEAT_BLESS").is_ok_and(|value| value == "1") {
        fs::write(format!("{}/{path}", env!("CARGO_MANIFEST_DIR")), &computed).expect("the table is written");
    }
    assert_eq!(read(path), computed, "DEADBEAT_BLESS=1 rewrites {path}");
    assert!(read("manual/compared.md").contains(&computed), "manual/compared.md: the table of {path} is another");
}

/// The samples are those of the reference trajectories.
#[test]
fn the_samples_are_the_reference() {
    for (file, h) in [("traj_003_h0p1", 0.1), ("traj_003_h0p01", 0.01)] {
        let golden: serde_json::Value = serde_json::from_str(&read(&format!("tests/golden/{file}.json"))).unwrap();
        let mut random = Congruence::run(0);
        for (k, y) in golden["y"].as_array().unwrap().iter().enumerate() {
            let t = k as f64 * h;
            let ours = signal(t)[0] + 10.0 * h * h * h * (random.draw() + deadbeat_math::sin_f64(35.0 * t));
            // A few roundings of numbers up to 1e4.
            assert!((ours - y.as_f64().unwrap()).abs() < 1e-11, "{file} {k}: {ours} {y}");
        }
    }
}
