//! Numbers as people read them: counts, times, significant digits.
//!
//! Knows how people read numbers. Never knows a plant, nor any mathematics.

/// A count as a number for messages.
#[expect(clippy::cast_precision_loss, reason = "counts of samples and bits are far below 2^53")]
pub fn count(value: usize) -> f64 {
    value as f64
}

/// The length of some samples.
pub fn seconds(samples: usize, sample_time_s: f64) -> f64 {
    count(samples) * sample_time_s
}

/// Up to nine significant digits, for messages.
pub fn trimmed(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

/// Four significant digits.
pub fn short(value: f64) -> String {
    if !value.is_finite() {
        return "-".into();
    }
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let digits = format!("{value:.3e}").parse::<f64>().unwrap_or(value);
        format!("{digits}")
    } else {
        format!("{value:.3e}")
    }
}

/// A factor by which something shrinks: near one, by how much it is less.
pub fn factor(value: f64) -> String {
    if value > 0.999 && value < 1.0 { format!("1 - {}", short(1.0 - value)) } else { short(value) }
}

/// A share of an error; below the digits that it was computed with, that.
pub fn remainder(left: f64) -> String {
    if left < 1e-12 { "less than 1e-12".into() } else { short(left) }
}
