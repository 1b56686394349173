//! Drivers in C, C++ and Rust that run every observer of the corpus in one program.
//!
//! Each feeds the same numbers (xorshift64, drawn as in `corpus::Random`) and prints, for each
//! observer, a hash over the bits of all answers of two instances: equal text is equal bits.

#![allow(dead_code, reason = "each test uses its part of this")]

use std::fmt::Write as _;

use deadbeat_codegen::program::{CellKind, Field, Kind, Scalar};

use super::corpus::{Span, Subject};

/// Calls of each instance.
const STEPS: usize = 1_500;

/// What all C drivers begin with.
const C_HEAD: &str = "\
/* The bits of random numbers. */
static uint64_t draw(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return *seed;
}

/* A missing sample now and then, else a number of the span. Every product is exact. */
static double number(uint64_t *seed, double centre, double amplitude)
{
    const uint64_t bits = draw(seed);
    if ((bits & 1023U) == 0U) {
        return (double)NAN;
    }
    return centre + amplitude * (2.0 * ((double)(bits >> 11) / 9007199254740992.0) - 1.0);
}

/* A number as a count, 64 for each unit; nothing for a missing one. */
static int32_t count(double number)
{
    return (-1e6 <= number && number <= 1e6) ? (int32_t)(64.0 * number) : 0;
}

/* FNV-1a. */
static void mix(uint64_t *hash, const void *from, size_t size)
{
    const unsigned char *bytes = (const unsigned char *)from;
    size_t at;
    for (at = 0; at < size; ++at) {
        *hash = (*hash ^ bytes[at]) * UINT64_C(0x100000001b3);
    }
}
";

/// What they end with; `steps` of two instances, alone, by turns, and copied in mid-run.
fn c_main(subjects: &[Subject]) -> String {
    let mut text = String::from("\nint main(void)\n{\n    int failed = 0;\n    int step;\n");
    for Subject { name, .. } in subjects {
        let _ = writeln!(text, "    static run_{name} {name}_alone[2], {name}_turn[2], {name}_copy;");
    }
    for Subject { name, .. } in subjects {
        let _ = write!(
            text,
            "    begin_{name}(&{name}_alone[0], 1U);
    begin_{name}(&{name}_alone[1], 2U);
    begin_{name}(&{name}_turn[0], 1U);
    begin_{name}(&{name}_turn[1], 2U);
    for (step = 0; step < {STEPS}; ++step) {{
        go_{name}(&{name}_alone[0]);
    }}
    for (step = 0; step < {STEPS}; ++step) {{
        go_{name}(&{name}_alone[1]);
    }}
"
        );
    }
    let _ = writeln!(text, "    for (step = 0; step < {STEPS}; ++step) {{");
    for Subject { name, .. } in subjects {
        let _ = write!(
            text,
            "        go_{name}(&{name}_turn[0]);
        go_{name}(&{name}_turn[1]);
        if (step == {}) {{
            memcpy(&{name}_copy, &{name}_turn[0], sizeof {name}_copy);
        }} else if (step > {}) {{
            go_{name}(&{name}_copy);
        }}
",
            STEPS / 2,
            STEPS / 2
        );
    }
    text += "    }\n";
    for Subject { name, .. } in subjects {
        let _ = write!(
            text,
            "    if ({name}_alone[0].hash != {name}_turn[0].hash || {name}_alone[1].hash != {name}_turn[1].hash) {{
        fprintf(stderr, \"{name}: two instances disturb each other\\n\");
        failed = 1;
    }}
    if ({name}_alone[0].hash != {name}_copy.hash) {{
        fprintf(stderr, \"{name}: a copy has another future\\n\");
        failed = 1;
    }}
    printf(\"{name} %016llx %016llx %d\\n\", (unsigned long long){name}_alone[0].hash,
           (unsigned long long){name}_alone[1].hash, {name}_alone[0].converged);
"
        );
    }
    text + "    return failed;\n}\n"
}

/// The header of each observer.
fn includes(subjects: &[Subject]) -> String {
    subjects.iter().fold(String::new(), |text, it| text + "#include \"" + &it.name + ".h\"\n")
}

/// One program in C.
pub fn together(subjects: &[Subject]) -> String {
    let mut text = String::from("#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n\n");
    text += &includes(subjects);
    text = text + "\n" + C_HEAD;
    for subject in subjects {
        text += &c_run(subject);
    }
    text + &c_main(subjects)
}

/// The same in C++, with what C++ can say of the types.
pub fn together_in_cpp(subjects: &[Subject]) -> String {
    let mut text = String::from(
        "#include <cmath>\n#include <cstdint>\n#include <cstdio>\n#include <cstring>\n#include <type_traits>\n\n\
         using std::size_t;\n\n",
    );
    text += &includes(subjects);
    text += "\n#undef NAN\n#define NAN __builtin_nan(\"\")\n";
    text += C_HEAD;
    for subject in subjects {
        let name = &subject.name;
        text += "\n";
        let mut kinds = vec!["measurements", "estimate", "state"];
        if !subject.generated.program.inputs.is_empty() {
            kinds.push("inputs");
        }
        for kind in kinds {
            let _ = writeln!(
                text,
                "static_assert(std::is_trivial<{name}_{kind}>::value && std::is_standard_layout<{name}_{kind}>::value \
                 && !std::is_empty<{name}_{kind}>::value, \"plain data\");"
            );
        }
        let inputs = if subject.generated.program.inputs.is_empty() {
            String::new()
        } else {
            format!("const {name}_inputs *, ")
        };
        let _ = writeln!(
            text,
            "static_assert(std::is_same<decltype(&{name}_step), void (*)({name}_state *, const {name}_measurements *, \
             {inputs}{name}_estimate *)>::value, \"const-correct\");"
        );
        text += &c_run(subject);
    }
    text + &c_main(subjects)
}

/// An observer with its numbers and its hash, in C and C++.
fn c_run(subject: &Subject) -> String {
    let (name, program) = (&subject.name, &subject.generated.program);
    let has_inputs = !program.inputs.is_empty();
    let declared = if has_inputs {
        format!("    {name}_inputs inputs;\n    const {name}_inputs *applied = &inputs;\n")
    } else {
        String::new()
    };
    let passed = if has_inputs { "applied, " } else { "" };
    let fill = c_fill(subject, "number(&run->seed, CENTRE, AMPLITUDE)");
    let hashed = estimates(subject, |name| format!("    mix(&run->hash, &estimate.{name}, sizeof estimate.{name});\n"));
    let upper = name.to_uppercase();
    format!(
        "
typedef struct {{
    {name}_state state;
    uint64_t seed;
    uint64_t hash;
    int converged;
}} run_{name};

static void begin_{name}(run_{name} *run, uint64_t seed)
{{
    {name}_init(&run->state);
    run->seed = seed * UINT64_C(0x9e3779b97f4a7c15) | 1U;
    run->hash = UINT64_C(0xcbf29ce484222325);
    run->converged = 0;
}}

static void go_{name}(run_{name} *run)
{{
    {name}_measurements measurements;
    const {name}_measurements *measured = &measurements;
{declared}    {name}_estimate estimate;
    unsigned char status;
{fill}    {name}_step(&run->state, measured, {passed}&estimate);
{hashed}    status = (unsigned char)estimate.status;
    mix(&run->hash, &status, sizeof status);
    run->converged += estimate.status == {upper}_CONVERGED ? 1 : 0;
}}
"
    )
}

/// The statements that fill measurements, then inputs.
fn c_fill(subject: &Subject, number: &str) -> String {
    let scalar = match subject.scalar() {
        Scalar::F32 => "float",
        Scalar::F64 => "double",
    };
    let fill = |of: &str, field: &Field, span: Span| {
        let number = number
            .replace("CENTRE", &format!("{:?}", span.centre))
            .replace("AMPLITUDE", &format!("{:?}", span.amplitude));
        match field.kind {
            Kind::Count { bits, signed } => {
                format!("    {of}.{} = ({}int{bits}_t)count({number});\n", field.name, if signed { "" } else { "u" })
            }
            Kind::Float | Kind::Index => format!("    {of}.{} = ({scalar}){number};\n", field.name),
        }
    };
    each(subject, fill)
}

/// A line for each measurement, then for each input.
fn each(subject: &Subject, line: impl Fn(&str, &Field, Span) -> String) -> String {
    let program = &subject.generated.program;
    let measured =
        program.measurements.iter().zip(subject.measured()).map(|(field, span)| line("measurements", field, span));
    let applied = program.inputs.iter().zip(subject.applied()).map(|(field, span)| line("inputs", field, span));
    measured.chain(applied).collect()
}

/// A line for each estimate.
fn estimates(subject: &Subject, line: impl Fn(&str) -> String) -> String {
    subject.generated.program.estimates.iter().map(|(field, _)| line(&field.name)).collect()
}

/// The same in Rust: the binary of a crate whose library has every observer as a module.
pub fn together_in_rust(subjects: &[Subject]) -> String {
    let mut text = String::from(
        "//! Runs every observer of the crate, two instances of each by turns.

use deadbeat::{Observer, Status};

fn draw(seed: &mut u64) -> u64 {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    *seed
}

fn number(seed: &mut u64, centre: f64, amplitude: f64) -> f64 {
    let bits = draw(seed);
    if bits & 1023 == 0 {
        return f64::NAN;
    }
    centre + amplitude * (2.0 * ((bits >> 11) as f64 / 9_007_199_254_740_992.0) - 1.0)
}

/// A number as a count, 64 for each unit; nothing for a missing one.
fn count(number: f64) -> i32 {
    if (-1e6..=1e6).contains(&number) { (64.0 * number) as i32 } else { 0 }
}

fn mix(hash: &mut u64, bytes: &[u8]) {
    for byte in bytes {
        *hash = (*hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    }
}

/// Generic code over the trait.
#[derive(Clone, Copy)]
struct Run<O> {
    observer: O,
    seed: u64,
    hash: u64,
    converged: u32,
}

impl<O: Observer + Default + Copy> Run<O> {
    fn new(seed: u64) -> Self {
        let seed = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        Self { observer: O::default(), seed, hash: 0xcbf2_9ce4_8422_2325, converged: 0 }
    }

    fn go(&mut self, feed: impl Fn(&mut u64) -> (O::Measurements, O::Inputs), read: impl Fn(&O::Estimate, &mut u64) -> Status) {
        let (measurements, inputs) = feed(&mut self.seed);
        let estimate = self.observer.step(measurements, inputs);
        let status = read(&estimate, &mut self.hash);
        mix(&mut self.hash, &[status as u8]);
        self.converged += u32::from(status == Status::Converged);
    }
}

fn run<O: Observer + Default + Copy>(
    name: &str,
    feed: impl Fn(&mut u64) -> (O::Measurements, O::Inputs),
    read: impl Fn(&O::Estimate, &mut u64) -> Status,
) {
    let mut alone = [Run::<O>::new(1), Run::new(2)];
    let mut turn = alone;
    for run in &mut alone {
        (0..STEPS).for_each(|_| run.go(&feed, &read));
    }
    let mut copy = turn[0];
    for step in 0..STEPS {
        turn.iter_mut().for_each(|run| run.go(&feed, &read));
        if step == STEPS / 2 {
            copy = turn[0];
        } else if step > STEPS / 2 {
            copy.go(&feed, &read);
        }
    }
    assert_eq!(alone.map(|it| it.hash), turn.map(|it| it.hash), \"{name}: two instances disturb each other\");
    assert_eq!(alone[0].hash, copy.hash, \"{name}: a copy has another future\");
    println!(\"{name} {:016x} {:016x} {}\", alone[0].hash, alone[1].hash, alone[0].converged);
}

",
    );
    let _ = writeln!(text, "const STEPS: usize = {STEPS};\n\nfn main() {{");
    for subject in subjects {
        let (name, program, scalar) = (&subject.name, &subject.generated.program, subject.scalar());
        let narrowed = if scalar == Scalar::F32 { " as f32" } else { "" };
        let fill = |of: &'static str| {
            each(subject, |which, field, span| {
                if which != of {
                    return String::new();
                }
                rust_field(field, span, narrowed)
            })
        };
        let inputs = if program.inputs.is_empty() {
            "()".to_owned()
        } else {
            format!("contract::{name}::Inputs {{ {}}}", fill("inputs"))
        };
        let hashed = estimates(subject, |name| format!("mix(hash, &estimate.{name}.to_ne_bytes()); "));
        let _ = writeln!(
            text,
            "    run::<contract::{name}::Observer>(\"{name}\", |seed| (contract::{name}::Measurements {{ {}}}, {inputs}), \
             |estimate, hash| {{ {hashed}estimate.status }});",
            fill("measurements")
        );
    }
    text + "}\n"
}

/// A field of a struct with its number.
fn rust_field(field: &Field, span: Span, narrowed: &str) -> String {
    let number = format!("number(seed, {:?}, {:?})", span.centre, span.amplitude);
    match field.kind {
        Kind::Count { bits, signed } => {
            format!("{}: count({number}) as {}{bits}, ", field.name, if signed { "i" } else { "u" })
        }
        Kind::Float | Kind::Index => format!("{}: {number}{narrowed}, ", field.name),
    }
}

/// A C program that feeds every observer bits of every kind, then nothing to the unstable ones, and
/// looks at estimate and state after each call. Arguments: steps of each.
pub fn abuse(subjects: &[Subject], unstable: &[&str], phase: impl Fn(&Subject) -> usize) -> String {
    let mut text = String::from(
        "#include <float.h>\n#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n\n",
    );
    text += &includes(subjects);
    text = text + "\n" + C_HEAD;
    for scalar in ["float", "double"] {
        let _ = write!(
            text,
            "
static {scalar} any_{scalar}(uint64_t *seed, long phase, double centre, double amplitude)
{{
    const uint64_t bits = draw(seed);
    const {scalar} plausible = ({scalar})number(seed, centre, amplitude);
    {scalar} any;
    memcpy(&any, &bits, sizeof any);
    switch (phase % 4) {{
    case 0:
        return plausible;
    case 1:
        return any;
    case 2:
        return (bits >> 40) % 8U == 0U ? any : plausible;
    default:
        return ({scalar})NAN;
    }}
}}
"
        );
    }
    for subject in subjects {
        text += &c_abuse(subject, phase(subject));
    }
    text += "\nint main(int count, char **arguments)\n{\n    long steps;\n    long gone;\n    if (count != 3) {\n        return 3;\n    }\n    steps = atol(arguments[1]);\n    gone = atol(arguments[2]);\n";
    for subject in subjects {
        let _ = writeln!(text, "    abuse_{}(steps, 0);", subject.name);
        if unstable.contains(&subject.stem.as_str()) {
            let _ = writeln!(text, "    abuse_{}(gone, 1);", subject.name);
        }
    }
    text + "    return 0;\n}\n"
}

fn c_abuse(subject: &Subject, phase: usize) -> String {
    let (name, program) = (&subject.name, &subject.generated.program);
    let scalar = if subject.scalar() == Scalar::F32 { "float" } else { "double" };
    let (declared, passed) = if program.inputs.is_empty() {
        (String::new(), "")
    } else {
        (format!("    {name}_inputs inputs;\n"), "&inputs, ")
    };
    let fill = each(subject, |of, field, span| {
        let line = |step: &str| {
            format!(
                "{of}.{} = any_{scalar}(&seed, {step} / {phase}, {:?}, {:?});\n",
                field.name, span.centre, span.amplitude
            )
        };
        if let Kind::Count { bits, signed } = field.kind {
            // It has no bits but counts, and cannot be gone.
            let sign = if signed { "" } else { "u" };
            format!("        {of}.{} = ({sign}int{bits}_t)draw(&seed);\n", field.name)
        } else if of == "measurements" {
            format!(
                "        {}        if (gone && step > {}) {{ {of}.{} = ({scalar})NAN; }}\n",
                line("(gone ? 0 : step)"),
                2 * phase,
                field.name
            )
        } else {
            format!("        {}", line("(gone ? 0 : step)"))
        }
    });
    let mut checks = String::new();
    for (field, _) in program.estimates.iter().filter(|(field, _)| field.kind == Kind::Float) {
        let _ = writeln!(checks, "        fine = fine && isfinite(estimate.{});", field.name);
    }
    for cell in &program.cells {
        match cell.kind {
            CellKind::Float { .. } => drop(writeln!(checks, "        fine = fine && isfinite(state.{});", cell.name)),
            CellKind::Ring { len, .. } => {
                let at = format!("        fine = fine && isfinite(state.{}[step % {len}]);", cell.name);
                let _ = writeln!(checks, "{at}");
            }
            CellKind::Index { .. } | CellKind::Counts { .. } => {}
        }
    }
    format!(
        "
static void abuse_{name}(long steps, int gone)
{{
    {name}_state state;
    uint64_t seed = 88172645463325252U;
    long step;
    {name}_init(&state);
    for (step = 0; step < steps; ++step) {{
        {name}_measurements measurements;
    {declared}        {name}_estimate estimate;
        int fine = 1;
{fill}        {name}_step(&state, &measurements, {passed}&estimate);
{checks}        fine = fine && (unsigned)estimate.status <= 2U;
        if (!fine) {{
            fprintf(stderr, \"{name}: not finite at step %ld\\n\", step);
            exit(1);
        }}
    }}
}}
"
    )
}
