//! Ranges of numbers and round numbers on them.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of things in a figure are small"
)]

/// A range of finite numbers that is never empty.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Range {
    /// Numbers beyond this are drawn outside, so that differences do not overflow.
    pub(super) const LARGEST: f64 = 1e300;

    /// The range of the finite values; a tenth around them when they are all but equal.
    pub(super) fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let finite = values.filter(|value| value.is_finite()).map(|value| value.clamp(-Self::LARGEST, Self::LARGEST));
        let (low, high) = finite.fold(None, |range: Option<(f64, f64)>, value| {
            Some(range.map_or((value, value), |(low, high)| (low.min(value), high.max(value))))
        })?;
        let size = low.abs().max(high.abs());
        let half = if size < 1e-300 { 1.0 } else { 0.1 * size };
        if high - low > 1e-9 * size && size >= 1e-300 {
            return Some(Self { low, high });
        }
        Some(Self { low: low - half, high: high + half })
    }

    /// With some room above and below.
    pub(super) fn padded(self) -> Self {
        let room = 0.06 * (self.high - self.low);
        Self { low: self.low - room, high: self.high + room }
    }

    pub(super) fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// The position of a value, 0 at the low end and 1 at the high end, not far outside.
    pub(super) fn part(self, value: f64) -> f64 {
        let value = value.clamp(-2.0 * Self::LARGEST, 2.0 * Self::LARGEST);
        ((value - self.low) / (self.high - self.low)).clamp(-10.0, 11.0)
    }
}

/// A range with round numbers on it.
pub(super) struct Axis {
    pub(super) range: Range,
    pub(super) ticks: Vec<Tick>,
}

pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

impl Axis {
    /// Places about `count` ticks at multiples of 1, 2 or 5 times a power of ten.
    pub(super) fn new(range: Range, count: f64) -> Self {
        let (multiple, exponent) = round_step((range.high - range.low) / count);
        let step = decimal(multiple, exponent);
        let first = (range.low / step - 1e-6).ceil() as i64;
        let last = (range.high / step + 1e-6).floor() as i64;
        let plain = exponent >= -4 && range.low.abs().max(range.high.abs()) < 1e6;
        let tick = |k: i64| {
            let digits = k * multiple;
            let label = if plain { plain_label(digits, exponent) } else { scientific_label(digits, exponent) };
            Tick { value: decimal(digits, exponent), label: label.replace('-', "\u{2212}") }
        };
        Self { range, ticks: (first..=last).map(tick).collect() }
    }

    pub(super) fn labels(&self) -> impl Iterator<Item = &str> {
        self.ticks.iter().map(|tick| tick.label.as_str())
    }
}

/// The one of 1, 2 and 5 times a power of ten that is about nearest to a positive number.
pub(super) fn round_step(raw: f64) -> (i64, i32) {
    let written = format!("{raw:e}");
    let (mantissa, exponent) = written.split_once('e').unwrap_or(("1", "0"));
    let mantissa: f64 = mantissa.parse().unwrap_or(1.0);
    let exponent: i32 = exponent.parse().unwrap_or(0);
    match mantissa {
        ..1.5 => (1, exponent),
        ..3.5 => (2, exponent),
        ..7.5 => (5, exponent),
        _ => (1, exponent + 1),
    }
}

/// The double nearest to `digits` times ten to the `exponent`.
pub(super) fn decimal(digits: i64, exponent: i32) -> f64 {
    format!("{digits}e{exponent}").parse().unwrap_or(0.0)
}

pub(super) fn plain_label(digits: i64, exponent: i32) -> String {
    let decimals = usize::try_from(-exponent).unwrap_or(0);
    format!("{:.decimals$}", decimal(digits, exponent))
}

pub(super) fn scientific_label(mut digits: i64, mut exponent: i32) -> String {
    if digits == 0 {
        return "0".to_owned();
    }
    while digits % 10 == 0 {
        digits /= 10;
        exponent += 1;
    }
    format!("{:e}", decimal(digits, exponent))
}
