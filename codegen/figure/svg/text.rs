//! Text in a figure: where its lines stand, how wide it is, how it is escaped.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of things in a figure are small"
)]

use std::fmt::{self, Display, Formatter};

use super::{CHARACTER_WIDTH, FONT_SIZE, LINE_HEIGHT};

/// Moves sorted positions as little as needed (least squares) for them to lie `distance` apart and,
/// if there is room, between 0 and `height`.
pub(super) fn spread(wanted: &[f64], distance: f64, height: f64) -> Vec<f64> {
    // Without their offsets the positions only have to increase: groups that do not are averaged.
    let mut groups: Vec<(f64, f64)> = Vec::new();
    for (k, position) in wanted.iter().enumerate() {
        let mut group = (position - distance * k as f64, 1.0);
        while let Some((mean, count)) = groups.pop_if(|last| last.0 > group.0) {
            group = ((mean * count + group.0 * group.1) / (count + group.1), count + group.1);
        }
        groups.push(group);
    }
    let most = (height - distance * wanted.len().saturating_sub(1) as f64).max(0.0);
    let means = groups.iter().flat_map(|&(mean, count)| std::iter::repeat_n(mean, count as usize));
    means.enumerate().map(|(k, mean)| mean.clamp(0.0, most) + distance * k as f64).collect()
}

/// The room that the widest of these texts needs.
pub(super) fn widest<'a>(texts: impl Iterator<Item = &'a str>) -> f64 {
    let characters = texts.map(|text| text.chars().count()).max().unwrap_or(0);
    characters as f64 * FONT_SIZE * CHARACTER_WIDTH
}

/// Base lines of text, from the given one downwards.
pub(super) fn lines_from(y: f64) -> impl Iterator<Item = f64> {
    (0..).map(move |line| y + LINE_HEIGHT * f64::from(line))
}

pub(super) fn text(
    f: &mut Formatter<'_>,
    x: f64,
    y: f64,
    attributes: &str,
    colour: &str,
    content: &str,
) -> fmt::Result {
    let (x, y, content) = (Px(x), Px(y), Escaped(content));
    writeln!(f, r#"<text x="{x}" y="{y}"{attributes} fill="{colour}">{content}</text>"#)
}

/// A coordinate with at most two decimals: fine enough for smooth curves.
pub(super) struct Px(pub(super) f64);

impl Display for Px {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        // Adding zero turns minus zero into zero.
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}

/// Text in which nothing is taken for markup; characters that XML forbids are replaced.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            '\0'..='\x08' | '\x0b' | '\x0c' | '\x0e'..='\x1f' | '\u{fffe}' | '\u{ffff}' => f.write_str("\u{fffd}"),
            _ => write!(f, "{c}"),
        })
    }
}
