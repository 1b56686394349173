//! The corpus as a person would write it down: one right-hand side per specification, by hand.

#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(clippy::cast_precision_loss, reason = "entries of a matrix are small")]

use std::f64::consts::PI;

use super::plant::{Hold, Truth, corpus};

/// Every specification of the corpus whose truth is known.
pub fn truth(name: &str) -> Option<Truth> {
    Some(match name {
        "battery" => battery(),
        "dc_motor" | "motor_known_start" | "motor_single_delay" | "motor_intermittent" | "motor_recursive"
        | "luenberger" => dc_motor(),
        "motor_continuous" => smooth_motor(),
        "differentiator" => integrators(&[2.0, 3.0, 5.0, 5.0]),
        "differentiator_encoder" | "edge_times" | "lossy_encoder" | "three_windows" | "hand_guided" => {
            integrators(&[0.5, 2.0, 5.0])
        }
        "swing_up" => integrators(&[2.0, 5.0]),
        "pendulum_turning" => pendulum_turning(),
        // A ramp, whose backward differences are its derivatives.
        "differentiator_euler" => {
            Truth { start: vec![(290.0, 310.0), (-0.05, 0.05), (0.0, 0.0)], ..integrators(&[0.0; 3]) }
        }
        "pll" | "low_pass" | "adaptive_window" => integrators(&[2.0, 20.0]),
        // Within half a turn, so that the truth need not be folded.
        "shaft_wrapped" => integrators(&[0.5, 2.0, 5.0]),
        "joint_wrapped" => joint(),
        "car_rates" => car(),
        "camera_luenberger" | "camera_prescribed" => seen_part(),
        "alpha_beta" => integrators(&[100.0, 5.0]),
        "alpha_beta_gamma" => integrators(&[0.1, 0.5, 2.0]),
        "drive_irregular" | "bus_sensor" => drive_irregular(),
        "drive_prescribed" => drive_prescribed(),
        "fixed_time_linear" => shaker(),
        "inverted_cart" => inverted_cart(0.3),
        "late_position" | "lossy_position" => late_position(0.4),
        "lossy_arm" => lossy_arm(),
        "two_rates" => two_rates(),
        "long_window" | "high_gain" => long_window(),
        "magnetic_levitation" => magnetic_levitation(),
        "mass_chain" => mass_chain(),
        "oscillator" | "oscillator_known_start" | "oscillator_kalman" | "oscillator_handover" => oscillator(),
        "pendulum"
        | "pendulum_known_start"
        | "pendulum_single_delay"
        | "pendulum_impulsive"
        | "pendulum_prescribed"
        | "kalman" => pendulum(),
        "pendulum_discrete" => pendulum_discrete(),
        "robust_exact" => swinging(),
        "small_memory" => small_memory(),
        "thermal_stack" => thermal_stack(),
        "two_mass_drive" => two_mass_drive(),
        "two_mass_kalman" => {
            Truth { outputs: Box::new(|x, _| vec![x[0], x[1]]), delays: vec![0.0; 2], ..drive_prescribed() }
        }
        "unknown_discrete" => unknown_discrete(),
        "unknown_force" => unknown_force(),
        "unknown_force_network" => unknown_force_network(),
        _ => return None,
    })
}

/// The stems of all files in specs/ whose samples are floats: any number of a counter's unit, and NaN.
/// What counters give: `tests/suite/sensors/wrap.rs`.
pub fn names() -> Vec<String> {
    let folder = format!("{}/specs", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder}: {error}"));
    let paths = entries.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "toml"));
    let mut names: Vec<String> = paths.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    names.retain(|name| !corpus(name).contains("sample = \""));
    names.sort();
    names
}

/// Those of one method.
pub fn names_of(method: &str) -> Vec<String> {
    let uses = |name: &String| corpus(name).lines().any(|line| line.trim() == format!("[observer.{method}]"));
    names().into_iter().filter(uses).collect()
}

/// The methods that predict and correct.
const CORRECTORS: [&str; 9] = [
    "prescribed-time",
    "differentiator",
    "luenberger",
    "kalman",
    "high-gain",
    "fixed-time-linear",
    "robust-exact",
    "pll",
    "alpha-beta",
];

/// The methods that promise nothing: `tests/suite/methods/baselines_shipped.rs` says what they compute.
const BASELINES: [&str; 2] = ["low-pass", "adaptive-window"];

/// Whether a specification's method predicts and corrects.
pub fn corrects(name: &str) -> bool {
    uses(name, &CORRECTORS)
}

/// Whether a specification's method is a formula without a certificate.
pub fn is_baseline(name: &str) -> bool {
    uses(name, &BASELINES)
}

fn uses(name: &str, methods: &[&str]) -> bool {
    let of = |method: &&str| corpus(name).lines().any(|line| line.trim() == format!("[observer.{method}]"));
    methods.iter().any(of)
}

/// Not so far that it turns.
fn pendulum_turning() -> Truth {
    let (m, l, b, g): (f64, f64, f64, f64) = (0.6, 0.45, 0.15, 9.81);
    Truth {
        discrete: false,
        change: Box::new(move |_, x, u| vec![x[1], (u[0] + x[2] - b * x[1]) / (m * l * l) - g / l * x[0].sin(), 0.0]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-1.0, 1.0), (-2.0, 2.0), (-0.3, 0.3)],
        input: vec![(-0.5, 0.5)],
        exact: false,
    }
}

fn dc_motor() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| {
            vec![x[1], 15.0 * x[2] - 35.0 * x[0].sin() - x[1], 40.0 * u[0] - 36.4 * x[1] - 200.0 * x[2]]
        }),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-2.0, 2.0), (-3.0, 3.0), (-1.0, 1.0)],
        input: vec![(-10.0, 10.0)],
        exact: false,
    }
}

fn battery() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![-u[0] / (3600.0 * 2.9), u[0] / 2400.0 - x[1] / (0.015 * 2400.0)]),
        outputs: Box::new(|x, u| vec![3.2 + 0.9 * x[0] - x[1] - 0.02 * u[0]]),
        delays: vec![0.0],
        holds: vec![Hold::First],
        start: vec![(0.2, 0.9), (-0.02, 0.05)],
        input: vec![(-3.0, 6.0)],
        exact: true,
    }
}

/// Without a voltage: only between jumps of an input is the arm's motion as smooth as a cubic takes it to be.
fn smooth_motor() -> Truth {
    Truth { input: vec![(0.0, 0.0)], ..dc_motor() }
}

/// A polynomial and its derivatives, which start within these.
fn integrators(start: &[f64]) -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, _| x[1..].iter().copied().chain([0.0]).collect()),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![],
        start: start.iter().map(|most| (-most, *most)).collect(),
        input: vec![],
        exact: true,
    }
}

/// Within half a turn, so that the truth need not be folded.
fn joint() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], 4.0 * u[0] - 19.6 * x[0].sin() - 0.5 * x[1]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-0.5, 0.5), (-1.0, 1.0)],
        input: vec![(-2.0, 2.0)],
        exact: false,
    }
}

fn car() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], u[0] + x[2], 0.0]),
        outputs: Box::new(|x, _| vec![x[1], x[0]]),
        delays: vec![0.0; 2],
        holds: vec![Hold::Zero],
        start: vec![(-5.0, 5.0), (-5.0, 5.0), (-0.5, 0.5)],
        input: vec![(-2.0, 2.0)],
        exact: true,
    }
}

fn seen_part() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], 4.0 * u[0] - 2.5 * x[1]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-0.5, 0.5), (-0.5, 0.5)],
        input: vec![(-1.0, 1.0)],
        exact: true,
    }
}

fn drive_irregular() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], 15.0 * x[2] - x[1], 40.0 * u[0] - 36.4 * x[1] - 200.0 * x[2]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-2.0, 2.0), (-3.0, 3.0), (-1.0, 1.0)],
        input: vec![(-10.0, 10.0)],
        exact: true,
    }
}

/// Without the load's eccentricity.
fn drive_prescribed() -> Truth {
    Truth {
        change: Box::new(|_, x, u| {
            let shaft = 400.0 * (x[0] - x[1]) + 0.2 * (x[2] - x[3]);
            vec![x[2], x[3], (u[0] - shaft) / 0.01, shaft / 0.05]
        }),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        exact: true,
        ..two_mass_drive()
    }
}

fn oscillator() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], u[0] - 0.4 * x[1] - 25.0 * x[0]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-0.5, 0.5), (-2.0, 2.0)],
        input: vec![(-3.0, 3.0)],
        exact: true,
    }
}

/// A table on a spring, and the lag of its amplifier.
fn shaker() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], 40.0 * x[2] - 900.0 * x[0] - 3.0 * x[1], 25.0 * (u[0] - x[2])]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-0.01, 0.01), (-0.3, 0.3), (-0.5, 0.5)],
        input: vec![(-0.5, 0.5)],
        exact: true,
    }
}

/// Whose third derivative is at most 400.
fn swinging() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|t, x, _| vec![x[1], x[2], 150.0 * (6.0 * t).sin() - 30.0 * x[1]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![],
        start: vec![(-0.5, 0.5), (-2.0, 2.0), (-5.0, 5.0)],
        input: vec![],
        exact: false,
    }
}

/// With the amplitude of the known ground motion; linear and exact when it is 0.
pub fn inverted_cart(ground: f64) -> Truth {
    Truth {
        discrete: false,
        change: Box::new(move |t, x, u| {
            let (angle, dx, dangle, force) = (x[1], x[2], x[3], u[0]);
            vec![
                dx,
                dangle,
                -0.1818 * dx + 2.6727 * angle + 1.8182 * force,
                -0.4545 * dx + 31.1818 * angle + 4.5455 * force + ground * (2.0 * PI * 1.5 * t).sin(),
            ]
        }),
        outputs: Box::new(|x, _| vec![x[0], x[1]]),
        delays: vec![0.0; 2],
        holds: vec![Hold::Zero],
        start: vec![(-0.1, 0.1), (-0.05, 0.05), (-0.2, 0.2), (-0.1, 0.1)],
        input: vec![(-1.0, 1.0)],
        exact: ground == 0.0,
    }
}

/// Swings that stay within a turn, so that the estimate of a wrapped angle is the angle.
fn lossy_arm() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], 8.0 * u[0] - 35.0 * x[0].sin() - x[1]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-0.5, 0.5), (-2.0, 2.0)],
        input: vec![(-1.0, 1.0)],
        exact: false,
    }
}

fn two_rates() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], u[0] / 2.5 - 0.8 * x[1] + x[2], 0.0]),
        outputs: Box::new(|x, _| vec![x[0], x[1]]),
        delays: vec![0.02, 0.0],
        holds: vec![Hold::Zero],
        start: vec![(-1.0, 1.0), (-1.0, 1.0), (-0.5, 0.5)],
        input: vec![(-2.0, 2.0)],
        exact: true,
    }
}

/// With the size of the dry friction; linear and exact when it is 0.
pub fn late_position(friction: f64) -> Truth {
    Truth {
        discrete: false,
        change: Box::new(move |_, x, u| {
            let (speed, slope, wheel) = (x[1], x[2], x[3]);
            vec![
                speed,
                u[0] / 2.5 - 0.8 * speed - friction * (20.0 * wheel).tanh() + slope,
                0.0,
                30.0 * (speed - wheel),
            ]
        }),
        outputs: Box::new(|x, _| vec![x[0], x[3]]),
        delays: vec![0.04, 0.0],
        holds: vec![Hold::Zero],
        start: vec![(-5.0, 5.0), (-0.3, 0.3), (-0.5, 0.5), (-0.3, 0.3)],
        input: vec![(-3.0, 3.0)],
        exact: friction == 0.0,
    }
}

fn long_window() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], -9.81 / 6.0 * x[0].sin() - 0.05 * x[1] - u[0] / 6.0]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-0.3, 0.3), (-0.2, 0.2)],
        input: vec![(-0.5, 0.5)],
        exact: false,
    }
}

fn small_memory() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], u[0] / 2e-3 - 1.5 * x[1] - x[2], 0.0]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(-3.0, 3.0), (-20.0, 20.0), (-50.0, 50.0)],
        input: vec![(-0.5, 0.5)],
        exact: true,
    }
}

fn magnetic_levitation() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| vec![x[1], 9.81 - 6.53e-5 * u[0] * u[0] / (2.0 * 0.068 * x[0] * x[0])]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(0.009, 0.011), (-0.05, 0.05)],
        input: vec![(1.2, 1.7)],
        exact: false,
    }
}

fn mass_chain() -> Truth {
    let document: toml::Table = corpus("mass_chain").parse().unwrap();
    let matrix = |letter: &str| -> Vec<Vec<f64>> {
        let rows = document["plant"][letter].as_array().unwrap();
        rows.iter().map(|row| row.as_array().unwrap().iter().map(number).collect()).collect()
    };
    let (a, b, c) = (matrix("A"), matrix("B"), matrix("C"));
    let dot = |row: &[f64], x: &[f64]| row.iter().zip(x).map(|(r, x)| r * x).sum::<f64>();
    let n = a.len();
    Truth {
        discrete: false,
        change: Box::new(move |_, x, u| a.iter().zip(&b).map(|(a, b)| dot(a, x) + dot(b, u)).collect()),
        outputs: Box::new(move |x, _| c.iter().map(|row| dot(row, x)).collect()),
        delays: vec![0.0; 3],
        holds: vec![Hold::Zero],
        start: (0..n).map(|i| if i < 6 { (-0.1, 0.1) } else { (-1.0, 1.0) }).collect(),
        input: vec![(-5.0, 5.0)],
        exact: true,
    }
}

/// A number, or a quotient of two in a string.
fn number(value: &toml::Value) -> f64 {
    match value {
        toml::Value::Integer(n) => *n as f64,
        toml::Value::Float(x) => *x,
        toml::Value::String(text) => {
            let (over, under) = text.split_once('/').unwrap();
            over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()
        }
        other => panic!("{other:?} is no number"),
    }
}

fn pendulum() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, _| vec![x[1], 64.2189 * x[0].sin() - 0.067_227 * x[1]]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![],
        start: vec![(0.5, 2.5), (-5.0, 5.0)],
        input: vec![],
        exact: false,
    }
}

/// 001 (64).
fn pendulum_discrete() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, _| vec![x[1], -x[0].sin()]),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![],
        start: vec![(-2.0, 2.0), (-1.0, 1.0)],
        input: vec![],
        exact: false,
    }
}

fn thermal_stack() -> Truth {
    Truth {
        discrete: true,
        change: Box::new(|_, x, u| {
            let (heater, block, sensor) = (x[0], x[1], x[2]);
            vec![
                0.82 * heater + 0.11 * block + 0.9 * u[0],
                0.05 * heater + 0.93 * block - 0.002 * (sensor - u[1]),
                0.2 * block + 0.8 * sensor,
            ]
        }),
        outputs: Box::new(|x, _| vec![x[2]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero; 2],
        start: vec![(10.0, 40.0); 3],
        input: vec![(0.0, 8.0), (10.0, 30.0)],
        exact: true,
    }
}

fn two_mass_drive() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| {
            let (motor, load, motor_speed, load_speed) = (x[0], x[1], x[2], x[3]);
            let shaft = 400.0 * (motor - load) + 0.2 * (motor_speed - load_speed);
            vec![motor_speed, load_speed, (u[0] - shaft) / 0.01, (shaft - 1.5 * load.sin()) / 0.05]
        }),
        outputs: Box::new(|x, _| vec![x[0], x[1]]),
        delays: vec![0.0; 2],
        holds: vec![Hold::First],
        start: vec![(-0.5, 0.5), (-0.5, 0.5), (-10.0, 10.0), (-10.0, 10.0)],
        input: vec![(-5.0, 5.0)],
        exact: false,
    }
}

/// The unknowns are the last two states; they stay.
fn unknown_force() -> Truth {
    Truth {
        discrete: false,
        change: Box::new(|_, x, u| {
            let (speed, current, load, offset) = (x[1], x[2], x[3], x[4]);
            vec![
                speed,
                15.0 * current - speed + load,
                40.0 * (u[0] + offset) - 36.4 * speed - 200.0 * current,
                0.0,
                0.0,
            ]
        }),
        outputs: Box::new(|x, _| vec![x[0], x[2]]),
        delays: vec![0.0; 2],
        holds: vec![Hold::Zero],
        start: vec![(-1.0, 1.0), (-3.0, 3.0), (-1.0, 1.0), (-20.0, 20.0), (-2.0, 2.0)],
        input: vec![(-10.0, 10.0)],
        exact: true,
    }
}

/// Moving enough for its window to excite every unknown: it starts far from where the spring holds it.
fn unknown_force_network() -> Truth {
    let bump = |x: f64| (-(x / 0.4) * (x / 0.4)).exp();
    Truth {
        discrete: false,
        change: Box::new(move |t, x, u| {
            let (position, weights) = (x[0], &x[2..]);
            let field = weights[0] * bump(position + 0.5)
                + weights[1] * bump(position)
                + weights[2] * bump(position - 0.5)
                + weights[3] * (3.0 * t).sin();
            vec![x[1], -40.0 * position + u[0] + field, 0.0, 0.0, 0.0, 0.0]
        }),
        outputs: Box::new(|x, _| vec![x[0]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(1.0, 1.5), (-1.0, 1.0), (-3.0, 3.0), (-3.0, 3.0), (-3.0, 3.0), (-3.0, 3.0)],
        input: vec![(-2.0, 2.0)],
        exact: false,
    }
}

fn unknown_discrete() -> Truth {
    Truth {
        discrete: true,
        change: Box::new(|_, x, u| {
            let (level, shown, leak) = (x[0], x[1], x[2]);
            vec![0.98 * level + 0.05 * u[0] - leak, 0.3 * level + 0.7 * shown, leak]
        }),
        outputs: Box::new(|x, _| vec![x[1]]),
        delays: vec![0.0],
        holds: vec![Hold::Zero],
        start: vec![(0.5, 2.0), (0.5, 2.0), (0.0, 0.02)],
        input: vec![(0.0, 2.0)],
        exact: true,
    }
}
