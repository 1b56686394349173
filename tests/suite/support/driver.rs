//! The main functions that run a batch of observers one after the other: each reads its samples
//! from the input and writes its answers to the output, as raw numbers.

use deadbeat_codegen::internals::emit::Door;
use deadbeat_codegen::program::{Field, Kind, Program, Scalar};

use super::{Case, restart};

/// All C files as one.
pub fn all(cases: &[Case]) -> String {
    let includes = cases.iter().map(|it| format!("#include \"{}.c\"\n", it.program.name));
    includes.collect::<Vec<_>>().concat()
}

/// One line of text for each field.
fn each<'f>(fields: impl IntoIterator<Item = &'f Field>, line: impl Fn(&str) -> String) -> String {
    fields.into_iter().map(|field| line(&field.name)).collect::<Vec<_>>().concat()
}

/// The type of a field in Rust.
fn r#type(field: &Field, scalar: Scalar) -> String {
    match field.kind {
        Kind::Float => scalar.to_string(),
        Kind::Count { bits, signed } => format!("{}{bits}", if signed { 'i' } else { 'u' }),
        Kind::Index => "u32".to_owned(),
    }
}

/// The fields of the estimate.
fn estimates(program: &Program) -> impl Iterator<Item = &Field> {
    program.estimates.iter().map(|(field, _)| field)
}

/// A C main function that runs the batch's observers one after the other.
pub fn c(batch: usize, cases: &[Case]) -> String {
    let runs = cases.iter().map(c_run).collect::<Vec<_>>().concat();
    let calls = cases.iter().map(|it| format!("    run_{}();\n", it.program.name)).collect::<Vec<_>>().concat();
    format!(
        "#include <stdio.h>
#include <stdlib.h>
#include \"all_{batch}.c\"

static void get(void *to, size_t size)
{{
    if (fread(to, size, 1, stdin) != 1) {{
        exit(1);
    }}
}}

static void put(const void *from, size_t size)
{{
    if (fwrite(from, size, 1, stdout) != 1) {{
        exit(1);
    }}
}}
{runs}
int main(void)
{{
{calls}    return 0;
}}
"
    )
}

/// The C function that runs one observer.
fn c_run(case: &Case) -> String {
    let Case { program, samples } = case;
    let (name, count) = (&program.name, samples.len());
    let get = |of: &str, fields| each(fields, |field| format!("        get(&{of}.{field}, sizeof {of}.{field});\n"));
    let measurements = get("measurements", &program.measurements);
    let inputs = get("inputs", &program.inputs);
    let estimates =
        each(estimates(program), |field| format!("        put(&estimate.{field}, sizeof estimate.{field});\n"));
    let again = restart(case).map_or(String::new(), |call| {
        format!(
            "        if (call == {call}) {{
            {name}_init_at(&state, &estimate);
        }}
"
        )
    });
    let (declared, passed) = if program.inputs.is_empty() {
        (String::new(), "")
    } else {
        (format!("    {name}_inputs inputs;\n"), "&inputs, ")
    };
    format!(
        "
static void run_{name}(void)
{{
    {name}_state state;
    {name}_measurements measurements;
{declared}    {name}_estimate estimate;
    int call;
    {name}_init(&state);
    for (call = 0; call < {count}; ++call) {{
        unsigned char status;
{again}{measurements}{inputs}        {name}_step(&state, &measurements, {passed}&estimate);
{estimates}        status = (unsigned char)estimate.status;
        put(&status, sizeof status);
    }}
}}
"
    )
}

/// Every second Rust file is included, the others are modules.
pub fn door(at: usize) -> Door {
    if at.is_multiple_of(2) { Door::File } else { Door::Include }
}

/// The declaration of a Rust file's module.
fn module(at: usize, Case { program, .. }: &Case) -> String {
    let name = &program.name;
    match door(at) {
        Door::File => format!("pub mod {name};\n"),
        Door::Include => format!("pub mod {name} {{\n    include!(\"{name}.rs\");\n}}\n"),
    }
}

/// A Rust main function that runs the batch's observers one after the other.
pub fn rust(cases: &[Case]) -> String {
    let modules: Vec<String> = cases.iter().enumerate().map(|(at, case)| module(at, case)).collect();
    let modules = modules.concat();
    let runs = cases.iter().map(rust_run).collect::<Vec<_>>().concat();
    format!(
        "use std::io::{{Read, Write}};

{modules}
fn get<const N: usize>(input: &mut impl Read) -> [u8; N] {{
    let mut raw = [0; N];
    input.read_exact(&mut raw).unwrap();
    raw
}}

fn main() {{
    let mut input = std::io::BufReader::new(std::io::stdin());
    let mut output = std::io::BufWriter::new(std::io::stdout());
{runs}}}
"
    )
}

/// The Rust statements that run one observer.
fn rust_run(case: &Case) -> String {
    let Case { program, samples } = case;
    let (name, scalar, count) = (&program.name, program.scalar, samples.len());
    let get = |fields: &[Field]| -> String {
        let one = |it: &Field| format!("{}: {}::from_ne_bytes(get(&mut input)), ", it.name, r#type(it, scalar));
        fields.iter().map(one).collect()
    };
    let measurements = get(&program.measurements);
    let inputs = get(&program.inputs);
    let passed = if program.inputs.is_empty() { String::new() } else { format!(", {name}::Inputs {{ {inputs} }}") };
    let estimates = each(estimates(program), |field| {
        format!("        output.write_all(&estimate.{field}.to_ne_bytes()).unwrap();\n")
    });
    let (last, call, again, kept) = match restart(case) {
        None => (String::new(), "_", String::new(), ""),
        Some(call) => (
            "    let mut last = None;\n".to_owned(),
            "call",
            format!(
                "        if let (Some(last), {call}) = (last, call) {{
            observer = {name}::Observer::at(last);
        }}
"
            ),
            "        last = Some(estimate);\n",
        ),
    };
    format!(
        "    let mut observer = {name}::Observer::default();
{last}    for {call} in 0..{count} {{
{again}        let estimate = observer.step({name}::Measurements {{ {measurements} }}{passed});
{estimates}        output.write_all(&[estimate.status as u8]).unwrap();
{kept}    }}
"
    )
}
