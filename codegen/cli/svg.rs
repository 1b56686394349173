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
mod text;

use std::fmt::{self, Display, Formatter};

use axis::{Axis, Range};
use text::{Escaped, Px, lines_from, spread, text, widest};

/// A point of a curve: time and value.
pub type Point = (f64, f64);

/// A whole figure; draw it with `to_string` or `write!`.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    pub title: String,
    /// Lines below the title.
    pub subtitle: String,
    /// What the figure shows, for readers who cannot see it.
    pub description: String,
    /// Quantity and unit of the time axes, `time [s]`.
    pub x_label: String,
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
    pub role: Role,
    pub points: Vec<Point>,
}

/// What a curve stands for, which determines how it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// Pale grey, at the bottom; dots when there is room for them.
    Measured,
    /// Black, wide and pale.
    Reference,
    /// Vermilion.
    Error,
    /// Blue, on top.
    Estimate,
}

/// A vertical line with a name.
#[derive(Clone, Debug)]
pub struct Marker {
    pub x: f64,
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

/// How curves of a role are drawn.
struct Pen {
    colour: &'static str,
    /// For text, dark enough to be read on white.
    text: &'static str,
    width: f64,
    opacity: f64,
}

impl Role {
    const fn pen(self) -> Pen {
        match self {
            Self::Measured => Pen { colour: "#b4b4b4", text: "#737373", width: 2.25, opacity: 1.0 },
            Self::Reference => Pen { colour: "#000000", text: "#444444", width: 2.5, opacity: 0.4 },
            Self::Error => Pen { colour: "#d55e00", text: "#c05000", width: 1.0, opacity: 1.0 },
            Self::Estimate => Pen { colour: "#0072b2", text: "#0072b2", width: 1.15, opacity: 1.0 },
        }
    }
}

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
        Ok(())
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
        let errors = curves.peek().is_some() && curves.all(|curve| curve.role == Role::Error);
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

impl Cell {
    /// The range of everything that is visible; errors and bands are seen against zero.
    fn y_range(&self, x: Range) -> Range {
        let curves = self.curves.iter().flat_map(|curve| &curve.points);
        let values = curves.filter(|point| x.contains(point.0)).map(|point| point.1);
        let band = self.band.into_iter().flat_map(|bound| [-bound, bound]);
        let errors = self.curves.iter().any(|curve| curve.role == Role::Error);
        let zero = errors.then_some(0.0);
        Range::of(values.chain(band).chain(zero)).unwrap_or(Range { low: 0.0, high: 1.0 })
    }

    fn draw(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        frame.draw_grid(f)?;
        let (x, y, width, height) = (Px(frame.left), Px(frame.top), Px(frame.width), Px(frame.height));
        // A nested document clips what it holds, without an id that could clash with another figure.
        writeln!(
            f,
            r#"<svg x="{x}" y="{y}" width="{width}" height="{height}" fill="none" stroke-linecap="round" stroke-linejoin="round">"#
        )?;
        if let Some(bound) = self.band.filter(|bound| bound.is_finite()) {
            let (top, bottom) = (frame.y_at(bound.abs()), frame.y_at(-bound.abs()));
            let (y, height) = (Px(top), Px(bottom - top));
            writeln!(f, r##"<rect y="{y}" width="{width}" height="{height}" fill="#000000" fill-opacity="0.06"/>"##)?;
        }
        let mut curves: Vec<&Curve> = self.curves.iter().collect();
        curves.sort_by_key(|curve| curve.role);
        for curve in &curves {
            curve.draw(f, frame)?;
        }
        if let Some(marker) = &self.marker {
            marker.draw(f, frame)?;
        }
        writeln!(f, "</svg>")?;
        if curves.iter().all(|curve| curve.end(frame).is_none()) {
            let attributes = r#" text-anchor="middle""#;
            text(f, frame.left + frame.width / 2.0, frame.top + frame.height / 2.0, attributes, MUTED, "no data")?;
        }
        self.draw_labels(f, frame)
    }

    /// Writes the name of each curve at its end, in its colour.
    fn draw_labels(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        let named = self.curves.iter().filter(|curve| !curve.label.is_empty());
        let mut ends: Vec<(f64, &Curve)> = named.filter_map(|curve| Some((curve.end(frame)?, curve))).collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wanted: Vec<f64> = ends.iter().map(|end| end.0).collect();
        for (y, (_, curve)) in spread(&wanted, LABEL_DISTANCE, frame.height).into_iter().zip(ends) {
            text(f, frame.right() + 6.0, frame.top + y + 4.0, "", curve.role.pen().text, &curve.label)?;
        }
        Ok(())
    }
}

impl Curve {
    /// The points in the frame, with one neighbour on either side for the line to come from and go to.
    fn visible(&self, x: Range) -> &[Point] {
        let first = self.points.partition_point(|point| point.0 < x.low).saturating_sub(1);
        let end = self.points.partition_point(|point| point.0 <= x.high) + 1;
        self.points.get(first..end.min(self.points.len())).unwrap_or_default()
    }

    /// The height in the frame at which the curve ends.
    fn end(&self, frame: &Frame) -> Option<f64> {
        let visible = self.visible(frame.x.range).iter().rev();
        let last = visible.copied().find(|point| frame.x.range.contains(point.0) && point.1.is_finite())?;
        Some(frame.y_at(last.1))
    }

    fn draw(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        let points = self.visible(frame.x.range);
        let Pen { colour, width, opacity, .. } = self.role.pen();
        let dots = self.role == Role::Measured && points.len() as f64 * DOT_DISTANCE < frame.width;
        let width = Px(if dots { width + 0.5 } else { width });
        write!(f, r#"<path stroke="{colour}" stroke-width="{width}""#)?;
        if opacity < 1.0 {
            write!(f, r#" stroke-opacity="{opacity}""#)?;
        }
        f.write_str(r#" d=""#)?;
        let mut pen_down = false;
        for (k, &(t, y)) in points.iter().enumerate() {
            let drawable = t.is_finite() && y.is_finite();
            let alone = !points.get(k + 1).is_some_and(|next| next.0.is_finite() && next.1.is_finite());
            if drawable {
                let command = if pen_down { 'L' } else { 'M' };
                write!(f, "{command}{} {}", Px(frame.x_at(t)), Px(frame.y_at(y)))?;
                if dots || (!pen_down && alone) {
                    f.write_str("h0")?;
                }
            }
            pen_down = drawable && !dots;
        }
        writeln!(f, r#""/>"#)
    }
}

impl Marker {
    /// Draws the line and writes the name beside it, where there is more room.
    fn draw(&self, f: &mut Formatter<'_>, frame: &Frame) -> fmt::Result {
        if !frame.x.range.contains(self.x) {
            return Ok(());
        }
        let at = frame.x_at(self.x);
        let (x, height) = (Px(at), Px(frame.height));
        writeln!(f, r#"<path stroke="{MUTED}" stroke-dasharray="2 3" stroke-linecap="butt" d="M{x} 0V{height}"/>"#)?;
        let (offset, anchor) = if at < frame.width / 2.0 { (5.0, "start") } else { (-5.0, "end") };
        let halo = format!(r##" text-anchor="{anchor}" stroke="#ffffff" stroke-width="3" paint-order="stroke""##);
        text(f, at + offset, 11.0, &halo, MUTED, &self.label)
    }
}

/// The rectangle of a cell and its two axes.
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x: Axis,
    y: Axis,
}

impl Frame {
    fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Pixels from the left edge.
    fn x_at(&self, t: f64) -> f64 {
        self.width * self.x.range.part(t)
    }

    /// Pixels from the upper edge.
    fn y_at(&self, y: f64) -> f64 {
        self.height * (1.0 - self.y.range.part(y))
    }

    /// Draws faint lines at the ticks and writes the values on the left.
    fn draw_grid(&self, f: &mut Formatter<'_>) -> fmt::Result {
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
    fn draw_x_axis(&self, f: &mut Formatter<'_>, label: &str) -> fmt::Result {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(points: Vec<Point>, role: Role) -> Figure {
        let curve = Curve { label: "a < b & \"c\"\u{1}".into(), role, points };
        let marker = Some(Marker { x: 1.0, label: "m".into() });
        let cell = Cell { curves: vec![curve.clone(), curve], marker, band: Some(0.5) };
        Figure {
            title: "<title>".into(),
            subtitle: "one\ntwo".into(),
            columns: vec![Column::default(), Column { title: "zoom".into(), x_range: Some((0.0, 1.5)) }],
            panels: vec![Panel { cells: vec![cell.clone(), cell], ..Panel::default() }, Panel::default()],
            ..Figure::default()
        }
    }

    /// Checks that tags nest, attributes are quoted and no number is NaN or infinite.
    fn check(svg: &str) {
        let mut open = Vec::new();
        for piece in svg.split('<').skip(1) {
            let (tag, content) = piece.split_once('>').expect("a tag ends");
            assert!(!content.contains('"'), "{content}");
            assert!(tag.matches('"').count() % 2 == 0, "{tag}");
            assert!(!["NaN", "inf", "-0 "].iter().any(|bad| tag.contains(bad)), "{tag}");
            if let Some(name) = tag.strip_prefix('/') {
                assert_eq!(open.pop(), Some(name));
            } else if !tag.ends_with('/') {
                open.push(tag.split(' ').next().unwrap());
            }
        }
        assert!(open.is_empty());
    }

    fn labels(low: f64, high: f64) -> Vec<String> {
        Axis::new(Range { low, high }, 5.0).labels().map(str::to_owned).collect()
    }

    #[test]
    fn every_curve_gives_a_well_formed_document() {
        const NAN: f64 = f64::NAN;
        let curves: [&[Point]; 11] = [
            &[],
            &[(0.0, NAN), (1.0, f64::INFINITY)],
            &[(NAN, 1.0)],
            &[(1.0, 2.0)],
            &[(0.0, 3.0), (1.0, 3.0), (2.0, 3.0)],
            &[(0.0, 1e300), (1.0, -1e300), (2.0, 0.0)],
            &[(0.0, f64::MAX), (1.0, f64::MIN), (2.0, 5e-324)],
            &[(0.0, 1e-300), (1.0, 2e-300), (2.0, -1e-310)],
            &[(-1e308, 1.0), (1e308, 1.0 + f64::EPSILON)],
            &[(0.0, 1.0), (0.5, NAN), (1.0, 1.0), (1.2, NAN), (1.4, 2.0)],
            &[(2.0, 1.0), (0.0, 2.0), (1.0, 3.0)],
        ];
        for points in curves {
            for role in [Role::Measured, Role::Reference, Role::Error, Role::Estimate] {
                check(&figure(points.to_vec(), role).to_string());
            }
        }
        check(&Figure::default().to_string());
    }

    #[test]
    fn text_is_escaped() {
        let svg = figure(vec![(0.0, 1.0), (1.0, 2.0)], Role::Error).to_string();
        assert!(svg.contains("<title>&lt;title&gt;</title>"));
        assert!(svg.contains("a &lt; b &amp; &quot;c&quot;\u{fffd}</text>"));
    }

    #[test]
    fn a_gap_interrupts_the_line_and_a_lone_point_is_a_dot() {
        let points = vec![(0.0, 0.0), (0.5, 1.0), (0.6, f64::NAN), (1.0, 1.0)];
        let svg = figure(points, Role::Estimate).to_string();
        let path = svg.lines().find(|line| line.contains("#0072b2")).unwrap();
        assert_eq!((path.matches('M').count(), path.matches('L').count(), path.matches("h0").count()), (2, 1, 1));
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(labels(0.0, 55.0), ["0", "10", "20", "30", "40", "50"]);
        assert_eq!(labels(-0.3, 0.31), ["−0.3", "−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"]);
        assert_eq!(labels(0.0, 2.5e6), ["0", "5e5", "1e6", "1.5e6", "2e6", "2.5e6"]);
        assert_eq!(labels(0.0, 4e-300), ["0", "1e−300", "2e−300", "3e−300", "4e−300"]);
    }

    #[test]
    fn labels_are_pushed_apart_within_the_panel() {
        let close = |a: Vec<f64>, b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(close(spread(&[10.0, 50.0], 15.0, 100.0), &[10.0, 50.0]));
        assert!(close(spread(&[50.0, 50.0], 15.0, 100.0), &[42.5, 57.5]));
        assert!(close(spread(&[40.0, 50.0, 52.0], 15.0, 100.0), &[97.0 / 3.0, 142.0 / 3.0, 187.0 / 3.0]));
        assert!(close(spread(&[0.0, 1.0], 15.0, 100.0), &[0.0, 15.0]));
        assert!(close(spread(&[99.0, 100.0], 15.0, 100.0), &[85.0, 100.0]));
        assert!(close(spread(&[5.0, 5.0, 5.0], 15.0, 20.0), &[0.0, 15.0, 30.0]));
    }

    #[test]
    fn coordinates_have_at_most_two_decimals_and_no_minus_zero() {
        assert_eq!([1.0, 2.345_6, -0.001, 1e5 / 3.0].map(|x| Px(x).to_string()), ["1", "2.35", "0", "33333.33"]);
    }
}
