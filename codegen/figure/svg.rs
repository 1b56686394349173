//! Draws curves over time as an SVG figure: panels in rows that share the time axis of their column.
//!
//! In go a [`Figure`] and its curves, already thinned to what a plot can show; out comes, through
//! `Display`, a well-formed SVG document that depends on nothing but its input. No value makes it
//! fail: what is not finite interrupts the line, and what is out of range is clipped.
//!
//! The style: a white ground, faint grid lines and no frame, thin curves in the colours of Okabe and
//! Ito, which colour-blind readers tell apart, and names at the ends of the curves instead of a legend.

#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of things in a figure are small"
)]

mod axis;
mod cell;
mod frame;
mod legend;
mod pen;
mod text;

use std::fmt::{self, Display, Formatter};

use axis::{Axis, Range};
use frame::Frame;
use text::{Escaped, Px, lines_from, text, widest};

pub use legend::Entry;
pub use pen::Role;

/// A point of a curve: time and value.
pub type Point = (f64, f64);

/// A whole figure; draw it with `to_string` or `write!`.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// Above everything, and the document's title.
    pub title: String,
    /// Lines below the title.
    pub subtitle: String,
    /// What the figure shows, for readers who cannot see it.
    pub description: String,
    /// Quantity and unit of the time axes, `time [s]`.
    pub x_label: String,
    /// What the colours stand for, where the names at the ends of the curves do not say it.
    pub legend: Vec<Entry>,
    /// Side by side, for example the whole recording and its beginning.
    pub columns: Vec<Column>,
    /// From top to bottom.
    pub panels: Vec<Panel>,
}

/// What the panels of a column have in common.
#[derive(Clone, Debug, Default)]
pub struct Column {
    /// Shown above the column, may be empty.
    pub title: String,
    /// First and last time; all of the curves when absent.
    pub x_range: Option<(f64, f64)>,
}

/// A row of the figure: one quantity, once per column.
#[derive(Clone, Debug, Default)]
pub struct Panel {
    /// Quantity and unit, `omega [rad/s]`.
    pub y_label: String,
    /// A remark after it, may be empty.
    pub title: String,
    /// By column; a row may have fewer cells than the figure has columns.
    pub cells: Vec<Cell>,
}

/// The curves in one column of a panel.
#[derive(Clone, Debug, Default)]
pub struct Cell {
    /// Drawn by the layers of their roles, in this order within one.
    pub curves: Vec<Curve>,
    /// An instant of time to be marked.
    pub marker: Option<Marker>,
    /// Shades the values between minus and plus this bound.
    pub band: Option<f64>,
}

/// A named curve by increasing time; a value that is not finite interrupts the line.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Written at the end of the curve, may be empty.
    pub label: String,
    /// How it is drawn.
    pub role: Role,
    /// In the units of the figure's axes.
    pub points: Vec<Point>,
}

/// A vertical line with a name.
#[derive(Clone, Debug)]
pub struct Marker {
    /// Its time.
    pub x: f64,
    /// Written beside it.
    pub label: String,
}

const WIDTH: f64 = 1000.0;
const MARGIN: f64 = 20.0;
const PANEL_HEIGHT: f64 = 150.0;
const ERROR_PANEL_HEIGHT: f64 = 100.0;
/// Between panels, room for the heading.
const PANEL_GAP: f64 = 44.0;
const COLUMN_GAP: f64 = 24.0;
/// Below the last panel: the numbers and the name of the time axis.
const X_AXIS_HEIGHT: f64 = 44.0;
const LINE_HEIGHT: f64 = 18.0;
const FONT_SIZE: f64 = 12.0;
/// Widest average character in the fonts that are likely to be used, in font sizes.
const CHARACTER_WIDTH: f64 = 0.62;
/// Least distance between the names of two curves.
const LABEL_DISTANCE: f64 = 15.0;
/// Dots closer than this are drawn as a line.
const DOT_DISTANCE: f64 = 3.0;

const INK: &str = "#222222";
const MUTED: &str = "#666666";
const GRID: &str = "#e8e8e8";
const AXIS: &str = "#999999";

impl Display for Figure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (frames, height) = self.layout();
        self.head(f, height)?;
        for (panel, frames) in self.panels.iter().zip(&frames) {
            panel.draw(f, frames)?;
        }
        for (index, column) in self.columns.iter().enumerate() {
            let mut cells = frames.iter().filter_map(|row| row.get(index));
            if let Some(highest) = cells.clone().next() {
                text(f, highest.left, highest.top - 30.0, "", MUTED, &column.title)?;
            }
            if let Some(lowest) = cells.next_back() {
                lowest.draw_x_axis(f, &self.x_label)?;
            }
        }
        f.write_str("</svg>\n")
    }
}

impl Figure {
    /// Opens the document and writes everything above the panels.
    fn head(&self, f: &mut Formatter<'_>, height: f64) -> fmt::Result {
        let (width, height) = (Px(WIDTH), Px(height));
        writeln!(
            f,
            r#"<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="{FONT_SIZE}">"#
        )?;
        writeln!(f, "<title>{}</title>", Escaped(&self.title))?;
        writeln!(f, "<desc>{}</desc>", Escaped(&self.description))?;
        writeln!(f, r##"<rect width="{width}" height="{height}" fill="#ffffff"/>"##)?;
        text(f, MARGIN, MARGIN + 16.0, r#" font-size="18" font-weight="600""#, INK, &self.title)?;
        for (line, y) in self.subtitle.lines().zip(lines_from(MARGIN + 38.0)) {
            text(f, MARGIN, y, r#" font-size="13""#, MUTED, line)?;
        }
        let below = self.subtitle.lines().count() as f64;
        legend::draw(f, &self.legend, MARGIN + 44.0 + LINE_HEIGHT * below)
    }

    /// Where every cell goes, by row and column, and the height of the figure.
    fn layout(&self) -> (Vec<Vec<Frame>>, f64) {
        let columns = self.columns.len();
        let x_ranges: Vec<Range> = (0..columns).map(|column| self.x_range(column)).collect();
        let y_axes: Vec<Vec<Axis>> = self.panels.iter().map(|panel| panel.y_axes(&x_ranges)).collect();

        let cells = |column: usize| self.panels.iter().filter_map(move |panel| panel.cells.get(column));
        let names = |column| cells(column).flat_map(|cell| &cell.curves).map(|curve| curve.label.as_str());
        let numbers = |column: usize| y_axes.iter().filter_map(move |row| row.get(column)).flat_map(Axis::labels);
        let before: Vec<f64> = (0..columns).map(|column| widest(numbers(column)) + 8.0).collect();
        let after: Vec<f64> = (0..columns).map(|column| widest(names(column)) + 8.0).collect();

        let gaps = 2.0 * MARGIN + COLUMN_GAP * columns.saturating_sub(1) as f64;
        let gutters = before.iter().chain(&after).sum::<f64>();
        let width = ((WIDTH - gaps - gutters) / columns.max(1) as f64).max(40.0);

        let mut top = MARGIN + 38.0 + LINE_HEIGHT * self.subtitle.lines().count() as f64 + PANEL_GAP;
        top += legend::height(&self.legend);
        let mut frames = Vec::new();
        for (panel, y_axes) in self.panels.iter().zip(y_axes) {
            let height = panel.height();
            let mut left = MARGIN;
            let mut row = Vec::new();
            for (column, y) in y_axes.into_iter().enumerate() {
                left += before[column];
                let x = Axis::new(x_ranges[column], width / 70.0);
                row.push(Frame { left, top, width, height, x, y });
                left += width + after[column] + COLUMN_GAP;
            }
            frames.push(row);
            top += height + PANEL_GAP;
        }
        (frames, top - PANEL_GAP + X_AXIS_HEIGHT + MARGIN)
    }

    /// The time range of a column.
    fn x_range(&self, column: usize) -> Range {
        let curves = self.panels.iter().filter_map(|panel| panel.cells.get(column)).flat_map(|cell| &cell.curves);
        let times = curves.flat_map(|curve| &curve.points).map(|point| point.0);
        match self.columns[column].x_range {
            Some((low, high)) => Range::of([low, high].into_iter()),
            None => Range::of(times),
        }
        .unwrap_or(Range { low: 0.0, high: 1.0 })
    }
}

impl Panel {
    /// Errors need less room than what they are errors of.
    fn height(&self) -> f64 {
        let mut curves = self.cells.iter().flat_map(|cell| &cell.curves).peekable();
        let errors = curves.peek().is_some() && curves.all(|curve| curve.role.is_error());
        if errors { ERROR_PANEL_HEIGHT } else { PANEL_HEIGHT }
    }

    fn y_axes(&self, x_ranges: &[Range]) -> Vec<Axis> {
        let axis = |(cell, x): (&Cell, &Range)| Axis::new(cell.y_range(*x).padded(), self.height() / 35.0);
        self.cells.iter().zip(x_ranges).map(axis).collect()
    }

    fn draw(&self, f: &mut Formatter<'_>, frames: &[Frame]) -> fmt::Result {
        let Some(first) = frames.first() else {
            return Ok(());
        };
        let (x, y) = (Px(first.left), Px(first.top - 10.0));
        writeln!(
            f,
            r#"<text x="{x}" y="{y}" font-size="13" fill="{INK}"><tspan font-weight="600">{}</tspan><tspan dx="8" fill="{MUTED}">{}</tspan></text>"#,
            Escaped(&self.y_label),
            Escaped(&self.title)
        )?;
        self.cells.iter().zip(frames).try_for_each(|(cell, frame)| cell.draw(f, frame))
    }
}

#[cfg(test)]
mod tests;
