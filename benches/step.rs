//! How long a generated C step takes, against what a user would write by hand: arrays that are shifted by
//! one each sample, and a double loop over constant matrices.
//!
//! `cargo bench --bench step`. Both run alternately in one process, the same flags, the same samples; the
//! figure to look at is the ratio of the medians, since machines differ and are noisy.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use deadbeat_codegen::promise::Fir;
use deadbeat_codegen::{Generator, Language};

/// Compilers and flags that are tried; a compiler that is not there is named and left out.
const BUILDS: [(&str, &[&str]); 6] = [
    ("gcc", &["-Os"]),
    ("gcc", &["-O2"]),
    ("gcc", &["-O3", "-march=native"]),
    ("clang", &["-Os"]),
    ("clang", &["-O2"]),
    ("clang", &["-O3", "-march=native"]),
];

fn main() {
    let folder = env::temp_dir().join(format!("deadbeat-step-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a temporary folder");
    println!("{:<24} {:>12} {:>12} {:>8}", "one step of", "generated", "by hand", "ratio");
    for name in ["pendulum", "dc_motor"] {
        measure(name, &folder);
    }
    fs::remove_dir_all(&folder).expect("the temporary folder goes");
}

fn measure(name: &str, folder: &Path) {
    let spec = format!("{}/specs/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let generator = Generator::new(&fs::read_to_string(&spec).expect("a specification of the corpus"), &spec);
    let generated = generator.design().expect("the corpus designs");
    let output = generator.generate().expect("the corpus generates").only(&[Language::C]);
    output.write_to(folder).expect("the generated files");
    let input = !generated.plant.inputs.is_empty();
    let text = by_hand(name, generated.design.fir.as_ref().expect("a window has weights"), input);
    fs::write(folder.join("main.c"), text).expect("the program");
    for (compiler, flags) in BUILDS {
        let program = folder.join("step");
        let sources = [folder.join("main.c"), folder.join(format!("{name}.c"))];
        let built = Command::new(compiler).args(flags).args(&sources).arg("-o").arg(&program).arg("-lm").status();
        let label = format!("{name}, {compiler} {}", flags[0]);
        if !built.is_ok_and(|status| status.success()) {
            println!("{label:<24} not there");
            continue;
        }
        let times = Command::new(&program).output().expect("the program runs").stdout;
        let times = String::from_utf8(times).expect("two numbers");
        let times: Vec<f64> = times.split_whitespace().map(|t| t.parse().expect("nanoseconds")).collect();
        println!("{label:<24} {:>9.1} ns {:>9.1} ns {:>8.2}", times[0], times[1], times[1] / times[0]);
    }
}

/// A matrix of weights, ages by states.
fn matrix(name: &str, weights: &[Vec<Vec<f64>>], column: usize) -> String {
    let states = weights[0].len();
    let mut text = format!("static const float {name}[{}][{states}] = {{\n", weights.len());
    for age in weights {
        #[expect(clippy::cast_possible_truncation, reason = "the comparison is in single precision")]
        let row: Vec<String> = age.iter().map(|state| format!("{:e}f", state[column] as f32)).collect();
        let _ = writeln!(text, "    {{{}}},", row.join(", "));
    }
    text + "};\n"
}

/// The plain step and a program that times both.
fn by_hand(name: &str, fir: &Fir, input: bool) -> String {
    let (ages, states) = (fir.k.len(), fir.k[0].len());
    let mut text = format!(
        "#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#include <time.h>\n#include \"{name}.h\"\n"
    );
    text += &matrix("K", &fir.k, 0);
    for (column, _) in fir.known.iter().enumerate() {
        text += &matrix(&format!("M{column}"), &fir.m, column);
    }
    let sine = fir.known.iter().position(|known| known.starts_with("sin")).expect("both plants have a sine");
    let fill = |column: usize| if column == sine { "sinf(y)" } else { "u" };
    let _ = writeln!(text, "static float ys[{ages}], ws[{}][{ages}];", fir.known.len());
    text += "static void plain(float y, float u, float *x)\n{\n    (void)u;\n";
    text += "    memmove(ys + 1, ys, sizeof ys - sizeof ys[0]); ys[0] = y;\n";
    for (column, _) in fir.known.iter().enumerate() {
        // A held input since the last sample is of age 1.
        let first = usize::from(column != sine);
        let _ = writeln!(
            text,
            "    memmove(ws[{column}] + 1, ws[{column}], sizeof ws[0] - sizeof ws[0][0]); ws[{column}][{first}] = {};",
            fill(column)
        );
    }
    let _ = writeln!(text, "    for (int i = 0; i < {states}; ++i) {{\n        float sum = 0.0f;");
    let _ = writeln!(text, "        for (int j = 0; j < {ages}; ++j) sum += K[j][i] * ys[j];");
    for (column, _) in fir.known.iter().enumerate() {
        let _ = writeln!(text, "        for (int j = 0; j < {ages}; ++j) sum += M{column}[j][i] * ws[{column}][j];");
    }
    text += "        x[i] = sum;\n    }\n}\n";
    let call = if input { "&m, &u, &e" } else { "&m, &e" };
    let (declare, value) =
        if input { (format!("{name}_inputs u = {{0.5f}};"), "u.u") } else { (String::new(), "0.0f") };
    let _ = write!(
        text,
        "static double now(void) {{ struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return 1e9 * (double)t.tv_sec + (double)t.tv_nsec; }}
static int rising(const void *a, const void *b) {{ double x = *(const double *)a, y = *(const double *)b; return (x > y) - (x < y); }}
int main(void)
{{
    enum {{ ROUNDS = 41, CALLS = 5000 }};
    static {name}_state state; {name}_estimate e; {declare} float x[{states}];
    volatile float sink = 0.0f; double ours[ROUNDS], plain_[ROUNDS];
    {name}_init(&state);
    for (int round = 0; round < ROUNDS; ++round) {{
        double a = now();
        for (int k = 0; k < CALLS; ++k) {{ {name}_measurements m = {{0.01f * (float)(k % 100)}}; {name}_step(&state, {call}); sink += (float)e.status; }}
        double b = now();
        for (int k = 0; k < CALLS; ++k) {{ plain(0.01f * (float)(k % 100), {value}, x); sink += x[0]; }}
        double c = now();
        ours[round] = (b - a) / CALLS; plain_[round] = (c - b) / CALLS;
    }}
    qsort(ours, ROUNDS, sizeof ours[0], rising); qsort(plain_, ROUNDS, sizeof plain_[0], rising);
    printf(\"%f %f\\n\", ours[ROUNDS / 2], plain_[ROUNDS / 2]);
    return 0;
}}
"
    );
    text
}
