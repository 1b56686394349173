//! Right-hand sides: what a user may write in an expression, exactly.
//!
//! Knows what can be written, names once they are given. Never knows what a name stands for.
//!
//! In: text in a literal string. Out: a syntax tree with spans ([`parse`]), and from it, once the
//! names are known, a tree of [`Node`]s, each with its canonical polynomial ([`Poly`]): decimals
//! are rationals, `b1*(i + 2*i)` is linear, `q^2 - q*q` vanishes. No float appears here.

pub mod bounds;
mod further;
mod guess;
pub mod node;
pub mod parse;
pub mod poly;
pub mod unit;
pub mod value;

pub use node::{Meaning, Names, Node, NodeKind, resolve};
pub use poly::{Atom, Constant, Monomial, Poly};

use std::fmt;

/// A function of the specification language; powers are written `^`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the language's")]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Exp,
    Log,
    Sqrt,
    Abs,
    Sign,
    Min,
    Max,
    Tanh,
    Pow,
    Log10,
    Log2,
    Exp2,
    Sinh,
    Cosh,
    Cbrt,
    Floor,
    Hypot,
}

/// A function that is written for `min(max(x, low), high)`.
pub const CLAMP: &str = "clamp";

impl Function {
    /// Those that can be called by name, with their number of arguments.
    pub const CALLABLE: [(&'static str, Self, usize); 23] = [
        ("sin", Self::Sin, 1),
        ("cos", Self::Cos, 1),
        ("tan", Self::Tan, 1),
        ("asin", Self::Asin, 1),
        ("acos", Self::Acos, 1),
        ("atan", Self::Atan, 1),
        ("atan2", Self::Atan2, 2),
        ("exp", Self::Exp, 1),
        ("log", Self::Log, 1),
        ("sqrt", Self::Sqrt, 1),
        ("abs", Self::Abs, 1),
        ("sign", Self::Sign, 1),
        ("min", Self::Min, 2),
        ("max", Self::Max, 2),
        ("tanh", Self::Tanh, 1),
        ("sinh", Self::Sinh, 1),
        ("cosh", Self::Cosh, 1),
        ("log10", Self::Log10, 1),
        ("log2", Self::Log2, 1),
        ("exp2", Self::Exp2, 1),
        ("cbrt", Self::Cbrt, 1),
        ("hypot", Self::Hypot, 2),
        ("floor", Self::Floor, 1),
    ];

    /// The names of all functions, as they can be called.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        Self::CALLABLE.iter().map(|entry| entry.0).chain([CLAMP])
    }

    /// The function of that name with its number of arguments.
    pub fn by_name(name: &str) -> Option<(Self, usize)> {
        Self::CALLABLE.iter().find(|entry| entry.0 == name).map(|entry| (entry.1, entry.2))
    }

    /// Its name; `pow` for the operator `^`.
    pub fn name(self) -> &'static str {
        Self::CALLABLE.iter().find(|entry| entry.1 == self).map_or("pow", |entry| entry.0)
    }
}

/// Something that varies: what an expression may name besides constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// Time since the first call, s.
    Time,
    /// A state, by its place.
    State(usize),
    /// An input, by its place.
    Input(usize),
    /// An unknown constant, by its place.
    Unknown(usize),
    /// A disturbance, by its place.
    Disturbance(usize),
}

/// Nearest word of `choices` for a "did you mean"; few edits away, so that something of the word is left.
pub fn nearest<'a>(word: &str, choices: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let allowed = match word.len() {
        0..=3 => 1,
        4..=8 => 2,
        _ => 3,
    };
    let close = |choice: &str| {
        let distance = edit_distance(word, choice);
        let shorter = word.len().min(choice.len());
        // Of three letters, another one in the place of one makes another word.
        let another = word.len() == 3 && choice.len() == 3;
        (distance <= allowed && distance < shorter && !another) || word.eq_ignore_ascii_case(choice)
    };
    let common = |choice: &str| word.bytes().zip(choice.bytes()).take_while(|(a, b)| a == b).count();
    choices.into_iter().filter(|choice| close(choice)).min_by_key(|choice| {
        let same = word.eq_ignore_ascii_case(choice);
        (!same, edit_distance(word, choice), usize::MAX - common(choice), *choice)
    })
}

/// How many letters have to be inserted, removed or replaced to turn `a` into `b` (Levenshtein).
pub fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, cb) in b.iter().enumerate() {
            let changed = diagonal + usize::from(ca != *cb);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

/// A list of names for a message: `a`, `b` and `c`.
pub struct List<'a>(pub &'a [&'a str]);

impl fmt::Display for List<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, name) in self.0.iter().enumerate() {
            let link = match place {
                0 => "",
                _ if place + 1 == self.0.len() => " and ",
                _ => ", ",
            };
            write!(f, "{link}`{name}`")?;
        }
        Ok(())
    }
}
