//! Units as they are written, and what they are in SI units, exactly.
//!
//! Knows the text of a unit. Never knows what a quantity is.
//!
//! A unit keeps the words of its text, so that messages speak the user's language; two units are compared by what the
//! words are in SI units. A word that is none of `words` is a unit of its own, such as `count` or `px`.

mod read;
mod words;

use std::collections::BTreeMap;
use std::fmt;

use dashu_ratio::RBig;

use words::{PREFIXES, Powers, WORDS, Word};

pub use read::Unreadable;

/// A power of a word is a whole number of these: square and cube roots stay exact.
const PARTS: i32 = 12;
/// Largest power of a word; it bounds the sizes that are computed.
const MOST: i32 = 99;

/// A product of powers of words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unit {
    /// Each with its power, in twelfths; never 0.
    powers: BTreeMap<String, i32>,
}

/// A unit in SI units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Si {
    /// Powers of the base units, in twelfths.
    base: Powers,
    /// Powers of words that are units of their own, in twelfths.
    own: BTreeMap<String, i32>,
    /// The size, as powers of rationals and of pi: a root of a size is seldom a rational.
    size: BTreeMap<RBig, i32>,
    pi: i32,
}

impl Unit {
    /// One word.
    pub fn word(name: &str) -> Self {
        Self { powers: BTreeMap::from([(name.to_owned(), PARTS)]) }
    }

    /// Reads text such as `rad/(V s^2)`, `kg·m²`, `1/s`.
    pub fn parse(text: &str) -> Result<Self, Unreadable> {
        read::read(text)
    }

    /// The product with another unit's power, given as a fraction; `None` where the power is not a whole number of
    /// twelfths, or beyond bounds.
    pub fn times(&self, other: &Self, (over, under): (i32, i32)) -> Option<Self> {
        let mut powers = self.powers.clone();
        for (word, power) in &other.powers {
            let scaled = power.checked_mul(over).filter(|scaled| scaled % under == 0)? / under;
            let sum = powers.entry(word.clone()).or_insert(0);
            *sum = sum.checked_add(scaled).filter(|sum| sum.abs() <= MOST * PARTS)?;
        }
        powers.retain(|_, power| *power != 0);
        Some(Self { powers })
    }

    /// In SI units.
    pub fn si(&self) -> Si {
        let mut si = Si { base: [0; 7], own: BTreeMap::new(), size: BTreeMap::new(), pi: 0 };
        for (word, power) in &self.powers {
            si.take(word, *power);
        }
        si.settle();
        si
    }
}

impl Si {
    fn take(&mut self, name: &str, power: i32) {
        let Some((word, tens)) = meaning(name) else {
            *self.own.entry(singular(name).to_owned()).or_insert(0) += power;
            return;
        };
        for (base, own) in self.base.iter_mut().zip(word.powers) {
            *base += own * power;
        }
        let (over, under, pi) = word.size;
        self.pi += pi * power;
        self.scale(RBig::from_parts(over.into(), under.unsigned_abs().into()), power);
        self.scale(RBig::from(10), tens * power);
    }

    fn scale(&mut self, size: RBig, power: i32) {
        *self.size.entry(size).or_insert(0) += power;
    }

    /// Whole powers of sizes are one rational; what is no whole power stays apart.
    fn settle(&mut self) {
        let mut whole = RBig::ONE;
        let mut apart = BTreeMap::new();
        for (size, power) in std::mem::take(&mut self.size) {
            whole *= size.pow(power.div_euclid(PARTS) as isize);
            if power.rem_euclid(PARTS) != 0 && size != RBig::ONE {
                apart.insert(size, power.rem_euclid(PARTS));
            }
        }
        apart.insert(whole, PARTS);
        self.size = apart;
        self.own.retain(|_, power| *power != 0);
    }

    /// Whether both measure the same kind of quantity.
    pub fn alike(&self, other: &Self) -> bool {
        self.base == other.base && self.own == other.own
    }

    /// Whether it is a plain number.
    pub fn is_number(&self) -> bool {
        self.base == [0; 7] && self.own.is_empty()
    }

    /// Whether words that are units of their own have part in it.
    pub fn has_own(&self) -> bool {
        !self.own.is_empty()
    }

    /// How many of `other` are one of this, as a rational times a power of pi; `None` where that is no such number.
    pub fn in_terms_of(&self, other: &Self) -> Option<(RBig, i32)> {
        let whole = |si: &Self| match si.size.iter().next() {
            Some((size, _)) if si.size.len() == 1 && si.pi % PARTS == 0 => Some(size.clone()),
            _ => None,
        };
        self.alike(other).then_some(())?;
        Some((whole(self)? / whole(other)?, (self.pi - other.pi) / PARTS))
    }
}

/// The word and the power of ten before it.
fn meaning(name: &str) -> Option<(&'static Word, i32)> {
    let plain = |name: &str| WORDS.iter().find(|word| word.name == name || word.name == singular(name));
    let prefixed = |(prefix, tens): &(&str, i32)| {
        let rest = name.strip_prefix(prefix)?;
        WORDS.iter().find(|word| word.prefixed && word.name == rest).map(|word| (word, *tens))
    };
    plain(name).map(|word| (word, 0)).or_else(|| PREFIXES.iter().find_map(prefixed))
}

/// `counts` is `count`.
fn singular(name: &str) -> &str {
    name.strip_suffix('s').filter(|rest| rest.chars().count() > 2).unwrap_or(name)
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let product = |sign: i32| {
            let factors = self.powers.iter().filter(|(_, power)| power.signum() == sign);
            factors.map(|(word, power)| factor(word, power.abs())).collect::<Vec<_>>()
        };
        let (over, under) = (product(1), product(-1));
        let top = if over.is_empty() { "1".to_owned() } else { over.join(" ") };
        match under.as_slice() {
            [] => write!(f, "{top}"),
            [one] => write!(f, "{top}/{one}"),
            many => write!(f, "{top}/({})", many.join(" ")),
        }
    }
}

fn factor(word: &str, power: i32) -> String {
    match power {
        PARTS => word.to_owned(),
        _ if power % PARTS == 0 => format!("{word}^{}", power / PARTS),
        _ => {
            let whole = RBig::from_parts(power.into(), PARTS.unsigned_abs().into());
            format!("{word}^({whole})")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn si(text: &str) -> Si {
        Unit::parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}")).si()
    }

    /// Texts that name one unit in different words are equal; these are definitions of the SI brochure.
    #[test]
    fn the_same_unit_in_other_words() {
        for (one, other) in [
            ("N", "kg m/s^2"),
            ("N m/(kg m^2)", "rad/s²"),
            ("V", "W/A"),
            ("Wb", "V s"),
            ("ohm", "V/A"),
            ("kΩ", "1000 ohm"),
            ("H/ohm", "s"),
            ("F ohm", "s"),
            ("J", "N·m"),
            ("rad/(A s^2)", "rad/A/s/s"),
            ("1/s", "Hz"),
            ("s^-1", "s-1"),
            ("m2", "m^2"),
            ("km/h", "km hr^-1"),
            ("counts/s", "count/s"),
            ("m/s^2", "(m/s)/s"),
            ("V/sqrt(Hz)", "V Hz^-0.5"),
            ("kg^(1/2)", "sqrt(kg)"),
            ("-", "1"),
            ("", "rad"),
            ("[m]", "m"),
        ] {
            assert_eq!(si(one), si(other), "{one} against {other}");
        }
    }

    /// Units of one kind differ by an exact factor.
    #[test]
    fn factors_are_exact() {
        let cases: [(&str, &str, i64, u64, i32); 11] = [
            ("deg", "rad", 1, 180, 1),
            ("rpm", "rad/s", 1, 30, 1),
            ("rpm", "deg/s", 6, 1, 0),
            ("ms", "s", 1, 1_000, 0),
            ("rad/(s ms)", "rad/s^2", 1_000, 1, 0),
            ("km/h", "m/s", 5, 18, 0),
            ("Ah", "C", 3_600, 1, 0),
            ("mbar", "hPa", 1, 1, 0),
            ("kWh", "MJ", 18, 5, 0),
            ("%", "1", 1, 100, 0),
            ("l/min", "m^3/s", 1, 60_000, 0),
        ];
        for (one, other, over, under, pi) in cases {
            let factor = si(one).in_terms_of(&si(other));
            assert_eq!(factor, Some((RBig::from_parts(over.into(), under.into()), pi)), "{one} in {other}");
        }
    }

    /// Another kind of quantity has no factor.
    #[test]
    fn kinds_differ() {
        for (one, other) in [("m", "rad/s"), ("counts", "rad"), ("K", "J"), ("counts", "px")] {
            assert_eq!(si(one).in_terms_of(&si(other)), None, "{one} against {other}");
        }
    }

    /// A text that can be read in two ways is not read, nor is one that is no unit.
    #[test]
    fn what_is_not_read() {
        for text in ["W/m K", "m/s*kg", "m^", "(m", "m)", "m^x", "3..4 m", "m^99999999999", "°°(", "/s", "a^1000"] {
            assert!(Unit::parse(text).is_err(), "{text}");
        }
    }

    /// A unit is shown in the words that it was written in.
    #[test]
    fn it_is_shown_in_its_words() {
        for (text, shown) in
            [("rad/(A s^2)", "rad/(A s^2)"), ("N m/rad/s", "N m/(rad s)"), ("1/s", "1/s"), ("kg·m²", "kg m^2")]
        {
            assert_eq!(Unit::parse(text).map(|unit| unit.to_string()), Ok(shown.to_owned()));
        }
    }
}
