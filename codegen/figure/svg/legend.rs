//! A legend: short strokes in the colours of the curves with names behind them, in lines across the figure.

#![allow(clippy::cast_precision_loss, reason = "counts of things in a figure are small")]

use std::fmt::{self, Formatter};

use super::pen::{Pen, Role};
use super::text::{Px, text, widest};
use super::{LINE_HEIGHT, MARGIN, WIDTH};

/// A stroke's length, and the room to its name and to the next entry.
const STROKE: f64 = 22.0;
const BEFORE_NAME: f64 = 6.0;
const BEHIND_NAME: f64 = 18.0;

/// What a colour stands for.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Written beside the stroke.
    pub name: String,
    /// Whose colour the stroke has.
    pub role: Role,
}

/// From the left and the line of each entry.
fn places(entries: &[Entry]) -> Vec<(f64, usize)> {
    let (mut left, mut line) = (MARGIN, 0);
    let place = |entry: &Entry| {
        let width = STROKE + BEFORE_NAME + widest(std::iter::once(entry.name.as_str()));
        if left > MARGIN && left + width > WIDTH - MARGIN {
            (left, line) = (MARGIN, line + 1);
        }
        let here = (left, line);
        left += width + BEHIND_NAME;
        here
    };
    entries.iter().map(place).collect()
}

/// The height of a legend; nothing takes none.
pub(super) fn height(entries: &[Entry]) -> f64 {
    places(entries).last().map_or(0.0, |(_, line)| LINE_HEIGHT * (*line as f64 + 1.0))
}

/// Draws the entries, the first line on a base line.
pub(super) fn draw(f: &mut Formatter<'_>, entries: &[Entry], base: f64) -> fmt::Result {
    for (entry, (left, line)) in entries.iter().zip(places(entries)) {
        let y = base + LINE_HEIGHT * line as f64;
        let Pen { colour, text: ink, opacity, .. } = entry.role.pen();
        let (x, middle, dash) = (Px(left), Px(y - 4.0), entry.role.pen().dash());
        writeln!(
            f,
            r#"<path stroke="{colour}" stroke-width="2.5" stroke-opacity="{opacity}"{dash} d="M{x} {middle}h{STROKE}"/>"#
        )?;
        text(f, left + STROKE + BEFORE_NAME, y, "", ink, &entry.name)?;
    }
    Ok(())
}
