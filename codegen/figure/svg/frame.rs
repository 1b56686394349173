//! The rectangle of a cell: where values go in it, its grid and its axes.

use std::fmt::{self, Formatter};

use super::axis::Axis;
use super::text::{Px, text};
use super::{AXIS, GRID, INK, MUTED};

/// The rectangle of a cell and its two axes.
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) x: Axis,
    pub(super) y: Axis,
}

impl Frame {
    pub(super) fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Pixels from the left edge.
    pub(super) fn x_at(&self, t: f64) -> f64 {
        self.width * self.x.range.part(t)
    }

    /// Pixels from the upper edge.
    pub(super) fn y_at(&self, y: f64) -> f64 {
        self.height * (1.0 - self.y.range.part(y))
    }

    /// Draws faint lines at the ticks and writes the values on the left.
    pub(super) fn draw_grid(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (left, right, top, bottom) = (Px(self.left), Px(self.right()), Px(self.top), Px(self.top + self.height));
        write!(f, r#"<path stroke="{GRID}" d=""#)?;
        for tick in &self.x.ticks {
            write!(f, "M{} {top}V{bottom}", Px(self.left + self.x_at(tick.value)))?;
        }
        for tick in &self.y.ticks {
            write!(f, "M{left} {}H{right}", Px(self.top + self.y_at(tick.value)))?;
        }
        writeln!(f, r#""/>"#)?;
        if self.y.range.contains(0.0) {
            let zero = Px(self.top + self.y_at(0.0));
            writeln!(f, r##"<path stroke="#c8c8c8" d="M{left} {zero}H{right}"/>"##)?;
        }
        for tick in &self.y.ticks {
            let y = self.top + self.y_at(tick.value) + 4.0;
            text(f, self.left - 7.0, y, r#" text-anchor="end""#, MUTED, &tick.label)?;
        }
        Ok(())
    }

    /// Draws the time axis below the frame.
    pub(super) fn draw_x_axis(&self, f: &mut Formatter<'_>, label: &str) -> fmt::Result {
        let bottom = self.top + self.height;
        let (left, right, y) = (Px(self.left), Px(self.right()), Px(bottom));
        write!(f, r#"<path fill="none" stroke="{AXIS}" d="M{left} {y}H{right}"#)?;
        for tick in &self.x.ticks {
            write!(f, "M{} {y}v4", Px(self.left + self.x_at(tick.value)))?;
        }
        writeln!(f, r#""/>"#)?;
        for tick in &self.x.ticks {
            let x = self.left + self.x_at(tick.value);
            text(f, x, bottom + 18.0, r#" text-anchor="middle""#, MUTED, &tick.label)?;
        }
        let middle = self.left + self.width / 2.0;
        text(f, middle, bottom + 38.0, r#" font-size="13" text-anchor="middle""#, INK, label)
    }
}
