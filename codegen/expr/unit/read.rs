//! The text of a unit: words, powers, products and quotients.

use super::{MOST, PARTS, Unit};

/// Longest text of a unit, in bytes: nothing that a person writes is longer, and depth is bounded by it.
const LONGEST: usize = 80;

/// Why a text is not a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// A product behind `/`: it may stand below the line or beside it.
    TwoWays,
    /// No unit at all.
    NoUnit,
}

type Read<T> = Result<T, Unreadable>;

pub(super) fn read(text: &str) -> Read<Unit> {
    let text = text.trim();
    let text = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or(text);
    if text.len() > LONGEST {
        return Err(Unreadable::NoUnit);
    }
    if text.is_empty() || text == "-" {
        return Ok(Unit::default());
    }
    let mut reader = Reader { rest: text };
    let unit = reader.quotient()?;
    if reader.rest.is_empty() { Ok(unit) } else { Err(Unreadable::NoUnit) }
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    /// Products, each but the first below a line of its own.
    fn quotient(&mut self) -> Read<Unit> {
        let (mut unit, _) = self.product()?;
        loop {
            self.blanks();
            if !self.skip("/") {
                return Ok(unit);
            }
            let (below, several) = self.product()?;
            if several {
                return Err(Unreadable::TwoWays);
            }
            unit = unit.times(&below, (-1, 1)).ok_or(Unreadable::NoUnit)?;
        }
    }

    /// Factors side by side, and whether there was more than one.
    fn product(&mut self) -> Read<(Unit, bool)> {
        let mut unit = self.power()?;
        let mut several = false;
        loop {
            self.blanks();
            let sign = ["**", "*", "·", "⋅", "."].into_iter().find(|sign| self.skip(sign));
            let ends = self.rest.is_empty() || self.rest.starts_with(['/', ')']);
            match (sign, ends) {
                (None, true) => return Ok((unit, several)),
                (Some("**"), _) | (Some(_), true) => return Err(Unreadable::NoUnit),
                _ => unit = unit.times(&self.power()?, (1, 1)).ok_or(Unreadable::NoUnit)?,
            }
            several = true;
        }
    }

    fn power(&mut self) -> Read<Unit> {
        self.blanks();
        let base = if self.skip("sqrt(") {
            let inner = self.quotient()?;
            self.close()?;
            Unit::default().times(&inner, (1, 2)).ok_or(Unreadable::NoUnit)?
        } else if self.skip("(") {
            let inner = self.quotient()?;
            self.close()?;
            inner
        } else if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            return self.number();
        } else {
            Unit::word(self.letters()?)
        };
        let power = self.exponent()?;
        Unit::default().times(&base, power).ok_or(Unreadable::NoUnit)
    }

    /// A power of ten before or among the words.
    fn number(&mut self) -> Read<Unit> {
        let digits = self.take(|c| c.is_ascii_digit());
        let zeros = digits.strip_prefix('1').filter(|zeros| zeros.bytes().all(|digit| digit == b'0'));
        let tens = zeros.and_then(|zeros| i32::try_from(zeros.len()).ok()).ok_or(Unreadable::NoUnit)?;
        if tens == 0 {
            return Ok(Unit::default());
        }
        Unit::default().times(&Unit::word("10"), (tens, 1)).ok_or(Unreadable::NoUnit)
    }

    fn letters(&mut self) -> Read<&'a str> {
        let word = self.take(|c| c.is_alphabetic() || matches!(c, '%' | '°' | '_' | 'µ' | '\u{2126}'));
        if word.is_empty() { Err(Unreadable::NoUnit) } else { Ok(word) }
    }

    /// `^2`, `^-1`, `^(1/2)`, `^0.5`, `2`, `-2`, `²`, `⁻¹`, or nothing.
    fn exponent(&mut self) -> Read<(i32, i32)> {
        const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let raised: Option<String> = self
            .take(|c| c == '⁻' || RAISED.contains(&c))
            .chars()
            .map(|c| match RAISED.iter().position(|digit| *digit == c) {
                Some(digit) => u32::try_from(digit).ok().and_then(|digit| char::from_digit(digit, 10)),
                None => Some('-'),
            })
            .collect();
        match raised {
            Some(digits) if !digits.is_empty() => return Ok((whole(&digits)?, 1)),
            _ => {}
        }
        let marked = self.skip("^") || self.skip("**");
        let wrapped = marked && self.skip("(");
        let power = match self.signed(marked) {
            "" if marked => return Err(Unreadable::NoUnit),
            "" => return Ok((1, 1)),
            digits => fraction(digits)?,
        };
        let under = if wrapped && self.skip("/") { whole(self.signed(true))? } else { 1 };
        if wrapped {
            self.close()?;
        }
        if under <= 0 { Err(Unreadable::NoUnit) } else { Ok((power.0, power.1 * under)) }
    }

    /// A number with its sign; a decimal point only behind `^`, since it is a product elsewhere.
    fn signed(&mut self, marked: bool) -> &'a str {
        let rest = self.rest;
        let digits = rest.strip_prefix('-').unwrap_or(rest);
        let sign = rest.len() - digits.len();
        let length = digits.find(|c: char| !(c.is_ascii_digit() || marked && c == '.')).unwrap_or(digits.len());
        if length == 0 {
            return "";
        }
        self.rest = &rest[sign + length..];
        &rest[..sign + length]
    }

    fn close(&mut self) -> Read<()> {
        self.blanks();
        if self.skip(")") { Ok(()) } else { Err(Unreadable::NoUnit) }
    }

    fn blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn skip(&mut self, sign: &str) -> bool {
        let rest = self.rest.strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn take(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !wanted(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }
}

fn whole(digits: &str) -> Read<i32> {
    digits.parse().ok().filter(|power: &i32| power.abs() <= MOST).ok_or(Unreadable::NoUnit)
}

/// A whole number, or a half.
fn fraction(digits: &str) -> Read<(i32, i32)> {
    match digits.split_once('.') {
        None => Ok((whole(digits)?, 1)),
        Some((before, "5")) => {
            let sign = if before.starts_with('-') { -1 } else { 1 };
            Ok((2 * whole(before)? + sign, 2))
        }
        Some(_) => Err(Unreadable::NoUnit),
    }
}

const _: () = assert!(PARTS % 2 == 0, "a half is a whole number of parts");
