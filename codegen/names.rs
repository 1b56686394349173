//! Every rule about names in generated code.
//!
//! Knows what Rust and C can carry. Never knows what a name stands for.
//!
//! A user's name becomes a field of a struct, without its capitals, and nothing else: it cannot meet a local, a
//! parameter or a function. What stands at file scope is the generator's, and carries the
//! specification's name in C: `pendulum_step`, `PENDULUM_WINDOW`.

use crate::program::{Program, Statement, Table, TableId, Value};

/// The names of one Program's output.
pub(super) struct Names {
    /// The specification's name.
    pub lower: String,
    /// The same in upper case.
    pub upper: String,
    tables: Vec<String>,
    /// Digits of the largest value's number, where it has more than two.
    digits: usize,
}

/// Names at file scope that are the generator's, without the prefix that they have in C.
const OWN: [&str; 5] = ["H", "SAMPLE_TIME", "CONVERGING", "CONVERGED", "COASTING"];

impl Names {
    /// The names of a Program; some are taken by what a language needs beside it.
    pub fn new(program: &Program, is_taken: impl Fn(&str) -> bool) -> Self {
        let mut tables: Vec<String> = vec![];
        for Table { name, .. } in &program.tables {
            let numbered = (2..).map(|number: u32| format!("{name}_{number}"));
            let mut candidates = std::iter::once(name.clone()).chain(numbered);
            let is_free = |name: &String| !OWN.contains(&name.as_str()) && !is_taken(name) && !tables.contains(name);
            let free = candidates.find(is_free);
            tables.push(free.unwrap_or_else(|| unreachable!("there are names without end")));
        }
        let largest = largest(&program.body).to_string().len();
        let digits = if largest > 2 { largest } else { 0 };
        Self { lower: program.name.clone(), upper: program.name.to_ascii_uppercase(), tables, digits }
    }

    /// A table's name, the same in both languages but for the prefix.
    pub fn table(&self, table: TableId) -> &str {
        &self.tables[usize::from(table.0)]
    }

    /// A table's name with its prefix.
    pub fn prefixed_table(&self, table: TableId) -> String {
        format!("{}_{}", self.upper, self.table(table))
    }

    /// The name of a temporary in Rust, all of one length: `t46` and `t146` would be too similar for clippy.
    pub fn temporary(&self, value: Value) -> String {
        format!("t{:0digits$}", value.0, digits = self.digits)
    }

    /// A part of the elementary functions in C with this prefix in place of its own.
    pub fn adopt(&self, source: &str) -> String {
        source.replace("deadbeat_", &format!("{}_", self.lower)).replace("DEADBEAT_", &format!("{}_", self.upper))
    }
}

/// The largest number of a value.
fn largest(body: &[Statement]) -> u32 {
    let of = |statement: &Statement| match statement {
        Statement::Let { value, .. } => value.0,
        Statement::Loop(inner) => {
            inner.carried.iter().map(|carried| carried.value.0).fold(largest(&inner.body), u32::max)
        }
        _ => 0,
    };
    body.iter().map(of).max().unwrap_or(0)
}

/// The name of a temporary in C.
pub(super) fn temporary(value: Value) -> String {
    value.to_string()
}

/// The name of the function at this place; the step itself has its own.
pub(super) fn part(place: usize) -> String {
    format!("part_{}", place + 1)
}

/// The nearest name in `snake_case`: `dTheta` is `d_theta`, `Motor-1` is `motor_1`.
#[must_use]
pub fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut before_is_lower = false;
    for c in name.chars() {
        if c.is_ascii_uppercase() && before_is_lower {
            snake.push('_');
        }
        snake.push(if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' });
        before_is_lower = c.is_ascii_lowercase() || c.is_ascii_digit();
    }
    let words: Vec<&str> = snake.split('_').filter(|word| !word.is_empty()).collect();
    let joined = words.join("_");
    if joined.starts_with(|c: char| c.is_ascii_alphabetic()) { joined } else { format!("x{joined}") }
}

/// The field of generated structs that stands for a user's name: the same without capitals, `t_1` for `T_1`.
///
/// Where that would be another thing's name, as `t` the time's, it gets `cap_` in front.
#[must_use]
pub fn field(name: &str) -> String {
    if !name.contains(|c: char| c.is_ascii_uppercase()) {
        return name.to_owned();
    }
    let snake = snake_case(name);
    if snake == "t" || reserved(&snake).is_some() { format!("cap_{snake}") } else { snake }
}

/// Why a field cannot be called as a type of the header is, to be read behind "`name` is": in C++ a member's name hides
/// the type's. `specification` is the prefix of the header's own types.
#[must_use]
pub fn type_of_the_header(specification: &str, field: &str) -> Option<&'static str> {
    const OF_STDINT: &str = "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t intptr_t uintptr_t intmax_t \
        uintmax_t size_t ptrdiff_t max_align_t nullptr_t";
    const OWN: [&str; 5] = ["state", "measurements", "inputs", "estimate", "status"];
    if OF_STDINT.split_whitespace().any(|name| name == field) {
        return Some("a type of the C library, and a C++ compiler would take it for the field");
    }
    let own = field.strip_prefix(specification)?.strip_prefix('_')?;
    OWN.contains(&own).then_some("a type of the generated header, and a C++ compiler would take it for the field")
}

/// Why a name cannot be a field, to be read behind "`name` is"; nothing if it can.
#[must_use]
pub fn reserved(name: &str) -> Option<&'static str> {
    if name.starts_with('_') {
        return Some("a name of the C implementation, as all that begin with an underscore are");
    }
    let table = RESERVED.iter().find(|(words, _)| words.split_whitespace().any(|word| word == name));
    table.map(|(_, why)| *why)
}

/// Why a name cannot be the specification's, which names files and prefixes symbols.
#[must_use]
pub fn reserved_for_a_file(name: &str) -> Option<&'static str> {
    let is_header = C_HEADERS.split_whitespace().any(|header| header == name);
    reserved(name).or(is_header.then_some("the name of a header of the C library"))
}

/// Words that no field may be called, and why.
const RESERVED: [(&str, &str); 5] = [
    (
        "abstract as async await become box break const continue crate do dyn else enum extern \
         false final fn for gen if impl in let loop macro match mod move mut override priv pub ref \
         return self Self static struct super trait true try type typeof unsafe unsized use \
         virtual where while yield",
        "a keyword of Rust",
    ),
    (
        "alignas alignof asm auto bool case char constexpr default double float goto inline int \
         long nullptr register restrict short signed sizeof static_assert switch thread_local \
         typedef typeof_unqual union unsigned void volatile",
        "a keyword of C",
    ),
    (
        "and and_eq bitand bitor catch char16_t char32_t char8_t class co_await co_return co_yield \
         compl concept const_cast consteval constinit decltype delete dynamic_cast explicit export \
         friend mutable namespace new noexcept not not_eq operator or or_eq private protected \
         public reinterpret_cast requires static_cast template this throw typeid typename using \
         wchar_t xor xor_eq",
        "a keyword of C++",
    ),
    (
        "cdecl complex errno far huge hyper i386 imaginary interface linux mips near noreturn \
         pascal small sparc stderr stdin stdout sun unix",
        "a macro of widespread C compilers or headers",
    ),
    ("status", "a field that every estimate has"),
];

/// The headers of the C library: a file of that name would stand in front of them.
const C_HEADERS: &str = "assert complex ctype errno fenv float inttypes iso646 limits locale math \
    setjmp signal stdalign stdarg stdatomic stdbool stdckdint stddef stdint stdio stdlib \
    stdnoreturn string tgmath threads time uchar wchar wctype";

#[cfg(test)]
mod tests {
    use super::*;

    /// Claim: no name in the proposed form is refused for its form again.
    #[test]
    fn proposes_snake_case() {
        let cases =
            [("dTheta", "d_theta"), ("Motor-1", "motor_1"), ("_x__y_", "x_y"), ("2nd", "x2nd"), ("I", "i"), ("", "x")];
        for (name, snake) in cases {
            assert_eq!(snake_case(name), snake);
        }
    }

    /// Claim: a field has no capitals, and is never another thing's name.
    #[test]
    fn fields_have_no_capitals() {
        for (name, snake) in
            [("F", "f"), ("T1", "t1"), ("dTheta", "d_theta"), ("q", "q"), ("T", "cap_t"), ("Int", "cap_int")]
        {
            assert_eq!(field(name), snake);
            assert!(reserved(&field(name)).is_none());
        }
        assert!(type_of_the_header("motor", "uint32_t").is_some_and(|why| why.starts_with("a type of the C library")));
        assert!(type_of_the_header("motor", "motor_estimate").is_some());
        assert!(type_of_the_header("motor", "motor_speed").is_none());
    }

    /// Claim: each kind of reserved word is told apart, and ordinary names are free.
    #[test]
    fn tells_why() {
        let why = |name| reserved(name).unwrap_or("free");
        assert_eq!(why("gen"), "a keyword of Rust");
        assert_eq!(why("double"), "a keyword of C");
        assert_eq!(why("xor"), "a keyword of C++");
        assert_eq!(why("linux"), "a macro of widespread C compilers or headers");
        assert_eq!(why("status"), "a field that every estimate has");
        for name in ["row", "state", "t0", "gains", "inputs", "estimate", "self_", "y"] {
            assert_eq!(why(name), "free");
        }
        assert_eq!(reserved_for_a_file("stdint"), Some("the name of a header of the C library"));
    }
}
