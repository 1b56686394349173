//! Claim: the C twins give the bits of the Rust functions, with every compiler at hand, and each compiles cleanly alone.

#![expect(clippy::cast_possible_truncation, reason = "bits move between words of known range")]

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use super::super::closure;

type Single = fn(f32, f32) -> f32;
type Double = fn(f64, f64) -> f64;

/// A function in both widths; with one argument it ignores the second.
struct Pair {
    name: &'static str,
    arguments: usize,
    single: Single,
    double: Double,
}

macro_rules! unary {
    ($name:literal, $single:ident, $double:ident) => {
        Pair {
            name: $name,
            arguments: 1,
            single: |x, _| deadbeat_math::$single(x),
            double: |x, _| deadbeat_math::$double(x),
        }
    };
}

macro_rules! binary {
    ($name:literal, $single:ident, $double:ident) => {
        Pair { name: $name, arguments: 2, single: deadbeat_math::$single, double: deadbeat_math::$double }
    };
}

const PAIRS: &[Pair] = &[
    unary!("sin", sin_f32, sin_f64),
    unary!("cos", cos_f32, cos_f64),
    unary!("tan", tan_f32, tan_f64),
    unary!("asin", asin_f32, asin_f64),
    unary!("acos", acos_f32, acos_f64),
    unary!("atan", atan_f32, atan_f64),
    binary!("atan2", atan2_f32, atan2_f64),
    unary!("exp", exp_f32, exp_f64),
    unary!("log", log_f32, log_f64),
    unary!("sqrt", sqrt_f32, sqrt_f64),
    unary!("tanh", tanh_f32, tanh_f64),
    binary!("pow", pow_f32, pow_f64),
];

const WARNINGS: &[&str] =
    &["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Werror"];
const C_ONLY: &[&str] = &["-std=c99", "-Wundef", "-Wcast-qual", "-Wstrict-prototypes"];
const SPEEDS: &[&[&str]] = &[&["-O0"], &["-O2"], &["-O3", "-march=native"]];

/// The compilers at hand; one that `DEADBEAT_REQUIRE` lists must be there.
fn compilers() -> Vec<&'static str> {
    let required = env::var("DEADBEAT_REQUIRE").unwrap_or_default();
    let mut found = Vec::new();
    for name in ["gcc", "clang"] {
        if Command::new(name).arg("--version").output().is_ok_and(|it| it.status.success()) {
            found.push(name);
            continue;
        }
        assert!(!required.split(',').any(|wanted| wanted == name), "{name} is required");
        println!("{name} is missing: not compared");
    }
    found
}

/// The functions of these names and everything that they require, as the emitter writes it.
fn source(names: &[String]) -> String {
    let mut text = String::from("#include <stdint.h>\n");
    for part in closure(names.iter().cloned().collect()) {
        text.push('\n');
        text.push_str(part.text);
    }
    text
}

fn workplace(name: &str) -> PathBuf {
    let path = env::temp_dir().join(format!("deadbeat-twin-{}-{name}", std::process::id()));
    fs::create_dir_all(&path).expect("a temporary directory");
    path
}

fn run(command: &mut Command) {
    let output = command.output().expect("the command starts");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{message}");
}

/// A program that writes, for all functions and arguments of a file, the bits of the results.
fn program() -> String {
    let names: Vec<String> =
        PAIRS.iter().flat_map(|pair| ["f32", "f64"].map(|width| format!("{}_{width}", pair.name))).collect();
    let mut text = String::from("#include <stdio.h>\n");
    text.push_str(&source(&names));
    text.push_str(
        "\nstatic void put(FILE *out, uint64_t bits)\n{\n    fwrite(&bits, sizeof bits, 1, out);\n}\n\n\
         static void all(FILE *out, const uint64_t *word)\n{\n\
         const double x = deadbeat_f64_from_bits(word[0]);\n\
         const double y = deadbeat_f64_from_bits(word[1]);\n\
         const float u = deadbeat_f32_from_bits((uint32_t)word[2]);\n\
         const float v = deadbeat_f32_from_bits((uint32_t)word[3]);\n",
    );
    for pair in PAIRS {
        let (wide, narrow) = if pair.arguments == 1 { ("x", "u") } else { ("x, y", "u, v") };
        let name = pair.name;
        writeln!(text, "put(out, deadbeat_f64_to_bits(deadbeat_{name}_f64({wide})));").unwrap();
        writeln!(text, "put(out, deadbeat_f32_to_bits(deadbeat_{name}_f32({narrow})));").unwrap();
    }
    text.push_str(
        "}\n\nint main(int count, char **names)\n{\n    uint64_t word[4];\n    FILE *in;\n    FILE *out;\n\
         if (count != 3) {\n        return 1;\n    }\n    in = fopen(names[1], \"rb\");\n\
         out = fopen(names[2], \"wb\");\n    if (!in || !out) {\n        return 2;\n    }\n\
         while (fread(word, sizeof word, 1, in) == 1) {\n        all(out, word);\n    }\n\
         return fclose(out);\n}\n",
    );
    text
}

/// Pseudo-random bits (xorshift).
struct Dice(u64);

impl Dice {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    /// Any digits and sign, an exponent within `reach` of that of 1.
    fn realistic(&mut self, reach: u64) -> f64 {
        let field = 1023 - reach + self.bits() % (2 * reach);
        f64::from_bits((self.bits() & 0x800F_FFFF_FFFF_FFFF) | (field << 52))
    }
}

/// The arguments x, y of both widths: specials crossed, random bits, realistic sizes.
fn arguments(count: usize) -> Vec<[u64; 4]> {
    let specials = [
        0.0,
        f64::from_bits(1),
        f64::MIN_POSITIVE,
        1e-300,
        1e-40,
        1e-20,
        1e-5,
        0.125,
        0.25,
        0.5,
        std::f64::consts::FRAC_PI_4,
        0.999_999_999_999,
        1.0,
        std::f64::consts::FRAC_PI_2,
        1.5,
        2.0,
        3.0,
        std::f64::consts::PI,
        10.0,
        88.722_83,
        103.972_1,
        127.0,
        1e5,
        16_777_217.0,
        1e10,
        1e22,
        1e38,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    let signed: Vec<f64> = specials.iter().flat_map(|&x| [x, -x]).collect();
    let word = |x: f64, y: f64| {
        let (u, v) = (x as f32, y as f32);
        [x.to_bits(), y.to_bits(), u64::from(u.to_bits()), u64::from(v.to_bits())]
    };
    let mut all: Vec<[u64; 4]> = signed.iter().flat_map(|&x| signed.iter().map(move |&y| word(x, y))).collect();
    let mut dice = Dice(0x0123_4567_89AB_CDEF);
    while all.len() < count {
        all.push([dice.bits(), dice.bits(), dice.bits() >> 32, dice.bits() >> 32]);
        all.push(word(dice.realistic(8), dice.realistic(8)));
        all.push(word(dice.realistic(2), dice.realistic(30)));
    }
    all
}

fn rust_results(arguments: &[[u64; 4]]) -> Vec<u64> {
    let mut results = Vec::new();
    for word in arguments {
        let (x, y) = (f64::from_bits(word[0]), f64::from_bits(word[1]));
        let (u, v) = (f32::from_bits(word[2] as u32), f32::from_bits(word[3] as u32));
        for pair in PAIRS {
            results.push((pair.double)(x, y).to_bits());
            results.push(u64::from((pair.single)(u, v).to_bits()));
        }
    }
    results
}

fn compare(place: &Path, compiler: &str, speed: &[&str], arguments: &[[u64; 4]], expected: &[u64]) {
    let binary = place.join(format!("{compiler}{}", speed.concat()));
    run(Command::new(compiler)
        .args(C_ONLY)
        .args(WARNINGS)
        .args(speed)
        .arg("-ffp-contract=off")
        .arg(place.join("twin.c"))
        .arg("-o")
        .arg(&binary));
    let output = binary.with_extension("out");
    run(Command::new(&binary).arg(place.join("arguments")).arg(&output));
    let bytes = fs::read(&output).expect("the results");
    assert_eq!(bytes.len(), expected.len() * 8);
    for (i, (chunk, &wanted)) in bytes.chunks_exact(8).zip(expected).enumerate() {
        let got = u64::from_ne_bytes(chunk.try_into().expect("eight bytes"));
        let word = arguments[i / (2 * PAIRS.len())];
        let name = PAIRS[i / 2 % PAIRS.len()].name;
        assert_eq!(got, wanted, "{compiler} {speed:?} {name} {word:X?}: {got:X} but {wanted:X}");
    }
    println!("{compiler} {speed:?}: {} results equal", expected.len());
}

/// Claim: 100 thousand arguments, special and random, give the same bits in both languages at every level.
#[test]
fn c_gives_the_bits_of_rust() {
    let place = workplace("twin");
    let arguments = arguments(100_000);
    let expected = rust_results(&arguments);
    let bytes: Vec<u8> = arguments.iter().flatten().flat_map(|word| word.to_ne_bytes()).collect();
    fs::write(place.join("arguments"), bytes).expect("the arguments");
    fs::write(place.join("twin.c"), program()).expect("the program");
    for compiler in compilers() {
        for speed in SPEEDS {
            compare(&place, compiler, speed, &arguments, &expected);
        }
    }
    fs::remove_dir_all(&place).expect("the directory goes");
}

/// Claim: each function with what it requires is all that a compiler wants, without a warning, in C and in C++.
#[test]
fn each_function_alone_compiles_cleanly_as_c_and_as_cpp() {
    let place = workplace("alone");
    for compiler in compilers() {
        for pair in PAIRS {
            for (width, kind) in [("f32", "float"), ("f64", "double")] {
                let name = format!("{}_{width}", pair.name);
                let (parameters, values) = if pair.arguments == 1 {
                    (format!("{kind} x"), "x")
                } else {
                    (format!("{kind} x, {kind} y"), "x, y")
                };
                let mut text = source(std::slice::from_ref(&name));
                writeln!(text, "\n{kind} use({parameters});\n{kind} use({parameters})\n{{").unwrap();
                writeln!(text, "    return deadbeat_{name}({values});\n}}").unwrap();
                let file = place.join(format!("{name}.c"));
                fs::write(&file, text).expect("the source");
                let object = file.with_extension("o");
                let compile = |language: &str, flags: &[&str]| {
                    run(Command::new(compiler)
                        .args(["-c", "-O1", "-ffp-contract=off", "-x", language])
                        .args(flags)
                        .args(WARNINGS)
                        .arg(&file)
                        .arg("-o")
                        .arg(&object));
                };
                compile("c", C_ONLY);
                compile("c++", &[]);
            }
        }
    }
    fs::remove_dir_all(&place).expect("the directory goes");
}
