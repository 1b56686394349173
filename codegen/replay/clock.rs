//! Times as recordings write them: the names of their columns, their units, stamps of the calendar.

use std::fmt;

/// The unit of a recording's time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TimeUnit {
    /// s
    #[default]
    Seconds,
    /// ms
    Milliseconds,
    /// us
    Microseconds,
    /// ns
    Nanoseconds,
    /// min
    Minutes,
    /// h
    Hours,
}

impl TimeUnit {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Seconds, Self::Milliseconds, Self::Microseconds, Self::Nanoseconds, Self::Minutes, Self::Hours];

    /// Its sign.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Seconds => "s",
            Self::Milliseconds => "ms",
            Self::Microseconds => "us",
            Self::Nanoseconds => "ns",
            Self::Minutes => "min",
            Self::Hours => "h",
        }
    }

    /// The unit that a word means, in any case: its sign or its name.
    pub fn named(word: &str) -> Option<Self> {
        Some(match word.to_lowercase().as_str() {
            "s" | "sec" | "secs" | "second" | "seconds" => Self::Seconds,
            "ms" | "msec" | "msecs" | "millis" | "millisecond" | "milliseconds" => Self::Milliseconds,
            "us" | "µs" | "μs" | "usec" | "usecs" | "micros" | "microsecond" | "microseconds" => Self::Microseconds,
            "ns" | "nsec" | "nsecs" | "nanos" | "nanosecond" | "nanoseconds" => Self::Nanoseconds,
            "min" | "mins" | "minute" | "minutes" => Self::Minutes,
            "h" | "hour" | "hours" => Self::Hours,
            _ => return None,
        })
    }

    /// A time of this unit, s.
    pub fn seconds(self, time: f64) -> f64 {
        // Divisors are exact, their inverses are not.
        match self {
            Self::Seconds => time,
            Self::Milliseconds => time / 1e3,
            Self::Microseconds => time / 1e6,
            Self::Nanoseconds => time / 1e9,
            Self::Minutes => time * 60.0,
            Self::Hours => time * 3600.0,
        }
    }

    /// The unit that the name of a column of times ends in, as in `Time (ms)`, `t [us]` and `stamp_ns`.
    pub fn of_column(name: &str) -> Option<Self> {
        let words = words(name);
        let (last, first) = words.split_last()?;
        let glued = ["timestamp", "time"].into_iter().find_map(|base| last.strip_prefix(base));
        Self::named(last).or_else(|| glued.filter(|_| first.is_empty()).and_then(Self::named))
    }

    /// The unit that a cell below a column's name means, as in `ms`, `[ms]` and `(ms)`.
    pub fn of_cell(cell: &str) -> Option<Self> {
        match words(cell).as_slice() {
            [unit] => Self::named(unit),
            _ => None,
        }
    }
}

impl fmt::Display for TimeUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.sign())
    }
}

/// Whether a column without another meaning is the time: `time`, `Timestamp`, `t_ms`, `Time (s)`, `TimeUS`.
pub(super) fn is_time(name: &str) -> bool {
    let is_base = |word: &str| matches!(word, "t" | "time" | "timestamp");
    match words(name).as_slice() {
        [base] => is_base(base) || TimeUnit::of_column(name).is_some_and(|_| TimeUnit::named(base).is_none()),
        [base, unit] => is_base(base) && TimeUnit::named(unit).is_some(),
        [one, two, unit] => one == "time" && two == "stamp" && TimeUnit::named(unit).is_some(),
        _ => false,
    }
}

/// The words of a name, in small letters.
fn words(name: &str) -> Vec<String> {
    let parts = name.split(|c: char| !c.is_alphanumeric());
    parts.filter(|part| !part.is_empty()).map(str::to_lowercase).collect()
}

/// A stamp as `2026-01-31 12:00:00.25`, with `T` and a zone as ISO 8601 has them, s since 1970; or a time of the day as
/// `12:00:00.25`, s since midnight.
pub(super) fn stamp(text: &str) -> Option<f64> {
    let Some((date, time)) = text.split_once(['T', 't', ' ']) else { return day_time(text) };
    let separator = if date.contains('/') { '/' } else { '-' };
    let [year, month, day] = numbers(date, separator)?;
    if date.find(separator) != Some(4) || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    let (time, zone) = zoned(time.trim())?;
    Some(seconds(days(year, month, day) * 86_400 - zone, day_time(time)?))
}

/// A number of whole seconds and a part of a day.
#[expect(clippy::cast_precision_loss, reason = "seconds since 1970 are below 2^53")]
fn seconds(whole: i64, rest: f64) -> f64 {
    whole as f64 + rest
}

/// A time with its zone, s east.
fn zoned(time: &str) -> Option<(&str, i64)> {
    let bare = ["Z", "z", "UTC", "GMT"].into_iter().find_map(|zone| time.strip_suffix(zone));
    if let Some(bare) = bare {
        return Some((bare.trim_end(), 0));
    }
    let Some(place) = time.find(['+', '-']) else { return Some((time, 0)) };
    let (bare, zone) = time.split_at(place);
    let digits: String = zone[1..].chars().filter(|c| *c != ':').collect();
    if !matches!(digits.len(), 2 | 4) {
        return None;
    }
    let (hours, minutes) = digits.split_at(2);
    let east = number(hours)? * 3600 + if minutes.is_empty() { 0 } else { number(minutes)? * 60 };
    Some((bare.trim_end(), if zone.starts_with('-') { -east } else { east }))
}

/// Seconds since midnight.
fn day_time(text: &str) -> Option<f64> {
    let (whole, rest) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let [hours, minutes, whole] = numbers(whole, ':')?;
    let within = (0..24).contains(&hours) && (0..60).contains(&minutes) && (0..=60).contains(&whole);
    if !within || !rest.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let rest = if rest.is_empty() { 0.0 } else { format!("0.{rest}").parse().ok()? };
    Some(seconds((hours * 60 + minutes) * 60 + whole, rest))
}

/// Three whole numbers.
fn numbers(text: &str, separator: char) -> Option<[i64; 3]> {
    let parts: Vec<i64> = text.split(separator).map(number).collect::<Option<_>>()?;
    parts.try_into().ok()
}

/// A whole number of few digits.
fn number(text: &str) -> Option<i64> {
    let digits = (1..=4).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    if digits { text.parse().ok() } else { None }
}

/// Days from 1970-01-01 to a day of the Gregorian calendar.
fn days(year: i64, month: i64, day: i64) -> i64 {
    // Years begin in March, so that the day of a leap year is the last one.
    let year = if month <= 2 { year - 1 } else { year };
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + of_year - 719_468
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stamps_of_the_calendar() {
        // From `date -u -d … +%s`.
        for (text, expected) in [
            ("1970-01-01 00:00:00", 0.0),
            ("2000-02-29 12:30:45.5", 951_827_445.5),
            ("2026-01-01T12:00:00.010000", 1_767_268_800.01),
            ("2026-01-01T12:00:00Z", 1_767_268_800.0),
            ("2026-01-01T13:00:00+01:00", 1_767_268_800.0),
            ("2026-01-01 10:30:00-0130", 1_767_268_800.0),
            ("2026/03/01 00:00:00 UTC", 1_772_323_200.0),
            ("12:00:00,25", 43_200.25),
        ] {
            assert_eq!(stamp(text), Some(expected), "{text}");
        }
        for text in
            ["", "noon", "2026-13-01 12:00:00", "01-01-2026 12:00:00", "2026-01-01", "25:00:00", "1:2", "12:00:00.x"]
        {
            assert_eq!(stamp(text), None, "{text}");
        }
    }

    #[test]
    fn names_of_times_and_their_units() {
        use TimeUnit::{Microseconds, Milliseconds, Nanoseconds, Seconds};
        for (name, unit) in [
            ("Time (ms)", Some(Milliseconds)),
            ("time", None),
            ("timestamp_ns", Some(Nanoseconds)),
            ("TimeUS", Some(Microseconds)),
            ("t [µs]", Some(Microseconds)),
            ("Time[s]", Some(Seconds)),
            ("T", None),
        ] {
            assert!(is_time(name), "{name}");
            assert_eq!(TimeUnit::of_column(name), unit, "{name}");
        }
        for name in ["seconds", "ms", "theta", "time of flight", "t_sensor", "timer"] {
            assert!(!is_time(name), "{name}");
        }
        assert_eq!(TimeUnit::of_column("stamp_us"), Some(Microseconds));
        assert_eq!(TimeUnit::of_column("t_sensor"), None);
        assert_eq!((TimeUnit::of_cell("[ms]"), TimeUnit::of_cell("rad/s")), (Some(Milliseconds), None));
        assert_eq!(Milliseconds.seconds(10.0), 0.01);
    }
}
