//! What a user meant by a function that there is none of; never one that means something else.

use super::{Function, edit_distance};

/// Functions of other languages, and how to write them here.
const FOREIGN: [(&str, &str); 27] = [
    ("ln", "the natural logarithm is `log`"),
    ("pow power", "write powers with `^`: `a^b`"),
    ("fabs magnitude norm", "the magnitude is `abs`"),
    ("sqr square", "write powers with `^`: `x^2`"),
    ("exp10", "write `10^x`"),
    ("log1p", "write `log(1 + x)`"),
    ("expm1", "write `exp(x) - 1`"),
    ("sgn signum", "the sign is `sign`"),
    ("ceil ceiling", "write `-floor(-x)`"),
    ("round rint nint", "write `floor(x + 0.5)`"),
    ("trunc fix", "write `sign(x)*floor(abs(x))`"),
    ("mod fmod rem remainder", "write `a - b*floor(a/b)`"),
    ("arcsin", "write `asin`"),
    ("arccos", "write `acos`"),
    ("arctan", "write `atan`"),
    ("arctan2", "write `atan2`"),
    ("asinh arcsinh arsinh", "write `log(x + sqrt(x^2 + 1))`"),
    ("acosh arccosh arcosh", "write `log(x + sqrt(x^2 - 1))`"),
    ("atanh arctanh artanh", "write `0.5*log((1 + x)/(1 - x))`"),
    ("sinc", "write `sin(x)/x`, which has no value at 0"),
    ("cot cotan", "write `1/tan(x)`"),
    ("sec", "write `1/cos(x)`"),
    ("csc cosec", "write `1/sin(x)`"),
    ("sat saturate saturation limit clip", "write `clamp(x, low, high)`"),
    ("step heaviside", "write `(1 + sign(x))/2`"),
    ("if ifelse where select piecewise", "there are no conditions: write `min`, `max`, `clamp`, `abs` or `sign`"),
    ("der diff ddt d", "a derivative is a state: give it an equation of its own in [states]"),
];

/// How to go on behind "there is no function".
pub(super) fn instead_of(name: &str) -> String {
    let lower = name.to_ascii_lowercase();
    if let Some(same) = Function::names().find(|known| *known == lower) {
        return format!("did you mean `{same}`?");
    }
    let foreign = FOREIGN.iter().find(|(words, _)| words.split(' ').any(|word| word == lower));
    if let Some((_, help)) = foreign {
        return (*help).to_owned();
    }
    match slip(&lower) {
        Some(close) => format!("did you mean `{close}`?"),
        None => format!("the functions are {}", Function::names().collect::<Vec<_>>().join(", ")),
    }
}

/// The one function that a slip of the hand made the word of: two letters that changed places, or else one letter too
/// many or too few.
fn slip(word: &str) -> Option<&'static str> {
    let swapped = |known: &&str| {
        let apart = word.bytes().zip(known.bytes()).filter(|(a, b)| a != b).count();
        sorted(word) == sorted(known) && apart == 2
    };
    let longer = |known: &&str| edit_distance(word, known) == 1 && word.len() != known.len() && known.len() > 2;
    only(Function::names().filter(swapped)).or_else(|| only(Function::names().filter(longer)))
}

fn sorted(word: &str) -> Vec<u8> {
    let mut letters = word.as_bytes().to_vec();
    letters.sort_unstable();
    letters
}

fn only(mut found: impl Iterator<Item = &'static str>) -> Option<&'static str> {
    let first = found.next()?;
    found.next().is_none().then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slip is mended, and no function is proposed that means something else.
    #[test]
    fn nothing_else_is_proposed() {
        for (word, meant) in
            [("Sin", "sin"), ("SQRT", "sqrt"), ("sine", "sin"), ("tahn", "tanh"), ("sqt", "sqrt"), ("hypt", "hypot")]
        {
            assert_eq!(instead_of(word), format!("did you mean `{meant}`?"));
        }
        for word in ["cot", "ceil", "atanh", "log1p", "erf", "sinc", "lerp", "cis", "sun", "bar", "mix"] {
            assert!(!instead_of(word).contains("did you mean"), "{word}: {}", instead_of(word));
        }
        assert_eq!(instead_of("Ln"), "the natural logarithm is `log`");
    }
}
