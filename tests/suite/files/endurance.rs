//! Claim: no realisation and no corrector wears out. Over ten million calls of the generated Rust in single precision, on a
//! stable, an undamped, an integrating and an unstable plant, the error stays within what the design promises.
//!
//! The plant runs in doubles beside the observer, kept where it is by feedback of its true state; what the
//! observer gets is rounded to singles. So the only errors are the samples' rounding, which the noise gain
//! bounds, and the step's own, which the design's round-off bounds.
//!
//! A corrector is given noise up to the declared bound besides, and its error is held against the bound that the design
//! prints for that noise: from the promised call on, or, where the status says when, whenever it says so.

use crate::support::corpus;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use corpus::{empty_folder, put, root, side_by_side, succeed};
use deadbeat_codegen::internals::estimator::corrector::Corrector;
use deadbeat_codegen::internals::estimator::window::Functional;
use deadbeat_codegen::promise::Convergence;
use deadbeat_codegen::{Generated, Generator, Output};

/// A plant with two states and one input, by its name; feedback that keeps it within about 1.
struct Plant {
    name: &'static str,
    rows: [&'static str; 2],
    feedback: [f64; 2],
}

const PLANTS: [Plant; 4] = [
    Plant { name: "stable", rows: ["x2", "u - 4*x1 - 1.5*x2"], feedback: [0.0, 0.0] },
    Plant { name: "undamped", rows: ["x2", "u - 9*x1"], feedback: [0.0, -0.4] },
    Plant { name: "integrating", rows: ["x2", "u"], feedback: [-2.0, -2.0] },
    Plant { name: "unstable", rows: ["x2", "u + 2*x1 - 0.5*x2"], feedback: [-5.0, -2.0] },
];

/// Every realisation, those of least squares by `window`, the recursive one by `single-delay`: with one copy on
/// the stable and the unstable plant, with two that take turns on the others.
const REALIZATIONS: [&str; 4] = ["fir", "two-level", "ping-pong", "recursive"];

/// What the noise of a corrector's samples is bounded by: well above the rounding of samples of 1.
const NOISE: f64 = 1e-3;

/// Every mode of every method that predicts and corrects, with its keys.
const CORRECTORS: [(&str, &str, &str); 9] = [
    ("hold", "prescribed-time", "time = 0.5"),
    ("restart", "prescribed-time", "time = 0.5\nafter = 'restart'"),
    (
        "handover",
        "prescribed-time",
        "time = 0.5\nafter = 'handover'\nprocess_noise = [1e-7, 1e-5]\nmeasurement_noise = [3e-7]",
    ),
    (
        "table",
        "prescribed-time",
        "time = 0.5\nkalman = { process_noise = [1e-7, 1e-5], measurement_noise = [3e-7], initial_deviation = 10 }",
    ),
    ("kalman", "kalman", "process_noise = [1e-7, 1e-5]\nmeasurement_noise = [3e-7]"),
    ("luenberger", "luenberger", "poles = [-12, -15]"),
    ("high_gain", "high-gain", "gain = 15\npoles = [-1, -1]"),
    ("fixed_time", "fixed-time-linear", ""),
    ("robust_exact", "robust-exact", "lipschitz = 5"),
];

/// A design with the bounds on its error.
struct Subject {
    name: String,
    generated: Generated,
    output: Output,
    feedback: [f64; 2],
    /// What a held input does in one interval.
    gamma: [f64; 2],
    /// On the noise of the samples, beside their rounding.
    noise: f64,
}

fn designed(plant: &Plant, name: &str, realization: &str) -> (Generated, Output) {
    let method = if realization == "recursive" { "single-delay]\nk = 3" } else { "window]" };
    observed(plant, name, &format!("{method}\nwindow = 1.2\nrealization = '{realization}'"))
}

/// The plant under the observer of a table, from its name on.
fn observed(plant: &Plant, name: &str, table: &str) -> (Generated, Output) {
    let [first, second] = plant.rows;
    let text = format!(
        "deadbeat = 1\nname = '{name}'\n[states]\nx1 = {{ derivative = '{first}' }}\nx2 = {{ derivative = '{second}' }}\n\
         [inputs]\nu = {{}}\n[outputs]\ny = {{ value = 'x1', noise = {NOISE} }}\n[observer.{table}\n[target]\n\
         sample_time = 0.01\nscalar = 'f32'\n"
    );
    let generator = Generator::new(&text, &format!("{name}.toml"));
    let generated = generator.design().unwrap_or_else(|report| panic!("{}", report.render(false)));
    let output = Output::new(&generated, generator.source());
    (generated, output)
}

fn subject(plant: &Plant, gamma: [f64; 2], realization: &str) -> Subject {
    let name = format!("{}_{}", plant.name, realization.replace('-', "_"));
    let (generated, output) = designed(plant, &name, realization);
    Subject { name, generated, output, feedback: plant.feedback, gamma, noise: 0.0 }
}

fn corrector(plant: &Plant, gamma: [f64; 2], (mode, method, keys): (&str, &str, &str)) -> Subject {
    let name = format!("{}_{mode}", plant.name);
    let (generated, output) = observed(plant, &name, &format!("{method}]\n{keys}"));
    Subject { name, generated, output, feedback: plant.feedback, gamma, noise: NOISE }
}

/// What a held input does in one interval: with least squares `M_1 = (I - K_0 C) Gamma`, solved for Gamma.
fn gamma(least_squares: &Generated) -> [f64; 2] {
    let fir = least_squares.design.fir.as_ref().expect("weights");
    let (k, m) = (&fir.k[0], &fir.m[1]);
    // C = [1 0]: the first column of I - K_0 C is changed, the second is not.
    let first = m[0][0] / (1.0 - k[0][0]);
    [first, m[1][0] + k[1][0] * first]
}

impl Subject {
    fn file(&self) -> &str {
        let name = format!("{}.rs", self.name);
        &self.output.files().iter().find(|file| file.name == name).expect("the Rust file").text
    }

    /// Per state, for a sample or input of magnitude 1: the step's round-off, and what rounding the samples does.
    fn bounds(&self) -> Vec<f64> {
        if self.generated.design.estimator.downcast_ref::<Corrector>().is_some() {
            let bounds = &self.generated.design.certificate.error_bound;
            return bounds.iter().map(|bound| bound.expect("the noise is declared")).collect();
        }
        let functional = self.generated.design.estimator.downcast_ref::<Functional>().expect("a window");
        let load = functional.way.load().cloned().unwrap_or_else(|| functional.load(&self.generated.plant));
        let rounded = f64::from(f32::EPSILON) / 2.0;
        let noise = &self.generated.design.certificate.noise_gain_l1;
        load.round_off.iter().zip(noise).map(|(own, gains)| own + rounded * gains.iter().sum::<f64>()).collect()
    }

    /// A run beside the plant; prints the largest error of each state as a share of its bound.
    fn driver(&self) -> String {
        let functional_matrix = |letter: &str| {
            &self.generated.design.constants.iter().find(|m| m.letter == letter).expect("a matrix of the design").rows
        };
        let phi = functional_matrix("Phi");
        let gamma = self.gamma;
        let [f1, f2] = self.feedback;
        let bounds = self.bounds();
        // The bounds of a sum over samples are for samples of 1; the printed bound is one.
        let grows = u8::from(self.noise == 0.0);
        let sensed = matches!(self.generated.design.convergence, Convergence::Sensed { .. });
        let steps = self.generated.design.valid_from_step;
        format!(
            "
mod {name} {{
    include!(concat!(env!(\"OBSERVERS\"), \"/{name}_body.rs\"));
}}

fn run_{name}(calls: u64) -> [f64; 2] {{
    let mut observer = {name}::Observer::new();
    let (mut x, mut u, mut seed) = ([0.4_f64, 0.1_f64], 0.0_f32, 88_172_645_463_325_252_u64);
    let (mut worst, mut size, mut recent) = ([0.0_f64; 2], 1.0_f64, 0);
    let (mut noise, mut said) = (2_685_821_657_736_338_717_u64, 0_u64);
    for call in 0..calls {{
        noise ^= noise << 13;
        noise ^= noise >> 7;
        noise ^= noise << 17;
        let y = (x[0] + {level:?} * ((noise >> 11) as f64 / 4_503_599_627_370_496.0 - 1.0)) as f32;
        if {grows} == 1 {{
            size = size.max(x[0].abs()).max(f64::from(u).abs());
        }}
        let estimate = observer.step({name}::Measurements {{ y }}, {name}::Inputs {{ u }});
        let converged = estimate.status == ::deadbeat::Status::Converged;
        if call >= {steps} && (converged || !{sensed}) {{
            assert!(converged);
            said += 1;
            worst[0] = worst[0].max((f64::from(estimate.x1) - x[0]).abs());
            worst[1] = worst[1].max((f64::from(estimate.x2) - x[1]).abs());
        }}
        recent += 1;
        if recent == 50 {{
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            recent = 0;
        }}
        let excitation = (seed >> 11) as f64 / 4_503_599_627_370_496.0 - 1.0;
        u = (excitation + {f1:?} * x[0] + {f2:?} * x[1]) as f32;
        let v = f64::from(u);
        x = [
            {a:?} * x[0] + {b:?} * x[1] + {g:?} * v,
            {c:?} * x[0] + {d:?} * x[1] + {h:?} * v,
        ];
    }}
    assert!(said * 10 > calls * 9);
    [worst[0] / ({b1:?} * size), worst[1] / ({b2:?} * size)]
}}
",
            name = self.name,
            // The rest of the declared noise is the rounding of samples, and the step's: 1e-6, for samples of up to 8.
            level = 0.999 * self.noise,
            a = phi[0][0],
            b = phi[0][1],
            c = phi[1][0],
            d = phi[1][1],
            g = gamma[0],
            h = gamma[1],
            b1 = bounds[0],
            b2 = bounds[1],
        )
    }
}

/// Compiles a run of every subject into one program.
fn program(folder: &Path, subjects: &[Subject]) -> PathBuf {
    let mut main = String::from("//! Runs observers beside their plants.\n");
    for subject in subjects {
        // A file that is included as a module has no inner documentation.
        let body: Vec<&str> = subject.file().lines().filter(|line| !line.starts_with("//!")).collect();
        put(&folder.join(format!("{}_body.rs", subject.name)), &body.join("\n"));
        main += &subject.driver();
    }
    main += "\nfn main() {\n    let mut arguments = std::env::args().skip(1);\n    \
             let name = arguments.next().expect(\"a name\");\n    \
             let calls: u64 = arguments.next().expect(\"calls\").parse().expect(\"a number\");\n    \
             let worst = match name.as_str() {\n";
    for Subject { name, .. } in subjects {
        let _ = writeln!(main, "        \"{name}\" => run_{name}(calls),");
    }
    main += "        _ => panic!(\"no such observer\"),\n    };\n    println!(\"{} {}\", worst[0], worst[1]);\n}\n";
    put(&folder.join("main.rs"), &main);
    let rustc = || {
        let mut rustc = Command::new("rustc");
        rustc.args(["--edition=2024", "-O", "--cap-lints=allow", "-L"]).arg(folder).arg("--out-dir").arg(folder);
        rustc.env("OBSERVERS", folder);
        rustc
    };
    for (name, path) in [("deadbeat_math", "math/src/lib.rs"), ("deadbeat", "src/lib.rs")] {
        let mut library = rustc();
        library.args(["--crate-type=rlib", "--crate-name", name]).arg(root().join("runtime").join(path));
        library.args((name == "deadbeat").then_some("--extern=deadbeat_math"));
        succeed(&mut library);
    }
    succeed(rustc().args(["--crate-name", "endurance", "--extern=deadbeat"]).arg(folder.join("main.rs")));
    folder.join("endurance")
}

fn endure(test: &str, calls: u64) {
    let of_plant = |plant: &Plant| {
        let gamma = gamma(&designed(plant, plant.name, "fir").0);
        let windows = REALIZATIONS.map(|it| subject(plant, gamma, it)).into_iter();
        windows.chain(CORRECTORS.map(|it| corrector(plant, gamma, it))).collect::<Vec<_>>()
    };
    let subjects: Vec<Subject> = side_by_side(&PLANTS, of_plant).into_iter().flatten().collect();
    let program = program(&empty_folder(test), &subjects);
    let printed = side_by_side(&subjects, |subject| {
        succeed(Command::new(&program).args([subject.name.as_str(), &calls.to_string()]))
    });
    for (Subject { name, .. }, printed) in subjects.iter().zip(printed) {
        println!("{name}: {} of the bound after {calls} calls", printed.trim());
        let shares: Vec<f64> = printed.split_whitespace().map(|share| share.parse().expect("a number")).collect();
        // A step that gave nothing would be right here too if the plant stood still.
        assert!(shares.iter().all(|share| (1e-6..=1.0).contains(share)), "{name}: {shares:?} of the bound");
    }
}

/// A hundred thousand calls.
#[test]
fn no_realisation_wears_out() {
    endure("endurance", 100_000);
}

/// Ten million calls.
#[test]
#[ignore = "about half a minute"]
fn no_realisation_wears_out_over_ten_million_calls() {
    endure("endurance_long", 10_000_000);
}
