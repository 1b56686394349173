//! Letters and signs that a keyboard for formulas has and a name or an expression cannot, and what is written for them.

/// The names of Greek letters, small ones; a capital one's begins with a capital.
const GREEK: [(char, &str); 25] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('µ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
];

/// How a letter is spelt in ASCII; nothing for one that is not known.
#[must_use]
pub fn spelt(letter: char) -> Option<String> {
    let small = letter.to_lowercase().next()?;
    let name = match small {
        'ϕ' => "phi",
        'ϑ' => "theta",
        'ϵ' => "epsilon",
        'ä' => "ae",
        'ö' => "oe",
        'ü' => "ue",
        'ß' => "ss",
        'é' | 'è' | 'ê' => "e",
        'à' | 'á' | 'â' | 'å' => "a",
        _ => GREEK.iter().find(|(greek, _)| *greek == small)?.1,
    };
    let capital = small != letter && letter.is_uppercase();
    Some(if capital { name[..1].to_ascii_uppercase() + &name[1..] } else { name.to_owned() })
}

/// A name with its letters spelt in ASCII, where one of them is not and all of those are known; subscripts as digits.
#[must_use]
pub fn spelt_out(name: &str) -> Option<String> {
    if name.is_ascii() {
        return None;
    }
    let mut ascii = String::new();
    for c in name.chars() {
        match c {
            '₀'..='₉' => ascii.push(char::from_digit(u32::from(c) - u32::from('₀'), 10)?),
            c if c.is_ascii() => ascii.push(c),
            c => ascii += &spelt(c)?,
        }
    }
    Some(ascii)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names of formulas have a spelling; what has none is left.
    #[test]
    fn letters_are_spelt() {
        for (name, ascii) in [("θ", "theta"), ("Ω", "Omega"), ("θ₁", "theta1"), ("dφ", "dphi"), ("Δx", "Deltax")]
        {
            assert_eq!(spelt_out(name).as_deref(), Some(ascii));
        }
        assert_eq!(spelt_out("theta"), None);
        assert_eq!(spelt_out("角"), None);
    }
}
