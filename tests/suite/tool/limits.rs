//! Claim: a limit that stands for some specifications refuses one of them with its sentence, and takes one that avoids it;
//! every such limit of every method is tried. And a sample may be missing whatever the method.

use deadbeat_codegen::program::Status;
use deadbeat_codegen::program::interp::Interpreter;
use deadbeat_codegen::{Cell, Feature, Generator, Limit, METHODS, Method};

/// The methods that a chain of integrators stands for.
const OF_CHAINS: [&str; 5] = ["differentiator", "pll", "alpha-beta", "low-pass", "adaptive-window"];

/// The fewest keys of each method.
fn keys(method: &str) -> &'static str {
    match method {
        "window" | "single-delay" | "impulsive" | "parameters" => "window = 0.2",
        "prescribed-time" => "time = 0.2",
        "differentiator" => "order = 2\ntime = 0.2",
        "luenberger" => "poles = [-5, -6]",
        "kalman" => "process_noise = [1e-3, 1e-3]\nmeasurement_noise = [1e-3]",
        "high-gain" => "gain = 10\npoles = [-1, -1]",
        "fixed-time-linear" => "",
        "robust-exact" => "lipschitz = 1",
        "pll" => "bandwidth = 10",
        "alpha-beta" => "alpha = 0.5",
        "low-pass" => "time_constant = 0.05",
        "adaptive-window" => "deviation = 1e-3\nlongest = 0.1",
        other => panic!("the keys of `{other}`"),
    }
}

/// What a specification of two states says besides its method.
#[derive(Clone, Copy)]
struct Spec {
    /// The states; not of chains.
    states: &'static str,
    /// Of the output `y`, besides its value.
    sensor: &'static str,
    /// Lines below the output, with tables of their own.
    more: &'static str,
    /// Keys of the method; the fewest where there are none.
    keys: &'static str,
    /// Lines of the target.
    target: &'static str,
}

const SWING: &str = "q = { derivative = 'v' }\nv = { derivative = '-q' }";
const PENDULUM: &str = "q = { derivative = 'v' }\nv = { derivative = '-sin(q)' }";
const MASS: &str = "q = { derivative = 'v' }\nv = { derivative = '0' }";
const LOADED: &str = "q = { derivative = 'v' }\nv = { derivative = '-q + load' }";
const SWAYED: &str = "q = { derivative = 'v' }\nv = { derivative = '-q + sin(t)*load' }";
const TWO_LOADS: &str = "q = { derivative = 'v' }\nv = { derivative = '-q + load + sin(t)*push' }";
const DRIFTING: &str = "q = { next = '0.98*q - load' }\nv = { next = '0.3*q + 0.7*v' }";
const STEPPING: &str = "q = { next = 'q + 0.1*v' }\nv = { next = 'v' }";
const FOUR: &str =
    "q = { derivative = 'v' }\nv = { derivative = 'a' }\na = { derivative = 'b' }\nb = { derivative = '-q' }";
const CHAIN: &str =
    "q = { derivative = 'v' }\nv = { derivative = 'a' }\na = { derivative = 'b' }\nb = { derivative = '0' }";
const LOAD: &str = "[unknowns]\nload = {}";
const LEFT_OUT: &str = "window = 0.2\nmissing = 'left-out'";
const PAPER: &str = "window = 0.2\nform = 'paper'";
const FILTER: &str =
    "time = 0.2\nkalman = { process_noise = [1e-6, 1e-6], measurement_noise = [1e-4, 1e-4], initial_deviation = 1 }";

const PLAIN: Spec = Spec { states: SWING, sensor: "", more: "", keys: "", target: "scalar = 'f32'" };

impl Spec {
    fn text(self, method: &str) -> String {
        let is_chain = OF_CHAINS.contains(&method);
        let states = if is_chain { String::new() } else { format!("[states]\n{}\n", self.states) };
        let value = if is_chain || self.sensor.starts_with("value") { "" } else { "value = 'q', " };
        let keys = if self.keys.is_empty() { keys(method) } else { self.keys };
        format!(
            "deadbeat = 1\nname = 's'\n{states}[outputs]\ny = {{ {value}{} }}\n{}\n[observer.{method}]\n{keys}\n\
             [target]\nsample_time = 0.01\n{}\n",
            self.sensor.trim_end_matches(", "),
            self.more,
            self.target
        )
        .replace(", }", " }")
    }
}

/// A specification that meets a limit, and one that avoids it.
fn example(method: &str, limit: &Limit, words: &str) -> [Spec; 2] {
    let sensor = |sensor| Spec { sensor, ..PLAIN };
    let keyed = |spec: Spec, keys| [Spec { keys, ..spec }, spec];
    match (method, limit.feature, words) {
        (
            _,
            Feature::Counter,
            "of 32 bits in f32, unless `wrap` is a turn of at most 2^24 counts or `range` within these",
        ) => {
            let plant = match method {
                "parameters" => Spec { states: LOADED, more: LOAD, ..PLAIN },
                _ => PLAIN,
            };
            let spec = Spec { sensor: "sample = 'i32', quantum = 1e-3", ..plant };
            [spec, Spec { target: "scalar = 'f64'", ..spec }]
        }
        (_, Feature::Every, "of an output in a nonlinear term") => {
            [Spec { states: PENDULUM, ..sensor("every = 2") }, sensor("every = 2")]
        }
        ("prescribed-time", Feature::Every, "of several outputs") => {
            let spec = Spec { keys: FILTER, more: "w = { value = 'v' }", ..sensor("every = 2") };
            [spec, Spec { more: "", keys: "", ..spec }]
        }
        ("prescribed-time", Feature::Outputs, "but with the law `kalman`") => {
            let spec = Spec { more: "w = { value = 'v' }", ..PLAIN };
            [spec, Spec { keys: FILTER, ..spec }]
        }
        ("single-delay", Feature::Wrap, "with `form = \"continuous\"`") => {
            keyed(Spec { states: MASS, ..sensor("wrap = '2*pi'") }, "window = 0.2\nform = 'continuous'")
        }
        (
            "window" | "single-delay",
            Feature::Counter,
            "of 32 bits in f32 without `wrap`, unless `range` is within 2^24 counts of 0",
        ) => {
            let spec = |range| Spec { states: MASS, ..sensor(range) };
            [spec("sample = 'i32', quantum = 1e-3"), spec("sample = 'i32', quantum = 1e-3, range = [-8e3, 8e3]")]
        }
        ("single-delay", Feature::Counter, _) => {
            let keys = "window = 0.2\nintermittent = { min = 0.01, max = 0.02 }";
            let states = MASS;
            let spec = Spec { states, keys, ..sensor("sample = 'i32', quantum = 1e-3, wrap = 'counter'") };
            [spec, Spec { target: "scalar = 'f64'", ..spec }]
        }
        ("parameters", Feature::Delay, "of a discrete plant, with `form = \"paper\"`") => {
            keyed(Spec { states: DRIFTING, more: LOAD, ..sensor("value = 'v', delay = 0.01") }, PAPER)
        }
        ("parameters", Feature::Delay, "with several unknowns and `form = \"paper\"`") => {
            let spec = Spec { keys: PAPER, ..sensor("delay = 0.02") };
            let both = "[unknowns]\nload = {}\npush = {}";
            [Spec { states: TWO_LOADS, more: both, ..spec }, Spec { states: LOADED, more: LOAD, ..spec }]
        }
        ("parameters", Feature::Outputs, "with `form = \"paper\"`") => {
            keyed(Spec { states: LOADED, more: "w = { value = 'v' }\n[unknowns]\nload = {}", ..PLAIN }, PAPER)
        }
        ("parameters", Feature::Ahead, "where the factor of an unknown varies") => {
            let spec = Spec { more: LOAD, keys: "window = 0.2\nahead = 0.01", ..PLAIN };
            [Spec { states: SWAYED, ..spec }, Spec { states: LOADED, ..spec }]
        }
        ("parameters", Feature::InitAt, "with `form = \"paper\"`, where the factor of an unknown varies") => {
            keyed(Spec { states: SWAYED, more: LOAD, target: "init_at = true", ..PLAIN }, PAPER)
        }
        ("window", Feature::Counter, _) => {
            let turning = "sample = 'i32', quantum = '2*pi/2156', wrap = '2*pi'";
            ["sample = 'i32', quantum = 1e-3, wrap = 'counter'", turning].map(|counts| Spec {
                keys: LEFT_OUT,
                states: MASS,
                ..sensor(counts)
            })
        }
        ("window", Feature::Gate, "of a late output, where samples are left out") => {
            keyed(sensor("gate = 1, delay = 0.02"), LEFT_OUT)
        }
        ("window", Feature::Age, words) => {
            let aged = sensor("age = 'measured'");
            match words {
                "of a discrete plant" => [Spec { states: STEPPING, ..aged }, Spec { states: MASS, ..aged }],
                "of more than 3 states, or 4 in a chain" => {
                    [Spec { states: FOUR, ..aged }, Spec { states: CHAIN, ..aged }]
                }
                "of a late output" => [sensor("age = 'measured', delay = 0.02"), aged],
                "of an output with a gate" => [sensor("age = 'measured', gate = 1"), aged],
                "of an output with an input in it" => {
                    let driven = Spec { states: "q = { derivative = 'v' }\nv = { derivative = 'u' }", ..PLAIN };
                    let driven = Spec { more: "[inputs]\nu = {}", ..driven };
                    ["value = 'q + u', age = 'measured'", "age = 'measured'"].map(|sensor| Spec { sensor, ..driven })
                }
                "of an output in a nonlinear term" => [Spec { states: PENDULUM, ..aged }, aged],
                other => panic!("no example of an age {other}"),
            }
        }
        ("window", Feature::Windows, "where samples are left out") => {
            let spec = Spec { keys: "window = [0.2, 0.4]", ..PLAIN };
            [Spec { keys: "window = [0.2, 0.4]\nmissing = 'left-out'", ..spec }, spec]
        }
        _ => panic!("no example of {} {words} for `{method}`", limit.feature.words()),
    }
}

/// What stands for some specifications, of all methods.
fn partly() -> impl Iterator<Item = (&'static Method, &'static Limit, &'static str)> {
    let of =
        |method: &'static Method| method.limits.iter().filter_map(move |limit| Some((method, limit, limit.words()?)));
    METHODS.iter().flat_map(of)
}

/// Every limit refuses what meets it, with its sentence and its way out, and takes what avoids it.
#[test]
fn each_limit_refuses_what_meets_it_and_no_more() {
    let mut wrong = Vec::new();
    for (method, limit, words) in partly() {
        let [met, avoided] = example(method.name, limit, words).map(|spec| spec.text(method.name));
        let report = Generator::new(&met, "met.toml").check();
        let sentence = limit.sentence(method.name);
        let said =
            report.diagnostics.iter().any(|it| it.message == sentence && it.help.as_deref() == Some(limit.instead));
        if !said {
            wrong.push(format!("should say: {sentence}\n{met}\n{}", report.render(false)));
        }
        let report = Generator::new(&avoided, "avoided.toml").check();
        if report.has_errors() {
            wrong.push(format!("{} {words} is avoided\n{avoided}\n{}", limit.feature.words(), report.render(false)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(partly().count() >= 35, "{}", partly().count());
}

/// A sample is missing when the estimate has converged: the estimate stays a number, and converges again.
#[test]
fn every_method_takes_a_missing_sample() {
    for method in METHODS {
        assert_eq!(method.cell(Feature::Missing), Cell::Taken, "{}", method.name);
        let unknown = method.name == "parameters";
        let spec = if unknown { Spec { states: LOADED, more: LOAD, ..PLAIN } } else { PLAIN };
        let text = spec.text(method.name);
        let generated = Generator::new(&text, "missing.toml").design();
        let generated = generated.unwrap_or_else(|report| panic!("{}", report.render(false)));
        let mut interpreter = Interpreter::new(&generated.program);
        let mut estimates = vec![0.0; generated.program.estimates.len()];
        let mut step = |sample| {
            let status = interpreter.step(&[sample], &[], &mut estimates);
            assert!(estimates.iter().all(|it| it.is_finite()), "{}: {estimates:?}", method.name);
            status
        };
        let calls = 4 * generated.design.valid_from_step + 200;
        let before = (0..calls).map(|_| step(0.25)).last();
        assert_eq!(before, Some(Status::Converged), "{}\n{text}", method.name);
        step(f64::NAN);
        assert_eq!((0..calls).map(|_| step(0.25)).last(), Some(Status::Converged), "{}", method.name);
    }
}
